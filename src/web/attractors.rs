//! The calls about what motions settle on: tori, sweeps, exponents, spectra, and whether the teeth keep contact.

use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::model::parameters::{Parameters, Regime};
use crate::study::basin::{Attractor, AttractorKind, BasinOptions, BasinWork};
use crate::study::contact::{self, Limit, NoLoad};
use crate::study::lyapunov as exponents;
use crate::study::motion::TOLERANCE;
use crate::study::spectrum as series;
use crate::study::sweep::{self as sweeping, Direction, SweepOptions};
use crate::study::torus as tori;
use crate::web::columns::Record;
use crate::web::errors::{Allowed, Given, WebError};
use crate::web::options::{self, LARGEST_COORDINATE, Options};

/// Range of the mesh frequency.
pub const OMEGA: [f64; 2] = [0.01, 100.0];
/// Mesh periods of a Lyapunov spectrum by default.
const LYAPUNOV_PERIODS: usize = 2000;
/// Mesh periods left out before a spectrum, and in it, by default.
const SPECTRUM_PERIODS: (usize, usize) = (500, 128);
/// Most periods left out before a spectrum.
const LONGEST_TRANSIENT: usize = 1_000_000;

/// A quasi-periodic motion: `torus(params, {tolerance})`.
///
/// # Errors
/// The plain object of a `GearError`.
#[wasm_bindgen]
pub fn torus(params: &JsValue, options: &JsValue) -> Result<JsValue, JsValue> {
    let options = Options::read(options, &["tolerance"])?;
    let tolerance = options.tolerance()?;
    let parameters = options::parameters(params)?;
    let answer = tori::torus(&parameters, tolerance).map_err(WebError::from)?;
    let record = Record::new()
        .number("meanRadius", answer.mean_radius)
        .number("rotation", answer.rotation)
        .column("curve", answer.curve.as_flattened())
        .value("stable", answer.stable)
        .number("growth", answer.growth)
        .number("rMin", answer.r_min)
        .number("rMax", answer.r_max)
        .number("maxU_p", answer.max_u_p)
        .number("maxU", answer.max_u)
        .number("circles", answer.circles as f64);
    let record = match &answer.averages {
        None => record.value("averages", JsValue::NULL),
        Some(averages) => record.record(
            "averages",
            Record::new().number("meanRadius", averages.mean_radius).number("rotation", averages.rotation),
        ),
    };
    Ok(record.provenance(&answer.method, &answer.error).finish()?)
}

/// A brute-force bifurcation diagram: `sweep(params, {Omega, direction, transient, points, state, tolerance})`.
///
/// # Errors
/// The plain object of a `GearError`.
#[wasm_bindgen]
pub fn sweep(params: &JsValue, options: &JsValue) -> Result<JsValue, JsValue> {
    let names = ["Omega", "direction", "transient", "points", "state", "tolerance"];
    let options = Options::read(options, &names)?;
    let omega = options.grid("Omega", OMEGA)?;
    let usual = SweepOptions::new(omega);
    let word = options.word("direction", "up, down")?;
    let direction = match word.as_deref() {
        None => usual.direction,
        Some(word) => Direction::from_name(word).map_err(WebError::from)?,
    };
    let asked = SweepOptions {
        omega,
        direction,
        transient: options.whole("transient", (0, 1_000_000), usual.transient)?,
        points: options.whole("points", (1, 1_000_000), usual.points)?,
        state: options.state("state")?,
        tolerance: options.tolerance()?,
    };
    let parameters = options::parameters(params)?;
    let answer = sweeping::sweep(&parameters, &asked).map_err(WebError::from)?;
    let record = Record::new()
        .column("Omega", &answer.omega)
        .column("u_p", &answer.u_p)
        .column("u", &answer.u)
        .optional("escaped", answer.escaped)
        .provenance(&answer.method, &answer.error);
    Ok(record.finish()?)
}

/// The Lyapunov spectrum: `lyapunov(params, {state, periods, tolerance})`.
///
/// # Errors
/// The plain object of a `GearError`.
#[wasm_bindgen]
pub fn lyapunov(params: &JsValue, options: &JsValue) -> Result<JsValue, JsValue> {
    let options = Options::read(options, &["state", "periods", "tolerance"])?;
    let state = options.state("state")?;
    let periods = options.whole("periods", (1, exponents::MOST_PERIODS), LYAPUNOV_PERIODS)?;
    let tolerance = options.tolerance()?;
    let parameters = options::parameters(params)?;
    let answer = exponents::lyapunov(&parameters, state, periods, tolerance).map_err(WebError::from)?;
    let record = Record::new()
        .column("exponents", &answer.exponents)
        .column("state", &answer.state)
        .provenance(&answer.method, &answer.error);
    Ok(record.finish()?)
}

/// The spectrum of the transmission error: `spectrum(params, {state, transient, periods, tolerance})`.
///
/// # Errors
/// The plain object of a `GearError`.
#[wasm_bindgen]
pub fn spectrum(params: &JsValue, options: &JsValue) -> Result<JsValue, JsValue> {
    let options = Options::read(options, &["state", "transient", "periods", "tolerance"])?;
    let state = options.state("state")?;
    let transient = options.whole("transient", (0, LONGEST_TRANSIENT), SPECTRUM_PERIODS.0)?;
    let periods = options.whole("periods", (1, series::MOST_PERIODS), SPECTRUM_PERIODS.1)?;
    let tolerance = options.tolerance()?;
    let parameters = options::parameters(params)?;
    let answer =
        series::spectrum(&parameters, state, transient, periods, tolerance).map_err(WebError::from)?;
    let record = Record::new()
        .column("frequency", &answer.frequency)
        .column("amplitude", &answer.amplitude)
        .value("window", answer.window)
        .provenance(&answer.method, &answer.error);
    Ok(record.finish()?)
}

/// Whether the teeth keep contact: `contactMargin(params, {state, tolerance})`.
///
/// # Errors
/// The plain object of a `GearError`.
#[wasm_bindgen(js_name = contactMargin)]
pub fn contact_margin(params: &JsValue, options: &JsValue) -> Result<JsValue, JsValue> {
    let options = Options::read(options, &["state", "tolerance"])?;
    let state = options.state("state")?;
    let tolerance = options.tolerance()?;
    let parameters = loaded(params)?;
    let answer = contact::contact_margin(&parameters, state, tolerance).map_err(WebError::from)?;
    let record = Record::new()
        .number("margin", answer.margin)
        .number("at", answer.at)
        .column("state", &answer.state)
        .value("stable", answer.stable)
        .number("period", answer.period as f64)
        .provenance(&answer.method, &answer.error);
    Ok(record.finish()?)
}

/// The least load that keeps the teeth in contact: `leastLoad(params, {tolerance})`.
///
/// # Errors
/// The plain object of a `GearError`.
#[wasm_bindgen(js_name = leastLoad)]
pub fn least_load(params: &JsValue, options: &JsValue) -> Result<JsValue, JsValue> {
    let options = Options::read(options, &["tolerance"])?;
    let tolerance = options.tolerance()?;
    let parameters = loaded(params)?;
    let answer = contact::least_load(&parameters, tolerance).map_err(WebError::from)?;
    let limit = match answer.limit {
        Limit::Contact => "contact",
        Limit::Stability => "stability",
        Limit::None => "none",
    };
    let reason = answer.reason.map_or(JsValue::NULL, |reason| no_load_word(reason).into());
    let record = Record::new()
        .optional("F", answer.load)
        .optional("contactF", answer.contact_load)
        .value("limit", limit)
        .value("reason", reason);
    let record = match &answer.state {
        Some(state) => record.column("state", state),
        None => record.value("state", JsValue::NULL),
    };
    Ok(record.provenance(&answer.method, &answer.error).finish()?)
}

fn no_load_word(reason: NoLoad) -> &'static str {
    match reason {
        NoLoad::Unstable => "unstable",
        NoLoad::Parted => "parted",
        NoLoad::NoResponse => "no-response",
    }
}

/// Parameters of a question that has no meaning without teeth.
///
/// # Errors
/// As [`options::parameters`].
fn loaded(params: &JsValue) -> Result<Parameters, WebError> {
    let parameters = options::parameters(params)?;
    if parameters.regime == Regime::Homogeneous {
        return Err(WebError {
            code: "not-allowed",
            parameter: Some("regime".into()),
            given: Given::Text("homogeneous".into()),
            allowed: Allowed::Text("contact, backlash".into()),
            message:
                "in the homogeneous regime there are no teeth to keep in contact; choose contact or backlash"
                    .into(),
        });
    }
    Ok(parameters)
}

/// Names of the coordinates of a state.
const COORDINATES: [&str; 6] = ["u_p", "u_g", "u", "u_p_dot", "u_g_dot", "u_dot"];
/// Range of a coordinate in a plane of starts.
const STARTS: [f64; 2] = [-LARGEST_COORDINATE, LARGEST_COORDINATE];

/// Basins of attraction: `basin(params, {plane, x, y, state, periods, tolerance})`.
///
/// # Errors
/// The plain object of a `GearError`.
#[wasm_bindgen]
pub fn basin(params: &JsValue, options: &JsValue) -> Result<JsValue, JsValue> {
    let options = Options::read(options, &["plane", "x", "y", "state", "periods", "tolerance"])?;
    let parameters = options::parameters(params)?;
    let (x, y) = (options.grid("x", STARTS)?, options.grid("y", STARTS)?);
    let usual = BasinOptions::new(&parameters, x, y);
    let asked = BasinOptions {
        plane: options.names("plane", &COORDINATES, usual.plane)?,
        state: options.state("state")?.unwrap_or(usual.state),
        // None given: chosen by the study.
        periods: Some(options.whole("periods", (1, 100_000), 0)?).filter(|periods| *periods > 0),
        tolerance: options.number("tolerance", TOLERANCE, usual.tolerance)?,
        ..usual
    };
    let mut work = BasinWork::new(&parameters, &asked).map_err(WebError::from)?;
    while !work.advance().map_err(WebError::from)? {}
    let answer = work.basin();
    let numbers: Vec<f64> = answer.attractor.iter().map(|index| f64::from(*index)).collect();
    let phases: Vec<f64> = answer.phase.iter().map(|phase| f64::from(*phase)).collect();
    let record = Record::new()
        .column("attractor", &numbers)
        .column("phase", &phases)
        .list("attractors", answer.attractors.iter().map(attractor_record))
        .provenance(&answer.method, &answer.error);
    Ok(record.finish()?)
}

fn attractor_record(attractor: &Attractor) -> Record {
    let (kind, period) = match attractor.kind {
        AttractorKind::Orbit { period } | AttractorKind::Gap { period } => ("orbit", Some(period as f64)),
        AttractorKind::Torus => ("torus", None),
    };
    let record = Record::new()
        .value("kind", kind)
        .optional("period", period)
        .column("state", &attractor.state)
        .column("points", attractor.points.as_flattened());
    if period.is_none() {
        return record.value("multipliers", JsValue::NULL);
    }
    record.record("multipliers", Record::new().column("re", &attractor.re).column("im", &attractor.im))
}
