//! The stability chart: spectral radius over the mesh frequency and the depth of the pulsation.
//!
//! The coefficients of the characteristic polynomial are entire functions of the period T and of k0^2 (a change of sign
//! of k0 shifts the mesh phase by half a period). They are computed on Chebyshev nodes, as many as their decay asks for,
//! interpolated onto the chart, and factorised along k0, each point from its neighbour.

use super::grid::Grid;
use super::linear_floquet::{LinearFloquet, factorise};
use super::motion;
use super::multipliers::linear_monodromy;
use crate::error::{NumericsError, StudyError};
use crate::model::parameters::Parameters;
use crate::numerics::characteristic::{self, Characteristic, Factors};
use crate::numerics::periodic::matrix;
use crate::numerics::{chebyshev, floquet};
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
/// Coefficients of the polynomial are wanted at least this well, relative to the greatest: near what the
/// series of the integration leave out.
const FINEST: f64 = 1e-13;
/// The coefficients seen to be left out may be this many times what is wanted: they are the last of a steep decay, and
/// what follows them is smaller still.
const ENOUGH: f64 = 20.0;
/// The same, where the integration is refined and multipliers meet.
const ROUNDING: f64 = 2e-15;
/// Points computed directly, for comparison.
const SPOT_CHECKS: usize = 8;
/// Terms in k0^2 at very short periods.
const FEWEST: f64 = 6.0;
/// Nodes beyond which interpolation is not tried.
const MOST_NODES: usize = 400;

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
    let accuracy = (1e-4 * tolerance).max(characteristic::ROUNDING);
    let finest = (0.1 * tolerance * tolerance).clamp(FINEST, 1e-10);
    let mut chart = Surface::fit(&linear, omega, k0, finest)?.factorised(&linear, omega, k0, accuracy)?;
    if chart.error > tolerance {
        // Multipliers meet somewhere: what can be had from double precision.
        let refined = linear.refined();
        chart = Surface::fit(&refined, omega, k0, ROUNDING)?.factorised(
            &refined,
            omega,
            k0,
            characteristic::ROUNDING,
        )?;
    }
    let seen = spot_checks(p, omega, k0, &chart.radius)?;
    let mut method = "Chebyshev interpolation of the characteristic polynomial, Taylor series of order 24 on half a period";
    if seen > tolerance.max(chart.error) {
        // What the decay promised does not hold: every point by itself.
        let direct = Surface::direct(&linear, omega, k0)?;
        chart = direct.factorised(&linear, omega, k0, accuracy)?;
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
    Ok(floquet::spectrum(&matrix(&linear_monodromy(&here, 1e-14, 1.0)?))?.radius())
}

/// Interpolated coefficients c_1 to c_{n-1} of the characteristic polynomial over the chart.
struct Surface {
    /// Coefficients a row: 3 or 5.
    width: usize,
    /// Numbers a mesh frequency: `width` times the terms in k0^2.
    terms: usize,
    /// `[i_omega][coefficient][term]`.
    values: Vec<f64>,
    /// `[term][i_k0]`; none where the terms are the values on the chart's own k0.
    basis: Option<Vec<f64>>,
    /// Error of the coefficients relative to the greatest of each polynomial.
    error: f64,
}

struct Factorised {
    radius: Vec<f64>,
    error: f64,
}

/// Coefficients c_1 to c_{n-1}: c_n is known exactly.
fn inner_coefficients(
    linear: &LinearFloquet,
    omega: f64,
    k0: f64,
    into: &mut Vec<f64>,
) -> Result<(), NumericsError> {
    let polynomial = linear.characteristic(omega, k0)?;
    into.extend_from_slice(&polynomial.coefficients[..polynomial.degree - 1]);
    Ok(())
}

fn too_much_work(steps: f64) -> StudyError {
    NumericsError::TooManySteps { time: 0.0, steps: steps.min(1e15) as usize }.into()
}

impl Surface {
    /// As many nodes as the decay asks for in each direction, or the chart's own points where these are fewer.
    fn fit(linear: &LinearFloquet, omega: Grid, k0: Grid, finest: f64) -> Result<Self, StudyError> {
        let (long, short) = (2.0 * PI / omega.low, 2.0 * PI / omega.high);
        let mut rows = terms_in_depth(linear, omega.low, k0, finest)?;
        let turns: f64 = linear.frequencies().iter().sum::<f64>() * 0.5 * (long - short);
        // The coefficients turn as exp(i turns x): their Chebyshev coefficients are Bessel functions of `turns`.
        let mut nodes = (turns + 6.0 * turns.cbrt() + 8.0 + 0.06 * k0.high * turns).ceil();
        while nodes < omega.count.min(MOST_NODES) as f64 {
            let fitted = Self::sample(linear, omega, k0, Some(nodes as usize), rows)?;
            if fitted.error <= ENOUGH * finest {
                return Ok(fitted);
            }
            nodes = (1.2 * nodes + 4.0).ceil();
            rows = rows.map(|rows| rows + 2).filter(|rows| *rows < k0.count);
        }
        Self::sample(linear, omega, k0, None, rows)
    }

    /// Every point by itself.
    fn direct(linear: &LinearFloquet, omega: Grid, k0: Grid) -> Result<Self, StudyError> {
        Self::sample(linear, omega, k0, None, None)
    }

    fn sample(
        linear: &LinearFloquet,
        omega: Grid,
        k0: Grid,
        nodes: Option<usize>,
        rows: Option<usize>,
    ) -> Result<Self, StudyError> {
        let width = 2 * linear.modes() - 1;
        let (long, short) = (2.0 * PI / omega.low, 2.0 * PI / omega.high);
        let frequencies: Vec<f64> = match nodes {
            Some(count) => chebyshev::nodes(short, long, count).iter().map(|t| 2.0 * PI / t).collect(),
            None => (0..omega.count).map(|i| omega.value(i)).collect(),
        };
        let per_row = rows.unwrap_or(k0.count);
        let work: f64 = frequencies.iter().map(|at| linear.steps(*at, k0.high)).sum::<f64>() * per_row as f64;
        if work.is_nan() || work > MOST_CHART_STEPS {
            return Err(too_much_work(work));
        }
        let terms = width * per_row;
        let mut values = vec![0.0; frequencies.len() * terms];
        let mut samples = Vec::with_capacity(terms);
        let mut error = 0.0_f64;
        let grid: Vec<f64> = (0..k0.count).map(|j| k0.value(j)).collect();
        for (at, row) in frequencies.iter().zip(values.chunks_exact_mut(terms)) {
            samples.clear();
            // Shorter periods ask for fewer terms in k0^2, about as their square root.
            let count = rows.map_or(k0.count, |most| {
                let part = (omega.low / at).sqrt();
                (FEWEST + (most as f64 - FEWEST).max(0.0) * part).ceil().min(most as f64) as usize
            });
            let depths = if rows.is_some() { &depths(k0, count) } else { &grid };
            for depth in depths {
                inner_coefficients(linear, *at, *depth, &mut samples)?;
            }
            if rows.is_some() {
                samples = chebyshev::coefficients(&samples, width);
                error = error.max(chebyshev::tail(&samples, width) / largest(&samples).max(1.0));
            }
            for (term, numbers) in samples.chunks_exact(width).enumerate() {
                for (coefficient, value) in numbers.iter().enumerate() {
                    row[coefficient * per_row + term] = *value;
                }
            }
        }
        if let Some(count) = nodes {
            let scale = largest(&values).max(1.0);
            let in_period = chebyshev::coefficients(&values, terms);
            error = error.max(chebyshev::tail(&in_period, terms) / scale);
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
        let basis = rows.map(|count| {
            let mut basis = vec![0.0; count * k0.count];
            for j in 0..k0.count {
                let square = k0.value(j) * k0.value(j);
                let here = chebyshev::polynomials(k0.low * k0.low, k0.high * k0.high, square, count);
                for (term, value) in here.into_iter().enumerate() {
                    basis[term * k0.count + j] = value;
                }
            }
            basis
        });
        Ok(Self { width, terms: per_row, values, basis, error: error.max(linear.truncation()) })
    }

    /// The radius at every point, each column of the chart from k0 = 0 upwards.
    fn factorised(
        &self,
        linear: &LinearFloquet,
        omega: Grid,
        k0: Grid,
        accuracy: f64,
    ) -> Result<Factorised, StudyError> {
        let mut radius = vec![0.0; omega.count * k0.count];
        let at_rest = linear.at_rest()?;
        let mut amplification = Amplification::default();
        let mut columns = vec![0.0; self.width * k0.count];
        for (i, values) in self.values.chunks_exact(self.width * self.terms).enumerate() {
            let at = omega.value(i);
            let period = 2.0 * PI / at;
            self.expand(values, &mut columns, k0.count);
            let idle = linear.idle_radius(at);
            let mut coefficients = [0.0; 6];
            coefficients[self.width] = (-linear.damping_trace() * period).exp();
            // The last three rows' factors, the newest first, as far as they continue each other.
            let mut rows = [at_rest.propagated(period); 3];
            let mut continued = usize::from(finite(&rows[0]));
            for j in 0..k0.count {
                for k in 0..self.width {
                    coefficients[k] = columns[k * k0.count + j];
                }
                let polynomial = Characteristic { degree: self.width + 1, coefficients };
                let mut tried = None;
                if continued > 0 {
                    let mut guess =
                        if continued > 3 { rows[0].extrapolated(&rows[1], &rows[2]) } else { rows[0] };
                    tried = guess.refine(&polynomial, accuracy).map(|separation| (guess, separation));
                }
                continued += 1;
                let (factors, separation) = if let Some(tried) = tried {
                    tried
                } else {
                    continued = 1;
                    factorise(&polynomial, None, accuracy)?
                };
                let here = factors.radius();
                radius[j * omega.count + i] = here.max(idle);
                amplification.see(&factors, here, separation, &coefficients);
                rows = [factors, rows[0], rows[1]];
            }
        }
        Ok(Factorised { radius, error: amplification.of(self.error).max(10.0 * accuracy) })
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

/// The number of terms in k0^2 that the longest period asks for; none where the chart has no more rows than that.
fn terms_in_depth(
    linear: &LinearFloquet,
    omega: f64,
    k0: Grid,
    finest: f64,
) -> Result<Option<usize>, StudyError> {
    let width = 2 * linear.modes() - 1;
    let mut count = 8;
    loop {
        if count >= k0.count {
            return Ok(None);
        }
        let work = linear.steps(omega, k0.high) * count as f64;
        if work.is_nan() || work > MOST_CHART_STEPS {
            return Err(too_much_work(work));
        }
        let mut samples = Vec::with_capacity(width * count);
        for depth in depths(k0, count) {
            inner_coefficients(linear, omega, depth, &mut samples)?;
        }
        let coefficients = chebyshev::coefficients(&samples, width);
        let limit = finest * largest(&coefficients).max(1.0);
        if chebyshev::tail(&coefficients, width) <= limit {
            // No more than the first two terms that are negligible.
            let used =
                coefficients.chunks(width).rposition(|row| largest(row) > limit).map_or(1, |last| last + 1);
            return Ok(Some((used + 2).min(count)));
        }
        count = count * 3 / 2;
    }
}

/// How far errors of the coefficients can change the greatest root: divided by its distances from the others, or the
/// square root where they meet.
#[derive(Default)]
struct Amplification {
    /// Greatest square of the factor.
    square: f64,
    /// Greatest size of the coefficients and of their powers in the polynomial.
    size: f64,
}

impl Amplification {
    fn see(&mut self, factors: &Factors, radius: f64, separation: f64, coefficients: &[f64; 6]) {
        let mut size = largest(coefficients).max(1.0);
        // A change of the coefficients is multiplied by up to radius^(n-1).
        for _ in 1..2 * factors.count {
            size *= radius.max(1.0);
        }
        let top = factors.top();
        let own = (factors.p[top] * factors.p[top] - 4.0 * factors.q[top]).abs().min(1.0);
        self.square = self.square.max(size * size / (separation.abs() * own));
        self.size = self.size.max(size);
    }

    /// The greatest change of a root for this error of the coefficients, relative to the greatest of each polynomial.
    fn of(&self, error: f64) -> f64 {
        (error * self.square.sqrt()).min((error * self.size).sqrt())
    }
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
