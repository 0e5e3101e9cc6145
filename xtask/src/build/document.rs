//! As much of HTML as a build must understand: the tags of documents of our own, with their attributes.

/// A tag with its attributes; `</p>` is one of the name `/p`.
#[derive(Debug, PartialEq)]
pub struct Tag<'a> {
    /// As it stands, from `<` to `>`.
    pub text: &'a str,
    pub name: &'a str,
    attributes: Vec<(&'a str, Option<&'a str>)>,
}

impl<'a> Tag<'a> {
    /// The value of an attribute; empty for one without.
    pub fn value(&self, name: &str) -> Option<&'a str> {
        let found = self.attributes.iter().find(|(known, _)| *known == name);
        found.map(|(_, value)| value.unwrap_or_default())
    }

    /// The tag with another value of an attribute that it has; without the attribute for none.
    pub fn with(&self, name: &str, value: Option<&str>) -> String {
        let mut text = format!("<{}", self.name);
        for (known, given) in &self.attributes {
            let given = if *known == name { value } else { Some(given.unwrap_or_default()) };
            if let Some(given) = given {
                text.push(' ');
                text.push_str(known);
                if !given.is_empty() {
                    text.extend(["=\"", given, "\""]);
                }
            }
        }
        text.push('>');
        text
    }
}

/// A document with what `change` puts in the place of its tags; where it says none the tag stays. Scripts and styles are
/// passed over, and comments left out.
pub fn rewrite<E>(
    document: &str,
    mut change: impl FnMut(&Tag<'_>) -> Result<Option<String>, E>,
) -> Result<String, E> {
    let mut out = String::with_capacity(document.len());
    let mut rest = document;
    while let Some(at) = rest.find('<') {
        out.push_str(&rest[..at]);
        rest = &rest[at..];
        if let Some(comment) = rest.strip_prefix("<!--") {
            rest = comment.find("-->").map_or("", |end| &comment[end + 3..]);
            continue;
        }
        let Some(tag) = tag(rest) else {
            out.push('<');
            rest = &rest[1..];
            continue;
        };
        out.push_str(&change(&tag)?.unwrap_or_else(|| tag.text.to_owned()));
        rest = &rest[tag.text.len()..];
        if tag.name == "script" || tag.name == "style" {
            let close = format!("</{}", tag.name);
            let end = rest.find(&close).unwrap_or(rest.len());
            out.push_str(&rest[..end]);
            rest = &rest[end..];
        }
    }
    out.push_str(rest);
    Ok(out)
}

/// The tag that a text begins with.
fn tag(text: &str) -> Option<Tag<'_>> {
    let inner = text.strip_prefix('<')?;
    let name_end = inner
        .find(|sign: char| sign.is_whitespace() || sign == '>' || (sign == '/' && !inner.starts_with('/')))?;
    let name = &inner[..name_end];
    if !name.starts_with(|sign: char| sign.is_ascii_alphabetic() || sign == '/' || sign == '!') {
        return None;
    }
    let mut attributes = Vec::new();
    let mut rest = &inner[name_end..];
    loop {
        rest = rest.trim_start_matches(|sign: char| sign.is_whitespace() || sign == '/');
        if let Some(after) = rest.strip_prefix('>') {
            let length = text.len() - after.len();
            return Some(Tag { text: &text[..length], name, attributes });
        }
        let end = rest.find(|sign: char| sign.is_whitespace() || "=>/".contains(sign))?;
        if end == 0 {
            return None;
        }
        let attribute = &rest[..end];
        rest = &rest[end..];
        if let Some(value) = rest.strip_prefix('=') {
            let (value, after) = match value.strip_prefix('"') {
                Some(quoted) => quoted.split_once('"')?,
                None => value.split_at(value.find(|sign: char| sign.is_whitespace() || sign == '>')?),
            };
            attributes.push((attribute, Some(value)));
            rest = after;
        } else {
            attributes.push((attribute, None));
        }
    }
}

/// A text as the value of an attribute or as content.
pub fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::{escaped, rewrite, tag};

    #[test]
    fn tags_are_read() {
        let read = tag("<link rel=\"icon\" href=a.svg crossorigin data-x='y' />rest").unwrap();
        assert_eq!(
            (read.name, read.text),
            ("link", "<link rel=\"icon\" href=a.svg crossorigin data-x='y' />")
        );
        assert_eq!((read.value("rel"), read.value("href")), (Some("icon"), Some("a.svg")));
        assert_eq!((read.value("crossorigin"), read.value("src")), (Some(""), None));
        assert_eq!(read.with("href", Some("b")), "<link rel=\"icon\" href=\"b\" crossorigin data-x=\"'y'\">");
        assert_eq!(read.with("href", None), "<link rel=\"icon\" crossorigin data-x=\"'y'\">");
        assert_eq!(tag("</p >").unwrap().name, "/p");
        assert_eq!(tag("<!doctype html>").unwrap().name, "!doctype");
        assert!(tag("< 3").is_none() && tag("<p").is_none());
    }

    #[test]
    fn tags_change_and_all_else_stays_but_comments() {
        let document = "<!doctype html>\n<!-- <img src=no> --><p>1 < 2<img src=\"a\" alt=\"<b>\"></p><script>if (a<b) \"<img src=x>\"</script>";
        let changed = rewrite(document, |tag| -> Result<_, ()> {
            Ok((tag.name == "img").then(|| tag.with("src", Some("b"))))
        });
        assert_eq!(
            changed.unwrap(),
            "<!doctype html>\n<p>1 < 2<img src=\"b\" alt=\"<b>\"></p><script>if (a<b) \"<img src=x>\"</script>"
        );
    }

    #[test]
    fn signs_of_html_are_escaped() {
        assert_eq!(escaped("a < \"b\" & c"), "a &lt; &quot;b&quot; &amp; c");
    }
}
