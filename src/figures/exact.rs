//! Exact branches for figures over the mesh frequency: periodic orbits by the automatic diagram, tori between the
//! torus bifurcations of the steady response.

use super::compose::{Composer, Line, Points, even, number};
use super::job::Orbits;
use crate::chart::drawing::{Mark, Role};
use crate::error::FigureError;
use crate::model::parameters::Parameters;
use crate::order;
use crate::study::ErrorEstimate;
use crate::study::branch::{Branch, BranchEvent, Breaks, EventKind};
use crate::study::diagram::{Diagram, DiagramOptions, DiagramWork};
use crate::study::sweep::at_frequency;
use crate::study::torus::TorusWork;

/// Tolerance of orbits and tori.
const TOLERANCE: f64 = 1e-9;
/// Tolerance of tori: a line is drawn through them.
const TORUS: f64 = 1e-7;
/// Orbits with a multiplier above this are left out: what is left of double precision there does not show in a picture,
/// but nobody would meet them either.
const STEEPEST: f64 = 1e4;

/// Distance of a torus from its own image up to which it counts as a smooth curve that its Fourier series describes.
const SMOOTH: f64 = 1e-5;

/// A torus at one mesh frequency.
#[derive(Clone, Copy, Debug)]
struct Size {
    omega: f64,
    max_u_p: f64,
    stable: bool,
    /// A state on it at t = 0.
    state: [f64; 6],
}

/// The work on the exact branches, done in slices.
#[derive(Debug)]
pub(super) struct Exact {
    parameters: Parameters,
    options: DiagramOptions,
    /// The first slice does nothing: what else the figure shows is not kept waiting.
    begun: bool,
    work: Option<DiagramWork>,
    /// Mesh frequencies of tori to come, once all of the orbits are there.
    waiting: Option<Vec<f64>>,
    /// The torus that is being looked for, and where.
    search: Option<(f64, TorusWork)>,
    tori: Vec<Size>,
    /// Of those that are smooth.
    of_tori: ErrorEstimate,
    /// How many are not, and how far the worst of them is from being mapped onto itself.
    rough: usize,
    roughest: f64,
    /// Why there are no branches, where there are none.
    refused: Option<String>,
    /// Tori that are looked for between two torus bifurcations.
    tori_wanted: usize,
}

/// A point of a branch, or an event on it, by its index.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Spot {
    Point(usize),
    Event(usize),
}

impl Spot {
    /// Mesh frequency, state at t = 0, and greatest `|u_p|`.
    pub(super) fn of(self, branch: &Branch) -> (f64, [f64; 6], f64) {
        match self {
            Self::Point(at) => (branch.value[at], branch.state[at], branch.max_u_p[at]),
            Self::Event(at) => {
                let event = &branch.events[at];
                (event.value, event.state, event.max_u_p)
            }
        }
    }
}

/// The place in a figure of a spot of the branch of this index; not finite where it has none.
pub(super) type Place<'a> = &'a dyn Fn(usize, Spot) -> [f64; 3];

/// How branches are drawn.
pub(super) struct Style<'a> {
    /// Sets names apart from those of another drawing of the same kind.
    pub(super) name: &'a str,
    pub(super) place: Place<'a>,
    /// The frame has three axes.
    pub(super) space: bool,
    /// With the names of the branches and the bifurcations on them.
    pub(super) marked: bool,
}

/// Whether an orbit is too unstable to be shown.
fn steep(branch: &Branch, at: usize) -> bool {
    branch.re[at][0].hypot(branch.im[at][0]) > STEEPEST
}

impl Exact {
    /// The branches over a range of mesh frequencies; a system without any answers with none.
    pub(super) fn new(p: &Parameters, range: (f64, f64), max_period: usize, max_branches: usize) -> Self {
        let omega = [range.0.clamp(0.01, 99.0), range.1.clamp(0.011, 100.0)];
        let options =
            DiagramOptions { max_period, max_branches, tolerance: TOLERANCE, ..DiagramOptions::new(omega) };
        let inside = at_frequency(p, p.omega.clamp(omega[0], omega[1]));
        Self {
            parameters: inside,
            options,
            begun: false,
            work: None,
            waiting: None,
            search: None,
            tori: Vec::new(),
            of_tori: ErrorEstimate::default(),
            rough: 0,
            roughest: 0.0,
            refused: None,
            tori_wanted: 0,
        }
    }

    /// With so many tori between any two torus bifurcations of the steady response.
    pub(super) fn with_tori(self, tori_wanted: usize) -> Self {
        Self { tori_wanted, ..self }
    }

    /// Finds the steady response that the branches begin at.
    fn begin(&mut self) {
        match DiagramWork::new(&self.parameters, &self.options) {
            Ok(work) => self.work = Some(work),
            Err(error) => self.refused = Some(error.to_string()),
        }
    }

    /// Does a slice of the work; true when all is done.
    pub(super) fn advance(&mut self) -> Result<bool, FigureError> {
        if !self.begun {
            self.begun = true;
            return Ok(false);
        }
        let Some(work) = &mut self.work else {
            if self.refused.is_none() {
                self.begin();
            }
            return Ok(self.work.is_none());
        };
        if self.waiting.is_none() {
            if work.advance()? {
                self.waiting = Some(if self.tori_wanted > 0 { self.frequencies() } else { Vec::new() });
            }
            return Ok(false);
        }
        let Some((omega, search)) = &mut self.search else {
            let Some(omega) = self.waiting.as_mut().and_then(Vec::pop) else { return Ok(true) };
            // Each from a motion: to follow them from one to the next takes longer where they end.
            self.search = Some((omega, TorusWork::new(&at_frequency(&self.parameters, omega), TORUS)?));
            return Ok(false);
        };
        let omega = *omega;
        let Some(answer) = search.advance() else { return Ok(false) };
        self.search = None;
        // Where there is no torus the line ends.
        if let Ok(found) = answer {
            let state = found.curve.first().copied().unwrap_or_default();
            self.tori.push(Size { omega, max_u_p: found.max_u_p, stable: found.stable, state });
            let off = found.error.residual.unwrap_or(0.0);
            if off > SMOOTH {
                self.rough += 1;
                self.roughest = self.roughest.max(off);
            } else {
                self.of_tori = self.of_tori.worse(found.error);
            }
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
            wanted.extend(even(low, high, self.tori_wanted + 2).skip(1).take(self.tori_wanted));
        }
        wanted
    }

    /// What is known of the error of the branches that are drawn whole, and of the tori.
    pub(super) fn error(&self) -> ErrorEstimate {
        let whole =
            self.branches().iter().filter(|branch| !(0..branch.value.len()).any(|at| steep(branch, at)));
        whole.fold(self.of_tori, |worst, branch| worst.worse(branch.error))
    }

    /// Remarks for the reader.
    pub(super) fn notes(&self) -> Vec<String> {
        let mut notes = Vec::new();
        if let Some(refused) = &self.refused {
            notes.push(format!("No exact branches: {refused}."));
        }
        let cut =
            self.branches().iter().flat_map(|branch| (0..branch.value.len()).map(|at| steep(branch, at)));
        let (mut left_out, mut all) = (0, 0);
        for steep in cut {
            all += 1;
            left_out += usize::from(steep);
        }
        if left_out > 0 {
            notes.push(format!(
                "Left out are {left_out} of {all} exact orbits, with a multiplier above 10,000; the errors given are \
                 those of the branches drawn whole."
            ));
        }
        if self.rough > 0 {
            notes.push(format!(
                "{} of {} tori are no smooth curves: their size is that of points of a long motion, to {}.",
                self.rough,
                self.tori.len(),
                number(self.roughest, 1)
            ));
        }
        match (&self.waiting, self.work.is_some()) {
            (None, true) => notes.push(format!("{} exact branches so far.", self.branches().len())),
            (Some(left), true) if !left.is_empty() => notes.push(format!("{} tori to go.", left.len())),
            _ => {}
        }
        notes
    }

    /// Every orbit and torus that is drawn, for a reader who picks one.
    pub(super) fn orbits(&self) -> Orbits {
        let mut all = Orbits::default();
        let mut add = |omega: f64, max_u_p: f64, period: usize, stable: bool, state: &[f64; 6]| {
            all.omega.push(omega);
            all.max_u_p.push(max_u_p);
            all.period.push(period as f64);
            all.stable.push(f64::from(u8::from(stable)));
            all.state.extend(state);
        };
        for branch in self.branches() {
            for at in (0..branch.value.len()).filter(|&at| !steep(branch, at)) {
                let (omega, state, max_u_p) = Spot::Point(at).of(branch);
                add(omega, max_u_p, branch.period, branch.stable[at], &state);
            }
        }
        for torus in &self.tori {
            add(torus.omega, torus.max_u_p, 0, torus.stable, &torus.state);
        }
        all
    }

    /// Greatest `|u_p|` of all.
    pub(super) fn highest(&self) -> f64 {
        let orbits = self.branches().iter().flat_map(|branch| {
            let shown = (0..branch.value.len()).filter(|&at| !steep(branch, at));
            shown.map(|at| branch.max_u_p[at])
        });
        orbits.chain(self.tori.iter().map(|torus| torus.max_u_p)).fold(0.0, f64::max)
    }

    /// Height of the stable orbits that are born from the steady response at a place on the axis, between the computed
    /// ones; the first such place along a branch.
    pub(super) fn stable_at(&self, x: f64, place: Place) -> Option<f64> {
        let orbits = self.branches().iter().enumerate();
        let orbits = orbits.filter(|(index, branch)| branch.period > 1 && self.born_at_rest(*index));
        let heights = orbits.filter_map(|(index, branch)| {
            let at = |point: usize| place(index, Spot::Point(point));
            let after = (1..branch.value.len()).find(|&after| {
                let both = branch.stable[after - 1] && branch.stable[after];
                both && (at(after - 1)[0] - x) * (at(after)[0] - x) <= 0.0
            })?;
            let (one, other) = (at(after - 1), at(after));
            let part = if other[0] == one[0] { 0.0 } else { (x - one[0]) / (other[0] - one[0]) };
            Some(one[1] + part * (other[1] - one[1]))
        });
        heights.filter(|height| height.is_finite()).reduce(f64::max)
    }

    /// Whether a branch is born from the steady response.
    fn born_at_rest(&self, index: usize) -> bool {
        self.diagram().is_some_and(|diagram| matches!(diagram.from.get(index), Some(Some((0, _)))))
    }

    /// Whether a branch has its name on it: those born from the steady response, and longer ones.
    fn named(&self, index: usize) -> bool {
        let period = self.branches()[index].period;
        period > 2 || (period == 2 && self.born_at_rest(index))
    }

    /// The place from mesh frequency and greatest `|u_p|`.
    pub(super) fn by_size(&self, index: usize, spot: Spot) -> [f64; 3] {
        let (omega, _, size) = spot.of(&self.branches()[index]);
        [omega, size, 0.0]
    }

    /// Draws everything so far into a frame.
    pub(super) fn draw(&self, composer: &mut Composer, frame: usize, style: &Style) {
        for (index, branch) in self.branches().iter().enumerate() {
            let period = if branch.period == 1 { "*T*".to_owned() } else { format!("{}*T*", branch.period) };
            for stable in [true, false] {
                let mut points = Points::default();
                for stretch in stretches(branch, stable) {
                    let places = stretch.into_iter().map(|spot| match spot {
                        Spot::Point(at) if steep(branch, at) => [f64::NAN; 3],
                        spot => (style.place)(index, spot),
                    });
                    if style.space {
                        points.piece_in_space(places.map(|[x, y, z]| (x, y, z)));
                    } else {
                        points.piece(places.map(|[x, y, _]| (x, y)));
                    }
                }
                let word = if stable { "stable" } else { "unstable" };
                let meaning = format!("exact motion of period {}T, {word}", branch.period);
                let line =
                    Line::new(format!("exact{} {} {word}", style.name, index + 1), meaning, Role::Exact)
                        .stable(stable);
                // The steady response needs no name on its line, and a branch only one.
                let labelled = style.marked && stable && self.named(index);
                let line = if labelled { line.label(&format!("exact, {period}"), 0.6) } else { line };
                composer.curve(frame, line, points);
            }
        }
        if style.marked {
            self.draw_events(composer, frame, style);
        }
    }

    /// Draws the tori over the mesh frequency, as this part of their greatest `|u_p|`.
    pub(super) fn draw_tori(&self, composer: &mut Composer, frame: usize, part: f64) {
        let mut tori = self.tori.clone();
        tori.extend(self.births());
        order::by_number(&mut tori, |torus| torus.omega);
        for stable in [true, false] {
            let mut points = Points::default();
            points.piece(tori.iter().map(|torus| {
                if torus.stable == stable {
                    (torus.omega, part * torus.max_u_p)
                } else {
                    (f64::NAN, f64::NAN)
                }
            }));
            let word = if stable { "stable" } else { "unstable" };
            let line =
                Line::new(format!("torus {word}"), format!("exact torus, {word}"), Role::QuasiPeriodic);
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
                state: event.state,
            })
        })
        .collect()
    }

    fn draw_events(&self, composer: &mut Composer, frame: usize, style: &Style) {
        let mut all: Vec<(&BranchEvent, [f64; 3])> = Vec::new();
        for (index, branch) in self.branches().iter().enumerate() {
            let shown = |event: &BranchEvent| !steep(branch, event.after.min(branch.value.len() - 1));
            let events = branch.events.iter().enumerate().filter(|(_, event)| shown(event));
            all.extend(events.map(|(at, event)| (event, (style.place)(index, Spot::Event(at)))));
        }
        // Where a branch is born both it and its parent have the event; the parent's says of which kind it is.
        let known: Vec<(f64, f64)> = all
            .iter()
            .filter(|(event, _)| event.supercritical.is_some())
            .map(|(event, _)| (event.value, event.max_u_p))
            .collect();
        all.retain(|(event, _)| {
            event.supercritical.is_some()
                || !known.iter().any(|(value, size)| {
                    (value - event.value).abs() < 1e-5 && (size - event.max_u_p).abs() < 1e-3
                })
        });
        for (role, word, label, belongs) in EVENTS {
            let mut points = Points::default();
            let places = all.iter().filter(|(event, _)| belongs(event)).map(|(_, place)| *place);
            let mut seen: Vec<(f64, f64)> = Vec::new();
            for [x, y, _] in places {
                // Where a branch is born both it and its parent have the event.
                if !seen.iter().any(|(u, v)| (u - x).abs() < 1e-5 && (v - y).abs() < 1e-4) {
                    seen.push((x, y));
                }
            }
            points.cloud(seen);
            let line =
                Line::new(format!("{word}{}", style.name), format!("exact: {word}"), role).label(label, 0.0);
            composer.add(frame, Mark::Marks, line, points);
        }
    }
}

/// Role, name, label, and which events they are for.
type Look = (Role, &'static str, &'static str, fn(&BranchEvent) -> bool);

/// The kinds of events: how they are drawn, what they are called, which they are.
const EVENTS: [Look; 8] = [
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
fn stretches(branch: &Branch, stable: bool) -> Vec<Vec<Spot>> {
    let mut all = Vec::new();
    let count = branch.value.len();
    // Between a point and the next.
    let joint = |after: usize| {
        let found = branch
            .events
            .iter()
            .position(|event| event.after == after && event.kind != EventKind::Grazing)?;
        Some(Spot::Event(found))
    };
    let mut start = 0;
    while start < count {
        let kind = branch.stable[start];
        let end = (start..count).find(|&at| branch.stable[at] != kind).unwrap_or(count);
        if kind == stable {
            let before = if start > 0 { joint(start - 1) } else { None };
            let after = if end < count { joint(end - 1).or(Some(Spot::Point(end))) } else { None };
            all.push(before.into_iter().chain((start..end).map(Spot::Point)).chain(after).collect());
        }
        start = end;
    }
    all
}
