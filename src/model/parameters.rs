//! The parameters of the model: one table from which validation, controls, documentation and defaults all come.
//!
//! All are dimensionless, as in (22) of the paper: lengths over half the backlash `b`, time times the natural
//! frequency `omega_n`, masses over the equivalent mass `M`, stiffnesses over the mean mesh stiffness `K`.

mod table;

pub use table::{ParameterInfo, SHORT_FORMS, Scale, ShortForm, TABLE};

use crate::error::ModelError;

/// Mesh regime: what the tooth force is a function of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Regime {
    /// (25) with nothing on its right-hand side: the deviation from the unloaded state, `f(u) = u`.
    Homogeneous,
    /// (25): the teeth never separate, `f(u) = u - 1`. True only while `u > 1`.
    Contact,
    /// (22) with the dead zone `|u| <= 1` of (23).
    Backlash,
}

impl Regime {
    /// The words by which the regimes are named.
    pub const NAMES: [&'static str; 3] = ["homogeneous", "contact", "backlash"];

    /// The regime's name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Homogeneous => "homogeneous",
            Self::Contact => "contact",
            Self::Backlash => "backlash",
        }
    }

    /// The regime of that name.
    ///
    /// # Errors
    /// [`ModelError::NotAChoice`] where there is none.
    pub fn from_name(name: &str) -> Result<Self, ModelError> {
        match name {
            "homogeneous" => Ok(Self::Homogeneous),
            "contact" => Ok(Self::Contact),
            "backlash" => Ok(Self::Backlash),
            _ => Err(ModelError::NotAChoice {
                parameter: "regime".into(),
                given: name.into(),
                allowed: &Self::NAMES,
            }),
        }
    }
}

/// Every parameter by its full name. All finite and within the ranges of [`TABLE`] when made by
/// [`Parameters::from_named`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs, reason = "TABLE holds name, symbol, range, unit and meaning of each")]
pub struct Parameters {
    pub m_p: f64,
    pub m_g: f64,
    pub k_p: f64,
    pub k_g: f64,
    pub alpha_p: f64,
    pub alpha_g: f64,
    pub zeta: f64,
    pub zeta_p: f64,
    pub zeta_g: f64,
    pub k0: f64,
    pub omega: f64,
    pub load: f64,
    pub load_p: f64,
    pub load_g: f64,
    pub error: f64,
    pub omega_p: f64,
    pub omega_g: f64,
    pub regime: Regime,
}

/// A value as it comes from outside: a number, or a word.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// A number, finite or not.
    Number(f64),
    /// Anything else, as text.
    Text(String),
}

/// Equal supports (24): what the paper's formulas take.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Symmetric {
    /// Mass of each body.
    pub m: f64,
    /// Stiffness of each support.
    pub k: f64,
    /// Cubic stiffness of each support, as in (25): the paper's formulas from (27) on use `alpha / k0`.
    pub alpha: f64,
    /// Damping ratio of the mesh.
    pub zeta: f64,
    /// Damping ratio of each support.
    pub zeta_s: f64,
    /// Depth of the pulsation, the paper's epsilon.
    pub k0: f64,
    /// Mesh frequency.
    pub omega: f64,
}

impl Default for Parameters {
    fn default() -> Self {
        let value =
            |name: &str| TABLE.iter().find(|info| info.name == name).map_or(f64::NAN, |info| info.default);
        Self {
            m_p: value("m_p"),
            m_g: value("m_g"),
            k_p: value("k_p"),
            k_g: value("k_g"),
            alpha_p: value("alpha_p"),
            alpha_g: value("alpha_g"),
            zeta: value("zeta"),
            zeta_p: value("zeta_p"),
            zeta_g: value("zeta_g"),
            k0: value("k0"),
            omega: value("Omega"),
            load: value("F"),
            load_p: value("F_p"),
            load_g: value("F_g"),
            error: value("E"),
            omega_p: value("Omega_p"),
            omega_g: value("Omega_g"),
            regime: Regime::Homogeneous,
        }
    }
}

/// The line of the table that holds this name; a short form answers with the first parameter it sets.
pub fn info(name: &str) -> Option<&'static ParameterInfo> {
    let full = SHORT_FORMS.iter().find(|form| form.name == name).map_or(name, |form| form.sets[0]);
    TABLE.iter().find(|info| info.name == full)
}

fn number(name: &str, value: &Value) -> Result<f64, ModelError> {
    let info = info(name).ok_or_else(|| ModelError::UnknownParameter { name: name.into() })?;
    let (low, high) = (info.low, info.high);
    let not_a_number = |given: String| ModelError::NotANumber { parameter: name.into(), given, low, high };
    match value {
        Value::Text(given) => Err(not_a_number(format!("\"{given}\""))),
        Value::Number(given) if !given.is_finite() => Err(not_a_number(given.to_string())),
        Value::Number(given) if *given < low || *given > high => {
            Err(ModelError::OutOfRange { parameter: name.into(), given: *given, low, high })
        }
        Value::Number(given) => Ok(*given),
    }
}

impl Parameters {
    /// Parameters from names and values, in any order; a full name beats its short form, a name given twice
    /// takes its last value, and what is not given takes its default.
    ///
    /// # Errors
    /// A [`ModelError`] that names the first parameter that is unknown, no finite number or out of range, or a
    /// load in the homogeneous regime. Nothing is guessed.
    pub fn from_named<'a>(values: impl IntoIterator<Item = (&'a str, Value)>) -> Result<Self, ModelError> {
        let mut full = [None; TABLE.len()];
        let mut by_short_form = [None; TABLE.len()];
        let mut regime = Regime::Homogeneous;
        for (name, value) in values {
            if name == "regime" {
                regime = match value {
                    Value::Text(word) => Regime::from_name(&word)?,
                    Value::Number(given) => Regime::from_name(&given.to_string())?,
                };
                continue;
            }
            let given = Some(number(name, &value)?);
            for (index, info) in TABLE.iter().enumerate() {
                if info.name == name {
                    full[index] = given;
                } else if info.short == Some(name) {
                    by_short_form[index] = given;
                }
            }
        }
        let own = |name: &str| {
            let index = TABLE.iter().position(|info| info.name == name)?;
            full[index].or(by_short_form[index])
        };
        let value = |name: &str| {
            let info = info(name);
            own(name).or_else(|| own(info?.follows?)).or_else(|| Some(info?.default)).unwrap_or(f64::NAN)
        };
        let parameters = Self {
            m_p: value("m_p"),
            m_g: value("m_g"),
            k_p: value("k_p"),
            k_g: value("k_g"),
            alpha_p: value("alpha_p"),
            alpha_g: value("alpha_g"),
            zeta: value("zeta"),
            zeta_p: value("zeta_p"),
            zeta_g: value("zeta_g"),
            k0: value("k0"),
            omega: value("Omega"),
            load: value("F"),
            load_p: value("F_p"),
            load_g: value("F_g"),
            error: value("E"),
            omega_p: value("Omega_p"),
            omega_g: value("Omega_g"),
            regime,
        };
        parameters.refuse_load_in_homogeneous()?;
        Ok(parameters)
    }

    fn refuse_load_in_homogeneous(&self) -> Result<(), ModelError> {
        if self.regime != Regime::Homogeneous {
            return Ok(());
        }
        for (parameter, given) in
            [("F", self.load), ("F_p", self.load_p), ("F_g", self.load_g), ("E", self.error)]
        {
            if given != 0.0 {
                return Err(ModelError::LoadInHomogeneous { parameter, given });
            }
        }
        Ok(())
    }

    /// Every number by its full name, in the order of [`TABLE`].
    pub fn named(&self) -> [(&'static str, f64); TABLE.len()] {
        [
            ("m_p", self.m_p),
            ("m_g", self.m_g),
            ("k_p", self.k_p),
            ("k_g", self.k_g),
            ("alpha_p", self.alpha_p),
            ("alpha_g", self.alpha_g),
            ("zeta", self.zeta),
            ("zeta_p", self.zeta_p),
            ("zeta_g", self.zeta_g),
            ("k0", self.k0),
            ("Omega", self.omega),
            ("F", self.load),
            ("F_p", self.load_p),
            ("F_g", self.load_g),
            ("E", self.error),
            ("Omega_p", self.omega_p),
            ("Omega_g", self.omega_g),
        ]
    }

    /// The equal supports that the paper's formulas take (24).
    ///
    /// # Errors
    /// [`ModelError::Asymmetric`] with the first pair that differs.
    pub fn symmetric(&self) -> Result<Symmetric, ModelError> {
        for (parameter, pinion, gear) in [
            ("m", self.m_p, self.m_g),
            ("k", self.k_p, self.k_g),
            ("alpha", self.alpha_p, self.alpha_g),
            ("zeta", self.zeta_p, self.zeta_g),
        ] {
            if pinion != gear {
                return Err(ModelError::Asymmetric { parameter, pinion, gear });
            }
        }
        Ok(Symmetric {
            m: self.m_p,
            k: self.k_p,
            alpha: self.alpha_p,
            zeta: self.zeta,
            zeta_s: self.zeta_p,
            k0: self.k0,
            omega: self.omega,
        })
    }

    /// Mesh period `T = 2 pi / Omega`.
    pub fn mesh_period(&self) -> f64 {
        std::f64::consts::TAU / self.omega
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn defaults_are_within_their_ranges_and_named_in_order() {
        let parameters = Parameters::from_named([]).expect("defaults are valid");
        assert_eq!(parameters, Parameters::default());
        for (info, (name, value)) in TABLE.iter().zip(parameters.named()) {
            assert_eq!(info.name, name);
            assert_eq!(info.default, value);
            assert!(info.low <= value && value <= info.high, "{name}");
            assert!(info.low <= info.slider.0 && info.slider.1 <= info.high, "{name}");
        }
    }

    #[test]
    fn a_full_name_beats_its_short_form_in_either_order() {
        let five = |name| (name, Value::Number(5.0));
        let seven = |name| (name, Value::Number(7.0));
        for values in [[five("k"), seven("k_g")], [seven("k_g"), five("k")]] {
            let parameters = Parameters::from_named(values).expect("valid");
            assert_eq!((parameters.k_p, parameters.k_g), (5.0, 7.0));
            assert_eq!(
                parameters.symmetric(),
                Err(ModelError::Asymmetric { parameter: "k", pinion: 5.0, gear: 7.0 })
            );
        }
    }

    #[test]
    fn followers_follow_unless_given() {
        let parameters = Parameters::from_named([
            ("zeta", Value::Number(0.1)),
            ("zeta_g", Value::Number(0.3)),
            ("Omega", Value::Number(2.0)),
        ])
        .expect("valid");
        assert_eq!((parameters.zeta_p, parameters.zeta_g), (0.1, 0.3));
        assert_eq!((parameters.omega_p, parameters.omega_g), (2.0, 2.0));
    }

    #[test]
    fn bad_values_are_named_with_what_was_given_and_what_is_allowed() {
        let refused = |name, value| Parameters::from_named([(name, value)]).expect_err("refused");
        assert_eq!(
            refused("k0", Value::Number(1.5)),
            ModelError::OutOfRange { parameter: "k0".into(), given: 1.5, low: 0.0, high: 1.0 }
        );
        assert!(
            matches!(refused("m", Value::Number(f64::NAN)), ModelError::NotANumber { parameter, .. } if parameter == "m")
        );
        assert!(matches!(refused("zeta", Value::Text("a lot".into())), ModelError::NotANumber { .. }));
        assert!(
            matches!(refused("omega", Value::Number(1.0)), ModelError::UnknownParameter { name } if name == "omega")
        );
        assert!(matches!(refused("regime", Value::Text("free".into())), ModelError::NotAChoice { .. }));
        assert!(matches!(
            refused("F", Value::Number(1.5)),
            ModelError::LoadInHomogeneous { parameter: "F", .. }
        ));
    }
}
