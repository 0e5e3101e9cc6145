//! Whether the terms of a package are among those that we may pass on, or may at least work with.

/// Terms that ask for no more than their text to be kept.
const ALLOWED: [&str; 11] = [
    "MIT",
    "Apache-2.0",
    "Apache-2.0 WITH LLVM-exception",
    "BSD-2-Clause",
    "BSD-3-Clause",
    "0BSD",
    "ISC",
    "Unlicense",
    "CC0-1.0",
    "Zlib",
    "Unicode-3.0",
];

/// Terms of tools that are used in tests and never passed on.
const FOR_TOOLS: [&str; 3] = ["MPL-2.0", "BlueOak-1.0.0", "Python-2.0"];

/// What becomes of a package.
#[derive(Clone, Copy, PartialEq)]
pub enum Use {
    /// It is, or may be, in what we give to others.
    PassedOn,
    /// It runs in tests alone.
    InTests,
}

/// Whether an SPDX expression (or the old form with a slash) can be met by allowed terms.
pub fn allowed(expression: &str, purpose: Use) -> bool {
    let spaced = expression.replace('/', " OR ").replace('(', " ( ").replace(')', " ) ");
    let words: Vec<&str> = spaced.split_whitespace().collect();
    let mut at = 0;
    either(&words, &mut at, purpose).is_some_and(|met| met && at == words.len())
}

fn either(words: &[&str], at: &mut usize, purpose: Use) -> Option<bool> {
    let mut met = both(words, at, purpose)?;
    while words.get(*at) == Some(&"OR") {
        *at += 1;
        met |= both(words, at, purpose)?;
    }
    Some(met)
}

fn both(words: &[&str], at: &mut usize, purpose: Use) -> Option<bool> {
    let mut met = term(words, at, purpose)?;
    while words.get(*at) == Some(&"AND") {
        *at += 1;
        met &= term(words, at, purpose)?;
    }
    Some(met)
}

fn term(words: &[&str], at: &mut usize, purpose: Use) -> Option<bool> {
    let word = *words.get(*at)?;
    *at += 1;
    if word == "(" {
        let met = either(words, at, purpose)?;
        let closed = words.get(*at) == Some(&")");
        *at += 1;
        return closed.then_some(met);
    }
    if [")", "OR", "AND", "WITH"].contains(&word) {
        return None;
    }
    if words.get(*at) == Some(&"WITH") {
        let exception = words.get(*at + 1)?;
        *at += 2;
        return Some(ALLOWED.contains(&format!("{word} WITH {exception}").as_str()));
    }
    Some(ALLOWED.contains(&word) || (purpose == Use::InTests && FOR_TOOLS.contains(&word)))
}

#[cfg(test)]
mod tests {
    use super::{Use, allowed};

    #[test]
    fn expressions_are_met_or_not() {
        for met in [
            "MIT",
            "MIT/Apache-2.0",
            "Unlicense OR MIT",
            "GPL-3.0 OR (Zlib AND MIT)",
            "(MIT OR Apache-2.0) AND Unicode-3.0",
            "Apache-2.0 WITH LLVM-exception OR GPL-2.0",
        ] {
            assert!(allowed(met, Use::PassedOn), "{met}");
        }
        for refused in [
            "",
            "GPL-3.0",
            "MIT AND GPL-3.0",
            "(MIT",
            "MIT)",
            "MIT OR",
            "MIT WITH x",
            "UNLICENSED",
            "MIT Apache-2.0",
        ] {
            assert!(!allowed(refused, Use::InTests), "{refused}");
        }
    }

    #[test]
    fn what_is_never_passed_on_may_ask_for_more() {
        assert!(allowed("MPL-2.0", Use::InTests) && !allowed("MPL-2.0", Use::PassedOn));
    }
}
