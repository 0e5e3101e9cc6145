//! A figure, computed at once or step by step.

use super::basins::Basins;
use super::beside::{Beside, Part};
use super::branches::Branches;
use super::compose::Composer;
use super::errata::Errata;
use super::exact_cycles::Cycles;
use super::exact_exponents::Exponents;
use super::exact_pitchforks::Pitchforks;
use super::exponents::ExponentPaths;
use super::load::Loads;
use super::loaded_stability::{self, LoadedTongues};
use super::multiplier_paths::MultiplierPaths;
use super::overall::Overall;
use super::poincare_map::{self, Map};
use super::specification::{Specification, specification};
use super::start::{self, Start};
use super::sweep::Sweeps;
use super::tongues::Supports;
use super::trajectory_map::TrajectoryMap;
use super::{
    determinant, eigenvalues, hopf, pitchfork, response, schematic, stability, trajectory,
    trajectory_spectrum,
};
use crate::chart::drawing::Drawing;
use crate::error::{FigureError, ModelError, StudyError};
use crate::model::parameters::{Parameters, Value};
use crate::study::ErrorEstimate;
use crate::study::motion::default_state;
use crate::theory::modes::Mode;
use std::fmt;

/// A computed figure: what is drawn, in what words, by what method.
#[derive(Clone, Debug)]
pub struct Figure {
    /// Its number, e.g. `11a`.
    pub id: &'static str,
    /// The parameters it was computed with.
    pub parameters: Parameters,
    /// What is drawn.
    pub drawing: Drawing,
    /// One sentence made from the data: what it shows.
    pub summary: String,
    /// By what formulas or methods.
    pub method: String,
    /// Error estimates of what was integrated; empty for closed formulas.
    pub error: ErrorEstimate,
    /// The motion of an animated figure, repeated without end.
    pub motion: Option<Motion>,
    /// The rows of a figure that is a table.
    pub table: Vec<Row>,
    /// Remarks for the reader: contact lost, an escape, a tongue that is closed.
    pub notes: Vec<String>,
    /// What the summary is made of, by name: for sentences in other languages.
    pub facts: Vec<(&'static str, Fact)>,
    /// The state from which the motion shown starts, where the figure takes one.
    pub start: Option<[f64; 6]>,
    /// The state in which what was computed of it ends, after whole mesh periods: from there another motion may go on.
    pub end: Option<[f64; 6]>,
    /// The orbits behind the branches that are drawn, for a reader who picks one.
    pub orbits: Option<Orbits>,
    /// How far the theory is from the exact answer, place by place.
    pub distances: Vec<Distance>,
}

/// One thing that a figure has found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fact {
    /// A number, dimensionless.
    Number(f64),
    /// One of a few words.
    Word(&'static str),
    /// Whether something is so.
    Truth(bool),
}

/// Orbits on branches, a row each: columns of one length.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Orbits {
    /// Mesh frequency.
    pub omega: Vec<f64>,
    /// Greatest `|u_p|`.
    pub max_u_p: Vec<f64>,
    /// Period in mesh periods; 0 for a torus, which has none.
    pub period: Vec<f64>,
    /// 1 where it is stable, else 0.
    pub stable: Vec<f64>,
    /// State at t = 0, six numbers a row.
    pub state: Vec<f64>,
}

/// A formula's number beside the exact one.
#[derive(Clone, Debug, PartialEq)]
pub struct Distance {
    /// What it is, in plain words, with the formula in brackets.
    pub what: String,
    /// Where: the axis by its ASCII name, and the place on it; none for a number that has no place.
    pub at: Option<(&'static str, f64)>,
    /// As the formula has it.
    pub theory: f64,
    /// As the exact system has it.
    pub exact: f64,
}

impl Distance {
    /// Theory minus exact.
    pub fn difference(&self) -> f64 {
        self.theory - self.exact
    }
}

/// One line of a table that sets what is printed beside what is computed.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Where it is printed, e.g. `(105)`.
    pub place: &'static str,
    /// What it is, in plain words.
    pub quantity: String,
    /// As printed.
    pub printed: Entry,
    /// As corrected here.
    pub ours: Entry,
    /// As the exact system has it.
    pub exact: Entry,
    /// How it is known, in plain words.
    pub remark: &'static str,
}

/// What stands in a table.
#[derive(Clone, Debug, PartialEq)]
pub enum Entry {
    /// A number, dimensionless.
    Number(f64),
    /// Words.
    Words(&'static str),
    /// Nothing: there is no such number, or it is not computed yet.
    Nothing,
}

impl Entry {
    /// The number, where it is one.
    pub fn number(&self) -> Option<f64> {
        match self {
            Self::Number(number) => Some(*number),
            Self::Words(_) | Self::Nothing => None,
        }
    }
}

impl From<Option<f64>> for Entry {
    fn from(number: Option<f64>) -> Self {
        number.filter(|number| number.is_finite()).map_or(Self::Nothing, Self::Number)
    }
}

impl Figure {
    /// A figure with nothing but its drawing.
    pub(super) fn drawn(id: &'static str, parameters: &Parameters, drawing: Drawing) -> Self {
        Self {
            id,
            parameters: *parameters,
            drawing,
            summary: String::new(),
            method: String::new(),
            error: ErrorEstimate::default(),
            motion: None,
            table: Vec::new(),
            notes: Vec::new(),
            facts: Vec::new(),
            start: None,
            end: None,
            orbits: None,
            distances: Vec::new(),
        }
    }

    /// A figure of which nothing is known yet.
    pub(super) fn waiting(id: &'static str, parameters: &Parameters) -> Self {
        let empty = Self::drawn(id, parameters, Composer::new((1, 1)).drawing());
        Self { summary: "Not computed yet.".to_owned(), ..empty }
    }
}

/// A stretch of motion: columns of one length, dimensionless.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Motion {
    /// Time from the stretch's begin, rising from 0.
    pub t: Vec<f64>,
    /// Displacement of the pinion's body along the line of action, over half the backlash.
    pub u_p: Vec<f64>,
    /// The same of the gear's body.
    pub u_g: Vec<f64>,
    /// Transmission error over half the backlash; the teeth touch where its magnitude is 1 or more.
    pub u: Vec<f64>,
}

/// A figure in the making. Each [`Job::advance`] does a slice of the work; [`Job::figure`] is the picture so far.
pub struct Job {
    specification: &'static Specification,
    parameters: Parameters,
    start: Option<[f64; 6]>,
    work: Work,
}

/// By its name alone: what it holds would bring words for everything that is computed anywhere into the module.
impl fmt::Debug for Job {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_struct("Job").field("id", &self.specification.id).finish_non_exhaustive()
    }
}

enum Work {
    /// Nothing done yet of what is done at once.
    Waiting,
    /// Done.
    Finished(Box<Figure>),
    /// Done step by step.
    Slices(Box<dyn Slices>),
}

/// A figure that is computed step by step.
pub(super) trait Slices {
    /// Does the next slice of the work, some milliseconds; `true` once there is nothing more to do.
    ///
    /// # Errors
    /// What a study or a formula fails with.
    fn advance(&mut self) -> Result<bool, FigureError>;

    /// Leaves all but one part to others; false, and nothing is changed, where the work cannot be divided.
    ///
    /// # Errors
    /// As for the work's begin.
    fn divide(&mut self, _part: usize, _parts: usize) -> Result<bool, FigureError> {
        Ok(false)
    }

    /// The picture so far.
    fn figure(&self, id: &'static str, parameters: &Parameters) -> Figure;
}

impl Job {
    /// A job for the figure of this id; parameters given override its preset by name.
    ///
    /// # Errors
    /// [`FigureError::UnknownFigure`], or what [`Specification::with`] refuses.
    pub fn new(id: &str, given: &[(String, Value)]) -> Result<Self, FigureError> {
        let specification = specification(id)?;
        let (start, given) = start::split(given)?;
        let parameters = specification.with(&given)?;
        let start = started(specification, &start, &parameters)?;
        let beside = |formulas: Figure, part: Box<dyn Part>| {
            Work::Slices(Box::new(Beside::new(formulas, part)) as Box<dyn Slices>)
        };
        let p = &parameters;
        let work = match specification.id {
            "3" => {
                beside(pitchfork::figure("3", p, Mode::Second)?, Box::new(Pitchforks::new(p, Mode::Second)?))
            }
            "5" => {
                beside(pitchfork::figure("5", p, Mode::Third)?, Box::new(Pitchforks::new(p, Mode::Third)?))
            }
            "6" => beside(eigenvalues::figure("6", p)?, Box::new(Exponents::new(p)?)),
            "7" => beside(hopf::figure("7", p)?, Box::new(Cycles::new(p)?)),
            "9" => Work::Slices(Box::new(Overall::new("9", &parameters, Supports::Hardening)?)),
            "10" => Work::Slices(Box::new(Overall::new("10", &parameters, Supports::Softening)?)),
            "A" => Work::Slices(Box::new(Basins::new(&parameters)?)),
            "L" => Work::Slices(Box::new(Loads::new(&parameters))),
            "B" => Work::Slices(Box::new(Branches::new(&parameters))),
            "E" => Work::Slices(Box::new(Errata::new(&parameters)?)),
            "S" => Work::Slices(Box::new(Sweeps::new(&parameters)?)),
            "8" => Work::Slices(Box::new(ExponentPaths::new(&parameters)?)),
            "T" if loaded_stability::applies(p) => Work::Slices(Box::new(LoadedTongues::new(p)?)),
            "M" => Work::Slices(Box::new(MultiplierPaths::new(&parameters))),
            "P" => Work::Slices(Box::new(TrajectoryMap::new(&parameters, start))),
            id if poincare_map::draws(id) => Work::Slices(Box::new(Map::new(&parameters))),
            _ => Work::Waiting,
        };
        Ok(Self { specification, parameters, start, work })
    }

    /// Does only one part of the work, counted from 0, of so many that are done side by side: of a field every `parts`-th
    /// column, from column `part` on. To be asked for before the first [`Job::advance`]. False where the work is not
    /// divided: then all of it is done.
    ///
    /// # Errors
    /// [`StudyError::Option`] for a part that there is not.
    pub fn divide(&mut self, part: usize, parts: usize) -> Result<bool, FigureError> {
        if part >= parts {
            let allowed = format!("from 0 to {}", parts.max(1) - 1);
            return Err(StudyError::Option { option: "part", given: part.to_string(), allowed }.into());
        }
        match &mut self.work {
            Work::Slices(work) if parts > 1 => work.divide(part, parts),
            _ => Ok(false),
        }
    }

    /// Does the next slice of the work, some milliseconds; `true` once there is nothing more to do.
    ///
    /// # Errors
    /// Unequal supports where a formula needs equal ones, or what a study fails with.
    pub fn advance(&mut self) -> Result<bool, FigureError> {
        match &mut self.work {
            Work::Finished(_) => Ok(true),
            Work::Slices(work) => work.advance(),
            Work::Waiting => {
                let figure = at_once(self.specification.id, &self.parameters, self.start)?;
                self.work = Work::Finished(Box::new(figure));
                Ok(true)
            }
        }
    }

    /// The picture so far. Before the first [`Job::advance`] it may be empty.
    pub fn figure(&self) -> Figure {
        match &self.work {
            Work::Finished(figure) => (**figure).clone(),
            Work::Slices(work) => work.figure(self.specification.id, &self.parameters),
            Work::Waiting => Figure::waiting(self.specification.id, &self.parameters),
        }
    }
}

/// The start of a figure that takes one: what was given of it, where anything was.
fn started(
    specification: &Specification,
    start: &Start,
    parameters: &Parameters,
) -> Result<Option<[f64; 6]>, FigureError> {
    match start.first() {
        Some(name) if !specification.starts => {
            Err(StudyError::from(ModelError::UnknownParameter { name: name.to_owned() }).into())
        }
        _ => Ok(start.state(parameters)),
    }
}

fn at_once(
    id: &'static str,
    parameters: &Parameters,
    start: Option<[f64; 6]>,
) -> Result<Figure, FigureError> {
    let from = || start.unwrap_or_else(|| default_state(parameters));
    match id {
        "1" => schematic::figure(id, parameters, start),
        "U" => trajectory::figure(id, parameters, from()),
        "W" => trajectory_spectrum::figure(id, parameters, from()),
        "2" => determinant::figure(id, parameters, Mode::Second),
        "4" => determinant::figure(id, parameters, Mode::Third),
        "14a" | "14b" => response::figure(id, parameters),
        "T" => stability::figure(id, parameters),
        other => Err(FigureError::UnknownFigure { given: other.to_owned() }),
    }
}

/// The whole figure of this id; parameters given override its preset by name.
///
/// # Errors
/// Those of [`Job::new`] and [`Job::advance`].
pub fn figure(id: &str, given: &[(String, Value)]) -> Result<Figure, FigureError> {
    let mut job = Job::new(id, given)?;
    while !job.advance()? {}
    Ok(job.figure())
}

/// The drawing of a figure at a time of its motion: figure 1 moves, the others are as they are.
pub fn at_time(figure: &Figure, time: f64) -> Drawing {
    match &figure.motion {
        Some(motion) => schematic::at_time(figure, motion, time),
        None => figure.drawing.clone(),
    }
}

/// Time after which a motion is not waited for any longer to settle: slow meshes have long periods, stiff supports
/// need short steps.
pub(super) fn patience(parameters: &Parameters) -> f64 {
    let fastest = (parameters.k_p / parameters.m_p).max(parameters.k_g / parameters.m_g).sqrt();
    f64::min(1500.0, 1e5 / fastest)
}

/// A figure made by formulas alone.
pub(super) fn formula(
    id: &'static str,
    parameters: &Parameters,
    composer: Composer,
    summary: String,
    method: &str,
) -> Figure {
    Figure { summary, method: method.to_owned(), ..Figure::drawn(id, parameters, composer.drawing()) }
}
