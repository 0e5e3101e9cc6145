//! The figures of one motion from any start: in time, once a mesh period, its spectrum, the moving gears.

use gear_bifurcations::chart::drawing::{Drawing, Series};
use gear_bifurcations::error::{FigureError, ModelError, StudyError};
use gear_bifurcations::figures::{Fact, Figure, START, figure, specification};
use gear_bifurcations::model::parameters::Value;
use gear_bifurcations::study::orbit::{OrbitOptions, periodic_orbit};
use gear_bifurcations::study::time_response::{TimeResponse, TimeResponseOptions, time_response};

fn given(values: &[(&str, f64)]) -> Vec<(String, Value)> {
    values.iter().map(|(name, value)| ((*name).to_owned(), Value::Number(*value))).collect()
}

fn made(id: &str, values: &[(&str, f64)]) -> Figure {
    figure(id, &given(values)).unwrap_or_else(|error| panic!("figure {id} with {values:?}: {error}"))
}

fn series<'a>(drawing: &'a Drawing, name: &str) -> &'a Series {
    drawing.series.iter().find(|series| series.name == name).unwrap_or_else(|| panic!("no series {name:?}"))
}

/// Every number of a drawing is finite, and so are those in its words.
fn check(figure: &Figure) {
    for series in &figure.drawing.series {
        let all = series.x.iter().chain(&series.y).chain(&series.z);
        assert!(all.copied().all(f64::is_finite), "{}: {:?}", figure.id, series.name);
    }
    for frame in &figure.drawing.frames {
        assert!(frame.x.low < frame.x.high && frame.y.low < frame.y.high, "{}", figure.id);
    }
    for words in figure.notes.iter().chain([&figure.summary]) {
        assert!(!words.contains("NaN") && !words.contains("inf"), "{}: {words:?}", figure.id);
    }
}

fn fact(figure: &Figure, name: &str) -> Fact {
    let found = figure.facts.iter().find(|(known, _)| *known == name);
    found.unwrap_or_else(|| panic!("no fact {name} among {:?}", figure.facts)).1
}

fn number_of(figure: &Figure, name: &str) -> f64 {
    match fact(figure, name) {
        Fact::Number(number) => number,
        other => panic!("{name} is {other:?}"),
    }
}

fn words(regime: &str, values: &[(&str, f64)]) -> Vec<(String, Value)> {
    let mut all = given(values);
    all.push(("regime".to_owned(), Value::Text(regime.to_owned())));
    all
}

#[test]
fn a_motion_in_time_says_what_becomes_of_contact() {
    let fourteen = [("zeta", 0.07), ("alpha", 0.0), ("F", 1.5), ("Omega", 1.6)];
    let lost = figure("U", &words("backlash", &fourteen)).expect("a motion");
    assert_eq!(fact(&lost, "contact"), Fact::Word("lost"));
    assert!((number_of(&lost, "lowest") + 0.4539).abs() < 1e-3, "{}", number_of(&lost, "lowest"));
    assert!((number_of(&lost, "highest") - 4.9618).abs() < 1e-3);
    let times = time_response_of("backlash", &fourteen).contact_loss;
    assert_eq!(number_of(&lost, "lostAt"), times[0]);
    let kept =
        figure("U", &words("backlash", &[("zeta", 0.07), ("alpha", -1.3), ("F", 1.5), ("Omega", 1.6)]));
    let kept = kept.expect("a motion");
    assert_eq!(fact(&kept, "contact"), Fact::Word("kept"));
    assert!((number_of(&kept, "margin") - (number_of(&kept, "lowest") - 1.0)).abs() < 1e-12);
    let escaping = figure("U", &words("contact", &fourteen)).expect("an answer");
    assert!(number_of(&escaping, "escapedAt") > 10.0 && escaping.end.is_none());
    assert_eq!(fact(&made("U", &[("F", 0.0), ("u0", 1.2)]), "contact"), Fact::Word("lost"));
}

#[test]
fn the_map_of_a_motion_that_dies_away_says_where_it_comes_to_rest() {
    let dying = made("P", &[("k0", 0.1), ("Omega", 2.6), ("zeta", 0.05)]);
    assert!(dying.summary.starts_with("The start comes to rest at u = 0;"), "{}", dying.summary);
    let gap = figure("P", &words("backlash", &[("F", 0.0), ("u_p0", 0.1), ("u_g0", -0.1), ("u0", 0.25)]));
    let gap = gap.expect("a map").summary;
    let (_, rest) = gap.split_once("The start comes to rest at u = ").unwrap_or_else(|| panic!("{gap}"));
    let (place, _) = rest.split_once(';').unwrap_or((rest, ""));
    let place: f64 = place.replace('\u{2212}', "-").parse().unwrap_or_else(|_| panic!("{gap}"));
    assert!(place.abs() < 1.0, "{gap}");
}

fn time_response_of(regime: &str, values: &[(&str, f64)]) -> TimeResponse {
    let p = specification("U").expect("known").with(&words(regime, values)).expect("valid");
    let options = TimeResponseOptions { periods: 200.0, ..TimeResponseOptions::new(&p) };
    time_response(&p, &options).expect("a motion")
}

fn starting(state: [f64; 6]) -> Vec<(String, Value)> {
    START.iter().zip(state).map(|(info, value)| (info.name.to_owned(), Value::Number(value))).collect()
}

#[test]
fn a_start_on_an_unstable_orbit_shows_that_orbit_in_every_figure_of_a_motion() {
    let unstable = made("B", &[]).orbits.expect("orbits");
    let row = (0..unstable.omega.len())
        .find(|&row| {
            unstable.stable[row] == 0.0 && unstable.period[row] == 2.0 && unstable.max_u_p[row] > 1.0
        })
        .expect("the paper's branch is unstable beyond its torus bifurcation");
    let state: [f64; 6] = std::array::from_fn(|index| unstable.state[6 * row + index]);
    let mut values = starting(state);
    values.push(("Omega".to_owned(), Value::Number(unstable.omega[row])));
    values.push(("F".to_owned(), Value::Number(0.0)));
    values.push(("regime".to_owned(), Value::Text("homogeneous".to_owned())));
    values.push(("zeta".to_owned(), Value::Number(0.02)));
    let time = figure("U", &values).expect("a motion");
    assert_eq!(number_of(&time, "period"), 2.0);
    assert!((number_of(&time, "maxU_p") - unstable.max_u_p[row]).abs() < 1e-3 * unstable.max_u_p[row]);
    let map = figure("P", &values).expect("a map");
    assert_eq!((fact(&map, "end"), number_of(&map, "period")), (Fact::Word("closed"), 2.0));
    assert_eq!(series(&map.drawing, "orbit").x.len(), 2);
    let spectrum = figure("W", &values).expect("a spectrum");
    assert_eq!(number_of(&spectrum, "loudest"), 0.5, "a motion of period 2T");
    values.push(("alpha".to_owned(), Value::Number(-0.2)));
    let gears = figure("1", &values).expect("gears");
    let motion = gears.motion.expect("a motion");
    let greatest = motion.u_p.iter().fold(0.0_f64, |most, u_p| most.max(u_p.abs()));
    assert!((greatest - unstable.max_u_p[row]).abs() < 2e-3 * unstable.max_u_p[row]);
}

#[test]
fn a_stroboscopic_map_follows_a_start_to_what_it_settles_on() {
    let exact = periodic_orbit(
        &specification("P").expect("known").with(&[]).expect("valid"),
        &OrbitOptions { period: 2, guess: None, tolerance: 1e-10 },
    )
    .expect("the orbit of figure 11 c");
    let map = made("P", &[]);
    assert_eq!((fact(&map, "end"), fact(&map, "centre")), (Fact::Word("orbit"), Fact::Word("saddle")));
    let orbit = series(&map.drawing, "orbit");
    let near = orbit.x.iter().any(|x| (x.abs() - exact.state[0].abs()).abs() < 1e-8);
    assert!(near && orbit.x.len() == 2, "{:?} {:?}", orbit.x, exact.state);
    assert_eq!(series(&map.drawing, "start").x, [-0.02]);
    let torus = made("P", &[("Omega", 3.7)]);
    assert_eq!(
        (fact(&torus, "end"), fact(&torus, "centre")),
        (Fact::Word("wandering"), Fact::Word("unstable spiral"))
    );
    let far = made("P", &[("u_p0", 4.9), ("u_g0", -4.9), ("u_p_dot0", 6.0), ("u_g_dot0", -6.0)]);
    assert_eq!(fact(&far, "end"), Fact::Word("escaped"));
    // Unequal supports, every load, the dead zone: where the mathematics allows, all of it.
    let rough = [
        ("m_g", 1.3),
        ("k_p", 4.0),
        ("alpha_g", 0.1),
        ("zeta", 0.05),
        ("F", 1.5),
        ("F_p", 0.1),
        ("E", 0.05),
        ("Omega", 1.7),
    ];
    for id in ["1", "U", "P", "W", "T", "M"] {
        for regime in ["contact", "backlash"] {
            check(
                &figure(id, &words(regime, &rough)).unwrap_or_else(|error| panic!("{id} {regime}: {error}")),
            );
        }
    }
}

#[test]
fn the_whine_of_a_motion_of_period_two_has_lines_at_half_the_mesh_frequency() {
    let whine = made("W", &[("alpha", 0.0)]);
    assert!(
        (number_of(&whine, "loudest") - 0.5).abs() < 0.02
            || (number_of(&whine, "loudest") - 1.0).abs() < 0.02
    );
    let quiet =
        figure("W", &words("homogeneous", &[("F", 0.0), ("Omega", 2.4), ("zeta", 0.2)])).expect("rest");
    assert!(quiet.summary.contains("does not vibrate"), "{}", quiet.summary);
    let escaping = [("zeta", 0.07), ("alpha", 0.0), ("F", 1.5), ("Omega", 1.6)];
    check(&figure("W", &words("contact", &escaping)).expect("an answer"));
}

#[test]
fn a_start_is_refused_where_there_is_none_to_take_and_where_it_is_no_number() {
    let refused = figure("11a", &given(&[("u_p0", 0.1)])).expect_err("no start");
    assert!(
        matches!(&refused, FigureError::Study(StudyError::Model(ModelError::UnknownParameter { name })) if name == "u_p0"),
        "{refused:?}"
    );
    let far = figure("U", &given(&[("u_dot0", 1e7)])).expect_err("out of range");
    assert!(matches!(far, FigureError::Study(StudyError::Model(ModelError::OutOfRange { .. }))), "{far:?}");
    let beyond = figure("U", &given(&[("u_p0", 1e3)])).expect_err("beyond the bounds of escape");
    assert!(matches!(beyond, FigureError::Study(StudyError::Option { option: "state", .. })), "{beyond:?}");
}
