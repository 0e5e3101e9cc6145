//! What measurements need, and the test of a trap; reachable as the hidden `gear.bench`, no part of the contract.

use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::study::benchmark;
use crate::web::errors::{Allowed, WebError};
use crate::web::values;

/// The job that ends as a fault of ours would: in a trap.
const TRAP: &str = "trap";

/// Does a job of [`benchmark::JOBS`] `repetitions` times without crossing the boundary in between, and answers a number
/// that depends on every one of them; or traps.
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
    match job.as_string().as_deref() {
        Some(TRAP) => core::arch::wasm32::unreachable(),
        Some(job) => Ok(benchmark::run(job, repetitions).map_err(WebError::from)?),
        None => {
            let allowed = Allowed::Text(benchmark::JOBS.map(|job| job.name).join(", "));
            Err(WebError::option("job", values::given(job), allowed).into())
        }
    }
}
