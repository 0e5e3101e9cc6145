//! A Runge-Kutta step's own polynomial: the dense output.

use super::dop853_coefficients::{DENSE, RESULT, STAGES, Weights};

/// Coefficients of a dense output of degree 7.
pub const COEFFICIENTS: usize = 8;

/// A step and its polynomial of degree 7, accurate to order 7 all over the step and exact in value and slope at
/// both ends. A step backwards in time ends before it starts.
///
/// Source: E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, 2nd ed. 1993, section
/// II.6, (6.28) onwards, and the function CONTD8 of their code DOP853. With `r` from 0 to 1 along the step,
///
/// ```text
/// x(r) = x_0 + r (d_0 + (1-r) (d_1 + r (d_2 + (1-r) (d_3 + r (d_4 + (1-r) (d_5 + r d_6))))))
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DenseStep<const N: usize> {
    start: f64,
    end: f64,
    start_state: [f64; N],
    end_state: [f64; N],
    terms: [[f64; N]; COEFFICIENTS - 1],
}

impl<const N: usize> DenseStep<N> {
    /// The step from `start` to `end` whose stages had these slopes.
    pub(super) fn new(
        (start, start_state): (f64, [f64; N]),
        (end, end_state): (f64, [f64; N]),
        slopes: &[[f64; N]; STAGES],
    ) -> Self {
        let length = end - start;
        let mut terms = [[0.0; N]; COEFFICIENTS - 1];
        for i in 0..N {
            let rise = end_state[i] - start_state[i];
            terms[0][i] = rise;
            terms[1][i] = length * slopes[0][i] - rise;
            terms[2][i] = rise - length * slopes[RESULT][i] - terms[1][i];
        }
        for (term, weights) in terms[3..].iter_mut().zip(DENSE) {
            *term = weighted_sum(weights, slopes).map(|sum| length * sum);
        }
        Self { start, end, start_state, end_state, terms }
    }

    /// A step of no length.
    pub(super) fn resting(time: f64, state: [f64; N]) -> Self {
        Self {
            start: time,
            end: time,
            start_state: state,
            end_state: state,
            terms: [[0.0; N]; COEFFICIENTS - 1],
        }
    }

    /// Time at which the step starts.
    pub fn start(&self) -> f64 {
        self.start
    }

    /// Time at which it ends; before its start where it goes backwards.
    pub fn end(&self) -> f64 {
        self.end
    }

    /// `end - start`, below zero where the step goes backwards.
    pub fn length(&self) -> f64 {
        self.end - self.start
    }

    /// The state at the start.
    pub fn start_state(&self) -> &[f64; N] {
        &self.start_state
    }

    /// The state at the end.
    pub fn end_state(&self) -> &[f64; N] {
        &self.end_state
    }

    /// The state at `time`, meant for times between start and end; the ends themselves are met to the last bit.
    pub fn value(&self, time: f64) -> [f64; N] {
        if time == self.start {
            return self.start_state;
        }
        if time == self.end {
            return self.end_state;
        }
        let part = (time - self.start) / self.length();
        let rest = 1.0 - part;
        let mut state = [0.0; N];
        for (n, term) in self.terms.iter().enumerate().rev() {
            let factor = if n % 2 == 0 { part } else { rest };
            for (value, coefficient) in state.iter_mut().zip(term) {
                *value = (*value + coefficient) * factor;
            }
        }
        for (value, start) in state.iter_mut().zip(&self.start_state) {
            *value += start;
        }
        state
    }

    /// Coefficients of coordinate `index`, below N, in powers of `s = t - start`: the number of power `s^n` is the
    /// n-th. Its range is `s` from 0 to [`DenseStep::length`]; for a step of no length only the first is not 0.
    pub fn component_coefficients(&self, index: usize) -> [f64; COEFFICIENTS] {
        let mut powers = [0.0; COEFFICIENTS];
        if self.length() == 0.0 {
            powers[0] = self.start_state[index];
            return powers;
        }
        for (n, term) in self.terms.iter().enumerate().rev() {
            powers[0] += term[index];
            // Times r, or times 1 - r.
            for power in (1..COEFFICIENTS).rev() {
                powers[power] =
                    if n % 2 == 0 { powers[power - 1] } else { powers[power] - powers[power - 1] };
            }
            if n % 2 == 0 {
                powers[0] = 0.0;
            }
        }
        powers[0] += self.start_state[index];
        let mut scale = 1.0;
        for power in &mut powers {
            *power *= scale;
            scale /= self.length();
        }
        powers
    }
}

/// Sum of the stages' slopes, each times its weight.
pub(super) fn weighted_sum<const N: usize>(weights: Weights, slopes: &[[f64; N]; STAGES]) -> [f64; N] {
    let mut sum = [0.0; N];
    for &(stage, weight) in weights {
        for (value, slope) in sum.iter_mut().zip(&slopes[stage]) {
            *value += weight * slope;
        }
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::roots::{derivative, polynomial_value};

    /// A step of length -0.5 with slopes that follow no rule at all.
    fn arbitrary() -> DenseStep<2> {
        let mut slopes = [[0.0; 2]; STAGES];
        for (stage, slope) in slopes.iter_mut().enumerate() {
            *slope = [(1.7 * stage as f64).sin(), (0.9 * stage as f64).cos()];
        }
        DenseStep::new((2.0, [0.3, -1.0]), (1.5, [0.1, 4.0]), &slopes)
    }

    #[test]
    fn powers_and_nested_form_are_the_same_polynomial() {
        let step = arbitrary();
        for index in 0..2 {
            let powers = step.component_coefficients(index);
            let size: f64 = powers.iter().rev().fold(0.0, |sum, c| 0.5 * sum + c.abs());
            for k in 0..=16 {
                let since = -0.5 * f64::from(k) / 16.0;
                let value = powers.iter().rev().fold(0.0, |sum, coefficient| sum * since + coefficient);
                let difference = value - step.value(2.0 + since)[index];
                assert!(difference.abs() <= 4.0 * f64::EPSILON * size, "{index} {k}: {difference:e}");
            }
        }
    }

    #[test]
    fn ends_are_met_in_value_and_slope() {
        let step = arbitrary();
        assert_eq!(step.value(2.0), [0.3, -1.0]);
        assert_eq!(step.value(1.5), [0.1, 4.0]);
        let powers = step.component_coefficients(0);
        assert!(powers[1].abs() < 1e-13, "the first stage's slope is sin(0)");
        let slopes = derivative(&powers);
        let end_slope = polynomial_value(&slopes, -0.5);
        assert!((end_slope - (1.7 * RESULT as f64).sin()).abs() < 1e-12);
    }

    #[test]
    fn a_step_of_no_length_stays_where_it_is() {
        let step = DenseStep::resting(3.0, [7.0]);
        assert_eq!(step.value(3.0), [7.0]);
        assert_eq!(step.component_coefficients(0), [7.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
    }
}
