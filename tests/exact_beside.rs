//! The exact answers beside the formulas of the paper's figures, against the studies asked directly.

use gear_bifurcations::chart::drawing::{Drawing, Role, Series};
use gear_bifurcations::figures::{Figure, Job, figure, specification};
use gear_bifurcations::model::parameters::{Parameters, Regime};
use gear_bifurcations::study::multipliers::multipliers;
use gear_bifurcations::study::orbit::{OrbitOptions, periodic_orbit};
use gear_bifurcations::study::tongue::{Tongue, tongue_edges};
use gear_bifurcations::theory::{Mode, Modes, combination, primary};

fn made(id: &str) -> Figure {
    figure(id, &[]).unwrap_or_else(|error| panic!("figure {id}: {error}"))
}

fn series<'a>(drawing: &'a Drawing, name: &str) -> &'a Series {
    drawing.series.iter().find(|series| series.name == name).unwrap_or_else(|| panic!("no series {name:?}"))
}

#[test]
fn the_exact_answer_comes_after_the_formulas() {
    for id in ["3", "5", "6", "7", "9", "10"] {
        let mut job = Job::new(id, &[]).expect("valid");
        assert!(!job.advance().expect("formulas"), "{id}");
        let formulas = job.figure();
        assert!(formulas.drawing.series.iter().any(|series| series.role == Role::Paper), "{id}");
        let exact = |role: Role| matches!(role, Role::Exact | Role::QuasiPeriodic | Role::TorusBifurcation);
        assert!(!formulas.drawing.series.iter().any(|series| exact(series.role)), "{id}");
        let whole = made(id);
        assert!(whole.drawing.series.iter().any(|series| exact(series.role)), "{id}");
        assert!(whole.method.contains("exact"), "{id}: {}", whole.method);
        assert!(whole.error.residual.is_some(), "{id}");
        let told = |note: &String| note.contains("off by") || note.contains("apart");
        assert!(whole.notes.iter().any(told), "{id}: {:?}", whole.notes);
    }
}

#[test]
fn exact_amplitudes_are_those_of_the_orbit() {
    let figure = made("5");
    let modes = Modes::new(1.0, 5.0).expect("valid");
    let line = series(&figure.drawing, "exact softening 3 stable");
    let other = series(&figure.drawing, "exact softening opposite 3 stable");
    let middle = line.x.len() / 2;
    let omega = primary::emanating_frequency(&modes, Mode::Third) + 0.5 * line.x[middle];
    let mut p = specification("5").expect("known").with(&[]).expect("valid");
    (p.alpha_p, p.alpha_g) = (-0.2, -0.2);
    let at = Parameters { omega, omega_p: omega, omega_g: omega, ..p };
    let orbit =
        periodic_orbit(&at, &OrbitOptions { period: 2, ..OrbitOptions::default() }).expect("in the tongue");
    // The mode's share of u_p is 2 R cos(Omega t/2): what is left of the greatest |u_p| are small harmonics.
    assert!(
        (2.0 * line.y[middle] - orbit.max[0]).abs() < 0.03 * orbit.max[0],
        "{} {}",
        line.y[middle],
        orbit.max[0]
    );
    assert_eq!(line.y[middle], -other.y[middle]);
}

#[test]
fn exact_exponents_are_logarithms_of_the_multipliers() {
    let figure = made("6");
    let omega_0 = combination::emanating_frequency(&Modes::new(1.0, 5.0).expect("valid"));
    let mut compared = 0;
    let lines = figure
        .drawing
        .series
        .iter()
        .filter(|line| line.name.starts_with("re exact") && line.name.ends_with("growing"));
    for line in lines {
        for (omega_1, re) in line.x.iter().zip(&line.y).step_by(7).filter(|(_, re)| **re > 1e-3) {
            let omega = omega_0 + 0.5 * omega_1;
            let p = Parameters {
                omega,
                omega_p: omega,
                omega_g: omega,
                regime: Regime::Homogeneous,
                ..Parameters::default()
            };
            let radius = multipliers(&p, 1e-10).expect("regular").spectral_radius;
            assert!((re - radius.ln() / p.mesh_period()).abs() < 1e-9, "{omega_1} {re}");
            compared += 1;
        }
    }
    assert!(compared > 4);
    let edges = series(&figure.drawing, "exact edges re");
    let exact = tongue_edges(&Parameters::default(), Tongue::Combination, 1e-9).expect("open");
    assert!((omega_0 + 0.5 * edges.x[0] - exact.left.expect("open")).abs() < 1e-9);
    assert!((omega_0 + 0.5 * edges.x[1] - exact.right.expect("open")).abs() < 1e-9);
}

#[test]
fn maps_show_their_exact_attractors() {
    let nodes = made("13a");
    let points = series(&nodes.drawing, "exact points");
    let node = series(&nodes.drawing, "node 1");
    for (x, y) in points.x.iter().zip(&points.y) {
        assert!(node.x.iter().zip(&node.y).any(|(u, v)| (u - x).hypot(v - y) < 1e-8), "{x} {y}");
    }
    let cycle = made("12c");
    let circle = series(&cycle.drawing, "exact circle");
    let reach = |line: &Series| line.x.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let late = series(&cycle.drawing, "limit cycle");
    assert!((reach(circle) - reach(late)).abs() < 2e-3 * reach(late), "{} {}", reach(circle), reach(late));
    assert!(cycle.notes.iter().any(|note| note.contains("[T8]") && note.contains("off by")));
}
