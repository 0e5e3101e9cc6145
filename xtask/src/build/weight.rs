//! What a first visit to the page loads, and what that weighs on its way.

use super::site::Site;
use crate::Failure;
use std::collections::BTreeMap;
use std::io::Write;

/// The files of a first visit, by their path, each with its weight in bytes as it travels: gzipped, but for faces,
/// which are compressed already.
pub type Weights = BTreeMap<String, usize>;

/// Follows what the document names: its links and scripts, also those that stand in it, what those import and start, what the styles fetch, and the
/// first static drawing, which stands where the page opens.
///
/// # Errors
/// A file that is named but does not exist.
pub fn first_visit(site: &Site) -> Result<Weights, Failure> {
    let mut weights = Weights::new();
    let mut waiting = vec!["index.html".to_owned()];
    while let Some(name) = waiting.pop() {
        if weights.contains_key(&name) {
            continue;
        }
        let content = site.bytes(&name)?;
        weights.insert(name.clone(), if is_face(&name) { content.len() } else { gzipped(content).len() });
        let text = String::from_utf8_lossy(content);
        let named = match name.rsplit_once('.').map_or("", |(_, ending)| ending) {
            "html" => of_document(&text),
            "js" => of_script(&text),
            "css" => between(&text, "url(\"", "\"").collect(),
            _ => Vec::new(),
        };
        waiting.extend(named.into_iter().map(|address| resolve(&name, address)));
    }
    Ok(weights)
}

/// Bytes as a web server would send them; the same always give the same.
pub fn gzipped(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::best());
    // Writing to memory cannot fail.
    let written = encoder.write_all(bytes).and_then(|()| encoder.finish());
    written.unwrap_or_default()
}

fn is_face(name: &str) -> bool {
    std::path::Path::new(name).extension().is_some_and(|ending| ending == "woff2")
}

fn of_document(text: &str) -> Vec<&str> {
    let links = between(text, "<link ", ">").filter_map(|tag| between(tag, "href=\"", "\"").next());
    let scripts = between(text, "<script ", ">").filter_map(|tag| between(tag, "src=\"", "\"").next());
    let drawings = between(text, "<img ", ">").filter_map(|tag| between(tag, "src=\"", "\"").next());
    let fetched = between(text, "fetch(\"", "\"").chain(between(text, "new Worker(\"", "\""));
    let all = links.chain(scripts).chain(drawings.take(1)).chain(fetched);
    all.filter(|address| !address.contains(':') && !address.starts_with('#')).collect()
}

/// Modules that are imported from the start, and files that the script finds beside itself.
fn of_script(text: &str) -> Vec<&str> {
    let imported = text.lines().filter(|line| line.starts_with("import "));
    let imported = imported.filter_map(|line| between(line, "from \"", "\"").next());
    // Where a joined module once lay is an address of nothing.
    let addresses = text.split("new URL(\"").skip(1).filter_map(|rest| rest.split_once('"'));
    let beside = addresses
        .filter(|(address, rest)| address.contains('.') && !rest.starts_with(", import.meta.url).href"));
    imported.chain(beside.map(|(address, _)| address)).collect()
}

/// Every part of a text between these two signs.
fn between<'a>(text: &'a str, from: &'a str, to: &'a str) -> impl Iterator<Item = &'a str> {
    text.split(from).skip(1).filter_map(move |rest| rest.split_once(to)).map(|(inside, _)| inside)
}

/// The path that an address leads to, as seen from a file.
fn resolve(from: &str, address: &str) -> String {
    let mut steps: Vec<&str> = from.split('/').collect();
    steps.pop();
    for step in address.split('/') {
        match step {
            "." => {}
            ".." => drop(steps.pop()),
            name => steps.push(name),
        }
    }
    steps.join("/")
}

#[cfg(test)]
mod tests {
    use super::{first_visit, gzipped};
    use crate::build::site::Site;

    #[test]
    fn everything_that_opens_with_the_page_is_weighed_once_and_nothing_else() {
        let mut site = Site::default();
        let document = "<link rel=\"stylesheet\" href=\"a/b.css\"><script src=\"a/main.js\"></script>\
            <a href=\"elsewhere.html\"></a><img src=\"1.svg\"><img src=\"2.svg\"><script>fetch(\"m.wasm\"); new Worker(\"a/w.js\");</script><link href=\"https://x.org/y\">";
        let script = "import * as x from \"../x.js\";\nconst y = new URL(\"./v.js\", import.meta.url);\nconst z = () => import(\"./later.js\");\n";
        for (name, content) in [
            ("index.html", document),
            ("a/b.css", "@font-face { src: url(\"f.woff2\") }"),
            ("a/f.woff2", "face"),
            ("a/main.js", script),
            (
                "a/w.js",
                "const place = new URL(\"./joined.js\", import.meta.url).href;\nimport * as x from \"../x.js\";\n",
            ),
            ("a/v.js", ""),
            ("x.js", "x"),
            ("1.svg", "<svg/>"),
            ("m.wasm", "m"),
        ] {
            site.add(name, content);
        }
        let weights = first_visit(&site).unwrap();
        let names: Vec<&str> = weights.keys().map(String::as_str).collect();
        assert_eq!(
            names,
            [
                "1.svg",
                "a/b.css",
                "a/f.woff2",
                "a/main.js",
                "a/v.js",
                "a/w.js",
                "index.html",
                "m.wasm",
                "x.js"
            ]
        );
        assert_eq!(weights["a/f.woff2"], 4);
        assert_eq!(weights["index.html"], gzipped(document.as_bytes()).len());
    }

    #[test]
    fn a_file_that_is_not_served_is_reported() {
        let mut site = Site::default();
        site.add("index.html", "<script src=\"gone.js\"></script>");
        assert!(first_visit(&site).is_err());
    }
}
