//! Joins the page's modules into few files: one request instead of thirty, each of which costs a browser milliseconds
//! before the first picture.
//!
//! Each module becomes a function that is called once, in the order of the imports, and returns what it exports. So
//! names cannot clash and nothing is rewritten but the lines of import and export. What these functions cannot
//! express (a live binding, a default export, a circle of imports) is refused, not guessed at.
//!
//! A file that is fetched later, such as the laboratory's, takes the modules that its host holds already from there, so
//! that there is one of each: what a module remembers must not be remembered twice.

use crate::Failure;
use std::collections::BTreeMap;
use std::fmt::Write as _;

/// The page's modules: their texts by path, as `www/figure/table.js`.
pub type Modules = BTreeMap<String, String>;

/// A joined file.
pub struct Linked {
    pub text: String,
    /// The modules in it, by their paths.
    pub holds: Vec<String>,
}

/// A file that is there before another one is fetched, and the modules that it offers to it.
#[derive(Clone, Copy)]
pub struct Host<'a> {
    /// Its entry, which is its path too.
    pub entry: &'a str,
    pub holds: &'a [String],
}

/// Joins `entry` and all that it imports. What is in `apart`, or is none of `modules`, stays a file of its own, which the
/// joined file imports; what the `host` holds is taken from it.
pub fn link(
    modules: &Modules,
    entry: &str,
    apart: &[&str],
    host: Option<Host<'_>>,
) -> Result<Linked, Failure> {
    let mut linker = Linker {
        modules,
        entry,
        apart,
        host,
        joined: String::new(),
        names: Vec::new(),
        outside: Vec::new(),
        taken: Vec::new(),
    };
    let exports = linker.add(entry, &mut Vec::new())?;
    let mut text = String::new();
    for (address, name) in &linker.outside {
        let _ = writeln!(text, "import * as {name} from \"{address}\";");
    }
    if let Some(host) = host.filter(|_| !linker.taken.is_empty()) {
        let address = relative(entry, host.entry);
        let _ = writeln!(text, "import {{ {} }} from \"{address}\";", linker.taken.join(", "));
    }
    text.push_str(&linker.joined);
    if !exports.is_empty() {
        let _ = writeln!(text, "export const {{ {} }} = {};", exports.join(", "), variable(entry));
    }
    Ok(Linked { text, holds: linker.names })
}

impl Linked {
    /// Lets files that are fetched later take its modules.
    pub fn offer(&mut self) {
        let names: Vec<_> = self.holds.iter().map(|path| variable(path)).collect();
        let _ = writeln!(self.text, "export {{ {} }};", names.join(", "));
    }
}

struct Linker<'a> {
    modules: &'a Modules,
    entry: &'a str,
    apart: &'a [&'a str],
    host: Option<Host<'a>>,
    joined: String,
    /// Modules that are joined already.
    names: Vec<String>,
    /// Files that stay apart: their address as seen from the entry, and the variable that holds what they export.
    outside: Vec<(String, String)>,
    /// The variables of the host's modules that are taken from it.
    taken: Vec<String>,
}

impl Linker<'_> {
    /// Joins a module after those it imports; the names that it exports.
    fn add(&mut self, path: &str, importers: &mut Vec<String>) -> Result<Vec<String>, Failure> {
        let failed = |reason: String| Failure::invalid(path, reason);
        let text = self.modules.get(path).ok_or_else(|| failed("there is no such module".into()))?;
        importers.push(path.to_owned());
        let (mut body, mut exports) = (String::new(), Vec::new());
        for statement in statements(text) {
            if let Some(rest) = starts_import(&statement) {
                let (clause, address) =
                    parts(rest).ok_or_else(|| failed(format!("cannot read `{statement}`")))?;
                let target =
                    resolve(path, &address).ok_or_else(|| failed(format!("\"{address}\" leads nowhere")))?;
                let from = self.need(&target, importers)?;
                if let Some(clause) = clause {
                    let names = names(&clause).ok_or_else(|| failed(format!("cannot read `{statement}`")))?;
                    let taken: Vec<_> = names.iter().map(|(name, local)| pair(name, local)).collect();
                    let _ = writeln!(body, "const {{ {} }} = {from};", taken.join(", "));
                }
            } else if let Some(rest) = statement.strip_prefix("export ") {
                if rest.starts_with('{') {
                    let list = rest.trim_end().trim_end_matches(';');
                    let names = names(list).ok_or_else(|| failed(format!("cannot read `{statement}`")))?;
                    exports.extend(names.into_iter().map(|(name, exported)| (exported, name)));
                } else {
                    let name =
                        declared_name(rest).ok_or_else(|| failed(format!("cannot export `{statement}`")))?;
                    exports.push((name.to_owned(), name.to_owned()));
                    body.push_str(rest);
                    body.push('\n');
                }
            } else {
                body.push_str(&statement);
                body.push('\n');
            }
        }
        importers.pop();
        let returned: Vec<_> = exports.iter().map(|(exported, name)| pair(exported, name)).collect();
        let name = variable(path);
        let _ = writeln!(
            self.joined,
            "// {path}\nconst {name} = (() => {{\n{body}return {{ {} }};\n}})();",
            returned.join(", ")
        );
        self.names.push(path.to_owned());
        Ok(exports.into_iter().map(|(exported, _)| exported).collect())
    }

    /// The variable that holds what a module exports; joins the module first where need be.
    fn need(&mut self, target: &str, importers: &mut Vec<String>) -> Result<String, Failure> {
        let held = |host: Host<'_>| host.holds.iter().any(|name| name == target);
        if self.host.is_some_and(held) {
            let name = variable(target);
            if !self.taken.contains(&name) {
                self.taken.push(name);
            }
        } else if self.apart.contains(&target) || !self.modules.contains_key(target) {
            let address = relative(self.entry, target);
            if !self.outside.iter().any(|(known, _)| *known == address) {
                self.outside.push((address, variable(target)));
            }
        } else if importers.iter().any(|importer| importer == target) {
            return Err(Failure::invalid(
                target,
                format!("it is imported in a circle: {}", importers.join(", ")),
            ));
        } else if !self.names.iter().any(|name| name == target) {
            self.add(target, importers)?;
        }
        Ok(variable(target))
    }
}

/// The lines of a module, those of an import or of a list of exports made one.
fn statements(text: &str) -> Vec<String> {
    let mut found: Vec<String> = Vec::new();
    let mut open = false;
    for line in text.lines() {
        if open {
            if let Some(last) = found.last_mut() {
                last.push(' ');
                last.push_str(line.trim());
            }
        } else {
            found.push(line.to_owned());
        }
        let starts = starts_import(line).is_some() || line.starts_with("export {");
        open = (open || starts) && !line.trim_end().ends_with(';');
    }
    found
}

/// What follows the word `import` of a static import.
fn starts_import(line: &str) -> Option<&str> {
    line.strip_prefix("import").filter(|rest| rest.starts_with([' ', '{', '*', '"', '\'']))
}

/// The list of names, if any, and the address of an import.
fn parts(rest: &str) -> Option<(Option<String>, String)> {
    let rest = rest.trim().strip_suffix(';')?;
    let (clause, quoted) = match rest.split_once(" from ") {
        Some((clause, quoted)) => (Some(clause.trim().to_owned()), quoted.trim()),
        None => (None, rest),
    };
    let address = quoted.strip_prefix('"')?.strip_suffix('"')?;
    Some((clause, address.to_owned()))
}

/// The names in `{ a, b as c }`: what each is called on the left of `as`, and on its right.
fn names(list: &str) -> Option<Vec<(String, String)>> {
    let inner = list.trim().strip_prefix('{')?.strip_suffix('}')?;
    let names = inner.split(',').map(str::trim).filter(|name| !name.is_empty());
    names
        .map(|name| {
            let (left, right) = name.split_once(" as ").unwrap_or((name, name));
            (is_name(left) && is_name(right)).then(|| (left.to_owned(), right.to_owned()))
        })
        .collect()
}

fn is_name(name: &str) -> bool {
    !name.is_empty() && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_' || c == '$')
}

fn pair(key: &str, value: &str) -> String {
    if key == value { key.to_owned() } else { format!("{key}: {value}") }
}

/// The name that an exported declaration declares; none for what cannot be returned once and for all.
fn declared_name(declaration: &str) -> Option<&str> {
    let kinds = ["async function ", "function ", "class ", "const "];
    let rest = kinds.iter().find_map(|kind| declaration.strip_prefix(kind))?;
    let end = rest.find(|c: char| !(c.is_ascii_alphanumeric() || c == '_' || c == '$'))?;
    (end > 0).then(|| &rest[..end])
}

/// The variable of a module: its path with a sign that no name of ours begins with.
fn variable(path: &str) -> String {
    let plain: String = path.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '_' }).collect();
    format!("${plain}")
}

/// The path that a relative address leads to.
fn resolve(from: &str, address: &str) -> Option<String> {
    let mut folders: Vec<&str> = from.split('/').collect();
    folders.pop();
    for step in address.split('/') {
        match step {
            "." => {}
            ".." => {
                folders.pop()?;
            }
            name => folders.push(name),
        }
    }
    address.starts_with('.').then(|| folders.join("/"))
}

/// The relative address of a file as seen from another.
fn relative(from: &str, to: &str) -> String {
    let from: Vec<&str> = from.split('/').collect();
    let to: Vec<&str> = to.split('/').collect();
    let shared = from.iter().zip(&to).take_while(|(one, other)| one == other).count().min(from.len() - 1);
    let up = from.len() - 1 - shared;
    let start = if up == 0 { "./".to_owned() } else { "../".repeat(up) };
    format!("{start}{}", to[shared..].join("/"))
}

#[cfg(test)]
mod tests {
    use super::{Host, Modules, link, relative, resolve};

    fn modules(texts: &[(&str, &str)]) -> Modules {
        texts.iter().map(|(path, text)| ((*path).to_owned(), (*text).to_owned())).collect()
    }

    #[test]
    fn modules_are_joined_in_the_order_of_their_imports_each_once() {
        let joined = link(
            &modules(&[
                ("www/main.js", "import { one } from \"./a/one.js\";\nimport {\n  two as second,\n  three,\n} from \"./a/two.js\";\none(second, three);\n"),
                ("www/a/one.js", "import { two } from \"./two.js\";\nexport function one() {\n  return two;\n}\n"),
                ("www/a/two.js", "const hidden = 2;\nexport const two = hidden;\nexport { hidden as three };\n"),
            ]),
            "www/main.js",
            &[],
            None,
        )
        .unwrap()
        .text;
        let place = |text: &str| joined.find(text).unwrap_or_else(|| panic!("`{text}` is not in\n{joined}"));
        assert!(place("// www/a/two.js") < place("// www/a/one.js"));
        assert!(place("// www/a/one.js") < place("// www/main.js"));
        place("return { two, three: hidden };");
        place("const { two: second, three } = $www_a_two_js;");
        place("function one() {");
        assert_eq!(joined.matches("const hidden").count(), 1);
        assert!(!joined.contains("import ") && !joined.contains("export "));
    }

    #[test]
    fn what_stays_apart_is_imported_from_where_the_joined_file_lies() {
        let joined = link(
            &modules(&[
                ("www/engine/running.js", "import { load } from \"../../gear.js\";\nimport { x } from \"./x.js\";\nexport const engine = load(x);\n"),
                ("www/engine/x.js", "export const x = 1;\n"),
            ]),
            "www/engine/running.js",
            &["www/engine/x.js"],
            None,
        )
        .unwrap()
        .text;
        assert!(joined.starts_with(
            "import * as $gear_js from \"../../gear.js\";\nimport * as $www_engine_x_js from \"./x.js\";\n"
        ));
        assert!(joined.ends_with("export const { engine } = $www_engine_running_js;\n"));
    }

    #[test]
    fn what_is_fetched_later_takes_from_its_host_what_is_there() {
        let modules = modules(&[
            ("www/main.js", "import { say } from \"./words/say.js\";\nsay(1);\n"),
            ("www/words/say.js", "export const say = (word) => word;\n"),
            (
                "www/lab/lab.js",
                "import { say } from \"../words/say.js\";\nimport { own } from \"./own.js\";\nexport const start = () => say(own);\n",
            ),
            ("www/lab/own.js", "import { say } from \"../words/say.js\";\nexport const own = say(2);\n"),
        ]);
        let mut main = link(&modules, "www/main.js", &[], None).unwrap();
        let host = Host { entry: "www/main.js", holds: &main.holds };
        let lab = link(&modules, "www/lab/lab.js", &[], Some(host)).unwrap();
        assert!(lab.text.starts_with("import { $www_words_say_js } from \"../main.js\";\n"), "{}", lab.text);
        assert!(!lab.text.contains("// www/words/say.js") && lab.text.contains("// www/lab/own.js"));
        main.offer();
        assert!(main.text.ends_with("export { $www_words_say_js, $www_main_js };\n"), "{}", main.text);
    }

    #[test]
    fn what_cannot_be_joined_is_refused() {
        for text in [
            "export let count = 0;\n",
            "export default 3;\n",
            "import all from \"./b.js\";\n",
            "import { main } from \"./main.js\";\nexport const b = 1;\n",
            "import { b } from \"b\";\n",
        ] {
            let refused = link(
                &modules(&[("www/main.js", text), ("www/b.js", "export const b = 1;\n")]),
                "www/main.js",
                &[],
                None,
            );
            assert!(refused.is_err(), "{text}");
        }
    }

    #[test]
    fn addresses_lead_there_and_back() {
        for (from, to, address) in [
            ("www/main.js", "www/figure/bar.js", "./figure/bar.js"),
            ("www/engine/running.js", "gear.js", "../../gear.js"),
            ("www/figure/a.js", "www/controls/b.js", "../controls/b.js"),
        ] {
            assert_eq!(relative(from, to), address);
            assert_eq!(resolve(from, address).as_deref(), Some(to));
        }
    }
}
