//! The calls that follow periodic orbits: one branch, and the automatic diagram.

use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::model::parameters::info;
use crate::study::branch::{self as following, Branch, BranchEnd, BranchEvent, BranchOptions};
use crate::study::diagram::{self as all, DiagramOptions};
use crate::study::family::parameter_named;
use crate::study::orbit::LONGEST;
use crate::web::attractors::OMEGA;
use crate::web::columns::Record;
use crate::web::errors::WebError;
use crate::web::options::{self, Options};

/// Most points of a branch, each way.
const MOST_POINTS: usize = 100_000;

/// A branch of periodic orbits: `branch(params, {parameter, range, period, from, points, maxStep, tolerance})`.
///
/// # Errors
/// The plain object of a `GearError`.
#[wasm_bindgen]
pub fn branch(params: &JsValue, options: &JsValue) -> Result<JsValue, JsValue> {
    let names = ["parameter", "range", "period", "from", "points", "maxStep", "tolerance"];
    let options = Options::read(options, &names)?;
    let word = options.word("parameter", "the name of a parameter")?;
    let (parameter, allowed) = parameter_named(word.as_deref().unwrap_or("Omega")).map_err(WebError::from)?;
    let slider = info(parameter).map_or(allowed, |info| [info.slider.0, info.slider.1]);
    let usual = BranchOptions::new(slider, 1);
    let longest = allowed[1] - allowed[0];
    let step = options.number("maxStep", (1e-12, longest), f64::NAN)?;
    let asked = BranchOptions {
        parameter,
        range: options.range("range", slider, allowed)?,
        period: options.whole("period", (1, LONGEST), usual.period)?,
        from: options.state("from")?,
        points: options.whole("points", (2, MOST_POINTS), usual.points)?,
        max_step: (!step.is_nan()).then_some(step),
        tolerance: options.tolerance()?,
    };
    let parameters = options::parameters(params)?;
    let answer = following::branch(&parameters, &asked).map_err(WebError::from)?;
    Ok(branch_record(&answer).finish()?)
}

/// A branch as a plain object.
pub fn branch_record(branch: &Branch) -> Record {
    let flags: Vec<f64> = branch.stable.iter().map(|stable| f64::from(u8::from(*stable))).collect();
    let counts: Vec<f64> = branch.unstable.iter().map(|count| *count as f64).collect();
    Record::new()
        .value("parameter", branch.parameter)
        .number("period", branch.period as f64)
        .column(branch.parameter, &branch.value)
        .column("maxU_p", &branch.max_u_p)
        .column("maxU", &branch.max_u)
        .column("state", branch.state.as_flattened())
        .column("stable", &flags)
        .column("unstable", &counts)
        .column("re", branch.re.as_flattened())
        .column("im", branch.im.as_flattened())
        .list("events", branch.events.iter().map(|event| event_record(event, branch.parameter)))
        .list("ends", branch.ends.iter().map(end_record))
        .provenance(&branch.method, &branch.error)
}

fn event_record(event: &BranchEvent, parameter: &str) -> Record {
    Record::new()
        .value("kind", event.kind.name())
        .number(parameter, event.value)
        .column("state", &event.state)
        .value("breaks", event.breaks.map_or(JsValue::NULL, |breaks| breaks.name().into()))
        .number("maxU_p", event.max_u_p)
        .number("maxU", event.max_u)
        .value("supercritical", event.supercritical.map_or(JsValue::NULL, JsValue::from))
        .number("after", event.after as f64)
}

fn end_record(end: &BranchEnd) -> Record {
    let (kind, period, reason) = match end {
        BranchEnd::Range => ("range", None, None),
        BranchEnd::BornFrom { period } => ("born-from", Some(*period as f64), None),
        BranchEnd::Points => ("points", None, None),
        BranchEnd::Closed => ("closed", None, None),
        BranchEnd::Steep { entry } => ("steep", None, Some(format!("a multiplier of {entry:e}"))),
        BranchEnd::Lost { reason } => ("lost", None, Some(reason.to_string())),
    };
    Record::new()
        .value("kind", kind)
        .optional("period", period)
        .value("reason", reason.map_or(JsValue::NULL, |reason| reason.as_str().into()))
}

/// The automatic diagram: `diagram(params, {Omega, maxPeriod, maxBranches, tolerance})`.
///
/// # Errors
/// The plain object of a `GearError`.
#[wasm_bindgen]
pub fn diagram(params: &JsValue, options: &JsValue) -> Result<JsValue, JsValue> {
    let options = Options::read(options, &["Omega", "maxPeriod", "maxBranches", "tolerance"])?;
    let slider = info("Omega").map_or(OMEGA, |info| [info.slider.0, info.slider.1]);
    let usual = DiagramOptions::new(options.range("Omega", slider, OMEGA)?);
    let asked = DiagramOptions {
        max_period: options.whole("maxPeriod", (1, LONGEST), usual.max_period)?,
        max_branches: options.whole("maxBranches", (1, 1000), usual.max_branches)?,
        tolerance: options.tolerance()?,
        ..usual
    };
    let parameters = options::parameters(params)?;
    let answer = all::diagram(&parameters, &asked).map_err(WebError::from)?;
    let branches = answer.branches.iter().zip(&answer.from).map(|(branch, from)| {
        let record = branch_record(branch);
        match from {
            None => record.value("from", JsValue::NULL),
            Some((branch, event)) => record.record(
                "from",
                Record::new().number("branch", *branch as f64).number("event", *event as f64),
            ),
        }
    });
    let record = Record::new()
        .list("branches", branches)
        .value("complete", answer.complete)
        .provenance(&answer.method, &answer.error);
    Ok(record.finish()?)
}
