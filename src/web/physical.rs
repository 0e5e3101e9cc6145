//! A real gear pair in SI units, made dimensionless and back.

use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::error::ModelError;
use crate::model::parameters::Value;
use crate::model::physical::{self, Geometry, ONLY_GIVEN_BACK, QUANTITIES, QuantityInfo, Scales};
use crate::study::ErrorEstimate;
use crate::web::columns::{Record, parameters_record};
use crate::web::errors::WebError;
use crate::web::{options, values};

/// Range of a scale, in its SI unit.
const SCALE: (f64, f64) = (1e-12, 1e15);
/// What the scales object must hold, and what it may: all of it or none.
const NEEDED: [&str; 3] = ["M", "omega_n", "b"];
const GEOMETRY: [&str; 6] = ["r_p", "r_g", "I_p", "I_g", "teeth_p", "teeth_g"];

/// A real gear pair to parameters and scales: `fromPhysical(si)`.
///
/// # Errors
/// The plain object of a `GearError`.
#[wasm_bindgen(js_name = fromPhysical)]
pub fn from_physical(si: &JsValue) -> Result<JsValue, JsValue> {
    let taken: Vec<&QuantityInfo> =
        QUANTITIES.iter().filter(|quantity| !ONLY_GIVEN_BACK.contains(&quantity.name)).collect();
    let names: Vec<&str> = taken.iter().map(|quantity| quantity.name).collect();
    let mut named = Vec::new();
    for (name, value) in values::properties("si", si)? {
        let quantity = taken.iter().find(|quantity| quantity.name == name);
        let range = quantity.map(|quantity| (quantity.low, quantity.high));
        let value = options::number_value(&name, &value, range).map_err(|error| error.among(&names))?;
        named.push((name, value));
    }
    let (parameters, scales) =
        physical::from_physical(named.iter().map(|(name, value)| (name.as_str(), value.clone())))
            .map_err(WebError::from)?;
    let record = Record::new()
        .record("params", parameters_record(&parameters))
        .record("scales", scales_record(&scales))
        .provenance("(12) corrected, (13), (16), (20), (21)", &ErrorEstimate::default());
    Ok(record.finish()?)
}

/// Parameters and scales back to a real gear pair: `toPhysical(params, scales)`.
///
/// # Errors
/// The plain object of a `GearError`.
#[wasm_bindgen(js_name = toPhysical)]
pub fn to_physical(params: &JsValue, scales: &JsValue) -> Result<JsValue, JsValue> {
    let parameters = options::parameters(params)?;
    let scales = read_scales(scales)?;
    let quantities = physical::to_physical(&parameters, &scales).map_err(WebError::from)?;
    let record = quantities.iter().fold(Record::new(), |record, (name, value)| record.number(name, *value));
    Ok(record.finish()?)
}

fn scales_record(scales: &Scales) -> Record {
    let record = Record::new()
        .number("M", scales.mass)
        .number("omega_n", scales.omega_n)
        .number("b", scales.half_backlash);
    match scales.geometry {
        None => record,
        Some(geometry) => record
            .number("r_p", geometry.r_p)
            .number("r_g", geometry.r_g)
            .number("I_p", geometry.inertia_p)
            .number("I_g", geometry.inertia_g)
            .number("teeth_p", geometry.teeth_p)
            .number("teeth_g", geometry.teeth_g),
    }
}

fn read_scales(scales: &JsValue) -> Result<Scales, WebError> {
    let mut given = Vec::new();
    for (name, value) in values::properties("scales", scales)? {
        let known = NEEDED.into_iter().chain(GEOMETRY).find(|known| *known == name);
        let number = options::number_value(&name, &value, known.map(|_| SCALE))
            .map_err(|error| error.among(&[NEEDED.as_slice(), GEOMETRY.as_slice()].concat()))?;
        if let (Some(known), Value::Number(number)) = (known, number) {
            if !(SCALE.0..=SCALE.1).contains(&number) {
                let (low, high) = SCALE;
                return Err(ModelError::OutOfRange { parameter: name, given: number, low, high }.into());
            }
            given.push((known, number));
        }
    }
    let find = |name: &'static str| {
        let number = given.iter().find(|(known, _)| *known == name).map(|(_, number)| *number);
        number.ok_or(WebError::from(ModelError::Missing { parameter: name }))
    };
    let has_geometry = given.iter().any(|(known, _)| GEOMETRY.contains(known));
    let geometry = if has_geometry {
        Some(Geometry {
            r_p: find("r_p")?,
            r_g: find("r_g")?,
            inertia_p: find("I_p")?,
            inertia_g: find("I_g")?,
            teeth_p: find("teeth_p")?,
            teeth_g: find("teeth_g")?,
        })
    } else {
        None
    };
    Ok(Scales { mass: find("M")?, omega_n: find("omega_n")?, half_backlash: find("b")?, geometry })
}
