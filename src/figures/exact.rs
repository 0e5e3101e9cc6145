//! Exact branches for figures over the mesh frequency: periodic orbits by the automatic diagram, tori between the
//! torus bifurcations of the steady response.

use super::compose::{Composer, Line, Points, even};
use crate::chart::drawing::{Mark, Role};
use crate::error::FigureError;
use crate::model::parameters::Parameters;
use crate::study::ErrorEstimate;
use crate::study::branch::{Branch, BranchEvent, Breaks, EventKind};
use crate::study::diagram::{Diagram, DiagramOptions, DiagramWork};
use crate::study::sweep::at_frequency;
use crate::study::torus::torus;

/// Tolerance of orbits and tori.
const TOLERANCE: f64 = 1e-9;
/// Tolerance of tori: a line is drawn through them.
const TORUS: f64 = 1e-7;
/// Tori that are computed between two torus bifurcations.
const TORI: usize = 10;

/// A torus at one mesh frequency.
#[derive(Clone, Copy, Debug)]
struct Size {
    omega: f64,
    max_u_p: f64,
    stable: bool,
}

/// The work on the exact branches, done in slices.
#[derive(Debug)]
pub(super) struct Exact {
    parameters: Parameters,
    work: Option<DiagramWork>,
    /// Mesh frequencies of tori to come.
    waiting: Option<Vec<f64>>,
    tori: Vec<Size>,
    /// Why there are no branches, where there are none.
    refused: Option<String>,
    with_tori: bool,
}

/// A place in a figure from mesh frequency and greatest `|u_p|`.
pub(super) type Place<'a> = &'a dyn Fn(f64, f64) -> (f64, f64);

impl Exact {
    /// The branches over a range of mesh frequencies; a system without any answers with none.
    pub(super) fn new(p: &Parameters, range: (f64, f64), max_period: usize, with_tori: bool) -> Self {
        let omega = [range.0.clamp(0.01, 99.0), range.1.clamp(0.011, 100.0)];
        let options = DiagramOptions {
            max_period,
            max_branches: 24,
            tolerance: TOLERANCE,
            ..DiagramOptions::new(omega)
        };
        let inside = at_frequency(p, p.omega.clamp(omega[0], omega[1]));
        let (work, refused) = match DiagramWork::new(&inside, &options) {
            Ok(work) => (Some(work), None),
            Err(error) => (None, Some(error.to_string())),
        };
        Self { parameters: *p, work, waiting: None, tori: Vec::new(), refused, with_tori }
    }

    /// Does a slice of the work; true when all is done.
    pub(super) fn advance(&mut self) -> Result<bool, FigureError> {
        let Some(work) = &mut self.work else { return Ok(true) };
        if self.waiting.is_none() {
            if work.advance()? {
                self.waiting = Some(if self.with_tori { self.frequencies() } else { Vec::new() });
            }
            return Ok(false);
        }
        let Some(omega) = self.waiting.as_mut().and_then(Vec::pop) else { return Ok(true) };
        let p = at_frequency(&self.parameters, omega);
        // Where there is no torus the line ends.
        if let Ok(found) = torus(&p, TORUS) {
            self.tori.push(Size { omega, max_u_p: found.max_u_p, stable: found.stable });
        }
        Ok(self.waiting.as_ref().is_none_or(Vec::is_empty))
    }

    fn diagram(&self) -> Option<&Diagram> {
        self.work.as_ref().map(DiagramWork::diagram)
    }

    /// Every branch so far.
    pub(super) fn branches(&self) -> &[Branch] {
        self.diagram().map_or(&[], |diagram| &diagram.branches)
    }

    /// Mesh frequencies at which tori are looked for: between the torus bifurcations of the steady response.
    fn frequencies(&self) -> Vec<f64> {
        let born: Vec<f64> = self.branches().first().map_or_else(Vec::new, |steady| {
            let events = steady.events.iter().filter(|event| event.kind == EventKind::NeimarkSacker);
            events.map(|event| event.value).collect()
        });
        let mut wanted = Vec::new();
        for pair in born.chunks_exact(2) {
            let (low, high) = (pair[0].min(pair[1]), pair[0].max(pair[1]));
            // At the edges themselves the torus is a point.
            wanted.extend(even(low, high, TORI + 2).skip(1).take(TORI));
        }
        wanted
    }

    /// What is known of the error.
    pub(super) fn error(&self) -> ErrorEstimate {
        self.diagram().map_or_else(ErrorEstimate::default, |diagram| diagram.error)
    }

    /// Remarks for the reader.
    pub(super) fn notes(&self) -> Vec<String> {
        let mut notes = Vec::new();
        if let Some(refused) = &self.refused {
            notes.push(format!("No exact branches: {refused}."));
        }
        match (&self.waiting, self.work.is_some()) {
            (None, true) => notes.push(format!("{} exact branches so far.", self.branches().len())),
            (Some(left), true) if !left.is_empty() => notes.push(format!("{} tori to go.", left.len())),
            _ => {}
        }
        notes
    }

    /// Greatest `|u_p|` of all.
    pub(super) fn highest(&self) -> f64 {
        let orbits = self.branches().iter().flat_map(|branch| branch.max_u_p.iter().copied());
        orbits.chain(self.tori.iter().map(|torus| torus.max_u_p)).fold(0.0, f64::max)
    }

    /// Greatest `|u_p|` of the stable orbits of period `2T`, or of the stable torus, at a mesh frequency, between the
    /// computed ones.
    pub(super) fn stable_size(&self, omega: f64) -> Option<f64> {
        let orbits = self.branches().iter().filter(|branch| branch.period > 1).filter_map(|branch| {
            let place = (1..branch.value.len()).find(|&after| {
                let (one, other) = (branch.value[after - 1], branch.value[after]);
                (one - omega) * (other - omega) <= 0.0 && branch.stable[after - 1] && branch.stable[after]
            })?;
            let (one, other) = (branch.value[place - 1], branch.value[place]);
            let part = if other == one { 0.0 } else { (omega - one) / (other - one) };
            Some(branch.max_u_p[place - 1] + part * (branch.max_u_p[place] - branch.max_u_p[place - 1]))
        });
        orbits.reduce(f64::max)
    }

    /// Draws everything so far into a frame; `name` sets it apart from another drawing of the same kind.
    pub(super) fn draw(&self, composer: &mut Composer, frame: usize, name: &str, place: Place, marks: bool) {
        for (index, branch) in self.branches().iter().enumerate() {
            let period = if branch.period == 1 { "*T*".to_owned() } else { format!("{}*T*", branch.period) };
            for stable in [true, false] {
                let points = stretches(branch, stable, place);
                let word = if stable { "stable" } else { "unstable" };
                let meaning = format!("exact motion of period {}T, {word}", branch.period);
                let line = Line::new(format!("exact{name} {} {word}", index + 1), meaning, Role::Exact)
                    .stable(stable);
                // The steady response needs no name on its line, and a branch only one.
                let labelled = branch.period > 1 && stable;
                let line = if labelled { line.label(&format!("exact, {period}"), 0.6) } else { line };
                composer.curve(frame, line, points);
            }
        }
        self.draw_tori(composer, frame, name, place);
        if marks {
            self.draw_events(composer, frame, name, place);
        }
    }

    fn draw_tori(&self, composer: &mut Composer, frame: usize, name: &str, place: Place) {
        let mut tori = self.tori.clone();
        tori.extend(self.births());
        tori.sort_unstable_by(|one, other| one.omega.total_cmp(&other.omega));
        for stable in [true, false] {
            let mut points = Points::default();
            points.piece(tori.iter().map(|torus| {
                if torus.stable == stable { place(torus.omega, torus.max_u_p) } else { (f64::NAN, f64::NAN) }
            }));
            let word = if stable { "stable" } else { "unstable" };
            let line =
                Line::new(format!("torus{name} {word}"), format!("exact torus, {word}"), Role::QuasiPeriodic);
            composer.curve(frame, line.stable(stable).label("exact, torus", 0.4), points);
        }
    }

    /// The torus bifurcations of the steady response next to which there are tori: there each is a point.
    fn births(&self) -> Vec<Size> {
        let Some(steady) = self.branches().first() else { return Vec::new() };
        let near = steady.events.iter().filter(|event| event.kind == EventKind::NeimarkSacker);
        near.filter_map(|event| {
            let nearest = self.tori.iter().min_by(|one, other| {
                (one.omega - event.value).abs().total_cmp(&(other.omega - event.value).abs())
            })?;
            let close = (nearest.omega - event.value).abs() < 0.04 * event.value;
            // An unstable torus is born elsewhere: outside of the tongue.
            (close && nearest.stable).then_some(Size {
                omega: event.value,
                max_u_p: event.max_u_p,
                stable: nearest.stable,
            })
        })
        .collect()
    }

    fn draw_events(&self, composer: &mut Composer, frame: usize, name: &str, place: Place) {
        let mut all: Vec<&BranchEvent> = self.branches().iter().flat_map(|branch| &branch.events).collect();
        // Where a branch is born both it and its parent have the event; the parent's says of which kind it is.
        let known: Vec<(f64, f64)> = all
            .iter()
            .filter(|event| event.supercritical.is_some())
            .map(|event| (event.value, event.max_u_p))
            .collect();
        all.retain(|event| {
            event.supercritical.is_some()
                || !known.iter().any(|(value, size)| {
                    (value - event.value).abs() < 1e-5 && (size - event.max_u_p).abs() < 1e-3
                })
        });
        for (role, word, label, belongs) in EVENTS {
            let mut points = Points::default();
            let places =
                all.iter().filter(|event| belongs(event)).map(|event| place(event.value, event.max_u_p));
            let mut seen: Vec<(f64, f64)> = Vec::new();
            for (x, y) in places {
                // Where a branch is born both it and its parent have the event.
                if !seen.iter().any(|(u, v)| (u - x).abs() < 1e-5 && (v - y).abs() < 1e-4) {
                    seen.push((x, y));
                }
            }
            points.cloud(seen);
            let line = Line::new(format!("{word}{name}"), format!("exact: {word}"), role).label(label, 0.0);
            composer.add(frame, Mark::Marks, line, points);
        }
    }
}

/// The kinds of events: how they are drawn, what they are called, which they are.
const EVENTS: [(Role, &str, &str, fn(&BranchEvent) -> bool); 8] = [
    (Role::Fold, "fold", "fold", |event| event.kind == EventKind::Fold),
    (Role::TorusBifurcation, "torus bifurcation", "torus", |event| event.kind == EventKind::NeimarkSacker),
    (Role::AcrossManifold, "across the manifold", "across", |event| {
        event.breaks == Some(Breaks::Exchange) || event.kind == EventKind::BranchPoint
    }),
    (Role::Supercritical, "supercritical period doubling", "period doubling", |event| {
        event.kind == EventKind::PeriodDoubling && event.supercritical == Some(true)
    }),
    (Role::Subcritical, "subcritical period doubling", "period doubling", |event| {
        event.kind == EventKind::PeriodDoubling && event.supercritical != Some(true)
    }),
    (Role::Supercritical, "supercritical pitchfork", "pitchfork", |event| {
        event.kind == EventKind::Pitchfork
            && event.breaks != Some(Breaks::Exchange)
            && event.supercritical == Some(true)
    }),
    (Role::Subcritical, "subcritical pitchfork", "pitchfork", |event| {
        event.kind == EventKind::Pitchfork
            && event.breaks != Some(Breaks::Exchange)
            && event.supercritical != Some(true)
    }),
    (Role::Event, "grazing", "grazing", |event| event.kind == EventKind::Grazing),
];

/// The stretches of a branch of one stability. They meet at the bifurcation between them or, where that is not known,
/// at the first point of the next.
fn stretches(branch: &Branch, stable: bool, place: Place) -> Points {
    let mut points = Points::default();
    let count = branch.value.len();
    // Between a point and the next.
    let joint = |after: usize| {
        let event =
            branch.events.iter().find(|event| event.after == after && event.kind != EventKind::Grazing);
        event.map(|event| place(event.value, event.max_u_p))
    };
    let mut start = 0;
    while start < count {
        let kind = branch.stable[start];
        let end = (start..count).find(|&at| branch.stable[at] != kind).unwrap_or(count);
        if kind == stable {
            let before = if start > 0 { joint(start - 1) } else { None };
            let after = if end < count {
                joint(end - 1).or_else(|| Some(place(branch.value[end], branch.max_u_p[end])))
            } else {
                None
            };
            let own = (start..end).map(|at| place(branch.value[at], branch.max_u_p[at]));
            points.piece(before.into_iter().chain(own).chain(after));
        }
        start = end;
    }
    points
}
