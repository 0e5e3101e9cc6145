//! The calls about the linear problem: where tongues begin and end, their boundaries as curves, the chart of stability.

use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::study::chart_work::ChartWork;
use crate::study::multipliers::unloaded;
use crate::study::stability_chart::stability_chart as linear_chart;
use crate::study::tongue::{self, Tongue};
use crate::study::tongue_boundary::{self as boundary, POINTS};
use crate::web::attractors::OMEGA;
use crate::web::columns::Record;
use crate::web::errors::{Allowed, WebError};
use crate::web::options::{self, Options};
use crate::web::values;

/// Most points of a chart.
const MOST_POINTS: usize = 1 << 22;
/// Tolerance of a chart's spectral radius by default, absolute.
const CHART: f64 = 1e-6;
/// What a tongue may be.
const TONGUES: &str = "primary2, primary3, combination, or {near: Omega}";

/// The tongue that is asked for.
///
/// # Errors
/// `option`.
fn tongue(options: &Options) -> Result<Tongue, WebError> {
    let value = options.value("tongue");
    let refused = || WebError::option("tongue", values::given(&value), Allowed::Text(TONGUES.into()));
    if let Some(word) = value.as_string() {
        return match word.as_str() {
            "primary2" => Ok(Tongue::Primary2),
            "primary3" => Ok(Tongue::Primary3),
            "combination" => Ok(Tongue::Combination),
            _ => Err(refused()),
        };
    }
    if !value.is_object() || value.is_function() {
        return Err(refused());
    }
    let near = options.nested("tongue", &["near"])?;
    let omega = near.number("near", (OMEGA[0], OMEGA[1]), f64::NAN)?;
    if omega.is_nan() { Err(refused()) } else { Ok(Tongue::Near(omega)) }
}

/// The exact edges of a tongue: `tongueEdges(params, {tongue, tolerance})`.
///
/// # Errors
/// The plain object of a `GearError`.
#[wasm_bindgen(js_name = tongueEdges)]
pub fn tongue_edges(params: &JsValue, options: &JsValue) -> Result<JsValue, JsValue> {
    let options = Options::read(options, &["tongue", "tolerance"])?;
    let tongue = tongue(&options)?;
    let tolerance = options.tolerance()?;
    let parameters = options::parameters(params)?;
    let answer = tongue::tongue_edges(&parameters, tongue, tolerance).map_err(WebError::from)?;
    let record = Record::new().optional("left", answer.left).optional("right", answer.right);
    let record = match answer.kind {
        None => record.value("kind", JsValue::NULL),
        Some(kinds) => record.texts("kind", kinds.iter().map(|kind| kind.name())),
    };
    Ok(record.provenance(&answer.method, &answer.error).finish()?)
}

/// The boundary of a tongue: `tongueBoundary(params, {tongue, k0, points, tolerance})`.
///
/// # Errors
/// The plain object of a `GearError`.
#[wasm_bindgen(js_name = tongueBoundary)]
pub fn tongue_boundary(params: &JsValue, options: &JsValue) -> Result<JsValue, JsValue> {
    let options = Options::read(options, &["tongue", "k0", "points", "tolerance"])?;
    let tongue = tongue(&options)?;
    let k0 = options.range("k0", [0.0, 1.0], [0.0, 1.0])?;
    let points = options.whole("points", POINTS, 90)?;
    let tolerance = options.tolerance()?;
    let parameters = options::parameters(params)?;
    let answer =
        boundary::tongue_boundary(&parameters, tongue, k0, points, tolerance).map_err(WebError::from)?;
    let record = Record::new()
        .column("Omega", &answer.omega)
        .column("k0", &answer.k0)
        .texts("kind", answer.kind.iter().map(|kind| kind.name()))
        .number("left", answer.left as f64);
    let record = match answer.tip {
        None => record.value("tip", JsValue::NULL),
        Some([omega, k0]) => record.record("tip", Record::new().number("Omega", omega).number("k0", k0)),
    };
    Ok(record.provenance(&answer.method, &answer.error).finish()?)
}

/// The spectral radius over a plane: `stabilityChart(params, {Omega, k0, tolerance})`.
///
/// # Errors
/// The plain object of a `GearError`.
#[wasm_bindgen(js_name = stabilityChart)]
pub fn stability_chart(params: &JsValue, options: &JsValue) -> Result<JsValue, JsValue> {
    let options = Options::read(options, &["Omega", "k0", "tolerance"])?;
    let (omega, k0) = (options.grid("Omega", OMEGA)?, options.grid("k0", [0.0, 1.0])?);
    if omega.count * k0.count > MOST_POINTS {
        let given = crate::web::errors::Given::Words(format!("{} times {}", omega.count, k0.count));
        let allowed = Allowed::Text(format!("with k0 at most {MOST_POINTS} points"));
        return Err(WebError::option("Omega", given, allowed).into());
    }
    let tolerance = options.number("tolerance", crate::study::motion::TOLERANCE, CHART)?;
    let parameters = options::parameters(params)?;
    let chart = if unloaded(&parameters) {
        linear_chart(&parameters, omega, k0, tolerance).map_err(WebError::from)?
    } else {
        let mut work = ChartWork::new(&parameters, omega, k0, tolerance, None).map_err(WebError::from)?;
        while !work.advance().map_err(WebError::from)? {}
        work.chart()
    };
    // No number crosses that is not finite: where there is no response there is no radius either.
    let missing: Vec<f64> =
        chart.spectral_radius.iter().map(|radius| f64::from(u8::from(!radius.is_finite()))).collect();
    let radius: Vec<f64> =
        chart.spectral_radius.iter().map(|radius| if radius.is_finite() { *radius } else { -1.0 }).collect();
    let step = chart.error.is_finite().then_some(chart.error);
    let record = Record::new()
        .column("Omega", &(0..omega.count).map(|index| omega.value(index)).collect::<Vec<_>>())
        .column("k0", &(0..k0.count).map(|index| k0.value(index)).collect::<Vec<_>>())
        .column("spectralRadius", &radius)
        .number("missing", missing.iter().sum())
        .provenance(&chart.method, &crate::study::ErrorEstimate { step, ..Default::default() });
    Ok(record.finish()?)
}
