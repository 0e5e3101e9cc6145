//! The exact tori beside the limit cycles of figure 7.

use super::beside::{Part, Told, edges_on_axis, farthest, modal, unloaded};
use super::compose::{Composer, Line, Points, crowded};
use super::job::Figure;
use super::tongues::{Setting, Supports, split};
use crate::chart::drawing::Role;
use crate::error::FigureError;
use crate::model::parameters::Parameters;
use crate::study::ErrorEstimate;
use crate::study::motion::sampled;
use crate::study::sweep::at_frequency;
use crate::study::tongue::Tongue;
use crate::study::torus::{Torus, TorusWork};
use crate::theory::combination::emanating_frequency;
use crate::theory::damped::combination_half_width;
use crate::theory::modes::Mode;

/// Tolerance of the tori.
const TOLERANCE: f64 = 1e-7;
/// Tori of each kind of supports.
const TORI: usize = 6;
/// How far they reach from the edge they are born at, in widths of the tongue: within it starts near rest come to them.
const REACH: f64 = 0.96;
/// Of the points on a torus every so manyeth is followed for a mesh period, in so many samples.
const SPARSE: usize = 8;
const SAMPLES: usize = 8;

/// A torus: place on the axis, both radii, stability.
#[derive(Clone, Copy, Debug)]
struct Found {
    omega_1: f64,
    radii: [f64; 2],
    stable: bool,
}

/// The work on the exact part of figure 7.
#[derive(Debug)]
pub(super) struct Cycles {
    setting: Setting,
    parameters: Parameters,
    omega_0: f64,
    /// The exact edges, once they are known.
    edges: Option<[f64; 2]>,
    /// What is to come, the next at the end.
    waiting: Option<Vec<(Supports, f64)>>,
    /// The torus that is being looked for, and where.
    search: Option<(Supports, f64, TorusWork)>,
    found: Vec<(Supports, Found)>,
    error: ErrorEstimate,
}

impl Cycles {
    /// # Errors
    /// Unequal supports.
    pub(super) fn new(parameters: &Parameters) -> Result<Self, FigureError> {
        let setting = Setting::of(parameters)?;
        Ok(Self {
            setting,
            parameters: unloaded(parameters, setting.symmetric.alpha.abs()),
            omega_0: emanating_frequency(&setting.modes),
            edges: None,
            waiting: None,
            search: None,
            found: Vec::new(),
            error: ErrorEstimate::default(),
        })
    }

    /// The edges, and where tori are looked for.
    fn begin(&mut self) -> Result<Vec<(Supports, f64)>, FigureError> {
        if self.setting.paper_alpha().is_none() {
            return Ok(Vec::new());
        }
        let (edges, answer) = edges_on_axis(&self.parameters, Tongue::Combination, self.omega_0)?;
        (self.edges, self.error) = (edges, answer.error);
        let Some([left, right]) = edges else { return Ok(Vec::new()) };
        let mut all = Vec::new();
        for supports in Supports::BOTH {
            let (birth, other) = if supports.sign() > 0.0 { (left, right) } else { (right, left) };
            let places = crowded(birth, birth + REACH * (other - birth), TORI + 1).skip(1);
            all.extend(places.map(|place| (supports, place)));
        }
        all.reverse();
        Ok(all)
    }

    /// The parameters at one place.
    fn parameters_at(&self, supports: Supports, omega_1: f64) -> Parameters {
        let omega = self.omega_0 + self.parameters.k0 * omega_1;
        let alpha = supports.sign() * self.parameters.alpha_p;
        at_frequency(&unloaded(&self.parameters, alpha), omega)
    }

    /// Radii of the torus at one place.
    fn measured(&self, torus: &Torus, supports: Supports, omega_1: f64) -> Result<Found, FigureError> {
        let p = self.parameters_at(supports, omega_1);
        let (mut sums, mut count) = ([0.0; 2], 0.0);
        for state in torus.curve.iter().step_by(SPARSE) {
            sampled(&p, *state, 1.0, SAMPLES, &mut |_, state| {
                for (sum, mode) in sums.iter_mut().zip(Mode::BOTH) {
                    *sum += modal(&self.setting.modes, mode, state).powi(2);
                }
                count += 1.0;
            })?;
        }
        let radii = sums.map(|sum: f64| (2.0 * sum / count).sqrt());
        Ok(Found { omega_1, radii, stable: torus.stable })
    }

    /// The exact radius of one mode between the computed ones, and zero at the edge.
    fn radius(&self, supports: Supports, mode: usize, x: f64) -> Option<f64> {
        let line = self.line(supports, mode);
        let pair = line.windows(2).find(|pair| (pair[0].0 - x) * (pair[1].0 - x) <= 0.0)?;
        let (one, other) = (pair[0], pair[1]);
        // Radii leave the edge like a square root: their squares are interpolated.
        let part = (x - one.0) / (other.0 - one.0);
        Some((one.1 * one.1 + part * (other.1 * other.1 - one.1 * one.1)).max(0.0).sqrt())
    }

    /// Places and radii of one mode, from the edge.
    fn line(&self, supports: Supports, mode: usize) -> Vec<(f64, f64)> {
        let found = self.found.iter().filter(|(of, _)| *of == supports);
        let mut line: Vec<(f64, f64)> = found.map(|(_, found)| (found.omega_1, found.radii[mode])).collect();
        if let (Some([left, right]), false) = (self.edges, line.is_empty()) {
            line.insert(0, (if supports.sign() > 0.0 { left } else { right }, 0.0));
        }
        line
    }
}

impl Part for Cycles {
    fn advance(&mut self) -> Result<bool, FigureError> {
        let Some(waiting) = &mut self.waiting else {
            self.waiting = Some(Vec::new());
            self.waiting = Some(self.begin()?);
            return Ok(false);
        };
        let Some((supports, omega_1, search)) = &mut self.search else {
            let Some((supports, omega_1)) = waiting.pop() else { return Ok(true) };
            let search = TorusWork::new(&self.parameters_at(supports, omega_1), TOLERANCE)?;
            self.search = Some((supports, omega_1, search));
            return Ok(false);
        };
        let (supports, omega_1) = (*supports, *omega_1);
        let Some(answer) = search.advance() else { return Ok(false) };
        self.search = None;
        if let Ok(torus) = answer {
            self.error = self.error.worse(torus.error);
            let found = self.measured(&torus, supports, omega_1)?;
            self.found.push((supports, found));
        } else if let Some(waiting) = &mut self.waiting {
            // The line ends here: further from its birth every search would be long, and in vain.
            waiting.retain(|(of, _)| *of != supports);
        }
        Ok(self.waiting.as_ref().is_none_or(Vec::is_empty))
    }

    fn draw(&self, formulas: &Figure, composer: &mut Composer, told: &mut Told) {
        let damped = combination_half_width(&self.setting.modes, &self.setting.symmetric);
        if let (Some(edges), Some(damped)) = (self.edges, damped) {
            told.edges_apart("[T6]", damped / self.parameters.k0, edges);
        }
        if let Some(left) = self.waiting.as_ref().map(Vec::len).filter(|left| *left > 0) {
            told.notes.push(format!("{left} exact tori to go."));
        }
        for supports in Supports::BOTH {
            let name = supports.name();
            let wanted = format!("{name}-plane");
            let Some(flat) = formulas.drawing.frames.iter().position(|frame| frame.name == wanted) else {
                continue;
            };
            if let Some([left, right]) = self.edges {
                let line = Line::new(
                    format!("exact edges {name}"),
                    "exact edges of the tongue: torus bifurcations",
                    Role::TorusBifurcation,
                );
                composer.marks(flat, line.label("exact", 0.0), Points::plane([(left, 0.0), (right, 0.0)]));
            }
            for (mode, letter) in ["B", "C"].into_iter().enumerate() {
                let meaning =
                    format!("exact tori, root mean square of the mode of R_{letter}, {name} supports");
                let all = self.line(supports, mode);
                // At the edge itself the torus is as its neighbour.
                let kinds: Vec<bool> = self
                    .found
                    .iter()
                    .filter(|(of, _)| *of == supports)
                    .map(|(_, found)| found.stable)
                    .collect();
                let parts = split(&all, |at| kinds[at.saturating_sub(1)]);
                for (points, (stable, word)) in parts.into_iter().zip([(true, "stable"), (false, "unstable")])
                {
                    let name = format!("exact R_{letter} {name} {word}");
                    let line = Line::new(name, meaning.clone(), Role::QuasiPeriodic).stable(stable);
                    composer.curve(flat, line.label(&format!("exact *R*_{{{letter}}}"), 0.8), points);
                }
                let wanted = format!("R_{letter} {name} stable");
                let curve = formulas.drawing.series.iter().filter(|series| series.name == wanted);
                if let Some(found) = farthest(curve, &|x| self.radius(supports, mode, x)) {
                    told.apart(&format!("R_{letter}, {name}"), "Omega_1", found);
                }
            }
        }
    }

    fn method(&self) -> (&'static str, ErrorEstimate) {
        (
            "; exact: tori by collocation of the stroboscopic map, radii as square root of twice the mean square of each \
             modal coordinate",
            self.error,
        )
    }
}
