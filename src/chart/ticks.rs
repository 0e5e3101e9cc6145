//! Round numbers along an axis, and how they are written.

/// Ticks of an axis: where they stand, and what is written there.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Ticks {
    /// Values, rising.
    pub values: Vec<f64>,
    /// Their texts, without the common factor.
    pub labels: Vec<String>,
    /// Power of ten by which every text is to be multiplied; mostly 0.
    pub exponent: i32,
}

impl Ticks {
    /// The same with another sign before the decimals. A comma is as wide as a point, so that places stay.
    #[must_use]
    pub fn written_with(mut self, decimal: char) -> Self {
        if decimal != '.' {
            for label in &mut self.labels {
                *label = label.replace('.', decimal.encode_utf8(&mut [0; 4]));
            }
        }
        self
    }
}

/// Round steps within a decade.
const STEPS: [f64; 4] = [1.0, 2.0, 2.5, 5.0];

/// Ticks from `low` to `high` in the least round step (1, 2, 2.5 or 5 times a power of ten) that makes at most `most` of them;
/// if that leaves fewer than two, one step finer.
pub fn ticks(low: f64, high: f64, most: usize) -> Ticks {
    let most = most.max(2) as f64;
    let span = high - low;
    if !(span > 0.0 && span.is_finite()) {
        return Ticks::default();
    }
    let decade = (span / most).log10().floor() as i32;
    let mut finer = Ticks::default();
    for power in [decade - 1, decade, decade + 1] {
        for digit in STEPS {
            let step = digit * 10_f64.powi(power);
            let (first, last) = ((low / step - 1e-9).ceil(), (high / step + 1e-9).floor());
            let count = last - first + 1.0;
            if count > 2.0 * most + 4.0 {
                continue;
            }
            let found = written(first, last, digit, power);
            if count < 2.0 {
                return if finer.values.is_empty() { found } else { finer };
            }
            if count <= most {
                return found;
            }
            finer = found;
        }
    }
    finer
}

fn written(first: f64, last: f64, digit: f64, power: i32) -> Ticks {
    let count = (last - first).max(-1.0) as usize + usize::from(last >= first);
    let step = digit * 10_f64.powi(power);
    // The tick's number counts and is scaled last: the third of 0.1 is 0.3 and no neighbour of it.
    let value = |index: usize| (first + index as f64) * step;
    let largest = (first.abs().max(last.abs())) * step;
    let magnitude = if largest > 0.0 { largest.log10().floor() as i32 } else { 0 };
    let exponent = if magnitude >= 5 || magnitude <= -4 { magnitude } else { 0 };
    let decimals = (exponent - power + i32::from(digit == 2.5)).max(0) as usize;
    let labels = (0..count)
        .map(|index| {
            let number = (first + index as f64) * digit * 10_f64.powi(power - exponent);
            let text = format!("{:.decimals$}", number.abs());
            if number < 0.0 { format!("\u{2212}{text}") } else { text }
        })
        .collect();
    Ticks { values: (0..count).map(value).collect(), labels, exponent }
}

#[cfg(test)]
mod tests {
    use super::ticks;

    #[test]
    fn round_and_within() {
        let found = ticks(-0.613, 0.6, 6);
        assert_eq!(found.labels, ["\u{2212}0.50", "\u{2212}0.25", "0.00", "0.25", "0.50"]);
        assert!(found.values.iter().all(|value| (-0.613..=0.6).contains(value)));
    }

    #[test]
    fn labels_have_the_digits_that_tell_them_apart() {
        assert_eq!(ticks(0.0, 1.0, 5).labels, ["0.00", "0.25", "0.50", "0.75", "1.00"]);
        assert_eq!(ticks(0.0, 1.0, 6).labels, ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"]);
        assert_eq!(ticks(-4.0, 4.0, 5).labels, ["\u{2212}4", "\u{2212}2", "0", "2", "4"]);
        assert_eq!(ticks(0.0, 120.0, 7).labels, ["0", "20", "40", "60", "80", "100", "120"]);
        assert_eq!(ticks(1.456, 1.694, 6).labels, ["1.50", "1.55", "1.60", "1.65"]);
    }

    #[test]
    fn zero_is_written_without_a_sign() {
        assert!(ticks(-0.31, 0.3, 9).labels.contains(&"0.0".to_owned()));
        assert!(!ticks(-0.31, 0.3, 9).labels.iter().any(|label| label.contains("\u{2212}0.0")));
    }

    #[test]
    fn very_large_and_small_numbers_share_a_power_of_ten() {
        let large = ticks(0.0, 3e6, 4);
        assert_eq!(
            (large.exponent, large.labels.clone()),
            (6, vec!["0".into(), "1".into(), "2".into(), "3".into()])
        );
        let small = ticks(-2e-7, 2e-7, 5);
        assert_eq!((small.exponent, small.labels[0].as_str()), (-7, "\u{2212}2"));
    }

    #[test]
    fn labels_say_the_value_and_never_repeat() {
        for (low, high, most) in
            [(0.1, 0.7, 7), (-1e-3, 3.0, 9), (17.3, 17.9, 8), (-5e4, 7e4, 6), (99.9, 100.1, 5)]
        {
            let found = ticks(low, high, most);
            assert!(found.values.len() >= 2, "{low} {high}");
            for (value, label) in found.values.iter().zip(&found.labels) {
                let read: f64 = label.replace('\u{2212}', "-").parse().unwrap();
                let said = read * 10_f64.powi(found.exponent);
                assert!((said - value).abs() <= 1e-9 * (high - low), "{label} {value}");
            }
            assert!(found.labels.windows(2).all(|pair| pair[0] != pair[1]));
        }
    }

    #[test]
    fn the_decimal_sign_is_the_readers() {
        assert_eq!(ticks(-0.5, 0.5, 3).written_with(',').labels, ["\u{2212}0,5", "0,0", "0,5"]);
        assert_eq!(ticks(0.0, 1.0, 5).written_with('.'), ticks(0.0, 1.0, 5));
    }

    #[test]
    fn an_empty_range_has_none() {
        assert!(ticks(1.0, 1.0, 5).values.is_empty());
        assert!(ticks(f64::NEG_INFINITY, 1.0, 5).values.is_empty());
    }
}
