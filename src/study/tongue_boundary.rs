//! The exact boundary of a tongue as a curve in the plane of mesh frequency and depth of pulsation.
//!
//! The curve is followed by pseudo-arclength from the left edge at the greatest depth down, over the tip, and up to the
//! right edge. Without damping its legs meet in a corner at `k0 = 0`; there, or where the depths asked for end above the
//! tip, each leg is followed by itself. The points are then set along the arc, closer where it turns, each solved for.

use super::ErrorEstimate;
use super::edge_function::EdgeFunction;
use super::linear_floquet::LinearFloquet;
use super::motion;
use super::tongue::{self, Edge, EdgeKind, Tongue};
use crate::error::{NumericsError, StudyError};
use crate::model::parameters::Parameters;
use crate::numerics::continuation::two_parameter::{self, Curve, End, Options};

/// The boundary of a tongue.
#[derive(Clone, Debug, PartialEq)]
pub struct TongueBoundary {
    /// Mesh frequencies, from the left leg over the tip to the right leg; empty where the tongue is closed at all depths.
    pub omega: Vec<f64>,
    /// Depths of the pulsation.
    pub k0: Vec<f64>,
    /// What happens at each point.
    pub kind: Vec<EdgeKind>,
    /// Points of the left leg, the first of the columns. With a `tip` the curve goes on from there; without, the right leg
    /// is a curve of its own.
    pub left: usize,
    /// The lowest point, `[Omega, k0]`; none where the depths asked for end above it.
    pub tip: Option<[f64; 2]>,
    /// How it was computed.
    pub method: String,
    /// `residual`: greatest distance of a point from the curve, along Omega; `step`: greatest change of some points' Omega
    /// when every step is halved.
    pub error: ErrorEstimate,
}

/// Least and greatest number of points.
pub const POINTS: (usize, usize) = (3, 4096);

/// A piece of the boundary, traced.
struct Leg {
    curve: Curve,
    function: EdgeFunction,
}

/// Scales of the plane in which a boundary is followed.
#[derive(Clone, Copy)]
struct Plane {
    middle: f64,
    width: f64,
    depth: f64,
}

impl Plane {
    fn point(&self, omega: f64, k0: f64) -> [f64; 2] {
        [(omega - self.middle) / self.width, k0 / self.depth]
    }

    fn omega(&self, point: [f64; 2]) -> f64 {
        self.middle + self.width * point[0]
    }

    fn k0(&self, point: [f64; 2]) -> f64 {
        self.depth * point[1]
    }
}

/// The boundary from the depth `k0[1]` down to the tip, or to `k0[0]` where that is above it, in `points` points.
///
/// # Errors
/// [`StudyError::Option`] for an option out of range, [`StudyError::Numerics`] where the boundary cannot be followed.
pub fn tongue_boundary(
    p: &Parameters,
    tongue: Tongue,
    k0: [f64; 2],
    points: usize,
    tolerance: f64,
) -> Result<TongueBoundary, StudyError> {
    motion::check_tolerance(tolerance)?;
    let [low, high] = k0;
    if !(low >= 0.0 && low < high && high <= 1.0) {
        return Err(StudyError::Option {
            option: "k0",
            given: format!("[{low}, {high}]"),
            allowed: "[low, high] with 0 <= low < high <= 1".into(),
        });
    }
    if points < POINTS.0 || points > POINTS.1 {
        return Err(StudyError::Option {
            option: "points",
            given: points.to_string(),
            allowed: format!("a whole number from {} to {}", POINTS.0, POINTS.1),
        });
    }
    let linear = LinearFloquet::new(p);
    let mut boundary = TongueBoundary {
        omega: Vec::new(),
        k0: Vec::new(),
        kind: Vec::new(),
        left: 0,
        tip: None,
        method: "pseudo-arclength continuation of the characteristic polynomial's conditions, Taylor series of order 24 on half a period".into(),
        error: ErrorEstimate::default(),
    };
    let Some([left, right]) = tongue::edges(&linear, tongue, high, tolerance)? else { return Ok(boundary) };
    let plane =
        Plane { middle: 0.5 * (left.omega + right.omega), width: right.omega - left.omega, depth: high };
    let traced = along_arc(&linear, tongue, plane, [&left, &right], low, points, tolerance, &mut boundary);
    if let Err(StudyError::Numerics(_)) = traced {
        // Where another tongue runs into this one the curve can turn too sharply to be followed.
        by_levels(&linear, tongue, k0, points, tolerance, &mut boundary)?;
    }
    errors(&linear, plane, &mut boundary)?;
    Ok(boundary)
}

/// The boundary by pseudo-arclength.
#[expect(clippy::too_many_arguments, reason = "the question and its answer, passed on")]
fn along_arc(
    linear: &LinearFloquet,
    tongue: Tongue,
    plane: Plane,
    [left, right]: [&Edge; 2],
    low: f64,
    points: usize,
    tolerance: f64,
    boundary: &mut TongueBoundary,
) -> Result<(), StudyError> {
    match follow(linear, plane, left, right, low)? {
        Followed::Over(leg) => over(linear, plane, &leg, points, tolerance, boundary),
        Followed::Down(leg) => {
            let Followed::Down(other) = follow(linear, plane, right, left, low)? else {
                return Err(NumericsError::NoConvergence { iterations: 0, residual: 1.0, tolerance }.into());
            };
            let named =
                if matches!(tongue, Tongue::Near(_)) { None } else { Some(tongue::origin(linear, tongue).0) };
            two_legs(linear, plane, &[leg, other], low, named, points, tolerance, boundary)
        }
    }
}

/// Halvings of the depths between which the tip lies, where it is looked for by the edges alone.
const HALVINGS: usize = 40;

/// The boundary from the edges at one depth after another.
fn by_levels(
    linear: &LinearFloquet,
    tongue: Tongue,
    [low, high]: [f64; 2],
    points: usize,
    tolerance: f64,
    boundary: &mut TongueBoundary,
) -> Result<(), StudyError> {
    boundary.omega.clear();
    boundary.k0.clear();
    boundary.kind.clear();
    boundary.method =
        "edges at one depth after another: zeros of the characteristic polynomial's conditions, Taylor series of order 24 on half a period"
            .into();
    // Where the tongue cannot be told from another at some depth, that depth is as good as closed.
    let at_depth = |near: Tongue, depth: f64| match tongue::edges(linear, near, depth, tolerance) {
        Err(StudyError::Numerics(error @ NumericsError::TooManySteps { .. })) => Err(error.into()),
        Err(StudyError::Numerics(_)) => Ok(None),
        other => other,
    };
    // A tongue given by a frequency in it is found again by its middle at the depth before.
    let within = |edges: &[Edge; 2]| match tongue {
        Tongue::Near(_) => Tongue::Near(0.5 * (edges[0].omega + edges[1].omega)),
        named => named,
    };
    let Some(top) = at_depth(tongue, high)? else { return Ok(()) };
    let (mut closed, mut open, mut lowest) = (low, high, top);
    let mut reaches = false;
    if low > 0.0
        && let Some(edges) = at_depth(within(&top), low)?
    {
        (open, lowest, reaches) = (low, edges, true);
    }
    for _ in 0..HALVINGS {
        if reaches || open - closed <= 1e-10 {
            break;
        }
        let middle = 0.5 * (open + closed);
        match at_depth(within(&lowest), middle)? {
            Some(edges) => (open, lowest) = (middle, edges),
            None => closed = middle,
        }
    }
    // The tip is one of the points.
    let beside = points - usize::from(!reaches);
    let counts = [beside.div_ceil(2), beside / 2];
    let mut legs: Vec<Vec<(f64, [Edge; 2])>> = Vec::with_capacity(2);
    for count in counts {
        if legs.first().is_some_and(|leg| leg.len() == count) {
            legs.push(legs[0].clone());
            continue;
        }
        // Down to the least depth itself where the tongue is open there.
        let intervals = if reaches { count - 1 } else { count };
        let mut levels = Vec::with_capacity(count);
        let mut before = top;
        for index in 0..count {
            let part = 1.0 - index as f64 / intervals.max(1) as f64;
            let depth = (open * open + (high * high - open * open) * part * part).sqrt();
            if let Some(edges) = at_depth(within(&before), depth)? {
                before = edges;
                levels.push((depth, edges));
            }
        }
        legs.push(levels);
    }
    for (depth, edges) in &legs[0] {
        push(boundary, edges[0].omega, *depth, edges[0].function.kind);
    }
    if !reaches {
        let omega = 0.5 * (lowest[0].omega + lowest[1].omega);
        push(boundary, omega, open, lowest[0].function.kind);
        boundary.tip = Some([omega, open]);
    }
    boundary.left = boundary.omega.len();
    for (depth, edges) in legs[1].iter().rev() {
        push(boundary, edges[1].omega, *depth, edges[1].function.kind);
    }
    Ok(())
}

enum Followed {
    /// From one edge over the tip to the other.
    Over(Leg),
    /// Down to the least depth.
    Down(Leg),
}

fn at(
    linear: &LinearFloquet,
    plane: Plane,
    function: EdgeFunction,
    point: [f64; 2],
) -> Result<f64, NumericsError> {
    function.value(linear, plane.omega(point), plane.k0(point))
}

/// Follows the boundary from an edge downwards.
fn follow(
    linear: &LinearFloquet,
    plane: Plane,
    from: &Edge,
    to: &Edge,
    low: f64,
) -> Result<Followed, StudyError> {
    let function = from.function;
    let start = plane.point(from.omega, plane.depth);
    let floor = low / plane.depth;
    let mut went_over = false;
    let (curve, end) = two_parameter::trace(
        &mut |point| {
            // Damped, the boundary ends above k0 = 0: below is only its mirror image, near which a sharp tip could be jumped.
            if point[1] < 0.0 && !linear.undamped() {
                return Err(NumericsError::NoBracket { low: 0.0, high: plane.depth });
            }
            at(linear, plane, function, point)
        },
        start,
        [0.0, -1.0],
        &Options::default(),
        &mut |curve| {
            let [x, y] = curve.points[curve.points.len() - 1];
            went_over = y >= 1.0;
            y <= floor || y >= 1.0 || x.abs() > 20.0
        },
    )?;
    let leg = Leg { curve, function: from.function };
    match end {
        End::Stopped if went_over => {
            let landed = plane.omega(leg.curve.points[leg.curve.points.len() - 1]);
            // It must come up at the other edge: else another tongue has run into this one.
            if (landed - to.omega).abs() < 0.5 * plane.width {
                return Ok(Followed::Over(leg));
            }
            Err(NumericsError::NoBracket { low: from.omega, high: to.omega }.into())
        }
        End::Stopped if leg.curve.points.last().is_some_and(|point| point[1] <= floor) => {
            Ok(Followed::Down(leg))
        }
        _ => Err(NumericsError::NoConvergence {
            iterations: leg.curve.points.len(),
            residual: leg.curve.points.last().map_or(1.0, |point| point[1]),
            tolerance: floor,
        }
        .into()),
    }
}

/// How much a right angle of turning counts, as a part of the curve's length.
const TURNING: f64 = 0.25;

/// Cumulative weight at the nodes of a curve: its length and its turning.
fn weights(curve: &Curve) -> Vec<f64> {
    let total = curve.lengths[curve.lengths.len() - 1];
    let mut weights = vec![0.0];
    let mut before: Option<f64> = None;
    for pair in curve.points.windows(2) {
        let angle = (pair[1][1] - pair[0][1]).atan2(pair[1][0] - pair[0][0]);
        let length = (pair[1][0] - pair[0][0]).hypot(pair[1][1] - pair[0][1]);
        let turn = before.map_or(0.0, |before| {
            let turn = (angle - before).abs();
            turn.min(2.0 * std::f64::consts::PI - turn)
        });
        before = Some(angle);
        let last = weights[weights.len() - 1];
        weights.push(last + length / total + TURNING * turn / std::f64::consts::FRAC_PI_2);
    }
    weights
}

/// The length along the curve at which its cumulative weight has this value.
fn length_at(curve: &Curve, weights: &[f64], weight: f64) -> f64 {
    let after = weights.partition_point(|at| *at < weight).clamp(1, weights.len() - 1);
    let part = (weight - weights[after - 1]) / (weights[after] - weights[after - 1]);
    curve.lengths[after - 1] + part * (curve.lengths[after] - curve.lengths[after - 1])
}

/// Weight at which the curve, near one of its ends, has the height `y`.
fn weight_at_height(curve: &Curve, weights: &[f64], y: f64) -> f64 {
    let last = curve.points.len() - 1;
    let (low, high) = (curve.points[last][1], curve.points[last - 1][1]);
    let part = if low == high { 1.0 } else { ((high - y) / (high - low)).clamp(0.0, 1.0) };
    weights[last - 1] + part * (weights[last] - weights[last - 1])
}

fn push(boundary: &mut TongueBoundary, omega: f64, k0: f64, kind: EdgeKind) {
    boundary.omega.push(omega);
    boundary.k0.push(k0);
    boundary.kind.push(kind);
}

/// Points along a curve that goes over its tip.
fn over(
    linear: &LinearFloquet,
    plane: Plane,
    leg: &Leg,
    points: usize,
    tolerance: f64,
    boundary: &mut TongueBoundary,
) -> Result<(), StudyError> {
    let curve = &leg.curve;
    let function = leg.function;
    let weights = weights(curve);
    let top = weight_at_height(curve, &weights, 1.0);
    let fine = tolerance.max(1e-14) * 0.1 / plane.width.max(1.0);
    let tip = tip(linear, plane, leg, fine)?;
    let lowest = (1..curve.points.len())
        .fold(0, |best, i| if curve.points[i][1] < curve.points[best][1] { i } else { best });
    // The tip is one of the points: as many of the others on each side as the weights say.
    let tip_weight = weights[lowest];
    let before = (((points - 1) as f64 * tip_weight / top).round() as usize).clamp(1, points - 2);
    let kind = function.kind;
    for index in 0..points {
        if index == before {
            push(boundary, plane.omega(tip), plane.k0(tip), kind);
            continue;
        }
        let weight = if index < before {
            tip_weight * index as f64 / before as f64
        } else {
            tip_weight + (top - tip_weight) * (index - before) as f64 / (points - 1 - before) as f64
        };
        let mut evaluate = |point| at(linear, plane, function, point);
        let point = if index == 0 {
            curve.points[0]
        } else if index + 1 == points {
            level(&mut evaluate, curve, 1.0, fine)?
        } else {
            curve.at(&mut evaluate, length_at(curve, &weights, weight), fine)?
        };
        push(boundary, plane.omega(point), plane.k0(point), kind);
    }
    boundary.left = before + 1;
    boundary.tip = Some([plane.omega(tip), plane.k0(tip)]);
    Ok(())
}

/// The point near the end of a curve that has the height `y`.
fn level(
    evaluate: two_parameter::PlaneFunction,
    curve: &Curve,
    y: f64,
    tolerance: f64,
) -> Result<[f64; 2], NumericsError> {
    let last = curve.points.len() - 1;
    let (below, above) = (curve.points[last - 1], curve.points[last]);
    let part = (y - below[1]) / (above[1] - below[1]);
    let guess = [below[0] + part * (above[0] - below[0]), y];
    let length = (above[0] - below[0]).hypot(above[1] - below[1]);
    // Along x the derivative is that along the normal times the normal's x.
    let slope = -curve.slopes[last] * (above[1] - below[1]) / length;
    let found = two_parameter::correct(evaluate, guess, [1.0, 0.0], slope, length, tolerance)?;
    found.map(|(point, _)| point).ok_or(NumericsError::NoConvergence {
        iterations: 1,
        residual: length,
        tolerance,
    })
}

/// The lowest point: there y^2 is nearly a parabola in x, damped or not, so that polynomials through a few solved
/// points near it converge fast.
fn tip(linear: &LinearFloquet, plane: Plane, leg: &Leg, tolerance: f64) -> Result<[f64; 2], StudyError> {
    let curve = &leg.curve;
    let function = leg.function;
    let lowest = (1..curve.points.len() - 1)
        .fold(1, |best, i| if curve.points[i][1] < curve.points[best][1] { i } else { best });
    let mut centre = curve.points[lowest];
    let mut radius = 0.5 * (curve.points[lowest + 1][0] - curve.points[lowest - 1][0]).abs();
    let mut slope = curve.slopes[lowest];
    for _ in 0..4 {
        // Solved points at five Chebyshev extrema, and the parabola of y^2 with its cubic and quartic terms.
        let offsets = [-1.0, -std::f64::consts::FRAC_1_SQRT_2, 0.0, std::f64::consts::FRAC_1_SQRT_2, 1.0];
        let mut squares = [0.0; 5];
        for (square, offset) in squares.iter_mut().zip(offsets) {
            let x = centre[0] + radius * offset;
            let guess = [x, centre[1]];
            let found = two_parameter::correct(
                &mut |point| at(linear, plane, function, point),
                guess,
                [0.0, 1.0],
                slope,
                0.5,
                tolerance.max(1e-13),
            )?;
            let Some((point, found_slope)) = found else {
                return Err(
                    NumericsError::NoConvergence { iterations: 1, residual: radius, tolerance }.into()
                );
            };
            slope = found_slope;
            *square = point[1] * point[1];
        }
        // Chebyshev coefficients on the extrema; the derivative's root by Newton's method.
        let [a, b, c, d, e] = squares;
        let s = std::f64::consts::FRAC_1_SQRT_2;
        let coefficients = [
            0.25 * (0.5 * (a + e) + b + c + d),
            0.5 * (0.5 * (e - a) + s * (d - b)),
            0.5 * (0.5 * (a + e) - c),
            0.5 * (0.5 * (e - a) - s * (d - b)),
            0.25 * (0.5 * (a + e) - b + c - d),
        ];
        let derivative = |x: f64| {
            coefficients[1]
                + 4.0 * coefficients[2] * x
                + coefficients[3] * (12.0 * x * x - 3.0)
                + coefficients[4] * (32.0 * x * x * x - 16.0 * x)
        };
        let curvature = |x: f64| {
            4.0 * coefficients[2] + 24.0 * coefficients[3] * x + coefficients[4] * (96.0 * x * x - 16.0)
        };
        let mut x = 0.0;
        for _ in 0..6 {
            x = f64::clamp(x - derivative(x) / curvature(x), -1.5, 1.5);
        }
        let value = coefficients[0]
            + coefficients[1] * x
            + coefficients[2] * (2.0 * x * x - 1.0)
            + coefficients[3] * x * (4.0 * x * x - 3.0)
            + coefficients[4] * (8.0 * x * x * (x * x - 1.0) + 1.0);
        centre = [centre[0] + radius * x, value.max(0.0).sqrt()];
        radius *= if x.abs() > 0.7 { 1.0 } else { 0.2 };
    }
    Ok(centre)
}

#[expect(clippy::too_many_arguments, reason = "the question and its answer, passed on")]
/// Points along two legs that end at the depth `low`, or meet at `k0 = 0`.
fn two_legs(
    linear: &LinearFloquet,
    plane: Plane,
    legs: &[Leg],
    low: f64,
    named: Option<f64>,
    points: usize,
    tolerance: f64,
    boundary: &mut TongueBoundary,
) -> Result<(), StudyError> {
    let meets = low == 0.0;
    let fine = tolerance.max(1e-14) * 0.1 / plane.width.max(1.0);
    // The tip, where there is one, is a point of the left leg.
    let counts = [points.div_ceil(2), points / 2];
    let mut ends = [0.0; 2];
    let mut columns: [Vec<[f64; 2]>; 2] = [Vec::new(), Vec::new()];
    for (which, leg) in legs.iter().enumerate() {
        let curve = &leg.curve;
        let function = leg.function;
        let mut evaluate = |point| at(linear, plane, function, point);
        let weights = weights(curve);
        let floor = low / plane.depth;
        let bottom = weight_at_height(curve, &weights, floor);
        // The right leg of two that meet ends one interval before the tip.
        let intervals = if meets && which == 1 { counts[1] } else { counts[which] - 1 };
        for index in 0..counts[which] {
            let point = if index == 0 {
                curve.points[0]
            } else if index == intervals && !meets {
                level(&mut evaluate, curve, floor, fine)?
            } else if index == intervals {
                [f64::NAN, 0.0]
            } else {
                let weight = bottom * index as f64 / intervals as f64;
                curve.at(&mut evaluate, length_at(curve, &weights, weight), fine)?
            };
            columns[which].push(point);
        }
        let last = curve.points.len() - 1;
        let (above, below) = (curve.points[last - 1], curve.points[last]);
        let part = (above[1] - floor) / (above[1] - below[1]);
        ends[which] = above[0] + part * (below[0] - above[0]);
    }
    let tip = meets.then(|| {
        let seen = plane.omega([0.5 * (ends[0] + ends[1]), 0.0]);
        named.unwrap_or_else(|| nearest_origin(linear, seen))
    });
    for (which, column) in columns.iter_mut().enumerate() {
        if which == 1 {
            column.reverse();
        }
        for point in column.iter() {
            let omega = if point[0].is_nan() { tip.unwrap_or(f64::NAN) } else { plane.omega(*point) };
            push(boundary, omega, plane.k0(*point), legs[which].function.kind);
        }
    }
    boundary.left = counts[0];
    boundary.tip = tip.map(|omega| [omega, 0.0]);
    Ok(())
}

/// The mesh frequency nearest to `omega` from which an undamped tongue starts: a sum of two natural frequencies, or
/// twice one, over a whole number.
fn nearest_origin(linear: &LinearFloquet, omega: f64) -> f64 {
    let frequencies = linear.frequencies();
    let mut best = f64::INFINITY;
    for (i, first) in frequencies.iter().enumerate() {
        for second in &frequencies[i..] {
            let order = ((first + second) / omega).round().max(1.0);
            let candidate = (first + second) / order;
            if (candidate - omega).abs() < (best - omega).abs() {
                best = candidate;
            }
        }
    }
    best
}

/// Distance of points from the curve, and their change when every step is halved.
fn errors(linear: &LinearFloquet, plane: Plane, boundary: &mut TongueBoundary) -> Result<(), StudyError> {
    let (mut step, mut residual) = (0.0_f64, 0.0_f64);
    let count = boundary.omega.len();
    if count == 0 {
        return Ok(());
    }
    for index in [0, count / 3, 2 * count / 3, count - 1] {
        if boundary.k0[index] == 0.0 {
            continue;
        }
        let function = EdgeFunction { kind: boundary.kind[index] };
        let edge = Edge { omega: boundary.omega[index], function };
        let (change, distance) = tongue::edge_error(linear, &edge, boundary.k0[index], plane.width)?;
        step = step.max(change);
        residual = residual.max(distance);
    }
    boundary.error = ErrorEstimate { liouville: None, step: Some(step), residual: Some(residual) };
    Ok(())
}
