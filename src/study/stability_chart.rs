//! The stability chart: spectral radius over the mesh frequency and the depth of the pulsation.
//!
//! The coefficients of the characteristic polynomial are entire functions of the period T and of k0^2 (a change of sign
//! of k0 shifts the mesh phase by half a period). They are computed on Chebyshev nodes, as many as their decay asks for,
//! interpolated onto the chart, and factorised along k0, each point from its neighbour.

use super::grid::Grid;
use super::linear_floquet::{LinearFloquet, factorise};
use super::motion;
use super::multipliers::linear_spectrum;
use crate::error::{NumericsError, StudyError};
use crate::model::parameters::Parameters;
use crate::numerics::characteristic::{self, Characteristic, Factors, Top};
use crate::numerics::chebyshev;
use std::f64::consts::PI;

/// The largest modulus of the six multipliers over a plane.
#[derive(Clone, Debug, PartialEq)]
pub struct StabilityChart {
    /// Mesh frequencies.
    pub omega: Grid,
    /// Depths of the pulsation.
    pub k0: Grid,
    /// Largest modulus of a multiplier over one period of the motion, index `i_k0 * omega.count + i_omega`; infinite
    /// where no periodic response was found that it could be about.
    pub spectral_radius: Vec<f64>,
    /// Bound of the error of every finite value, absolute: from the decay of the coefficients, how far they amplify
    /// errors, and points computed directly.
    pub error: f64,
    /// How it was computed.
    pub method: String,
}

/// Most steps of all integrations of a chart: some seconds.
const MOST_CHART_STEPS: f64 = 8e5;
/// Most steps spent on points whose polynomial is computed anew.
const MOST_DIRECT_STEPS: f64 = 1e4;
/// Coefficients of the polynomial are wanted at most this well: near what the series of the integration leave out.
const FINEST: f64 = 1e-13;
/// The coefficients seen to be left out may be this many times what is wanted: they are the last of a steep decay, and
/// what follows them is smaller still.
const ENOUGH: f64 = 20.0;
/// What rounding leaves of coefficients, relative to the greatest.
const ROUNDING: f64 = 1e-14;
/// An error this many times that is too great to be it.
const MANY: f64 = 100.0;
/// Error of a radius over the accuracy of the factors where nothing amplifies it: somewhat more than was ever seen.
const LEFT: f64 = 25.0;
/// Terms this much below the error are left out.
const NEGLIGIBLE: f64 = 1e-3;
/// Points computed directly, for comparison.
const SPOT_CHECKS: usize = 8;
/// Terms in k0^2 that are tried first.
const FEWEST: usize = 12;
/// Nodes beyond which interpolation is not tried.
const MOST_NODES: usize = 400;
/// Greatest exponent by which decay is taken off the multipliers.
const MOST_DECAY: f64 = 50.0;

/// Refuses grids that cannot be charted.
///
/// # Errors
/// [`StudyError::Option`].
pub fn check_plane(omega: Grid, k0: Grid) -> Result<(), StudyError> {
    Grid::new("Omega", [omega.low, omega.high], omega.count, [1e-3, 1e3])?;
    Grid::new("k0", [k0.low, k0.high], k0.count, [0.0, 1.0])?;
    Ok(())
}

/// The chart of the linear problem about the trivial state; `tolerance` is of the spectral radius, absolute.
///
/// Where multipliers meet, the radius depends on the coefficients as a square root, and its error can exceed a tolerance
/// below about 1e-6: `error` says what was reached.
///
/// # Errors
/// [`StudyError::Option`] for grids or tolerances out of range, [`StudyError::Numerics`] where stiff or slow systems
/// would take more than some seconds.
pub fn stability_chart(
    p: &Parameters,
    omega: Grid,
    k0: Grid,
    tolerance: f64,
) -> Result<StabilityChart, StudyError> {
    check_plane(omega, k0)?;
    motion::check_tolerance(tolerance)?;
    let linear = LinearFloquet::new(p);
    let finest = (3e-5 * tolerance).clamp(FINEST, 1e-10);
    let surface = Surface::fit(&linear, omega, k0, finest)?;
    checked(p, &linear, &surface, tolerance)
}

/// The chart from interpolated coefficients, if direct computation does not contradict it.
fn checked(
    p: &Parameters,
    linear: &LinearFloquet,
    surface: &Surface,
    tolerance: f64,
) -> Result<StabilityChart, StudyError> {
    let [omega, k0] = surface.grids;
    let mut chart = surface.factorised(linear, tolerance)?;
    let mut seen = spot_checks(p, omega, k0, &chart.radius)?;
    let mut method = "Chebyshev interpolation of the characteristic polynomial, Taylor series of order 24 on half a period";
    if seen > tolerance.max(chart.error) {
        // What the decay promised does not hold: every point by itself.
        chart = Surface::sample(linear, omega, k0, None, None)?.factorised(linear, tolerance)?;
        seen = spot_checks(p, omega, k0, &chart.radius)?;
        method = "characteristic polynomial at every point, Taylor series of order 24 on half a period";
    }
    Ok(StabilityChart {
        omega,
        k0,
        spectral_radius: chart.radius,
        error: chart.error.max(2.0 * seen),
        method: method.into(),
    })
}

/// The largest difference from multipliers computed directly, at points spread over the chart.
fn spot_checks(p: &Parameters, omega: Grid, k0: Grid, radius: &[f64]) -> Result<f64, StudyError> {
    let mut worst = 0.0_f64;
    for check in 0..SPOT_CHECKS {
        // Multiples of the golden ratio, and of the square root of two, are spread evenly.
        let part = |ratio: f64, count: usize| {
            ((((check as f64 + 0.5) * ratio).fract() * count as f64) as usize).min(count - 1)
        };
        let (i, j) = (part(0.618_033_988_749_895, omega.count), part(0.414_213_562_373_095, k0.count));
        let value = radius[j * omega.count + i];
        worst = worst.max((direct_radius(p, omega.value(i), k0.value(j))? - value).abs());
    }
    Ok(worst)
}

/// The spectral radius from the whole monodromy matrix by other code than the chart's.
fn direct_radius(p: &Parameters, omega: f64, k0: f64) -> Result<f64, NumericsError> {
    let here = Parameters { k0, omega, ..*p };
    Ok(linear_spectrum(&here, 1e-14)?.radius())
}

/// Interpolated coefficients c_1 to c_{n-1} of the characteristic polynomial over the chart; c_n is known exactly.
///
/// They are those of exp(decay T) times the multipliers, of which the greatest is near 1 whatever the damping.
struct Surface {
    /// Omega and k0.
    grids: [Grid; 2],
    /// Coefficients a row: 3 or 5.
    width: usize,
    /// Terms in k0^2, or depths, of each.
    terms: usize,
    /// `[i_omega][coefficient][term]`.
    values: Vec<f64>,
    /// `[term][i_k0]`; none where the terms are the values on the chart's own k0.
    basis: Option<Vec<f64>>,
    /// Error of the coefficients, absolute.
    error: f64,
    /// The greatest coefficient.
    scale: f64,
    /// Decay taken off.
    decay: f64,
}

struct Factorised {
    radius: Vec<f64>,
    error: f64,
}

/// The characteristic polynomial of exp(decay T) times the multipliers.
fn polynomial(
    linear: &LinearFloquet,
    omega: f64,
    k0: f64,
    decay: f64,
) -> Result<Characteristic, NumericsError> {
    let mut found = linear.characteristic(omega, k0)?;
    let growth = (decay * 2.0 * PI / omega).exp();
    let mut power = 1.0;
    for coefficient in &mut found.coefficients[..found.degree] {
        power *= growth;
        *coefficient *= power;
    }
    Ok(found)
}

fn too_much_work(steps: f64) -> StudyError {
    NumericsError::TooManySteps { time: 0.0, steps: steps.min(1e15) as usize }.into()
}

impl Surface {
    /// As many nodes as the decay asks for in each direction, or the chart's own points where these are fewer.
    fn fit(linear: &LinearFloquet, omega: Grid, k0: Grid, finest: f64) -> Result<Self, StudyError> {
        let (long, short) = (2.0 * PI / omega.low, 2.0 * PI / omega.high);
        let turns: f64 = linear.frequencies().iter().sum::<f64>() * 0.5 * (long - short);
        // The coefficients turn as exp(i turns x): their Chebyshev coefficients are Bessel functions of `turns`.
        let mut nodes = (turns + 5.5 * turns.cbrt() + 8.0 + 0.06 * k0.high * turns).ceil();
        while nodes < omega.count.min(MOST_NODES) as f64 {
            let fitted = Self::sample(linear, omega, k0, Some(nodes as usize), Some(finest))?;
            if fitted.error <= (ENOUGH * finest).max(MANY * ROUNDING * fitted.scale) {
                return Ok(fitted);
            }
            nodes = (1.2 * nodes + 4.0).ceil();
        }
        Self::sample(linear, omega, k0, None, Some(finest))
    }

    /// The coefficients from this many nodes in the period, or at every mesh frequency; in k0^2 from as many as make
    /// them as fine as wanted, or at every depth.
    fn sample(
        linear: &LinearFloquet,
        omega: Grid,
        k0: Grid,
        nodes: Option<usize>,
        finest: Option<f64>,
    ) -> Result<Self, StudyError> {
        let width = 2 * linear.modes() - 1;
        let (long, short) = (2.0 * PI / omega.low, 2.0 * PI / omega.high);
        let decay = (-linear.at_rest()?.abscissa()).min(MOST_DECAY / long);
        // From the longest period, which asks for most terms, to the shortest.
        let frequencies: Vec<f64> = match nodes {
            Some(count) => chebyshev::nodes(short, long, count).iter().map(|t| 2.0 * PI / t).collect(),
            None => (0..omega.count).map(|i| omega.value(i)).collect(),
        };
        let grid: Vec<f64> = (0..k0.count).map(|j| k0.value(j)).collect();
        let mut interpolates = finest.is_some() && FEWEST < k0.count;
        let mut count = if interpolates { FEWEST } else { k0.count };
        let (mut error, mut work) = (0.0_f64, 0.0);
        let mut scale = 1.0_f64;
        let mut rows: Vec<Vec<f64>> = Vec::with_capacity(frequencies.len());
        for at in &frequencies {
            loop {
                work += linear.steps(*at, k0.high) * count as f64;
                if work.is_nan() || work > MOST_CHART_STEPS {
                    return Err(too_much_work(work));
                }
                let mut samples = Vec::with_capacity(width * count);
                let nodes_in_depth = if interpolates { depths(k0, count) } else { grid.clone() };
                for depth in &nodes_in_depth {
                    let found = polynomial(linear, *at, *depth, decay)?;
                    samples.extend_from_slice(&found.coefficients[..width]);
                }
                scale = scale.max(largest(&samples));
                if !interpolates {
                    rows.push(samples);
                    break;
                }
                let coefficients = chebyshev::coefficients(&samples, width);
                let tail = chebyshev::tail(&coefficients, width);
                let limit = finest.unwrap_or(0.0).max(ROUNDING * scale);
                if tail <= limit || !rows.is_empty() && count >= k0.count {
                    error = error.max(tail);
                    // The next one needs no more than those that count and two to see it by.
                    let used = coefficients.chunks(width).rposition(|row| largest(row) > limit);
                    count = count.min(used.map_or(1, |last| last + 1) + 2);
                    rows.push(coefficients);
                    break;
                }
                count = (count * 4).div_ceil(3).min(k0.count);
                if rows.is_empty() && count == k0.count {
                    interpolates = false;
                }
            }
        }
        error += ROUNDING.max(linear.truncation()) * scale;
        let per_row = rows.iter().map(Vec::len).max().unwrap_or(0) / width;
        let terms = width * per_row;
        let mut values = vec![0.0; rows.len() * terms];
        for (row, numbers) in values.chunks_exact_mut(terms).zip(&rows) {
            for (index, value) in numbers.iter().enumerate() {
                row[index % width * per_row + index / width] = *value;
            }
        }
        if let Some(count) = nodes {
            let in_period = chebyshev::coefficients(&values, terms);
            error += chebyshev::tail(&in_period, terms);
            values = vec![0.0; omega.count * terms];
            for (i, row) in values.chunks_exact_mut(terms).enumerate() {
                let basis = chebyshev::polynomials(short, long, 2.0 * PI / omega.value(i), count);
                for (weight, coefficients) in basis.iter().zip(in_period.chunks_exact(terms)) {
                    for (sum, value) in row.iter_mut().zip(coefficients) {
                        *sum += weight * value;
                    }
                }
            }
        }
        let basis = interpolates.then(|| {
            let mut basis = vec![0.0; per_row * k0.count];
            for j in 0..k0.count {
                let square = k0.value(j) * k0.value(j);
                let here = chebyshev::polynomials(k0.low * k0.low, k0.high * k0.high, square, per_row);
                for (term, value) in here.into_iter().enumerate() {
                    basis[term * k0.count + j] = value;
                }
            }
            basis
        });
        Ok(Self { grids: [omega, k0], width, terms: per_row, values, basis, error, scale, decay })
    }

    /// The radius at every point, each column of the chart from k0 = 0 upwards.
    fn factorised(&self, linear: &LinearFloquet, tolerance: f64) -> Result<Factorised, StudyError> {
        let [omega, k0] = self.grids;
        let accuracy = (1e-4 * tolerance).max(characteristic::ROUNDING);
        let refined = linear.refined();
        let mut left = MOST_DIRECT_STEPS;
        let mut radius = vec![0.0; omega.count * k0.count];
        let at_rest = linear.at_rest()?.shifted(self.decay);
        let mut error = LEFT * accuracy;
        let mut columns = vec![0.0; self.width * k0.count];
        let degree = self.width + 1;
        for (i, values) in self.values.chunks_exact(self.width * self.terms).enumerate() {
            let at = omega.value(i);
            let period = 2.0 * PI / at;
            self.expand(values, &mut columns, k0.count);
            let idle = linear.idle_radius(at);
            let decayed = (-self.decay * period).exp();
            let mut of = Characteristic { degree, coefficients: [0.0; 6] };
            of.coefficients[self.width] =
                ((degree as f64 * self.decay - linear.damping_trace()) * period).exp();
            // The last three rows' factors, the newest first, as far as they continue each other.
            let mut rows = [at_rest.propagated(period); 3];
            let mut continued = usize::from(finite(&rows[0]));
            for j in 0..k0.count {
                for k in 0..self.width {
                    of.coefficients[k] = columns[k * k0.count + j];
                }
                let guess = if continued > 3 { rows[0].extrapolated(&rows[1], &rows[2]) } else { rows[0] };
                let (mut factors, mut top) =
                    continue_from(guess, continued > 0, &of, accuracy, &mut continued)?;
                let mut bound = decayed * conditioned(&top, degree, self.error);
                if bound > tolerance && left > 0.0 {
                    left -= 2.0 * linear.steps(at, k0.value(j));
                    let direct = polynomial(&refined, at, k0.value(j), self.decay)?;
                    (factors, top) =
                        continue_from(factors, true, &direct, characteristic::ROUNDING, &mut continued)?;
                    let fine = refined.truncation() * largest(&direct.coefficients).max(1.0);
                    bound = decayed * conditioned(&top, degree, fine);
                }
                error = error.max(bound);
                radius[j * omega.count + i] = (decayed * top.radius).max(idle);
                rows = [factors, rows[0], rows[1]];
            }
        }
        Ok(Factorised { radius, error })
    }

    /// The coefficients on the chart's own k0, one run of them for each coefficient.
    fn expand(&self, values: &[f64], columns: &mut [f64], count: usize) {
        let Some(basis) = &self.basis else {
            columns.copy_from_slice(values);
            return;
        };
        for (column, terms) in columns.chunks_exact_mut(count).zip(values.chunks_exact(self.terms)) {
            column.fill(0.0);
            for (value, polynomial) in terms.iter().zip(basis.chunks_exact(count)) {
                // Short periods have few terms.
                if value.abs() < NEGLIGIBLE * self.error {
                    continue;
                }
                for (sum, basis) in column.iter_mut().zip(polynomial) {
                    *sum += value * basis;
                }
            }
        }
    }
}

fn finite(factors: &Factors) -> bool {
    factors.p.iter().chain(&factors.q).all(|value| value.is_finite())
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, value| most.max(value.abs()))
}

/// Chebyshev nodes in k0^2.
fn depths(k0: Grid, count: usize) -> Vec<f64> {
    chebyshev::nodes(k0.low * k0.low, k0.high * k0.high, count)
        .iter()
        .map(|square| square.max(0.0).sqrt())
        .collect()
}

/// Factors and greatest root of a polynomial: from a guess, or else from nothing, and then the rows start to be counted
/// anew.
fn continue_from(
    mut guess: Factors,
    trusted: bool,
    of: &Characteristic,
    accuracy: f64,
    continued: &mut usize,
) -> Result<(Factors, Top), NumericsError> {
    *continued += 1;
    if trusted && let Some(top) = guess.refine(of, accuracy) {
        return Ok((guess, top));
    }
    *continued = 1;
    factorise(of, accuracy)
}

/// How far errors of the coefficients can move the greatest root: divided by the polynomial's slope there, or the square
/// root where roots meet.
pub(super) fn conditioned(top: &Top, degree: usize, error: f64) -> f64 {
    let mut change = 0.0;
    for _ in 1..degree {
        change = (change + error) * top.radius;
    }
    (change * change / top.slope_square).min(16.0 * change).sqrt()
}

/// A tongue seen on a chart.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SeenTongue {
    /// A mesh frequency well inside it at `k0`: a start for [`Tongue::Near`](super::tongue::Tongue::Near).
    pub omega: f64,
    /// The depth at which it is that frequency.
    pub k0: f64,
    /// The least depth at which the chart shows it.
    pub lowest: f64,
}

/// How far beyond 1, and beyond the chart's own error, a radius counts as unstable here.
const SEEN: f64 = 1e-5;

/// The tongues that a chart shows: unstable intervals of a row above none in the row below, each followed upwards to the
/// last row in which it is an interval of its own.
///
/// Tongues narrower than the chart's columns may be missed, and one that starts narrower than them may be seen late.
pub fn tongues_in(chart: &StabilityChart) -> Vec<SeenTongue> {
    let (columns, rows) = (chart.omega.count, chart.k0.count);
    let limit = 1.0 + SEEN.max(2.0 * chart.error);
    let mut seen: Vec<SeenTongue> = Vec::new();
    // Intervals of the row below: first and last column, and the tongue it belongs to.
    let mut below: Vec<(usize, usize, usize)> = Vec::new();
    for j in 0..rows {
        let row = &chart.spectral_radius[j * columns..(j + 1) * columns];
        let unstable = |i: usize| row[i].is_finite() && row[i] > limit;
        let mut intervals = Vec::new();
        let mut i = 0;
        while i < columns {
            if !unstable(i) {
                i += 1;
                continue;
            }
            let first = i;
            while i < columns && unstable(i) {
                i += 1;
            }
            let last = i - 1;
            // Neighbouring columns count: a narrow tongue leans to one side from row to row.
            let mut parents = below
                .iter()
                .filter(|(start, end, _)| *start <= last + 1 && first <= end + 1)
                .map(|own| own.2);
            let (parent, second) = (parents.next(), parents.next());
            let tongue = parent.unwrap_or_else(|| {
                let k0 = chart.k0.value(j);
                seen.push(SeenTongue { omega: chart.omega.value(first), k0, lowest: k0 });
                seen.len() - 1
            });
            if second.is_none() {
                let deepest = (first..=last).fold(first, |best, i| if row[i] > row[best] { i } else { best });
                (seen[tongue].omega, seen[tongue].k0) = (chart.omega.value(deepest), chart.k0.value(j));
            }
            intervals.push((first, last, tongue));
        }
        below = intervals;
    }
    seen
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plane() -> [Grid; 2] {
        [Grid { low: 0.5, high: 6.0, count: 120 }, Grid { low: 0.0, high: 1.0, count: 40 }]
    }

    #[test]
    fn coefficients_that_promise_what_they_do_not_hold_are_found_out() {
        let p = Parameters { zeta: 0.02, ..Parameters::default() };
        let [omega, k0] = plane();
        let linear = LinearFloquet::new(&p);
        let mut surface = Surface::fit(&linear, omega, k0, 3e-11).expect("fits");
        let sound = checked(&p, &linear, &surface, 1e-6).expect("computes");
        assert!(sound.method.starts_with("Chebyshev") && sound.error < 1e-6, "{sound:?}");
        for value in &mut surface.values {
            *value *= 1.001;
        }
        let direct = checked(&p, &linear, &surface, 1e-6).expect("computes");
        assert!(direct.method.contains("at every point") && direct.error < 1e-6, "{}", direct.method);
        for (left, right) in direct.spectral_radius.iter().zip(&sound.spectral_radius) {
            assert!((left - right).abs() <= direct.error + sound.error);
        }
    }

    #[test]
    fn points_whose_bound_is_too_great_are_computed_anew() {
        let p = Parameters { zeta: 0.02, m_p: 1.3, ..Parameters::default() };
        let [omega, k0] = plane();
        let linear = LinearFloquet::new(&p);
        let mut surface = Surface::fit(&linear, omega, k0, 3e-11).expect("fits");
        let sound = surface.factorised(&linear, 1e-6).expect("computes");
        // Coarse coefficients that say so: refused wherever the steps allowed reach.
        for value in &mut surface.values {
            *value *= 1.0 + 1e-6;
        }
        surface.error = 1e-4;
        let anew = surface.factorised(&linear, 1e-6).expect("computes");
        // Columns of long periods come first.
        for j in 0..k0.count {
            let index = j * omega.count;
            assert!((anew.radius[index] - sound.radius[index]).abs() < 1e-9);
        }
        assert!(anew.error > 1e-6, "not all of them");
    }

    #[test]
    fn too_few_nodes_are_seen_by_their_tail_and_small_charts_are_computed_at_their_points() {
        let p = Parameters { zeta: 0.02, ..Parameters::default() };
        let [omega, k0] = plane();
        let linear = LinearFloquet::new(&p);
        let few = Surface::sample(&linear, omega, k0, Some(20), Some(3e-11)).expect("computes");
        assert!(few.error > 1e-3, "{}", few.error);
        let small = Grid { count: 9, ..omega };
        let at_points = Surface::fit(&linear, small, Grid { count: 6, ..k0 }, 3e-11).expect("computes");
        assert!(at_points.basis.is_none() && at_points.terms == 6);
    }
}
