//! As much of a Rust lexer as is needed to read paths: names and punctuation, without comments, strings and numbers.

/// A name or a punctuation mark; `::` is one token.
#[derive(Clone, Debug, PartialEq)]
pub enum Token {
    Name(String),
    Mark(char),
    Colons,
}

/// The tokens of a source text.
pub fn tokens(text: &str) -> Vec<Token> {
    let characters: Vec<char> = text.chars().collect();
    let mut found = Vec::new();
    let mut at = 0;
    while let Some(&c) = characters.get(at) {
        let next = characters.get(at + 1).copied();
        at = match (c, next) {
            ('/', Some('/')) => after(&characters, at, |c| c == '\n'),
            ('/', Some('*')) => after_block_comment(&characters, at),
            ('"', _) => after_string(&characters, at),
            ('r' | 'b', Some('"' | '#' | 'r')) if starts_raw(&characters, at) => {
                after_raw_string(&characters, at)
            }
            ('\'', _) => after_quote(&characters, at),
            (':', Some(':')) => {
                found.push(Token::Colons);
                at + 2
            }
            _ if c.is_alphabetic() || c == '_' => {
                let end = after(&characters, at, |c| !(c.is_alphanumeric() || c == '_'));
                found.push(Token::Name(characters[at..end].iter().collect()));
                end
            }
            _ if c.is_ascii_digit() => after(&characters, at, |c| !(c.is_alphanumeric() || c == '_')),
            _ => {
                if !c.is_whitespace() {
                    found.push(Token::Mark(c));
                }
                at + 1
            }
        };
    }
    found
}

/// The first place from `at` on where the condition holds, or the end.
fn after(characters: &[char], at: usize, ends: impl Fn(char) -> bool) -> usize {
    characters[at..].iter().position(|&c| ends(c)).map_or(characters.len(), |length| at + length)
}

/// Block comments nest.
fn after_block_comment(characters: &[char], mut at: usize) -> usize {
    let mut depth = 0;
    while at < characters.len() {
        match (characters[at], characters.get(at + 1)) {
            ('/', Some('*')) => (depth, at) = (depth + 1, at + 2),
            ('*', Some('/')) => {
                (depth, at) = (depth - 1, at + 2);
                if depth == 0 {
                    break;
                }
            }
            _ => at += 1,
        }
    }
    at
}

fn after_string(characters: &[char], at: usize) -> usize {
    let mut at = at + 1;
    while at < characters.len() && characters[at] != '"' {
        at += if characters[at] == '\\' { 2 } else { 1 };
    }
    at + 1
}

/// Whether `r"`, `r#"`, `br"` and the like begin here (and not a raw name such as `r#type`).
fn starts_raw(characters: &[char], at: usize) -> bool {
    let rest = &characters[at..];
    let rest = rest.strip_prefix(&['b']).unwrap_or(rest);
    let Some(rest) = rest.strip_prefix(&['r']) else {
        return false;
    };
    rest.iter().find(|&&c| c != '#') == Some(&'"')
}

fn after_raw_string(characters: &[char], at: usize) -> usize {
    let open = after(characters, at, |c| c == '"');
    let hashes = characters[at..open].iter().filter(|&&c| c == '#').count();
    let closes = |end: usize| {
        characters[end..].starts_with(&['"'])
            && characters[end + 1..].iter().take(hashes).filter(|&&c| c == '#').count() == hashes
    };
    (open + 1..characters.len()).find(|&end| closes(end)).map_or(characters.len(), |end| end + 1 + hashes)
}

/// After a character, or after the mark of a lifetime.
fn after_quote(characters: &[char], at: usize) -> usize {
    match (characters.get(at + 1), characters.get(at + 2)) {
        (Some('\\'), _) => after(characters, at + 3, |c| c == '\'') + 1,
        (Some(_), Some('\'')) => at + 3,
        _ => at + 1,
    }
}

#[test]
fn comments_strings_and_numbers_hold_no_names() {
    let text = r##"a::b // c
        /* d /* e */ f */ "g \" h" r#"i " j"# 'l' '\'' '\u{41}' &'m n 1.5e3_f64 br"x" rust "##;
    let names: Vec<String> = tokens(text)
        .into_iter()
        .filter_map(|token| if let Token::Name(name) = token { Some(name) } else { None })
        .collect();
    assert_eq!(names, ["a", "b", "m", "n", "rust"]);
}
