//! Motions inside the tooth gap. The teeth exert no force there, whatever u is, so that of one such motion all that have
//! its u displaced are motions too: periodic ones come as a continuous family, of which each has a multiplier of one. Without
//! load these are the rests, `u_p = u_g = 0` at any u from -1 to 1.
//!
//! By the equations of motion inside the gap the deviations from one of them keep the sum
//!
//! ```text
//! u' - u_p' + u_g' + 2 zeta u = 2 zeta u_end,   so that with q = u_p - u_g and z = u - u_end:   z' = q' - 2 zeta z
//! ```
//!
//! which tells of a motion that touches the teeth no more at which member of the family it ends. As damping only takes
//! energy, `|q|` stays within a reach that the energy has, and `|z|` within the sum of two: that reach, and the greater of
//! it and of `|z - q|` at the start.

use super::orbit::{OrbitOptions, PeriodicOrbit, periodic_orbit};
use crate::model::equations::{U, U_DOT};
use crate::model::parameters::{Parameters, Regime};

/// How exactly the map must keep a displacement of u for a motion to count as one that nowhere touches the teeth.
const KEPT: f64 = 1e-12;
/// The other multipliers of a family that attracts are below one by more; without mesh damping a second one is at one too,
/// and rounding moves the two apart by its square root.
const INSIDE: f64 = 1e-7;
/// Motions that reach the teeth by less only graze them.
const GRAZING: f64 = 1e-6;
/// What rounding may add to the way of a motion inside the gap.
const ROUNDING: f64 = 1e-9;

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

/// A family of orbits inside the gap that attracts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Gap {
    /// How far the orbit in the middle can be displaced without touching the teeth.
    room: f64,
}

impl Gap {
    /// The family to which an orbit belongs, and its orbit in the middle of the gap; none where the orbit touches the
    /// teeth, or does not attract.
    pub(super) fn of(p: &Parameters, orbit: &PeriodicOrbit, tolerance: f64) -> Option<(Self, PeriodicOrbit)> {
        let within = orbit.min[U] > -1.0 - GRAZING && orbit.max[U] < 1.0 + GRAZING;
        if p.regime != Regime::Backlash || !within {
            return None;
        }
        let mut guess = orbit.state;
        guess[U] -= 0.5 * (orbit.min[U] + orbit.max[U]);
        let options = OrbitOptions { period: orbit.period, guess: Some(guess), tolerance };
        let middle = periodic_orbit(p, &options).ok()?;
        let extremes = [middle.min[U], middle.max[U]];
        let room = 1.0 + extremes[0].min(-extremes[1]);
        is_family(p, extremes, middle.re[1].hypot(middle.im[1])).then_some((Self { room }, middle))
    }

    /// Whether a motion ends in the family for certain, touching the teeth no more: it is at this state when the orbit in
    /// the middle is at that point. About a motion whose supports have a cubic part this is as good as that part is small.
    pub(super) fn holds(self, p: &Parameters, point: &[f64; 6], state: &[f64; 6]) -> bool {
        let aside: [f64; 6] = std::array::from_fn(|i| state[i] - point[i]);
        let turning = aside[U_DOT] - aside[3] + aside[4];
        let remaining = -turning / (2.0 * p.zeta);
        let end = aside[U] - remaining;
        let pinion = Support { k: p.k_p, alpha: p.alpha_p };
        let gear = Support { k: p.k_g, alpha: p.alpha_g };
        let energy = turning * turning
            + p.m_p * aside[3] * aside[3]
            + p.m_g * aside[4] * aside[4]
            + pinion.energy(aside[0])
            + gear.energy(aside[1]);
        if !(pinion.keeps(aside[0], energy) && gear.keeps(aside[1], energy)) {
            return false;
        }
        let reach = (energy * (1.0 / pinion.least() + 1.0 / gear.least())).sqrt();
        let way = reach + reach.max((remaining - aside[0] + aside[1]).abs());
        end.abs() + way <= self.room + ROUNDING
    }
}

/// A support's spring.
struct Support {
    k: f64,
    alpha: f64,
}

impl Support {
    /// Twice its energy.
    fn energy(&self, u: f64) -> f64 {
        (self.k + 0.5 * self.alpha * u * u) * u * u
    }

    /// A stiffness by which its energy is at least that of a linear spring, below the barrier of a softening one.
    fn least(&self) -> f64 {
        if self.alpha < 0.0 { 0.5 * self.k } else { self.k }
    }

    /// Whether a motion of twice this energy stays below the barrier.
    fn keeps(&self, u: f64, energy: f64) -> bool {
        self.alpha >= 0.0 || (-self.alpha * u * u < self.k && -2.0 * self.alpha * energy < self.k * self.k)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::equations::GearPair;
    use crate::model::parameters::Value;
    use crate::study::multipliers::{Budget, image};
    use crate::study::poincare::Strobe;
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
        let (gap, middle) = Gap::of(&p, &orbit, 1e-10).expect("a family");
        assert!((gap.room - 1.0).abs() < 1e-9 && largest_difference(&middle.state, &[0.0; 6]) < 1e-9);
    }

    #[test]
    fn without_mesh_damping_or_with_teeth_touched_there_is_no_family() {
        for given in [[("zeta", 0.0), ("zeta_s", 0.0)], [("zeta", 0.0), ("zeta_s", 0.05)]] {
            let p = parameters(&given);
            let rest = orbit_near(&p, [0.0, 0.0, 0.2, 0.0, 0.0, 0.0]);
            assert_eq!(Gap::of(&p, &rest, 1e-10), None);
        }
        let p = parameters(&[("zeta", 0.07), ("Omega", 1.6), ("alpha", 0.0), ("F", 1.5)]);
        let options = OrbitOptions { period: 2, guess: None, tolerance: 1e-10 };
        let loaded = periodic_orbit(&p, &options).expect("converges");
        assert_eq!(Gap::of(&p, &loaded, 1e-10), None);
    }

    /// What is said to touch the teeth no more ends where the kept sum has it: were a tooth touched, it would not.
    #[test]
    fn motions_that_are_held_end_where_they_are_said_to() {
        for given in [
            vec![],
            vec![("alpha", -20.0), ("k0", 0.9)],
            vec![("alpha", 30.0), ("zeta", 0.2)],
            vec![("k_g", 2.0), ("m_p", 1.5), ("zeta_s", 0.05)],
            vec![("E", 0.1)],
            vec![("F_p", 0.05), ("zeta", 0.1)],
        ] {
            let p = parameters(&given);
            let (gap, middle) = Gap::of(&p, &orbit_near(&p, [0.0; 6]), 1e-10).expect("a family");
            let mut held = 0;
            let mut seed = 1_u32;
            let mut one = || {
                seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                f64::from(seed) / f64::from(1_u32 << 31) - 1.0
            };
            for _ in 0..600 {
                // Hardly turning, so that it is the supports that move, and may move far.
                let size = 0.5 * one();
                let (v_p, v_g) = (one() * size, one() * size);
                let turning = 2.0 * p.zeta * one() * size;
                let from = [one() * size, one() * size, one(), v_p, v_g, v_p - v_g + turning];
                let state: [f64; 6] = std::array::from_fn(|i| middle.state[i] + from[i]);
                if !gap.holds(&p, &middle.state, &state) {
                    continue;
                }
                held += 1;
                let end = from[U] + (from[U_DOT] - from[3] + from[4]) / (2.0 * p.zeta);
                let mut strobe = Strobe::new(&p, state, 1e-9).expect("allowed");
                for _ in 0..500 {
                    assert!(strobe.next().expect("integrates").is_some());
                }
                let reached = strobe.state();
                let expected: [f64; 6] =
                    std::array::from_fn(|i| middle.state[i] + if i == U { end } else { 0.0 });
                let off = largest_difference(&reached, &expected);
                assert!(off < 1e-5, "{given:?} from {from:?}: {off:e}");
            }
            assert!(held > 20, "{given:?}: {held}");
        }
    }
}
