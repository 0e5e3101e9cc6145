//! Results on their way to JavaScript: plain objects with `Float64Array` columns, and no number that is not finite.
//!
//! What fills them is called hundreds of times, and seldom: what is not inlined is compiled once.

use wasm_bindgen::JsValue;
use web_sys::js_sys::{Array, Float64Array, Object, Uint32Array};

use crate::model::parameters::Parameters;
use crate::study::ErrorEstimate;
use crate::web::errors::WebError;
use crate::web::values;

/// A plain object that is being filled. It remembers the first number that is not finite, and is then refused.
pub struct Record {
    object: Object,
    not_finite: Option<String>,
}

impl Record {
    /// An empty object.
    pub fn new() -> Self {
        Self { object: Object::new(), not_finite: None }
    }

    /// A copy, whose lists are those of the first.
    pub fn copied(&self) -> Self {
        Self { object: Object::assign(&Object::new(), &self.object), not_finite: self.not_finite.clone() }
    }

    /// Any value.
    #[must_use]
    pub fn value(self, name: &str, value: impl Into<JsValue>) -> Self {
        self.put(name, &value.into())
    }

    #[inline(never)]
    fn put(self, name: &str, value: &JsValue) -> Self {
        values::set(&self.object, name, value);
        self
    }

    /// A number.
    #[must_use]
    #[inline(never)]
    pub fn number(mut self, name: &str, number: f64) -> Self {
        self.check(name, &[number]);
        self.value(name, number)
    }

    /// A number, or null.
    #[must_use]
    #[inline(never)]
    pub fn optional(self, name: &str, number: Option<f64>) -> Self {
        match number {
            Some(number) => self.number(name, number),
            None => self.value(name, JsValue::NULL),
        }
    }

    /// A column as a `Float64Array`.
    #[must_use]
    #[inline(never)]
    pub fn column(mut self, name: &str, numbers: &[f64]) -> Self {
        self.check(name, numbers);
        self.value(name, Float64Array::new_from_slice(numbers))
    }

    /// Whole numbers as a `Uint32Array`.
    #[must_use]
    #[inline(never)]
    pub fn indices(self, name: &str, indices: &[usize]) -> Self {
        let indices: Vec<u32> =
            indices.iter().map(|index| u32::try_from(*index).unwrap_or(u32::MAX)).collect();
        self.value(name, Uint32Array::new_from_slice(&indices))
    }

    /// The six coordinates of states, each a column of its own.
    #[must_use]
    #[inline(never)]
    pub fn states(mut self, states: &[[f64; 6]]) -> Self {
        const NAMES: [&str; 6] = ["u_p", "u_g", "u", "u_p_dot", "u_g_dot", "u_dot"];
        let mut column = Vec::with_capacity(states.len());
        for (coordinate, name) in NAMES.iter().enumerate() {
            column.clear();
            column.extend(states.iter().map(|state| state[coordinate]));
            self = self.column(name, &column);
        }
        self
    }

    /// Another record; what is not finite in it is not finite in this one.
    #[must_use]
    #[inline(never)]
    pub fn record(mut self, name: &str, inner: Self) -> Self {
        if let (None, Some(within)) = (&self.not_finite, &inner.not_finite) {
            self.not_finite = Some(format!("{name}.{within}"));
        }
        self.value(name, inner.object)
    }

    /// A list of records.
    #[must_use]
    pub fn list(mut self, name: &str, inner: impl IntoIterator<Item = Self>) -> Self {
        let list = Array::new();
        for record in inner {
            if let (None, Some(within)) = (&self.not_finite, &record.not_finite) {
                self.not_finite = Some(format!("{name}.{within}"));
            }
            list.push(&record.object);
        }
        self.value(name, list)
    }

    /// Texts as an array.
    #[must_use]
    pub fn texts<'a>(self, name: &str, texts: impl IntoIterator<Item = &'a str>) -> Self {
        let list = Array::new();
        for text in texts {
            list.push(&text.into());
        }
        self.value(name, list)
    }

    /// A pair of numbers as an array.
    #[must_use]
    #[inline(never)]
    pub fn pair(mut self, name: &str, pair: (f64, f64)) -> Self {
        self.check(name, &[pair.0, pair.1]);
        self.value(name, Array::of2(&pair.0.into(), &pair.1.into()))
    }

    /// How it was computed and how far to trust it: part of every result.
    #[must_use]
    #[inline(never)]
    pub fn provenance(self, method: &str, error: &ErrorEstimate) -> Self {
        let mut estimates = Self::new();
        for (name, estimate) in
            [("liouville", error.liouville), ("step", error.step), ("residual", error.residual)]
        {
            if let Some(estimate) = estimate {
                estimates = estimates.number(name, estimate);
            }
        }
        self.value("method", method).record("error", estimates)
    }

    /// The finished object.
    ///
    /// # Errors
    /// `internal`, naming the first number that is not finite.
    #[inline(never)]
    pub fn finish(self) -> Result<JsValue, WebError> {
        match self.not_finite {
            None => Ok(self.object.into()),
            Some(name) => Err(WebError::internal(format!("the result's {name} is no finite number"))),
        }
    }

    fn check(&mut self, name: &str, numbers: &[f64]) {
        if self.not_finite.is_none() && numbers.iter().any(|number| !number.is_finite()) {
            self.not_finite = Some(name.into());
        }
    }
}

/// Records as an array.
///
/// # Errors
/// `internal`, naming the first number that is not finite.
pub fn array(records: impl IntoIterator<Item = Record>) -> Result<JsValue, WebError> {
    let array = Array::new();
    for record in records {
        array.push(&record.finish()?);
    }
    Ok(array.into())
}

/// Every parameter by its full name, and the regime.
pub fn parameters_record(parameters: &Parameters) -> Record {
    parameters
        .named()
        .iter()
        .fold(Record::new(), |record, (name, value)| record.number(name, *value))
        .value("regime", parameters.regime.name())
}
