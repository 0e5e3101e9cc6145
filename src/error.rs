//! Errors as types with data: one enum a layer. Each says what was given, what is allowed, and where.

use std::fmt;

/// What numerics can fail with.
#[derive(Clone, Debug, PartialEq)]
pub enum NumericsError {
    /// The step fell below what double precision can resolve.
    StepTooSmall {
        /// Time of the failing step.
        time: f64,
        /// Step that would have been needed.
        step: f64,
    },
    /// More steps than allowed.
    TooManySteps {
        /// Time that was reached.
        time: f64,
        /// Steps taken.
        steps: usize,
    },
    /// A state or derivative stopped being a finite number.
    NotFinite {
        /// Time at which it was seen.
        time: f64,
    },
    /// The motion left the region in which the question makes sense.
    Escaped {
        /// Time of escape.
        time: f64,
    },
    /// An iteration did not converge.
    NoConvergence {
        /// Iterations done.
        iterations: usize,
        /// Residual at the end.
        residual: f64,
        /// Residual that was asked for.
        tolerance: f64,
    },
    /// A matrix that must be inverted is singular to working precision.
    Singular,
    /// Two ends of an interval do not bracket a root.
    NoBracket {
        /// Lower end.
        low: f64,
        /// Upper end.
        high: f64,
    },
}

/// What the model's input can be refused for.
#[derive(Clone, Debug, PartialEq)]
pub enum ModelError {
    /// No parameter has this name.
    UnknownParameter {
        /// The name as given.
        name: String,
    },
    /// A value that is no finite number.
    NotANumber {
        /// Name of the parameter.
        parameter: String,
        /// What was given, as text.
        given: String,
        /// Least allowed value.
        low: f64,
        /// Greatest allowed value.
        high: f64,
    },
    /// A number outside its range.
    OutOfRange {
        /// Name of the parameter.
        parameter: String,
        /// The number given.
        given: f64,
        /// Least allowed value.
        low: f64,
        /// Greatest allowed value.
        high: f64,
    },
    /// A word that is none of those allowed.
    NotAChoice {
        /// Name of the parameter.
        parameter: String,
        /// What was given.
        given: String,
        /// The words allowed.
        allowed: &'static [&'static str],
    },
    /// The homogeneous regime takes no load.
    LoadInHomogeneous {
        /// Name of the load.
        parameter: &'static str,
        /// Its value.
        given: f64,
    },
    /// A formula of the paper needs equal supports.
    Asymmetric {
        /// Short name of the parameter that differs, e.g. `m`.
        parameter: &'static str,
        /// Pinion's value.
        pinion: f64,
        /// Gear's value.
        gear: f64,
    },
    /// The load's frequency has no common period with the mesh.
    Incommensurate {
        /// `Omega_p` or `Omega_g`.
        parameter: &'static str,
        /// Its value.
        given: f64,
        /// The mesh frequency.
        omega: f64,
    },
    /// A physical quantity that is needed is missing.
    Missing {
        /// Its name.
        parameter: &'static str,
    },
    /// Torques that do not balance.
    UnbalancedTorque {
        /// Gear torque as given, N m.
        given: f64,
        /// Gear torque that balances the pinion's, N m.
        balanced: f64,
    },
}

/// What a formula of the theory can be refused for.
#[derive(Clone, Debug, PartialEq)]
pub enum TheoryError {
    /// A formula divides by this number, which is zero.
    Vanishing {
        /// Name of the number.
        parameter: &'static str,
        /// The equation that needs it, e.g. `(63)`.
        equation: &'static str,
    },
    /// A root search did not converge.
    NoConvergence {
        /// Residual at the end.
        residual: f64,
    },
    /// The model refused.
    Model(ModelError),
}

/// What a study can fail with.
#[derive(Clone, Debug, PartialEq)]
pub enum StudyError {
    /// An option that is out of range or no number.
    Option {
        /// Its name.
        option: &'static str,
        /// What was given, as text.
        given: String,
        /// What is allowed, in words.
        allowed: String,
    },
    /// What was asked for is not there; something else is.
    NotFound {
        /// What was looked for.
        sought: &'static str,
        /// What was found instead, in words.
        found: String,
    },
    /// The numerics failed.
    Numerics(NumericsError),
    /// The model refused.
    Model(ModelError),
    /// The theory refused.
    Theory(TheoryError),
}

/// What drawing can fail with.
#[derive(Clone, Debug, PartialEq)]
pub enum ChartError {
    /// The backend refused.
    Backend {
        /// Its own words.
        message: String,
    },
    /// A picture too small or too large to draw.
    Size {
        /// Width in pixels.
        width: f64,
        /// Height in pixels.
        height: f64,
    },
    /// A number that is not finite was about to be drawn.
    NotFinite {
        /// Name of the series or axis.
        name: String,
    },
    /// A drawing that contradicts itself.
    Malformed {
        /// Name of the series, axis or frame.
        name: String,
        /// What is wrong with it, in words.
        fault: &'static str,
    },
    /// A part of a drawing was asked for that it has not.
    Unknown {
        /// What kind of part: `frame` or `series`.
        what: &'static str,
        /// Its name as given.
        given: String,
        /// The names there are.
        known: Vec<String>,
    },
    /// A window that shows nothing.
    Window {
        /// Name of the frame.
        frame: String,
        /// Its lower end as given.
        low: f64,
        /// Its upper end as given.
        high: f64,
        /// Whether it is the frame that has no axes.
        bare: bool,
    },
}

/// What a figure can fail with.
#[derive(Clone, Debug, PartialEq)]
pub enum FigureError {
    /// No figure has this id.
    UnknownFigure {
        /// The id as given.
        given: String,
    },
    /// A study failed.
    Study(StudyError),
    /// A drawing failed.
    Chart(ChartError),
}

impl fmt::Display for NumericsError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::StepTooSmall { time, step } => {
                write!(
                    f,
                    "at time {time} a step of {step:e} would be needed, which double precision cannot resolve"
                )
            }
            Self::TooManySteps { time, steps } => write!(f, "{steps} steps reached only time {time}"),
            Self::NotFinite { time } => write!(f, "the motion is no finite number any more at time {time}"),
            Self::Escaped { time } => write!(f, "the motion escapes at time {time}"),
            Self::NoConvergence { iterations, residual, tolerance } => write!(
                f,
                "no convergence after {iterations} iterations: the residual is {residual:e}, asked for was {tolerance:e}"
            ),
            Self::Singular => write!(f, "a matrix that must be inverted is singular"),
            Self::NoBracket { low, high } => write!(f, "no change of sign between {low} and {high}"),
        }
    }
}

impl fmt::Display for ModelError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::UnknownParameter { name } => write!(f, "there is no parameter named \"{name}\""),
            Self::NotANumber { parameter, given, low, high } => {
                write!(f, "{parameter} must be a number from {low} to {high}, but {given} was given")
            }
            Self::OutOfRange { parameter, given, low, high } => {
                write!(f, "{parameter} must be from {low} to {high}, but {given} was given")
            }
            Self::NotAChoice { parameter, given, allowed } => {
                write!(f, "{parameter} must be one of {}, but \"{given}\" was given", allowed.join(", "))
            }
            Self::LoadInHomogeneous { parameter, given } => write!(
                f,
                "the homogeneous regime takes no load, but {parameter} is {given}; choose contact or backlash"
            ),
            Self::Asymmetric { parameter, pinion, gear } => write!(
                f,
                "the paper's formulas need equal supports, but {parameter}_p is {pinion} and {parameter}_g is {gear}"
            ),
            Self::Incommensurate { parameter, given, omega } => write!(
                f,
                "{parameter} = {given} has no common period with Omega = {omega}: \
                 it must be n/d times Omega with d at most 64"
            ),
            Self::Missing { parameter } => write!(f, "{parameter} is needed and was not given"),
            Self::UnbalancedTorque { given, balanced } => write!(
                f,
                "T_g = {given} N m does not balance the pinion's torque: T_p r_g / r_p is {balanced} N m"
            ),
        }
    }
}

impl fmt::Display for TheoryError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Vanishing { parameter, equation } => {
                write!(f, "equation {equation} has no meaning where {parameter} is zero")
            }
            Self::NoConvergence { residual } => write!(f, "no convergence: the residual is {residual:e}"),
            Self::Model(error) => error.fmt(f),
        }
    }
}

impl fmt::Display for StudyError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Option { option, given, allowed } => {
                write!(f, "the option {option} must be {allowed}, but {given} was given")
            }
            Self::NotFound { sought, found } => write!(f, "there is no {sought} to be found here: {found}"),
            Self::Numerics(error) => error.fmt(f),
            Self::Model(error) => error.fmt(f),
            Self::Theory(error) => error.fmt(f),
        }
    }
}

impl fmt::Display for ChartError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Backend { message } => write!(f, "the drawing failed: {message}"),
            Self::Size { width, height } => write!(
                f,
                "a picture of {width} by {height} pixels cannot be drawn: each side must be from 120 to 8192 pixels"
            ),
            Self::NotFinite { name } => write!(f, "\"{name}\" holds a value that is no finite number"),
            Self::Malformed { name, fault } => write!(f, "\"{name}\" cannot be drawn: {fault}"),
            Self::Unknown { what, given, known } => {
                write!(f, "there is no {what} \"{given}\" in the drawing: it has {}", known.join(", "))
            }
            Self::Window { frame, bare: true, .. } => {
                write!(f, "\"{frame}\" has no axes of which a part could be shown")
            }
            Self::Window { frame, low, high, .. } => write!(
                f,
                "\"{frame}\" cannot show its axis from {low} to {high}: it must rise, within \u{b1}1e12, by more than a \
                 billionth of its greater end"
            ),
        }
    }
}

impl fmt::Display for FigureError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::UnknownFigure { given } => write!(f, "there is no figure \"{given}\""),
            Self::Study(error) => error.fmt(f),
            Self::Chart(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for NumericsError {}
impl std::error::Error for ModelError {}
impl std::error::Error for TheoryError {}
impl std::error::Error for StudyError {}
impl std::error::Error for ChartError {}
impl std::error::Error for FigureError {}

impl From<ModelError> for TheoryError {
    fn from(error: ModelError) -> Self {
        Self::Model(error)
    }
}
impl From<NumericsError> for StudyError {
    fn from(error: NumericsError) -> Self {
        Self::Numerics(error)
    }
}
impl From<ModelError> for StudyError {
    fn from(error: ModelError) -> Self {
        Self::Model(error)
    }
}
impl From<TheoryError> for StudyError {
    fn from(error: TheoryError) -> Self {
        Self::Theory(error)
    }
}
impl<E: Into<StudyError>> From<E> for FigureError {
    fn from(error: E) -> Self {
        Self::Study(error.into())
    }
}
impl From<ChartError> for FigureError {
    fn from(error: ChartError) -> Self {
        Self::Chart(error)
    }
}
