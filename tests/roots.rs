//! Roots: brackets, and polynomials made from roots that are known.

use crate::common::Generator;
use crate::generated::{below, parted, with_roots};
use gear_bifurcations::error::NumericsError;
use gear_bifurcations::numerics::roots::{
    Root, RootKind, bracketed_root, extrema, polynomial_roots, polynomial_value, stationary_points,
};
use std::cell::Cell;

fn kinds(roots: &[Root]) -> Vec<RootKind> {
    roots.iter().map(|root| root.kind).collect()
}

/// A function, a bracket, and the root in it.
type Case = (fn(f64) -> f64, f64, f64, f64);

#[test]
fn brackets_shrink_to_rounding() {
    let cases: [Case; 6] = [
        (|x| x.cos() - x, 0.0, 1.0, 0.739_085_133_215_160_6),
        (|x| x * x - 2.0, 2.0, 0.0, 2.0_f64.sqrt()),
        (|x| x.exp() - 1e9, 0.0, 100.0, 1e9_f64.ln()),
        (|x| (x - 0.3).powi(9), 0.0, 1.0, 0.3),
        (|x| if x < 0.7 { -1.0 } else { 1.0 }, 0.0, 1.0, 0.7),
        (|x| (1e3 * (x - 0.1)).tanh(), -1.0, 1.0, 0.1),
    ];
    for (function, low, high, root) in cases {
        let count = Cell::new(0);
        let counted = |x: f64| {
            count.set(count.get() + 1);
            function(x)
        };
        let found = bracketed_root(counted, low, high, 0.0).expect("a bracket");
        assert!((found - root).abs() <= 4.0 * f64::EPSILON * root.abs(), "{found} for {root}");
        assert!(count.get() < 130, "{} evaluations for {root}", count.get());
    }
}

#[test]
fn a_smooth_root_takes_few_evaluations() {
    let count = Cell::new(0);
    let counted = |x: f64| {
        count.set(count.get() + 1);
        x.cos() - x
    };
    bracketed_root(counted, 0.0, 1.0, 1e-15).expect("a bracket");
    assert!(count.get() <= 10, "{} evaluations", count.get());
}

#[test]
fn ends_that_bracket_nothing_and_values_that_are_no_numbers_are_errors() {
    assert_eq!(
        bracketed_root(|x| x * x + 1.0, -1.0, 2.0, 0.0),
        Err(NumericsError::NoBracket { low: -1.0, high: 2.0 })
    );
    assert!(matches!(
        bracketed_root(|x| 1.0 / x, -1.0, 1.0, 0.0),
        Err(NumericsError::NotFinite { time }) if time == 0.0
    ));
    assert_eq!(bracketed_root(|x| x, 0.0, 1.0, 0.0), Ok(0.0));
    assert_eq!(bracketed_root(|x| x - 1.0, 0.0, 1.0, 0.0), Ok(1.0));
}

/// Roots parted by at least `apart`, some inside (0, 1), some outside, and complex pairs, in a polynomial of 17
/// coefficients on an interval of random length, forwards and backwards.
#[test]
fn generated_polynomials_give_back_their_roots() {
    let mut generator = Generator(1);
    for round in 0..400 {
        let count = below(&mut generator, 6);
        let inside = parted(&mut generator, count, 0.04, (0.02, 0.98));
        let outside: Vec<f64> = (0..3).map(|_| 1.1 + 2.0 * generator.unit()).collect();
        let pairs: Vec<(f64, f64)> =
            (0..3).map(|_| (2.0 * generator.unit() - 0.5, 0.2 + generator.unit())).collect();
        let length = 10.0_f64.powf(6.0 * generator.unit() - 3.0) * if round % 2 == 0 { 1.0 } else { -1.0 };
        let roots: Vec<f64> = inside.iter().chain(&outside).copied().collect();
        let polynomial = with_roots::<17>(&roots, &pairs, length);
        let found = polynomial_roots(&polynomial, length, 0.0);
        let found = found.as_slice();
        assert_eq!(found.len(), inside.len(), "{inside:?} {outside:?} {pairs:?} {length}: {found:?}");
        let starts_above = polynomial[0] > 0.0;
        for (n, (root, known)) in found.iter().zip(&inside).enumerate() {
            assert!((root.at / length - known).abs() < 1e-7, "{inside:?}: {found:?}");
            let falling = starts_above == (n % 2 == 0);
            assert_eq!(root.kind, if falling { RootKind::Falling } else { RootKind::Rising });
        }
    }
}

#[test]
fn no_change_of_sign_that_sampling_shows_is_missed() {
    let mut generator = Generator(7);
    let mut seen = 0;
    for _ in 0..400 {
        // A random sum of Chebyshev polynomials of degree up to 24, which waves all over the interval.
        let waves: Vec<f64> = (0..25).map(|_| 2.0 * generator.unit() - 1.0).collect();
        let mut polynomial = [0.0; 25];
        let (mut before, mut present) = ([0.0; 25], [0.0; 25]);
        present[0] = 1.0;
        for (n, wave) in waves.iter().enumerate() {
            // Degrees above 12 need more digits than the powers have; let them fade.
            let wave = if n > 12 { wave * 0.1_f64.powf(n as f64 - 12.0) } else { *wave };
            for k in 0..25 {
                polynomial[k] += wave * present[k];
            }
            let mut next = [0.0; 25];
            for k in 0..25 {
                let shifted = if k > 0 { present[k - 1] } else { 0.0 };
                next[k] = if n == 0 {
                    2.0 * shifted - present[k]
                } else {
                    2.0 * (2.0 * shifted - present[k]) - before[k]
                };
            }
            (before, present) = (present, next);
        }
        let found = polynomial_roots(&polynomial, 1.0, 0.0);
        let found = found.as_slice();
        assert!(found.windows(2).all(|pair| pair[0].at <= pair[1].at));
        let mut place = 0;
        let mut last = polynomial_value(&polynomial, 0.0);
        for n in 1..=4096 {
            let at = f64::from(n) / 4096.0;
            let value = polynomial_value(&polynomial, at);
            let within = found[place..].iter().take_while(|root| root.at <= at).count();
            assert_eq!(within % 2 == 1, (last > 0.0) != (value > 0.0), "before {at}: {found:?}");
            place += within;
            last = value;
        }
        seen += found.len();
    }
    assert!(seen > 1000, "{seen} roots are too few to be a test");
}

#[test]
fn a_pair_of_crossings_however_near_is_two_and_a_touch_is_one() {
    for depth in [1e-3, 1e-6, 1e-9, 1e-12] {
        // (x - 1/3)^2 - depth, on [0, 1].
        let third = 1.0 / 3.0;
        let pair = [third * third - depth, -2.0 * third, 1.0, 0.0, 0.0];
        let found = polynomial_roots(&pair, 1.0, 0.1 * depth);
        assert_eq!(kinds(found.as_slice()), [RootKind::Falling, RootKind::Rising], "{depth:e}");
        let width = found.as_slice()[1].at - found.as_slice()[0].at;
        assert!((width / (2.0 * depth.sqrt()) - 1.0).abs() < 1e-3, "{depth:e}: {width:e}");
        for bottom in [-depth, 0.0, depth] {
            let touch = [third * third + bottom, -2.0 * third, 1.0, 0.0, 0.0];
            let found = polynomial_roots(&touch, 1.0, 1.1 * depth);
            assert_eq!(kinds(found.as_slice()), [RootKind::Touch], "{depth:e} {bottom:e}");
            assert!((found.as_slice()[0].at - third).abs() < 1e-9);
        }
        let miss = [third * third + depth, -2.0 * third, 1.0, 0.0, 0.0];
        assert_eq!(polynomial_roots(&miss, 1.0, 0.9 * depth).as_slice(), []);
    }
}

#[test]
fn roots_of_any_odd_multiplicity_cross_and_of_any_even_one_touch() {
    for center in [0.25, 0.3, 0.5, 0.7] {
        for multiplicity in 1..=8 {
            let polynomial = with_roots::<12>(&vec![center; multiplicity], &[], 1.0);
            let found = polynomial_roots(&polynomial, 1.0, 1e-14);
            let expected = match multiplicity % 2 {
                0 => RootKind::Touch,
                _ => RootKind::Rising,
            };
            assert_eq!(kinds(found.as_slice()), [expected], "{center}^{multiplicity}");
            // Rounding of the coefficients moves a root of this multiplicity by its root of 1e-15.
            let spread = 1e-14_f64.powf(1.0 / multiplicity as f64);
            assert!((found.as_slice()[0].at - center).abs() < spread.max(1e-14), "{found:?}");
        }
    }
}

#[test]
fn roots_at_the_joints_of_halving_are_not_lost() {
    // Wilkinson-like: roots exactly where the interval is halved and quartered.
    let polynomial = with_roots::<12>(&[0.25, 0.375, 0.5, 0.625, 0.75], &[], 1.0);
    let found = polynomial_roots(&polynomial, 1.0, 0.0);
    let at: Vec<f64> = found.as_slice().iter().map(|root| root.at).collect();
    assert_eq!(at.len(), 5, "{at:?}");
    for (found, known) in at.iter().zip([0.25, 0.375, 0.5, 0.625, 0.75]) {
        // The coefficients' sizes sum to 8, and the flattest slope at a root is 1e-3.
        assert!((found - known).abs() < 8.0 * f64::EPSILON / 1e-3, "{at:?}");
    }
    // Symmetric about the middle: the derivative vanishes at the first joint.
    let symmetric = with_roots::<12>(&[0.2, 0.4, 0.6, 0.8], &[], 1.0);
    assert_eq!(polynomial_roots(&symmetric, 1.0, 0.0).as_slice().len(), 4);
    assert!(stationary_points(&symmetric, 1.0).as_slice().iter().any(|at| (at - 0.5).abs() < 1e-14));
}

#[test]
fn a_root_at_an_end_is_an_end() {
    let found = polynomial_roots(&[0.0, 1.0, -1.0], 1.0, 0.0);
    assert_eq!(kinds(found.as_slice()), [RootKind::End, RootKind::End]);
    assert_eq!(found.as_slice()[0].at, 0.0);
    assert_eq!(found.as_slice()[1].at, 1.0);
    let flat = polynomial_roots(&[1e-13, 0.0, 0.0], 1.0, 1e-12);
    assert_eq!(kinds(flat.as_slice()), [RootKind::End]);
    assert_eq!(polynomial_roots(&[1.0], 1.0, 0.0).as_slice(), []);
}

#[test]
fn extrema_are_those_of_fine_sampling() {
    let mut generator = Generator(3);
    for round in 0..200 {
        let roots: Vec<f64> = (0..7).map(|_| 1.4 * generator.unit() - 0.2).collect();
        let length = if round % 2 == 0 { 0.3 } else { -0.3 };
        let polynomial = with_roots::<10>(&roots, &[], length);
        let found = extrema(&polynomial, length);
        let sampled: Vec<f64> =
            (0..=2000).map(|n| polynomial_value(&polynomial, length * f64::from(n) / 2000.0)).collect();
        let (least, greatest) =
            sampled.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(*v), b.max(*v)));
        let size = greatest - least;
        assert!(found.least <= least && found.greatest >= greatest, "{roots:?}");
        assert!(found.least > least - 1e-4 * size && found.greatest < greatest + 1e-4 * size, "{roots:?}");
        assert_eq!(polynomial_value(&polynomial, found.least_at), found.least);
        assert_eq!(polynomial_value(&polynomial, found.greatest_at), found.greatest);
    }
}
