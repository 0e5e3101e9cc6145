//! Who may import whom among the parts of the page.
//!
//! What a part imports when it runs is one thing; what it says about types in a JSDoc comment is another, and free.

/// The parts of `www/`, each with the parts whose modules it may import when it runs.
const ARROWS: [(&str, &[&str]); 14] = [
    (
        "main",
        &[
            "main",
            "state",
            "engine",
            "figure",
            "controls",
            "words",
            "shell",
            "story",
            "lab",
            "classroom",
            "exports",
            "embed",
            "offline",
        ],
    ),
    ("state", &["state"]),
    ("engine", &["engine", "module"]),
    ("words", &["words"]),
    ("style", &["style"]),
    ("figure", &["figure", "controls", "style", "words"]),
    ("controls", &["controls", "figure", "words"]),
    ("shell", &["shell", "state", "style", "words"]),
    ("story", &["story", "state", "words"]),
    ("exports", &["exports", "state", "figure", "style", "words"]),
    ("lab", &["lab", "state", "figure", "controls", "exports", "style", "words"]),
    ("classroom", &["classroom", "state", "figure", "controls", "exports", "style", "words"]),
    ("offline", &["offline", "words"]),
    ("embed", &["embed", "state", "engine", "figure", "controls", "exports", "style", "words"]),
];

/// Everything in the page's sources that goes against the arrows, a line each.
pub fn violations(files: &[(String, String)]) -> Vec<String> {
    let mut found = Vec::new();
    for (name, text) in files {
        let Some((part, allowed)) =
            part_of(name).and_then(|part| ARROWS.iter().find(|(name, _)| *name == part))
        else {
            found.push(format!("{name} belongs to no part of the page"));
            continue;
        };
        let code = without_comments(text);
        for address in imports(&code) {
            match target(name, &address) {
                None => {
                    found.push(format!("{name}: \"{address}\" is not a relative address inside the page"));
                }
                Some(file) => match part_of(&file) {
                    Some(target) if allowed.contains(&target) => {}
                    Some(target) => {
                        found.push(format!("{name}: {part} may not import {target} (\"{address}\")"));
                    }
                    None => found.push(format!("{name}: \"{address}\" belongs to no part of the page")),
                },
            }
        }
        // Words about it are no part of it.
        if *part != "engine" && *part != "words" && code.contains("WebAssembly") {
            found.push(format!("{name}: only engine/ touches the wasm"));
        }
    }
    found
}

/// The addresses of the scripts that a document loads. An inline script, which would be a part of its own, counts as `inline`.
pub fn module_scripts(document: &str) -> Vec<String> {
    let mut found = Vec::new();
    let mut rest = document;
    while let Some(start) = rest.find("<script") {
        let end = rest[start..].find('>').map_or(rest.len(), |length| start + length);
        let tag = &rest[start..end];
        rest = &rest[end..];
        let quoted = tag.split_once("src=\"").and_then(|(_, after)| after.split_once('"'));
        found.push(quoted.map_or_else(|| "inline".to_owned(), |(address, _)| address.to_owned()));
    }
    found
}

/// The part of the page that a file belongs to; `module` is the built gear-bifurcations.js.
fn part_of(file: &str) -> Option<&'static str> {
    match file {
        "gear-bifurcations.js" => return Some("module"),
        "www/main.js" => return Some("main"),
        "www/state.js" | "www/url.js" | "www/history.js" | "www/presets.js" | "www/values.js" => {
            return Some("state");
        }
        _ => {}
    }
    ARROWS.iter().map(|(part, _)| *part).find(|part| file.starts_with(&format!("www/{part}/")))
}

/// The file that an address in another file leads to, from the project's root.
fn target(from: &str, address: &str) -> Option<String> {
    if !address.starts_with("./") && !address.starts_with("../") {
        // The one exception: the module reads its wasm through Node where there is one, by a name that it keeps in a
        // variable so that bundlers do not follow it. Whether it asks the network for anything is tested in the browser.
        return (from == "www/engine/gear-bifurcations.js"
            && (address.starts_with("node:") || address == "?"))
            .then(|| "www/engine/gear-bifurcations.js".to_owned());
    }
    let mut parts: Vec<&str> = from.split('/').collect();
    parts.pop();
    for part in address.split('/') {
        match part {
            "." => {}
            ".." => {
                parts.pop()?;
            }
            name => parts.push(name),
        }
    }
    Some(parts.join("/"))
}

/// The addresses that code imports from: statically, on demand, or as a worker. An address that is not written out is `?`.
fn imports(code: &str) -> Vec<String> {
    let mut found = Vec::new();
    for (at, _) in code.match_indices("import").chain(code.match_indices("export")) {
        let word = |c: char| c.is_alphanumeric() || c == '_' || c == '$';
        if code[..at].ends_with(word) || code[..at].ends_with('.') || code[at + 6..].starts_with(word) {
            continue;
        }
        let export = code[at..].starts_with("export");
        let rest = code[at + 6..].trim_start();
        if rest.starts_with("(${") {
            // Part of a text that is a script: what it imports is filled in, and written out where that is done.
        } else if let Some(argument) = rest.strip_prefix('(').filter(|_| !export) {
            found.push(quoted(argument).unwrap_or_else(|| "?".to_owned()));
        } else if rest.starts_with('.') {
            // import.meta
        } else if let Some(address) = quoted(rest).filter(|_| !export) {
            found.push(address);
        } else if !export || rest.starts_with(['{', '*']) {
            // Up to `from`, which for an export list may be missing.
            let clause = &rest[..rest.find(';').unwrap_or(rest.len())];
            found.extend(clause.rsplit_once("from").and_then(|(_, address)| quoted(address)));
        }
    }
    for (at, _) in code.match_indices("new URL(") {
        let rest = &code[at + "new URL(".len()..];
        // A script this way is a worker; anything else, such as the wasm, is a file to fetch.
        found.extend(quoted(rest).filter(|address| address.rsplit('.').next() == Some("js")));
    }
    found
}

/// The quoted text at the beginning.
fn quoted(text: &str) -> Option<String> {
    let text = text.trim_start();
    let mark = text.chars().next().filter(|mark| matches!(mark, '"' | '\''))?;
    text[1..].split_once(mark).map(|(inside, _)| inside.to_owned())
}

/// The code without its comments. Quoted texts stay: addresses are among them.
fn without_comments(text: &str) -> String {
    let mut code = String::with_capacity(text.len());
    let mut rest = text;
    let mut quote: Option<char> = None;
    while let Some(c) = rest.chars().next() {
        let mut length = c.len_utf8();
        match quote {
            Some(mark) => {
                if c == '\\' {
                    length += rest[length..].chars().next().map_or(0, char::len_utf8);
                } else if c == mark || (c == '\n' && mark != '`') {
                    quote = None;
                }
                code.push_str(&rest[..length]);
            }
            None if rest.starts_with("//") => length = rest.find('\n').unwrap_or(rest.len()),
            None if rest.starts_with("/*") => length = rest.find("*/").map_or(rest.len(), |end| end + 2),
            None => {
                if matches!(c, '"' | '\'' | '`') {
                    quote = Some(c);
                }
                code.push(c);
            }
        }
        rest = &rest[length..];
    }
    code
}

#[cfg(test)]
mod tests {
    use super::{module_scripts, violations};

    fn objections(file: &str, text: &str) -> usize {
        violations(&[(file.to_owned(), text.to_owned())]).len()
    }

    #[test]
    fn planted_violations_are_found() {
        for (file, text) in [
            ("www/figure/gear-figure.js", "import { client } from \"../engine/client.js\";"),
            ("www/figure/gear-figure.js", "import { a,\n  b } from '../state.js'"),
            ("www/figure/gear-figure.js", "export { load } from \"../../gear-bifurcations.js\";"),
            ("www/figure/gear-figure.js", "export * from \"../state.js\";"),
            ("www/controls/slider.js", "const main = await import(\"../main.js\");"),
            ("www/controls/slider.js", "const part = await import(address);"),
            ("www/controls/slider.js", "import \"../url.js\";"),
            ("www/controls/slider.js", "new Worker(new URL(\"../engine/worker.js\", import.meta.url));"),
            ("www/main.js", "import { load } from \"../gear-bifurcations.js\";"),
            ("www/main.js", "await WebAssembly.compile(bytes);"),
            ("www/main.js", "import x from \"lodash\";"),
            ("www/main.js", "import x from \"https://cdn.example/x.js\";"),
            ("www/main.js", "import x from \"/www/state.js\";"),
            ("www/state.js", "import { draw } from \"./figure/gear-figure.js\";"),
            ("www/url.js", "import { say } from \"./words/say.js\";"),
            ("www/words/say.js", "import { language } from \"../state.js\";"),
            ("www/lab/lab.js", "import { engine } from \"../engine/running.js\";"),
            ("www/lab/lab.js", "import { lessons } from \"../classroom/lessons.js\";"),
            ("www/story/story.js", "import { engine } from \"../engine/running.js\";"),
            ("www/shell/palette.js", "import { start } from \"../lab/lab.js\";"),
            ("www/engine/client.js", "import { state } from \"../state.js\";"),
            ("www/engine/client.js", "import fs from \"node:fs\";"),
            ("www/other.js", ""),
        ] {
            assert_eq!(objections(file, text), 1, "{file}: {text}");
        }
    }

    #[test]
    fn what_is_allowed_is_let_pass() {
        for (file, text) in [
            (
                "www/main.js",
                "import { a } from \"./state.js\"; import \"./figure/gear-figure.js\"; import { b } from './engine/pool.js';",
            ),
            (
                "www/figure/gear-figure.js",
                "/** @typedef {import(\"../state.js\").State} State */ import { slider } from \"../controls/slider.js\";",
            ),
            (
                "www/figure/axes.js",
                "// import \"../engine/client.js\"\nexport const imported = \"a // b\"; export { imported as from };",
            ),
            ("www/figure/axes.js", "export function draw() { return state.import(x); }"),
            (
                "www/engine/worker.js",
                "import { load } from \"../../gear-bifurcations.js\"; new URL(\"./worker.js\", import.meta.url); WebAssembly;",
            ),
            (
                "www/engine/gear-bifurcations.js",
                "import { createBindings } from \"./bindings.js\"; await import(\"node:fs/promises\"); await import(/* x */ name);",
            ),
        ] {
            assert_eq!(
                objections(file, text),
                0,
                "{file}: {text}: {:?}",
                violations(&[(file.to_owned(), text.to_owned())])
            );
        }
    }

    #[test]
    fn scripts_of_a_document_are_found() {
        let document = "<script type=\"module\" src=\"./www/main.js\"></script><script>alert(1)</script>";
        assert_eq!(module_scripts(document), ["./www/main.js", "inline"]);
    }
}
