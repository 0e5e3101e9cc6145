//! Newton's method for a map of six numbers with its exact Jacobian, damped where the full step does not help.

use nalgebra::{SMatrix, SVector};

use crate::error::NumericsError;

/// A residual and its Jacobian at a point.
pub struct Linearised {
    /// The residual.
    pub residual: SVector<f64, 6>,
    /// Its derivative.
    pub jacobian: SMatrix<f64, 6, 6>,
}

/// What Newton's method came to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solution {
    /// The root.
    pub point: [f64; 6],
    /// Largest component of the residual there.
    pub residual: f64,
    /// Iterations done.
    pub iterations: usize,
}

/// Bounds of Newton's method.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// Largest component of the residual, relative to 1 + the largest coordinate, at which the iteration may stop.
    pub tolerance: f64,
    /// Greatest number of iterations.
    pub iterations: usize,
}

impl Default for Options {
    fn default() -> Self {
        Self { tolerance: 1e-11, iterations: 40 }
    }
}

/// Finds a root of `map` near `start`.
///
/// `map` may fail (a trial point whose motion escapes); the step is then halved, as it is where the residual does
/// not fall. Once within the tolerance it goes on as long as the residual still falls to less than half: the last,
/// quadratic steps cost little and give full accuracy.
///
/// # Errors
/// [`NumericsError::Singular`] or [`NumericsError::NoConvergence`]; an error of `map` at `start` itself.
pub fn solve(
    start: [f64; 6],
    options: Options,
    mut map: impl FnMut(&[f64; 6]) -> Result<Linearised, NumericsError>,
) -> Result<Solution, NumericsError> {
    let mut point = SVector::<f64, 6>::from(start);
    let mut here = map(&start)?;
    for iteration in 0..options.iterations {
        let size = here.residual.amax();
        let within = size <= options.tolerance * (1.0 + point.amax());
        let Some(step) = here.jacobian.lu().solve(&here.residual) else {
            if within {
                return Ok(Solution { point: point.into(), residual: size, iterations: iteration });
            }
            return Err(NumericsError::Singular);
        };
        let mut damping = 1.0;
        let accepted = loop {
            let trial = point - step * damping;
            let at_trial =
                map(&trial.into()).ok().filter(|there| there.residual.iter().all(|r| r.is_finite()));
            if let Some(there) = at_trial
                && there.residual.amax() < size * (1.0 - 0.1 * damping)
            {
                break Some((trial, there));
            }
            damping *= 0.5;
            if within || damping < 1e-4 {
                break None;
            }
        };
        match accepted {
            Some((trial, there)) => {
                let done = within && there.residual.amax() > 0.5 * size;
                point = trial;
                here = there;
                if done {
                    break;
                }
            }
            None => break,
        }
    }
    let residual = here.residual.amax();
    if residual <= options.tolerance * (1.0 + point.amax()) {
        Ok(Solution { point: point.into(), residual, iterations: options.iterations })
    } else {
        Err(NumericsError::NoConvergence {
            iterations: options.iterations,
            residual,
            tolerance: options.tolerance,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cubic(target: f64) -> impl FnMut(&[f64; 6]) -> Result<Linearised, NumericsError> {
        move |x| {
            Ok(Linearised {
                residual: SVector::from_fn(|i, _| x[i].powi(3) + (i as f64) * x[i] - target),
                jacobian: SMatrix::from_fn(|i, j| if i == j { 3.0 * x[i] * x[i] + i as f64 } else { 0.0 }),
            })
        }
    }

    #[test]
    fn finds_roots_to_rounding() {
        let solution = solve([1.0; 6], Options::default(), cubic(2.0)).expect("converges");
        assert!((solution.point[0] - 2.0_f64.cbrt()).abs() < 1e-15);
        assert!(solution.residual < 1e-14);
    }

    #[test]
    fn says_how_far_it_came_where_there_is_no_root() {
        let no_root = |x: &[f64; 6]| {
            Ok(Linearised {
                residual: SVector::from_fn(|i, _| x[i] * x[i] + 1.0),
                jacobian: SMatrix::from_fn(|i, j| if i == j { 2.0 * x[i] } else { 0.0 }),
            })
        };
        match solve([3.0; 6], Options::default(), no_root) {
            Err(NumericsError::NoConvergence { residual, .. }) => assert!(residual >= 1.0),
            other => panic!("{other:?}"),
        }
    }
}
