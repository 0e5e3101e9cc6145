//! What several integration tests share: the reference numbers, and generated parameters.
#![allow(dead_code, reason = "every test file uses a part of it")]

use gear_bifurcations::model::parameters::{Parameters, Value};
use serde_json::Value as Json;

/// A file of `tests/reference`; its origin is told in `tests/reference/README.md`.
pub fn reference(name: &str) -> Json {
    let path = format!("{}/tests/reference/{name}.json", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"));
    serde_json::from_str(&text).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// Parameters from a JSON object of numbers and words.
pub fn parameters(given: &Json) -> Parameters {
    let pairs = given.as_object().expect("an object").iter().map(|(name, value)| {
        let value = match value {
            Json::Number(number) => Value::Number(number.as_f64().expect("a number")),
            Json::String(word) => Value::Text(word.clone()),
            other => panic!("{name}: {other}"),
        };
        (name.as_str(), value)
    });
    Parameters::from_named(pairs).expect("valid")
}

/// Parameters from names and numbers.
pub fn numbers(given: &[(&str, f64)]) -> Parameters {
    Parameters::from_named(given.iter().map(|(name, value)| (*name, Value::Number(*value)))).expect("valid")
}

/// Numbers of a JSON array.
pub fn floats(array: &Json) -> Vec<f64> {
    array.as_array().expect("an array").iter().map(|value| value.as_f64().expect("a number")).collect()
}

/// A small generator of reproducible numbers in [0, 1): SplitMix64 (Steele, Lea, Flood 2014).
pub struct Generator(pub u64);

impl Generator {
    /// The next number in [0, 1).
    pub fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        bits ^= bits >> 31;
        (bits >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// The next number in [low, high).
    pub fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }
}
