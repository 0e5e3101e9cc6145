//! Polynomials with known roots, from the numbers of `common`.
#![allow(dead_code, reason = "each test file uses its part")]

use crate::common::Generator;

/// A number from 0 to `limit` - 1.
pub fn below(generator: &mut Generator, limit: usize) -> usize {
    generator.within(0.0, limit as f64) as usize
}

/// `count` numbers between `low` and `high` in rising order, each at least `apart` from the next.
pub fn parted(generator: &mut Generator, count: usize, apart: f64, (low, high): (f64, f64)) -> Vec<f64> {
    loop {
        let mut numbers: Vec<f64> = (0..count).map(|_| generator.within(low, high)).collect();
        numbers.sort_by(f64::total_cmp);
        if numbers.windows(2).all(|pair| pair[1] - pair[0] >= apart) {
            return numbers;
        }
    }
}

/// The polynomial in `s` whose roots in `s / length` are these real ones and these complex pairs (real part and
/// imaginary part), with leading coefficient 1 in `s / length`.
pub fn with_roots<const LEN: usize>(real: &[f64], pairs: &[(f64, f64)], length: f64) -> [f64; LEN] {
    let mut polynomial = [0.0; LEN];
    polynomial[0] = 1.0;
    let mut multiply = |factor: [f64; 3]| {
        for n in (0..LEN).rev() {
            let lower = |by: usize| if n >= by { polynomial[n - by] } else { 0.0 };
            polynomial[n] = factor[0] * lower(0) + factor[1] * lower(1) + factor[2] * lower(2);
        }
    };
    for root in real {
        multiply([-root, 1.0, 0.0]);
    }
    for (re, im) in pairs {
        multiply([re * re + im * im, -2.0 * re, 1.0]);
    }
    let mut power = 1.0;
    for coefficient in &mut polynomial {
        *coefficient /= power;
        power *= length;
    }
    polynomial
}
