//! Figure B: the exact periodic and quasi-periodic motions over the mesh frequency, above the theory's branches.

use super::compose::{Composer, Line, Points, axis, even, number, plane};
use super::exact::{Exact, Spot, Style};
use super::job::{Distance, Fact, Figure, Slices};
use super::tongue_range::range;
use super::tongues::{Setting, half_parabola};
use crate::chart::drawing::{Drawing, Role};
use crate::error::FigureError;
use crate::model::parameters::Parameters;
use crate::theory::branches::{cycles, period_two};
use crate::theory::damped::{combination_edges, primary_edges};
use crate::theory::modes::Mode;
use crate::theory::{Edges, combination, primary};

/// Longest period that is followed, mesh periods.
const LONGEST: usize = 4;
/// Most branches that are followed.
const MOST: usize = 24;
/// Tori between two torus bifurcations.
const TORI: usize = 10;
/// Mesh frequencies at which theory and exact branches are compared.
const COMPARED: usize = 400;

/// A branch of the theory: name, label, stability, from its edge onwards.
struct Theory {
    name: String,
    label: Option<&'static str>,
    stable: bool,
    curve: Vec<(f64, f64)>,
}

/// The work on figure B, done in slices.
#[derive(Debug)]
pub(super) struct Branches {
    exact: Exact,
    setting: Option<Setting>,
    range: (f64, f64),
}

impl Branches {
    pub(super) fn new(parameters: &Parameters) -> Self {
        let range = range(parameters);
        let exact = Exact::new(parameters, range, LONGEST, MOST).with_tori(TORI);
        // Unequal supports have exact branches all the same; the formulas need equal ones.
        Self { exact, setting: Setting::of(parameters).ok(), range }
    }

    /// The theory's branches, as greatest `|u_p|`.
    fn theory(&self) -> Vec<Theory> {
        let Some(setting) = &self.setting else { return Vec::new() };
        let alpha = setting.symmetric.alpha;
        if alpha == 0.0 || setting.symmetric.k0 == 0.0 {
            return Vec::new();
        }
        let sign = alpha.signum();
        let (modes, symmetric) = (&setting.modes, &setting.symmetric);
        let places = [
            primary::emanating_frequency(modes, Mode::Second),
            combination::emanating_frequency(modes),
            primary::emanating_frequency(modes, Mode::Third),
        ];
        let reach = sign * 0.5 * (places[1] - places[0]);
        let mut all = Vec::new();
        let edge = |edges: &Edges, index: usize| if index == 0 { edges.left } else { edges.right };
        for (mode, place) in [(Mode::Second, places[0]), (Mode::Third, places[2])] {
            let Some(edges) = primary_edges(modes, mode, symmetric) else { continue };
            for index in 0..2 {
                let radius = |omega: f64| {
                    let orbits = period_two(&setting.at(omega), mode).ok()?;
                    orbits[index].map(|orbit| 2.0 * orbit.radius)
                };
                let curve = half_parabola(edge(&edges, index), place + reach, radius);
                let stable = (index == 0) == (sign > 0.0);
                all.push(Theory {
                    name: format!("[T7] {} {index}", mode.number()),
                    label: stable.then_some("theory [T7]"),
                    stable,
                    curve,
                });
            }
        }
        if let Some(edges) = combination_edges(modes, symmetric) {
            for index in 0..2 {
                let from = if (index == 0) == (sign > 0.0) { edges.left } else { edges.right };
                let radius = |omega: f64| {
                    let both = cycles(&setting.at(omega)).ok()?;
                    both[index].map(|cycle| 2.0 * (cycle.radius_b + cycle.radius_c))
                };
                all.push(Theory {
                    name: format!("[T8] {index}"),
                    label: (index == 0).then_some("theory [T8]"),
                    stable: index == 0,
                    curve: half_parabola(from, places[1] + reach, radius),
                });
            }
        }
        all.retain(|theory| theory.curve.len() > 2);
        all
    }

    fn drawing(&self) -> Drawing {
        let theory = self.theory();
        let highest = self.exact.highest();
        // The theory's branches go on for ever: the exact ones say how high the frame is, while there are any.
        let of_theory =
            theory.iter().flat_map(|theory| &theory.curve).fold(0.0_f64, |most, point| most.max(point.1));
        let top = if highest > 1e-6 { 1.15 * highest } else { 1.1 * of_theory.max(1e-3) };
        let mut composer = Composer::new((1, 1));
        let frame = composer.frame(plane(
            "branches",
            "",
            (0, 0),
            axis("Omega", "*Ω*", self.range),
            axis("max u_p", "max |*u*_{p}|", (-0.04 * top, top)),
        ));
        for theory in theory {
            let word = if theory.stable { "stable" } else { "unstable" };
            let meaning = format!("theory with damping, {word}: greatest |u_p|");
            let line = Line::new(theory.name, meaning, Role::CorrectedSecond).stable(theory.stable);
            let line = theory.label.map_or(line.clone(), |label| line.label(label, 0.3));
            composer.curve(frame, line, Points::plane(theory.curve));
        }
        let place = &|index: usize, spot: Spot| self.exact.by_size(index, spot);
        self.exact.draw(&mut composer, frame, &Style { name: "", place, space: false, marked: true });
        self.exact.draw_tori(&mut composer, frame, 1.0);
        composer.drawing()
    }

    /// The greatest distance between the theory's stable branches and the exact ones, with its mesh frequency and both
    /// values.
    fn farthest(&self) -> Option<(f64, f64, f64)> {
        let theory = self.theory();
        let mut farthest: Option<(f64, f64, f64)> = None;
        for omega in even(self.range.0, self.range.1, COMPARED) {
            let formula = theory.iter().filter(|theory| theory.stable).filter_map(|theory| {
                let curve = &theory.curve;
                let after =
                    (1..curve.len()).find(|&at| (curve[at - 1].0 - omega) * (curve[at].0 - omega) <= 0.0)?;
                let (one, other) = (curve[after - 1], curve[after]);
                let part = (omega - one.0) / (other.0 - one.0);
                Some(one.1 + part * (other.1 - one.1))
            });
            let pair = formula
                .reduce(f64::max)
                .zip(self.exact.stable_at(omega, &|index, spot| self.exact.by_size(index, spot)));
            if let Some((formula, exact)) = pair {
                let off = (formula - exact).abs();
                if farthest.is_none_or(|(_, a, b)| off > (a - b).abs()) {
                    farthest = Some((omega, formula, exact));
                }
            }
        }
        farthest
    }

    fn distance(&self) -> Option<Distance> {
        let (omega, theory, exact) = self.farthest()?;
        let what = "greatest |u_p| of the stable motion, where furthest apart".to_owned();
        Some(Distance { what, at: Some(("Omega", omega)), theory, exact })
    }

    fn summary(&self) -> String {
        let branches = self.exact.branches();
        let events: usize = branches.iter().map(|branch| branch.events.len()).sum();
        let told =
            format!("{} branches of periodic motions with {events} bifurcations on them", branches.len());
        match self.farthest() {
            Some((omega, formula, exact)) => format!(
                "{told}; theory and exact are furthest apart at Omega = {}, where the formula says |u_p| up to {} and the \
                 stable motion reaches {}, a distance of {}.",
                number(omega, 4),
                number(formula, 4),
                number(exact, 5),
                number(formula - exact, 3)
            ),
            None => format!("{told}."),
        }
    }
}

impl Slices for Branches {
    fn advance(&mut self) -> Result<bool, FigureError> {
        self.exact.advance()
    }

    fn figure(&self, id: &'static str, parameters: &Parameters) -> Figure {
        Figure {
            summary: self.summary(),
            method: "exact: pseudo-arclength continuation of the stroboscopic map, switching at bifurcations, tori by \
                     collocation; theory: [T7], [T8] with damping"
                .to_owned(),
            error: self.exact.error(),
            notes: self.exact.notes(),
            facts: vec![("branches", Fact::Number(self.exact.branches().len() as f64))],
            orbits: Some(self.exact.orbits()),
            distances: self.distance().into_iter().collect(),
            ..Figure::drawn(id, parameters, self.drawing())
        }
    }
}
