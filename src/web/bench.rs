//! What measurements need, and the test of a trap; reachable as the hidden `gear.bench`, no part of the contract.

use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::model::parameters::Parameters;
use crate::study::multipliers::multipliers;
use crate::study::time_response::{TimeResponseOptions, time_response};
use crate::web::errors::{Allowed, WebError};
use crate::web::values;

/// The jobs, for the error.
const JOBS: &str = "multipliers, timeResponse, trap";
/// Tolerance of the measured jobs.
const TOLERANCE: f64 = 1e-10;

/// Does a job `repetitions` times without crossing the boundary in between, and answers a number that depends on
/// every one of them: `multipliers` (one monodromy and its multipliers to 1e-10), `timeResponse` (100 mesh periods to
/// 1e-10), `trap` (what a fault of ours would do).
///
/// # Errors
/// The plain object of a `GearError`.
#[wasm_bindgen]
pub fn bench(job: &JsValue, repetitions: &JsValue) -> Result<f64, JsValue> {
    let repetitions = match repetitions.as_f64() {
        Some(number) if (1.0..=1e6).contains(&number) => number as usize,
        _ => {
            let given = values::given(repetitions);
            return Err(WebError::option("repetitions", given, Allowed::Range(1.0, 1e6)).into());
        }
    };
    let work = match job.as_string().as_deref() {
        Some("multipliers") => one_monodromy,
        Some("timeResponse") => hundred_periods,
        Some("trap") => core::arch::wasm32::unreachable(),
        _ => {
            return Err(WebError::option("job", values::given(job), Allowed::Text(JOBS.into())).into());
        }
    };
    let mut sum = 0.0;
    for repetition in 0..repetitions {
        // No two alike, so that nothing can be done once for all.
        sum += work(1e-9 * repetition as f64)?;
    }
    Ok(sum)
}

fn one_monodromy(shift: f64) -> Result<f64, WebError> {
    let defaults = Parameters::default();
    let parameters = Parameters { omega: defaults.omega + shift, ..defaults };
    Ok(multipliers(&parameters, TOLERANCE)?.spectral_radius)
}

fn hundred_periods(shift: f64) -> Result<f64, WebError> {
    let defaults = Parameters::default();
    let parameters = Parameters { omega: 1.65 + shift, ..defaults };
    let usual = TimeResponseOptions::new(&parameters);
    let asked = TimeResponseOptions { periods: 100.0, samples_per_period: 1, tolerance: TOLERANCE, ..usual };
    let answer = time_response(&parameters, &asked)?;
    Ok(answer.states.last().map_or(0.0, |state| state[0]))
}
