//! A part of a figure object that is read back, with the path by which an error names it.

use wasm_bindgen::JsValue;
use web_sys::js_sys::Reflect;

use crate::web::errors::{Given, WebError};
use crate::web::values;

/// A value somewhere within a figure object.
pub struct Part {
    path: String,
    value: JsValue,
}

impl Part {
    /// The value itself, at its root.
    pub fn root(value: JsValue) -> Self {
        Self { path: "the object".into(), value }
    }

    /// A property; `undefined` where there is none.
    ///
    /// # Errors
    /// `drawing`, where this is no object or cannot be read.
    pub fn get(&self, name: &str) -> Result<Self, WebError> {
        if !self.value.is_object() {
            return Err(self.wrong("an object"));
        }
        let value = Reflect::get(&self.value, &name.into())
            .map_err(|_| WebError::drawing(name, Given::Words("something unreadable".into()), "readable"))?;
        let path = if self.path == "the object" { name.to_string() } else { format!("{}.{name}", self.path) };
        Ok(Self { path, value })
    }

    /// The elements of a list.
    ///
    /// # Errors
    /// `drawing`, where this is no list or has more than `most` elements.
    pub fn list(&self, most: usize) -> Result<Vec<Self>, WebError> {
        let allowed = || format!("a list of at most {most}");
        let length = values::list_length(&self.value, most)
            .map_err(|given| WebError::drawing(&self.path, given, &allowed()))?;
        (0..length)
            .map(|index| {
                let value = values::item(&self.value, index)
                    .map_err(|given| WebError::drawing(&self.path, given, &allowed()))?;
                Ok(Self { path: format!("{}[{index}]", self.path), value })
            })
            .collect()
    }

    /// Whether there is nothing here.
    pub fn is_nothing(&self) -> bool {
        self.value.is_undefined() || self.value.is_null()
    }

    /// A text of at most `longest` bytes.
    ///
    /// # Errors
    /// `drawing`.
    pub fn text(&self, longest: usize) -> Result<String, WebError> {
        match self.value.as_string() {
            Some(text) if text.len() <= longest => Ok(text),
            _ => Err(self.wrong(&format!("a text of at most {longest} bytes"))),
        }
    }

    /// A finite number.
    ///
    /// # Errors
    /// `drawing`.
    pub fn number(&self) -> Result<f64, WebError> {
        self.value.as_f64().filter(|number| number.is_finite()).ok_or_else(|| self.wrong("a finite number"))
    }

    /// True or false.
    ///
    /// # Errors
    /// `drawing`.
    pub fn truth(&self) -> Result<bool, WebError> {
        self.value.as_bool().ok_or_else(|| self.wrong("true or false"))
    }

    /// A whole number from `low` to `high`.
    ///
    /// # Errors
    /// `drawing`.
    pub fn whole(&self, low: usize, high: usize) -> Result<usize, WebError> {
        match self.value.as_f64() {
            Some(number) if number.fract() == 0.0 && low as f64 <= number && number <= high as f64 => {
                Ok(number as usize)
            }
            _ => Err(self.wrong(&format!("a whole number from {low} to {high}"))),
        }
    }

    /// Two whole numbers from `low` to `high`.
    ///
    /// # Errors
    /// `drawing`.
    pub fn whole_pair(&self, low: usize, high: usize) -> Result<(usize, usize), WebError> {
        match self.list(2)?.as_slice() {
            [first, second] => Ok((first.whole(low, high)?, second.whole(low, high)?)),
            _ => Err(self.wrong("two whole numbers")),
        }
    }

    /// At most `most` finite numbers.
    ///
    /// # Errors
    /// `drawing`.
    pub fn numbers(&self, most: usize) -> Result<Vec<f64>, WebError> {
        let allowed = format!("at most {most} finite numbers");
        let numbers = values::numbers(&self.value, most)
            .map_err(|given| WebError::drawing(&self.path, given, &allowed))?;
        match numbers.iter().find(|number| !number.is_finite()) {
            Some(bad) => Err(WebError::drawing(&self.path, Given::Number(*bad), &allowed)),
            None => Ok(numbers),
        }
    }

    /// The raw value.
    pub fn value(&self) -> &JsValue {
        &self.value
    }

    /// The error that says what this must be.
    pub fn wrong(&self, allowed: &str) -> WebError {
        WebError::drawing(&self.path, values::given(&self.value), allowed)
    }

    /// The error that says what this must be, where the value itself is not worth repeating.
    pub fn unfit(&self, given: &str, allowed: &str) -> WebError {
        WebError::drawing(&self.path, Given::Words(given.into()), allowed)
    }
}
