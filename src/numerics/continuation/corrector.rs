//! From a place near a branch to the branch: Newton's method in the hyperplane through it, within the space that the
//! orbit's symmetries fix.

use super::symmetry::Space;
use super::{Evaluation, Family, Kind, Scale, Scaled, State, dot, minus, norm, unit};
use crate::error::NumericsError;

/// What a correction works with.
#[derive(Clone, Copy, Debug)]
pub struct Frame<'a> {
    /// The map whose fixed points form the branch.
    pub kind: Kind,
    /// The space that the branch lies in.
    pub space: &'a Space,
    /// Units of lengths.
    pub scale: Scale,
    /// Length of the last correction, over the scales.
    pub tolerance: f64,
}

/// A point on the branch.
#[derive(Clone, Copy, Debug)]
pub struct Corrected {
    /// State and parameter over their scales.
    pub at: Scaled,
    /// The map there: evaluated at most the tolerance away.
    pub evaluation: Evaluation,
    /// Unit tangent, at an acute angle to the normal of the hyperplane.
    pub tangent: Scaled,
    /// Whether that was found from a tangent that was given, and is this again.
    pub given: bool,
    /// Distance of the given place from the branch.
    pub distance: f64,
    /// Largest component of the map's residual at the last evaluation.
    pub residual: f64,
}

/// Most iterations: from a good prediction it takes one or two.
const ITERATIONS: usize = 8;
/// Largest entry of a linearisation up to which the tolerance is as given; beyond, the less by as much as it is greater.
pub(super) const GENTLE: f64 = 10.0;
/// The least part of the tolerance that is asked for of steep maps.
pub(super) const STRICTEST: f64 = 1e-3;
/// The shift of the parameter by which the map is differenced, relative to it.
const SHIFT: f64 = 1e-6;
/// Distance from the branch up to which a tangent that was predicted with the place is believed, or this many times the
/// tolerance: what it is off leaves that part of the last correction.
pub(super) const TRUSTED: f64 = 1e-6;
const TOLERATED: f64 = 10.0;
/// Least share of the parameter in a tangent from which the derivative by it is taken.
const STEEP: f64 = 0.05;

/// The derivative of the image by the parameter, by a difference: good to five or six digits, which costs Newton's
/// method nothing and is right for any parameter, the period included.
///
/// # Errors
/// As [`Family::image`].
pub fn by_parameter(
    family: &mut dyn Family,
    kind: Kind,
    state: &State,
    parameter: f64,
    image: &State,
    scale: Scale,
) -> Result<State, NumericsError> {
    let shift = SHIFT * parameter.abs().max(1e-3 * scale.parameter);
    let shifted = parameter + shift;
    let there = family.image(kind, state, shifted)?;
    let shift = shifted - parameter;
    Ok(std::array::from_fn(|i| (there[i] - image[i]) / shift))
}

/// The derivative of the image by the parameter, by what it is along the branch: (A - I) dx + slope dp = 0.
fn slope_along(evaluation: &Evaluation, tangent: &Scaled, scale: Scale) -> State {
    let rate = scale.state / (tangent[6] * scale.parameter);
    std::array::from_fn(|row| {
        let moved: f64 = (0..6).map(|column| evaluation.derivative[(row, column)] * tangent[column]).sum();
        (tangent[row] - moved) * rate
    })
}

/// Finds the point of the branch in the hyperplane through `place` with this normal.
///
/// `along`: the branch's tangent there where it is known to some digits; the derivative by the parameter follows from
/// it, and need not be differenced.
///
/// # Errors
/// [`NumericsError::NoConvergence`] where the corrections do not shrink, [`NumericsError::Singular`] where the branch
/// is parallel to the hyperplane or not unique there, or an error of the family.
pub fn correct(
    family: &mut dyn Family,
    frame: &Frame<'_>,
    place: &Scaled,
    normal: &Scaled,
    along: Option<&Scaled>,
) -> Result<Corrected, NumericsError> {
    let Frame { kind, space, scale, tolerance } = *frame;
    let mut at = projected(space, scale, place);
    let mut slope: Option<State> = None;
    let mut along = along;
    let mut last = f64::INFINITY;
    for iteration in 0..ITERATIONS {
        let (state, parameter) = scale.plain(&at);
        let evaluation = family.evaluate(kind, &state, parameter)?;
        let by_tangent = along.filter(|tangent| tangent[6].abs() > STEEP);
        let given = slope.is_none() && by_tangent.is_some();
        let slope = match (slope, by_tangent) {
            (Some(slope), _) => slope,
            (None, Some(tangent)) => slope_along(&evaluation, tangent, scale),
            _ => *slope.insert(by_parameter(family, kind, &state, parameter, &evaluation.image, scale)?),
        };
        let residual = minus(&evaluation.image, &state);
        let off = dot(normal, &minus(&at, place));
        let (step, tangent) = newton_step(frame, &evaluation, &slope, &residual, normal, off)?;
        let size = norm(&step);
        if !size.is_finite() {
            return Err(NumericsError::NotFinite { time: 0.0 });
        }
        // A place that is off tells that the tangent is, too.
        if size > (TOLERATED * frame.tolerance).max(TRUSTED) {
            along = None;
        }
        let worst = residual.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
        // The linearisation is that of the place before the correction: the steeper it is, the nearer that must be.
        let tolerance = tolerance * (GENTLE / evaluation.derivative.amax()).clamp(STRICTEST, 1.0);
        // What no longer shrinks but is small is as good as the map's own rounding allows.
        let stalled = size > 0.3 * last && size < 1e3 * tolerance;
        if size > 0.7 * last && !stalled || (iteration > 0 && size > 1e3) {
            return Err(NumericsError::NoConvergence { iterations: iteration, residual: worst, tolerance });
        }
        at = projected(space, scale, &std::array::from_fn(|i| at[i] + step[i]));
        if size <= tolerance || stalled {
            let mut evaluation = evaluation;
            for (peak, gradient) in evaluation.peaks.iter_mut().zip(&evaluation.gradients) {
                *peak += (0..6).map(|i| gradient[i] * step[i] * scale.state).sum::<f64>();
            }
            let distance = norm(&minus(&at, place));
            return Ok(Corrected { at, evaluation, tangent, given, distance, residual: worst });
        }
        last = size;
    }
    Err(NumericsError::NoConvergence { iterations: ITERATIONS, residual: last, tolerance })
}

/// The nearest place of the space.
fn projected(space: &Space, scale: Scale, at: &Scaled) -> Scaled {
    if space.fixed == 6 {
        return *at;
    }
    let (state, parameter) = scale.plain(at);
    scale.scaled(&space.project(&state), parameter)
}

/// One step of Newton's method and the branch's tangent, both from one elimination.
fn newton_step(
    frame: &Frame<'_>,
    evaluation: &Evaluation,
    slope: &State,
    residual: &State,
    normal: &Scaled,
    off: f64,
) -> Result<(Scaled, Scaled), NumericsError> {
    let Frame { space, scale, .. } = *frame;
    let fixed = space.fixed;
    let (mut system, border) = bordered(frame, evaluation, slope, normal);
    let right = space.components(&residual.map(|value| -value / scale.state));
    for row in 0..fixed {
        system[row][7] = right[row];
    }
    system[fixed][7] = -off;
    system[fixed][8] = 1.0;
    if !eliminate(&mut system, fixed + 1) {
        return Err(NumericsError::Singular);
    }
    let solution = |column: usize| {
        let mut components = [0.0; 6];
        for row in 0..fixed {
            components[row] = system[row][column];
        }
        let vector = space.vector(&components);
        let mut scaled = [0.0; 7];
        scaled[..6].copy_from_slice(&vector);
        scaled[6] = system[fixed][column];
        scaled
    };
    debug_assert!(border.len() == 7);
    Ok((solution(7), unit(&solution(8))))
}

/// A linear system of up to seven unknowns with up to two right-hand sides, in columns 7 and 8.
type System = [[f64; 9]; 7];

/// The linearised map, bordered by its derivative by the parameter and by the normal: the unknowns are the
/// components within the fixed space, then the parameter.
fn bordered(frame: &Frame<'_>, evaluation: &Evaluation, slope: &State, normal: &Scaled) -> (System, Scaled) {
    let Frame { space, scale, .. } = *frame;
    let fixed = space.fixed;
    let mut system = [[0.0; 9]; 7];
    let inside = space.inside(&evaluation.derivative);
    let slope = space.components(&slope.map(|value| value * scale.parameter / scale.state));
    let mut states = [0.0; 6];
    states.copy_from_slice(&normal[..6]);
    let row_of_normal = space.components(&states);
    for row in 0..fixed {
        for column in 0..fixed {
            system[row][column] = inside[(row, column)] - f64::from(u8::from(row == column));
        }
        system[row][fixed] = slope[row];
        system[fixed][row] = row_of_normal[row];
    }
    system[fixed][fixed] = normal[6];
    (system, *normal)
}

/// Solves in place by Gauss's elimination with row pivoting; false where a pivot vanishes.
fn eliminate(system: &mut System, size: usize) -> bool {
    for column in 0..size {
        let mut pivot = column;
        for row in column + 1..size {
            if system[row][column].abs() > system[pivot][column].abs() {
                pivot = row;
            }
        }
        let largest = system[pivot][column].abs();
        if largest.is_nan() || largest < 1e-280 {
            return false;
        }
        system.swap(column, pivot);
        let upper = system[column];
        for row in column + 1..size {
            let factor = system[row][column] / upper[column];
            for (entry, above) in system[row].iter_mut().zip(upper).skip(column) {
                *entry -= factor * above;
            }
        }
    }
    for column in (0..size).rev() {
        for right in 7..9 {
            let known: f64 = (column + 1..size).map(|i| system[column][i] * system[i][right]).sum();
            system[column][right] = (system[column][right] - known) / system[column][column];
        }
    }
    true
}

/// The unit tangent of the branch at a point on it, with the parameter rising where it changes at all.
///
/// # Errors
/// [`NumericsError::Singular`] where two branches cross, or as the family fails.
pub fn tangent(
    family: &mut dyn Family,
    frame: &Frame<'_>,
    at: &Scaled,
    evaluation: &Evaluation,
) -> Result<Scaled, NumericsError> {
    let (state, parameter) = frame.scale.plain(at);
    let slope = by_parameter(family, frame.kind, &state, parameter, &evaluation.image, frame.scale)?;
    // Of all coordinate directions the one along which the branch runs most gives the smallest solution.
    let mut best: Option<(f64, Scaled)> = None;
    for axis in (0..7).rev() {
        let mut normal = [0.0; 7];
        normal[axis] = 1.0;
        let (mut system, _) = bordered(frame, evaluation, &slope, &normal);
        system[frame.space.fixed][8] = 1.0;
        if !eliminate(&mut system, frame.space.fixed + 1) {
            continue;
        }
        let mut components = [0.0; 6];
        for row in 0..frame.space.fixed {
            components[row] = system[row][8];
        }
        let mut solution = [0.0; 7];
        solution[..6].copy_from_slice(&frame.space.vector(&components));
        solution[6] = system[frame.space.fixed][8];
        let size = norm(&solution);
        if size.is_finite() && best.is_none_or(|(smallest, _)| size < smallest) {
            best = Some((size, solution));
        }
    }
    let (_, solution) = best.ok_or(NumericsError::Singular)?;
    let sign = if solution[6] < 0.0 { -1.0 } else { 1.0 };
    Ok(unit(&solution.map(|value| sign * value)))
}
