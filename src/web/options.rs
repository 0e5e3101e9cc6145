//! Parameters and options as they come from JavaScript, checked by name, type and range before anything is done.

use wasm_bindgen::JsValue;

use crate::error::ModelError;
use crate::figures::START;
use crate::model::parameters::{Parameters, Regime, Value, info};
use crate::study::grid::{Grid, MOST_VALUES};
use crate::study::motion::TOLERANCE;
use crate::web::errors::{Allowed, Given, WebError, number_words};
use crate::web::values;

/// Largest absolute value of a coordinate of a state.
pub const LARGEST_COORDINATE: f64 = 1e6;

/// The default tolerance.
pub const DEFAULT_TOLERANCE: f64 = 1e-10;

/// Names and values of a parameters object, in its order; nothing given is no parameters.
///
/// # Errors
/// `not-an-object`, `unknown-parameter`, `not-a-number` or `not-a-choice`. Ranges are checked by the model.
pub fn named_values(params: &JsValue) -> Result<Vec<(String, Value)>, WebError> {
    if values::is_absent(params) {
        return Ok(Vec::new());
    }
    values::properties("parameters", params)?
        .into_iter()
        .map(|(name, value)| {
            let value = parameter_value(&name, &value)?;
            Ok((name, value))
        })
        .collect()
}

fn parameter_value(name: &str, value: &JsValue) -> Result<Value, WebError> {
    if name == "regime" {
        return value.as_string().map(Value::Text).ok_or_else(|| {
            let given = values::given_words(value);
            ModelError::NotAChoice { parameter: name.into(), given, allowed: &Regime::NAMES }.into()
        });
    }
    let info = info(name).or_else(|| START.iter().find(|info| info.name == name));
    number_value(name, value, info.map(|info| (info.low, info.high)))
}

/// A finite number by the name of a parameter or quantity with this range; without a range there is no such name.
///
/// # Errors
/// `unknown-parameter` or `not-a-number`. The range is checked by the model.
pub fn number_value(name: &str, value: &JsValue, range: Option<(f64, f64)>) -> Result<Value, WebError> {
    let Some((low, high)) = range else {
        return Err(ModelError::UnknownParameter { name: name.into() }.into());
    };
    value.as_f64().filter(|number| number.is_finite()).map(Value::Number).ok_or_else(|| {
        let given = values::given_words(value);
        ModelError::NotANumber { parameter: name.into(), given, low, high }.into()
    })
}

/// The parameters of the model from a parameters object.
///
/// # Errors
/// As [`named_values`], and those of [`Parameters::from_named`].
pub fn parameters(params: &JsValue) -> Result<Parameters, WebError> {
    let named = named_values(params)?;
    Ok(Parameters::from_named(named.iter().map(|(name, value)| (name.as_str(), value.clone())))?)
}

/// The same from the `params` of a figure object, which hold a start as well where the figure takes one.
///
/// # Errors
/// As [`parameters`].
pub fn parameters_and_start(params: &JsValue) -> Result<(Parameters, Option<[f64; 6]>), WebError> {
    let named = named_values(params)?;
    let is_start = |name: &str| START.iter().position(|info| info.name == name);
    let mut start = None;
    for (name, value) in &named {
        if let (Some(index), Value::Number(value)) = (is_start(name), value) {
            start.get_or_insert([0.0; 6])[index] = *value;
        }
    }
    let rest = named.iter().filter(|(name, _)| is_start(name).is_none());
    Ok((Parameters::from_named(rest.map(|(name, value)| (name.as_str(), value.clone())))?, start))
}

/// An options object whose names are known. `undefined` as a value is as if the option were not there.
pub struct Options {
    given: Vec<(String, JsValue)>,
}

impl Options {
    /// Reads an options object that may hold these names.
    ///
    /// # Errors
    /// `not-an-object`, or `option` for a name that is not known.
    pub fn read(options: &JsValue, known: &[&str]) -> Result<Self, WebError> {
        Self::read_named("options", options, known)
    }

    fn read_named(what: &str, options: &JsValue, known: &[&str]) -> Result<Self, WebError> {
        if values::is_absent(options) {
            return Ok(Self { given: Vec::new() });
        }
        let given = values::properties(what, options)?;
        match given.iter().find(|(name, _)| !known.contains(&name.as_str())) {
            Some((name, _)) => Err(WebError::unknown_option(name, known)),
            None => Ok(Self { given }),
        }
    }

    fn get(&self, name: &str) -> Option<&JsValue> {
        self.given
            .iter()
            .find(|(given, value)| given == name && !values::is_absent(value))
            .map(|(_, value)| value)
    }

    /// A number from `range`, ends included.
    ///
    /// # Errors
    /// `option`.
    pub fn number(&self, name: &str, range: (f64, f64), default: f64) -> Result<f64, WebError> {
        let Some(value) = self.get(name) else { return Ok(default) };
        value
            .as_f64()
            .filter(|number| range.0 <= *number && *number <= range.1)
            .ok_or_else(|| WebError::option(name, values::given(value), Allowed::Range(range.0, range.1)))
    }

    /// A whole number from `range`, ends included.
    ///
    /// # Errors
    /// `option`.
    pub fn whole(&self, name: &str, range: (usize, usize), default: usize) -> Result<usize, WebError> {
        let Some(value) = self.get(name) else { return Ok(default) };
        let (low, high) = (range.0 as f64, range.1 as f64);
        match value.as_f64() {
            Some(number) if low <= number && number <= high && number.fract() == 0.0 => Ok(number as usize),
            Some(number) if low <= number && number <= high => {
                let allowed = Allowed::Text(format!("a whole number from {low} to {high}"));
                Err(WebError::option(name, values::given(value), allowed))
            }
            _ => Err(WebError::option(name, values::given(value), Allowed::Range(low, high))),
        }
    }

    /// The tolerance of an integration.
    ///
    /// # Errors
    /// `option`.
    pub fn tolerance(&self) -> Result<f64, WebError> {
        self.number("tolerance", TOLERANCE, DEFAULT_TOLERANCE)
    }

    /// A state: six finite numbers `(u_p, u_g, u, u_p', u_g', u')`.
    ///
    /// # Errors
    /// `option`.
    pub fn state(&self, name: &str) -> Result<Option<[f64; 6]>, WebError> {
        let Some(value) = self.get(name) else { return Ok(None) };
        let allowed =
            || Allowed::Text(format!("six numbers, each from -{LARGEST_COORDINATE} to {LARGEST_COORDINATE}"));
        let numbers = values::numbers(value, 6).map_err(|given| WebError::option(name, given, allowed()))?;
        if let Some(bad) = numbers.iter().find(|number| number.is_nan() || number.abs() > LARGEST_COORDINATE)
        {
            return Err(WebError::option(name, Given::Number(*bad), allowed()));
        }
        let length = numbers.len();
        <[f64; 6]>::try_from(numbers)
            .map(Some)
            .map_err(|_| WebError::option(name, Given::Words(format!("{length} numbers")), allowed()))
    }

    /// Two numbers `[low, high]` within `allowed`, the first below the second.
    ///
    /// # Errors
    /// `option`.
    pub fn range(&self, name: &str, default: [f64; 2], allowed: [f64; 2]) -> Result<[f64; 2], WebError> {
        let Some(value) = self.get(name) else { return Ok(default) };
        let [least, most] = allowed;
        let words = || {
            let (least, most) = (number_words(least), number_words(most));
            Allowed::Text(format!("[low, high] with {least} <= low < high <= {most}"))
        };
        let numbers = values::numbers(value, 2).map_err(|given| WebError::option(name, given, words()))?;
        match numbers.as_slice() {
            &[low, high] if least <= low && low < high && high <= most => Ok([low, high]),
            given => Err(WebError::option(name, listed(given), words())),
        }
    }

    /// An evenly spaced grid `[low, high, number]` within `allowed`; it must be given.
    ///
    /// # Errors
    /// `option`.
    pub fn grid(&self, name: &'static str, allowed: [f64; 2]) -> Result<Grid, WebError> {
        let words = || {
            let [least, most] = allowed.map(number_words);
            let counts = format!("a whole number from 2 to {MOST_VALUES}");
            Allowed::Text(format!("[low, high, number] with {least} <= low <= high <= {most} and {counts}"))
        };
        let absent = JsValue::UNDEFINED;
        let value = self.get(name).unwrap_or(&absent);
        let numbers = values::numbers(value, 3).map_err(|given| WebError::option(name, given, words()))?;
        match numbers.as_slice() {
            &[low, high, count] if count.fract() == 0.0 && (1.0..=MOST_VALUES as f64).contains(&count) => {
                Ok(Grid::new(name, [low, high], count as usize, allowed)?)
            }
            given => Err(WebError::option(name, listed(given), words())),
        }
    }

    /// A text of at most 80 characters.
    ///
    /// # Errors
    /// `option`, saying that it is one of `choices`.
    pub fn word(&self, name: &str, choices: &str) -> Result<Option<String>, WebError> {
        let Some(value) = self.get(name) else { return Ok(None) };
        match value.as_string() {
            Some(word) if word.len() <= 80 => Ok(Some(word)),
            _ => Err(WebError::option(name, values::given(value), Allowed::Text(choices.into()))),
        }
    }

    /// The value as it was given; `undefined` where it was not.
    pub fn value(&self, name: &str) -> JsValue {
        self.get(name).cloned().unwrap_or(JsValue::UNDEFINED)
    }

    /// Two different names out of a list, as indices in it.
    ///
    /// # Errors
    /// `option`.
    pub fn names(&self, name: &str, known: &[&str], default: [usize; 2]) -> Result<[usize; 2], WebError> {
        let Some(value) = self.get(name) else { return Ok(default) };
        let wrong = || {
            let allowed = Allowed::Text(format!("two different ones of {}", known.join(", ")));
            WebError::option(name, values::given(value), allowed)
        };
        if values::list_length(value, 2).ok() != Some(2) {
            return Err(wrong());
        }
        let index = |at: usize| {
            let word = values::item(value, at).ok()?.as_string()?;
            known.iter().position(|known| *known == word)
        };
        match (index(0), index(1)) {
            (Some(first), Some(second)) if first != second => Ok([first, second]),
            _ => Err(wrong()),
        }
    }

    /// At most `most` texts.
    ///
    /// # Errors
    /// `option`.
    pub fn texts(&self, name: &str, most: usize) -> Result<Vec<String>, WebError> {
        let Some(value) = self.get(name) else { return Ok(Vec::new()) };
        let wrong =
            |given| WebError::option(name, given, Allowed::Text(format!("a list of at most {most} texts")));
        let length = values::list_length(value, most).map_err(wrong)?;
        (0..length)
            .map(|index| {
                let item = values::item(value, index).map_err(wrong)?;
                item.as_string().ok_or_else(|| wrong(values::given(&item)))
            })
            .collect()
    }

    /// Options within each property of an option, by the property's name, in their order.
    ///
    /// # Errors
    /// `not-an-object`, or `option` for a name that is not known.
    pub fn nested_each(&self, name: &str, known: &[&str]) -> Result<Vec<(String, Self)>, WebError> {
        let Some(value) = self.get(name) else { return Ok(Vec::new()) };
        let own = values::properties(name, value)?;
        own.into_iter()
            .map(|(key, value)| {
                let options = Self::read_named(&format!("{name}.{key}"), &value, known)?;
                Ok((key, options))
            })
            .collect()
    }

    /// Two numbers, where they were given.
    ///
    /// # Errors
    /// `option`, for anything but two numbers. Whether they are sound is for others to say.
    pub fn ends(&self, name: &str) -> Result<Option<[f64; 2]>, WebError> {
        let Some(value) = self.get(name) else { return Ok(None) };
        let wrong = |given| WebError::option(name, given, Allowed::Text("[low, high]".into()));
        let numbers = values::numbers(value, 2).map_err(wrong)?;
        match numbers.as_slice() {
            &[low, high] => Ok(Some([low, high])),
            given => Err(wrong(listed(given))),
        }
    }

    /// Options within an option.
    ///
    /// # Errors
    /// `not-an-object`, or `option` for a name that is not known.
    pub fn nested(&self, name: &str, known: &[&str]) -> Result<Self, WebError> {
        match self.get(name) {
            None => Ok(Self { given: Vec::new() }),
            Some(value) => Self::read_named(name, value, known),
        }
    }
}

/// Numbers as they were given, for a sentence.
fn listed(numbers: &[f64]) -> Given {
    let words: Vec<String> = numbers.iter().map(|number| number_words(*number)).collect();
    Given::Words(format!("[{}]", words.join(", ")))
}
