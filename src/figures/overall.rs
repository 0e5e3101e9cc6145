//! Figures 9 and 10: all first-order branches over the mesh frequency.

use super::beside::{Told, farthest};
use super::compose::{Composer, Line, Points, axis, number, plane};
use super::exact::{Exact, Spot, Style};
use super::hopf;
use super::job::{Figure, Slices, formula};
use super::pitchfork::no_branches;
use super::tongues::{Setting, Supports, half_parabola};
use crate::chart::drawing::Role;
use crate::error::FigureError;
use crate::model::parameters::{Parameters, Regime};
use crate::theory::branches::period_two;
use crate::theory::modes::Mode;
use crate::theory::primary::{Branch, radius_squared};
use crate::theory::tongues::Edges;
use crate::theory::{combination, damped, primary};

/// Where the formulas put one tongue at the given `k0`.
#[derive(Clone, Copy, Debug)]
struct Tongue {
    omega_0: f64,
    /// As printed, without damping; `None` at `k0 = 0`.
    paper: Option<Edges>,
    /// With damping; `None` where that closes it.
    damped: Option<Edges>,
}

/// The three tongues from left to right.
#[derive(Clone, Copy, Debug)]
struct Tongues {
    second: Tongue,
    combination: Tongue,
    third: Tongue,
}

impl Tongues {
    fn of(setting: &Setting) -> Self {
        let (modes, symmetric) = (&setting.modes, &setting.symmetric);
        let tongue = |omega_0: f64, printed: f64, damped: Option<Edges>| Tongue {
            omega_0,
            paper: (symmetric.k0 > 0.0).then(|| Edges::about(omega_0, symmetric.k0 * printed)),
            damped,
        };
        let primary = |mode: Mode| {
            tongue(
                primary::emanating_frequency(modes, mode),
                primary::half_width(modes, mode),
                damped::primary_edges(modes, mode, symmetric),
            )
        };
        Self {
            second: primary(Mode::Second),
            combination: tongue(
                combination::emanating_frequency(modes),
                combination::half_width_printed(modes),
                damped::combination_edges(modes, symmetric),
            ),
            third: primary(Mode::Third),
        }
    }

    fn each(&self) -> [Tongue; 3] {
        [self.second, self.combination, self.third]
    }

    /// Half the way from the first to the second: as far as a branch is followed.
    fn span(&self) -> f64 {
        0.5 * (self.combination.omega_0 - self.second.omega_0)
    }

    /// From below the first tongue to above the third, as far as the branches are followed.
    fn range(&self) -> (f64, f64) {
        let span = 1.15 * self.span();
        ((self.second.omega_0 - span).max(0.0), self.third.omega_0 + span)
    }
}

/// One branch over `Omega`, from its edge.
struct Drawn {
    name: String,
    meaning: String,
    label: Option<String>,
    label_at: f64,
    role: Role,
    stable: bool,
    curve: Vec<(f64, f64)>,
    /// The bifurcation at its edge, unless another branch of the same edge shows it.
    event: Option<&'static str>,
}

/// Longest period of the exact motions beside the formulas, mesh periods.
const LONGEST: usize = 2;

/// Most branches of them.
const MOST: usize = 24;

/// Tori between two torus bifurcations.
const TORI: usize = 6;

/// Figure 9 or 10 in the making: the formulas at once, the exact motions as they are computed.
#[derive(Debug)]
pub(super) struct Overall {
    formulas: Figure,
    exact: Exact,
}

impl Overall {
    /// # Errors
    /// Unequal supports.
    pub(super) fn new(
        id: &'static str,
        parameters: &Parameters,
        supports: Supports,
    ) -> Result<Self, FigureError> {
        let setting = Setting::of(parameters)?.with(supports);
        let formulas = formulas(id, parameters, supports)?;
        let alpha = setting.symmetric.alpha;
        let p = Parameters {
            alpha_p: alpha,
            alpha_g: alpha,
            regime: Regime::Homogeneous,
            load: 0.0,
            load_p: 0.0,
            load_g: 0.0,
            error: 0.0,
            ..*parameters
        };
        let (low, high) = Tongues::of(&setting).range();
        let exact = Exact::new(&p, (low.max(0.3 * high.min(1.0)), high), LONGEST, MOST).with_tori(TORI);
        Ok(Self { formulas, exact })
    }

    /// Half of the greatest `|u_p|`, which the formulas call `R`, over the mesh frequency.
    fn place(&self, index: usize, spot: Spot) -> [f64; 3] {
        let [omega, size, _] = self.exact.by_size(index, spot);
        [omega, 0.5 * size, 0.0]
    }

    /// Where the formula of the stable motion and the exact one are furthest apart.
    fn farthest(&self) -> Option<[f64; 3]> {
        let stable = self.formulas.drawing.series.iter().filter(|series| {
            series.role == Role::Corrected && series.stable == Some(true) && series.name.starts_with("R_")
        });
        farthest(stable.filter(|series| !series.name.contains("cycle")), &|omega| {
            self.exact.stable_at(omega, &|index, spot| self.place(index, spot))
        })
    }
}

impl Slices for Overall {
    fn advance(&mut self) -> Result<bool, FigureError> {
        self.exact.advance()
    }

    fn figure(&self, _: &'static str, _: &Parameters) -> Figure {
        let mut figure = self.formulas.clone();
        let mut composer = Composer::on(figure.drawing);
        let place = &|index: usize, spot: Spot| self.place(index, spot);
        self.exact.draw(&mut composer, 0, &Style { name: "", place, space: false, marked: true });
        self.exact.draw_tori(&mut composer, 0, 0.5);
        figure.drawing = composer.drawing();
        let mut told = Told { notes: self.exact.notes(), ..Told::default() };
        if let Some(found) = self.farthest() {
            told.apart("", "Omega", found);
        }
        told.onto(&mut figure);
        figure.error = self.exact.error();
        figure
            .method
            .push_str("; exact: continuation of the stroboscopic map, tori by collocation, drawn as half of the greatest |u_p|");
        figure
    }
}

/// # Errors
/// Unequal supports.
fn formulas(id: &'static str, parameters: &Parameters, supports: Supports) -> Result<Figure, FigureError> {
    let setting = Setting::of(parameters)?.with(supports);
    let all = Tongues::of(&setting);
    let (low, high) = all.range();
    let span = all.span();
    let mut drawn = Vec::new();
    for (mode, tongue) in [(Mode::Second, &all.second), (Mode::Third, &all.third)] {
        let end = tongue.omega_0 + supports.sign() * span;
        drawn.extend(printed_pitchforks(&setting, supports, mode, tongue, end));
        drawn.extend(damped_pitchforks(&setting, supports, mode, tongue, end)?);
    }
    drawn.extend(hopf_branches(&setting, supports, &all.combination, span)?);
    let reach =
        drawn.iter().flat_map(|branch| &branch.curve).fold(0.0_f64, |reach, point| reach.max(point.1));
    let top = if reach > 1e-9 { 1.16 * reach } else { 1.0 };

    let mut composer = Composer::new((1, 1));
    let frame = composer.frame(plane(
        "diagram",
        &supports.title(setting.symmetric.alpha.abs()),
        (0, 0),
        axis("Omega", "*Ω*", (low, high)),
        axis("R", "*R*_{B}, *R*_{C}", (-0.06 * top, top)),
    ));
    let pulsating = setting.symmetric.k0 > 0.0;
    for (edges, word, role) in [
        (all.each().map(|tongue| tongue.paper.filter(|_| pulsating)), "as printed", Role::Paper),
        (all.each().map(|tongue| tongue.damped), "with damping", Role::Corrected),
    ] {
        origin(&mut composer, frame, (low, high), edges, word, role);
    }
    for branch in drawn {
        draw(&mut composer, frame, branch);
    }
    for (name, words, tongue) in [
        ("second", "*Ω*_{0} = 2*ω*_{2}", &all.second),
        ("combination", "*Ω*_{0} = *ω*_{2} + *ω*_{3}", &all.combination),
        ("third", "*Ω*_{0} = 2*ω*_{3}", &all.third),
    ] {
        composer.text(frame, &format!("tongue {name}"), words, (tongue.omega_0, 0.95 * top));
    }
    let mut notes = Vec::new();
    if setting.paper_alpha().is_none() {
        notes.push(no_branches(&setting));
    }
    let summary = summary(&all, supports, &mut notes);
    let mut figure = formula(
        id,
        parameters,
        composer,
        summary,
        "closed formulas (63), (64), (88), (89) and (106)-(109) as printed; with damping [T5]-[T8]",
    );
    figure.notes = notes;
    Ok(figure)
}

fn summary(all: &Tongues, supports: Supports, notes: &mut Vec<String>) -> String {
    let mut open = Vec::new();
    for (name, tongue) in
        [("second mode", all.second), ("combination", all.combination), ("third mode", all.third)]
    {
        match tongue.damped {
            Some(edges) => {
                open.push(format!("{name} {} to {}", number(edges.left, 5), number(edges.right, 5)));
            }
            None => notes.push(format!("Damping closes the tongue: {name}.")),
        }
    }
    let lean = if supports == Supports::Hardening { "higher" } else { "lower" };
    if open.is_empty() {
        "With damping all three tongues are closed and the origin is stable everywhere.".to_owned()
    } else {
        format!(
            "With damping the origin is unstable in these tongues of Omega: {}; all branches lean to {lean} Omega.",
            open.join(", ")
        )
    }
}

fn origin(
    composer: &mut Composer,
    frame: usize,
    (low, high): (f64, f64),
    edges: [Option<Edges>; 3],
    word: &str,
    role: Role,
) {
    let (mut stable, mut unstable) = (Points::default(), Points::default());
    let mut reached = low;
    for edges in edges.into_iter().flatten() {
        let (left, right) = (edges.left.clamp(reached, high), edges.right.clamp(reached, high));
        if left > reached {
            stable.piece([(reached, 0.0), (left, 0.0)]);
        }
        if right > left {
            unstable.piece([(left, 0.0), (right, 0.0)]);
        }
        reached = right;
    }
    if high > reached {
        stable.piece([(reached, 0.0), (high, 0.0)]);
    }
    for (points, is_stable, kind) in [(stable, true, "stable"), (unstable, false, "unstable")] {
        let line = Line::new(format!("origin {word} {kind}"), format!("the origin, {kind}, {word}"), role);
        composer.curve(frame, line.stable(is_stable), points);
    }
}

fn draw(composer: &mut Composer, frame: usize, branch: Drawn) {
    let line = Line::new(&branch.name, branch.meaning, branch.role).stable(branch.stable);
    let line = match &branch.label {
        Some(label) => line.label(label, branch.label_at),
        None => line,
    };
    let edge = branch.curve.first().copied();
    composer.curve(frame, line, Points::plane(branch.curve));
    if let (Some(kind), Some(edge)) = (branch.event, edge) {
        let (role, word) = if branch.stable {
            (Role::Supercritical, "supercritical")
        } else {
            (Role::Subcritical, "subcritical")
        };
        let line = Line::new(format!("{word} {kind} of {}", branch.name), format!("{word} {kind}"), role);
        composer.marks(frame, line, Points::one(edge));
    }
}

/// Whether `end` lies beyond `edge` on the side on which branches lie.
fn reaches(supports: Supports, edge: f64, end: f64) -> bool {
    supports.sign() * (end - edge) > 0.0 && end > 0.0
}

fn printed_pitchforks(
    setting: &Setting,
    supports: Supports,
    mode: Mode,
    tongue: &Tongue,
    end: f64,
) -> Vec<Drawn> {
    let (Some(alpha), Some(edges)) = (setting.paper_alpha(), tongue.paper) else {
        return Vec::new();
    };
    let k0 = setting.symmetric.k0;
    let (letter, equations) = match mode {
        Mode::Second => ("B", ["(63)", "(64)"]),
        Mode::Third => ("C", ["(88)", "(89)"]),
    };
    [(Branch::Sine, edges.left, "2,3", equations[0]), (Branch::Cosine, edges.right, "4,5", equations[1])]
        .into_iter()
        .filter(|(_, edge, _, _)| reaches(supports, *edge, end))
        .map(|(branch, edge, subscript, equation)| {
            let stable = (branch == Branch::Sine) == (supports == Supports::Hardening);
            let radius = |omega: f64| {
                let omega_1 = (omega - tongue.omega_0) / k0;
                let square = radius_squared(&setting.modes, mode, branch, alpha, omega_1).ok()?;
                (square >= 0.0 && square.is_finite()).then(|| square.sqrt())
            };
            Drawn {
                name: format!("R_{letter}{subscript} {equation}"),
                meaning: format!("R_{letter}{subscript} as printed {equation}, {}", stability(stable)),
                label: Some(format!("paper {equation}")),
                label_at: 0.93,
                role: Role::Paper,
                stable,
                curve: half_parabola(edge, end, radius),
                event: Some("pitchfork as printed"),
            }
        })
        .collect()
}

fn stability(stable: bool) -> &'static str {
    if stable { "stable" } else { "unstable" }
}

fn damped_pitchforks(
    setting: &Setting,
    supports: Supports,
    mode: Mode,
    tongue: &Tongue,
    end: f64,
) -> Result<Vec<Drawn>, FigureError> {
    let (Some(edges), Some(_)) = (tongue.damped, setting.paper_alpha()) else {
        return Ok(Vec::new());
    };
    let letter = if mode == Mode::Second { "B" } else { "C" };
    let mut drawn = Vec::new();
    for (index, edge, subscript) in [(0, edges.left, "2,3"), (1, edges.right, "4,5")] {
        if !reaches(supports, edge, end) {
            continue;
        }
        let Some(last) = period_two(&setting.at(end), mode)?[index] else {
            continue;
        };
        let radius = |omega: f64| period_two(&setting.at(omega), mode).ok()?[index].map(|orbit| orbit.radius);
        drawn.push(Drawn {
            name: format!("R_{letter}{subscript} damped"),
            meaning: format!("R_{letter}{subscript} with damping [T7], {}", stability(last.stable)),
            label: last.stable.then(|| format!("*R*_{{{letter}}} damped [T7]")),
            label_at: 0.72,
            role: Role::Corrected,
            stable: last.stable,
            curve: half_parabola(edge, end, radius),
            event: Some("pitchfork with damping"),
        });
    }
    Ok(drawn)
}

fn hopf_branches(
    setting: &Setting,
    supports: Supports,
    tongue: &Tongue,
    span: f64,
) -> Result<Vec<Drawn>, FigureError> {
    let k0 = setting.symmetric.k0;
    let end = supports.sign() * span / k0;
    if !end.is_finite() {
        return Ok(Vec::new());
    }
    let over_omega = |curve: Vec<(f64, f64)>| -> Vec<(f64, f64)> {
        curve.into_iter().map(|(omega_1, radius)| (tongue.omega_0 + k0 * omega_1, radius)).collect()
    };
    let mut drawn = Vec::new();
    let reaching = |radii: &hopf::Radii| {
        reaches(supports, radii.edge, end) || supports.sign() * (end - radii.edge) > 0.0
    };
    for radii in hopf::printed(setting, end).into_iter().filter(reaching) {
        let side = if radii.edge < 0.0 { "left" } else { "right" };
        for (letter, curve) in [("B", radii.b), ("C", radii.c)] {
            drawn.push(Drawn {
                name: format!("R_{letter} (106)-(109) {side}"),
                meaning: format!(
                    "R_{letter} of the solutions of (106)-(109) as printed, from the {side} edge, {}",
                    stability(radii.stable)
                ),
                label: (letter == "B" && radii.edge * end < 0.0).then(|| "paper (106)–(109)".to_owned()),
                label_at: 0.95,
                role: Role::Paper,
                stable: radii.stable,
                curve: over_omega(curve),
                event: None,
            });
        }
    }
    for radii in hopf::damped(setting, supports, end)?.into_iter().filter(reaching) {
        let word = stability(radii.stable);
        for (letter, curve, role) in [("C", radii.c, Role::Corrected), ("B", radii.b, Role::CorrectedSecond)]
        {
            drawn.push(Drawn {
                name: format!("R_{letter} cycle {word} damped"),
                meaning: format!("R_{letter} of the {word} limit cycle with damping [T8]"),
                label: radii.stable.then(|| format!("*R*_{{{letter}}} damped [T8]")),
                label_at: if letter == "C" { 0.4 } else { 0.6 },
                role,
                stable: radii.stable,
                curve: over_omega(curve),
                event: (letter == "C").then_some("Hopf with damping"),
            });
        }
    }
    Ok(drawn)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_frame_holds_all_three_tongues() {
        let all = Tongues::of(&Setting::of(&Parameters::default()).expect("equal supports"));
        let (low, high) = all.range();
        for tongue in all.each() {
            let edges = tongue.paper.expect("open");
            assert!(low < edges.left && edges.right < high);
        }
        assert!((all.combination.omega_0 - 0.5 * (all.second.omega_0 + all.third.omega_0)).abs() < 1e-14);
    }
}
