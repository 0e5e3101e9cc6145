//! Exact answers beside the formulas of a figure: the formulas are its first picture, the rest comes slice by slice.

use super::compose::{Composer, number};
use super::job::{Distance, Figure, Slices};
use crate::chart::drawing::Series;
use crate::error::{FigureError, StudyError};
use crate::model::parameters::{Parameters, Regime};
use crate::study::ErrorEstimate;
use crate::study::tongue::{Tongue, TongueEdges, tongue_edges};
use crate::theory::modes::{Mode, Modes};

/// Tolerance of the tongues' edges.
const EDGES: f64 = 1e-9;

/// The exact part of a figure.
pub(super) trait Part {
    /// Does the next slice of the work; true once there is nothing more to do.
    ///
    /// # Errors
    /// What a study fails with: the figure then has its formulas, and a note.
    fn advance(&mut self) -> Result<bool, FigureError>;

    /// Draws what there is so far onto the formulas.
    fn draw(&self, formulas: &Figure, composer: &mut Composer, told: &mut Told);

    /// How it is computed, and what is known of the error.
    fn method(&self) -> (&'static str, ErrorEstimate);
}

/// A figure of formulas with its exact part in the making.
pub(super) struct Beside {
    formulas: Figure,
    part: Box<dyn Part>,
    /// The first slice does nothing: the formulas are not kept waiting.
    begun: bool,
    refused: Option<String>,
}

impl Beside {
    pub(super) fn new(formulas: Figure, part: Box<dyn Part>) -> Self {
        Self { formulas, part, begun: false, refused: None }
    }
}

impl Slices for Beside {
    fn advance(&mut self) -> Result<bool, FigureError> {
        if !self.begun {
            self.begun = true;
            return Ok(false);
        }
        match self.part.advance() {
            Ok(done) => Ok(done),
            Err(error) => {
                self.refused = Some(format!("The exact answer is not complete: {error}."));
                Ok(true)
            }
        }
    }

    fn figure(&self, _: &'static str, _: &Parameters) -> Figure {
        let mut figure = self.formulas.clone();
        let mut composer = Composer::on(figure.drawing);
        let mut told = Told::default();
        self.part.draw(&self.formulas, &mut composer, &mut told);
        figure.drawing = composer.drawing();
        told.onto(&mut figure);
        figure.notes.extend(self.refused.clone());
        let (method, error) = self.part.method();
        figure.method.push_str(method);
        figure.error = error;
        figure
    }
}

/// The system that the formulas speak of: without loads, with this cubic stiffness on both sides.
pub(super) fn unloaded(parameters: &Parameters, alpha: f64) -> Parameters {
    Parameters {
        alpha_p: alpha,
        alpha_g: alpha,
        regime: Regime::Homogeneous,
        load: 0.0,
        load_p: 0.0,
        load_g: 0.0,
        error: 0.0,
        ..*parameters
    }
}

/// The exact edges of a tongue as places on the axis of `Omega_1`, with what the study says of them; none where the
/// tongue is closed, or without pulsation.
///
/// # Errors
/// Those of [`tongue_edges`].
pub(super) fn edges_on_axis(
    p: &Parameters,
    tongue: Tongue,
    omega_0: f64,
) -> Result<(Option<[f64; 2]>, TongueEdges), StudyError> {
    let edges = tongue_edges(p, tongue, EDGES)?;
    let place = |omega: f64| (omega - omega_0) / p.k0;
    let both = edges.left.zip(edges.right).map(|(left, right)| [place(left), place(right)]);
    Ok((both.filter(|[left, right]| left.is_finite() && right.is_finite()), edges))
}

/// What a figure tells in words, and the distances of theory from exact among it as numbers.
#[derive(Clone, Debug, Default)]
pub(super) struct Told {
    pub(super) notes: Vec<String>,
    pub(super) distances: Vec<Distance>,
}

impl Told {
    /// Adds it to what a figure tells.
    pub(super) fn onto(self, figure: &mut Figure) {
        figure.notes.extend(self.notes);
        figure.distances.extend(self.distances);
    }

    /// The distance of symmetric edges by formula from the exact ones.
    pub(super) fn edges_apart(&mut self, what: &str, formula: f64, [left, right]: [f64; 2]) {
        self.notes.push(format!(
            "Exact edges at Omega_1 = {} and {}; the formula {what} is off by {} and {}.",
            number(left, 6),
            number(right, 6),
            number(-formula - left, 2),
            number(formula - right, 2)
        ));
        let what = what.trim_end_matches(',');
        for (side, theory, exact) in [("left", -formula, left), ("right", formula, right)] {
            self.distances.push(Distance {
                what: format!("Omega_1 of the {side} edge, {what}"),
                at: None,
                theory,
                exact,
            });
        }
    }

    /// Where a branch by formula and the exact one are furthest apart, from [`farthest`].
    pub(super) fn apart(&mut self, which: &str, axis: &'static str, [x, theory, exact]: [f64; 3]) {
        let words = format!(
            "Furthest apart at {axis} = {}: the formula says R = {}, the exact motion has {}, a distance of {}.",
            number(x, 4),
            number(theory, 4),
            number(exact, 5),
            number(theory - exact, 2)
        );
        self.notes.push(if which.is_empty() { words } else { format!("{which}: {words}") });
        let what = if which.is_empty() {
            "R where furthest apart".into()
        } else {
            format!("R, {which}, where furthest apart")
        };
        self.distances.push(Distance { what, at: Some((axis, x)), theory, exact });
    }

    /// The greatest growth rate by formula and exactly.
    pub(super) fn greatest_growth(&mut self, theory: f64, exact: f64) {
        self.notes.push(format!(
            "Greatest growth rate: {} by the formula, {} exactly, a distance of {}.",
            number(theory, 5),
            number(exact, 5),
            number(theory - exact, 2)
        ));
        self.distances.push(Distance { what: "greatest growth rate".into(), at: None, theory, exact });
    }
}

/// Where curves of formulas and the exact height are furthest apart: the place, the formula's height, the exact one.
pub(super) fn farthest<'a>(
    curves: impl Iterator<Item = &'a Series>,
    exact: &dyn Fn(f64) -> Option<f64>,
) -> Option<[f64; 3]> {
    let mut farthest: Option<[f64; 3]> = None;
    for (x, height) in curves.flat_map(|curve| curve.x.iter().zip(&curve.y)) {
        let Some(exact) = exact(*x).filter(|_| *height >= 0.0) else { continue };
        if farthest.is_none_or(|[_, one, other]| (height - exact).abs() > (one - other).abs()) {
            farthest = Some([*x, *height, exact]);
        }
    }
    farthest
}

/// A modal coordinate of a state, as the paper scales it: `u_p - u_g = -4 (q_2 + q_3)`, `u = a q_2 + b q_3`.
pub(super) fn modal(modes: &Modes, mode: Mode, state: &[f64; 6]) -> f64 {
    let (own, other) = (modes.coefficient(mode), modes.coefficient(mode.partner()));
    (state[2] - 0.25 * other * (state[1] - state[0])) / (own - other)
}
