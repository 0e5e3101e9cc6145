//! The amplitude spectrum of the transmission error along a motion.

use super::ErrorEstimate;
use super::motion::{self, ORDER_16};
use super::poincare::Strobe;
use super::settling;
use super::time_response::largest_difference;
use crate::error::{NumericsError, StudyError};
use crate::model::equations::{GearPair, U};
use crate::model::parameters::Parameters;
use crate::numerics::ode::taylor::Options;
use crate::numerics::spectrum::{Window, amplitudes};

/// Samples of each mesh period: lines up to 32 times the mesh frequency, whose upper half stays unspoilt by what lies
/// beyond.
pub const SAMPLES: usize = 64;
/// Most periods of transient and series together.
pub const MOST_PERIODS: usize = 16_384;
/// Most steps of the integration, besides those that every period may take: a second or so.
const MOST_STEPS: usize = 150_000;
/// Steps that every period may take on average, however many are asked for.
const STEPS_A_PERIOD: usize = 40;
/// A series that ends this near where it began, relative to 1 + the largest coordinate, holds whole periods.
const CLOSED: f64 = 1e-6;

/// Amplitudes over frequency.
#[derive(Clone, Debug, PartialEq)]
pub struct AmplitudeSpectrum {
    /// Frequencies over the mesh frequency, from 0, evenly spaced by 1 over the number of periods.
    pub frequency: Vec<f64>,
    /// Amplitude of the cosine of each in `u`; at 0 the mean's modulus.
    pub amplitude: Vec<f64>,
    /// The window's name: rectangular where the motion repeats itself in the series, else Blackman-Harris.
    pub window: &'static str,
    /// How it was computed.
    pub method: String,
    /// What is known of the error: `step`, the change of the last state of the series when every step is halved.
    pub error: ErrorEstimate,
}

/// The spectrum of `u` over `periods` mesh periods after `transient` ones, from `state` (none:
/// [`motion::default_state`]).
///
/// # Errors
/// [`StudyError::Option`] for an option out of range, [`StudyError::Model`] for an incommensurate load,
/// [`StudyError::Numerics`] where the motion escapes or the integration fails.
pub fn spectrum(
    p: &Parameters,
    state: Option<[f64; 6]>,
    transient: usize,
    periods: usize,
    tolerance: f64,
) -> Result<AmplitudeSpectrum, StudyError> {
    if periods == 0 || periods > MOST_PERIODS || transient > 100 * MOST_PERIODS {
        return Err(StudyError::Option {
            option: "periods",
            given: periods.to_string(),
            allowed: format!(
                "a whole number from 1 to {MOST_PERIODS}, after a transient of at most {}",
                100 * MOST_PERIODS
            ),
        });
    }
    let most_steps = MOST_STEPS + STEPS_A_PERIOD * (transient + periods);
    let mut strobe = Strobe::new(p, state.unwrap_or_else(|| motion::default_state(p)), tolerance)?;
    let escaped = |time: f64| StudyError::Numerics(NumericsError::Escaped { time });
    for _ in 0..transient {
        if strobe.next()?.is_none() {
            return Err(escaped(strobe.escaped().unwrap_or_else(|| strobe.time())));
        }
        if strobe.steps() > most_steps {
            return Err(NumericsError::TooManySteps { time: strobe.time(), steps: strobe.steps() }.into());
        }
    }
    let pair = GearPair::new(p);
    let start = strobe.state();
    let (from, period) = (strobe.time(), p.mesh_period());
    let end = from + periods as f64 * period;
    let spacing = period / SAMPLES as f64;
    let count = periods * SAMPLES;
    let options =
        Options { tolerance: motion::step_tolerance(tolerance), step_factor: 1.0, steps: most_steps };
    let mut series = Vec::with_capacity(count);
    let reached = motion::follow::<ORDER_16>(&pair, from, start, end, options, |step, _| {
        while series.len() < count {
            let since = from + series.len() as f64 * spacing - step.start;
            // What rounding puts a hair before the step belongs to its start.
            if since > step.length {
                break;
            }
            series.push(step.value(since.max(0.0))[U]);
        }
    })?;
    if let Some(time) = reached.escaped {
        return Err(escaped(time));
    }
    let halved = Options { step_factor: 0.5, steps: 3 * most_steps, ..options };
    let check = motion::follow::<ORDER_16>(&pair, from, start, end, halved, |_, _| ())?;
    let closed = largest_difference(&reached.state, &start) < CLOSED * settling::size(&start);
    let window = if closed { Window::Rectangular } else { Window::BlackmanHarris };
    let amplitude = amplitudes(&series, window);
    Ok(AmplitudeSpectrum {
        frequency: (0..amplitude.len()).map(|line| line as f64 / periods as f64).collect(),
        amplitude,
        window: window.name(),
        method: format!(
            "Taylor series, {SAMPLES} samples a mesh period, {} window, fast Fourier transform",
            window.name()
        ),
        error: ErrorEstimate {
            step: Some(largest_difference(&reached.state, &check.state)),
            ..ErrorEstimate::default()
        },
    })
}
