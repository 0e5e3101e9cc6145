//! Orbits whose multipliers are large, where one shot over the period cannot hit its end.

use crate::common::numbers;
use gear_bifurcations::model::equations::GearPair;
use gear_bifurcations::model::parameters::Parameters;
use gear_bifurcations::numerics::floquet::{self, Matrix6};
use gear_bifurcations::numerics::periodic::{fixed_point, matrix};
use gear_bifurcations::numerics::{multiple_shooting, newton};
use gear_bifurcations::study::branch::{Branch, BranchOptions, branch};
use gear_bifurcations::study::multipliers::{Budget, image, image_between};
use gear_bifurcations::study::orbit::{OrbitOptions, periodic_orbit};

/// The branch of tongue 3, along which the multipliers grow by ten powers of ten. The orbits are opposite after one
/// mesh period, so that the branch itself follows them over half of their period only.
fn steepening() -> (Parameters, Branch) {
    let p = numbers(&[("Omega", 5.55)]);
    let found = branch(&p, &BranchOptions::new([2.0, 6.0], 2)).expect("a branch");
    (p, found)
}

fn radius(branch: &Branch, index: usize) -> f64 {
    branch.re[index][0].hypot(branch.im[index][0])
}

fn at(p: &Parameters, branch: &Branch, index: usize) -> Parameters {
    let omega = branch.value[index];
    Parameters { omega, omega_p: omega, omega_g: omega, ..*p }
}

/// A point of the branch whose largest multiplier is in a range.
fn between(branch: &Branch, least: f64, most: f64) -> usize {
    let within = |i: &usize| (least..most).contains(&radius(branch, *i));
    (0..branch.value.len()).find(within).unwrap_or_else(|| {
        panic!(
            "none from {least} to {most}: {:?}",
            (0..branch.value.len()).map(|i| radius(branch, i)).fold(0.0, f64::max)
        )
    })
}

#[test]
fn what_one_shot_misses_several_hit() {
    let (p, found) = steepening();
    for (least, most, off) in [(1e7, 1e8, 1e-5), (1e8, 1e9, 1e-6), (1e9, 1e10, 1e-6)] {
        let index = between(&found, least, most);
        let there = at(&p, &found, index);
        let mut guess = found.state[index];
        guess[0] += off;
        guess[4] -= off;
        let pair = GearPair::new(&there);
        let bounds = newton::Options { tolerance: 1e-10, ..newton::Options::default() };
        let budget = Budget::default();
        let single = fixed_point(guess, bounds, |state| image(&pair, state, 2, 1e-10, 1.0, &budget));
        let hit = single.is_ok_and(|solution| (solution.point[0] - found.state[index][0]).abs() < 1e-6);
        assert!(!hit, "one shot is enough at {least:e}");
        let options = OrbitOptions { period: 2, guess: Some(guess), tolerance: 1e-10 };
        let orbit = periodic_orbit(&there, &options).unwrap_or_else(|error| panic!("{least:e}: {error}"));
        assert!(orbit.method.starts_with("multiple shooting") && orbit.period == 2, "{}", orbit.method);
        for i in 0..6 {
            assert!((orbit.state[i] - found.state[index][i]).abs() < 1e-7, "{least:e}: {:?}", orbit.state);
        }
        let expected = radius(&found, index);
        let largest = orbit.re[0].hypot(orbit.im[0]);
        assert!((largest / expected - 1.0).abs() < 1e-4, "{least:e}: {largest:e} {expected:e}");
        assert!(orbit.error.residual.expect("given") < 1e-8);
    }
}

#[test]
fn one_shot_and_several_agree_where_both_hit() {
    let (p, found) = steepening();
    for (least, most) in [(1.5, 10.0), (1e2, 1e3), (1e4, 1e5)] {
        let index = between(&found, least, most);
        let there = at(&p, &found, index);
        let (pair, budget) = (GearPair::new(&there), Budget::default());
        let bounds = newton::Options { tolerance: 1e-12, ..newton::Options::default() };
        let whole =
            fixed_point(found.state[index], bounds, |state| image(&pair, state, 2, 1e-12, 1.0, &budget));
        let single = whole.expect("one shot is enough").point;
        for parts in [2, 5, 8] {
            let part = 2.0 * there.mesh_period() / parts as f64;
            let mut shoot = |index: usize, state: &[f64; 6]| {
                let times = [index as f64 * part, (index + 1) as f64 * part];
                image_between(&pair, state, times, 1e-12, 1.0, &budget)
            };
            let mut start = vec![single; parts];
            for index in 1..parts {
                start[index] = shoot(index - 1, &start[index - 1]).expect("moves").0;
                start[index].iter_mut().for_each(|value| *value += 1e-4);
            }
            let nodes = multiple_shooting::solve(start, bounds, &mut shoot).expect("converges");
            for i in 0..6 {
                assert!((nodes.states[0][i] - single[i]).abs() < 1e-10, "{parts}: {:?}", nodes.states[0]);
            }
            let mut product = Matrix6::identity();
            for (index, state) in nodes.states.iter().enumerate() {
                product = matrix(&shoot(index, state).expect("moves").1) * product;
            }
            let (_, rows) = image(&pair, &single, 2, 1e-12, 1.0, &budget).expect("moves");
            let (several, once) = (floquet::spectrum(&product), floquet::spectrum(&matrix(&rows)));
            let distance = several.expect("six").distance(&once.expect("six"));
            assert!(distance < 1e-7 * most, "{parts} parts, {least:e}: {distance:e}");
        }
    }
}
