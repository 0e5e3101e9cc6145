//! Sweeps of the mesh frequency, up or down, the state carried over from one frequency to the next: the brute-force
//! bifurcation diagram, with its hysteresis.

use super::ErrorEstimate;
use super::grid::Grid;
use super::motion;
use super::multipliers::SLICE;
use super::poincare::Strobe;
use super::time_response::{MOST_ROWS, largest_difference};
use crate::error::{NumericsError, StudyError};
use crate::model::equations::U;
use crate::model::parameters::Parameters;

/// Most integration steps of a sweep, besides those that every period may take: a second or so.
const MOST_STEPS: usize = 500_000;
/// Steps that every period may take on average, however many are asked for.
const STEPS_A_PERIOD: usize = 40;

/// Which way the frequency goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// From the lowest frequency to the highest.
    Up,
    /// From the highest to the lowest.
    Down,
}

impl Direction {
    /// The words for them, upwards first.
    pub const NAMES: [&'static str; 2] = ["up", "down"];

    /// Its word.
    pub fn name(self) -> &'static str {
        Self::NAMES[usize::from(self == Self::Down)]
    }

    /// The direction of that name.
    ///
    /// # Errors
    /// [`StudyError::Option`] where there is none.
    pub fn from_name(name: &str) -> Result<Self, StudyError> {
        match name {
            "up" => Ok(Self::Up),
            "down" => Ok(Self::Down),
            _ => Err(StudyError::Option {
                option: "direction",
                given: name.into(),
                allowed: Self::NAMES.join(" or "),
            }),
        }
    }
}

/// What to compute.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SweepOptions {
    /// The mesh frequencies.
    pub omega: Grid,
    /// Which way they are passed.
    pub direction: Direction,
    /// Periods left out at each frequency before points are taken.
    pub transient: usize,
    /// Points taken at each frequency, at least 1; in all at most a million.
    pub points: usize,
    /// State at the first frequency; none: [`motion::default_state`].
    pub state: Option<[f64; 6]>,
    /// Tolerance of the states, 1e-14 to 1e-3.
    pub tolerance: f64,
}

impl SweepOptions {
    /// Upwards, 200 periods left out and 40 points at each frequency, to 1e-8.
    pub fn new(omega: Grid) -> Self {
        Self { omega, direction: Direction::Up, transient: 200, points: 40, state: None, tolerance: 1e-8 }
    }
}

/// Stroboscopic points, frequency after frequency.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sweep {
    /// Mesh frequency of each point.
    pub omega: Vec<f64>,
    /// `u_p` of each point.
    pub u_p: Vec<f64>,
    /// `u` of each point.
    pub u: Vec<f64>,
    /// The frequency at which the motion escaped; the sweep ends there.
    pub escaped: Option<f64>,
    /// How it was computed.
    pub method: String,
    /// What is known of the error: `step`, the greatest change of a state over one period, of one period at each
    /// frequency, when the tolerance is a hundredth.
    pub error: ErrorEstimate,
}

/// By so much the state is disturbed at each new frequency, as in any real machine; a little off the manifold
/// `u_g = -u_p`, so that no instability is hidden by symmetry.
const DISTURBANCE: [f64; 6] = [-4e-4, 4.2e-4, 1e-3, 0.0, 0.0, 0.0];

/// The parameters at another mesh frequency. The loads' frequencies keep their ratio to it, as those of shafts do that
/// turn with the teeth.
pub fn at_frequency(p: &Parameters, omega: f64) -> Parameters {
    // A ratio of 1 is kept to the last bit.
    let scaled = |own: f64| if own == p.omega { omega } else { own / p.omega * omega };
    Parameters { omega, omega_p: scaled(p.omega_p), omega_g: scaled(p.omega_g), ..*p }
}

/// A sweep in the making.
#[derive(Clone, Debug)]
pub struct SweepWork {
    parameters: Parameters,
    options: SweepOptions,
    /// Frequencies completed.
    done: usize,
    /// The present frequency's map.
    strobe: Option<Strobe>,
    state: [f64; 6],
    steps: usize,
    most_steps: usize,
    sweep: Sweep,
}

impl SweepWork {
    /// Prepares a sweep.
    ///
    /// # Errors
    /// [`StudyError::Option`] for an option out of range; [`StudyError::Model`] for an incommensurate load.
    pub fn new(p: &Parameters, options: &SweepOptions) -> Result<Self, StudyError> {
        let points = options.points as f64;
        let periods = (points + options.transient as f64) * options.omega.count as f64;
        if options.points == 0 || points * options.omega.count as f64 > MOST_ROWS || periods > 2e7 {
            return Err(StudyError::Option {
                option: "points",
                given: options.points.to_string(),
                allowed: format!(
                    "at least 1, in all at most {MOST_ROWS:e}, and with the transients at most 2e7 periods"
                ),
            });
        }
        let state = options.state.unwrap_or_else(|| motion::default_state(p));
        // Refuses what is out of range before any work is done.
        Strobe::new(p, state, options.tolerance)?;
        let method = format!(
            "Taylor series, sampled at every mesh period, Omega {}, the state carried over",
            options.direction.name()
        );
        Ok(Self {
            parameters: *p,
            options: *options,
            done: 0,
            strobe: None,
            state,
            steps: 0,
            most_steps: MOST_STEPS + STEPS_A_PERIOD * periods as usize,
            sweep: Sweep { method, ..Sweep::default() },
        })
    }

    /// Does a slice of the work; true when all is done.
    ///
    /// # Errors
    /// [`StudyError::Numerics`] where the integration fails or takes too many steps in all.
    pub fn advance(&mut self) -> Result<bool, StudyError> {
        let until = self.steps + SLICE;
        while self.steps < until {
            if self.finished() {
                return Ok(true);
            }
            let mut strobe = match self.strobe.take() {
                Some(strobe) => strobe,
                None => self.begin()?,
            };
            let before = strobe.steps();
            let next = strobe.next()?;
            self.steps += strobe.steps() - before;
            if self.steps > self.most_steps {
                return Err(NumericsError::TooManySteps { time: strobe.time(), steps: self.steps }.into());
            }
            let Some(state) = next else {
                self.sweep.escaped = Some(self.frequency());
                return Ok(true);
            };
            let periods = strobe.periods() as usize;
            if periods == 1 {
                self.check(&state)?;
            }
            self.state = state;
            if periods > self.options.transient {
                self.sweep.omega.push(self.frequency());
                self.sweep.u_p.push(state[0]);
                self.sweep.u.push(state[U]);
            }
            if periods >= self.options.transient + self.options.points {
                self.done += 1;
            } else {
                self.strobe = Some(strobe);
            }
        }
        Ok(self.finished())
    }

    /// The points so far.
    pub fn sweep(&self) -> &Sweep {
        &self.sweep
    }

    /// The share of the frequencies that is done, 0 to 1.
    pub fn progress(&self) -> f64 {
        self.done as f64 / self.options.omega.count as f64
    }

    fn finished(&self) -> bool {
        self.done >= self.options.omega.count || self.sweep.escaped.is_some()
    }

    fn frequency(&self) -> f64 {
        let grid = &self.options.omega;
        match self.options.direction {
            Direction::Up => grid.value(self.done),
            Direction::Down => grid.value(grid.count - 1 - self.done),
        }
    }

    /// Goes to the next frequency. Every one begins at t = 0, where the mesh stiffness is greatest, as the one before
    /// ended at such a time.
    fn begin(&self) -> Result<Strobe, StudyError> {
        let p = at_frequency(&self.parameters, self.frequency());
        // A motion that has settled to the last bit would stay where it is when that becomes unstable.
        let state = std::array::from_fn(|index| self.state[index] + DISTURBANCE[index]);
        Strobe::new(&p, state, self.options.tolerance)
    }

    /// The error of one period at this frequency.
    fn check(&mut self, reached: &[f64; 6]) -> Result<(), StudyError> {
        let p = at_frequency(&self.parameters, self.frequency());
        let finer = (0.01 * self.options.tolerance).max(motion::TOLERANCE.0);
        let mut strobe = Strobe::new(&p, self.state, finer)?;
        if let Some(state) = strobe.next()? {
            let change = largest_difference(&state, reached);
            let most = self.sweep.error.step.map_or(change, |most| most.max(change));
            self.sweep.error.step = Some(most);
        }
        self.steps += strobe.steps();
        Ok(())
    }
}

/// Sweeps the mesh frequency.
///
/// # Errors
/// As [`SweepWork`].
pub fn sweep(p: &Parameters, options: &SweepOptions) -> Result<Sweep, StudyError> {
    let mut work = SweepWork::new(p, options)?;
    while !work.advance()? {}
    Ok(work.sweep)
}
