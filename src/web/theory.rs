//! The theory's calls: modes and tongues.

use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::study::ErrorEstimate;
use crate::theory::{self, Edges, Modes, Tongue};
use crate::web::columns::Record;
use crate::web::errors::WebError;
use crate::web::options::{self, Options};

/// Natural frequencies and mode shapes: `modes(params)`.
///
/// # Errors
/// The plain object of a `GearError`.
#[wasm_bindgen]
pub fn modes(params: &JsValue, options: &JsValue) -> Result<JsValue, JsValue> {
    Options::read(options, &[])?;
    let symmetric = options::parameters(params)?.symmetric().map_err(WebError::from)?;
    let modes = Modes::of(&symmetric).map_err(WebError::from)?;
    let record = Record::new()
        .number("a", modes.a)
        .number("b", modes.b)
        .column("omega", &modes.omega)
        .column("shapes", &modes.shapes().concat())
        .provenance("closed formulas (36)-(41), equal supports", &ErrorEstimate::default());
    Ok(record.finish()?)
}

/// Where each formula puts the three tongues: `tongues(params)`.
///
/// # Errors
/// The plain object of a `GearError`.
#[wasm_bindgen]
pub fn tongues(params: &JsValue, options: &JsValue) -> Result<JsValue, JsValue> {
    Options::read(options, &[])?;
    let symmetric = options::parameters(params)?.symmetric().map_err(WebError::from)?;
    let tongues = theory::tongues(&symmetric).map_err(WebError::from)?;
    let record = Record::new()
        .record("primary2", tongue_record(&tongues.primary2, true))
        .record("primary3", tongue_record(&tongues.primary3, true))
        .record("combination", tongue_record(&tongues.combination, false))
        .provenance(
            "first order: (56), (82), (105), [T3]-[T6]; hill: Hill's determinant of all harmonics that matter",
            &ErrorEstimate::default(),
        );
    Ok(record.finish()?)
}

fn interval(edges: Option<Edges>) -> Record {
    Record::new()
        .optional("left", edges.map(|edges| edges.left))
        .optional("right", edges.map(|edges| edges.right))
}

fn tongue_record(tongue: &Tongue, primary: bool) -> Record {
    let record = Record::new()
        .number("Omega0", tongue.omega_0)
        .record("paper", interval(tongue.paper))
        .record("corrected", interval(tongue.corrected))
        .record("damped", interval(tongue.damped));
    // Closed, not asked for, and not found are three different answers.
    let record = match (&tongue.hill_error, primary) {
        (None, true) => record.record("hill", interval(tongue.hill)).value("hillError", JsValue::NULL),
        (None, false) => record.value("hill", JsValue::NULL).value("hillError", JsValue::NULL),
        (Some(error), _) => record.value("hill", JsValue::NULL).value("hillError", error.to_string()),
    };
    record.number("threshold", tongue.threshold)
}
