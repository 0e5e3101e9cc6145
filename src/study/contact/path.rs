//! The responses over the load: followed down and up, and the loads on their way at which something changes.

use super::{CLIMB, GREATEST, Point, RATIO, Responses, SLOWEST_CLIMB, SMALL, carried_at_rest};
use crate::error::{NumericsError, StudyError};
use crate::numerics::roots::bracketed_root;

/// Responses from a large load down to none, or to where the response cannot be followed any further.
pub(super) async fn descend(responses: &Responses<'_>, large: Point) -> Result<Vec<Point>, StudyError> {
    let mut path = vec![large];
    let mut at = large;
    while at.load > 0.0 {
        let next = if at.load < SMALL * large.load { 0.0 } else { RATIO * at.load };
        let before = path.len().checked_sub(2).map(|index| path[index]);
        match responses.walk(at, before, next).await {
            Ok(point) => at = point,
            Err(error @ NumericsError::TooManySteps { .. }) => return Err(error.into()),
            Err(_) => break,
        }
        path.push(at);
    }
    Ok(path)
}

/// The same path, continued upwards to where the response ends.
pub(super) async fn climb(responses: &Responses<'_>, path: Vec<Point>) -> Result<Vec<Point>, StudyError> {
    let most = carried_at_rest(&responses.parameters).min(GREATEST);
    let Some(mut at) = path.first().copied() else { return Ok(path) };
    let mut before = path.get(1).copied();
    let mut upwards = Vec::new();
    let mut growth = CLIMB;
    while at.load < most && growth > SLOWEST_CLIMB {
        match responses.walk(at, before, (growth * at.load).min(most)).await {
            Ok(point) => {
                before = Some(at);
                at = point;
                upwards.push(at);
            }
            Err(error @ NumericsError::TooManySteps { .. }) if upwards.is_empty() => return Err(error.into()),
            Err(NumericsError::TooManySteps { .. }) => break,
            // The end is near: on in smaller steps.
            Err(_) => growth = 1.0 + 0.3 * (growth - 1.0),
        }
    }
    upwards.reverse();
    upwards.extend(path);
    Ok(upwards)
}

/// The least load of the path at which the margin is not negative.
pub(super) fn least_in_contact(responses: &Responses, path: &[Point]) -> Result<Option<Point>, StudyError> {
    // Without any other load all margins are 0 at rest, up to rounding.
    let kept = |point: &Point| point.margin >= -1e-12;
    let Some(index) = path.iter().rposition(kept) else { return Ok(None) };
    let inside = path[index];
    let Some(outside) = path.get(index + 1).copied() else { return Ok(Some(inside)) };
    between(responses, inside, outside, &mut |point| Ok(point.margin))
}

/// The least load above `least` at which the response is stable.
pub(super) async fn least_stable(
    responses: &Responses<'_>,
    path: &[Point],
    least: &Point,
) -> Result<Option<Point>, StudyError> {
    let p = &responses.parameters;
    if p.alpha_p == 0.0 && p.alpha_g == 0.0 {
        // The multipliers of a linear response do not depend on the load.
        return Ok(None);
    }
    let mut below = *least;
    for point in path.iter().rev().filter(|point| point.load > least.load && point.margin >= 0.0) {
        if !responses.stable(point)?.0 {
            below = *point;
            continue;
        }
        // Stability is a yes or no: halve.
        let (mut low, mut high) = (below, *point);
        while high.load - low.load > responses.tolerance * high.load {
            let middle = responses.walk(high, Some(low), 0.5 * (low.load + high.load)).await?;
            let done = middle.load <= low.load || middle.load >= high.load;
            if responses.stable(&middle)?.0 && middle.margin >= 0.0 {
                high = middle;
            } else {
                low = middle;
            }
            if done {
                break;
            }
        }
        return Ok(Some(high));
    }
    Ok(None)
}

/// The response between two others at which a number of it vanishes.
fn between(
    responses: &Responses,
    inside: Point,
    outside: Point,
    number: &mut dyn FnMut(&Point) -> Result<f64, StudyError>,
) -> Result<Option<Point>, StudyError> {
    let mut failure = None;
    let mut best = inside;
    let root = bracketed_root(
        |load| {
            if load == inside.load {
                return number(&inside).unwrap_or(f64::NAN).max(0.0);
            }
            if load == outside.load {
                return number(&outside).unwrap_or(f64::NAN);
            }
            let share = (load - outside.load) / (inside.load - outside.load);
            let guess =
                std::array::from_fn(|i| outside.state[i] + share * (inside.state[i] - outside.state[i]));
            match responses.near(load, guess).map_err(StudyError::from).and_then(|point| {
                let value = number(&point)?;
                best = point;
                Ok(value)
            }) {
                Ok(value) => value,
                Err(error) => {
                    failure = Some(error);
                    f64::NAN
                }
            }
        },
        inside.load,
        outside.load,
        0.01 * responses.tolerance * inside.load,
    );
    match (root, failure) {
        (_, Some(error)) => Err(error),
        (Err(error), None) => Err(error.into()),
        (Ok(load), None) if load == best.load => Ok(Some(best)),
        (Ok(load), None) => Ok(Some(responses.near(load, best.state)?)),
    }
}
