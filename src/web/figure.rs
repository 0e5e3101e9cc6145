//! The figures: what there is, one computed at once, one computed in pieces.

use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;
use web_sys::js_sys::Array;

use crate::figures::{self, Job, Preset, START, Specification};
use crate::model::parameters::{
    ParameterInfo, Parameters, Regime, SHORT_FORMS, Scale, ShortForm, TABLE, info,
};
use crate::web::columns::{Record, array};
use crate::web::drawing;
use crate::web::errors::WebError;
use crate::web::options::{self, Options};

const REGIME_MEANING: &str = "what the tooth force follows: the deviation alone (homogeneous), the teeth always in \
    contact (contact), or contact and separation (backlash)";

/// Every parameter with its symbol, default, range and meaning: `defaults()`.
///
/// # Errors
/// The plain object of a `GearError`.
#[wasm_bindgen]
pub fn defaults() -> Result<JsValue, JsValue> {
    let lines = TABLE.iter().map(|line| parameter_record(line, None));
    let regime = regime_record(Parameters::default().regime.name());
    Ok(array(lines.chain([regime]))?)
}

/// Every figure with its words, controls and manners: `figures()`.
///
/// # Errors
/// The plain object of a `GearError`.
#[wasm_bindgen]
pub fn figures() -> Result<JsValue, JsValue> {
    let mut lines = Lines::default();
    Ok(array(figures::specifications().iter().map(|one| specification_record(one, &mut lines)))?)
}

/// One figure, computed: `figure(id, params)`.
///
/// # Errors
/// The plain object of a `GearError`.
#[wasm_bindgen]
pub fn figure(id: &JsValue, params: &JsValue) -> Result<JsValue, JsValue> {
    let (figure, title) = drawing::computed(id, params)?;
    Ok(drawing::figure_record(&figure, &title).finish()?)
}

/// A figure that is computed in pieces.
#[wasm_bindgen]
pub struct FigureProgress {
    job: Job,
    title: String,
    divided: bool,
}

/// Most parts of one figure.
const MOST_PARTS: usize = 64;

/// Begins a figure that is computed in pieces: `progress(id, params, {part, parts})`.
///
/// # Errors
/// The plain object of a `GearError`.
#[wasm_bindgen]
pub fn progress(id: &JsValue, params: &JsValue, options: &JsValue) -> Result<FigureProgress, JsValue> {
    let id = drawing::figure_id(id)?;
    let given = options::named_values(params)?;
    let options = Options::read(options, &["part", "parts"])?;
    let parts = options.whole("parts", (1, MOST_PARTS), 1)?;
    let part = options.whole("part", (0, parts - 1), 0)?;
    let mut job = Job::new(&id, &given).map_err(WebError::from)?;
    let divided = job.divide(part, parts).map_err(WebError::from)?;
    let title = drawing::title(&id).map_err(WebError::from)?;
    Ok(FigureProgress { job, title, divided })
}

#[wasm_bindgen]
impl FigureProgress {
    /// Whether only the part that was asked for is computed; a figure that cannot be divided is computed whole.
    pub fn divided(&self) -> bool {
        self.divided
    }

    /// Works for about 15 ms; true when the figure is done.
    ///
    /// # Errors
    /// The plain object of a `GearError`.
    pub fn advance(&mut self) -> Result<bool, JsValue> {
        Ok(self.job.advance().map_err(WebError::from)?)
    }

    /// What there is so far.
    ///
    /// # Errors
    /// The plain object of a `GearError`.
    pub fn figure(&self) -> Result<JsValue, JsValue> {
        Ok(drawing::figure_record(&self.job.figure(), &self.title).finish()?)
    }
}

fn specification_record(specification: &Specification, lines: &mut Lines) -> Record {
    let names = specification.parameters.iter();
    let mut controls: Vec<Record> = names.map(|name| control_record(specification, name, lines)).collect();
    if specification.starts {
        // With the state in which this figure starts where nothing is said.
        let usual = START.iter().zip(specification.usual_start());
        controls.extend(usual.map(|(line, value)| lines.record(line, None, value)));
    }
    Record::new()
        .value("id", specification.id)
        .value("title", specification.title)
        .value("caption", specification.caption)
        .list("parameters", controls)
        .value("turnable", specification.turnable)
        .value("animated", specification.animated)
        .number("aspect", specification.aspect)
        .value("heavy", specification.heavy)
        .value("divisible", specification.divisible)
}

/// One control of a figure: the parameter's line, with this figure's own default.
fn control_record(specification: &Specification, name: &str, lines: &mut Lines) -> Record {
    let preset = |name: &str| {
        let own = specification.preset.iter().find(|(given, _)| *given == name);
        own.map(|(_, preset)| *preset)
    };
    if name == "regime" {
        return regime_record(match preset(name) {
            Some(Preset::Word(word)) => word,
            _ => Parameters::default().regime.name(),
        });
    }
    let form = SHORT_FORMS.iter().find(|form| form.name == name);
    let Some(line) = info(name) else { return Record::new().value("name", name) };
    let own = [Some(name), form.map(|form| form.sets[0]), line.short, line.follows]
        .into_iter()
        .flatten()
        .find_map(preset);
    let default = match own {
        Some(Preset::Number(number)) => number,
        _ => line.default,
    };
    lines.record(line, form, default)
}

/// The lines of the table that have been put into objects, by name. Thirty figures have three hundred controls, of two dozen
/// parameters, and to make an object here takes twelve values across the boundary, to copy one a single call.
#[derive(Default)]
struct Lines(Vec<(&'static str, Record)>);

impl Lines {
    fn record(
        &mut self,
        line: &'static ParameterInfo,
        form: Option<&'static ShortForm>,
        default: f64,
    ) -> Record {
        let name = form.map_or(line.name, |form| form.name);
        let place = self.0.iter().position(|(known, _)| *known == name).unwrap_or_else(|| {
            self.0.push((name, parameter_record(line, form)));
            self.0.len() - 1
        });
        self.0[place].1.copied().number("default", default)
    }
}

/// A line of the table.
fn parameter_record(line: &ParameterInfo, form: Option<&ShortForm>) -> Record {
    let (name, symbol, meaning) =
        form.map_or((line.name, line.symbol, line.meaning), |form| (form.name, form.symbol, form.meaning));
    let sets = form.map_or_else(|| vec![line.name], |form| form.sets.to_vec());
    let short = if form.is_some() { None } else { line.short };
    let scale = match line.scale {
        Scale::Linear => "linear",
        Scale::Logarithmic => "logarithmic",
    };
    let word = |word: Option<&str>| word.map_or(JsValue::NULL, JsValue::from);
    Record::new()
        .value("name", name)
        .value("symbol", symbol)
        .number("default", line.default)
        .number("low", line.low)
        .number("high", line.high)
        .pair("range", (line.low, line.high))
        .pair("slider", line.slider)
        .value("scale", scale)
        .value("unit", "dimensionless")
        .value("meaning", meaning)
        .value("follows", word(line.follows))
        .value("short", word(short))
        .texts("sets", sets)
}

fn regime_record(default: &str) -> Record {
    Record::new()
        .value("name", "regime")
        .value("choices", Regime::NAMES.iter().map(|name| JsValue::from(*name)).collect::<Array>())
        .value("default", default)
        .value("meaning", REGIME_MEANING)
}
