//! Basins against motions followed to their end, and the shares of several workers against one another.

use crate::common::{Generator, numbers};
use gear_bifurcations::model::parameters::{Parameters, Regime};
use gear_bifurcations::study::basin::{AttractorKind, Basin, BasinOptions, ESCAPED, UNDECIDED, basin};
use gear_bifurcations::study::grid::Grid;
use gear_bifurcations::study::poincare::Strobe;

fn even(reach: f64, count: usize) -> Grid {
    Grid::new("x", [-reach, reach], count, [-100.0, 100.0]).expect("allowed")
}

/// What becomes of a start in the long run, at a fine tolerance: the index of the nearest attractor, or escape.
fn followed(p: &Parameters, start: [f64; 6], basin: &Basin) -> (i32, u8) {
    let mut strobe = Strobe::new(p, start, 1e-11).expect("allowed");
    for _ in 0..2000 {
        if strobe.next().expect("integrates").is_none() {
            return (ESCAPED, 0);
        }
    }
    let state = strobe.state();
    for (index, attractor) in basin.attractors.iter().enumerate() {
        for (phase, point) in attractor.points.iter().enumerate() {
            if point.iter().zip(state).all(|(a, b)| (a - b).abs() < 1e-3) {
                let period = attractor.points.len();
                return (
                    i32::try_from(index).expect("few"),
                    ((phase + period - 2000 % period) % period) as u8,
                );
            }
        }
    }
    (UNDECIDED, 0)
}

fn agrees_with_long_motions(p: &Parameters, options: &BasinOptions, seed: u64) -> Basin {
    let found = basin(p, options).expect("computes");
    let mut generator = Generator(seed);
    let (mut checked, mut wrong) = (0, 0);
    while checked < 60 {
        let column = (generator.unit() * options.x.count as f64) as usize;
        let row = (generator.unit() * options.y.count as f64) as usize;
        let cell = row * options.x.count + column;
        let mut start = options.state;
        (start[0], start[3]) = (options.x.value(column), options.y.value(row));
        (start[1], start[4]) = (-start[0], -start[3]);
        checked += 1;
        let expected = followed(p, start, &found);
        wrong += usize::from(expected != (found.attractor[cell], found.phase[cell]));
    }
    // On the edge of a basin a start is decided by the last digits.
    assert!(wrong <= 1, "{wrong} of {checked}");
    found
}

#[test]
fn the_basin_of_figure_11_c_is_that_of_motions_followed_to_their_end() {
    let p = numbers(&[("Omega", 1.65)]);
    let options = BasinOptions::new(&p, even(3.0, 48), even(5.0, 48));
    let found = agrees_with_long_motions(&p, &options, 7);
    assert_eq!(found.attractors.len(), 1);
    assert_eq!(found.attractors[0].kind, AttractorKind::Orbit { period: 2 });
    assert!((found.attractors[0].state[0].abs() - 1.8492753921814418).abs() < 1e-8);
    assert!(found.attractor.contains(&ESCAPED) && found.phase.contains(&1));
    // The plane is its own mirror image; off its middle the same cells must come out without that short cut.
    let count = found.attractor.len();
    assert!((0..count).all(|cell| found.attractor[cell] == found.attractor[count - 1 - cell]));
    let shifted = BasinOptions { state: [0.0, 0.0, 1e-9, 0.0, 0.0, 0.0], ..options };
    let whole = basin(&p, &shifted).expect("computes");
    let same = whole.attractor.iter().zip(&found.attractor).filter(|(a, b)| a == b).count();
    assert!(same as f64 > 0.98 * count as f64, "{same} of {count}");
}

#[test]
fn two_attractors_beside_each_other_are_told_apart() {
    // Below 5.2199 the orbit of tongue 3 coexists with the stable origin.
    let p = numbers(&[("Omega", 5.1)]);
    let options = BasinOptions { periods: Some(1500), ..BasinOptions::new(&p, even(4.0, 24), even(8.0, 24)) };
    let found = agrees_with_long_motions(&p, &options, 3);
    assert!(found.attractors.len() >= 2, "{:?}", found.attractors);
    for index in 0..2 {
        assert!(found.attractor.contains(&index));
    }
}

#[test]
fn shares_agree_on_the_attractors_and_together_make_the_whole() {
    let p = numbers(&[("Omega", 1.65)]);
    let x = Grid::new("x", [-1.0, 3.0], 20, [-100.0, 100.0]).expect("allowed");
    let options = BasinOptions::new(&p, x, even(4.0, 17));
    let whole = basin(&p, &options).expect("computes");
    let shares: Vec<Basin> = (0..3)
        .map(|share| basin(&p, &BasinOptions { share: (share, 3), ..options }).expect("computes"))
        .collect();
    for share in &shares {
        assert_eq!(share.attractors, whole.attractors);
    }
    for cell in 0..whole.attractor.len() {
        let decided: Vec<i32> =
            shares.iter().map(|share| share.attractor[cell]).filter(|index| *index != UNDECIDED).collect();
        assert!(decided.len() <= 1);
        assert_eq!(decided.first().copied().unwrap_or(UNDECIDED), whole.attractor[cell]);
    }
}

#[test]
fn unequal_supports_and_a_dead_zone_are_followed_as_well() {
    let unequal = numbers(&[("Omega", 1.65), ("k_g", 5.05), ("m_p", 1.02)]);
    let options =
        BasinOptions { periods: Some(800), ..BasinOptions::new(&unequal, even(2.0, 8), even(3.0, 8)) };
    let found = basin(&unequal, &options).expect("computes");
    assert!(found.attractor.iter().filter(|index| **index == UNDECIDED).count() < 8, "{found:?}");

    let p = numbers(&[("zeta", 0.07), ("Omega", 1.6), ("alpha", 0.0)]);
    let p = Parameters { load: 1.5, regime: Regime::Backlash, ..p };
    let x = Grid::new("x", [-1.0, 0.0], 6, [-100.0, 100.0]).expect("allowed");
    let found = basin(&p, &BasinOptions { periods: Some(800), ..BasinOptions::new(&p, x, even(0.5, 6)) })
        .expect("computes");
    // All motions part the teeth and come to the orbit of twice the mesh period.
    assert!(found.attractors.iter().any(|a| a.kind == AttractorKind::Orbit { period: 2 }), "{found:?}");
    assert!(found.attractor.iter().all(|index| *index >= 0), "{:?}", found.attractor);
}

/// Starts that come to an orbit in thousands of periods: beside a tongue's edge, where rest attracts weakly, and with
/// unequal supports, whose sum of displacements is hardly damped.
#[test]
fn slow_attractors_are_orbits_all_the_same_and_leave_nothing_undecided() {
    for (p, period) in [
        (numbers(&[("Omega", 3.84), ("alpha", 0.2)]), 1),
        (numbers(&[("Omega", 1.65), ("m_p", 1.2), ("m_g", 0.9)]), 2),
    ] {
        let options = BasinOptions::new(&p, even(4.0, 16), even(4.0, 16));
        let found = basin(&p, &options).expect("computes");
        let orbit = |kind| matches!(kind, AttractorKind::Orbit { period: found } if found == period);
        assert!(
            found.attractors.iter().any(|attractor| orbit(attractor.kind)),
            "{:?}",
            found.attractors.len()
        );
        let undecided = found.attractor.iter().filter(|index| **index == UNDECIDED).count();
        assert!(undecided < 8, "{undecided}");
    }
}

/// Whether a motion comes to rest somewhere in the tooth gap, followed for long; none where it escapes.
fn rests_in_gap(p: &Parameters, start: [f64; 6]) -> Option<bool> {
    let mut strobe = Strobe::new(p, start, 1e-9).expect("allowed");
    for _ in 0..1500 {
        strobe.next().expect("integrates")?;
    }
    let state = strobe.state();
    Some(
        state
            .iter()
            .enumerate()
            .all(|(index, value)| value.abs() < if index == 2 { 1.0 + 1e-9 } else { 1e-6 }),
    )
}

#[test]
fn all_rests_in_the_tooth_gap_are_one_attractor() {
    let p = Parameters { regime: Regime::Backlash, ..numbers(&[]) };
    // Starts on both sides of the middle, also one that rests from the beginning, at the very edge of the gap.
    let options = BasinOptions::new(&p, even(3.0, 13), even(4.0, 13));
    let found = basin(&p, &options).expect("computes");
    assert_eq!(found.attractors.len(), 1, "{:?}", found.attractors.len());
    let rest = &found.attractors[0];
    assert_eq!(rest.kind, AttractorKind::Gap { period: 1 });
    assert!(rest.is_rest_in_gap() && rest.state.iter().all(|value| value.abs() < 1e-9), "{rest:?}");
    let moduli: Vec<f64> = rest.re.iter().zip(rest.im).map(|(re, im)| re.hypot(im)).collect();
    assert!((moduli[0] - 1.0).abs() < 1e-12 && moduli[1] < 0.93, "{moduli:?}");
    assert!(found.attractor.contains(&ESCAPED));
    for (cell, &answer) in found.attractor.iter().enumerate() {
        let (x, y) = (options.x.value(cell % 13), options.y.value(cell / 13));
        let expected = match rests_in_gap(&p, [x, -x, 1.0, y, -y, 0.0]) {
            None => ESCAPED,
            Some(true) => 0,
            Some(false) => UNDECIDED,
        };
        assert_eq!(answer, expected, "from {x}, {y}");
    }
    let shares =
        [0, 1].map(|share| basin(&p, &BasinOptions { share: (share, 2), ..options }).expect("computes"));
    assert!(shares.iter().all(|share| share.attractors == found.attractors));
}

#[test]
fn motions_inside_the_gap_are_one_attractor_under_a_load_that_alternates_too() {
    let p = Parameters { regime: Regime::Backlash, error: 0.1, ..numbers(&[]) };
    let found = basin(&p, &BasinOptions::new(&p, even(1.0, 6), even(1.0, 6))).expect("computes");
    assert_eq!(found.attractors.len(), 1, "{:?}", found.attractors.len());
    assert_eq!(found.attractors[0].kind, AttractorKind::Gap { period: 1 });
    assert!(!found.attractors[0].is_rest_in_gap());
    assert!(found.attractor.iter().all(|index| *index == 0), "{:?}", found.attractor);
}

#[test]
fn undamped_there_is_no_family_in_the_gap() {
    let p = Parameters { regime: Regime::Backlash, ..numbers(&[("zeta", 0.0), ("zeta_s", 0.0)]) };
    let found = basin(&p, &BasinOptions::new(&p, even(1.0, 4), even(1.0, 4))).expect("computes");
    assert!(found.attractors.iter().all(|attractor| !matches!(attractor.kind, AttractorKind::Gap { .. })));
}
