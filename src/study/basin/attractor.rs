//! Attractors, how they are found, and how a motion is seen to have come to one.

use super::BasinOptions;
use crate::error::StudyError;
use crate::model::equations::{GearPair, U};
use crate::model::parameters::Parameters;
use crate::numerics::contraction::Ellipsoid;
use crate::numerics::floquet::Spectrum;
use crate::order;
use crate::study::gap::Gap;
use crate::study::motion;
use crate::study::multipliers::{Budget, image};
use crate::study::orbit::PeriodicOrbit;
use crate::study::settling::{self, LONGEST, size, stable_orbit};
use crate::study::time_response::largest_difference;

/// Periods, besides those of the options, for which a start is followed in search of attractors.
const SEARCHING: usize = 600;
/// Periods after which an orbit is looked for the first time.
const FIRST_TRY: usize = 24;
/// How near, relative to its size, a motion must come back to look for an orbit there.
const RETURNING: f64 = 0.1;
/// Points kept of an attractor that never repeats.
const POINTS: usize = 1024;
/// A motion this near those points, relative to its size, for some periods in a row, has come to the attractor.
const CLOSE: f64 = 0.03;
/// Periods in a row that a motion must be near those points.
const IN_A_ROW: usize = 6;
/// Widest half-axis, relative to the orbit's size, of the least neighbourhood that is tried, and of the greatest.
const NEIGHBOURHOOD: (f64, f64) = (1e-3, 4.0);
/// Tolerance of the orbits.
const TOLERANCE: f64 = 1e-10;
/// Two attractors nearer than this, relative to their size, are one.
const SAME: f64 = 1e-5;

/// What an attractor is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AttractorKind {
    /// A periodic orbit.
    Orbit {
        /// Its period, in mesh periods.
        period: usize,
    },
    /// The motions inside the tooth gap that differ by a displacement of u and nothing else: a continuous family of periodic
    /// orbits, to one or another of which all come. Without load they are the rests.
    Gap {
        /// Their period, in mesh periods.
        period: usize,
    },
    /// A motion that does not repeat itself: quasi-periodic, or chaotic.
    Torus,
}

/// An attractor.
#[derive(Clone, Debug, PartialEq)]
pub struct Attractor {
    /// What it is.
    pub kind: AttractorKind,
    /// A state of it at t = 0; of a family that of the orbit in the middle of the gap.
    pub state: [f64; 6],
    /// Its stroboscopic points in the order in which they follow, the state the first.
    pub points: Vec<[f64; 6]>,
    /// Real parts of the multipliers over its period, largest modulus first; of orbits only. Of a family the first is one.
    pub re: [f64; 6],
    /// Imaginary parts.
    pub im: [f64; 6],
}

/// Coordinates and velocities below this are those of rest.
const RESTING: f64 = 1e-8;

impl Attractor {
    /// Whether it is the rests inside the tooth gap.
    pub fn is_rest_in_gap(&self) -> bool {
        let still = self.state.iter().enumerate().all(|(index, value)| index == U || value.abs() < RESTING);
        matches!(self.kind, AttractorKind::Gap { .. }) && still
    }
}

/// An attractor and how it is recognised.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Known {
    pub attractor: Attractor,
    /// About the points of an orbit, in their order; a point without one has none that could be shown to contract.
    balls: Vec<Option<Ellipsoid>>,
    /// Coordinates in which the balls live: four on the manifold `u_g = -u_p`.
    coordinates: Vec<usize>,
    /// Of an attractor that never repeats: how far its points are apart.
    spacing: f64,
    /// Of a family inside the tooth gap.
    gap: Option<Gap>,
}

/// How long a motion has been near each attractor that never repeats.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Arrival {
    near: Vec<u16>,
}

/// The attractor that a motion has come to, and the number of the orbit's point at which it would have started.
pub(super) fn arrived(
    p: &Parameters,
    known: &[Known],
    state: &[f64; 6],
    periods: usize,
    common: usize,
    arrival: &mut Arrival,
) -> Option<(usize, u8)> {
    if !periods.is_multiple_of(common) {
        return None;
    }
    for (index, candidate) in known.iter().enumerate() {
        match candidate.attractor.kind {
            AttractorKind::Orbit { period } | AttractorKind::Gap { period } => {
                if let Some(point) = candidate.point_near(p, state, common) {
                    let phase = (point + period - periods % period) % period;
                    return Some((index, phase as u8));
                }
            }
            AttractorKind::Torus => {
                if arrival.near.len() < known.len() {
                    arrival.near.resize(known.len(), 0);
                }
                let near = candidate.is_near(state);
                arrival.near[index] = if near { arrival.near[index] + 1 } else { 0 };
                if usize::from(arrival.near[index]) >= IN_A_ROW {
                    return Some((index, 0));
                }
            }
        }
    }
    None
}

/// By how much a motion that comes to an orbit draws nearer until that is seen.
const NEARER: f64 = 1e4;

impl Known {
    /// Periods in which a motion comes near, by the slowest multiplier of an orbit.
    pub(super) fn patience(&self) -> Option<f64> {
        let (period, slowest) = match self.attractor.kind {
            AttractorKind::Orbit { period } => (period, 0),
            AttractorKind::Gap { period } => (period, 1),
            AttractorKind::Torus => return None,
        };
        let rate = -self.attractor.re[slowest].hypot(self.attractor.im[slowest]).ln() / period as f64;
        (rate > 0.0).then(|| NEARER.ln() / rate)
    }

    /// The point of the orbit to which a motion comes that is at this state.
    fn point_near(&self, p: &Parameters, state: &[f64; 6], common: usize) -> Option<usize> {
        if let Some(gap) = self.gap {
            let points = &self.attractor.points;
            return (0..points.len()).step_by(common).find(|&index| gap.holds(p, &points[index], state));
        }
        let mut reduced = [0.0; 6];
        let count = self.coordinates.len();
        for (place, &coordinate) in reduced.iter_mut().zip(&self.coordinates) {
            *place = state[coordinate];
        }
        self.balls.iter().position(|ball| ball.as_ref().is_some_and(|ball| ball.contains(&reduced[..count])))
    }

    fn is_near(&self, state: &[f64; 6]) -> bool {
        let limit = self.spacing;
        self.attractor
            .points
            .iter()
            .any(|point| (state[0] - point[0]).abs() < limit && largest_difference(state, point) < limit)
    }
}

/// What a search for attractors needs to know.
#[derive(Clone, Copy, Debug)]
pub(super) struct Search {
    pub pair: GearPair,
    pub options: BasinOptions,
    pub common: usize,
    pub mirrored: bool,
}

/// Follows a start in search of an attractor that is not known yet.
pub(super) async fn explore(
    search: &Search,
    start: [f64; 6],
    known: &mut Vec<Known>,
    budget: &Budget,
) -> Result<(), StudyError> {
    let Search { pair, options, common, mirrored } = search;
    let common = *common;
    let p = &pair.parameters;
    let period = p.mesh_period();
    let tolerance = options.tolerance.min(1e-8);
    if motion::check_state(pair, &start).is_err() {
        return Ok(());
    }
    let mut states = vec![start];
    let mut arrival = Arrival::default();
    let mut next_try = FIRST_TRY;
    let most = options.periods.unwrap_or(0).max(SEARCHING);
    for count in 1..=most + POINTS {
        let phase = ((count - 1) % common) as f64 * period;
        let Ok(reached) = motion::carry(pair, phase, states[count - 1], phase + period, tolerance) else {
            budget.spend(super::FAILED);
            return Ok(());
        };
        budget.spend(reached.steps);
        if reached.escaped.is_some() || budget.left() == 0 {
            return Ok(());
        }
        budget.rest().await;
        states.push(reached.state);
        if arrived(p, known, &reached.state, count, common, &mut arrival).is_some() {
            return Ok(());
        }
        if count != next_try || count > most || !count.is_multiple_of(common) {
            next_try += usize::from(count == next_try);
            continue;
        }
        next_try = next_try * 3 / 2 + 7;
        let Some(lag) = best_return(&states, common) else { continue };
        if let Some(orbit) = stable_orbit(p, reached.state, lag, RETURNING, TOLERANCE, budget) {
            add_orbit(search, orbit, known, budget).await?;
        }
    }
    let last = states[states.len() - 1];
    let points: Vec<[f64; 6]> = states[states.len() - POINTS..].to_vec();
    if let Some(orbit) = settling::drawn_to(p, &points, (common, LONGEST), TOLERANCE, budget) {
        return add_orbit(search, orbit, known, budget).await;
    }
    let attractor = Attractor { kind: AttractorKind::Torus, state: last, points, re: [0.0; 6], im: [0.0; 6] };
    let spacing = spacing(&attractor.points).max(CLOSE * size(&last));
    let add = |attractor: Attractor, known: &mut Vec<Known>| {
        // The last points are near an attractor known already: slowly arrived there.
        let tail = &attractor.points[POINTS - POINTS / 8..];
        let same = |other: &Known| {
            other.attractor.kind == AttractorKind::Torus && tail.iter().all(|state| other.is_near(state))
        };
        if !known.iter().any(same) {
            known.push(Known { attractor, balls: Vec::new(), coordinates: Vec::new(), spacing, gap: None });
        }
    };
    let image = mirrored.then(|| mirror(&attractor));
    add(attractor, known);
    if let Some(image) = image {
        add(image, known);
    }
    Ok(())
}

/// The number of periods, at most [`LONGEST`] or the common period, after which the last point came back best, if near.
fn best_return(states: &[[f64; 6]], common: usize) -> Option<usize> {
    let (last, earlier) = states.split_last()?;
    let distance = |lag: &usize| largest_difference(last, &earlier[earlier.len() - lag]);
    let lags = (1..=LONGEST.max(common).min(earlier.len())).filter(|lag| lag.is_multiple_of(common));
    // A multiple of the true period comes back a little better while the motion still settles: not preferred.
    let weighted = |lag: &usize| distance(lag) * (1.0 + 0.2 * *lag as f64);
    lags.min_by(|a, b| weighted(a).total_cmp(&weighted(b)))
        .filter(|lag| distance(lag) < RETURNING * size(last))
}

/// The mirror image under `u -> -u`.
fn mirror(attractor: &Attractor) -> Attractor {
    Attractor {
        state: attractor.state.map(|value| -value),
        points: attractor.points.iter().map(|point| point.map(|value| -value)).collect(),
        ..attractor.clone()
    }
}

fn is_same_orbit(left: &Attractor, right: &Attractor) -> bool {
    let near = SAME * size(&left.state);
    left.kind == right.kind && right.points.iter().any(|point| largest_difference(point, &left.state) < near)
}

async fn add_orbit(
    search: &Search,
    orbit: PeriodicOrbit,
    known: &mut Vec<Known>,
    budget: &Budget,
) -> Result<(), StudyError> {
    let period = search.pair.parameters.mesh_period();
    let (orbit, gap) = match Gap::of(&search.pair.parameters, &orbit, TOLERANCE) {
        Some((gap, middle)) => (middle, Some(gap)),
        None => (orbit, None),
    };
    let spectrum = Spectrum { re: orbit.re, im: orbit.im };
    let mut points = vec![orbit.state];
    for index in 1..orbit.period {
        let phase = ((index - 1) % search.common) as f64 * period;
        points.push(motion::carry(&search.pair, phase, points[index - 1], phase + period, TOLERANCE)?.state);
    }
    let attractor = Attractor {
        kind: match gap {
            Some(_) => AttractorKind::Gap { period: orbit.period },
            None => AttractorKind::Orbit { period: orbit.period },
        },
        state: orbit.state,
        points,
        re: orbit.re,
        im: orbit.im,
    };
    let images = if search.mirrored { vec![mirror(&attractor)] } else { Vec::new() };
    for attractor in std::iter::once(attractor).chain(images) {
        if !known.iter().any(|other| is_same_orbit(&attractor, &other.attractor)) {
            known.push(Known { gap, ..recognised(search, attractor, &spectrum, budget).await? });
        }
    }
    Ok(())
}

/// An orbit with neighbourhoods of its points that the map of its period contracts.
async fn recognised(
    search: &Search,
    attractor: Attractor,
    spectrum: &Spectrum,
    budget: &Budget,
) -> Result<Known, StudyError> {
    let Search { pair, options, common, .. } = search;
    let p = &pair.parameters;
    let AttractorKind::Orbit { period } = attractor.kind else {
        return Ok(Known { attractor, balls: Vec::new(), coordinates: Vec::new(), spacing: 0.0, gap: None });
    };
    let on_manifold = stays_on_manifold(pair, options, &attractor.state);
    let coordinates: Vec<usize> = if on_manifold { vec![0, 2, 3, 5] } else { (0..6).collect() };
    let length = period as f64 * p.mesh_period();
    let tolerance = options.tolerance;
    let mut balls = Vec::with_capacity(period);
    for (index, point) in attractor.points.iter().enumerate() {
        if index % common != 0 {
            balls.push(None);
            continue;
        }
        let (_, rows) = image(pair, point, period, TOLERANCE, 1.0, &Budget::default())?;
        let mut linear = Vec::with_capacity(coordinates.len().pow(2));
        for &row in &coordinates {
            for &column in &coordinates {
                let opposite =
                    if on_manifold && (column == 0 || column == 3) { rows[row][column + 1] } else { 0.0 };
                linear.push(rows[row][column] - opposite);
            }
        }
        let reduce = |state: &[f64; 6]| -> Vec<f64> { coordinates.iter().map(|&c| state[c]).collect() };
        let expand = |x: &[f64]| -> [f64; 6] {
            if on_manifold { [x[0], -x[0], x[1], x[2], -x[2], x[3]] } else { std::array::from_fn(|i| x[i]) }
        };
        let mut ball = Ellipsoid::new(&reduce(point), &linear, spectrum.radius());
        if let Some(ball) = &mut ball {
            let scale = size(point);
            let mut growth = ball.growth(NEIGHBOURHOOD.0 * scale, NEIGHBOURHOOD.1 * scale);
            let map = &mut |x: &[f64]| {
                if budget.left() == 0 {
                    return None;
                }
                let reached = motion::carry(pair, 0.0, expand(x), length, tolerance);
                budget.spend(reached.as_ref().map_or(super::FAILED, |reached| reached.steps));
                reached.ok().filter(|reached| reached.escaped.is_none()).map(|reached| reduce(&reached.state))
            };
            while ball.grow(&mut growth, map) {
                budget.rest().await;
            }
        }
        balls.push(ball);
    }
    Ok(Known { attractor, balls, coordinates, spacing: 0.0, gap: None })
}

/// Whether all starts, and this orbit, are on the manifold `u_g = -u_p`, and stay there.
fn stays_on_manifold(pair: &GearPair, options: &BasinOptions, orbit: &[f64; 6]) -> bool {
    let opposed = |state: &[f64; 6], near: f64| {
        (state[0] + state[1]).abs() <= near && (state[3] + state[4]).abs() <= near
    };
    pair.parameters.symmetric().is_ok()
        && super::starts_on_manifold(options)
        && opposed(orbit, 1e-9 * size(orbit))
}

/// The attractor that is the mirror image of another, and the phase that each of its phases turns into.
pub(super) fn mirror_image(known: &Known, all: &[Known]) -> (i32, Vec<u8>) {
    let image = mirror(&known.attractor);
    let found = all.iter().enumerate().find_map(|(index, other)| match image.kind {
        AttractorKind::Torus => {
            let same = other.attractor.kind == image.kind
                && image.points[POINTS - POINTS / 8..].iter().all(|state| other.is_near(state));
            same.then(|| (super::number(index), vec![0]))
        }
        AttractorKind::Orbit { period } | AttractorKind::Gap { period } => {
            if !is_same_orbit(&image, &other.attractor) {
                return None;
            }
            let near = SAME * size(&image.state);
            let shift = other
                .attractor
                .points
                .iter()
                .position(|point| largest_difference(point, &image.state) < near)?;
            Some((super::number(index), (0..period).map(|phase| ((phase + shift) % period) as u8).collect()))
        }
    });
    found.unwrap_or((super::UNDECIDED, vec![0]))
}

/// Twice the greatest distance of a point from its nearest neighbour, gaps of a few stragglers left out.
fn spacing(points: &[[f64; 6]]) -> f64 {
    let mut nearest: Vec<f64> = points
        .iter()
        .enumerate()
        .map(|(index, point)| {
            let others = points.iter().enumerate().filter(|(other, _)| *other != index);
            others.map(|(_, other)| largest_difference(point, other)).fold(f64::INFINITY, f64::min)
        })
        .collect();
    order::ascending(&mut nearest);
    2.0 * nearest[(nearest.len() * 98 / 100).min(nearest.len() - 1)]
}
