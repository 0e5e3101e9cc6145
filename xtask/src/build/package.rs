//! The npm package: module, wasm, types, a README and the licences, and nothing that runs when it is installed.

use super::site::{MODULE, Site, VERSION};
use crate::Failure;
use serde_json::json;
use std::path::Path;

/// The folder of the package in the site.
pub const FOLDER: &str = "package";

/// Adds the package; `module` is the module with its comments, for whoever reads it.
pub fn add(site: &mut Site, root: &Path, module: &str) -> Result<(), Failure> {
    let into = |name: &str| format!("{FOLDER}/{name}");
    let same = ["gear-bifurcations_bg.wasm", "gear-bifurcations.d.ts"];
    for name in same {
        let content = site.bytes(name)?.to_vec();
        site.add(&into(name), content);
    }
    site.add(&into(MODULE), module);
    site.copy(&root.join("docs/package.md"), &into("README.md"))?;
    for name in ["LICENSE-MIT", "LICENSE-APACHE"] {
        site.copy(&root.join(name), &into(name))?;
    }
    let mut manifest = manifest();
    manifest["description"] = "Pitchfork and Hopf bifurcations of gear pairs: a paper's formulas beside exact numerics, in WebAssembly".into();
    manifest["keywords"] =
        json!(["bifurcation", "floquet", "gear", "parametric-resonance", "nonlinear-dynamics", "wasm"]);
    manifest["engines"] = json!({ "node": ">=20" });
    manifest["sideEffects"] = false.into();
    manifest["files"] = json!([MODULE, same[0], same[1], "LICENSE-MIT", "LICENSE-APACHE"]);
    site.add(&into("package.json"), text(&manifest));
    Ok(())
}

/// Lets Node and editors take the site's folder itself as a package: without it Node 20 would read the module as `CommonJS`.
pub fn of_folder() -> String {
    text(&manifest())
}

fn manifest() -> serde_json::Value {
    let module = json!({ "types": "./gear-bifurcations.d.ts", "default": "./gear-bifurcations.js" });
    json!({
        "name": "gear-bifurcations",
        "version": VERSION,
        "license": "MIT OR Apache-2.0",
        "type": "module",
        "exports": {
            ".": module,
            "./gear-bifurcations.js": module,
            "./gear-bifurcations_bg.wasm": "./gear-bifurcations_bg.wasm",
            "./package.json": "./package.json",
        },
        "types": "./gear-bifurcations.d.ts",
    })
}

fn text(manifest: &serde_json::Value) -> String {
    format!("{manifest:#}\n")
}
