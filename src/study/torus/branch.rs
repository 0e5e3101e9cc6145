//! Invariant circles over the mesh frequency.

use std::cell::RefCell;
use std::rc::Rc;

use super::{
    Circle, ErrorEstimate, GearPair, Known, MOST_STEPS, NumericsError, Parameters, Section, StudyError,
    Torus, at_frequency, describe, motion, seed,
};
use crate::study::grid::Grid;
use crate::study::multipliers::Budget;
use crate::study::slices::Slices;

/// The share of a step below which the search for the next circle is given up.
const LEAST_SHARE: f64 = 1.0 / 100.0;
/// Places, as shares of the range, at which a first circle is looked for.
const PLACES: [f64; 7] = [0.5, 0.25, 0.75, 0.125, 0.875, 0.0, 1.0];
/// A circle whose size fell below this part of the greatest of its branch when it was lost has shrunk away.
const SHRUNK: f64 = 0.4;

/// Steps that each circle may take, besides those of the search for the first one.
const STEPS_A_POINT: usize = 20_000;

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
pub(super) async fn follow<'a>(
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
        match advance(p, &at, before.as_ref(), next).await {
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
async fn advance<'a>(
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
    let (circle, defect) = section.converge(guess).await?;
    if circle.size() > 2.0 * size || (circle.rotation - at.circle.rotation).abs() > 0.02 {
        // Another circle.
        return Err(NumericsError::NoConvergence {
            iterations: 0,
            residual: circle.size() - size,
            tolerance: size,
        });
    }
    Ok(Known { section, circle, defect, averages: None, collocated: true })
}

/// A branch in the making, circle by circle: from a first one up to the end of the range, then down.
#[derive(Debug)]
pub struct TorusBranchWork {
    slices: Slices<Result<(), StudyError>>,
    branch: Rc<RefCell<TorusBranch>>,
}

impl TorusBranchWork {
    /// Prepares a branch over `omega` (lowest, highest) with `points` frequencies, both ends included.
    ///
    /// # Errors
    /// [`StudyError::Option`] for a range, a number of points or a tolerance out of range.
    pub fn new(p: &Parameters, omega: [f64; 2], points: usize, tolerance: f64) -> Result<Self, StudyError> {
        motion::check_tolerance(tolerance)?;
        let omega = Grid::new("Omega", omega, points, [0.01, 100.0])?;
        let branch = Rc::new(RefCell::new(TorusBranch {
            omega: Vec::new(),
            mean_radius: Vec::new(),
            max_u_p: Vec::new(),
            max_u: Vec::new(),
            rotation: Vec::new(),
            stable: Vec::new(),
            ends: [TorusEnd::Range; 2],
            method: "collocation of Fourier nodes on the stroboscopic map, followed in Omega".into(),
            error: ErrorEstimate::default(),
        }));
        Ok(Self { slices: Slices::new(trace(*p, omega, tolerance, Rc::clone(&branch))), branch })
    }

    /// Does a slice of the work; true when all is done.
    ///
    /// # Errors
    /// [`StudyError::NotFound`] where no place has one; [`StudyError::Model`] for an incommensurate load;
    /// [`StudyError::Numerics`] where the integration fails.
    pub fn advance(&mut self) -> Result<bool, StudyError> {
        match self.slices.advance() {
            None => Ok(false),
            Some(done) => done.map(|()| true),
        }
    }

    /// The branch so far.
    pub fn branch(&self) -> TorusBranch {
        self.branch.borrow().clone()
    }
}

/// Finds a first circle and follows it both ways.
async fn trace(
    p: Parameters,
    omega: Grid,
    tolerance: f64,
    branch: Rc<RefCell<TorusBranch>>,
) -> Result<(), StudyError> {
    let budget = Budget::of(MOST_STEPS + STEPS_A_POINT * omega.count);
    let (index, first) = begin(&p, &omega, tolerance, &budget).await?;
    let torus = describe(&first).await?;
    branch.borrow_mut().insert(&torus, &first, true);
    for upwards in [true, false] {
        let (mut at, mut earlier) = (first.clone(), None);
        let mut next = index;
        loop {
            next = if upwards { next + 1 } else { next.wrapping_sub(1) };
            if next >= omega.count {
                break;
            }
            let (target, here) = (omega.value(next), at.omega());
            (at, earlier) = follow(&p, at, earlier, target).await;
            if at.omega() != here {
                let torus = describe(&at).await?;
                branch.borrow_mut().insert(&torus, &at, upwards);
            }
            if at.omega() != target {
                branch.borrow_mut().end(upwards);
                break;
            }
        }
    }
    Ok(())
}

/// Looks for a first circle, place after place: the index of its frequency, and the circle.
async fn begin<'a>(
    p: &Parameters,
    omega: &Grid,
    tolerance: f64,
    budget: &'a Budget,
) -> Result<(usize, Known<'a>), StudyError> {
    let mut failure = None;
    for place in PLACES {
        let index = (place * (omega.count - 1) as f64).round() as usize;
        match seed::by_motion(&at_frequency(p, omega.value(index)), tolerance, budget).await {
            Ok(known) => return Ok((index, known)),
            Err(error @ StudyError::NotFound { .. }) => failure = Some(error),
            Err(error) => return Err(error),
        }
    }
    Err(failure.unwrap_or(NumericsError::Singular.into()))
}

impl TorusBranch {
    /// Adds a circle at its upper or at its lower end.
    fn insert(&mut self, torus: &Torus, known: &Known, upwards: bool) {
        let at = if upwards { self.omega.len() } else { 0 };
        self.omega.insert(at, known.omega());
        self.mean_radius.insert(at, torus.mean_radius);
        self.max_u_p.insert(at, torus.max_u_p);
        self.max_u.insert(at, torus.max_u);
        self.rotation.insert(at, torus.rotation);
        self.stable.insert(at, torus.stable);
        self.error.residual = Some(self.error.residual.unwrap_or(0.0).max(known.defect));
    }

    /// Says why it ends.
    fn end(&mut self, upwards: bool) {
        let greatest = self.max_u_p.iter().copied().fold(0.0, f64::max);
        let last = if upwards { self.max_u_p.last() } else { self.max_u_p.first() };
        let shrunk = last.is_some_and(|size| *size < SHRUNK * greatest);
        self.ends[usize::from(upwards)] = if shrunk { TorusEnd::Shrinks } else { TorusEnd::Lost };
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
