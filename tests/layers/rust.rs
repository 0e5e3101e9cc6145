//! Who may import whom among the modules of the crate.

use crate::rust_tokens::{Token, tokens};
use std::collections::BTreeSet;

/// The layers, each with the layers it may name besides `error` and `order`, which everyone may. A path means only that part of the layer.
///
/// `web` draws onto the canvas and therefore knows `chart`; nobody knows `web`.
const ARROWS: [(&str, &[&str]); 9] = [
    ("error", &[]),
    ("order", &[]),
    ("numerics", &[]),
    ("model", &["numerics"]),
    ("theory", &["model::parameters"]),
    ("study", &["model", "numerics", "theory"]),
    ("chart", &[]),
    ("figures", &["model::parameters", "study", "theory", "chart"]),
    ("web", &["figures", "study", "theory", "model", "chart"]),
];

/// Crates from elsewhere, or paths in them, each with the layers that may name them.
///
/// A complex number is a number: the theory's answers are of that type, and whoever shows them may say so.
const CRATES: [(&str, &[&str]); 8] = [
    ("nalgebra", &["numerics", "theory"]),
    ("nalgebra::Complex", &["figures"]),
    ("plotters", &["chart", "web"]),
    ("plotters_backend", &["chart", "web"]),
    ("plotters_canvas", &["web"]),
    ("wasm_bindgen", &["web"]),
    ("js_sys", &["web"]),
    ("web_sys", &["web"]),
];

/// The file whose contents every formula and every study shares: it must not lean on the numerics by a side door.
const SHARED_TABLE: &str = "src/model/parameters";

/// Everything in the sources that goes against the arrows, a line each.
pub fn violations(files: &[(String, String)]) -> Vec<String> {
    let numerics: Vec<Vec<Token>> = files
        .iter()
        .filter(|(name, _)| layer(name) == Some("numerics"))
        .map(|(_, text)| tokens(text))
        .collect();
    let interfaces = interfaces(&numerics);
    let mut found = Vec::new();
    for (name, text) in files {
        let Some(layer) = layer(name) else {
            if name != "src/lib.rs" {
                found.push(format!("{name} belongs to no layer"));
            }
            continue;
        };
        for path in paths(&tokens(text), &module_of(name)) {
            if let Some(reason) = objection(name, layer, &path, &interfaces) {
                found.push(format!("{name}: {}: {reason}", path.join("::")));
            }
        }
    }
    found
}

/// Why a file of a layer may not name this path, if it may not.
fn objection(file: &str, layer: &str, path: &[String], interfaces: &BTreeSet<String>) -> Option<String> {
    let first = path.first()?.as_str();
    if first != "crate" {
        let given = path.join("::");
        let mut entries = CRATES.iter().filter(|(entry, _)| leads_to(entry, &given));
        return (!entries.any(|(_, users)| users.contains(&layer)))
            .then(|| format!("{layer} does not use it"));
    }
    let Some(target) = path.get(1) else {
        return Some("the root hides which layer is meant".to_owned());
    };
    if ARROWS.iter().all(|(name, _)| name != target) {
        return Some(format!("\"{target}\" is no layer; name things where they live, not through the root"));
    }
    if file.starts_with(SHARED_TABLE)
        && target != "error"
        && path.get(2).is_none_or(|part| part != "parameters")
    {
        return Some("the table of parameters knows only error".to_owned());
    }
    if target == layer || target == "error" || target == "order" {
        return None;
    }
    let (_, allowed) = ARROWS.iter().find(|(name, _)| *name == layer)?;
    let inside = path[1..].join("::");
    if !allowed.iter().any(|arrow| leads_to(arrow, &inside)) {
        return Some(format!("{layer} may not know {target} (it may know: error {})", allowed.join(" ")));
    }
    let leaf = path.last()?;
    if layer == "model" && target == "numerics" && !interfaces.contains(leaf) {
        return Some("model fulfils the traits of numerics and calls none of its algorithms".to_owned());
    }
    None
}

/// Whether a path is this arrow's end or something inside of it.
fn leads_to(arrow: &str, path: &str) -> bool {
    path.strip_prefix(arrow).is_some_and(|rest| rest.is_empty() || rest.starts_with("::"))
}

/// The layer of a file, from its path.
fn layer(file: &str) -> Option<&'static str> {
    let inside = file.strip_prefix("src/")?;
    let first = inside.split('/').next()?.trim_end_matches(".rs");
    ARROWS.iter().map(|(name, _)| *name).find(|name| *name == first)
}

/// The path of the module that a file is.
fn module_of(file: &str) -> Vec<String> {
    let inside = file.trim_start_matches("src/").trim_end_matches(".rs").trim_end_matches("/mod");
    std::iter::once("crate").chain(inside.split('/')).map(str::to_owned).collect()
}

/// Names of the traits declared in these sources, and every name that stands in one (the types its methods speak of).
fn interfaces(sources: &[Vec<Token>]) -> BTreeSet<String> {
    let mut names = BTreeSet::new();
    for source in sources {
        let mut tokens = source.iter();
        while let Some(token) = tokens.next() {
            if *token != Token::Name("trait".to_owned()) {
                continue;
            }
            let mut depth = 0;
            for token in tokens.by_ref() {
                match token {
                    Token::Name(name) => {
                        names.insert(name.clone());
                    }
                    Token::Mark('{') => depth += 1,
                    Token::Mark('}') if depth == 1 => break,
                    Token::Mark('}') => depth -= 1,
                    _ => {}
                }
            }
        }
    }
    names
}

/// Every path in a file that begins at the root, at a parent or at a known crate, whole: groups are taken apart.
fn paths(tokens: &[Token], module: &[String]) -> Vec<Vec<String>> {
    let mut found = Vec::new();
    // Inline modules we are inside of: name and the depth of braces at which they end.
    let mut inline: Vec<(String, usize)> = Vec::new();
    let mut depth = 0;
    let mut at = 0;
    while let Some(token) = tokens.get(at) {
        match token {
            Token::Mark('{') => depth += 1,
            Token::Mark('}') => {
                depth -= 1;
                if inline.last().is_some_and(|(_, start)| *start == depth) {
                    inline.pop();
                }
            }
            Token::Name(name) if name == "mod" => {
                if let (Some(Token::Name(name)), Some(Token::Mark('{'))) =
                    (tokens.get(at + 1), tokens.get(at + 2))
                {
                    inline.push((name.clone(), depth));
                }
            }
            Token::Name(name) => {
                let inside = at > 0 && tokens[at - 1] == Token::Colons;
                let used = at > 0 && tokens[at - 1] == Token::Name("use".to_owned());
                let goes_on = tokens.get(at + 1) == Some(&Token::Colons);
                let known = ["crate", "super", "self", "gear_bifurcations"].contains(&name.as_str())
                    || CRATES.iter().any(|(name_of_crate, _)| name_of_crate == name);
                if known && !inside && (goes_on || used) {
                    let here = module
                        .iter()
                        .cloned()
                        .chain(inline.iter().map(|(name, _)| name.clone()))
                        .collect::<Vec<_>>();
                    let mut ends = Vec::new();
                    read_tree(tokens, &mut at, &[], &mut ends);
                    found.extend(ends.into_iter().map(|path| absolute(path, &here)));
                    continue;
                }
            }
            _ => {}
        }
        at += 1;
    }
    found
}

/// Reads `a::b::{c, d::e as f, *}` from `at` on; each leaf becomes a path. Leaves `at` on what follows.
fn read_tree(tokens: &[Token], at: &mut usize, prefix: &[String], found: &mut Vec<Vec<String>>) {
    let mut path = prefix.to_vec();
    loop {
        match tokens.get(*at) {
            Some(Token::Name(name)) => {
                path.push(name.clone());
                *at += 1;
            }
            Some(Token::Mark('*')) => {
                path.push("*".to_owned());
                *at += 1;
                break;
            }
            Some(Token::Mark('{')) => {
                *at += 1;
                while let Some(token) = tokens.get(*at) {
                    match token {
                        Token::Mark('}') => break,
                        Token::Name(_) | Token::Mark('*') => read_tree(tokens, at, &path, found),
                        _ => *at += 1,
                    }
                }
                *at += 1;
                return;
            }
            // A turbofish `::<`: the path has ended.
            _ => break,
        }
        if tokens.get(*at) != Some(&Token::Colons) {
            break;
        }
        *at += 1;
    }
    // `as` and the new name: not part of the path, and not the beginning of another.
    if tokens.get(*at) == Some(&Token::Name("as".to_owned())) && prefix_is_import(tokens, *at) {
        *at += 2;
    }
    found.push(path);
}

/// Whether the `as` at this place renames an import (and is not a cast).
fn prefix_is_import(tokens: &[Token], at: usize) -> bool {
    matches!(tokens.get(at + 2), Some(Token::Mark(';' | ',' | '}')))
}

/// A path seen from the root: `super` and `self` replaced, our own crate's name as well.
fn absolute(path: Vec<String>, here: &[String]) -> Vec<String> {
    let mut base = here.to_vec();
    let mut rest = path.as_slice();
    match rest.first().map(String::as_str) {
        Some("super" | "self") => {
            while let Some(first) = rest.first().filter(|part| *part == "super" || *part == "self") {
                if first == "super" {
                    base.pop();
                }
                rest = &rest[1..];
            }
        }
        Some("gear_bifurcations") => (base, rest) = (vec!["crate".to_owned()], &rest[1..]),
        _ => return path.into_iter().filter(|part| part != "self").collect(),
    }
    base.into_iter().chain(rest.iter().filter(|part| *part != "self").cloned()).collect()
}

#[cfg(test)]
mod tests {
    use super::violations;

    /// The number of objections to one file, beside a numerics with one trait.
    fn objections(file: &str, text: &str) -> usize {
        let numerics =
            "pub struct Step; pub trait Field { fn rates(&self, step: &Step); } pub fn integrate() {}";
        violations(&[
            ("src/numerics/ode.rs".to_owned(), numerics.to_owned()),
            (file.to_owned(), text.to_owned()),
        ])
        .len()
    }

    #[test]
    fn planted_violations_are_found() {
        for (file, text) in [
            ("src/theory/modes.rs", "use crate::numerics::roots::bisect;"),
            ("src/theory/modes.rs", "use crate::{error::TheoryError, numerics::{self, roots}};"),
            ("src/theory/modes.rs", "use super::super::numerics;"),
            ("src/theory/mod.rs", "use super::numerics as n;"),
            ("src/theory/mod.rs", "fn f() { super::numerics::newton::solve(); }"),
            ("src/theory/mod.rs", "mod tests { use super::super::numerics; }"),
            ("src/theory/modes.rs", "fn f() -> f64 { crate::numerics::newton::solve(1.0) }"),
            ("src/theory/modes.rs", "use gear_bifurcations::numerics;"),
            ("src/theory/modes.rs", "use crate::model::equations::GearPair;"),
            ("src/theory/modes.rs", "use crate::model;"),
            ("src/theory/modes.rs", "use crate::*;"),
            ("src/theory/modes.rs", "use crate as all;"),
            ("src/theory/modes.rs", "use crate::Parameters;"),
            ("src/numerics/newton.rs", "use crate::model::parameters::Parameters;"),
            ("src/model/equations.rs", "use crate::numerics::ode::integrate;"),
            ("src/model/equations.rs", "use crate::numerics::ode;"),
            ("src/model/equations.rs", "use crate::numerics::ode::*;"),
            ("src/model/parameters.rs", "use crate::numerics::ode::Field;"),
            ("src/model/parameters.rs", "use super::equations;"),
            ("src/study/orbit.rs", "use crate::figures::Figure;"),
            ("src/chart/axes.rs", "use crate::model::parameters::Parameters;"),
            ("src/chart/axes.rs", "use nalgebra::Matrix3;"),
            ("src/chart/axes.rs", "use web_sys;"),
            ("src/figures/job.rs", "use crate::numerics::ode::Field;"),
            ("src/figures/job.rs", "use plotters::style::Color;"),
            ("src/figures/job.rs", "use nalgebra::{Complex, Matrix3};"),
            ("src/study/orbit.rs", "type Number = nalgebra::Complex<f64>;"),
            ("src/figures/job.rs", "fn f(x: f64) { let y = x as f64; crate::web::show(y); }"),
            ("src/error.rs", "use crate::model::parameters::Parameters;"),
            ("src/misc/help.rs", ""),
        ] {
            assert!(objections(file, text) > 0, "{file}: {text}");
        }
    }

    #[test]
    fn what_is_allowed_is_let_pass() {
        for (file, text) in [
            ("src/lib.rs", "pub use crate::theory::modes; pub mod web;"),
            (
                "src/theory/modes.rs",
                "use crate::model::parameters::{self, Symmetric as S}; use super::primary::Branch;",
            ),
            (
                "src/theory/mod.rs",
                "pub use modes::{Mode, Modes}; mod tests { use super::*; use super::modes; }",
            ),
            (
                "src/theory/modes.rs",
                "//! like [`crate::numerics`]\nconst WORDS: &str = \"crate::numerics::x\";",
            ),
            ("src/theory/hill.rs", "use nalgebra::Matrix2; use crate::error::TheoryError;"),
            (
                "src/model/equations.rs",
                "use crate::numerics::ode::{Field, Step}; use super::parameters::Parameters;",
            ),
            ("src/model/parameters.rs", "use crate::error::ModelError; use super::parameters;"),
            ("src/study/orbit.rs", "use crate::{model::equations, numerics::newton, theory};"),
            ("src/figures/job.rs", "use crate::study::orbit; use crate::model::parameters::Parameters;"),
            ("src/figures/job.rs", "type Number = nalgebra::Complex<f64>;"),
            ("src/chart/axes.rs", "use plotters::prelude::DrawingBackend; use crate::error::ChartError;"),
            (
                "src/web/draw.rs",
                "use wasm_bindgen::JsValue; use crate::{chart, figures, study, theory, model};",
            ),
        ] {
            assert_eq!(objections(file, text), 0, "{file}: {text}");
        }
    }
}
