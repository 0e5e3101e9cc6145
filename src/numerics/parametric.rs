//! Linear systems of second order under a pulsating stiffness of rank one, over half a period of it.
//!
//! ```text
//! x'' + C x' + K(t) x = 0,   C = diag(d) + z b b^T,   K = diag(s) + (1 + k0 cos Omega t) b b^T
//! ```
//!
//! Both matrices are symmetric and the stiffness is even about half a period, so that the monodromy is
//! M = S^-1 P^T S P with P = Phi(T/2) and S = [[C, I], [I, 0]], damped or not. P comes from Taylor series of order
//! 24 in equal steps; of the products of series only that of the scalar u = b.x with the cosine is needed.

use super::characteristic::Characteristic;
use crate::error::NumericsError;
use std::f64::consts::PI;

/// Order of the Taylor series.
const ORDER: usize = 24;
/// Greatest step, over the reciprocal of the fastest rate. A term of the series is then at most about
/// 3^24/24! = 5e-13 of the state were all of the motion at that rate; seen are errors near 1e-14.
const REACH: f64 = 3.0;
/// Terms of the cosine's series below this are left out.
const NEGLIGIBLE: f64 = 1e-18;
/// Bound of the last terms of a step relative to the state; where they are greater, more steps are taken. The terms left
/// out are smaller by another factor of about 8.
const LAST_TERMS: f64 = 4e-13;
/// By how much the number of steps then grows.
const MORE: f64 = 1.25;

/// The system: N coordinates, 2 N = L initial values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parametric<const N: usize, const L: usize> {
    /// The diagonal s of the stiffness.
    pub stiffness: [f64; N],
    /// The diagonal d of the damping.
    pub damping: [f64; N],
    /// The vector b.
    pub coupling: [f64; N],
    /// The factor z of the damping's part of rank one.
    pub mutual_damping: f64,
}

impl<const N: usize, const L: usize> Parametric<N, L> {
    /// The trace of C: the logarithm of det M is minus this times the period.
    pub fn damping_trace(&self) -> f64 {
        self.damping.iter().sum::<f64>() + self.mutual_damping * self.coupling_square()
    }

    fn coupling_square(&self) -> f64 {
        self.coupling.iter().map(|b| b * b).sum()
    }

    /// A bound of the rate at which solutions change at this depth k0 of the pulsation.
    fn fastest(&self, depth: f64) -> f64 {
        let greatest = |values: &[f64; N]| values.iter().fold(0.0_f64, |most, value| most.max(*value));
        let square = self.coupling_square();
        let decay = 0.5 * (greatest(&self.damping) + self.mutual_damping * square);
        let stiffness = greatest(&self.stiffness) + (1.0 + depth.abs()) * square;
        decay + (decay * decay + stiffness).sqrt()
    }

    /// Steps over half a period; a number that may be too great to be carried out.
    pub fn steps(&self, depth: f64, omega: f64) -> f64 {
        ((self.fastest(depth) + omega) * PI / (omega * REACH)).ceil()
    }

    /// The matrix Phi(T/2) by rows, the coordinates before their rates, in this number of steps; and the greatest of
    /// the last terms of the series, relative to the state.
    fn half(&self, depth: f64, omega: f64, steps: usize) -> ([[f64; L]; L], f64) {
        let h = PI / (omega * steps as f64);
        let (mut x, mut w) = ([[0.0; L]; N], [[0.0; L]; N]);
        for i in 0..N {
            x[i][i] = 1.0;
            w[i][N + i] = h;
        }
        let mut cosine = [0.0; ORDER];
        let mut terms = ORDER;
        let mut term = h * h * depth;
        for (n, value) in cosine.iter_mut().enumerate() {
            *value = term;
            if term.abs() < NEGLIGIBLE * h * h {
                terms = n.max(1);
                break;
            }
            term *= omega * h / (n + 1) as f64;
        }
        let reciprocal: [f64; ORDER] = std::array::from_fn(|n| 1.0 / (n + 1) as f64);
        let mut last = 0.0_f64;
        for step in 0..steps {
            let (sine, cos) = (PI * step as f64 / steps as f64).sin_cos();
            let mut pulsation = [0.0; ORDER];
            for n in 0..terms {
                pulsation[n] = cosine[n] * [cos, -sine, -cos, sine][n % 4];
            }
            last = last.max(self.step(h, &pulsation[..terms], &reciprocal, &mut x, &mut w));
        }
        let mut half = [[0.0; L]; L];
        for i in 0..N {
            half[i] = x[i];
            half[N + i] = w[i].map(|value| value / h);
        }
        (half, last)
    }

    /// One step of length h of the coordinates x and of w = h x', all columns at once. With X_n, W_n their
    /// coefficients times h^n and U = b.X:
    /// X_{n+1} = W_n/(n+1), W_{n+1} = -(h d W_n + h^2 s X_n + b (h z b.W_n + h^2 U_n + sum kappa_j U_{n-j}))/(n+1).
    fn step(
        &self,
        h: f64,
        pulsation: &[f64],
        reciprocal: &[f64; ORDER],
        x: &mut [[f64; L]; N],
        w: &mut [[f64; L]; N],
    ) -> f64 {
        let damping = self.damping.map(|d| -h * d);
        let stiffness = self.stiffness.map(|s| -h * h * s);
        let (mutual, mean) = (h * self.mutual_damping, h * h);
        let (mut x_n, mut w_n) = (*x, *w);
        let mut u = [[0.0; L]; ORDER + 1];
        let mut rate = [0.0; L];
        for i in 0..N {
            for lane in 0..L {
                u[0][lane] += self.coupling[i] * x_n[i][lane];
                rate[lane] += self.coupling[i] * w_n[i][lane];
            }
        }
        for n in 0..ORDER {
            let force = force(mutual, &rate, mean, &u, n, pulsation);
            let part = reciprocal[n];
            u[n + 1] = rate.map(|value| value * part);
            rate = [0.0; L];
            for i in 0..N {
                let (d, s, b) = (part * damping[i], part * stiffness[i], part * self.coupling[i]);
                for lane in 0..L {
                    let next = d * w_n[i][lane] + s * x_n[i][lane] - b * force[lane];
                    x_n[i][lane] = w_n[i][lane] * part;
                    w_n[i][lane] = next;
                    x[i][lane] += x_n[i][lane];
                    w[i][lane] += next;
                    rate[lane] += self.coupling[i] * next;
                }
            }
        }
        let (mut last, mut all) = ([0.0; L], [0.0; L]);
        for i in 0..N {
            for lane in 0..L {
                last[lane] += x_n[i][lane].abs() + w_n[i][lane].abs();
                all[lane] += x[i][lane].abs() + w[i][lane].abs();
            }
        }
        last.iter().sum::<f64>() / all.iter().sum::<f64>().max(f64::MIN_POSITIVE)
    }

    /// M = S^-1 P^T S P from P = Phi(T/2).
    fn whole_from_half(&self, half: &[[f64; L]; L]) -> [[f64; L]; L] {
        let damped = |rows: [&[f64; L]; N]| -> [[f64; L]; N] {
            let mut common = [0.0; L];
            for i in 0..N {
                for lane in 0..L {
                    common[lane] += self.coupling[i] * rows[i][lane];
                }
            }
            std::array::from_fn(|i| {
                std::array::from_fn(|lane| {
                    self.damping[i] * rows[i][lane] + self.mutual_damping * self.coupling[i] * common[lane]
                })
            })
        };
        // S P: the upper rows are C P_upper + P_lower, the lower ones P_upper.
        let mut s_p = [[0.0; L]; L];
        let upper = damped(std::array::from_fn(|i| &half[i]));
        for i in 0..N {
            for lane in 0..L {
                s_p[i][lane] = upper[i][lane] + half[N + i][lane];
            }
            s_p[N + i] = half[i];
        }
        let mut product = [[0.0; L]; L];
        for inner in 0..L {
            for row in 0..L {
                for lane in 0..L {
                    product[row][lane] += half[inner][row] * s_p[inner][lane];
                }
            }
        }
        // S^-1 = [[0, I], [I, -C]].
        let mut monodromy = [[0.0; L]; L];
        let lower = damped(std::array::from_fn(|i| &product[N + i]));
        for i in 0..N {
            monodromy[i] = product[N + i];
            for lane in 0..L {
                monodromy[N + i][lane] = product[i][lane] - lower[i][lane];
            }
        }
        monodromy
    }

    /// The monodromy matrix at this depth and frequency of the pulsation, by rows; `most` is the greatest number of
    /// steps that may be taken, `refinement` multiplies the number that is.
    ///
    /// # Errors
    /// [`NumericsError::TooManySteps`], [`NumericsError::NotFinite`] where the solutions outgrow the numbers.
    pub fn monodromy(
        &self,
        depth: f64,
        omega: f64,
        most: usize,
        refinement: f64,
    ) -> Result<[[f64; L]; L], NumericsError> {
        let mut steps = (self.steps(depth, omega) * refinement).ceil();
        loop {
            if steps.is_nan() || steps > most as f64 {
                return Err(NumericsError::TooManySteps { time: 0.0, steps: most });
            }
            let (half, last) = self.half(depth, omega, steps as usize);
            if half.iter().flatten().any(|value| !value.is_finite()) {
                return Err(NumericsError::NotFinite { time: PI / omega });
            }
            if last <= LAST_TERMS {
                return Ok(self.whole_from_half(&half));
            }
            steps = (MORE * steps).ceil().max(steps + 1.0);
        }
    }

    /// The characteristic polynomial of the monodromy matrix.
    ///
    /// # Errors
    /// As [`Parametric::monodromy`].
    pub fn characteristic(
        &self,
        depth: f64,
        omega: f64,
        most: usize,
        refinement: f64,
    ) -> Result<Characteristic, NumericsError> {
        let monodromy = self.monodromy(depth, omega, most, refinement)?;
        let determinant = (-2.0 * PI / omega * self.damping_trace()).exp();
        let characteristic = Characteristic::of(&monodromy, determinant);
        if characteristic.coefficients.iter().all(|value| value.is_finite()) {
            Ok(characteristic)
        } else {
            Err(NumericsError::NotFinite { time: 2.0 * PI / omega })
        }
    }
}

/// Coefficient n of the force h z b.W + h^2 U + the pulsation's product with U.
#[inline]
fn force<const L: usize>(
    mutual: f64,
    rate: &[f64; L],
    mean: f64,
    u: &[[f64; L]; ORDER + 1],
    n: usize,
    pulsation: &[f64],
) -> [f64; L] {
    // Two sums side by side, because each addition waits for the one before it.
    let (mut force, mut other) = ([0.0; L], [0.0; L]);
    let terms = pulsation.len().min(n + 1);
    let (pairs, rest) = pulsation[..terms].as_chunks::<2>();
    let (mut even, mut odd) = (n, n.wrapping_sub(1));
    for kappa in pairs {
        for lane in 0..L {
            force[lane] += kappa[0] * u[even][lane];
            other[lane] += kappa[1] * u[odd][lane];
        }
        even = even.wrapping_sub(2);
        odd = odd.wrapping_sub(2);
    }
    for kappa in rest {
        for lane in 0..L {
            force[lane] += kappa * u[even][lane];
        }
    }
    std::array::from_fn(|lane| (mutual * rate[lane] + mean * u[n][lane]) + (force[lane] + other[lane]))
}

#[cfg(test)]
mod tests {
    use super::*;

    const PAIR: Parametric<3, 6> = Parametric {
        stiffness: [3.1, 9.3, 0.0],
        damping: [0.04, 0.11, 0.0],
        coupling: [0.88, -1.2, 1.0],
        mutual_damping: 0.07,
    };

    #[test]
    fn without_pulsation_the_monodromy_is_that_of_the_damped_oscillator() {
        let (rate, square, period) = (0.15, 2.3_f64, 2.0 * PI / 0.9);
        let system =
            Parametric::<1, 2> { stiffness: [1.3], damping: [0.1], coupling: [1.0], mutual_damping: 0.2 };
        let found = system.monodromy(0.0, 0.9, 1000, 1.0).expect("computes");
        let omega = (square - rate * rate).sqrt();
        let (sine, cosine) = (omega * period).sin_cos();
        let decay = (-rate * period).exp();
        let expected = [
            [cosine + rate / omega * sine, sine / omega],
            [-square / omega * sine, cosine - rate / omega * sine],
        ];
        for (row, exact) in found.iter().flatten().zip(expected.iter().flatten()) {
            assert!((row - decay * exact).abs() < 1e-13, "{found:?}");
        }
    }

    #[test]
    fn the_determinant_is_liouvilles_and_finer_steps_change_nothing() {
        for (depth, omega) in [(0.0, 0.7), (0.6, 1.6), (1.0, 0.3), (0.9, 12.0)] {
            let found = PAIR.monodromy(depth, omega, 1000, 1.0).expect("computes");
            let finer = PAIR.monodromy(depth, omega, 1000, 3.0).expect("computes");
            let size = found.iter().flatten().fold(1.0_f64, |most, value| most.max(value.abs()));
            for (value, exact) in found.iter().flatten().zip(finer.iter().flatten()) {
                assert!((value - exact).abs() < 2e-13 * size, "{depth} {omega}: {value} {exact}");
            }
            let determinant = nalgebra::SMatrix::<f64, 6, 6>::from_fn(|i, j| found[i][j]).determinant();
            let exact = (-2.0 * PI / omega * PAIR.damping_trace()).exp();
            assert!((determinant - exact).abs() < 1e-12 * size.powi(3), "{determinant} {exact}");
        }
    }

    #[test]
    fn a_change_of_sign_of_the_depth_leaves_the_polynomial() {
        let [one, other] =
            [0.8, -0.8].map(|depth| PAIR.characteristic(depth, 1.1, 1000, 1.0).expect("computes"));
        for (left, right) in one.coefficients.iter().zip(&other.coefficients) {
            assert!((left - right).abs() < 1e-12, "{one:?} {other:?}");
        }
    }

    #[test]
    fn too_many_steps_and_numbers_beyond_all_are_refused() {
        let many = PAIR.monodromy(0.5, 0.01, 100, 1.0);
        assert!(matches!(many, Err(NumericsError::TooManySteps { steps: 100, .. })), "{many:?}");
        // Negative stiffness: growth by exp(30 * 2 pi / 0.1).
        let system =
            Parametric::<1, 2> { stiffness: [-900.0], damping: [0.0], coupling: [1.0], mutual_damping: 0.0 };
        let grown = system.monodromy(0.0, 0.1, 1_000_000, 1.0);
        assert!(grown.is_err(), "{grown:?}");
    }
}
