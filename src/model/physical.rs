//! A real gear pair in SI units, made dimensionless and back: (12) corrected, (13), (16), (20), (21).
//!
//! Two departures from the paper as printed. The equivalent mass obeys `1/M = r_p^2/I_p + r_g^2/I_g`, as (3) and (4)
//! demand; (12) has the inertias exchanged. And (16) divides the loads by `b` as it divides the displacements.

use std::f64::consts::TAU;

use crate::error::ModelError;
use crate::model::parameters::{Parameters, Value};

/// One physical quantity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct QuantityInfo {
    /// Its name; case matters.
    pub name: &'static str,
    /// Its SI unit.
    pub unit: &'static str,
    /// Value when not given; none: it is needed, or follows from others.
    pub default: Option<f64>,
    /// Whether there is no answer without it.
    pub needed: bool,
    /// Least allowed value.
    pub low: f64,
    /// Greatest allowed value.
    pub high: f64,
    /// What it means.
    pub meaning: &'static str,
}

const fn needed(name: &'static str, unit: &'static str, meaning: &'static str) -> QuantityInfo {
    QuantityInfo { name, unit, default: None, needed: true, low: 1e-12, high: 1e15, meaning }
}

const fn zero_unless_given(
    name: &'static str,
    unit: &'static str,
    low: f64,
    meaning: &'static str,
) -> QuantityInfo {
    QuantityInfo { name, unit, default: Some(0.0), needed: false, low, high: 1e18, meaning }
}

const fn follows(name: &'static str, unit: &'static str, low: f64, meaning: &'static str) -> QuantityInfo {
    QuantityInfo { name, unit, default: None, needed: false, low, high: 1e15, meaning }
}

/// The table of physical quantities.
pub const QUANTITIES: [QuantityInfo; 28] = [
    needed("M_p", "kg", "mass of the pinion's body"),
    needed("M_g", "kg", "mass of the gear's body"),
    needed("I_p", "kg m^2", "moment of inertia of the pinion"),
    needed("I_g", "kg m^2", "moment of inertia of the gear"),
    needed("r_p", "m", "base radius of the pinion"),
    needed("r_g", "m", "base radius of the gear"),
    needed("K", "N/m", "mean mesh stiffness"),
    zero_unless_given("K_amplitude", "N/m", 0.0, "amplitude of the mesh stiffness's pulsation"),
    needed("K_p", "N/m", "stiffness of the pinion's support"),
    needed("K_g", "N/m", "stiffness of the gear's support"),
    zero_unless_given("K_p3", "N/m^3", -1e18, "cubic stiffness of the pinion's support"),
    zero_unless_given("K_g3", "N/m^3", -1e18, "cubic stiffness of the gear's support"),
    zero_unless_given("C", "N s/m", 0.0, "damping of the mesh"),
    zero_unless_given("C_p", "N s/m", 0.0, "damping of the pinion's support"),
    zero_unless_given("C_g", "N s/m", 0.0, "damping of the gear's support"),
    needed("b", "m", "half the backlash"),
    zero_unless_given("E", "m", -1e15, "amplitude of the static transmission error"),
    zero_unless_given("T_p", "N m", -1e15, "mean torque on the pinion"),
    follows("T_g", "N m", -1e15, "mean torque on the gear; balances the pinion's when not given"),
    zero_unless_given("T_p_amplitude", "N m", -1e15, "amplitude of the pinion's torque fluctuation"),
    zero_unless_given("T_g_amplitude", "N m", -1e15, "amplitude of the gear's torque fluctuation"),
    follows(
        "omega_p",
        "rad/s",
        1e-12,
        "frequency of the pinion's torque fluctuation; its shaft speed when not given",
    ),
    follows(
        "omega_g",
        "rad/s",
        1e-12,
        "frequency of the gear's torque fluctuation; its shaft speed when not given",
    ),
    needed("teeth_p", "1", "number of teeth of the pinion"),
    follows(
        "teeth_g",
        "1",
        1.0,
        "number of teeth of the gear; in the ratio of the base radii when not given",
    ),
    needed("rpm_p", "1/min", "speed of the pinion"),
    follows("rpm_g", "1/min", 1e-12, "speed of the gear; only given back"),
    follows("mesh_frequency", "Hz", 1e-12, "teeth meeting in a second; only given back"),
];

/// Names of [`QUANTITIES`] that are answers, never input.
pub const ONLY_GIVEN_BACK: [&str; 2] = ["rpm_g", "mesh_frequency"];

/// How far the gear's torque may be from balancing the pinion's, relative to it.
const BALANCED_WITHIN: f64 = 1e-9;

/// What carries dimensionless numbers back to SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scales {
    /// Equivalent mass, kg.
    pub mass: f64,
    /// Natural frequency of the mesh, rad/s (13).
    pub omega_n: f64,
    /// Half the backlash, m.
    pub half_backlash: f64,
    /// Geometry that speeds and torques need; without it they are not given back.
    pub geometry: Option<Geometry>,
}

/// Sizes that neither the model nor its scales hold.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Geometry {
    /// Base radius of the pinion, m.
    pub r_p: f64,
    /// Base radius of the gear, m.
    pub r_g: f64,
    /// Moment of inertia of the pinion, kg m^2.
    pub inertia_p: f64,
    /// Moment of inertia of the gear, kg m^2.
    pub inertia_g: f64,
    /// Teeth of the pinion.
    pub teeth_p: f64,
    /// Teeth of the gear.
    pub teeth_g: f64,
}

/// Equivalent mass, (12) corrected: `I_p I_g / (I_g r_p^2 + I_p r_g^2)`, kg.
pub fn equivalent_mass(inertia_p: f64, inertia_g: f64, r_p: f64, r_g: f64) -> f64 {
    inertia_p * inertia_g / (inertia_g * r_p * r_p + inertia_p * r_g * r_g)
}

/// Equivalent mass as printed in (12), with the inertias exchanged in the denominator, kg.
pub fn equivalent_mass_printed(inertia_p: f64, inertia_g: f64, r_p: f64, r_g: f64) -> f64 {
    inertia_p * inertia_g / (inertia_p * r_p * r_p + inertia_g * r_g * r_g)
}

/// Natural frequency of the mesh (13): `sqrt(K/M)`, rad/s.
pub fn natural_frequency(stiffness: f64, mass: f64) -> f64 {
    (stiffness / mass).sqrt()
}

/// Damping ratio (13), (21): `C / (2 sqrt(K M))`, dimensionless.
pub fn damping_ratio(damping: f64, stiffness: f64, mass: f64) -> f64 {
    damping / (2.0 * (stiffness * mass).sqrt())
}

/// Mesh frequency from teeth and speed: `teeth_p rpm_p / 60`, Hz.
pub fn mesh_frequency(teeth_p: f64, rpm_p: f64) -> f64 {
    teeth_p * rpm_p / 60.0
}

/// The given quantities by their place in [`QUANTITIES`].
struct Given([Option<f64>; QUANTITIES.len()]);

impl Given {
    fn read<'a>(values: impl IntoIterator<Item = (&'a str, Value)>) -> Result<Self, ModelError> {
        let mut given = [None; QUANTITIES.len()];
        for (name, value) in values {
            let place = QUANTITIES
                .iter()
                .position(|info| info.name == name && !ONLY_GIVEN_BACK.contains(&name))
                .ok_or_else(|| ModelError::UnknownParameter { name: name.into() })?;
            let QuantityInfo { low, high, .. } = QUANTITIES[place];
            let parameter = name.to_string();
            given[place] = Some(match value {
                Value::Number(number) if number.is_finite() && (low..=high).contains(&number) => number,
                Value::Number(given) if given.is_finite() => {
                    return Err(ModelError::OutOfRange { parameter, given, low, high });
                }
                Value::Number(given) => {
                    return Err(ModelError::NotANumber { parameter, given: given.to_string(), low, high });
                }
                Value::Text(given) => {
                    return Err(ModelError::NotANumber {
                        parameter,
                        given: format!("\"{given}\""),
                        low,
                        high,
                    });
                }
            });
        }
        for (info, value) in QUANTITIES.iter().zip(&given) {
            if info.needed && value.is_none() {
                return Err(ModelError::Missing { parameter: info.name });
            }
        }
        Ok(Self(given))
    }

    fn get(&self, name: &str) -> Option<f64> {
        let place = QUANTITIES.iter().position(|info| info.name == name)?;
        self.0[place].or(QUANTITIES[place].default)
    }

    fn value(&self, name: &str) -> f64 {
        self.get(name).unwrap_or(0.0)
    }
}

/// A real gear pair as parameters of the model, in the backlash regime, which is the true one.
///
/// # Errors
/// [`ModelError`] for a quantity that is unknown, missing, no finite number or out of range, for torques that do
/// not balance, and where a dimensionless parameter comes out of its own range.
pub fn from_physical<'a>(
    values: impl IntoIterator<Item = (&'a str, Value)>,
) -> Result<(Parameters, Scales), ModelError> {
    let si = Given::read(values)?;
    let value = |name: &str| si.value(name);
    let (r_p, r_g, inertia_p, inertia_g) = (value("r_p"), value("r_g"), value("I_p"), value("I_g"));
    let (stiffness, b) = (value("K"), value("b"));
    let mass = equivalent_mass(inertia_p, inertia_g, r_p, r_g);
    let omega_n = natural_frequency(stiffness, mass);
    let torque_p = value("T_p");
    let balanced = torque_p * r_g / r_p;
    let torque_g = si.get("T_g").unwrap_or(balanced);
    if (torque_g - balanced).abs() > BALANCED_WITHIN * balanced.abs().max(torque_g.abs()) {
        return Err(ModelError::UnbalancedTorque { given: torque_g, balanced });
    }
    let teeth_p = value("teeth_p");
    let teeth_g = si.get("teeth_g").unwrap_or(teeth_p * r_g / r_p);
    let shaft_p = TAU * value("rpm_p") / 60.0;
    let omega_p = si.get("omega_p").unwrap_or(shaft_p);
    let omega_g = si.get("omega_g").unwrap_or(shaft_p * teeth_p / teeth_g);
    let ratio = |damping: &str| damping_ratio(value(damping), stiffness, mass);
    // A torque as a force over K b, (12) and (16).
    let force = |torque: f64, r: f64, inertia: f64| mass * torque * r / (stiffness * inertia * b);
    let numbers = [
        ("m_p", value("M_p") / mass),
        ("m_g", value("M_g") / mass),
        ("k_p", value("K_p") / stiffness),
        ("k_g", value("K_g") / stiffness),
        ("alpha_p", b * b * value("K_p3") / stiffness),
        ("alpha_g", b * b * value("K_g3") / stiffness),
        ("zeta", ratio("C")),
        ("zeta_p", ratio("C_p")),
        ("zeta_g", ratio("C_g")),
        ("k0", value("K_amplitude") / stiffness),
        ("Omega", TAU * mesh_frequency(teeth_p, value("rpm_p")) / omega_n),
        ("F", force(torque_p, r_p, inertia_p) + force(torque_g, r_g, inertia_g)),
        ("F_p", force(value("T_p_amplitude"), r_p, inertia_p)),
        ("F_g", force(value("T_g_amplitude"), r_g, inertia_g)),
        ("E", value("E") / b),
        ("Omega_p", omega_p / omega_n),
        ("Omega_g", omega_g / omega_n),
    ];
    let regime = ("regime", Value::Text("backlash".into()));
    let named = numbers.into_iter().map(|(name, number)| (name, Value::Number(number)));
    let parameters = Parameters::from_named(named.chain([regime]))?;
    let geometry = Geometry { r_p, r_g, inertia_p, inertia_g, teeth_p, teeth_g };
    Ok((parameters, Scales { mass, omega_n, half_backlash: b, geometry: Some(geometry) }))
}

/// Parameters of the model as physical quantities, by the names of [`QUANTITIES`]; speeds, radii and torques only
/// where the scales hold the geometry.
///
/// Forces `F`, `F_p`, `F_g` in newtons are given as well, under these names.
///
/// # Errors
/// [`ModelError::OutOfRange`] for a scale that is not above zero.
pub fn to_physical(p: &Parameters, scales: &Scales) -> Result<Vec<(&'static str, f64)>, ModelError> {
    for (parameter, given) in [("M", scales.mass), ("omega_n", scales.omega_n), ("b", scales.half_backlash)] {
        if !(given > 0.0 && given.is_finite()) {
            return Err(ModelError::OutOfRange {
                parameter: parameter.into(),
                given,
                low: 1e-12,
                high: 1e15,
            });
        }
    }
    let Scales { mass, omega_n, half_backlash: b, geometry } = *scales;
    let stiffness = mass * omega_n * omega_n;
    let damping = 2.0 * (stiffness * mass).sqrt();
    let newton = stiffness * b;
    let mesh_hertz = p.omega * omega_n / TAU;
    let mut quantities = vec![
        ("M_p", p.m_p * mass),
        ("M_g", p.m_g * mass),
        ("K", stiffness),
        ("K_amplitude", p.k0 * stiffness),
        ("K_p", p.k_p * stiffness),
        ("K_g", p.k_g * stiffness),
        ("K_p3", p.alpha_p * stiffness / (b * b)),
        ("K_g3", p.alpha_g * stiffness / (b * b)),
        ("C", p.zeta * damping),
        ("C_p", p.zeta_p * damping),
        ("C_g", p.zeta_g * damping),
        ("b", b),
        ("E", p.error * b),
        ("omega_p", p.omega_p * omega_n),
        ("omega_g", p.omega_g * omega_n),
        ("mesh_frequency", mesh_hertz),
        ("F", p.load * newton),
        ("F_p", p.load_p * newton),
        ("F_g", p.load_g * newton),
    ];
    if let Some(Geometry { r_p, r_g, inertia_p, inertia_g, teeth_p, teeth_g }) = geometry {
        let rpm_p = 60.0 * mesh_hertz / teeth_p;
        quantities.extend([
            ("I_p", inertia_p),
            ("I_g", inertia_g),
            ("r_p", r_p),
            ("r_g", r_g),
            ("teeth_p", teeth_p),
            ("teeth_g", teeth_g),
            ("rpm_p", rpm_p),
            ("rpm_g", rpm_p * teeth_p / teeth_g),
            // With balanced torques F K b is the tooth force itself.
            ("T_p", p.load * newton * r_p),
            ("T_g", p.load * newton * r_g),
            ("T_p_amplitude", p.load_p * newton * inertia_p / (mass * r_p)),
            ("T_g_amplitude", p.load_g * newton * inertia_g / (mass * r_g)),
        ]);
    }
    Ok(quantities)
}

#[cfg(test)]
mod tests {
    use super::*;

    const PAIR: [(&str, f64); 24] = [
        ("M_p", 0.8),
        ("M_g", 1.9),
        ("I_p", 4e-4),
        ("I_g", 2.5e-3),
        ("r_p", 0.03),
        ("r_g", 0.06),
        ("K", 2e8),
        ("K_amplitude", 6e7),
        ("K_p", 5e8),
        ("K_g", 7e8),
        ("K_p3", -1e16),
        ("K_g3", 2e16),
        ("C", 900.0),
        ("C_p", 700.0),
        ("C_g", 800.0),
        ("b", 5e-5),
        ("E", 1e-6),
        ("T_p", 120.0),
        ("T_p_amplitude", 10.0),
        ("T_g_amplitude", 15.0),
        ("teeth_p", 20.0),
        ("teeth_g", 40.0),
        ("rpm_p", 3000.0),
        ("omega_g", 250.0),
    ];

    fn given(pairs: &[(&'static str, f64)]) -> Vec<(&'static str, Value)> {
        pairs.iter().map(|(name, number)| (*name, Value::Number(*number))).collect()
    }

    #[test]
    fn there_and_back_again() {
        let (parameters, scales) = from_physical(given(&PAIR)).expect("valid");
        let back = to_physical(&parameters, &scales).expect("valid");
        for (name, number) in PAIR {
            let (_, again) = back.iter().find(|(other, _)| *other == name).expect("given back");
            assert!((again / number - 1.0).abs() < 1e-12, "{name}: {number} came back as {again}");
        }
        let find = |name: &str| back.iter().find(|(other, _)| *other == name).map(|(_, value)| *value);
        assert!((find("mesh_frequency").expect("given back") - 1000.0).abs() < 1e-9);
        assert!((find("rpm_g").expect("given back") - 1500.0).abs() < 1e-9);
        // T_p / r_p = 4000 N is the tooth force.
        assert!((find("F").expect("given back") - 4000.0).abs() < 1e-8);
    }

    #[test]
    fn the_corrected_mass_follows_from_the_torsional_equations() {
        // (3) and (4) without supports: r_p theta_p'' - r_g theta_g'' = -(r_p^2/I_p + r_g^2/I_g) force.
        let (inertia_p, inertia_g, r_p, r_g) = (4e-4, 2.5e-3, 0.03, 0.06);
        let expected = 1.0 / (r_p * r_p / inertia_p + r_g * r_g / inertia_g);
        assert!((equivalent_mass(inertia_p, inertia_g, r_p, r_g) / expected - 1.0).abs() < 1e-14);
        assert!((equivalent_mass_printed(inertia_p, inertia_g, r_p, r_g) / expected - 1.0).abs() > 0.1);
    }

    #[test]
    fn bad_input_is_named() {
        let without =
            |name: &str| given(&PAIR).into_iter().filter(|(other, _)| *other != name).collect::<Vec<_>>();
        assert_eq!(from_physical(without("K")), Err(ModelError::Missing { parameter: "K" }));
        let plus = |name: &'static str, value: Value| {
            let mut all = given(&PAIR);
            all.push((name, value));
            from_physical(all).expect_err("refused")
        };
        assert!(matches!(plus("T_g", Value::Number(1.0)), ModelError::UnbalancedTorque { .. }));
        assert!(matches!(plus("mass", Value::Number(1.0)), ModelError::UnknownParameter { .. }));
        assert!(matches!(plus("K", Value::Number(f64::INFINITY)), ModelError::NotANumber { .. }));
        assert!(matches!(plus("r_p", Value::Number(-1.0)), ModelError::OutOfRange { .. }));
        assert!(matches!(plus("b", Value::Text("wide".into())), ModelError::NotANumber { .. }));
        // The dimensionless frequency has a range of its own.
        assert!(
            matches!(plus("rpm_p", Value::Number(1e9)), ModelError::OutOfRange { parameter, .. } if parameter == "Omega")
        );
    }
}
