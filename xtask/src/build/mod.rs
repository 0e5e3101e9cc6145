//! `cargo xtask build`: from the sources to a static folder that any web server can serve.

mod bindings;
mod link;
mod module;
mod modules;
mod script;
mod site;

use crate::command::{cargo, run};
use crate::{Failure, place, tools};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// No visitor should wait for more wasm than this, in bytes as it travels (gzipped): as much for the exact answers as
/// for the paper's figures and the drawing, which alone stayed below the half of it.
pub const WASM_CEILING: usize = 614_400;

/// What a build made.
pub struct Built {
    /// The folder.
    pub out: PathBuf,
    /// Size of the wasm, gzipped, in bytes.
    pub gzipped: usize,
    /// How long it took.
    pub took: Duration,
}

impl Built {
    /// Says it in a line.
    pub fn report(&self) {
        let Self { out, gzipped, took } = self;
        println!(
            "built {} in {:.1} s; the wasm is {gzipped} bytes gzipped (ceiling {WASM_CEILING})",
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
    let gzipped = gzipped_size(&generated.wasm);
    if gzipped > WASM_CEILING {
        let reason = format!("{gzipped} bytes gzipped, which is more than the ceiling of {WASM_CEILING}");
        return Err(Failure::invalid("the wasm", reason));
    }
    site::gather(&place::root(), &generated)?.write(out)?;
    Ok(Built { out: out.to_owned(), gzipped, took: start.elapsed() })
}

/// Size of some bytes as a web server would send them.
fn gzipped_size(bytes: &[u8]) -> usize {
    let mut encoder = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::best());
    // Writing to memory cannot fail.
    let written = encoder.write_all(bytes).and_then(|()| encoder.finish());
    written.map_or(usize::MAX, |compressed| compressed.len())
}
