//! Figure T: the tongues of instability, exact, over the mesh frequency and the depth of the pulsation.

use super::compose::{Composer, Line, Points, axis, even, number, plane};
use super::job::{Distance, Fact, Figure};
use super::tongue_range::range;
use super::tongues::Setting;
use crate::chart::drawing::{Drawing, Frame, Mark, Role};
use crate::error::FigureError;
use crate::model::parameters::{Parameters, Regime, Symmetric};
use crate::order;
use crate::study::ErrorEstimate;
use crate::study::grid::Grid;
use crate::study::multipliers::{multipliers, unloaded};
use crate::study::stability_chart::{StabilityChart, stability_chart};
use crate::study::tongue::{EdgeKind, Tongue, tongue_edges};
use crate::study::tongue_boundary::{TongueBoundary, tongue_boundary};
use crate::theory::damped::{combination_edges, primary_edges};
use crate::theory::modes::Mode;
use crate::theory::{Edges, combination, primary};

/// Columns and rows of the field.
const COLUMNS: usize = 201;
const ROWS: usize = 101;
/// Points on the boundary of each tongue.
const POINTS: usize = 90;
/// Points on that of a further tongue, which is smaller.
const POINTS_FURTHER: usize = 60;
/// Most further tongues whose boundaries are followed.
const MOST_FURTHER: usize = 6;
/// A further tongue that is narrower than so many columns at the top is left to the field.
const NARROWEST: usize = 2;
/// Tolerance of the field's spectral radius, and of the boundaries.
const TOLERANCE: f64 = 1e-6;
const BOUNDARY: f64 = 1e-9;
/// Depths at which a boundary is begun where it cannot be at the top.
const LOWER_TOPS: [f64; 2] = [0.8, 0.6];
/// Growth in a period that is none.
const NO_GROWTH: f64 = 1e-6;

/// The three tongues of the theory.
const NAMED: [(Tongue, &str, &str); 3] = [
    (Tongue::Primary2, "second mode", "2*ω*_{2}"),
    (Tongue::Combination, "combination", "*ω*_{2} + *ω*_{3}"),
    (Tongue::Primary3, "third mode", "2*ω*_{3}"),
];

/// A boundary with the name of its tongue.
#[derive(Debug)]
pub(super) struct Found {
    name: String,
    boundary: TongueBoundary,
}

/// The same pair without its loads, about its state of rest.
pub(super) fn at_rest(p: &Parameters) -> Parameters {
    Parameters { regime: Regime::Homogeneous, load: 0.0, load_p: 0.0, load_g: 0.0, error: 0.0, ..*p }
}

/// # Errors
/// What the chart fails with. A boundary that cannot be followed is left out, with a note.
pub(super) fn figure(id: &'static str, parameters: &Parameters) -> Result<Figure, FigureError> {
    let p = at_rest(parameters);
    let (low, high) = range(&p);
    let omega = Grid { low: 0.5 * low, high, count: COLUMNS };
    let k0 = Grid { low: 0.0, high: 1.0, count: ROWS };
    let mut notes = Vec::new();
    let chart = match stability_chart(&p, omega, k0, TOLERANCE) {
        Ok(chart) => chart,
        Err(error) => {
            // Stiff corners of the ranges would take minutes: the formulas stand alone there.
            notes.push(format!("The field and the exact boundaries cannot be computed here: {error}."));
            let nothing = vec![1.0; COLUMNS * ROWS];
            StabilityChart { omega, k0, spectral_radius: nothing, error: 1.0, method: "none".to_owned() }
        }
    };
    let charted = notes.is_empty();
    if !unloaded(parameters) {
        notes.push(
            "The load does not matter here: it is the unloaded state whose stability is asked.".to_owned(),
        );
    }
    let found = if charted { boundaries(&p, &chart, &mut notes) } else { Vec::new() };
    let here = multipliers(&p, 1e-10)?;
    let growth = here.spectral_radius.ln() / p.mesh_period();
    let drawing = drawing(&p, &chart, &found, here.spectral_radius > 1.0 + NO_GROWTH);
    let summary = format!(
        "At Omega = {}, k0 = {} rest is {}: the largest multiplier has magnitude {}, a deviation {} at the rate {}.",
        number(p.omega, 6),
        number(p.k0, 4),
        if here.stable { "stable" } else { "unstable" },
        number(here.spectral_radius, 7),
        if growth > 0.0 { "grows" } else { "decays" },
        number(growth.abs(), 3)
    );
    let greatest = |pick: fn(&ErrorEstimate) -> Option<f64>| {
        found.iter().filter_map(|found| pick(&found.boundary.error)).reduce(f64::max)
    };
    if charted {
        notes.push(format!("The field's spectral radius is right to {}.", number(chart.error, 1)));
    }
    Ok(Figure {
        summary,
        method: format!("field: {}; boundaries: pseudo-arclength continuation to 1e-9", chart.method),
        error: ErrorEstimate {
            liouville: here.error.liouville,
            // Of the field where it is drawn, absolutely, of the spectral radius.
            step: greatest(|error| error.step)
                .into_iter()
                .chain(charted.then_some(chart.error))
                .reduce(f64::max),
            residual: greatest(|error| error.residual),
        },
        notes,
        facts: vec![
            ("stable", Fact::Truth(here.stable)),
            ("spectralRadius", Fact::Number(here.spectral_radius)),
            ("growth", Fact::Number(growth)),
        ],
        distances: if charted { distances(&p) } else { Vec::new() },
        ..Figure::drawn(id, parameters, drawing)
    })
}

/// The edges at the present depth by formula, with damping, and exactly.
fn distances(p: &Parameters) -> Vec<Distance> {
    let Ok(setting) = Setting::of(p) else { return Vec::new() };
    let (modes, symmetric) = (&setting.modes, &setting.symmetric);
    let formulas = [
        ("[T5]", primary_edges(modes, Mode::Second, symmetric)),
        ("[T6]", combination_edges(modes, symmetric)),
        ("[T5]", primary_edges(modes, Mode::Third, symmetric)),
    ];
    let pairs = NAMED.into_iter().zip(formulas).filter_map(|((tongue, name, _), (equation, edges))| {
        let exact = tongue_edges(p, tongue, BOUNDARY).ok()?;
        let (edges, left, right) = (edges?, exact.left?, exact.right?);
        let beside = |side: &str, theory: f64, exact: f64| Distance {
            what: format!("Omega of the {side} edge, {name} {equation}"),
            at: Some(("k0", p.k0)),
            theory,
            exact,
        };
        Some([beside("left", edges.left, left), beside("right", edges.right, right)])
    });
    pairs.flatten().collect()
}

/// The boundaries of the three tongues at rest.
pub(super) fn named_boundaries(p: &Parameters, depth: [f64; 2], notes: &mut Vec<String>) -> Vec<Found> {
    let mut found: Vec<Found> = Vec::new();
    for (tongue, name, _) in NAMED {
        // Where tongues run into one another at the top, each is followed as far up as it is alone.
        let mut followed = tongue_boundary(p, tongue, depth, POINTS, BOUNDARY);
        for top in LOWER_TOPS {
            if followed.is_err() {
                followed = tongue_boundary(p, tongue, [depth[0], top], POINTS, BOUNDARY);
            }
        }
        match followed {
            Ok(boundary) if boundary.omega.is_empty() => {
                notes.push(format!("Damping closes the tongue at every depth: {name}."));
            }
            Ok(boundary) => found.push(Found { name: name.to_owned(), boundary }),
            Err(error) => notes.push(format!("The boundary could not be followed ({name}: {error}).")),
        }
    }
    found
}

/// The boundaries of the three tongues and of the larger ones among the others that the field shows.
fn boundaries(p: &Parameters, chart: &StabilityChart, notes: &mut Vec<String>) -> Vec<Found> {
    let depth = [chart.k0.low, chart.k0.high];
    let mut found = named_boundaries(p, depth, notes);
    for (index, omega) in unexplained(chart, &found).into_iter().take(MOST_FURTHER).enumerate() {
        // What cannot be followed still shows in the field.
        if let Ok(boundary) = tongue_boundary(p, Tongue::Near(omega), depth, POINTS_FURTHER, BOUNDARY)
            && !boundary.omega.is_empty()
        {
            found.push(Found { name: format!("further tongue {}", index + 1), boundary });
        }
    }
    found
}

/// Mesh frequencies in the middle of the unstable stretches along the field's upper edge that no boundary encloses, the
/// widest first.
fn unexplained(chart: &StabilityChart, found: &[Found]) -> Vec<f64> {
    let top = (chart.k0.count - 1) * chart.omega.count;
    let unstable = |column: usize| chart.spectral_radius[top + column] > 1.0 + NO_GROWTH;
    let enclosed = |omega: f64| {
        found.iter().any(|found| {
            let ends = found.boundary.omega.first().zip(found.boundary.omega.last());
            ends.is_some_and(|(left, right)| (*left..=*right).contains(&omega))
        })
    };
    let mut stretches: Vec<(usize, f64)> = Vec::new();
    let mut column = 0;
    while column < chart.omega.count {
        let end = (column..chart.omega.count).find(|&at| !unstable(at)).unwrap_or(chart.omega.count);
        let middle = 0.5 * (chart.omega.value(column) + chart.omega.value(end.saturating_sub(1)));
        let within = column > 0 && end < chart.omega.count;
        if end - column >= NARROWEST && within && !enclosed(middle) {
            stretches.push((end - column, middle));
        }
        column = end.max(column) + 1;
    }
    order::by_number(&mut stretches, |stretch| -(stretch.0 as f64));
    stretches.into_iter().map(|stretch| stretch.1).collect()
}

/// The plane of a chart, with the bar of its growth rates.
pub(super) fn growth_frame(composer: &mut Composer, chart: &StabilityChart, rates: &[f64]) -> usize {
    let most = rates.iter().fold(0.0_f64, |most, rate| most.max(*rate));
    composer.frame(Frame {
        bar: Some(axis("growth", "growth rate ln|*μ*|/*T*", (0.0, if most > 1e-6 { most } else { 1.0 }))),
        ..plane(
            "tongues",
            "",
            (0, 0),
            axis("Omega", "*Ω*", (chart.omega.low, chart.omega.high)),
            axis("k0", "*k*_{0}", (chart.k0.low, chart.k0.high)),
        )
    })
}

fn drawing(p: &Parameters, chart: &StabilityChart, found: &[Found], grows: bool) -> Drawing {
    let mut composer = Composer::new((1, 1));
    let omegas: Vec<f64> = (0..chart.omega.count).map(|column| chart.omega.value(column)).collect();
    let depths: Vec<f64> = (0..chart.k0.count).map(|row| chart.k0.value(row)).collect();
    let rates: Vec<f64> = chart
        .spectral_radius
        .iter()
        .enumerate()
        .map(|(index, radius)| radius.ln() * omegas[index % omegas.len()] / std::f64::consts::TAU)
        .collect();
    let frame = growth_frame(&mut composer, chart, &rates);
    let field = Line::new("growth", "growth rate of the exact linear problem", Role::Growth);
    composer.field(frame, field, omegas, depths, rates);
    if let Ok(setting) = Setting::of(p) {
        first_order(&mut composer, frame, &setting);
    }
    let mut named: Vec<EdgeKind> = Vec::new();
    for found in found {
        exact(&mut composer, frame, found, &mut named);
    }
    let word = if grows { "unstable" } else { "stable" };
    let meaning = format!("the present Omega and k0: {word}");
    let line = Line::new("present", meaning, Role::Handle).label(word, 0.0);
    composer.marks(frame, line, Points::one((p.omega, p.k0)));
    composer.drawing()
}

/// The edges of a tongue at a depth of the pulsation, with damping; none where it is closed.
type Damped<'a> = &'a dyn Fn(f64) -> Option<Edges>;

/// The tongues to first order: straight as printed, with damping as hyperbolas.
pub(super) fn first_order(composer: &mut Composer, frame: usize, setting: &Setting) {
    let modes = &setting.modes;
    let symmetric = &setting.symmetric;
    let at = |k0: f64| Symmetric { k0, ..*symmetric };
    let second = |k0: f64| primary_edges(modes, Mode::Second, &at(k0));
    let sum = |k0: f64| combination_edges(modes, &at(k0));
    let third = |k0: f64| primary_edges(modes, Mode::Third, &at(k0));
    let each: [(f64, f64, &str, &str, &str, Damped); 3] = [
        (
            primary::emanating_frequency(modes, Mode::Second),
            primary::half_width_printed(modes, Mode::Second),
            "second mode",
            "paper (56)",
            "[T5]",
            &second,
        ),
        (
            combination::emanating_frequency(modes),
            combination::half_width_printed(modes),
            "combination",
            "paper (105)",
            "damped [T6]",
            &sum,
        ),
        (
            primary::emanating_frequency(modes, Mode::Third),
            primary::half_width_printed(modes, Mode::Third),
            "third mode",
            "paper (82)",
            "[T5]",
            &third,
        ),
    ];
    for (omega_0, width, name, label, damped_label, damped) in each {
        let meaning = format!("first-order edges as printed, {name}");
        let line = Line::new(format!("{name} printed"), meaning, Role::Paper).label(label, 0.86);
        composer.curve(
            frame,
            line,
            Points::plane([(omega_0 - width, 1.0), (omega_0, 0.0), (omega_0 + width, 1.0)]),
        );
        let depths: Vec<f64> = even(0.0, 1.0, 201).collect();
        let leg = |left: bool| {
            let edges = depths.iter().filter_map(|&k0| Some((k0, damped(k0)?)));
            edges
                .map(move |(k0, edges)| (if left { edges.left } else { edges.right }, k0))
                .collect::<Vec<_>>()
        };
        let curve = leg(true).into_iter().rev().chain(leg(false));
        let meaning = format!("first-order edges with damping, {name}");
        let line = Line::new(format!("{name} damped"), meaning, Role::Corrected).label(damped_label, 0.12);
        composer.curve(frame, line, Points::plane(curve));
    }
}

/// What a boundary is, in words and on it.
fn kind_words(kind: EdgeKind) -> (&'static str, &'static str) {
    match kind {
        EdgeKind::PeriodDoubling => ("a multiplier passes -1: period doubling", "exact, *μ* = −1"),
        EdgeKind::PlusOne => ("a multiplier passes +1", "exact, *μ* = +1"),
        EdgeKind::NeimarkSacker => ("a pair leaves the unit circle: torus", "exact, |*μ*| = 1 (torus)"),
        EdgeKind::Krein => ("pairs meet on the unit circle", "exact, pairs meet"),
    }
}

/// The boundaries of a tongue. A further one, of which there are several close to each other, has words at it only where
/// its kind has none yet.
fn exact(composer: &mut Composer, frame: usize, found: &Found, named: &mut Vec<EdgeKind>) {
    let role = |kind| match kind {
        EdgeKind::PeriodDoubling | EdgeKind::PlusOne => Role::Exact,
        EdgeKind::NeimarkSacker | EdgeKind::Krein => Role::QuasiPeriodic,
    };
    boundary_lines(composer, frame, found, named, &|kind| (role(kind), kind_words(kind).1));
    let Found { name, boundary } = found;
    if let Some([omega, k0]) = boundary.tip.filter(|_| !name.starts_with("further")) {
        let meaning = format!("tip of the tongue, {name}: closed below");
        let line = Line::new(format!("tip {name}"), meaning, Role::Reference);
        composer.marks(frame, line, Points::one((omega, k0)));
    }
}

/// A line for each kind of boundary that a tongue has, as `look` has it for a kind: role and label.
pub(super) fn boundary_lines(
    composer: &mut Composer,
    frame: usize,
    Found { name, boundary }: &Found,
    named: &mut Vec<EdgeKind>,
    look: &dyn Fn(EdgeKind) -> (Role, &'static str),
) {
    let further = name.starts_with("further");
    let count = boundary.omega.len();
    let places: Vec<(f64, f64)> =
        boundary.omega.iter().zip(&boundary.k0).map(|(omega, k0)| (*omega, *k0)).collect();
    let mut kinds: Vec<EdgeKind> = Vec::new();
    for kind in &boundary.kind {
        if !kinds.contains(kind) {
            kinds.push(*kind);
        }
    }
    for kind in kinds {
        let mut points = Points::default();
        let mut start = 0;
        while start < count {
            let same = |at: &usize| boundary.kind[*at] == boundary.kind[start];
            // Without a tip the right leg is a curve of its own.
            let split = boundary.tip.is_none() && start < boundary.left;
            let most = if split { boundary.left } else { count };
            let end = (start..most).find(|at| !same(at)).unwrap_or(most);
            if boundary.kind[start] == kind {
                // To the next kind's first point, so that no gap is seen.
                let last = if end < most { end + 1 } else { end };
                points.piece(places[start..last].iter().copied());
            }
            start = end;
        }
        let (meaning, (role, label)) = (kind_words(kind).0, look(kind));
        let line =
            Line::new(format!("{name} {}", kind.name()), format!("exact boundary, {name}: {meaning}"), role);
        let line = if further && named.contains(&kind) { line } else { line.label(label, 0.97) };
        named.push(kind);
        composer.add(frame, Mark::Curve, line, points);
    }
}
