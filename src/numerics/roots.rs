//! Roots: of any function on a bracket, and all those of a polynomial on an interval, touches told from crossings.

use crate::error::NumericsError;

/// Pieces narrower than this part of the interval are not divided further when stationary points are parted: two
/// so close leave the polynomial between them as it is, to rounding.
const NARROW: f64 = 1e-12;

/// A side of zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Below zero.
    Below,
    /// Above zero.
    Above,
}

impl Side {
    /// The side of a value farther than `tolerance` from zero; `None` nearer to it.
    pub fn of(value: f64, tolerance: f64) -> Option<Self> {
        if value > tolerance {
            Some(Self::Above)
        } else if value < -tolerance {
            Some(Self::Below)
        } else {
            None
        }
    }
}

/// What a polynomial does where it meets zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RootKind {
    /// It passes from below to above.
    Rising,
    /// It passes from above to below.
    Falling,
    /// It comes within the tolerance, or beyond zero by no more than that, and turns back.
    Touch,
    /// It is within the tolerance at an end of the interval, so that the side beyond is not known.
    End,
}

/// A root of a polynomial on an interval that starts at 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Root {
    /// Where it is, from the start of the interval.
    pub at: f64,
    /// What the polynomial does there, followed from the start of the interval to its end.
    pub kind: RootKind,
}

/// A short list on the stack, in order from the start of the interval to its end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Found<T, const LEN: usize> {
    items: [T; LEN],
    count: usize,
}

impl<T: Copy, const LEN: usize> Found<T, LEN> {
    fn none(filler: T) -> Self {
        Self { items: [filler; LEN], count: 0 }
    }

    fn push(&mut self, item: T) {
        if let Some(place) = self.items.get_mut(self.count) {
            *place = item;
            self.count += 1;
        }
    }

    /// What was found.
    pub fn as_slice(&self) -> &[T] {
        &self.items[..self.count]
    }
}

/// A root of a continuous function between `low` and `high`, where its signs differ; within `tolerance`, or to
/// rounding where that is more.
///
/// Source: T. R. Chandrupatla, A new hybrid quadratic/bisection algorithm for finding the zero of a nonlinear
/// function without using derivatives, Advances in Engineering Software 28 (1997) 145-149, doi
/// 10.1016/S0965-9978(96)00051-8. Departure: three evaluations that do not halve the bracket are followed by a
/// bisection, which bounds the work whatever the function.
///
/// # Errors
/// [`NumericsError::NoBracket`] where the signs at the ends are the same, [`NumericsError::NotFinite`] where the
/// function or an end is not finite; its `time` is the argument.
pub fn bracketed_root(
    mut function: impl FnMut(f64) -> f64,
    low: f64,
    high: f64,
    tolerance: f64,
) -> Result<f64, NumericsError> {
    let mut finite = |at: f64| {
        let value = function(at);
        if value.is_finite() && at.is_finite() {
            Ok(value)
        } else {
            Err(NumericsError::NotFinite { time: at })
        }
    };
    let (at_low, at_high) = (finite(low)?, finite(high)?);
    if at_low == 0.0 {
        return Ok(low);
    }
    if at_high == 0.0 {
        return Ok(high);
    }
    if (at_low > 0.0) == (at_high > 0.0) {
        return Err(NumericsError::NoBracket { low, high });
    }
    shrink(finite, (low, at_low), (high, at_high), tolerance)
}

/// The work of [`bracketed_root`], from ends whose values are known, not 0, and of different sign.
fn shrink(
    mut function: impl FnMut(f64) -> Result<f64, NumericsError>,
    low: (f64, f64),
    high: (f64, f64),
    tolerance: f64,
) -> Result<f64, NumericsError> {
    // The root is between `newest` and `opposite`; `dropped` is the point that the newest replaced.
    let (mut newest, mut opposite) = (low, high);
    let whole = (high.0 - low.0).abs();
    let least = 0.5 * tolerance.max(0.0) + f64::EPSILON * f64::EPSILON * whole;
    let mut part = 0.5;
    let (mut halved, mut since_halved) = (whole, 0);
    loop {
        let at = newest.0 + part * (opposite.0 - newest.0);
        let value = function(at)?;
        let dropped;
        if (value > 0.0) == (newest.1 > 0.0) {
            dropped = newest;
        } else {
            dropped = opposite;
            opposite = newest;
        }
        newest = (at, value);
        let best = if newest.1.abs() < opposite.1.abs() { newest } else { opposite };
        let width = (opposite.0 - newest.0).abs();
        let near = (f64::EPSILON * best.0.abs() + least) / width;
        if value == 0.0 || width == 0.0 || near >= 0.5 {
            return Ok(best.0);
        }
        since_halved += 1;
        if width <= 0.5 * halved {
            (halved, since_halved) = (width, 0);
        }
        let position = (newest.0 - opposite.0) / (dropped.0 - opposite.0);
        let rise = (newest.1 - opposite.1) / (dropped.1 - opposite.1);
        let trusted = since_halved < 3 && rise * rise < position && (1.0 - rise).powi(2) < 1.0 - position;
        part = if trusted {
            // Inverse quadratic interpolation through the three points.
            let (a, b, c) = (newest, opposite, dropped);
            a.1 / (b.1 - a.1) * (c.1 / (b.1 - c.1))
                + (c.0 - a.0) / (b.0 - a.0) * (a.1 / (c.1 - a.1)) * (b.1 / (c.1 - b.1))
        } else {
            0.5
        };
        part = if part.is_finite() { part.clamp(near, 1.0 - near) } else { 0.5 };
    }
}

/// Value of the polynomial with these coefficients of rising powers, by Horner's rule.
pub fn polynomial_value<const LEN: usize>(coefficients: &[f64; LEN], at: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, coefficient| sum * at + coefficient)
}

/// Coefficients of the derivative; the last one is 0.
pub fn derivative<const LEN: usize>(coefficients: &[f64; LEN]) -> [f64; LEN] {
    let mut derivative = [0.0; LEN];
    for n in 1..LEN {
        derivative[n - 1] = coefficients[n] * n as f64;
    }
    derivative
}

/// Every root of the polynomial from 0 to `length` (below 0: backwards), given by finite coefficients of rising
/// powers; a root is where its value is within `tolerance` (at least 0) of zero, crossings are located to rounding.
///
/// Between neighbouring stationary points the polynomial is monotone: their values show every crossing, pairs
/// of crossings within the interval included, and every touch. A polynomial within the tolerance all over has
/// one root, of kind [`RootKind::End`].
pub fn polynomial_roots<const LEN: usize>(
    coefficients: &[f64; LEN],
    length: f64,
    tolerance: f64,
) -> Found<Root, LEN> {
    let mut roots = Found::none(Root { at: 0.0, kind: RootKind::End });
    follow_roots(coefficients, length, tolerance, None, &mut |root| {
        roots.push(root);
        false
    });
    roots
}

/// Calls `visit` with each root as [`polynomial_roots`] has them, in order, until it answers true; answers the
/// side reached.
///
/// `side` is the side the polynomial comes from where that is known: a start within the tolerance is then no end
/// but part of a crossing or touch, and a start on the other side is a crossing at 0.
pub fn follow_roots<const LEN: usize>(
    coefficients: &[f64; LEN],
    length: f64,
    tolerance: f64,
    side: Option<Side>,
    visit: &mut impl FnMut(Root) -> bool,
) -> Option<Side> {
    if let Some(here) = far_from_zero(coefficients, length, tolerance)
        && side.is_none_or(|side| side == here)
    {
        return Some(here);
    }
    let stationary = stationary_points(coefficients, length);
    let nodes = std::iter::once(0.0).chain(stationary.as_slice().iter().copied()).chain([length]);
    let mut side = side;
    // The last node outside the tolerance, and the node nearest to zero since.
    let mut outside: Option<(f64, f64)> = None;
    let mut within: Option<(f64, f64)> = None;
    for at in nodes {
        let value = polynomial_value(coefficients, at);
        let Some(here) = Side::of(value, tolerance) else {
            if within.is_none_or(|(_, nearest)| value.abs() < nearest) {
                within = Some((at, value.abs()));
            }
            continue;
        };
        let root = match (side, within) {
            (None, Some((start, _))) => Some(Root { at: start, kind: RootKind::End }),
            (Some(before), Some((touch, _))) if before == here => {
                Some(Root { at: touch, kind: RootKind::Touch })
            }
            (Some(before), _) if before != here => {
                let from = outside.unwrap_or((0.0, coefficients[0]));
                let kind = if here == Side::Above { RootKind::Rising } else { RootKind::Falling };
                Some(Root { at: crossing_between(coefficients, from, (at, value)), kind })
            }
            _ => None,
        };
        side = Some(here);
        (outside, within) = (Some((at, value)), None);
        if root.is_some_and(&mut *visit) {
            return side;
        }
    }
    if let Some((at, _)) = within {
        visit(Root { at, kind: RootKind::End });
    }
    side
}

/// The root between two points; the first one where the second's side is reached there already.
fn crossing_between<const LEN: usize>(coefficients: &[f64; LEN], from: (f64, f64), to: (f64, f64)) -> f64 {
    if from.1 == 0.0 || (from.1 > 0.0) == (to.1 > 0.0) {
        return from.0;
    }
    let value = |at: f64| Ok(polynomial_value(coefficients, at));
    shrink(value, from, to, f64::EPSILON * (to.0 - from.0).abs()).unwrap_or(to.0)
}

/// The side the polynomial is on all over the interval, where its coefficients alone show it is farther than
/// `tolerance` from zero.
fn far_from_zero<const LEN: usize>(coefficients: &[f64; LEN], length: f64, tolerance: f64) -> Option<Side> {
    let scaled = scaled(coefficients, length);
    let rest: f64 = scaled[1..].iter().map(|value| value.abs()).sum();
    if scaled[0].abs() > rest + tolerance {
        return Side::of(scaled[0], tolerance);
    }
    // The polynomial is nowhere beyond its Bernstein coefficients.
    let hull = bernstein(&scaled);
    let margin = tolerance + rounding(&scaled);
    let first = Side::of(hull[0], margin);
    if hull.iter().all(|value| Side::of(*value, margin) == first) { first } else { None }
}

/// Points strictly within the interval from 0 to `length` (below 0: backwards) where the derivative of the
/// polynomial changes sign, in order.
pub fn stationary_points<const LEN: usize>(coefficients: &[f64; LEN], length: f64) -> Found<f64, LEN> {
    let mut points = Found::none(0.0);
    let slopes = derivative(coefficients);
    let powers = scaled(&slopes, length);
    let (hull, noise) = (bernstein(&powers), rounding(&powers));
    part_roots(&hull, (0.0, 1.0), noise, &mut 0.0, &mut |low, high| {
        let at = refined(&slopes, low * length, high * length);
        if at != 0.0 && at != length {
            points.push(at);
        }
    });
    points
}

/// The root of the polynomial in a narrow interval that has one; where rounding hides it, the end nearer to it.
fn refined<const LEN: usize>(coefficients: &[f64; LEN], low: f64, high: f64) -> f64 {
    let from = (low, polynomial_value(coefficients, low));
    let to = (high, polynomial_value(coefficients, high));
    if from.1 * to.1 < 0.0 {
        return crossing_between(coefficients, from, to);
    }
    if from.1.abs() <= to.1.abs() { low } else { high }
}

/// Coefficients of the polynomial in the variable that runs from 0 to 1 over the interval.
fn scaled<const LEN: usize>(coefficients: &[f64; LEN], length: f64) -> [f64; LEN] {
    let mut scaled = *coefficients;
    let mut power = 1.0;
    for value in &mut scaled {
        *value *= power;
        power *= length;
    }
    scaled
}

/// Bernstein coefficients on [0, 1] of a polynomial given by its powers.
fn bernstein<const LEN: usize>(powers: &[f64; LEN]) -> [f64; LEN] {
    let degree = LEN - 1;
    let mut coefficients = [0.0; LEN];
    for (i, coefficient) in coefficients.iter_mut().enumerate() {
        let mut ratio = 1.0;
        for (k, power) in powers.iter().enumerate().take(i + 1) {
            *coefficient += ratio * power;
            ratio *= (i - k) as f64 / (degree - k).max(1) as f64;
        }
    }
    coefficients
}

/// Bound of the rounding errors of a polynomial's values and Bernstein coefficients on [0, 1], given its powers.
fn rounding<const LEN: usize>(powers: &[f64; LEN]) -> f64 {
    let sum: f64 = powers.iter().map(|value| value.abs()).sum();
    2.0 * LEN as f64 * f64::EPSILON * sum
}

/// Calls `found` with an interval around each change of sign of a polynomial in Bernstein form, in order; an
/// interval of no width is the root itself.
///
/// The changes of sign of the coefficients are at least as many as the roots and of the same parity (variation
/// diminution: G. Farin, Curves and Surfaces for CAGD, 5th ed. 2002, sections 5.3 and 6.3); halving the interval
/// parts them. `last` is the sign before the interval, and after it when this returns: coefficients below
/// `noise` have none, and a root may hide among them at a joint.
fn part_roots<const LEN: usize>(
    coefficients: &[f64; LEN],
    (low, high): (f64, f64),
    noise: f64,
    last: &mut f64,
    found: &mut impl FnMut(f64, f64),
) {
    let signs = || coefficients.iter().filter(|value| value.abs() > noise).map(|value| value.signum());
    let Some(first) = signs().next() else {
        return;
    };
    let (end, changes) =
        signs().fold((first, 0), |(before, count), sign| (sign, count + usize::from(sign != before)));
    // The one root of a piece is only told from one at its end where both ends have signs.
    let told = changes == 0 || changes == 1 && [0, LEN - 1].iter().all(|n| coefficients[*n].abs() > noise);
    if !told && high - low > NARROW {
        let (mut left, mut right) = ([0.0; LEN], *coefficients);
        for level in (0..LEN).rev() {
            left[LEN - 1 - level] = right[0];
            for i in 0..level {
                right[i] = 0.5 * (right[i] + right[i + 1]);
            }
        }
        let middle = 0.5 * (low + high);
        part_roots(&left, (low, middle), noise, last, found);
        part_roots(&right, (middle, high), noise, last, found);
        return;
    }
    if *last * first < 0.0 {
        found(low, low);
    }
    if first != end {
        found(low, high);
    }
    *last = end;
}

/// Least and greatest value of a polynomial on an interval, and where they are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extrema {
    /// Least value.
    pub least: f64,
    /// Where it is, from the start of the interval.
    pub least_at: f64,
    /// Greatest value.
    pub greatest: f64,
    /// Where it is, from the start of the interval.
    pub greatest_at: f64,
}

/// Least and greatest value from 0 to `length` (below 0: backwards), ends and interior extrema both considered; the
/// coefficients are finite, of rising powers.
pub fn extrema<const LEN: usize>(coefficients: &[f64; LEN], length: f64) -> Extrema {
    let start = coefficients[0];
    let mut extrema = Extrema { least: start, least_at: 0.0, greatest: start, greatest_at: 0.0 };
    let stationary = stationary_points(coefficients, length);
    for at in stationary.as_slice().iter().copied().chain([length]) {
        let value = polynomial_value(coefficients, at);
        if value < extrema.least {
            (extrema.least, extrema.least_at) = (value, at);
        }
        if value > extrema.greatest {
            (extrema.greatest, extrema.greatest_at) = (value, at);
        }
    }
    extrema
}
