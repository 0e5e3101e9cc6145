//! A neighbourhood of a stable fixed point that a map carries into itself: an ellipsoid from the linearised map, grown as
//! far as trials show that every point of it comes nearer.
//!
//! `V(x) = x^T P x` with `P = sum (A^T/g)^k (A/g)^k`, `A` the linearised map and `g` between its spectral radius and 1,
//! falls by `g^2` at least under `A`; by how much of the neighbourhood that holds for the map itself is tried out.

/// Directions in which an ellipsoid is tried.
const DIRECTIONS: usize = 100;
/// Ratio of the sizes that are tried in turn at first.
const STRIDE: f64 = 2.5;
/// The same at last.
const GROWTH: f64 = 1.2;
/// `V` must fall at least by this factor at every point tried.
const FALL: f64 = 0.998;
/// The part of the size that passed the trials which is used.
const SAFETY: f64 = 0.9;

/// An ellipsoid about a point: all states with `V(x - centre) < level`.
#[derive(Clone, Debug, PartialEq)]
pub struct Ellipsoid {
    /// Number of coordinates.
    dimension: usize,
    /// Its centre.
    centre: Vec<f64>,
    /// `P` by rows.
    form: Vec<f64>,
    /// The lower triangle `L` of `P = L L^T`, by rows.
    triangle: Vec<f64>,
    /// Half its width along each coordinate axis, for a quick no.
    reach: Vec<f64>,
    /// The level.
    level: f64,
}

/// How far the growth of an ellipsoid has come.
#[derive(Clone, Debug)]
pub struct Growth {
    directions: Vec<Vec<f64>>,
    /// The greatest size that is tried.
    most: f64,
    /// The size tried next, and the last one that passed.
    size: f64,
    passed: f64,
    /// Ratio of the sizes tried in turn.
    factor: f64,
}

impl Ellipsoid {
    /// The form that belongs to a linearised map (by rows) of this spectral radius; none where it does not contract or
    /// rounding spoils it. The level is 0.
    pub fn new(centre: &[f64], linear: &[f64], spectral_radius: f64) -> Option<Self> {
        let dimension = centre.len();
        // Halfway on a logarithmic scale; a map that forgets everything at once needs no slower form than 1/2.
        let rate = spectral_radius.max(0.25).sqrt();
        if rate >= 1.0 {
            return None;
        }
        let mut power: Vec<f64> = linear.iter().map(|entry| entry / rate).collect();
        let mut form: Vec<f64> = (0..dimension * dimension).map(|at| identity(at, dimension)).collect();
        // Doubling: after n rounds the sum holds 2^n terms.
        for _ in 0..40 {
            let more = congruent(&form, &power, dimension);
            let size = form.iter().fold(0.0_f64, |most, entry| most.max(entry.abs()));
            let added = more.iter().fold(0.0_f64, |most, entry| most.max(entry.abs()));
            for (sum, part) in form.iter_mut().zip(&more) {
                *sum += part;
            }
            power = product(&power, &power, dimension);
            if !added.is_finite() {
                return None;
            }
            if added < 1e-12 * size {
                break;
            }
        }
        let triangle = cholesky(&form, dimension)?;
        Some(Self {
            dimension,
            centre: centre.to_vec(),
            form,
            triangle,
            reach: vec![0.0; dimension],
            level: 0.0,
        })
    }

    /// Whether a state is inside.
    pub fn contains(&self, state: &[f64]) -> bool {
        let near = state.iter().zip(&self.centre).zip(&self.reach).all(|((x, c), r)| (x - c).abs() < *r);
        near && self.value(state) < self.level
    }

    /// Half its width along each axis.
    pub fn reach(&self) -> &[f64] {
        &self.reach
    }

    fn value(&self, state: &[f64]) -> f64 {
        let mut sum = 0.0;
        for (row, entries) in self.form.chunks_exact(self.dimension).enumerate() {
            let own = state[row] - self.centre[row];
            let along: f64 = entries.iter().zip(state).zip(&self.centre).map(|((p, x), c)| p * (x - c)).sum();
            sum += own * along;
        }
        sum
    }

    /// The trials by which it may grow: from one whose widest half-axis is `least` to one of `most`.
    pub fn growth(&self, least: f64, most: f64) -> Growth {
        let widest = self.widths().into_iter().fold(0.0, f64::max);
        Growth {
            directions: directions(self.dimension),
            most: most / widest,
            size: least / widest,
            passed: 0.0,
            factor: STRIDE,
        }
    }

    /// Grows the ellipsoid by the next size as long as `map` carries every point tried on its surface strictly inwards;
    /// `map` says no where a motion is lost. False when it has grown as far as it can.
    pub fn grow(&mut self, growth: &mut Growth, map: &mut dyn FnMut(&[f64]) -> Option<Vec<f64>>) -> bool {
        let size = growth.size;
        let inwards = size <= growth.most
            && growth.directions.iter().all(|direction| {
                let state = self.surface(direction, size);
                map(&state).is_some_and(|image| self.value(&image) < FALL * size * size)
            });
        if inwards {
            growth.passed = size;
            growth.size *= growth.factor;
            return true;
        }
        if growth.factor == STRIDE && growth.passed > 0.0 {
            // In strides first, then from the last size that passed in small steps.
            growth.factor = GROWTH;
            growth.size = GROWTH * growth.passed;
            return true;
        }
        let size = SAFETY * growth.passed;
        self.level = size * size;
        self.reach = self.widths().iter().map(|width| width * size).collect();
        false
    }

    /// The point of the surface `V = size^2` in a direction of the unit sphere: `centre + size L^-T direction`.
    fn surface(&self, direction: &[f64], size: f64) -> Vec<f64> {
        let dimension = self.dimension;
        let mut x = direction.to_vec();
        for row in (0..dimension).rev() {
            for later in row + 1..dimension {
                x[row] -= self.triangle[later * dimension + row] * x[later];
            }
            x[row] /= self.triangle[row * dimension + row];
        }
        x.iter().zip(&self.centre).map(|(x, c)| c + size * x).collect()
    }

    /// Half the widths of the ellipsoid `V = 1`: the square roots of the diagonal of `P^-1`, whose columns are those of
    /// `L^-T L^-1`.
    fn widths(&self) -> Vec<f64> {
        let dimension = self.dimension;
        (0..dimension)
            .map(|axis| {
                // Solve L y = e_axis; the diagonal entry is |y|^2.
                let mut y = vec![0.0; dimension];
                for row in 0..dimension {
                    let mut value = f64::from(u8::from(row == axis));
                    for earlier in 0..row {
                        value -= self.triangle[row * dimension + earlier] * y[earlier];
                    }
                    y[row] = value / self.triangle[row * dimension + row];
                }
                y.iter().map(|value| value * value).sum::<f64>().sqrt()
            })
            .collect()
    }
}

fn identity(at: usize, dimension: usize) -> f64 {
    f64::from(u8::from(at / dimension == at % dimension))
}

fn product(left: &[f64], right: &[f64], dimension: usize) -> Vec<f64> {
    (0..dimension * dimension)
        .map(|at| {
            let (row, column) = (at / dimension, at % dimension);
            (0..dimension)
                .map(|inner| left[row * dimension + inner] * right[inner * dimension + column])
                .sum()
        })
        .collect()
}

/// `A^T P A`.
fn congruent(form: &[f64], matrix: &[f64], dimension: usize) -> Vec<f64> {
    let right = product(form, matrix, dimension);
    (0..dimension * dimension)
        .map(|at| {
            let (row, column) = (at / dimension, at % dimension);
            (0..dimension)
                .map(|inner| matrix[inner * dimension + row] * right[inner * dimension + column])
                .sum()
        })
        .collect()
}

fn cholesky(form: &[f64], dimension: usize) -> Option<Vec<f64>> {
    let mut lower = vec![0.0; dimension * dimension];
    for row in 0..dimension {
        for column in 0..=row {
            let known: f64 =
                (0..column).map(|k| lower[row * dimension + k] * lower[column * dimension + k]).sum();
            let left = form[row * dimension + column] - known;
            lower[row * dimension + column] = if row == column {
                if !(left > 0.0 && left.is_finite()) {
                    return None;
                }
                left.sqrt()
            } else {
                left / lower[column * dimension + column]
            };
        }
    }
    Some(lower)
}

/// Directions spread over the unit sphere, always the same: the axes both ways, then normalised points of a Kronecker
/// sequence turned into normal deviates.
fn directions(dimension: usize) -> Vec<Vec<f64>> {
    let mut all: Vec<Vec<f64>> = Vec::with_capacity(DIRECTIONS);
    for axis in 0..dimension {
        for sign in [1.0, -1.0] {
            all.push((0..dimension).map(|i| if i == axis { sign } else { 0.0 }).collect());
        }
    }
    // Fractional parts of multiples of square roots of primes.
    let roots = [2.0_f64, 3.0, 5.0, 7.0, 11.0, 13.0, 17.0, 19.0].map(f64::sqrt);
    for n in 1..=DIRECTIONS - 2 * dimension {
        let part = |i: usize| (n as f64 * roots[i % roots.len()]).fract();
        let mut direction: Vec<f64> = (0..dimension)
            .map(|i| {
                // Box and Muller: two even numbers give two normal ones.
                let (first, second) = (part(i / 2 * 2).max(1e-12), part(i / 2 * 2 + 1));
                let (sine, cosine) = (std::f64::consts::TAU * second).sin_cos();
                (-2.0 * first.ln()).sqrt() * if i % 2 == 0 { cosine } else { sine }
            })
            .collect();
        let length = direction.iter().map(|x| x * x).sum::<f64>().sqrt().max(1e-12);
        for x in &mut direction {
            *x /= length;
        }
        all.push(direction);
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A contraction with a known basin: the unit disc in bent coordinates.
    fn map(x: &[f64]) -> Vec<f64> {
        let (a, b) = (x[0], x[1] - 0.3 * x[0] * x[0]);
        let growth = 0.8 + 0.2 * (a * a + b * b);
        let (c, d) = (growth * (0.6 * a - 0.8 * b), growth * (0.8 * a + 0.6 * b));
        vec![c, d + 0.3 * c * c]
    }

    #[test]
    fn the_ellipsoid_is_within_the_basin_and_fills_a_good_part_of_it() {
        let linear = [0.48, -0.64, 0.64, 0.48];
        let mut ball = Ellipsoid::new(&[0.0, 0.0], &linear, 0.8).expect("contracts");
        let mut growth = ball.growth(1e-3, 10.0);
        while ball.grow(&mut growth, &mut |x| Some(map(x))) {}
        assert!(ball.reach().iter().all(|reach| *reach > 0.4 && *reach < 1.0), "{:?}", ball.reach());
        for index in 0..400 {
            let start = [f64::from(index % 20) * 0.15 - 1.5, f64::from(index / 20) * 0.15 - 1.5];
            if ball.contains(&start) {
                let end = (0..500).fold(start.to_vec(), |x, _| map(&x));
                assert!(end[0].abs() + end[1].abs() < 1e-9, "{start:?}");
            }
        }
    }

    #[test]
    fn what_does_not_contract_has_none() {
        assert_eq!(Ellipsoid::new(&[0.0], &[1.0], 1.0), None);
    }
}
