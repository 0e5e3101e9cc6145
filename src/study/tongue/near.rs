//! The interval of instability about or next to a given frequency.

use super::{
    Edge, EdgeFunction, EdgeKind, Factors, LinearFloquet, NEAR, NumericsError, PI, StudyError,
    linear_floquet, minimise, zero,
};

/// By how much a modulus must exceed 1 to count. Undamped multipliers that meet on the circle are parted by the
/// square root of rounding.
fn slack(linear: &LinearFloquet) -> f64 {
    if linear.undamped() { 3e-6 } else { 1e-11 }
}

fn factors(linear: &LinearFloquet, omega: f64, k0: f64) -> Result<Factors, NumericsError> {
    linear_floquet::factors(&linear.characteristic(omega, k0)?)
}

fn growth(linear: &LinearFloquet, omega: f64, k0: f64) -> Result<f64, NumericsError> {
    Ok(factors(linear, omega, k0)?.radius() - 1.0 - slack(linear))
}

/// A step that neither a multiplier's turn nor a tongue of ordinary width is lost in.
fn stride(linear: &LinearFloquet, omega: f64) -> f64 {
    let turn: f64 = linear.frequencies().iter().sum();
    (0.1 * omega * omega / (2.0 * PI * turn)).min(1e-3 * omega)
}

/// Most steps of the search on each side.
const MOST: usize = 4000;

pub(super) fn edges(
    linear: &LinearFloquet,
    omega: f64,
    k0: f64,
    tolerance: f64,
) -> Result<Option<[Edge; 2]>, StudyError> {
    if !(0.01..=100.0).contains(&omega) {
        return Err(StudyError::Option {
            option: "tongue",
            given: omega.to_string(),
            allowed: "a mesh frequency from 0.01 to 100".into(),
        });
    }
    let Some(inside) = inside(linear, omega, k0)? else { return Ok(None) };
    let mut found = Vec::with_capacity(2);
    for direction in [-1.0, 1.0] {
        found.push(edge(linear, inside, direction, k0, tolerance)?);
    }
    Ok(Some([found[0], found[1]]))
}

/// An unstable frequency: the given one, or the nearest one that the search meets.
fn inside(linear: &LinearFloquet, omega: f64, k0: f64) -> Result<Option<f64>, NumericsError> {
    if growth(linear, omega, k0)? > 0.0 {
        return Ok(Some(omega));
    }
    let step = stride(linear, omega);
    let count = ((NEAR * omega / step).ceil() as usize).min(MOST);
    let functions = functions(linear);
    let start = linear.characteristic(omega, k0)?;
    let start = functions.map(|function| function.of(&start));
    // Values of the functions two and one steps before, on each side.
    let mut before = [[start; 2]; 2];
    for index in 1..=count {
        for (side, direction) in [-1.0, 1.0].into_iter().enumerate() {
            let at = omega + direction * step * index as f64;
            if at <= 0.0 {
                continue;
            }
            let here = linear.characteristic(at, k0)?;
            if linear_floquet::factors(&here)?.radius() - 1.0 > slack(linear) {
                return Ok(Some(at));
            }
            let values = functions.map(|function| function.of(&here));
            // About the given frequency itself the neighbours are those on both sides.
            let (far, middle) = match (index, side) {
                (1, 0) => (values, start),
                (1, _) => (before[0][1], start),
                _ => (before[side][0], before[side][1]),
            };
            before[side] = [middle, values];
            for (which, function) in functions.into_iter().enumerate() {
                let dips = middle[which] < far[which] && middle[which] <= values[which];
                // A tongue may hide between two steps, where the function dips below zero.
                if dips && let Some(bottom) = bottom(linear, function, at - direction * step, step, k0)? {
                    return Ok(Some(bottom));
                }
            }
        }
    }
    Ok(None)
}

/// The functions of all that may happen at an edge.
fn functions(linear: &LinearFloquet) -> [EdgeFunction; 3] {
    [EdgeKind::PeriodDoubling, EdgeKind::PlusOne, EdgeFunction::pair(linear).kind]
        .map(|kind| EdgeFunction { kind })
}

/// Parts of a step by which the bottom of a dip is closed in on.
const CLOSER: [f64; 4] = [0.5, 0.05, 5e-3, 5e-4];

/// The bottom of the dip of a function within a step of a frequency, if it is unstable there.
fn bottom(
    linear: &LinearFloquet,
    function: EdgeFunction,
    omega: f64,
    step: f64,
    k0: f64,
) -> Result<Option<f64>, NumericsError> {
    let widths = CLOSER.map(|part| part * step / omega);
    let deepest = minimise(linear, function, omega, k0, &widths)?;
    let there = (deepest.omega - omega).abs() <= 2.0 * step && growth(linear, deepest.omega, k0)? > 0.0;
    Ok(there.then_some(deepest.omega))
}

fn edge(
    linear: &LinearFloquet,
    inside: f64,
    direction: f64,
    k0: f64,
    tolerance: f64,
) -> Result<Edge, StudyError> {
    let mut unstable = inside;
    let mut stable = None;
    for _ in 0..MOST {
        let next = unstable + direction * stride(linear, unstable);
        if growth(linear, next, k0)? <= 0.0 {
            stable = Some(next);
            break;
        }
        unstable = next;
    }
    let Some(mut stable) = stable else {
        return Err(NumericsError::NoBracket { low: inside.min(unstable), high: inside.max(unstable) }.into());
    };
    let outer = stable;
    while (stable - unstable).abs() > 1e-9 * inside {
        let middle = 0.5 * (stable + unstable);
        if growth(linear, middle, k0)? > 0.0 { unstable = middle } else { stable = middle }
    }
    let at_edge = factors(linear, unstable, k0)?;
    let top = at_edge.top();
    let (p, q) = (at_edge.p[top], at_edge.q[top]);
    let kind = match (0.25 * p * p >= q, p > 0.0) {
        (true, true) => EdgeKind::PeriodDoubling,
        (true, false) => EdgeKind::PlusOne,
        (false, _) => EdgeFunction::pair(linear).kind,
    };
    let function = EdgeFunction { kind };
    // Both sides of the zero, at a distance that its rounding does not blur.
    for distance in [1e-7, 1e-6, 1e-5] {
        let low = unstable - direction * distance * inside;
        let high = stable + direction * (distance * inside).min((outer - stable).abs());
        if function.value(linear, low, k0)? * function.value(linear, high, k0)? < 0.0 {
            let omega = zero(linear, function, low, high, k0, tolerance)?;
            return Ok(Edge { omega, function });
        }
    }
    Ok(Edge { omega: 0.5 * (stable + unstable), function })
}
