//! The automatic diagram: from the steady response, every branch of periodic orbits that bifurcations lead to.

use super::ErrorEstimate;
use super::branch::{self, Branch, BranchOptions, Followed, assemble, bounds};
use super::family::GearFamily;
use super::motion;
use super::multipliers::{Budget, trivial_state, unloaded};
use super::orbit::{self, LONGEST, OrbitOptions};
use crate::error::{NumericsError, StudyError};
use crate::model::parameters::Parameters;
use crate::numerics::continuation::detect::Point;
use crate::numerics::continuation::step::{Bounds, End, Trace};
use crate::numerics::continuation::switch::{self, Birth, Nature};
use crate::numerics::continuation::{Family, Path};

/// What to compute.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DiagramOptions {
    /// Least and greatest mesh frequency Omega.
    pub omega: [f64; 2],
    /// Longest period of the orbits, in mesh periods, 1 to [`LONGEST`].
    pub max_period: usize,
    /// Most branches, 1 to 1000.
    pub max_branches: usize,
    /// Tolerance of the states, 1e-14 to 1e-3.
    pub tolerance: f64,
}

impl DiagramOptions {
    /// Up to period 4 T and 64 branches, to 1e-10.
    pub fn new(omega: [f64; 2]) -> Self {
        Self { omega, max_period: 4, max_branches: 64, tolerance: 1e-10 }
    }
}

/// Every branch that was reached.
#[derive(Clone, Debug, PartialEq)]
pub struct Diagram {
    /// The branches; the steady response first.
    pub branches: Vec<Branch>,
    /// Of each branch, the branch and the event of it at which it was reached, none for the steady response: where it
    /// was born, or where that branch ends on it.
    pub from: Vec<Option<(usize, usize)>>,
    /// Whether there was more to follow when the number of branches or the work allowed was used up.
    pub complete: bool,
    /// How it was computed.
    pub method: String,
    /// The largest errors of all branches.
    pub error: ErrorEstimate,
}

/// Where a branch is to be started.
#[derive(Clone, Debug)]
struct Pending {
    birth: Birth,
    at: Point,
    /// Branch and event.
    from: (usize, usize),
    nature_at_birth: Nature,
    parent_period: usize,
}

/// A branch that is being followed.
#[derive(Clone, Debug)]
struct Current {
    backwards: Trace,
    forwards: Trace,
    pending: Option<Pending>,
    from: Option<(usize, usize)>,
}

/// A branch on which another one ends.
#[derive(Clone, Copy, Debug)]
struct Parent {
    path: Path,
    at: Point,
    /// Branch that ends there, and the event.
    from: (usize, usize),
}

/// A diagram under way.
#[derive(Clone, Debug)]
pub struct DiagramWork {
    options: DiagramOptions,
    family: GearFamily,
    bounds: Bounds,
    start: Option<(Path, Point)>,
    current: Option<Current>,
    pending: Vec<Pending>,
    parents: Vec<Parent>,
    /// Bifurcations from which a branch was already followed, or at which one ended: value, greatest |u|, and periods.
    visited: Vec<(f64, f64)>,
    diagram: Diagram,
    /// Why the very first branch could not be followed.
    refusal: Option<StudyError>,
    done: bool,
}

/// Steps granted to a diagram: some seconds.
const STEPS: usize = 1_500_000;
/// Steps of one slice of work: about ten milliseconds.
const SLICE: usize = 5_000;
/// Points of a branch each way.
const POINTS: usize = 1000;

impl DiagramWork {
    /// Finds the steady response from which the diagram starts.
    ///
    /// # Errors
    /// [`StudyError::Option`] for an option out of range, [`StudyError::Model`] for an incommensurate load,
    /// [`StudyError::Numerics`] where no steady response is found.
    pub fn new(p: &Parameters, options: &DiagramOptions) -> Result<Self, StudyError> {
        let followed = BranchOptions {
            points: POINTS,
            tolerance: options.tolerance,
            ..BranchOptions::new(options.omega, options.max_period)
        };
        motion::check_tolerance(options.tolerance)?;
        branch::check(&followed, [0.01, 100.0]).map_err(named)?;
        if !(1..=1000).contains(&options.max_branches) {
            return Err(StudyError::Option {
                option: "maxBranches",
                given: options.max_branches.to_string(),
                allowed: "a whole number from 1 to 1000".into(),
            });
        }
        let mut family = GearFamily::new(p, "Omega", options.omega, options.tolerance, STEPS)?;
        let bounds = bounds(p, &followed);
        let start = steady(p, &mut family, &bounds, options)?;
        Ok(Self {
            options: *options,
            family,
            bounds,
            start: Some(start),
            current: None,
            pending: Vec::new(),
            parents: Vec::new(),
            visited: Vec::new(),
            diagram: Diagram {
                branches: Vec::new(),
                from: Vec::new(),
                complete: false,
                method: String::new(),
                error: ErrorEstimate::default(),
            },
            refusal: None,
            done: false,
        })
    }

    /// Does a slice of the work; true when all is done.
    ///
    /// # Errors
    /// None at present: what cannot be followed is an end of its branch.
    pub fn advance(&mut self) -> Result<bool, StudyError> {
        let until = self.family.budget().saturating_sub(SLICE);
        // At least once, so that it comes to an end when nothing of the work allowed is left.
        loop {
            self.next();
            if self.done || self.family.budget() <= until {
                return Ok(self.done);
            }
        }
    }

    fn next(&mut self) {
        if let Some(current) = &mut self.current {
            let ended =
                current.forwards.advance(&mut self.family) && current.backwards.advance(&mut self.family);
            if ended && let Some(current) = self.current.take() {
                self.take_in(current);
            }
            return;
        }
        if let Some((path, point)) = self.start.take() {
            self.follow(path, &point, None);
            return;
        }
        if self.diagram.branches.len() >= self.options.max_branches || self.family.budget() == 0 {
            self.done = true;
            return;
        }
        // First born, first followed: bifurcations of the steady response before those far from it.
        if !self.pending.is_empty() {
            let pending = self.pending.remove(0);
            if !self.is_visited(&pending.at) {
                self.begin(pending);
            }
            return;
        }
        // Last of all what other branches were found to end on: by now most of that is there.
        let Some(parent) = self.parents.pop() else {
            self.diagram.complete = true;
            self.done = true;
            return;
        };
        let Bounds { scale, .. } = self.bounds;
        let (state, value) = scale.plain(&parent.at.at);
        if !self.is_known(&parent)
            && let Ok(point) = branch::on_branch(&mut self.family, parent.path, &state, value, &self.bounds)
        {
            self.follow(parent.path, &point, Some(parent.from));
        }
    }

    /// Follows a branch both ways from a point.
    fn follow(&mut self, path: Path, point: &Point, from: Option<(usize, usize)>) {
        let group = *self.family.group();
        let first = branch::FIRST_STEP * self.bounds.longest;
        let turned = Point { tangent: point.tangent.map(|value| -value), ..*point };
        self.current = Some(Current {
            backwards: Trace::new(path, &group, turned, self.bounds, first),
            forwards: Trace::new(path, &group, *point, self.bounds, first),
            pending: None,
            from,
        });
    }

    /// Whether the branch on which another one ends is there already: it has an event at that place.
    fn is_known(&self, parent: &Parent) -> bool {
        let place = self.place(&parent.at);
        self.diagram.branches.iter().enumerate().any(|(index, branch)| {
            index != parent.from.0
                && branch.period == parent.path.period()
                && branch.events.iter().any(|event| self.same(place, (event.value, event.max_u)))
        })
    }

    /// Switches onto a born branch.
    fn begin(&mut self, pending: Pending) {
        let Bounds { scale, tolerance, .. } = self.bounds;
        let place = self.place(&pending.at);
        self.visited.push(place);
        let start = switch::start(&mut self.family, &pending.birth, &pending.at, scale, tolerance);
        let Ok(points) = start else { return };
        let group = *self.family.group();
        let path = pending.birth.path;
        let trace = |[first, second]: [Point; 2], bounds: Bounds| {
            let mut trace = Trace::new(path, &group, first, bounds, branch::FIRST_STEP * bounds.longest);
            trace.end = None;
            trace.push(second);
            trace
        };
        let forwards = trace(points, self.bounds);
        let back = Point { tangent: points[0].tangent.map(|value| -value), ..points[0] };
        let mut backwards = Trace::new(path, &group, back, self.bounds, self.bounds.longest);
        backwards.end = Some(End::Range);
        if pending.birth.both_ways {
            let towards = pending.birth.towards.map(|value| -value);
            let other = Birth { towards, ..pending.birth };
            if let Ok(points) = switch::start(&mut self.family, &other, &pending.at, scale, tolerance) {
                backwards = trace(points, self.bounds);
            }
        }
        let from = Some(pending.from);
        self.current = Some(Current { backwards, forwards, pending: Some(pending), from });
    }

    /// A branch that has ended becomes part of the diagram, and what is born on it is noted.
    fn take_in(&mut self, current: Current) {
        if current.forwards.points.len().max(current.backwards.points.len()) < 2 {
            // Too steep to be followed at all.
            if self.diagram.branches.is_empty() && current.from.is_none() {
                self.refusal = branch::left_its_start(&[current.backwards, current.forwards]).err();
            }
            return;
        }
        let birth = current
            .pending
            .as_ref()
            .filter(|pending| !pending.birth.both_ways)
            .map(|pending| (pending.nature_at_birth, pending.parent_period));
        let followed = assemble(&mut self.family, "Omega", [current.backwards, current.forwards], birth);
        let Followed { branch, births, parents, path } = followed;
        let index = self.diagram.branches.len();
        for (event, parent) in parents.into_iter().enumerate() {
            self.parents.extend(parent.map(|(path, at)| Parent { path, at, from: (index, event) }));
        }
        for (event, birth) in births.into_iter().enumerate() {
            let here = &branch.events[event];
            let Some((birth, nature, at)) = birth else {
                // The birth of this very branch, at either of its ends.
                if !matches!(
                    here.kind,
                    branch::EventKind::Fold | branch::EventKind::NeimarkSacker | branch::EventKind::Grazing
                ) {
                    self.visited.push((here.value, here.max_u));
                }
                continue;
            };
            if birth.path.period() <= self.options.max_period {
                self.pending.push(Pending {
                    birth,
                    at,
                    from: (index, event),
                    nature_at_birth: nature,
                    parent_period: path.period(),
                });
            }
        }
        let worst = |all: Option<f64>, one: Option<f64>| Some(all.unwrap_or(0.0).max(one.unwrap_or(0.0)));
        let error = &mut self.diagram.error;
        error.liouville = worst(error.liouville, branch.error.liouville);
        error.step = worst(error.step, branch.error.step);
        error.residual = worst(error.residual, branch.error.residual);
        self.diagram.method.clone_from(&branch.method);
        self.diagram.branches.push(branch);
        self.diagram.from.push(current.from);
    }

    fn place(&self, at: &Point) -> (f64, f64) {
        (at.at[6] * self.bounds.scale.parameter, at.evaluation.peaks[1])
    }

    fn is_visited(&self, at: &Point) -> bool {
        let place = self.place(at);
        self.visited.iter().any(|other| self.same(place, *other))
    }

    /// Whether two bifurcations, by value and greatest |u|, are one.
    fn same(&self, (value, size): (f64, f64), (other, other_size): (f64, f64)) -> bool {
        (other - value).abs() < 1e-6 * self.bounds.scale.parameter
            && (other_size - size).abs() < 1e-4 * size.max(1.0)
    }

    /// The diagram so far.
    pub fn diagram(&self) -> &Diagram {
        &self.diagram
    }

    /// The diagram, for good.
    pub fn into_diagram(self) -> Diagram {
        self.diagram
    }
}

/// The options of a branch under the names of those of a diagram.
fn named(error: StudyError) -> StudyError {
    match error {
        StudyError::Option { option: "range", given, allowed } => {
            StudyError::Option { option: "Omega", given, allowed }
        }
        StudyError::Option { option: "period", given, allowed } => {
            StudyError::Option { option: "maxPeriod", given, allowed }
        }
        other => other,
    }
}

/// The steady response at the given Omega, or, where none is found there, at others of the range.
fn steady(
    p: &Parameters,
    family: &mut GearFamily,
    bounds: &Bounds,
    options: &DiagramOptions,
) -> Result<(Path, Point), StudyError> {
    let [low, high] = options.omega;
    branch::isolated_rest(p)?;
    let common = family.common();
    if common > LONGEST {
        return Err(StudyError::Option {
            option: "maxPeriod",
            given: options.max_period.to_string(),
            allowed: format!("not possible: the common period of mesh and load is {common} mesh periods"),
        });
    }
    let budget = Budget::default();
    let mut failure = None;
    let shares = [0.5, 1.0, 0.0, 0.75, 0.25];
    let values = shares.map(|share| low + share * (high - low));
    for value in [p.omega.clamp(low, high)].into_iter().chain(values) {
        let there = family.at(value);
        let found = if unloaded(p) {
            Ok(trivial_state(p))
        } else {
            let wanted = OrbitOptions { period: common, guess: None, tolerance: options.tolerance };
            orbit::response(&there, common, &wanted, &budget).map(|orbit| orbit.state)
        };
        let started = found.and_then(|state| {
            let path = branch::recognise(family, &state, value, common, bounds.scale)?;
            let point = branch::on_branch(family, path, &state, value, bounds)?;
            Ok((path, point))
        });
        match started {
            Ok(started) => return Ok(started),
            Err(error) => failure = Some(error),
        }
    }
    Err(failure.unwrap_or(StudyError::Numerics(NumericsError::Singular)))
}

/// Computes a diagram.
///
/// # Errors
/// As [`DiagramWork::new`], and those of [`branch::branch`] where the steady response is none that can be followed: a diagram
/// without a branch is no answer.
pub fn diagram(p: &Parameters, options: &DiagramOptions) -> Result<Diagram, StudyError> {
    let mut work = DiagramWork::new(p, options)?;
    while !work.advance()? {}
    match work.refusal.take() {
        Some(refusal) => Err(refusal),
        None => Ok(work.into_diagram()),
    }
}
