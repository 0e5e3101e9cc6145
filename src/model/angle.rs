//! Sine and cosine of one angle together, by operations that every machine and engine carries out alike.
//!
//! What the platforms offer differs in the last bit, and reduces an angle anew for each of the two. Reduction in two parts
//! and the polynomials on an eighth of the circle are those of fdlibm (`e_rem_pio2.c`, `k_sin.c`, `k_cos.c`, Sun Microsystems
//! 1993), which allows everybody to use and to change them.

use std::f64::consts::FRAC_2_PI;

/// Beyond this angle quarter turns are no longer counted exactly, and the platform is asked.
const FAR: f64 = 1e6;
/// A quarter turn to 33 bits, and the rest of it.
const QUARTER: [f64; 2] = [1.570_796_326_734_125_6, 6.077_100_506_506_192e-11];
/// Added and taken away again it leaves the nearest whole number, whose last bits are those of the sum.
const ROUND: f64 = 6_755_399_441_055_744.0;
const SINE: [f64; 6] = [
    -1.666_666_666_666_663_2e-1,
    8.333_333_333_322_49e-3,
    -1.984_126_982_985_795e-4,
    2.755_731_370_707_006_8e-6,
    -2.505_076_025_340_686_3e-8,
    1.589_690_995_211_55e-10,
];
const COSINE: [f64; 6] = [
    4.166_666_666_666_66e-2,
    -1.388_888_888_887_411e-3,
    2.480_158_728_947_673e-5,
    -2.755_731_435_139_066_3e-7,
    2.087_572_321_298_175e-9,
    -1.135_964_755_778_819_5e-11,
];

/// Sine and cosine of an angle in radians, each to one unit in its last place or, near its zeros, to 1e-20; not a number
/// for what is not finite.
pub fn sine_and_cosine(angle: f64) -> (f64, f64) {
    if angle.is_nan() || angle.abs() > FAR {
        return angle.sin_cos();
    }
    let shifted = angle * FRAC_2_PI + ROUND;
    let turns = shifted - ROUND;
    let (first, second) = (angle - turns * QUARTER[0], turns * QUARTER[1]);
    let rest = first - second;
    let (sine, cosine) = within_an_eighth(rest, (first - rest) - second);
    match shifted.to_bits() & 3 {
        0 => (sine, cosine),
        1 => (cosine, -sine),
        2 => (-sine, -cosine),
        _ => (-cosine, sine),
    }
}

/// Of an angle within an eighth of the circle, given as a number and what is missing in its last place.
fn within_an_eighth(x: f64, tail: f64) -> (f64, f64) {
    let z = x * x;
    let w = z * z;
    let higher = SINE[1] + z * (SINE[2] + z * SINE[3]) + z * w * (SINE[4] + z * SINE[5]);
    let cubed = z * x;
    let sine = x - ((z * (0.5 * tail - cubed * higher) - tail) - cubed * SINE[0]);
    let fourth = z * (COSINE[0] + z * (COSINE[1] + z * COSINE[2]))
        + w * w * (COSINE[3] + z * (COSINE[4] + z * COSINE[5]));
    let half = 0.5 * z;
    let near = 1.0 - half;
    (sine, near + (((1.0 - near) - half) + (z * fourth - x * tail)))
}

#[cfg(test)]
mod tests {
    use super::{FAR, sine_and_cosine};

    /// Distance in units of the last place of a number.
    fn units(value: f64, exact: f64) -> f64 {
        let unit = f64::from_bits(exact.abs().to_bits() + 1) - exact.abs();
        (value - exact).abs() / unit
    }

    #[test]
    fn both_are_as_near_as_the_platforms() {
        // Steps that meet every part of the circle, near and far.
        for (step, count) in [(1e-3, 20_000), (0.731, 20_000), (49.37, 20_000)] {
            for index in -count..count {
                let angle = step * f64::from(index);
                let ((sine, cosine), exact) = (sine_and_cosine(angle), angle.sin_cos());
                // Where one of the two vanishes what the quarter turn lacks counts, times their number.
                let slack = 2e-26 * angle.abs();
                for (value, exact) in [(sine, exact.0), (cosine, exact.1)] {
                    assert!(
                        units(value, exact) <= 1.0 || (value - exact).abs() < slack,
                        "{angle}: {value}, {exact}"
                    );
                }
            }
        }
    }

    #[test]
    fn whole_and_half_turns_are_found() {
        assert_eq!(sine_and_cosine(0.0), (0.0, 1.0));
        assert_eq!(sine_and_cosine(-0.0).0.to_bits(), (-0.0_f64).to_bits());
        let (sine, cosine) = sine_and_cosine(std::f64::consts::PI);
        assert!((sine - 1.224_646_799_147_353_2e-16).abs() < 1e-25 && cosine == -1.0);
    }

    #[test]
    fn what_is_far_or_no_number_is_the_platforms() {
        assert_eq!(sine_and_cosine(3.0 * FAR), (3.0 * FAR).sin_cos());
        for angle in [f64::NAN, f64::INFINITY] {
            assert!(sine_and_cosine(angle).0.is_nan() && sine_and_cosine(angle).1.is_nan());
        }
    }
}
