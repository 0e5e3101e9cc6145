//! A stability chart made bit by bit, coarse to fine, for showing while it is under way.
//!
//! About the trivial state, and about any response of a pair that is linear while the teeth touch, it is that of
//! [the chart](super::stability_chart::stability_chart). About the response of a loaded nonlinear pair every point
//! needs its own orbit: those of a coarse lattice are grown with the load, the others are found by Newton's method from a
//! prediction through their neighbours.

use super::grid::Grid;
use super::motion;
use super::multipliers::{Budget, common_period, image, image_on_manifold, unloaded};
use super::orbit::{self, OrbitOptions};
use super::stability_chart::{StabilityChart, check_plane, stability_chart};
use crate::error::StudyError;
use crate::model::equations::GearPair;
use crate::model::parameters::{Parameters, Regime};
use crate::numerics::floquet::{self, Spectrum};
use crate::numerics::periodic::{correction, matrix};

/// A stability chart under way.
#[derive(Clone, Debug)]
pub struct ChartWork {
    p: Parameters,
    omega: Grid,
    k0: Grid,
    tolerance: f64,
    /// Indices of the rows of this share.
    rows: Vec<usize>,
    radius: Vec<f64>,
    /// What is known of each point.
    known: Vec<Known>,
    /// States at t = 0 of the responses found.
    states: Vec<[f64; 6]>,
    /// Distance of the lattice's points now being filled.
    stride: usize,
    /// Number of the next point of that lattice.
    next: usize,
    period: usize,
    linear: Option<StabilityChart>,
    is_linear: bool,
    error: f64,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Known {
    Nothing,
    Found,
    Missing,
}

/// Distance of the points of the first lattice.
const COARSEST: usize = 16;
/// Lattices from this distance on take what their neighbours predict, and no orbit is grown with the load any more.
const GROWN_FROM: usize = 4;
/// Steps of the integration in one slice of work: some 10 ms.
const SLICE: usize = 5_000;
/// Steps that one orbit may take.
const ORBIT_STEPS: usize = 60_000;
/// Newton's iterations granted to a prediction.
const ITERATIONS: usize = 7;

/// Whether a state is on the manifold `u_g = -u_p` but for the error of an orbit.
fn near_manifold(state: &[f64; 6]) -> bool {
    let size = state.iter().fold(1.0_f64, |most, value| most.max(value.abs()));
    (state[0] + state[1]).abs() + (state[3] + state[4]).abs() < 1e-5 * size
}

impl ChartWork {
    /// A chart over the plane; `rows` is this share's number and the number of shares: of several workers each takes the
    /// rows whose index leaves that remainder. `tolerance` is of the spectral radius.
    ///
    /// The loads' frequencies keep their ratio to the mesh frequency.
    ///
    /// # Errors
    /// [`StudyError::Option`] for an option out of range, [`StudyError::Model`] for an incommensurate load.
    pub fn new(
        p: &Parameters,
        omega: Grid,
        k0: Grid,
        tolerance: f64,
        rows: Option<(usize, usize)>,
    ) -> Result<Self, StudyError> {
        check_plane(omega, k0)?;
        motion::check_tolerance(tolerance)?;
        let (share, shares) = rows.unwrap_or((0, 1));
        if share >= shares {
            return Err(StudyError::Option {
                option: "rows",
                given: format!("({share}, {shares})"),
                allowed: "(share, shares) with share below shares".into(),
            });
        }
        let is_linear = unloaded(p) || (p.regime == Regime::Contact && p.alpha_p == 0.0 && p.alpha_g == 0.0);
        let period = if is_linear { 1 } else { common_period(p)? };
        let size = omega.count * k0.count;
        Ok(Self {
            p: *p,
            omega,
            k0,
            tolerance,
            rows: (share..k0.count).step_by(shares).collect(),
            radius: vec![f64::INFINITY; size],
            known: vec![Known::Nothing; size],
            states: if is_linear { Vec::new() } else { vec![[0.0; 6]; size] },
            stride: COARSEST,
            next: 0,
            period,
            linear: None,
            is_linear,
            error: 0.0,
        })
    }

    /// The rows of this share, indices of `k0`.
    pub fn rows(&self) -> &[usize] {
        &self.rows
    }

    /// The part that is done, 0 to 1.
    pub fn done(&self) -> f64 {
        if self.is_linear {
            return if self.linear.is_some() { 1.0 } else { 0.0 };
        }
        let points = self.rows.len() * self.omega.count;
        let finished = self
            .rows
            .iter()
            .flat_map(|row| &self.known[row * self.omega.count..(row + 1) * self.omega.count]);
        finished.filter(|known| **known != Known::Nothing).count() as f64 / points.max(1) as f64
    }

    /// Some milliseconds of work; true when all is done.
    ///
    /// # Errors
    /// As [`stability_chart`]; a response that is not found is no error.
    pub fn advance(&mut self) -> Result<bool, StudyError> {
        if self.is_linear {
            if self.linear.is_none() {
                self.linear = Some(stability_chart(&self.p, self.omega, self.k0, self.tolerance)?);
            }
            return Ok(true);
        }
        let mut spent = 0;
        while spent < SLICE {
            let columns = self.omega.count.div_ceil(self.stride);
            let rows = self.rows.len().div_ceil(self.stride);
            if self.next >= rows * columns {
                if self.stride == 1 {
                    return Ok(true);
                }
                self.stride /= 2;
                self.next = 0;
                continue;
            }
            let (row, column) = (self.next / columns * self.stride, self.next % columns * self.stride);
            self.next += 1;
            if self.known[self.index(row, column)] == Known::Nothing {
                spent += self.point(row, column)?;
            }
        }
        Ok(false)
    }

    /// Index of a point by its number among this share's rows and its column.
    fn index(&self, row: usize, column: usize) -> usize {
        self.rows[row] * self.omega.count + column
    }

    /// The parameters at a point.
    fn parameters(&self, row: usize, column: usize) -> Parameters {
        let omega = self.omega.value(column);
        let ratio = omega / self.p.omega;
        Parameters {
            omega,
            omega_p: self.p.omega_p * ratio,
            omega_g: self.p.omega_g * ratio,
            k0: self.k0.value(self.rows[row]),
            ..self.p
        }
    }

    /// One point; answers the steps it took.
    fn point(&mut self, row: usize, column: usize) -> Result<usize, StudyError> {
        let p = self.parameters(row, column);
        let index = self.index(row, column);
        let budget = Budget::of(ORBIT_STEPS);
        let mut found = None;
        if let Some(guess) = self.predicted(row, column) {
            found = self.newton(&p, guess, &budget)?;
        }
        if found.is_none() && self.stride >= GROWN_FROM {
            found = self.grown(&p, &budget)?;
        }
        if let Some((state, radius)) = found {
            self.known[index] = Known::Found;
            self.states[index] = state;
            self.radius[index] = radius;
        } else {
            self.known[index] = Known::Missing;
        }
        // What went wrong took time as well.
        Ok((ORBIT_STEPS - budget.left()).max(50))
    }

    /// Newton's method for the response from a guess; the state and the spectral radius.
    fn newton(
        &mut self,
        p: &Parameters,
        guess: [f64; 6],
        budget: &Budget,
    ) -> Result<Option<([f64; 6], f64)>, StudyError> {
        let pair = GearPair::new(p);
        // The derivative changes with the state about as much as the state does.
        let close = 0.1 * self.tolerance;
        let tolerance = (0.01 * self.tolerance).clamp(1e-13, 1e-7);
        let mut state = guess;
        let equal = p.symmetric().is_ok() && near_manifold(&guess);
        if equal {
            (state[1], state[4]) = (-state[0], -state[3]);
        }
        let mut before = f64::INFINITY;
        let largest = |six: &[f64; 6]| six.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
        for _ in 0..ITERATIONS {
            let there = image_on_manifold(&pair, &state, self.period, tolerance, budget)
                .unwrap_or_else(|| image(&pair, &state, self.period, tolerance, 1.0, budget));
            let Ok(there) = there else { return Ok(None) };
            let Some(step) = correction(&state, &there) else { return Ok(None) };
            let size = largest(&step);
            if size.is_nan() || size > close && size >= 0.7 * before.max(1.0) {
                return Ok(None);
            }
            for (value, step) in state.iter_mut().zip(step) {
                *value -= step;
            }
            if equal {
                // To the last bit: the response that the load grows from the trivial state has the pair's symmetry.
                (state[1], state[4]) = (-state[0], -state[3]);
            }
            if size <= close * (1.0 + largest(&state)) {
                self.error = self.error.max(size);
                return Ok(Some((state, floquet::spectrum(&matrix(&there.1))?.radius())));
            }
            before = size;
        }
        Ok(None)
    }

    /// The response grown with the load from the trivial state.
    fn grown(&self, p: &Parameters, budget: &Budget) -> Result<Option<([f64; 6], f64)>, StudyError> {
        let options = OrbitOptions {
            period: self.period,
            guess: None,
            tolerance: (0.01 * self.tolerance).clamp(1e-12, 1e-7),
        };
        match orbit::response(p, self.period, &options, budget) {
            Ok(orbit) => {
                let radius = Spectrum { re: orbit.re, im: orbit.im }.radius();
                Ok(Some((orbit.state, radius)))
            }
            Err(StudyError::Numerics(_)) => Ok(None),
            Err(error) => Err(error),
        }
    }

    /// The state that known neighbours along Omega, or else along k0, predict.
    fn predicted(&self, row: usize, column: usize) -> Option<[f64; 6]> {
        let known = |row: Option<usize>, column: Option<usize>| {
            let (row, column) = (row?, column?);
            if row >= self.rows.len() || column >= self.omega.count {
                return None;
            }
            let index = self.index(row, column);
            (self.known[index] == Known::Found).then_some(index)
        };
        let mut nearest = None;
        for distance in [self.stride, 2 * self.stride] {
            for along_omega in [true, false] {
                let near = |offset: isize| {
                    let moved = |from: usize, by: isize| from.checked_add_signed(by);
                    if along_omega {
                        known(Some(row), moved(column, offset * distance.cast_signed()))
                    } else {
                        known(moved(row, offset * distance.cast_signed()), Some(column))
                    }
                };
                let around = [near(-3), near(-1), near(1), near(3)];
                match around {
                    // Through four points, cubic; through two, linear; on one side, on from two.
                    [Some(a), Some(b), Some(c), Some(d)] => {
                        return Some(self.mixed(&[(a, -0.0625), (b, 0.5625), (c, 0.5625), (d, -0.0625)]));
                    }
                    [_, Some(b), Some(c), _] => return Some(self.mixed(&[(b, 0.5), (c, 0.5)])),
                    [_, Some(b), None, _] => {
                        if let Some(far) = near(-2) {
                            return Some(self.mixed(&[(b, 2.0), (far, -1.0)]));
                        }
                        nearest = nearest.or(Some(b));
                    }
                    [_, None, Some(c), _] => nearest = nearest.or(Some(c)),
                    _ => {}
                }
            }
        }
        nearest.map(|index| self.states[index])
    }

    fn mixed(&self, parts: &[(usize, f64)]) -> [f64; 6] {
        let mut sum = [0.0; 6];
        for (index, weight) in parts {
            for (sum, value) in sum.iter_mut().zip(&self.states[*index]) {
                *sum += weight * value;
            }
        }
        sum
    }

    /// The chart so far: what is not computed yet has the value of its nearest point on the lattice before; rows of other
    /// shares are infinite.
    pub fn chart(&self) -> StabilityChart {
        if let Some(chart) = &self.linear {
            return chart.clone();
        }
        let mut radius = self.radius.clone();
        for row in 0..self.rows.len() {
            for column in 0..self.omega.count {
                let index = self.index(row, column);
                if self.known[index] != Known::Nothing {
                    continue;
                }
                let mut stride = self.stride;
                while stride <= COARSEST {
                    let coarse = self.index(row / stride * stride, column / stride * stride);
                    if self.known[coarse] != Known::Nothing {
                        radius[index] = self.radius[coarse];
                        break;
                    }
                    stride *= 2;
                }
            }
        }
        StabilityChart {
            omega: self.omega,
            k0: self.k0,
            spectral_radius: radius,
            error: self.error.max(self.tolerance),
            method: "periodic response at every point by Newton's method from its neighbours, variational Taylor series, QR".into(),
        }
    }
}
