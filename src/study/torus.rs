//! Quasi-periodic motions: invariant circles of the stroboscopic map, their size, their rotation, their stability.
//!
//! The circle is seeded by a long motion, made exactly invariant by collocation ([`crate::numerics::torus`]), and its mean
//! radius and rotation are taken a second time, independently, as weighted Birkhoff averages of the long motion.

use std::f64::consts::TAU;

use super::ErrorEstimate;
use super::motion;
use super::multipliers::{Budget, common_period, image, multipliers, unloaded};
use super::poincare::Strobe;
use super::settling::{self, returning, stable_orbit};
use super::slices::{Slices, whole};
use super::sweep::at_frequency;
use crate::error::{NumericsError, StudyError};
use crate::model::equations::{GearPair, U};
use crate::model::lanes::{LANES, OnManifold, SIZE, lane, set_lane};
use crate::model::manifold::{self, Manifold};
use crate::model::parameters::{Parameters, Regime};
use crate::numerics::birkhoff;
use crate::numerics::lyapunov::orthonormalise;
use crate::numerics::ode::event;
use crate::numerics::ode::taylor::{Options, Propagation};
use crate::numerics::periodic::Image;
use crate::numerics::torus::{self, Circle, Map, Weights};
use crate::theory::{Modes, branches};

mod branch;
mod seed;
pub use branch::{TorusBranch, TorusBranchWork, TorusEnd, torus_branch};
pub use seed::Averages;

/// Coordinates that are left on the manifold `u_g = -u_p`.
const ON_MANIFOLD: [usize; 4] = [0, 2, 3, 5];
/// Most unknowns of the collocation: some tenths of a second's work at most.
const MOST_UNKNOWNS: usize = 800;
/// A circle whose defect stays above this part of its size is not believed.
const WORST_DEFECT: f64 = 1e-4;
/// A circle whose defect is above this part of its size is not smooth.
const SMOOTH: f64 = 1e-8;
/// Points on the circle over which its means and extremes are taken.
const SAMPLES: usize = 4096;
/// Points given as the curve.
const CURVE: usize = 256;
/// Steps that one search may take: a second or two.
const MOST_STEPS: usize = 1_200_000;
/// Steps of the map over which the growth across the circle is averaged.
const GROWTH_STEPS: usize = 2000;

/// An invariant circle of the stroboscopic map (several, where the map carries one into the next).
#[derive(Clone, Debug, PartialEq)]
pub struct Torus {
    /// Mean of `sqrt(u_p^2 + u_p'^2)` along the motion.
    pub mean_radius: f64,
    /// Its frequency over the mesh frequency, modulo 1 and up to sign: in [0, 1/2].
    pub rotation: f64,
    /// States along the circle, evenly spaced in its own angle; circle after circle.
    pub curve: Vec<[f64; 6]>,
    /// Whether neighbouring motions come near, in all six dimensions.
    pub stable: bool,
    /// The fastest growth across the circle, per unit of t: below 0 where it is stable.
    pub growth: f64,
    /// Least of `sqrt(u_p^2 + u_p'^2)` on the circle.
    pub r_min: f64,
    /// Greatest of it.
    pub r_max: f64,
    /// Greatest `|u_p|` along the motion, between the points of the map as well: from samples, to about 1e-4 of its size.
    pub max_u_p: f64,
    /// Greatest `|u|` along the motion, likewise.
    pub max_u: f64,
    /// Number of circles, that is mesh periods after which the map returns to the same one.
    pub circles: usize,
    /// The same by averages over a long motion; none where the circle does not attract one.
    pub averages: Option<Averages>,
    /// How it was computed.
    pub method: String,
    /// What is known of the error: `residual`, the greatest distance of the image of a point between nodes from the circle.
    pub error: ErrorEstimate,
}

/// The stroboscopic map, on the manifold `u_g = -u_p` where the circle is in it.
#[derive(Clone, Copy)]
struct Section<'a> {
    pair: GearPair,
    /// Mesh periods of one application.
    periods: usize,
    on_manifold: bool,
    tolerance: f64,
    budget: &'a Budget,
}

impl Section<'_> {
    fn dimension(&self) -> usize {
        self.coordinates().len()
    }

    fn coordinates(&self) -> &'static [usize] {
        if self.on_manifold { &ON_MANIFOLD } else { &[0, 1, 2, 3, 4, 5] }
    }

    fn expand(&self, point: &[f64]) -> [f64; 6] {
        if self.on_manifold {
            [point[0], -point[0], point[1], point[2], -point[2], point[3]]
        } else {
            std::array::from_fn(|i| point[i])
        }
    }

    fn reduce(&self, state: &[f64; 6], point: &mut [f64]) {
        for (place, &coordinate) in point.iter_mut().zip(self.coordinates()) {
            *place = state[coordinate];
        }
    }

    /// The end of one application of the map.
    fn end(&self) -> f64 {
        self.periods as f64 * self.pair.parameters.mesh_period()
    }

    /// The map and, where asked for, its derivative at several points, in the coordinates that are left.
    fn map(
        &self,
        points: &[f64],
        images: &mut [f64],
        derivatives: Option<&mut [f64]>,
    ) -> Result<(), NumericsError> {
        let dimension = self.dimension();
        let block = dimension * dimension;
        if let Some(rows) = derivatives {
            for (index, (point, image)) in
                points.chunks_exact(dimension).zip(images.chunks_exact_mut(dimension)).enumerate()
            {
                let (reached, matrix) = self.image(&self.expand(point))?;
                self.reduce(&reached, image);
                for (place, entry) in rows[index * block..(index + 1) * block].iter_mut().enumerate() {
                    let (row, column) = (place / dimension, place % dimension);
                    *entry = if self.on_manifold {
                        let (row, column) = (ON_MANIFOLD[row], ON_MANIFOLD[column]);
                        // A change of the pinion's coordinate changes the gear's the other way.
                        let opposite = if column == U || column == 5 { 0.0 } else { matrix[row][column + 1] };
                        matrix[row][column] - opposite
                    } else {
                        matrix[row][column]
                    };
                }
            }
            return Ok(());
        }
        let side_by_side = if self.on_manifold { OnManifold::new(&self.pair.parameters) } else { None };
        if let Some(field) = side_by_side {
            for (points, images) in points.chunks(LANES * dimension).zip(images.chunks_mut(LANES * dimension))
            {
                self.lanes(&field, points, images)?;
            }
            return Ok(());
        }
        for (point, image) in points.chunks_exact(dimension).zip(images.chunks_exact_mut(dimension)) {
            let state = self.expand(point);
            let reached = motion::carry(&self.pair, 0.0, state, self.end(), self.tolerance)?;
            self.spend(reached.steps)?;
            if let Some(time) = reached.escaped {
                return Err(NumericsError::Escaped { time });
            }
            self.reduce(&reached.state, image);
        }
        Ok(())
    }

    /// Takes off steps that were taken.
    fn spend(&self, steps: usize) -> Result<(), NumericsError> {
        self.budget.spend(steps);
        if self.budget.left() == 0 {
            return Err(NumericsError::TooManySteps { time: 0.0, steps });
        }
        Ok(())
    }

    /// The images of at most [`LANES`] points side by side.
    fn lanes(&self, field: &OnManifold, points: &[f64], images: &mut [f64]) -> Result<(), NumericsError> {
        let dimension = self.dimension();
        let mut all = [0.0; SIZE];
        for index in 0..LANES {
            // Lanes without a point repeat the first.
            let point = points.chunks_exact(dimension).nth(index).unwrap_or(&points[..dimension]);
            set_lane(&mut all, index, &self.expand(point));
        }
        let options = self.options();
        let mut propagation = Propagation::<_, SIZE, { motion::ORDER_16 }>::new(field, 0.0, all, options);
        let [bound, _] = self.pair.escape_bounds();
        while propagation.time() < self.end() {
            propagation.advance(self.end())?;
            self.spend(2)?;
            if propagation.state()[..LANES].iter().any(|u_p| u_p.abs() > bound) {
                return Err(NumericsError::Escaped { time: propagation.time() });
            }
        }
        for (index, image) in images.chunks_exact_mut(dimension).enumerate() {
            self.reduce(&lane(propagation.state(), index), image);
        }
        Ok(())
    }

    fn options(&self) -> Options {
        Options {
            tolerance: motion::step_tolerance(self.tolerance),
            step_factor: 1.0,
            steps: self.budget.left(),
        }
    }

    /// The image of a state and its derivative in all six dimensions.
    fn image(&self, state: &[f64; 6]) -> Result<Image, NumericsError> {
        let end = self.end();
        let narrow = if self.on_manifold { Manifold::of(&self.pair.parameters) } else { None };
        let Some(field) = narrow else {
            let before = self.budget.left();
            let image = image(&self.pair, state, self.periods, self.tolerance, 1.0, self.budget)?;
            // With its derivative a step costs as much as eight without.
            self.spend(7 * (before - self.budget.left()))?;
            return Ok(image);
        };
        let [bound, _] = self.pair.escape_bounds();
        let mut propagation = Propagation::<_, { manifold::SIZE }, { motion::ORDER_16 }>::new(
            &field,
            0.0,
            manifold::start(state),
            self.options(),
        );
        while propagation.time() < end {
            propagation.advance(end)?;
            self.spend(4)?;
            if propagation.state()[0].abs() > bound {
                return Err(NumericsError::Escaped { time: propagation.time() });
            }
        }
        Ok(manifold::split(propagation.state()))
    }

    /// Makes a circle invariant, with as many nodes as it takes.
    async fn converge(&self, mut circle: Circle) -> Result<(Circle, f64), NumericsError> {
        let map: &mut Map = &mut |point, to, derivative| self.map(point, to, derivative);
        let mut best: Option<(Circle, f64)> = None;
        loop {
            self.budget.rest().await;
            let size = circle.size();
            let options = torus::Options {
                tolerance: (10.0 * self.tolerance).max(1e-11) * (1.0 + size),
                iterations: 40,
            };
            let found = match circle.solve(options, map) {
                Ok(found) => found.circle,
                Err(error @ NumericsError::TooManySteps { .. }) => return Err(error),
                Err(error) => return best.ok_or(error),
            };
            if found.size() < 1e-3 * size {
                return Err(NumericsError::NoConvergence {
                    iterations: 0,
                    residual: found.size(),
                    tolerance: 1e-3 * size,
                });
            }
            let defect = found.defect(map, 1)?;
            let goal = (10.0 * self.tolerance).max(1e-10) * (1.0 + size);
            let better = best.as_ref().is_none_or(|(_, least)| defect < *least);
            // More nodes that do not help: the circle is not smooth, or rounding is reached.
            let stuck = best.as_ref().is_some_and(|(_, least)| defect > 0.3 * least);
            let count = if found.mirrored { 2 * found.count() } else { 2 * found.count() - 1 };
            if better {
                best = Some((found.clone(), defect));
            }
            if defect <= goal || stuck || count * found.dimension > MOST_UNKNOWNS {
                break;
            }
            circle = found.resampled(count);
        }
        let unfound = NumericsError::NoConvergence { iterations: 0, residual: f64::MAX, tolerance: 0.0 };
        let (circle, defect) = best.ok_or(unfound)?;
        if defect > WORST_DEFECT * (1.0 + circle.size()) {
            return Err(NumericsError::NoConvergence {
                iterations: 40,
                residual: defect,
                tolerance: WORST_DEFECT,
            });
        }
        Ok((circle, defect))
    }

    /// The fastest growth across the circle per unit of t, in all six dimensions.
    async fn growth(&self, circle: &Circle) -> Result<f64, NumericsError> {
        let count = circle.count();
        let mut derivatives = Vec::with_capacity(36 * count);
        for node in circle.nodes.chunks_exact(circle.dimension) {
            let (_, matrix) = self.image(&self.expand(node))?;
            derivatives.extend(matrix.into_iter().flatten());
            self.budget.rest().await;
        }
        // Of a mirrored circle both halves have the same derivatives.
        let turns = if circle.mirrored { 2.0 } else { 1.0 };
        let interpolation = Weights::new(count, false);
        let weights = birkhoff::weights(GROWTH_STEPS);
        let mut frame = [0.0; 36];
        (0..6).for_each(|i| frame[7 * i] = 1.0);
        let mut sums = [0.0; 6];
        let turning = GROWTH_STEPS / 4;
        for step in 0..turning + GROWTH_STEPS {
            let theta = (step as f64 * circle.rotation).rem_euclid(1.0);
            let mut derivative = [0.0; 36];
            interpolation.combine(turns * theta, &derivatives, &mut derivative);
            let mut image = [0.0; 36];
            for (row, to) in image.chunks_exact_mut(6).enumerate() {
                for inner in 0..6 {
                    let factor = derivative[6 * row + inner];
                    for column in 0..6 {
                        to[column] += factor * frame[6 * inner + column];
                    }
                }
            }
            frame = image;
            let logarithms: [f64; 6] = orthonormalise(&mut frame, 6);
            if let Some(index) = step.checked_sub(turning) {
                for (sum, logarithm) in sums.iter_mut().zip(logarithms) {
                    *sum += weights[index] * logarithm;
                }
            }
        }
        // One of the six belongs to the direction along the circle, in which nothing grows.
        let along = (0..6).min_by(|&i, &j| sums[i].abs().total_cmp(&sums[j].abs())).unwrap_or(0);
        let across = (0..6).filter(|&i| i != along).map(|i| sums[i]).fold(f64::NEG_INFINITY, f64::max);
        if !across.is_finite() {
            return Err(NumericsError::NotFinite { time: 0.0 });
        }
        Ok(across / (self.periods as f64 * self.pair.parameters.mesh_period()))
    }
}

/// A circle with the map that it belongs to.
#[derive(Clone)]
struct Known<'a> {
    section: Section<'a>,
    circle: Circle,
    defect: f64,
    averages: Option<Averages>,
    /// Whether collocation has made the circle invariant; else it is the averages' own.
    collocated: bool,
}

/// The invariant circle at these parameters: the one that a motion from near rest or from the cycle of \[T8\] comes to,
/// else the one that continues that at the nearest mesh frequency at which the unloaded state is an unstable spiral.
///
/// # Errors
/// [`StudyError::Option`] for a tolerance out of range, [`StudyError::Model`] for an incommensurate load,
/// [`StudyError::NotFound`] where there is no such motion, [`StudyError::Numerics`] where the integration fails.
pub fn torus(p: &Parameters, tolerance: f64) -> Result<Torus, StudyError> {
    motion::check_tolerance(tolerance)?;
    let budget = Budget::of(MOST_STEPS);
    whole(async { describe(&find(p, tolerance, &budget).await?).await })
}

/// [`torus()`], a slice at a time.
#[derive(Debug)]
pub struct TorusWork {
    slices: Slices<Result<Torus, StudyError>>,
}

impl TorusWork {
    /// Nothing is done yet.
    ///
    /// # Errors
    /// [`StudyError::Option`] for a tolerance out of range.
    pub fn new(p: &Parameters, tolerance: f64) -> Result<Self, StudyError> {
        motion::check_tolerance(tolerance)?;
        let p = *p;
        let slices = Slices::new(async move {
            let budget = Budget::of(MOST_STEPS);
            describe(&find(&p, tolerance, &budget).await?).await
        });
        Ok(Self { slices })
    }

    /// Does a slice of some milliseconds; the answer at the end, once, as [`torus()`] gives it.
    pub fn advance(&mut self) -> Option<Result<Torus, StudyError>> {
        self.slices.advance()
    }
}

async fn find<'a>(p: &Parameters, tolerance: f64, budget: &'a Budget) -> Result<Known<'a>, StudyError> {
    if GearPair::new(p).trace() == 0.0 {
        return Err(StudyError::NotFound {
            sought: "isolated torus",
            found: "without damping quasi-periodic motions come in families".into(),
        });
    }
    match seed::by_motion(p, tolerance, budget).await {
        Err(StudyError::NotFound { sought, found }) => {
            from_neighbours(p, tolerance, budget).await?.ok_or(StudyError::NotFound { sought, found })
        }
        known => known,
    }
}

/// Mesh frequencies, relative to the one asked for, at which a spiral is looked for: nearest first.
const NEIGHBOURS: usize = 12;
/// Distance of these, relative.
const NEIGHBOUR_SPACING: f64 = 0.01;

/// Steps of a period above which no neighbours are asked.
const MOST_LINEAR_STEPS: usize = 1000;

/// The circle followed in Omega from a neighbouring frequency at which the trivial state is an unstable spiral.
async fn from_neighbours<'a>(
    p: &Parameters,
    tolerance: f64,
    budget: &'a Budget,
) -> Result<Option<Known<'a>>, StudyError> {
    if !unloaded(p) {
        return Ok(None);
    }
    // Where a period takes so many steps, the linear problem does as well, at each of these frequencies.
    let one = motion::carry(&GearPair::new(p), 0.0, motion::default_state(p), p.mesh_period(), tolerance)?;
    if one.steps > MOST_LINEAR_STEPS {
        return Ok(None);
    }
    for index in 2..=2 * NEIGHBOURS + 1 {
        let distance = (index / 2) as f64 * NEIGHBOUR_SPACING * if index % 2 == 0 { 1.0 } else { -1.0 };
        let neighbour = at_frequency(p, p.omega * (1.0 + distance));
        budget.rest().await;
        let linear = multipliers(&neighbour, tolerance)?;
        if linear.spectral_radius < 1.0 || linear.im[0].abs() < 1e-3 {
            continue;
        }
        return match seed::by_motion(&neighbour, tolerance, budget).await {
            Ok(known) => {
                let (at, _) = branch::follow(p, known, None, p.omega).await;
                Ok((at.omega() == p.omega).then_some(at))
            }
            Err(StudyError::NotFound { .. }) => Ok(None),
            Err(error) => Err(error),
        };
    }
    Ok(None)
}

/// Everything that is asked of a circle.
async fn describe(known: &Known<'_>) -> Result<Torus, StudyError> {
    let Known { section, circle, defect, averages, collocated } = known;
    let growth = section.growth(circle).await?;
    let (mut curve, mut radii) = (Vec::new(), Vec::with_capacity(SAMPLES * section.periods));
    let mut nodes = Vec::new();
    let interpolation = Weights::new(circle.count(), circle.mirrored);
    for index in 0..SAMPLES {
        let mut point = [0.0; 6];
        let theta = index as f64 / SAMPLES as f64;
        interpolation.combine(theta, &circle.nodes, &mut point[..circle.dimension]);
        let state = section.expand(&point);
        radii.push(state[0].hypot(state[3]));
        if index % (SAMPLES / CURVE) == 0 {
            nodes.push(state);
        }
    }
    // The other circles are images of the first.
    let one = Section { periods: 1, pair: section.pair, ..*section };
    let p = &section.pair.parameters;
    let common = common_period(p)?;
    let (mut max_u_p, mut max_u) = (Peaks::default(), Peaks::default());
    for period in 0..section.periods {
        if period > 0 {
            radii.extend(nodes.iter().map(|state| state[0].hypot(state[3])));
        }
        curve.extend_from_slice(&nodes);
        for (index, state) in nodes.iter_mut().enumerate() {
            if circle.mirrored && index >= CURVE / 2 {
                // The mirror image of the first half reaches as far.
                break;
            }
            section.budget.rest().await;
            let (reached, peaks) = one.extremes(state, (period % common) as f64 * p.mesh_period())?;
            max_u_p.push(period, peaks[0]);
            max_u.push(period, peaks[1]);
            *state = reached;
        }
    }
    let (of_circle, r_min, r_max) = radius(&radii);
    let turned =
        seed::rotation(circle.rotation, section.periods, averages.as_ref().map(|means| means.rotation));
    // A circle that is not smooth is known better by its averages than by its Fourier series.
    let (mean_radius, rotation) = match averages {
        Some(means) if *defect > SMOOTH * (1.0 + circle.size()) => (means.mean_radius, means.rotation),
        _ => (of_circle, turned),
    };
    Ok(Torus {
        mean_radius,
        rotation,
        curve,
        stable: growth < 0.0,
        growth,
        r_min,
        r_max,
        max_u_p: max_u_p.greatest(),
        max_u: max_u.greatest(),
        circles: section.periods,
        averages: *averages,
        method: if *collocated {
            format!(
                "collocation of {} Fourier nodes on the stroboscopic map, variational Taylor series",
                circle.count() * if circle.mirrored { 2 } else { 1 }
            )
        } else {
            "weighted Birkhoff averages along a long motion, the circle by its Fourier series".into()
        },
        error: ErrorEstimate { residual: Some(*defect), ..ErrorEstimate::default() },
    })
}

/// Mean, least and greatest of the radius: of the first circle from evenly spaced samples, whose plain mean is exact to
/// rounding for a smooth function, and of the others' samples in their turn.
fn radius(radii: &[f64]) -> (f64, f64, f64) {
    let (first, others) = radii.split_at(SAMPLES.min(radii.len()));
    let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len().max(1) as f64;
    let mut means = mean(first);
    let (mut least, mut greatest) = (f64::INFINITY, f64::NEG_INFINITY);
    let circles = 1 + others.len() / CURVE;
    for circle in std::iter::once(first).chain(others.chunks(CURVE)) {
        least = least.min(-peak(&circle.iter().map(|radius| -radius).collect::<Vec<_>>()));
        greatest = greatest.max(peak(circle));
    }
    if circles > 1 {
        means = (means + others.chunks(CURVE).map(mean).sum::<f64>()) / circles as f64;
    }
    (means, least, greatest)
}

/// The greatest value of a smooth closed series, by the parabola through its greatest sample and its neighbours.
fn peak(values: &[f64]) -> f64 {
    let count = values.len();
    let Some(at) = (0..count).max_by(|&i, &j| values[i].total_cmp(&values[j])) else {
        return f64::NEG_INFINITY;
    };
    let (before, here, after) = (values[(at + count - 1) % count], values[at], values[(at + 1) % count]);
    let curvature = before - 2.0 * here + after;
    if curvature >= 0.0 { here } else { here - (after - before).powi(2) / (8.0 * curvature) }
}

/// The same from fewer samples, by the trigonometric interpolation near the greatest.
fn finer_peak(values: &[f64]) -> f64 {
    let count = values.len();
    let at = (0..count).max_by(|&i, &j| values[i].total_cmp(&values[j])).unwrap_or(0);
    let interpolation = Weights::new(count, false);
    let near: Vec<f64> = (-16..=16)
        .map(|offset| {
            let mut sum = [0.0];
            let theta = (at as f64 + f64::from(offset) / 16.0) / count as f64;
            interpolation.combine(theta, values, &mut sum);
            sum[0]
        })
        .collect();
    peak(&near)
}

/// Greatest values along the motion, circle by circle.
#[derive(Default)]
struct Peaks {
    circles: Vec<Vec<f64>>,
}

impl Peaks {
    fn push(&mut self, circle: usize, value: f64) {
        if self.circles.len() <= circle {
            self.circles.push(Vec::new());
        }
        self.circles[circle].push(value);
    }

    fn greatest(&self) -> f64 {
        self.circles.iter().map(|values| finer_peak(values)).fold(0.0, f64::max)
    }
}

impl Section<'_> {
    /// The state a mesh period later, and the greatest `|u_p|` and `|u|` in between.
    fn extremes(&self, state: &[f64; 6], start: f64) -> Result<([f64; 6], [f64; 2]), NumericsError> {
        let mut peaks = [0.0_f64; 2];
        let options = self.options();
        let end = start + self.pair.parameters.mesh_period();
        let reached =
            motion::follow::<{ motion::ORDER_16 }>(&self.pair, start, *state, end, options, |step, _| {
                for (peak, coordinate) in peaks.iter_mut().zip([0, U]) {
                    let (low, high) = event::range(&step.coordinate(coordinate), step.length);
                    *peak = peak.max(high).max(-low);
                }
            })?;
        self.budget.spend(reached.steps);
        Ok((reached.state, peaks))
    }
}
