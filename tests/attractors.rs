//! Quasi-periodic motions, Lyapunov exponents, spectra, sweeps and contact margins, against reference numbers and against
//! what must hold whatever the numbers.

use crate::common::{numbers, reference};
use gear_bifurcations::error::{NumericsError, StudyError};
use gear_bifurcations::model::parameters::{Parameters, Regime};
use gear_bifurcations::study::contact::{contact_margin, least_load};
use gear_bifurcations::study::grid::Grid;
use gear_bifurcations::study::lyapunov::lyapunov;
use gear_bifurcations::study::orbit::{OrbitOptions, periodic_orbit};
use gear_bifurcations::study::spectrum::spectrum;
use gear_bifurcations::study::sweep::{Direction, SweepOptions, sweep};
use gear_bifurcations::study::torus::torus;

fn at(omega: f64) -> Parameters {
    numbers(&[("Omega", omega)])
}

#[test]
fn tori_agree_with_the_reference_and_with_their_own_averages() {
    for row in reference("tori")["tori"].as_array().expect("rows") {
        let number = |name: &str| row[name].as_f64().expect("a number");
        let torus = torus(&at(number("Omega")), 1e-10).expect("found");
        assert!((torus.mean_radius - number("mean_radius")).abs() < 1e-6, "{torus:?}");
        assert!((torus.rotation - number("rotation")).abs() < 1e-8, "{}", torus.rotation);
        assert!((torus.r_min - number("r_min")).abs() < 1e-4 && (torus.r_max - number("r_max")).abs() < 1e-4);
        assert!(torus.stable && torus.circles == 1);
        let averages = torus.averages.expect("it attracts");
        let difference = averages.mean_radius - torus.mean_radius;
        assert!(difference.abs() < 1e-7, "{} {difference:e}", torus.mean_radius);
        assert!((averages.rotation - torus.rotation).abs() < 1e-9);
        assert!(torus.error.residual.is_some_and(|defect| defect < 1e-8));
    }
}

#[test]
fn where_there_is_no_torus_it_says_what_there_is() {
    match torus(&at(1.65), 1e-9) {
        Err(StudyError::NotFound { sought: "torus", found }) => {
            assert!(found.contains("period 2 T"), "{found}");
        }
        other => panic!("{other:?}"),
    }
}

/// Next to a tongue's edge motions draw together on rest in thousands of periods, and never look like a circle.
#[test]
fn what_comes_to_rest_slowly_is_no_torus() {
    for p in [at(3.79), numbers(&[("Omega", 3.4), ("m", 1.3), ("k0", 0.4), ("zeta", 0.01)])] {
        match torus(&p, 1e-9) {
            Err(StudyError::NotFound { sought: "torus", found }) => {
                assert!(found.contains("period 1 T"), "{found}");
            }
            other => panic!("{other:?}"),
        }
    }
}

#[test]
fn exponents_of_an_orbit_are_the_logarithms_of_its_multipliers() {
    let p = at(1.65);
    let orbit = periodic_orbit(&p, &OrbitOptions { period: 2, ..OrbitOptions::default() }).expect("found");
    let found = lyapunov(&p, None, 400, 1e-10).expect("computes");
    let time = 2.0 * p.mesh_period();
    for ((re, im), exponent) in orbit.re.iter().zip(orbit.im).zip(found.exponents) {
        assert!((re.hypot(im).ln() / time - exponent).abs() < 1e-9, "{found:?}");
    }
    assert!(found.error.liouville.is_some_and(|residual| residual < 1e-11), "{found:?}");
}

#[test]
fn on_a_torus_one_exponent_vanishes_and_the_next_is_the_growth_across() {
    let p = at(3.7);
    let found = lyapunov(&p, None, 600, 1e-9).expect("computes");
    let torus = torus(&p, 1e-9).expect("found");
    assert!(found.exponents[0].abs() < 1e-5, "{found:?}");
    assert!((found.exponents[1] - torus.growth).abs() < 1e-4, "{found:?} {}", torus.growth);
}

#[test]
fn swept_up_and_down_the_branch_beyond_the_subcritical_edge_is_seen_one_way_only() {
    // Hardening, so that the stable orbits of tongue 3 go on above its right edge.
    let p = numbers(&[("alpha", 0.2)]);
    let largest = |direction: Direction| {
        let omega = Grid::new("Omega", [3.6, 3.9], 31, [0.01, 100.0]).expect("allowed");
        let options = SweepOptions { direction, transient: 300, points: 60, ..SweepOptions::new(omega) };
        let sweep = sweep(&p, &options).expect("computes");
        assert_eq!(sweep.escaped, None);
        assert_eq!(sweep.omega.len(), 31 * 60);
        let near = sweep.omega.iter().zip(&sweep.u_p).filter(|(omega, _)| (**omega - 3.84).abs() < 0.005);
        near.map(|(_, u_p)| u_p.abs()).fold(0.0, f64::max)
    };
    let (up, down) = (largest(Direction::Up), largest(Direction::Down));
    assert!(up > 2.0 && down < 1e-2, "{up} {down}");
}

#[test]
fn the_spectrum_of_an_orbit_holds_half_the_mesh_frequency_and_that_of_a_torus_its_rotation() {
    let orbit = spectrum(&at(1.65), None, 1200, 64, 1e-10).expect("computes");
    assert_eq!(orbit.window, "rectangular");
    let strongest = |amplitude: &[f64]| {
        (1..amplitude.len()).max_by(|&i, &j| amplitude[i].total_cmp(&amplitude[j])).expect("lines")
    };
    assert_eq!(orbit.frequency[strongest(&orbit.amplitude)], 0.5);
    let between = orbit.amplitude.iter().enumerate().filter(|(line, _)| line % 32 != 0);
    assert!(between.map(|(_, amplitude)| *amplitude).fold(0.0, f64::max) < 1e-8);

    let p = at(3.7);
    let found = spectrum(&p, None, 600, 1000, 1e-9).expect("computes");
    assert_eq!(found.window, "Blackman-Harris");
    let line = found.frequency[strongest(&found.amplitude)];
    let rotation = torus(&p, 1e-9).expect("found").rotation;
    let turns = (line - rotation).abs().min((1.0 - line - rotation).abs());
    assert!(turns < 1e-3, "{line} {rotation}");
}

fn figure_14_b() -> Parameters {
    let p = numbers(&[("zeta", 0.07), ("Omega", 1.6), ("alpha", -1.3)]);
    Parameters { load: 1.5, regime: Regime::Contact, ..p }
}

#[test]
fn the_margin_of_figure_14_b_is_that_of_its_settled_motion() {
    let margin = contact_margin(&figure_14_b(), None, 1e-10).expect("found");
    assert!((margin.margin - 1.2497).abs() < 1e-4 && margin.stable, "{margin:?}");
    let given = contact_margin(&figure_14_b(), Some(margin.state), 1e-10).expect("found");
    assert!((given.margin - margin.margin).abs() < 1e-12);
    let backlash = Parameters { regime: Regime::Backlash, ..figure_14_b() };
    assert_eq!(contact_margin(&backlash, None, 1e-10).expect("found").margin, margin.margin);
}

#[test]
fn at_the_least_load_the_teeth_just_touch() {
    for (omega, alpha) in [(1.2, -0.2), (3.0, -0.2), (6.0, -0.2), (2.0, 0.2), (3.0, 0.0)] {
        let p = numbers(&[("Omega", omega), ("alpha", alpha)]);
        let p = Parameters { error: 0.1, regime: Regime::Contact, ..p };
        let least = least_load(&p, 1e-10).expect("computes");
        let load = least.load.expect("there is one");
        assert_eq!(least.contact_load, Some(load));
        let margin = contact_margin(&Parameters { load, ..p }, None, 1e-10).expect("found").margin;
        assert!(margin.abs() < 1e-8, "{omega} {alpha} {load}: {margin}");
        let less = Parameters { load: 0.99 * load, ..p };
        assert!(contact_margin(&less, None, 1e-10).expect("found").margin < 0.0);
    }
}

#[test]
fn without_a_cubic_term_no_load_helps_in_a_tongue() {
    let p = numbers(&[("Omega", 1.6), ("alpha", 0.0)]);
    let p = Parameters { error: 0.1, regime: Regime::Contact, ..p };
    let least = least_load(&p, 1e-10).expect("computes");
    assert_eq!(least.load, None);
    // And in proportion to the error elsewhere, as the problem is linear.
    let load = |error: f64| {
        let p = Parameters { error, ..numbers(&[("Omega", 1.2), ("alpha", 0.0)]) };
        let p = Parameters { regime: Regime::Contact, ..p };
        least_load(&p, 1e-11).expect("computes").load.expect("there is one")
    };
    assert!((load(0.3) - 3.0 * load(0.1)).abs() < 1e-8);
}

#[test]
fn an_escape_is_told_with_its_time() {
    let p = at(1.4);
    let far = Some([8.0, -8.0, 3.0, 5.0, -5.0, 0.0]);
    match lyapunov(&p, far, 100, 1e-8) {
        Err(StudyError::Numerics(NumericsError::Escaped { time })) => assert!(time > 0.0),
        other => panic!("{other:?}"),
    }
}
