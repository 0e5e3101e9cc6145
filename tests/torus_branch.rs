//! Invariant circles over the mesh frequency against single ones and the point where they are born.

use crate::common::numbers;
use gear_bifurcations::error::StudyError;
use gear_bifurcations::study::torus::{TorusBranchWork, TorusEnd, torus, torus_branch};

/// Where the pair of multipliers crosses the unit circle, found by another program.
const BIRTH: f64 = 3.7865560726;

#[test]
fn circles_of_a_branch_are_those_found_one_by_one_and_it_shrinks_onto_its_birth() {
    let p = numbers(&[]);
    let branch = torus_branch(&p, [3.69, 3.81], 13, 1e-9).expect("found");
    assert_eq!(branch.ends, [TorusEnd::Range, TorusEnd::Shrinks]);
    assert!(branch.omega.windows(2).all(|pair| pair[0] < pair[1]));
    let last = branch.omega.len() - 1;
    assert!(branch.omega[last] < BIRTH && branch.omega[last] > BIRTH - 1e-3, "{:?}", branch.omega);
    assert!(branch.stable.iter().all(|stable| *stable));
    assert!(branch.error.residual.is_some_and(|defect| defect < 1e-6));
    for index in [0, 3, 7] {
        let one = torus(&numbers(&[("Omega", branch.omega[index])]), 1e-9).expect("found");
        assert!((one.mean_radius - branch.mean_radius[index]).abs() < 1e-6, "{index}");
        assert!((one.rotation - branch.rotation[index]).abs() < 1e-8, "{index}");
        let (pinion, mesh) = (one.max_u_p - branch.max_u_p[index], one.max_u - branch.max_u[index]);
        // Taken from samples that are not the same.
        assert!(
            pinion.abs() < 2e-4 * one.max_u_p && mesh.abs() < 2e-4 * one.max_u,
            "{index}: {pinion:e} {mesh:e}"
        );
    }
    // Born supercritically: the radius is as the root of the distance.
    let squares: Vec<f64> =
        [5, 7].map(|index| branch.mean_radius[index].powi(2) / (BIRTH - branch.omega[index])).to_vec();
    assert!((squares[0] / squares[1] - 1.0).abs() < 0.15, "{squares:?}");
}

#[test]
fn near_its_birth_the_averages_are_those_of_the_circle() {
    let found = torus(&numbers(&[("Omega", 3.78)]), 1e-9).expect("found");
    let averages = found.averages.expect("it attracts");
    assert!((averages.mean_radius - found.mean_radius).abs() < 1e-7, "{found:?}");
    assert!((averages.rotation - found.rotation).abs() < 1e-9);
}

#[test]
fn in_slices_the_branch_grows_and_where_there_is_none_it_is_said() {
    let mut work = TorusBranchWork::new(&numbers(&[]), [3.7, 3.72], 3, 1e-8).expect("allowed");
    let (mut slices, mut circles) = (0, 0);
    loop {
        let done = work.advance().expect("computes");
        slices += 1;
        assert!(work.branch().omega.len() >= circles);
        circles = work.branch().omega.len();
        if done {
            break;
        }
    }
    assert!(circles == 3 && slices > 3, "{slices}");
    let none = torus_branch(&numbers(&[]), [1.649, 1.651], 2, 1e-8);
    assert!(matches!(none, Err(StudyError::NotFound { sought: "torus", .. })), "{none:?}");
}
