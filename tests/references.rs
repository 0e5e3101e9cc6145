//! Multipliers, periodic orbits and responses against numbers from independent programs.

use crate::common::{floats, numbers, parameters, reference};
use gear_bifurcations::error::{NumericsError, StudyError};
use gear_bifurcations::model::parameters::{Parameters, Regime};
use gear_bifurcations::study::multipliers::multipliers;
use gear_bifurcations::study::orbit::{OrbitOptions, periodic_orbit};
use gear_bifurcations::study::time_response::{TimeResponseOptions, time_response};

/// Greatest distance of each expected complex number from its nearest among the given ones.
fn farthest(expected: &[(f64, f64)], re: &[f64], im: &[f64]) -> f64 {
    expected.iter().fold(0.0, |most, (x, y)| {
        let nearest = re.iter().zip(im).map(|(a, b)| (a - x).hypot(b - y)).fold(f64::INFINITY, f64::min);
        f64::max(most, nearest)
    })
}

fn pairs(array: &serde_json::Value) -> Vec<(f64, f64)> {
    array.as_array().expect("an array").iter().map(|pair| (floats(pair)[0], floats(pair)[1])).collect()
}

#[test]
fn multipliers_agree_to_1e_9() {
    for row in reference("floquet_multipliers").as_array().expect("rows") {
        let found = multipliers(&parameters(&row["params"]), 1e-10).expect("computes");
        let expected = pairs(&row["multipliers"]);
        assert!(farthest(&expected, &found.re, &found.im) < 1e-9, "{row}: {found:?}");
        let radius = expected.iter().map(|(re, im)| re.hypot(*im)).fold(0.0, f64::max);
        assert!((found.spectral_radius - radius).abs() < 1e-9);
        assert!(found.error.liouville.is_some_and(|residual| residual < 1e-11), "{found:?}");
        assert!(found.error.step.is_some_and(|change| change < 1e-9), "{found:?}");
    }
}

#[test]
fn orbits_agree_to_1e_8_from_a_rough_guess_and_from_none() {
    for row in reference("periodic_orbits")["orbits"].as_array().expect("rows") {
        let p = parameters(&row["params"]);
        let period = row["period_in_T"].as_u64().expect("a number") as usize;
        let expected = floats(&row["state"]);
        let rough = std::array::from_fn(|i| 1.02 * expected[i] + 0.01);
        for guess in [None, Some(rough)] {
            let orbit = periodic_orbit(&p, &OrbitOptions { period, guess, ..OrbitOptions::default() })
                .unwrap_or_else(|error| panic!("{}: {error}", row["figure"]));
            for i in 0..6 {
                assert!((orbit.state[i] - expected[i]).abs() < 1e-8, "{}: {orbit:?}", row["figure"]);
                // The file's extrema are those of samples, so that the true ones lie beyond them, by little;
                // those of orbit_branch.json are refined, and agree to 1e-8 below.
                let (low, high) = (floats(&row["min"])[i], floats(&row["max"])[i]);
                assert!(
                    orbit.min[i] < low + 1e-8 && orbit.min[i] > low - 5e-6,
                    "{}: {orbit:?}",
                    row["figure"]
                );
                assert!(
                    orbit.max[i] > high - 1e-8 && orbit.max[i] < high + 5e-6,
                    "{}: {orbit:?}",
                    row["figure"]
                );
            }
            assert!(farthest(&pairs(&row["multipliers"]), &orbit.re, &orbit.im) < 1e-8, "{orbit:?}");
            assert_eq!(orbit.period, period);
            assert!(orbit.stable);
        }
    }
}

#[test]
fn responses_are_found_through_the_folds_of_their_load() {
    for case in reference("folded_responses")["cases"].as_array().expect("cases") {
        let found = periodic_orbit(&parameters(&case["params"]), &OrbitOptions::default()).expect("found");
        assert_eq!(found.period as u64, case["period_in_T"].as_u64().expect("a number"));
        let states = case["states"].as_array().expect("states").iter().map(floats);
        let nearest = states
            .map(|state| {
                state.iter().zip(found.state).fold(0.0_f64, |worst, (one, own)| worst.max((one - own).abs()))
            })
            .fold(f64::INFINITY, f64::min);
        assert!(nearest < 1e-8, "{nearest:e} {found:?}");
    }
}

#[test]
fn a_guess_whose_motion_escapes_leads_to_no_orbit() {
    let options = OrbitOptions { period: 2, guess: Some([9.0; 6]), ..OrbitOptions::default() };
    match periodic_orbit(&numbers(&[("Omega", 1.65)]), &options) {
        Err(StudyError::Numerics(NumericsError::NoConvergence { residual, .. })) => {
            assert!(residual.is_finite() && residual > 1.0);
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn the_branch_of_tongue_2_agrees_at_every_reference_point() {
    for row in reference("orbit_branch")["tongue2"].as_array().expect("rows") {
        let number = |name: &str| row[name].as_f64().expect("a number");
        let p = numbers(&[("Omega", number("Omega"))]);
        let (u_p, velocity) = (number("u_p"), number("u_p_dot"));
        let guess = Some([u_p, -u_p, number("u"), velocity, -velocity, number("u_dot")]);
        let orbit =
            periodic_orbit(&p, &OrbitOptions { period: 2, guess, ..OrbitOptions::default() }).expect("found");
        assert!((orbit.state[0] - u_p).abs() < 1e-8 && (orbit.state[2] - number("u")).abs() < 1e-8);
        assert!((orbit.max[0] - number("max_u_p")).abs() < 1e-8, "{orbit:?}");
        // Stable down to the torus bifurcation at 1.619717349.
        assert_eq!(orbit.stable, number("Omega") > 1.6198, "{orbit:?}");
    }
}

fn figure_14(alpha: f64, regime: Regime) -> Parameters {
    let p = numbers(&[("m", 1.0), ("k", 5.0), ("zeta", 0.07), ("k0", 0.5), ("Omega", 1.6), ("alpha", alpha)]);
    Parameters { load: 1.5, regime, ..p }
}

fn late_range(p: &Parameters, from: f64, periods: f64) -> (f64, f64, Option<f64>, Vec<f64>) {
    let options = TimeResponseOptions { periods, samples_per_period: 400, ..TimeResponseOptions::new(p) };
    let response = time_response(p, &options).expect("computes");
    let late = response.t.iter().zip(&response.states).filter(|(t, _)| **t > from).map(|(_, state)| state[2]);
    let range = late.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), u| (low.min(u), high.max(u)));
    (range.0, range.1, response.escaped, response.contact_loss)
}

#[test]
fn figure_14_a_loses_contact_and_settles_only_with_the_dead_zone() {
    let linear = figure_14(0.0, Regime::Contact);
    let options =
        TimeResponseOptions { periods: 2000.0, samples_per_period: 1, ..TimeResponseOptions::new(&linear) };
    let response = time_response(&linear, &options).expect("computes");
    assert!(response.escaped.is_some(), "the linear system grows without bound");
    let first_loss = response.contact_loss[0];

    let backlash = figure_14(0.0, Regime::Backlash);
    let (low, high, escaped, losses) = late_range(&backlash, 800.0 * 3.93, 900.0);
    assert_eq!(escaped, None);
    assert!((low + 0.4539).abs() < 1e-4 && (high - 4.9618).abs() < 1e-4, "{low} {high}");
    // Up to the first loss both regimes are one system.
    assert!((losses[0] - first_loss).abs() < 1e-7, "{} {first_loss}", losses[0]);
    let orbit =
        periodic_orbit(&backlash, &OrbitOptions { period: 2, ..OrbitOptions::default() }).expect("found");
    assert_eq!((orbit.period, orbit.stable), (2, true));
    assert!((orbit.min[2] + 0.4539).abs() < 1e-4 && (orbit.max[2] - 4.9618).abs() < 1e-4, "{orbit:?}");
}

#[test]
fn figure_14_b_settles_in_contact_the_same_in_both_regimes() {
    for regime in [Regime::Contact, Regime::Backlash] {
        let (low, high, escaped, _) = late_range(&figure_14(-1.3, regime), 300.0 * 3.93, 400.0);
        assert_eq!(escaped, None);
        assert!((low - 2.2497).abs() < 1e-4 && (high - 2.8431).abs() < 1e-4, "{low} {high}");
    }
}

#[test]
fn where_no_orbit_of_period_two_is_the_shorter_one_is_given_as_what_it_is() {
    let between_tongues = numbers(&[("Omega", 3.0), ("k0", 0.1)]);
    let options = OrbitOptions { period: 2, ..OrbitOptions::default() };
    let orbit = periodic_orbit(&between_tongues, &options).expect("found");
    assert_eq!((orbit.period, orbit.stable), (1, true));
    assert!(orbit.state.iter().all(|value| value.abs() < 1e-9), "{orbit:?}");
}
