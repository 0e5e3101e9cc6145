//! `cargo xtask build`: from the sources to a static folder that any web server can serve.

mod base64;
mod bindings;
mod document;
mod equations;
mod link;
mod module;
mod modules;
mod order;
pub mod package;
pub mod release;
mod script;
mod single;
mod site;
pub mod stamp;
mod weight;

use crate::command::{cargo, run};
use crate::{Failure, place, tools};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// No visitor should wait for more wasm than this, in bytes as it travels (gzipped). `ARCHITECTURE.md` says why it is not less.
pub const WASM_CEILING: usize = 480_000;

/// Nor for more than this in all, when the page is opened for the first time: 160,000 beside the wasm.
pub const FIRST_VISIT_CEILING: usize = WASM_CEILING + 160_000;

/// Nor may the page in one file be larger, in bytes.
pub const SINGLE_CEILING: usize = single::CEILING;

/// What a build made.
pub struct Built {
    /// The folder.
    pub out: PathBuf,
    /// Size of the wasm, gzipped, in bytes.
    pub gzipped: usize,
    /// What everything weighs that a first visit loads, in bytes as it travels.
    pub first_visit: usize,
    /// Size of the page in one file, in bytes.
    pub single: usize,
    /// How many still drawings found no room in it.
    pub left_out: usize,
    /// How long it took.
    pub took: Duration,
}

impl Built {
    /// Says it in a line.
    pub fn report(&self) {
        let Self { out, gzipped, first_visit, single, left_out, took } = self;
        println!(
            "built {} in {:.1} s; the wasm is {gzipped} bytes gzipped (ceiling {WASM_CEILING}), a first visit {first_visit} \
             bytes (ceiling {FIRST_VISIT_CEILING}), the page in one file {single} (ceiling {})",
            out.display(),
            took.as_secs_f64(),
            single::CEILING
        );
        if *left_out > 0 {
            println!(
                "  {left_out} still drawings, the heaviest, found no room in that file; they show where scripts are off"
            );
        }
    }
}

/// What is to be built.
pub struct Wanted<'a> {
    /// Into this folder.
    pub out: &'a Path,
    /// With files of their own for these figures.
    pub figures: &'a [&'a str],
    /// Around the wasm that was compiled last.
    pub keep_wasm: bool,
}

/// Compiles, and builds the site into `out`.
pub fn build(out: &Path) -> Result<Built, Failure> {
    make(&Wanted { out, figures: &[], keep_wasm: false })
}

/// Compiles the wasm.
pub fn compile() -> Result<(), Failure> {
    tools::ensure_wasm_target()?;
    let mut compile =
        cargo(&["build", "--quiet", "--release", "--lib", "--target", "wasm32-unknown-unknown"]);
    run(compile.args(without_home()))
}

/// Builds what is wanted.
pub fn make(wanted: &Wanted<'_>) -> Result<Built, Failure> {
    let start = Instant::now();
    if !wanted.keep_wasm {
        compile()?;
    }
    let generated = bindings::generate(&tools::wasm_artifact(), &place::scratch().join("bindings"))?;
    let gzipped = weight::gzipped(&generated.wasm).len();
    let gathered = site::gather(&place::root(), &generated, wanted.figures)?;
    let weights = weight::first_visit(&gathered.site)?;
    let first_visit = weights.values().sum();
    within("the wasm", gzipped, WASM_CEILING, "")?;
    let all: Vec<String> = weights.iter().map(|(name, bytes)| format!("\n  {bytes} {name}")).collect();
    within("a first visit", first_visit, FIRST_VISIT_CEILING, &all.concat())?;
    gathered.site.write(wanted.out)?;
    let single = gathered.site.bytes(site::SINGLE)?.len();
    let (out, left_out) = (wanted.out.to_owned(), gathered.left_out);
    Ok(Built { out, gzipped, first_visit, single, left_out, took: start.elapsed() })
}

/// Lets no path of this machine into the wasm: panics name the files of crates by where the registry lies. Joined to the flags of
/// `.cargo/config.toml`.
fn without_home() -> Vec<String> {
    let home = std::env::var_os("CARGO_HOME")
        .map(PathBuf::from)
        .or_else(|| std::env::home_dir().map(|home| home.join(".cargo")));
    let remapped = |home: PathBuf| {
        let flags = format!("['--remap-path-prefix={}=cargo']", home.display());
        vec!["--config".to_owned(), format!("target.wasm32-unknown-unknown.rustflags={flags}")]
    };
    home.map(remapped).unwrap_or_default()
}

fn within(what: &str, bytes: usize, ceiling: usize, details: &str) -> Result<(), Failure> {
    if bytes <= ceiling {
        return Ok(());
    }
    let reason = format!("{bytes} bytes gzipped, which is more than the ceiling of {ceiling}{details}");
    Err(Failure::invalid(what, reason))
}
