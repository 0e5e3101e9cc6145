//! The studies' calls: multipliers, time response, stroboscopic map, periodic orbits.

use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::study::multipliers as floquet;
use crate::study::orbit::{self, OrbitOptions};
use crate::study::poincare::{self as strobe, PoincareOptions};
use crate::study::time_response::{self as response, TimeResponseOptions};
use crate::web::columns::Record;
use crate::web::errors::{Allowed, Given, WebError};
use crate::web::options::{self, Options};

/// Shortest and longest time response, mesh periods.
const PERIODS: (f64, f64) = (1e-6, 1e5);
/// Finest sampling, rows a period.
const MOST_SAMPLES: usize = 10_000;
/// Most rows of one answer.
const MOST_ROWS: usize = response::MOST_ROWS as usize;

/// Floquet multipliers: `multipliers(params, {tolerance})`.
///
/// # Errors
/// The plain object of a `GearError`.
#[wasm_bindgen]
pub fn multipliers(params: &JsValue, options: &JsValue) -> Result<JsValue, JsValue> {
    let options = Options::read(options, &["tolerance"])?;
    let tolerance = options.tolerance()?;
    let parameters = options::parameters(params)?;
    let answer = floquet::multipliers(&parameters, tolerance).map_err(WebError::from)?;
    let record = Record::new()
        .column("re", &answer.re)
        .column("im", &answer.im)
        .number("spectralRadius", answer.spectral_radius)
        .value("stable", answer.stable)
        .column("state", &answer.state)
        .provenance(&answer.method, &answer.error);
    Ok(record.finish()?)
}

/// Motion in time: `timeResponse(params, {state, periods, samplesPerPeriod, tolerance})`.
///
/// # Errors
/// The plain object of a `GearError`.
#[wasm_bindgen(js_name = timeResponse)]
pub fn time_response(params: &JsValue, options: &JsValue) -> Result<JsValue, JsValue> {
    let options = Options::read(options, &["state", "periods", "samplesPerPeriod", "tolerance"])?;
    let parameters = options::parameters(params)?;
    let usual = TimeResponseOptions::new(&parameters);
    let periods = options.number("periods", PERIODS, usual.periods)?;
    let samples_per_period =
        options.whole("samplesPerPeriod", (1, MOST_SAMPLES), usual.samples_per_period)?;
    if periods * samples_per_period as f64 > MOST_ROWS as f64 {
        let given = Given::Words(format!("{periods} times {samples_per_period}"));
        let allowed = Allowed::Text(format!("with samplesPerPeriod at most {MOST_ROWS} rows"));
        return Err(WebError::option("periods", given, allowed).into());
    }
    let asked = TimeResponseOptions {
        state: options.state("state")?.unwrap_or(usual.state),
        periods,
        samples_per_period,
        tolerance: options.tolerance()?,
    };
    let answer = response::time_response(&parameters, &asked).map_err(WebError::from)?;
    let record = Record::new()
        .column("t", &answer.t)
        .states(&answer.states)
        .column("contactLoss", &answer.contact_loss)
        .optional("escaped", answer.escaped)
        .provenance(&answer.method, &answer.error);
    Ok(record.finish()?)
}

/// Stroboscopic points: `poincare(params, {state, transient, points, tolerance})`.
///
/// # Errors
/// The plain object of a `GearError`.
#[wasm_bindgen]
pub fn poincare(params: &JsValue, options: &JsValue) -> Result<JsValue, JsValue> {
    let options = Options::read(options, &["state", "transient", "points", "tolerance"])?;
    let parameters = options::parameters(params)?;
    let usual = PoincareOptions::new(&parameters);
    let points = options.whole("points", (1, MOST_ROWS), usual.points)?;
    let transient = options.whole("transient", (0, MOST_ROWS), usual.transient)?;
    if points + transient > MOST_ROWS {
        let given = Given::Words(format!("{points} after {transient}"));
        let allowed = Allowed::Text(format!("with the transient at most {MOST_ROWS} periods"));
        return Err(WebError::option("points", given, allowed).into());
    }
    let asked = PoincareOptions {
        state: options.state("state")?.unwrap_or(usual.state),
        transient,
        points,
        tolerance: options.tolerance()?,
    };
    let answer = strobe::poincare(&parameters, &asked).map_err(WebError::from)?;
    let period = parameters.mesh_period();
    let times: Vec<f64> = (0..answer.states.len()).map(|row| (transient + row) as f64 * period).collect();
    let record = Record::new()
        .column("t", &times)
        .states(&answer.states)
        .optional("escaped", answer.escaped)
        .provenance(&answer.method, &answer.error);
    Ok(record.finish()?)
}

/// A periodic orbit: `periodicOrbit(params, {period, guess, tolerance})`.
///
/// # Errors
/// The plain object of a `GearError`.
#[wasm_bindgen(js_name = periodicOrbit)]
pub fn periodic_orbit(params: &JsValue, options: &JsValue) -> Result<JsValue, JsValue> {
    let options = Options::read(options, &["period", "guess", "tolerance"])?;
    let usual = OrbitOptions::default();
    let asked = OrbitOptions {
        period: options.whole("period", (1, orbit::LONGEST), usual.period)?,
        guess: options.state("guess")?,
        tolerance: options.tolerance()?,
    };
    let parameters = options::parameters(params)?;
    let answer = orbit::periodic_orbit(&parameters, &asked).map_err(WebError::from)?;
    let record = Record::new()
        .column("state", &answer.state)
        .record("multipliers", Record::new().column("re", &answer.re).column("im", &answer.im))
        .value("stable", answer.stable)
        .column("min", &answer.min)
        .column("max", &answer.max)
        .number("period", answer.period as f64)
        .provenance(&answer.method, &answer.error);
    Ok(record.finish()?)
}
