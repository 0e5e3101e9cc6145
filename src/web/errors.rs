//! The one place where a typed error becomes what JavaScript is told: `{code, parameter, given, allowed, message}`.
//!
//! The wrapper turns that plain object into a `GearError`. The codes are a promise to users (`docs/api.md`).

use wasm_bindgen::JsValue;
use web_sys::js_sys::{Array, Object};

use crate::error::{ChartError, FigureError, ModelError, NumericsError, StudyError, TheoryError};
use crate::figures;
use crate::model::parameters::{Regime, SHORT_FORMS, TABLE};
use crate::web::values;

/// What was given, as it was given where that can cross: a number or a text.
#[derive(Clone, Debug, PartialEq)]
pub enum Given {
    /// Nothing in particular.
    Nothing,
    /// A number, finite or not.
    Number(f64),
    /// A text.
    Text(String),
    /// In words, what kind of value it was: an array, `null`, something that cannot be read.
    Words(String),
}

/// What is allowed.
#[derive(Clone, Debug, PartialEq)]
pub enum Allowed {
    /// Nothing to say.
    Nothing,
    /// A closed range of numbers.
    Range(f64, f64),
    /// Said in words.
    Text(String),
}

/// An error on its way to JavaScript.
#[derive(Clone, Debug, PartialEq)]
pub struct WebError {
    /// One of the codes of `docs/api.md`.
    pub code: &'static str,
    /// Name of the parameter, option or quantity it is about.
    pub parameter: Option<String>,
    /// What was given.
    pub given: Given,
    /// What is allowed.
    pub allowed: Allowed,
    /// One sentence for a person.
    pub message: String,
}

impl WebError {
    /// An option that is unknown, of the wrong type or out of range.
    pub fn option(name: &str, given: Given, allowed: Allowed) -> Self {
        let message =
            format!("the option {name} must be {}, but {} was given", allowed.words(), given.words());
        Self { code: "option", parameter: Some(name.into()), given, allowed, message }
    }

    /// An option that this call does not have.
    pub fn unknown_option(name: &str, known: &[&str]) -> Self {
        let (list, message) = if known.is_empty() {
            ("none".to_string(), format!("there is no option \"{name}\": this call has none"))
        } else {
            let list = known.join(", ");
            (list.clone(), format!("there is no option \"{name}\": this call has {list}"))
        };
        Self {
            code: "option",
            parameter: Some(name.into()),
            given: Given::Text(name.into()),
            allowed: Allowed::Text(list),
            message,
        }
    }

    /// Something that should be a plain object and is none.
    pub fn not_an_object(what: &str, given: Given) -> Self {
        let message = format!("{what} must be a plain object, but {} was given", given.words());
        Self {
            code: "not-an-object",
            parameter: Some(what.into()),
            given,
            allowed: Allowed::Text("a plain object".into()),
            message,
        }
    }

    /// The same error with the names that are allowed, where they are not those of the parameters.
    #[must_use]
    pub fn among(mut self, names: &[&str]) -> Self {
        if self.code == "unknown-parameter" {
            self.allowed = Allowed::Text(names.join(", "));
        }
        self
    }

    /// A figure that does not exist.
    pub fn unknown_figure(given: Given) -> Self {
        let ids: Vec<&str> = figures::specifications().iter().map(|figure| figure.id).collect();
        let message = format!("there is no figure {}: there are {}", given.words(), ids.join(", "));
        Self {
            code: "unknown-figure",
            parameter: Some("id".into()),
            given,
            allowed: Allowed::Text(ids.join(", ")),
            message,
        }
    }

    /// A figure object, or a part of one, that cannot be drawn.
    pub fn drawing(part: &str, given: Given, allowed: &str) -> Self {
        let message = format!("in the figure {part} must be {allowed}, but {} was given", given.words());
        Self {
            code: "drawing",
            parameter: Some(part.into()),
            given,
            allowed: Allowed::Text(allowed.into()),
            message,
        }
    }

    /// A fault of ours.
    pub fn internal(message: String) -> Self {
        plain("internal", message)
    }

    /// The plain object that is thrown.
    pub fn to_js(&self) -> JsValue {
        let given = match &self.given {
            Given::Nothing => JsValue::NULL,
            Given::Number(number) => (*number).into(),
            Given::Text(text) | Given::Words(text) => text.into(),
        };
        let allowed = match &self.allowed {
            Allowed::Nothing => JsValue::NULL,
            Allowed::Range(low, high) => Array::of2(&(*low).into(), &(*high).into()).into(),
            Allowed::Text(text) => text.into(),
        };
        let object = Object::new();
        values::set(&object, "code", &self.code.into());
        values::set(&object, "parameter", &self.parameter.as_ref().map_or(JsValue::NULL, Into::into));
        values::set(&object, "given", &given);
        values::set(&object, "allowed", &allowed);
        values::set(&object, "message", &self.message.as_str().into());
        object.into()
    }
}

impl From<WebError> for JsValue {
    fn from(error: WebError) -> Self {
        error.to_js()
    }
}

impl Given {
    /// For a sentence: texts in quotation marks.
    pub fn words(&self) -> String {
        match self {
            Self::Nothing => "nothing".into(),
            Self::Number(number) => number_words(*number),
            Self::Text(text) => format!("\"{text}\""),
            Self::Words(words) => words.clone(),
        }
    }
}

impl Allowed {
    fn words(&self) -> String {
        match self {
            Self::Nothing => "something else".into(),
            Self::Range(low, high) => {
                format!("a number from {} to {}", number_words(*low), number_words(*high))
            }
            Self::Text(text) => text.clone(),
        }
    }
}

/// A number as JavaScript writes it.
pub fn number_words(number: f64) -> String {
    if number.is_infinite() {
        return if number > 0.0 { "Infinity".into() } else { "-Infinity".into() };
    }
    let magnitude = number.abs();
    if number != 0.0 && !(1e-4..1e7).contains(&magnitude) && !number.is_nan() {
        return format!("{number:e}");
    }
    format!("{number}")
}

fn plain(code: &'static str, message: String) -> WebError {
    WebError { code, parameter: None, given: Given::Nothing, allowed: Allowed::Nothing, message }
}

/// Undoes what the model's errors do to a value to put it into a sentence.
fn given_from_text(text: &str) -> Given {
    match text {
        "NaN" => Given::Number(f64::NAN),
        "inf" | "Infinity" => Given::Number(f64::INFINITY),
        "-inf" | "-Infinity" => Given::Number(f64::NEG_INFINITY),
        _ => {
            Given::Text(text.strip_prefix('"').and_then(|rest| rest.strip_suffix('"')).unwrap_or(text).into())
        }
    }
}

impl From<ModelError> for WebError {
    fn from(error: ModelError) -> Self {
        let message = error.to_string();
        let (code, parameter, given, allowed) = match error {
            ModelError::UnknownParameter { name } => {
                let mut names: Vec<&str> = TABLE.iter().map(|info| info.name).collect();
                names.extend(SHORT_FORMS.iter().map(|form| form.name));
                names.push("regime");
                let given = Given::Text(name.clone());
                ("unknown-parameter", name, given, Allowed::Text(names.join(", ")))
            }
            ModelError::NotANumber { parameter, given, low, high } => {
                ("not-a-number", parameter, given_from_text(&given), Allowed::Range(low, high))
            }
            ModelError::OutOfRange { parameter, given, low, high } => {
                ("out-of-range", parameter, Given::Number(given), Allowed::Range(low, high))
            }
            ModelError::NotAChoice { parameter, given, allowed } => {
                ("not-a-choice", parameter, Given::Text(given), Allowed::Text(allowed.join(", ")))
            }
            ModelError::LoadInHomogeneous { parameter, given } => {
                let allowed = format!("0, or another regime: {}, {}", Regime::NAMES[1], Regime::NAMES[2]);
                ("not-allowed", parameter.into(), Given::Number(given), Allowed::Text(allowed))
            }
            ModelError::Asymmetric { parameter, pinion, gear } => {
                let given = format!("{parameter}_p = {pinion}, {parameter}_g = {gear}");
                let allowed = format!("{parameter}_p = {parameter}_g");
                ("asymmetric", parameter.into(), Given::Text(given), Allowed::Text(allowed))
            }
            ModelError::Incommensurate { parameter, given, omega } => {
                let allowed = format!("n/d times Omega = {omega} with d at most 64");
                ("incommensurate", parameter.into(), Given::Number(given), Allowed::Text(allowed))
            }
            ModelError::Missing { parameter } => {
                ("missing", parameter.into(), Given::Nothing, Allowed::Text("a number".into()))
            }
            ModelError::UnbalancedTorque { given, balanced } => {
                ("unbalanced-torque", "T_g".into(), Given::Number(given), Allowed::Range(balanced, balanced))
            }
        };
        Self { code, parameter: Some(parameter), given, allowed, message }
    }
}

impl From<NumericsError> for WebError {
    fn from(error: NumericsError) -> Self {
        let message = error.to_string();
        match error {
            NumericsError::NoConvergence { residual, tolerance, .. } => Self {
                code: "no-convergence",
                parameter: Some("residual".into()),
                given: Given::Number(residual),
                allowed: Allowed::Range(0.0, tolerance),
                message,
            },
            NumericsError::Escaped { time } => Self {
                code: "escaped",
                parameter: Some("t".into()),
                given: Given::Number(time),
                allowed: Allowed::Nothing,
                message,
            },
            NumericsError::StepTooSmall { time, .. }
            | NumericsError::TooManySteps { time, .. }
            | NumericsError::NotFinite { time } => Self {
                code: "numerics",
                parameter: Some("t".into()),
                given: Given::Number(time),
                allowed: Allowed::Nothing,
                message,
            },
            NumericsError::Singular | NumericsError::NoBracket { .. } => plain("numerics", message),
        }
    }
}

impl From<TheoryError> for WebError {
    fn from(error: TheoryError) -> Self {
        let message = error.to_string();
        match error {
            TheoryError::Vanishing { parameter, equation } => Self {
                code: "theory",
                parameter: Some(parameter.into()),
                given: Given::Number(0.0),
                allowed: Allowed::Text(format!("not zero, for equation {equation}")),
                message,
            },
            TheoryError::NoConvergence { residual } => Self {
                code: "no-convergence",
                parameter: Some("residual".into()),
                given: Given::Number(residual),
                allowed: Allowed::Nothing,
                message,
            },
            TheoryError::Model(error) => error.into(),
        }
    }
}

impl From<StudyError> for WebError {
    fn from(error: StudyError) -> Self {
        let message = error.to_string();
        match error {
            StudyError::Option { option, given, allowed } => Self {
                code: "option",
                parameter: Some(option.into()),
                given: given_from_text(&given),
                allowed: Allowed::Text(allowed),
                message,
            },
            StudyError::NotFound { .. } => plain("not-found", message),
            StudyError::Numerics(error) => error.into(),
            StudyError::Model(error) => error.into(),
            StudyError::Theory(error) => error.into(),
        }
    }
}

impl From<ChartError> for WebError {
    fn from(error: ChartError) -> Self {
        let message = error.to_string();
        match error {
            ChartError::Backend { .. } => plain("drawing", message),
            ChartError::Size { width, height } => Self {
                code: "drawing",
                parameter: Some("size".into()),
                given: Given::Text(format!("{width} by {height}")),
                allowed: Allowed::Text("120 to 8192 pixels a side".into()),
                message,
            },
            ChartError::NotFinite { name } => Self {
                code: "drawing",
                parameter: Some(name),
                given: Given::Nothing,
                allowed: Allowed::Text("finite numbers".into()),
                message,
            },
            ChartError::Malformed { name, fault } => Self {
                code: "drawing",
                parameter: Some(name),
                given: Given::Words(fault.into()),
                allowed: Allowed::Nothing,
                message,
            },
            ChartError::Unknown { what, given, known } => Self {
                code: "option",
                parameter: Some(if what == "frame" { "windows" } else { "hidden" }.into()),
                given: Given::Text(given),
                allowed: Allowed::Text(known.join(", ")),
                message,
            },
            ChartError::Window { frame, low, high, bare } => Self {
                code: "option",
                parameter: Some("windows".into()),
                given: Given::Words(format!("{frame}: [{}, {}]", number_words(low), number_words(high))),
                allowed: if bare {
                    Allowed::Text("frames with axes".into())
                } else {
                    Allowed::Text("low < high, by more than a billionth of the greater end".into())
                },
                message,
            },
        }
    }
}

impl From<FigureError> for WebError {
    fn from(error: FigureError) -> Self {
        match error {
            FigureError::UnknownFigure { given } => Self::unknown_figure(Given::Text(given)),
            FigureError::Study(error) => error.into(),
            FigureError::Chart(error) => error.into(),
        }
    }
}
