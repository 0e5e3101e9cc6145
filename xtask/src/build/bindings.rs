//! The glue between JavaScript and the wasm, made by wasm-bindgen in this process.

use super::order::ordered;
use crate::Failure;
use std::path::Path;
use wasm_bindgen_cli_support::Bindgen;

/// What wasm-bindgen makes of the compiled library.
pub struct Generated {
    /// The glue, an ES module for the target "web".
    pub glue: String,
    /// The wasm that belongs to it.
    pub wasm: Vec<u8>,
}

/// Runs wasm-bindgen on `artifact`; `folder` takes what it writes.
pub fn generate(artifact: &Path, folder: &Path) -> Result<Generated, Failure> {
    let failed = |error: &dyn std::fmt::Display| {
        Failure::invalid(artifact.display().to_string(), format!("{error:#}"))
    };
    if folder.exists() {
        std::fs::remove_dir_all(folder).map_err(Failure::file(folder))?;
    }
    let mut bindgen = Bindgen::new();
    bindgen
        .input_path(artifact)
        .web(true)
        .map_err(|error| failed(&error))?
        .out_name("bindings")
        .typescript(false)
        // The hand-written module finds the wasm itself, in a page, in a worker and in Node alike.
        .omit_default_module_path(true)
        .remove_name_section(true)
        .remove_producers_section(true);
    let mut output = bindgen.generate_output().map_err(|error| failed(&error))?;
    output.emit(folder).map_err(|error| failed(&error))?;
    let (glue, wasm) = (folder.join("bindings.js"), folder.join("bindings_bg.wasm"));
    Ok(Generated {
        glue: std::fs::read_to_string(&glue).map_err(Failure::file(&glue))?,
        wasm: ordered(&std::fs::read(&wasm).map_err(Failure::file(&wasm))?)?,
    })
}
