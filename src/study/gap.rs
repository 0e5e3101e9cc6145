//! Motions inside the tooth gap. The teeth exert no force there, whatever u is, so that of one such motion all that have
//! its u displaced are motions too: periodic ones come as a continuous family, of which each has a multiplier of one. Without
//! load these are the rests, `u_p = u_g = 0` at any u from -1 to 1.

use crate::model::equations::U;
use crate::model::parameters::{Parameters, Regime};

/// How exactly the map must keep a displacement of u for a motion to count as one that nowhere touches the teeth.
const KEPT: f64 = 1e-12;
/// The other multipliers of a family that attracts are below one by more; without mesh damping a second one is at one too,
/// and rounding moves the two apart by its square root.
const INSIDE: f64 = 1e-7;

/// Whether a derivative of the stroboscopic map is that along a motion which nowhere touches the teeth: a displacement of
/// u is kept as it is, so that Newton's method has nothing by which to choose u.
pub(super) fn keeps_displacement(derivative: &[[f64; 6]; 6]) -> bool {
    derivative.iter().enumerate().all(|(row, entries)| {
        let kept = f64::from(u8::from(row == U));
        (entries[U] - kept).abs() < KEPT
    })
}

/// Whether an orbit with these extremes of u is one of a family inside the gap that attracts what is near it: its greatest
/// multiplier is the one of the family, and what counts is the modulus of the second.
pub(super) fn is_family(p: &Parameters, [min, max]: [f64; 2], second_modulus: f64) -> bool {
    p.regime == Regime::Backlash && p.zeta > 0.0 && min > -1.0 && max < 1.0 && second_modulus < 1.0 - INSIDE
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::equations::GearPair;
    use crate::model::parameters::Value;
    use crate::study::multipliers::{Budget, image};
    use crate::study::orbit::{OrbitOptions, PeriodicOrbit, periodic_orbit};
    use crate::study::time_response::largest_difference;

    fn parameters(given: &[(&str, f64)]) -> Parameters {
        let mut named: Vec<(&str, Value)> =
            given.iter().map(|(name, value)| (*name, Value::Number(*value))).collect();
        named.push(("regime", Value::Text("backlash".into())));
        Parameters::from_named(named).expect("allowed")
    }

    fn orbit_near(p: &Parameters, guess: [f64; 6]) -> PeriodicOrbit {
        let options = OrbitOptions { period: 1, guess: Some(guess), tolerance: 1e-10 };
        periodic_orbit(p, &options).expect("converges")
    }

    #[test]
    fn only_a_motion_that_touches_no_tooth_keeps_a_displacement() {
        let p = parameters(&[]);
        let derivative = |state: [f64; 6]| {
            image(&GearPair::new(&p), &state, 1, 1e-10, 1.0, &Budget::default()).expect("integrates").1
        };
        assert!(keeps_displacement(&derivative([0.05, -0.05, 0.3, 0.0, 0.0, 0.01])));
        assert!(!keeps_displacement(&derivative([0.05, -0.05, 1.1, 0.0, 0.0, 0.0])));
    }

    #[test]
    fn newtons_method_finds_the_rest_that_a_motion_comes_to() {
        let p = parameters(&[]);
        let orbit = orbit_near(&p, [0.01, -0.01, 0.2, 0.0, 0.0, 0.0]);
        assert!(orbit.stable, "{orbit:?}");
        assert!((orbit.re[0] - 1.0).abs() < 1e-12 && orbit.re[1].hypot(orbit.im[1]) < 0.93, "{orbit:?}");
        assert!(orbit.state[U] > 0.1 && orbit.state[U] < 0.25, "{orbit:?}");
        let elsewhere = largest_difference(&orbit.state, &[0.0, 0.0, orbit.state[U], 0.0, 0.0, 0.0]);
        assert!(elsewhere < 1e-10, "{orbit:?}");
    }
}
