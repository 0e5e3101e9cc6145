//! Figure T of a loaded pair with cubic supports: where its periodic response is unstable, filled in from coarse to fine.

use super::compose::{Composer, Line, Points, number};
use super::job::{Fact, Figure, Slices};
use super::stability::{Found, at_rest, boundary_lines, first_order, growth_frame, named_boundaries};
use super::tongue_range::range;
use super::tongues::Setting;
use crate::chart::drawing::{Drawing, Mark, Role};
use crate::error::{FigureError, StudyError};
use crate::model::parameters::{Parameters, Regime};
use crate::study::ErrorEstimate;
use crate::study::chart_work::ChartWork;
use crate::study::grid::Grid;
use crate::study::multipliers::{Multipliers, common_period, multipliers, unloaded};
use crate::study::stability_chart::StabilityChart;

/// Columns and rows of the field: each point may need an orbit of its own.
const COLUMNS: usize = 121;
const ROWS: usize = 61;
/// Tolerance of the field's spectral radius.
const TOLERANCE: f64 = 1e-6;

/// Whether the response to the load has a stability of its own: a pair that is linear where the teeth touch has that of
/// rest, and loads without a common period have no periodic response.
pub(super) fn applies(p: &Parameters) -> bool {
    let cubic = p.alpha_p != 0.0 || p.alpha_g != 0.0;
    let own = match p.regime {
        Regime::Homogeneous => false,
        Regime::Contact => cubic,
        Regime::Backlash => true,
    };
    own && !unloaded(p) && common_period(p).is_ok()
}

/// The work on the figure, done in slices.
#[derive(Debug)]
pub(super) struct LoadedTongues {
    parameters: Parameters,
    work: ChartWork,
    /// Which part of how many, counted from 0: every so many columns, from that one on.
    part: (usize, usize),
    /// The exact boundaries at rest, which the load moves: none before they are asked for.
    at_rest: Vec<Found>,
    /// None: not asked for yet.
    here: Option<Result<Multipliers, StudyError>>,
}

impl LoadedTongues {
    /// # Errors
    /// As [`ChartWork::new`].
    pub(super) fn new(parameters: &Parameters) -> Result<Self, FigureError> {
        Self::part(parameters, (0, 1))
    }

    fn part(parameters: &Parameters, part: (usize, usize)) -> Result<Self, FigureError> {
        let p = parameters;
        let (low, high) = range(p);
        let omega = Grid { low: 0.5 * low, high, count: COLUMNS };
        let k0 = Grid { low: 0.0, high: 1.0, count: ROWS };
        Ok(Self {
            parameters: *p,
            work: ChartWork::new(p, omega, k0, TOLERANCE, Some(part))?,
            part,
            at_rest: Vec::new(),
            here: None,
        })
    }

    fn drawing(&self, chart: &StabilityChart) -> Drawing {
        let p = &self.parameters;
        let periods = common_period(p).unwrap_or(1) as f64;
        let mut composer = Composer::new((1, 1));
        let omegas: Vec<f64> = (0..chart.omega.count).map(|column| chart.omega.value(column)).collect();
        let depths: Vec<f64> = (0..chart.k0.count).map(|row| chart.k0.value(row)).collect();
        let rate = |index: usize| {
            let column = index % COLUMNS;
            // What others compute looks like its neighbours until it is here.
            let radius = chart.spectral_radius[index - column + self.own(column)];
            // Where there is no response there is nothing that could grow from it; the place is marked.
            let rate = radius.ln() * omegas[column] / (periods * std::f64::consts::TAU);
            if rate.is_finite() { rate } else { 0.0 }
        };
        let rates: Vec<f64> = (0..chart.spectral_radius.len()).map(rate).collect();
        let frame = growth_frame(&mut composer, chart, &rates);
        let missing: Vec<(f64, f64)> = chart
            .spectral_radius
            .iter()
            .enumerate()
            .filter(|(index, radius)| self.own(index % COLUMNS) == index % COLUMNS && !radius.is_finite())
            .map(|(index, _)| (omegas[index % omegas.len()], depths[index / omegas.len()]))
            .collect();
        let field = Line::new("growth", "growth rate about the response to the load", Role::Growth);
        composer.field(frame, field, omegas, depths, rates);
        if self.work.done() >= 1.0 && !missing.is_empty() {
            let mut points = Points::default();
            points.cloud(missing);
            let line =
                Line::new("no response", "no periodic response that grows with the load", Role::Reference);
            composer.add(frame, Mark::Cloud, line.label("no response", 0.5), points);
        }
        if let Ok(setting) = Setting::of(p) {
            first_order(&mut composer, frame, &setting);
        }
        for found in &self.at_rest {
            boundary_lines(&mut composer, frame, found, &mut Vec::new(), &|_| {
                (Role::Reference, "exact, at rest")
            });
        }
        let word = match &self.here {
            Some(Ok(here)) if here.stable => "stable",
            Some(Ok(_)) => "unstable",
            _ => "no response",
        };
        let meaning = format!("the present Omega and k0: {word}");
        let line = Line::new("present", meaning, Role::Handle).label(word, 0.0);
        composer.marks(frame, line, Points::one((p.omega, p.k0)));
        composer.drawing()
    }

    /// The nearest of the columns that are computed here.
    fn own(&self, column: usize) -> usize {
        let (part, parts) = self.part;
        let below = column.saturating_sub(part) / parts * parts + part;
        let above = below + parts;
        if column > below && above < COLUMNS && above - column < column - below { above } else { below }
    }

    fn summary(&self) -> String {
        let p = &self.parameters;
        let place = format!("At Omega = {}, k0 = {}", number(p.omega, 6), number(p.k0, 4));
        match &self.here {
            Some(Ok(here)) => {
                let growth = growth(p, here);
                format!(
                    "{place} the response to the load is {}: the largest multiplier has magnitude {}, a deviation {} at the rate {}.",
                    if here.stable { "stable" } else { "unstable" },
                    number(here.spectral_radius, 7),
                    if growth > 0.0 { "grows" } else { "decays" },
                    number(growth.abs(), 3)
                )
            }
            _ => format!("{place} no periodic response was found that the load leads to."),
        }
    }
}

fn growth(p: &Parameters, here: &Multipliers) -> f64 {
    here.spectral_radius.ln() / (common_period(p).unwrap_or(1) as f64 * p.mesh_period())
}

impl Slices for LoadedTongues {
    fn advance(&mut self) -> Result<bool, FigureError> {
        if self.here.is_none() {
            self.here = Some(multipliers(&self.parameters, 1e-10));
            // What cannot be followed is left out: the field is what is asked for.
            self.at_rest = named_boundaries(&at_rest(&self.parameters), [0.0, 1.0], &mut Vec::new());
            return Ok(false);
        }
        Ok(self.work.advance()?)
    }

    fn divide(&mut self, part: usize, parts: usize) -> Result<bool, FigureError> {
        *self = Self::part(&self.parameters, (part, parts))?;
        Ok(true)
    }

    fn figure(&self, id: &'static str, parameters: &Parameters) -> Figure {
        let chart = self.work.chart();
        let mut notes = vec![
            "Under this load it is the periodic response whose stability is asked; formulas and thin lines are those of rest."
                .to_owned(),
        ];
        let done = self.work.done();
        if done < 1.0 {
            notes.push(format!("{} per cent of the field computed so far.", number(100.0 * done, 2)));
        } else {
            notes.push(format!("The field's spectral radius is right to {}.", number(chart.error, 1)));
        }
        let here = self.here.as_ref().and_then(|here| here.as_ref().ok());
        let facts = here.map_or_else(Vec::new, |here| {
            vec![
                ("stable", Fact::Truth(here.stable)),
                ("spectralRadius", Fact::Number(here.spectral_radius)),
                ("growth", Fact::Number(growth(&self.parameters, here))),
            ]
        });
        let found = here.map(|here| here.error).unwrap_or_default();
        Figure {
            summary: self.summary(),
            method: format!("field: {}", chart.method),
            error: ErrorEstimate { step: Some(found.step.unwrap_or(0.0).max(chart.error)), ..found },
            notes,
            facts,
            ..Figure::drawn(id, parameters, self.drawing(&chart))
        }
    }
}
