//! Branches against numbers from independent programs and against themselves.

mod common;

use common::{numbers, parameters, reference};
use serde_json::json;
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

#[test]
fn tongue_3() {
    let p = numbers(&[("Omega", 5.4)]);
    let found = branch(&p, &BranchOptions::new([1.0, 6.0], 2)).expect("follows");
    show(&found);
}

#[test]
fn loaded() {
    for (given, parameter, range, period) in [
        (json!({"m":1,"k":5,"zeta":0.07,"k0":0.5,"Omega":1.6,"alpha":-1.3,"F":1.5,"regime":"contact"}), "Omega", [1.0, 4.0], 1),
        (json!({"m":1,"k":5,"zeta":0.07,"k0":0.5,"Omega":1.6,"alpha":0.0,"F":1.5,"regime":"backlash"}), "Omega", [1.2, 2.0], 2),
        (json!({"m":1,"k":5,"zeta":0.07,"k0":0.5,"Omega":1.6,"alpha":-0.2,"F":1.5,"E":0.1,"regime":"backlash"}), "Omega", [0.6, 4.0], 1),
        (json!({"m_p":1,"m_g":1.3,"k_p":5,"k_g":4,"zeta":0.02,"k0":0.5,"Omega":1.5,"alpha":-0.2}), "Omega", [1.0, 2.0], 2),
        (json!({"zeta":0.02,"k0":0.5,"Omega":1.75,"alpha":0.2}), "Omega", [1.2, 2.4], 2),
        (json!({"zeta":0.02,"k0":0.5,"Omega":1.65,"alpha":-0.2}), "k0", [0.05, 1.0], 2),
        (json!({"zeta":0.02,"k0":0.5,"Omega":1.65,"alpha":-0.2}), "alpha", [-2.0, -0.01], 2),
        (json!({"zeta":0.0,"k0":0.5,"Omega":1.65,"alpha":-0.2}), "Omega", [1.2, 2.0], 2),
        (json!({"zeta":0.0,"k0":0.3,"Omega":1.65,"alpha":-0.2}), "Omega", [1.0, 6.0], 1),
        (json!({"zeta":0.05,"k0":0.5,"Omega":1.65,"alpha":-0.2,"F":2.0,"regime":"backlash"}), "F", [0.01, 3.0], 1),
        (json!({"zeta":0.05,"k0":0.5,"Omega":1.65,"alpha":-0.2,"regime":"backlash"}), "Omega", [0.5, 3.0], 1),
        (json!({"zeta":0.05,"k0":0.5,"Omega":1.65,"alpha":-0.2,"F":2.0,"F_p":0.3,"Omega_p":0.825,"regime":"contact"}), "Omega", [0.8, 3.0], 1),
    ] {
        println!("{given} {parameter} {range:?}");
        let p = parameters(&given);
        let begun = std::time::Instant::now();
        match branch(&p, &BranchOptions { parameter, ..BranchOptions::new(range, period) }) {
            Ok(found) => show(&found),
            Err(error) => println!("{error}"),
        }
        println!("{:?}", begun.elapsed());
    }
}

#[test]
fn one() {
    let p = parameters(&json!({"m":1,"k":5,"zeta":0.07,"k0":0.5,"Omega":1.0,"alpha":-0.2,"F":1.5,"E":0.1,"regime":"backlash"}));
    for range in [[0.6, 1.1], [0.5, 1.2], [0.6, 4.0]] {
    let found = branch(&p, &BranchOptions::new(range, 1)).expect("follows");
    show(&found);
    }
}
