//! The exact Floquet exponents beside the eigenvalues of figure 6, in the slow flow's own frame.

use super::beside::{Part, Told, edges_on_axis, unloaded};
use super::compose::{Composer, Line, Points};
use super::exponents::{ExponentPaths, NO_GROWTH};
use super::job::{Figure, Slices};
use super::tongues::{Setting, split};
use crate::chart::drawing::Role;
use crate::error::FigureError;
use crate::model::parameters::Parameters;
use crate::study::ErrorEstimate;
use crate::study::tongue::Tongue;
use crate::theory::combination::{emanating_frequency, half_width};
use crate::theory::damped::combination_half_width;
use crate::theory::modes::Mode;
use crate::theory::primary;

/// Frequencies at which multipliers are computed before the edges are known.
const COARSE: usize = 61;

/// The work on the exact part of figure 6.
#[derive(Debug)]
pub(super) struct Exponents {
    parameters: Parameters,
    omega_0: f64,
    paths: Option<ExponentPaths>,
    edges: Option<[f64; 2]>,
    error: ErrorEstimate,
    begun: bool,
}

impl Exponents {
    /// # Errors
    /// Unequal supports.
    pub(super) fn new(parameters: &Parameters) -> Result<Self, FigureError> {
        let setting = Setting::of(parameters)?;
        Ok(Self {
            parameters: unloaded(parameters, setting.symmetric.alpha),
            omega_0: emanating_frequency(&setting.modes),
            paths: None,
            edges: None,
            error: ErrorEstimate::default(),
            begun: false,
        })
    }

    /// The edges, and the range of the formulas' frame for the exponents.
    fn begin(&mut self) -> Result<(), FigureError> {
        let setting = Setting::of(&self.parameters)?;
        let modes = &setting.modes;
        let k0 = self.parameters.k0;
        if k0 == 0.0 {
            return Ok(());
        }
        let reach = super::eigenvalues::reach(&setting) * k0;
        let places = [
            primary::emanating_frequency(modes, Mode::Second),
            self.omega_0,
            primary::emanating_frequency(modes, Mode::Third),
        ];
        let low = (self.omega_0 - reach).max(0.5 * self.omega_0);
        let range = (low, self.omega_0 + reach);
        self.paths = Some(ExponentPaths::over(&self.parameters, setting, places, range, COARSE));
        let (edges, answer) = edges_on_axis(&self.parameters, Tongue::Combination, self.omega_0)?;
        (self.edges, self.error) = (edges, answer.error);
        Ok(())
    }

    /// Places on the axis with the exponents of the second mode and those of the third in the turning frames of the slow
    /// flow, `(Re, Im)`.
    fn values(&self, paths: &ExponentPaths) -> Vec<(f64, [(f64, f64); 4])> {
        let slower = paths.setting.modes.omega[1] / self.omega_0 - 0.5;
        let own = |omega: f64, re: f64, im: f64| {
            // In the frame that turns with half the mesh frequency the pairs lie below and above the real axis.
            let folded = im - (im / omega).round() * omega;
            (re, folded + if folded < 0.0 { -slower } else { slower } * omega)
        };
        let tracks = paths.tracks().into_iter();
        tracks
            .map(|(omega, four)| {
                let x = (omega - self.omega_0) / self.parameters.k0;
                (x, four.map(|value| own(omega, value.re, value.im)))
            })
            .collect()
    }
}

impl Part for Exponents {
    fn advance(&mut self) -> Result<bool, FigureError> {
        if !self.begun {
            self.begun = true;
            self.begin()?;
            return Ok(self.paths.is_none());
        }
        self.paths.as_mut().map_or(Ok(true), Slices::advance)
    }

    fn draw(&self, formulas: &Figure, composer: &mut Composer, told: &mut Told) {
        let Some(paths) = &self.paths else { return };
        let values = self.values(paths);
        if values.len() < 2 {
            return;
        }
        for (name, real) in [("re", true), ("im", false)] {
            let wanted = format!("scaled-{name}");
            let Some(frame) = formulas.drawing.frames.iter().position(|frame| frame.name == wanted) else {
                continue;
            };
            let part = |value: (f64, f64)| if real { value.0 } else { value.1 };
            for index in 0..4 {
                let points: Vec<(f64, f64)> =
                    values.iter().map(|(x, four)| (*x, part(four[index]))).collect();
                let [decaying, growing] = split(&points, |at| values[at].1[index].0 <= NO_GROWTH);
                for (points, stable, word) in [(decaying, true, "decaying"), (growing, false, "growing")] {
                    let line = Line::new(
                        format!("{name} exact {} {word}", index + 1),
                        format!("exact Floquet exponent {}, {word}", index + 1),
                        Role::Exact,
                    );
                    let line = line.stable(stable);
                    let label = index == 0 && !stable && real;
                    composer.curve(frame, if label { line.label("exact", 0.5) } else { line }, points);
                }
            }
            if let Some(edges) = self.edges {
                let growing = |x: f64| {
                    let nearest =
                        values.iter().min_by(|one, other| (one.0 - x).abs().total_cmp(&(other.0 - x).abs()));
                    let four = nearest.map_or([(0.0, 0.0); 4], |near| near.1);
                    four.into_iter().filter(|value| value.0 > -1e-3).map(|value| value.1).collect::<Vec<_>>()
                };
                let places = edges.into_iter().flat_map(|x| {
                    let heights = if real { vec![0.0] } else { growing(x) };
                    heights.into_iter().map(move |height| (x, height))
                });
                let mut points = Points::default();
                points.cloud(places);
                let line = Line::new(
                    format!("exact edges {name}"),
                    "exact edges of the tongue: a pair of multipliers leaves the unit circle",
                    Role::TorusBifurcation,
                );
                composer.marks(frame, line, points);
            }
        }
        let setting = &paths.setting;
        match (self.edges, combination_half_width(&setting.modes, &setting.symmetric)) {
            (Some(edges), Some(width)) => {
                told.edges_apart("[T6]", width / self.parameters.k0, edges);
                let most = values.iter().flat_map(|(_, four)| four).fold(0.0_f64, |most, v| most.max(v.0));
                let formula = formulas
                    .drawing
                    .series
                    .iter()
                    .filter(|series| series.name.starts_with("Re damped"))
                    .flat_map(|series| &series.y)
                    .fold(0.0_f64, |most, value| most.max(*value));
                told.greatest_growth(formula, most);
            }
            (Some(edges), None) => {
                told.edges_apart("[T4], without damping,", half_width(&setting.modes), edges);
            }
            (None, _) => told.notes.push("Exactly, too, no edge was found: the tongue is closed.".to_owned()),
        }
    }

    fn method(&self) -> (&'static str, ErrorEstimate) {
        let error = self.paths.as_ref().map_or(self.error, |paths| self.error.worse(paths.error));
        ("; exact: ln(multiplier)/T of the variational flow, in the frame in which each mode turns", error)
    }
}
