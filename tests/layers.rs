//! The arrows between the layers, read off the sources: what ARCHITECTURE.md promises about who imports whom.
//!
//! Rust paths are read from the tokens, not from lines, so that grouped, renamed and `super::` imports are all seen; comments
//! and strings are not. The checkers are themselves tried on planted violations.

#[path = "layers/javascript.rs"]
mod javascript;
#[path = "layers/rust.rs"]
mod rust;
#[path = "layers/rust_tokens.rs"]
mod rust_tokens;

use std::fs;
use std::path::Path;

/// The text of every file below `folder` with one of these endings, with its path from the project's root.
fn sources(folder: &str, endings: &[&str]) -> Vec<(String, String)> {
    fn visit(folder: &Path, endings: &[&str], found: &mut Vec<(String, String)>) {
        for entry in fs::read_dir(folder).expect("a folder of the project") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                visit(&path, endings, found);
            } else if path.extension().is_some_and(|ending| endings.iter().any(|wanted| ending == *wanted)) {
                let name = path.strip_prefix(env!("CARGO_MANIFEST_DIR")).expect("inside the project");
                let name = name.to_string_lossy().replace('\\', "/");
                found.push((name, fs::read_to_string(&path).expect("UTF-8")));
            }
        }
    }
    let mut found = Vec::new();
    visit(&Path::new(env!("CARGO_MANIFEST_DIR")).join(folder), endings, &mut found);
    found.sort();
    found
}

#[test]
fn every_rust_layer_imports_only_what_it_may() {
    let files = sources("src", &["rs"]);
    assert!(files.len() > 10, "the sources were not found");
    let violations = rust::violations(&files);
    assert!(violations.is_empty(), "\n{}", violations.join("\n"));
}

#[test]
fn every_part_of_the_page_imports_only_what_it_may() {
    let files = sources("www", &["js"]);
    assert!(files.iter().any(|(name, _)| name == "www/main.js"), "the page's sources were not found");
    let violations = javascript::violations(&files);
    assert!(violations.is_empty(), "\n{}", violations.join("\n"));
}

#[test]
fn the_document_starts_the_engine_early_and_main_and_nothing_else() {
    let document =
        fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("index.html")).expect("index.html");
    let started = javascript::module_scripts(&document);
    let started: Vec<&str> = started.iter().map(|address| address.trim_start_matches("./")).collect();
    // An address that is not relative would not begin with www/.
    let plain = ["www/engine/ahead.js", "www/shell/beforehand.js", "www/figure/hold-back.js"];
    let expected = [&plain[..], &["www/engine/running.js", "www/main.js"]].concat();
    assert_eq!(started, expected);
}
