//! First-order theory against exact multipliers as the pulsation vanishes: the error must fall as its square.

use crate::common::{numbers, reference};
use gear_bifurcations::model::parameters::Parameters;
use gear_bifurcations::study::multipliers::multipliers;
use gear_bifurcations::theory::tongues;

fn damped(k0: f64, zeta: f64) -> Parameters {
    numbers(&[("m", 1.0), ("k", 5.0), ("k0", k0), ("zeta", zeta)])
}

fn radius(p: &Parameters, omega: f64) -> f64 {
    let p = Parameters { omega, omega_p: omega, omega_g: omega, ..*p };
    multipliers(&p, 1e-13).expect("computes").spectral_radius
}

/// The frequency between `inside` and `outside` the tongue at which the spectral radius passes `level`.
fn edge(p: &Parameters, inside: f64, outside: f64, level: f64) -> f64 {
    let (mut inside, mut outside) = (inside, outside);
    assert!(radius(p, inside) > level && radius(p, outside) <= level, "{inside} {outside}");
    for _ in 0..50 {
        let middle = 0.5 * (inside + outside);
        if radius(p, middle) > level {
            inside = middle;
        } else {
            outside = middle;
        }
    }
    0.5 * (inside + outside)
}

#[test]
fn edges_of_theory_err_by_second_order() {
    // Damped in proportion to k0, so that both widths of [T5] and [T6] scale with it.
    let errors = |k0: f64| -> Vec<f64> {
        let p = damped(k0, 0.02 * k0);
        let theory = tongues(&p.symmetric().expect("equal supports")).expect("computes");
        [&theory.primary2, &theory.primary3, &theory.combination]
            .iter()
            .flat_map(|tongue| {
                let edges = tongue.damped.expect("open");
                let width = edges.right - edges.left;
                [
                    edge(&p, tongue.omega_0, edges.left - width, 1.0) - edges.left,
                    edge(&p, tongue.omega_0, edges.right + width, 1.0) - edges.right,
                ]
            })
            .collect()
    };
    let (coarse, fine) = (errors(0.01), errors(0.005));
    for (coarse, fine) in coarse.iter().zip(&fine) {
        let slope = (coarse / fine).abs().log2();
        assert!((slope - 2.0).abs() < 0.15, "slope {slope}: {coarse:e} {fine:e}");
    }
}

#[test]
fn the_printed_combination_width_errs_by_first_order() {
    let error = |k0: f64| {
        let p = damped(k0, 0.0);
        let theory = tongues(&p.symmetric().expect("equal supports")).expect("computes").combination;
        let (paper, corrected) = (theory.paper.expect("open"), theory.corrected.expect("open"));
        // Just above the slack that rounding leaves where multipliers meet.
        let exact = edge(&p, theory.omega_0, paper.right + 0.5 * k0, 1.0 + 1e-6);
        ((paper.right - exact) / k0, (corrected.right - exact) / k0)
    };
    let (coarse, fine) = (error(0.04), error(0.02));
    // The printed half-width is 0.40132, the true one 0.35644.
    assert!((fine.0 - (0.401_317_17 - 0.356_439_78)).abs() < 2e-3, "{fine:?}");
    assert!(fine.0 > 0.9 * coarse.0, "it does not get better");
    assert!(fine.1.abs() < 0.6 * coarse.1.abs() + 1e-4, "{coarse:?} {fine:?}");
}

#[test]
fn the_hill_determinant_agrees_with_the_multipliers_at_the_primary_edges() {
    for (key, k0, zeta) in [("k0=0.5 zeta=0.02", 0.5, 0.02), ("k0=0.2 zeta=0.02", 0.2, 0.02)] {
        let p = damped(k0, zeta);
        let theory = tongues(&p.symmetric().expect("equal supports")).expect("computes");
        for (name, tongue) in [("2w2", &theory.primary2), ("2w3", &theory.primary3)] {
            let row = &reference("tongue_edges")["edges"][key][name];
            let Some(left) = row["left"].as_f64() else { continue };
            let hill = tongue.hill.expect("open");
            assert!((hill.left - left).abs() < 1e-9, "{key} {name}");
            for omega in [hill.left, hill.right] {
                assert!((radius(&p, omega) - 1.0).abs() < 1e-9, "{key} {name} {omega}");
            }
        }
    }
}
