//! `cargo xtask build`: from the sources to a static folder that any web server can serve.

mod bindings;
mod equations;
mod link;
mod module;
mod modules;
mod script;
mod site;
mod weight;

use crate::command::{cargo, run};
use crate::{Failure, place, tools};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// No visitor should wait for more wasm than this, in bytes as it travels (gzipped): as much for the exact answers as
/// for the paper's figures and the drawing, which alone stayed below the half of it.
pub const WASM_CEILING: usize = 614_400;

/// Nor for more than this in all, when the page is opened for the first time.
pub const FIRST_VISIT_CEILING: usize = 780_000;

/// What a build made.
pub struct Built {
    /// The folder.
    pub out: PathBuf,
    /// Size of the wasm, gzipped, in bytes.
    pub gzipped: usize,
    /// What everything weighs that a first visit loads, in bytes as it travels.
    pub first_visit: usize,
    /// How long it took.
    pub took: Duration,
}

impl Built {
    /// Says it in a line.
    pub fn report(&self) {
        let Self { out, gzipped, first_visit, took } = self;
        println!(
            "built {} in {:.1} s; the wasm is {gzipped} bytes gzipped (ceiling {WASM_CEILING}), a first visit {first_visit} \
             bytes (ceiling {FIRST_VISIT_CEILING})",
            out.display(),
            took.as_secs_f64()
        );
    }
}

/// Compiles the library to wasm.
pub fn compile() -> Result<(), Failure> {
    tools::ensure_wasm_target()?;
    run(&mut cargo(&["build", "--quiet", "--release", "--lib", "--target", "wasm32-unknown-unknown"]))
}

/// Compiles, and builds everything into `out`.
pub fn build(out: &Path) -> Result<Built, Failure> {
    let start = Instant::now();
    compile()?;
    let built = around_compiled(out)?;
    Ok(Built { took: start.elapsed(), ..built })
}

/// Builds everything into `out` around the wasm that was compiled last.
pub fn around_compiled(out: &Path) -> Result<Built, Failure> {
    let start = Instant::now();
    let generated = bindings::generate(&tools::wasm_artifact(), &place::scratch().join("bindings"))?;
    let gzipped = weight::gzipped_size(&generated.wasm);
    let site = site::gather(&place::root(), &generated)?;
    let weights = weight::first_visit(&site)?;
    let first_visit = weights.values().sum();
    within("the wasm", gzipped, WASM_CEILING, "")?;
    let all: Vec<String> = weights.iter().map(|(name, bytes)| format!("\n  {bytes} {name}")).collect();
    within("a first visit", first_visit, FIRST_VISIT_CEILING, &all.concat())?;
    site.write(out)?;
    Ok(Built { out: out.to_owned(), gzipped, first_visit, took: start.elapsed() })
}

fn within(what: &str, bytes: usize, ceiling: usize, details: &str) -> Result<(), Failure> {
    if bytes <= ceiling {
        return Ok(());
    }
    let reason = format!("{bytes} bytes gzipped, which is more than the ceiling of {ceiling}{details}");
    Err(Failure::invalid(what, reason))
}
