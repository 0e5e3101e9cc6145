//! A motion followed step by step, up to where it escapes: what every study of trajectories is made of.

use crate::error::{NumericsError, StudyError};
use crate::model::equations::{Contact, DIVERGED, GearPair, U};
use crate::model::parameters::{Parameters, Regime};
use crate::numerics::ode::event;
use crate::numerics::ode::taylor::{Options, Propagation, Step};

/// Taylor coefficients of a step of order 16: less work for variational equations than order 20.
pub const ORDER_16: usize = 17;
/// Taylor coefficients of a step of order 20: the least work for motions wanted to 1e-7 or finer. One order serves
/// all, because each has its coefficients written out.
pub const ORDER_20: usize = 21;
/// Taylor coefficients of a step of order 24, for the linear problem.
pub const ORDER_24: usize = 25;

/// Range of the option `tolerance` of every study.
pub const TOLERANCE: (f64, f64) = (1e-14, 1e-3);

/// The tolerance of a step for an answer within `tolerance`.
///
/// Measured over 100 periods of Fig. 14 b and of a 2T orbit: the error that is left is then below the tolerance.
pub fn step_tolerance(tolerance: f64) -> f64 {
    (0.1 * tolerance).max(1e-16)
}

/// Refuses a tolerance out of range.
///
/// # Errors
/// [`StudyError::Option`].
pub fn check_tolerance(tolerance: f64) -> Result<(), StudyError> {
    if tolerance >= TOLERANCE.0 && tolerance <= TOLERANCE.1 {
        return Ok(());
    }
    Err(StudyError::Option {
        option: "tolerance",
        given: tolerance.to_string(),
        allowed: format!("from {:e} to {:e}", TOLERANCE.0, TOLERANCE.1),
    })
}

/// Refuses a state that is not finite or already beyond the escape bounds.
///
/// # Errors
/// [`StudyError::Option`].
pub fn check_state(pair: &GearPair, state: &[f64; 6]) -> Result<(), StudyError> {
    let refused =
        |allowed: String| Err(StudyError::Option { option: "state", given: format!("{state:?}"), allowed });
    if state.iter().any(|value| !value.is_finite()) {
        return refused("six finite numbers u_p, u_g, u, u_p', u_g', u'".into());
    }
    if escaped(pair, state) {
        let [pinion, gear] = pair.escape_bounds();
        return refused(format!(
            "within the bounds of escape: |u_p| at most {pinion}, |u_g| at most {gear}, |u| at most {DIVERGED:e}"
        ));
    }
    Ok(())
}

/// Where a motion starts when nothing else is said: at rest, loaded teeth just touching at `u = 1`; in the
/// homogeneous regime, which would rest for ever, a little out of rest on the manifold `u_g = -u_p`.
pub fn default_state(p: &Parameters) -> [f64; 6] {
    match p.regime {
        Regime::Homogeneous => [-0.02, 0.02, 0.05, 0.0, 0.0, 0.0],
        Regime::Contact | Regime::Backlash => [0.0, 0.0, 1.0, 0.0, 0.0, 0.0],
    }
}

fn escaped(pair: &GearPair, state: &[f64; 6]) -> bool {
    let [pinion, gear] = pair.escape_bounds();
    state[0].abs() > pinion || state[1].abs() > gear || state[U].abs() > DIVERGED
}

/// Whether the start or the end of a step is beyond half of a bound of `|u_p|` and `|u_g|`, or of `|u|`.
fn near_escape([pinion, gear]: [f64; 2], start: &[f64; 6], end: &[f64; 6]) -> bool {
    [(0, pinion), (1, gear), (U, DIVERGED)].iter().any(|&(coordinate, bound)| {
        start[coordinate].abs() > 0.5 * bound || end[coordinate].abs() > 0.5 * bound
    })
}

/// The time since the start of the step at which the motion first passes one of the bounds of escape.
fn escape_since<const LEN: usize>(pair: &GearPair, step: &Step<6, LEN>) -> Option<f64> {
    let [pinion, gear] = pair.escape_bounds();
    let mut first: Option<f64> = None;
    for (coordinate, bound) in [(0, pinion), (1, gear), (U, DIVERGED)] {
        if !bound.is_finite() {
            continue;
        }
        for level in [bound, -bound] {
            let mut coefficients = step.coordinate(coordinate);
            coefficients[0] -= level;
            let end = first.unwrap_or(step.length);
            if let Some(since) = event::first_crossing(&coefficients, end, false) {
                first = Some(since);
            }
        }
    }
    first
}

/// How far a motion came.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reached {
    /// The time reached: the end, or the time of escape.
    pub time: f64,
    /// The state there.
    pub state: [f64; 6],
    /// Time of escape, if it escaped.
    pub escaped: Option<f64>,
    /// Steps taken.
    pub steps: usize,
}

/// Follows a motion from `state` at `start` to `end`, showing each step (its polynomial, valid on its length, and
/// the contact that held) to `visit`; ends where it escapes.
///
/// # Errors
/// As [`Propagation::step`].
pub fn follow<const LEN: usize>(
    pair: &GearPair,
    start: f64,
    state: [f64; 6],
    end: f64,
    options: Options,
    mut visit: impl FnMut(&Step<6, LEN>, Contact),
) -> Result<Reached, NumericsError> {
    let mut propagation = Propagation::<GearPair, 6, LEN>::new(pair, start, state, options);
    let bounds = pair.escape_bounds();
    while propagation.time() < end {
        let contact = propagation.piece();
        propagation.advance(end)?;
        let step = propagation.latest();
        // A motion that starts and ends a step well inside the bounds does not leave them in between.
        if near_escape(bounds, &step.series[0], propagation.state())
            && let Some(since) = escape_since(pair, step)
        {
            let step = Step { length: since, ..*step };
            visit(&step, contact);
            let time = step.end();
            return Ok(Reached {
                time,
                state: step.value(since),
                escaped: Some(time),
                steps: propagation.taken(),
            });
        }
        visit(step, contact);
    }
    Ok(Reached {
        time: propagation.time(),
        state: *propagation.state(),
        escaped: None,
        steps: propagation.taken(),
    })
}

/// Most steps of one [`carry`], which mostly goes over one period: some tenths of a second.
const CARRY_STEPS: usize = 400_000;

/// [`follow`] where the steps themselves are not asked for.
///
/// # Errors
/// As [`follow`].
pub fn carry(
    pair: &GearPair,
    start: f64,
    state: [f64; 6],
    end: f64,
    tolerance: f64,
) -> Result<Reached, NumericsError> {
    let options = Options { tolerance: step_tolerance(tolerance), steps: CARRY_STEPS, ..Options::default() };
    follow::<ORDER_20>(pair, start, state, end, options, |_, _| ())
}

/// Shows the states of a motion at `samples` even times of `periods` mesh periods, the first included.
///
/// # Errors
/// Where the integration fails.
pub fn sampled(
    p: &Parameters,
    mut state: [f64; 6],
    periods: f64,
    samples: usize,
    visit: &mut dyn FnMut(f64, &[f64; 6]),
) -> Result<(), StudyError> {
    let pair = GearPair::new(p);
    let length = periods * p.mesh_period() / samples as f64;
    for sample in 0..samples {
        let time = sample as f64 * length;
        visit(time, &state);
        state = carry(&pair, time, state, time + length, 1e-8)?.state;
    }
    Ok(())
}
