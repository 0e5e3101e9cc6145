//! As much of JavaScript as a build must understand: what is code, what a comment, and what a string, a template or a
//! regular expression, in which nothing may be touched.

/// A stretch of a script.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stretch<'a> {
    /// Code proper.
    Code(&'a str),
    /// A string, a template with all that stands in it, or a regular expression.
    Literal(&'a str),
    /// A comment.
    Comment(&'a str),
}

/// A script in its stretches; joined they are the script.
pub fn stretches(text: &str) -> Vec<Stretch<'_>> {
    let mut found = Vec::new();
    let bytes = text.as_bytes();
    let (mut start, mut at) = (0, 0);
    while at < bytes.len() {
        let end = match (bytes[at], bytes.get(at + 1)) {
            (b'/', Some(b'/')) => {
                Some((text[at..].find('\n').map_or(text.len(), |length| at + length), true))
            }
            (b'/', Some(b'*')) => {
                Some((text[at + 2..].find("*/").map_or(text.len(), |length| at + length + 4), true))
            }
            (b'/', _) if expression_may_begin(&text[..at], &found, start) => {
                Some((expression_end(bytes, at), false))
            }
            (b'"' | b'\'', _) => Some((quoted_end(bytes, at), false)),
            (b'`', _) => Some((template_end(bytes, at), false)),
            _ => None,
        };
        let Some((end, comment)) = end else {
            at += 1;
            continue;
        };
        if start < at {
            found.push(Stretch::Code(&text[start..at]));
        }
        found.push(if comment { Stretch::Comment(&text[at..end]) } else { Stretch::Literal(&text[at..end]) });
        (start, at) = (end, end);
    }
    if start < text.len() {
        found.push(Stretch::Code(&text[start..]));
    }
    found
}

/// Without comments, indentation and empty lines: what a browser need not be sent.
pub fn bare(text: &str) -> String {
    let mut bare = String::with_capacity(text.len());
    for stretch in stretches(text) {
        match stretch {
            Stretch::Literal(literal) => bare.push_str(literal),
            // Where a line ended in a comment, a statement may end.
            Stretch::Comment(comment) => {
                push_code(&mut bare, if comment.contains('\n') { "\n" } else { " " });
            }
            Stretch::Code(code) => push_code(&mut bare, code),
        }
    }
    bare
}

/// A script of which a browser that knows this sign compiles every function as it arrives, beside the page. Otherwise it reads them
/// all to find their ends, and most once more on the page's own thread, while the page opens. V8 knows it since version 13.6,
/// see <https://v8.dev/blog/explicit-compile-hints>; for others it is a comment.
pub fn compiled_at_once(text: &str) -> String {
    format!("//# allFunctionsCalledOnLoad\n{text}")
}

/// Adds code, of whose white space a sign a stretch is kept: a line's end if there was one.
fn push_code(bare: &mut String, code: &str) {
    for sign in code.chars() {
        match sign {
            '\n' => {
                bare.truncate(bare.trim_end_matches(' ').len());
                if !bare.is_empty() && !bare.ends_with('\n') {
                    bare.push('\n');
                }
            }
            ' ' | '\t' | '\r' => {
                if !bare.is_empty() && !bare.ends_with([' ', '\n']) {
                    bare.push(' ');
                }
            }
            _ => bare.push(sign),
        }
    }
}

/// Bare, without white space beside signs either, and with the end of a line only where a statement may end by it: what is joined
/// into one file is read by browsers alone.
pub fn dense(text: &str) -> String {
    let text = bare(text);
    let mut dense = String::with_capacity(text.len());
    for stretch in stretches(&text) {
        match stretch {
            Stretch::Literal(literal) => {
                if !literal.starts_with('/') {
                    drop_spaces(&mut dense);
                }
                dense.push_str(literal);
            }
            Stretch::Comment(comment) => dense.push_str(comment),
            Stretch::Code(code) => code.chars().for_each(|sign| push_dense(&mut dense, sign)),
        }
    }
    dense
}

/// Adds a sign of code that has no comments and no indentation.
fn push_dense(dense: &mut String, sign: char) {
    if sign == '\n' || PARTS.contains(&sign) {
        drop_spaces(dense);
    }
    if GOES_BACK.contains(&sign) && dense.ends_with('\n') {
        dense.pop();
    }
    let idle = match sign {
        ' ' => dense.ends_with(PARTS) || dense.ends_with('\n'),
        '\n' => dense.ends_with(GOES_ON),
        _ => false,
    };
    if !idle {
        dense.push(sign);
    }
}

fn drop_spaces(text: &mut String) {
    text.truncate(text.trim_end_matches(' ').len());
}

/// Beside these no space is needed: brought together, no two of them mean anything else.
const PARTS: &[char] =
    &['(', ')', '{', '}', '[', ']', ',', ';', ':', '?', '=', '<', '>', '&', '|', '"', '\'', '`'];
/// After these a statement goes on, or is over in any case.
const GOES_ON: &[char] = &['(', '{', '[', ',', ';', ':', '?', '=', '&', '|'];
/// Before these it goes on.
const GOES_BACK: &[char] = &[')', '}', ']', ',', ';', ':', '?', '=', '&', '|'];

/// Whether a `/` after `before` begins a regular expression; otherwise it divides.
fn expression_may_begin(before: &str, found: &[Stretch<'_>], start: usize) -> bool {
    let code = before[start..].trim_end();
    let Some(last) = code.chars().last() else {
        // Straight after a comment one has to look further back; after a literal one divides.
        return match found.iter().rev().find(|stretch| !matches!(stretch, Stretch::Comment(_))) {
            Some(Stretch::Code(code)) => code.trim_end().ends_with(begins),
            Some(_) => false,
            None => true,
        };
    };
    let word = code.rsplit(|sign: char| !sign.is_ascii_alphanumeric()).next().unwrap_or_default();
    begins(last) || ["return", "typeof", "case", "in", "of", "await", "yield"].contains(&word)
}

/// Signs after which an expression begins.
fn begins(sign: char) -> bool {
    "(,=:[!&|?{;+-*%<>~^".contains(sign)
}

/// Where the regular expression that begins at `at` ends, with its flags.
fn expression_end(bytes: &[u8], at: usize) -> usize {
    let (mut end, mut class) = (at + 1, false);
    while end < bytes.len() && bytes[end] != b'\n' {
        match bytes[end] {
            b'\\' => end += 1,
            b'[' => class = true,
            b']' => class = false,
            b'/' if !class => break,
            _ => {}
        }
        end += 1;
    }
    end += 1;
    while end < bytes.len() && bytes[end].is_ascii_alphabetic() {
        end += 1;
    }
    end.min(bytes.len())
}

/// Where the string that begins at `at` ends.
fn quoted_end(bytes: &[u8], at: usize) -> usize {
    let mut end = at + 1;
    while end < bytes.len() && bytes[end] != bytes[at] && bytes[end] != b'\n' {
        end += if bytes[end] == b'\\' { 2 } else { 1 };
    }
    (end + 1).min(bytes.len())
}

/// Where the template that begins at `at` ends, with the expressions in it and the templates in those.
fn template_end(bytes: &[u8], at: usize) -> usize {
    let mut end = at + 1;
    while end < bytes.len() && bytes[end] != b'`' {
        if bytes[end] == b'\\' {
            end += 2;
        } else if bytes[end] == b'$' && bytes.get(end + 1) == Some(&b'{') {
            end = hole_end(bytes, end + 2);
        } else {
            end += 1;
        }
    }
    (end + 1).min(bytes.len())
}

/// Where the expression in a template ends, behind its closing brace.
fn hole_end(bytes: &[u8], at: usize) -> usize {
    let (mut end, mut open) = (at, 1);
    while end < bytes.len() && open > 0 {
        match bytes[end] {
            b'`' => end = template_end(bytes, end),
            b'"' | b'\'' => end = quoted_end(bytes, end),
            sign => {
                open += i32::from(sign == b'{') - i32::from(sign == b'}');
                end += 1;
            }
        }
    }
    end
}

#[cfg(test)]
mod tests {
    use super::Stretch::{Code, Comment, Literal};
    use super::{bare, dense, stretches};

    #[test]
    fn code_comments_and_literals_are_told_apart() {
        assert_eq!(
            stretches(
                "a(\"//\\\"\", `/* ${b(`}`, '}')} `); // c\nd / e / f; /* g */ h = /[/\"]\\//gu.test(i);"
            ),
            [
                Code("a("),
                Literal("\"//\\\"\""),
                Code(", "),
                Literal("`/* ${b(`}`, '}')} `"),
                Code("); "),
                Comment("// c"),
                Code("\nd / e / f; "),
                Comment("/* g */"),
                Code(" h = "),
                Literal("/[/\"]\\//gu"),
                Code(".test(i);"),
            ]
        );
    }

    #[test]
    fn what_divides_is_no_expression_and_what_follows_a_comment_is_looked_at() {
        assert_eq!(stretches("(a) / b / c"), [Code("(a) / b / c")]);
        assert_eq!(stretches("\"a\" / b / c"), [Literal("\"a\""), Code(" / b / c")]);
        assert_eq!(stretches("return /a'/;"), [Code("return "), Literal("/a'/"), Code(";")]);
        assert_eq!(
            stretches("x = /* y */ /'/;"),
            [Code("x = "), Comment("/* y */"), Code(" "), Literal("/'/"), Code(";")]
        );
    }

    #[test]
    fn nothing_is_lost_but_comments_and_white_space() {
        let text = "/** Doc. */\nexport function f() { // why\n\n  const x = /** @type {A} */ (y);\n  return /* no */ `\n  kept // too`;\n}\n";
        assert_eq!(bare(text), "export function f() {\nconst x = (y);\nreturn `\n  kept // too`;\n}\n");
    }

    #[test]
    fn a_dense_script_says_the_same() {
        let text = "const { a, b: c } = d;\nlet [x] = a ? [\n  1,\n  .5,\n] : `${ a } : b`;\nif (a + +b < c - -x) return \"a , b\" in c;\nx = y\n  ?? z;\nfor (const one of all) { f(one) }\nconst g = () => /a , b/u .test(c)\n(1 / x).go()\nawait [x];\n";
        assert_eq!(
            dense(text),
            "const{a,b:c}=d;let[x]=a?[1,.5,]:`${ a } : b`;if(a + +b<c - -x)return\"a , b\"in c;x=y??z;for(const one of all){f(one)}\nconst g=()=>/a , b/u .test(c)\n(1 / x).go()\nawait[x];"
        );
    }

    #[test]
    fn stretches_joined_are_the_script() {
        for text in ["", "/", "'", "`${", "/*", "a = /[", "\"é\" // ü", "`${`${1}`}`"] {
            let joined: String = stretches(text)
                .into_iter()
                .map(|stretch| match stretch {
                    Code(text) | Literal(text) | Comment(text) => text,
                })
                .collect();
            assert_eq!(joined, text);
        }
    }
}
