//! From a bifurcation onto the branch that is born there, and back from a branch that shrinks to its birth.

use super::corrector::{Frame, correct};
use super::detect::{Linear, Located, Point, Sign, direction, finish};
use super::predictor::{self, Knot};
use super::step::{Shrunk, Trace};
use super::symmetry::{Group, Space};
use super::{Family, Kind, Path, Scale, Scaled, State, dot, minus, norm, unit};
use crate::error::NumericsError;

/// What a bifurcation is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Nature {
    /// The parameter turns back.
    Fold,
    /// Orbits of twice the period are born.
    PeriodDoubling,
    /// Orbits of the same period that lack symmetries are born; the set of those lost (bit `1 << index`).
    Pitchfork(u8),
    /// A torus is born.
    NeimarkSacker,
    /// Two branches cross.
    BranchPoint,
    /// The orbit touches the end of an analytic piece.
    Grazing,
}

/// The branch that is born at a bifurcation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Birth {
    /// Its map and symmetries.
    pub path: Path,
    /// The direction in which it leaves, over the scales.
    pub towards: Scaled,
    /// Whether both directions lead to different orbits: only where no symmetry and no shift in time maps one onto
    /// the other.
    pub both_ways: bool,
}

/// How near to a symmetry a null vector must be to have it.
const ALIKE: f64 = 1e-4;

/// What was located, and what is born there.
pub fn nature(
    group: &Group,
    path: Path,
    space: &Space,
    scale: Scale,
    located: &Located,
) -> (Nature, Option<Birth>) {
    match located.sign {
        Sign::Touch => return (Nature::Grazing, None),
        Sign::Pair => return (Nature::NeimarkSacker, None),
        Sign::Plus | Sign::Minus => {}
    }
    let point = &located.point;
    let vector = direction(&point.evaluation.derivative, space, located.block, located.sign);
    let Some(vector) = vector else {
        return (if located.turns { Nature::Fold } else { Nature::BranchPoint }, None);
    };
    let opposing = group.opposing(path.keeping, &vector, ALIKE);
    let keeping = group.sparing(path.keeping, &vector, ALIKE);
    let lost = path.keeping & !keeping;
    let mut towards = [0.0; 7];
    towards[..6].copy_from_slice(&vector.map(|value| value / scale.state));
    let towards = unit(&towards);
    let Kind { periods, symmetry } = path.kind;
    if located.sign == Sign::Plus {
        if opposing != 0 {
            let path = Path { kind: path.kind, keeping };
            return (Nature::Pitchfork(lost), Some(Birth { path, towards, both_ways: false }));
        }
        if located.turns {
            return (Nature::Fold, None);
        }
        // The null space holds this vector and the branch's own tangent.
        let along = dot(&towards, &point.tangent);
        let aside = unit(&std::array::from_fn(|i| towards[i] - along * point.tangent[i]));
        return (Nature::BranchPoint, Some(Birth { path, towards: aside, both_ways: true }));
    }
    // With a symmetry that reverses the vector, the map followed by it keeps the born orbits; without, its square.
    let kind = match (0..4).find(|index| opposing & (1 << index) != 0) {
        Some(index) => Kind { periods, symmetry: symmetry ^ index },
        None => Kind { periods: 2 * periods, symmetry: 0 },
    };
    let born = Path { kind, keeping };
    let nature = if path.period() == periods {
        Nature::PeriodDoubling
    } else {
        // The whole orbit keeps its period and loses what joined its halves.
        Nature::Pitchfork(if lost == 0 { 1 << symmetry } else { lost })
    };
    (nature, Some(Birth { path: born, towards, both_ways: false }))
}

/// First distances at which the born branch is looked for, over the scales.
const DISTANCES: [f64; 5] = [1e-2, 2e-3, 3e-4, 5e-5, 1e-5];

/// The first two points of a born branch: the bifurcation itself, and one at a small distance from it.
///
/// # Errors
/// Where no point is found at any of the distances tried.
pub fn start(
    family: &mut dyn Family,
    birth: &Birth,
    at: &Point,
    scale: Scale,
    tolerance: f64,
) -> Result<[Point; 2], NumericsError> {
    let space = Space::new(family.group(), birth.path.keeping);
    let frame = Frame { kind: birth.path.kind, space: &space, scale, tolerance };
    let slack = family.slack();
    let first = at_bifurcation(family, &frame, &at.at, birth.towards, 0.0)?;
    let mut failure = NumericsError::Singular;
    for distance in DISTANCES {
        let place: Scaled = std::array::from_fn(|i| at.at[i] + distance * birth.towards[i]);
        match correct(family, &frame, &place, &birth.towards, None) {
            // Beyond a few times the distance it is not what is born here.
            Ok(corrected) if corrected.distance < 0.5 * distance => {
                let mut corrected = corrected;
                if dot(&corrected.tangent, &birth.towards) < 0.0 {
                    corrected.tangent = corrected.tangent.map(|value| -value);
                }
                let chord = norm(&minus(&corrected.at, &first.at));
                let arc = predictor::length(chord, (&first.tangent, &corrected.tangent));
                return Ok([first, finish(corrected, arc, &space, slack)?]);
            }
            Ok(_) => {}
            Err(error) => failure = error,
        }
    }
    Err(failure)
}

/// A bifurcation as an end of the branch that is born there.
fn at_bifurcation(
    family: &mut dyn Family,
    frame: &Frame<'_>,
    at: &Scaled,
    tangent: Scaled,
    arc: f64,
) -> Result<Point, NumericsError> {
    let (state, parameter) = frame.scale.plain(at);
    let evaluation = family.evaluate(frame.kind, &state, parameter)?;
    let linear = Linear::of(&evaluation.derivative, frame.space, family.slack())?;
    let residual = minus(&evaluation.image, &state).iter().fold(0.0_f64, |most, value| most.max(value.abs()));
    Ok(Point { arc, at: *at, tangent, evaluation, linear, residual, singular: true })
}

/// Where a branch that shrank was born: its last point is replaced by the bifurcation.
///
/// The orbits there belong to the branch of higher symmetry or shorter period; the bifurcation is located on that.
///
/// # Errors
/// As the family fails at the bifurcation.
pub fn finish_shrunk(
    family: &mut dyn Family,
    trace: &mut Trace,
    shrunk: Shrunk,
) -> Result<(Path, Nature), NumericsError> {
    let scale = trace.bounds.scale;
    let guess = meeting_place(family, trace, shrunk);
    let (state, _) = scale.plain(&guess.1);
    let group = *family.group();
    let kind = if shrunk.half {
        Kind { periods: trace.path.kind.periods / 2, symmetry: shrunk.symmetry }
    } else {
        trace.path.kind
    };
    let gained = if shrunk.half { 1 } else { 1 << shrunk.symmetry };
    let keeping = group.keeping(&state, 1e-3 * scale.state) | trace.path.keeping | gained;
    let parent = Path { kind, keeping: closed(keeping) };
    let lost = parent.keeping & !trace.path.keeping;
    let nature = if parent.period() < trace.path.period() {
        Nature::PeriodDoubling
    } else {
        Nature::Pitchfork(if lost == 0 { 1 << shrunk.symmetry } else { lost })
    };
    let target = if shrunk.half { -1.0 } else { 1.0 };
    let at = on_parent(family, parent, scale, &guess.1, target, trace.bounds.tolerance).unwrap_or(guess.1);
    let last = trace.points.pop();
    let before = trace.points.last().map_or(guess.0, |point| point.arc);
    let tangent = last.map_or([0.0; 7], |point| point.tangent);
    let chord = trace.points.last().map_or(0.0, |point| norm(&minus(&at, &point.at)));
    let frame =
        Frame { kind: trace.path.kind, space: &trace.space, scale, tolerance: trace.bounds.tolerance };
    let end = at_bifurcation(family, &frame, &at, tangent, before + chord)?;
    trace.points.push(end);
    Ok((parent, nature))
}

/// The subgroup that a set of elements generates.
fn closed(keeping: u8) -> u8 {
    let mut all = keeping | 1;
    for left in 0..4 {
        for right in 0..4 {
            if all & (1 << left) != 0 && all & (1 << right) != 0 {
                all |= 1 << (left ^ right);
            }
        }
    }
    all
}

/// Where, by interpolation, what parts the branch from the more symmetric orbits vanishes between its last two points.
fn meeting_place(family: &dyn Family, trace: &Trace, shrunk: Shrunk) -> (f64, Scaled) {
    let scale = trace.bounds.scale;
    let count = trace.points.len();
    let usable: Vec<&Point> = trace.points[count.saturating_sub(6)..].iter().collect();
    let gap = |point: &Point| -> State {
        let (state, _) = scale.plain(&point.at);
        let shifted = if shrunk.half { point.evaluation.half } else { state };
        minus(&shifted, &family.group().apply(shrunk.symmetry, &state))
    };
    let [.., before, last] = usable[..] else { return (0.0, [0.0; 7]) };
    let along = unit(&gap(before));
    // The gap's component, as one more polynomial through the same points.
    let knots: Vec<Knot> = usable
        .iter()
        .map(|point| {
            let mut value = [0.0; 7];
            value[0] = dot(&gap(point), &along);
            (point.arc, value, [0.0; 7])
        })
        .collect();
    let places: Vec<Knot> = usable.iter().map(|point| point.knot()).collect();
    let (mut low, mut high) = (before.arc, last.arc);
    let linear = |arc: f64| {
        let share = (arc - before.arc) / (last.arc - before.arc);
        let value = |index: usize| knots[knots.len() - index].1[0];
        (1.0 - share) * value(2) + share * value(1)
    };
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        let value = if knots.len() < 4 { linear(middle) } else { predictor::place(&knots, middle)[0] };
        *(if value > 0.0 { &mut low } else { &mut high }) = middle;
    }
    (low, predictor::place(&places, low))
}

/// The bifurcation on the more symmetric branch near a place: where one of its multipliers is `target`.
fn on_parent(
    family: &mut dyn Family,
    parent: Path,
    scale: Scale,
    near: &Scaled,
    target: f64,
    tolerance: f64,
) -> Option<Scaled> {
    let space = Space::new(family.group(), parent.keeping);
    let frame = Frame { kind: parent.kind, space: &space, scale, tolerance };
    let slack = family.slack();
    let mut normal = [0.0; 7];
    normal[6] = 1.0;
    let mut tests = |parameter: f64| -> Option<([f64; 2], Scaled)> {
        let mut place = *near;
        place[6] = parameter;
        let corrected = correct(family, &frame, &place, &normal, None).ok()?;
        let point = finish(corrected, 0.0, &space, slack).ok()?;
        let [first, second] = point.linear.blocks;
        let mut values = [f64::INFINITY; 2];
        for (value, block) in values.iter_mut().zip([first, second]).take(point.linear.count) {
            *value = if target > 0.0 { block.plus } else { block.minus };
        }
        Some((values, point.at))
    };
    // The block whose test function is nearest to a root by its own slope.
    let (mut before, mut here) = (near[6] + 1e-4, near[6]);
    let (at_before, at_here) = (tests(before)?.0, tests(here)?.0);
    let step = |block: usize| (at_here[block] / (at_here[block] - at_before[block])).abs();
    let block = usize::from(step(1) < step(0));
    let mut last = at_before[block];
    for _ in 0..20 {
        let (values, place) = tests(here)?;
        let value = values[block];
        let step = if value == last { 0.0 } else { -value * (here - before) / (value - last) };
        if !step.is_finite() || (here + step - near[6]).abs() > 0.05 {
            return None;
        }
        if step.abs() < 1e-12 {
            return Some(place);
        }
        (before, last) = (here, value);
        here += step;
    }
    None
}
