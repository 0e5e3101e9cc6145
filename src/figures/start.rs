//! The state from which a figure's motion starts, as numbers beside the parameters: `u_p0`, `u_dot0` and so on.

use crate::error::ModelError;
use crate::model::parameters::{ParameterInfo, Parameters, Scale, Value};
use crate::study::motion::default_state;

/// Largest number of a start; whether a motion can begin there its study says.
const LARGEST: f64 = 1e6;

const fn line(name: &'static str, symbol: &'static str, meaning: &'static str) -> ParameterInfo {
    ParameterInfo {
        name,
        symbol,
        default: 0.0,
        follows: None,
        short: None,
        low: -LARGEST,
        high: LARGEST,
        slider: (-5.0, 5.0),
        scale: Scale::Linear,
        meaning,
    }
}

/// The numbers of a start, in the order of a state. What is not given is as where a motion starts when nothing is said.
pub static START: [ParameterInfo; 6] = [
    line("u_p0", "*u*_{p}(0)", "the pinion's displacement at the start, over half the backlash"),
    line("u_g0", "*u*_{g}(0)", "the gear's displacement at the start, over half the backlash"),
    line("u0", "*u*(0)", "transmission error at the start, over half the backlash"),
    line("u_p_dot0", "*u*_{p}'(0)", "the pinion's velocity at the start"),
    line("u_g_dot0", "*u*_{g}'(0)", "the gear's velocity at the start"),
    line("u_dot0", "*u*'(0)", "rate of the transmission error at the start"),
];

/// A start as it was given: each number or none.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Start([Option<f64>; 6]);

impl Start {
    /// The name of the first number that was given, if one was.
    pub(super) fn first(&self) -> Option<&'static str> {
        START.iter().zip(self.0).find_map(|(info, value)| value.map(|_| info.name))
    }

    /// The state that it says, where it says any: what it leaves open is as if nothing were said.
    pub(super) fn state(&self, p: &Parameters) -> Option<[f64; 6]> {
        self.first()?;
        let usual = default_state(p);
        Some(std::array::from_fn(|index| self.0[index].unwrap_or(usual[index])))
    }
}

/// The start among the values given, and the rest of them.
///
/// # Errors
/// [`ModelError::NotANumber`] or [`ModelError::OutOfRange`], naming the number of the start.
pub(super) fn split(given: &[(String, Value)]) -> Result<(Start, Vec<(String, Value)>), ModelError> {
    let mut start = Start::default();
    let mut rest = Vec::with_capacity(given.len());
    for (name, value) in given {
        let Some(index) = START.iter().position(|info| info.name == name) else {
            rest.push((name.clone(), value.clone()));
            continue;
        };
        let (parameter, low, high) = (name.clone(), -LARGEST, LARGEST);
        start.0[index] = match value {
            Value::Number(given) if given.abs() <= LARGEST => Some(*given),
            Value::Number(given) if given.is_finite() => {
                return Err(ModelError::OutOfRange { parameter, given: *given, low, high });
            }
            Value::Number(given) => {
                return Err(ModelError::NotANumber { parameter, given: given.to_string(), low, high });
            }
            Value::Text(given) => {
                return Err(ModelError::NotANumber { parameter, given: format!("\"{given}\""), low, high });
            }
        };
    }
    Ok((start, rest))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_start_leaves_open_is_as_if_nothing_were_said() {
        let p = Parameters::default();
        let number = |name: &str, value: f64| (name.to_owned(), Value::Number(value));
        let (start, rest) = split(&[number("u0", 0.3), number("Omega", 2.0)]).expect("valid");
        assert_eq!(start.state(&p), Some([-0.02, 0.02, 0.3, 0.0, 0.0, 0.0]));
        assert_eq!(rest, [number("Omega", 2.0)]);
        assert_eq!(split(&rest).expect("valid").0.state(&p), None);
        assert!(matches!(split(&[number("u0", f64::NAN)]), Err(ModelError::NotANumber { .. })));
        assert!(matches!(split(&[number("u_dot0", 2e6)]), Err(ModelError::OutOfRange { .. })));
    }
}
