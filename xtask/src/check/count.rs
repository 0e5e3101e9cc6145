//! Counting tests from what the test programs print.

use std::fmt;
use std::ops::AddAssign;

/// How many tests passed and failed.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Count {
    /// Those that passed.
    pub passed: usize,
    /// Those that did not.
    pub failed: usize,
}

impl AddAssign for Count {
    fn add_assign(&mut self, other: Self) {
        self.passed += other.passed;
        self.failed += other.failed;
    }
}

impl fmt::Display for Count {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} passed, {} failed", self.passed, self.failed)
    }
}

/// A line of `cargo test`: `test result: ok. 12 passed; 0 failed; 1 ignored; ...`.
pub fn cargo(line: &str) -> Count {
    let Some(result) = line.trim().strip_prefix("test result: ") else {
        return Count::default();
    };
    let mut count = Count::default();
    for part in result.split(['.', ';']) {
        match number_and_word(part) {
            Some((number, "passed")) => count.passed = number,
            Some((number, "failed")) => count.failed = number,
            _ => {}
        }
    }
    count
}

/// A line of `node --test` with its spec reporter: `ℹ pass 12`, `ℹ fail 0`, `ℹ cancelled 0`.
pub fn node(line: &str) -> Count {
    let mut words = line.trim().strip_prefix('ℹ').unwrap_or_default().split_ascii_whitespace();
    let (word, number) = (words.next(), words.next().and_then(|number| number.parse().ok()));
    match (word, number) {
        (Some("pass"), Some(passed)) => Count { passed, failed: 0 },
        (Some("fail" | "cancelled"), Some(failed)) => Count { passed: 0, failed },
        _ => Count::default(),
    }
}

/// A line of Playwright's summary: `  12 passed (3.4s)`, `  1 failed`, `  2 interrupted`, `  3 did not run`.
pub fn playwright(line: &str) -> Count {
    // The summary is indented; a test's own output need not be, and its title stands behind a mark.
    if !line.starts_with("  ") {
        return Count::default();
    }
    match number_and_word(line) {
        Some((passed, "passed")) => Count { passed, failed: 0 },
        Some((failed, "failed" | "flaky" | "interrupted" | "did")) => Count { passed: 0, failed },
        _ => Count::default(),
    }
}

/// `" 12 passed (3.4s)"` as `(12, "passed")`.
fn number_and_word(text: &str) -> Option<(usize, &str)> {
    let mut words = text.split_ascii_whitespace();
    Some((words.next()?.parse().ok()?, words.next()?))
}

#[cfg(test)]
mod tests {
    use super::{Count, cargo, node, playwright};

    fn sum(reader: fn(&str) -> Count, text: &str) -> (usize, usize) {
        let mut count = Count::default();
        text.lines().for_each(|line| count += reader(line));
        (count.passed, count.failed)
    }

    #[test]
    fn counts_of_cargo() {
        let text = "\
running 3 tests
test result: ok. 16 passed; 0 failed; 2 ignored; 0 measured; 0 filtered out; finished in 0.00s
test result: FAILED. 4 passed; 1 failed; 0 ignored; 0 measured; 9 filtered out; finished in 1.50s
16 passed; 1 failed";
        assert_eq!(sum(cargo, text), (20, 1));
    }

    #[test]
    fn counts_of_node() {
        let text = "✔ pass 3 (1.2ms)\nℹ tests 9\nℹ suites 0\nℹ pass 7\nℹ fail 1\nℹ cancelled 1\nℹ skipped 0";
        assert_eq!(sum(node, text), (7, 2));
    }

    #[test]
    fn counts_of_playwright() {
        let text = "\
Running 3 tests using 2 workers
  ✓  1 [chromium] › page.spec.js:3:1 › 5 passed parameters (1.0s)
5 passed
  2 failed
    [chromium] › page.spec.js:3:1 › x
  3 did not run
  12 passed (3.4s)";
        assert_eq!(sum(playwright, text), (12, 5));
    }
}
