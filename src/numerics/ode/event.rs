//! Crossings on a step's own polynomial.

/// Pieces narrower than this part of the step are not divided further: two roots so close count as a touch.
const NARROW: f64 = 1e-9;

/// A change of sign of a polynomial.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// Time since the start of the step.
    pub since: f64,
    /// From below zero to above.
    pub rising: bool,
}

/// The first time in (0, `length`] at which the polynomial changes sign; a touch without a change is none.
///
/// `starts_on_root`: it is zero at 0 by construction, and that zero does not count.
pub fn first_crossing<const LEN: usize>(
    coefficients: &[f64; LEN],
    length: f64,
    starts_on_root: bool,
) -> Option<f64> {
    let mut first = None;
    visit_crossings(coefficients, length, starts_on_root, &mut |crossing| {
        first = Some(crossing.since);
        true
    });
    first
}

/// Calls `visit` with each change of sign in (0, `length`] in order of time, until it answers true.
///
/// The polynomial is written in Bernstein form, whose changes of sign bound the number of roots, and halved until
/// every piece holds none or one: no pair of crossings within the step is missed (G. Farin, Curves and Surfaces
/// for CAGD, 5th ed., ch. 6, variation diminution).
pub fn visit_crossings<const LEN: usize>(
    coefficients: &[f64; LEN],
    length: f64,
    starts_on_root: bool,
    visit: &mut impl FnMut(Crossing) -> bool,
) {
    let mut scaled = [0.0; LEN];
    let mut power = 1.0;
    let skipped = usize::from(starts_on_root);
    for n in skipped..LEN {
        scaled[n - skipped] = coefficients[n] * power;
        power *= length;
    }
    let rest: f64 = scaled[1..].iter().map(|value| value.abs()).sum();
    if scaled[0].abs() > rest {
        return;
    }
    visit_in(&bernstein(&scaled), 0.0, 1.0, &mut |crossing| {
        visit(Crossing { since: crossing.since * length, ..crossing })
    });
}

/// Least and greatest value of the polynomial on [0, `length`], interior extrema included.
pub fn range<const LEN: usize>(coefficients: &[f64; LEN], length: f64) -> (f64, f64) {
    let value = |at: f64| coefficients.iter().rev().fold(0.0, |sum, coefficient| sum * at + coefficient);
    let (start, end) = (coefficients[0], value(length));
    let mut range = (start.min(end), start.max(end));
    let mut derivative = [0.0; LEN];
    for n in 1..LEN {
        derivative[n - 1] = coefficients[n] * n as f64;
    }
    visit_crossings(&derivative, length, false, &mut |crossing| {
        let extremum = value(crossing.since);
        range = (range.0.min(extremum), range.1.max(extremum));
        false
    });
    range
}

/// Bernstein coefficients on [0, 1] of a polynomial given by its powers.
fn bernstein<const LEN: usize>(powers: &[f64; LEN]) -> [f64; LEN] {
    let degree = LEN - 1;
    let mut coefficients = [0.0; LEN];
    for (i, coefficient) in coefficients.iter_mut().enumerate() {
        let mut ratio = 1.0;
        for (k, power) in powers.iter().enumerate().take(i + 1) {
            *coefficient += ratio * power;
            ratio *= (i - k) as f64 / (degree - k).max(1) as f64;
        }
    }
    coefficients
}

fn sign_changes(coefficients: &[f64]) -> usize {
    let mut changes = 0;
    let mut last = 0.0;
    for &value in coefficients {
        if value != 0.0 {
            if last * value < 0.0 {
                changes += 1;
            }
            last = value;
        }
    }
    changes
}

fn value_at<const LEN: usize>(coefficients: &[f64; LEN], part: f64) -> f64 {
    let mut work = *coefficients;
    for level in (1..LEN).rev() {
        for i in 0..level {
            work[i] += part * (work[i + 1] - work[i]);
        }
    }
    work[0]
}

/// Answers true once `visit` has.
fn visit_in<const LEN: usize>(
    coefficients: &[f64; LEN],
    low: f64,
    high: f64,
    visit: &mut impl FnMut(Crossing) -> bool,
) -> bool {
    match sign_changes(coefficients) {
        0 => false,
        1 => {
            let (part, rising) = only_root(coefficients);
            visit(Crossing { since: low + (high - low) * part, rising })
        }
        _ if high - low < NARROW => false,
        _ => {
            let (mut left, mut right) = ([0.0; LEN], *coefficients);
            for level in (0..LEN).rev() {
                left[LEN - 1 - level] = right[0];
                for i in 0..level {
                    right[i] = 0.5 * (right[i] + right[i + 1]);
                }
            }
            let middle = 0.5 * (low + high);
            visit_in(&left, low, middle, visit) || visit_in(&right, middle, high, visit)
        }
    }
}

/// The one root on [0, 1] of a polynomial whose Bernstein coefficients change sign once, by bisection, and
/// whether it rises there.
fn only_root<const LEN: usize>(coefficients: &[f64; LEN]) -> (f64, bool) {
    let (mut low, mut high) = (0.0, 1.0);
    let rising = coefficients.iter().rev().find(|value| **value != 0.0).is_some_and(|value| *value > 0.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if (value_at(coefficients, middle) > 0.0) == rising {
            high = middle;
        } else {
            low = middle;
        }
    }
    (0.5 * (low + high), rising)
}
