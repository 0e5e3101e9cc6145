//! Periodic orbits whose multipliers are large, by multiple shooting: the period is parted, the states at all parts are
//! unknowns together, and no motion is followed so long that a small change of its start grows beyond bounds.
//!
//! Source: J. Stoer, R. Bulirsch, Introduction to Numerical Analysis, 3rd ed. (Springer 2002), section 7.3.5. The linear
//! system is eliminated as a whole with pivoting, not condensed: condensing brings back what single shooting suffers from.

use super::elimination::Factors;
use super::newton::Options;
use super::periodic::Image;
use crate::error::NumericsError;

/// Largest entry of the derivative over a period beyond which one shot over it is given up for several.
pub const STEEP: f64 = 1e4;
/// Growth over a part that parts are chosen for.
const GROWTH: f64 = 30.0;
/// Most parts.
const MOST: usize = 64;

/// An orbit as its states at equally spaced times.
#[derive(Clone, Debug, PartialEq)]
pub struct Nodes {
    /// The states.
    pub states: Vec<[f64; 6]>,
    /// Largest component by which a part misses the start of the next.
    pub residual: f64,
    /// Iterations done.
    pub iterations: usize,
}

/// The number of parts, a multiple of `periods`, for a derivative of this largest entry; at least two.
pub fn parts(periods: usize, entry: f64) -> usize {
    let wished = (entry.max(1.0).ln() / GROWTH.ln()).ceil().max(2.0) as usize;
    let each = wished.div_ceil(periods).min((MOST / periods).max(1));
    if each * periods == 1 { 2 } else { each * periods }
}

/// Carries a state over the part of an index.
pub type Part<'a> = dyn FnMut(usize, &[f64; 6]) -> Result<Image, NumericsError> + 'a;

/// Finds the periodic orbit near these states; `map` carries a state over the part of an index.
///
/// # Errors
/// [`NumericsError::NoConvergence`] with the residual, [`NumericsError::Singular`], or an error of `map` at the start.
pub fn solve(start: Vec<[f64; 6]>, options: Options, map: &mut Part<'_>) -> Result<Nodes, NumericsError> {
    let mut states = start;
    let mut here = linearised(&states, map)?;
    let mut last = residual(&here);
    for iteration in 0..options.iterations {
        let size = states.iter().flatten().fold(1.0_f64, |most, value| most.max(value.abs()));
        let within = last <= options.tolerance * size;
        let step = newton_step(&here)?;
        let mut damping = 1.0;
        let accepted = loop {
            let trial: Vec<[f64; 6]> = states
                .iter()
                .zip(&step)
                .map(|(state, step)| std::array::from_fn(|i| state[i] - damping * step[i]))
                .collect();
            if let Ok(there) = linearised(&trial, map) {
                let missed = residual(&there);
                if missed < last * (1.0 - 0.1 * damping) {
                    break Some((trial, there, missed));
                }
            }
            damping *= 0.5;
            if within || damping < 1e-4 {
                break None;
            }
        };
        let Some((trial, there, missed)) = accepted else {
            if within {
                return Ok(Nodes { states, residual: last, iterations: iteration });
            }
            break;
        };
        (states, here) = (trial, there);
        let done = within && missed > 0.5 * last;
        last = missed;
        if done {
            return Ok(Nodes { states, residual: last, iterations: iteration + 1 });
        }
    }
    Err(NumericsError::NoConvergence {
        iterations: options.iterations,
        residual: last,
        tolerance: options.tolerance,
    })
}

/// By how much each part misses the start of the next, with its derivative.
fn linearised(states: &[[f64; 6]], map: &mut Part<'_>) -> Result<Vec<Image>, NumericsError> {
    let mut all = Vec::with_capacity(states.len());
    for (part, state) in states.iter().enumerate() {
        let (image, derivative) = map(part, state)?;
        let next = &states[(part + 1) % states.len()];
        let missed: [f64; 6] = std::array::from_fn(|i| image[i] - next[i]);
        if missed.iter().chain(derivative.iter().flatten()).any(|value| !value.is_finite()) {
            return Err(NumericsError::NotFinite { time: 0.0 });
        }
        all.push((missed, derivative));
    }
    Ok(all)
}

fn residual(parts: &[Image]) -> f64 {
    parts.iter().flat_map(|(missed, _)| missed).fold(0.0, |most, value| most.max(value.abs()))
}

/// What is to be taken off the states.
fn newton_step(parts: &[Image]) -> Result<Vec<[f64; 6]>, NumericsError> {
    let count = parts.len();
    let size = 6 * count;
    let mut rows = vec![0.0; size * size];
    let mut right = Vec::with_capacity(size);
    for (part, (missed, derivative)) in parts.iter().enumerate() {
        let next = (part + 1) % count;
        for i in 0..6 {
            let row = &mut rows[(6 * part + i) * size..(6 * part + i + 1) * size];
            row[6 * part..6 * part + 6].copy_from_slice(&derivative[i]);
            row[6 * next + i] -= 1.0;
        }
        right.extend_from_slice(missed);
    }
    Factors::new(size, rows)?.solve(&mut right);
    Ok(right.chunks_exact(6).map(|six| std::array::from_fn(|i| six[i])).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Three independent saddles whose multipliers multiply to 1e12 over four parts, slightly bent.
    #[allow(clippy::unnecessary_wraps, reason = "as a map is")]
    fn bent(part: usize, state: &[f64; 6]) -> Result<Image, NumericsError> {
        let shift = (part as f64).cos();
        let mut derivative = [[0.0; 6]; 6];
        let mut image = [0.0; 6];
        for i in 0..6 {
            let rate = if i < 3 { 1e3 } else { 1e-3 };
            image[i] = rate * state[i] + 0.3 * state[i] * state[i] + shift;
            derivative[i][i] = rate + 0.6 * state[i];
        }
        Ok((image, derivative))
    }

    #[test]
    fn orbits_of_multipliers_of_1e12_are_found_to_rounding() {
        let nodes = solve(vec![[0.2; 6]; 4], Options::default(), &mut bent).expect("converges");
        for (part, state) in nodes.states.iter().enumerate() {
            let (image, _) = bent(part, state).expect("a map");
            let next = nodes.states[(part + 1) % 4];
            assert!((0..6).all(|i| (image[i] - next[i]).abs() < 1e-11), "{part}");
        }
    }

    #[test]
    fn steeper_orbits_are_parted_more_often_and_whole_periods_evenly() {
        assert_eq!(parts(1, 1.0), 2);
        assert_eq!(parts(2, 1e6), 6);
        assert_eq!(parts(3, 1e4), 3);
        assert!(parts(64, 1e300) == 64 && parts(1, 1e300) == 64);
    }
}
