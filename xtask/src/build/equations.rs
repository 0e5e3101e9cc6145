//! `docs/equations.md` as a page of its own: the numbers of equations on the page lead to its rows.

use crate::Failure;
use pulldown_cmark::{CowStr, Event, Options, Parser, Tag, TagEnd, TextMergeStream, html};
use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::path::Path;

/// Where it stands in the static folder.
pub const PAGE: &str = "docs/equations.html";

const HEAD: &str = r#"<!doctype html>
<html lang="en" data-theme="auto">
<head>
  <meta charset="utf-8">
  <meta name="viewport" content="width=device-width, initial-scale=1">
  <title>Equations: from the number to the code</title>
  <meta name="color-scheme" content="light dark">
  <link rel="icon" href="../www/style/icon.svg" type="image/svg+xml">
  <link rel="stylesheet" href="../www/style/fonts/faces.css">
  <link rel="stylesheet" href="../www/style/page.css">
  <link rel="stylesheet" href="../www/style/reference.css">
</head>
<body class="reference">
<header><p><a href="../index.html">gear-bifurcations</a></p></header>
<main>
"#;

const FOOT: &str = "</main>\n</body>\n</html>\n";

/// Reads the document and makes the page.
pub fn page(root: &Path) -> Result<String, Failure> {
    let file = root.join("docs/equations.md");
    let text = std::fs::read_to_string(&file).map_err(Failure::file(&file))?;
    Ok(render(&text))
}

fn render(markdown: &str) -> String {
    let mut events = Vec::new();
    let mut known = BTreeSet::new();
    // The column in which the present cell stands; none outside of a table's body.
    let mut column = None;
    for event in TextMergeStream::new(Parser::new_ext(markdown, Options::ENABLE_TABLES)) {
        match &event {
            Event::Start(Tag::TableRow) => column = Some(0),
            Event::End(TagEnd::TableCell) => column = column.map(|at: usize| at + 1),
            Event::End(TagEnd::TableRow) => column = None,
            Event::Text(text) if column == Some(0) => {
                let anchors = anchors(&numbers(text), &mut known);
                events.push(Event::InlineHtml(CowStr::from(anchors)));
            }
            // A path may be broken after each of its steps: a phone has no room for one in a line.
            Event::Code(path) if path.contains("::") => {
                let broken = path.split("::").collect::<Vec<_>>().join("::<wbr>");
                events.push(Event::InlineHtml(CowStr::from(format!("<code>{broken}</code>"))));
                continue;
            }
            _ => {}
        }
        events.push(event);
    }
    let mut body = String::new();
    html::push_html(&mut body, events.into_iter());
    format!("{HEAD}{body}{FOOT}")
}

/// The numbers that a text names: `(3)`, `[T4]`, and all within `(58)-(61)`.
fn numbers(text: &str) -> Vec<String> {
    let mut found = Vec::new();
    let mut rest = text;
    let mut from: Option<u32> = None;
    while let Some(start) = rest.find(['(', '[']) {
        let through = rest[..start] == *"-";
        let close = if rest[start..].starts_with('(') { ')' } else { ']' };
        let Some(length) = rest[start..].find(close) else { break };
        let name = &rest[start + 1..start + length];
        rest = &rest[start + length + 1..];
        let number = name.parse::<u32>().ok();
        if let (true, Some(first), Some(last)) = (through, from, number) {
            found.extend((first + 1..last).map(|between| between.to_string()));
        }
        if number.is_some() || name.starts_with('T') {
            found.push(name.to_owned());
        }
        from = number;
    }
    found
}

/// A place to link to for each number that has none yet.
fn anchors(numbers: &[String], known: &mut BTreeSet<String>) -> String {
    let mut made = String::new();
    for number in numbers {
        if known.insert(number.clone()) {
            let _ = write!(made, "<span id=\"eq-{number}\"></span>");
        }
    }
    made
}

#[cfg(test)]
mod tests {
    use super::{numbers, render};

    #[test]
    fn ranges_name_all_that_is_within_them() {
        assert_eq!(numbers("(1)-(4)"), ["1", "2", "3", "4"]);
        assert_eq!(numbers("(62)-(64), (87)-(89)"), ["62", "63", "64", "87", "88", "89"]);
        assert_eq!(numbers("[T3]"), ["T3"]);
        assert_eq!(numbers("(31), second order (see below)"), ["31"]);
        assert_eq!(numbers("Hill"), [""; 0]);
    }

    #[test]
    fn every_equation_has_one_place() {
        let page = render(include_str!("../../../docs/equations.md"));
        let numbers = (1..=113).map(|number: u32| number.to_string());
        for number in numbers.chain((1..=8).map(|number| format!("T{number}"))) {
            assert_eq!(page.matches(&format!("id=\"eq-{number}\"")).count(), 1, "({number})");
        }
        assert!(page.contains("<code>theory::<wbr>damped::<wbr>decay_rate</code>"));
    }
}
