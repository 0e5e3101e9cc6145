//! The stroboscopic map: the state at every whole mesh period, t = n T, where cos(Omega t) = 1.

use super::ErrorEstimate;
use super::motion;
use super::time_response::{MOST_ROWS, largest_difference};
use crate::error::StudyError;
use crate::model::equations::GearPair;
use crate::model::parameters::Parameters;

/// A stroboscopic map that is advanced period by period.
#[derive(Clone, Debug)]
pub struct Strobe {
    pair: GearPair,
    state: [f64; 6],
    periods: u64,
    tolerance: f64,
    escaped: Option<f64>,
    steps: usize,
}

impl Strobe {
    /// Starts at `state` at t = 0.
    ///
    /// # Errors
    /// [`StudyError::Option`] for a state or tolerance out of range; [`StudyError::Model`] where a fluctuating load
    /// is incommensurate with the mesh.
    pub fn new(p: &Parameters, state: [f64; 6], tolerance: f64) -> Result<Self, StudyError> {
        let pair = GearPair::new(p);
        super::multipliers::common_period(p)?;
        motion::check_tolerance(tolerance)?;
        motion::check_state(&pair, &state)?;
        Ok(Self { pair, state, periods: 0, tolerance, escaped: None, steps: 0 })
    }

    /// The state one period later; none once the motion has escaped.
    ///
    /// # Errors
    /// [`StudyError::Numerics`] where the integration fails.
    #[allow(clippy::should_implement_trait, reason = "it can fail, which an iterator cannot say as plainly")]
    pub fn next(&mut self) -> Result<Option<[f64; 6]>, StudyError> {
        if self.escaped.is_some() {
            return Ok(None);
        }
        let period = self.pair.parameters.mesh_period();
        let (start, end) = (self.periods as f64 * period, (self.periods + 1) as f64 * period);
        let reached = motion::carry(&self.pair, start, self.state, end, self.tolerance)?;
        self.state = reached.state;
        self.steps += reached.steps;
        self.periods += 1;
        self.escaped = reached.escaped;
        Ok(if self.escaped.is_some() { None } else { Some(self.state) })
    }

    /// Time of escape, if it has escaped.
    pub fn escaped(&self) -> Option<f64> {
        self.escaped
    }

    /// Present state: at the end of the last period, or where it escaped.
    pub fn state(&self) -> [f64; 6] {
        self.state
    }

    /// Integration steps taken so far.
    pub fn steps(&self) -> usize {
        self.steps
    }

    /// Time at the end of the last period.
    pub fn time(&self) -> f64 {
        self.periods as f64 * self.pair.parameters.mesh_period()
    }

    /// Periods completed.
    pub fn periods(&self) -> u64 {
        self.periods
    }
}

/// What to compute.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PoincareOptions {
    /// State at t = 0.
    pub state: [f64; 6],
    /// Periods to leave out first.
    pub transient: usize,
    /// Points to give, at least 1; with the transient at most a million.
    pub points: usize,
    /// Tolerance of the states, 1e-14 to 1e-3.
    pub tolerance: f64,
}

impl PoincareOptions {
    /// 1000 points after no transient from [`motion::default_state`] to 1e-10.
    pub fn new(p: &Parameters) -> Self {
        Self { state: motion::default_state(p), transient: 0, points: 1000, tolerance: 1e-10 }
    }
}

/// Points of the stroboscopic map.
#[derive(Clone, Debug, PartialEq)]
pub struct Poincare {
    /// The states, the first at t = transient T.
    pub states: Vec<[f64; 6]>,
    /// Time of escape; the points end before it.
    pub escaped: Option<f64>,
    /// How it was computed.
    pub method: String,
    /// What is known of the error: `step` is the change of the state after the first period when the tolerance is
    /// a hundredth.
    pub error: ErrorEstimate,
}

/// Computes points of the stroboscopic map.
///
/// # Errors
/// As [`Strobe`]; [`StudyError::Option`] for a number of points out of range.
pub fn poincare(p: &Parameters, options: &PoincareOptions) -> Result<Poincare, StudyError> {
    let all = options.transient as f64 + options.points as f64;
    if options.points == 0 || all > MOST_ROWS {
        return Err(StudyError::Option {
            option: "points",
            given: options.points.to_string(),
            allowed: format!("at least 1, and with the transient at most {MOST_ROWS:e}"),
        });
    }
    let mut strobe = Strobe::new(p, options.state, options.tolerance)?;
    let mut states = Vec::new();
    if options.transient == 0 {
        states.push(options.state);
    }
    let mut first = None;
    for index in 1..options.transient + options.points {
        let Some(state) = strobe.next()? else { break };
        first.get_or_insert(state);
        if index >= options.transient {
            states.push(state);
        }
    }
    let step = match first {
        Some(state) => {
            let finer = (options.tolerance * 0.01).max(motion::TOLERANCE.0);
            let mut check = Strobe::new(p, options.state, finer)?;
            check.next()?.map(|checked| largest_difference(&state, &checked))
        }
        None => None,
    };
    Ok(Poincare {
        states,
        escaped: strobe.escaped(),
        method: "Taylor series, sampled at every mesh period".into(),
        error: ErrorEstimate { step, ..ErrorEstimate::default() },
    })
}
