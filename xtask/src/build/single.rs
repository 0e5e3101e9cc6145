//! The page, and any figure of it, as one file with everything inside: opened by a double click, without any request.
//!
//! The modules stand in plain scripts; the wasm, packed and in letters, in one that does not run. Each part has an id, so
//! that such a file can make others of itself: `www/embed/save-figure.js` fills the same shell with the same parts.

use super::document::{Tag, escaped, rewrite};
use super::modules::{Modules, resolve};
use super::site::Site;
use super::{base64, link, script, weight};
use crate::Failure;
use std::fmt::Write as _;
use std::path::Path;

/// No such file may be larger, in bytes.
pub const CEILING: usize = 2_000_000;

/// What the browser is to allow these files: scripts and styles that stand in them, workers made of those, and no request.
const POLICY: &str = "default-src 'none'; script-src 'unsafe-inline' 'wasm-unsafe-eval' blob:; worker-src blob:; \
                      style-src 'unsafe-inline'; img-src data: blob:; font-src data:";

const MODULE: &str = "gear-bifurcations.js";
const DELIVERY: &str = "www/engine/delivery.js";
const DELIVERY_INLINE: &str = "www/engine/delivery-inline.js";
const RUNNING: &str = "www/engine/running.js";
const MAIN: &str = "www/main.js";
const FIGURE: &str = "www/embed/figure-file.js";
const BEFOREHAND: &str = "www/shell/beforehand.js";
const HOLD_BACK: &str = "www/figure/hold-back.js";
/// What workers run.
pub const WORKER: &str = "www/engine/worker.js";

/// After this time a figure there without a live drawing shows its still one, ms: reading all of them takes longer than a
/// live one.
const PATIENCE: u32 = 4000;

/// So long after the file was opened its first figure is shown still, unless its answer is there, ms: an engine that
/// compiles slowly then has a picture before 300 ms, and one that compiles fast never shows two.
const FIRST_PATIENCE: u32 = 200;

/// What is said in the place of a drawing that found no room.
const STAND_IN: &str = "This figure is computed when the file is opened where scripts run.";

/// The parts that all these files have, by the id of their element.
const PARTS: [&str; 6] = ["gear-style", "gear-wasm", "gear-module", "gear-worker", "gear-code", "gear-shell"];

/// What these files are made of.
pub struct Single<'a> {
    site: &'a Site,
    /// In the order of `PARTS`.
    parts: [String; PARTS.len()],
    /// A figure's file, without the parts.
    shell: String,
    /// The script that says how the page looks before any of it is shown.
    beforehand: String,
    /// The script that keeps still drawings from being read before they are needed.
    hold_back: String,
    /// The modules that only the whole page has.
    page: String,
    index: &'a str,
}

impl<'a> Single<'a> {
    /// From the site's files, the page, the shell of a figure's file, and all modules with the module itself among them.
    pub fn gather(site: &'a Site, index: &'a str, figure: &str, modules: &Modules) -> Result<Self, Failure> {
        let mut modules = modules.clone();
        let inline = modules.get(DELIVERY_INLINE).cloned();
        let inline = inline.ok_or_else(|| Failure::invalid(DELIVERY_INLINE, "there is no such module"))?;
        modules.insert(DELIVERY.to_owned(), inline);
        let plain = |name: &str| match modules.get(name) {
            Some(text) => Ok(script::dense(text)),
            None => Err(Failure::invalid(name, "there is no such script")),
        };
        let (beforehand, hold_back) = (plain(BEFOREHAND)?, plain(HOLD_BACK)?);
        let [module, code, page] = three(link::scripts(&modules, &[&[MODULE], &[FIGURE], &[MAIN]])?)?;
        let [_, worker, _] = three(link::scripts(&modules, &[&[MODULE], &[WORKER], &[WORKER]])?)?;
        let [module, code, page, worker] = [module, code, page, worker].map(|text| script::dense(&text));
        let worker = worker + &link::start(WORKER);
        let wasm = base64::encoded(&weight::gzipped(site.bytes("gear-bifurcations_bg.wasm")?));
        let picture = |address: &str| site.text(address).map(picture_address);
        let shell = shell(site, figure, &picture, &Scripts { early: "", late: &started(FIGURE) })?;
        let packed = base64::encoded(shell.as_bytes());
        let style = style(site, index)?;
        Ok(Self {
            site,
            parts: [style, wasm, module, worker, code, packed],
            shell,
            beforehand,
            hold_back,
            page,
            index,
        })
    }

    /// The whole page. Where it would be too large, the heaviest of the drawings that stand in for figures without scripts
    /// stay out, and a sentence stands in their place; how many did is said with it.
    pub fn page(&self) -> Result<(String, usize), Failure> {
        let mut left_out: Vec<String> = Vec::new();
        loop {
            let mut heaviest = (0, String::new());
            let picture = |address: &str| {
                let drawing = self.site.text(address)?;
                let left_out = left_out.iter().any(|known| known == address);
                Ok(if left_out { picture_address(&stand_in(drawing)) } else { picture_address(drawing) })
            };
            let late = format!("<script id=\"gear-page\">\n{}</script>\n{}", self.page, started(MAIN));
            let early = format!(
                "<script>\n{}</script>\n<script data-patience=\"{PATIENCE}\" data-first-patience=\"{FIRST_PATIENCE}\">\n{}</script>\n{}",
                self.beforehand,
                self.hold_back,
                started(RUNNING)
            );
            let scripts = Scripts { early: &early, late: &late };
            let page = self.filled(&shell(self.site, self.index, &picture, &scripts)?);
            if page.len() <= CEILING {
                return Ok((page, left_out.len()));
            }
            rewrite(self.index, |tag| -> Result<_, Failure> {
                if let Some(address) = tag.value("src").filter(|_| tag.name == "img") {
                    let size = self.site.bytes(address)?.len();
                    if size > heaviest.0 && !left_out.iter().any(|known| known == address) {
                        heaviest = (size, address.to_owned());
                    }
                }
                Ok(None)
            })?;
            if heaviest.0 == 0 {
                let reason = format!("{} bytes, more than the ceiling of {CEILING}", page.len());
                return Err(Failure::invalid("the page in one file", reason));
            }
            left_out.push(heaviest.1);
        }
    }

    /// What a figure's file is made from in the browser: all but what stands in double braces.
    pub fn template(&self) -> String {
        self.filled(&self.shell)
    }

    /// The file of a figure as it is drawn before anybody changes anything.
    pub fn figure(&self, id: &str) -> Result<String, Failure> {
        let path = format!("figures/{id}.svg");
        let drawing = self.site.text(&path).map_err(|_| {
            Failure::invalid(
                format!("figure {id}"),
                "there is none of this name; those there are: see figures/ in the site",
            )
        })?;
        let ((title, description), (width, height)) = (words_of(drawing), size_of(drawing));
        let values = [
            ("title", title),
            ("description", description),
            ("width", width.to_owned()),
            ("height", height.to_owned()),
            ("picture", picture_address(drawing)),
            ("figure", id.to_owned()),
            ("attributes", String::new()),
        ];
        Ok(values
            .iter()
            .fold(self.template(), |file, (name, value)| file.replace(&format!("{{{{{name}}}}}"), value)))
    }

    fn filled(&self, shell: &str) -> String {
        let parts = PARTS.iter().zip(&self.parts);
        parts.fold(shell.to_owned(), |file, (id, part)| file.replace(&format!("{{{{{id}}}}}"), part))
    }
}

/// Exactly three scripts, none of which ends the element that it stands in.
fn three(scripts: Vec<String>) -> Result<[String; 3], Failure> {
    if scripts.iter().any(|script| script.contains("</script") || script.contains("<!--")) {
        return Err(Failure::invalid(
            "the scripts",
            "\"</script\" and \"<!--\" cannot stand in them: part them",
        ));
    }
    <[String; 3]>::try_from(scripts).map_err(|_| Failure::invalid("the scripts", "there must be three"))
}

/// The scripts of a document beyond the parts: those before its content, and those after it.
struct Scripts<'a> {
    early: &'a str,
    late: &'a str,
}

/// The script that starts a module.
fn started(path: &str) -> String {
    format!("<script>{}</script>\n", link::start(path))
}

/// A document with its own policy, room for the parts in the place of its links to files, and no address that leads to
/// another file.
fn shell(
    site: &Site,
    document: &str,
    picture: &dyn Fn(&str) -> Result<String, Failure>,
    scripts: &Scripts<'_>,
) -> Result<String, Failure> {
    let part = |id: &str, kind: &str| format!("<script id=\"{id}\"{kind}>{{{{{id}}}}}</script>\n");
    let silent = " type=\"text/plain\"";
    let mut head = String::from("<style id=\"gear-style\">{{gear-style}}</style>\n");
    for id in &PARTS[1..] {
        head.push_str(&part(id, if ["gear-module", "gear-code"].contains(id) { "" } else { silent }));
    }
    // Within scripts nothing is looked at, so the end tags of those that are taken out go with them.
    let mut ends = false;
    rewrite(document, |tag| {
        if tag.name == "/script" && std::mem::take(&mut ends) {
            return Ok(Some(String::new()));
        }
        Ok(match tag.name {
            "meta" if tag.value("charset").is_some() => Some(format!(
                "{}\n  <meta http-equiv=\"Content-Security-Policy\" content=\"{POLICY}\">",
                tag.text
            )),
            "link" => Some(match tag.value("rel") {
                Some("icon") => {
                    let address = tag.value("href").unwrap_or_default();
                    tag.with("href", Some(&picture_address(site.text(address)?)))
                }
                _ => String::new(),
            }),
            "script" if tag.value("src").is_some() => {
                ends = true;
                Some(String::new())
            }
            "/head" => Some(format!("{head}{}</head>", scripts.early)),
            "/body" => Some(format!("{}</body>", scripts.late)),
            "img" => match tag.value("src") {
                Some(address) if !address.contains("{{") => Some(tag.with("src", Some(&picture(address)?))),
                _ => None,
            },
            "a" => {
                tag.value("href").filter(|address| leads_to_a_file(address)).map(|_| tag.with("href", None))
            }
            _ => return refused(tag),
        })
    })
}

/// Whether an address is one of a file beside the document.
fn leads_to_a_file(address: &str) -> bool {
    !address.starts_with('#') && !address.contains(':') && !address.contains("{{")
}

/// Other tags may hold no address of a file.
fn refused(tag: &Tag<'_>) -> Result<Option<String>, Failure> {
    let addresses = ["src", "srcset", "href", "data", "poster", "action"];
    let found = addresses.iter().filter_map(|name| tag.value(name)).find(|address| leads_to_a_file(address));
    match found {
        Some(_) => Err(Failure::invalid(tag.text, "the page in one file cannot lead there")),
        None => Ok(None),
    }
}

/// All style sheets of a document, with what they name inside.
fn style(site: &Site, document: &str) -> Result<String, Failure> {
    let mut whole = String::new();
    rewrite(document, |tag| -> Result<_, Failure> {
        if tag.name == "link" && tag.value("rel") == Some("stylesheet") {
            let path = tag.value("href").unwrap_or_default();
            whole.push_str(&sheet(site, path)?);
        }
        Ok(None)
    })?;
    Ok(whole)
}

/// A style sheet, without comments, with the files that it names inside.
fn sheet(site: &Site, path: &str) -> Result<String, Failure> {
    let text = bare_style(site.text(path)?);
    let mut whole = String::new();
    let mut rest = text.as_str();
    while let Some((before, after)) = rest.split_once("url(\"") {
        let (address, after) =
            after.split_once("\")").ok_or_else(|| Failure::invalid(path, "an address in it does not end"))?;
        let target = resolve(path, &format!("./{address}")).unwrap_or_default();
        let kind = if Path::new(&target).extension().is_some_and(|ending| ending == "woff2") {
            "font/woff2"
        } else {
            return Err(Failure::invalid(
                path,
                format!("{address}: only typefaces can stand in the single file"),
            ));
        };
        whole.push_str(before);
        let _ = write!(whole, "url(\"data:{kind};base64,{}\")", base64::encoded(site.bytes(&target)?));
        rest = after;
    }
    whole.push_str(rest);
    if whole.contains("@import") || whole.contains("</") {
        return Err(Failure::invalid(
            path,
            "what it imports, or a tag in it, cannot stand in the single file",
        ));
    }
    Ok(whole)
}

/// A style sheet without its comments and empty lines.
pub fn bare_style(text: &str) -> String {
    let mut plain = String::new();
    let mut rest = text;
    while let Some((before, after)) = rest.split_once("/*") {
        plain.push_str(before);
        rest = after.split_once("*/").map_or("", |(_, after)| after);
    }
    plain.push_str(rest);
    plain.lines().map(str::trim).filter(|line| !line.is_empty()).flat_map(|line| [line, "\n"]).collect()
}

/// A drawing as an address of its own, in letters as they are but for those that mean something in one. The two kinds of
/// quotes change places within its tags, for the address stands in double ones.
fn picture_address(drawing: &str) -> String {
    let mut address = String::from("data:image/svg+xml,");
    let mut in_tag = false;
    for sign in drawing.chars() {
        in_tag = sign == '<' || (in_tag && sign != '>');
        match sign {
            '"' if in_tag => address.push('\''),
            '\'' if in_tag => address.push_str("%22"),
            '\n' => address.push(' '),
            '"' | '%' | '#' | '&' => {
                let _ = write!(address, "%{:02X}", sign as u32);
            }
            _ => address.push(sign),
        }
    }
    address
}

/// What stands where a drawing found no room: as large as it, with a sentence why nothing more is seen.
fn stand_in(drawing: &str) -> String {
    let (width, height) = size_of(drawing);
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\" \
         font-family=\"Times New Roman,Times,serif\"><rect width=\"100%\" height=\"100%\" fill=\"#f3f3f1\"/><text x=\"50%\" \
         y=\"50%\" font-size=\"20\" text-anchor=\"middle\" fill=\"#4e555d\">{STAND_IN}</text></svg>"
    )
}

/// The title of a drawing and the sentence that says what it shows, as values of attributes.
pub fn words_of(drawing: &str) -> (String, String) {
    let text = |start, end| escaped_again(within(drawing, start, end));
    (text("<title>", "</title>"), text("<desc>", "</desc>"))
}

/// Width and height of a drawing, as it says them.
pub fn size_of(drawing: &str) -> (&str, &str) {
    (within(drawing, " width=\"", "\""), within(drawing, " height=\"", "\""))
}

/// What stands first between these two; nothing where they do not.
fn within<'a>(text: &'a str, start: &str, end: &str) -> &'a str {
    let found = text.split_once(start).and_then(|(_, after)| after.split_once(end));
    found.map_or("", |(inner, _)| inner)
}

/// Text of a drawing, where some signs are escaped, as the value of an attribute.
fn escaped_again(text: &str) -> String {
    escaped(&text.replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&"))
}

#[cfg(test)]
mod tests {
    use super::{Scripts, bare_style, escaped_again, picture_address, shell};
    use crate::build::site::Site;

    fn shelled(body: &str) -> Result<String, crate::Failure> {
        let document = format!(
            "<html><head><meta charset=\"utf-8\"><link rel=\"preload\" href=\"a.wasm\"><script src=\"a.js\"></script></head><body>{body}</body></html>"
        );
        shell(
            &Site::default(),
            &document,
            &|address| Ok(format!("data:{address}")),
            &Scripts { early: "E", late: "L" },
        )
    }

    #[test]
    fn nothing_in_the_file_leads_to_another() {
        let text = shelled("<a href=\"module.js\">m</a><a href=\"#there\">t</a><a href=\"https://a.b/\">w</a><img src=\"1.svg\" alt=\"\">").unwrap();
        assert!(text.contains(
            "<a>m</a><a href=\"#there\">t</a><a href=\"https://a.b/\">w</a><img src=\"data:1.svg\" alt>"
        ));
        assert!(text.contains("<meta charset=\"utf-8\">\n  <meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none';"));
        assert!(!text.contains("a.wasm") && !text.contains("a.js"));
        assert!(text.contains("E</head>") && text.ends_with("L</body></html>"));
        for id in super::PARTS {
            assert_eq!(text.matches(&format!("{{{{{id}}}}}")).count(), 1, "{id}");
        }
    }

    #[test]
    fn what_would_ask_for_a_file_is_refused() {
        for body in [
            "<video src=\"a.mp4\"></video>",
            "<iframe src=\"b.html\"></iframe>",
            "<object data=\"c\"></object>",
        ] {
            assert!(shelled(body).is_err(), "{body}");
        }
        assert!(shelled("<svg><use href=\"#a\"/></svg>").is_ok());
    }

    #[test]
    fn drawings_are_written_into_addresses() {
        let drawing = "<svg font=\"'A B', C\">\n<desc>50 % of \"it's\" &amp;</desc><p fill=\"#fff\"/></svg>";
        assert_eq!(
            picture_address(drawing),
            "data:image/svg+xml,<svg font='%22A B%22, C'> <desc>50 %25 of %22it's%22 %26amp;</desc><p fill='%23fff'/></svg>"
        );
        assert_eq!(escaped_again("a &lt; \"b\" &amp; c"), "a &lt; &quot;b&quot; &amp; c");
    }

    #[test]
    fn style_sheets_lose_their_comments() {
        assert_eq!(bare_style("/* a\nb */\np {\n  color: red; /* c */\n}\n"), "p {\ncolor: red;\n}\n");
    }
}
