//! The theory against reference numbers, against its own identities on generated parameters, and against numerical
//! derivatives and projections of what its formulas are derived from.

use crate::theory_support;

use crate::common::{floats, reference};
use gear_bifurcations::error::{ModelError, TheoryError};
use gear_bifurcations::theory::modes::{self, Modes};
use gear_bifurcations::theory::primary::{self, Branch};
use gear_bifurcations::theory::{
    Mode, combination, combination_exponents, cycles, damped, hill, period_two_guess, primary_exponents,
    tongues,
};
use theory_support::{
    assert_close, determinant, eigenvalues, generated, numerical_jacobian, symmetric, times,
};

#[test]
fn modes_and_half_widths_are_the_reference() {
    let rows = reference("modes_and_tongues");
    let rows = rows.as_array().expect("a list");
    assert_eq!(rows.len(), 4);
    for row in rows {
        let number = |value: &serde_json::Value| value.as_f64().expect("a number");
        let (m, k) = (number(&row["m"]), number(&row["k"]));
        let modes = Modes::new(m, k).expect("in range");
        assert_close("a", modes.a, number(&row["a"]), 1e-12);
        assert_close("b", modes.b, number(&row["b"]), 1e-12);
        for (omega, expected) in modes.omega.into_iter().zip(floats(&row["omega"])) {
            assert_close("omega", omega, expected, 1e-12);
        }
        let tongues = tongues(&symmetric(m, k, 0.0, 0.0, 1.0, 1.0)).expect("in range");
        for (name, tongue) in [
            ("primary2", &tongues.primary2),
            ("primary3", &tongues.primary3),
            ("combination", &tongues.combination),
        ] {
            assert_close(name, tongue.omega_0, number(&row["Omega0"][name]), 1e-12);
        }
        let widths = [
            ("half_width_paper", "primary2", primary::half_width_printed(&modes, Mode::Second)),
            ("half_width_paper", "primary3", primary::half_width_printed(&modes, Mode::Third)),
            ("half_width_paper", "combination_105", combination::half_width_printed(&modes)),
            ("half_width_corrected", "combination_T4", combination::half_width(&modes)),
        ];
        for (table, name, width) in widths {
            assert_close(name, width, number(&row[table][name]), 1e-12);
        }
    }
}

#[test]
fn the_checked_numbers_at_one_and_five() {
    let modes = Modes::new(1.0, 5.0).expect("in range");
    assert_close("W_2", primary::half_width(&modes, Mode::Second), 0.26897851, 5e-9);
    assert_close("W_3", primary::half_width(&modes, Mode::Third), 0.47234004, 5e-9);
    assert_close("W_c", combination::half_width(&modes), 0.35643978, 5e-9);
    assert_close("(105)", combination::half_width_printed(&modes), 0.40131717, 5e-9);
    assert_close("edge of (106)-(109)", combination::printed_solutions_edge(&modes), 0.42090, 1e-5);
    let [h_2, h_3] = combination::couplings(&modes);
    assert_close("growth", (h_2 * h_3).sqrt(), 0.17822, 5e-6);
    assert_close("growth at the centre", combination::growth_rates(&modes, 0.0)[0].re, 0.17822, 5e-6);
    assert_close("d_2", damped::decay_rate(&modes, Mode::Second, 1.0, 1.0), 0.492443, 5e-7);
    assert_close("d_3", damped::decay_rate(&modes, Mode::Third, 1.0, 1.0), 3.507557, 5e-7);
    let uncoupled = Modes::new(1.0, 1.0).expect("in range");
    assert_eq!(modes::shape_products(uncoupled.k)[2], 0.0);
    assert_close("W_c at k = 1", combination::half_width(&uncoupled), 0.2041, 5e-5);
}

#[test]
fn the_damped_combination_tongue_is_half_as_wide_again_as_damping_vanishes() {
    let modes = Modes::new(1.0, 5.0).expect("in range");
    let light = symmetric(1.0, 5.0, 0.0, 1e-9, 0.1, 1.0);
    let width = damped::combination_half_width(&modes, &light).expect("open");
    assert_close("ratio", width / (0.1 * combination::half_width(&modes)), 1.52, 5e-3);
}

#[test]
fn tongues_without_pulsation_are_closed_and_bad_input_is_named() {
    let closed = tongues(&symmetric(1.0, 5.0, 0.0, 0.0, 0.0, 1.0)).expect("in range");
    for tongue in [closed.primary2, closed.primary3, closed.combination] {
        assert_eq!((tongue.paper, tongue.corrected, tongue.damped, tongue.hill), (None, None, None, None));
        assert_eq!((tongue.hill_error, tongue.threshold), (None, 0.0));
    }
    assert!(matches!(
        Modes::new(-1.0, 5.0),
        Err(TheoryError::Model(ModelError::OutOfRange { given: -1.0, .. }))
    ));
    assert!(matches!(
        Modes::new(1.0, f64::NAN),
        Err(TheoryError::Model(ModelError::NotANumber { parameter, .. })) if parameter == "k"
    ));
    let modes = Modes::new(1.0, 5.0).expect("in range");
    assert_eq!(
        primary::radius_squared(&modes, Mode::Third, Branch::Cosine, 0.0, 0.1),
        Err(TheoryError::Vanishing { parameter: "alpha", equation: "(89)" })
    );
    assert_eq!(
        modes::paper_alpha(&symmetric(1.0, 5.0, 0.2, 0.0, 0.0, 1.0)),
        Err(TheoryError::Vanishing { parameter: "k0", equation: "(27)" })
    );
}

#[test]
fn the_modes_satisfy_what_the_paper_says_of_them() {
    for (m, k) in generated(200) {
        let modes = Modes::new(m, k).expect("in range");
        let omega_0 = 0.5 + m;
        assert_close("(38)", modes.a, modes::constant_a(m, k), 1e-11 * (1.0 + m + k));
        assert_close("(39)", modes.b, modes::constant_b(m, k), 1e-11 * (1.0 + m + k));
        assert_close("(40)", modes.a * modes.b / modes::product_a_b(k), 1.0, 1e-14);
        assert_close("(42)", modes::discriminant(m, k) / ((m + k + 2.0).powi(2) - 4.0 * k * m), 1.0, 1e-13);
        assert!(modes::discriminant(m, k) > 0.0);
        let [_, second, third] = modes.shapes();
        let product: f64 = second.iter().zip(third).map(|(one, other)| one * other).sum();
        assert_close("(41)", product, modes::shape_products(k)[2], 1e-12 * (1.0 + k));
        let doubled = modes::twice_k_minus(m, k);
        assert_close("(43)", doubled[0], 2.0 * k - modes.a, 1e-11 * (1.0 + m + k));
        assert_close("(43)", doubled[1], 2.0 * k - modes.b, 1e-11 * (1.0 + m + k));
        assert_close("(44)", modes.sigma(Mode::Third) * 2.0 * m / doubled[1], 1.0, 1e-13);
        let squares = modes::natural_frequencies_squared(&modes, omega_0);
        assert_close("(45)", squares[1] * squares[2] / modes::frequency_product(&modes, omega_0), 1.0, 1e-13);
        assert_close("(46)", squares[0] / modes::first_frequency_squared(&modes, omega_0), 1.0, 1e-13);
        for (lambda_squared, shape) in
            modes::eigenvalue_squares(&modes, omega_0).into_iter().zip(modes.shapes())
        {
            let corrected = modes::characteristic_matrix(m, k, omega_0, lambda_squared);
            for entry in times(corrected, shape) {
                assert_close("(35), (37)", entry, 0.0, 1e-12 * (1.0 + m + k) * (1.0 + k));
            }
        }
        let printed = modes::characteristic_matrix_printed(m, k, omega_0, -squares[1]);
        assert!(determinant(printed).abs() > 1e-6, "(35) as printed is singular at m = {m}, k = {k}");
        for mode in Mode::BOTH {
            let left = modes.left_shape(mode);
            let through = |other: Mode| -> f64 {
                times(modes::mass_matrix(m), modes.shape(other))
                    .iter()
                    .zip(left)
                    .map(|(one, two)| one * two)
                    .sum()
            };
            let own = modes.coefficient(mode) - modes.coefficient(mode.partner());
            assert_close("l_j M v_j", through(mode) / own, 1.0, 1e-10);
            assert_close("l_j M v_i", through(mode.partner()) / own, 0.0, 1e-9);
            assert_close(
                "[T3]",
                primary::half_width_printed(&modes, mode) / primary::half_width(&modes, mode),
                1.0,
                1e-8,
            );
        }
        let widths = Mode::BOTH.map(|mode| primary::half_width(&modes, mode));
        assert_close("[T4]", combination::half_width(&modes) / (widths[0] * widths[1]).sqrt(), 1.0, 1e-13);
        let sum = combination::emanating_frequency(&modes);
        assert_close("(102)", sum * sum / ((m + k + 2.0) / m + 2.0 * (k / m).sqrt()), 1.0, 1e-13);
    }
}

#[test]
fn the_primary_jacobian_is_the_derivative_and_printed_90_is_not() {
    for (index, (m, k)) in generated(40).into_iter().enumerate() {
        let modes = Modes::new(m, k).expect("in range");
        for mode in Mode::BOTH {
            let width = primary::half_width(&modes, mode);
            let (alpha, omega_1) =
                (if index % 2 == 0 { 0.4 } else { -0.4 }, width * (0.13 * index as f64 - 2.6));
            let x = [0.7, -0.4 - 0.01 * index as f64];
            let numerical = numerical_jacobian(|x| primary::slow_flow(&modes, mode, alpha, omega_1, x), x);
            let [analytic, printed] = [primary::jacobian, primary::jacobian_printed]
                .map(|jacobian| jacobian(&modes, mode, alpha, omega_1, x));
            let worst = |jacobian: [[f64; 2]; 2]| {
                let pairs = jacobian.iter().flatten().zip(numerical.iter().flatten());
                pairs.map(|(one, other)| (one - other).abs()).fold(0.0, f64::max)
            };
            assert!(worst(analytic) < 1e-8 * (1.0 + k), "{mode:?} at m = {m}, k = {k}");
            let factor = modes.weight(mode) / (2.0 * primary::emanating_frequency(&modes, mode));
            let expected = if mode == Mode::Second { 0.0 } else { 2.0 * factor * width };
            assert_close("(90)", worst(printed), expected, 1e-8 * (1.0 + k));
            for (jacobian, value) in [
                (analytic, primary::determinant(&modes, mode, alpha, omega_1, x)),
                (printed, primary::determinant_printed(&modes, mode, alpha, omega_1, x)),
            ] {
                let direct = jacobian[0][0] * jacobian[1][1] - jacobian[0][1] * jacobian[1][0];
                assert_close("(67), (91)", value, direct, 1e-11 * (1.0 + direct.abs()) * (1.0 + k * k));
                for lambda in eigenvalues(jacobian) {
                    // The trace is zero, so that the square of an eigenvalue is real.
                    let square = (lambda * lambda).re;
                    let residual = primary::characteristic_polynomial(0.0, value, square.abs().sqrt());
                    let expected = if square > 0.0 { 0.0 } else { 2.0 * value };
                    assert_close("(66)", residual, expected, 1e-9 * (1.0 + value.abs()));
                }
            }
        }
    }
}

#[test]
fn equilibria_satisfy_the_slow_flow_and_their_determinants_follow() {
    let branches = [Branch::Origin, Branch::Sine, Branch::Cosine];
    let mut existing = 0;
    for (index, (m, k)) in generated(60).into_iter().enumerate() {
        let modes = Modes::new(m, k).expect("in range");
        for (mode, branch) in Mode::BOTH.into_iter().flat_map(|mode| branches.map(|branch| (mode, branch))) {
            let alpha = [0.3, -0.3][index % 2];
            let omega_1 = primary::half_width(&modes, mode) * (0.05 * index as f64 - 1.52);
            let square = primary::radius_squared(&modes, mode, branch, alpha, omega_1).expect("alpha");
            let exists = primary::exists(&modes, mode, branch, alpha, omega_1);
            assert_eq!(exists, square > 0.0 || branch == Branch::Origin, "{mode:?} {branch:?}");
            if !exists {
                continue;
            }
            existing += 1;
            let x = if branch == Branch::Cosine { [square.sqrt(), 0.0] } else { [0.0, square.sqrt()] };
            let angle = x[1].atan2(x[0]);
            let factor = modes.weight(mode) / (2.0 * primary::emanating_frequency(&modes, mode));
            let scale = 1.0 + factor * (omega_1.abs() + primary::half_width(&modes, mode));
            for residual in primary::slow_flow(&modes, mode, alpha, omega_1, x)
                .into_iter()
                .chain(primary::slow_flow_polar(&modes, mode, alpha, omega_1, square.sqrt(), angle))
            {
                assert_close("(58)-(61)", residual, 0.0, 1e-12 * scale * (1.0 + square.sqrt()));
            }
            let there = primary::determinant_at(&modes, mode, branch, omega_1);
            let direct = primary::determinant(&modes, mode, alpha, omega_1, x);
            assert_close("(68)-(70)", there, direct, 1e-12 * scale * scale);
            let printed = primary::determinant_printed(&modes, mode, alpha, omega_1, x);
            if mode == Mode::Third && branch != Branch::Origin {
                assert!((printed - direct).abs() > 0.1 * direct.abs(), "(91) as printed gives (93), (94)");
            }
            // By the letter of (69) and (70).
            let (own, partner) = (modes.coefficient(mode), modes.coefficient(mode.partner()));
            let omega_0 = primary::emanating_frequency(&modes, mode);
            let edge = own * (partner + 2.0 * m + 4.0) / (2.0 * m * omega_0 * (own - partner));
            let letter =
                own.powi(3) * (partner + 2.0 * m + 4.0) * (own - partner) / (2.0 * m * omega_0.powi(3));
            match branch {
                Branch::Origin => {}
                Branch::Sine => assert_close("(69)", there, letter * (omega_1 + edge), 1e-9 * scale * scale),
                Branch::Cosine => {
                    assert_close("(70)", there, -letter * (omega_1 - edge), 1e-9 * scale * scale);
                }
            }
        }
    }
    assert!(existing > 180, "{existing}");
}

#[test]
fn the_hill_determinant_gives_the_exact_primary_edges() {
    let all = &reference("tongue_edges")["edges"];
    for k0 in ["0.5", "0.2", "0.1", "0.05"] {
        for zeta in ["0", "0.02"] {
            for (name, mode) in [("2w2", Mode::Second), ("2w3", Mode::Third)] {
                let expected = &all[format!("k0={k0} zeta={zeta}")][name];
                let point = symmetric(1.0, 5.0, 0.0, zeta.parse().unwrap(), k0.parse().unwrap(), 1.0);
                let edges = hill::edges(&point, mode).expect("followed");
                if expected.is_null() {
                    assert_eq!(edges, None, "{name} at k0 = {k0}, zeta = {zeta}");
                } else {
                    let edges = edges.expect("open");
                    assert_close("left", edges.left, expected["left"].as_f64().expect("a number"), 1e-9);
                    assert_close("right", edges.right, expected["right"].as_f64().expect("a number"), 1e-9);
                }
            }
        }
    }
}

#[test]
fn the_hill_tips_are_the_reference_and_without_damping_at_zero() {
    for (name, mode) in [("zeta=0.02 2w2", Mode::Second), ("zeta=0.02 2w3", Mode::Third)] {
        let expected = &reference("tongue_edges")["tips"][name];
        let tip = hill::tip(&symmetric(1.0, 5.0, 0.0, 0.02, 1.0, 1.0), mode).expect("found").expect("open");
        assert_close("k0", tip.k0, expected["k0_min"].as_f64().expect("a number"), 1e-8);
        assert_close("Omega", tip.omega, expected["W"].as_f64().expect("a number"), 1e-6);
        let undamped =
            hill::tip(&symmetric(1.0, 5.0, 0.0, 0.0, 1.0, 1.0), mode).expect("found").expect("open");
        assert_eq!(undamped.k0, 0.0);
        assert_eq!(hill::tip(&symmetric(1.0, 5.0, 0.0, 2.0, 1.0, 1.0), mode), Ok(None));
    }
}

#[test]
fn on_a_hill_edge_the_whole_matrix_of_both_modes_is_singular() {
    for (index, (m, k)) in [(1.0, 5.0), (2.0, 1.0), (0.5, 3.0), (3.0, 10.0)].into_iter().enumerate() {
        for (mode, zeta) in
            [(Mode::Second, 0.0), (Mode::Second, 0.004), (Mode::Third, 0.0), (Mode::Third, 0.004)]
        {
            let mut point = symmetric(m, k, 0.0, zeta, 0.4, 1.0);
            point.zeta_s = 0.5 * zeta * index as f64;
            let Some(edges) = hill::edges(&point, mode).expect("followed") else { continue };
            for edge in [edges.left, edges.right] {
                let [on, off] =
                    [edge, edge * 1.01].map(|omega| theory_support::hill_matrix_gap(&point, omega, 15));
                assert!(on < 1e-11 && off > 1e-5, "m = {m}, k = {k}, {mode:?}, zeta = {zeta}: {on} {off}");
            }
        }
    }
}

#[test]
fn hill_edges_of_rigid_supports_are_those_of_mathieu() {
    // DLMF 28.6 at q = 0.1: a = 4/Omega^2, q = 2 k0/Omega^2; supports a million times stiffer than the mesh.
    for (characteristic, left) in [(1.098734312963, true), (0.898765556994, false)] {
        let omega = 2.0 / f64::sqrt(characteristic);
        let point = symmetric(1.0, 1e6, 0.0, 0.0, 0.05 * omega * omega, 1.0);
        let edges = hill::edges(&point, Mode::Second).expect("followed").expect("open");
        assert_close("Mathieu", if left { edges.left } else { edges.right }, omega, 5e-6);
    }
}

#[test]
fn omega_2_is_the_second_order_of_the_edges() {
    for (m, k) in [(1.0, 5.0), (2.0, 1.0), (0.5, 3.0), (3.0, 10.0)] {
        let modes = Modes::new(m, k).expect("in range");
        for mode in Mode::BOTH {
            let omega_2 = hill::omega_2(&modes, mode).expect("no resonance");
            let error = |k0: f64| {
                let edges =
                    hill::edges(&symmetric(m, k, 0.0, 0.0, k0, 1.0), mode).expect("followed").expect("open");
                let middle = 0.5 * (edges.left + edges.right) - primary::emanating_frequency(&modes, mode);
                (middle / (k0 * k0) - omega_2).abs()
            };
            // The two edges are even and odd in k0: what is left of their mean is of the fourth order.
            let (coarse, fine) = (error(0.04), error(0.02));
            assert!(fine < 3e-3 * (1.0 + omega_2.abs()), "{mode:?} m = {m}, k = {k}: {fine}");
            assert!((3.5..4.5).contains(&(coarse / fine)), "{mode:?} m = {m}, k = {k}: {coarse} {fine}");
        }
    }
}

#[test]
fn hill_edges_are_found_over_the_parameters() {
    let mut compared = 0;
    for (m, k) in generated(60) {
        let modes = Modes::new(m, k).expect("in range");
        for (mode, k0) in [(Mode::Second, 0.1), (Mode::Third, 0.1), (Mode::Second, 0.01), (Mode::Third, 0.01)]
        {
            let what = format!("{mode:?} m = {m}, k = {k}, k0 = {k0}");
            let point = symmetric(m, k, 0.0, 0.0, k0, 1.0);
            let edges = hill::edges(&point, mode).expect("followed").expect("open");
            for edge in [edges.left, edges.right] {
                let gap = theory_support::hill_matrix_gap(&point, edge, 15);
                assert!(gap < 1e-11, "{what}: {gap}");
            }
            // Where the third harmonic meets the other mode, the first order is no guide to the width.
            let ratio = 3.0 * modes.frequency(mode) / modes.frequency(mode.partner());
            if (ratio - 1.0).abs() > 0.15 {
                compared += 1;
                let width = (edges.right - edges.left) / (2.0 * k0 * primary::half_width(&modes, mode));
                assert_close(&what, width, 1.0, 2.0 * k0);
            }
        }
    }
    assert!(compared > 180, "{compared}");
}

#[test]
fn every_answer_is_a_number_over_the_whole_range_of_parameters() {
    let ends = [1e-3, 1.0, 1e6];
    for (m, k) in ends.into_iter().flat_map(|m| ends.map(|k| (m, k))) {
        for (zeta, k0) in [(0.0, 1e-12), (0.0, 1.0), (1e-9, 1.0), (0.02, 0.5), (2.0, 1.0)] {
            let mut widths = vec![];
            let all = tongues(&symmetric(m, k, 0.0, zeta, k0, 1.0)).expect("in range");
            for tongue in [&all.primary2, &all.primary3, &all.combination] {
                widths.extend([tongue.omega_0, tongue.threshold]);
                let edges = [tongue.paper, tongue.corrected, tongue.damped, tongue.hill];
                widths.extend(edges.into_iter().flatten().flat_map(|edges| [edges.left, edges.right]));
            }
            assert!(widths.iter().all(|value| value.is_finite()), "{m} {k} {zeta} {k0}: {widths:?}");
            for alpha in [-1e3, 1e-9, 1e3] {
                for omega in [0.01, 1.0, 100.0] {
                    let point = symmetric(m, k, alpha, zeta, k0, omega);
                    let mut values = vec![];
                    for mode in Mode::BOTH {
                        values.extend(period_two_guess(&point, mode).expect("alpha").into_iter().flatten());
                        values.extend(
                            primary_exponents(&point, mode).expect("in range").map(nalgebra::Complex::norm),
                        );
                    }
                    values.extend(
                        combination_exponents(&point).expect("in range").map(nalgebra::Complex::norm),
                    );
                    for cycle in cycles(&point).expect("alpha").into_iter().flatten() {
                        values.extend([
                            cycle.radius_b,
                            cycle.radius_c,
                            cycle.frequencies[0],
                            cycle.frequencies[1],
                        ]);
                    }
                    assert!(values.iter().all(|value| value.is_finite()), "{point:?}: {values:?}");
                }
            }
        }
    }
}
