//! Figures 3 and 5: pitchforks of a primary tongue, in the plane and in space.

use super::compose::{Composer, Line, Points, axis, number, plane};
use super::job::{Figure, formula};
use super::tongues::{Setting, Supports, about_zero, origin, parabola};
use crate::chart::drawing::{Frame, Mark, Role};
use crate::error::FigureError;
use crate::model::parameters::Parameters;
use crate::theory::branches::{PeriodTwo, period_two};
use crate::theory::damped::primary_half_width;
use crate::theory::modes::Mode;
use crate::theory::primary::{Branch, emanating_frequency, half_width, radius_squared};

/// How far the axis reaches, in half-widths of the tongue.
pub(super) const REACH: f64 = 2.2;

/// The words and numbers that tell the two figures apart.
struct Names {
    letter: &'static str,
    sine: &'static str,
    cosine: &'static str,
}

/// # Errors
/// Unequal supports.
pub(super) fn figure(id: &'static str, parameters: &Parameters, mode: Mode) -> Result<Figure, FigureError> {
    let setting = Setting::of(parameters)?;
    let names = match mode {
        Mode::Second => Names { letter: "B", sine: "(63)", cosine: "(64)" },
        Mode::Third => Names { letter: "C", sine: "(88)", cosine: "(89)" },
    };
    let mut composer = Composer::new((2, 2));
    for (column, supports) in Supports::BOTH.into_iter().enumerate() {
        panel(&mut composer, column, &setting.with(supports), supports, mode, &names)?;
    }
    let width = half_width(&setting.modes, mode);
    let damped = primary_half_width(&setting.modes, mode, &setting.symmetric);
    let k0 = setting.symmetric.k0;
    let mut notes = Vec::new();
    let branches = if setting.paper_alpha().is_none() {
        notes.push(no_branches(&setting));
        "no branch leaves the origin".to_owned()
    } else {
        "for hardening supports the stable branch leaves the left edge and an unstable one the right edge, for \
         softening ones the other way round; both go on beyond the tongue"
            .to_owned()
    };
    let edges = if let Some(damped) = damped {
        format!("with damping {}", number(damped / k0, 5))
    } else {
        notes.push("Damping closes this tongue at this k0: the green branches are gone.".to_owned());
        "with damping the tongue is closed".to_owned()
    };
    let summary = format!("Pitchforks at Omega_1 = -/+{} as printed, {edges}: {branches}.", number(width, 5));
    let method =
        format!("closed formulas {}, {} as printed; with damping [T5], [T7]", names.sine, names.cosine);
    let mut figure = formula(id, parameters, composer, summary, &method);
    figure.notes = notes;
    Ok(figure)
}

/// Why there are no branches.
pub(super) fn no_branches(setting: &Setting) -> String {
    if setting.symmetric.alpha == 0.0 {
        "alpha = 0: without a cubic part of the supports nothing but the origin is at rest, and no branch leaves it."
            .to_owned()
    } else {
        "k0 = 0: without pulsation there is no tongue, and the branches shrink onto the origin.".to_owned()
    }
}

/// A branch of equilibria with all that is drawn of it.
struct Drawn {
    name: String,
    meaning: String,
    label: String,
    label_at: f64,
    role: Role,
    stable: bool,
    /// `Omega_1` and `R`, with both signs of `R`, from end to end.
    curve: Vec<(f64, f64)>,
    /// Cosine and sine of the equilibria's angle.
    direction: (f64, f64),
    edge: f64,
}

fn panel(
    composer: &mut Composer,
    column: usize,
    setting: &Setting,
    supports: Supports,
    mode: Mode,
    names: &Names,
) -> Result<(), FigureError> {
    let modes = &setting.modes;
    let width = half_width(modes, mode);
    let range = (-REACH * width, REACH * width);
    let end = supports.sign() * range.1;
    let printed = printed(setting, supports, mode, names, end);
    let damped = damped(setting, supports, mode, end)?;
    let reach =
        printed.iter().chain(&damped).flat_map(|branch| &branch.curve).fold(0.0_f64, |r, p| r.max(p.1.abs()));
    let radius = about_zero(1.08 * reach);
    let letter = names.letter;
    let omega_1 = || axis("Omega_1", "*Ω*_{1}", range);
    let name = supports.name();
    let flat = composer.frame(plane(
        &format!("{name}-plane"),
        &supports.title(setting.symmetric.alpha.abs()),
        (column, 0),
        omega_1(),
        axis(&format!("R_{letter}"), &format!("*R*_{{{letter}}}"), radius),
    ));
    let space = composer.frame(Frame {
        z: Some(axis(&format!("{letter}_2"), &format!("*{letter}*_{{2}}"), radius)),
        ..plane(
            &format!("{name}-space"),
            "",
            (column, 1),
            omega_1(),
            axis(&format!("{letter}_1"), &format!("*{letter}*_{{1}}"), radius),
        )
    });
    let k0 = setting.symmetric.k0;
    let edges = primary_half_width(modes, mode, &setting.symmetric).map(|damped| (-damped / k0, damped / k0));
    for (edges, word, role) in [
        (Some((-width, width)).filter(|_| k0 > 0.0), "paper", Role::Paper),
        (edges, "damped", Role::Corrected),
    ] {
        for (line, points) in origin(range, edges, &format!("origin {name} {word}"), role) {
            composer.curve(space, line.clone().renamed(" 3-D"), points.lifted(false));
            composer.curve(flat, line, points);
        }
    }
    for branch in printed.into_iter().chain(damped) {
        draw(composer, flat, space, branch);
    }
    Ok(())
}

fn draw(composer: &mut Composer, flat: usize, space: usize, branch: Drawn) {
    let line = Line::new(&branch.name, &branch.meaning, branch.role).stable(branch.stable);
    let (cosine, sine) = branch.direction;
    let points = Points::space(branch.curve.iter().map(|&(x, r)| (x, r * cosine, r * sine)));
    composer.curve(space, line.clone().renamed(" 3-D"), points);
    composer.curve(flat, line.label(&branch.label, branch.label_at), Points::plane(branch.curve));
    let (role, word) = if branch.stable {
        (Role::Supercritical, "supercritical pitchfork")
    } else {
        (Role::Subcritical, "subcritical pitchfork")
    };
    let star = Line::new(format!("{word} of {}", branch.name), word, role);
    composer.add(space, Mark::Marks, star.clone().renamed(" 3-D"), Points::space([(branch.edge, 0.0, 0.0)]));
    composer.marks(flat, star, Points::one((branch.edge, 0.0)));
}

fn printed(setting: &Setting, supports: Supports, mode: Mode, names: &Names, end: f64) -> Vec<Drawn> {
    let Some(alpha) = setting.paper_alpha() else {
        return Vec::new();
    };
    let modes = &setting.modes;
    let width = half_width(modes, mode);
    [(Branch::Sine, -width), (Branch::Cosine, width)]
        .into_iter()
        .map(|(branch, edge)| {
            let radius = |omega_1: f64| {
                let square = radius_squared(modes, mode, branch, alpha, omega_1).ok()?;
                (square >= 0.0 && square.is_finite()).then(|| square.sqrt())
            };
            let stable = (branch == Branch::Sine) == (supports == Supports::Hardening);
            let (subscript, word, equation, direction) = match branch {
                Branch::Sine => ("2,3", "sine", names.sine, (0.0, 1.0)),
                _ => ("4,5", "cosine", names.cosine, (1.0, 0.0)),
            };
            Drawn {
                name: format!("R_{subscript} {} {equation}", supports.name()),
                meaning: format!(
                    "{word} branch R_{subscript} of {} supports, as printed {equation}, {}",
                    supports.name(),
                    if stable { "stable (centres)" } else { "unstable (saddles)" }
                ),
                label: format!("*R*_{{{subscript}}} paper {equation}"),
                label_at: 0.9,
                role: Role::Paper,
                stable,
                curve: parabola(edge, end, radius),
                direction,
                edge,
            }
        })
        .collect()
}

fn damped(setting: &Setting, supports: Supports, mode: Mode, end: f64) -> Result<Vec<Drawn>, FigureError> {
    let symmetric = &setting.symmetric;
    let Some(width) = primary_half_width(&setting.modes, mode, symmetric) else {
        return Ok(Vec::new());
    };
    if symmetric.alpha == 0.0 {
        return Ok(Vec::new());
    }
    let (k0, omega_0) = (symmetric.k0, emanating_frequency(&setting.modes, mode));
    let at = |omega_1: f64| period_two(&setting.at(omega_0 + k0 * omega_1), mode);
    let mut drawn = Vec::new();
    for (index, edge) in [(0, -width / k0), (1, width / k0)] {
        let Some(last) = at(end)?[index] else {
            continue;
        };
        let radius = |omega_1: f64| at(omega_1).ok()?[index].map(|orbit: PeriodTwo| orbit.radius);
        let (subscript, word) = if last.branch == Branch::Sine { ("2,3", "sine") } else { ("4,5", "cosine") };
        drawn.push(Drawn {
            name: format!("R_{subscript} {} damped", supports.name()),
            meaning: format!(
                "{word} branch R_{subscript} of {} supports with damping [T7], {}",
                supports.name(),
                if last.stable { "stable (nodes or foci)" } else { "unstable (saddles)" }
            ),
            label: "damped [T7]".to_owned(),
            label_at: 0.08,
            role: Role::Corrected,
            stable: last.stable,
            curve: parabola(edge, end, radius),
            direction: (last.angle.cos(), last.angle.sin()),
            edge,
        });
    }
    Ok(drawn)
}
