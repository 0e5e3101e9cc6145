//! Exact tongue edges and boundaries against numbers from independent programs.

use crate::common::{numbers, parameters, reference};
use gear_bifurcations::model::parameters::Parameters;
use gear_bifurcations::numerics::parametric::Parametric;
use gear_bifurcations::numerics::roots::bracketed_root;
use gear_bifurcations::study::linear_floquet::LinearFloquet;
use gear_bifurcations::study::multipliers::multipliers;
use gear_bifurcations::study::tongue::{EdgeKind, Tongue, tongue_edges};
use gear_bifurcations::study::tongue_boundary::tongue_boundary;
use gear_bifurcations::theory::{Mode, hill};

fn damped(k0: f64, zeta: f64) -> Parameters {
    numbers(&[("m", 1.0), ("k", 5.0), ("k0", k0), ("zeta", zeta)])
}

fn reference_kind(name: &str) -> &'static str {
    match name {
        "-1" => "period-doubling",
        "+1" => "plus-one",
        "NS" => "neimark-sacker",
        "Krein" => "krein",
        other => panic!("{other}"),
    }
}

#[test]
fn edges_agree_to_1e_9_and_closed_tongues_are_closed() {
    let file = reference("tongue_edges");
    let mut worst = 0.0_f64;
    for (key, row) in file["edges"].as_object().expect("rows") {
        let value = |name: &str| -> f64 {
            let from = key.find(name).expect("given") + name.len() + 1;
            key[from..].split(' ').next().expect("a number").parse().expect("a number")
        };
        let p = damped(value("k0"), value("zeta"));
        for (name, tongue) in
            [("2w2", Tongue::Primary2), ("w2+w3", Tongue::Combination), ("2w3", Tongue::Primary3)]
        {
            let found =
                tongue_edges(&p, tongue, 1e-10).unwrap_or_else(|error| panic!("{key} {name}: {error}"));
            let expected = &row[name];
            let (Some(left), Some(right)) = (expected["left"].as_f64(), expected["right"].as_f64()) else {
                assert_eq!((found.left, found.right, found.kind), (None, None, None), "{key} {name}");
                continue;
            };
            let (own_left, own_right) = (found.left.expect("open"), found.right.expect("open"));
            worst = worst.max((own_left - left).abs()).max((own_right - right).abs());
            let kind = reference_kind(expected["type"].as_str().expect("a word"));
            assert_eq!(found.kind.expect("open").map(EdgeKind::name), [kind, kind], "{key} {name}");
            let near = tongue_edges(&p, Tongue::Near(0.5 * (left + right)), 1e-10).expect("found");
            let near = (near.left.expect("open") - left).abs().max((near.right.expect("open") - right).abs());
            worst = worst.max(near);
        }
    }
    assert!(worst < 1e-9, "{worst:e}");
}

#[test]
fn named_tongues_are_found_where_damping_hides_their_middle() {
    // Mesh and supports damped so differently, or supports so unequal, that the function whose zeros the edges are has no
    // minimum to follow from k0 = 0, or one that leads astray.
    for case in reference("tongue_edges_unequal_damping")["cases"].as_array().expect("cases") {
        let p = parameters(&case["params"]);
        let tongue = match case["tongue"].as_str().expect("a word") {
            "primary2" => Tongue::Primary2,
            "primary3" => Tongue::Primary3,
            _ => Tongue::Combination,
        };
        let found = tongue_edges(&p, tongue, 1e-10).unwrap_or_else(|error| panic!("{case}: {error}"));
        for (side, own) in [("left", found.left), ("right", found.right)] {
            let expected = case[side].as_f64().expect("a number");
            let own = own.unwrap_or_else(|| panic!("closed: {case}"));
            assert!((own - expected).abs() < 1e-9, "{case}: {found:?}");
        }
        for (own, kind) in found.kind.expect("open").iter().zip(case["kind"].as_array().expect("two")) {
            assert_eq!(own.name(), reference_kind(kind.as_str().expect("a word")), "{case}");
        }
    }
}

#[test]
fn other_tongues_are_found_near_a_frequency() {
    let rows = reference("tongue_edges")["other_edges_k0_0_5_zeta_0_005"].clone();
    let rows = rows.as_array().expect("rows");
    let p = damped(0.5, 0.005);
    for pair in rows.chunks(2) {
        let edge = |index: usize| pair[index]["W"].as_f64().expect("a number");
        for part in [0.5, 0.1] {
            let near = edge(0) + part * (edge(1) - edge(0));
            let found = tongue_edges(&p, Tongue::Near(near), 1e-10).expect("found");
            let off =
                (found.left.expect("open") - edge(0)).abs().max((found.right.expect("open") - edge(1)).abs());
            assert!(off < 1e-9, "{found:?}");
            let kinds = [0, 1].map(|index| reference_kind(pair[index]["type"].as_str().expect("a word")));
            assert_eq!(found.kind.expect("open").map(EdgeKind::name), kinds);
        }
    }
}

/// Least distance of a multiplier's modulus from 1: on an edge that lies in another tongue not the greatest one is there.
fn from_circle(p: &Parameters, omega: f64, k0: f64) -> f64 {
    let here = Parameters { omega, k0, ..*p };
    let found = multipliers(&here, 1e-13).expect("computes");
    found.re.iter().zip(&found.im).map(|(re, im)| (re.hypot(*im) - 1.0).abs()).fold(f64::INFINITY, f64::min)
}

#[test]
fn boundaries_lie_on_the_unit_circle_and_their_tips_are_the_thresholds() {
    let file = reference("tongue_edges");
    for (key, tongue) in
        [("2w2", Tongue::Primary2), ("w2+w3", Tongue::Combination), ("2w3", Tongue::Primary3)]
    {
        let p = damped(0.5, 0.02);
        let boundary = tongue_boundary(&p, tongue, [0.0, 0.5], 91, 1e-10).expect("followed");
        assert_eq!(boundary.omega.len(), 91);
        let tip = boundary.tip.expect("closed by damping");
        let expected = &file["tips"][format!("zeta=0.02 {key}")];
        assert!((tip[1] - expected["k0_min"].as_f64().expect("a number")).abs() < 1e-9, "{key} {tip:?}");
        // The reference found it as a minimum, which says where only to the square root of its digits.
        assert!((tip[0] - expected["W"].as_f64().expect("a number")).abs() < 2e-7, "{key} {tip:?}");
        assert_eq!((boundary.omega[boundary.left - 1], boundary.k0[boundary.left - 1]), (tip[0], tip[1]));
        let edges = tongue_edges(&p, tongue, 1e-10).expect("found");
        assert!((boundary.omega[0] - edges.left.expect("open")).abs() < 1e-9);
        assert!((boundary.omega[90] - edges.right.expect("open")).abs() < 1e-9);
        for (omega, k0) in boundary.omega.iter().zip(&boundary.k0) {
            assert!(from_circle(&p, *omega, *k0) < 1e-9, "{key} {omega} {k0}");
            assert!(*k0 >= tip[1]);
        }
    }
}

#[test]
fn the_tip_is_where_the_edges_meet() {
    let p = damped(0.5, 0.02);
    let tip =
        tongue_boundary(&p, Tongue::Primary2, [0.0, 0.5], 41, 1e-12).expect("followed").tip.expect("a tip");
    let above = Parameters { k0: tip[1] + 1e-8, ..p };
    let edges = tongue_edges(&above, Tongue::Primary2, 1e-12).expect("found");
    let middle = 0.5 * (edges.left.expect("open") + edges.right.expect("open"));
    assert!((middle - tip[0]).abs() < 1e-8, "{middle} {tip:?}");
    let below = Parameters { k0: tip[1] - 1e-9, ..p };
    assert_eq!(tongue_edges(&below, Tongue::Primary2, 1e-12).expect("found").kind, None);
}

#[test]
fn undamped_boundaries_start_at_k0_zero_and_cut_ones_have_two_legs() {
    let p = damped(0.5, 0.0);
    let boundary = tongue_boundary(&p, Tongue::Combination, [0.0, 0.5], 40, 1e-9).expect("followed");
    let tip = boundary.tip.expect("at k0 = 0");
    assert_eq!(tip[1], 0.0);
    assert!((tip[0] - 3.531_591_136).abs() < 1e-8, "{tip:?}");
    assert!(boundary.kind.iter().all(|kind| kind.name() == "krein"));
    let cut = tongue_boundary(&p, Tongue::Primary3, [0.2, 0.5], 40, 1e-9).expect("followed");
    assert_eq!((cut.tip, cut.left, cut.omega.len()), (None, 20, 40));
    assert!((cut.omega[19] - 5.315_707_746_115_634).abs() < 1e-9, "{cut:?}");
    assert!((cut.omega[20] - 5.504_569_317_838_794).abs() < 1e-9, "{cut:?}");
    let closed =
        tongue_boundary(&damped(0.5, 0.02), Tongue::Primary3, [0.0, 0.2], 40, 1e-9).expect("computes");
    assert!(closed.omega.is_empty() && closed.tip.is_none());
}

#[test]
fn unequal_supports_have_edges_on_the_unit_circle() {
    let p = numbers(&[
        ("m_p", 1.3),
        ("m_g", 0.7),
        ("k_p", 4.0),
        ("k_g", 6.5),
        ("zeta", 0.02),
        ("zeta_p", 0.01),
        ("k0", 0.6),
    ]);
    for tongue in [Tongue::Primary2, Tongue::Combination, Tongue::Primary3] {
        let edges = tongue_edges(&p, tongue, 1e-10).expect("found");
        for omega in [edges.left.expect("open"), edges.right.expect("open")] {
            assert!(from_circle(&p, omega, p.k0) < 1e-10, "{tongue:?} {edges:?}");
        }
        let boundary = tongue_boundary(&p, tongue, [0.0, 0.6], 31, 1e-10).expect("followed");
        for (omega, k0) in boundary.omega.iter().zip(&boundary.k0) {
            assert!(from_circle(&p, *omega, *k0) < 1e-9, "{tongue:?} {omega} {k0}");
        }
    }
}

#[test]
fn nearly_immovable_supports_give_the_edges_of_mathieus_equation() {
    // x'' + (a - 2 q cos 2s) x = 0 with Omega t = 2 s: a = 4/Omega^2, q = 2 k0/Omega^2 up to a phase.
    for row in reference("published_and_classical")["mathieu"]["values"].as_array().expect("rows") {
        let number = |name: &str| row[name].as_f64().expect("a number");
        for name in ["b1", "a1", "b2", "a2"] {
            let (a, q) = (number(name), number("q"));
            let (omega, k0) = ((4.0 / a).sqrt(), 2.0 * q / a);
            if !(a > 0.0 && k0 <= 1.0) {
                continue;
            }
            let p = Parameters { m_p: 1e8, m_g: 1e8, k_p: 2e8, k_g: 2e8, k0, ..damped(0.5, 0.0) };
            let side = if name.starts_with('b') { 1.0 } else { -1.0 };
            // b_n is the right edge of the tongue, a_n the left one of the same.
            let other = number(&format!("{}{}", if side > 0.0 { "a" } else { "b" }, &name[1..]));
            let width = (omega - (4.0 / other).sqrt()).abs();
            let found = tongue_edges(&p, Tongue::Near(omega - side * 0.2 * width), 1e-10).expect("found");
            let edge = if side > 0.0 { found.right } else { found.left }.expect("open");
            assert!((edge - omega).abs() < 1e-7, "{name} {q}: {edge} {omega}");
            let kind = if name.ends_with('1') { "period-doubling" } else { "plus-one" };
            assert!(found.kind.expect("open").iter().all(|found| found.name() == kind), "{found:?}");
        }
    }
}

#[test]
fn mathieus_characteristic_values_come_out_of_the_same_numerics() {
    // x'' + (a - 2 q cos 2s) x = 0: one coordinate, with the stiffness a - 1 beside the mesh's 1.
    for row in reference("published_and_classical")["mathieu"]["values"].as_array().expect("rows") {
        let q = row["q"].as_f64().expect("a number");
        for (name, multiplier) in [("a0", 1.0), ("b1", -1.0), ("a1", -1.0), ("b2", 1.0), ("a2", 1.0)] {
            let expected = row[name].as_f64().expect("a number");
            let value = |a: f64| {
                let system = Parametric::<1, 2> {
                    stiffness: [a - 1.0],
                    damping: [0.0],
                    coupling: [1.0],
                    mutual_damping: 0.0,
                };
                let polynomial = system.characteristic(2.0 * q, 2.0, 1000, 1.0).expect("computes");
                polynomial.value(multiplier)
            };
            let found =
                bracketed_root(value, expected - 2e-3, expected + 2e-3, 1e-13).expect("a change of sign");
            assert!((found - expected).abs() < 1e-9, "{name} at {q}: {found} {expected}");
        }
    }
}

#[test]
fn a_narrow_tongue_is_found_from_right_beside_it() {
    // Narrower than a step of the search, which starts less than a step away.
    for k0 in [1e-4, 1e-3] {
        let p = damped(k0, 0.0);
        for tongue in [Tongue::Primary2, Tongue::Primary3] {
            let own = tongue_edges(&p, tongue, 1e-10).expect("computes");
            let (left, right) = (own.left.expect("open"), own.right.expect("open"));
            for aside in [3e-4, 1e-3, 4e-3] {
                for start in [left - aside, right + aside] {
                    let near = tongue_edges(&p, Tongue::Near(start), 1e-10).expect("computes");
                    let found = near.left.unwrap_or_else(|| panic!("none from {start}: {left} to {right}"));
                    assert!((found - left).abs() < 1e-8, "{start}: {found} for {left}");
                }
            }
        }
    }
}

#[test]
fn edges_agree_with_the_determinants_of_hill() {
    let mut open = 0;
    for (m, k) in [(1.0, 5.0), (0.4, 2.0), (3.0, 4.0)] {
        for (zeta, zeta_s) in [(0.0, 0.0), (0.01, 0.01), (0.03, 0.002)] {
            for k0 in [0.05, 0.3, 0.6] {
                let p = numbers(&[("m", m), ("k", k), ("zeta", zeta), ("zeta_s", zeta_s), ("k0", k0)]);
                let symmetric = p.symmetric().expect("equal supports");
                for (tongue, mode) in [(Tongue::Primary2, Mode::Second), (Tongue::Primary3, Mode::Third)] {
                    let expected = hill::edges(&symmetric, mode).expect("computes");
                    let found = tongue_edges(&p, tongue, 1e-11).expect("computes");
                    let both = expected.map(|edges| (edges.left, edges.right));
                    let (Some((left, right)), Some(own_left), Some(own_right)) =
                        (both, found.left, found.right)
                    else {
                        assert_eq!((both, found.left, found.right), (None, None, None), "{p:?} {tongue:?}");
                        continue;
                    };
                    open += 1;
                    let off = (own_left - left).abs().max((own_right - right).abs());
                    assert!(off < 1e-9, "{off:e} {tongue:?} m {m} k {k} zeta {zeta} {zeta_s} k0 {k0}");
                }
            }
        }
    }
    assert!(open > 30, "{open}");
}

#[test]
fn sharp_tips_of_light_damping_are_neither_jumped_nor_taken_for_undamped_ones() {
    for zeta in [1e-3, 1e-4, 1e-5, 1e-6] {
        let p = damped(0.5, zeta);
        let symmetric = p.symmetric().expect("equal supports");
        for (tongue, mode) in [(Tongue::Primary2, Mode::Second), (Tongue::Primary3, Mode::Third)] {
            let expected = hill::tip(&symmetric, mode).expect("computes").expect("below k0 = 1");
            let boundary = tongue_boundary(&p, tongue, [0.0, 0.5], 41, 1e-10).expect("followed");
            let tip = boundary.tip.expect("closed by damping");
            // The square of k0 is what the conditions fix, to their rounding.
            let fine = 1e-9_f64.max(1e-14 / expected.k0);
            assert!((tip[1] - expected.k0).abs() < fine, "{zeta} {tongue:?}: {tip:?} {expected:?}");
            assert!((tip[0] - expected.omega).abs() < 1e-6, "{zeta} {tongue:?}: {tip:?} {expected:?}");
        }
    }
}

#[test]
fn boundaries_that_the_arc_cannot_follow_come_from_their_edges() {
    // Other tongues run into these from the side.
    for (m, k, damping, tongue) in [
        (
            [0.382_956_4, 0.382_956_4],
            [1.452_599, 1.452_599],
            [0.0, 0.012_816_7, 0.012_816_7],
            Tongue::Primary2,
        ),
        (
            [8.795_099_7, 0.367_429_4],
            [1.769_549_6, 0.362_397_6],
            [0.032_412_2, 0.0, 0.000_129_26],
            Tongue::Combination,
        ),
        (
            [28.047_709, 28.047_709],
            [0.791_162_9, 0.791_162_9],
            [0.000_989_6, 0.023_526, 0.023_526],
            Tongue::Combination,
        ),
    ] {
        let p = Parameters {
            m_p: m[0],
            m_g: m[1],
            k_p: k[0],
            k_g: k[1],
            zeta: damping[0],
            zeta_p: damping[1],
            zeta_g: damping[2],
            ..damped(1.0, 0.0)
        };
        let boundary = tongue_boundary(&p, tongue, [0.0, 1.0], 31, 1e-10).expect("computes");
        assert!(boundary.method.starts_with("edges at one depth"), "{}", boundary.method);
        assert!(boundary.omega.len() > 20 && boundary.tip.is_some());
        for (omega, k0) in boundary.omega.iter().zip(&boundary.k0) {
            // The tip is where the edges can no longer be told apart.
            if [*omega, *k0] != boundary.tip.expect("just seen") {
                assert!(from_circle(&p, *omega, *k0) < 1e-8, "{tongue:?} {omega} {k0}");
            }
        }
    }
}

#[test]
fn supports_that_damping_alone_tells_apart_have_the_frequencies_of_equal_ones() {
    let equal = Parameters { m_p: 1.3, m_g: 1.3, k_p: 2.0, k_g: 2.0, ..damped(0.5, 0.02) };
    let unequal = Parameters { zeta_p: 0.05, ..equal };
    let (two, three) = (LinearFloquet::new(&equal), LinearFloquet::new(&unequal));
    assert_eq!((two.modes(), three.modes()), (2, 3));
    let (outer, all) = (two.frequencies(), three.frequencies());
    for (own, expected) in all.iter().zip([outer[0], (2.0_f64 / 1.3).sqrt(), outer[1]]) {
        assert!((own - expected).abs() < 1e-12, "{all:?} {outer:?}");
    }
    for (left, right) in [(outer[0], all[0]), (outer[1], all[2])] {
        assert!((two.participation(left) - three.participation(right)).abs() < 1e-10);
    }
}
