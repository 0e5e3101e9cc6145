//! Where a motion settles: on a periodic orbit, which is then found exactly, or on something that never repeats.

use super::motion;
use super::multipliers::{Budget, image};
use super::orbit::{OrbitOptions, PeriodicOrbit, periodic_orbit};
use super::poincare::Strobe;
use super::time_response::largest_difference;
use crate::error::{NumericsError, StudyError};
use crate::model::equations::GearPair;
use crate::model::parameters::Parameters;

/// Longest period, in mesh periods, that is looked for.
pub const LONGEST: usize = 8;
/// Two points of the map this near, relative to 1 + the largest coordinate: an orbit is looked for there.
const RETURNING: f64 = 1e-4;
/// An orbit this far, relative, from the point where it was looked for is another one.
pub(crate) const ELSEWHERE: f64 = 0.02;

/// Size of a state: 1 + its largest coordinate.
pub(crate) fn size(state: &[f64; 6]) -> f64 {
    1.0 + state.iter().fold(0.0_f64, |most, value| most.max(value.abs()))
}

/// The least number of periods, at most [`LONGEST`], after which the motion's last points came back.
pub(crate) fn returning(states: &[[f64; 6]]) -> Option<usize> {
    let (last, earlier) = states.split_last()?;
    let near = RETURNING * size(last);
    (1..=LONGEST.min(earlier.len()))
        .find(|&period| largest_difference(last, &earlier[earlier.len() - period]) < near)
}

/// Ratio of the spreads of the two halves of a motion's points from which on they do not draw together.
const STEADY: f64 = 0.995;
/// The same below which they do so fast enough to be believed without a look at the multipliers.
const FAST: f64 = 0.7;
/// How far, relative, a period's motion of them may be from that of the linear map about the orbit: then it is that map's
/// multipliers that decide where they go.
const LINEAR: f64 = 0.03;

/// The stable orbit in the middle of a motion's last points, where they draw together on it, perhaps too slowly to be
/// waited for; its period is a multiple of `common` up to `longest` mesh periods.
pub(crate) fn drawn_to(
    p: &Parameters,
    points: &[[f64; 6]],
    (common, longest): (usize, usize),
    tolerance: f64,
    budget: &Budget,
) -> Option<PeriodicOrbit> {
    let lags = (1..=longest.max(common)).filter(|lag| lag.is_multiple_of(common));
    let halves = |lag: usize| {
        let every: Vec<[f64; 6]> = points.iter().rev().step_by(lag).rev().copied().collect();
        let (first, second) = every.split_at(every.len() / 2);
        (spread(first), spread(second), middle(second))
    };
    // Points of one phase of the orbit are nearest together; a multiple of its period is not preferred.
    let (lag, (first, second, middle)) = lags.map(|lag| (lag, halves(lag))).min_by(|one, other| {
        let weighted = |(lag, half): &(usize, (f64, f64, [f64; 6]))| half.1 * (1.0 + 0.2 * *lag as f64);
        weighted(one).total_cmp(&weighted(other))
    })?;
    let ratio = second / first;
    if ratio.is_nan() || ratio >= STEADY {
        return None;
    }
    let orbit = stable_orbit(p, middle, lag, ELSEWHERE, tolerance, budget)?;
    (ratio < FAST || is_linear(p, &orbit, points, tolerance, budget)).then_some(orbit)
}

/// Whether the last of a motion's points move as the linear map about an orbit has it.
fn is_linear(
    p: &Parameters,
    orbit: &PeriodicOrbit,
    points: &[[f64; 6]],
    tolerance: f64,
    budget: &Budget,
) -> bool {
    let Some((to, from)) = points.last().zip(points.iter().rev().nth(orbit.period)) else { return false };
    // The point of the orbit that belongs to the last of the motion's.
    let Ok(mut strobe) = Strobe::new(p, orbit.state, tolerance) else { return false };
    let mut nearest = strobe.state();
    for _ in 1..orbit.period {
        let Ok(Some(state)) = strobe.next() else { return false };
        if largest_difference(&state, to) < largest_difference(&nearest, to) {
            nearest = state;
        }
    }
    let Ok((_, rows)) = image(&GearPair::new(p), &nearest, orbit.period, tolerance, 1.0, budget) else {
        return false;
    };
    let before: [f64; 6] = std::array::from_fn(|i| from[i] - nearest[i]);
    let predicted: [f64; 6] =
        std::array::from_fn(|i| nearest[i] + (0..6).map(|j| rows[i][j] * before[j]).sum::<f64>());
    largest_difference(&predicted, to) < LINEAR * largest_difference(to, &nearest)
}

/// Root of the mean squared distance of some states from their middle.
fn spread(states: &[[f64; 6]]) -> f64 {
    let middle = middle(states);
    let squares = states.iter().flat_map(|state| (0..6).map(|i| (state[i] - middle[i]).powi(2)));
    (squares.sum::<f64>() / states.len().max(1) as f64).sqrt()
}

/// The mean of some states.
fn middle(states: &[[f64; 6]]) -> [f64; 6] {
    std::array::from_fn(|i| states.iter().map(|state| state[i]).sum::<f64>() / states.len().max(1) as f64)
}

/// Times that an orbit's search goes along it, each step with its derivative counted as several: as a rule.
const PASSAGES: usize = 400;

/// The stable orbit of this period that passes a state within `reach`, relative to 1 + its largest coordinate, if there
/// is one; the budget pays, and where it does not suffice for a search, is spent.
pub(crate) fn stable_orbit(
    p: &Parameters,
    state: [f64; 6],
    period: usize,
    reach: f64,
    tolerance: f64,
    budget: &Budget,
) -> Option<PeriodicOrbit> {
    let one = motion::carry(&GearPair::new(p), 0.0, state, p.mesh_period(), tolerance);
    let price = one.map_or(usize::MAX, |reached| PASSAGES.saturating_mul(period * reached.steps));
    if price > budget.left() / 2 {
        budget.spend(price);
        return None;
    }
    budget.spend(price);
    let options = OrbitOptions { period, guess: Some(state), tolerance };
    let orbit = periodic_orbit(p, &options).ok()?;
    let near = reach * size(&state);
    let mut points = Strobe::new(p, orbit.state, tolerance).ok()?;
    for _ in 0..orbit.period {
        if largest_difference(&points.state(), &state) < near {
            return orbit.stable.then_some(orbit);
        }
        points.next().ok()??;
    }
    None
}

/// How a motion ended.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum End {
    /// On a stable orbit.
    Orbit(Box<PeriodicOrbit>),
    /// Over the barrier, at this time.
    Escaped(f64),
    /// On none of these within the periods given: its last state.
    Wandering([f64; 6]),
}

/// Follows a motion for at most `periods` mesh periods and at most `steps` steps of the integration, or until it is
/// known on which orbit it settles.
///
/// # Errors
/// As [`Strobe::next`]; [`NumericsError::TooManySteps`] where the steps do not suffice.
pub(crate) fn settle(
    p: &Parameters,
    state: [f64; 6],
    periods: usize,
    steps: usize,
    tolerance: f64,
) -> Result<End, StudyError> {
    let budget = Budget::of(steps);
    let mut strobe = Strobe::new(p, state, tolerance)?;
    let mut recent = vec![state];
    let mut next_search = 2 * LONGEST;
    for count in 1..=periods {
        let before = strobe.steps();
        let Some(state) = strobe.next()? else {
            return Ok(End::Escaped(strobe.escaped().unwrap_or(strobe.time())));
        };
        budget.spend(strobe.steps() - before);
        if budget.left() == 0 {
            return Err(NumericsError::TooManySteps { time: strobe.time(), steps }.into());
        }
        recent.push(state);
        if recent.len() > 4 * LONGEST {
            recent.drain(..2 * LONGEST);
        }
        if count < next_search {
            continue;
        }
        let Some(period) = returning(&recent) else { continue };
        if let Some(orbit) = stable_orbit(p, state, period, ELSEWHERE, tolerance, &budget) {
            return Ok(End::Orbit(Box::new(orbit)));
        }
        // A slow passage by something unstable looks like a return: wait longer before the next search.
        next_search = 2 * count;
    }
    Ok(End::Wandering(strobe.state()))
}

/// Steps that may be taken to see whether a motion comes back.
const MOST_STEPS: usize = 300_000;
/// Two states this near, relative to 1 + the largest coordinate, are one orbit's.
const CLOSED: f64 = 1e-7;

/// After how many periods, at most [`LONGEST`], a motion is back where it started: it started on an orbit, be it stable
/// or not.
///
/// # Errors
/// As [`Strobe::next`].
pub(crate) fn closed(p: &Parameters, state: &[f64; 6], tolerance: f64) -> Result<Option<usize>, StudyError> {
    let common = super::multipliers::common_period(p)?;
    let mut strobe = Strobe::new(p, *state, tolerance)?;
    for count in 1..=LONGEST.max(common) {
        let Some(now) = strobe.next()? else { return Ok(None) };
        if strobe.steps() > MOST_STEPS {
            return Err(NumericsError::TooManySteps { time: strobe.time(), steps: strobe.steps() }.into());
        }
        if count.is_multiple_of(common) && largest_difference(&now, state) < CLOSED * size(state) {
            return Ok(Some(count));
        }
    }
    Ok(None)
}
