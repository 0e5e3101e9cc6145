//! The static folder: what is in it, and how it is brought up to date.

use super::bindings::Generated;
use super::document::rewrite;
use super::modules::Modules;
use super::single::{self, Single, WORKER};
use super::stamp::Stamp;
use super::{equations, link, module, package, release, script};
use crate::{Failure, place};
use std::collections::BTreeMap;
use std::path::Path;

/// A file that every `dist/` of ours holds, and by which we know that a folder is ours to tidy.
pub const MODULE: &str = "gear-bifurcations.js";

/// Files of `www/` that are sources of others or serve only the type checker.
const NOT_SERVED: [&str; 7] = [
    "engine/gear-bifurcations.js",
    "engine/bindings.js",
    FIGURE_SHELL,
    FRAME.0,
    HOST.0,
    KEEPER.0,
    MANIFEST.0,
];

/// The page in one file.
pub const SINGLE: &str = "gear-bifurcations.html";

/// Below `www/`: what keeps the page for offline use, and what makes it installable. Both must lie beside the page, whose
/// folder is all that they may speak for.
const KEEPER: (&str, &str) = ("offline/service-worker.js", "service-worker.js");
const MANIFEST: (&str, &str) = ("offline/manifest.webmanifest", "manifest.webmanifest");

/// Below `www/`: what the file of a single figure is made from.
const FIGURE_SHELL: &str = "embed/figure.html";

pub const VERSION: &str = env!("CARGO_PKG_VERSION");

/// Modules that something is started with, in lists of those that live in one page or worker together. Each is served
/// joined with all that it imports.
const ENTRIES: [&[&str]; 4] = [
    &["www/engine/running.js", "www/main.js"],
    &["www/engine/worker.js"],
    &[ELEMENT],
    &["www/embed/frame.js"],
];

/// The script that brings the figure's element to any page. It lies beside the module, and is made of one line.
const ELEMENT: &str = "gear-figure.js";
const ELEMENT_SOURCE: &str = "import \"./www/embed/element.js\";\n";

/// Below `www/`: the document that shows a figure in a frame, and where it is served; and the script of ten lines for pages
/// that hold such frames.
const FRAME: (&str, &str) = ("embed/frame.html", "embed.html");
const HOST: (&str, &str) = ("embed/gear-host.js", "gear-host.js");

/// The files of the static folder, by their path in it.
#[derive(Default)]
pub struct Site(BTreeMap<String, Vec<u8>>);

/// A site, and what is to be said of it.
pub struct Gathered {
    pub site: Site,
    /// How many drawings found no room in the single file.
    pub left_out: usize,
}

/// The file of a figure.
pub fn figure_file(id: &str) -> String {
    format!("gear-bifurcations-{id}.html")
}

/// Brings together everything that is served, with a file for each of these figures.
pub fn gather(root: &Path, generated: &Generated, figures: &[&str]) -> Result<Gathered, Failure> {
    let mut site = Site::default();
    let www = root.join("www");
    let handwritten = www.join("engine/gear-bifurcations.js");
    let handwritten = std::fs::read_to_string(&handwritten).map_err(Failure::file(&handwritten))?;
    let module = module::splice(&handwritten, &generated.glue)?;
    site.add(MODULE, script::compiled_at_once(&script::bare(&module)));
    site.add("gear-bifurcations_bg.wasm", generated.wasm.clone());
    site.add("package.json", package::of_folder());
    site.copy(&www.join("engine/gear-bifurcations.d.ts"), "gear-bifurcations.d.ts")?;
    package::add(&mut site, root, &module)?;
    let stamp = Stamp::read(&generated.wasm)?;
    let document = |path: &Path| std::fs::read_to_string(path).map_err(Failure::file(path));
    let index = without_indents(&stamp.put_into(&document(&root.join("index.html"))?));
    let figure = stamp.put_into(&document(&www.join(FIGURE_SHELL))?);
    site.add(equations::PAGE, equations::page(root)?);
    let mut modules = Modules::new();
    for name in place::files_below(&www)? {
        let (from, path) = (www.join(&name), format!("www/{name}"));
        if NOT_SERVED.contains(&name.as_str()) || name.ends_with(".d.ts") {
            continue;
        }
        match Path::new(&name).extension().and_then(|ending| ending.to_str()) {
            Some("js") => {
                modules.insert(path, stamp.put_into(&document(&from)?));
            }
            Some("css") => site.add(&path, single::bare_style(&document(&from)?)),
            _ => site.copy(&from, &path)?,
        }
    }
    site.add("index.html", with_plain_scripts(&index, &modules)?);
    // Each figure as a drawing, for readers without scripts and until the live one is there. A test proves that they
    // are what the library draws today, so that the build need not compile it twice.
    let drawings = root.join("tests/goldens");
    for name in place::files_below(&drawings)? {
        site.copy(&drawings.join(&name), &format!("figures/{name}"))?;
    }
    let frame = www.join(FRAME.0);
    let frame = std::fs::read_to_string(&frame).map_err(Failure::file(&frame))?;
    site.add(FRAME.1, frame.replace("{{stills}}", &site.stills()?));
    site.copy(&www.join(HOST.0), HOST.1)?;
    site.copy(&www.join(MANIFEST.0), MANIFEST.1)?;
    modules.insert(ELEMENT.to_owned(), ELEMENT_SOURCE.to_owned());
    for entries in ENTRIES {
        for (path, text) in link::files(&modules, entries)? {
            let text = script::dense(&text);
            // Nothing waits for a worker's thread but the worker.
            site.add(&path, if path == WORKER { text } else { script::compiled_at_once(&text) });
        }
    }
    // They lead to files of the site two folders up, so they run where they lie.
    let examples = root.join("docs/examples");
    for name in place::files_below(&examples)? {
        site.copy(&examples.join(&name), &format!("docs/examples/{name}"))?;
    }
    let keeper = www.join(KEEPER.0);
    let keeper = std::fs::read_to_string(&keeper).map_err(Failure::file(&keeper))?;
    site.add(KEEPER.1, release::service_worker(&keeper, &site)?);
    modules.insert(MODULE.to_owned(), site.text(MODULE)?.to_owned());
    let single = Single::gather(&site, &index, &figure, &modules)?;
    let (page, left_out) = single.page()?;
    let template = single.template();
    let shown = figures.iter().map(|id| Ok((figure_file(id), single.figure(id)?)));
    let shown = shown.collect::<Result<Vec<_>, Failure>>()?;
    site.add(SINGLE, page);
    site.add("figure.html", template);
    for (name, file) in shown {
        site.add(&name, file);
    }
    Ok(Gathered { site, left_out })
}

/// A document without the spaces that begin its lines, which show its structure to those who write it and nobody else; what
/// is preformatted keeps its own.
fn without_indents(document: &str) -> String {
    let mut preformatted = false;
    let lines = document.lines().flat_map(|line| {
        let kept = if preformatted { line } else { line.trim_start() };
        preformatted = (preformatted || line.contains("<pre")) && !line.contains("</pre>");
        [kept, "\n"]
    });
    lines.collect()
}

/// The document with its plain scripts inside: they run while it is still being read, and wait for no request. Modules stay
/// files.
fn with_plain_scripts(document: &str, modules: &Modules) -> Result<String, Failure> {
    rewrite(document, |tag| {
        let Some(address) = tag.value("src").filter(|_| tag.name == "script" && tag.value("type").is_none())
        else {
            return Ok(None);
        };
        let text =
            modules.get(address).ok_or_else(|| Failure::invalid(address, "there is no such script"))?;
        Ok(Some(format!("{}\n{}", tag.with("src", None), script::dense(text))))
    })
}

impl Site {
    /// Adds a file with this content.
    pub fn add(&mut self, name: &str, content: impl Into<Vec<u8>>) {
        self.0.insert(name.to_owned(), content.into());
    }

    /// The still drawings as elements, each under the address that names its figure and nothing else.
    fn stills(&self) -> Result<String, Failure> {
        let drawings = self.0.keys().filter_map(|name| name.strip_prefix("figures/")?.strip_suffix(".svg"));
        let element = |id: &str| {
            let drawing = self.text(&format!("figures/{id}.svg"))?;
            let (words, size) = (single::words_of(drawing), single::size_of(drawing));
            Ok(format!(
                "    <p class=\"still\" id=\"figure={id}\"><img src=\"figures/{id}.svg\" width=\"{}\" height=\"{}\" loading=\"lazy\" alt=\"{}\"></p>",
                size.0, size.1, words.1
            ))
        };
        Ok(drawings.map(element).collect::<Result<Vec<_>, Failure>>()?.join("\n"))
    }

    /// All files, by their paths.
    pub fn files(&self) -> impl Iterator<Item = (&str, &[u8])> {
        self.0.iter().map(|(name, content)| (name.as_str(), content.as_slice()))
    }

    /// A file's bytes.
    pub fn bytes(&self, name: &str) -> Result<&[u8], Failure> {
        self.0.get(name).map(Vec::as_slice).ok_or_else(|| Failure::invalid(name, "the site has no such file"))
    }

    /// A file's text.
    pub fn text(&self, name: &str) -> Result<&str, Failure> {
        std::str::from_utf8(self.bytes(name)?).map_err(|error| Failure::invalid(name, error.to_string()))
    }

    /// Adds a file as it is.
    pub fn copy(&mut self, from: &Path, name: &str) -> Result<(), Failure> {
        self.add(name, std::fs::read(from).map_err(Failure::file(from))?);
        Ok(())
    }

    /// Makes `out` hold these files and no others. What is the same already is not written again.
    pub fn write(&self, out: &Path) -> Result<(), Failure> {
        let present = place::files_below(out)?;
        if !present.is_empty() && !out.join(MODULE).is_file() {
            let reason = format!(
                "it holds files but no {MODULE}; choose an empty folder, so that nothing of yours is lost"
            );
            return Err(Failure::invalid(out.display().to_string(), reason));
        }
        for stale in present.iter().filter(|name| !self.0.contains_key(*name)) {
            let path = out.join(stale);
            std::fs::remove_file(&path).map_err(Failure::file(&path))?;
        }
        for (name, content) in &self.0 {
            let path = out.join(name);
            if std::fs::read(&path).is_ok_and(|old| old == *content) {
                continue;
            }
            if let Some(folder) = path.parent() {
                std::fs::create_dir_all(folder).map_err(Failure::file(folder))?;
            }
            std::fs::write(&path, content).map_err(Failure::file(&path))?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::{MODULE, Site, with_plain_scripts, without_indents};
    use crate::build::modules::Modules;

    fn folder(name: &str) -> std::path::PathBuf {
        let folder = std::env::temp_dir().join(format!("gear-site-{}-{name}", std::process::id()));
        let _ = std::fs::remove_dir_all(&folder);
        folder
    }

    #[test]
    fn only_what_is_preformatted_keeps_its_indents() {
        let text = "<p>\n  a\n    b</p>\n  <pre>c\n  d\n  e</pre>\n  <p>f</p>\n";
        assert_eq!(without_indents(text), "<p>\na\nb</p>\n<pre>c\n  d\n  e</pre>\n<p>f</p>\n");
    }

    #[test]
    fn the_folder_holds_the_files_and_no_stale_ones() {
        let out = folder("stale");
        let mut site = Site::default();
        site.add(MODULE, "one");
        site.add("www/old.js", "old");
        site.write(&out).unwrap();
        let mut site = Site::default();
        site.add(MODULE, "two");
        site.add("www/style/new.css", "new");
        site.write(&out).unwrap();
        assert_eq!(crate::place::files_below(&out).unwrap(), [MODULE, "www/style/new.css"]);
        assert_eq!(std::fs::read(out.join(MODULE)).unwrap(), b"two");
        std::fs::remove_dir_all(out).unwrap();
    }

    #[test]
    fn plain_scripts_stand_in_the_document_and_modules_do_not() {
        let scripts = Modules::from([("a.js".to_owned(), "// why\nlet a = 1;\n".to_owned())]);
        let document =
            "<script src=\"a.js\" data-b=\"1\"></script><script type=\"module\" src=\"c.js\"></script>";
        assert_eq!(
            with_plain_scripts(document, &scripts).unwrap(),
            "<script data-b=\"1\">\nlet a=1;</script><script type=\"module\" src=\"c.js\"></script>"
        );
        assert!(with_plain_scripts("<script src=\"d.js\"></script>", &scripts).is_err());
    }

    #[test]
    fn a_folder_with_somebody_elses_files_is_left_alone() {
        let out = folder("foreign");
        std::fs::create_dir_all(&out).unwrap();
        std::fs::write(out.join("thesis.tex"), "years of work").unwrap();
        let mut site = Site::default();
        site.add(MODULE, "one");
        assert!(site.write(&out).is_err());
        assert_eq!(crate::place::files_below(&out).unwrap(), ["thesis.tex"]);
        std::fs::remove_dir_all(out).unwrap();
    }
}
