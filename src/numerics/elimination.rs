//! Linear systems of some hundred equations: Gaussian elimination with partial pivoting, factors kept for further right
//! sides.

use crate::error::NumericsError;

/// A factored matrix.
#[derive(Clone, Debug, PartialEq)]
pub struct Factors {
    size: usize,
    /// Row after row: below the diagonal the multipliers, from it on the eliminated rows.
    rows: Vec<f64>,
    pivots: Vec<usize>,
}

impl Factors {
    /// Factors the `size * size` numbers of a matrix by rows.
    ///
    /// # Errors
    /// [`NumericsError::Singular`] where no pivot is left that is a number other than zero.
    pub fn new(size: usize, mut rows: Vec<f64>) -> Result<Self, NumericsError> {
        let mut pivots = Vec::with_capacity(size);
        for column in 0..size {
            let (mut best, mut largest) = (column, 0.0);
            for row in column..size {
                let entry = rows[row * size + column].abs();
                if entry > largest {
                    (best, largest) = (row, entry);
                }
            }
            if !(largest > 0.0 && largest.is_finite()) {
                return Err(NumericsError::Singular);
            }
            pivots.push(best);
            if best != column {
                for place in 0..size {
                    rows.swap(column * size + place, best * size + place);
                }
            }
            let (above, below) = rows.split_at_mut((column + 1) * size);
            let pivot_row = &above[column * size + column..];
            let inverse = 1.0 / pivot_row[0];
            for row in below.chunks_exact_mut(size) {
                let factor = row[column] * inverse;
                row[column] = factor;
                if factor != 0.0 {
                    for (entry, pivot) in row[column + 1..].iter_mut().zip(&pivot_row[1..]) {
                        *entry -= factor * pivot;
                    }
                }
            }
        }
        Ok(Self { size, rows, pivots })
    }

    /// Replaces a right side by the solution.
    pub fn solve(&self, right: &mut [f64]) {
        let size = self.size;
        for (column, &pivot) in self.pivots.iter().enumerate() {
            right.swap(column, pivot);
        }
        for row in 1..size {
            let known: f64 =
                self.rows[row * size..row * size + row].iter().zip(&*right).map(|(a, b)| a * b).sum();
            right[row] -= known;
        }
        for row in (0..size).rev() {
            let entries = &self.rows[row * size + row..(row + 1) * size];
            let known: f64 = entries[1..].iter().zip(&right[row + 1..]).map(|(a, b)| a * b).sum();
            right[row] = (right[row] - known) / entries[0];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solutions_satisfy_the_system_and_a_singular_one_is_refused() {
        let size = 40;
        let entry = |i: usize, j: usize| {
            if i == j { 0.0 } else { ((7 * i + 3 * j * j) as f64).sin() }
        };
        let rows: Vec<f64> = (0..size * size).map(|at| entry(at / size, at % size)).collect();
        let factors = Factors::new(size, rows.clone()).expect("regular");
        let right: Vec<f64> = (0..size).map(|i| (i as f64).cos()).collect();
        let mut solution = right.clone();
        factors.solve(&mut solution);
        for i in 0..size {
            let sum: f64 = (0..size).map(|j| entry(i, j) * solution[j]).sum();
            assert!((sum - right[i]).abs() < 1e-12, "{i}");
        }
        assert_eq!(Factors::new(2, vec![1.0, 2.0, 2.0, 4.0]), Err(NumericsError::Singular));
    }
}
