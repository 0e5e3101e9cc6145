//! Figures 11-13: stroboscopic maps, which fill in as they are computed.

use super::compose::{Composer, Line, Points, axis, number, plane, rounded_up};
use super::exact_map::{self, ExactMap, Sought};
use super::job::{Figure, Slices};
use crate::chart::drawing::{Drawing, Mark, Role};
use crate::error::FigureError;
use crate::model::parameters::{Parameters, Regime};
use crate::study::multipliers::{Multipliers, multipliers};
use crate::study::orbit::{OrbitOptions, PeriodicOrbit, periodic_orbit};
use crate::study::poincare::Strobe;
use crate::study::torus::TorusWork;
use std::collections::HashSet;

/// The paper's start, from which its mirror image and the others are made: at rest, on the manifold `u_g = -u_p`.
const START: [f64; 6] = [-0.02, 0.02, 0.05, 0.0, 0.0, 0.0];
/// Further points of the manifold to start from: with another share of each mode.
const FURTHER: [[f64; 6]; 2] = [[0.03, -0.03, 0.01, 0.0, 0.0, 0.0], [0.01, -0.01, 0.08, 0.0, 0.0, 0.0]];
/// Most periods followed from the paper's start.
const MOST: usize = 4000;
/// Most periods followed from the others, which show how they come near.
const MOST_FURTHER: usize = 1000;
/// Periods computed in one slice.
const SLICE: usize = 500;
/// A start is followed until it is this near the attractor.
const NEAR: f64 = 1e-3;
/// Two points of the map this near, a few periods apart: an orbit is looked for there.
const RETURNING: f64 = 1e-4;
/// Longest period, in mesh periods, that is looked for.
const LONGEST: usize = 4;
/// The share of a motion that never settles on an orbit which counts as its transient.
const TRANSIENT: f64 = 0.6;
/// Tolerance of the integration.
const TOLERANCE: f64 = 1e-10;
/// Cells along each axis in which a second point is not drawn: two thirds of a pixel of an ordinary picture.
const CELLS: f64 = 1000.0;
/// The same for transients, which are light and wide apart.
const SPARSE: f64 = 800.0;

/// What the fixed point in the middle is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Centre {
    Stable,
    /// The largest multiplier is real and negative: sides change with every period.
    FlipSaddle,
    Saddle,
    Spiral,
}

impl Centre {
    pub(super) fn of(multipliers: &Multipliers) -> Self {
        if multipliers.stable {
            return Self::Stable;
        }
        let (re, im) = (multipliers.re[0], multipliers.im[0]);
        match (im.abs() > 1e-9 * re.abs(), re < 0.0) {
            (true, _) => Self::Spiral,
            (false, true) => Self::FlipSaddle,
            (false, false) => Self::Saddle,
        }
    }

    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Stable => "stable",
            Self::FlipSaddle | Self::Saddle => "saddle",
            Self::Spiral => "unstable spiral",
        }
    }

    pub(super) fn role(self) -> Role {
        match self {
            Self::Stable => Role::Attractor,
            Self::FlipSaddle | Self::Saddle => Role::Saddle,
            Self::Spiral => Role::UnstableSpiral,
        }
    }
}

/// How a start ended.
#[derive(Clone, Copy, Debug, PartialEq)]
enum End {
    /// At the attractor of this index, after so many points.
    Settled(usize, usize),
    /// Over the barrier.
    Escaped(f64),
    /// Followed as far as it may be.
    Wandering,
}

/// One start and its points so far, the start included.
#[derive(Clone, Debug)]
struct Track {
    strobe: Strobe,
    states: Vec<[f64; 6]>,
    end: Option<End>,
    /// Most periods it is followed.
    most: usize,
    /// Searches for an orbit that failed: each waits twice as long for the next.
    next_search: usize,
}

/// An attractor that starts have reached: the points of one orbit.
#[derive(Clone, Debug)]
struct Attractor {
    orbit: PeriodicOrbit,
    points: Vec<[f64; 6]>,
}

/// Whether the figure of this id is a stroboscopic map.
pub(super) fn draws(id: &str) -> bool {
    ["11", "12", "13"].iter().any(|number| id.starts_with(number))
}

/// A map in the making.
#[derive(Debug)]
pub(super) struct Map {
    parameters: Parameters,
    centre: Option<Multipliers>,
    tracks: Vec<Track>,
    attractors: Vec<Attractor>,
    turn: usize,
    /// Where starts can be expected to end, once they have.
    exact: Option<ExactMap>,
    /// The search for it, where that takes long.
    search: Option<TorusWork>,
}

impl Slices for Map {
    fn advance(&mut self) -> Result<bool, FigureError> {
        if self.centre.is_none() {
            self.begin()?;
        }
        let mut left = SLICE;
        while left > 0 {
            let Some(index) = self.next_open() else { break };
            let share = left.min(100);
            self.follow(index, share)?;
            left -= share;
        }
        if left == SLICE && self.exact.is_none() {
            return self.seek();
        }
        Ok(self.finished() && (self.exact.is_some() || self.sought().is_none()))
    }

    fn figure(&self, id: &'static str, parameters: &Parameters) -> Figure {
        let Some(centre) = &self.centre else { return Figure::waiting(id, parameters) };
        let of_orbit = || self.attractors.first().map_or(centre.error, |attractor| attractor.orbit.error);
        let mut method =
            "Taylor series from period to period to 1e-10; multipliers and orbits by the variational equations"
                .to_owned();
        if let Some(exact) = &self.exact {
            method.push_str("; exact: ");
            method.push_str(exact.method());
        }
        let mut notes = self.notes(centre);
        notes.extend(self.exact.as_ref().map(ExactMap::note));
        Figure {
            summary: self.summary(centre),
            method,
            error: self.exact.as_ref().and_then(ExactMap::error).unwrap_or_else(of_orbit),
            notes,
            distances: self.exact.as_ref().map_or_else(Vec::new, ExactMap::distances),
            ..Figure::drawn(id, parameters, self.drawing(centre))
        }
    }
}

impl Map {
    pub(super) fn new(parameters: &Parameters) -> Self {
        Self {
            parameters: *parameters,
            centre: None,
            tracks: Vec::new(),
            attractors: Vec::new(),
            turn: 0,
            exact: None,
            search: None,
        }
    }

    /// What is born where the fixed point in the middle loses its stability like this.
    fn sought(&self) -> Option<Sought> {
        match self.centre.as_ref().map(Centre::of) {
            Some(Centre::FlipSaddle) => Some(Sought::Points),
            Some(Centre::Spiral) => Some(Sought::Circle),
            _ => None,
        }
    }

    /// Does a slice of the search for what is exact; true when it is over.
    fn seek(&mut self) -> Result<bool, FigureError> {
        match (self.sought(), &mut self.search) {
            (None, _) => return Ok(true),
            (Some(Sought::Points), _) => self.exact = Some(ExactMap::points(&self.parameters)),
            (Some(Sought::Circle), None) => {
                self.search = Some(TorusWork::new(&self.parameters, exact_map::CIRCLE)?);
            }
            (Some(Sought::Circle), Some(search)) => {
                let found = search.advance();
                self.exact = found.map(|found| ExactMap::circle(&self.parameters, found));
            }
        }
        Ok(self.exact.is_some())
    }

    /// The equations are unchanged by `u -> -u`: every start stands for its mirror image too.
    fn mirrored(&self) -> bool {
        self.parameters.regime == Regime::Homogeneous
    }

    fn begin(&mut self) -> Result<(), FigureError> {
        let centre = multipliers(&self.parameters, TOLERANCE)?;
        let mut starts = vec![START];
        starts.extend(FURTHER);
        if !self.mirrored() {
            starts.extend(starts.clone().into_iter().map(|start| start.map(|value| -value)));
        }
        for start in starts {
            let paper = start.map(f64::abs) == START.map(f64::abs);
            let most = if paper { MOST } else { MOST_FURTHER };
            let state = std::array::from_fn(|i| centre.state[i] + start[i]);
            let strobe = Strobe::new(&self.parameters, state, TOLERANCE)?;
            self.tracks.push(Track { strobe, states: vec![state], end: None, most, next_search: 0 });
        }
        if centre.stable {
            let orbit = PeriodicOrbit {
                state: centre.state,
                re: centre.re,
                im: centre.im,
                stable: true,
                min: centre.state,
                max: centre.state,
                period: 1,
                method: centre.method.clone(),
                error: centre.error,
            };
            self.attractors.push(Attractor { points: vec![centre.state], orbit });
        }
        self.centre = Some(centre);
        Ok(())
    }

    /// The next start that has not ended, in turn.
    fn next_open(&mut self) -> Option<usize> {
        let count = self.tracks.len();
        let index =
            (0..count).map(|n| (self.turn + n) % count).find(|&index| self.tracks[index].end.is_none())?;
        self.turn = index + 1;
        Some(index)
    }

    fn follow(&mut self, index: usize, periods: usize) -> Result<(), FigureError> {
        for _ in 0..periods {
            let track = &mut self.tracks[index];
            let Some(state) = track.strobe.next()? else {
                track.end = Some(End::Escaped(track.strobe.escaped().unwrap_or(0.0)));
                return Ok(());
            };
            track.states.push(state);
            if track.states.len() > track.most {
                track.end = Some(End::Wandering);
                return Ok(());
            }
            if self.settled(index) {
                return Ok(());
            }
        }
        self.search(index);
        Ok(())
    }

    /// Whether the last point is at a known attractor; if so the start has ended.
    fn settled(&mut self, index: usize) -> bool {
        let track = &self.tracks[index];
        let Some(last) = track.states.last() else { return false };
        let at = self
            .attractors
            .iter()
            .position(|attractor| attractor.points.iter().any(|point| distance(point, last) < NEAR));
        if let Some(at) = at {
            let count = track.states.len();
            self.tracks[index].end = Some(End::Settled(at, count));
        }
        at.is_some()
    }

    /// Looks for an orbit where a start returns to where it was some periods before.
    fn search(&mut self, index: usize) {
        let track = &self.tracks[index];
        let count = track.states.len();
        if count <= LONGEST || count < track.next_search {
            return;
        }
        let last = track.states[count - 1];
        let returns =
            (1..=LONGEST).find(|&period| distance(&last, &track.states[count - 1 - period]) < RETURNING);
        let Some(period) = returns else { return };
        match self.orbit(last, period) {
            Some(attractor) => {
                let first = track
                    .states
                    .iter()
                    .position(|state| attractor.points.iter().any(|point| distance(point, state) < NEAR));
                self.attractors.push(attractor);
                self.tracks[index].end =
                    first.map(|first| End::Settled(self.attractors.len() - 1, first + 1));
            }
            None => self.tracks[index].next_search = 2 * count,
        }
    }

    /// The stable orbit near a state.
    fn orbit(&self, state: [f64; 6], period: usize) -> Option<Attractor> {
        let options = OrbitOptions { period, guess: Some(state), tolerance: TOLERANCE };
        let orbit = periodic_orbit(&self.parameters, &options).ok().filter(|orbit| orbit.stable)?;
        if distance(&orbit.state, &state) > 0.1 {
            return None;
        }
        let mut points = vec![orbit.state];
        let mut strobe = Strobe::new(&self.parameters, orbit.state, TOLERANCE).ok()?;
        for _ in 1..orbit.period {
            points.push(strobe.next().ok()??);
        }
        Some(Attractor { orbit, points })
    }

    fn finished(&self) -> bool {
        !self.tracks.is_empty() && self.tracks.iter().all(|track| track.end.is_some())
    }

    /// The points of a track as they are drawn: those up to the attractor.
    fn shown(track: &Track) -> &[[f64; 6]] {
        match track.end {
            Some(End::Settled(_, count)) => &track.states[..count.min(track.states.len())],
            _ => &track.states,
        }
    }

    /// Where the transient of a track ends: a motion that never settles on an orbit is shown as an attractor from
    /// there on.
    fn transient(&self, track: &Track) -> usize {
        let never_settles = !matches!(track.end, Some(End::Settled(..) | End::Escaped(_)));
        let count = (TRANSIENT * MOST as f64) as usize;
        if never_settles && self.attractors.is_empty() {
            count.min(track.states.len())
        } else {
            track.states.len()
        }
    }

    /// Half the width and the height of the frame, about the fixed point in the middle.
    fn reach(&self, centre: &Multipliers) -> (f64, f64) {
        let all = self.tracks.iter().flat_map(Self::shown).copied();
        let nodes = self.attractors.iter().flat_map(|attractor| attractor.points.iter().copied());
        let (x, y) = all.chain(nodes).fold((0.0_f64, 0.0_f64), |(x, y), state| {
            (x.max((state[0] - centre.state[0]).abs()), y.max((state[3] - centre.state[3]).abs()))
        });
        (rounded_up(1.08 * x), rounded_up(1.08 * y))
    }

    fn drawing(&self, centre: &Multipliers) -> Drawing {
        let kind = Centre::of(centre);
        let (x, y) = self.reach(centre);
        let (x_0, y_0) = (centre.state[0], centre.state[3]);
        let mut composer = Composer::new((1, 1));
        let frame = composer.frame(plane(
            "map",
            "",
            (0, 0),
            axis("u_p", "*u*_{p}", (x_0 - x, x_0 + x)),
            axis("u_p_dot", "*u*_{p}'", (y_0 - y, y_0 + y)),
        ));
        let mut seen = Thinning::new((x_0, y_0), (x, y), SPARSE);
        let mut seen_late = Thinning::new((x_0, y_0), (x, y), CELLS);
        let mut joints = Points::default();
        let mut transients = Points::default();
        let mut late = Points::default();
        let sides: &[f64] = if self.mirrored() { &[1.0, -1.0] } else { &[1.0] };
        for (number, track) in self.tracks.iter().enumerate() {
            let shown = Self::shown(track);
            let cut = self.transient(track).min(shown.len());
            for &side in sides {
                let point = |state: &[f64; 6]| (side * state[0], side * state[3]);
                if kind == Centre::FlipSaddle && track.most == MOST {
                    let mut joined = Points::default();
                    for first in 0..2 {
                        joined.piece(shown[..cut].iter().skip(first).step_by(2).map(point));
                    }
                    let name = if side > 0.0 && number == 0 { "start" } else { "mirrored start" };
                    let line = Line::new(
                        format!("{name} joined"),
                        "every second point of the map joined",
                        Role::Trajectory,
                    );
                    composer.curve(frame, line, joined);
                }
                let way = if kind == Centre::FlipSaddle && track.most == MOST {
                    &mut joints
                } else {
                    &mut transients
                };
                way.cloud(shown[..cut].iter().map(point).filter(|at| seen.first_there(*at)));
                late.cloud(shown[cut..].iter().map(point).filter(|at| seen_late.first_there(*at)));
            }
        }
        let line = Line::new("trajectories", "points of the map on their way", Role::Trajectory);
        composer.add(frame, Mark::Cloud, line, transients);
        let line = Line::new("points", "points of the map from the paper's start", Role::Trajectory);
        composer.marks(frame, line, joints);
        let line = Line::new("limit cycle", "the closed curve on which the points stay", Role::Attractor);
        composer.add(frame, Mark::Cloud, line.label("limit cycle", 0.3), late);
        self.mark_attractors(&mut composer, frame, kind);
        if let Some(exact) = &self.exact {
            exact.draw(&mut composer, frame);
        }
        let line =
            Line::new("fixed point", format!("the fixed point in the middle: {}", kind.name()), kind.role());
        let line = line.stable(kind == Centre::Stable).label(kind.name(), 0.5);
        composer.marks(frame, line, Points::one((x_0, y_0)));
        composer.drawing()
    }

    fn mark_attractors(&self, composer: &mut Composer, frame: usize, kind: Centre) {
        let skip = usize::from(kind == Centre::Stable);
        for (number, attractor) in self.attractors.iter().enumerate().skip(skip) {
            let mut points: Vec<[f64; 6]> = attractor.points.clone();
            if self.mirrored() {
                for point in &attractor.points {
                    let image = point.map(|value| -value);
                    if points.iter().all(|other| distance(other, &image) > NEAR) {
                        points.push(image);
                    }
                }
            }
            let period = attractor.orbit.period;
            let meaning = format!("{} points of the stable motion of period {period}T", points.len());
            let line = Line::new(format!("node {}", number + 1), meaning, Role::Attractor).stable(true);
            let label = if period == 2 { "node".to_owned() } else { format!("period {period}*T*") };
            composer.marks(
                frame,
                line.label(&label, 0.0),
                Points::plane(points.iter().map(|state| (state[0], state[3]))),
            );
        }
    }

    fn summary(&self, centre: &Multipliers) -> String {
        let kind = Centre::of(centre);
        let largest = format!("its largest multiplier has magnitude {}", number(centre.spectral_radius, 5));
        let middle = format!("The fixed point in the middle is {} ({largest})", article(kind));
        let skip = usize::from(kind == Centre::Stable);
        if let Some(attractor) = self.attractors.get(skip) {
            let state = attractor.points[0];
            let period = attractor.orbit.period;
            if !self.mirrored() || period != 2 {
                return format!(
                    "{middle}; starts end in a stable motion of period {period}T, one of whose points is u_p = {}, u_p' = {}.",
                    number(state[0], 5),
                    number(state[3], 5)
                );
            }
            return format!(
                "{middle}; the starts end in the points of a stable motion of period {period}T at u_p = \u{b1}{}, \
                 u_p' = {}{}.",
                number(state[0].abs(), 5),
                if state[0] * state[3] < 0.0 { "\u{2213}" } else { "\u{b1}" },
                number(state[3].abs(), 5)
            );
        }
        if kind == Centre::Stable {
            return format!(
                "{middle}: the parameters lie outside of the tongues, and small starts come to rest."
            );
        }
        if let Some(time) = self.first_escape() {
            return format!("{middle}; a start escapes over the barrier at t = {}.", number(time, 5));
        }
        let late = self.tracks.iter().flat_map(|track| &track.states[self.transient(track)..]);
        let (x, y) =
            late.fold((0.0_f64, 0.0_f64), |(x, y), state| (x.max(state[0].abs()), y.max(state[3].abs())));
        if x > 0.0 {
            format!(
                "{middle}; the starts wind onto a closed curve, a limit cycle, with |u_p| up to {} and |u_p'| up to {}.",
                number(x, 4),
                number(y, 4)
            )
        } else {
            format!("{middle}; the starts are on their way out from it.")
        }
    }

    fn first_escape(&self) -> Option<f64> {
        self.tracks
            .iter()
            .filter_map(|track| match track.end {
                Some(End::Escaped(time)) => Some(time),
                _ => None,
            })
            .reduce(f64::min)
    }

    fn notes(&self, centre: &Multipliers) -> Vec<String> {
        let mut notes = Vec::new();
        if !self.finished() {
            let periods: usize = self.tracks.iter().map(|track| track.states.len() - 1).sum();
            notes.push(format!("{periods} periods computed so far."));
        }
        for (number_of, track) in self.tracks.iter().enumerate() {
            if let Some(End::Escaped(time)) = track.end {
                notes.push(format!(
                    "Start {} escapes at t = {}; it is drawn up to there.",
                    number_of + 1,
                    number(time, 5)
                ));
            }
        }
        if Centre::of(centre) == Centre::Stable {
            notes.push("The origin is stable here: no tongue holds these parameters.".to_owned());
        }
        notes
    }
}

pub(super) fn article(kind: Centre) -> &'static str {
    match kind {
        Centre::Stable => "stable",
        Centre::FlipSaddle | Centre::Saddle => "a saddle",
        Centre::Spiral => "an unstable spiral",
    }
}

/// Distance of two states.
pub(super) fn distance(one: &[f64; 6], other: &[f64; 6]) -> f64 {
    one.iter().zip(other).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt()
}

/// Lets through the first point in each of many small cells.
pub(super) struct Thinning {
    middle: (f64, f64),
    cell: (f64, f64),
    seen: HashSet<(i32, i32)>,
}

impl Thinning {
    pub(super) fn new(middle: (f64, f64), reach: (f64, f64), cells: f64) -> Self {
        Self { middle, cell: (2.0 * reach.0 / cells, 2.0 * reach.1 / cells), seen: HashSet::new() }
    }

    pub(super) fn first_there(&mut self, (x, y): (f64, f64)) -> bool {
        let place = |value: f64, middle: f64, cell: f64| ((value - middle) / cell).round() as i32;
        self.seen.insert((place(x, self.middle.0, self.cell.0), place(y, self.middle.1, self.cell.1)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thinning_keeps_one_point_of_a_cell() {
        let mut thinning = Thinning::new((0.0, 0.0), (3.0, 3.0), 6000.0);
        assert!(thinning.first_there((1.0, 1.0)));
        assert!(!thinning.first_there((1.0001, 1.0001)));
        assert!(thinning.first_there((1.01, 1.0)));
    }
}
