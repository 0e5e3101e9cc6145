//! Figure P: the stroboscopic map from one start, which fills in as it is computed.

use super::compose::{Composer, Line, Points, axis, number, plane, rounded_up};
use super::job::{Fact, Figure, Slices};
use super::poincare_map::{Centre, Thinning, article, distance};
use crate::chart::drawing::{Drawing, Mark, Role};
use crate::error::FigureError;
use crate::model::parameters::Parameters;
use crate::study::ErrorEstimate;
use crate::study::motion::default_state;
use crate::study::multipliers::{Budget, Multipliers, multipliers, trivial_state};
use crate::study::orbit::PeriodicOrbit;
use crate::study::poincare::Strobe;
use crate::study::settling::{ELSEWHERE, closed, returning, size, stable_orbit};

/// Most periods followed.
const MOST: usize = 4000;
/// Periods computed in one slice; most integration steps in it.
const SLICE: usize = 400;
const SLICE_STEPS: usize = 12_000;
/// Most integration steps in all: stiff and slow corners of the ranges end sooner.
const MOST_STEPS: usize = 1_000_000;
/// Steps that the search for orbits may take.
const SEARCH: usize = 150_000;
/// The share of a motion that never settles which counts as its transient.
const TRANSIENT: f64 = 0.6;
/// Tolerance of the integration.
const TOLERANCE: f64 = 1e-10;
/// A start is followed until it is this near the orbit it settles on, relative to 1 + the largest coordinate.
const NEAR: f64 = 1e-3;
/// What is nearer than this to nothing is nothing, beside the tolerance.
const NOTHING: f64 = 1e-9;
/// The frame of a motion that escapes reaches no further than this.
const FARTHEST: f64 = 40.0;
/// So many points of the way are drawn as marks of their own.
const FEW: usize = 400;
/// Cells along each axis in which a second point is not drawn.
const CELLS: f64 = 900.0;

/// What is known of where the motion ends.
#[derive(Clone, Debug, PartialEq)]
enum End {
    /// It starts on an orbit, of so many mesh periods.
    Closed(usize),
    /// On a stable orbit, whose points these are.
    Orbit(Box<PeriodicOrbit>, Vec<[f64; 6]>),
    /// Over the barrier.
    Escaped(f64),
    /// Followed as far as it may be.
    Wandering,
}

/// A map in the making.
#[derive(Debug)]
pub(super) struct TrajectoryMap {
    parameters: Parameters,
    start: Option<[f64; 6]>,
    /// The fixed point in the middle, once it has been looked for; why there is none.
    centre: Option<Result<Multipliers, String>>,
    strobe: Option<Strobe>,
    states: Vec<[f64; 6]>,
    end: Option<End>,
    /// A search for an orbit that failed waits twice as long for the next.
    next_search: usize,
    budget: Budget,
}

impl TrajectoryMap {
    pub(super) fn new(parameters: &Parameters, start: Option<[f64; 6]>) -> Self {
        Self {
            parameters: *parameters,
            start,
            centre: None,
            strobe: None,
            states: Vec::new(),
            end: None,
            next_search: 4,
            budget: Budget::of(SEARCH),
        }
    }

    /// Where nothing is said, a start near the fixed point in the middle, as the paper's maps have it.
    fn begin(&mut self) -> Result<(), FigureError> {
        let p = &self.parameters;
        let state = self.start.unwrap_or_else(|| {
            let homogeneous = Parameters { regime: crate::model::parameters::Regime::Homogeneous, ..*p };
            let (middle, aside) = (trivial_state(p), default_state(&homogeneous));
            std::array::from_fn(|index| middle[index] + aside[index])
        });
        self.strobe = Some(Strobe::new(p, state, TOLERANCE)?);
        self.states = vec![state];
        if self.start.is_some()
            && let Some(period) = closed(p, &state, TOLERANCE)?
        {
            self.end = Some(End::Closed(period));
            let mut strobe = Strobe::new(p, state, TOLERANCE)?;
            for _ in 1..period {
                self.states.extend(strobe.next()?);
            }
        }
        Ok(())
    }

    /// Follows the motion for a slice.
    fn follow(&mut self) -> Result<(), FigureError> {
        let Some(strobe) = &mut self.strobe else { return Ok(()) };
        let before = strobe.steps();
        for _ in 0..SLICE {
            let Some(state) = strobe.next()? else {
                self.end = Some(End::Escaped(strobe.escaped().unwrap_or(strobe.time())));
                return Ok(());
            };
            self.states.push(state);
            if self.states.len() > MOST || strobe.steps() > MOST_STEPS {
                self.end = Some(End::Wandering);
                return Ok(());
            }
            if strobe.steps() - before > SLICE_STEPS {
                break;
            }
        }
        self.search();
        Ok(())
    }

    /// Looks for an orbit where the motion returns to where it was some periods before.
    fn search(&mut self) {
        let count = self.states.len();
        if count < self.next_search {
            return;
        }
        let recent = &self.states[count.saturating_sub(32)..];
        let (Some(period), Some(&last)) = (returning(recent), recent.last()) else { return };
        let p = &self.parameters;
        let found = stable_orbit(p, last, period, ELSEWHERE, TOLERANCE, &self.budget);
        let Some(orbit) = found else {
            self.next_search = 2 * count;
            return;
        };
        let mut points = vec![orbit.state];
        if let Ok(mut strobe) = Strobe::new(p, orbit.state, TOLERANCE) {
            for _ in 1..orbit.period {
                points.extend(strobe.next().ok().flatten());
            }
        }
        let near = |state: &[f64; 6]| points.iter().any(|point| distance(point, state) < NEAR * size(point));
        let settled = self.states.iter().position(near).map_or(count, |first| first + 1);
        self.states.truncate(settled);
        self.end = Some(End::Orbit(Box::new(orbit), points));
    }

    /// Where the transient ends: a motion that never settles counts as an attractor from there on.
    fn transient(&self) -> usize {
        match self.end {
            Some(End::Wandering) => (TRANSIENT * self.states.len() as f64) as usize,
            Some(End::Closed(_)) => 0,
            _ => self.states.len(),
        }
    }

    fn middle(&self) -> Option<&Multipliers> {
        self.centre.as_ref().and_then(|centre| centre.as_ref().ok())
    }

    /// Points of what the motion settles on.
    fn settled(&self) -> &[[f64; 6]] {
        match &self.end {
            Some(End::Orbit(_, points)) => points,
            Some(End::Closed(_)) => &self.states,
            _ => &[],
        }
    }

    /// The frame about the middle that holds everything.
    fn frame(&self) -> ((f64, f64), (f64, f64)) {
        let middle = self.middle().map_or_else(|| trivial_state(&self.parameters), |middle| middle.state);
        let all = self.states.iter().chain(self.settled());
        let (x, y) = all.fold((0.0_f64, 0.0_f64), |(x, y), state| {
            (x.max((state[0] - middle[0]).abs()), y.max((state[3] - middle[3]).abs()))
        });
        // Where the motion escapes without bound its last points would leave nothing to be seen of the first.
        let most = if matches!(self.end, Some(End::Escaped(_))) { FARTHEST } else { f64::INFINITY };
        let (x, y) = (x.min(most), y.min(most));
        ((middle[0], middle[3]), (rounded_up(1.08 * x), rounded_up(1.08 * y)))
    }

    fn drawing(&self) -> Drawing {
        let ((x_0, y_0), (x, y)) = self.frame();
        let mut composer = Composer::new((1, 1));
        let frame = composer.frame(plane(
            "map",
            "",
            (0, 0),
            axis("u_p", "*u*_{p}", (x_0 - x, x_0 + x)),
            axis("u_p_dot", "*u*_{p}'", (y_0 - y, y_0 + y)),
        ));
        let place = |state: &[f64; 6]| (state[0], state[3]);
        let cut = self.transient();
        let mut seen = Thinning::new((x_0, y_0), (x, y), CELLS);
        let mut way = Points::default();
        way.cloud(self.states[..cut].iter().map(place).filter(|at| seen.first_there(*at)));
        let line = Line::new("trajectory", "points of the map on their way", Role::Trajectory);
        // Few points are looked at one by one, many as a cloud.
        let mark = if way.x.len() <= FEW { Mark::Marks } else { Mark::Cloud };
        composer.add(frame, mark, line, way);
        let mut seen = Thinning::new((x_0, y_0), (x, y), CELLS);
        let mut stays = Points::default();
        let late = if self.end == Some(End::Wandering) { &self.states[cut..] } else { &[] };
        stays.cloud(late.iter().map(place).filter(|at| seen.first_there(*at)));
        let line = Line::new("stays", "points of the map where the motion stays", Role::Attractor);
        composer.add(frame, Mark::Cloud, line, stays);
        let (period, stable) = match &self.end {
            Some(End::Orbit(orbit, _)) => (orbit.period, Some(true)),
            Some(End::Closed(period)) => (*period, None),
            _ => (0, None),
        };
        let meaning = format!("points of the motion of period {period}T");
        let line = Line::new("orbit", meaning, Role::Attractor);
        let name = if period == 1 { "period *T*".to_owned() } else { format!("period {period}*T*") };
        let line = line.label(&name, 0.0);
        let line = if let Some(stable) = stable { line.stable(stable) } else { line };
        composer.marks(frame, line, Points::plane(self.settled().iter().map(place)));
        if let Some(middle) = self.middle() {
            let kind = Centre::of(middle);
            let meaning = format!("the fixed point in the middle: {}", kind.name());
            let line = Line::new("fixed point", meaning, kind.role()).stable(middle.stable);
            composer.marks(frame, line.label(kind.name(), 0.5), Points::one(place(&middle.state)));
        }
        if let Some(first) = self.states.first() {
            let line = Line::new("start", "the start", Role::Handle).label("start", 0.0);
            composer.marks(frame, line, Points::one(place(first)));
        }
        composer.drawing()
    }

    fn summary(&self) -> String {
        let ends = match &self.end {
            Some(End::Closed(period)) => format!("The start lies on a motion of period {period}T"),
            Some(End::Orbit(orbit, points)) => match orbit.rest(NOTHING) {
                Some(u) => format!("The start comes to rest at u = {}", number(rounded_off(u), 5)),
                None => format!(
                    "The start ends in a stable motion of period {}T, one of whose points is u_p = {}, u_p' = {}",
                    orbit.period,
                    number(rounded_off(points[0][0]), 5),
                    number(rounded_off(points[0][3]), 5)
                ),
            },
            Some(End::Escaped(time)) => format!("The start escapes at t = {}", number(*time, 5)),
            Some(End::Wandering) => {
                let late = &self.states[self.transient()..];
                let reach = late.iter().fold(0.0_f64, |most, state| most.max(state[0].abs()));
                format!(
                    "The start settles on no motion of period up to 8T; its points stay within |u_p| of {}",
                    number(reach, 4)
                )
            }
            None => "The start is on its way".to_owned(),
        };
        match self.middle() {
            Some(middle) => format!(
                "{ends}; the fixed point in the middle is {}, its largest multiplier has magnitude {}.",
                article(Centre::of(middle)),
                number(middle.spectral_radius, 5)
            ),
            None => format!("{ends}."),
        }
    }

    fn facts(&self) -> Vec<(&'static str, Fact)> {
        let mut facts = Vec::new();
        if let Some(middle) = self.middle() {
            facts.push(("centre", Fact::Word(Centre::of(middle).name())));
            facts.push(("spectralRadius", Fact::Number(middle.spectral_radius)));
        }
        let (word, period) = match &self.end {
            Some(End::Closed(period)) => ("closed", Some(*period)),
            Some(End::Orbit(orbit, _)) => ("orbit", Some(orbit.period)),
            Some(End::Escaped(time)) => {
                facts.push(("escapedAt", Fact::Number(*time)));
                ("escaped", None)
            }
            Some(End::Wandering) => ("wandering", None),
            None => ("unknown", None),
        };
        facts.push(("end", Fact::Word(word)));
        facts.extend(period.map(|period| ("period", Fact::Number(period as f64))));
        let greatest = |orbit: &PeriodicOrbit| orbit.max[0].abs().max(orbit.min[0].abs());
        if let Some(End::Orbit(orbit, _)) = &self.end {
            facts.push(("maxU_p", Fact::Number(greatest(orbit))));
        }
        facts
    }
}

/// A coordinate, nought where only rounding keeps it from that.
fn rounded_off(value: f64) -> f64 {
    if value.abs() < NOTHING { 0.0 } else { value }
}

impl Slices for TrajectoryMap {
    fn advance(&mut self) -> Result<bool, FigureError> {
        if self.strobe.is_none() {
            self.begin()?;
        } else if self.end.is_none() {
            self.follow()?;
        } else {
            return Ok(true);
        }
        if self.centre.is_none() {
            self.centre = Some(multipliers(&self.parameters, TOLERANCE).map_err(|error| error.to_string()));
        }
        Ok(self.end.is_some())
    }

    fn figure(&self, id: &'static str, parameters: &Parameters) -> Figure {
        let Some(start) = self.states.first() else { return Figure::waiting(id, parameters) };
        let mut notes = Vec::new();
        if self.end.is_none() {
            notes.push(format!("{} periods computed so far.", self.states.len() - 1));
        }
        if let Some(Err(reason)) = &self.centre {
            notes.push(format!("No fixed point in the middle: {reason}."));
        }
        let error = match (&self.end, self.middle()) {
            (Some(End::Orbit(orbit, _)), _) => orbit.error,
            (_, Some(middle)) => middle.error,
            _ => ErrorEstimate::default(),
        };
        Figure {
            summary: self.summary(),
            method: "Taylor series from period to period to 1e-10; multipliers and orbits by the variational equations"
                .to_owned(),
            error,
            notes,
            facts: self.facts(),
            start: Some(*start),
            ..Figure::drawn(id, parameters, self.drawing())
        }
    }
}
