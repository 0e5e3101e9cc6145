//! Branches of periodic orbits over any parameter, with every bifurcation on them.

mod assembly;

pub(crate) use assembly::{Followed, assemble};

use super::ErrorEstimate;
use super::family::{GearFamily, parameter_named};
use super::motion;
use super::multipliers::{Budget, trivial_state, unloaded};
use super::orbit::{self, LONGEST, OrbitOptions};
use crate::error::{NumericsError, StudyError};
use crate::model::equations::GearPair;
use crate::model::parameters::{Parameters, Regime};
use crate::numerics::continuation::corrector::{self, Frame};
use crate::numerics::continuation::detect::{Point, finish};
use crate::numerics::continuation::step::{Bounds, End, Trace};
use crate::numerics::continuation::switch::{self, Birth};
use crate::numerics::continuation::symmetry::Space;
use crate::numerics::continuation::{Family, Kind, Path, Scale, State};
use crate::numerics::newton;
use crate::numerics::periodic::fixed_point;
use crate::order;

/// What happens at a point of a branch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EventKind {
    /// The parameter turns back.
    Fold,
    /// Orbits of twice the period are born.
    PeriodDoubling,
    /// Orbits that lack a symmetry are born.
    Pitchfork,
    /// A torus is born.
    NeimarkSacker,
    /// Two branches cross.
    BranchPoint,
    /// The teeth touch, or part, with no relative velocity.
    Grazing,
}

impl EventKind {
    /// The word for it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Fold => "fold",
            Self::PeriodDoubling => "period-doubling",
            Self::Pitchfork => "pitchfork",
            Self::NeimarkSacker => "neimark-sacker",
            Self::BranchPoint => "branch-point",
            Self::Grazing => "grazing",
        }
    }
}

/// Which symmetry a pitchfork breaks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Breaks {
    /// u to -u, about the unloaded state.
    Sign,
    /// Pinion and gear exchanged: the born orbits leave the manifold `u_g = -u_p`.
    Exchange,
}

impl Breaks {
    /// The word for it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Sign => "sign",
            Self::Exchange => "exchange",
        }
    }
}

/// A point of a branch at which something happens.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BranchEvent {
    /// What.
    pub kind: EventKind,
    /// Value of the parameter.
    pub value: f64,
    /// State at t = 0.
    pub state: [f64; 6],
    /// Of a pitchfork, the symmetry that it breaks.
    pub breaks: Option<Breaks>,
    /// Greatest |u_p| of the orbit.
    pub max_u_p: f64,
    /// Greatest |u| of the orbit.
    pub max_u: f64,
    /// Of a period doubling or pitchfork: the born orbits are on the side where the old one is less stable; none also where
    /// that is too near the border between both to be told.
    pub supercritical: Option<bool>,
    /// Index of the point of the branch that it comes after, or is.
    pub after: usize,
}

/// What to follow.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BranchOptions {
    /// A number of the model, by its full or short name.
    pub parameter: &'static str,
    /// Least and greatest value of it.
    pub range: [f64; 2],
    /// Period in mesh periods, 1 to [`LONGEST`]; 1 stands for the common period of mesh and load.
    pub period: usize,
    /// A state near an orbit of the branch at t = 0, at the given parameters; none: as
    /// [`periodic_orbit`](super::orbit::periodic_orbit) finds it there, and where it finds none of the period, the
    /// branch that bifurcations within the range lead to from the steady response.
    pub from: Option<[f64; 6]>,
    /// Most points each way from the start, 2 to 100,000. The fewer, the longer the steps, within bounds.
    pub points: usize,
    /// Longest step in the parameter.
    pub max_step: Option<f64>,
    /// Tolerance of the states, 1e-14 to 1e-3.
    pub tolerance: f64,
}

impl BranchOptions {
    /// Over Omega within a range, 1000 points each way at most, to 1e-10.
    pub fn new(range: [f64; 2], period: usize) -> Self {
        Self { parameter: "Omega", range, period, from: None, points: 1000, max_step: None, tolerance: 1e-10 }
    }
}

/// Why a branch ends.
#[derive(Clone, Debug, PartialEq)]
pub enum BranchEnd {
    /// At an end of the range.
    Range,
    /// At a bifurcation of a branch of shorter period or higher symmetry, of that period.
    BornFrom {
        /// Period of the other branch in mesh periods.
        period: usize,
    },
    /// All the points asked for are there.
    Points,
    /// It came back to where it began.
    Closed,
    /// Its multipliers have grown so large that double precision does not resolve the orbits any more.
    Steep {
        /// Largest entry of the linearisation there.
        entry: f64,
    },
    /// It could not be followed any further.
    Lost {
        /// Why.
        reason: NumericsError,
    },
}

/// A branch of periodic orbits, in order along it.
#[derive(Clone, Debug, PartialEq)]
pub struct Branch {
    /// The parameter's name.
    pub parameter: &'static str,
    /// Period in mesh periods.
    pub period: usize,
    /// Values of the parameter.
    pub value: Vec<f64>,
    /// Greatest |u_p| of each orbit.
    pub max_u_p: Vec<f64>,
    /// Greatest |u| of each orbit.
    pub max_u: Vec<f64>,
    /// State of each orbit at t = 0.
    pub state: Vec<[f64; 6]>,
    /// No multiplier outside the unit circle.
    pub stable: Vec<bool>,
    /// Number of multipliers outside the unit circle.
    pub unstable: Vec<usize>,
    /// Real parts of the multipliers over the period, largest modulus first.
    pub re: Vec<[f64; 6]>,
    /// Imaginary parts.
    pub im: Vec<[f64; 6]>,
    /// What happens on it, in order; a birth at one of its ends included.
    pub events: Vec<BranchEvent>,
    /// Why it ends at its first and at its last point.
    pub ends: [BranchEnd; 2],
    /// How it was computed.
    pub method: String,
    /// What is known of the error: the largest `residual` and `liouville` of all points, and `step`, the change of the
    /// multipliers of one of them when every step is halved, relative to the largest where that is above one.
    pub error: ErrorEstimate,
}

/// Steps granted to one branch: some seconds.
const STEPS: usize = 600_000;
/// Longest step of all, over the scales.
const LONGEST_STEP: f64 = 0.06;
/// Length of the last correction of a point, over the scales, at the default tolerance.
const LAST_CORRECTION: f64 = 1e-8;

/// Follows a branch both ways from an orbit.
///
/// # Errors
/// [`StudyError::Option`] for an option out of range, [`StudyError::Model`] for an incommensurate load,
/// [`StudyError::Numerics`] where no orbit is found to start from or none next to it, [`StudyError::NotFound`] where the
/// orbit found is none that can be followed.
pub fn branch(p: &Parameters, options: &BranchOptions) -> Result<Branch, StudyError> {
    let (parameter, allowed) = parameter_named(options.parameter)?;
    check(options, allowed)?;
    let mut family = GearFamily::new(p, parameter, options.range, options.tolerance, STEPS)?;
    let bounds = bounds(p, options);
    let (path, start) = first(p, &mut family, options, &bounds)?;
    let traces = both_ways(&mut family, path, &start, bounds);
    left_its_start(&traces)?;
    let followed = assemble(&mut family, parameter, traces, None);
    Ok(followed.branch)
}

/// Refuses what leads nowhere: a single orbit is no branch.
///
/// # Errors
/// Why it could be followed neither way.
pub(crate) fn left_its_start(traces: &[Trace; 2]) -> Result<(), StudyError> {
    if traces.iter().any(|trace| trace.points.len() > 1) {
        return Ok(());
    }
    for trace in traces {
        match &trace.end {
            Some(End::Steep(entry)) => {
                return Err(StudyError::NotFound {
                    sought: "orbit that can be followed",
                    found: format!(
                        "motions near the one found are {entry:.0e} times as far from it a period later"
                    ),
                });
            }
            Some(End::Lost(reason)) => return Err(reason.clone().into()),
            _ => {}
        }
    }
    Ok(())
}

pub(crate) fn check(options: &BranchOptions, [least, most]: [f64; 2]) -> Result<(), StudyError> {
    motion::check_tolerance(options.tolerance)?;
    let [low, high] = options.range;
    if !(least <= low && low < high && high <= most) {
        return Err(StudyError::Option {
            option: "range",
            given: format!("[{low}, {high}]"),
            allowed: format!("[low, high] with {least} <= low < high <= {most}"),
        });
    }
    let whole = |option: &'static str, given: usize, least: usize, most: usize| {
        if (least..=most).contains(&given) {
            return Ok(());
        }
        let allowed = format!("a whole number from {least} to {most}");
        Err(StudyError::Option { option, given: given.to_string(), allowed })
    };
    whole("period", options.period, 1, LONGEST)?;
    whole("points", options.points, 2, 100_000)?;
    match options.max_step {
        Some(step) if !(step > 0.0 && step.is_finite()) => Err(StudyError::Option {
            option: "maxStep",
            given: step.to_string(),
            allowed: "a number above 0".into(),
        }),
        _ => Ok(()),
    }
}

/// Units and bounds of the steps.
pub(crate) fn bounds(p: &Parameters, options: &BranchOptions) -> Bounds {
    let [low, high] = options.range;
    // The displacement at which the cubic term equals the linear one: what orbits grow to.
    let size = |k: f64, alpha: f64| (k / alpha.abs()).sqrt();
    let state = size(p.k_p, p.alpha_p).min(size(p.k_g, p.alpha_g)).clamp(0.1, 5.0);
    let scale = Scale { state, parameter: high - low };
    let even = (8.0 / options.points as f64).clamp(0.03, LONGEST_STEP);
    let longest = options.max_step.map_or(even, |step| step / scale.parameter);
    let tolerance = LAST_CORRECTION * (options.tolerance / 1e-10).clamp(0.1, 1e3);
    Bounds {
        range: options.range,
        scale,
        longest: longest.min(LONGEST_STEP),
        points: options.points,
        tolerance,
    }
}

/// Two states as near as this, over the scale, are one.
const SAME: f64 = 1e-6;

/// The map and the symmetries of an orbit: the shortest part of the period after which it repeats itself, as it is or
/// under a symmetry.
pub(crate) fn recognise(
    family: &mut GearFamily,
    state: &State,
    value: f64,
    period: usize,
    scale: Scale,
) -> Result<Path, NumericsError> {
    let keeping = family.group().keeping(state, SAME * scale.state);
    let common = family.common();
    let group = *family.group();
    let mut kind = Kind { periods: period, symmetry: 0 };
    'found: for periods in (common..=period).step_by(common) {
        let after = family.image(Kind { periods, symmetry: 0 }, state, value)?;
        for (symmetry, element) in group.elements() {
            let image = element.apply(state);
            let distance = after.iter().zip(image).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
            if distance <= SAME * scale.state {
                kind = Kind { periods, symmetry };
                break 'found;
            }
        }
    }
    Ok(Path { kind, keeping })
}

/// The orbit from which a branch starts.
fn first(
    p: &Parameters,
    family: &mut GearFamily,
    options: &BranchOptions,
    bounds: &Bounds,
) -> Result<(Path, Point), StudyError> {
    let [low, high] = options.range;
    let value = family.value().clamp(low, high);
    let there = family.at(value);
    let common = family.common();
    let period = if options.period == 1 { common } else { options.period };
    let state = match options.from {
        Some(guess) => {
            motion::check_state(&GearPair::new(&there), &guess)?;
            let whole = Kind { periods: period, symmetry: 0 };
            let newton = newton::Options { tolerance: options.tolerance, ..newton::Options::default() };
            fixed_point(guess, newton, |state| {
                let evaluation = family.evaluate(whole, state, value)?;
                let rows = std::array::from_fn(|i| std::array::from_fn(|j| evaluation.derivative[(i, j)]));
                Ok((evaluation.image, rows))
            })?
            .point
        }
        None if period == common && unloaded(p) => {
            isolated_rest(p)?;
            trivial_state(p)
        }
        None => {
            let wanted = OrbitOptions { period, guess: None, tolerance: options.tolerance };
            match orbit::periodic_orbit(&there, &wanted) {
                Ok(orbit) if orbit.period == period => orbit.state,
                found => {
                    if let Some(born) = by_bifurcations(&there, family, period, bounds) {
                        return Ok(born);
                    }
                    let other = found?.period;
                    return Err(StudyError::NotFound {
                        sought: "orbit of this period",
                        found: format!("the search came to one of period {other} and not {period}"),
                    });
                }
            }
        }
    };
    let path = recognise(family, &state, value, period, bounds.scale)?;
    match on_branch(family, path, &state, value, bounds) {
        Err(NumericsError::Singular) => Err(StudyError::NotFound {
            sought: "isolated orbit to start from",
            found: "one with a multiplier of 1, as of teeth that never touch, where u drifts freely".into(),
        }),
        found => Ok((path, found?)),
    }
}

/// Refuses an unloaded pair with backlash: no branch of its states of rest is there to be followed.
///
/// # Errors
/// [`StudyError::NotFound`].
pub(crate) fn isolated_rest(p: &Parameters) -> Result<(), StudyError> {
    if p.regime != Regime::Backlash || !unloaded(p) {
        return Ok(());
    }
    Err(StudyError::NotFound {
        sought: "isolated state of rest",
        found: "without load the pair rests at every u from -1 to 1; give a load or a state to start from"
            .into(),
    })
}

/// Most branches that are followed in search of one of a given period.
const MOST_ANCESTORS: usize = 6;

/// An orbit of a period on a branch that bifurcations lead to from the steady response, of all those born within the
/// range the one born nearest to the present value.
fn by_bifurcations(
    there: &Parameters,
    family: &mut GearFamily,
    period: usize,
    bounds: &Bounds,
) -> Option<(Path, Point)> {
    let (common, value) = (family.common(), family.value());
    isolated_rest(there).ok()?;
    let state = if unloaded(there) {
        trivial_state(there)
    } else {
        let options = OrbitOptions { period: common, ..OrbitOptions::default() };
        orbit::response(there, common, &options, &Budget::default()).ok()?.state
    };
    let within = value.clamp(bounds.range[0], bounds.range[1]);
    let path = recognise(family, &state, within, common, bounds.scale).ok()?;
    let mut waiting = vec![(path, on_branch(family, path, &state, within, bounds).ok()?)];
    for ancestor in 0..MOST_ANCESTORS {
        let (path, start) = *waiting.get(ancestor)?;
        let traces = both_ways(family, path, &start, *bounds);
        let mut births: Vec<(Birth, Point)> = Vec::new();
        for trace in &traces {
            for (_, located) in &trace.found {
                let (_, birth) = switch::nature(family.group(), path, &trace.space, bounds.scale, located);
                births.extend(birth.map(|birth| (birth, located.point)));
            }
        }
        let distance = |point: &Point| (point.at[6] * bounds.scale.parameter - value).abs();
        order::by_number(&mut births, |birth| distance(&birth.1));
        for (birth, at) in births {
            let reached = birth.path.period();
            if reached > period || !period.is_multiple_of(reached) {
                continue;
            }
            let Ok([_, second]) = switch::start(family, &birth, &at, bounds.scale, bounds.tolerance) else {
                continue;
            };
            if reached == period {
                return Some((birth.path, second));
            }
            waiting.push((birth.path, second));
        }
    }
    None
}

/// A point of a branch near a state, at the same value of the parameter.
pub(crate) fn on_branch(
    family: &mut GearFamily,
    path: Path,
    state: &State,
    value: f64,
    bounds: &Bounds,
) -> Result<Point, NumericsError> {
    let space = Space::new(family.group(), path.keeping);
    let frame = Frame { kind: path.kind, space: &space, scale: bounds.scale, tolerance: bounds.tolerance };
    let mut normal = [0.0; 7];
    normal[6] = 1.0;
    let place = bounds.scale.scaled(&space.project(state), value);
    let mut corrected = corrector::correct(family, &frame, &place, &normal, None)?;
    corrected.at[6] = place[6];
    corrected.tangent = corrector::tangent(family, &frame, &corrected.at, &corrected.evaluation)?;
    finish(corrected, 0.0, &space, family.slack())
}

/// Follows a branch from a point both ways: against its tangent, then along it.
pub(crate) fn both_ways(family: &mut GearFamily, path: Path, start: &Point, bounds: Bounds) -> [Trace; 2] {
    let group = *family.group();
    let mut forwards = Trace::new(path, &group, *start, bounds, FIRST_STEP * bounds.longest);
    forwards.run(family);
    let turned = Point { tangent: start.tangent.map(|value| -value), ..*start };
    let mut backwards = Trace::new(path, &group, turned, bounds, FIRST_STEP * bounds.longest);
    if forwards.end == Some(End::Closed) {
        backwards.end = Some(End::Closed);
    }
    backwards.run(family);
    [backwards, forwards]
}

/// The first step's part of the longest: nothing is known of the curvature yet.
pub(crate) const FIRST_STEP: f64 = 0.2;
