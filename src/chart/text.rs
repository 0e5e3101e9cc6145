//! Label markup, and labels set into runs of letters with known places.
//!
//! `*x*` is italic, `_{..}` lowered, `^{..}` raised, `'` a prime, `\` takes the next character as it is; a hyphen
//! that begins a number is set as a minus sign. What is not closed stays as written.

use super::metrics::{ASCENT, DESCENT, Face, width};

/// Size of a lowered or raised text over that of its base, dimensionless.
const SCRIPT: f64 = 0.72;
/// How far a lowered text sinks, over the base's font size, dimensionless.
const LOWERED: f64 = 0.2;
/// How far a raised text rises, over the base's font size, dimensionless.
const RAISED: f64 = 0.34;

/// Letters of one face and size on one baseline.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    /// The letters; never begins or ends with a space.
    pub text: String,
    /// Left end, pixels from the label's left end.
    pub x: f64,
    /// Baseline, pixels under the label's baseline.
    pub y: f64,
    /// Font size, pixels.
    pub size: f64,
    /// The face.
    pub face: Face,
}

/// A label set into runs.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Label {
    /// The runs, from left to right.
    pub runs: Vec<Run>,
    /// Width, pixels.
    pub width: f64,
    /// Height over the baseline, pixels.
    pub ascent: f64,
    /// Depth under the baseline, pixels.
    pub descent: f64,
}

impl Label {
    /// Height from the highest to the lowest letter, pixels.
    pub fn height(&self) -> f64 {
        self.ascent + self.descent
    }
}

#[derive(Clone, Copy, PartialEq)]
enum Level {
    Base,
    Lowered,
    Raised,
}

/// A character with what the markup says about it.
#[derive(Clone, Copy)]
struct Letter {
    character: char,
    italic: bool,
    level: Level,
}

/// The font size nearest to a wanted one in steps of half a pixel: what is meant to be of one size is, however it was reckoned.
fn font_size(wanted: f64) -> f64 {
    (2.0 * wanted).round().max(1.0) / 2.0
}

/// Sets a label in a base face at about a font size in pixels.
pub fn set(markup: &str, size: f64, base: Face) -> Label {
    let size = font_size(size);
    let letters = parse(markup);
    let mut label = Label { ascent: ASCENT * size, descent: DESCENT * size, ..Label::default() };
    if letters.is_empty() {
        return Label::default();
    }
    // Lowered and raised text have pens of their own, so that they stand over each other.
    let (mut pen, mut lowered, mut raised) = (0.0_f64, None::<f64>, None::<f64>);
    let mut primes: Option<f64> = None;
    let mut index = 0;
    while index < letters.len() {
        let first = letters[index];
        let is_prime = |letter: &Letter| letter.level == Level::Base && letter.character == '\u{2032}';
        // Primes are runs of their own: a lowered text goes under them.
        let same = |letter: &&Letter| {
            letter.italic == first.italic
                && letter.level == first.level
                && is_prime(letter) == is_prime(&first)
        };
        let end = index + letters[index..].iter().take_while(same).count();
        let face = if first.italic { Face::Italic } else { base };
        let (font, shift) = match first.level {
            Level::Base => (size, 0.0),
            Level::Lowered => (font_size(SCRIPT * size), LOWERED * size),
            Level::Raised => (font_size(SCRIPT * size), -RAISED * size),
        };
        let text: String = letters[index..end].iter().map(|letter| letter.character).collect();
        let advance = width(&text, face, font);
        let start = match first.level {
            // A prime behind a lowered text stands over it, as in print.
            Level::Base if is_prime(&first) && lowered.is_some() => {
                let start = pen;
                pen += advance;
                start
            }
            Level::Base => {
                pen = pen.max(lowered.take().unwrap_or(pen)).max(raised.take().unwrap_or(pen));
                let start = pen;
                primes = is_prime(&first).then_some(start);
                pen += advance;
                start
            }
            Level::Lowered => {
                let start = lowered.or(primes).unwrap_or(pen);
                lowered = Some(start + advance);
                start
            }
            Level::Raised => {
                let start = raised.unwrap_or(pen);
                raised = Some(start + advance);
                start
            }
        };
        let trimmed = text.trim_start_matches(' ');
        let lead = width(&text[..text.len() - trimmed.len()], face, font);
        let kept = trimmed.trim_end_matches(' ');
        if !kept.is_empty() {
            label.runs.push(Run { text: kept.to_owned(), x: start + lead, y: shift, size: font, face });
            label.ascent = label.ascent.max(ASCENT * font - shift);
            label.descent = label.descent.max(DESCENT * font + shift);
        }
        index = end;
    }
    label.width = pen.max(lowered.unwrap_or(pen)).max(raised.unwrap_or(pen));
    label
}

/// Sets a label in as few lines as fit a width in pixels, broken at spaces between words.
pub fn set_lines(markup: &str, size: f64, base: Face, width: f64) -> Vec<Label> {
    let mut lines: Vec<String> = Vec::new();
    for word in words(markup) {
        if let Some(line) = lines.last_mut() {
            let longer = format!("{line} {word}");
            if set(&longer, size, base).width <= width {
                *line = longer;
                continue;
            }
        }
        lines.push(word);
    }
    lines.iter().map(|line| set(line, size, base)).collect()
}

/// Words of a markup: split at spaces outside of braces and italics.
fn words(markup: &str) -> Vec<String> {
    let (mut words, mut word, mut depth, mut italic) = (Vec::new(), String::new(), 0_usize, false);
    for character in markup.chars() {
        match character {
            '{' => depth += 1,
            '}' => depth = depth.saturating_sub(1),
            '*' => italic = !italic,
            _ => {}
        }
        if character == ' ' && depth == 0 && !italic {
            if !word.is_empty() {
                words.push(std::mem::take(&mut word));
            }
        } else {
            word.push(character);
        }
    }
    if !word.is_empty() {
        words.push(word);
    }
    words
}

/// The markup without its signs, as a reader would say it: for titles and for the ear.
pub fn plain(markup: &str) -> String {
    parse(markup).into_iter().map(|letter| letter.character).collect()
}

fn parse(markup: &str) -> Vec<Letter> {
    let source: Vec<char> = markup.chars().collect();
    let mut letters: Vec<Letter> = Vec::with_capacity(source.len());
    let (mut italic, mut level) = (false, Level::Base);
    let mut index = 0;
    while index < source.len() {
        let character = source[index];
        let rest = &source[index + 1..];
        match character {
            '\\' if !rest.is_empty() => {
                letters.push(Letter { character: rest[0], italic, level });
                index += 1;
            }
            '*' if italic || rest.contains(&'*') => italic = !italic,
            '_' | '^' if level == Level::Base && rest.first() == Some(&'{') && rest.contains(&'}') => {
                level = if character == '_' { Level::Lowered } else { Level::Raised };
                index += 1;
            }
            '}' if level != Level::Base => level = Level::Base,
            '\'' => letters.push(Letter { character: '\u{2032}', italic: false, level }),
            '-' if begins_number(letters.last().map(|letter| letter.character), rest) => {
                letters.push(Letter { character: '\u{2212}', italic: false, level });
            }
            // Digits stand upright, as in print, even within a symbol.
            _ => letters.push(Letter { character, italic: italic && !character.is_ascii_digit(), level }),
        }
        index += 1;
    }
    letters
}

fn begins_number(before: Option<char>, rest: &[char]) -> bool {
    let starts = rest.first().is_some_and(|next| next.is_ascii_digit() || *next == '.');
    starts && before.is_none_or(|last| " =(,[{<>≤≥±\u{2013}".contains(last))
}

#[cfg(test)]
mod tests {
    use super::{Face, plain, set, set_lines};

    #[test]
    fn italics_and_subscripts_become_runs() {
        let label = set("*Ω*_{1}", 10.0, Face::Regular);
        assert_eq!(label.runs.len(), 2);
        assert_eq!((label.runs[0].text.as_str(), label.runs[0].face), ("Ω", Face::Italic));
        assert_eq!(label.runs[1].text, "1");
        // 7.2 by its share, in steps of half a pixel.
        assert_eq!(label.runs[1].size, 7.0);
        assert!(label.runs[1].y > 0.0 && label.runs[1].x > 0.0);
        assert!(label.width > label.runs[1].x);
    }

    #[test]
    fn a_subscript_goes_under_the_prime() {
        let label = set("*u*'_{*p*}", 10.0, Face::Regular);
        assert_eq!(label.runs[1].text, "\u{2032}");
        assert_eq!(label.runs[1].x, label.runs[2].x);
    }

    #[test]
    fn a_prime_behind_a_subscript_goes_over_it() {
        let label = set("*u*_{*p*}' x", 10.0, Face::Regular);
        assert_eq!(label.runs[1].x, label.runs[2].x);
        assert!(label.runs[3].x > label.runs[2].x + 3.0);
    }

    #[test]
    fn lowered_and_raised_stand_over_each_other() {
        let label = set("*u*_{*p*}^{2} x", 10.0, Face::Regular);
        assert_eq!(label.runs[1].x, label.runs[2].x);
        assert!(label.runs[3].x > label.runs[2].x);
    }

    #[test]
    fn hyphens_before_numbers_become_minus_signs() {
        assert_eq!(plain("*α* = -0.2, left-hand 1-2"), "α = \u{2212}0.2, left-hand 1-2");
    }

    #[test]
    fn unclosed_markup_stays_as_written() {
        assert_eq!(plain("a*b_{c"), "a*b_{c");
        assert_eq!(plain("a\\*b"), "a*b");
    }

    #[test]
    fn lines_are_broken_to_fit() {
        let lines = set_lines("one two three four", 10.0, Face::Regular, 45.0);
        assert!(lines.len() > 1);
        assert!(lines.iter().all(|line| line.width <= 45.0));
    }

    #[test]
    fn nothing_is_set_for_an_empty_label() {
        assert!(set("", 10.0, Face::Regular).runs.is_empty());
    }
}
