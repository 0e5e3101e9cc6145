//! The page's modules, read: what each imports, at once or later, and what it exports.

use super::script::{self, Stretch};
use crate::Failure;
use std::collections::BTreeMap;
use std::fmt::Write as _;

/// The page's modules: their texts by path, as `www/figure/table.js`.
pub type Modules = BTreeMap<String, String>;

/// A module, read.
#[derive(Debug, Default)]
pub struct Module {
    /// The paths of the modules it imports, with the names it takes: theirs, and what it calls them.
    pub imports: Vec<(String, Vec<(String, String)>)>,
    /// The names it exports: as others see them, and as it calls them.
    pub exports: Vec<(String, String)>,
    /// Everything else.
    pub body: Vec<Piece>,
}

/// A piece of a module's body.
#[derive(Debug, PartialEq)]
pub enum Piece {
    /// Code as it stands.
    Code(String),
    /// `import("./there.js")`: the path of the module that is wanted later.
    Later(String),
    /// `import.meta.url`: the module's own address.
    Here,
}

impl Module {
    /// Reads a module. What a function that is called once cannot express (a live binding, a default export) is refused.
    pub fn read(path: &str, text: &str) -> Result<Self, Failure> {
        let failed = |reason: String| Failure::invalid(path, reason);
        let target = |address: &str| {
            resolve(path, address).ok_or_else(|| failed(format!("\"{address}\" leads nowhere")))
        };
        let mut module = Self::default();
        let mut body = String::new();
        for statement in statements(&script::bare(text)) {
            if let Some(rest) = starts_import(&statement) {
                let (clause, address) =
                    parts(rest).ok_or_else(|| failed(format!("cannot read `{statement}`")))?;
                let taken = match clause {
                    Some(clause) => {
                        names(&clause).ok_or_else(|| failed(format!("cannot read `{statement}`")))?
                    }
                    None => Vec::new(),
                };
                module.imports.push((target(&address)?, taken));
                continue;
            }
            let Some(rest) = statement.strip_prefix("export ") else {
                let _ = writeln!(body, "{statement}");
                continue;
            };
            if rest.starts_with('{') {
                let list = rest.trim_end().trim_end_matches(';');
                let listed = names(list).ok_or_else(|| failed(format!("cannot read `{statement}`")))?;
                module.exports.extend(listed.into_iter().map(|(name, exported)| (exported, name)));
            } else {
                let name =
                    declared_name(rest).ok_or_else(|| failed(format!("cannot export `{statement}`")))?;
                module.exports.push((name.to_owned(), name.to_owned()));
                let _ = writeln!(body, "{rest}");
            }
        }
        module.body = pieces(&body, &target)?;
        Ok(module)
    }

    /// The paths of the modules it wants later.
    pub fn later(&self) -> impl Iterator<Item = &str> {
        self.body.iter().filter_map(|piece| match piece {
            Piece::Later(target) => Some(target.as_str()),
            _ => None,
        })
    }
}

/// The variable of a module: its path with a sign that no name of ours begins with.
pub fn variable(path: &str) -> String {
    let plain: String = path.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '_' }).collect();
    format!("${plain}")
}

/// `key: value` of an object or of what is taken from one.
pub fn pair(key: &str, value: &str) -> String {
    if key == value { key.to_owned() } else { format!("{key}: {value}") }
}

/// Parts the body at its dynamic imports and at its own address.
fn pieces(body: &str, target: &impl Fn(&str) -> Result<String, Failure>) -> Result<Vec<Piece>, Failure> {
    const LATER: &str = "import(";
    const HERE: &str = "import.meta.url";
    let mut found = Vec::new();
    let mut code = String::new();
    for stretch in script::stretches(body) {
        match stretch {
            Stretch::Literal(literal) => {
                let asked = literal.strip_prefix('"').and_then(|rest| rest.strip_suffix('"'));
                match (code.strip_suffix(LATER), asked) {
                    (Some(before), Some(address)) => {
                        found.push(Piece::Code(before.to_owned()));
                        found.push(Piece::Later(target(address)?));
                        code = String::new();
                    }
                    _ => code.push_str(literal),
                }
            }
            Stretch::Comment(comment) => code.push_str(comment),
            Stretch::Code(plain) => {
                // The bracket of a dynamic import goes with it.
                let closes = code.is_empty() && matches!(found.last(), Some(Piece::Later(_)));
                let plain = if closes { plain.strip_prefix(')').unwrap_or(plain) } else { plain };
                let mut parts = plain.split(HERE);
                code.push_str(parts.next().unwrap_or_default());
                for part in parts {
                    found.push(Piece::Code(std::mem::take(&mut code)));
                    found.push(Piece::Here);
                    code.push_str(part);
                }
            }
        }
    }
    found.push(Piece::Code(code));
    Ok(found)
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

/// The name that an exported declaration declares; none for what cannot be returned once and for all.
fn declared_name(declaration: &str) -> Option<&str> {
    let kinds = ["async function ", "function ", "class ", "const "];
    let rest = kinds.iter().find_map(|kind| declaration.strip_prefix(kind))?;
    let end = rest.find(|c: char| !(c.is_ascii_alphanumeric() || c == '_' || c == '$'))?;
    (end > 0).then(|| &rest[..end])
}

/// The path that a relative address leads to.
pub fn resolve(from: &str, address: &str) -> Option<String> {
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
pub fn relative(from: &str, to: &str) -> String {
    let from: Vec<&str> = from.split('/').collect();
    let to: Vec<&str> = to.split('/').collect();
    let shared = from.iter().zip(&to).take_while(|(one, other)| one == other).count().min(from.len() - 1);
    let up = from.len() - 1 - shared;
    let start = if up == 0 { "./".to_owned() } else { "../".repeat(up) };
    format!("{start}{}", to[shared..].join("/"))
}

#[cfg(test)]
mod tests {
    use super::{Module, Piece, relative, resolve};

    fn pairs(names: &[(&str, &str)]) -> Vec<(String, String)> {
        names.iter().map(|(one, other)| ((*one).to_owned(), (*other).to_owned())).collect()
    }

    #[test]
    fn a_module_is_read() {
        let module = Module::read(
            "www/a/one.js",
            "/** Never `import(\"./no.js\")`. */\nimport { x } from \"../x.js\";\nimport {\n  two as second, // why\n  three,\n} from \"./two.js\";\nimport \"./alone.js\";\nexport const one = x;\nexport { second as other };\n  export_this();\n",
        )
        .unwrap();
        assert_eq!(
            module.imports,
            [
                ("www/x.js".to_owned(), pairs(&[("x", "x")])),
                ("www/a/two.js".to_owned(), pairs(&[("two", "second"), ("three", "three")])),
                ("www/a/alone.js".to_owned(), vec![]),
            ]
        );
        assert_eq!(module.exports, pairs(&[("one", "one"), ("other", "second")]));
        assert_eq!(module.body, [Piece::Code("const one = x;\nexport_this();\n".to_owned())]);
    }

    #[test]
    fn what_is_wanted_later_and_its_own_address_are_found() {
        let text = "const room = () => import(\"./lab/room.js\").then(open);\nconst at = new URL(\"./w.js\", import.meta.url);\nconst s = 'import(\"./not.js\")';\nimport(name);\n";
        let module = Module::read("www/main.js", text).unwrap();
        assert_eq!(module.later().collect::<Vec<_>>(), ["www/lab/room.js"]);
        assert_eq!(
            module.body,
            [
                Piece::Code("const room = () => ".to_owned()),
                Piece::Later("www/lab/room.js".to_owned()),
                Piece::Code(".then(open);\nconst at = new URL(\"./w.js\", ".to_owned()),
                Piece::Here,
                Piece::Code(");\nconst s = 'import(\"./not.js\")';\nimport(name);\n".to_owned()),
            ]
        );
    }

    #[test]
    fn what_cannot_be_joined_is_refused() {
        for text in [
            "export let count = 0;\n",
            "export default 3;\n",
            "import all from \"./b.js\";\n",
            "import { b } from \"b\";\n",
            "import(\"b\");\n",
        ] {
            assert!(Module::read("www/main.js", text).is_err(), "{text}");
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
