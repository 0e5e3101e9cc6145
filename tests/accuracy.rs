//! Every reference number, ours, and the deviation: `docs/accuracy.md` is written by this test when
//! `ACCURACY=renew` is set (`cargo xtask accuracy`), and is otherwise held against what the library computes today.

mod common;

use common::{floats, numbers, parameters, reference};
use gear_bifurcations::model::parameters::{Parameters, Regime};
use gear_bifurcations::study::branch::{BranchOptions, EventKind, branch};
use gear_bifurcations::study::multipliers::multipliers;
use gear_bifurcations::study::orbit::{OrbitOptions, periodic_orbit};
use gear_bifurcations::study::time_response::{TimeResponseOptions, time_response};
use gear_bifurcations::study::tongue::{Tongue, tongue_edges};
use gear_bifurcations::study::tongue_boundary::tongue_boundary;
use gear_bifurcations::study::torus::torus;
use gear_bifurcations::theory::{Mode, Modes, combination, primary};
use serde_json::Value as Json;
use std::fmt::Write as _;

/// A number of somebody else's beside ours.
struct Row {
    what: String,
    reference: f64,
    ours: f64,
    /// Greatest deviation we allow ourselves: half a unit of the reference's last digit where it has few.
    wanted: f64,
}

struct Section {
    title: &'static str,
    origin: &'static str,
    rows: Vec<Row>,
}

impl Section {
    fn new(title: &'static str, origin: &'static str) -> Self {
        Self { title, origin, rows: Vec::new() }
    }

    fn row(&mut self, what: impl Into<String>, reference: f64, ours: f64, wanted: f64) {
        self.rows.push(Row { what: what.into(), reference, ours, wanted });
    }
}

fn number(value: &Json) -> f64 {
    value.as_f64().expect("a number")
}

fn modes_and_widths() -> Section {
    let mut section = Section::new("Modes and widths of the formulas", "modes_and_tongues.json");
    for case in reference("modes_and_tongues").as_array().expect("cases") {
        let (m, k) = (number(&case["m"]), number(&case["k"]));
        let at = format!("m = {m}, k = {k}");
        let p = numbers(&[("m", m), ("k", k)]).symmetric().expect("equal supports");
        let modes = Modes::of(&p).expect("modes");
        section.row(format!("a, {at}"), number(&case["a"]), modes.a, 1e-12);
        section.row(format!("b, {at}"), number(&case["b"]), modes.b, 1e-12);
        for (index, expected) in floats(&case["omega"]).into_iter().enumerate() {
            section.row(format!("omega_{}, {at}", index + 1), expected, modes.omega[index], 1e-12);
        }
        let widths = &case["half_width_paper"];
        for (mode, name, symbol) in [(Mode::Second, "primary2", "W_2"), (Mode::Third, "primary3", "W_3")] {
            let ours = primary::half_width(&modes, mode);
            section.row(format!("{symbol}, {at}"), number(&widths[name]), ours, 1e-12);
        }
        let printed = combination::half_width_printed(&modes);
        section.row(format!("(105) as printed, {at}"), number(&widths["combination_105"]), printed, 1e-12);
        let corrected = combination::half_width(&modes);
        let expected = number(&case["half_width_corrected"]["combination_T4"]);
        section.row(format!("W_c corrected, {at}"), expected, corrected, 1e-12);
    }
    section
}

fn floquet() -> Section {
    let mut section = Section::new("Floquet multipliers", "floquet_multipliers.json");
    for (index, case) in reference("floquet_multipliers").as_array().expect("cases").iter().enumerate() {
        let found = multipliers(&parameters(&case["params"]), 1e-10).expect("computes");
        let mut left: Vec<usize> = (0..6).collect();
        for pair in case["multipliers"].as_array().expect("six") {
            let (re, im) = (number(&pair[0]), number(&pair[1]));
            let distance = |i: &usize| (found.re[*i] - re).hypot(found.im[*i] - im);
            let nearest = *left
                .iter()
                .min_by(|one, other| distance(one).total_cmp(&distance(other)))
                .expect("six multipliers");
            left.retain(|other| *other != nearest);
            // Meeting multipliers of an undamped system are known to the square root of everything else.
            let meeting = (0..6).any(|i| {
                i != nearest
                    && (found.re[i] - found.re[nearest]).hypot(found.im[i] - found.im[nearest]) < 1e-5
            });
            let wanted = if meeting { 1e-7 } else { 1e-9 };
            section.row(format!("case {}, real part", index + 1), re, found.re[nearest], wanted);
            section.row(format!("case {}, imaginary part", index + 1), im, found.im[nearest], wanted);
        }
    }
    section
}

fn tongue_of(name: &str) -> Tongue {
    match name {
        "2w2" => Tongue::Primary2,
        "w2+w3" => Tongue::Combination,
        "2w3" => Tongue::Primary3,
        other => panic!("unknown tongue {other}"),
    }
}

/// The numbers in a text such as `k0=0.5 zeta=0.02`.
fn named(text: &str) -> Vec<(&str, f64)> {
    text.split_whitespace()
        .filter_map(|word| word.split_once('='))
        .map(|(name, value)| (name, value.parse().expect("a number")))
        .collect()
}

fn edges() -> Section {
    let mut section = Section::new("Edges of the tongues", "tongue_edges.json");
    let file = reference("tongue_edges");
    for (case, tongues) in file["edges"].as_object().expect("cases") {
        let p = numbers(&named(case));
        for (name, expected) in tongues.as_object().expect("tongues") {
            let found = tongue_edges(&p, tongue_of(name), 1e-10).expect("computes");
            if expected.is_null() {
                assert!(found.left.is_none() && found.right.is_none(), "{case} {name} is closed: {found:?}");
                continue;
            }
            for (side, ours) in [("left", found.left), ("right", found.right)] {
                let ours = ours.unwrap_or_else(|| panic!("{case} {name} is open"));
                section.row(format!("{name} {side}, {case}"), number(&expected[side]), ours, 1e-9);
            }
        }
    }
    section
}

/// Supports so heavy and so stiff that the gears cannot give way: what is left is one oscillator, whose edges are classical.
fn immovable(zeta: f64, k0: f64) -> Parameters {
    Parameters { m_p: 1e8, m_g: 1e8, k_p: 2e8, k_g: 2e8, ..numbers(&[("zeta", zeta), ("k0", k0)]) }
}

fn published() -> Section {
    let mut section = Section::new(
        "Published edges, through the gear pair with immovable supports",
        "published_and_classical.json",
    );
    let file = reference("published_and_classical");
    for case in file["parametric_duffing"]["rows"].as_array().expect("rows") {
        let p = immovable(0.01, number(&case["eps"]));
        let found = tongue_edges(&p, Tongue::Near(2.0), 1e-10).expect("computes");
        for (side, expected, ours) in
            [("left", &case["edges"][0], found.left), ("right", &case["edges"][1], found.right)]
        {
            let what = format!("Mathieu with damping 0.01, {side}, k0 = {}", case["eps"]);
            section.row(what, number(expected), ours.expect("an edge"), 1e-7);
        }
    }
    // A characteristic value a at q is the edge Omega = 2 / sqrt(a) at k0 = 2 q / a.
    for case in file["mathieu"]["values"].as_array().expect("values") {
        for (name, side) in [("b1", 1), ("a1", 0), ("b2", 1), ("a2", 0)] {
            let (q, a) = (number(&case["q"]), number(&case[name]));
            let (omega, k0) = (2.0 / a.sqrt(), 2.0 * q / a);
            let middle = if name.ends_with('1') { 2.0 } else { 1.0 };
            if a <= 0.0 || k0 > 1.0 {
                continue;
            }
            let found = tongue_edges(&immovable(0.0, k0), Tongue::Near(middle), 1e-10).expect("computes");
            let edges = [found.left, found.right].map(|edge| edge.expect("an edge"));
            section.row(format!("{name} at q = {q}, as Omega"), omega, edges[side], 1e-7);
        }
    }
    section
}

fn tips() -> Section {
    let mut section = Section::new("Tips of the tongues", "tongue_edges.json");
    for (case, expected) in reference("tongue_edges")["tips"].as_object().expect("tips") {
        let (zeta, name) = case.split_once(' ').expect("damping and tongue");
        let tongue = if name == "2w2/2" { Tongue::Near(0.81) } else { tongue_of(name) };
        let p = numbers(&[named(zeta)[0], ("k0", 0.5)]);
        let boundary = tongue_boundary(&p, tongue, [0.01, 0.5], 60, 1e-10).expect("computes");
        let [omega, k0] = boundary.tip.unwrap_or_else(|| panic!("{case} has a tip"));
        section.row(format!("k0 at the tip, {case}"), number(&expected["k0_min"]), k0, 1e-9);
        // Flat there: where it is least is known to the square root of how little it is.
        section.row(format!("Omega at the tip, {case}"), number(&expected["W"]), omega, 1e-6);
    }
    section
}

fn orbits() -> Section {
    let mut section = Section::new("Periodic orbits", "periodic_orbits.json");
    for case in reference("periodic_orbits")["orbits"].as_array().expect("orbits") {
        let period = case["period_in_T"].as_u64().expect("a number") as usize;
        let options = OrbitOptions { period, ..OrbitOptions::default() };
        let orbit = periodic_orbit(&parameters(&case["params"]), &options).expect("found");
        let figure = case["figure"].as_str().expect("a figure");
        for (index, expected) in floats(&case["state"]).into_iter().enumerate() {
            let name = ["u_p", "u_g", "u", "u_p'", "u_g'", "u'"][index];
            section.row(format!("{name}, figure {figure}"), expected, orbit.state[index], 1e-8);
        }
    }
    section
}

fn branches() -> Section {
    let mut section = Section::new("The branch of period 2T in tongue 2", "orbit_branch.json");
    let file = reference("orbit_branch");
    for case in file["tongue2"].as_array().expect("points") {
        let value = |name: &str| number(&case[name]);
        let (u_p, velocity) = (value("u_p"), value("u_p_dot"));
        let guess = Some([u_p, -u_p, value("u"), velocity, -velocity, value("u_dot")]);
        let p = numbers(&[("Omega", value("Omega"))]);
        let options = OrbitOptions { period: 2, guess, ..OrbitOptions::default() };
        let orbit = periodic_orbit(&p, &options).expect("found");
        let at = format!("Omega = {}", value("Omega"));
        section.row(format!("u_p, {at}"), u_p, orbit.state[0], 1e-8);
        section.row(format!("u, {at}"), value("u"), orbit.state[2], 1e-8);
        section.row(format!("max u_p, {at}"), value("max_u_p"), orbit.max[0], 1e-8);
    }
    let p = numbers(&[("Omega", 1.65)]);
    let traced = branch(&p, &BranchOptions::new([1.2, 1.8], 2)).expect("traced");
    let event = |kind: EventKind, near: f64| {
        let values = traced.events.iter().filter(|event| event.kind == kind).map(|event| event.value);
        values.min_by(|one, other| (one - near).abs().total_cmp(&(other - near).abs())).unwrap_or(f64::NAN)
    };
    let events = &file["events"];
    // Given to 1e-9.
    for (name, kind, key) in [
        ("torus bifurcation", EventKind::NeimarkSacker, "torus"),
        ("fold", EventKind::Fold, "fold"),
        ("branch point across the manifold", EventKind::Pitchfork, "branch_point_across_manifold"),
    ] {
        let expected = number(&events[key]);
        section.row(name, expected, event(kind, expected), 1e-7);
    }
    section
}

fn tori() -> Section {
    let mut section = Section::new("Tori", "tori.json");
    for case in reference("tori")["tori"].as_array().expect("tori") {
        let omega = number(&case["Omega"]);
        let found = torus(&numbers(&[("Omega", omega)]), 1e-10).expect("found");
        let at = format!("Omega = {omega}");
        section.row(format!("mean radius, {at}"), number(&case["mean_radius"]), found.mean_radius, 1e-5);
        section.row(format!("rotation, {at}"), number(&case["rotation"]), found.rotation, 1e-7);
        section.row(format!("least radius, {at}"), number(&case["r_min"]), found.r_min, 1e-4);
        section.row(format!("greatest radius, {at}"), number(&case["r_max"]), found.r_max, 1e-3);
    }
    section
}

fn figure_14() -> Section {
    let mut section = Section::new("Figure 14, settled", "the numbers that come with the model");
    let ranges = [
        ("14 a", Regime::Backlash, 0.0, 900.0, 800.0, [-0.4539, 4.9618]),
        ("14 b", Regime::Contact, -1.3, 400.0, 300.0, [2.2497, 2.8431]),
        ("14 b", Regime::Backlash, -1.3, 400.0, 300.0, [2.2497, 2.8431]),
    ];
    for (figure, regime, alpha, periods, settled, expected) in ranges {
        let p = numbers(&[("zeta", 0.07), ("Omega", 1.6), ("alpha", alpha)]);
        let p = Parameters { load: 1.5, regime, ..p };
        let options =
            TimeResponseOptions { periods, samples_per_period: 400, ..TimeResponseOptions::new(&p) };
        let response = time_response(&p, &options).expect("computes");
        let from = settled * p.mesh_period();
        let late =
            || response.t.iter().zip(&response.states).filter(|(t, _)| **t > from).map(|(_, state)| state[2]);
        let word = if regime == Regime::Contact { "contact" } else { "backlash" };
        let (low, high) = (late().fold(f64::INFINITY, f64::min), late().fold(f64::NEG_INFINITY, f64::max));
        section.row(format!("least u, {figure}, {word}"), expected[0], low, 1e-4);
        section.row(format!("greatest u, {figure}, {word}"), expected[1], high, 1e-4);
    }
    section
}

fn written(sections: &[Section]) -> String {
    let mut text = String::from(
        "# Accuracy\n\nEvery reference number that we hold, ours, and how far they are apart. Written by `cargo xtask accuracy`;\n\
         `tests/accuracy.rs` fails where a deviation is larger than wanted. The files and where their numbers come from are\n\
         told in `tests/reference/README.md`. Reference numbers of few digits agree to half of their last one.\n",
    );
    for section in sections {
        let farthest = section.rows.iter().map(|row| (row.ours - row.reference).abs()).fold(0.0, f64::max);
        let _ = write!(
            text,
            "\n## {}\n\nFrom {}. {} numbers; the largest deviation is {farthest:.1e}.\n\n| what | reference | ours | deviation | wanted |\n|---|---:|---:|---:|---:|\n",
            section.title,
            section.origin,
            section.rows.len()
        );
        for row in &section.rows {
            let deviation = row.ours - row.reference;
            let _ = writeln!(
                text,
                "| {} | {} | {:.12} | {deviation:.1e} | {:.0e} |",
                row.what, row.reference, row.ours, row.wanted
            );
        }
    }
    text
}

#[test]
fn every_reference_number_is_met_and_told() {
    let sections = [
        modes_and_widths(),
        floquet(),
        edges(),
        published(),
        tips(),
        orbits(),
        branches(),
        tori(),
        figure_14(),
    ];
    let mut far = Vec::new();
    for row in sections.iter().flat_map(|section| &section.rows) {
        let deviation = (row.ours - row.reference).abs();
        if deviation.is_nan() || deviation > row.wanted {
            far.push(format!("{}: {} and not {}, {deviation:e} apart", row.what, row.ours, row.reference));
        }
    }
    assert!(far.is_empty(), "{}", far.join("\n"));
    let path = format!("{}/docs/accuracy.md", env!("CARGO_MANIFEST_DIR"));
    let text = written(&sections);
    if std::env::var("ACCURACY").is_ok_and(|wish| wish == "renew") {
        std::fs::write(&path, &text).expect("docs/accuracy.md can be written");
    }
    // The last digits of ours depend on the machine; what is compared does not.
    let told = std::fs::read_to_string(&path).expect("docs/accuracy.md, written by `cargo xtask accuracy`");
    let compared = |text: &str| -> Vec<String> {
        let columns = |line: &str| line.split('|').take(3).collect::<Vec<_>>().join("|");
        text.lines().filter(|line| line.starts_with('|')).map(columns).collect()
    };
    assert!(
        compared(&told) == compared(&text),
        "docs/accuracy.md is out of date: run `cargo xtask accuracy`"
    );
}
