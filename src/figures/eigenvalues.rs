//! Figure 6: eigenvalues of the slow flow at the origin in the combination tongue.

use super::compose::{Composer, Line, Points, axis, even, number, plane};
use super::job::{Figure, formula};
use super::tongues::{Setting, about_zero};
use crate::chart::drawing::Role;
use crate::error::FigureError;
use crate::model::parameters::Parameters;
use crate::theory::combination::{
    eigenvalues_111, emanating_frequency, growth_rates, half_width, half_width_printed,
};
use crate::theory::damped::{combination_exponents, combination_half_width};

/// How far the axis reaches, in the largest of the half-widths.
const REACH: f64 = 1.5;
/// Samples between two neighbouring edges.
const SAMPLES: usize = 48;

type Four = [(f64, f64); 4];
/// The real or the imaginary part.
type Part = fn((f64, f64)) -> f64;

/// One set of four eigenvalues over `Omega_1`.
struct Set<'a> {
    name: &'static str,
    meaning: &'static str,
    label: &'static str,
    label_at: f64,
    role: Role,
    edge: Option<f64>,
    of: &'a dyn Fn(f64) -> Four,
}

/// # Errors
/// Unequal supports.
pub(super) fn figure(id: &'static str, parameters: &Parameters) -> Result<Figure, FigureError> {
    let setting = Setting::of(parameters)?;
    let (modes, symmetric) = (&setting.modes, &setting.symmetric);
    let k0 = symmetric.k0;
    let omega_0 = emanating_frequency(modes);
    let (printed_edge, edge) = (half_width_printed(modes), half_width(modes));
    let damped_edge =
        combination_half_width(modes, symmetric).map(|width| width / k0).filter(|w| w.is_finite());
    let range = about_zero(reach(&setting));

    let printed = |omega_1: f64| eigenvalues_111(modes, omega_1).map(|value| (value.re, value.im));
    let corrected = |omega_1: f64| growth_rates(modes, omega_1).map(|value| (k0 * value.re, k0 * value.im));
    let damped = |omega_1: f64| match combination_exponents(&setting.at(omega_0 + k0 * omega_1)) {
        Ok(values) => values.map(|value| (value.re, value.im)),
        Err(_) => [(f64::NAN, f64::NAN); 4],
    };
    let sets = [
        Set {
            name: "printed",
            meaning: "eigenvalues of the Jacobian (110) as printed, by (111)",
            label: "paper (111)",
            label_at: 0.5,
            role: Role::Paper,
            edge: Some(printed_edge),
            of: &printed,
        },
        Set {
            name: "corrected",
            meaning: "growth rates of the slow flow without damping [T4]",
            label: "corrected [T4]",
            label_at: 0.42,
            role: Role::CorrectedSecond,
            edge: Some(edge).filter(|_| k0 > 0.0),
            of: &corrected,
        },
        Set {
            name: "damped",
            meaning: "growth rates of the slow flow with damping [T6]",
            label: "damped [T6]",
            label_at: 0.6,
            role: Role::Corrected,
            edge: damped_edge,
            of: &damped,
        },
    ];
    let mut composer = Composer::new((2, 2));
    for (column, (title, sets)) in [
        ("as printed, on its own scale", &sets[..1]),
        ("per unit of time, each mode rightly scaled", &sets[1..]),
    ]
    .into_iter()
    .enumerate()
    {
        panels(&mut composer, column, title, range, sets);
    }
    let growth = 0.5 * k0 * edge;
    let damped_words = match damped_edge {
        Some(edge) => format!("and with damping at -/+{} [T6]", number(edge, 5)),
        None => "and with damping nowhere: the tongue is closed".to_owned(),
    };
    let summary = format!(
        "The real parts leave zero at Omega_1 = -/+{} as printed (105), at -/+{} rightly scaled [T4], {damped_words}; \
         in the middle of the tongue the undamped growth rate is {} and the imaginary part is zero.",
        number(printed_edge, 5),
        number(edge, 5),
        number(growth, 4)
    );
    let mut figure =
        formula(id, parameters, composer, summary, "closed formulas (110), (111); [T4], [T6] with averaging");
    figure.notes.push(
        "Printed are lambda^2 and (a^2 - b^2)/2 in (111); drawn is what the matrix (110) has, with lambda and \
         (a^2 + b^2)/2, for only that vanishes at (105)."
            .to_owned(),
    );
    if damped_edge.is_none() {
        figure.notes.push("Damping closes this tongue at this k0.".to_owned());
    }
    Ok(figure)
}

/// How far the axis reaches, in `Omega_1`.
pub(super) fn reach(setting: &Setting) -> f64 {
    let (modes, symmetric) = (&setting.modes, &setting.symmetric);
    let damped = combination_half_width(modes, symmetric).map(|width| width / symmetric.k0);
    let damped = damped.filter(|width| width.is_finite()).unwrap_or(0.0);
    REACH * damped.max(half_width_printed(modes)).max(half_width(modes))
}

fn panels(composer: &mut Composer, column: usize, title: &str, range: (f64, f64), sets: &[Set]) {
    let prefix = ["printed", "scaled"][column];
    let reach = |part: Part| {
        let values = sets.iter().flat_map(|set| even(range.0, range.1, 41).flat_map(|x| (set.of)(x)));
        about_zero(1.12 * values.map(|value| part(value).abs()).filter(|v| v.is_finite()).fold(0.0, f64::max))
    };
    let parts: [(&str, &str, &str, Part); 2] =
        [("Re", "Re *λ*", title, |value| value.0), ("Im", "Im *λ*", "", |value| value.1)];
    for (row, (name, label, title, part)) in parts.into_iter().enumerate() {
        let frame = composer.frame(plane(
            &format!("{prefix}-{}", name.to_ascii_lowercase()),
            title,
            (column, row),
            axis("Omega_1", "*Ω*_{1}", range),
            axis(&format!("{name} lambda"), label, reach(part)),
        ));
        composer.curve(
            frame,
            Line::new(format!("zero {prefix} {name}"), "where growth turns into decay", Role::Reference),
            Points::plane([(range.0, 0.0), (range.1, 0.0)]),
        );
        for set in sets {
            for number in 0..4 {
                let line = Line::new(
                    format!("{name} {} {}", set.name, number + 1),
                    format!(
                        "{} part of the {}",
                        if name == "Re" { "real" } else { "imaginary" },
                        set.meaning
                    ),
                    set.role,
                );
                let line = if number == 0 { line.label(set.label, set.label_at) } else { line };
                composer.curve(frame, line, Points::plane(branch(set, range, number, part)));
            }
            if let Some(edge) = set.edge {
                let line = Line::new(
                    format!("Hopf points {} {name}", set.name),
                    format!("Hopf bifurcations of the {}", set.meaning),
                    Role::Bifurcation,
                );
                composer.marks(
                    frame,
                    line,
                    Points::plane([-edge, edge].into_iter().flat_map(|x| hopf(set, x, part))),
                );
            }
        }
    }
}

/// The parts of the eigenvalues that are about to grow at an edge, each once.
fn hopf(set: &Set, edge: f64, part: Part) -> Vec<(f64, f64)> {
    let values = (set.of)(edge);
    let size =
        values.iter().fold(f64::MIN_POSITIVE, |size, value| size.max(value.0.abs()).max(value.1.abs()));
    let largest = values.iter().fold(f64::NEG_INFINITY, |largest, value| largest.max(value.0));
    let mut found: Vec<(f64, f64)> = Vec::new();
    for value in values.into_iter().filter(|value| value.0 > largest - 1e-6 * size) {
        if found.iter().all(|(_, other)| (other - part(value)).abs() > 1e-6 * size) {
            found.push((edge, part(value)));
        }
    }
    found
}

/// One eigenvalue's part over the axis, with the points crowded at the edges, where square roots begin.
fn branch(set: &Set, range: (f64, f64), number: usize, part: Part) -> Vec<(f64, f64)> {
    let edge = set.edge.unwrap_or(0.5 * range.1);
    let cuts = [range.0, -edge, 0.0, edge, range.1];
    let mut points = Vec::new();
    for (index, ends) in cuts.windows(2).enumerate() {
        // Crowd at whichever end is an edge.
        let at_right = index % 2 == 0;
        for step in even(0.0, 1.0, SAMPLES) {
            let fraction = if at_right { 1.0 - (1.0 - step) * (1.0 - step) } else { step * step };
            let x = ends[0] * (1.0 - fraction) + ends[1] * fraction;
            points.push((x, part((set.of)(x)[number])));
        }
    }
    points
}
