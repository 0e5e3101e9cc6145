//! From the two parts of a followed branch to its columns and events.

use super::{Branch, BranchEnd, BranchEvent, Breaks, EventKind};
use crate::model::equations::GearPair;
use crate::numerics::continuation::criticality;
use crate::numerics::continuation::detect::{Located, Point};
use crate::numerics::continuation::step::{End, Trace};
use crate::numerics::continuation::switch::{self, Birth, Nature};
use crate::numerics::continuation::{Family, Path, Scale};
use crate::numerics::floquet::{self, Spectrum};
use crate::order;
use crate::study::ErrorEstimate;
use crate::study::family::{GearFamily, SWAP};

/// A branch with what else is born on it.
pub(crate) struct Followed {
    /// The branch.
    pub branch: Branch,
    /// Of each event, what is born there and from where.
    pub births: Vec<Option<(Birth, Nature, Point)>>,
    /// Of each event at which this branch was found to end on another, that one and the point.
    pub parents: Vec<Option<(Path, Point)>>,
    /// The points' maps and symmetries.
    pub path: Path,
}

/// What was located, as an event, with what is born there, or what it was born of.
type Noted = (BranchEvent, Option<(Birth, Nature, Point)>, Option<(Path, Point)>);

/// One branch from its two parts. The first is only the start where the branch is `born` there: then what happens
/// there and the period of the other branch are given.
pub(crate) fn assemble(
    family: &mut GearFamily,
    parameter: &'static str,
    traces: [Trace; 2],
    born: Option<(Nature, usize)>,
) -> Followed {
    let [mut backwards, mut forwards] = traces;
    let path = forwards.path;
    let scale = forwards.bounds.scale;
    let mut events: Vec<(f64, Noted)> = Vec::new();
    let mut ends = [BranchEnd::Range, BranchEnd::Range];
    let parts = [(&mut backwards, -1.0), (&mut forwards, 1.0)];
    for (side, (trace, sign)) in parts.into_iter().enumerate() {
        let (end, birth) = ended(family, trace);
        ends[side] = end;
        for (_, located) in trace.found.clone() {
            let noted = describe(family, trace, &located);
            events.push((sign * located.point.arc, noted));
        }
        if let (Some((parent, nature)), Some(point)) = (birth, trace.points.last()) {
            let event = event(family, scale, nature, point, None);
            events.push((sign * point.arc, (event, None, Some((parent, *point)))));
        }
    }
    if let (Some((nature, period)), Some(point)) = (born, forwards.points.first()) {
        ends[0] = BranchEnd::BornFrom { period };
        events.push((0.0, (event(family, scale, nature, point, None), None, None)));
    }
    order::by_number(&mut events, |event| event.0);
    let mut points: Vec<(f64, Point)> = Vec::with_capacity(backwards.points.len() + forwards.points.len());
    points.extend(backwards.points.iter().skip(1).rev().map(|point| (-point.arc, *point)));
    points.extend(forwards.points.iter().map(|point| (point.arc, *point)));
    let mut births = Vec::with_capacity(events.len());
    let mut parents = Vec::with_capacity(events.len());
    let mut listed = Vec::with_capacity(events.len());
    for (arc, (mut event, birth, parent)) in events {
        event.after = points.partition_point(|(other, _)| *other <= arc).saturating_sub(1);
        listed.push(event);
        births.push(birth);
        parents.push(parent);
    }
    let points: Vec<Point> = points.into_iter().map(|(_, point)| point).collect();
    let branch = columns(family, parameter, path, scale, &points, listed, ends);
    Followed { branch, births, parents, path }
}

/// The end of one part of a branch, and of one that shrinks its birth, which becomes its last point.
fn ended(family: &mut GearFamily, trace: &mut Trace) -> (BranchEnd, Option<(Path, Nature)>) {
    match trace.end.clone() {
        Some(End::Range) | None => (BranchEnd::Range, None),
        Some(End::Points) => (BranchEnd::Points, None),
        Some(End::Closed) => (BranchEnd::Closed, None),
        Some(End::Steep(entry)) => (BranchEnd::Steep { entry }, None),
        Some(End::Lost(reason)) => (BranchEnd::Lost { reason }, None),
        Some(End::Shrunk(shrunk)) => match switch::finish_shrunk(family, trace, shrunk) {
            Ok((parent, nature)) => (BranchEnd::BornFrom { period: parent.period() }, Some((parent, nature))),
            Err(reason) => (BranchEnd::Lost { reason }, None),
        },
    }
}

fn event(
    family: &GearFamily,
    scale: Scale,
    nature: Nature,
    point: &Point,
    supercritical: Option<bool>,
) -> BranchEvent {
    let (state, value) = scale.plain(&point.at);
    let (kind, breaks) = match nature {
        Nature::Fold => (EventKind::Fold, None),
        Nature::PeriodDoubling => (EventKind::PeriodDoubling, None),
        Nature::NeimarkSacker => (EventKind::NeimarkSacker, None),
        Nature::BranchPoint => (EventKind::BranchPoint, None),
        Nature::Grazing => (EventKind::Grazing, None),
        Nature::Pitchfork(lost) => {
            let exchanged = family.group().element(SWAP).is_some() && lost & (1 << SWAP) != 0;
            (EventKind::Pitchfork, Some(if exchanged { Breaks::Exchange } else { Breaks::Sign }))
        }
    };
    let [max_u_p, max_u] = point.evaluation.peaks;
    BranchEvent { kind, value, state, breaks, max_u_p, max_u, supercritical, after: 0 }
}

/// What was located, in words.
fn describe(family: &mut GearFamily, trace: &Trace, located: &Located) -> Noted {
    let scale = trace.bounds.scale;
    let (nature, birth) = switch::nature(family.group(), trace.path, &trace.space, scale, located);
    let supercritical = birth
        .as_ref()
        .filter(|birth| !birth.both_ways)
        .and_then(|birth| criticality::supercritical(family, birth, &located.point, scale));
    let event = event(family, scale, nature, &located.point, supercritical);
    (event, birth.map(|birth| (birth, nature, located.point)), None)
}

fn columns(
    family: &mut GearFamily,
    parameter: &'static str,
    path: Path,
    scale: Scale,
    points: &[Point],
    events: Vec<BranchEvent>,
    ends: [BranchEnd; 2],
) -> Branch {
    let count = points.len();
    let squared = path.period() != path.kind.periods;
    let mut branch = Branch {
        parameter,
        period: path.period(),
        value: Vec::with_capacity(count),
        max_u_p: Vec::with_capacity(count),
        max_u: Vec::with_capacity(count),
        state: Vec::with_capacity(count),
        stable: Vec::with_capacity(count),
        unstable: Vec::with_capacity(count),
        re: Vec::with_capacity(count),
        im: Vec::with_capacity(count),
        events,
        ends,
        method:
            "pseudo-arclength continuation, prediction of degree 7, variational Taylor series of order 16, \
                 symmetric stroboscopic map"
                .into(),
        error: ErrorEstimate::default(),
    };
    let mut liouville = 0.0_f64;
    for (index, point) in points.iter().enumerate() {
        let (state, value) = scale.plain(&point.at);
        let spectrum = whole(&point.linear.spectrum, squared);
        branch.value.push(value);
        branch.state.push(state);
        branch.max_u_p.push(point.evaluation.peaks[0]);
        branch.max_u.push(point.evaluation.peaks[1]);
        branch.re.push(spectrum.re);
        branch.im.push(spectrum.im);
        // At a bifurcation itself rounding decides: its neighbour on the branch is meant.
        let judged = match (point.singular, index) {
            (true, 0) => points.get(1).unwrap_or(point),
            (true, _) => &points[index - 1],
            _ => point,
        };
        branch.unstable.push(judged.linear.outside());
        branch.stable.push(judged.linear.outside() == 0);
        let p = family.at(value);
        let length = path.kind.periods as f64 * p.mesh_period();
        // Symmetries of the model change the sign of an even number of coordinates or exchange two pairs: their
        // determinant is 1.
        let trace = GearPair::new(&p).trace();
        liouville = liouville.max(floquet::liouville_residual(&point.evaluation.derivative, trace * length));
    }
    branch.error = ErrorEstimate {
        liouville: Some(liouville),
        step: points.get(count / 2).and_then(|point| halved(family, path, scale, point)),
        residual: Some(residual(family, path, scale, points)),
    };
    branch
}

/// Points of a branch whose residual is computed at the state that is answered.
const LOOKED_AT: usize = 24;
/// A residual, over the scale of the states, that is told as it was before the last correction.
const SMALL: f64 = 1e-8;

/// The greatest residual of all points. What the points carry is that before their last correction, which makes it smaller:
/// of steep maps, by many orders. Those that seem worst are looked at again.
fn residual(family: &mut GearFamily, path: Path, scale: Scale, points: &[Point]) -> f64 {
    let mut all: Vec<(f64, usize)> = points.iter().map(|point| point.residual).zip(0..).collect();
    order::by_number(&mut all, |(before, _)| -before);
    let mut greatest = 0.0_f64;
    for (looked_at, &(before, index)) in all.iter().enumerate() {
        if before <= greatest || before < SMALL * scale.state || looked_at == LOOKED_AT {
            return greatest.max(before);
        }
        let (state, value) = scale.plain(&points[index].at);
        let Ok(image) = family.image(path.kind, &state, value) else { return greatest.max(before) };
        let now = state.iter().zip(image).fold(0.0_f64, |most, (one, other)| most.max((one - other).abs()));
        greatest = greatest.max(now.min(before));
    }
    greatest
}

/// The multipliers over the whole period.
fn whole(spectrum: &Spectrum, squared: bool) -> Spectrum {
    if !squared {
        return *spectrum;
    }
    floquet::ordered(std::array::from_fn(|i| {
        let (re, im) = (spectrum.re[i], spectrum.im[i]);
        (re * re - im * im, 2.0 * re * im)
    }))
}

/// The change of the multipliers when every step is halved, relative to the largest where that is above one.
fn halved(family: &mut GearFamily, path: Path, scale: Scale, point: &Point) -> Option<f64> {
    let (state, value) = scale.plain(&point.at);
    family.step_factor = 0.5;
    let finer = family.evaluate(path.kind, &state, value);
    family.step_factor = 1.0;
    let finer = floquet::spectrum(&finer.ok()?.derivative).ok()?;
    Some(finer.distance(&point.linear.spectrum) / finer.radius().max(1.0))
}
