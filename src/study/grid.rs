//! Evenly spaced values of a parameter or coordinate.

use crate::error::StudyError;

/// Most values of a [`Grid`].
pub const MOST_VALUES: usize = 4096;

/// `count` evenly spaced values from `low` to `high`, both included.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grid {
    /// First value.
    pub low: f64,
    /// Last value, not below the first.
    pub high: f64,
    /// Number of values, 1 to [`MOST_VALUES`]; one value only where both ends are the same.
    pub count: usize,
}

impl Grid {
    /// A grid within `allowed`; `option` names it in errors.
    ///
    /// # Errors
    /// [`StudyError::Option`] for ends that are not finite, out of order or out of range, and for a count out of range.
    pub fn new(
        option: &'static str,
        [low, high]: [f64; 2],
        count: usize,
        allowed: [f64; 2],
    ) -> Result<Self, StudyError> {
        let [least, most] = allowed;
        let ordered = least <= low && low <= high && high <= most;
        let counted = (1..=MOST_VALUES).contains(&count) && (count > 1 || low == high);
        if ordered && counted {
            return Ok(Self { low, high, count });
        }
        Err(StudyError::Option {
            option,
            given: format!("[{low}, {high}, {count}]"),
            allowed: format!(
                "[low, high, number] with {least} <= low <= high <= {most} and a whole number from 2 to {MOST_VALUES}"
            ),
        })
    }

    /// The value of this index, 0 to `count - 1`; the ends are exact.
    pub fn value(&self, index: usize) -> f64 {
        if index == 0 {
            self.low
        } else if index + 1 >= self.count {
            self.high
        } else {
            self.low + (self.high - self.low) * (index as f64 / (self.count - 1) as f64)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_are_exact_and_values_are_even() {
        let grid = Grid::new("Omega", [0.4, 7.0], 200, [0.01, 100.0]).expect("allowed");
        assert_eq!((grid.value(0), grid.value(199)), (0.4, 7.0));
        let step = grid.value(1) - grid.value(0);
        assert!((1..200).all(|index| (grid.value(index) - grid.value(index - 1) - step).abs() < 1e-14));
    }

    #[test]
    fn bad_grids_are_refused_with_what_was_given() {
        for (ends, count) in [
            ([1.0, 0.5], 3),
            ([f64::NAN, 1.0], 3),
            ([0.0, 1.0], 3),
            ([0.5, 1.0], 0),
            ([0.5, 1.0], 1),
            ([0.5, 1.0], 5000),
        ] {
            let refused = Grid::new("Omega", ends, count, [0.01, 100.0]);
            assert!(matches!(refused, Err(StudyError::Option { option: "Omega", .. })), "{ends:?} {count}");
        }
    }
}
