//! Exact tongue edges and boundaries against numbers from independent programs.

mod common;

use common::{numbers, reference};
use gear_bifurcations::model::parameters::Parameters;
use gear_bifurcations::study::tongue::{Tongue, tongue_edges};

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
            println!("{key} {name} {:e} {:e} {:?}", own_left - left, own_right - right, found.error);
            worst = worst.max((own_left - left).abs()).max((own_right - right).abs());
            let kind = reference_kind(expected["type"].as_str().expect("a word"));
            assert_eq!(found.kind.expect("open").map(|kind| kind.name()), [kind, kind], "{key} {name}");
            let near = tongue_edges(&p, Tongue::Near(0.5 * (left + right)), 1e-10).expect("found");
            println!(
                "   near {:e} {:e} {:?}",
                near.left.unwrap() - left,
                near.right.unwrap() - right,
                near.kind
            );
        }
    }
    assert!(worst < 1e-9, "{worst:e}");
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
            println!(
                "{:e} {:e} {:?}",
                found.left.unwrap() - edge(0),
                found.right.unwrap() - edge(1),
                found.kind
            );
        }
    }
}
