//! Curves g(x, y) = 0 in a plane of two parameters, followed by pseudo-arclength: through folds and over sharp tips.
//!
//! Source of the method: H. B. Keller, Numerical solution of bifurcation and nonlinear eigenvalue problems, in:
//! Applications of Bifurcation Theory, Academic Press 1977, 359-384. Here the plane needs no linear algebra: a point is
//! predicted by extrapolation along the arc and corrected along the normal by secants. The step is shortened where the
//! curve turns by more than an angle or the correction is not small, so that neither a tip nor a neighbouring curve is
//! jumped.
//!
//! Both coordinates should be scaled so that the curve is of size one.

use crate::error::NumericsError;

/// A function of the plane whose zeros are followed. Where it answers an error no point is accepted: the curve is looked
/// for in shorter steps.
pub type PlaneFunction<'a> = &'a mut dyn FnMut([f64; 2]) -> Result<f64, NumericsError>;

/// How a curve is followed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// Length of the first step.
    pub first: f64,
    /// Greatest length of a step.
    pub greatest: f64,
    /// Least length of a step: below it the curve counts as lost.
    pub least: f64,
    /// Greatest angle between neighbouring chords, radians.
    pub turn: f64,
    /// A correction below this ends the iteration; its error is then about the square.
    pub tolerance: f64,
    /// Most points.
    pub points: usize,
}

impl Default for Options {
    fn default() -> Self {
        Self { first: 0.02, greatest: 0.15, least: 1e-9, turn: 0.35, tolerance: 1e-6, points: 500 }
    }
}

/// Why a curve ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// It was told to stop: the last point is the first one beyond.
    Stopped,
    /// It has as many points as allowed.
    Points,
    /// No further point was found with the least step.
    Lost,
}

/// Points of a curve in order.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Curve {
    /// The points.
    pub points: Vec<[f64; 2]>,
    /// Derivative of the function along the normal at each, which is the direction of travel turned left.
    pub slopes: Vec<f64>,
    /// Length of the chords up to each.
    pub lengths: Vec<f64>,
}

/// Iterations of a correction.
const CORRECTIONS: usize = 7;
/// Points that an extrapolation or interpolation goes through.
const STENCIL: usize = 6;
/// Corrections beyond this part of the step are not trusted.
const REACH: f64 = 0.1;

/// Attempts at steps, for each point that a curve may have.
const ATTEMPTS: usize = 4;
/// A step shorter than this part of the chord before it takes that chord back.
const SHORT: f64 = 0.2;
/// Corrections must end this much below the step: extrapolation multiplies what is left of them.
const NOISE: f64 = 1e-3;

fn turned(direction: [f64; 2]) -> [f64; 2] {
    [-direction[1], direction[0]]
}

fn along(from: [f64; 2], direction: [f64; 2], length: f64) -> [f64; 2] {
    [from[0] + length * direction[0], from[1] + length * direction[1]]
}

fn direction(from: [f64; 2], to: [f64; 2]) -> ([f64; 2], f64) {
    let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
    let length = dx.hypot(dy);
    ([dx / length, dy / length], length)
}

/// The zero on the normal through `guess` and the derivative along it, by secants from a first `slope`; `None` where
/// there is none within `reach`.
///
/// # Errors
/// Those of the function.
pub fn correct(
    function: PlaneFunction,
    guess: [f64; 2],
    normal: [f64; 2],
    slope: f64,
    reach: f64,
    tolerance: f64,
) -> Result<Option<([f64; 2], f64)>, NumericsError> {
    let mut slope = slope;
    let (mut at, mut value) = (0.0, function(guess)?);
    for _ in 0..CORRECTIONS {
        let step = -value / slope;
        if !step.is_finite() || (at + step).abs() > reach {
            return Ok(None);
        }
        let next = at + step;
        // A step this short is not worth another value: the slope is known to better than one part in a thousand.
        if step.abs() <= tolerance {
            return Ok(Some((along(guess, normal, next), slope)));
        }
        let there = function(along(guess, normal, next))?;
        let secant = (there - value) / step;
        if secant * slope > 0.0 {
            slope = secant;
        }
        (at, value) = (next, there);
    }
    Ok(None)
}

/// [`correct`] with the slope measured at the guess, not that of the point before: towards a sharp tip it falls with the
/// distance, and a correction divided by one too great would be taken for small.
fn correct_anew(
    function: PlaneFunction,
    guess: [f64; 2],
    normal: [f64; 2],
    reach: f64,
    tolerance: f64,
) -> Result<Option<([f64; 2], f64)>, NumericsError> {
    let value = function(guess)?;
    let slope = (function(along(guess, normal, tolerance))? - value) / tolerance;
    let step = -value / slope;
    if step.abs() <= tolerance {
        return Ok(Some((along(guess, normal, step), slope)));
    }
    correct(function, along(guess, normal, step), normal, slope, reach, tolerance)
}

impl Curve {
    fn push(&mut self, point: [f64; 2], slope: f64) {
        let length = match (self.points.last(), self.lengths.last()) {
            (Some(before), Some(length)) => length + direction(*before, point).1,
            _ => 0.0,
        };
        self.points.push(point);
        self.slopes.push(slope);
        self.lengths.push(length);
    }

    fn pop(&mut self) {
        self.points.pop();
        self.slopes.pop();
        self.lengths.pop();
    }

    /// Point and direction at a length along the curve, by the polynomial through the points from `first` on.
    fn interpolated(&self, first: usize, count: usize, length: f64) -> ([f64; 2], [f64; 2]) {
        let (mut point, mut rate) = ([0.0; 2], [0.0; 2]);
        for i in first..first + count {
            let (mut weight, mut derivative) = (1.0, 0.0);
            for j in (first..first + count).filter(|j| *j != i) {
                let gap = self.lengths[i] - self.lengths[j];
                let factor = (length - self.lengths[j]) / gap;
                derivative = derivative * factor + weight / gap;
                weight *= factor;
            }
            for axis in 0..2 {
                point[axis] += weight * self.points[i][axis];
                rate[axis] += derivative * self.points[i][axis];
            }
        }
        (point, direction([0.0; 2], rate).0)
    }

    /// The point of the curve at this length along its chords, to `tolerance`.
    ///
    /// # Errors
    /// Those of the function; [`NumericsError::NoConvergence`] where the correction does not settle.
    pub fn at(
        &self,
        function: PlaneFunction,
        length: f64,
        tolerance: f64,
    ) -> Result<[f64; 2], NumericsError> {
        let last = self.points.len() - 1;
        let after = self.lengths.partition_point(|at| *at < length).clamp(1, last);
        let count = STENCIL.min(last + 1);
        let first = after.saturating_sub(count / 2).min(last + 1 - count);
        let (guess, tangent) = self.interpolated(first, count, length);
        let spacing = self.lengths[after] - self.lengths[after - 1];
        let part = ((length - self.lengths[after - 1]) / spacing).clamp(0.0, 1.0);
        let slope = self.slopes[after - 1] + part * (self.slopes[after] - self.slopes[after - 1]);
        let found = correct(function, guess, turned(tangent), slope, REACH * spacing, tolerance)?;
        found.map(|(point, _)| point).ok_or(NumericsError::NoConvergence {
            iterations: CORRECTIONS,
            residual: spacing,
            tolerance,
        })
    }
}

/// Follows the curve from a point on it, towards `heading`, until `stop` says so of a point.
///
/// # Errors
/// Those of the function at the start; later ones shorten the step.
pub fn trace(
    function: PlaneFunction,
    start: [f64; 2],
    heading: [f64; 2],
    options: &Options,
    stop: &mut dyn FnMut(&Curve) -> bool,
) -> Result<(Curve, End), NumericsError> {
    let mut curve = Curve::default();
    // The gradient by differences gives the tangent at the start.
    let aside = 1e-3 * options.first;
    let mut gradient = [0.0; 2];
    for axis in 0..2 {
        let mut ends = [start; 2];
        ends[0][axis] += aside;
        ends[1][axis] -= aside;
        gradient[axis] = (function(ends[0])? - function(ends[1])?) / (2.0 * aside);
    }
    let size = gradient[0].hypot(gradient[1]);
    let mut tangent = [gradient[1] / size, -gradient[0] / size];
    if tangent[0] * heading[0] + tangent[1] * heading[1] < 0.0 {
        tangent = [-tangent[0], -tangent[1]];
    }
    let normal = turned(tangent);
    curve.push(start, gradient[0] * normal[0] + gradient[1] * normal[1]);
    let mut step = options.first;
    // Each point may cost some attempts, and be taken back.
    for _ in 0..ATTEMPTS * options.points {
        if curve.points.len() >= options.points {
            break;
        }
        let count = curve.points.len();
        let here = curve.points[count - 1];
        let (guess, ahead) = if count == 1 {
            (along(here, tangent, step), tangent)
        } else {
            let stencil = STENCIL.min(count);
            curve.interpolated(count - stencil, stencil, curve.lengths[count - 1] + step)
        };
        let tolerance = options.tolerance.min(NOISE * step);
        let found = correct_anew(function, guess, turned(ahead), REACH * step, tolerance);
        let accepted = found.ok().flatten().and_then(|(point, slope)| {
            let (chord, length) = direction(here, point);
            let turn = (tangent[0] * chord[1] - tangent[1] * chord[0])
                .atan2(tangent[0] * chord[0] + tangent[1] * chord[1])
                .abs();
            let correction = direction(guess, point).1;
            (turn <= options.turn && length < 2.0 * step).then_some((point, slope, chord, turn, correction))
        });
        let Some((point, slope, chord, turn, correction)) = accepted else {
            step *= 0.5;
            if step < options.least {
                return Ok((curve, End::Lost));
            }
            // The last chord was too long for where it ended: the curve had begun to turn.
            if count > 2 && step < SHORT * (curve.lengths[count - 1] - curve.lengths[count - 2]) {
                step = 0.5 * (curve.lengths[count - 1] - curve.lengths[count - 2]);
                curve.pop();
                tangent = direction(curve.points[count - 3], curve.points[count - 2]).0;
            }
            continue;
        };
        curve.push(point, slope);
        tangent = chord;
        if stop(&curve) {
            return Ok((curve, End::Stopped));
        }
        let wished = if correction > 0.02 * step || turn > 0.6 * options.turn {
            0.7
        } else if correction < 4e-3 * step && turn < 0.4 * options.turn {
            1.6
        } else {
            1.0
        };
        step = (step * wished).min(options.greatest);
    }
    Ok((curve, End::Points))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_circle_is_followed_round_and_its_points_are_set_anywhere() {
        let mut circle = |[x, y]: [f64; 2]| Ok(x * x + y * y - 1.0);
        let (curve, end) = trace(&mut circle, [1.0, 0.0], [0.0, 1.0], &Options::default(), &mut |curve| {
            curve.points.len() > 10
                && curve.points[curve.points.len() - 1][1] > 0.0
                && curve.lengths[curve.lengths.len() - 1] > 4.0
        })
        .expect("followed");
        assert_eq!(end, End::Stopped);
        for point in &curve.points {
            assert!((point[0].hypot(point[1]) - 1.0).abs() < 1e-6, "{point:?}");
        }
        // Chords are shorter than arcs, by 1/24 of the square of their angle.
        let whole = curve.lengths[curve.lengths.len() - 1];
        let turned = 2.0 * std::f64::consts::PI + curve.points[curve.points.len() - 1][1].asin();
        assert!(whole < turned && whole > 0.99 * turned, "{whole} {turned}");
        for part in [0.0, 0.13, 0.5, 0.77, 1.0] {
            let [x, y] = curve.at(&mut circle, part * whole, 1e-12).expect("solved");
            assert!((x.hypot(y) - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn a_sharp_tip_is_rounded_and_not_jumped() {
        // Hyperbolas whose radius of curvature at the tip is a quarter of its height.
        for (half_gap, tolerance) in [(1e-2, 1e-6), (1e-3, 1e-6), (1e-5, 1e-9)] {
            let options = Options { tolerance, ..Options::default() };
            // The mirrored half is not of the plane: straight ahead leads there.
            let mut tongue = |[x, y]: [f64; 2]| {
                let outside = NumericsError::NoBracket { low: 0.0, high: 1.0 };
                if y < 0.0 { Err(outside) } else { Ok(4.0 * x * x + half_gap * half_gap - y * y) }
            };
            let start = [-0.5, (1.0 + half_gap * half_gap).sqrt()];
            let (curve, end) = trace(&mut tongue, start, [0.0, -1.0], &options, &mut |curve| {
                curve.points[curve.points.len() - 1][1].abs() > 1.0
            })
            .expect("followed");
            assert_eq!(end, End::Stopped, "{half_gap}");
            let last = curve.points[curve.points.len() - 1];
            assert!(last[0] > 0.4 && last[1] > 0.9, "{half_gap}: {last:?}");
            assert!(curve.points.iter().all(|point| point[1] > 0.9 * half_gap), "{half_gap}");
        }
    }

    #[test]
    fn corrections_out_of_reach_are_none_and_curves_that_end_are_lost() {
        let mut line = |[x, _]: [f64; 2]| Ok(x - 1.0);
        assert_eq!(correct(&mut line, [0.0, 0.0], [1.0, 0.0], 1.0, 0.5, 1e-9), Ok(None));
        let found =
            correct(&mut line, [0.7, 0.2], [1.0, 0.0], 1.0, 0.5, 1e-9).expect("computes").expect("in reach");
        assert!((found.0[0] - 1.0).abs() < 1e-12 && found.0[1] == 0.2);
        let mut ends = |[x, y]: [f64; 2]| Ok(if y > 0.5 { 1.0 } else { x });
        let (curve, end) =
            trace(&mut ends, [0.0, 0.0], [0.0, 1.0], &Options::default(), &mut |_| false).expect("followed");
        assert_eq!(end, End::Lost);
        let height = curve.points[curve.points.len() - 1][1];
        assert!(height <= 0.5 && height > 0.45, "{height}");
        let few = Options { points: 7, ..Options::default() };
        let (curve, end) =
            trace(&mut |[x, _]| Ok(x), [0.0, 0.0], [0.0, 1.0], &few, &mut |_| false).expect("followed");
        assert_eq!((curve.points.len(), end), (7, End::Points));
    }
}
