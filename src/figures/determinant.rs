//! Figures 2 and 4: determinants of the slow flow's Jacobian, (68)-(70) and (92)-(94).

use super::beside::{Told, edges_on_axis};
use super::compose::{Composer, Line, Points, axis, even, number, plane};
use super::job::{Figure, formula};
use super::tongues::Setting;
use crate::chart::drawing::Role;
use crate::error::FigureError;
use crate::model::parameters::Parameters;
use crate::study::ErrorEstimate;
use crate::study::tongue::Tongue;
use crate::theory::damped::primary_half_width;
use crate::theory::modes::Mode;
use crate::theory::primary::{Branch, determinant_at, emanating_frequency, half_width};

/// How far the axis reaches, in half-widths of the tongue.
const REACH: f64 = 1.9;

/// # Errors
/// Unequal supports.
pub(super) fn figure(id: &'static str, parameters: &Parameters, mode: Mode) -> Result<Figure, FigureError> {
    let setting = Setting::of(parameters)?;
    let modes = &setting.modes;
    let width = half_width(modes, mode);
    let depth = -determinant_at(modes, mode, Branch::Origin, 0.0);
    let (low, high) = (-REACH * width, REACH * width);
    let (letter, equations) = match mode {
        Mode::Second => ("B", ["(68)", "(69)", "(70)"]),
        Mode::Third => ("C", ["(92)", "(93)", "(94)"]),
    };
    let mut composer = Composer::new((1, 1));
    let frame = composer.frame(plane(
        "determinant",
        "",
        (0, 0),
        axis("Omega_1", "*Ω*_{1}", (low, high)),
        axis("Det", "Det *J*", (-5.5 * depth, 9.5 * depth)),
    ));
    composer.curve(
        frame,
        Line::new("zero", "where the determinant changes its sign", Role::Reference),
        Points::plane([(low, 0.0), (high, 0.0)]),
    );
    for (branch, subscript, equation, at) in [
        (Branch::Origin, "1", equations[0], 0.5),
        (Branch::Sine, "2,3", equations[1], 0.72),
        (Branch::Cosine, "4,5", equations[2], 0.28),
    ] {
        let value = |omega_1: f64| (omega_1, determinant_at(modes, mode, branch, omega_1));
        // The zeros are known: the curve is cut there, a centre above and a saddle below.
        let cuts: Vec<f64> = match branch {
            Branch::Origin => vec![low, -width, width, high],
            Branch::Sine => vec![low, -width, high],
            Branch::Cosine => vec![low, width, high],
        };
        let (mut above, mut below) = (Points::default(), Points::default());
        for ends in cuts.windows(2) {
            let middle = value(0.5 * (ends[0] + ends[1])).1;
            let part = if middle > 0.0 { &mut above } else { &mut below };
            part.piece(even(ends[0], ends[1], if branch == Branch::Origin { 60 } else { 24 }).map(value));
        }
        let name = format!("Det at R_{subscript}");
        let label = format!("*R*_{{{letter}{subscript}}}, paper {equation}");
        let line = |word: &str, stable: bool| {
            let meaning = format!("{name} {equation}, {word}");
            Line::new(format!("{name} {word}"), meaning, Role::Paper).stable(stable)
        };
        let (centre, saddle) = (line("centre", true), line("saddle", false));
        let label_above = branch != Branch::Origin;
        composer.curve(frame, if label_above { centre.label(&label, at) } else { centre }, above);
        composer.curve(frame, if label_above { saddle } else { saddle.label(&label, at) }, below);
    }
    for (name, label, omega_1) in [("Omega_L", "*Ω*_{L}", -width), ("Omega_R", "*Ω*_{R}", width)] {
        let line = Line::new(name, "pitchfork bifurcation at the tongue's edge", Role::Bifurcation);
        composer.marks(frame, line.label(label, 0.5), Points::one((omega_1, 0.0)));
    }
    let (exact, error) = exact_edges(&mut composer, frame, parameters, mode, &setting);
    let summary = format!(
        "The determinant at the origin is below zero, a saddle, for Omega_1 between {} and {}; the determinants at \
         R_2,3 and R_4,5 pass through zero at the left and at the right of these, where the pitchforks are.",
        number(-width, 5),
        number(width, 5)
    );
    let mut figure = formula(
        id,
        parameters,
        composer,
        summary,
        &format!(
            "closed formulas {}-{}; exact edges: zeros of the characteristic polynomial's conditions, to 1e-9",
            equations[0], equations[2]
        ),
    );
    exact.onto(&mut figure);
    figure.error = error;
    figure.notes.push(format!(
        "The equilibria on a branch exist only on one side of its star: for hardening supports (alpha > 0) on the right \
         of it, for softening ones on the left ({}).",
        if mode == Mode::Second { "(71)-(76)" } else { "(95)-(100)" }
    ));
    Ok(figure)
}

/// Marks the exact edges on the axis, with the damping and without; gives what is to be told and the errors of the former.
fn exact_edges(
    composer: &mut Composer,
    frame: usize,
    parameters: &Parameters,
    mode: Mode,
    setting: &Setting,
) -> (Told, ErrorEstimate) {
    let tongue = match mode {
        Mode::Second => Tongue::Primary2,
        Mode::Third => Tongue::Primary3,
    };
    let (mut told, mut error) = (Told::default(), ErrorEstimate::default());
    let undamped = Parameters { zeta: 0.0, zeta_p: 0.0, zeta_g: 0.0, ..*parameters };
    for (p, name, label, formula) in [
        (parameters, "with damping", "exact", primary_half_width(&setting.modes, mode, &setting.symmetric)),
        (&undamped, "without damping", "exact, undamped", None),
    ] {
        let formula = formula.map_or(half_width(&setting.modes, mode), |width| width / p.k0);
        match edges_on_axis(p, tongue, emanating_frequency(&setting.modes, mode)) {
            Ok((Some(edges), answer)) => {
                let meaning = format!("exact edges of the tongue {name}");
                let line = Line::new(format!("exact edges {name}"), meaning, Role::Exact);
                composer.marks(frame, line.label(label, 0.0), Points::plane(edges.map(|x| (x, 0.0))));
                told.edges_apart(&format!("{name}, of first order,"), formula, edges);
                error = error.worse(answer.error);
            }
            Ok((None, _)) => told.notes.push(format!("Exactly, {name}, the tongue is closed.")),
            Err(failed) => told.notes.push(format!("The exact edges {name} cannot be computed: {failed}.")),
        }
    }
    (told, error)
}
