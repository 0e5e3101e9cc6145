//! Periodic orbits, as fixed points of the stroboscopic map found by Newton's method with its exact derivative.

use super::ErrorEstimate;
use super::motion::{self, ORDER_20};
use super::multipliers::{Budget, common_period, image, is_stable, trivial_state, unloaded};
use super::poincare::Strobe;
use super::time_response::largest_difference;
use crate::error::{NumericsError, StudyError};
use crate::model::equations::GearPair;
use crate::model::parameters::{Parameters, Regime};
use crate::numerics::floquet;
use crate::numerics::newton;
use crate::numerics::ode::event;
use crate::numerics::ode::taylor::Options;
use crate::numerics::periodic::{fixed_point, matrix};
use crate::theory::{self, Mode, Modes, branches};

/// Greatest period, in mesh periods.
pub const LONGEST: usize = 64;

/// What to look for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OrbitOptions {
    /// Period in mesh periods, 1 to [`LONGEST`]; 1 stands for the common period of mesh and load.
    pub period: usize,
    /// A state near the orbit at t = 0; none: the steady response for period 1, \[T7\] for period 2, the end of a
    /// long motion for longer ones.
    pub guess: Option<[f64; 6]>,
    /// Tolerance of the states, 1e-14 to 1e-3.
    pub tolerance: f64,
}

impl Default for OrbitOptions {
    fn default() -> Self {
        Self { period: 1, guess: None, tolerance: 1e-10 }
    }
}

/// A periodic orbit.
#[derive(Clone, Debug, PartialEq)]
pub struct PeriodicOrbit {
    /// State at t = 0.
    pub state: [f64; 6],
    /// Real parts of the multipliers over its true period, largest modulus first.
    pub re: [f64; 6],
    /// Imaginary parts.
    pub im: [f64; 6],
    /// All multipliers inside the unit circle (undamped: on it).
    pub stable: bool,
    /// Least value of each coordinate over the orbit.
    pub min: [f64; 6],
    /// Greatest value of each coordinate over the orbit.
    pub max: [f64; 6],
    /// The true period, in mesh periods: a divisor of the one asked for.
    pub period: usize,
    /// How it was computed.
    pub method: String,
    /// What is known of the error: `residual` of the map, `liouville`, and `step`, the change of the multipliers
    /// when every step is halved.
    pub error: ErrorEstimate,
}

/// Two states nearer than this are one orbit's, when its true period is looked for.
const SAME: f64 = 1e-7;

/// Finds a periodic orbit.
///
/// # Errors
/// [`StudyError::Option`] for an option out of range, [`StudyError::Model`] for an incommensurate load,
/// [`StudyError::Numerics`] with the residual where none is found.
pub fn periodic_orbit(p: &Parameters, options: &OrbitOptions) -> Result<PeriodicOrbit, StudyError> {
    motion::check_tolerance(options.tolerance)?;
    let common = common_period(p)?;
    // The shortest period there can be is what "period 1" means under a load of longer period than the mesh.
    let options =
        &OrbitOptions { period: if options.period == 1 { common } else { options.period }, ..*options };
    if options.period == 0 || options.period > LONGEST || !options.period.is_multiple_of(common) {
        let allowed = if common == 1 {
            format!("a whole number from 1 to {LONGEST}")
        } else {
            format!("a multiple of {common}, the common period of mesh and load, up to {LONGEST}")
        };
        return Err(StudyError::Option { option: "period", given: options.period.to_string(), allowed });
    }
    let budget = Budget::default();
    if let Some(guess) = options.guess {
        motion::check_state(&GearPair::new(p), &guess)?;
        let state = solve(p, guess, options, &budget)?;
        return describe(p, state, options);
    }
    match options.period {
        period if period == common => response(p, period, options, &budget),
        2 => period_two(p, options, &budget),
        _ => from_long_motion(p, options, &budget),
    }
}

fn solve(
    p: &Parameters,
    guess: [f64; 6],
    options: &OrbitOptions,
    budget: &Budget,
) -> Result<newton::Solution, NumericsError> {
    let pair = GearPair::new(p);
    let bounds = newton::Options { tolerance: options.tolerance, ..newton::Options::default() };
    fixed_point(guess, bounds, |state| image(&pair, state, options.period, options.tolerance, 1.0, budget))
}

/// The steady response: the T-periodic orbit that grows from the trivial state with the load.
///
/// In the backlash regime it is looked for in permanent contact first; where that response parts the teeth, it is
/// the guess for the true one, and where this fails, the end of a long motion is.
///
/// # Errors
/// As [`periodic_orbit`].
pub fn response(
    p: &Parameters,
    period: usize,
    options: &OrbitOptions,
    budget: &Budget,
) -> Result<PeriodicOrbit, StudyError> {
    let options = &OrbitOptions { period, ..*options };
    if unloaded(p) {
        let still = newton::Solution { point: trivial_state(p), residual: 0.0, iterations: 0 };
        return describe(p, still, options);
    }
    if p.regime != Regime::Backlash {
        return describe(p, grown_with_load(p, options, budget)?, options);
    }
    let contact = Parameters { regime: Regime::Contact, ..*p };
    if let Ok(solution) = grown_with_load(&contact, options, budget)
        && let Ok(parted) = solve(p, solution.point, options, budget)
    {
        return describe(p, parted, options);
    }
    from_long_motion(p, options, budget)
}

/// Smallest share of the load by which the response is carried on before the search is given up.
const LEAST_SHARE: f64 = 1.0 / 4096.0;

fn grown_with_load(
    p: &Parameters,
    options: &OrbitOptions,
    budget: &Budget,
) -> Result<newton::Solution, NumericsError> {
    let loaded = |share: f64| Parameters {
        load: share * p.load,
        load_p: share * p.load_p,
        load_g: share * p.load_g,
        error: share * p.error,
        ..*p
    };
    let trivial = newton::Solution { point: trivial_state(p), residual: 0.0, iterations: 0 };
    let (mut at, mut share, mut before) = (trivial, 0.0, None::<(f64, [f64; 6])>);
    let mut step = 0.5;
    while share < 1.0 {
        let next = f64::min(share + step, 1.0);
        // Straight on from the last two responses.
        let guess = match before {
            Some((earlier, state)) => {
                let ratio = (next - share) / (share - earlier);
                std::array::from_fn(|i| at.point[i] + ratio * (at.point[i] - state[i]))
            }
            None => at.point,
        };
        let found = solve(&loaded(next), guess, options, budget);
        match found {
            Ok(solution) if near(&solution.point, &guess, &at.point) => {
                before = Some((share, at.point));
                (at, share) = (solution, next);
                step *= 2.0;
            }
            Err(error @ NumericsError::TooManySteps { .. }) => return Err(error),
            Err(error) if step <= LEAST_SHARE => return Err(error),
            Ok(solution) if step <= LEAST_SHARE => {
                return Err(NumericsError::NoConvergence {
                    iterations: solution.iterations,
                    residual: largest_difference(&solution.point, &guess),
                    tolerance: options.tolerance,
                });
            }
            _ => step *= 0.5,
        }
    }
    Ok(at)
}

/// Whether a solution continues the branch: not further from the prediction than the prediction, or a fair step,
/// from the last solution.
fn near(solution: &[f64; 6], guess: &[f64; 6], last: &[f64; 6]) -> bool {
    let size = last.iter().fold(1.0_f64, |most, value| most.max(value.abs()));
    largest_difference(solution, guess) <= size.max(2.0 * largest_difference(guess, last))
}

/// Factors by which the first-order amplitude of \[T7\] is tried; the true one is smaller where k0 is not small.
const AMPLITUDES: [f64; 8] = [1.0, 0.8, 0.6, 0.45, 0.3, 0.2, 0.1, 1.3];

/// A stable orbit of period 2T where one is found, else an unstable one, else the orbit of period T that every
/// search comes to.
fn period_two(p: &Parameters, options: &OrbitOptions, budget: &Budget) -> Result<PeriodicOrbit, StudyError> {
    let mut unstable = None;
    for guess in period_two_guesses(p) {
        let solution = match solve(p, guess, options, budget) {
            Ok(solution) => solution,
            Err(error @ NumericsError::TooManySteps { .. }) => return Err(error.into()),
            Err(_) => continue,
        };
        let orbit = describe(p, solution, options)?;
        if orbit.period == 2 {
            if orbit.stable {
                return upper_half(p, orbit, options, budget);
            }
            unstable.get_or_insert(orbit);
        }
    }
    let settled = from_long_motion(p, options, budget);
    match (settled, unstable) {
        (Ok(orbit), _) if orbit.period == 2 => upper_half(p, orbit, options, budget),
        (_, Some(orbit)) => upper_half(p, orbit, options, budget),
        (settled, None) => settled,
    }
}

/// The orbit's state at t = 0 has two values, one mesh period apart; the one with the greater `u_p` is given.
fn upper_half(
    p: &Parameters,
    orbit: PeriodicOrbit,
    options: &OrbitOptions,
    budget: &Budget,
) -> Result<PeriodicOrbit, StudyError> {
    let mut strobe = Strobe::new(p, orbit.state, options.tolerance)?;
    match strobe.next()? {
        Some(other) if other[0] > orbit.state[0] => {
            let solution = solve(p, other, options, budget)?;
            describe(p, solution, options)
        }
        _ => Ok(orbit),
    }
}

/// First-order states of \[T7\], the tongue nearest to Omega first, each at several parts of its amplitude.
fn period_two_guesses(p: &Parameters) -> Vec<[f64; 6]> {
    let Ok(symmetric) = p.symmetric() else { return Vec::new() };
    let Ok(modes) = Modes::of(&symmetric) else { return Vec::new() };
    let centre = trivial_state(p);
    let mut order = [Mode::Second, Mode::Third];
    let detuning = |mode: &Mode| (p.omega - 2.0 * modes.frequency(*mode)).abs();
    order.sort_unstable_by(|left, right| detuning(left).total_cmp(&detuning(right)));
    let mut guesses = Vec::new();
    for mode in order {
        let Ok(orbits) = theory::period_two(&symmetric, mode) else { continue };
        for orbit in orbits.into_iter().flatten() {
            for factor in AMPLITUDES {
                let state =
                    branches::orbit_state(&modes, &symmetric, mode, factor * orbit.radius, orbit.angle);
                guesses.push(std::array::from_fn(|i| centre[i] + state[i]));
            }
        }
    }
    guesses
}

/// Periods after which a motion is taken to have settled near its attractor.
const SETTLING: usize = 600;

fn from_long_motion(
    p: &Parameters,
    options: &OrbitOptions,
    budget: &Budget,
) -> Result<PeriodicOrbit, StudyError> {
    let mut strobe = Strobe::new(p, motion::default_state(p), options.tolerance.max(1e-10))?;
    for _ in 0..SETTLING {
        if strobe.steps() > budget.left() {
            return Err(NumericsError::TooManySteps { time: strobe.time(), steps: strobe.steps() }.into());
        }
        if strobe.next()?.is_none() {
            let time = strobe.escaped().unwrap_or(f64::INFINITY);
            return Err(NumericsError::Escaped { time }.into());
        }
    }
    describe(p, solve(p, strobe.state(), options, budget)?, options)
}

/// True period, multipliers, extrema and errors of a solution.
fn describe(
    p: &Parameters,
    solution: newton::Solution,
    options: &OrbitOptions,
) -> Result<PeriodicOrbit, StudyError> {
    let pair = GearPair::new(p);
    let state = solution.point;
    let period = true_period(p, &state, options)?;
    let (_, coarse) = image(&pair, &state, period, options.tolerance, 1.0, &Budget::default())?;
    let (_, derivative) = image(&pair, &state, period, options.tolerance, 0.5, &Budget::default())?;
    let monodromy = matrix(&derivative);
    let spectrum = floquet::spectrum(&monodromy)?;
    let step = spectrum.distance(&floquet::spectrum(&matrix(&coarse))?);
    let length = period as f64 * p.mesh_period();
    let liouville = floquet::liouville_residual(&monodromy, pair.trace() * length);
    let (min, max) = extrema(&pair, state, length, options.tolerance)?;
    Ok(PeriodicOrbit {
        state,
        re: spectrum.re,
        im: spectrum.im,
        stable: is_stable(&spectrum, pair.trace(), step),
        min,
        max,
        period,
        method: "Newton's method on the stroboscopic map, variational Taylor series".into(),
        error: ErrorEstimate {
            liouville: Some(liouville),
            step: Some(step),
            residual: Some(solution.residual),
        },
    })
}

fn true_period(p: &Parameters, state: &[f64; 6], options: &OrbitOptions) -> Result<usize, StudyError> {
    let common = common_period(p)?;
    let size = state.iter().fold(1.0_f64, |most, value| most.max(value.abs()));
    let mut strobe = Strobe::new(p, *state, options.tolerance)?;
    for period in 1..options.period {
        let Some(now) = strobe.next()? else { break };
        let divides = options.period.is_multiple_of(period) && period.is_multiple_of(common);
        if divides && largest_difference(&now, state) <= SAME * size {
            return Ok(period);
        }
    }
    Ok(options.period)
}

/// Least and greatest value of each coordinate from t = 0 to `length`.
fn extrema(
    pair: &GearPair,
    state: [f64; 6],
    length: f64,
    tolerance: f64,
) -> Result<([f64; 6], [f64; 6]), NumericsError> {
    let (mut min, mut max) = (state, state);
    let options = Options { tolerance: motion::step_tolerance(tolerance), ..Options::default() };
    let mut widen = |coordinate: usize, (low, high): (f64, f64)| {
        min[coordinate] = min[coordinate].min(low);
        max[coordinate] = max[coordinate].max(high);
    };
    motion::follow::<ORDER_20>(pair, 0.0, state, length, options, |step, _| {
        (0..6).for_each(|i| widen(i, event::range(&step.coordinate(i), step.length)));
    })?;
    Ok((min, max))
}
