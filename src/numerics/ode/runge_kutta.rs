//! The Runge-Kutta pair of order 8(5,3) of Dormand and Prince with its dense output: the second opinion beside
//! the Taylor series. It knows nothing of a field but its value.
//!
//! Source: E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, 2nd ed., Springer 1993,
//! sections II.4 (step control, first step), II.5 and II.10 (the pair, its two estimators); the authors' Fortran code
//! DOP853. Departures: a step cut short to end at a given time leaves the proposal for the next one alone, a step
//! to a state that is not finite is tried again shorter, and stiffness is not looked for.

use super::Field;
use super::dense::{DenseStep, weighted_sum};
use super::dop853_coefficients::{FIFTH_ORDER_ERROR, NODES, RESULT, ROWS, STAGES, THIRD_ORDER};
use crate::error::NumericsError;

/// Part of the step the estimate allows that is tried.
const SAFETY: f64 = 0.9;
/// The next step is at least this part of the last one.
const LEAST_FACTOR: f64 = 0.333;
/// The next step is at most this many times the last one.
const GREATEST_FACTOR: f64 = 6.0;
/// A step this little short of the end is stretched to it.
const STRETCH: f64 = 1.01;

/// How an integration is carried out. Numbers outside their range count as the nearest end of it, and what is not
/// a number as the default.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RungeKuttaOptions {
    /// Bound of a step's error relative to each coordinate; 1e-15 to 1.
    pub relative_tolerance: f64,
    /// Bound of a step's error, in the unit of each coordinate, added to the relative one; 1e-100 to 1e100.
    pub absolute_tolerance: f64,
    /// Length of the first step tried, in time; above 0. `None`: chosen from the field at the start.
    pub first_step: Option<f64>,
    /// Bound of the length of every step, in time; above 0.
    pub largest_step: f64,
    /// Greatest number of steps tried in all, those refused included.
    pub step_limit: usize,
}

impl Default for RungeKuttaOptions {
    fn default() -> Self {
        Self {
            relative_tolerance: 1e-10,
            absolute_tolerance: 1e-12,
            first_step: None,
            largest_step: f64::INFINITY,
            step_limit: 1_000_000,
        }
    }
}

impl RungeKuttaOptions {
    /// The default with both tolerances set to `tolerance`.
    pub fn with_tolerance(tolerance: f64) -> Self {
        Self { relative_tolerance: tolerance, absolute_tolerance: tolerance, ..Self::default() }
    }

    fn within_ranges(self) -> Self {
        let default = Self::default();
        let number = |given: f64, otherwise: f64| if given.is_nan() { otherwise } else { given };
        let above_zero = |length: &f64| *length > 0.0;
        Self {
            relative_tolerance: number(self.relative_tolerance, default.relative_tolerance).clamp(1e-15, 1.0),
            absolute_tolerance: number(self.absolute_tolerance, default.absolute_tolerance)
                .clamp(1e-100, 1e100),
            first_step: self.first_step.filter(above_zero),
            largest_step: Some(self.largest_step).filter(above_zero).unwrap_or(f64::INFINITY),
            step_limit: self.step_limit,
        }
    }
}

/// Work done by an integration.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Work {
    /// Evaluations of the field.
    pub evaluations: usize,
    /// Steps taken.
    pub accepted: usize,
    /// Steps tried and refused by the error estimate.
    pub rejected: usize,
}

/// An integration under way, taken step by step, in either direction of time.
#[derive(Clone, Debug)]
pub struct RungeKutta<'a, F: Field<N>, const N: usize> {
    field: &'a F,
    options: RungeKuttaOptions,
    time: f64,
    state: [f64; N],
    slope: [f64; N],
    /// Length of the next step to try, without sign.
    proposal: Option<f64>,
    work: Work,
}

/// A step tried, before anyone has judged it.
struct Trial<const N: usize> {
    slopes: [[f64; N]; STAGES],
    end: f64,
    state: [f64; N],
}

impl<'a, F: Field<N>, const N: usize> RungeKutta<'a, F, N> {
    /// Starts at `state` at `time`.
    ///
    /// # Errors
    /// [`NumericsError::NotFinite`] where time, state or the field there is not.
    pub fn new(
        field: &'a F,
        time: f64,
        state: [f64; N],
        options: RungeKuttaOptions,
    ) -> Result<Self, NumericsError> {
        let options = options.within_ranges();
        let mut integration = Self {
            field,
            options,
            time,
            state,
            slope: [0.0; N],
            proposal: options.first_step,
            work: Work::default(),
        };
        integration.restart(time, state)?;
        Ok(integration)
    }

    /// Goes on from another state or time, with the length of step found so far: after an impact, say. Where the
    /// field itself changes, make a new integration and hand it [`RungeKutta::proposed_step`].
    ///
    /// # Errors
    /// [`NumericsError::NotFinite`], as in [`RungeKutta::new`].
    pub fn restart(&mut self, time: f64, state: [f64; N]) -> Result<(), NumericsError> {
        if !time.is_finite() || !all_finite(&state) {
            return Err(NumericsError::NotFinite { time });
        }
        let slope = self.slope_at(time, &state);
        if !all_finite(&slope) {
            return Err(NumericsError::NotFinite { time });
        }
        (self.time, self.state, self.slope) = (time, state, slope);
        Ok(())
    }

    /// Present time.
    pub fn time(&self) -> f64 {
        self.time
    }

    /// Present state.
    pub fn state(&self) -> &[f64; N] {
        &self.state
    }

    /// Work done so far.
    pub fn work(&self) -> Work {
        self.work
    }

    /// Length of the step that will be tried next; `None` before the first one where none was given.
    pub fn proposed_step(&self) -> Option<f64> {
        self.proposal
    }

    /// Takes one step towards `until`, at most to it, and gives its dense output, which costs three evaluations
    /// of the field more than [`RungeKutta::advance`]. At `until` already, the step has no length.
    ///
    /// # Errors
    /// As [`RungeKutta::advance`].
    pub fn step(&mut self, until: f64) -> Result<DenseStep<N>, NumericsError> {
        let (start, start_state) = (self.time, self.state);
        match self.accepted_trial(until)? {
            Some(trial) => self.with_dense_output(start, start_state, trial),
            None => Ok(DenseStep::resting(start, start_state)),
        }
    }

    /// Takes one step towards `until`, at most to it, which may be before the present time.
    ///
    /// # Errors
    /// [`NumericsError::NotFinite`] where `until` or every shorter step's end is not finite,
    /// [`NumericsError::StepTooSmall`], [`NumericsError::TooManySteps`].
    pub fn advance(&mut self, until: f64) -> Result<(), NumericsError> {
        self.accepted_trial(until).map(|_| ())
    }

    /// Takes one step of the whole way to `until`, whatever its error, and gives its dense output.
    ///
    /// # Errors
    /// [`NumericsError::NotFinite`].
    pub fn step_unchecked(&mut self, until: f64) -> Result<DenseStep<N>, NumericsError> {
        let (start, start_state) = (self.time, self.state);
        let mut trial = self.trial(until);
        if !all_finite(&trial.state) {
            return Err(NumericsError::NotFinite { time: start });
        }
        if !self.accept(&mut trial) {
            return Err(NumericsError::NotFinite { time: until });
        }
        self.with_dense_output(start, start_state, trial)
    }

    fn slope_at(&mut self, time: f64, state: &[f64; N]) -> [f64; N] {
        self.work.evaluations += 1;
        self.field.derivative(time, state)
    }

    fn stage(&mut self, stage: usize, length: f64, slopes: &mut [[f64; N]; STAGES]) {
        let mut argument = weighted_sum(ROWS[stage], slopes);
        for (value, start) in argument.iter_mut().zip(&self.state) {
            *value = start + length * *value;
        }
        slopes[stage] = self.slope_at(self.time + NODES[stage] * length, &argument);
    }

    fn trial(&mut self, end: f64) -> Trial<N> {
        let length = end - self.time;
        let mut slopes = [[0.0; N]; STAGES];
        slopes[0] = self.slope;
        for stage in 1..RESULT {
            self.stage(stage, length, &mut slopes);
        }
        let mut state = weighted_sum(ROWS[RESULT], &slopes);
        for (value, start) in state.iter_mut().zip(&self.state) {
            *value = start + length * *value;
        }
        Trial { slopes, end, state }
    }

    /// The trial's error over the tolerance, accepted up to 1: both estimators together, as II.10 has it.
    fn error(&self, trial: &Trial<N>) -> f64 {
        let fifth = weighted_sum(FIFTH_ORDER_ERROR, &trial.slopes);
        let result = weighted_sum(ROWS[RESULT], &trial.slopes);
        let embedded = weighted_sum(THIRD_ORDER, &trial.slopes);
        let (mut fifth_square, mut third_square) = (0.0, 0.0);
        for i in 0..N {
            let size = self.state[i].abs().max(trial.state[i].abs());
            let allowed = self.options.absolute_tolerance + self.options.relative_tolerance * size;
            fifth_square += (fifth[i] / allowed).powi(2);
            third_square += ((result[i] - embedded[i]) / allowed).powi(2);
        }
        let both = fifth_square + 0.01 * third_square;
        if both == 0.0 {
            return 0.0;
        }
        (trial.end - self.time).abs() * fifth_square / (N as f64 * both).sqrt()
    }

    /// Moves to the end of the trial, unless the field is not finite there.
    fn accept(&mut self, trial: &mut Trial<N>) -> bool {
        let slope = self.slope_at(trial.end, &trial.state);
        if !all_finite(&slope) {
            return false;
        }
        trial.slopes[RESULT] = slope;
        (self.time, self.state, self.slope) = (trial.end, trial.state, slope);
        self.work.accepted += 1;
        true
    }

    fn with_dense_output(
        &mut self,
        start: f64,
        start_state: [f64; N],
        mut trial: Trial<N>,
    ) -> Result<DenseStep<N>, NumericsError> {
        let length = trial.end - start;
        for stage in RESULT + 1..STAGES {
            let mut argument = weighted_sum(ROWS[stage], &trial.slopes);
            for (value, from) in argument.iter_mut().zip(&start_state) {
                *value = from + length * *value;
            }
            trial.slopes[stage] = self.slope_at(start + NODES[stage] * length, &argument);
            if !all_finite(&trial.slopes[stage]) {
                return Err(NumericsError::NotFinite { time: start });
            }
        }
        Ok(DenseStep::new((start, start_state), (trial.end, trial.state), &trial.slopes))
    }

    /// Tries steps until one is accepted; `None` at `until` already.
    fn accepted_trial(&mut self, until: f64) -> Result<Option<Trial<N>>, NumericsError> {
        if !until.is_finite() {
            return Err(NumericsError::NotFinite { time: until });
        }
        let left = until - self.time;
        if left == 0.0 {
            return Ok(None);
        }
        let mut length = match self.proposal {
            Some(length) => length,
            None => self.first_step(left),
        };
        let (mut refused, mut finite) = (false, true);
        loop {
            length = length.min(self.options.largest_step);
            if self.work.accepted + self.work.rejected >= self.options.step_limit {
                return Err(NumericsError::TooManySteps { time: self.time, steps: self.options.step_limit });
            }
            let last = STRETCH * length >= left.abs();
            let resolution = (10.0 * f64::EPSILON * self.time.abs()).max(f64::MIN_POSITIVE);
            if !last && length <= resolution {
                return Err(if finite {
                    NumericsError::StepTooSmall { time: self.time, step: length }
                } else {
                    NumericsError::NotFinite { time: self.time }
                });
            }
            let end = if last { until } else { self.time + length.copysign(left) };
            let mut trial = self.trial(end);
            let error = self.error(&trial);
            finite = error.is_finite() && all_finite(&trial.state);
            if finite && error <= 1.0 {
                let tried = if last { left.abs() } else { length };
                if self.accept(&mut trial) {
                    let mut next = tried * factor(error).max(LEAST_FACTOR);
                    if refused {
                        next = next.min(tried);
                    } else if last {
                        next = next.max(length);
                    }
                    self.proposal = Some(next.min(self.options.largest_step));
                    return Ok(Some(trial));
                }
                finite = false;
            }
            let tried = if last { left.abs() } else { length };
            length = tried * if finite { factor(error).max(LEAST_FACTOR) } else { LEAST_FACTOR };
            self.work.rejected += 1;
            refused = true;
        }
    }

    /// A length for the first step, II.4, function HINIT of DOP853: an explicit Euler step a hundredth of the state
    /// long shows the second derivative, and the step is such that the eighth power is in keeping with it.
    fn first_step(&mut self, left: f64) -> f64 {
        let longest = left.abs().min(self.options.largest_step);
        let allowed = self
            .state
            .map(|value| self.options.absolute_tolerance + self.options.relative_tolerance * value.abs());
        let square = |vector: &[f64; N]| -> f64 {
            vector.iter().zip(&allowed).map(|(value, scale)| (value / scale).powi(2)).sum()
        };
        let (slope_square, state_square) = (square(&self.slope), square(&self.state));
        let euler = if slope_square <= 1e-10 || state_square <= 1e-10 {
            1e-6
        } else {
            0.01 * (state_square / slope_square).sqrt()
        };
        let euler = euler.min(longest);
        let mut moved = self.state;
        for (value, slope) in moved.iter_mut().zip(&self.slope) {
            *value += euler.copysign(left) * slope;
        }
        let mut change = self.slope_at(self.time + euler.copysign(left), &moved);
        for (value, slope) in change.iter_mut().zip(&self.slope) {
            *value -= slope;
        }
        let second = square(&change).sqrt() / euler;
        let steepest = second.max(slope_square.sqrt());
        let by_derivative =
            if steepest <= 1e-15 { (1e-3 * euler).max(1e-6) } else { (0.01 / steepest).powf(1.0 / 8.0) };
        // A field that is not finite near by gives none of these a meaning: then start with the Euler step.
        let length = if by_derivative.is_finite() { by_derivative } else { euler };
        length.min(100.0 * euler).min(longest)
    }
}

/// Ratio of the step that the error allows to the step that made it.
fn factor(error: f64) -> f64 {
    (SAFETY / error.powf(1.0 / 8.0)).min(GREATEST_FACTOR)
}

fn all_finite<const N: usize>(values: &[f64; N]) -> bool {
    values.iter().all(|value| value.is_finite())
}

/// The state at `end`, started at `state` at `start`; `end` may be before `start`.
///
/// # Errors
/// As [`RungeKutta::new`] and [`RungeKutta::advance`].
pub fn integrate<F: Field<N>, const N: usize>(
    field: &F,
    start: f64,
    state: [f64; N],
    end: f64,
    options: RungeKuttaOptions,
) -> Result<[f64; N], NumericsError> {
    let mut integration = RungeKutta::new(field, start, state, options)?;
    while integration.time() != end {
        integration.advance(end)?;
    }
    Ok(*integration.state())
}

/// The state at `end` by `steps` (at least 1) equal steps of the classical method of order 4, without error
/// control: the plain scheme against which the others are measured.
///
/// # Errors
/// [`NumericsError::NotFinite`].
pub fn rk4_fixed<F: Field<N>, const N: usize>(
    field: &F,
    start: f64,
    state: [f64; N],
    end: f64,
    steps: usize,
) -> Result<[f64; N], NumericsError> {
    let steps = steps.max(1);
    let length = (end - start) / steps as f64;
    let mut state = state;
    for n in 0..steps {
        let time = start + n as f64 * length;
        let moved = |by: f64, slope: &[f64; N]| {
            let mut moved = state;
            for (value, slope) in moved.iter_mut().zip(slope) {
                *value += by * slope;
            }
            moved
        };
        let first = field.derivative(time, &state);
        let second = field.derivative(time + 0.5 * length, &moved(0.5 * length, &first));
        let third = field.derivative(time + 0.5 * length, &moved(0.5 * length, &second));
        let fourth = field.derivative(time + length, &moved(length, &third));
        for i in 0..N {
            state[i] += length / 6.0 * (first[i] + 2.0 * (second[i] + third[i]) + fourth[i]);
        }
    }
    if all_finite(&state) { Ok(state) } else { Err(NumericsError::NotFinite { time: end }) }
}
