//! Joins the page's modules into few files: one request instead of thirty, each of which costs a browser milliseconds
//! before the first picture.
//!
//! Each module becomes a function that is called once and returns what it exports. So names cannot clash and nothing is
//! rewritten but the lines of import and export. What these functions cannot express (a live binding, a default export,
//! a circle of imports) is refused, not guessed at.
//!
//! On the site (`files`) a module is called in the order of the imports, and what is imported later is in files of
//! its own, each module in one file alone. In the single file (`scripts`) there is nothing to fetch: all modules stand in
//! plain scripts, and each is called when it is first asked for.

use super::modules::{Module, Modules, Piece, pair, relative, variable};
use crate::Failure;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;

/// Joins into files what `entries` import. They are all of one page, that is, of one set of modules that are alive
/// together; an entry leaves to those before it what they have. What is none of `modules` stays a file of its own.
pub fn files(modules: &Modules, entries: &[&str]) -> Result<BTreeMap<String, String>, Failure> {
    let read = read(modules, entries)?;
    let mut plan = Plan { read: &read, order: Vec::new(), file_of: BTreeMap::new() };
    for entry in entries {
        plan.assign(entry, entry, &mut Vec::new())?;
    }
    plan.assign_later(entries)?;
    let mut files: Vec<&String> = plan.file_of.values().collect();
    files.sort_unstable();
    files.dedup();
    Ok(files.into_iter().map(|file| (file.clone(), plan.text(file))).collect())
}

/// Which module stands in which file.
struct Plan<'a> {
    read: &'a BTreeMap<String, Module>,
    /// The modules, each after those it imports.
    order: Vec<String>,
    file_of: BTreeMap<String, String>,
}

impl Plan<'_> {
    /// Puts a module, and before it all that it imports, into a file, but for what is in one already.
    fn assign(&mut self, path: &str, file: &str, importers: &mut Vec<String>) -> Result<(), Failure> {
        if importers.iter().any(|importer| importer == path) {
            return Err(Failure::invalid(
                path,
                format!("it is imported in a circle: {}", importers.join(", ")),
            ));
        }
        let Some(module) = self.read.get(path) else { return Ok(()) };
        if self.file_of.contains_key(path) {
            return Ok(());
        }
        importers.push(path.to_owned());
        for (target, _) in &module.imports {
            self.assign(target, file, importers)?;
        }
        importers.pop();
        self.order.push(path.to_owned());
        self.file_of.insert(path.to_owned(), file.to_owned());
        Ok(())
    }

    /// Puts what is imported later into files: what one such import alone needs into its own, what several need into one for
    /// just these.
    fn assign_later(&mut self, entries: &[&str]) -> Result<(), Failure> {
        let mut wanted: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
        let later: BTreeSet<&str> = self.read.values().flat_map(Module::later).collect();
        for &root in later.iter().filter(|root| !entries.contains(root)) {
            for path in closure(self.read, root) {
                wanted.entry(path).or_default().insert(root.to_owned());
            }
        }
        let mut shared: BTreeMap<BTreeSet<String>, String> = BTreeMap::new();
        // In the order of their imports: a file that several share is then named after what is deepest in it.
        for &root in &later {
            for path in closure(self.read, root) {
                let Some(roots) = wanted.get(&path) else { continue };
                if self.file_of.contains_key(&path) {
                    continue;
                }
                let file = match roots.first() {
                    Some(only) if roots.len() == 1 => only.clone(),
                    _ => shared.entry(roots.clone()).or_insert_with(|| path.clone()).clone(),
                };
                self.assign(&path, &file, &mut Vec::new())?;
            }
        }
        Ok(())
    }

    /// A file's text.
    fn text(&self, file: &str) -> String {
        let mut outside: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
        let mut body = String::new();
        for path in self.order.iter().filter(|path| self.file_of[*path] == file) {
            let module = &self.read[path];
            for (target, _) in &module.imports {
                if self.file_of.get(target).is_none_or(|home| home != file) {
                    let home = self.file_of.get(target).unwrap_or(target);
                    outside.entry(relative(file, home)).or_default().insert(target.clone());
                }
            }
            let mut text = taken(module, variable);
            for piece in &module.body {
                match piece {
                    Piece::Code(code) => text.push_str(code),
                    // From the same folder every relative address leads to the same.
                    Piece::Here if folder(path) == folder(file) => text.push_str("import.meta.url"),
                    Piece::Here => {
                        let _ = write!(text, "new URL(\"{}\", import.meta.url).href", relative(file, path));
                    }
                    Piece::Later(target) => match self.file_of.get(target) {
                        Some(home) => {
                            let (home, name) = (relative(file, home), variable(target));
                            let _ = write!(text, "import(\"{home}\").then(({{ {name} }}) => {name})");
                        }
                        None => {
                            let _ = write!(text, "import(\"{}\")", relative(file, target));
                        }
                    },
                }
            }
            let _ = writeln!(body, "const {} = (() => {{\n{text}{}}})();", variable(path), returned(module));
        }
        let mut whole = String::new();
        for (address, targets) in outside {
            for target in targets {
                let name = variable(&target);
                let _ = if self.file_of.contains_key(&target) {
                    writeln!(whole, "import {{ {name} }} from \"{address}\";")
                } else {
                    writeln!(whole, "import * as {name} from \"{address}\";")
                };
            }
        }
        whole.push_str(&body);
        let asked: Vec<_> = self.asked_for(file).iter().map(|path| variable(path)).collect();
        if !asked.is_empty() {
            let _ = writeln!(whole, "export {{ {} }};", asked.join(", "));
        }
        let exports: Vec<_> = match self.read.get(file) {
            Some(module) => module.exports.iter().map(|(exported, _)| exported.as_str()).collect(),
            None => Vec::new(),
        };
        if !exports.is_empty() {
            let _ = writeln!(whole, "export const {{ {} }} = {};", exports.join(", "), variable(file));
        }
        whole
    }

    /// The modules in a file that modules in others ask for, at once or later.
    fn asked_for(&self, file: &str) -> BTreeSet<String> {
        let mut asked = BTreeSet::new();
        for (path, home) in &self.file_of {
            let module = &self.read[path];
            let now = module.imports.iter().map(|(target, _)| target.as_str()).filter(|_| home != file);
            for target in now.chain(module.later()) {
                if self.file_of.get(target).is_some_and(|home| home == file) {
                    asked.insert(target.to_owned());
                }
            }
        }
        asked
    }
}

/// Joins into plain scripts, one after the other, what each list of modules needs, at once or later; a script leaves to
/// those before it what they have. Nothing runs until it is asked for: see `start`.
pub fn scripts(modules: &Modules, lists: &[&[&str]]) -> Result<Vec<String>, Failure> {
    let mut known: BTreeSet<String> = BTreeSet::new();
    let mut scripts = Vec::new();
    for roots in lists {
        let read = read(modules, roots)?;
        // Refuses what goes round in a circle.
        let mut plan = Plan { read: &read, order: Vec::new(), file_of: BTreeMap::new() };
        for path in read.keys() {
            plan.assign(path, path, &mut Vec::new())?;
        }
        let mut script = String::new();
        if known.is_empty() {
            script.push_str("const $once = (make) => {\nlet made;\nreturn () => (made ??= make());\n};\n");
        }
        for path in &plan.order {
            if !known.insert(path.clone()) {
                continue;
            }
            let module = &read[path];
            if let Some((absent, _)) = module.imports.iter().find(|(target, _)| !read.contains_key(target)) {
                return Err(Failure::invalid(path, format!("it imports {absent}, which is no module")));
            }
            let mut text = taken(module, |target| format!("{}()", variable(target)));
            for piece in &module.body {
                match piece {
                    Piece::Code(code) => text.push_str(code),
                    Piece::Here => text.push_str("self.location.href"),
                    Piece::Later(target) => {
                        let _ = write!(text, "Promise.resolve().then({})", variable(target));
                    }
                }
            }
            let _ =
                writeln!(script, "const {} = $once(() => {{\n{text}{}}});", variable(path), returned(module));
        }
        scripts.push(script);
    }
    Ok(scripts)
}

/// The folder of a file.
fn folder(path: &str) -> &str {
    path.rsplit_once('/').map_or("", |(folder, _)| folder)
}

/// The line that starts a module of `scripts`.
pub fn start(path: &str) -> String {
    format!("{}();", variable(path))
}

/// All modules that some import, at once or later, and they themselves.
fn read(modules: &Modules, roots: &[&str]) -> Result<BTreeMap<String, Module>, Failure> {
    let mut read: BTreeMap<String, Module> = BTreeMap::new();
    let mut waiting: Vec<String> = roots.iter().map(|&root| root.to_owned()).collect();
    for root in roots {
        if !modules.contains_key(*root) {
            return Err(Failure::invalid(*root, "there is no such module"));
        }
    }
    while let Some(path) = waiting.pop() {
        let Some(text) = modules.get(&path) else { continue };
        if read.contains_key(&path) {
            continue;
        }
        let module = Module::read(&path, text)?;
        waiting.extend(module.imports.iter().map(|(target, _)| target.clone()));
        for target in module.later() {
            if !modules.contains_key(target) {
                return Err(Failure::invalid(
                    &path,
                    format!("it imports {target} later, which is no module"),
                ));
            }
            waiting.push(target.to_owned());
        }
        read.insert(path, module);
    }
    Ok(read)
}

/// A module and all that it imports at once, each after those it imports.
fn closure(read: &BTreeMap<String, Module>, root: &str) -> Vec<String> {
    fn visit(
        read: &BTreeMap<String, Module>,
        path: &str,
        seen: &mut BTreeSet<String>,
        found: &mut Vec<String>,
    ) {
        let Some(module) = read.get(path) else { return };
        if !seen.insert(path.to_owned()) {
            return;
        }
        for (target, _) in &module.imports {
            visit(read, target, seen, found);
        }
        found.push(path.to_owned());
    }
    let mut found = Vec::new();
    visit(read, root, &mut BTreeSet::new(), &mut found);
    found
}

/// The lines that take what a module imports; `whose` says how a module is had.
fn taken(module: &Module, whose: impl Fn(&str) -> String) -> String {
    let mut lines = String::new();
    for (target, names) in &module.imports {
        let names: Vec<_> = names.iter().map(|(name, local)| pair(name, local)).collect();
        let _ = if names.is_empty() {
            writeln!(lines, "{};", whose(target))
        } else {
            writeln!(lines, "const {{ {} }} = {};", names.join(", "), whose(target))
        };
    }
    lines
}

/// The line that returns what a module exports.
fn returned(module: &Module) -> String {
    let exports: Vec<_> = module.exports.iter().map(|(exported, name)| pair(exported, name)).collect();
    format!("return {{ {} }};\n", exports.join(", "))
}

#[cfg(test)]
mod tests {
    use super::{Modules, files, scripts, start};

    fn modules(texts: &[(&str, &str)]) -> Modules {
        texts.iter().map(|(path, text)| ((*path).to_owned(), (*text).to_owned())).collect()
    }

    fn place(text: &str, part: &str) -> usize {
        text.find(part).unwrap_or_else(|| panic!("`{part}` is not in\n{text}"))
    }

    #[test]
    fn modules_are_joined_in_the_order_of_their_imports_each_once() {
        let modules = modules(&[
            (
                "www/main.js",
                "import { one } from \"./a/one.js\";\nimport {\n  two as second,\n  three,\n} from \"./a/two.js\";\none(second, three);\n",
            ),
            (
                "www/a/one.js",
                "import { two } from \"./two.js\";\nexport function one() {\n  return two;\n}\n",
            ),
            ("www/a/two.js", "const hidden = 2;\nexport const two = hidden;\nexport { hidden as three };\n"),
        ]);
        let joined = &files(&modules, &["www/main.js"]).unwrap()["www/main.js"];
        assert!(place(joined, "const $www_a_two_js") < place(joined, "const $www_a_one_js"));
        assert!(place(joined, "const $www_a_one_js") < place(joined, "const $www_main_js"));
        place(joined, "return { two, three: hidden };");
        place(joined, "const { two: second, three } = $www_a_two_js;");
        place(joined, "function one() {");
        assert_eq!(joined.matches("const hidden").count(), 1);
        assert!(!joined.contains("import ") && !joined.contains("export "));
    }

    #[test]
    fn an_entry_leaves_to_those_before_it_what_they_have() {
        let joined = files(
            &modules(&[
                ("www/engine/running.js", "import { load } from \"../../gear.js\";\nimport { x } from \"./x.js\";\nexport const engine = load(x);\n"),
                ("www/engine/x.js", "export const x = new URL(\"./w.js\", import.meta.url);\n"),
                ("www/main.js", "import { engine } from \"./engine/running.js\";\nimport { x } from \"./engine/x.js\";\nimport { y } from \"./far/y.js\";\nengine(x, y);\n"),
                ("www/far/y.js", "export const y = new URL(\"./z\", import.meta.url);\n"),
            ]),
            &["www/engine/running.js", "www/main.js"],
        )
        .unwrap();
        let running = &joined["www/engine/running.js"];
        assert!(running.starts_with("import * as $gear_js from \"../../gear.js\";\nconst $www_engine_x_js"));
        place(running, "new URL(\"./w.js\", import.meta.url)");
        place(&joined["www/main.js"], "new URL(\"./z\", new URL(\"./far/y.js\", import.meta.url).href)");
        assert!(running.ends_with(
            "export { $www_engine_running_js, $www_engine_x_js };\nexport const { engine } = $www_engine_running_js;\n"
        ));
        assert!(joined["www/main.js"].starts_with(
            "import { $www_engine_running_js } from \"./engine/running.js\";\nimport { $www_engine_x_js } from \"./engine/running.js\";\n"
        ));
        assert_eq!(joined.len(), 2);
    }

    /// A page with two rooms that share something, and a house that all have.
    fn house() -> Modules {
        modules(&[
            (
                "www/main.js",
                "import { house } from \"./house.js\";\nhouse(() => import(\"./lab/room.js\"), () => import(\"./class/room.js\"));\n",
            ),
            ("www/house.js", "export const house = 1;\n"),
            ("www/shared.js", "import { house } from \"./house.js\";\nexport const shared = house;\n"),
            ("www/lab/room.js", "import { shared } from \"../shared.js\";\nexport const lab = shared;\n"),
            (
                "www/class/room.js",
                "import { shared } from \"../shared.js\";\nimport { own } from \"./own.js\";\nexport const room = shared + own;\n",
            ),
            ("www/class/own.js", "export const own = 1;\n"),
        ])
    }

    #[test]
    fn what_is_imported_later_is_in_files_of_its_own_and_no_module_is_in_two() {
        let joined = files(&house(), &["www/main.js"]).unwrap();
        let names: Vec<_> = joined.keys().map(String::as_str).collect();
        assert_eq!(names, ["www/class/room.js", "www/lab/room.js", "www/main.js", "www/shared.js"]);
        place(
            &joined["www/main.js"],
            "() => import(\"./lab/room.js\").then(({ $www_lab_room_js }) => $www_lab_room_js)",
        );
        place(&joined["www/main.js"], "export { $www_house_js };");
        assert!(joined["www/shared.js"].starts_with("import { $www_house_js } from \"./main.js\";"));
        assert!(joined["www/lab/room.js"].starts_with("import { $www_shared_js } from \"../shared.js\";"));
        place(&joined["www/class/room.js"], "const $www_class_own_js");
        for module in ["house", "shared", "lab_room", "class_room", "class_own"] {
            let declared = format!("const $www_{module}_js =");
            assert_eq!(
                joined.values().map(|text| text.matches(&declared).count()).sum::<usize>(),
                1,
                "{module}"
            );
        }
    }

    #[test]
    fn scripts_hold_everything_once_and_run_nothing() {
        let joined = scripts(&house(), &[&["www/shared.js"], &["www/main.js"]]).unwrap();
        assert_eq!(joined.len(), 2);
        assert!(joined[0].starts_with("const $once = "));
        place(&joined[0], "const $www_shared_js = $once(() => {\nconst { house } = $www_house_js();\n");
        place(&joined[1], "Promise.resolve().then($www_lab_room_js)");
        place(&joined[1], "const $www_class_own_js = $once");
        assert!(!joined[1].contains("const $www_house_js") && !joined[1].contains("$once = "));
        assert_eq!(start("www/main.js"), "$www_main_js();");
        assert!(joined.iter().all(|script| !script.contains("import") && !script.contains("export")));
    }

    #[test]
    fn circles_and_what_is_not_there_are_refused() {
        let circle = "import { main } from \"./main.js\";\nexport const b = 1;\n";
        for (main, other) in [
            ("import { b } from \"./b.js\";\nexport const main = 1;\n", circle),
            ("import(\"./absent.js\");\n", circle),
        ] {
            let modules = modules(&[("www/main.js", main), ("www/b.js", other)]);
            assert!(files(&modules, &["www/main.js"]).is_err(), "{main}");
            assert!(scripts(&modules, &[&["www/main.js"]]).is_err(), "{main}");
        }
        let absent = modules(&[("www/main.js", "import { x } from \"./x.js\";\n")]);
        assert!(scripts(&absent, &[&["www/main.js"]]).is_err());
        assert!(files(&absent, &["www/absent.js"]).is_err());
    }
}
