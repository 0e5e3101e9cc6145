//! Programs from elsewhere: found, brought where we may, and otherwise named.

use crate::command::{output_of, program, run};
use crate::{Failure, place};
use std::path::PathBuf;

const WASM_TARGET: &str = "wasm32-unknown-unknown";

/// Where a program is on the search path.
pub fn find(name: &str) -> Option<PathBuf> {
    let path = std::env::var_os("PATH")?;
    std::env::split_paths(&path).map(|folder| folder.join(name)).find(|candidate| candidate.is_file())
}

/// Sees to it that the compiler can make wasm. Never touches the toolchain itself.
pub fn ensure_wasm_target() -> Result<(), Failure> {
    if find("rustup").is_none() {
        // A distribution's own compiler: it has the target if its library is there.
        let target =
            output_of(&mut program("rustc", &["--print", "target-libdir", "--target", WASM_TARGET]))?;
        if PathBuf::from(target.trim()).is_dir() {
            return Ok(());
        }
        return Err(Failure::Missing {
            tool: "the compiler's wasm32-unknown-unknown target",
            advice: "Install rustup (https://rustup.rs) and run `rustup target add wasm32-unknown-unknown`, \
                     or install your distribution's package of that target (Debian: libstd-rust-dev-wasm32).",
        });
    }
    let installed = output_of(&mut program("rustup", &["target", "list", "--installed"]))?;
    if installed.lines().any(|line| line.trim() == WASM_TARGET) {
        return Ok(());
    }
    println!("adding the target {WASM_TARGET}");
    run(&mut program("rustup", &["target", "add", WASM_TARGET]))
}

/// Where the release build for wasm lands.
pub fn wasm_artifact() -> PathBuf {
    place::target().join(WASM_TARGET).join("release").join("gear_bifurcations.wasm")
}
