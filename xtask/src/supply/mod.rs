//! Where everything comes from that is not ours, under which terms, and why it is there: read from both lock files, checked, and
//! written down in `docs/dependencies.md`.

mod license;

use crate::command::{cargo, output_of};
use crate::{Failure, place};
use license::Use;
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::path::Path;

const CRATES: &str = "registry+https://github.com/rust-lang/crates.io-index";
const NPM: &str = "https://registry.npmjs.org/";
const DOCUMENT: &str = "docs/dependencies.md";

/// A package that is not ours.
struct Package {
    license: String,
    /// Why it is there, where we asked for it ourselves.
    reason: Option<String>,
    /// Who asks for it otherwise.
    by: BTreeSet<String>,
}

/// By name and version.
type Packages = BTreeMap<String, Package>;

/// Checks sources, terms and the document; says how many packages there are.
pub fn check() -> Result<(), Failure> {
    let (crates, npm) = (crates()?, npm()?);
    let text = document(&crates, &npm);
    let path = place::root().join(DOCUMENT);
    let present = std::fs::read_to_string(&path).map_err(Failure::file(&path))?;
    if present != text {
        return Err(Failure::invalid(
            DOCUMENT,
            "it is not what the lock files say: `cargo xtask dependencies` renews it",
        ));
    }
    println!(
        "{} crates and {} npm packages, of known source and under allowed terms",
        crates.len(),
        npm.len()
    );
    Ok(())
}

/// Writes the document anew.
pub fn renew() -> Result<(), Failure> {
    let path = place::root().join(DOCUMENT);
    std::fs::write(&path, document(&crates()?, &npm()?)).map_err(Failure::file(&path))
}

/// Every crate of the lock file.
fn crates() -> Result<Packages, Failure> {
    let told = output_of(&mut cargo(&["metadata", "--format-version", "1", "--locked", "--all-features"]))?;
    let told: Value =
        serde_json::from_str(&told).map_err(|error| Failure::invalid("cargo metadata", error.to_string()))?;
    let lock = read(&place::root().join("Cargo.lock"))?;
    let mut reasons = reasons_in_toml(&read(&place::root().join("Cargo.toml"))?);
    reasons.extend(reasons_in_toml(&read(&place::root().join("xtask/Cargo.toml"))?));
    packages_of(&told, &lock, &reasons)
}

fn packages_of(told: &Value, lock: &str, reasons: &BTreeMap<String, String>) -> Result<Packages, Failure> {
    let (mut found, mut names, mut direct) = (Packages::new(), BTreeMap::new(), BTreeSet::new());
    for package in list(&told["packages"]) {
        let (name, version) = (text(&package["name"]), text(&package["version"]));
        names.insert(text(&package["id"]), format!("{name} {version}"));
        if package["source"].is_null() {
            direct.insert(text(&package["id"]));
            continue;
        }
        let failed = |reason: &str| Err(Failure::invalid(format!("the crate {name} {version}"), reason));
        if text(&package["source"]) != CRATES {
            return failed("it does not come from crates.io");
        }
        let entry =
            format!("name = \"{name}\"\nversion = \"{version}\"\nsource = \"{CRATES}\"\nchecksum = \"");
        if !lock.contains(&entry) {
            return failed("Cargo.lock has no checksum of it");
        }
        let license = text(&package["license"]);
        if !license::allowed(&license, Use::PassedOn) {
            return failed(&format!("its terms, \"{license}\", are not among those allowed"));
        }
        found.insert(format!("{name} {version}"), Package { license, reason: None, by: BTreeSet::new() });
    }
    for node in list(&told["resolve"]["nodes"]) {
        let asking = text(&node["id"]);
        for wanted in list(&node["dependencies"]).iter().filter_map(|id| names.get(&text(id))) {
            let Some(package) = found.get_mut(wanted) else { continue };
            if direct.contains(&asking) {
                let name = wanted.split(' ').next().unwrap_or_default();
                let reason = reasons.get(name).ok_or_else(|| {
                    Failure::invalid(
                        format!("the crate {name}"),
                        "Cargo.toml must say why it is there, in a comment above it",
                    )
                })?;
                package.reason = Some(reason.clone());
            } else if let Some(asking) = names.get(&asking) {
                package.by.insert(asking.split(' ').next().unwrap_or_default().to_owned());
            }
        }
    }
    Ok(found)
}

/// The comments above the dependencies of a Cargo.toml, by name. One comment may stand above several.
fn reasons_in_toml(toml: &str) -> BTreeMap<String, String> {
    let (mut reasons, mut reason, mut open) = (BTreeMap::new(), String::new(), false);
    for line in toml.lines() {
        if let Some(comment) = line.strip_prefix("# ") {
            if !std::mem::replace(&mut open, true) {
                reason.clear();
            }
            let gap = if reason.is_empty() { "" } else { " " };
            let _ = write!(reason, "{gap}{comment}");
            continue;
        }
        open = false;
        if line.is_empty() || line.starts_with('[') {
            reason.clear();
        } else if let Some((name, _)) = line.split_once(" = ").filter(|_| !reason.is_empty()) {
            reasons.insert(name.to_owned(), reason.clone());
        }
    }
    reasons
}

/// Every npm package of the lock file.
fn npm() -> Result<Packages, Failure> {
    let parsed = |name: &str| -> Result<Value, Failure> {
        serde_json::from_str(&read(&place::root().join(name))?)
            .map_err(|error| Failure::invalid(name, error.to_string()))
    };
    npm_packages_of(&parsed("package-lock.json")?, &parsed("package.json")?["//devDependencies"])
}

fn npm_packages_of(lock: &Value, reasons: &Value) -> Result<Packages, Failure> {
    let mut found = Packages::new();
    let empty = serde_json::Map::new();
    let all = lock["packages"].as_object().unwrap_or(&empty);
    let name_of = |path: &str| path.rsplit("node_modules/").next().unwrap_or_default().to_owned();
    for (path, package) in all.iter().filter(|(path, _)| !path.is_empty()) {
        let name = name_of(path);
        let failed = |reason: &str| Err(Failure::invalid(format!("the npm package {name}"), reason));
        if package.get("resolved").is_some_and(|address| !text(address).starts_with(NPM)) {
            return failed("it does not come from registry.npmjs.org");
        }
        if text(&package["integrity"]).is_empty() {
            return failed("package-lock.json has no hash of it");
        }
        let license = text(&package["license"]);
        if !license::allowed(&license, Use::InTests) {
            return failed(&format!("its terms, \"{license}\", are not among those allowed"));
        }
        let by = all.iter().filter(|(asking, other)| {
            let kinds = ["dependencies", "optionalDependencies"];
            !asking.is_empty() && kinds.iter().any(|kind| other[*kind].get(&name).is_some())
        });
        let by: BTreeSet<String> = by.map(|(asking, _)| name_of(asking)).collect();
        let reason = reasons.get(&name).map(text);
        let direct = &lock["packages"][""];
        if ["dependencies", "devDependencies"].iter().any(|kind| direct[*kind].get(&name).is_some())
            && reason.is_none()
        {
            return failed("package.json must say why it is there, under \"//devDependencies\"");
        }
        found.insert(format!("{name} {}", text(&package["version"])), Package { license, reason, by });
    }
    Ok(found)
}

/// The document.
fn document(crates: &Packages, npm: &Packages) -> String {
    let mut whole = String::from(
        "# What is not ours\n\n\
         Every package of both lock files, why it is there and under which terms. Written by `cargo xtask dependencies`; `cargo xtask test` checks that it is\n\
         so, that every crate comes from crates.io and every npm package from registry.npmjs.org with a hash of its content, and that all terms are among\n\
         those that ask for no more than their text to be kept, or, for tools that only tests use, are free in some other way. The page runs no npm package; the library and its wasm hold those crates that are asked for by\n\
         `Cargo.toml` (not by `xtask/Cargo.toml`).\n",
    );
    for (title, packages) in [("Crates", crates), ("npm packages, for tests alone", npm)] {
        let _ = write!(whole, "\n## {title}\n\n| package | why | terms |\n|---|---|---|\n");
        let asked = packages.iter().filter(|(_, package)| package.reason.is_some());
        let brought = packages.iter().filter(|(_, package)| package.reason.is_none());
        for (name, Package { license, reason, by }) in asked.chain(brought) {
            let by: Vec<&str> = by.iter().map(String::as_str).collect();
            let why = reason.clone().unwrap_or_else(|| format!("for {}", by.join(", ")));
            let _ = writeln!(whole, "| {name} | {why} | {license} |");
        }
    }
    whole
}

fn read(path: &Path) -> Result<String, Failure> {
    std::fs::read_to_string(path).map_err(Failure::file(path))
}

fn list(value: &Value) -> &[Value] {
    value.as_array().map_or(&[], Vec::as_slice)
}

fn text(value: &Value) -> String {
    value.as_str().unwrap_or_default().to_owned()
}

#[cfg(test)]
mod tests {
    use super::{CRATES, npm_packages_of, packages_of, reasons_in_toml};
    use serde_json::json;
    use std::collections::BTreeMap;

    #[test]
    fn reasons_stand_above_what_they_explain() {
        let reasons = reasons_in_toml(
            "[dependencies]\n# One\n# reason.\na = \"1\"\nb = { version = \"2\" }\n\n[other]\nc = \"3\"\n# Two.\nd = \"4\"\n",
        );
        let reasons: Vec<_> = reasons.iter().map(|(name, reason)| (name.as_str(), reason.as_str())).collect();
        assert_eq!(reasons, [("a", "One reason."), ("b", "One reason."), ("d", "Two.")]);
    }

    #[test]
    fn crates_of_other_sources_and_terms_or_without_hash_or_reason_are_refused() {
        let told = |source: &str, license: &str| {
            json!({
                "packages": [
                    { "name": "ours", "version": "1", "id": "o", "source": null, "license": null },
                    { "name": "a", "version": "2", "id": "a", "source": source, "license": license },
                ],
                "resolve": { "nodes": [{ "id": "o", "dependencies": ["a"] }] },
            })
        };
        let lock = format!("name = \"a\"\nversion = \"2\"\nsource = \"{CRATES}\"\nchecksum = \"x\"");
        let reasons = BTreeMap::from([("a".to_owned(), "it helps".to_owned())]);
        let found = packages_of(&told(CRATES, "MIT"), &lock, &reasons).unwrap();
        assert_eq!(found["a 2"].reason.as_deref(), Some("it helps"));
        assert!(packages_of(&told("git+https://x", "MIT"), &lock, &reasons).is_err());
        assert!(packages_of(&told(CRATES, "GPL-3.0"), &lock, &reasons).is_err());
        assert!(packages_of(&told(CRATES, "MIT"), "", &reasons).is_err());
        assert!(packages_of(&told(CRATES, "MIT"), &lock, &BTreeMap::new()).is_err());
    }

    #[test]
    fn npm_packages_of_other_sources_and_terms_or_without_hash_or_reason_are_refused() {
        let lock = |key: &str, value: &str| {
            let mut package = json!({ "version": "1", "integrity": "sha512-x", "license": "MIT" });
            package[key] = value.into();
            json!({ "packages": { "": { "devDependencies": { "a": "1" } }, "node_modules/a": package } })
        };
        let reasons = json!({ "a": "it helps" });
        assert!(npm_packages_of(&lock("license", "MIT"), &reasons).is_ok());
        assert!(npm_packages_of(&lock("license", "MIT"), &json!({})).is_err());
        for (key, value) in
            [("license", "GPL-3.0"), ("integrity", ""), ("resolved", "https://elsewhere.example/a.tgz")]
        {
            assert!(npm_packages_of(&lock(key, value), &reasons).is_err(), "{key}");
        }
    }
}
