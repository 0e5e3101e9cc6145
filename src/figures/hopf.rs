//! Figure 7: the limit cycles of the combination tongue, in the plane and in space.

use super::compose::{Composer, Line, Points, axis, crowded, even, number, plane};
use super::job::{Figure, formula};
use super::pitchfork::no_branches;
use super::tongues::{Setting, Supports, about_zero, half_parabola, origin};
use crate::chart::drawing::{Frame, Mark, Role};
use crate::error::FigureError;
use crate::model::parameters::Parameters;
use crate::theory::branches::{Cycle, cycles};
use crate::theory::combination::{
    PrintedSolution, emanating_frequency, half_width, half_width_printed, printed_solutions,
    printed_solutions_edge,
};
use crate::theory::damped::combination_half_width;
use std::f64::consts::TAU;

/// How far the axis reaches, in the largest of the half-widths.
const REACH: f64 = 2.2;

/// # Errors
/// Unequal supports.
pub(super) fn figure(id: &'static str, parameters: &Parameters) -> Result<Figure, FigureError> {
    let setting = Setting::of(parameters)?;
    let mut composer = Composer::new((2, 2));
    for (column, supports) in Supports::BOTH.into_iter().enumerate() {
        panel(&mut composer, column, &setting.with(supports), supports)?;
    }
    let edge = damped_edge(&setting);
    let mut notes = Vec::new();
    if setting.paper_alpha().is_none() {
        notes.push(no_branches(&setting));
    }
    let summary = if let Some(edge) = edge {
        format!(
            "Limit cycles are born at Omega_1 = -/+{} with damping, where the paper says -/+{}: a stable one at the \
             supercritical edge, left for hardening and right for softening supports, which goes on beyond the other \
             edge, where an unstable one is born.",
            number(edge, 5),
            number(half_width_printed(&setting.modes), 5)
        )
    } else {
        notes.push("Damping closes this tongue at this k0: there is no limit cycle.".to_owned());
        "Damping closes the combination tongue: the origin is stable and no limit cycle is born.".to_owned()
    };
    let method = "nontrivial solutions of (106)-(109) as printed; with damping [T6], [T8]";
    let mut figure = formula(id, parameters, composer, summary, method);
    figure.notes = notes;
    Ok(figure)
}

/// The tongue's half-width with damping, in `Omega_1`.
fn damped_edge(setting: &Setting) -> Option<f64> {
    let width = combination_half_width(&setting.modes, &setting.symmetric)?;
    Some(width / setting.symmetric.k0).filter(|edge| edge.is_finite())
}

/// Both radii of the solutions that leave the origin at one edge, over `Omega_1` or `Omega`.
pub(super) struct Radii {
    pub(super) edge: f64,
    pub(super) stable: bool,
    /// `(Omega_1, R_B)`.
    pub(super) b: Vec<(f64, f64)>,
    /// `(Omega_1, R_C)`.
    pub(super) c: Vec<(f64, f64)>,
}

/// The cycles of \[T8\] as far as `end` in `Omega_1`: of the supercritical edge and of the subcritical one.
///
/// # Errors
/// Those of [`cycles`].
pub(super) fn damped(setting: &Setting, supports: Supports, end: f64) -> Result<Vec<Radii>, FigureError> {
    let (Some(width), Some(_)) = (damped_edge(setting), setting.paper_alpha()) else {
        return Ok(Vec::new());
    };
    let (k0, omega_0) = (setting.symmetric.k0, emanating_frequency(&setting.modes));
    let at = |omega_1: f64| cycles(&setting.at(omega_0 + k0 * omega_1));
    let mut all = Vec::new();
    for (index, edge) in [(0, -supports.sign() * width), (1, supports.sign() * width)] {
        let Some(last) = at(end)?[index] else {
            continue;
        };
        let radius =
            |of: fn(Cycle) -> f64| half_parabola(edge, end, |omega_1| at(omega_1).ok()?[index].map(of));
        all.push(Radii {
            edge,
            stable: last.stable,
            b: radius(|cycle| cycle.radius_b),
            c: radius(|cycle| cycle.radius_c),
        });
    }
    Ok(all)
}

/// The solutions of (106)-(109) as printed, followed from each edge at which they leave the origin to `end`.
pub(super) fn printed(setting: &Setting, end: f64) -> Vec<Radii> {
    let Some(alpha) = setting.paper_alpha() else {
        return Vec::new();
    };
    let modes = &setting.modes;
    let width = printed_solutions_edge(modes);
    let mut all = Vec::new();
    for edge in [-width, width] {
        let Some(track) =
            follow(edge, end, |omega_1| printed_solutions(modes, alpha, omega_1).unwrap_or_default())
        else {
            continue;
        };
        // What is born stable stays the same branch: its stability is asked in the middle of its way.
        let stable = track[track.len() / 2].1.stable;
        let curve = |of: fn(&PrintedSolution) -> f64| {
            std::iter::once((edge, 0.0)).chain(track.iter().map(|(x, solution)| (*x, of(solution)))).collect()
        };
        all.push(Radii { edge, stable, b: curve(|s| s.radius_b), c: curve(|s| s.radius_c) });
    }
    all
}

/// Follows the solution that is born at `edge`: the smallest one at the first step, then the nearest in its ratio.
fn follow(
    edge: f64,
    end: f64,
    solutions: impl Fn(f64) -> Vec<PrintedSolution>,
) -> Option<Vec<(f64, PrintedSolution)>> {
    let mut track: Vec<(f64, PrintedSolution)> = Vec::new();
    for omega_1 in crowded(edge, end, 120).skip(1) {
        let found = solutions(omega_1);
        let key = |solution: &PrintedSolution| match track.last() {
            None => solution.radius_b,
            Some((_, before)) => (solution.ratio - before.ratio).abs(),
        };
        let Some(next) = found.into_iter().min_by(|one, other| key(one).total_cmp(&key(other))) else {
            break;
        };
        track.push((omega_1, next));
    }
    (track.len() > 1).then_some(track)
}

fn panel(
    composer: &mut Composer,
    column: usize,
    setting: &Setting,
    supports: Supports,
) -> Result<(), FigureError> {
    let modes = &setting.modes;
    let edge = damped_edge(setting);
    let widest = edge.unwrap_or(0.0).max(half_width(modes)).max(printed_solutions_edge(modes));
    let range = (-REACH * widest, REACH * widest);
    let end = supports.sign() * range.1;
    let damped = damped(setting, supports, end)?;
    let printed = printed(setting, end);
    let reach = damped
        .iter()
        .chain(&printed)
        .flat_map(|radii| radii.b.iter().chain(&radii.c))
        .fold(0.0_f64, |reach, point| reach.max(point.1));
    let radius = about_zero(1.08 * reach);
    let name = supports.name();
    let flat = composer.frame(plane(
        &format!("{name}-plane"),
        &supports.title(setting.symmetric.alpha.abs()),
        (column, 0),
        axis("Omega_1", "*Ω*_{1}", range),
        axis("R", "*R*_{B}, *R*_{C}", (-0.06 * radius.1, radius.1)),
    ));
    let space = composer.frame(Frame {
        z: Some(axis("B_2", "*B*_{2}", radius)),
        ..plane(
            &format!("{name}-space"),
            "",
            (column, 1),
            axis("Omega_1", "*Ω*_{1}", range),
            axis("B_1", "*B*_{1}", radius),
        )
    });
    for (line, points) in
        origin(range, edge.map(|edge| (-edge, edge)), &format!("origin {name}"), Role::Corrected)
    {
        composer.curve(space, line.clone().renamed(" 3-D"), points.lifted(false));
        composer.curve(flat, line, points);
    }
    for (index, radii) in printed.iter().enumerate() {
        let which = ["left", "right"][usize::from(index > 0 || radii.edge > 0.0)];
        for (letter, curve, label_at) in [("B", &radii.b, 0.7), ("C", &radii.c, 0.97)] {
            let line = Line::new(
                format!("R_{letter} {name} (106)-(109) {which}"),
                format!("R_{letter} of the solutions of (106)-(109) as printed, {name} supports, from the {which} edge"),
                Role::Paper,
            )
            .stable(radii.stable);
            let label = format!("*R*_{{{letter}}} paper (106)–(109)");
            // One pair of labels is enough; the dashed curves are the same solutions from the other edge.
            let line = if radii.edge * end < 0.0 { line.label(&label, label_at) } else { line };
            composer.curve(flat, line, Points::plane(curve.iter().copied()));
        }
    }
    for radii in &damped {
        cycle(composer, flat, space, radii, name);
    }
    Ok(())
}

fn cycle(composer: &mut Composer, flat: usize, space: usize, radii: &Radii, name: &str) {
    let word = if radii.stable { "stable" } else { "unstable" };
    for (letter, curve, role, label_at) in
        [("C", &radii.c, Role::Corrected, 0.55), ("B", &radii.b, Role::CorrectedSecond, 0.75)]
    {
        let line = Line::new(
            format!("R_{letter} {name} {word}"),
            format!("radius R_{letter} of the {word} limit cycle with damping [T8], {name} supports"),
            role,
        )
        .stable(radii.stable);
        let line = match (radii.stable, letter) {
            (true, _) => line.label(&format!("*R*_{{{letter}}} damped [T8]"), label_at),
            (false, "B") => line,
            (false, _) => line.label("unstable [T8]", 0.3),
        };
        composer.curve(flat, line, Points::plane(curve.iter().copied()));
    }
    let meaning =
        format!("the {word} limit cycle with damping [T8] as circles of radius R_B, {name} supports");
    let line =
        Line::new(format!("cycle {name} {word} 3-D"), meaning.clone(), Role::Corrected).stable(radii.stable);
    composer.curve(space, line, rings(&radii.b, if radii.stable { 9 } else { 4 }));
    let line =
        Line::new(format!("tube {name} {word} 3-D"), meaning, Role::CorrectedSecond).stable(radii.stable);
    composer.curve(space, line, tube(&radii.b, if radii.stable { 8 } else { 4 }));
    let (role, word) = if radii.stable {
        (Role::Supercritical, "supercritical Hopf bifurcation")
    } else {
        (Role::Subcritical, "subcritical Hopf bifurcation")
    };
    let star = Line::new(format!("{word} {name}"), word, role);
    composer.add(space, Mark::Marks, star.clone().renamed(" 3-D"), Points::space([(radii.edge, 0.0, 0.0)]));
    composer.marks(flat, star, Points::one((radii.edge, 0.0)));
}

/// Circles across the tube, evenly spaced along it.
fn rings(radii: &[(f64, f64)], count: usize) -> Points {
    let mut points = Points::default();
    let (Some(first), Some(last)) = (radii.first(), radii.last()) else {
        return points;
    };
    for x in even(first.0, last.0, count + 1).skip(1) {
        let radius = radius_at(radii, x);
        points
            .piece_in_space(even(0.0, TAU, 49).map(|angle| (x, radius * angle.cos(), radius * angle.sin())));
    }
    points
}

/// Lines along the tube, evenly spaced about it.
fn tube(radii: &[(f64, f64)], count: usize) -> Points {
    let mut points = Points::default();
    for angle in even(0.0, TAU, count + 1).take(count) {
        points
            .piece_in_space(radii.iter().map(|&(x, radius)| (x, radius * angle.cos(), radius * angle.sin())));
    }
    points
}

/// Straight between the samples, whose first coordinates rise or fall.
fn radius_at(radii: &[(f64, f64)], x: f64) -> f64 {
    radii
        .windows(2)
        .find(|pair| (pair[0].0 - x) * (pair[1].0 - x) <= 0.0 && pair[0].0 != pair[1].0)
        .map_or(0.0, |pair| pair[0].1 + (pair[1].1 - pair[0].1) * (x - pair[0].0) / (pair[1].0 - pair[0].0))
}
