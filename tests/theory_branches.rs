//! The perturbation equations against projections of what they are expanded from, the combination tongue, and the
//! motions born at the tongues' edges.

use std::f64::consts::PI;

use crate::common::Generator;
use crate::theory_support::{
    assert_close, determinant, eigenvalues, generated, numerical_jacobian, symmetric,
};
use gear_bifurcations::error::TheoryError;
use gear_bifurcations::model::parameters::Symmetric;
use gear_bifurcations::theory::modes::{self, Amplitudes, Expansion, Modes};
use gear_bifurcations::theory::primary::{self, Branch};
use gear_bifurcations::theory::{
    Mode, branches, combination, combination_exponents, cycles, damped, paper_alpha, period_two,
    period_two_guess, primary_exponents,
};
use nalgebra::Complex;

/// Cosine and sine coefficients of the right side of (33) at the three frequencies, which must be multiples of
/// `1/denominator`: rows are the equations, columns the frequencies.
fn projected(
    modes: &Modes,
    expansion: &Expansion,
    omega_n: [f64; 3],
    amplitudes: &Amplitudes,
    denominator: usize,
) -> [[[f64; 3]; 3]; 2] {
    let samples = 16 * denominator;
    let mut coefficients = [[[0.0; 3]; 3]; 2];
    for sample in 0..samples {
        let tau = 2.0 * PI * denominator as f64 * sample as f64 / samples as f64;
        let u_0 = modes::zeroth_order(modes, omega_n, amplitudes, tau);
        let mut curved = *amplitudes;
        for (pair, omega) in [&mut curved.a, &mut curved.b, &mut curved.c].into_iter().zip(omega_n) {
            *pair = pair.map(|amplitude| -omega * omega * amplitude);
        }
        let second = modes::zeroth_order(modes, omega_n, &curved, tau);
        let forcing = modes::first_order_forcing(modes, expansion, u_0, second, tau);
        for (row, value) in forcing.into_iter().enumerate() {
            for (column, omega) in omega_n.into_iter().enumerate() {
                let weight = 2.0 * value / samples as f64;
                coefficients[0][row][column] += weight * (omega * tau).cos();
                coefficients[1][row][column] += weight * (omega * tau).sin();
            }
        }
    }
    coefficients
}

fn assert_matrices(what: &str, found: [[f64; 3]; 3], expected: [[f64; 3]; 3], sign: f64) {
    for (found, expected) in found.iter().flatten().zip(expected.iter().flatten()) {
        assert_close(what, *found, sign * expected, 1e-11);
    }
}

const AMPLITUDES: Amplitudes = Amplitudes { a: [0.4, -0.3], b: [0.5, 0.2], c: [-0.1, 0.6] };

#[test]
fn the_matrices_of_48_are_the_projection_of_33() {
    let modes = Modes::new(1.3, 2.1).expect("in range");
    // Frequencies among which neither the mesh nor the cubes make a resonance.
    let omega_n = [5.0 / 20.0, 13.0 / 20.0, 37.0 / 20.0];
    let expansion = Expansion { omega_0: 1.7, omega_1: 0.3, alpha: 0.8 };
    let [cosine, sine] = projected(&modes, &expansion, omega_n, &AMPLITUDES, 20);
    let [expected_cosine, expected_sine] = modes::resonant_terms(&modes, &expansion, omega_n, &AMPLITUDES);
    assert_matrices("(48)", cosine, expected_cosine, 1.0);
    assert_matrices("(48)", sine, expected_sine, -1.0);
    let frequencies = modes::forcing_frequencies(omega_n);
    assert_eq!((frequencies[3], frequencies[6]), (omega_n[1] - 1.0, omega_n[2] + 1.0));
}

#[test]
fn the_secular_matrices_of_the_primary_tongues_are_the_projection() {
    let modes = Modes::new(1.3, 2.1).expect("in range");
    for (mode, alone) in [
        (Mode::Second, Amplitudes { b: AMPLITUDES.b, ..Amplitudes::default() }),
        (Mode::Third, Amplitudes { c: AMPLITUDES.c, ..Amplitudes::default() }),
    ] {
        let (alpha, omega_1) = (-0.7, 0.2);
        let expansion = Expansion { omega_0: primary::emanating_frequency(&modes, mode), omega_1, alpha };
        let column = mode.number() - 1;
        // The other modes are at rest and their frequencies only placeholders.
        let mut omega_n = [0.25, 0.75, 0.75];
        omega_n[column] = 0.5;
        let [cosine, sine] = projected(&modes, &expansion, omega_n, &alone, 4);
        let expected = [
            primary::secular_cosine(&modes, mode, alpha, omega_1, &alone),
            primary::secular_sine(&modes, mode, alpha, omega_1, &alone),
        ];
        for row in 0..3 {
            assert_close("(54), (80)", cosine[row][column], expected[0][row][column], 1e-11);
            assert_close("(55), (81)", sine[row][column], -expected[1][row][column], 1e-11);
        }
    }
}

#[test]
fn a_secular_column_is_balanced_at_an_equilibrium_and_only_there() {
    for (m, k) in generated(20) {
        let modes = Modes::new(m, k).expect("in range");
        for (mode, branch) in
            [Branch::Sine, Branch::Cosine].into_iter().flat_map(|b| Mode::BOTH.map(|mode| (mode, b)))
        {
            let (alpha, omega_1) = (0.3, 1.7 * primary::half_width(&modes, mode));
            let square = primary::radius_squared(&modes, mode, branch, alpha, omega_1).expect("alpha");
            let omega_0 = primary::emanating_frequency(&modes, mode);
            let part = usize::from(branch == Branch::Sine);
            let determinants = |radius: f64, matrix: [[f64; 3]; 3]| {
                let mut amplitudes = Amplitudes::default();
                match mode {
                    Mode::Second => amplitudes.b[part] = radius,
                    Mode::Third => amplitudes.c[part] = radius,
                }
                let secular = [primary::secular_cosine, primary::secular_sine][part](
                    &modes,
                    mode,
                    alpha,
                    omega_1,
                    &amplitudes,
                );
                let column = mode.number() - 1;
                primary::solvability(matrix, secular.map(|row| row[column]))
                    .map(f64::abs)
                    .into_iter()
                    .fold(0.0, f64::max)
            };
            let matrix = modes::characteristic_matrix(m, k, omega_0, -0.25);
            let printed = modes::characteristic_matrix_printed(m, k, omega_0, -0.25);
            let off = determinants(0.9 * square.sqrt(), matrix);
            assert!(determinants(square.sqrt(), matrix) < 1e-9 * off, "(57) at m = {m}, k = {k}");
            assert!(determinants(square.sqrt(), printed) > 1e-3 * off, "(57) with the printed matrix");
        }
    }
}

#[test]
fn without_cubes_the_secular_determinants_vanish_on_the_edges() {
    for (m, k) in generated(20) {
        let modes = Modes::new(m, k).expect("in range");
        for mode in Mode::BOTH {
            let width = primary::half_width_printed(&modes, mode);
            let at = |secular: fn(&Modes, Mode, f64, f64, &Amplitudes) -> [[f64; 3]; 3], omega_1: f64| {
                determinant(secular(&modes, mode, 0.0, omega_1, &AMPLITUDES)).abs()
            };
            // Cosine on the right edge, sine on the left one.
            let scale = at(primary::secular_cosine, 2.0 * width);
            assert!(
                at(primary::secular_cosine, width) < 1e-9 * scale
                    && at(primary::secular_cosine, -width) > 1e-6 * scale
            );
            let scale = at(primary::secular_sine, 2.0 * width);
            assert!(
                at(primary::secular_sine, -width) < 1e-9 * scale
                    && at(primary::secular_sine, width) > 1e-6 * scale
            );
        }
    }
}

#[test]
fn the_secular_matrices_of_the_combination_tongue_are_the_projection_and_lead_to_105() {
    // m = 1 and k such that omega_2 : omega_3 = 3 : 13, so that the projection is exact.
    let square = (3.0_f64 / 13.0).powi(2);
    let sigma = ((1.0 + square) - ((1.0 + square).powi(2) - 12.0 * square).sqrt()) / (2.0 * square);
    let modes = Modes::new(1.0, sigma * sigma * square).expect("in range");
    let omega_0 = combination::emanating_frequency(&modes);
    assert_close("ratio", modes.omega[1] / omega_0, 3.0 / 16.0, 1e-14);
    let moving = Amplitudes { a: [0.0; 2], ..AMPLITUDES };
    let (alpha, omega_1) = (0.6, -0.2);
    let omega_n = [5.0 / 16.0, 3.0 / 16.0, 13.0 / 16.0];
    let [cosine, sine] = projected(&modes, &Expansion { omega_0, omega_1, alpha }, omega_n, &moving, 16);
    let expected = [
        combination::secular_cosine(&modes, alpha, omega_1, &moving),
        combination::secular_sine(&modes, alpha, omega_1, &moving),
    ];
    for (row, column) in (0..3).flat_map(|row| [(row, 1), (row, 2)]) {
        assert_close("(103)", cosine[row][column], expected[0][row][column], 1e-11);
        assert_close("(104)", sine[row][column], -expected[1][row][column], 1e-11);
    }
    // The conic A x^2 + B x y + C y^2 of the determinant and the paper's condition on it.
    for (secular, part) in [
        (combination::secular_cosine as fn(&Modes, f64, f64, &Amplitudes) -> _, 0),
        (combination::secular_sine, 1),
    ] {
        let condition = |omega_1: f64| {
            let at = |b: f64, c: f64| {
                let mut amplitudes = Amplitudes::default();
                (amplitudes.a[part], amplitudes.b[part], amplitudes.c[part]) = (1.0, b, c);
                determinant(secular(&modes, 0.0, omega_1, &amplitudes))
            };
            let (a, c) = (at(1.0, 0.0), at(0.0, 1.0));
            let b = at(1.0, 1.0) - a - c;
            [a * b + 2.0 * a * c + b * c, (a * b).abs() + 2.0 * (a * c).abs() + (b * c).abs()]
        };
        let [right, left] = [1.0, -1.0].map(|sign| {
            let [value, size] = condition(sign * combination::half_width_printed(&modes));
            value.abs() / size
        });
        // Unlike the primary tongues': the cosines lead to the left edge, the sines to the right one.
        let (on, off) = if part == 0 { (left, right) } else { (right, left) };
        assert!(on < 1e-10 && off > 1e-3, "(105): {on} {off}");
    }
}

#[test]
fn the_jacobian_110_its_eigenvalues_and_its_conditions() {
    let mut generator = Generator(3);
    for (m, k) in generated(40) {
        let modes = Modes::new(m, k).expect("in range");
        let printed_width = combination::half_width_printed(&modes);
        let omega_1 = printed_width * (3.0 * generator.unit() - 1.5);
        let alpha = 0.5;
        let scale = 1.0 + k;
        let x = std::array::from_fn(|_| generator.unit() - 0.5);
        let numerical = numerical_jacobian(|x| combination::slow_flow_printed(&modes, alpha, omega_1, x), x);
        let analytic = combination::jacobian_printed(&modes, alpha, omega_1, x);
        for (one, other) in analytic.iter().flatten().zip(numerical.iter().flatten()) {
            assert_close("Jacobian of (106)-(109)", *one, *other, 1e-9 * scale);
        }
        let origin = combination::origin_jacobian_printed(&modes, omega_1);
        assert_eq!(combination::jacobian_printed(&modes, alpha, omega_1, [0.0; 4]), origin);
        let characteristic = |jacobian: [[f64; 4]; 4], lambda: Complex<f64>| {
            let matrix = nalgebra::Matrix4::from_fn(|row, column| Complex::from(jacobian[row][column]));
            (matrix - nalgebra::Matrix4::identity() * lambda).determinant().norm()
        };
        let polynomial = |lambda: Complex<f64>| characteristic(origin, lambda) / scale.powi(4);
        let worst = |values: [Complex<f64>; 4]| values.into_iter().map(&polynomial).fold(0.0, f64::max);
        assert!(worst(combination::eigenvalues_111(&modes, omega_1)) < 1e-11, "(111) corrected");
        assert!(worst(combination::eigenvalues_printed(&modes, omega_1)) > 1e-9, "(111) as printed");
        let outside = omega_1.abs() > printed_width;
        assert_eq!(combination::is_centre_112(&modes, omega_1), outside, "(112)");
        assert_eq!(combination::is_spiral_printed(&modes, omega_1), !outside, "(113)");
        let scaled = combination::origin_jacobian(&modes, omega_1);
        let rates = combination::growth_rates(&modes, omega_1);
        for rate in rates {
            assert!(
                characteristic(scaled, rate) < 1e-13 * (1.0 + modes.omega[2]).powi(4),
                "{rate} at m = {m}, k = {k}"
            );
        }
        let sum: Complex<f64> = rates.iter().sum();
        let product: Complex<f64> = rates.iter().product();
        assert_close("trace", sum.norm(), 0.0, 1e-14 * (1.0 + modes.omega[2]));
        assert_close("product", product.re / determinant(scaled), 1.0, 1e-9);
        let growing = rates.into_iter().any(|rate| rate.re > 1e-12);
        assert_eq!(combination::is_unstable(&modes, omega_1), growing, "[T4]");
    }
    let modes = Modes::new(1.0, 5.0).expect("in range");
    let part = |part: f64| part * combination::half_width_printed(&modes);
    let printed = [0.5, 2.0].map(|outward| combination::is_centre_printed(&modes, part(outward)));
    assert_eq!(printed, [true, false], "(112) as printed says the opposite of what it is for");
    let middle = combination::eigenvalues_111(&modes, 0.0);
    assert!(middle.into_iter().all(|lambda| lambda.im == 0.0), "(113): no spiral in the middle");
}

#[test]
fn the_solutions_of_106_to_109_solve_them_and_leave_the_origin_at_their_own_edge() {
    for (index, (m, k)) in generated(40).into_iter().enumerate() {
        let modes = Modes::new(m, k).expect("in range");
        let alpha = [0.4, -0.4][index % 2];
        let edge = combination::printed_solutions_edge(&modes);
        for omega_1 in [-3.0, -0.5, 0.0, 0.7, 1.2].map(|part| part * edge) {
            let solutions = combination::printed_solutions(&modes, alpha, omega_1).expect("alpha");
            // One more from each edge on, towards the side to which the cubes bend; folds may add pairs.
            let along = omega_1 / edge * alpha.signum();
            let born = usize::from(along > -1.0) + usize::from(along > 1.0);
            assert!(
                solutions.len() >= born && (solutions.len() - born).is_multiple_of(2),
                "{along} {solutions:?}"
            );
            for solution in solutions {
                let (sine, cosine) = f64::sin_cos(0.3 + index as f64);
                let x = [
                    solution.radius_b * cosine,
                    solution.radius_b * sine,
                    solution.ratio * solution.radius_b * cosine,
                    -solution.ratio * solution.radius_b * sine,
                ];
                assert_close("R_C", x[2].hypot(x[3]), solution.radius_c, 1e-12 * (1.0 + solution.radius_c));
                let size = (1.0 + k) * (solution.radius_b + solution.radius_c);
                for residual in combination::slow_flow_printed(&modes, alpha, omega_1, x) {
                    assert_close("(106)-(109)", residual, 0.0, 1e-11 * size);
                }
                // The circle's zero is double and rounding splits it by its root.
                let values = eigenvalues(combination::jacobian_printed(&modes, alpha, omega_1, x));
                let grows = values.iter().any(|value| value.re > 1e-5 * (1.0 + k));
                assert_eq!(solution.stable, !grows, "m = {m}, k = {k}: {values:?}");
            }
        }
        // A pair leaves the origin at each edge: the least radius goes to zero as the edge is approached.
        let least = |part: f64| {
            let solutions = combination::printed_solutions(&modes, alpha, part * edge).expect("alpha");
            solutions.iter().map(|solution| solution.radius_b).fold(f64::INFINITY, f64::min)
        };
        let born = [0.99999, 1.00001, -0.99999, -1.00001].map(least);
        assert!(born.iter().filter(|radius| **radius < 0.05 * (1.0 + k).sqrt()).count() >= 2, "{born:?}");
    }
    let modes = Modes::new(1.0, 5.0).expect("in range");
    assert_eq!(
        combination::printed_solutions(&modes, 0.0, 0.1),
        Err(TheoryError::Vanishing { parameter: "alpha", equation: "(106)-(109)" })
    );
}

#[test]
fn decay_rates_are_those_of_the_linear_system() {
    for (m, k) in generated(30) {
        let modes = Modes::new(m, k).expect("in range");
        for (zeta, zeta_s) in [(1e-6, 0.0), (0.0, 1e-6), (1e-6, 3e-6)] {
            // (25) on the manifold u_g = -u_p, without pulsation, solved for u_p'' and u''.
            let row_u_p = [-k / m, -1.0 / m, -2.0 * zeta_s / m, -2.0 * zeta / m];
            let row_u = [-2.0 * k / m, -2.0 / m - 1.0, -4.0 * zeta_s / m, -4.0 * zeta / m - 2.0 * zeta];
            let system = [[0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0], row_u_p, row_u];
            for value in eigenvalues(system) {
                let mode = Mode::BOTH
                    .into_iter()
                    .min_by(|one, other| {
                        let gap = |mode: Mode| (modes.frequency(mode) - value.im.abs()).abs();
                        gap(*one).total_cmp(&gap(*other))
                    })
                    .expect("two modes");
                let decay = damped::decay_rate(&modes, mode, zeta, zeta_s);
                assert_close("[T2]", -value.re / 1e-6, decay / 1e-6, 1e-5 * (1.0 + modes.sigma(mode)));
            }
        }
    }
}

#[test]
fn exponents_cross_zero_on_the_damped_edges() {
    let mut open = 0;
    for (m, k) in generated(40) {
        let modes = Modes::new(m, k).expect("in range");
        let mut point = symmetric(m, k, 0.0, 0.003, 0.6, 1.0);
        point.zeta_s = 0.001;
        let largest = |values: &[Complex<f64>]| values.iter().map(|value| value.re).fold(f64::MIN, f64::max);
        for mode in Mode::BOTH {
            let threshold = damped::primary_threshold(&modes, mode, &point);
            let edges = damped::primary_edges(&modes, mode, &point);
            assert_eq!(edges.is_some(), threshold < point.k0);
            for edge in edges.into_iter().flat_map(|edges| [edges.left, edges.right]) {
                open += 1;
                let exponents =
                    primary_exponents(&Symmetric { omega: edge, ..point }, mode).expect("in range");
                assert_close("[T5]", largest(&exponents), 0.0, 1e-12);
            }
        }
        let threshold = damped::combination_threshold(&modes, &point);
        let edges = damped::combination_edges(&modes, &point);
        assert_eq!(edges.is_some(), threshold < point.k0);
        for edge in edges.into_iter().flat_map(|edges| [edges.left, edges.right]) {
            open += 1;
            let exponents = combination_exponents(&Symmetric { omega: edge, ..point }).expect("in range");
            assert_close("[T6]", largest(&exponents), 0.0, 1e-11);
        }
        // Without damping the exponents are k0 times the rates of the scaled (110).
        let undamped = Symmetric {
            zeta: 0.0,
            zeta_s: 0.0,
            omega: combination::emanating_frequency(&modes) + 0.1,
            ..point
        };
        let rates = combination::growth_rates(&modes, 0.1 / point.k0);
        for exponent in combination_exponents(&undamped).expect("in range") {
            let nearest =
                rates.iter().map(|rate| (rate * point.k0 - exponent).norm()).fold(f64::INFINITY, f64::min);
            assert!(nearest < 1e-9, "{nearest}");
        }
    }
    assert!(open > 100, "{open}");
}

/// Slow flow of a primary tongue in time, with damping.
fn primary_flow(point: &Symmetric, mode: Mode, x: [f64; 2]) -> [f64; 2] {
    let modes = Modes::of(point).expect("in range");
    let omega_1 = (point.omega - primary::emanating_frequency(&modes, mode)) / point.k0;
    let flow = primary::slow_flow(&modes, mode, paper_alpha(point).expect("k0"), omega_1, x);
    let decay = damped::decay_rate(&modes, mode, point.zeta, point.zeta_s);
    std::array::from_fn(|part| point.k0 * primary::rate(&modes, mode) * flow[part] - decay * x[part])
}

#[test]
fn the_motions_of_t7_are_equilibria_with_the_stability_they_claim() {
    let (mut stable, mut unstable) = (0, 0);
    for (index, (m, k)) in generated(120).into_iter().enumerate() {
        let modes = Modes::new(m, k).expect("in range");
        for mode in Mode::BOTH {
            let zeta = [0.0, 0.002, 0.01][index % 3];
            let part = 0.05 * index as f64 - 3.0;
            let mut point = symmetric(m, k, [0.3, -0.3][index % 2], zeta, 0.4, 1.0);
            point.omega = primary::emanating_frequency(&modes, mode)
                + part * point.k0 * primary::half_width(&modes, mode);
            for motion in period_two(&point, mode).expect("alpha").into_iter().flatten() {
                let x = [motion.radius * motion.angle.cos(), motion.radius * motion.angle.sin()];
                for rate in primary_flow(&point, mode, x) {
                    assert_close(
                        "[T7]",
                        rate,
                        0.0,
                        1e-11 * (1.0 + motion.radius) * (1.0 + modes.frequency(mode)),
                    );
                }
                let values = eigenvalues(numerical_jacobian(|x| primary_flow(&point, mode, x), x));
                let grows = values.iter().any(|value| value.re > 1e-6);
                assert_eq!(motion.stable, !grows, "m = {m}, k = {k}, {mode:?}: {values:?}");
                if motion.stable {
                    stable += 1;
                } else {
                    unstable += 1;
                }
                if zeta == 0.0 {
                    let omega_1 = part * primary::half_width(&modes, mode);
                    let alpha = paper_alpha(&point).expect("k0");
                    let square =
                        primary::radius_squared(&modes, mode, motion.branch, alpha, omega_1).expect("alpha");
                    assert_close("(63), (64)", motion.radius.powi(2) / square, 1.0, 1e-9);
                }
            }
        }
    }
    assert!(stable > 60 && unstable > 30, "{stable} {unstable}");
}

#[test]
fn t8_gives_the_checked_example_and_hysteresis() {
    let modes = Modes::new(1.0, 5.0).expect("in range");
    let omega = combination::emanating_frequency(&modes) - 0.003;
    let [supercritical, subcritical] = cycles(&symmetric(1.0, 5.0, -0.02, 5e-4, 0.02, omega)).expect("alpha");
    let cycle = supercritical.expect("softening, inside");
    assert_close("B", cycle.radius_b, 0.6260, 5e-5);
    assert_close("C", cycle.radius_c, 0.5792, 5e-5);
    assert!(cycle.stable && subcritical.is_none());
    assert_close("frequencies", cycle.frequencies[0] + cycle.frequencies[1], omega, 1e-13);
    // alpha = +0.2, k0 = 0.5, zeta = 0.02, beyond the right edge: both exist and the origin is stable.
    let beyond = symmetric(1.0, 5.0, 0.2, 0.02, 0.5, 3.95);
    assert!(damped::combination_edges(&modes, &beyond).expect("open").right < beyond.omega);
    let [stable, unstable] = cycles(&beyond).expect("alpha");
    let (stable, unstable) = (stable.expect("goes on"), unstable.expect("born"));
    assert!(stable.stable && !unstable.stable && stable.radius_b > unstable.radius_b);
    assert_eq!(
        cycles(&symmetric(1.0, 5.0, 0.0, 0.0, 0.5, 3.5)),
        Err(TheoryError::Vanishing { parameter: "alpha", equation: "[T8]" })
    );
}

/// Slow flow of the combination tongue in time with damping, in a frame that turns by `turn` more in the second mode
/// and less in the third.
fn combination_flow(point: &Symmetric, turn: f64, x: [f64; 4]) -> [f64; 4] {
    let modes = Modes::of(point).expect("in range");
    let omega_1 = (point.omega - combination::emanating_frequency(&modes)) / point.k0;
    let flow = combination::slow_flow(&modes, paper_alpha(point).expect("k0"), omega_1, x);
    let [d_2, d_3] = Mode::BOTH.map(|mode| damped::decay_rate(&modes, mode, point.zeta, point.zeta_s));
    // x_1 - i x_2 turns with exp(-i turn t) in the new frame.
    [
        point.k0 * flow[0] - d_2 * x[0] - turn * x[1],
        point.k0 * flow[1] - d_2 * x[1] + turn * x[0],
        point.k0 * flow[2] - d_3 * x[2] + turn * x[3],
        point.k0 * flow[3] - d_3 * x[3] - turn * x[2],
    ]
}

#[test]
fn the_cycles_of_t8_are_cycles_of_the_slow_flow_with_the_stability_they_claim() {
    let (mut stable, mut unstable) = (0, 0);
    for (index, (m, k)) in generated(150).into_iter().enumerate() {
        let modes = Modes::new(m, k).expect("in range");
        let (zeta, zeta_s) = [(0.0, 0.0), (0.004, 0.0), (0.001, 0.006)][index % 3];
        let mut point = symmetric(m, k, [0.3, -0.3][index % 2], zeta, 0.4, 1.0);
        point.zeta_s = zeta_s;
        let omega_0 = combination::emanating_frequency(&modes);
        point.omega = omega_0 + (0.04 * index as f64 - 3.0) * point.k0 * combination::half_width(&modes);
        for cycle in cycles(&point).expect("alpha").into_iter().flatten() {
            // The second mode's frame turns at omega_2 Omega / Omega_0, the cycle at its own frequency.
            let turn = cycle.frequencies[0] - modes.omega[1] * point.omega / omega_0;
            let size = (1.0 + cycle.radius_b + cycle.radius_c) * (1.0 + modes.omega[2]);
            // Of the phase only the sum counts: look for the one that makes the flow vanish, then refine.
            let [h_2, _] = combination::couplings(&modes);
            let [d_2, _] = Mode::BOTH.map(|mode| damped::decay_rate(&modes, mode, zeta, zeta_s));
            let sine = d_2 * cycle.radius_b / (point.k0 * h_2 * cycle.radius_c);
            let sign = if cycle.supercritical == (point.alpha > 0.0) { 1.0 } else { -1.0 };
            let psi = sine.atan2(sign * (1.0 - sine * sine).max(0.0).sqrt());
            let x = [cycle.radius_b, 0.0, cycle.radius_c * psi.cos(), cycle.radius_c * psi.sin()];
            for rate in combination_flow(&point, turn, x) {
                assert_close("[T8]", rate, 0.0, 1e-10 * size);
            }
            let values = eigenvalues(numerical_jacobian(|x| combination_flow(&point, turn, x), x));
            // One eigenvalue is zero, for the phase that nothing fixes; without damping a second, for the family, and
            // rounding splits a double one by its root.
            let rounding = if zeta == 0.0 { 1e-6 } else { 1e-11 };
            let grows = values.iter().any(|value| value.re > rounding * size);
            assert_eq!(cycle.stable, !grows, "m = {m}, k = {k}, zeta = {zeta}: {values:?}");
            if cycle.stable { stable += 1 } else { unstable += 1 }
        }
    }
    assert!(stable > 40 && unstable > 20, "{stable} {unstable}");
}

/// (25), homogeneous, on the manifold `u_g = -u_p`; state `u_p, u, u_p', u'`.
fn manifold_field(point: &Symmetric, t: f64, y: [f64; 4]) -> [f64; 4] {
    let force = 2.0 * point.zeta * y[3] + (1.0 + point.k0 * (point.omega * t).cos()) * y[1];
    let support = 2.0 * point.zeta_s * y[2] + point.k * y[0] + point.alpha * y[0].powi(3);
    let body = -(support + force) / point.m;
    [y[2], y[3], body, 2.0 * body - force]
}

#[test]
fn the_modal_equations_t1_are_the_model() {
    let mut generator = Generator(5);
    for (m, k) in generated(40) {
        let modes = Modes::new(m, k).expect("in range");
        let mut next = || generator.unit() - 0.5;
        let mut point = symmetric(m, k, next(), 0.03, 0.4, 1.3);
        point.zeta_s = 0.1 + 0.1 * next();
        let (q, q_dot) = ([next(), next()], [next(), next()]);
        let in_model =
            |[second, third]: [f64; 2]| [-2.0 * (second + third), modes.a * second + modes.b * third];
        let ([u_p, u], [u_p_dot, u_dot]) = (in_model(q), in_model(q_dot));
        let direct = manifold_field(&point, 0.7, [u_p, u, u_p_dot, u_dot]);
        let modal = in_model(branches::modal_accelerations(&point, 0.7, q, q_dot).expect("in range"));
        let size = (1.0 + k) * (1.0 + k / m) * (1.0 + 1.0 / m);
        assert_close("[T1] u_p", modal[0], direct[2], 1e-12 * size);
        assert_close("[T1] u", modal[1], direct[3], 1e-12 * size);
    }
}

/// One classical Runge-Kutta step after another of [`manifold_field`].
fn integrate(point: &Symmetric, mut state: [f64; 4], time: f64, steps: usize) -> [f64; 4] {
    let field = |t: f64, y: [f64; 4]| manifold_field(point, t, y);
    let h = time / steps as f64;
    for step in 0..steps {
        let t = step as f64 * h;
        let moved = |by: [f64; 4], part: f64| std::array::from_fn(|i| state[i] + part * h * by[i]);
        let first = field(t, state);
        let second = field(t + 0.5 * h, moved(first, 0.5));
        let third = field(t + 0.5 * h, moved(second, 0.5));
        let fourth = field(t + h, moved(third, 1.0));
        for i in 0..4 {
            state[i] += h / 6.0 * (first[i] + 2.0 * second[i] + 2.0 * third[i] + fourth[i]);
        }
    }
    state
}

#[test]
fn the_guess_of_t7_comes_back_after_two_periods_up_to_second_order() {
    for (m, k, mode) in
        [(1.0, 5.0, Mode::Second), (1.0, 5.0, Mode::Third), (0.5, 3.0, Mode::Second), (2.0, 1.0, Mode::Third)]
    {
        let modes = Modes::new(m, k).expect("in range");
        for sign in [1.0, -1.0] {
            let miss = |k0: f64| {
                let zeta = 0.01 * k0;
                let mut point = symmetric(m, k, sign * 0.5 * k0, zeta, k0, 1.0);
                point.omega =
                    primary::emanating_frequency(&modes, mode) + 0.3 * k0 * primary::half_width(&modes, mode);
                let guess = period_two_guess(&point, mode).expect("alpha").expect("exists");
                assert_eq!((guess[0], guess[3]), (-guess[1], -guess[4]));
                let start = [guess[0], guess[2], guess[3], guess[5]];
                let end = integrate(&point, start, 4.0 * PI / point.omega, 4000);
                start.iter().zip(end).map(|(one, other)| (one - other).abs()).fold(0.0, f64::max)
            };
            let (coarse, fine) = (miss(0.02), miss(0.01));
            let order = (coarse / fine).log2();
            assert!((1.8..2.2).contains(&order), "m = {m}, k = {k}, {mode:?}: {coarse} {fine}");
        }
    }
}

#[test]
fn an_orbit_state_without_pulsation_and_cubes_is_the_mode_itself() {
    let modes = Modes::new(1.0, 5.0).expect("in range");
    let point = symmetric(1.0, 5.0, 0.0, 0.0, 0.0, 1.7);
    let state = branches::orbit_state(&modes, &point, Mode::Second, 0.5, 0.0);
    assert_eq!(state, [-1.0, 1.0, 0.5 * modes.a, 0.0, 0.0, 0.0]);
}
