//! Periodic orbits, as fixed points of the stroboscopic map found by Newton's method with its exact derivative.

use super::ErrorEstimate;
use super::gap::{is_family, keeps_displacement};
use super::load_path::{loaded, through_folds};
use super::motion::{self, ORDER_20};
use super::multipliers::{Budget, common_period, image, image_between, is_stable, trivial_state, unloaded};
use super::poincare::Strobe;
use super::time_response::largest_difference;
use crate::error::{NumericsError, StudyError};
use crate::model::equations::{DIVERGED, GearPair, U};
use crate::model::manifold;
use crate::model::parameters::{Parameters, Regime};
use crate::numerics::floquet::{self, Matrix6};
use crate::numerics::multiple_shooting;
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
    /// All multipliers inside the unit circle (undamped: on it; inside the tooth gap: but for the one of a displacement of u).
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

impl PeriodicOrbit {
    /// Where the transmission error `u` (dimensionless) stands, if the whole motion stands still to within `nothing`.
    pub fn rest(&self, nothing: f64) -> Option<f64> {
        let still = self.min.iter().zip(&self.max).all(|(min, max)| max - min < nothing);
        still.then_some(0.5 * (self.min[U] + self.max[U]))
    }
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
        let state = solve(p, guess, options, &budget).map_err(|error| none_near(p, error, options))?;
        return describe(p, state, options);
    }
    match options.period {
        period if period == common => response(p, period, options, &budget),
        2 => period_two(p, options, &budget),
        _ => from_long_motion(p, options, &budget),
    }
}

/// What a search from a guess says whose motion leaves before a period is over, or whose map has no regular derivative:
/// that there is no orbit near. The residual is then at least the distance at which motions count as escaped.
fn none_near(p: &Parameters, error: NumericsError, options: &OrbitOptions) -> NumericsError {
    match error {
        NumericsError::Escaped { .. } | NumericsError::NotFinite { .. } | NumericsError::Singular => {
            let [pinion, gear] = GearPair::new(p).escape_bounds();
            let residual = pinion.min(gear).min(DIVERGED);
            NumericsError::NoConvergence { iterations: 0, residual, tolerance: options.tolerance }
        }
        other => other,
    }
}

/// A state on an orbit, or, where one shot over the period is too long, as many states as shots.
struct Found {
    solution: newton::Solution,
    /// At equally spaced times, the first at t = 0.
    nodes: Vec<[f64; 6]>,
}

impl From<newton::Solution> for Found {
    fn from(solution: newton::Solution) -> Self {
        Self { nodes: vec![solution.point], solution }
    }
}

/// What an unknown derivative's largest entry is taken for.
const UNKNOWN: f64 = 1e10;

/// Newton's method over the whole period, or over parts of it where its multipliers are large.
fn solve(
    p: &Parameters,
    guess: [f64; 6],
    options: &OrbitOptions,
    budget: &Budget,
) -> Result<Found, NumericsError> {
    let pair = GearPair::new(p);
    let bounds = newton::Options { tolerance: options.tolerance, ..newton::Options::default() };
    let mut steepest = 0.0_f64;
    // What starts on the manifold of equal supports stays there but for rounding.
    let equal = p.symmetric().is_ok() && manifold::holds(&guess);
    let exactly = |state: &[f64; 6]| if equal { manifold::onto_manifold(state) } else { *state };
    let single = fixed_point(guess, bounds, |state| {
        let mut image = image(&pair, &exactly(state), options.period, options.tolerance, 1.0, budget);
        if let Ok((_, derivative)) = &mut image {
            steepest = derivative.iter().flatten().fold(steepest, |most, entry| most.max(entry.abs()));
            // Of a continuous family that one is found whose u the motion itself comes to.
            if keeps_displacement(derivative) {
                derivative[U] = [0.0; 6];
            }
        }
        image
    });
    // A guess that was given is believed, even where its motion does not last a period.
    let escapes = matches!(single, Err(NumericsError::Escaped { .. })) && options.guess.is_some();
    let single = single.map(|solution| newton::Solution { point: exactly(&solution.point), ..solution });
    if steepest < multiple_shooting::STEEP && !escapes {
        return single.map(Found::from);
    }
    let parts = multiple_shooting::parts(options.period, if escapes { UNKNOWN } else { steepest });
    // The solution of the single shot, which may be as good as it can be there and still not within the tolerance.
    let near = single.as_ref().map_or(guess, |solution| solution.point);
    let several = start_of_parts(p, near, options, parts)
        .and_then(|start| in_parts(&pair, start, options, bounds, budget));
    several.or_else(|error| single.map(Found::from).map_err(|_| error))
}

fn in_parts(
    pair: &GearPair,
    start: Vec<[f64; 6]>,
    options: &OrbitOptions,
    bounds: newton::Options,
    budget: &Budget,
) -> Result<Found, NumericsError> {
    let part = options.period as f64 * pair.parameters.mesh_period() / start.len() as f64;
    let nodes = multiple_shooting::solve(start, bounds, &mut |index, state| {
        let times = [index as f64 * part, (index + 1) as f64 * part];
        image_between(pair, state, times, options.tolerance, 1.0, budget)
    })?;
    let multiple_shooting::Nodes { states, residual, iterations } = nodes;
    Ok(Found { solution: newton::Solution { point: states[0], residual, iterations }, nodes: states })
}

/// States to start from: of the first half of the period forwards from the guess, of the second backwards from it, so
/// that an error of the guess grows over half of the period only.
fn start_of_parts(
    p: &Parameters,
    guess: [f64; 6],
    options: &OrbitOptions,
    parts: usize,
) -> Result<Vec<[f64; 6]>, NumericsError> {
    let part = options.period as f64 * p.mesh_period() / parts as f64;
    // The forces are even in time: run backwards, the damping alone changes its sign.
    let reversed = GearPair::new(&Parameters { zeta: -p.zeta, zeta_p: -p.zeta_p, zeta_g: -p.zeta_g, ..*p });
    let back =
        |state: [f64; 6]| -> [f64; 6] { std::array::from_fn(|i| if i < 3 { state[i] } else { -state[i] }) };
    let mut states = vec![guess; parts];
    let forwards = GearPair::new(p);
    for index in 1..=parts / 2 {
        let start = (index - 1) as f64 * part;
        let from = states[index - 1];
        states[index] =
            motion::carry(&forwards, start, from, start + part, options.tolerance.max(1e-10))?.state;
    }
    let mut state = back(guess);
    for index in 1..parts.div_ceil(2) {
        let start = (index - 1) as f64 * part;
        state = motion::carry(&reversed, start, state, start + part, options.tolerance.max(1e-10))?.state;
        states[parts - index] = back(state);
    }
    Ok(states)
}

/// The steady response: the T-periodic orbit that grows from the trivial state with the load, and where that folds
/// back before all of the load acts, the orbit that a long motion comes to; where that comes to none of this period, the
/// one that the responses lead to through their folds.
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
        return describe(p, still.into(), options);
    }
    match grown(p, options, budget) {
        Ok(found) => describe(p, found, options),
        // Whether there is time left or not: with a dead zone a long motion is what leads on.
        Err(error @ NumericsError::TooManySteps { .. }) if p.regime != Regime::Backlash => Err(error.into()),
        // Folded back before all of the load acts, as under a load at a resonance: what is left may be stable.
        Err(error) => from_long_motion(p, options, budget).or_else(|other| {
            if p.regime == Regime::Backlash {
                return Err(other);
            }
            let place = through_folds(p, period, options.tolerance, budget).map_err(|_| error)?;
            describe(p, solve(p, place, options, budget)?, options)
        }),
    }
}

/// The response that grows with the load without folding back; with a dead zone, the one that is found from the one in
/// permanent contact.
///
/// # Errors
/// [`NumericsError`] where there is none.
fn grown(p: &Parameters, options: &OrbitOptions, budget: &Budget) -> Result<Found, NumericsError> {
    if p.regime != Regime::Backlash {
        return grown_with_load(p, options, budget);
    }
    let touching = grown_with_load(&Parameters { regime: Regime::Contact, ..*p }, options, budget)?;
    solve(p, touching.solution.point, options, budget)
}

/// The state at t = 0 of that response.
///
/// # Errors
/// As there.
pub(super) fn grown_state(
    p: &Parameters,
    options: &OrbitOptions,
    budget: &Budget,
) -> Result<[f64; 6], NumericsError> {
    Ok(grown(p, options, budget)?.solution.point)
}

/// Smallest share of the load by which the response is carried on before the search is given up.
const LEAST_SHARE: f64 = 1.0 / 4096.0;

fn grown_with_load(p: &Parameters, options: &OrbitOptions, budget: &Budget) -> Result<Found, NumericsError> {
    let trivial = newton::Solution { point: trivial_state(p), residual: 0.0, iterations: 0 };
    let (mut at, mut share, mut before) = (Found::from(trivial), 0.0, None::<(f64, [f64; 6])>);
    let mut step = 0.5;
    while share < 1.0 {
        let next = f64::min(share + step, 1.0);
        // Straight on from the last two responses.
        let guess = match before {
            Some((earlier, state)) => {
                let ratio = (next - share) / (share - earlier);
                std::array::from_fn(|i| at.nodes[0][i] + ratio * (at.nodes[0][i] - state[i]))
            }
            None => at.nodes[0],
        };
        let found = solve(&loaded(p, next), guess, options, budget);
        match found {
            Ok(solution) if near(&solution.nodes[0], &guess, &at.nodes[0]) => {
                before = Some((share, at.nodes[0]));
                (at, share) = (solution, next);
                step *= 2.0;
            }
            Err(error @ NumericsError::TooManySteps { .. }) => return Err(error),
            Err(error) if step <= LEAST_SHARE => return Err(error),
            Ok(solution) if step <= LEAST_SHARE => {
                return Err(NumericsError::NoConvergence {
                    iterations: solution.solution.iterations,
                    residual: largest_difference(&solution.nodes[0], &guess),
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
    if detuning(&order[1]) < detuning(&order[0]) {
        order.reverse();
    }
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
            let time = strobe.escaped().unwrap_or_else(|| strobe.time());
            return Err(NumericsError::Escaped { time }.into());
        }
    }
    describe(p, solve(p, strobe.state(), options, budget)?, options)
}

/// True period, multipliers, extrema and errors of a solution.
fn describe(p: &Parameters, found: Found, options: &OrbitOptions) -> Result<PeriodicOrbit, StudyError> {
    let pair = GearPair::new(p);
    let Found { solution, mut nodes } = found;
    let state = solution.point;
    let period = true_period(p, &nodes, options)?;
    let shots = nodes.len();
    nodes.truncate((shots * period / options.period).max(1));
    let length = period as f64 * p.mesh_period();
    let part = length / nodes.len() as f64;
    // The derivative over the period is the product of those over its parts, each from a state that is on the orbit.
    let product = |step_factor: f64| -> Result<Matrix6, NumericsError> {
        let mut product = Matrix6::identity();
        for (index, node) in nodes.iter().enumerate() {
            let times = [index as f64 * part, (index + 1) as f64 * part];
            let (_, derivative) =
                image_between(&pair, node, times, options.tolerance, step_factor, &Budget::default())?;
            product = matrix(&derivative) * product;
        }
        Ok(product)
    };
    let (coarse, monodromy) = (product(1.0)?, product(0.5)?);
    let spectrum = floquet::spectrum(&monodromy)?;
    let step = spectrum.distance(&floquet::spectrum(&coarse)?);
    let liouville = floquet::liouville_residual(&monodromy, pair.trace() * length);
    let (mut min, mut max) = (state, state);
    for (index, node) in nodes.iter().enumerate() {
        let start = index as f64 * part;
        let (low, high) = extrema(&pair, *node, [start, start + part], options.tolerance)?;
        (0..6).for_each(|i| (min[i], max[i]) = (min[i].min(low[i]), max[i].max(high[i])));
    }
    let method = if shots == 1 {
        "Newton's method on the stroboscopic map, variational Taylor series".into()
    } else {
        format!("multiple shooting in {shots} parts, variational Taylor series")
    };
    let one_of_many = is_family(p, [min[U], max[U]], spectrum.re[1].hypot(spectrum.im[1]));
    Ok(PeriodicOrbit {
        state,
        re: spectrum.re,
        im: spectrum.im,
        stable: one_of_many || is_stable(&spectrum, pair.trace(), step),
        min,
        max,
        period,
        method,
        error: ErrorEstimate {
            liouville: Some(liouville),
            step: Some(step),
            residual: Some(solution.residual),
        },
    })
}

/// The shortest period after which the orbit returns.
fn true_period(p: &Parameters, nodes: &[[f64; 6]], options: &OrbitOptions) -> Result<usize, StudyError> {
    let common = common_period(p)?;
    let state = nodes[0];
    let size = state.iter().fold(1.0_f64, |most, value| most.max(value.abs()));
    let divides = |period: usize| options.period.is_multiple_of(period) && period.is_multiple_of(common);
    if nodes.len() > 1 {
        let returns = |period: &usize| {
            let (place, rest) =
                (nodes.len() * period / options.period, nodes.len() * period % options.period);
            rest == 0 && largest_difference(&nodes[place], &state) <= SAME * size
        };
        return Ok((1..options.period)
            .filter(|period| divides(*period))
            .find(returns)
            .unwrap_or(options.period));
    }
    let mut strobe = Strobe::new(p, state, options.tolerance)?;
    for period in 1..options.period {
        let Some(now) = strobe.next()? else { break };
        if divides(period) && largest_difference(&now, &state) <= SAME * size {
            return Ok(period);
        }
    }
    Ok(options.period)
}

/// Least and greatest value of each coordinate from one time to another.
fn extrema(
    pair: &GearPair,
    state: [f64; 6],
    [start, end]: [f64; 2],
    tolerance: f64,
) -> Result<([f64; 6], [f64; 6]), NumericsError> {
    let (mut min, mut max) = (state, state);
    let options = Options { tolerance: motion::step_tolerance(tolerance), ..Options::default() };
    let mut widen = |coordinate: usize, (low, high): (f64, f64)| {
        min[coordinate] = min[coordinate].min(low);
        max[coordinate] = max[coordinate].max(high);
    };
    motion::follow::<ORDER_20>(pair, start, state, end, options, |step, _| {
        (0..6).for_each(|i| widen(i, event::range(&step.coordinate(i), step.length)));
    })?;
    Ok((min, max))
}
