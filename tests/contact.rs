//! Contact margins and least loads against one another and against motions in the dead zone.

use crate::common::numbers;
use gear_bifurcations::model::parameters::{Parameters, Regime};
use gear_bifurcations::study::contact::{LeastLoadWork, contact_margin, least_load, least_load_curve};
use gear_bifurcations::study::grid::Grid;
use gear_bifurcations::study::orbit::{OrbitOptions, periodic_orbit};
use gear_bifurcations::study::sweep::at_frequency;
use gear_bifurcations::study::time_response::{TimeResponseOptions, time_response};

fn with_error(alpha: f64) -> Parameters {
    Parameters { error: 0.1, regime: Regime::Contact, ..numbers(&[("alpha", alpha)]) }
}

#[test]
fn the_curve_is_made_of_least_loads_and_at_each_of_them_the_teeth_just_touch() {
    let p = with_error(-0.2);
    let omega = Grid::new("Omega", [1.0, 6.0], 9, [0.01, 100.0]).expect("allowed");
    let curve = least_load_curve(&p, omega, 1e-9).expect("computes");
    assert_eq!(curve.omega, (0..9).map(|index| omega.value(index)).collect::<Vec<_>>());
    let mut touching = 0;
    for index in 0..9 {
        let here = at_frequency(&p, curve.omega[index]);
        let one = least_load(&here, 1e-9).expect("computes");
        assert_eq!((one.load, one.contact_load), (curve.load[index], curve.contact_load[index]));
        assert_eq!(one.reason, curve.reason[index]);
        assert_eq!(one.load.is_none(), one.reason.is_some());
        let Some(load) = one.load.filter(|load| *load > 0.0 && one.contact_load == Some(*load)) else {
            continue;
        };
        let margin =
            |load: f64| contact_margin(&Parameters { load, ..here }, one.state, 1e-9).expect("found").margin;
        assert!(margin(load).abs() < 1e-7, "{} {load}", curve.omega[index]);
        assert!(margin(0.999 * load) < 0.0 && margin(1.001 * load) > 0.0);
        touching += 1;
    }
    assert!(touching >= 5, "{curve:?}");
    let mut work = LeastLoadWork::new(&p, omega, 1e-9).expect("allowed");
    while !work.advance().expect("computes") {}
    assert_eq!(*work.curve(), curve);
}

#[test]
fn a_margin_above_zero_is_that_of_the_true_motion_and_below_zero_the_true_one_parts() {
    let pair = numbers(&[("zeta", 0.07), ("Omega", 3.0), ("alpha", -0.2)]);
    let backlash = |load: f64| Parameters { load, error: 0.1, regime: Regime::Backlash, ..pair };
    let needed = least_load(&backlash(1.0), 1e-10).expect("computes").load.expect("there is one");
    for (share, parts) in [(1.05, false), (0.9, true), (0.6, true)] {
        let p = backlash(share * needed);
        let margin = contact_margin(&p, None, 1e-10).expect("found");
        assert_eq!(margin.margin < 0.0, parts, "{margin:?}");
        let orbit =
            periodic_orbit(&p, &OrbitOptions { guess: Some(margin.state), ..OrbitOptions::default() });
        let orbit = orbit.expect("found");
        let options = TimeResponseOptions {
            state: orbit.state,
            periods: orbit.period as f64,
            samples_per_period: 400,
            ..TimeResponseOptions::new(&p)
        };
        let response = time_response(&p, &options).expect("computes");
        let least = response.states.iter().map(|state| state[2]).fold(f64::INFINITY, f64::min);
        // Samples come near the least value, and not below it.
        assert!(least >= orbit.min[2] - 1e-9 && least - orbit.min[2] < 1e-3);
        assert_eq!(response.contact_loss.is_empty(), !parts, "{:?}", response.contact_loss);
        if parts {
            assert!(orbit.min[2] < 1.0, "{orbit:?}");
        } else {
            assert!((orbit.min[2] - 1.0 - margin.margin).abs() < 1e-9);
            assert!(orbit.state.iter().zip(margin.state).all(|(a, b)| (a - b).abs() < 1e-8));
        }
    }
}
