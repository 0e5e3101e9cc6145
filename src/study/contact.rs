//! Does the load keep the teeth together? The contact margin, min u - 1, of the steady response, and the least load at
//! which it is not negative.
//!
//! All of it is asked of the `contact` regime, whose teeth never part: its response is the true one as long as its
//! margin is not negative. The response meant is the one that follows from a large mean load F as this is taken away.

use std::cell::RefCell;

use super::ErrorEstimate;
use super::motion::{self, ORDER_16};
use super::multipliers::{Budget, common_period, image, is_stable, trivial_state};
use super::slices::whole;
use super::time_response::largest_difference;
use crate::error::{NumericsError, StudyError};
use crate::model::equations::{GearPair, U};
use crate::model::parameters::{Parameters, Regime};
use crate::numerics::elimination::Factors;
use crate::numerics::floquet;
use crate::numerics::ode::taylor::Options;
use crate::numerics::periodic::matrix;
use crate::numerics::roots;

mod curve;
mod path;
pub use curve::{LeastLoadCurve, LeastLoadWork, least_load_curve};
use path::{climb, descend, least_in_contact, least_stable};

/// Most integration steps of one answer: a second or two.
const MOST_STEPS: usize = 400_000;
/// Greatest mean load that is tried, the end of its range.
const GREATEST: f64 = 1e3;
/// Shares of the load that a softening support can carry at rest, from which the response is followed.
const SHARES: [f64; 5] = [0.5, 0.25, 0.12, 0.06, 0.03];
/// Steps that the search for a response at one of these loads may take.
const SHARE_STEPS: usize = 60_000;
/// Smallest share of the loads by which a response is carried on before its search is given up.
const LEAST_SHARE: f64 = 1.0 / 1024.0;
/// Ratio of a load to the last one on the way up.
const CLIMB: f64 = 1.2;
/// The same where the end of the response is near, at least.
const SLOWEST_CLIMB: f64 = 1.005;
/// Greatest number of times that the map is applied in search of one response.
const ITERATIONS: usize = 30;
/// Ratio of a load to the next one tried on the way down.
const RATIO: f64 = 0.75;
/// Loads below this part of the first one are passed in one step to none.
const SMALL: f64 = 1e-3;

/// The contact margin of the steady response.
#[derive(Clone, Debug, PartialEq)]
pub struct ContactMargin {
    /// min u - 1 over a period of the response: at least 0 where the teeth never part.
    pub margin: f64,
    /// The time in the period at which u is least.
    pub at: f64,
    /// State at t = 0.
    pub state: [f64; 6],
    /// Whether the response is stable.
    pub stable: bool,
    /// Its period, in mesh periods.
    pub period: usize,
    /// How it was computed.
    pub method: String,
    /// What is known of the error: `residual` of the map, `liouville`, and `step`, the change of the margin when every
    /// step is halved.
    pub error: ErrorEstimate,
}

/// What decides on the least load.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Limit {
    /// At the least load the teeth just touch.
    Contact,
    /// They would keep contact under a smaller load, but only along an unstable response.
    Stability,
    /// No load is needed.
    None,
}

/// Why there is no least load.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoLoad {
    /// The response is unstable at every load tried at which it keeps contact.
    Unstable,
    /// The response parts the teeth at every load tried.
    Parted,
    /// No response was found even at a large load.
    NoResponse,
}

/// The least mean load that keeps the teeth in contact.
#[derive(Clone, Debug, PartialEq)]
pub struct LeastLoad {
    /// The smallest F, at least 0, at which the steady response is stable and its margin not negative; none where no
    /// F helps.
    pub load: Option<f64>,
    /// The smallest F at which the margin is not negative, whether the response is stable or not.
    pub contact_load: Option<f64>,
    /// What decides on `load`.
    pub limit: Limit,
    /// Why there is none.
    pub reason: Option<NoLoad>,
    /// State at t = 0 of the response at `load`.
    pub state: Option<[f64; 6]>,
    /// How it was computed.
    pub method: String,
    /// What is known of the error: `residual`, the margin at `contact_load`.
    pub error: ErrorEstimate,
}

/// A response at some load.
#[derive(Clone, Copy, Debug)]
struct Point {
    load: f64,
    state: [f64; 6],
    residual: f64,
    margin: f64,
    at: f64,
}

/// The response of a pair in permanent contact, at whatever mean load.
struct Responses<'a> {
    parameters: Parameters,
    period: usize,
    tolerance: f64,
    budget: &'a Budget,
    /// The derivative of the last search, factored.
    factors: RefCell<Option<Factors>>,
}

impl<'a> Responses<'a> {
    fn new(p: &Parameters, tolerance: f64, budget: &'a Budget) -> Result<Self, StudyError> {
        let parameters = Parameters { regime: Regime::Contact, ..*p };
        Ok(Self { parameters, period: common_period(p)?, tolerance, budget, factors: RefCell::new(None) })
    }

    fn under(&self, load: f64) -> Parameters {
        Parameters { load, ..self.parameters }
    }

    /// The response near a state, by Newton's method; the derivative of the map, which costs ten times the map itself, is
    /// renewed only where the last one, perhaps that of another load, no longer serves.
    fn near(&self, load: f64, guess: [f64; 6]) -> Result<Point, NumericsError> {
        self.at(&self.under(load), guess)
    }

    /// The same at these parameters.
    fn at(&self, p: &Parameters, guess: [f64; 6]) -> Result<Point, NumericsError> {
        let pair = GearPair::new(p);
        let mut factors = self.factors.borrow_mut();
        let (mut state, mut last) = (guess, f64::INFINITY);
        let mut best = (f64::INFINITY, guess);
        let mut fresh = false;
        for _ in 0..ITERATIONS {
            let mut step: [f64; 6] = self.apply(&pair, &state)?;
            for (value, from) in step.iter_mut().zip(state) {
                *value -= from;
            }
            let residual = largest(&step);
            let gained = residual < 0.1 * last;
            if residual < best.0 {
                best = (residual, state);
            }
            let within = 0.1 * self.tolerance * (1.0 + largest(&state));
            if best.0 <= within && (!gained || best.0 <= 1e-3 * within) {
                break;
            }
            if factors.is_none() || residual > 0.3 * last {
                if fresh && residual > last {
                    break;
                }
                let rows = self.derivative(&pair, &state)?;
                let matrix =
                    (0..36).map(|at| rows[at / 6][at % 6] - f64::from(u8::from(at % 7 == 0))).collect();
                *factors = Some(Factors::new(6, matrix)?);
                fresh = true;
            } else {
                fresh = false;
            }
            last = residual;
            if let Some(factors) = factors.as_ref() {
                factors.solve(&mut step);
            }
            for (value, step) in state.iter_mut().zip(step) {
                *value -= step;
            }
        }
        let (residual, state) = best;
        if residual.is_nan() || residual > self.tolerance * (1.0 + largest(&state)) {
            *factors = None;
            return Err(NumericsError::NoConvergence {
                iterations: ITERATIONS,
                residual,
                tolerance: self.tolerance,
            });
        }
        let (margin, at) = self.margin(&pair, state, 1.0)?;
        Ok(Point { load: p.load, state, residual, margin, at })
    }

    /// The rows of the map's derivative.
    fn derivative(&self, pair: &GearPair, state: &[f64; 6]) -> Result<[[f64; 6]; 6], NumericsError> {
        // With its derivative a step costs as much as eight without.
        let before = self.budget.left();
        let own = Budget::of(before / 8);
        let found = image(pair, state, self.period, self.tolerance, 1.0, &own);
        self.budget.spend(before - 8 * own.left());
        Ok(found?.1)
    }

    /// The state a period later.
    fn apply(&self, pair: &GearPair, state: &[f64; 6]) -> Result<[f64; 6], NumericsError> {
        if self.budget.left() == 0 {
            return Err(NumericsError::TooManySteps { time: 0.0, steps: 0 });
        }
        let end = self.period as f64 * pair.parameters.mesh_period();
        let reached = motion::carry(pair, 0.0, *state, end, self.tolerance)?;
        self.budget.spend(reached.steps);
        reached.escaped.map_or(Ok(reached.state), |time| Err(NumericsError::Escaped { time }))
    }

    /// min u - 1 over a period, and when.
    fn margin(
        &self,
        pair: &GearPair,
        state: [f64; 6],
        step_factor: f64,
    ) -> Result<(f64, f64), NumericsError> {
        let end = self.period as f64 * pair.parameters.mesh_period();
        let tolerance = motion::step_tolerance(self.tolerance);
        let options = Options { tolerance, step_factor, steps: self.budget.left() };
        let mut least = (state[U], 0.0);
        let reached = motion::follow::<ORDER_16>(pair, 0.0, state, end, options, |step, _| {
            let extrema = roots::extrema(&step.coordinate(U), step.length);
            if extrema.least < least.0 {
                least = (extrema.least, step.start + extrema.least_at);
            }
        })?;
        self.budget.spend(reached.steps);
        match reached.escaped {
            Some(time) => Err(NumericsError::Escaped { time }),
            None => Ok((least.0 - 1.0, least.1)),
        }
    }

    /// From one response to that at another load, straight on from the last two, in steps that are halved where the
    /// search fails or ends up elsewhere.
    async fn walk(&self, from: Point, before: Option<Point>, load: f64) -> Result<Point, NumericsError> {
        let (mut at, mut before) = (from, before);
        let whole = load - from.load;
        let mut step = whole;
        while at.load != load {
            self.budget.rest().await;
            let next =
                if (load - at.load).abs() <= step.abs() * (1.0 + 1e-9) { load } else { at.load + step };
            let guess = straight_on(&at, before.as_ref(), next);
            match self.near(next, guess) {
                Ok(point) if continues(&point.state, &guess, &at.state) => {
                    before = Some(at);
                    at = point;
                    step *= 2.0;
                }
                Err(error @ NumericsError::TooManySteps { .. }) => return Err(error),
                failed => {
                    step *= 0.5;
                    if step.abs() < whole.abs() / 64.0 {
                        return Err(failed.err().unwrap_or(NumericsError::NoConvergence {
                            iterations: 0,
                            residual: at.residual,
                            tolerance: self.tolerance,
                        }));
                    }
                }
            }
        }
        Ok(at)
    }

    /// The response grown from none at this load together with the others.
    async fn grown(&self, load: f64) -> Result<Point, NumericsError> {
        let whole = self.under(load);
        let scaled = |share: f64| Parameters {
            load: share * whole.load,
            load_p: share * whole.load_p,
            load_g: share * whole.load_g,
            error: share * whole.error,
            ..whole
        };
        let least_left = self.budget.left().saturating_sub(SHARE_STEPS);
        let mut at = self.at(&scaled(0.0), trivial_state(&whole))?;
        let mut before: Option<(f64, [f64; 6])> = None;
        let (mut share, mut step) = (0.0, 0.5);
        while share < 1.0 {
            self.budget.rest().await;
            if self.budget.left() <= least_left {
                return Err(NumericsError::TooManySteps { time: 0.0, steps: SHARE_STEPS });
            }
            let next = f64::min(share + step, 1.0);
            let guess = before.map_or(at.state, |(earlier, state)| {
                let ratio = (next - share) / (share - earlier);
                std::array::from_fn(|i| at.state[i] + ratio * (at.state[i] - state[i]))
            });
            match self.at(&scaled(next), guess) {
                Ok(point) if continues(&point.state, &guess, &at.state) => {
                    before = Some((share, at.state));
                    (at, share) = (point, next);
                    step *= 2.0;
                }
                Err(error @ NumericsError::TooManySteps { .. }) => return Err(error),
                failed if step <= LEAST_SHARE => {
                    return Err(failed.err().unwrap_or(NumericsError::NoConvergence {
                        iterations: 0,
                        residual: at.residual,
                        tolerance: self.tolerance,
                    }));
                }
                _ => step *= 0.5,
            }
        }
        Ok(at)
    }

    /// A response at a large load, in contact if there is such a one.
    async fn large(&self) -> Result<Point, StudyError> {
        let mut found: Option<Point> = None;
        let mut failure = None;
        for load in self.large_loads() {
            self.budget.rest().await;
            match self.grown(load).await {
                Ok(point) if point.margin >= 0.0 => return Ok(point),
                Ok(point) => {
                    found.get_or_insert(point);
                }
                Err(error) => failure = Some(error.into()),
            }
            if self.budget.left() == 0 {
                break;
            }
        }
        let unfound =
            NumericsError::NoConvergence { iterations: 0, residual: f64::MAX, tolerance: self.tolerance };
        found.ok_or_else(|| failure.unwrap_or(unfound.into()))
    }

    /// Mean loads that count as large beside the others, in the order in which they are tried.
    fn large_loads(&self) -> Vec<f64> {
        let p = &self.parameters;
        let carried = carried_at_rest(p);
        if carried.is_finite() {
            return SHARES.iter().map(|share| (share * carried).min(GREATEST)).collect();
        }
        let others = p.load_p.abs() + p.load_g.abs() + p.omega * p.omega * p.error.abs();
        [1.0, 4.0, 0.25].iter().map(|factor| (factor * (10.0 * others + 1.0)).min(GREATEST)).collect()
    }

    fn stable(&self, point: &Point) -> Result<(bool, f64), StudyError> {
        let pair = GearPair::new(&self.under(point.load));
        let derivative = self.derivative(&pair, &point.state)?;
        let monodromy = matrix(&derivative);
        let spectrum = floquet::spectrum(&monodromy)?;
        let length = self.period as f64 * self.parameters.mesh_period();
        let liouville = floquet::liouville_residual(&monodromy, pair.trace() * length);
        Ok((is_stable(&spectrum, pair.trace(), 1e-9), liouville))
    }
}

fn largest(values: &[f64; 6]) -> f64 {
    values.iter().fold(0.0, |most, value| most.max(value.abs()))
}

/// The greatest mean load at which both supports still have an equilibrium on their first branch: for a softening
/// support the maximum of `k u - |alpha| u^3`.
fn carried_at_rest(p: &Parameters) -> f64 {
    [(p.k_p, p.alpha_p), (p.k_g, p.alpha_g)]
        .iter()
        .map(
            |&(k, alpha)| {
                if alpha < 0.0 { 2.0 / 3.0 * k * (k / (-3.0 * alpha)).sqrt() } else { f64::INFINITY }
            },
        )
        .fold(f64::INFINITY, f64::min)
}

/// The state predicted from the last response and the one before it.
fn straight_on(at: &Point, before: Option<&Point>, load: f64) -> [f64; 6] {
    match before {
        Some(earlier) if earlier.load != at.load => {
            let ratio = (load - at.load) / (at.load - earlier.load);
            std::array::from_fn(|i| at.state[i] + ratio * (at.state[i] - earlier.state[i]))
        }
        _ => at.state,
    }
}

/// Whether a solution continues the branch: not further from the prediction than a fair step is long.
fn continues(solution: &[f64; 6], guess: &[f64; 6], last: &[f64; 6]) -> bool {
    let size = last.iter().fold(0.2_f64, |most, value| most.max(value.abs()));
    largest_difference(solution, guess) <= (0.5 * size).max(largest_difference(guess, last))
}

/// The contact margin of the steady response: followed from a large mean load, or, with a `state`, of the periodic
/// motion near it.
///
/// # Errors
/// [`StudyError::Option`] for a tolerance or state out of range, [`StudyError::Model`] for an incommensurate load,
/// [`StudyError::Numerics`] where no response is found.
pub fn contact_margin(
    p: &Parameters,
    state: Option<[f64; 6]>,
    tolerance: f64,
) -> Result<ContactMargin, StudyError> {
    motion::check_tolerance(tolerance)?;
    whole(margin_of(p, state, tolerance))
}

async fn margin_of(
    p: &Parameters,
    state: Option<[f64; 6]>,
    tolerance: f64,
) -> Result<ContactMargin, StudyError> {
    let budget = Budget::of(MOST_STEPS);
    let responses = Responses::new(p, tolerance, &budget)?;
    let (point, way) = if let Some(guess) = state {
        motion::check_state(&GearPair::new(&responses.parameters), &guess)?;
        (responses.near(p.load, guess)?, "from the state given")
    } else {
        let followed = responses.large().await.ok().filter(|large| large.load > p.load);
        let walked = match followed {
            Some(large) => responses.walk(large, None, p.load).await.ok(),
            None => None,
        };
        match walked {
            Some(point) => (point, "followed from a large mean load"),
            None => (responses.grown(p.load).await?, "grown with the load"),
        }
    };
    let (stable, liouville) = responses.stable(&point)?;
    let (halved, _) = responses.margin(&GearPair::new(&responses.under(p.load)), point.state, 0.5)?;
    Ok(ContactMargin {
        margin: point.margin,
        at: point.at,
        state: point.state,
        stable,
        period: responses.period,
        method: format!("periodic response in permanent contact, {way}; least u on the Taylor polynomials"),
        error: ErrorEstimate {
            liouville: Some(liouville),
            step: Some((halved - point.margin).abs()),
            residual: Some(point.residual),
        },
    })
}

/// The least mean load that keeps the teeth in contact; F itself among the parameters has no part in it.
///
/// # Errors
/// [`StudyError::Option`] for a tolerance out of range, [`StudyError::Model`] for an incommensurate load,
/// [`StudyError::Numerics`] where the work allowed does not suffice.
pub fn least_load(p: &Parameters, tolerance: f64) -> Result<LeastLoad, StudyError> {
    whole(search(*p, tolerance))
}

async fn search(p: Parameters, tolerance: f64) -> Result<LeastLoad, StudyError> {
    motion::check_tolerance(tolerance)?;
    let budget = Budget::of(MOST_STEPS);
    let responses = Responses::new(&p, tolerance, &budget)?;
    let mut answer = LeastLoad {
        load: None,
        contact_load: None,
        limit: Limit::None,
        reason: None,
        state: None,
        method: "response in permanent contact, followed down from a large mean load; root of its margin"
            .into(),
        error: ErrorEstimate::default(),
    };
    let large = match responses.large().await {
        Ok(large) => large,
        Err(error @ (StudyError::Option { .. } | StudyError::Model(_))) => return Err(error),
        Err(StudyError::Numerics(error @ NumericsError::TooManySteps { .. })) => return Err(error.into()),
        Err(_) => {
            answer.reason = Some(NoLoad::NoResponse);
            return Ok(answer);
        }
    };
    let mut path = descend(&responses, large).await?;
    let mut whole = false;
    if path.iter().all(|point| point.margin < 0.0) {
        path = climb(&responses, path).await?;
        whole = true;
    }
    let Some(least) = least_in_contact(&responses, &path)? else {
        answer.reason = Some(NoLoad::Parted);
        return Ok(answer);
    };
    answer.contact_load = Some(least.load);
    answer.error.residual = Some(if least.load > 0.0 { least.margin.abs() } else { 0.0 });
    if responses.stable(&least)?.0 {
        answer.limit = if least.load > 0.0 { Limit::Contact } else { Limit::None };
        (answer.load, answer.state) = (Some(least.load), Some(least.state));
        return Ok(answer);
    }
    if !whole {
        path = climb(&responses, path).await?;
    }
    if let Some(point) = least_stable(&responses, &path, &least).await? {
        answer.limit = Limit::Stability;
        (answer.load, answer.state) = (Some(point.load), Some(point.state));
    } else {
        answer.reason = Some(NoLoad::Unstable);
    }
    Ok(answer)
}
