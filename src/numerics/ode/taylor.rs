//! Integration by Taylor series: exact recurrences for the coefficients, the step from the last two of them,
//! and each step's polynomial as its dense output.
//!
//! Source of the step rule: A. Jorba, M. Zou, A software package for the numerical integration of ODEs by means
//! of high-order Taylor methods, Experimental Mathematics 14 (2005) 99-117, doi 10.1080/10586458.2005.10128904,
//! section 3; departure: the step is set so that each of the last two terms is below the tolerance, at an order
//! chosen from a short list, because an order known to the compiler makes the recurrences several times faster.
//!
//! A field may consist of analytic pieces (a dead zone, say). A step never crosses from one piece to another:
//! it ends at the crossing, which is a root of the step's own polynomial.

use super::event;
use crate::error::NumericsError;

/// Coefficients of every coordinate in powers of the time since the start of the step: `series[n][i]` belongs to
/// the n-th power and coordinate i.
pub type Series<const N: usize, const LEN: usize> = [[f64; N]; LEN];

/// Where one analytic piece of a field ends: the coordinate reaches the level.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Boundary {
    /// Index of the coordinate.
    pub coordinate: usize,
    /// The level it reaches.
    pub level: f64,
}

/// A first-order system of N equations whose right-hand side is analytic in pieces, by its Taylor coefficients.
pub trait TaylorField<const N: usize> {
    /// Names a piece; `()` where there is only one.
    type Piece: Copy + PartialEq;

    /// The piece that holds at this state and just after it: on a boundary, that into which the motion goes.
    fn piece(&self, time: f64, state: &[f64; N]) -> Self::Piece;

    /// The ends of a piece.
    fn boundaries(&self, piece: Self::Piece) -> [Option<Boundary>; 2];

    /// Fills all of `series`, whatever it holds, with the Taylor coefficients of the solution through `state` at
    /// `time`, as if the piece had no end.
    fn series<const LEN: usize>(
        &self,
        piece: Self::Piece,
        time: f64,
        state: &[f64; N],
        series: &mut Series<N, LEN>,
    );
}

/// Coordinates below this are made zero after a step.
const NOTHING: f64 = 1e-100;

/// How an integration is carried out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// Bound of each of the last two terms of a step, relative to the largest coordinate; 1e-15 to 1e-2.
    pub tolerance: f64,
    /// Factor by which every step is shortened, for step-doubling estimates; above 0, at most 1.
    pub step_factor: f64,
    /// Greatest number of steps.
    pub steps: usize,
}

impl Default for Options {
    fn default() -> Self {
        Self { tolerance: 1e-11, step_factor: 1.0, steps: 4_000_000 }
    }
}

/// One step with its polynomial.
#[derive(Clone, Copy, Debug)]
pub struct Step<const N: usize, const LEN: usize> {
    /// Time at which it starts.
    pub start: f64,
    /// Its length.
    pub length: f64,
    /// Its Taylor coefficients.
    pub series: Series<N, LEN>,
}

impl<const N: usize, const LEN: usize> Step<N, LEN> {
    /// Time at which the step ends.
    pub fn end(&self) -> f64 {
        self.start + self.length
    }

    /// The state `since` after the start of the step; meant for 0 to [`Step::length`].
    ///
    /// By Horner's rule for the even and the odd powers apart: two sums that need not wait for one another.
    pub fn value(&self, since: f64) -> [f64; N] {
        let square = since * since;
        let (mut even, mut odd) = ([0.0; N], [0.0; N]);
        if LEN % 2 == 1 {
            even = self.series[LEN - 1];
        }
        for pair in self.series[..LEN - LEN % 2].rchunks_exact(2) {
            for i in 0..N {
                even[i] = even[i] * square + pair[0][i];
                odd[i] = odd[i] * square + pair[1][i];
            }
        }
        for i in 0..N {
            even[i] += odd[i] * since;
        }
        even
    }

    /// Coefficients of one coordinate in powers of the time since the start.
    pub fn coordinate(&self, index: usize) -> [f64; LEN] {
        let mut coefficients = [0.0; LEN];
        for (coefficient, row) in coefficients.iter_mut().zip(&self.series) {
            *coefficient = row[index];
        }
        coefficients
    }
}

/// Step length at which each of the last two terms is about `tolerance` times the largest coordinate.
///
/// Infinite where both vanish. States smaller than `1e-6` count as that large, so that an equilibrium reached to
/// rounding error does not ask for accuracy below it. The roots are taken to a per mille: a step need not be exact, and
/// is then the same to the bit on every machine.
pub fn step_length<const N: usize, const LEN: usize>(series: &Series<N, LEN>, tolerance: f64) -> f64 {
    let (last, last_but_one) = (largest(&series[LEN - 1]), largest(&series[LEN - 2]));
    let size = largest(&series[0]);
    if last == 0.0 && last_but_one == 0.0 {
        return f64::INFINITY;
    }
    if !(size + last + last_but_one).is_finite() {
        return f64::NAN;
    }
    let allowed = rough_log2(tolerance * greater(size, 1e-6));
    let by_term = |term: f64, order: usize| (allowed - rough_log2(term)) * (1.0 / order as f64);
    let (by_last, by_last_but_one) = (by_term(last, LEN - 1), by_term(last_but_one, LEN - 2));
    rough_exp2(if by_last < by_last_but_one { by_last } else { by_last_but_one })
}

/// Compared rather than by `max`, which wasm has as a call: the second where the first is no number.
fn greater(one: f64, other: f64) -> f64 {
    if one > other { one } else { other }
}

/// The largest size of a coordinate; of even and of odd places apart, which need not wait for one another. What is no number
/// does not count.
fn largest<const N: usize>(row: &[f64; N]) -> f64 {
    let mut most = [0.0; 2];
    let (pairs, rest) = row.as_chunks::<2>();
    for pair in pairs {
        for lane in 0..2 {
            most[lane] = greater(pair[lane].abs(), most[lane]);
        }
    }
    for value in rest {
        most[0] = greater(value.abs(), most[0]);
    }
    greater(most[0], most[1])
}

/// The logarithm to base 2 of a number above zero, to 2e-3: its exponent and a parabola in its mantissa. Zero counts
/// as the least normal number.
fn rough_log2(number: f64) -> f64 {
    let bits = greater(number, f64::MIN_POSITIVE).to_bits();
    let exponent = (bits >> 52) as f64 - 1023.0;
    let part = f64::from_bits(bits & 0x000f_ffff_ffff_ffff | 0x3ff0_0000_0000_0000) - 1.0;
    // Exact at both ends of the mantissa.
    exponent + part + part * (1.0 - part) * (0.4209 - 0.1564 * part)
}

/// 2 to this power, to 1e-3, for powers from -1000 to 1000; beyond, the value at the end.
fn rough_exp2(power: f64) -> f64 {
    let power = power.clamp(-1000.0, 1000.0);
    let whole = power.floor();
    let part = power - whole;
    let mantissa = 1.0 + part - part * (1.0 - part) * (0.3041 + 0.0791 * part);
    mantissa * f64::from_bits(((whole as i64 + 1023) as u64) << 52)
}

/// An integration under way, taken step by step.
#[derive(Clone, Debug)]
pub struct Propagation<'a, F: TaylorField<N>, const N: usize, const LEN: usize> {
    field: &'a F,
    options: Options,
    time: f64,
    state: [f64; N],
    piece: F::Piece,
    /// A boundary that the state lies on: its coordinate and level.
    on_boundary: Option<(usize, f64)>,
    taken: usize,
    /// The step taken last; kept here because its polynomial is too large to be moved about without need.
    latest: Step<N, LEN>,
}

impl<'a, F: TaylorField<N>, const N: usize, const LEN: usize> Propagation<'a, F, N, LEN> {
    /// Starts at `state` at `time`.
    pub fn new(field: &'a F, time: f64, state: [f64; N], options: Options) -> Self {
        let piece = field.piece(time, &state);
        let on_boundary = field
            .boundaries(piece)
            .into_iter()
            .flatten()
            .find(|boundary| state[boundary.coordinate] == boundary.level)
            .map(|boundary| (boundary.coordinate, boundary.level));
        let latest = Step { start: time, length: 0.0, series: [[0.0; N]; LEN] };
        Self { field, options, time, state, piece, on_boundary, taken: 0, latest }
    }

    /// Present time.
    pub fn time(&self) -> f64 {
        self.time
    }

    /// Present state.
    pub fn state(&self) -> &[f64; N] {
        &self.state
    }

    /// The piece of the field that holds now.
    pub fn piece(&self) -> F::Piece {
        self.piece
    }

    /// Steps taken so far.
    pub fn taken(&self) -> usize {
        self.taken
    }

    /// The step taken last; of no length before the first.
    pub fn latest(&self) -> &Step<N, LEN> {
        &self.latest
    }

    /// [`Propagation::advance`], and a copy of the step.
    ///
    /// # Errors
    /// As [`Propagation::advance`].
    pub fn step(&mut self, until: f64) -> Result<Step<N, LEN>, NumericsError> {
        self.advance(until)?;
        Ok(self.latest)
    }

    /// Takes one step forwards, at most to `until`, at most to the end of the present piece.
    ///
    /// # Errors
    /// [`NumericsError::NotFinite`], [`NumericsError::StepTooSmall`] or [`NumericsError::TooManySteps`].
    pub fn advance(&mut self, until: f64) -> Result<(), NumericsError> {
        if self.taken >= self.options.steps {
            return Err(NumericsError::TooManySteps { time: self.time, steps: self.taken });
        }
        self.field.series(self.piece, self.time, &self.state, &mut self.latest.series);
        let wished = step_length(&self.latest.series, self.options.tolerance) * self.options.step_factor;
        if wished.is_nan() {
            return Err(NumericsError::NotFinite { time: self.time });
        }
        let left = until - self.time;
        // A last step a hair longer is better than one more that is a hair long.
        let last = wished * (1.0 + 1e-3) >= left;
        let mut length = if last { left } else { wished };
        let resolution = 4.0 * f64::EPSILON * self.time.abs().max(f64::MIN_POSITIVE);
        if !last && length <= resolution {
            return Err(NumericsError::StepTooSmall { time: self.time, step: length });
        }
        let crossing = self.first_crossing(&self.latest.series, length);
        if let Some((since, _)) = crossing {
            length = since;
        }
        (self.latest.start, self.latest.length) = (self.time, length);
        self.state = self.latest.value(length);
        for value in &mut self.state {
            if !value.is_finite() {
                return Err(NumericsError::NotFinite { time: self.time });
            }
            // A motion that dies away would end among numbers below the normal ones, a hundred times slower to reckon with.
            if value.abs() < NOTHING {
                *value = 0.0;
            }
        }
        self.taken += 1;
        if let Some((_, boundary)) = crossing {
            self.time += length;
            self.state[boundary.coordinate] = boundary.level;
            // Asked of the field rather than read off the crossing: where the path turns back at the boundary,
            // only its next derivatives know.
            self.piece = self.field.piece(self.time, &self.state);
            self.on_boundary = Some((boundary.coordinate, boundary.level));
        } else {
            self.time = if last { until } else { self.time + length };
            self.on_boundary = None;
        }
        Ok(())
    }

    /// The first crossing out of the present piece within the step: time since its start, and the boundary.
    fn first_crossing(&self, series: &Series<N, LEN>, length: f64) -> Option<(f64, Boundary)> {
        let mut first: Option<(f64, Boundary)> = None;
        for boundary in self.field.boundaries(self.piece).into_iter().flatten() {
            let mut coefficients = [0.0; LEN];
            for (coefficient, row) in coefficients.iter_mut().zip(series) {
                *coefficient = row[boundary.coordinate];
            }
            coefficients[0] -= boundary.level;
            let starts_here = self.on_boundary == Some((boundary.coordinate, boundary.level));
            let end = first.map_or(length, |(since, _)| since);
            if let Some(since) = event::first_crossing(&coefficients, end, starts_here) {
                first = Some((since, boundary));
            }
        }
        first
    }
}

/// The state at `end`, started at `state` at `start`; `end` not before `start`.
///
/// # Errors
/// As [`Propagation::step`].
pub fn integrate<F: TaylorField<N>, const N: usize, const LEN: usize>(
    field: &F,
    start: f64,
    state: [f64; N],
    end: f64,
    options: Options,
) -> Result<[f64; N], NumericsError> {
    let mut propagation = Propagation::<F, N, LEN>::new(field, start, state, options);
    while propagation.time() < end {
        propagation.advance(end)?;
    }
    Ok(*propagation.state())
}

#[cfg(test)]
mod tests {
    use super::{rough_exp2, rough_log2, step_length};

    #[test]
    fn rough_powers_are_as_near_as_they_say() {
        for step in 0..4000 {
            let power = 0.37 * f64::from(step) - 740.0;
            let number = power.exp2();
            assert!((rough_exp2(power) / number - 1.0).abs() < 1e-3, "2^{power}");
            assert!((rough_log2(number) - power).abs() < 2e-3, "log2 of {number:e}");
        }
        assert!(rough_exp2(f64::INFINITY).is_finite() && rough_log2(0.0) < -1000.0);
    }

    #[test]
    fn a_step_makes_the_last_terms_as_small_as_asked() {
        let mut series = [[0.0; 2]; 9];
        for (order, row) in series.iter_mut().enumerate() {
            *row = [3.0 * 0.7_f64.powf(order as f64), 0.0];
        }
        let length = step_length(&series, 1e-12);
        let largest = |order: usize| series[order][0] * length.powf(order as f64) / 3.0;
        assert!((largest(8).max(largest(7)) / 1e-12).ln().abs() < 0.05);
        series[7] = [0.0; 2];
        series[8] = [0.0; 2];
        assert_eq!(step_length(&series, 1e-12), f64::INFINITY);
        series[8] = [f64::INFINITY; 2];
        assert!(step_length(&series, 1e-12).is_nan());
    }
}
