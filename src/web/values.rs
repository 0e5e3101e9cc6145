//! Reading values that come from JavaScript, whatever they are: nothing here can throw, panic or run away.
//!
//! Every property is read once. A getter or a proxy that throws is an error like any other wrong value.

use wasm_bindgen::{JsCast, JsValue};
use web_sys::js_sys::{Array, ArrayBuffer, Float64Array, Object, Reflect, Uint32Array};

use crate::web::errors::{Given, WebError, number_words};

/// Sets a property of an object of our own making; that cannot fail.
#[inline(never)]
pub fn set(object: &Object, name: &str, value: &JsValue) {
    let _ = Reflect::set(object, &name.into(), value);
}

/// What a value is, to be told to the one who gave it.
pub fn given(value: &JsValue) -> Given {
    if let Some(number) = value.as_f64() {
        return Given::Number(number);
    }
    if let Some(text) = value.as_string() {
        return Given::Text(shortened(&text));
    }
    Given::Words(kind(value).into())
}

/// The same for the middle of a sentence.
pub fn given_words(value: &JsValue) -> String {
    if let Some(number) = value.as_f64() {
        return number_words(number);
    }
    value.as_string().map_or_else(|| kind(value).into(), |text| format!("\"{}\"", shortened(&text)))
}

/// What kind of value it is, asking the value itself nothing.
fn kind(value: &JsValue) -> &'static str {
    if value.is_undefined() {
        "undefined"
    } else if value.is_null() {
        "null"
    } else if let Some(truth) = value.as_bool() {
        if truth { "true" } else { "false" }
    } else if value.is_bigint() {
        "a BigInt"
    } else if value.is_symbol() {
        "a symbol"
    } else if value.is_function() {
        "a function"
    } else if value.is_string() {
        "a text"
    } else {
        "an object"
    }
}

/// A text short enough for a sentence.
fn shortened(text: &str) -> String {
    const LONGEST: usize = 80;
    if text.chars().count() <= LONGEST {
        return text.into();
    }
    text.chars().take(LONGEST - 3).chain("...".chars()).collect()
}

/// Whether a value was left out.
pub fn is_absent(value: &JsValue) -> bool {
    value.is_undefined()
}

/// A plain object's own properties, each read once: names in their order, and values.
///
/// # Errors
/// `not-an-object`, naming `what`, for anything that is no plain object, or that throws when it is read.
pub fn properties(what: &str, value: &JsValue) -> Result<Vec<(String, JsValue)>, WebError> {
    // More names than any call has, and few enough to be looked at one by one.
    const MOST: u32 = 256;
    if !is_plain_object(value) {
        return Err(WebError::not_an_object(what, given(value)));
    }
    let unreadable = || WebError::not_an_object(what, Given::Words("an object that cannot be read".into()));
    let keys = Reflect::own_keys(value).map_err(|_| unreadable())?;
    if keys.length() > MOST {
        return Err(WebError::not_an_object(what, Given::Words(format!("one of {} names", keys.length()))));
    }
    let mut properties = Vec::new();
    for key in keys.iter() {
        let Some(name) = key.as_string() else {
            return Err(WebError::not_an_object(what, Given::Words("one with a symbol for a name".into())));
        };
        let property = Reflect::get(value, &key).map_err(|_| unreadable())?;
        properties.push((name, property));
    }
    Ok(properties)
}

/// An object whose prototype is `Object.prototype` of any frame, or none: no array, map, date or class.
fn is_plain_object(value: &JsValue) -> bool {
    if !value.is_object() || value.is_function() {
        return false;
    }
    let prototype_of = |value: &JsValue| Reflect::get_prototype_of(value).map(JsValue::from).ok();
    match prototype_of(value) {
        None => false,
        Some(prototype) if prototype.is_null() => true,
        Some(prototype) => prototype_of(&prototype).is_some_and(|root| root.is_null()),
    }
}

/// Numbers from a `Float64Array` or a `Uint32Array`, or one by one from anything with a length: at most `most` of
/// them.
///
/// # Errors
/// In words, what was given instead.
pub fn numbers(value: &JsValue, most: usize) -> Result<Vec<f64>, Given> {
    if !value.is_object() {
        return Err(given(value));
    }
    let length = list_length(value, most)?;
    if ArrayBuffer::is_view(value)
        && (value.is_instance_of::<Float64Array>() || value.is_instance_of::<Uint32Array>())
    {
        return copied(value, most);
    }
    let mut numbers = Vec::with_capacity(length);
    for index in 0..length {
        let element = item(value, index)?;
        match element.as_f64() {
            Some(number) => numbers.push(number),
            None => return Err(Given::Words(format!("{} among the numbers", given_words(&element)))),
        }
    }
    Ok(numbers)
}

/// The numbers of a view, by way of a copy that JavaScript makes: memory that has been given away is then an error and no
/// exception that runs through us, and the copy has the length it says, whatever was done to the view.
fn copied(view: &JsValue, most: usize) -> Result<Vec<f64>, Given> {
    let constructor = Object::from(Float64Array::new_with_length(0)).constructor();
    let copy = Reflect::construct(&constructor, &Array::of1(view))
        .map_err(|_| Given::Words("a view of memory that is gone".into()))?;
    let numbers = copy.unchecked_into::<Float64Array>().to_vec();
    if numbers.len() <= most {
        Ok(numbers)
    } else {
        Err(Given::Words(format!("a list of {}", numbers.len())))
    }
}

/// The length of a list-like object, at most `most`.
///
/// # Errors
/// In words, what was given instead.
pub fn list_length(value: &JsValue, most: usize) -> Result<usize, Given> {
    if !value.is_object() || value.is_function() {
        return Err(given(value));
    }
    let length = Reflect::get(value, &"length".into()).ok().and_then(|length| length.as_f64());
    match length {
        Some(length) if length >= 0.0 && length.fract() == 0.0 => {
            if length <= most as f64 {
                Ok(length as usize)
            } else {
                Err(Given::Words(format!("a list of {length}")))
            }
        }
        _ => Err(given(value)),
    }
}

/// One element of a list-like object.
///
/// # Errors
/// In words, what was found instead.
pub fn item(value: &JsValue, index: usize) -> Result<JsValue, Given> {
    Reflect::get_u32(value, u32::try_from(index).unwrap_or(u32::MAX))
        .map_err(|_| Given::Words("a list that cannot be read".into()))
}
