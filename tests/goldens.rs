//! The SVG of every figure with its preset, against the text kept in `tests/goldens/`.
//!
//! `GOLDENS=renew cargo test --test goldens` writes them anew; look at them before committing. Words must agree to the
//! letter, numbers to two hundredths of a pixel: sine and cosine differ in the last bit between mathematics libraries.

use gear_bifurcations::chart::{self, theme::Theme, view::View};
use gear_bifurcations::figures::{figure, specifications};
use std::fs;
use std::path::PathBuf;

const WIDTH: f64 = 720.0;
/// Greatest difference of two numbers, in pixels.
const CLOSE: f64 = 0.02;
/// Greatest size of one picture, bytes.
const LARGEST: usize = 150_000;

fn drawn(id: &str) -> String {
    let specification = specifications().iter().find(|specification| specification.id == id).expect("known");
    let figure = figure(id, &[]).expect("its preset can be computed");
    let theme = Theme::by_name("light").expect("there is a light theme");
    let size = (WIDTH, (WIDTH / specification.aspect).round());
    chart::svg(&figure.drawing, specification.title, &figure.summary, size, &theme, &View::default())
        .expect("it can be drawn")
}

fn path(id: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/goldens").join(format!("{id}.svg"))
}

/// A piece of a text: a number, or what stands between numbers.
#[derive(Debug, PartialEq)]
enum Token<'a> {
    Number(f64),
    Words(&'a str),
}

fn tokens(text: &str) -> Vec<Token<'_>> {
    let bytes = text.as_bytes();
    let (mut tokens, mut words, mut at) = (Vec::new(), 0, 0);
    while at < bytes.len() {
        let start = at;
        if bytes[at] == b'-' {
            at += 1;
        }
        let digits = at;
        let mut points = 0;
        while at < bytes.len() && (bytes[at].is_ascii_digit() || (bytes[at] == b'.' && points == 0)) {
            points += usize::from(bytes[at] == b'.');
            at += 1;
        }
        match text[start..at].parse() {
            Ok(number) if at > digits => {
                if words < start {
                    tokens.push(Token::Words(&text[words..start]));
                }
                tokens.push(Token::Number(number));
                words = at;
            }
            _ => {
                // Not a number after all: on to the next character.
                at = start + 1;
                while !text.is_char_boundary(at) {
                    at += 1;
                }
            }
        }
    }
    if words < bytes.len() {
        tokens.push(Token::Words(&text[words..]));
    }
    tokens
}

/// The first place in which two texts differ by more than rounding.
fn difference(kept: &str, now: &str) -> Option<String> {
    if kept == now {
        return None;
    }
    let (kept, now) = (tokens(kept), tokens(now));
    let differs = |one: &Token, other: &Token| match (one, other) {
        (Token::Number(a), Token::Number(b)) => (a - b).abs() > CLOSE,
        (one, other) => one != other,
    };
    if let Some(place) = kept.iter().zip(&now).position(|(one, other)| differs(one, other)) {
        let around = |tokens: &[Token]| {
            format!("{:?}", &tokens[place.saturating_sub(3)..(place + 3).min(tokens.len())])
        };
        return Some(format!("kept {}\nnow  {}", around(&kept), around(&now)));
    }
    (kept.len() != now.len()).then(|| format!("{} pieces kept, {} now", kept.len(), now.len()))
}

#[test]
fn every_figure_is_drawn_as_it_was() {
    let renew = std::env::var("GOLDENS").is_ok_and(|value| value == "renew");
    let mut differing = Vec::new();
    for specification in specifications() {
        let (id, now) = (specification.id, drawn(specification.id));
        assert!(now.len() < LARGEST, "figure {id} takes {} bytes", now.len());
        if renew {
            fs::create_dir_all(path(id).parent().expect("a folder")).expect("a folder for the goldens");
            fs::write(path(id), &now).expect("the golden can be written");
            continue;
        }
        let kept = fs::read_to_string(path(id)).unwrap_or_default();
        if let Some(words) = difference(&kept, &now) {
            differing.push(format!("figure {id}:\n{words}"));
        }
    }
    assert!(
        differing.is_empty(),
        "{}\nIf the change is meant: GOLDENS=renew cargo test --test goldens",
        differing.join("\n")
    );
}

#[test]
fn a_picture_is_the_same_each_time() {
    for id in ["3", "8", "11c"] {
        assert!(drawn(id) == drawn(id), "figure {id} is drawn differently the second time");
    }
}

#[test]
fn words_must_agree_and_numbers_nearly() {
    let kept = "<path d=\"M1.5 -2.25h10\" fill=\"#ff0\"/>";
    assert_eq!(difference(kept, kept), None);
    assert_eq!(difference(kept, &kept.replace("2.25", "2.26")), None);
    for changed in [kept.replace("2.25", "2.29"), kept.replace("path", "line"), kept.replace("h10", "")] {
        assert!(difference(kept, &changed).is_some(), "{changed}");
    }
    assert_eq!(
        tokens("−0.4-3.5.2"),
        [Token::Words("−"), Token::Number(0.4), Token::Number(-3.5), Token::Number(0.2)]
    );
}
