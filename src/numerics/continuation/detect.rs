//! Bifurcations between two points of a branch: seen by the signs of test functions and by the count of multipliers
//! outside the unit circle, then located as roots along the branch.

use super::corrector::{Corrected, Frame, correct};
use super::predictor::{self, Knot};
use super::symmetry::Space;
use super::{Evaluation, Family, Scaled, State, minus, unit};
use crate::error::NumericsError;
use crate::numerics::floquet::{self, Matrix6, Spectrum};

/// Test functions of one block of the linearisation A.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Tests {
    /// det(A - I): zero where a multiplier is +1.
    pub plus: f64,
    /// det(A + I): zero where a multiplier is -1.
    pub minus: f64,
    /// Product of `1 - mu_i mu_j` over all pairs: zero where a complex pair is on the unit circle.
    pub pair: f64,
    /// Least distance of a multiplier from +1.
    pub from_one: f64,
    /// Least distance of a multiplier from the unit circle; 1 for an undamped system.
    pub margin: f64,
    /// Number of multipliers outside the unit circle.
    pub outside: usize,
    /// Of these, the real ones above 1 and the real ones below -1.
    pub beyond: [usize; 2],
}

/// The linearisation of a map at a fixed point, taken apart.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Linear {
    /// Test functions within the fixed space, or of the first block; then of the second, if any.
    pub blocks: [Tests; 2],
    /// Number of blocks.
    pub count: usize,
    /// All multipliers of the map.
    pub spectrum: Spectrum,
}

impl Linear {
    /// Takes the derivative at a point of a space apart.
    ///
    /// # Errors
    /// As [`floquet::spectrum`].
    pub fn of(derivative: &Matrix6, space: &Space, slack: f64) -> Result<Self, NumericsError> {
        let mut blocks = [Tests::default(); 2];
        if space.whole() {
            let spectrum = floquet::spectrum(derivative)?;
            blocks[0] = tests(&spectrum, 6, slack);
            return Ok(Self { blocks, count: 1, spectrum });
        }
        let inside = space.inside(derivative);
        let mut values = [(0.0, 0.0); 6];
        let mut filled = 0;
        for (block, (from, to)) in space.ranges().enumerate() {
            let spectrum = block_spectrum(&inside, from, to)?;
            blocks[block] = tests(&spectrum, to - from, slack);
            for i in 0..to - from {
                values[filled] = (spectrum.re[i], spectrum.im[i]);
                filled += 1;
            }
        }
        Ok(Self { blocks, count: 2, spectrum: floquet::ordered(values) })
    }

    /// Number of multipliers outside the unit circle.
    pub fn outside(&self) -> usize {
        self.blocks[..self.count].iter().map(|block| block.outside).sum()
    }
}

/// Eigenvalues of a diagonal block, largest modulus first; zeros behind them.
fn block_spectrum(matrix: &Matrix6, from: usize, to: usize) -> Result<Spectrum, NumericsError> {
    if to - from == 2 {
        let [[a, b], [c, d]] = [0, 1].map(|i| [0, 1].map(|j| matrix[(from + i, from + j)]));
        let (half, gap) = (0.5 * (a + d), 0.5 * (a - d));
        let discriminant = gap * gap + b * c;
        let mut spectrum = Spectrum { re: [0.0; 6], im: [0.0; 6] };
        if discriminant >= 0.0 {
            // The smaller root from the product: no cancellation.
            let large = half + discriminant.sqrt().copysign(half);
            let small = if large == 0.0 { 0.0 } else { (a * d - b * c) / large };
            (spectrum.re[0], spectrum.re[1]) = (large, small);
        } else {
            let root = (-discriminant).sqrt();
            (spectrum.re[0], spectrum.re[1]) = (half, half);
            (spectrum.im[0], spectrum.im[1]) = (root, -root);
        }
        if !spectrum.re[0].is_finite() || !spectrum.im[0].is_finite() {
            return Err(NumericsError::NotFinite { time: 0.0 });
        }
        return Ok(spectrum);
    }
    let inner = |i: usize| i < to - from;
    floquet::spectrum(&Matrix6::from_fn(|i, j| {
        if inner(i) && inner(j) { matrix[(from + i, from + j)] } else { 0.0 }
    }))
}

/// Moduli above 1 by less are so by rounding: on a branch of a linear system, along which the parameter stays the same,
/// one multiplier is 1.
const ROUNDING: f64 = 1e-7;
/// Nearer to +1 than this at both ends of an interval, a multiplier stays there, and the sign of its test function is
/// rounding.
const NEUTRAL: f64 = 1e-7;

/// Test functions of a block from its multipliers.
fn tests(spectrum: &Spectrum, size: usize, slack: f64) -> Tests {
    let value = |i: usize| (spectrum.re[i], spectrum.im[i]);
    let times = |(a, b): (f64, f64), (c, d): (f64, f64)| (a * c - b * d, a * d + b * c);
    let (mut plus, mut minus, mut pair) = ((1.0, 0.0), (1.0, 0.0), (1.0, 0.0));
    let (mut outside, mut margin, mut from_one) = (0, 1.0_f64, f64::INFINITY);
    let mut beyond = [0; 2];
    for i in 0..size {
        let (re, im) = value(i);
        plus = times(plus, (re - 1.0, im));
        minus = times(minus, (re + 1.0, im));
        for j in 0..i {
            let (x, y) = times((re, im), value(j));
            pair = times(pair, (1.0 - x, -y));
        }
        let modulus = re.hypot(im);
        if modulus > 1.0 + slack.max(ROUNDING) {
            outside += 1;
            if im == 0.0 {
                beyond[usize::from(re < 0.0)] += 1;
            }
        }
        from_one = from_one.min((re - 1.0).hypot(im));
        if slack == 0.0 {
            margin = margin.min((modulus - 1.0).abs());
        }
    }
    // Undamped, the multipliers come in reciprocal pairs, and the product is zero everywhere.
    Tests {
        plus: plus.0,
        minus: minus.0,
        pair: if slack > 0.0 { 0.0 } else { pair.0 },
        from_one,
        margin,
        outside,
        beyond,
    }
}

/// What happens at a point of a branch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sign {
    /// A multiplier of the map is +1.
    Plus,
    /// A multiplier of the map is -1.
    Minus,
    /// A complex pair is on the unit circle.
    Pair,
    /// The orbit touches the end of an analytic piece.
    Touch,
}

/// A point of a branch, with all that was found there.
#[derive(Clone, Copy, Debug)]
pub struct Point {
    /// Length of the branch up to here.
    pub arc: f64,
    /// State and parameter over their scales.
    pub at: Scaled,
    /// Unit tangent in the direction of travel.
    pub tangent: Scaled,
    /// The map there.
    pub evaluation: Evaluation,
    /// Its linearisation taken apart.
    pub linear: Linear,
    /// Residual of the map at the last evaluation.
    pub residual: f64,
    /// A bifurcation itself: its test functions vanish and their signs mean nothing.
    pub singular: bool,
}

impl Point {
    /// As the predictor sees it.
    pub fn knot(&self) -> Knot {
        (self.arc, self.at, self.tangent)
    }
}

/// A bifurcation that was located.
#[derive(Clone, Copy, Debug)]
pub struct Located {
    /// What happens.
    pub sign: Sign,
    /// In which block.
    pub block: usize,
    /// Whether the parameter turns back there.
    pub turns: bool,
    /// The point.
    pub point: Point,
}

/// Where between two neighbouring points of a branch to look for bifurcations, and how to get there.
pub struct Search<'a> {
    /// How points are corrected.
    pub frame: Frame<'a>,
    /// Points of the branch around the interval, for interpolation.
    pub knots: &'a [Knot],
    /// Along the chord of the whole interval: one normal for all points between, so that they lie in the order of
    /// their arclengths.
    pub normal: Scaled,
    /// What is found, in order.
    pub found: Vec<Located>,
}

/// Intervals shorter than this part of a unit length are points.
const SHORTEST: f64 = 1e-11;
/// Part of an interval by which places within it keep away from its ends.
const LEAST_SHARE: f64 = 1e-6;
/// Most divisions of one interval.
const DEEPEST: usize = 48;

impl Search<'_> {
    /// Finds every bifurcation between two points.
    ///
    /// # Errors
    /// Where a point between them cannot be found, which between two points of one branch does not happen unless the
    /// work allowed is spent.
    pub fn between(
        &mut self,
        family: &mut dyn Family,
        from: &Point,
        to: &Point,
        depth: usize,
    ) -> Result<(), NumericsError> {
        let changes = changes(from, to);
        if changes.is_empty() {
            return Ok(());
        }
        let short = to.arc - from.arc < SHORTEST || depth >= DEEPEST;
        // A pair that crosses changes the sign of its test function: two single multipliers that cross do not.
        let sure = |sign: Sign, block: usize| {
            let (before, after) = (from.linear.blocks[block].pair, to.linear.blocks[block].pair);
            sign != Sign::Pair || before * after < 0.0 || family_is_undamped(before, after)
        };
        if let [(sign, block)] = &changes[..]
            && (short || sure(*sign, *block))
        {
            let located = self.locate(family, from, to, (*sign, *block))?;
            self.found.push(located);
            return Ok(());
        }
        if short {
            for (sign, block) in changes {
                self.found.push(Located { sign, block, turns: turns(from, to), point: *to });
            }
            return Ok(());
        }
        let middle = self.point(family, from, to, 0.5 * (from.arc + to.arc))?;
        self.between(family, from, &middle, depth + 1)?;
        self.between(family, &middle, to, depth + 1)
    }

    /// The point of the branch at an arclength between two points.
    ///
    /// # Errors
    /// As [`correct`].
    pub fn point(
        &self,
        family: &mut dyn Family,
        from: &Point,
        to: &Point,
        arc: f64,
    ) -> Result<Point, NumericsError> {
        self.point_aside(family, from, to, arc, &mut [0.0; 7])
    }

    /// The same with the branch's distance from what the points around lead to, which a place near by has as well: what it
    /// was there, and is here.
    fn point_aside(
        &self,
        family: &mut dyn Family,
        from: &Point,
        to: &Point,
        arc: f64,
        aside: &mut Scaled,
    ) -> Result<Point, NumericsError> {
        let place = if self.knots.len() < predictor::FEWEST {
            predictor::hermite(&from.knot(), &to.knot(), arc)
        } else {
            predictor::place(self.knots, arc)
        };
        let along = predictor::direction(self.knots, arc);
        let from = std::array::from_fn(|i| place[i] + aside[i]);
        let corrected = correct(family, &self.frame, &from, &self.normal, along.as_ref())?;
        *aside = minus(&corrected.at, &place);
        let slack = family.slack();
        finish(corrected, arc, self.frame.space, slack)
    }

    /// Narrows the interval of one change until it is a point.
    fn locate(
        &self,
        family: &mut dyn Family,
        from: &Point,
        to: &Point,
        (sign, block): (Sign, usize),
    ) -> Result<Located, NumericsError> {
        let (mut low, mut high) = (*from, *to);
        let value = |point: &Point| {
            let tests = point.linear.blocks[block];
            match sign {
                Sign::Plus => tests.plus,
                Sign::Minus => tests.minus,
                Sign::Pair => tests.pair,
                Sign::Touch => 0.0,
            }
        };
        let (mut at_low, mut at_high) = (value(&low), value(&high));
        let smooth = at_low * at_high < 0.0;
        let mut best = if at_low.abs() < at_high.abs() { low } else { high };
        // The parabola through three points in the test function leads to the root; where it leads out of the interval, and
        // where the interval does not shrink, it is halved.
        let mut third: Option<(f64, f64)> = None;
        let mut aside = [0.0; 7];
        let mut width = f64::INFINITY;
        for iteration in 1..=DEEPEST {
            let length = high.arc - low.arc;
            if length < SHORTEST {
                break;
            }
            let mut arc = low.arc + 0.5 * length;
            if smooth {
                let slow = iteration % 4 == 0 && length > 0.25 * width;
                if iteration % 4 == 0 {
                    width = length;
                }
                if !slow {
                    arc = inverse([(low.arc, at_low), (high.arc, at_high)], third);
                }
                // What would be found next to the best point is that point.
                if iteration > 1 && (arc - best.arc).abs() < SHORTEST {
                    break;
                }
                arc = arc.clamp(low.arc + LEAST_SHARE * length, high.arc - LEAST_SHARE * length);
            }
            let middle = match self.point_aside(family, &low, &high, arc, &mut aside) {
                Ok(middle) => middle,
                // At a crossing of two branches the last places are singular: what is bracketed so far is the answer.
                Err(_) if length < 1e-5 => break,
                Err(error) => return Err(error),
            };
            best = middle;
            let here = value(&middle);
            if smooth && here == 0.0 {
                break;
            }
            let below =
                if smooth { (here > 0.0) == (at_low > 0.0) } else { !changed(&low, &middle, sign, block) };
            if below {
                third = Some((low.arc, at_low));
                (low, at_low) = (middle, here);
            } else {
                third = Some((high.arc, at_high));
                (high, at_high) = (middle, here);
            }
        }
        let mut point = best;
        point.singular = true;
        Ok(Located { sign, block, turns: turns(from, to), point })
    }
}

/// Where a function with these values at both ends of an interval is zero: by inverse interpolation through the third
/// point too, if there is one and the answer lies within.
fn inverse([(low, at_low), (high, at_high)]: [(f64, f64); 2], third: Option<(f64, f64)>) -> f64 {
    let secant = low + (high - low) * (at_low / (at_low - at_high));
    let Some((other, at_other)) = third else { return secant };
    let quadratic = low * (at_high / (at_low - at_high)) * (at_other / (at_low - at_other))
        + high * (at_low / (at_high - at_low)) * (at_other / (at_high - at_other))
        + other * (at_low / (at_other - at_low)) * (at_high / (at_other - at_high));
    if quadratic > low && quadratic < high { quadratic } else { secant }
}

/// A corrected place as a point of the branch.
///
/// # Errors
/// As [`Linear::of`].
pub fn finish(corrected: Corrected, arc: f64, space: &Space, slack: f64) -> Result<Point, NumericsError> {
    let linear = Linear::of(&corrected.evaluation.derivative, space, slack)?;
    Ok(Point {
        arc,
        at: corrected.at,
        tangent: corrected.tangent,
        evaluation: corrected.evaluation,
        linear,
        residual: corrected.residual,
        singular: false,
    })
}

/// Whether the parameter runs one way at one point and the other way at the other.
fn turns(from: &Point, to: &Point) -> bool {
    let (before, after) = (from.tangent[6], to.tangent[6]);
    (before > 0.0) != (after > 0.0) && before.abs().max(after.abs()) > NEUTRAL
}

/// Whether this change, and no other of its block, is what tells two points apart.
fn changed(from: &Point, to: &Point, sign: Sign, block: usize) -> bool {
    let (before, after) = (&from.linear.blocks[block], &to.linear.blocks[block]);
    match sign {
        Sign::Plus => {
            let neutral = before.from_one.max(after.from_one) < NEUTRAL;
            (before.plus > 0.0) != (after.plus > 0.0) && !neutral
        }
        Sign::Minus => (before.minus > 0.0) != (after.minus > 0.0),
        Sign::Pair => before.outside != after.outside,
        Sign::Touch => from.evaluation.pieces != to.evaluation.pieces,
    }
}

/// Undamped, the test function of pairs is left at zero.
fn family_is_undamped(before: f64, after: f64) -> bool {
    before == 0.0 && after == 0.0
}

/// How much greater the first of two small numbers is.
fn difference(after: usize, before: usize) -> isize {
    after.cast_signed() - before.cast_signed()
}

/// What must have happened between two points of a branch.
pub fn changes(from: &Point, to: &Point) -> Vec<(Sign, usize)> {
    let mut changes = Vec::new();
    if from.singular || to.singular {
        return changes;
    }
    for block in 0..from.linear.count {
        let (before, after) = (&from.linear.blocks[block], &to.linear.blocks[block]);
        let mut singles = 0_isize;
        for (which, sign) in [Sign::Plus, Sign::Minus].into_iter().enumerate() {
            if changed(from, to, sign, block) {
                changes.push((sign, block));
                singles += difference(after.beyond[which], before.beyond[which]).signum();
            }
        }
        // Each crossing of +1 or -1 moves one multiplier, out or in; what is moved beyond that are pairs. One that comes in
        // while a pair goes out changes the count by one, as one that goes out does.
        let moved = difference(after.outside, before.outside) - singles;
        for _ in 0..moved.unsigned_abs() / 2 {
            changes.push((Sign::Pair, block));
        }
    }
    // The parameter cannot turn without a multiplier of +1: where none is seen, two crossed.
    if turns(from, to) && !changes.contains(&(Sign::Plus, 0)) {
        changes.extend([(Sign::Plus, 0); 2]);
    }
    if from.evaluation.pieces != to.evaluation.pieces {
        changes.push((Sign::Touch, 0));
    }
    changes
}

/// A dip deeper than this part of the values around it may go through zero between the points.
const DEEP: f64 = 0.5;

/// Where between three neighbouring points of a branch, none of which differs from the next in what [`changes`] tells,
/// a test function may come near zero and turn back: there two bifurcations can lie closer together than the points.
pub fn dip(points: [&Point; 3]) -> Option<f64> {
    let [left, middle, right] = points;
    if points.iter().any(|point| point.singular) {
        return None;
    }
    let values = |point: &Point| {
        let [first, second] = &point.linear.blocks;
        [first.plus, first.minus, first.margin, second.plus, second.minus, second.margin]
    };
    let used = 3 * left.linear.count;
    let (at_left, at_middle, at_right) = (values(left), values(middle), values(right));
    let (before, after) = (middle.arc - left.arc, right.arc - middle.arc);
    (0..used).find_map(|index| {
        let sign = at_middle[index].signum();
        let [f0, f1, f2] = [at_left, at_middle, at_right].map(|all| all[index] * sign);
        // The parabola through the three, about the middle one.
        let (rise, fall) = ((f2 - f1) / after, (f1 - f0) / before);
        let bend = (rise - fall) / (before + after);
        let slope = (rise * before + fall * after) / (before + after);
        if !(f0 > 0.0 && f2 > 0.0 && bend > 0.0) {
            return None;
        }
        let at = -0.5 * slope / bend;
        let least = f1 - 0.25 * slope * slope / bend;
        let inside = at > -before && at < after;
        // Near one of the points nothing new would be seen.
        let new = [-before, 0.0, after].iter().all(|known| (at - known).abs() > 1e-3 * (before + after));
        (inside && new && least < DEEP * f0.min(f1).min(f2)).then_some(middle.arc + at)
    })
}

/// The direction in which a multiplier of +1 or -1 acts: the null vector of A -+ I within a block.
pub fn direction(derivative: &Matrix6, space: &Space, block: usize, sign: Sign) -> Option<State> {
    let inside = space.inside(derivative);
    let (from, to) = space.ranges().nth(block)?;
    let one = if sign == Sign::Minus { -1.0 } else { 1.0 };
    let within = |i: usize| (from..to).contains(&i);
    let shifted = Matrix6::from_fn(|i, j| {
        let unit = f64::from(u8::from(i == j));
        if within(i) && within(j) { inside[(i, j)] - one * unit } else { unit * 1e3 }
    });
    let decomposed = shifted.svd(false, true);
    let smallest = decomposed.singular_values.imin();
    let row = decomposed.v_t?.row(smallest).into_owned();
    let components: State = std::array::from_fn(|i| row[i]);
    Some(unit(&space.vector(&components)))
}

#[cfg(test)]
mod tests {
    use super::super::symmetry::Group;
    use super::*;

    /// A point of a branch whose linearisation has these pairs, by modulus and angle, and these real multipliers.
    fn point(pairs: &[(f64, f64)], real: &[f64]) -> Point {
        let mut derivative = Matrix6::zeros();
        let mut at = 0;
        for (modulus, angle) in pairs {
            let (re, im) = (modulus * angle.cos(), modulus * angle.sin());
            (derivative[(at, at)], derivative[(at + 1, at + 1)]) = (re, re);
            (derivative[(at, at + 1)], derivative[(at + 1, at)]) = (-im, im);
            at += 2;
        }
        for value in real {
            derivative[(at, at)] = *value;
            at += 1;
        }
        assert_eq!(at, 6);
        let space = Space::new(&Group::new(None, None), 1);
        let evaluation = Evaluation {
            image: [0.0; 6],
            derivative,
            half: [0.0; 6],
            peaks: [0.0; 2],
            gradients: [[0.0; 6]; 2],
            pieces: 0,
        };
        let linear = Linear::of(&derivative, &space, 0.0).expect("eigenvalues");
        let mut tangent = [0.0; 7];
        tangent[6] = 1.0;
        Point { arc: 0.0, at: [0.0; 7], tangent, evaluation, linear, residual: 0.0, singular: false }
    }

    #[test]
    fn a_pair_that_goes_out_while_a_multiplier_comes_in_is_seen() {
        // The count rises by one, which a single multiplier that goes out would explain.
        let before = point(&[(0.996, 0.8), (0.97, 2.0)], &[-1.036, -0.956]);
        let after = point(&[(1.003, 0.85), (0.97, 2.0), (0.995, 3.07)], &[]);
        assert_eq!(changes(&before, &after), [(Sign::Minus, 0), (Sign::Pair, 0)]);
        assert_eq!(changes(&after, &before), [(Sign::Minus, 0), (Sign::Pair, 0)]);
        let out = point(&[(0.996, 0.8), (0.97, 2.0)], &[-0.99, -0.9]);
        assert_eq!(changes(&out, &before), [(Sign::Minus, 0)]);
        assert_eq!(changes(&out, &point(&[(1.01, 0.8), (0.97, 2.0)], &[-0.99, -0.9])), [(Sign::Pair, 0)]);
        let both = point(&[(1.01, 0.8), (0.97, 2.0)], &[-1.02, -0.9]);
        assert_eq!(changes(&out, &both), [(Sign::Minus, 0), (Sign::Pair, 0)]);
    }
}
