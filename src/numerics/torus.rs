//! Invariant circles of a map: a closed curve x(theta) that the map carries onto itself by a turn,
//! `P(x(theta)) = x(theta + rotation)`, by collocation at evenly spaced nodes of a Fourier series.
//!
//! Unknown are the curve at the nodes and the rotation; the nodes' images must lie on the curve, and one condition
//! fixes where theta begins. The curve may be known to be its own mirror image, `x(theta + 1/2) = -x(theta)`: then it
//! has odd harmonics only, and nodes on one half of it do. Source of the method: F. Schilder, H. M. Osinga, W. Vogt,
//! Continuation of quasi-periodic invariant tori, SIAM Journal on Applied Dynamical Systems 4 (2005) 459-488, doi
//! 10.1137/040611240, section 3; departure: by trigonometric interpolation instead of finite differences.

use super::elimination::Factors;
use crate::error::NumericsError;
use std::f64::consts::{PI, TAU};

/// A closed curve by its values at nodes, evenly spaced in theta.
#[derive(Clone, Debug, PartialEq)]
pub struct Circle {
    /// Coordinates of a point.
    pub dimension: usize,
    /// `x(theta + 1/2) = -x(theta)`; the nodes are then on the first half of the circle.
    pub mirrored: bool,
    /// The nodes, each of `dimension` numbers: an odd number of nodes, or, mirrored, an even one.
    pub nodes: Vec<f64>,
    /// Turns of theta at each application of the map.
    pub rotation: f64,
}

/// What the map does to several points, one after the other in one row: their images, and, where asked for, the
/// derivative at each by rows.
pub type Map<'a> = dyn FnMut(&[f64], &mut [f64], Option<&mut [f64]>) -> Result<(), NumericsError> + 'a;

/// Bounds of the search.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// Largest distance of a node's image from the curve at which the search may stop.
    pub tolerance: f64,
    /// Greatest number of times that all images are computed.
    pub iterations: usize,
}

/// What the search came to.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// The curve.
    pub circle: Circle,
    /// Largest distance of a node's image from the curve.
    pub residual: f64,
    /// Times that all images were computed.
    pub iterations: usize,
}

/// Trigonometric interpolation from evenly spaced nodes: of functions of period 1 from any number of nodes, or, mirrored,
/// of functions that change sign over half a period, from an even number on its first half.
#[derive(Clone, Debug, PartialEq)]
pub struct Weights {
    mirrored: bool,
    /// Sine and cosine of the angle of each node in which the function's own denominator turns.
    nodes: Vec<(f64, f64)>,
}

impl Weights {
    /// For so many nodes.
    pub fn new(count: usize, mirrored: bool) -> Self {
        Self { mirrored, nodes: (0..count).map(|node| (PI * node as f64 / count as f64).sin_cos()).collect() }
    }

    /// Adds to `sums` the interpolated values at theta; `values` holds as many numbers a node as there are sums.
    pub fn combine(&self, theta: f64, values: &[f64], sums: &mut [f64]) {
        let count = self.nodes.len();
        let theta = theta - theta.floor();
        let angle = if self.mirrored { TAU * theta } else { PI * theta };
        let (sine, cosine) = angle.sin_cos();
        let even = !self.mirrored && count.is_multiple_of(2);
        let numerator = (count as f64 * angle).sin() / count as f64;
        let mut sign = 1.0;
        for (&(node_sine, node_cosine), values) in self.nodes.iter().zip(values.chunks_exact(sums.len())) {
            // Sine and cosine of the distance from the node; the numerator there is the same up to its sign.
            let distance = sine * node_cosine - cosine * node_sine;
            let along = cosine * node_cosine + sine * node_sine;
            if distance.abs() < 1e-9 {
                // At a node, or, mirrored, half a turn from it.
                let weight = if self.mirrored && along < 0.0 { -1.0 } else { 1.0 };
                for (sum, value) in sums.iter_mut().zip(values) {
                    *sum = weight * value;
                }
                return;
            }
            let weight = sign * numerator * if even { along } else { 1.0 } / distance;
            for (sum, value) in sums.iter_mut().zip(values) {
                *sum += weight * value;
            }
            sign = -sign;
        }
    }
}

/// Value and derivative by theta of the interpolation weight of the node at 0, as the sum of its harmonics; for an odd
/// count, or mirrored.
fn cardinal_and_slope(count: usize, mirrored: bool, theta: f64) -> (f64, f64) {
    let (mut value, mut slope) = (if mirrored { 0.0 } else { 1.0 }, 0.0);
    let harmonics = count / 2;
    for index in 0..harmonics {
        let harmonic = if mirrored { 2 * index + 1 } else { index + 1 } as f64;
        let (sine, cosine) = (TAU * (harmonic * theta).fract()).sin_cos();
        value += 2.0 * cosine;
        slope -= 2.0 * TAU * harmonic * sine;
    }
    (value / count as f64, slope / count as f64)
}

impl Circle {
    /// Number of nodes.
    pub fn count(&self) -> usize {
        self.nodes.len() / self.dimension
    }

    /// theta of a node.
    pub fn theta(&self, node: usize) -> f64 {
        node as f64 / (self.count() * if self.mirrored { 2 } else { 1 }) as f64
    }

    /// The point at theta.
    pub fn point(&self, theta: f64) -> Vec<f64> {
        let mut point = vec![0.0; self.dimension];
        let weights = Weights::new(self.count(), self.mirrored);
        weights.combine(theta, &self.nodes, &mut point);
        point
    }

    /// The same curve by another number of nodes.
    #[must_use]
    pub fn resampled(&self, count: usize) -> Self {
        let mut other = Self { nodes: Vec::with_capacity(count * self.dimension), ..self.clone() };
        let spacing = 1.0 / (count * if self.mirrored { 2 } else { 1 }) as f64;
        for node in 0..count {
            other.nodes.extend(self.point(node as f64 * spacing));
        }
        other
    }

    /// Largest coordinate of the nodes, at least the smallest positive number.
    pub fn size(&self) -> f64 {
        self.nodes.iter().fold(f64::MIN_POSITIVE, |most, value| most.max(value.abs()))
    }

    /// Largest distance of the image of a point halfway between nodes from the curve: how far the curve is from
    /// invariant where nobody made it so. Every `stride`-th gap between nodes is looked at.
    ///
    /// # Errors
    /// As the map.
    pub fn defect(&self, map: &mut Map, stride: usize) -> Result<f64, NumericsError> {
        let halfway = |node: usize| 0.5 * (self.theta(node) + self.theta(node + 1));
        let between = || (0..self.count()).step_by(stride.max(1));
        let points: Vec<f64> = between().flat_map(|node| self.point(halfway(node))).collect();
        let mut images = vec![0.0; points.len()];
        map(&points, &mut images, None)?;
        let expected = between().flat_map(|node| self.point(halfway(node) + self.rotation));
        // Not a number stays visible, which a maximum would hide.
        let most = images.iter().zip(expected).fold(0.0_f64, |most, (found, wanted)| {
            let distance = (found - wanted).abs();
            if distance.is_finite() { most.max(distance) } else { f64::INFINITY }
        });
        if most.is_finite() { Ok(most) } else { Err(NumericsError::NotFinite { time: 0.0 }) }
    }

    /// Interpolation weights, and their derivatives by the rotation, from the nodes to the nodes turned on: by the
    /// difference of the two nodes' numbers, from `-(count - 1)` on.
    fn turned(&self) -> Vec<(f64, f64)> {
        let count = self.count();
        (0..2 * count - 1)
            .map(|index| {
                let difference = index as f64 - (count - 1) as f64;
                let theta = difference / (count * if self.mirrored { 2 } else { 1 }) as f64 + self.rotation;
                cardinal_and_slope(count, self.mirrored, theta)
            })
            .collect()
    }

    /// The derivative of the curve by theta at the nodes.
    fn slopes(&self) -> Vec<f64> {
        let mut still = self.clone();
        still.rotation = 0.0;
        let turned = still.turned();
        still.combine(&turned, |(_, slope)| slope)
    }

    /// The nodes' combinations with weights that depend on the difference of their numbers.
    fn combine(&self, turned: &[(f64, f64)], pick: impl Fn((f64, f64)) -> f64) -> Vec<f64> {
        let (count, dimension) = (self.count(), self.dimension);
        let mut sums = vec![0.0; count * dimension];
        for (j, sum) in sums.chunks_exact_mut(dimension).enumerate() {
            for (i, node) in self.nodes.chunks_exact(dimension).enumerate() {
                let weight = pick(turned[j + count - 1 - i]);
                for (sum, value) in sum.iter_mut().zip(node) {
                    *sum += weight * value;
                }
            }
        }
        sums
    }

    /// Makes the curve invariant by Newton's method, the derivative renewed only where the last one no longer serves.
    ///
    /// # Errors
    /// [`NumericsError::NoConvergence`], [`NumericsError::Singular`], or as the map.
    pub fn solve(mut self, options: Options, map: &mut Map) -> Result<Found, NumericsError> {
        let begin = self.slopes();
        let reference = self.nodes.clone();
        let size = self.nodes.len();
        let mut factors: Option<Factors> = None;
        let mut last = f64::INFINITY;
        let mut best: Option<(f64, Self)> = None;
        for iteration in 1..=options.iterations {
            let renew = factors.is_none();
            let turned = self.turned();
            let (mut right, rows) = self.equations(&turned, renew, map)?;
            let residual = right.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
            if !residual.is_finite() {
                return Err(NumericsError::NotFinite { time: 0.0 });
            }
            // Onwards past the tolerance as long as an iteration still gains a digit, which costs little.
            let gained = residual < 0.1 * last;
            if best.as_ref().is_none_or(|(least, _)| residual < *least) {
                best = Some((residual, self.clone()));
            }
            if residual <= options.tolerance && (!gained || residual < 1e-3 * options.tolerance) {
                break;
            }
            if !renew && residual > 0.2 * last {
                // The old derivative does not serve here: the next iteration makes a new one at the better point.
                factors = None;
                if residual > last
                    && let Some((_, better)) = &best
                {
                    self = better.clone();
                }
                last = f64::INFINITY;
                continue;
            }
            if renew {
                factors = Some(Factors::new(size + 1, self.bordered(&rows, &turned, &begin))?);
            }
            last = residual;
            right.push(self.nodes.iter().zip(&reference).zip(&begin).map(|((x, y), d)| (x - y) * d).sum());
            if let Some(factors) = &factors {
                factors.solve(&mut right);
            }
            for (node, step) in self.nodes.iter_mut().zip(&right) {
                *node -= step;
            }
            self.rotation -= right[size];
            if iteration == options.iterations {
                break;
            }
        }
        match best {
            Some((residual, circle)) if residual <= options.tolerance => {
                Ok(Found { circle, residual, iterations: options.iterations })
            }
            best => Err(NumericsError::NoConvergence {
                iterations: options.iterations,
                residual: best.map_or(f64::INFINITY, |(residual, _)| residual),
                tolerance: options.tolerance,
            }),
        }
    }

    /// The nodes' distances from invariance, and the map's derivatives where asked for.
    fn equations(
        &self,
        turned: &[(f64, f64)],
        derivatives: bool,
        map: &mut Map,
    ) -> Result<(Vec<f64>, Vec<f64>), NumericsError> {
        let dimension = self.dimension;
        let block = dimension * dimension;
        let mut right = vec![0.0; self.nodes.len()];
        let mut rows = vec![0.0; if derivatives { self.count() * block } else { 0 }];
        map(&self.nodes, &mut right, derivatives.then_some(&mut rows[..]))?;
        let on_curve = self.combine(turned, |(value, _)| value);
        for (image, expected) in right.iter_mut().zip(&on_curve) {
            *image -= expected;
        }
        Ok((right, rows))
    }

    /// The matrix of the linearised equations with the condition on where theta begins as its last row.
    fn bordered(&self, derivatives: &[f64], turned: &[(f64, f64)], begin: &[f64]) -> Vec<f64> {
        let (count, dimension) = (self.count(), self.dimension);
        let size = count * dimension + 1;
        let mut matrix = vec![0.0; size * size];
        let by_rotation = self.combine(turned, |(_, slope)| slope);
        for j in 0..count {
            for row in 0..dimension {
                let entries = &mut matrix[(j * dimension + row) * size..(j * dimension + row + 1) * size];
                for i in 0..count {
                    entries[i * dimension + row] -= turned[j + count - 1 - i].0;
                }
                let from = (j * dimension + row) * dimension;
                for column in 0..dimension {
                    entries[j * dimension + column] += derivatives[from + column];
                }
                entries[size - 1] = -by_rotation[j * dimension + row];
            }
        }
        matrix[(size - 1) * size..size * size - 1].copy_from_slice(begin);
        matrix
    }

    /// The map's derivative at each node, by rows.
    ///
    /// # Errors
    /// As the map.
    pub fn derivatives(&self, map: &mut Map) -> Result<Vec<f64>, NumericsError> {
        Ok(self.equations(&self.turned(), true, map)?.1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    type Images = Result<(), NumericsError>;

    /// A map of the plane with a known attracting circle: turned by a known angle in polar coordinates about a centre,
    /// seen through a bent coordinate. `odd` keeps the mirror image.
    fn bent(odd: bool, rotation: f64) -> impl FnMut(&[f64], &mut [f64], Option<&mut [f64]>) -> Images {
        let one = move |x: &[f64], image: &mut [f64], derivative: Option<&mut [f64]>| {
            let bend = |x: f64| if odd { 0.2 * x.powi(3) } else { 0.3 * x * x };
            let apply = |x: &[f64]| {
                let (a, b) = (x[0], x[1] - bend(x[0]));
                let radius = a.hypot(b);
                let scale = radius.powf(-0.5);
                let (sine, cosine) = (TAU * rotation).sin_cos();
                let (c, d) = ((a * cosine - b * sine) * scale, (a * sine + b * cosine) * scale);
                [c, d + bend(c)]
            };
            image.copy_from_slice(&apply(x));
            if let Some(rows) = derivative {
                for column in 0..2 {
                    let moved = |by: f64| {
                        let mut moved = [x[0], x[1]];
                        moved[column] += by;
                        apply(&moved)
                    };
                    let (ahead, behind) = (moved(1e-5), moved(-1e-5));
                    for row in 0..2 {
                        rows[2 * row + column] = (ahead[row] - behind[row]) / 2e-5;
                    }
                }
            }
        };
        move |points, images, mut derivatives| {
            for (index, (x, image)) in points.chunks(2).zip(images.chunks_mut(2)).enumerate() {
                one(x, image, derivatives.as_mut().map(|rows| &mut rows[4 * index..4 * index + 4]));
            }
            Ok(())
        }
    }

    fn seed(mirrored: bool, count: usize) -> Circle {
        let turns = if mirrored { 2 * count } else { count };
        let nodes = (0..count)
            .flat_map(|n| {
                let (sine, cosine) = (TAU * n as f64 / turns as f64).sin_cos();
                [0.9 * cosine, 1.1 * sine]
            })
            .collect();
        Circle { dimension: 2, mirrored, nodes, rotation: 0.21 }
    }

    #[test]
    fn a_known_circle_and_its_rotation_are_found() {
        for (mirrored, count) in [(false, 33), (true, 32)] {
            let mut map = bent(mirrored, 0.2137);
            let options = Options { tolerance: 1e-11, iterations: 40 };
            let found = seed(mirrored, count).solve(options, &mut map).expect("converges");
            assert!((found.circle.rotation - 0.2137).abs() < 1e-11, "{:?}", found.circle.rotation);
            assert!(found.circle.defect(&mut map, 1).expect("maps") < 1e-10);
            let finer = found.circle.resampled(2 * count + usize::from(!mirrored));
            assert!(finer.defect(&mut map, 1).expect("maps") < 1e-10);
        }
    }

    #[test]
    fn interpolation_is_exact_for_the_harmonics_it_holds() {
        for (count, mirrored) in [(7, false), (8, false), (8, true)] {
            let function = |theta: f64| {
                let angle = TAU * theta;
                if mirrored {
                    angle.cos() + 0.3 * (3.0 * angle).sin()
                } else {
                    0.4 + angle.sin() + (2.0 * angle).cos()
                }
            };
            let turns = if mirrored { 2 * count } else { count };
            let values: Vec<f64> = (0..count).map(|node| function(node as f64 / turns as f64)).collect();
            let weights = Weights::new(count, mirrored);
            for theta in [0.0, 0.123, 0.5, 0.77, 1.2, -0.3, 1.0 / turns as f64] {
                let mut sum = [0.0];
                weights.combine(theta, &values, &mut sum);
                assert!((sum[0] - function(theta)).abs() < 1e-12, "{count} {mirrored} {theta}: {}", sum[0]);
            }
        }
    }
}
