//! Figure L: the least load that keeps the teeth in contact, over the mesh frequency, and the margin at the present one.

use super::compose::{Composer, Line, Points, axis, even, number, plane};
use super::job::{Figure, Slices};
use super::tongue_range::range;
use crate::chart::drawing::{Drawing, Mark, Role};
use crate::error::FigureError;
use crate::model::parameters::{Parameters, Regime};
use crate::order;
use crate::study::ErrorEstimate;
use crate::study::contact::{ContactMargin, contact_margin, least_load};
use crate::study::sweep::at_frequency;
use crate::study::time_response::{TimeResponse, TimeResponseOptions, time_response};

/// Mesh frequencies at which the least load is computed.
const FREQUENCIES: usize = 110;
/// Tolerance of the responses.
const TOLERANCE: f64 = 1e-8;
/// Rows a period of the motion that is shown.
const SAMPLES: usize = 160;
/// Highest load drawn, over the median of all.
const HIGHEST: f64 = 6.0;

/// What was found at one mesh frequency.
#[derive(Clone, Copy, Debug)]
struct Sample {
    omega: f64,
    load: Option<f64>,
    /// Contact alone, whether the response is stable or not.
    contact: Option<f64>,
}

/// The work on figure L, done in slices.
#[derive(Debug)]
pub(super) struct Loads {
    parameters: Parameters,
    range: (f64, f64),
    waiting: Vec<f64>,
    samples: Vec<Sample>,
    here: Option<Result<(ContactMargin, TimeResponse), String>>,
}

impl Loads {
    pub(super) fn new(parameters: &Parameters) -> Self {
        let (low, high) = range(parameters);
        let range = (low.min(0.9 * parameters.omega), high.max(1.1 * parameters.omega));
        // In an order that shows the whole early: every eighth, then those between.
        let all: Vec<f64> = even(range.0, range.1, FREQUENCIES).collect();
        let mut waiting: Vec<f64> = [0, 4, 2, 6, 1, 3, 5, 7]
            .iter()
            .flat_map(|first| all.iter().skip(*first).step_by(8).copied())
            .collect();
        waiting.reverse();
        let parameters = match parameters.regime {
            // There is no load in it, and no teeth: the question is asked of permanent contact.
            Regime::Homogeneous => Parameters { regime: Regime::Contact, ..*parameters },
            _ => *parameters,
        };
        Self { parameters, range, waiting, samples: Vec::new(), here: None }
    }

    fn here(&self) -> Result<(ContactMargin, TimeResponse), FigureError> {
        let p = Parameters { regime: Regime::Contact, ..self.parameters };
        let margin = contact_margin(&p, None, TOLERANCE)?;
        let options = TimeResponseOptions {
            state: margin.state,
            periods: margin.period as f64,
            samples_per_period: SAMPLES,
            tolerance: TOLERANCE,
        };
        let motion = time_response(&p, &options)?;
        Ok((margin, motion))
    }

    fn drawing(&self) -> Drawing {
        let mut composer = Composer::new((2, 1));
        self.loads(&mut composer);
        self.motion(&mut composer);
        composer.drawing()
    }

    fn loads(&self, composer: &mut Composer) {
        let mut samples = self.samples.clone();
        order::by_number(&mut samples, |sample| sample.omega);
        let mut all: Vec<f64> = samples.iter().filter_map(|sample| sample.load).collect();
        order::ascending(&mut all);
        let median = all.get(all.len() / 2).copied().unwrap_or(1.0);
        let most = all.last().copied().unwrap_or(1.0);
        let top = 1.15 * most.min(HIGHEST * median).max(1.2 * self.parameters.load).max(1e-3);
        let frame = composer.frame(plane(
            "least load",
            "least *F* that keeps the teeth in contact",
            (0, 0),
            axis("Omega", "*Ω*", self.range),
            axis("F", "*F*", (0.0, top)),
        ));
        // Where no load helps is marked over the whole height, with a word.
        let step = (self.range.1 - self.range.0) / (FREQUENCIES - 1) as f64;
        let mut hopeless: Vec<(f64, f64)> = Vec::new();
        for sample in samples.iter().filter(|sample| sample.load.is_none()) {
            match hopeless.last_mut() {
                Some(last) if sample.omega - last.1 < 1.5 * step => last.1 = sample.omega,
                _ => hopeless.push((sample.omega, sample.omega)),
            }
        }
        for (index, (low, high)) in hopeless.into_iter().enumerate() {
            let line = Line::new(
                format!("none {}", index + 1),
                "no load helps: the response is unstable",
                Role::IntervalSaddle,
            );
            let corners = Points::plane([(low - 0.5 * step, 0.0), (high + 0.5 * step, top)]);
            composer.add(frame, Mark::Band, line.label("no load helps", 0.5), corners);
        }
        for (name, meaning, role, label, pick) in [
            (
                "contact",
                "least load at which the teeth would touch, stable or not",
                Role::Reference,
                "contact alone",
                (|sample: &Sample| sample.contact) as fn(&Sample) -> Option<f64>,
            ),
            (
                "load",
                "least load that keeps contact on a stable response",
                Role::Exact,
                "contact kept above",
                |sample| sample.load,
            ),
        ] {
            let mut points = Points::default();
            points.piece(samples.iter().map(|sample| (sample.omega, pick(sample).unwrap_or(f64::NAN))));
            composer.curve(frame, Line::new(name, meaning, role).label(label, 0.7), points);
        }
        let word = match &self.here {
            Some(Ok((margin, _))) if margin.margin >= 0.0 => "contact kept",
            Some(Ok(_)) => "contact lost",
            _ => "",
        };
        let line = Line::new("present", "the present Omega and F", Role::Handle).label(word, 0.0);
        composer.marks(frame, line, Points::one((self.parameters.omega, self.parameters.load)));
    }

    fn motion(&self, composer: &mut Composer) {
        let Some(Ok((margin, motion))) = &self.here else {
            let axes = (axis("t", "*t*", (0.0, 1.0)), axis("u", "*u*", (-1.0, 2.0)));
            composer.frame(plane("motion", "no periodic response here", (1, 0), axes.0, axes.1));
            return;
        };
        let u = || motion.states.iter().map(|state| state[2]);
        let (low, high) = u().fold((-1.2_f64, 1.5_f64), |(low, high), u| (low.min(u), high.max(u)));
        let end = motion.t.last().copied().unwrap_or(1.0).max(1e-9);
        let sign = if margin.margin >= 0.0 { "kept" } else { "lost" };
        let title = format!("one period: contact {sign}, margin {}", number(margin.margin, 4));
        let reach = 0.1 * (high - low);
        let frame = composer.frame(plane(
            "motion",
            &title,
            (1, 0),
            axis("t", "*t*", (0.0, end)),
            axis("u", "*u*", (low - reach, high + reach)),
        ));
        let zone = Line::new("dead zone", "dead zone: the teeth do not touch", Role::DeadZone)
            .label("dead zone", 0.5);
        composer.add(frame, Mark::Band, zone, Points::plane([(0.0, -1.0), (end, 1.0)]));
        let line = Line::new("u", "steady response in permanent contact", Role::Exact).stable(margin.stable);
        composer.curve(frame, line, Points::plane(motion.t.iter().copied().zip(u())));
        let least =
            Line::new("least", "least transmission error of the period", Role::Event).label("min *u*", 0.0);
        composer.marks(frame, least, Points::one((margin.at, margin.margin + 1.0)));
    }

    fn summary(&self) -> String {
        let here = match &self.here {
            None => return "Not computed yet.".to_owned(),
            Some(Err(error)) => format!("no periodic response was found ({error})"),
            Some(Ok((margin, _))) => format!(
                "contact is {}, with a margin of {} half-backlashes at its least",
                if margin.margin >= 0.0 { "kept" } else { "lost" },
                number(margin.margin, 5)
            ),
        };
        let p = &self.parameters;
        let nearest = self
            .samples
            .iter()
            .min_by(|one, other| (one.omega - p.omega).abs().total_cmp(&(other.omega - p.omega).abs()));
        let least = match nearest.map(|sample| sample.load) {
            Some(Some(load)) => format!("; about here F = {} would just do", number(load, 4)),
            Some(None) => "; about here no load helps".to_owned(),
            None => String::new(),
        };
        format!("At Omega = {} under F = {} {here}{least}.", number(p.omega, 5), number(p.load, 4))
    }
}

impl Slices for Loads {
    fn advance(&mut self) -> Result<bool, FigureError> {
        if self.here.is_none() {
            self.here = Some(self.here().map_err(|error| error.to_string()));
            return Ok(false);
        }
        if let Some(omega) = self.waiting.pop() {
            let p = at_frequency(&Parameters { regime: Regime::Contact, ..self.parameters }, omega);
            let found = least_load(&p, TOLERANCE).ok();
            let sample = Sample {
                omega,
                load: found.as_ref().and_then(|found| found.load),
                contact: found.as_ref().and_then(|found| found.contact_load),
            };
            self.samples.push(sample);
        }
        Ok(self.waiting.is_empty())
    }

    fn figure(&self, id: &'static str, parameters: &Parameters) -> Figure {
        let mut notes = Vec::new();
        if !self.waiting.is_empty() {
            notes.push(format!("{} mesh frequencies to go.", self.waiting.len()));
        }
        let (method, error) = match &self.here {
            Some(Ok((margin, _))) => (margin.method.clone(), margin.error),
            _ => (
                "periodic response in permanent contact, followed from a large load".to_owned(),
                ErrorEstimate::default(),
            ),
        };
        Figure {
            summary: self.summary(),
            method,
            error,
            notes,
            ..Figure::drawn(id, parameters, self.drawing())
        }
    }
}
