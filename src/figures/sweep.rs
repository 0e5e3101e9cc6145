//! Figure S: where motions end up as the mesh frequency is raised, and as it is lowered again.

use super::compose::{Composer, Line, Points, axis, number, plane};
use super::job::{Figure, Slices};
use super::tongue_range::range;
use crate::chart::drawing::{Drawing, Mark, Role};
use crate::error::FigureError;
use crate::model::parameters::{Parameters, Regime};
use crate::order;
use crate::study::ErrorEstimate;
use crate::study::grid::Grid;
use crate::study::sweep::{Direction, Sweep, SweepOptions, SweepWork};
use std::collections::BTreeSet;

/// Mesh frequencies of a sweep.
const FREQUENCIES: usize = 260;
/// Mesh periods left out at each, and points taken.
const TRANSIENT: usize = 160;
const POINTS: usize = 40;
/// Most times that a sweep begins anew from near rest after a motion has escaped.
const MOST_ESCAPES: usize = 24;
/// Tolerance of the integration.
const TOLERANCE: f64 = 1e-8;
/// The start: small, on the manifold `u_g = -u_p`, and a little off it, so that nothing is hidden by symmetry.
const START: [f64; 6] = [-0.02, 0.021, 0.05, 0.0, 0.0, 0.0];
/// A point nearer to the other sweep's points of the same frequency than this part of the largest is the same motion.
const SAME: f64 = 0.02;

/// One direction: a sweep and, after escapes, its successors.
#[derive(Debug)]
struct Way {
    direction: Direction,
    omega: Grid,
    /// The sweep that runs.
    work: SweepWork,
    done: Vec<Sweep>,
    finished: bool,
}

impl Way {
    fn new(p: &Parameters, omega: Grid, direction: Direction) -> Result<Self, FigureError> {
        let work = Self::begin(p, omega, direction)?;
        Ok(Self { direction, omega, work, done: Vec::new(), finished: false })
    }

    fn begin(p: &Parameters, omega: Grid, direction: Direction) -> Result<SweepWork, FigureError> {
        let options = SweepOptions {
            direction,
            transient: TRANSIENT,
            points: POINTS,
            // Under load rest is no motion: each sweep finds its own.
            state: (p.regime == Regime::Homogeneous).then_some(START),
            tolerance: TOLERANCE,
            ..SweepOptions::new(omega)
        };
        Ok(SweepWork::new(p, &options)?)
    }

    fn advance(&mut self, p: &Parameters) -> Result<(), FigureError> {
        if self.finished || !self.work.advance()? {
            return Ok(());
        }
        let sweep = self.work.sweep().clone();
        let rest = sweep.escaped.and_then(|escaped| self.beyond(escaped));
        self.done.push(sweep);
        match rest {
            Some(rest) if self.done.len() <= MOST_ESCAPES => {
                self.work = Self::begin(p, rest, self.direction)?;
            }
            _ => self.finished = true,
        }
        Ok(())
    }

    /// The frequencies after the one at which a motion escaped.
    fn beyond(&self, escaped: f64) -> Option<Grid> {
        let step = (self.omega.high - self.omega.low) / (self.omega.count - 1) as f64;
        let (low, high) = match self.direction {
            Direction::Up => (escaped + step, self.omega.high),
            Direction::Down => (self.omega.low, escaped - step),
        };
        let count = ((high - low) / step).round() as usize + 1;
        (high - low > 0.5 * step && count > 1).then_some(Grid { low, high, count })
    }

    /// Every sweep of this direction, the running one last.
    fn sweeps(&self) -> impl Iterator<Item = &Sweep> {
        self.done.iter().chain((!self.finished).then(|| self.work.sweep()))
    }

    /// The points, those that would be drawn over one another only once.
    fn drawn(&self, reach: f64) -> Points {
        let mut seen = BTreeSet::new();
        let mut points = Points::default();
        let cell = reach / 300.0;
        points.cloud(
            self.points().filter(|(omega, u_p)| seen.insert((omega.to_bits(), (u_p / cell).round() as i64))),
        );
        points
    }

    fn points(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        self.sweeps().flat_map(|sweep| sweep.omega.iter().copied().zip(sweep.u_p.iter().copied()))
    }

    fn escapes(&self) -> Vec<f64> {
        self.sweeps().filter_map(|sweep| sweep.escaped).collect()
    }
}

/// The work on figure S, done in slices.
#[derive(Debug)]
pub(super) struct Sweeps {
    parameters: Parameters,
    range: (f64, f64),
    ways: [Way; 2],
}

impl Sweeps {
    /// # Errors
    /// Loads whose frequencies have no common period with the mesh.
    pub(super) fn new(parameters: &Parameters) -> Result<Self, FigureError> {
        let range = range(parameters);
        let omega = Grid { low: range.0, high: range.1, count: FREQUENCIES };
        let up = Way::new(parameters, omega, Direction::Up)?;
        let down = Way::new(parameters, omega, Direction::Down)?;
        Ok(Self { parameters: *parameters, range, ways: [up, down] })
    }

    /// Half the height of the frame: what nearly all points need. A few wild ones may lie outside of it.
    fn reach(&self) -> f64 {
        let mut all: Vec<f64> = self.ways.iter().flat_map(Way::points).map(|(_, u_p)| u_p.abs()).collect();
        order::ascending(&mut all);
        let most = all.last().copied().unwrap_or(0.0);
        let nearly = all.get(all.len() * 99 / 100).copied().unwrap_or(0.0);
        let reach = most.min(1.5 * nearly.max(0.1 * most));
        if reach > 1e-6 { 1.1 * reach } else { 1.0 }
    }

    fn greatest(&self) -> f64 {
        self.ways.iter().flat_map(Way::points).fold(0.0, |most, (_, u_p)| u_p.abs().max(most))
    }

    fn drawing(&self) -> Drawing {
        let reach = self.reach();
        let mut composer = Composer::new((1, 1));
        let frame = composer.frame(plane(
            "sweep",
            "",
            (0, 0),
            axis("Omega", "*Ω*", self.range),
            axis("u_p", "*u*_{p}", (-reach, reach)),
        ));
        for (way, name, meaning, role, label, at) in [
            (
                &self.ways[0],
                "up",
                "stroboscopic points as Omega rises",
                Role::Attractor,
                "*Ω* rising →",
                0.75,
            ),
            (
                &self.ways[1],
                "down",
                "stroboscopic points as Omega falls",
                Role::Downward,
                "← *Ω* falling",
                0.4,
            ),
        ] {
            composer.add(frame, Mark::Cloud, Line::new(name, meaning, role), way.drawn(reach));
            // A label needs a place where the motion is large enough to be seen.
            let large: Vec<(f64, f64)> =
                way.points().filter(|point| point.1 > 0.2 * reach && point.1 < reach).collect();
            if let Some(place) = large.get((at * large.len() as f64) as usize) {
                let line = Line::new(format!("{name} label"), meaning, role).label(label, 0.0);
                composer.marks(frame, line, Points::one(*place));
            }
            let mut crosses = Points::default();
            crosses.cloud(way.escapes().into_iter().map(|omega| (omega, 0.0)));
            let told = format!("escapes as Omega {}", if name == "up" { "rises" } else { "falls" });
            let line = Line::new(format!("escape {name}"), told, Role::Event).label("escape", 0.0);
            composer.marks(frame, line, crosses);
        }
        composer.drawing()
    }

    /// Ranges of the mesh frequency in which the two ways differ.
    fn differing(&self) -> Vec<(f64, f64)> {
        let largest = |way: &Way| {
            let mut found: Vec<(f64, f64)> = Vec::new();
            for (omega, u_p) in way.points() {
                match found.iter_mut().find(|(known, _)| *known == omega) {
                    Some((_, most)) => *most = most.max(u_p.abs()),
                    None => found.push((omega, u_p.abs())),
                }
            }
            found
        };
        let (up, down) = (largest(&self.ways[0]), largest(&self.ways[1]));
        let same = SAME * self.reach();
        let step = (self.range.1 - self.range.0) / (FREQUENCIES - 1) as f64;
        let mut ranges: Vec<(f64, f64)> = Vec::new();
        let mut seen: Vec<f64> = up
            .iter()
            .filter(|(omega, most)| {
                let other = down.iter().find(|(other, _)| (other - omega).abs() < 0.01 * step);
                other.is_some_and(|(_, other)| (other - most).abs() > same)
            })
            .map(|(omega, _)| *omega)
            .collect();
        order::ascending(&mut seen);
        for omega in seen {
            match ranges.last_mut() {
                Some(last) if omega - last.1 < 1.5 * step => last.1 = omega,
                _ => ranges.push((omega, omega)),
            }
        }
        ranges.retain(|(low, high)| high - low > 1.5 * step);
        ranges
    }

    fn summary(&self) -> String {
        let ranges = self.differing();
        let told: Vec<String> =
            ranges.iter().map(|(low, high)| format!("{} to {}", number(*low, 4), number(*high, 4))).collect();
        let greatest = number(self.greatest(), 4);
        if told.is_empty() {
            return format!(
                "Raised and lowered, Omega leads through the same motions, with |u_p| up to {greatest}."
            );
        }
        format!(
            "What the pair does depends on where it comes from for Omega from {}: two motions, chosen by history; \
             |u_p| reaches {greatest}.",
            told.join(", and from ")
        )
    }
}

impl Slices for Sweeps {
    fn advance(&mut self) -> Result<bool, FigureError> {
        // In turn: both directions are seen from the start.
        let next = usize::from(self.ways[1].points().count() < self.ways[0].points().count());
        let next = if self.ways[next].finished { 1 - next } else { next };
        self.ways[next].advance(&self.parameters)?;
        Ok(self.ways.iter().all(|way| way.finished))
    }

    fn figure(&self, id: &'static str, parameters: &Parameters) -> Figure {
        let mut notes = Vec::new();
        for (way, word) in self.ways.iter().zip(["rises", "falls"]) {
            if !way.finished {
                notes.push(format!("{} points so far as Omega {word}.", way.points().count()));
            }
            if let [first, ..] = way.escapes().as_slice() {
                notes.push(format!(
                    "As Omega {word} a motion escapes at {}; the sweep then goes on from near rest.",
                    number(*first, 5)
                ));
            }
        }
        let steps = self.ways.iter().flat_map(Way::sweeps).filter_map(|sweep| sweep.error.step);
        let error = ErrorEstimate { step: steps.reduce(f64::max), ..ErrorEstimate::default() };
        Figure {
            summary: self.summary(),
            method: format!(
                "Taylor series; {TRANSIENT} mesh periods left out at each of {FREQUENCIES} frequencies, then {POINTS} points, \
                 the state carried over"
            ),
            error,
            notes,
            ..Figure::drawn(id, parameters, self.drawing())
        }
    }
}
