//! The Lyapunov spectrum of the motion that a start leads to.

use super::ErrorEstimate;
use super::motion::{self, ORDER_16};
use super::multipliers::{Budget, common_period, image};
use super::settling::{self, End, settle};
use super::time_response::largest_difference;
use crate::error::{NumericsError, StudyError};
use crate::model::equations::GearPair;
use crate::model::parameters::Parameters;
use crate::model::variational::{SIZE, Variational};
use crate::numerics::birkhoff;
use crate::numerics::floquet;
use crate::numerics::lyapunov::Framed;
use crate::numerics::ode::taylor::Options;
use crate::numerics::periodic::matrix;
use crate::order;

/// Most periods over which exponents are taken.
pub const MOST_PERIODS: usize = 100_000;
/// Most steps in which a motion may settle: a second or so.
const MOST_STEPS: usize = 600_000;
/// The same of the variational equations, which cost ten times as much.
const MOST_FRAMED_STEPS: usize = 60_000;
/// Such steps that every period may take on average, however many are asked for.
const STEPS_A_PERIOD: usize = 40;
/// Periods, besides half of those asked for, in which a motion may settle.
const SETTLING: usize = 1000;
/// Periods, at most, in which the frame turns into place.
const TURNING: usize = 200;

/// The six exponents.
#[derive(Clone, Debug, PartialEq)]
pub struct Lyapunov {
    /// Largest first, per unit of t.
    pub exponents: [f64; 6],
    /// The state on the attractor at which the averages begin.
    pub state: [f64; 6],
    /// How they were computed.
    pub method: String,
    /// What is known of the error: `liouville`, the distance of the exponents' sum from the trace of the Jacobian;
    /// `step`, the greatest difference between the exponents over the first and over the second half, or, on an orbit,
    /// their change when every step is halved.
    pub error: ErrorEstimate,
}

/// The exponents over `periods` mesh periods of the motion that starts at `state` (none: [`motion::default_state`]),
/// once it has settled.
///
/// Where it settles on a periodic orbit, they are taken along that orbit itself, and are the logarithms of its
/// multipliers over its period; a start on an unstable orbit, to 1e-7, gives that orbit's.
///
/// # Errors
/// [`StudyError::Option`] for an option out of range, [`StudyError::Model`] for an incommensurate load,
/// [`StudyError::Numerics`] where the motion escapes or the integration fails.
pub fn lyapunov(
    p: &Parameters,
    state: Option<[f64; 6]>,
    periods: usize,
    tolerance: f64,
) -> Result<Lyapunov, StudyError> {
    motion::check_tolerance(tolerance)?;
    let common = common_period(p)?;
    if periods == 0 || periods > MOST_PERIODS {
        return Err(StudyError::Option {
            option: "periods",
            given: periods.to_string(),
            allowed: format!("a whole number from 1 to {MOST_PERIODS}"),
        });
    }
    let pair = GearPair::new(p);
    let start = state.unwrap_or_else(|| motion::default_state(p));
    motion::check_state(&pair, &start)?;
    let begin = begin(p, start, state.is_some(), periods, tolerance)?;
    let period = p.mesh_period();
    let field = Variational { pair };
    let options = Options {
        tolerance: motion::step_tolerance(tolerance),
        step_factor: 1.0,
        steps: MOST_FRAMED_STEPS.max(STEPS_A_PERIOD * periods),
    };
    let bounds = pair.escape_bounds();
    let mut stay = |state: &[f64]| state[0].abs() <= bounds[0] && state[1].abs() <= bounds[1];
    let turning = (periods / 4).clamp(8, TURNING);
    let (fixed, state) = match begin {
        Begin::Orbit(state, length) => (Some((length, state)), state),
        Begin::State(state) => (None, state),
    };
    let mut framed = Framed::<6, SIZE>::new(0.0, &state);
    let mut series: [Vec<f64>; 6] = std::array::from_fn(|_| Vec::with_capacity(periods));
    for count in 0..turning + periods {
        // Time begins anew with every common period, so that its rounding does not grow, and, on an orbit, the state
        // with it, so that an unstable one is not left.
        let phase = match fixed {
            Some((length, state)) => {
                if count % length == 0 {
                    framed.set_state(&state);
                }
                count % length
            }
            None => count % common,
        };
        framed.time = phase as f64 * period;
        let end = (phase + 1) as f64 * period;
        let growth = framed.advance::<_, ORDER_16>(&field, end, options, &mut stay)?;
        if count >= turning {
            for (series, growth) in series.iter_mut().zip(growth) {
                series.push(growth / period);
            }
        }
    }
    let averaged = evaluate(&pair, state, &series);
    Ok(match fixed {
        Some((length, state)) => limits(&pair, &state, length, tolerance, averaged),
        None => averaged,
    })
}

/// Greatest distance of the sum of the multipliers' logarithms from the trace: above it, the smallest of them is lost
/// in the rounding of the others.
const LOST: f64 = 1e-9;

/// On a periodic orbit the averages' limits: they come near them like one over the number of periods only, where two
/// exponents are nearly or wholly alike.
fn limits(pair: &GearPair, state: &[f64; 6], length: usize, tolerance: f64, averaged: Lyapunov) -> Lyapunov {
    let duration = length as f64 * pair.parameters.mesh_period();
    let taken = |step_factor: f64| -> Result<[f64; 6], NumericsError> {
        let (_, rows) = image(pair, state, length, tolerance, step_factor, &Budget::default())?;
        let spectrum = floquet::spectrum(&matrix(&rows))?;
        Ok(std::array::from_fn(|i| spectrum.re[i].hypot(spectrum.im[i]).ln() / duration))
    };
    let (Ok(coarse), Ok(exponents)) = (taken(1.0), taken(0.5)) else { return averaged };
    let liouville = (exponents.iter().sum::<f64>() - pair.trace()).abs();
    if liouville.is_nan() || liouville > LOST {
        return averaged;
    }
    let away = largest_difference(&exponents, &averaged.exponents);
    Lyapunov {
        exponents,
        method: format!(
            "logarithms of the multipliers of the orbit of period {length} T; {} come to within {away:.0e} of them",
            averaged.method
        ),
        error: ErrorEstimate {
            liouville: Some(liouville),
            step: Some(largest_difference(&coarse, &exponents)),
            residual: None,
        },
        ..averaged
    }
}

/// Where the averages begin.
enum Begin {
    /// On an orbit of so many periods.
    Orbit([f64; 6], usize),
    /// On something else.
    State([f64; 6]),
}

fn begin(
    p: &Parameters,
    start: [f64; 6],
    given: bool,
    periods: usize,
    tolerance: f64,
) -> Result<Begin, StudyError> {
    if given && let Some(length) = settling::closed(p, &start, tolerance)? {
        return Ok(Begin::Orbit(start, length));
    }
    let most = periods / 2 + SETTLING;
    match settle(p, start, most, MOST_STEPS, tolerance)? {
        End::Orbit(orbit) => Ok(Begin::Orbit(orbit.state, orbit.period)),
        End::Escaped(time) => Err(NumericsError::Escaped { time }.into()),
        End::Wandering(state) => Ok(Begin::State(state)),
    }
}

/// Means of the growth rates, one a period.
fn evaluate(pair: &GearPair, state: [f64; 6], series: &[Vec<f64>; 6]) -> Lyapunov {
    let count = series[0].len();
    let plain = |values: &[f64]| values.iter().sum::<f64>() / values.len().max(1) as f64;
    let weighted = |values: &[f64]| birkhoff::mean(values, &birkhoff::weights(values.len()));
    // Along a quasi-periodic motion the weighted mean is far better, along a chaotic one a little worse: the halves
    // tell.
    let spread = |mean: &dyn Fn(&[f64]) -> f64| {
        let halves =
            series.iter().map(|values| (mean(&values[..count / 2]) - mean(&values[count / 2..])).abs());
        halves.fold(0.0, f64::max)
    };
    let spreads = if count < 2 { [f64::INFINITY; 2] } else { [spread(&plain), spread(&weighted)] };
    let by_weights = spreads[1] < spreads[0];
    let mut exponents: [f64; 6] =
        std::array::from_fn(|i| if by_weights { weighted(&series[i]) } else { plain(&series[i]) });
    let sum: f64 = exponents.iter().sum();
    order::descending(&mut exponents);
    let mean = if by_weights { "weighted Birkhoff averages" } else { "plain averages" };
    let step = spreads[0].min(spreads[1]);
    Lyapunov {
        exponents,
        state,
        method: format!(
            "variational Taylor series, an orthonormal frame at every step, {mean} over {count} periods"
        ),
        error: ErrorEstimate {
            liouville: Some((sum - pair.trace()).abs()),
            step: step.is_finite().then_some(step),
            residual: None,
        },
    }
}
