//! Floquet multipliers: about the unloaded state, or about the periodic response of a loaded pair.

use std::cell::Cell;

use super::ErrorEstimate;
use super::motion::{self, ORDER_16, ORDER_20, ORDER_24};
use super::orbit::{self, OrbitOptions};
use super::slices;
use crate::error::{ModelError, NumericsError, StudyError};
use crate::model::equations::GearPair;
use crate::model::linear::{self, LinearPair, Rows};
use crate::model::manifold::{self, Manifold};
use crate::model::parameters::{Parameters, Regime};
use crate::model::variational::{self, Variational};
use crate::numerics::floquet::{self, Spectrum};
use crate::numerics::ode::taylor::{self, Options, Propagation, TaylorField};
use crate::numerics::periodic::{Image, matrix};

/// Greatest denominator of a load's frequency over the mesh frequency.
pub const MOST_PERIODS: usize = 64;
/// How near to a fraction the ratio of the frequencies must be, relative to it.
const COMMENSURATE_WITHIN: f64 = 1e-9;

/// The six multipliers.
#[derive(Clone, Debug, PartialEq)]
pub struct Multipliers {
    /// Real parts, largest modulus first.
    pub re: [f64; 6],
    /// Imaginary parts.
    pub im: [f64; 6],
    /// Largest modulus.
    pub spectral_radius: f64,
    /// All moduli are below 1 by more than the error of the answer, or, undamped, none above 1 by more; of a response
    /// inside the tooth gap all but the one of a displacement of u.
    pub stable: bool,
    /// The periodic state at t = 0 that they are about.
    pub state: [f64; 6],
    /// How they were computed.
    pub method: String,
    /// What is known of the error: `liouville`; `step`, the change when every step is halved; for a periodic
    /// response its `residual`.
    pub error: ErrorEstimate,
}

/// The common period of mesh and load, in mesh periods: 1 to [`MOST_PERIODS`].
///
/// # Errors
/// [`ModelError::Incommensurate`] with the load that has no common period with the mesh.
pub fn common_period(p: &Parameters) -> Result<usize, ModelError> {
    let mut common = 1;
    for (parameter, amplitude, given) in [("Omega_p", p.load_p, p.omega_p), ("Omega_g", p.load_g, p.omega_g)]
    {
        if amplitude == 0.0 {
            continue;
        }
        let ratio = given / p.omega;
        let matches = |periods: usize| {
            let turns = ratio * periods as f64;
            turns.round() >= 1.0 && (turns - turns.round()).abs() <= COMMENSURATE_WITHIN * turns.round()
        };
        let incommensurate = ModelError::Incommensurate { parameter, given, omega: p.omega };
        let own =
            (1..=MOST_PERIODS).find(|&periods| matches(periods)).ok_or_else(|| incommensurate.clone())?;
        common = least_common_multiple(common, own);
        if common > MOST_PERIODS * MOST_PERIODS {
            return Err(incommensurate);
        }
    }
    Ok(common)
}

fn least_common_multiple(left: usize, right: usize) -> usize {
    let (mut a, mut b) = (left, right);
    while b != 0 {
        (a, b) = (b, a % b);
    }
    left / a * right
}

/// Whether nothing acts on the teeth, so that the motion's trivial state is exact.
pub fn unloaded(p: &Parameters) -> bool {
    [p.load, p.load_p, p.load_g, p.error].iter().all(|load| *load == 0.0)
}

/// The trivial state of an unloaded pair.
pub fn trivial_state(p: &Parameters) -> [f64; 6] {
    match p.regime {
        Regime::Homogeneous => [0.0; 6],
        Regime::Contact | Regime::Backlash => [0.0, 0.0, 1.0, 0.0, 0.0, 0.0],
    }
}

/// Most steps over half a period: stiff and slow corners of the ranges need more, and are refused.
const LINEAR_STEPS: usize = 400_000;

/// The monodromy over one mesh period of the linear problem in its symmetric coordinates, from half a period.
///
/// # Errors
/// [`NumericsError`] where the integration fails.
pub fn linear_monodromy(p: &Parameters, tolerance: f64, step_factor: f64) -> Result<Rows, NumericsError> {
    let pair = LinearPair::new(p);
    let options = Options { tolerance: motion::step_tolerance(tolerance), step_factor, steps: LINEAR_STEPS };
    let half_period = 0.5 * p.mesh_period();
    let half = taylor::integrate::<_, { linear::SIZE }, ORDER_24>(
        &pair,
        0.0,
        linear::start(),
        half_period,
        options,
    )?;
    Ok(pair.monodromy_from_half(&linear::rows(&half)))
}

/// The multipliers of [`linear_monodromy`].
///
/// # Errors
/// As there, or as [`floquet::spectrum`].
pub fn linear_spectrum(p: &Parameters, tolerance: f64) -> Result<Spectrum, NumericsError> {
    floquet::spectrum(&matrix(&linear_monodromy(p, tolerance, 1.0)?))
}

/// Steps that a search may take in all its integrations: some seconds at most, a hundred times what ordinary
/// parameters need. Stiff and slow corners of the ranges would otherwise take minutes.
#[derive(Clone, Debug)]
pub struct Budget {
    left: Cell<usize>,
    /// What was left at the last pause.
    at_pause: Cell<usize>,
}

/// Steps between two pauses: some milliseconds.
pub(crate) const SLICE: usize = 4000;

impl Default for Budget {
    fn default() -> Self {
        Self::of(200_000)
    }
}

impl Budget {
    /// A budget of this many steps.
    pub fn of(steps: usize) -> Self {
        Self { left: Cell::new(steps), at_pause: Cell::new(steps) }
    }

    /// Steps that are left.
    pub fn left(&self) -> usize {
        self.left.get()
    }

    /// Takes off steps that were taken.
    pub fn spend(&self, steps: usize) {
        self.left.set(self.left.get().saturating_sub(steps));
    }

    /// Ends the slice where enough has been spent since the last one ended.
    pub(crate) async fn rest(&self) {
        if self.at_pause.get() - self.left.get() >= SLICE {
            self.at_pause.set(self.left.get());
            slices::pause().await;
        }
    }
}

/// The state after `periods` mesh periods and its derivative by the state at t = 0, along the full nonlinear motion.
///
/// # Errors
/// [`NumericsError::Escaped`] where the motion escapes, [`NumericsError::TooManySteps`] where the budget is spent, or
/// as the integration fails.
pub fn image(
    pair: &GearPair,
    state: &[f64; 6],
    periods: usize,
    tolerance: f64,
    step_factor: f64,
    budget: &Budget,
) -> Result<Image, NumericsError> {
    let end = periods as f64 * pair.parameters.mesh_period();
    image_between(pair, state, [0.0, end], tolerance, step_factor, budget)
}

/// As [`image`], from one time to another. On the manifold `u_g = -u_p` of equal supports half as many numbers do.
///
/// # Errors
/// As [`image`].
pub fn image_between(
    pair: &GearPair,
    state: &[f64; 6],
    times: [f64; 2],
    tolerance: f64,
    step_factor: f64,
    budget: &Budget,
) -> Result<Image, NumericsError> {
    let options = (tolerance, step_factor);
    if let Some(field) = Manifold::of(&pair.parameters).filter(|_| manifold::holds(state)) {
        let start = manifold::start(state);
        let end = carried::<_, _, ORDER_16>(&field, start, 0, pair, times, options, budget)?;
        return Ok(manifold::split(&end));
    }
    let field = Variational { pair: *pair };
    let start = variational::start(state);
    let end = carried::<_, _, ORDER_20>(&field, start, 1, pair, times, options, budget)?;
    Ok(variational::split(&end))
}

/// The end of a motion from one time to another; `gear` is the place of a number that is as great as the gear's displacement.
fn carried<F: TaylorField<N>, const N: usize, const LEN: usize>(
    field: &F,
    start: [f64; N],
    gear: usize,
    pair: &GearPair,
    [from, until]: [f64; 2],
    (tolerance, step_factor): (f64, f64),
    budget: &Budget,
) -> Result<[f64; N], NumericsError> {
    let options = Options { tolerance: motion::step_tolerance(tolerance), step_factor, steps: budget.left() };
    let mut propagation = Propagation::<_, N, LEN>::new(field, from, start, options);
    let bounds = pair.escape_bounds();
    while propagation.time() < until {
        propagation.advance(until)?;
        budget.spend(1);
        let now = propagation.state();
        if now[0].abs() > bounds[0] || now[gear].abs() > bounds[1] {
            return Err(NumericsError::Escaped { time: propagation.time() });
        }
    }
    Ok(*propagation.state())
}

/// The multipliers at these parameters.
///
/// Unloaded: of the exact linear problem about the trivial state (in the backlash regime that of teeth that just
/// touch, for deviations that keep contact). Loaded: about the periodic response that continues the trivial state
/// as the load grows, over the common period of mesh and load.
///
/// # Errors
/// [`StudyError::Option`] for a tolerance out of range, [`StudyError::Model`] for an incommensurate load,
/// [`StudyError::Numerics`] where no periodic response is found.
pub fn multipliers(p: &Parameters, tolerance: f64) -> Result<Multipliers, StudyError> {
    motion::check_tolerance(tolerance)?;
    if unloaded(p) {
        return about_trivial_state(p, tolerance);
    }
    let periods = common_period(p)?;
    let orbit = orbit::response(
        p,
        periods,
        &OrbitOptions { period: periods, guess: None, tolerance },
        &Budget::default(),
    )?;
    Ok(Multipliers {
        re: orbit.re,
        im: orbit.im,
        spectral_radius: Spectrum { re: orbit.re, im: orbit.im }.radius(),
        stable: orbit.stable,
        state: orbit.state,
        method: orbit.method,
        error: orbit.error,
    })
}

/// The multipliers alone, without the second computation that tells their error: for a row of neighbours, one of which
/// [`multipliers`] answers for.
///
/// # Errors
/// As [`multipliers`].
pub fn spectrum(p: &Parameters, tolerance: f64) -> Result<Spectrum, StudyError> {
    if unloaded(p) {
        motion::check_tolerance(tolerance)?;
        return Ok(linear_spectrum(p, tolerance)?);
    }
    let Multipliers { re, im, .. } = multipliers(p, tolerance)?;
    Ok(Spectrum { re, im })
}

fn about_trivial_state(p: &Parameters, tolerance: f64) -> Result<Multipliers, StudyError> {
    let coarse = linear_spectrum(p, tolerance)?;
    let fine = matrix(&linear_monodromy(p, tolerance, 0.5)?);
    let spectrum = floquet::spectrum(&fine)?;
    let trace = GearPair::new(p).trace();
    let liouville = floquet::liouville_residual(&fine, trace * p.mesh_period());
    let step = spectrum.distance(&coarse);
    Ok(Multipliers {
        re: spectrum.re,
        im: spectrum.im,
        spectral_radius: spectrum.radius(),
        stable: is_stable(&spectrum, trace, step),
        state: trivial_state(p),
        method: format!("Taylor series of order {} on half a period, QR", ORDER_24 - 1),
        error: ErrorEstimate { liouville: Some(liouville), step: Some(step), residual: None },
    })
}

/// Undamped, the best there is are multipliers on the unit circle; where two of them meet, rounding moves them
/// apart by its square root.
const UNDAMPED_SLACK: f64 = 1e-7;

/// Whether all multipliers are inside the unit circle, or, undamped (trace zero), on it.
pub fn is_stable(spectrum: &Spectrum, trace: f64, error: f64) -> bool {
    let slack = if trace == 0.0 { UNDAMPED_SLACK.max(error) } else { -error.min(1e-9) };
    spectrum.radius() <= 1.0 + slack
}
