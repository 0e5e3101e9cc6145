//! Figure T under a load: the field is that of the response to it, and fills in from coarse to fine.

use gear_bifurcations::chart::drawing::Series;
use gear_bifurcations::figures::{Figure, Job, figure};
use gear_bifurcations::model::parameters::{Parameters, Value};
use gear_bifurcations::study::multipliers::multipliers;

fn given(regime: &str) -> Vec<(String, Value)> {
    let mut values = vec![("regime".to_owned(), Value::Text(regime.to_owned()))];
    for (name, value) in [("k0", 0.3), ("F", 2.0)] {
        if name != "F" || regime != "homogeneous" {
            values.push((name.to_owned(), Value::Number(value)));
        }
    }
    values
}

fn field(figure: &Figure) -> &Series {
    let found = figure.drawing.series.iter().find(|series| series.name == "growth").expect("a field");
    assert!(found.z.iter().all(|rate| rate.is_finite()) && found.z.len() == found.x.len() * found.y.len());
    found
}

#[test]
fn under_a_load_the_chart_is_about_the_response_to_it() {
    let mut job = Job::new("T", &given("contact")).expect("made");
    for _ in 0..3 {
        assert!(!job.advance().expect("computes"));
    }
    let coarse = job.figure();
    assert!(coarse.notes.iter().any(|note| note.contains("so far")), "{:?}", coarse.notes);
    assert!(field(&coarse).z.iter().any(|rate| *rate < 0.0), "a whole picture, if a coarse one");
    while !job.advance().expect("computes") {}
    let figure = job.figure();
    let (field, p) = (field(&figure), figure.parameters);
    let (mut compared, mut unstable) = (0, 0);
    for index in (0..field.z.len()).step_by(37) {
        let (omega, k0) = (field.x[index % field.x.len()], field.y[index / field.x.len()]);
        let here = Parameters { omega, omega_p: omega, omega_g: omega, k0, ..p };
        // Near folds of the response there may be one that the chart's neighbours do not lead to; it says so by a nought.
        if let Ok(exact) = multipliers(&here, 1e-11)
            && field.z[index] != 0.0
        {
            let rate = exact.spectral_radius.ln() / here.mesh_period();
            assert!((field.z[index] - rate).abs() < 2e-6, "{omega} {k0}: {} {rate}", field.z[index]);
            compared += 1;
            unstable += usize::from(rate > 1e-3);
        }
    }
    // What it is at rest stands beside it.
    let rest = figure
        .drawing
        .series
        .iter()
        .filter(|series| series.meaning.starts_with("exact boundary, second mode:"));
    assert!(rest.flat_map(|series| &series.y).any(|k0| *k0 > 0.9));
    assert!(compared > 160 && unstable > 5, "{compared} {unstable}");
    assert!(figure.summary.contains("the response to the load is"), "{}", figure.summary);
}

#[test]
fn without_a_load_it_is_about_rest() {
    let figure = figure("T", &given("homogeneous")).expect("computes");
    assert!(figure.summary.contains("rest is"), "{}", figure.summary);
}
