//! One self-contained ES module out of two: the hand-written one, and inside it the generated glue as a factory.
//!
//! wasm-bindgen's glue keeps the instance in variables of its module. Wrapped in a function, each call gives bindings
//! of their own, so that a user can load twice and nothing is shared.

use crate::Failure;

/// The line of the hand-written module in whose place the factory goes.
const IMPORT: &str = "import { createBindings } from \"./bindings.js\";";

/// Puts the generated glue into the hand-written module.
pub fn splice(handwritten: &str, glue: &str) -> Result<String, Failure> {
    let failed = |reason: String| Failure::invalid("www/engine/gear-bifurcations.js", reason);
    if handwritten.lines().filter(|line| line.trim_end() == IMPORT).count() != 1 {
        return Err(failed(format!("the line `{IMPORT}` must stand in it exactly once")));
    }
    let factory = factory(glue)?;
    let mut module = String::with_capacity(handwritten.len() + factory.len());
    for line in handwritten.lines() {
        if line.trim_end() == IMPORT {
            module.push_str(&factory);
        } else if is_import(line) {
            return Err(failed(format!("`{}`: the module must stand alone", line.trim())));
        } else {
            module.push_str(line);
            module.push('\n');
        }
    }
    Ok(module)
}

/// The glue as a function that returns its exports.
fn factory(glue: &str) -> Result<String, Failure> {
    let failed = |reason: String| Failure::invalid("the generated bindings", reason);
    let mut names = Vec::new();
    let mut body = String::with_capacity(glue.len());
    let mut initialisers = false;
    for line in glue.lines() {
        let Some(exported) = line.strip_prefix("export ") else {
            if is_import(line) || line.contains("import.meta") {
                return Err(failed(format!("`{line}` cannot stand in a function")));
            }
            push_indented(&mut body, line);
            continue;
        };
        if exported.starts_with('{') {
            // `export { initSync, __wbg_init as default };`: both are returned below under their own names.
            initialisers = exported.contains("initSync") && exported.contains("__wbg_init");
            continue;
        }
        names.push(
            declared_name(exported).ok_or_else(|| failed(format!("`{line}` declares no name we know")))?,
        );
        push_indented(&mut body, exported);
    }
    if names.is_empty() {
        return Err(failed("they export nothing of ours".to_owned()));
    }
    if !initialisers {
        return Err(failed("they export no initSync and __wbg_init".to_owned()));
    }
    names.sort_unstable();
    let names = names.join(", ");
    Ok(format!(
        "// Made by wasm-bindgen from src/web; each call gives bindings that share nothing with any other.\n\
         function createBindings() {{\n{body}    return {{ initSync, init: __wbg_init, {names} }};\n}}\n"
    ))
}

/// Whether a line is a static import.
fn is_import(line: &str) -> bool {
    line.strip_prefix("import").is_some_and(|rest| rest.starts_with([' ', '{', '*', '"', '\'']))
}

/// The name that a declaration after `export` declares.
fn declared_name(declaration: &str) -> Option<&str> {
    let kinds = ["async function ", "function ", "class ", "const "];
    let rest = kinds.iter().find_map(|kind| declaration.strip_prefix(kind))?;
    let end = rest.find(|c: char| !(c.is_ascii_alphanumeric() || c == '_' || c == '$'))?;
    (end > 0).then(|| &rest[..end])
}

fn push_indented(body: &mut String, line: &str) {
    if !line.is_empty() {
        body.push_str("    ");
        body.push_str(line);
    }
    body.push('\n');
}

#[cfg(test)]
mod tests {
    use super::{IMPORT, splice};

    const GLUE: &str = "\
let wasm;

export class Job {
    free() {}
}
export function figure(id) {
    return wasm.figure(id);
}
function initSync(module) {}
async function __wbg_init(source) {}
export { initSync, __wbg_init as default };
";

    #[test]
    fn the_glue_becomes_a_function_that_returns_its_exports() {
        let module =
            splice(&format!("// top\n{IMPORT}\nexport const load = () => createBindings();\n"), GLUE)
                .unwrap();
        assert!(module.starts_with("// top\n// Made by wasm-bindgen"));
        assert!(module.contains(
            "function createBindings() {\n    let wasm;\n\n    class Job {\n        free() {}\n    }\n"
        ));
        assert!(module.contains("    return { initSync, init: __wbg_init, Job, figure };\n}\n"));
        assert!(module.ends_with("export const load = () => createBindings();\n"));
        assert_eq!(module.matches("export ").count(), 1);
        assert!(!module.contains("import "));
    }

    #[test]
    fn the_import_must_stand_exactly_once_and_alone() {
        assert!(splice("export const load = 1;\n", GLUE).is_err());
        assert!(splice(&format!("{IMPORT}\n{IMPORT}\n"), GLUE).is_err());
        assert!(splice(&format!("{IMPORT}\nimport {{ x }} from \"./x.js\";\n"), GLUE).is_err());
    }

    #[test]
    fn glue_that_cannot_stand_in_a_function_is_refused() {
        for line in ["import * as env from 'env';", "const url = import.meta.url;", "export let x = 1;"] {
            assert!(splice(&format!("{IMPORT}\n"), &format!("{line}\n{GLUE}")).is_err(), "{line}");
        }
        assert!(splice(&format!("{IMPORT}\n"), "export function figure() {}\n").is_err());
    }
}
