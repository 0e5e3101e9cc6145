//! Following a branch step by step, one way, until it ends.

use super::corrector::{Frame, TRUSTED, correct};
use super::detect::{self, Located, Point, Search, finish};
use super::predictor::{self, Knot, MOST};
use super::symmetry::{Group, Space};
use super::{Family, Path, Scale, State, dot, minus, norm, unit};
use crate::error::NumericsError;
use crate::order;

/// How a branch is followed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Least and greatest value of the parameter.
    pub range: [f64; 2],
    /// Units of lengths.
    pub scale: Scale,
    /// Longest step, over the scales.
    pub longest: f64,
    /// Most points.
    pub points: usize,
    /// Length of the last correction of every point, over the scales.
    pub tolerance: f64,
}

/// Why a branch ended.
#[derive(Clone, Debug, PartialEq)]
pub enum End {
    /// At an end of the range of the parameter.
    Range,
    /// All the points asked for are there.
    Points,
    /// It came back to where it began.
    Closed,
    /// It shrank onto orbits of shorter period or higher symmetry, whose map and element are given.
    Shrunk(Shrunk),
    /// The linearisation, whose largest entry is given, has grown so that rounding decides where the orbit goes.
    Steep(f64),
    /// It could not be followed any further.
    Lost(NumericsError),
}

/// Onto what a branch shrinks: the states obey `Phi_shift x = g x`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shrunk {
    /// Half of the periods were needed, or none.
    pub half: bool,
    /// The symmetry g.
    pub symmetry: usize,
}

/// Distance between prediction and branch at which two corrections do, over the scales: the first leaves its square.
const FAIR: f64 = 2e-5;
/// Part of the tolerance of the last correction that the distance is to be for one to do.
const FINE: f64 = 0.5;
/// Part of the longest step below which two corrections of a longer step cost less than one each of shorter ones.
const SHORT: f64 = 0.3;
/// Steps shorter than this part of the longest are given up.
const SHORTEST: f64 = 1e-6;
/// Greatest angle between the tangents at both ends of a step.
const ANGLE: f64 = 0.3;
/// Angle between the tangents that the step is set for.
const GENTLE: f64 = 0.1;
/// Largest entry of a linearisation from which points, and what happens between them, are still found. The error that
/// the last correction leaves of a state, some 1e-8, times this entry is the relative error of the linearisation itself:
/// where it nears one, signs of test functions are noise and folds are seen in clusters.
const STEEPEST: f64 = 3e5;
/// Largest entry of a linearisation from which a branch is followed only as long as its steps do not shrink: the
/// steeper the map, the nearer together are the points at which it can be told from its linearisation.
const STEEP: f64 = 1e4;
/// Steps shorter than this part of the longest are too short for a steep branch.
const CRAWLING: f64 = 3e-5;
/// Most points that are added between three others.
const MOST_DIPS: usize = 8;
/// Greatest change of the linearisation over a step, relative to its size.
const CHANGE: f64 = 0.4;

/// A branch under way in one direction.
#[derive(Clone, Debug)]
pub struct Trace {
    /// The map, and the symmetries of every orbit.
    pub path: Path,
    /// The space that the branch lies in.
    pub space: Space,
    /// The points so far, in order.
    pub points: Vec<Point>,
    /// The bifurcations so far, each with the index of the point before it.
    pub found: Vec<(usize, Located)>,
    /// Why it ended.
    pub end: Option<End>,
    /// How it is followed.
    pub bounds: Bounds,
    step: f64,
    /// Points since the last one beyond which no polynomial leads.
    smooth: usize,
    refused: usize,
}

impl Trace {
    /// Starts at a point, in the direction of its tangent; `first` is the length of the first step.
    pub fn new(path: Path, group: &Group, start: Point, bounds: Bounds, first: f64) -> Self {
        let space = Space::new(group, path.keeping);
        let outwards = |end: f64, sign: f64| {
            let at_end = (start.at[6] - end / bounds.scale.parameter).abs() <= 1e-14 * start.at[6].abs();
            at_end && start.tangent[6] * sign > 0.0
        };
        let leaves = outwards(bounds.range[0], -1.0) || outwards(bounds.range[1], 1.0);
        let end = leaves.then_some(End::Range);
        let mut points = Vec::with_capacity(bounds.points.min(1024));
        points.push(start);
        let step = first.min(bounds.longest);
        Self { path, space, points, found: Vec::new(), end, bounds, step, smooth: 1, refused: 0 }
    }

    /// Adds a further known point of the branch: the second one, of a branch that starts at a bifurcation.
    pub fn push(&mut self, point: Point) {
        self.points.push(point);
        self.smooth += 1;
    }

    /// Takes one step, or refuses one and shortens it; true when the branch has ended.
    pub fn advance(&mut self, family: &mut dyn Family) -> bool {
        if self.end.is_some() {
            return true;
        }
        if self.points.len() >= self.bounds.points {
            self.end = Some(End::Points);
            return true;
        }
        let steepness = self.last().evaluation.derivative.amax();
        if steepness > STEEPEST || (steepness > STEEP && self.step < CRAWLING * self.bounds.longest) {
            self.end = Some(End::Steep(steepness));
            return true;
        }
        match self.try_step(family) {
            Ok(true) => self.refused = 0,
            Ok(false) => self.shorten(None),
            Err(error) => self.shorten(Some(error)),
        }
        self.end.is_some()
    }

    /// Follows the branch to its end.
    pub fn run(&mut self, family: &mut dyn Family) {
        while !self.advance(family) {}
    }

    fn shorten(&mut self, error: Option<NumericsError>) {
        self.refused += 1;
        self.step *= if self.refused > 2 { 0.25 } else { 0.5 };
        // A polynomial through points before a kink does not lead beyond it.
        if self.refused >= 2 {
            self.smooth = self.smooth.min(2);
        }
        let spent = matches!(error, Some(NumericsError::TooManySteps { .. }));
        if spent || self.step < SHORTEST * self.bounds.longest {
            let error = error.unwrap_or(NumericsError::StepTooSmall {
                time: self.last().at[6] * self.bounds.scale.parameter,
                step: self.step,
            });
            self.end = Some(End::Lost(error));
        }
    }

    fn last(&self) -> &Point {
        // There is a point from the start.
        &self.points[self.points.len() - 1]
    }

    fn frame(&self) -> Frame<'_> {
        Frame {
            kind: self.path.kind,
            space: &self.space,
            scale: self.bounds.scale,
            tolerance: self.bounds.tolerance,
        }
    }

    /// For what is located: every point is corrected once more.
    fn fine_frame(&self) -> Frame<'_> {
        Frame { tolerance: 1e-3 * self.bounds.tolerance, ..self.frame() }
    }

    fn knots(&self) -> Vec<Knot> {
        let count = self.smooth.min(MOST).min(self.points.len());
        self.points[self.points.len() - count..].iter().map(Point::knot).collect()
    }

    /// One step: true when it was taken, false when it was refused as too long.
    fn try_step(&mut self, family: &mut dyn Family) -> Result<bool, NumericsError> {
        let last = *self.last();
        let knots = self.knots();
        let arc = last.arc + self.step;
        let mut place = predictor::place(&knots, arc);
        let mut normal = last.tangent;
        let ends = self.bounds.range.map(|value| value / self.bounds.scale.parameter);
        // A step that would leave the range is taken to its end exactly.
        let leaving = ends.into_iter().find(|end| {
            (place[6] - end) * (last.at[6] - end) <= 0.0 && {
                let outwards = (place[6] - last.at[6]) * (end - last.at[6]);
                outwards > 0.0
            }
        });
        if let Some(end) = leaving {
            let (mut low, mut high) = (last.arc, arc);
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                let beyond = (predictor::place(&knots, middle)[6] - end) * (last.at[6] - end) <= 0.0;
                *(if beyond { &mut high } else { &mut low }) = middle;
            }
            place = predictor::place(&knots, high);
            place[6] = end;
            normal = [0.0; 7];
            normal[6] = (end - last.at[6]).signum();
        }
        let frame = self.frame();
        let along = if leaving.is_none() { predictor::direction(&knots, arc) } else { None };
        let mut corrected = correct(family, &frame, &place, &normal, along.as_ref())?;
        let chord = minus(&corrected.at, &last.at);
        let stretch = norm(&chord);
        if leaving.is_some() {
            corrected.at[6] = place[6];
            if dot(&corrected.tangent, &last.tangent) < 0.0 {
                corrected.tangent = corrected.tangent.map(|value| -value);
            }
        }
        if stretch == 0.0 {
            return Ok(false);
        }
        let bend = dot(&corrected.tangent, &last.tangent);
        let ahead = dot(&chord, &last.tangent) / stretch;
        let change = (corrected.evaluation.derivative - last.evaluation.derivative).amax();
        let size = last.evaluation.derivative.amax().max(1.0);
        let far = corrected.distance > (0.2 * stretch).min(0.02);
        if far || bend < ANGLE.cos() || ahead < ANGLE.cos() || change > CHANGE * size {
            return Ok(false);
        }
        let length = predictor::length(stretch, (&last.tangent, &corrected.tangent));
        if corrected.given && corrected.distance > TRUSTED {
            // Of the polynomial through the new point the tangent is better by an order than the one predicted.
            let mut through = knots.clone();
            through[0] = (last.arc + length, corrected.at, corrected.tangent);
            corrected.tangent =
                predictor::direction(&through, last.arc + length).unwrap_or(corrected.tangent);
        }
        let distance = corrected.distance;
        let point = finish(corrected, last.arc + length, &self.space, family.slack())?;
        if let Some(shrunk) = self.shrinks(family, &last, &point) {
            self.points.push(point);
            self.end = Some(End::Shrunk(shrunk));
            return Ok(true);
        }
        let closed = self.closes(&last, &point);
        self.search(family, &last, &point)?;
        self.points.push(point);
        self.smooth += 1;
        self.look_between(family);
        let order = knots.len().clamp(4, MOST) as f64;
        let for_distance = |wished: f64| {
            let growth = (wished / distance.max(1e-300)).powf(1.0 / order);
            (self.step * growth.clamp(0.4, 1.8)).min(self.bounds.longest)
        };
        let fine = for_distance(FINE * self.bounds.tolerance);
        let shortest = SHORT * self.bounds.longest;
        let straight = self.step * (GENTLE / bend.min(1.0).acos().max(1e-3)).max(0.5);
        let fair = for_distance(FAIR).min(shortest.max(fine));
        self.step = if fine >= shortest { fine } else { fair }.min(straight);
        if closed {
            self.end = Some(End::Closed);
        } else if leaving.is_some() {
            self.end = Some(End::Range);
        }
        Ok(true)
    }

    /// Looks for bifurcations between the last two points.
    fn search(&mut self, family: &mut dyn Family, last: &Point, point: &Point) -> Result<(), NumericsError> {
        let mut knots = self.knots();
        if knots.len() >= MOST {
            knots.remove(0);
        }
        knots.push(point.knot());
        let normal = unit(&minus(&point.at, &last.at));
        let mut search = Search { frame: self.fine_frame(), knots: &knots, normal, found: Vec::new() };
        search.between(family, last, point, 0)?;
        let found = search.found;
        // Where the orbit grazes, the branch has a kink in its second derivative.
        if found.iter().any(|located| located.sign == detect::Sign::Touch) {
            self.smooth = 0;
        }
        let index = self.points.len() - 1;
        self.found.extend(found.into_iter().map(|located| (index, located)));
        Ok(())
    }

    /// Looks where test functions dip between the last three points, and adds a point where they do.
    fn look_between(&mut self, family: &mut dyn Family) {
        for _ in 0..MOST_DIPS {
            let count = self.points.len();
            if self.smooth < 3 || count < 3 {
                return;
            }
            let [left, middle, right] = [3, 2, 1].map(|back| self.points[count - back]);
            let Some(arc) = detect::dip([&left, &middle, &right]) else { return };
            let (from, to, place) =
                if arc < middle.arc { (left, middle, count - 2) } else { (middle, right, count - 1) };
            let known = self.found.iter().any(|(index, _)| *index + 1 == place);
            if known {
                return;
            }
            let knots = self.knots();
            let normal = unit(&minus(&to.at, &from.at));
            let mut search = Search { frame: self.fine_frame(), knots: &knots, normal, found: Vec::new() };
            let Ok(point) = search.point(family, &from, &to, arc) else { return };
            let both = search.between(family, &from, &point, 0);
            let left_of_it = search.found.len();
            if both.is_err() || search.between(family, &point, &to, 0).is_err() {
                return;
            }
            let found = std::mem::take(&mut search.found);
            for (index, _) in &mut self.found {
                *index += usize::from(*index >= place);
            }
            for (order, located) in found.into_iter().enumerate() {
                self.found.push((if order < left_of_it { place - 1 } else { place }, located));
            }
            order::by_number(&mut self.found, |(_, located)| located.point.arc);
            self.points.insert(place, point);
            self.smooth += 1;
        }
    }

    /// Whether the orbits shrink onto more symmetric or shorter ones between two points: what parts them from those
    /// goes through zero and comes out opposite.
    fn shrinks(&self, family: &dyn Family, last: &Point, point: &Point) -> Option<Shrunk> {
        if last.singular {
            return None;
        }
        let scale = self.bounds.scale;
        let gap = |point: &Point, half: bool, symmetry: usize| -> State {
            let (state, _) = scale.plain(&point.at);
            let shifted = if half { point.evaluation.half } else { state };
            minus(&shifted, &family.group().apply(symmetry, &state))
        };
        let halves = family.halves(self.path.kind.periods);
        for half in [false, true] {
            if half && !halves {
                continue;
            }
            for (symmetry, _) in family.group().elements() {
                if !half && symmetry == 0 {
                    continue;
                }
                let (before, after) = (gap(last, half, symmetry), gap(point, half, symmetry));
                let product = norm(&before) * norm(&after);
                let floor = 1e-7 * scale.state;
                if norm(&before).min(norm(&after)) > floor && dot(&before, &after) < -0.8 * product {
                    return Some(Shrunk { half, symmetry });
                }
            }
        }
        None
    }

    /// Whether the branch passes its first point again.
    fn closes(&self, last: &Point, point: &Point) -> bool {
        let start = &self.points[0];
        if self.points.len() < 8 {
            return false;
        }
        let chord = minus(&point.at, &last.at);
        let to_start = minus(&start.at, &last.at);
        let share = dot(&chord, &to_start) / dot(&chord, &chord);
        if !(0.0..=1.0).contains(&share) || dot(&chord, &start.tangent) <= 0.0 {
            return false;
        }
        let on_branch =
            predictor::hermite(&last.knot(), &point.knot(), last.arc + share * (point.arc - last.arc));
        norm(&minus(&on_branch, &start.at)) < 1e-3 * norm(&chord)
    }
}
