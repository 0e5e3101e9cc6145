//! The motion in time: sampled evenly, with the times at which the teeth part, up to where it escapes.

use super::ErrorEstimate;
use super::motion::{self, ORDER_20};
use crate::error::StudyError;
use crate::model::equations::{Contact, GearPair, U};
use crate::model::parameters::{Parameters, Regime};
use crate::numerics::ode::event;
use crate::numerics::ode::taylor::{Options, Step};

/// Greatest number of rows of an answer.
pub const MOST_ROWS: f64 = 1e6;

/// Most integration steps of an answer: some seconds. Stiff and slow corners of the ranges need more, and are refused.
const MOST_STEPS: usize = 2_000_000;

/// What to compute.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TimeResponseOptions {
    /// State at t = 0.
    pub state: [f64; 6],
    /// Number of mesh periods, above 0; need not be whole.
    pub periods: f64,
    /// Samples a period, at least 1; `periods` times this at most [`MOST_ROWS`].
    pub samples_per_period: usize,
    /// Tolerance of the states, 1e-14 to 1e-3.
    pub tolerance: f64,
}

impl TimeResponseOptions {
    /// 100 periods of 64 samples from [`motion::default_state`] to 1e-10.
    pub fn new(p: &Parameters) -> Self {
        Self { state: motion::default_state(p), periods: 100.0, samples_per_period: 64, tolerance: 1e-10 }
    }
}

/// The motion in time.
#[derive(Clone, Debug, PartialEq)]
pub struct TimeResponse {
    /// Times of the samples; where the motion escapes, the time of escape is the last.
    pub t: Vec<f64>,
    /// The states at these times.
    pub states: Vec<[f64; 6]>,
    /// Times at which `u` falls through 1: the driving faces of the teeth part. Empty in the homogeneous regime,
    /// where `u` is only a deviation.
    pub contact_loss: Vec<f64>,
    /// Time of escape.
    pub escaped: Option<f64>,
    /// How it was computed.
    pub method: String,
    /// What is known of the error: `step` is the greatest change of the last state when every step is halved.
    pub error: ErrorEstimate,
}

/// Computes the motion in time.
///
/// # Errors
/// [`StudyError::Option`] for an option out of range, [`StudyError::Numerics`] where the integration fails.
pub fn time_response(p: &Parameters, options: &TimeResponseOptions) -> Result<TimeResponse, StudyError> {
    let pair = GearPair::new(p);
    motion::check_tolerance(options.tolerance)?;
    motion::check_state(&pair, &options.state)?;
    let rows = options.periods * options.samples_per_period as f64;
    if !(options.periods > 0.0 && rows <= MOST_ROWS) {
        return Err(StudyError::Option {
            option: "periods",
            given: options.periods.to_string(),
            allowed: format!("above 0, and at most {MOST_ROWS:e} samples in all"),
        });
    }
    if options.samples_per_period == 0 {
        return Err(StudyError::Option {
            option: "samplesPerPeriod",
            given: "0".into(),
            allowed: "at least 1".into(),
        });
    }
    sampled(&pair, options)
}

fn sampled(pair: &GearPair, options: &TimeResponseOptions) -> Result<TimeResponse, StudyError> {
    let spacing = pair.parameters.mesh_period() / options.samples_per_period as f64;
    let end = options.periods * pair.parameters.mesh_period();
    let stepping =
        Options { tolerance: motion::step_tolerance(options.tolerance), step_factor: 1.0, steps: MOST_STEPS };
    let mut t = vec![0.0];
    let mut states = vec![options.state];
    let mut contact_loss = Vec::new();
    let mut steps = 0_usize;
    let reached = motion::follow::<ORDER_20>(pair, 0.0, options.state, end, stepping, |step, contact| {
        steps += 1;
        losses(pair.parameters.regime, step, contact, &mut contact_loss);
        loop {
            let next = t.len() as f64 * spacing;
            // A sample that rounding puts a hair past the end belongs to it.
            if next > step.end() && (next > end * (1.0 + 1e-12) || step.end() < end) {
                break;
            }
            states.push(step.value((next - step.start).min(step.length)));
            t.push(next);
        }
    })?;
    if let Some(time) = reached.escaped
        && t.last().is_some_and(|last| *last < time)
    {
        t.push(time);
        states.push(reached.state);
    }
    let halved = Options { step_factor: 0.5, steps: 3 * MOST_STEPS, ..stepping };
    let check = motion::follow::<ORDER_20>(pair, 0.0, options.state, reached.time, halved, |_, _| ())?;
    let change = largest_difference(&reached.state, &check.state);
    Ok(TimeResponse {
        t,
        states,
        contact_loss,
        escaped: reached.escaped,
        method: format!("Taylor series of order {}, {steps} steps", ORDER_20 - 1),
        error: ErrorEstimate { step: Some(change), ..ErrorEstimate::default() },
    })
}

/// Largest difference of two states' coordinates.
pub(crate) fn largest_difference(left: &[f64; 6], right: &[f64; 6]) -> f64 {
    left.iter().zip(right).fold(0.0, |most, (a, b)| most.max((a - b).abs()))
}

fn losses(regime: Regime, step: &Step<6, ORDER_20>, contact: Contact, times: &mut Vec<f64>) {
    let mut coefficients = step.coordinate(U);
    coefficients[0] -= 1.0;
    match (regime, contact) {
        // In the backlash regime a step out of contact ends where the teeth part, to the last bit but not
        // beyond: the crossing is its end.
        (Regime::Backlash, Contact::Driving) => {
            let end = step.value(step.length);
            let scale = coefficients.iter().fold(0.0_f64, |most, value| most.max(value.abs())).max(1.0);
            if (end[U] - 1.0).abs() <= 1e-12 * scale && end[5] < 0.0 {
                times.push(step.end());
            }
        }
        (Regime::Contact, _) => {
            event::visit_crossings(&coefficients, step.length, coefficients[0] == 0.0, &mut |crossing| {
                if !crossing.rising {
                    times.push(step.start + crossing.since);
                }
                false
            });
        }
        _ => (),
    }
}
