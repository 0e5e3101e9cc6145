//! Branches and diagrams against numbers from independent programs and against themselves.

use crate::common::{Generator, numbers, parameters, reference};
use gear_bifurcations::error::StudyError;
use gear_bifurcations::model::parameters::Parameters;
use gear_bifurcations::study::branch::{
    Branch, BranchEnd, BranchEvent, BranchOptions, Breaks, EventKind, branch,
};
use gear_bifurcations::study::diagram::{Diagram, DiagramOptions, diagram};
use gear_bifurcations::study::multipliers::multipliers;
use gear_bifurcations::study::orbit::{OrbitOptions, periodic_orbit};
use gear_bifurcations::study::poincare::{PoincareOptions, poincare};
use gear_bifurcations::study::tongue::{Tongue, tongue_edges};
use serde_json::json;

fn over_omega(p: &Parameters, range: [f64; 2], period: usize) -> Branch {
    branch(p, &BranchOptions::new(range, period)).unwrap_or_else(|error| panic!("{p:?}: {error}"))
}

fn only(branch: &Branch, kind: EventKind) -> Vec<&BranchEvent> {
    branch.events.iter().filter(|event| event.kind == kind).collect()
}

/// Asserts that a branch has an event of a kind at a value, to 1e-7, and gives it.
fn expect(branch: &Branch, kind: EventKind, value: f64) -> &BranchEvent {
    let found = branch.events.iter().find(|event| event.kind == kind && (event.value - value).abs() < 1e-7);
    found.unwrap_or_else(|| panic!("no {} at {value}: {:#?}", kind.name(), branch.events))
}

/// What every branch promises: finite numbers within the range, steps without gaps, and a count of unstable
/// multipliers that changes only at an event.
fn check_promises(branch: &Branch, range: [f64; 2]) {
    let count = branch.value.len();
    assert!(count >= 2);
    let finite = |values: &[f64]| values.iter().all(|value| value.is_finite());
    assert!(finite(&branch.value) && finite(&branch.max_u_p) && finite(&branch.max_u));
    assert!(branch.value.iter().all(|value| *value >= range[0] - 1e-9 && *value <= range[1] + 1e-9));
    for columns in [&branch.state, &branch.re, &branch.im] {
        assert!(columns.len() == count && columns.iter().all(|row| finite(row)));
    }
    for i in 1..count {
        if branch.unstable[i] != branch.unstable[i - 1] {
            let between = branch.events.iter().any(|event| event.after + 1 == i || event.after == i);
            assert!(
                between,
                "{} to {} at {}: {:#?}",
                branch.unstable[i - 1],
                branch.unstable[i],
                branch.value[i],
                branch.events
            );
        }
        assert_eq!(branch.stable[i], branch.unstable[i] == 0);
    }
}

#[test]
fn the_branch_of_tongue_2_has_its_events_where_independent_programs_put_them() {
    let p = numbers(&[("Omega", 1.65)]);
    let found = over_omega(&p, [1.0, 2.0], 2);
    let expected = &reference("orbit_branch")["events"];
    let number = |name: &str| expected[name].as_f64().expect("a number");
    expect(&found, EventKind::NeimarkSacker, number("torus"));
    expect(&found, EventKind::Fold, number("fold"));
    let across = expect(&found, EventKind::Pitchfork, number("branch_point_across_manifold"));
    assert_eq!(across.breaks, Some(Breaks::Exchange));
    for value in expected["period_doubling"].as_array().expect("two") {
        let event = expect(&found, EventKind::PeriodDoubling, value.as_f64().expect("a number"));
        assert_eq!(event.max_u_p, 0.0, "born of the state of rest");
    }
    assert_eq!(only(&found, EventKind::PeriodDoubling).len(), 2);
    assert_eq!(only(&found, EventKind::Fold).len(), 1);
    assert_eq!(found.ends, [BranchEnd::BornFrom { period: 1 }, BranchEnd::BornFrom { period: 1 }]);
    check_promises(&found, [1.0, 2.0]);
    // Stable from the edge of the tongue down to the torus, unstable beyond.
    for i in 0..found.value.len() {
        let upper =
            found.events.iter().find(|event| event.kind == EventKind::NeimarkSacker && event.value > 1.6);
        let stable = i > upper.expect("the torus").after;
        assert_eq!(found.stable[i], stable, "{}", found.value[i]);
    }
}

/// The range's end is a point of the branch: where the reference has one, states agree there to 1e-8.
#[test]
fn branches_pass_through_every_reference_orbit() {
    let p = numbers(&[("Omega", 1.65)]);
    for row in reference("orbit_branch")["tongue2"].as_array().expect("rows") {
        let number = |name: &str| row[name].as_f64().expect("a number");
        let omega = number("Omega");
        let (range, last) = if omega > 1.65 { ([1.6, omega], true) } else { ([omega, 1.7], false) };
        let found = over_omega(&p, range, 2);
        let ends = if last { found.value.len() - 1 } else { 0 };
        // The branch may turn: of the points at the end of the range the one meant.
        let meant = |i: &usize| {
            (found.value[*i] - omega).abs() < 1e-12 && (found.max_u_p[*i] - number("max_u_p")).abs() < 1e-3
        };
        let index =
            (0..found.value.len()).find(meant).unwrap_or_else(|| panic!("{omega}: {}", found.value[ends]));
        let state = found.state[index];
        // One mesh period later it is at the opposite state.
        let sign = (state[0] * number("u_p")).signum();
        let expected = [
            number("u_p"),
            -number("u_p"),
            number("u"),
            number("u_p_dot"),
            -number("u_p_dot"),
            number("u_dot"),
        ];
        for i in 0..6 {
            assert!((sign * state[i] - expected[i]).abs() < 1e-8, "{omega}: {state:?}");
        }
        assert!((found.max_u_p[index] - number("max_u_p")).abs() < 1e-8, "{omega}");
    }
}

#[test]
fn the_branch_of_tongue_3_loses_stability_across_the_manifold() {
    let p = numbers(&[("Omega", 5.4)]);
    let found = over_omega(&p, [3.0, 6.0], 2);
    let born = only(&found, EventKind::PeriodDoubling);
    assert!((born[0].value - 5.598863224).abs() < 1e-8, "{born:?}");
    let lost = found.events.iter().filter(|event| event.breaks == Some(Breaks::Exchange));
    let lost: Vec<f64> = lost.map(|event| event.value).collect();
    assert!(lost.iter().any(|value| (value - 4.612150269).abs() < 1e-7), "{lost:?}");
    for (value, stable) in found.value.iter().zip(&found.stable) {
        assert_eq!(*stable, *value > 4.612150269, "{value}");
    }
    check_promises(&found, [3.0, 6.0]);
}

/// AUTO slid from one branch to the other across the manifold at a step of 0.02: at any step the same branch and the
/// same events are found here.
#[test]
fn long_steps_lose_nothing() {
    let p = numbers(&[("Omega", 1.65)]);
    let fine = over_omega(&p, [1.2, 1.69], 2);
    for max_step in [0.005, 0.02, 0.05, 0.3] {
        let options = BranchOptions { max_step: Some(max_step), ..BranchOptions::new([1.2, 1.69], 2) };
        let found = branch(&p, &options).expect("follows");
        assert_eq!(found.events.len(), fine.events.len(), "{max_step}: {:#?}", found.events);
        for (event, expected) in found.events.iter().zip(&fine.events) {
            assert_eq!((event.kind, event.breaks), (expected.kind, expected.breaks));
            assert!((event.value - expected.value).abs() < 1e-8, "{max_step}: {event:?} {expected:?}");
        }
    }
}

#[test]
fn a_branch_traced_backwards_returns_to_its_start() {
    let p = numbers(&[("Omega", 1.65)]);
    let there = over_omega(&p, [1.285, 1.66], 2);
    let far = there.value.len() / 3;
    let at =
        Parameters { omega: there.value[far], omega_p: there.value[far], omega_g: there.value[far], ..p };
    let options = BranchOptions { from: Some(there.state[far]), ..BranchOptions::new([1.285, 1.66], 2) };
    let back = branch(&at, &options).expect("follows");
    let pass = |branch: &Branch, i: usize| (branch.value[i], branch.state[i]);
    let (end, state) = pass(&there, there.value.len() - 1);
    let closest = (0..back.value.len())
        .filter(|&i| (back.value[i] - end).abs() < 1e-12)
        .map(|i| (0..6).map(|j| (back.state[i][j].abs() - state[j].abs()).abs()).fold(0.0, f64::max))
        .fold(f64::INFINITY, f64::min);
    assert!(closest < 1e-9, "{closest:e}");
    assert_eq!(back.events.len(), there.events.len());
}

#[test]
fn a_torus_that_is_born_while_a_multiplier_comes_back_is_located() {
    // At -1 a multiplier comes in at 1.65946, a pair goes out at 1.66307: over a step that holds both, the count rises by
    // one. Events computed independently: Newton on orbits by DOP853, roots of the test functions.
    let p = parameters(
        &json!({"m_p": 1.55204, "m_g": 2.103, "k_p": 3.73005, "k_g": 3.93256, "zeta": 0.003, "k0": 0.633947,
        "Omega": 1.86853, "alpha_p": 0.42754, "alpha_g": -0.13346, "regime": "contact", "F": 0.80133, "F_p": 0.15864}),
    );
    let found = over_omega(&p, [1.5484733439672382, 2.322710015950857], 1);
    let tori: Vec<f64> = only(&found, EventKind::NeimarkSacker).iter().map(|event| event.value).collect();
    assert_eq!(tori.len(), 3, "{tori:?}");
    for (own, expected) in tori.iter().zip([1.663066549, 1.754164703, 2.258127544]) {
        assert!((own - expected).abs() < 1e-7, "{tori:?}");
    }
    expect(&found, EventKind::PeriodDoubling, 1.65945814);
}

#[test]
fn steep_orbits_have_no_folds_of_rounding() {
    // Largest entry of the linearisation 180: a multiplier that leaves 1 slowly was seen to come back once.
    let p =
        parameters(&json!({"m": 0.584994, "k": 3.18025, "zeta": 0.0117626, "k0": 0.946715, "Omega": 0.76992,
        "alpha_p": -0.1399, "alpha_g": 0.19732}));
    let range = [0.6509756425056132, 0.8807317516252414];
    let found = over_omega(&p, range, 2);
    check_promises(&found, range);
    let folds = only(&found, EventKind::Fold);
    assert_eq!(folds.len(), 1, "{folds:#?}");
    expect(&found, EventKind::Fold, 0.666062425416);
}

/// Kinds and values, in rising order.
fn listed(branch: &Branch) -> Vec<(f64, &'static str)> {
    let mut all: Vec<_> = branch.events.iter().map(|event| (event.value, event.kind.name())).collect();
    all.sort_by(|left, right| left.0.total_cmp(&right.0));
    all
}

#[test]
fn from_wherever_a_branch_is_followed_it_is_the_same() {
    let mut generator = Generator(11);
    let mut compared = 0;
    for trial in 0..32 {
        let omega = generator.within(1.0, 3.5);
        let given = json!({
            "m_p": generator.within(0.5, 2.0), "m_g": generator.within(0.5, 2.0), "k_p": generator.within(2.0, 8.0),
            "k_g": generator.within(2.0, 8.0), "alpha_p": generator.within(-0.1, 0.4),
            "alpha_g": generator.within(-0.1, 0.4), "zeta": generator.within(0.005, 0.05),
            "k0": generator.within(0.2, 0.8), "Omega": omega, "F": generator.within(0.2, 1.0), "regime": "contact",
        });
        let p = parameters(&given);
        let range = [0.85 * omega, 1.15 * omega];
        let options = BranchOptions { points: 300, ..BranchOptions::new(range, 1 + trial % 2) };
        let Ok(there) = branch(&p, &options) else { continue };
        check_promises(&there, range);
        let ended = |branch: &Branch| {
            branch.ends.iter().all(|end| matches!(end, BranchEnd::Range | BranchEnd::BornFrom { .. }))
        };
        if !ended(&there) {
            continue;
        }
        let start = there.value.len() * 3 / 4;
        let at = Parameters {
            omega: there.value[start],
            omega_p: there.value[start],
            omega_g: there.value[start],
            ..p
        };
        let options = BranchOptions { from: Some(there.state[start]), period: there.period, ..options };
        let back = branch(&at, &options).expect("follows from one of its own points");
        check_promises(&back, range);
        let (first, second) = (listed(&there), listed(&back));
        assert_eq!(first.len(), second.len(), "{given}: {first:?} {second:?}");
        for (one, other) in first.iter().zip(&second) {
            assert!(one.1 == other.1 && (one.0 - other.0).abs() < 1e-7, "{given}: {first:?} {second:?}");
        }
        compared += 1;
    }
    assert!(compared >= 10, "{compared}");
}

#[test]
fn orbits_and_multipliers_on_a_branch_are_those_found_one_by_one() {
    for given in [
        json!({"Omega": 1.65}),
        json!({"Omega": 1.75, "alpha": 0.2}),
        json!({"Omega": 1.5, "m_g": 1.3, "k_g": 4.0}),
        json!({"Omega": 1.6, "zeta": 0.07, "alpha": 0.0, "F": 1.5, "regime": "backlash"}),
    ] {
        let p = parameters(&given);
        let found = over_omega(&p, [1.2, 1.9], 2);
        check_promises(&found, [1.2, 1.9]);
        assert_eq!(found.period, 2);
        let count = found.value.len();
        for index in (3..count.min(300)).step_by(41) {
            let omega = found.value[index];
            let at = Parameters { omega, omega_p: omega, omega_g: omega, ..p };
            let options = OrbitOptions { period: 2, guess: Some(found.state[index]), tolerance: 1e-11 };
            let Ok(orbit) = periodic_orbit(&at, &options) else { continue };
            if orbit.period != 2 {
                continue;
            }
            for i in 0..6 {
                // Next to a bifurcation an orbit is as uncertain as its nearly singular linearisation makes it.
                assert!((orbit.state[i] - found.state[index][i]).abs() < 1e-7, "{given} {omega}");
            }
            let size = found.re[index][0].hypot(found.im[index][0]).max(1.0);
            for i in 0..6 {
                let nearest = (0..6)
                    .map(|j| (orbit.re[i] - found.re[index][j]).hypot(orbit.im[i] - found.im[index][j]))
                    .fold(f64::INFINITY, f64::min);
                assert!(nearest < 2e-5 * size, "{given} {omega}: {nearest:e}");
            }
            let greatest = orbit.max[0].max(-orbit.min[0]);
            assert!((greatest - found.max_u_p[index]).abs() < 1e-7, "{given} {omega}");
            let greatest = orbit.max[2].max(-orbit.min[2]);
            assert!((greatest - found.max_u[index]).abs() < 1e-7, "{given} {omega}");
        }
    }
}

#[test]
fn grazing_is_an_event_of_its_own_where_the_teeth_just_part() {
    let given = json!({"Omega": 1.6, "zeta": 0.07, "F": 1.5, "E": 0.1, "regime": "backlash"});
    let found = over_omega(&parameters(&given), [0.5, 2.0], 1);
    check_promises(&found, [0.5, 2.0]);
    let grazing = only(&found, EventKind::Grazing);
    assert!(grazing.len() >= 3, "{:#?}", found.events);
    for event in grazing {
        let omega = event.value;
        let p = parameters(&given);
        let at = Parameters { omega, omega_p: omega, omega_g: omega, ..p };
        let options = OrbitOptions { period: 1, guess: Some(event.state), tolerance: 1e-12 };
        let orbit = periodic_orbit(&at, &options).expect("found");
        // The least u of the orbit, or the least of |u| - 1 that it turns back at, is the boundary.
        let touches = (orbit.min[2] - 1.0).abs().min((orbit.min[2] + 1.0).abs());
        assert!(touches < 1e-7, "{event:?}: {touches:e}");
        let smooth =
            |other: &&BranchEvent| other.kind != EventKind::Grazing && (other.value - omega).abs() < 1e-6;
        assert!(!found.events.iter().any(|other| smooth(&other)), "{:#?}", found.events);
    }
}

#[test]
fn multipliers_with_contact_loss_are_those_of_differences() {
    let given = json!({"Omega": 1.6, "zeta": 0.07, "alpha": 0.0, "F": 1.5, "regime": "backlash"});
    let p = parameters(&given);
    let found = over_omega(&p, [1.5, 1.65], 2);
    let index =
        (0..found.value.len()).find(|&i| found.value[i] < 1.6 && found.max_u[i] > 4.5).expect("parts");
    let omega = found.value[index];
    let at = Parameters { omega, omega_p: omega, omega_g: omega, ..p };
    let after = |state: [f64; 6]| {
        let options = PoincareOptions { state, transient: 2, points: 1, tolerance: 1e-13 };
        poincare(&at, &options).expect("computes").states[0]
    };
    let h = 1e-5;
    let derivative = nalgebra::SMatrix::<f64, 6, 6>::from_fn(|row, column| {
        let mut states = [found.state[index]; 2];
        states[0][column] += h;
        states[1][column] -= h;
        (after(states[0])[row] - after(states[1])[row]) / (2.0 * h)
    });
    let values = derivative.complex_eigenvalues();
    for i in 0..6 {
        let nearest = values
            .iter()
            .map(|value| (value.re - found.re[index][i]).hypot(value.im - found.im[index][i]))
            .fold(f64::INFINITY, f64::min);
        assert!(nearest < 1e-6, "{nearest:e}");
    }
}

/// Whether births are super- or subcritical is what the born branches show, where they show it, and does not depend on
/// which of two mirrored branches the rounding of a coarser tolerance leads to.
fn check_criticality(p: &Parameters, found: &Diagram) {
    let mut shown = 0;
    for (branch, from) in found.branches.iter().zip(&found.from).skip(1) {
        let Some((parent, event)) = from else { continue };
        let (parent, event) = (&found.branches[*parent], &found.branches[*parent].events[*event]);
        let from_birth: Vec<f64> = branch.value.iter().take(4).map(|value| value - event.value).collect();
        let [_, first, second, third] = from_birth[..] else { continue };
        let counts = parent.unstable.get(event.after).zip(parent.unstable.get(event.after + 1));
        let Some((before, after)) = counts.filter(|(before, after)| before.abs_diff(**after) == 1) else {
            continue;
        };
        // The change of the parameter grows steadily: neither rounding nor a fold.
        if first.abs() > 1e-6 && second / first > 1.0 && third / second > 1.0 {
            let rising = parent.value[event.after + 1] > parent.value[event.after];
            assert_eq!(
                event.supercritical,
                Some((first > 0.0) == ((after > before) == rising)),
                "{event:#?}"
            );
            shown += 1;
        }
    }
    assert!(shown >= 10, "{shown}");
    let coarser = DiagramOptions { tolerance: 1e-9, ..DiagramOptions::new([1.0, 6.0]) };
    let coarser = diagram(p, &coarser).expect("computes");
    let all = |diagram: &Diagram| -> Vec<BranchEvent> {
        diagram.branches.iter().flat_map(|branch| branch.events.clone()).collect()
    };
    let (fine, coarse) = (all(found), all(&coarser));
    let mut compared = 0;
    for event in fine.iter().filter(|event| event.supercritical.is_some()) {
        let same = |other: &&BranchEvent| {
            other.kind == event.kind
                && (other.value - event.value).abs() < 1e-7
                && (other.max_u_p - event.max_u_p).abs() < 1e-6
                && other.supercritical.is_some()
        };
        if let Some(other) = coarse.iter().find(same) {
            assert_eq!(event.supercritical, other.supercritical, "{event:#?}");
            compared += 1;
        }
    }
    assert!(compared >= 18, "{compared}");
    // Differences of the parameter along the born branches are rounding here: each of these was told by chance.
    for (value, expected) in [(3.8099877720, false), (3.8476314622, true), (4.2108456967, true)] {
        let there =
            fine.iter().find(|event| (event.value - value).abs() < 1e-7 && event.supercritical.is_some());
        assert_eq!(there.and_then(|event| event.supercritical), Some(expected), "{value}");
    }
}

#[test]
fn the_diagram_of_figure_10_joins_every_branch_to_its_birth() {
    let p = numbers(&[("Omega", 1.65)]);
    let found = diagram(&p, &DiagramOptions::new([1.0, 6.0])).expect("computes");
    assert!(found.complete && found.branches.len() == found.from.len());
    assert_eq!(found.from[0], None);
    for (index, (branch, from)) in found.branches.iter().zip(&found.from).enumerate().skip(1) {
        let (parent, event) = from.expect("born somewhere");
        assert!(parent < index);
        let birth = &found.branches[parent].events[event];
        if matches!(branch.ends[0], BranchEnd::BornFrom { .. }) {
            assert!((branch.value[0] - birth.value).abs() < 1e-9, "{index}");
        } else {
            // The other ends on this one, which has the bifurcation too.
            let same = |event: &BranchEvent| (event.value - birth.value).abs() < 1e-6;
            assert!(branch.events.iter().any(same), "{index}: {:#?}", branch.events);
        }
    }
    // Where multipliers are so large that rounding turns the branch, it is ended and not folded.
    for branch in &found.branches {
        let folds: Vec<f64> = only(branch, EventKind::Fold).iter().map(|event| event.value).collect();
        assert!(folds.windows(2).all(|two| (two[0] - two[1]).abs() > 1e-4), "{folds:?}");
    }
    // The steady response: the edges of the three tongues, as linear theory has them.
    let edges: Vec<f64> = found.branches[0].events.iter().map(|event| event.value).collect();
    for value in edges {
        let at = Parameters { omega: value, omega_p: value, omega_g: value, ..p };
        let radius = multipliers(&at, 1e-12).expect("computes").spectral_radius;
        assert!((radius - 1.0).abs() < 1e-8, "{value}: {radius}");
    }
    check_criticality(&p, &found);
    let tongue_2 = &found.branches[1];
    expect(tongue_2, EventKind::NeimarkSacker, 1.619717349);
    expect(tongue_2, EventKind::Fold, 1.279211051);
    // Off the manifold, between both of its branch points.
    let across = |index: usize| {
        let states = &found.branches[index].state;
        states.iter().any(|state| (state[0] + state[1]).abs() > 1e-3)
    };
    assert!((0..found.branches.len()).any(across));
    let periods: Vec<usize> = found.branches.iter().map(|branch| branch.period).collect();
    assert!(periods.contains(&4) && periods.iter().all(|period| *period <= 4), "{periods:?}");
}

#[test]
fn no_parameters_make_a_branch_panic_or_give_what_is_no_number() {
    let mut generator = Generator(7);
    let regimes = ["homogeneous", "contact", "backlash"];
    for trial in 0..40 {
        let regime = regimes[trial % 3];
        let load = if regime == "homogeneous" { 0.0 } else { generator.within(0.0, 3.0) };
        let given = json!({
            "m_p": generator.within(0.3, 3.0), "m_g": generator.within(0.3, 3.0), "k_p": generator.within(0.5, 9.0),
            "k_g": generator.within(0.5, 9.0), "alpha_p": generator.within(-1.0, 1.0),
            "alpha_g": generator.within(-1.0, 1.0), "zeta": generator.within(0.0, 0.2), "k0": generator.unit(),
            "Omega": generator.within(0.8, 5.0), "F": load, "regime": regime,
        });
        let p = parameters(&given);
        let (parameter, range) = [("Omega", [0.8, 5.0]), ("k0", [0.0, 1.0]), ("zeta", [0.0, 0.3])][trial % 2];
        let options =
            BranchOptions { parameter, points: 150, ..BranchOptions::new(range, 1 + trial / 3 % 2) };
        if let Ok(found) = branch(&p, &options) {
            check_promises(&found, range);
        }
    }
}

#[test]
fn options_out_of_range_are_refused_by_name() {
    let p = numbers(&[("Omega", 1.65)]);
    let good = BranchOptions::new([1.0, 2.0], 2);
    for (option, options) in [
        ("parameter", BranchOptions { parameter: "omega", ..good }),
        ("parameter", BranchOptions { parameter: "Omega_p", ..good }),
        ("range", BranchOptions { range: [2.0, 1.0], ..good }),
        ("range", BranchOptions { range: [f64::NAN, 1.0], ..good }),
        ("period", BranchOptions { period: 0, ..good }),
        ("points", BranchOptions { points: 1, ..good }),
        ("maxStep", BranchOptions { max_step: Some(0.0), ..good }),
        ("tolerance", BranchOptions { tolerance: 0.1, ..good }),
        ("state", BranchOptions { from: Some([f64::NAN; 6]), ..good }),
    ] {
        match branch(&p, &options) {
            Err(StudyError::Option { option: named, .. }) => assert_eq!(named, option),
            other => panic!("{option}: {other:?}"),
        }
    }
}

/// Where no symmetry halves the map of the doubled orbits, their multipliers are computed over both periods: at the
/// birth they must be the squares of the multipliers of the orbit that doubles.
#[test]
fn multipliers_of_born_orbits_are_squares_of_those_at_the_period_doubling() {
    let mut seen = 0;
    for given in [
        json!({"Omega": 1.2, "F": 0.5, "m_g": 1.3, "k_g": 4.0, "regime": "contact"}),
        json!({"Omega": 1.2, "F": 1.0, "alpha": 0.2, "regime": "contact"}),
        json!({"Omega": 1.65, "m_g": 1.3, "k_g": 4.0}),
    ] {
        let p = parameters(&given);
        let range = [1.2, 2.0];
        let steady = over_omega(&p, range, 1);
        check_promises(&steady, range);
        let doubled = over_omega(&p, range, 2);
        check_promises(&doubled, range);
        for event in only(&doubled, EventKind::PeriodDoubling) {
            let born =
                [0, doubled.value.len() - 1].into_iter().find(|&end| doubled.value[end] == event.value);
            let Some(born) = born else { continue };
            expect(&steady, EventKind::PeriodDoubling, event.value);
            let omega = event.value;
            let at = Parameters { omega, omega_p: omega, omega_g: omega, ..p };
            let options = OrbitOptions { period: 1, guess: Some(event.state), tolerance: 1e-12 };
            let single = periodic_orbit(&at, &options).expect("the orbit that doubles");
            assert_eq!(single.period, 1);
            let nearest_to_minus_one =
                (0..6).map(|i| (single.re[i] + 1.0).hypot(single.im[i])).fold(f64::INFINITY, f64::min);
            assert!(nearest_to_minus_one < 1e-7, "{given} {omega}: {nearest_to_minus_one:e}");
            for i in 0..6 {
                let (re, im) = (single.re[i], single.im[i]);
                let (re, im) = (re * re - im * im, 2.0 * re * im);
                let nearest = (0..6)
                    .map(|j| (doubled.re[born][j] - re).hypot(doubled.im[born][j] - im))
                    .fold(f64::INFINITY, f64::min);
                assert!(nearest < 1e-7, "{given} {omega}: {nearest:e}");
            }
            seen += 1;
        }
    }
    assert!(seen >= 4, "{seen}");
}

/// A hardening tongue leans the other way: from its left edge the orbits grow towards higher Omega.
#[test]
fn the_branch_of_a_hardening_pair_leans_to_higher_frequencies() {
    let p = numbers(&[("Omega", 1.6), ("alpha", 0.2)]);
    let range = [1.2, 2.6];
    let found = over_omega(&p, range, 2);
    check_promises(&found, range);
    let edges = only(&found, EventKind::PeriodDoubling);
    // The edges are those of the linear problem, whatever the cubic term.
    // Where the orbits are born the cubic term does not count yet.
    let left = tongue_edges(&p, Tongue::Primary2, 1e-11).expect("computes").left.expect("an open tongue");
    assert!((edges[0].value - left).abs() < 1e-8, "{left}: {edges:?}");
    let grown = (0..found.value.len()).find(|&i| found.max_u_p[i] > 5.0).expect("large orbits");
    assert!(found.value[..=grown].is_sorted(), "no fold on the way");
    assert!(found.value[grown] > left + 0.1, "{}", found.value[grown]);
}

/// A loaded branch on which the teeth part: its stability changes only at events, a fold among them, and multipliers
/// are those of differences wherever the orbit does not graze.
#[test]
fn stability_is_right_all_along_a_branch_that_parts_the_teeth() {
    let given = json!({"Omega": 1.0, "F": 1.0, "alpha": 0.05, "zeta": 0.04, "k0": 0.3, "E": 0.8, "regime": "backlash"});
    let p = parameters(&given);
    let range = [0.6, 2.2];
    let found = over_omega(&p, range, 1);
    check_promises(&found, range);
    let grazes =
        |omega: f64| only(&found, EventKind::Grazing).iter().any(|event| (event.value - omega).abs() < 2e-3);
    assert!(only(&found, EventKind::Fold).len() >= 4 && only(&found, EventKind::Grazing).len() >= 4);
    let (mut tried, mut parted) = (0, 0);
    let count = found.value.len();
    for index in (2..count - 2).step_by(count / 9) {
        let omega = found.value[index];
        if grazes(omega) {
            continue;
        }
        let at = Parameters { omega, omega_p: omega, omega_g: omega, ..p };
        let after = |state: [f64; 6]| {
            let options = PoincareOptions { state, transient: 1, points: 1, tolerance: 1e-13 };
            poincare(&at, &options).expect("computes").states[0]
        };
        let h = 1e-6;
        let derivative = nalgebra::SMatrix::<f64, 6, 6>::from_fn(|row, column| {
            let mut states = [found.state[index]; 2];
            states[0][column] += h;
            states[1][column] -= h;
            (after(states[0])[row] - after(states[1])[row]) / (2.0 * h)
        });
        let values = derivative.complex_eigenvalues();
        for i in 0..6 {
            let nearest = values
                .iter()
                .map(|value| (value.re - found.re[index][i]).hypot(value.im - found.im[index][i]))
                .fold(f64::INFINITY, f64::min);
            assert!(nearest < 1e-5, "{omega}: {nearest:e}");
        }
        let options = OrbitOptions { period: 1, guess: Some(found.state[index]), tolerance: 1e-12 };
        let orbit = periodic_orbit(&at, &options).expect("found");
        parted += usize::from(orbit.min[2] < 1.0);
        tried += 1;
    }
    assert!(tried >= 5 && parted >= 3, "{tried} {parted}");
}

#[test]
fn an_unloaded_pair_with_backlash_is_told_to_rest_anywhere() {
    let p = parameters(&json!({"Omega": 1.65, "regime": "backlash"}));
    let told = |error: StudyError| match error {
        StudyError::NotFound { found, .. } => assert!(found.contains("rests at every u"), "{found}"),
        other => panic!("{other:?}"),
    };
    told(branch(&p, &BranchOptions::new([1.0, 2.0], 1)).expect_err("no branch"));
    told(diagram(&p, &DiagramOptions::new([1.0, 2.0])).expect_err("no diagram"));
    // An orbit that strikes both flanks is a start like any other.
    let orbit = periodic_orbit(&p, &OrbitOptions { period: 2, ..OrbitOptions::default() }).expect("an orbit");
    let options = BranchOptions { from: Some(orbit.state), ..BranchOptions::new([1.5, 1.8], orbit.period) };
    check_promises(&branch(&p, &options).expect("follows"), [1.5, 1.8]);
}

#[test]
fn a_load_at_half_the_mesh_frequency_has_a_response_of_twice_the_period() {
    for omega in [1.2, 1.65, 2.4] {
        let given = json!({"Omega": omega, "k0": 0.3, "F": 1.5, "F_p": 0.2, "Omega_p": 0.5 * omega, "regime": "contact"});
        let p = parameters(&given);
        let orbit =
            periodic_orbit(&p, &OrbitOptions::default()).unwrap_or_else(|error| panic!("{omega}: {error}"));
        assert_eq!(orbit.period, 2);
        let options = BranchOptions { points: 200, ..BranchOptions::new([0.95 * omega, 1.05 * omega], 1) };
        let found = branch(&p, &options).unwrap_or_else(|error| panic!("{omega}: {error}"));
        assert_eq!(found.period, 2);
        check_promises(&found, [0.95 * omega, 1.05 * omega]);
    }
}

#[test]
fn an_orbit_too_unstable_to_be_followed_is_refused_with_its_growth() {
    // The orbits of twice the period that are born nearest to the given frequency, on responses found through folds of
    // their load.
    let p = parameters(&json!({
        "m_p": 2.415803541672443, "m_g": 2.3840029186661966, "k_p": 5.187072491772156, "k_g": 1.3407594476041909,
        "alpha_p": -0.349490611900116, "alpha_g": -0.9391039620258297, "zeta": 0.06284820136202654,
        "k0": 0.6630345195720643, "Omega": 1.4750728607609962, "F": 2.216672489799425, "regime": "contact",
    }));
    match branch(&p, &BranchOptions { points: 150, ..BranchOptions::new([0.8, 5.0], 2) }) {
        Err(StudyError::NotFound { sought: "orbit that can be followed", found }) => {
            let growth = found.split(' ').find_map(|word| word.parse::<f64>().ok()).expect("a number");
            assert!(growth > 1e5, "{found}");
        }
        other => panic!("{other:?}"),
    }
}
