//! Branches against numbers from independent programs and against themselves.

mod common;

use common::{numbers, reference};
use gear_bifurcations::study::branch::{Branch, BranchOptions, EventKind, branch};
use gear_bifurcations::study::diagram::{DiagramOptions, diagram};

fn show(branch: &Branch) {
    println!("{} points, period {}, ends {:?}, error {:?}", branch.value.len(), branch.period, branch.ends, branch.error);
    for event in &branch.events {
        println!("{:?}", event);
    }
}

#[test]
fn tongue_2() {
    let p = numbers(&[("Omega", 1.65)]);
    let found = branch(&p, &BranchOptions::new([1.0, 2.0], 2)).expect("follows");
    show(&found);
    for i in (0..found.value.len()).step_by(10) {
        println!("{} {} {} {}", found.value[i], found.max_u_p[i], found.stable[i], found.unstable[i]);
    }
    println!("{}", reference("orbit_branch")["events"]);
    assert_eq!(found.events[0].kind, EventKind::Fold);
}

#[test]
fn figure_10() {
    let p = numbers(&[("Omega", 1.65)]);
    let begun = std::time::Instant::now();
    let found = diagram(&p, &DiagramOptions::new([1.0, 6.0])).expect("computes");
    println!("{:?} {} branches, complete {}", begun.elapsed(), found.branches.len(), found.complete);
    for (branch, from) in found.branches.iter().zip(&found.from) {
        println!("from {from:?}");
        show(branch);
    }
}
