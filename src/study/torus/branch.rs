//! Invariant circles over the mesh frequency.

use super::{
    Circle, ErrorEstimate, GearPair, Known, NumericsError, Parameters, Section, StudyError, at_frequency,
    budget, describe, motion, seed,
};
use crate::study::grid::Grid;
use crate::study::multipliers::Budget;

/// The share of a step below which the search for the next circle is given up.
const LEAST_SHARE: f64 = 1.0 / 100.0;
/// Places, as shares of the range, at which a first circle is looked for.
const PLACES: [f64; 7] = [0.5, 0.25, 0.75, 0.125, 0.875, 0.0, 1.0];
/// A circle whose size fell below this part of the greatest of its branch when it was lost has shrunk away.
const SHRUNK: f64 = 0.4;

/// How a branch ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TorusEnd {
    /// At the end of the range.
    Range,
    /// It shrinks onto the orbit that it is born from.
    Shrinks,
    /// It cannot be followed: it folds back, or breaks up.
    Lost,
}

impl TorusEnd {
    /// Its word.
    pub fn name(self) -> &'static str {
        match self {
            Self::Range => "range",
            Self::Shrinks => "shrinks",
            Self::Lost => "lost",
        }
    }
}

/// Invariant circles over the mesh frequency, in rising order of it.
#[derive(Clone, Debug, PartialEq)]
pub struct TorusBranch {
    /// Mesh frequencies.
    pub omega: Vec<f64>,
    /// Mean of `sqrt(u_p^2 + u_p'^2)`.
    pub mean_radius: Vec<f64>,
    /// Greatest `|u_p|` along the motion.
    pub max_u_p: Vec<f64>,
    /// Greatest `|u|` along the motion.
    pub max_u: Vec<f64>,
    /// Rotation, as in [`Torus`](super::Torus).
    pub rotation: Vec<f64>,
    /// Whether it is stable, in all six dimensions.
    pub stable: Vec<bool>,
    /// How it ends at its lowest and at its highest frequency.
    pub ends: [TorusEnd; 2],
    /// How it was computed.
    pub method: String,
    /// What is known of the error: `residual`, the greatest of all circles.
    pub error: ErrorEstimate,
}

impl Known<'_> {
    /// Its mesh frequency.
    pub(super) fn omega(&self) -> f64 {
        self.section.pair.parameters.omega
    }
}

/// An earlier circle of the same branch, and its mesh frequency.
type Earlier = (f64, Circle);

/// Follows a circle to another mesh frequency, in steps that are halved where the search fails; ends where it can be
/// followed no further. Gives the last circle and the one before it.
pub(super) fn follow<'a>(
    p: &Parameters,
    from: Known<'a>,
    earlier: Option<Earlier>,
    omega: f64,
) -> (Known<'a>, Option<Earlier>) {
    let (mut at, mut before) = (from, earlier);
    let whole = omega - at.omega();
    let mut step = if before.is_some() { whole } else { 0.25 * whole };
    while at.omega() != omega {
        let here = at.omega();
        let next = if (omega - here).abs() <= step.abs() * (1.0 + 1e-9) { omega } else { here + step };
        match advance(p, &at, before.as_ref(), next) {
            Ok(known) => {
                before = Some((here, at.circle));
                at = known;
                step *= 1.5;
            }
            Err(NumericsError::TooManySteps { .. }) => break,
            Err(_) => {
                step *= 0.5;
                if step.abs() < whole.abs() * LEAST_SHARE {
                    break;
                }
            }
        }
    }
    (at, before)
}

/// The circle at the next mesh frequency, straight on from the last two.
fn advance<'a>(
    p: &Parameters,
    at: &Known<'a>,
    before: Option<&Earlier>,
    omega: f64,
) -> Result<Known<'a>, NumericsError> {
    let mut guess = at.circle.clone();
    if let Some((earlier, circle)) = before
        && circle.mirrored == guess.mirrored
    {
        let ratio = (omega - at.omega()) / (at.omega() - earlier);
        let resampled;
        let circle = if circle.count() == guess.count() {
            circle
        } else {
            resampled = circle.resampled(guess.count());
            &resampled
        };
        for (node, old) in guess.nodes.iter_mut().zip(&circle.nodes) {
            *node += ratio * (*node - old);
        }
        guess.rotation += ratio * (guess.rotation - circle.rotation);
    }
    let section = Section { pair: GearPair::new(&at_frequency(p, omega)), ..at.section };
    let size = at.circle.size();
    let (circle, defect) = section.converge(guess)?;
    if circle.size() > 2.0 * size || (circle.rotation - at.circle.rotation).abs() > 0.02 {
        // Another circle.
        return Err(NumericsError::NoConvergence {
            iterations: 0,
            residual: circle.size() - size,
            tolerance: size,
        });
    }
    Ok(Known { section, circle, defect, averages: None })
}

/// A branch in the making, circle by circle: from a first one up to the end of the range, then down.
#[derive(Clone, Debug)]
pub struct TorusBranchWork {
    parameters: Parameters,
    omega: Grid,
    tolerance: f64,
    /// The first circle: its frequency, and the circle with what belongs to it.
    first: Option<Place>,
    at: Option<Place>,
    earlier: Option<Earlier>,
    /// Index of the next frequency of the grid; none where this direction is done.
    next: Option<usize>,
    upwards: bool,
    tried: usize,
    rows: Vec<Row>,
    ends: [TorusEnd; 2],
    defect: f64,
    done: bool,
}

/// A circle without the borrowed budget of its search.
#[derive(Clone, Debug)]
struct Place {
    omega: f64,
    circle: Circle,
    periods: usize,
    on_manifold: bool,
    defect: f64,
}

impl Place {
    fn of(known: &Known) -> Self {
        Self {
            omega: known.omega(),
            circle: known.circle.clone(),
            periods: known.section.periods,
            on_manifold: known.section.on_manifold,
            defect: known.defect,
        }
    }

    fn known<'a>(&self, p: &Parameters, tolerance: f64, budget: &'a Budget) -> Known<'a> {
        let section = Section {
            pair: GearPair::new(&at_frequency(p, self.omega)),
            periods: self.periods,
            on_manifold: self.on_manifold,
            tolerance,
            budget,
        };
        Known { section, circle: self.circle.clone(), defect: self.defect, averages: None }
    }
}

#[derive(Clone, Copy, Debug)]
struct Row {
    omega: f64,
    mean_radius: f64,
    max_u_p: f64,
    max_u: f64,
    rotation: f64,
    stable: bool,
}

impl TorusBranchWork {
    /// Prepares a branch over `omega` (lowest, highest) with `points` frequencies, both ends included.
    ///
    /// # Errors
    /// [`StudyError::Option`] for a range, a number of points or a tolerance out of range.
    pub fn new(p: &Parameters, omega: [f64; 2], points: usize, tolerance: f64) -> Result<Self, StudyError> {
        motion::check_tolerance(tolerance)?;
        let omega = Grid::new("Omega", omega, points, [0.01, 100.0])?;
        Ok(Self {
            parameters: *p,
            omega,
            tolerance,
            first: None,
            at: None,
            earlier: None,
            next: None,
            upwards: true,
            tried: 0,
            rows: Vec::new(),
            ends: [TorusEnd::Range; 2],
            defect: 0.0,
            done: false,
        })
    }

    /// Does the next circle, or looks at the next place for a first one; true when all is done.
    ///
    /// # Errors
    /// [`StudyError::NotFound`] where no place has one; [`StudyError::Model`] for an incommensurate load;
    /// [`StudyError::Numerics`] where the integration fails.
    pub fn advance(&mut self) -> Result<bool, StudyError> {
        if self.done {
            return Ok(true);
        }
        let budget = budget();
        if self.first.is_none() {
            self.begin(&budget)?;
            return Ok(false);
        }
        let (Some(index), Some(at)) = (self.next, self.at.take()) else {
            self.turn();
            return Ok(self.done);
        };
        let target = self.omega.value(index);
        let from = at.known(&self.parameters, self.tolerance, &budget);
        let (known, earlier) = follow(&self.parameters, from, self.earlier.take(), target);
        let arrived = known.omega() == target;
        if known.omega() != at.omega {
            self.push(&known)?;
        }
        if arrived {
            self.at = Some(Place::of(&known));
            self.earlier = earlier;
            self.next = if self.upwards {
                Some(index + 1).filter(|&i| i < self.omega.count)
            } else {
                index.checked_sub(1)
            };
        } else {
            let greatest = self.rows.iter().map(|row| row.max_u_p).fold(0.0, f64::max);
            let last = if self.upwards { self.rows.last() } else { self.rows.first() };
            let shrunk = last.is_some_and(|row| row.max_u_p < SHRUNK * greatest);
            self.ends[usize::from(self.upwards)] = if shrunk { TorusEnd::Shrinks } else { TorusEnd::Lost };
            self.next = None;
        }
        Ok(false)
    }

    /// The branch so far.
    pub fn branch(&self) -> TorusBranch {
        let column = |pick: fn(&Row) -> f64| self.rows.iter().map(pick).collect();
        TorusBranch {
            omega: column(|row| row.omega),
            mean_radius: column(|row| row.mean_radius),
            max_u_p: column(|row| row.max_u_p),
            max_u: column(|row| row.max_u),
            rotation: column(|row| row.rotation),
            stable: self.rows.iter().map(|row| row.stable).collect(),
            ends: self.ends,
            method: "collocation of Fourier nodes on the stroboscopic map, followed in Omega".into(),
            error: ErrorEstimate { residual: Some(self.defect), ..ErrorEstimate::default() },
        }
    }

    /// Looks for a first circle at the next place.
    fn begin(&mut self, budget: &Budget) -> Result<(), StudyError> {
        let last = self.omega.count - 1;
        let place = PLACES.get(self.tried).copied().unwrap_or(1.0);
        let index = (place * last as f64).round() as usize;
        self.tried += 1;
        let p = at_frequency(&self.parameters, self.omega.value(index));
        match seed::by_motion(&p, self.tolerance, budget) {
            Ok(known) => {
                self.push(&known)?;
                self.first = Some(Place::of(&known));
                self.at.clone_from(&self.first);
                self.next = Some(index + 1).filter(|&next| next <= last);
                Ok(())
            }
            Err(StudyError::NotFound { .. }) if self.tried < PLACES.len() => Ok(()),
            Err(error) => Err(error),
        }
    }

    /// Turns from the way up to the way down, and from that to the end.
    fn turn(&mut self) {
        if !self.upwards {
            self.done = true;
            return;
        }
        self.upwards = false;
        self.earlier = None;
        self.at.clone_from(&self.first);
        let first = self.first.as_ref().map_or(f64::NEG_INFINITY, |first| first.omega);
        self.next = (0..self.omega.count).rev().find(|&index| self.omega.value(index) < first);
    }

    fn push(&mut self, known: &Known) -> Result<(), StudyError> {
        let torus = describe(known)?;
        self.defect = self.defect.max(known.defect);
        let row = Row {
            omega: known.omega(),
            mean_radius: torus.mean_radius,
            max_u_p: torus.max_u_p,
            max_u: torus.max_u,
            rotation: torus.rotation,
            stable: torus.stable,
        };
        if self.upwards {
            self.rows.push(row);
        } else {
            self.rows.insert(0, row);
        }
        Ok(())
    }
}

/// The invariant circles over a range of the mesh frequency.
///
/// # Errors
/// As [`TorusBranchWork`].
pub fn torus_branch(
    p: &Parameters,
    omega: [f64; 2],
    points: usize,
    tolerance: f64,
) -> Result<TorusBranch, StudyError> {
    let mut work = TorusBranchWork::new(p, omega, points, tolerance)?;
    while !work.advance()? {}
    Ok(work.branch())
}
