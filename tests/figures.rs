//! The figures as data: curves pass through what the theory says, presets show what the paper reports, and no value
//! of a slider breaks them.

use gear_bifurcations::chart::drawing::{Drawing, Mark, Role, Series};
use gear_bifurcations::error::{FigureError, ModelError, StudyError};
use gear_bifurcations::figures::{
    Entry, Figure, Job, Preset, at_time, figure, specification, specifications,
};
use gear_bifurcations::model::parameters::{Parameters, Regime, Symmetric, Value, info};
use gear_bifurcations::study::orbit::{OrbitOptions, periodic_orbit};
use gear_bifurcations::theory::{self, Mode, Modes, combination, damped, primary};
use std::collections::HashSet;

fn given(values: &[(&str, f64)]) -> Vec<(String, Value)> {
    values.iter().map(|(name, value)| ((*name).to_owned(), Value::Number(*value))).collect()
}

fn made(id: &str, values: &[(&str, f64)]) -> Figure {
    figure(id, &given(values)).unwrap_or_else(|error| panic!("figure {id} with {values:?}: {error}"))
}

fn series<'a>(drawing: &'a Drawing, name: &str) -> &'a Series {
    drawing.series.iter().find(|series| series.name == name).unwrap_or_else(|| {
        let names: Vec<&str> = drawing.series.iter().map(|series| series.name.as_str()).collect();
        panic!("no series {name:?} among {names:?}")
    })
}

fn with_role(drawing: &Drawing, role: Role) -> impl Iterator<Item = &Series> {
    drawing.series.iter().filter(move |series| series.role == role)
}

/// What every drawing must be: finite, within its own frames, and complete.
fn check(figure: &Figure) {
    let drawing = &figure.drawing;
    let id = figure.id;
    assert!(!drawing.frames.is_empty(), "{id}: no frame");
    let mut names = HashSet::new();
    for frame in &drawing.frames {
        assert!(names.insert(&frame.name), "{id}: two frames {}", frame.name);
        for axis in [&frame.x, &frame.y].into_iter().chain(&frame.z) {
            assert!(axis.low.is_finite() && axis.high.is_finite() && axis.low < axis.high, "{id}: {axis:?}");
        }
        assert!(
            frame.cell.0 + frame.span.0 <= drawing.grid.0 && frame.cell.1 + frame.span.1 <= drawing.grid.1
        );
    }
    let mut names = HashSet::new();
    for series in &drawing.series {
        assert!(names.insert(&series.name), "{id}: two series {:?}", series.name);
        assert!(!series.meaning.is_empty());
        let frame = &drawing.frames[series.frame];
        let depth = if frame.z.is_some() { series.x.len() } else { 0 };
        assert!(!series.x.is_empty(), "{id}: {:?} is empty", series.name);
        if series.mark == Mark::Field {
            assert_eq!(series.z.len(), series.x.len() * series.y.len(), "{id}: {:?}", series.name);
        } else {
            assert_eq!((series.y.len(), series.z.len()), (series.x.len(), depth), "{id}: {:?}", series.name);
        }
        let all = series.x.iter().chain(&series.y).chain(&series.z);
        assert!(all.copied().all(f64::is_finite), "{id}: {:?} is not finite", series.name);
        assert!(series.pieces.windows(2).all(|pair| pair[0] < pair[1]), "{id}: {:?}", series.name);
        assert!(series.pieces.last().is_none_or(|last| *last < series.x.len()), "{id}: {:?}", series.name);
        assert!((0.0..=1.0).contains(&series.label_at));
        if series.mark == Mark::Band {
            assert_eq!(series.x.len(), 2);
        }
    }
    assert!(figure.summary.len() > 20 && figure.summary.ends_with('.'), "{id}: {:?}", figure.summary);
    for words in figure.notes.iter().chain([&figure.summary]) {
        assert!(!words.contains("NaN") && !words.contains("inf"), "{id}: {words:?}");
    }
}

#[test]
fn every_figure_is_whole_with_its_preset() {
    let ids: Vec<&str> = specifications().iter().map(|specification| specification.id).collect();
    let expected = "1 2 3 4 5 6 7 8 9 10 11a 11b 11c 12a 12b 12c 13a 13b 13c 14a 14b T B M S L A U P W E";
    assert_eq!(ids.join(" "), expected);
    for specification in specifications() {
        let figure = made(specification.id, &[]);
        check(&figure);
        assert_eq!(figure.motion.is_some(), specification.animated);
        assert_eq!(figure.drawing.frames.iter().any(|frame| frame.z.is_some()), specification.turnable);
        assert!(!figure.method.is_empty() && !specification.caption.is_empty());
        for name in specification.parameters {
            assert!(info(name).is_some(), "{} has no parameter {name}", specification.id);
        }
    }
}

#[test]
fn presets_are_the_papers_and_what_is_given_overrides_them() {
    let parameters = |id: &str, values: &[(&str, f64)]| {
        specification(id).expect("known").with(&given(values)).expect("valid")
    };
    let first = parameters("11a", &[]);
    assert_eq!(
        (first.zeta, first.zeta_p, first.omega, first.alpha_p, first.k0),
        (0.052, 0.052, 1.55, -0.2, 0.5)
    );
    let loaded = parameters("14b", &[]);
    assert_eq!((loaded.alpha_p, loaded.load, loaded.zeta, loaded.regime), (-1.3, 1.5, 0.07, Regime::Contact));
    assert_eq!(parameters("13b", &[]).omega, 5.4);
    let changed = parameters("14a", &[("alpha_g", -0.5), ("Omega", 2.0)]);
    assert_eq!((changed.alpha_p, changed.alpha_g, changed.omega, changed.load), (0.0, -0.5, 2.0, 1.5));
    assert!(specification("1").expect("known").preset.contains(&("regime", Preset::Word("backlash"))));
}

#[test]
fn what_is_wrong_is_named() {
    assert_eq!(
        figure("15", &[]).expect_err("no such figure"),
        FigureError::UnknownFigure { given: "15".to_owned() }
    );
    let refused = figure("3", &given(&[("zeta", 3.0)])).expect_err("out of range");
    assert!(matches!(
        refused,
        FigureError::Study(StudyError::Model(ModelError::OutOfRange { parameter, .. })) if parameter == "zeta"
    ));
    let unequal = format!("{}", figure("9", &given(&[("m_p", 2.0)])).expect_err("unequal supports"));
    assert!(unequal.contains("m_p is 2"), "{unequal}");
}

#[test]
fn determinants_vanish_at_the_stars() {
    let modes = Modes::new(1.0, 5.0).expect("valid");
    for (id, mode) in [("2", Mode::Second), ("4", Mode::Third)] {
        let figure = made(id, &[]);
        let width = primary::half_width(&modes, mode);
        for (name, at) in [("Omega_L", -width), ("Omega_R", width)] {
            let star = series(&figure.drawing, name);
            assert_eq!((star.x[0], star.y[0], star.role), (at, 0.0, Role::Bifurcation));
        }
        let sine = series(&figure.drawing, "Det at R_2,3 centre");
        assert!(sine.y[0].abs() < 1e-12 * sine.y.last().expect("points").abs());
        for (x, y) in sine.x.iter().zip(&sine.y) {
            let exact = primary::determinant_at(&modes, mode, theory::Branch::Sine, *x);
            assert!((y - exact).abs() <= 1e-12 * exact.abs());
        }
    }
}

#[test]
fn pitchforks_pass_through_the_formulas_with_stars_at_the_edges() {
    let parameters = specification("5").expect("known").with(&[]).expect("valid");
    let symmetric = parameters.symmetric().expect("equal supports");
    let modes = Modes::of(&symmetric).expect("valid");
    let omega_0 = primary::emanating_frequency(&modes, Mode::Third);
    let width = damped::primary_half_width(&modes, Mode::Third, &symmetric).expect("open") / symmetric.k0;
    let figure = made("5", &[]);
    // Hardening: [T7] at a point of the stable branch, from the drawing's own columns.
    let stable = series(&figure.drawing, "R_2,3 hardening damped");
    assert_eq!(stable.stable, Some(true));
    let (omega_1, radius) = (stable.x[150], stable.y[150]);
    let at = Symmetric { omega: omega_0 + symmetric.k0 * omega_1, ..symmetric };
    let expected = theory::period_two(&at, Mode::Third).expect("valid")[0].expect("exists").radius;
    assert!((radius - expected).abs() < 1e-12, "{radius} {expected}");
    // (88) as printed, with the paper's alpha = alpha/k0.
    let printed = series(&figure.drawing, "R_2,3 hardening (88)");
    let square = primary::radius_squared(&modes, Mode::Third, theory::Branch::Sine, 0.4, printed.x[120]);
    assert!((printed.y[120].powi(2) - square.expect("exists")).abs() < 1e-12);
    let edge = |role: Role, frame: usize| -> Vec<f64> {
        let of_formulas = |star: &&Series| star.frame == frame && star.name.contains("pitchfork of");
        with_role(&figure.drawing, role).filter(of_formulas).map(|star| star.x[0]).collect()
    };
    let paper = primary::half_width(&modes, Mode::Third);
    assert_eq!(edge(Role::Supercritical, 0), [-paper, -width]);
    assert_eq!(edge(Role::Subcritical, 0), [paper, width]);
    // Softening mirrors it: frame 2 is the softening plane.
    assert_eq!(edge(Role::Supercritical, 2), [paper, width]);
    let unstable = series(&figure.drawing, "R_2,3 softening (88)");
    assert_eq!(unstable.stable, Some(false));
    assert!(unstable.x.iter().all(|x| *x <= -paper));
    // In space the branch stands on its plane: sine is (Omega_1, 0, R).
    let space = series(&figure.drawing, "R_2,3 hardening (88) 3-D");
    assert!(space.y.iter().all(|b_1| b_1.abs() < 1e-12));
    assert_eq!(space.z[120], printed.y[120]);
}

#[test]
fn eigenvalues_touch_zero_at_the_hopf_points() {
    let figure = made("6", &[]);
    for name in ["Hopf points printed Re", "Hopf points corrected Re", "Hopf points damped Re"] {
        let stars = series(&figure.drawing, name);
        assert_eq!(stars.x.len(), 2);
        assert!(stars.y.iter().all(|y| y.abs() < 1e-6), "{name}: {:?}", stars.y);
        assert!((stars.x[0] + stars.x[1]).abs() < 1e-15);
    }
    assert!((series(&figure.drawing, "Hopf points printed Re").x[1] - 0.401_317_174_595_744_3).abs() < 1e-12);
    assert!(
        (series(&figure.drawing, "Hopf points corrected Re").x[1] - 0.356_439_780_192_106_4).abs() < 1e-12
    );
    // The growth rate in the middle, sqrt(H_2 H_3) k0 = 0.17822 k0.
    let growth = series(&figure.drawing, "Re corrected 1");
    let middle = growth.x.iter().position(|x| x.abs() < 1e-12).expect("the middle is sampled");
    assert!((growth.y[middle] - 0.5 * 0.178_22).abs() < 1e-5);
}

#[test]
fn limit_cycles_pass_through_t8_and_go_on_beyond_the_other_edge() {
    let figure = made("7", &[]);
    let parameters = figure.parameters;
    let symmetric = parameters.symmetric().expect("equal supports");
    let modes = Modes::of(&symmetric).expect("valid");
    let edge = damped::combination_half_width(&modes, &symmetric).expect("open") / symmetric.k0;
    for letter in ["B", "C"] {
        let stable = series(&figure.drawing, &format!("R_{letter} hardening stable"));
        assert_eq!((stable.x[0], stable.y[0], stable.stable), (-edge, 0.0, Some(true)));
        assert!(*stable.x.last().expect("points") > 1.5 * edge, "it does not end at the other edge");
        let unstable = series(&figure.drawing, &format!("R_{letter} hardening unstable"));
        assert_eq!((unstable.x[0], unstable.stable), (edge, Some(false)));
        let omega_1 = stable.x[60];
        let omega = combination::emanating_frequency(&modes) + symmetric.k0 * omega_1;
        let cycle = theory::cycles(&Symmetric { omega, ..symmetric }).expect("valid")[0].expect("exists");
        let radius = if letter == "B" { cycle.radius_b } else { cycle.radius_c };
        assert!((stable.y[60] - radius).abs() < 1e-12);
    }
    let printed = series(&figure.drawing, "R_B hardening (106)-(109) left");
    assert!((printed.x[0] + 0.4209).abs() < 1e-4, "printed solutions leave the origin at {}", printed.x[0]);
    let softening = series(&figure.drawing, "R_B softening stable");
    assert_eq!(softening.x[0], edge);
}

#[test]
fn exact_exponents_and_the_slow_flow_meet_and_edges_are_the_exact_ones() {
    let figure = made("8", &[]);
    let mut edges = Vec::new();
    for series in &figure.drawing.series {
        if series.name.starts_with("kind exact") && series.role != Role::IntervalStable {
            edges.push((series.x[0], series.x[1], series.role));
        }
    }
    let expected = [
        (1.458_961_187, 1.694_651_839, Role::IntervalSaddle),
        (3.280_006_321, 3.786_556_073, Role::IntervalSpiral),
        (5.219_898_701, 5.598_863_224, Role::IntervalSaddle),
    ];
    assert_eq!(edges.len(), 3, "{edges:?}");
    for (one, other) in edges.iter().zip(expected) {
        assert!((one.0 - other.0).abs() < 1e-4 && (one.1 - other.1).abs() < 1e-4, "{one:?} {other:?}");
        assert_eq!(one.2, other.2);
    }
    // In the middle of the combination tongue exact and first order agree to within second order in k0.
    let top = |prefix: &str| {
        figure
            .drawing
            .series
            .iter()
            .filter(|series| series.name.starts_with(prefix) && series.name.contains("growing"))
            .flat_map(|series| series.x.iter().copied())
            .fold(0.0_f64, f64::max)
    };
    let (exact, first_order) = (top("exact"), top("slow flow"));
    assert!((exact - first_order).abs() < 0.01 && exact > 0.04, "{exact} {first_order}");
    assert_eq!(series(&figure.drawing, "present exponents").x.len(), 4);
}

#[test]
fn real_multipliers_do_not_jump_between_the_edges_of_the_strip() {
    // Near Omega = 2.67 both multipliers of the second mode are real: their exponents lie on the very edge.
    for zeta in [0.01, 0.02, 0.03] {
        let figure = made("8", &[("zeta", zeta)]);
        let decaying = |one: &&Series| one.name.starts_with("exact") && one.name.ends_with("decaying");
        for one in figure.drawing.series.iter().filter(decaying) {
            assert!(one.pieces.len() <= 3, "{}: {:?} of {}", one.name, one.pieces, one.x.len());
        }
    }
}

#[test]
fn the_whole_diagram_leans_with_the_supports() {
    for (id, role) in [("9", 1.0), ("10", -1.0)] {
        let figure = made(id, &[]);
        for name in
            ["R_B2,3 damped", "R_B4,5 damped", "R_C2,3 damped", "R_C4,5 damped", "R_C cycle stable damped"]
        {
            let branch = series(&figure.drawing, name);
            let (first, last) = (branch.x[0], branch.x[branch.x.len() - 1]);
            assert!(role * (last - first) > 0.0, "{id}: {name} from {first} to {last}");
            assert_eq!(branch.y[0], 0.0);
        }
        // Those of the formulas; the exact branches have marks of their own.
        let stars = |role: Role| {
            with_role(&figure.drawing, role).filter(|series| series.name.contains(" of R_")).count()
        };
        let (super_stars, sub_stars) = (stars(Role::Supercritical), stars(Role::Subcritical));
        assert_eq!((super_stars, sub_stars), (5, 5), "two pitchforks twice and a Hopf point on either side");
    }
}

fn node(id: &str) -> (f64, f64) {
    let figure = made(id, &[]);
    let node = with_role(&figure.drawing, Role::Attractor).find(|series| series.mark == Mark::Marks);
    let node = node.expect("nodes are marked");
    assert_eq!(node.x.len(), 2, "{id}: two nodes");
    assert!((node.x[0] + node.x[1]).abs() < 1e-7, "{id}: opposite each other");
    let dot = with_role(&figure.drawing, Role::Saddle).next().expect("a saddle in the middle");
    assert_eq!((dot.x[0], dot.y[0]), (0.0, 0.0));
    (node.x[0], node.y[0])
}

#[test]
fn nodes_approach_the_origin_as_omega_rises() {
    for ids in [["11a", "11b", "11c"], ["13a", "13b", "13c"]] {
        let radii = ids.map(|id| node(id).0.abs());
        assert!(radii[0] > radii[1] && radii[1] > radii[2], "{radii:?}");
    }
    // Against the independent reference: tests/reference/periodic_orbits.json.
    let (u_p, u_p_dot) = node("11c");
    assert!((u_p.abs() - 1.849_275_392_181_441_8).abs() < 1e-8, "{u_p}");
    assert!((u_p_dot.abs() - 0.176_579_629_459_158_2).abs() < 1e-8, "{u_p_dot}");
    assert!((node("11a").0.abs() - 2.928_647_491_158_051).abs() < 1e-8);
}

#[test]
fn the_limit_cycle_shrinks_as_omega_rises() {
    let sizes = ["12a", "12b", "12c"].map(|id| {
        let figure = made(id, &[]);
        let cycle = series(&figure.drawing, "limit cycle");
        assert_eq!((cycle.role, cycle.mark), (Role::Attractor, Mark::Cloud));
        assert!(cycle.x.len() > 1000, "{id}: {} points", cycle.x.len());
        assert_eq!(with_role(&figure.drawing, Role::UnstableSpiral).count(), 1);
        cycle.y.iter().fold(0.0_f64, |most, y| most.max(y.abs()))
    });
    assert!(sizes[0] > sizes[1] && sizes[1] > sizes[2], "{sizes:?}");
    // tests/reference/tori.json: at Omega = 3.7 the largest distance from the origin is 2.4398.
    assert!((sizes[1] - 2.424).abs() < 0.02, "{sizes:?}");
}

#[test]
fn outside_of_the_tongues_the_map_says_so() {
    let figure = made("11a", &[("Omega", 2.3)]);
    check(&figure);
    let dot = series(&figure.drawing, "fixed point");
    assert_eq!((dot.role, dot.stable), (Role::Attractor, Some(true)));
    assert!(figure.notes.iter().any(|note| note.contains("stable")), "{:?}", figure.notes);
    assert!(figure.summary.contains("stable"));
}

#[test]
fn contact_is_lost_without_the_cubic_part_and_kept_with_it() {
    let lost = made("14a", &[]);
    let event = series(&lost.drawing, "contact lost");
    assert_eq!(event.role, Role::Event);
    assert_eq!(event.y[0], 1.0);
    assert!(lost.notes.iter().any(|note| note.contains("no longer holds")), "{:?}", lost.notes);
    assert!(lost.summary.contains("\u{2212}0.4538") && lost.summary.contains("4.9618"), "{}", lost.summary);
    let both =
        |drawing: &Drawing| (series(drawing, "contact").y.clone(), series(drawing, "backlash").y.clone());
    let (contact, backlash) = both(&lost.drawing);
    let largest = |values: &[f64]| values.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
    assert!(largest(&contact) > 3.0 * largest(&backlash), "permanent contact grows");

    let kept = made("14b", &[]);
    assert!(kept.drawing.series.iter().all(|series| series.role != Role::Event));
    let (contact, backlash) = both(&kept.drawing);
    assert!(contact.iter().zip(&backlash).all(|(one, other)| (one - other).abs() < 1e-9));
    assert!(kept.summary.contains("2.2497") && kept.summary.contains("2.8431"), "{}", kept.summary);
}

#[test]
fn the_settled_range_is_that_of_the_exact_orbit() {
    let figure = made("14a", &[]);
    let parameters = Parameters { regime: Regime::Backlash, ..figure.parameters };
    let options = OrbitOptions { period: 2, guess: None, tolerance: 1e-10 };
    let orbit = periodic_orbit(&parameters, &options).expect("settles");
    assert!((orbit.min[2] + 0.4539).abs() < 1e-4 && (orbit.max[2] - 4.9618).abs() < 1e-4);
    let animated = made("1", &[]);
    let motion = animated.motion.expect("moves");
    let (low, high) = motion.u.iter().fold((0.0_f64, 0.0_f64), |(low, high), u| (low.min(*u), high.max(*u)));
    assert!((low - orbit.min[2]).abs() < 0.01 && (high - orbit.max[2]).abs() < 0.01, "{low} {high}");
}

#[test]
fn the_gears_move_and_say_whether_the_teeth_touch() {
    let figure = made("1", &[]);
    let motion = figure.motion.clone().expect("moves");
    let index = |wanted: fn(f64) -> bool| motion.u.iter().position(|u| wanted(*u)).expect("both happen");
    for (time, word, role) in [
        (motion.t[index(|u| u > 2.0)], "contact", Role::Attractor),
        (motion.t[index(|u| u < 0.5)], "parted", Role::Event),
    ] {
        let drawing = at_time(&figure, time);
        check(&Figure { drawing: drawing.clone(), ..figure.clone() });
        assert_eq!(series(&drawing, "contact").role, role);
        let title = &drawing.frames.iter().find(|frame| frame.name == "mesh").expect("close view").title;
        assert!(title.contains(word), "{title}");
        let handle = with_role(&drawing, Role::Handle).next().expect("the present moment");
        assert!((handle.x[0] - time).abs() < 1e-12);
    }
    assert_ne!(at_time(&figure, 0.0), at_time(&figure, 1.0));
    // The loop closes: a motion of period 2T over eight periods.
    let length = *motion.t.last().expect("points");
    assert!((motion.u[0] - motion.u.last().expect("points")).abs() < 1e-3);
    check(&Figure { drawing: at_time(&figure, 1e6 * length + 0.3), ..figure });
}

#[test]
fn a_job_gives_a_picture_at_any_time_and_ends_with_the_figure() {
    for id in ["8", "11b", "12c"] {
        let mut job = Job::new(id, &[]).expect("valid");
        let mut pictures = 0;
        let mut points = 0;
        while !job.advance().expect("no error") {
            pictures += 1;
            let partial = job.figure();
            check(&partial);
            let now: usize = partial.drawing.series.iter().map(|series| series.x.len()).sum();
            assert!(now >= points / 2, "{id}: it fills in");
            points = now;
        }
        assert!(pictures >= 1, "{id}: {pictures} pictures on the way");
        assert!(job.advance().expect("no error"), "done stays done");
        assert_eq!(job.figure().drawing, made(id, &[]).drawing);
    }
}

#[test]
fn an_escape_is_drawn_up_to_where_it_left_and_told() {
    let figure = made("14b", &[("alpha", -2.0), ("F", 10.0)]);
    check(&figure);
    let told = figure.notes.iter().any(|note| note.contains("escapes"));
    let event = figure.drawing.series.iter().any(|series| series.name.starts_with("escape"));
    assert!(told && event, "{:?}", figure.notes);
}

#[test]
fn without_a_cubic_part_or_pulsation_the_figures_say_so() {
    for id in ["3", "5", "7", "9", "10"] {
        for (name, word) in [("alpha", "alpha = 0"), ("k0", "k0 = 0")] {
            let figure = made(id, &[(name, 0.0)]);
            check(&figure);
            assert!(figure.notes.iter().any(|note| note.contains(word)), "{id}: {:?}", figure.notes);
        }
        let closed = made(id, &[("zeta", 0.2)]);
        check(&closed);
        assert!(closed.notes.iter().any(|note| note.contains("losed") || note.contains("loses")), "{id}");
    }
}

/// The ends of a slider, and of the whole range a number box takes.
fn extremes(name: &str, whole: bool) -> Vec<f64> {
    let info = info(name).expect("known");
    let mut values = vec![info.slider.0, info.slider.1];
    if whole {
        values.extend([info.low, info.high]);
    }
    values
}

#[test]
fn no_slider_breaks_a_figure_of_formulas() {
    for specification in specifications() {
        // Figure T is integrated as well, if quickly: its sliders are tried with those of the others.
        if !["2", "3", "4", "5", "6", "7", "9", "10"].contains(&specification.id) {
            continue;
        }
        let made = |id: &str, values: &[(&str, f64)]| {
            // The formulas are the first picture; what is exact beside them comes later.
            let mut job =
                Job::new(id, &given(values)).unwrap_or_else(|error| panic!("{id}, {values:?}: {error}"));
            job.advance().unwrap_or_else(|error| panic!("{id}, {values:?}: {error}"));
            job.figure()
        };
        for name in specification.parameters {
            for value in extremes(name, true) {
                check(&made(specification.id, &[(name, value)]));
                for other in specification.parameters.iter().filter(|other| *other != name) {
                    for second in extremes(other, true) {
                        check(&made(specification.id, &[(name, value), (other, second)]));
                    }
                }
            }
        }
    }
}

#[test]
fn no_slider_breaks_a_figure_that_is_integrated() {
    for id in ["1", "14a", "14b", "8", "11a", "12b", "13c", "T", "M", "L"] {
        let specification = specification(id).expect("known");
        for name in specification.parameters {
            for value in extremes(name, false) {
                match figure(id, &given(&[(name, value)])) {
                    Ok(figure) => check(&figure),
                    // A question without an answer is refused in words, never by a panic.
                    Err(error) => panic!("figure {id}, {name} = {value}: {error}"),
                }
            }
        }
    }
}

#[test]
fn the_chart_of_tongues_holds_the_exact_edges() {
    // tests/reference/tongue_edges.json, k0 = 0.5, zeta = 0.02.
    let figure = made("T", &[]);
    for (name, left, right) in [
        ("second mode period-doubling", 1.458_961_187_166_879, 1.694_651_839_393_933),
        ("combination neimark-sacker", 3.280_006_321_482_296, 3.786_556_072_561_84),
        ("third mode period-doubling", 5.219_898_701_370_242_5, 5.598_863_224_076_081),
    ] {
        let boundary = series(&figure.drawing, name);
        let crossings: Vec<f64> = (1..boundary.x.len())
            .filter(|&at| (boundary.y[at - 1] - 0.5) * (boundary.y[at] - 0.5) < 0.0)
            .map(|at| {
                let part = (0.5 - boundary.y[at - 1]) / (boundary.y[at] - boundary.y[at - 1]);
                boundary.x[at - 1] + part * (boundary.x[at] - boundary.x[at - 1])
            })
            .collect();
        assert_eq!(crossings.len(), 2, "{name}: {crossings:?}");
        // Straight between two points of the curve.
        assert!(
            (crossings[0] - left).abs() < 2e-3 && (crossings[1] - right).abs() < 2e-3,
            "{name}: {crossings:?}"
        );
    }
    let field = series(&figure.drawing, "growth");
    assert_eq!(field.mark, Mark::Field);
    let at = |omega: f64, k0: f64| {
        let nearest = |places: &[f64], wanted: f64| {
            let off = |index: &usize| (places[*index] - wanted).abs();
            (0..places.len()).min_by(|one, other| off(one).total_cmp(&off(other))).expect("places")
        };
        field.z[nearest(&field.y, k0) * field.x.len() + nearest(&field.x, omega)]
    };
    assert!(at(1.6, 0.5) > 0.04 && at(2.2, 0.5) < 0.0 && at(3.5, 0.5) > 0.03);
    let bar = figure.drawing.frames[0].bar.as_ref().expect("a bar says what the shades mean");
    assert!(field.z.iter().all(|rate| *rate <= bar.high * (1.0 + 1e-12)));
}

#[test]
fn the_table_of_errata_is_computed_and_its_numbers_are_those_of_the_reference() {
    let figure = made("E", &[]);
    let row = |place: &str| {
        let found = figure.table.iter().find(|row| row.place == place);
        found.unwrap_or_else(|| panic!("no row {place}"))
    };
    let near = |entry: &Entry, expected: f64, tolerance: f64, what: &str| {
        let number = entry.number().unwrap_or_else(|| panic!("{what}: {entry:?}"));
        assert!((number - expected).abs() < tolerance, "{what}: {number} for {expected}");
    };
    // tests/reference/modes_and_tongues.json.
    for (place, printed, ours) in [
        ("(56)", 0.268_978_505_800_801_5, 0.268_978_505_800_801_5),
        ("(82)", 0.472_340_035_220_087_6, 0.472_340_035_220_087_6),
        ("(105)", 0.401_317_174_595_744_3, 0.356_439_780_192_106_4),
    ] {
        near(&row(place).printed, printed, 1e-12, place);
        near(&row(place).ours, ours, 1e-12, place);
        near(&row(place).exact, ours, 2e-8, place);
    }
    near(&row("Fig. 11 c").exact, 1.851_530_408_351_971_5, 1e-5, "the exact orbit of figure 11 c");
    near(&row("Fig. 14 a").exact, 4.9618, 1e-3, "the exact orbit of figure 14 a");
    assert!(figure.table.iter().all(|row| !row.place.is_empty() && !row.remark.is_empty()));
}

#[test]
fn the_exact_diagram_marks_every_bifurcation_at_its_place() {
    let figure = made("B", &[]);
    let has = |role: Role, omega: f64| {
        with_role(&figure.drawing, role).any(|series| series.x.iter().any(|x| (x - omega).abs() < 1e-6))
    };
    // tests/reference/orbit_branch.json.
    assert!(has(Role::Supercritical, 1.694_651_839) && has(Role::TorusBifurcation, 1.619_717_349));
    assert!(has(Role::Fold, 1.279_211_051) && has(Role::AcrossManifold, 1.531_079_295));
    assert!(has(Role::Subcritical, 1.458_961_187));
    let steady = series(&figure.drawing, "exact 1 unstable");
    assert!(
        steady.x.iter().any(|x| (x - 1.694_651_839).abs() < 1e-6),
        "it changes at the bifurcation itself"
    );
    assert!(with_role(&figure.drawing, Role::QuasiPeriodic).next().is_some(), "tori are drawn");
}

#[test]
fn starts_of_figure_11_c_end_at_its_two_nodes_or_escape() {
    let figure = made("A", &[]);
    let field = with_role(&figure.drawing, Role::Basins).next().expect("a field");
    let share =
        |wanted: f64| field.z.iter().filter(|value| **value == wanted).count() as f64 / field.z.len() as f64;
    // The plane is its own mirror image, and so is each node's basin the other's.
    assert!((share(0.0) - share(1.0)).abs() < 1e-3 && share(0.0) > 0.1, "{} {}", share(0.0), share(1.0));
    assert!(share(-1.0) > 0.4 && share(-2.0) < 0.01);
    let nodes: Vec<f64> =
        with_role(&figure.drawing, Role::Attractor).map(|series| series.x[0].abs()).collect();
    assert_eq!(nodes.len(), 2);
    assert!(nodes.iter().all(|u_p| (u_p - 1.849_275_392).abs() < 1e-7), "{nodes:?}");
}

#[test]
fn the_least_load_is_high_in_the_tongues_and_the_margin_is_told() {
    let figure = made("L", &[]);
    assert!(figure.summary.contains("contact is kept"), "{}", figure.summary);
    let load = series(&figure.drawing, "load");
    let within = |low: f64, high: f64| {
        let inside = load.x.iter().zip(&load.y).filter(|(x, _)| (low..=high).contains(*x)).map(|(_, y)| *y);
        inside.fold(0.0_f64, f64::max)
    };
    assert!(within(1.5, 1.65) > 4.0 * within(1.8, 3.2), "{} {}", within(1.5, 1.65), within(1.8, 3.2));
    let lost = made("L", &[("F", 0.02)]);
    assert!(lost.summary.contains("contact is lost"), "{}", lost.summary);
}

#[test]
fn raised_and_lowered_the_pair_does_different_things_beside_a_tongue() {
    let figure = made("S", &[]);
    assert!(figure.summary.contains("depends on where it comes from"), "{}", figure.summary);
    // Below the third tongue's left edge, 5.2199, the stable branch of the orbit of period 2T coexists with rest.
    let most = |name: &str| {
        let points = series(&figure.drawing, name);
        let inside =
            points.x.iter().zip(&points.y).filter(|(x, _)| (4.9..5.1).contains(*x)).map(|(_, y)| y.abs());
        inside.fold(0.0_f64, f64::max)
    };
    assert!(most("up") < 0.05 && most("down") > 2.0, "{} {}", most("up"), most("down"));
}

#[test]
fn multipliers_at_the_handle_are_the_reference() {
    let figure = made("M", &[]);
    let present = series(&figure.drawing, "present");
    assert!(present.x.iter().any(|re| (re + 1.240_390_880_093_412).abs() < 1e-9), "{:?}", present.x);
    let grows = series(&figure.drawing, "magnitude 1 growing");
    let most = grows.y.iter().fold(0.0_f64, |most, modulus| most.max(*modulus));
    assert!(most > 1.24 && grows.y.iter().filter(|modulus| **modulus <= 1.0).count() < 8, "{most}");
}

#[test]
fn even_the_picture_before_the_first_step_can_be_drawn() {
    use gear_bifurcations::chart::{svg, theme::Theme, view::View};
    let theme = Theme::by_name("dark").expect("there is a dark theme");
    for specification in specifications() {
        let figure = Job::new(specification.id, &[]).expect("valid").figure();
        let drawn = svg(
            &figure.drawing,
            specification.title,
            &figure.summary,
            (480.0, 320.0),
            &theme,
            &View::default(),
        );
        assert!(drawn.is_ok(), "{}: {drawn:?}", specification.id);
        assert!(!figure.summary.is_empty());
    }
}
