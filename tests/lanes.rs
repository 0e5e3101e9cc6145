//! Motions carried side by side on the manifold `u_g = -u_p` against the whole model.

use gear_bifurcations::model::equations::GearPair;
use gear_bifurcations::model::lanes::{LANES, OnManifold, SIZE, lane, set_lane};
use gear_bifurcations::model::parameters::{Parameters, Regime};
use gear_bifurcations::numerics::ode::taylor::{Options, integrate};

#[test]
fn every_lane_is_the_motion_of_the_whole_model() {
    let contact = Parameters {
        regime: Regime::Contact,
        load: 0.7,
        error: 0.1,
        load_p: 0.2,
        omega_p: 0.8,
        zeta_p: 0.05,
        zeta_g: 0.05,
        ..Parameters::default()
    };
    for p in [Parameters::default(), contact] {
        let lanes = OnManifold::new(&p).expect("equal supports");
        let starts: [[f64; 6]; LANES] = std::array::from_fn(|lane| {
            let x = 0.3 * lane as f64 - 0.4;
            [x, -x, 1.0 + 0.5 * x, 0.2, -0.2, -x]
        });
        let mut all = [0.0; SIZE];
        starts.iter().enumerate().for_each(|(index, start)| set_lane(&mut all, index, start));
        let options = Options { tolerance: 1e-13, ..Options::default() };
        let end = integrate::<_, SIZE, 13>(&lanes, 0.3, all, 9.0, options).expect("integrates");
        for (index, start) in starts.into_iter().enumerate() {
            let expected =
                integrate::<_, 6, 17>(&GearPair::new(&p), 0.3, start, 9.0, options).expect("integrates");
            for (found, expected) in lane(&end, index).into_iter().zip(expected) {
                assert!((found - expected).abs() < 1e-11, "{index}: {found} {expected}");
            }
        }
    }
}

#[test]
fn where_the_manifold_is_not_invariant_there_are_no_lanes() {
    assert!(OnManifold::new(&Parameters { k_g: 6.0, ..Parameters::default() }).is_none());
    assert!(OnManifold::new(&Parameters { regime: Regime::Backlash, ..Parameters::default() }).is_none());
}
