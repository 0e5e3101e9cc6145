//! Numbers that every engine must give too: `tests/engines/numbers.json` holds questions to the module, as a page asks them, and
//! the native answers. They are written by this test when `ENGINES=renew` is set (`cargo xtask numbers`), and are otherwise held
//! against what the library computes today. `tests/engines/` asks the engines.

mod common;

use common::parameters;
use gear_bifurcations::figures::figure;
use gear_bifurcations::model::parameters::Value;
use gear_bifurcations::study::basin::{BasinOptions, basin};
use gear_bifurcations::study::branch::{BranchOptions, branch};
use gear_bifurcations::study::contact::{contact_margin, least_load};
use gear_bifurcations::study::grid::Grid;
use gear_bifurcations::study::lyapunov::lyapunov;
use gear_bifurcations::study::multipliers::multipliers;
use gear_bifurcations::study::orbit::{OrbitOptions, periodic_orbit};
use gear_bifurcations::study::poincare::{PoincareOptions, poincare};
use gear_bifurcations::study::spectrum::spectrum;
use gear_bifurcations::study::stability_chart::stability_chart;
use gear_bifurcations::study::sweep::{SweepOptions, sweep};
use gear_bifurcations::study::time_response::{TimeResponseOptions, time_response};
use gear_bifurcations::study::tongue::{Tongue, tongue_edges};
use gear_bifurcations::study::tongue_boundary::tongue_boundary;
use gear_bifurcations::study::torus::torus;
use gear_bifurcations::theory::{Modes, tongues};
use serde_json::{Map, Value as Json, json};
use std::fmt::Write as _;

/// Numbers agree within this, relative above 1.
const AGREE: f64 = 1e-9;
/// The tolerance that the module's calls have where none is given.
const TOLERANCE: f64 = 1e-10;
/// Of a longer column so many numbers are kept, evenly spread, and its length.
const KEPT: usize = 12;
/// The same of a figure's columns, of which there are a thousand.
const KEPT_OF_FIGURES: usize = 6;

fn path() -> String {
    format!("{}/tests/engines/numbers.json", env!("CARGO_MANIFEST_DIR"))
}

/// A column: short ones whole, of long ones a part that says where it lies.
fn column(numbers: impl IntoIterator<Item = f64>) -> Json {
    thinned(&numbers.into_iter().collect::<Vec<f64>>(), KEPT)
}

fn thinned(numbers: &[f64], kept: usize) -> Json {
    if numbers.len() <= kept {
        return json!(numbers);
    }
    let at: Vec<usize> = (0..kept).map(|part| part * (numbers.len() - 1) / (kept - 1)).collect();
    let is: Vec<f64> = at.iter().map(|index| numbers[*index]).collect();
    json!({ "length": numbers.len(), "at": at, "is": is })
}

fn states(rows: &[[f64; 6]]) -> Map<String, Json> {
    let names = ["u_p", "u_g", "u", "u_p_dot", "u_g_dot", "u_dot"];
    let column_of = |index: usize| column(rows.iter().map(|row| row[index]));
    names.iter().enumerate().map(|(index, name)| ((*name).to_owned(), column_of(index))).collect()
}

/// What a question's options say, as the module reads them.
struct Options<'a>(&'a Json);

impl Options<'_> {
    fn whole(&self, name: &str) -> Option<usize> {
        self.0[name].as_u64().map(|number| number as usize)
    }

    fn pair(&self, name: &str) -> [f64; 2] {
        let pair = common::floats(&self.0[name]);
        [pair[0], pair[1]]
    }

    fn grid(&self, name: &str) -> Grid {
        let [low, high, count] = <[f64; 3]>::try_from(common::floats(&self.0[name])).expect("a grid");
        Grid::new("Omega", [low, high], count as usize, [-1e3, 1e3]).expect("a grid")
    }

    fn state(&self, name: &str) -> Option<[f64; 6]> {
        self.0.get(name).map(|state| <[f64; 6]>::try_from(common::floats(state)).expect("a state"))
    }

    fn tongue(&self) -> Tongue {
        match self.0["tongue"].as_str() {
            Some("primary2") => Tongue::Primary2,
            Some("primary3") => Tongue::Primary3,
            Some("combination") => Tongue::Combination,
            _ => Tongue::Near(self.0["tongue"]["near"].as_f64().expect("a mesh frequency")),
        }
    }
}

/// The native answer to a question.
fn answer(question: &Json) -> Json {
    let call = question["call"].as_str().expect("a call");
    if call == "figure" {
        return figure_answer(question);
    }
    let p = parameters(&question["params"]);
    let options = Options(&question["options"]);
    match call {
        "modes" => {
            let modes = Modes::of(&p.symmetric().expect("equal supports")).expect("modes");
            json!({ "a": modes.a, "b": modes.b, "omega": column(modes.omega), "shapes": column(modes.shapes().concat()) })
        }
        "tongues" => {
            let all = tongues(&p.symmetric().expect("equal supports")).expect("tongues");
            let edges = |edges: Option<gear_bifurcations::theory::Edges>| {
                edges.map_or(json!({}), |edges| json!({ "left": edges.left, "right": edges.right }))
            };
            let one = |tongue: &gear_bifurcations::theory::Tongue| {
                json!({ "Omega0": tongue.omega_0, "threshold": tongue.threshold, "paper": edges(tongue.paper),
                        "corrected": edges(tongue.corrected), "damped": edges(tongue.damped) })
            };
            json!({ "primary2": one(&all.primary2), "primary3": one(&all.primary3), "combination": one(&all.combination) })
        }
        "multipliers" => {
            let found = multipliers(&p, TOLERANCE).expect("multipliers");
            json!({ "re": column(found.re), "im": column(found.im), "spectralRadius": found.spectral_radius, "state": column(found.state) })
        }
        "tongueEdges" => {
            let found = tongue_edges(&p, options.tongue(), TOLERANCE).expect("edges");
            json!({ "left": found.left, "right": found.right })
        }
        "tongueBoundary" => {
            let points = options.whole("points").expect("points");
            let found = tongue_boundary(&p, options.tongue(), options.pair("k0"), points, TOLERANCE)
                .expect("a boundary");
            // Where the tip lies along Omega is known to the square root of how deep it is: only the depth is compared.
            json!({ "Omega": column(found.omega), "k0": column(found.k0), "tip": { "k0": found.tip.expect("a tip")[1] } })
        }
        "stabilityChart" => {
            let chart =
                stability_chart(&p, options.grid("Omega"), options.grid("k0"), 1e-6).expect("a chart");
            json!({ "spectralRadius": column(chart.spectral_radius) })
        }
        "timeResponse" => {
            let usual = TimeResponseOptions::new(&p);
            let asked = TimeResponseOptions {
                state: options.state("state").unwrap_or(usual.state),
                periods: question["options"]["periods"].as_f64().unwrap_or(usual.periods),
                samples_per_period: options.whole("samplesPerPeriod").unwrap_or(usual.samples_per_period),
                ..usual
            };
            let found = time_response(&p, &asked).expect("a motion");
            let mut columns = states(&found.states);
            columns.insert("t".to_owned(), column(found.t));
            columns.insert("contactLoss".to_owned(), column(found.contact_loss));
            Json::Object(columns)
        }
        "poincare" => {
            let usual = PoincareOptions::new(&p);
            let asked = PoincareOptions {
                transient: options.whole("transient").unwrap_or(usual.transient),
                points: options.whole("points").unwrap_or(usual.points),
                ..usual
            };
            Json::Object(states(&poincare(&p, &asked).expect("points").states))
        }
        "periodicOrbit" => {
            let usual = OrbitOptions::default();
            let asked = OrbitOptions { period: options.whole("period").unwrap_or(usual.period), ..usual };
            let found = periodic_orbit(&p, &asked).expect("an orbit");
            json!({
                "state": column(found.state), "min": column(found.min), "max": column(found.max), "period": found.period,
                "multipliers": { "re": column(found.re), "im": column(found.im) },
            })
        }
        "branch" => {
            let asked = BranchOptions {
                points: options.whole("points").expect("points"),
                ..BranchOptions::new(options.pair("range"), options.whole("period").unwrap_or(1))
            };
            let found = branch(&p, &asked).expect("a branch");
            let events: Vec<Json> = found
                .events
                .iter()
                .map(|event| json!({ "Omega": event.value, "state": column(event.state) }))
                .collect();
            json!({
                "Omega": column(found.value), "maxU_p": column(found.max_u_p), "state": column(found.state.concat()),
                "unstable": column(found.unstable.iter().map(|count| *count as f64)), "events": events,
            })
        }
        "torus" => {
            let found = torus(&p, TOLERANCE).expect("a torus");
            json!({ "meanRadius": found.mean_radius, "rotation": found.rotation, "maxU_p": found.max_u_p, "growth": found.growth })
        }
        "sweep" => {
            let usual = SweepOptions::new(options.grid("Omega"));
            let asked = SweepOptions {
                transient: options.whole("transient").unwrap_or(usual.transient),
                points: options.whole("points").unwrap_or(usual.points),
                ..usual
            };
            let found = sweep(&p, &asked).expect("a sweep");
            json!({ "Omega": column(found.omega), "u_p": column(found.u_p), "u": column(found.u) })
        }
        "lyapunov" => {
            let periods = options.whole("periods").expect("periods");
            let found = lyapunov(&p, options.state("state"), periods, TOLERANCE).expect("exponents");
            json!({ "exponents": column(found.exponents), "state": column(found.state) })
        }
        "spectrum" => {
            let (transient, periods) = (options.whole("transient"), options.whole("periods"));
            let found = spectrum(&p, None, transient.expect("periods"), periods.expect("periods"), TOLERANCE)
                .expect("a spectrum");
            json!({ "frequency": column(found.frequency), "amplitude": column(found.amplitude) })
        }
        "basin" => {
            let usual = BasinOptions::new(&p, options.grid("x"), options.grid("y"));
            let found = basin(&p, &usual).expect("basins");
            let attractors: Vec<Json> = found
                .attractors
                .iter()
                .map(|attractor| json!({ "state": column(attractor.state) }))
                .collect();
            json!({ "attractor": column(found.attractor.iter().map(|index| f64::from(*index))), "attractors": attractors })
        }
        "contactMargin" => {
            let found = contact_margin(&p, None, TOLERANCE).expect("a margin");
            json!({ "margin": found.margin, "at": found.at, "state": column(found.state) })
        }
        "leastLoad" => {
            let found = least_load(&p, TOLERANCE).expect("a load");
            json!({ "F": found.load, "contactF": found.contact_load })
        }
        other => panic!("no call {other}"),
    }
}

/// A figure by the columns of all its series.
fn figure_answer(question: &Json) -> Json {
    let given: Vec<(String, Value)> = question["params"]
        .as_object()
        .expect("an object")
        .iter()
        .map(|(name, value)| (name.clone(), Value::Number(value.as_f64().expect("a number"))))
        .collect();
    let id = question["id"].as_str().expect("an id");
    let figure = figure(id, &given).unwrap_or_else(|error| panic!("figure {id}: {error}"));
    let series: Vec<Json> = figure
        .drawing
        .series
        .iter()
        .map(|series| {
            let column = |numbers: &[f64]| thinned(numbers, KEPT_OF_FIGURES);
            let mut columns = json!({ "x": column(&series.x), "y": column(&series.y) });
            if !series.z.is_empty() {
                columns["z"] = column(&series.z);
            }
            json!({ "name": series.name, "columns": columns })
        })
        .collect();
    json!({ "series": series })
}

/// Where two answers differ by more than [`AGREE`].
fn differences(expected: &Json, found: &Json, at: &str, told: &mut Vec<String>) {
    match (expected, found) {
        (Json::Number(one), Json::Number(other)) => {
            let (one, other) = (one.as_f64().expect("finite"), other.as_f64().expect("finite"));
            if (one - other).abs() > AGREE * one.abs().max(1.0) {
                told.push(format!("{at}: {one:?} was written, {other:?} is found"));
            }
        }
        (Json::Array(one), Json::Array(other)) if one.len() == other.len() => {
            for (index, (one, other)) in one.iter().zip(other).enumerate() {
                differences(one, other, &format!("{at}[{index}]"), told);
            }
        }
        (Json::Object(one), Json::Object(other)) if one.keys().eq(other.keys()) => {
            for (name, one) in one {
                differences(one, &other[name], &format!("{at}.{name}"), told);
            }
        }
        (one, other) if one == other => {}
        (one, other) => told.push(format!("{at}: {one} was written, {other} is found")),
    }
}

#[test]
fn the_numbers_that_engines_are_held_to_are_the_native_ones() {
    let text = std::fs::read_to_string(path()).expect("the file is there");
    let questions: Vec<Json> = serde_json::from_str(&text).expect("it is JSON");
    let renew = std::env::var_os("ENGINES").is_some_and(|wanted| wanted == "renew");
    let (mut written, mut told) = (Vec::new(), Vec::new());
    for question in &questions {
        let found = answer(question);
        if !renew {
            let at = format!("{} {} {}", question["call"], question["id"], question["params"]);
            differences(&question["answer"], &found, &at, &mut told);
        }
        let mut renewed = question.clone();
        renewed["answer"] = found;
        written.push(renewed);
    }
    if renew {
        let mut text = String::from("[");
        for (index, question) in written.iter().enumerate() {
            let _ = write!(text, "{}\n{question}", if index == 0 { "" } else { "," });
        }
        text.push_str("\n]\n");
        std::fs::write(path(), text).expect("it can be written");
    }
    assert!(
        told.is_empty(),
        "write them anew (cargo xtask numbers) if the change is meant:\n{}",
        told.join("\n")
    );
}
