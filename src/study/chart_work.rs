//! A stability chart made bit by bit, coarse to fine, for showing while it is under way.
//!
//! About the trivial state, and about any response of a pair that is linear while the teeth touch, it is that of
//! [the chart](super::stability_chart::stability_chart). About the response of a loaded nonlinear pair the orbits of a
//! coarse lattice are grown with the load, others found by Newton's method from what their neighbours predict; in
//! between, along k0, the coefficients of the characteristic polynomial are interpolated as far as they are sure enough.

use super::chart_column::{Between, Column, Node};
use super::grid::Grid;
use super::linear_floquet::factorise;
use super::motion;
use super::multipliers::{Budget, common_period, image, unloaded};
use super::orbit::{self, OrbitOptions};
use super::stability_chart::{StabilityChart, check_plane, conditioned, stability_chart};
use crate::error::StudyError;
use crate::model::equations::GearPair;
use crate::model::manifold::onto_manifold;
use crate::model::parameters::{Parameters, Regime};
use crate::numerics::characteristic::{Characteristic, Factors};
use crate::numerics::periodic::{Image, correction};

/// A stability chart under way.
#[derive(Clone, Debug)]
pub struct ChartWork {
    p: Parameters,
    omega: Grid,
    k0: Grid,
    tolerance: f64,
    /// Indices of the columns of this share.
    columns: Vec<usize>,
    radius: Vec<f64>,
    /// What is known of each point.
    known: Vec<Known>,
    /// What was computed in each column of this share.
    computed: Vec<Column>,
    /// Index of the lattice now being filled.
    lattice: usize,
    /// Number of the next point of that lattice.
    next: usize,
    period: usize,
    linear: Option<StabilityChart>,
    is_linear: bool,
    error: f64,
    /// Points that needed no orbit of their own.
    between: usize,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Known {
    Nothing,
    Found,
    Missing,
}

/// Distances of rows and of columns of the lattices, one after the other: first everywhere coarsely, then all columns, and
/// then the rows between, most of which follow from the others.
const LATTICES: [(usize, usize); 8] = [(16, 16), (8, 8), (8, 4), (8, 2), (8, 1), (4, 1), (2, 1), (1, 1)];
/// Lattices whose columns are nearer than this take what their neighbours predict, and no orbit is grown with the load any
/// more.
const GROWN_FROM: usize = 4;
/// Steps of the integration in one slice of work: some 10 ms.
const SLICE: usize = 5_000;
/// Steps that one orbit may take.
const ORBIT_STEPS: usize = 60_000;
/// Newton's iterations granted to a prediction.
const ITERATIONS: usize = 7;
/// What an interpolated point counts for, in steps.
const CHEAP: usize = 2;
/// The part of the tolerance within which an interpolated radius must be, by what fewer nodes make of it.
const SURE: f64 = 0.2;
/// The part of the tolerance to which orbits are computed, first and where multipliers that are close to one another make
/// that too little.
const FINE: f64 = 1e-2;
const FINEST: f64 = 1e-13;

/// Whether a state is on the manifold `u_g = -u_p` but for the error of an orbit.
fn near_manifold(state: &[f64; 6]) -> bool {
    let size = state.iter().fold(1.0_f64, |most, value| most.max(value.abs()));
    (state[0] + state[1]).abs() + (state[3] + state[4]).abs() < 1e-5 * size
}

fn largest(numbers: &[f64]) -> f64 {
    numbers.iter().fold(0.0_f64, |most, value| most.max(value.abs()))
}

/// An orbit with its multipliers.
struct Response {
    state: [f64; 6],
    polynomial: Characteristic,
    factors: Factors,
    radius: f64,
    /// Of the radius, from about the error of the polynomial's coefficients.
    bound: f64,
}

impl ChartWork {
    /// A chart over the plane; `share` is this share's number and the number of shares: of several workers each takes the
    /// columns whose index leaves that remainder. `tolerance` is of the spectral radius.
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
        share: Option<(usize, usize)>,
    ) -> Result<Self, StudyError> {
        check_plane(omega, k0)?;
        motion::check_tolerance(tolerance)?;
        let (share, shares) = share.unwrap_or((0, 1));
        if share >= shares {
            return Err(StudyError::Option {
                option: "share",
                given: format!("({share}, {shares})"),
                allowed: "(share, shares) with share below shares".into(),
            });
        }
        let is_linear = unloaded(p) || (p.regime == Regime::Contact && p.alpha_p == 0.0 && p.alpha_g == 0.0);
        let period = if is_linear { 1 } else { common_period(p)? };
        let size = omega.count * k0.count;
        let columns: Vec<usize> = (share..omega.count).step_by(shares).collect();
        Ok(Self {
            p: *p,
            omega,
            k0,
            tolerance,
            radius: vec![f64::INFINITY; size],
            known: vec![Known::Nothing; size],
            computed: if is_linear { Vec::new() } else { vec![Column::default(); columns.len()] },
            columns,
            lattice: 0,
            next: 0,
            period,
            linear: None,
            is_linear,
            error: 0.0,
            between: 0,
        })
    }

    /// The columns of this share, indices of `omega`.
    pub fn columns(&self) -> &[usize] {
        &self.columns
    }

    /// The part that is done, 0 to 1.
    pub fn done(&self) -> f64 {
        if self.is_linear {
            return if self.linear.is_some() { 1.0 } else { 0.0 };
        }
        let points = self.k0.count * self.columns.len();
        let finished = self.known.iter().filter(|known| **known != Known::Nothing).count();
        finished as f64 / points.max(1) as f64
    }

    /// The part of the points that followed from others, 0 to 1.
    pub fn interpolated(&self) -> f64 {
        self.between as f64 / (self.k0.count * self.columns.len()).max(1) as f64
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
            let Some(&(by_row, by_column)) = LATTICES.get(self.lattice) else { return Ok(true) };
            let rows = self.k0.count.div_ceil(by_row);
            let columns = self.columns.len().div_ceil(by_column);
            if self.next >= rows * columns {
                self.lattice += 1;
                self.next = 0;
                continue;
            }
            let (row, column) = (self.next / columns * by_row, self.next % columns * by_column);
            self.next += 1;
            if self.known[self.index(row, column)] == Known::Nothing {
                spent += self.point(row, column, by_column)?;
            }
        }
        Ok(false)
    }

    /// Index of a point by its row and its number among this share's columns.
    fn index(&self, row: usize, column: usize) -> usize {
        row * self.omega.count + self.columns[column]
    }

    /// The parameters at a point.
    fn parameters(&self, row: usize, column: usize) -> Parameters {
        let omega = self.omega.value(self.columns[column]);
        let ratio = omega / self.p.omega;
        Parameters {
            omega,
            omega_p: self.p.omega_p * ratio,
            omega_g: self.p.omega_g * ratio,
            k0: self.k0.value(row),
            ..self.p
        }
    }

    /// One point; answers the steps it took.
    fn point(&mut self, row: usize, column: usize, by_column: usize) -> Result<usize, StudyError> {
        let p = self.parameters(row, column);
        let index = self.index(row, column);
        let between = self.computed[column].between(row, p.k0);
        let followed = match &between {
            // A dead zone makes kinks in the response that few nodes tell nothing of.
            Some(between) if p.regime != Regime::Backlash && !self.computed[column].distrusted => {
                self.followed(between)?
            }
            _ => None,
        };
        // Of every column the first point that would do is computed all the same.
        if let Some((radius, bound)) = followed
            && self.computed[column].compared
        {
            self.known[index] = Known::Found;
            self.radius[index] = radius;
            self.error = self.error.max(bound);
            self.between += 1;
            return Ok(CHEAP);
        }
        let budget = Budget::of(ORBIT_STEPS);
        let mut found = None;
        let along_omega = self.along_omega(row, column, by_column);
        for guess in [between.map(|between| between.state), along_omega].into_iter().flatten() {
            if found.is_none() {
                found = self.newton(&p, guess, &budget);
            }
        }
        if found.is_none() && by_column >= GROWN_FROM {
            found = self.grown(&p, &budget);
        }
        if let Some(response) = found {
            let Response { state, polynomial, factors, radius, bound } = response;
            self.error = self.error.max(bound);
            if let Some((followed, expected)) = followed {
                let known = &mut self.computed[column];
                known.compared = true;
                known.distrusted = (followed - radius).abs() > expected.max(SURE * self.tolerance) + bound;
            }
            self.known[index] = Known::Found;
            self.radius[index] = radius;
            self.computed[column].add(Node { row, k0: p.k0, state, polynomial, factors });
        } else {
            self.known[index] = Known::Missing;
            self.computed[column].miss(row);
        }
        // What went wrong took time as well.
        Ok((ORBIT_STEPS - budget.left()).max(50))
    }

    /// The radius that follows from the nodes around a point, and a bound of its error; none where that is too great.
    fn followed(&self, between: &Between) -> Result<Option<(f64, f64)>, StudyError> {
        if between.doubt > self.tolerance {
            return Ok(None);
        }
        let accuracy = 1e-4 * self.tolerance;
        let mut factors = between.factors;
        let top = match factors.refine(&between.polynomial, accuracy) {
            Some(top) => top,
            None => factorise(&between.polynomial, accuracy)?.1,
        };
        let bound = conditioned(&top, 6, between.doubt);
        Ok((bound <= SURE * self.tolerance).then_some((top.radius, bound)))
    }

    /// The response near a guess, as fine as its multipliers ask for.
    fn newton(&self, p: &Parameters, guess: [f64; 6], budget: &Budget) -> Option<Response> {
        let coarse = self.orbit(p, guess, (FINE * self.tolerance).clamp(FINEST, 1e-7), budget)?;
        if coarse.bound <= self.tolerance {
            return Some(coarse);
        }
        self.orbit(p, coarse.state, FINEST, budget).or(Some(coarse))
    }

    /// Newton's method for the response from a guess.
    fn orbit(&self, p: &Parameters, guess: [f64; 6], tolerance: f64, budget: &Budget) -> Option<Response> {
        let pair = GearPair::new(p);
        let mut state = guess;
        let equal = p.symmetric().is_ok() && near_manifold(&guess);
        // To the last bit: the response that the load grows from the trivial state has the pair's symmetry.
        let exactly = |state: [f64; 6]| if equal { onto_manifold(&state) } else { state };
        state = exactly(state);
        let mut before = f64::INFINITY;
        for _ in 0..ITERATIONS {
            let there: Image = image(&pair, &state, self.period, tolerance, 1.0, budget).ok()?;
            let step = correction(&state, &there)?;
            let size = largest(&step);
            if size.is_nan() || size > tolerance && size >= 0.7 * before.max(1.0) {
                return None;
            }
            for (value, step) in state.iter_mut().zip(step) {
                *value -= step;
            }
            state = exactly(state);
            // What is left of the state's error is the square of this; the derivative was taken where it still was this.
            if size <= tolerance * (1.0 + largest(&state)) {
                let determinant = (pair.trace() * self.period as f64 * p.mesh_period()).exp();
                let polynomial = Characteristic::of(&there.1, determinant);
                let scale = largest(&polynomial.coefficients).max(1.0);
                let (factors, top) = factorise(&polynomial, 1e-4 * self.tolerance).ok()?;
                let bound = conditioned(&top, 6, (size + tolerance) * scale);
                return Some(Response { state, polynomial, factors, radius: top.radius, bound });
            }
            before = size;
        }
        None
    }

    /// The response grown with the load from the trivial state. Where that folds back before all of the load acts there may
    /// be others, which no neighbour leads to: a chart of those would be one of islands.
    fn grown(&self, p: &Parameters, budget: &Budget) -> Option<Response> {
        let tolerance = (FINE * self.tolerance).clamp(1e-12, 1e-7);
        let options = OrbitOptions { period: self.period, guess: None, tolerance };
        let state = orbit::grown_state(p, &options, budget).ok()?;
        self.newton(p, state, budget)
    }

    /// The state that known neighbours along Omega predict.
    fn along_omega(&self, row: usize, column: usize, by_column: usize) -> Option<[f64; 6]> {
        let near = |offset: isize, distance: usize| {
            let place = column.checked_add_signed(offset * distance.cast_signed())?;
            Some(self.computed.get(place)?.at(row)?.state)
        };
        let mut nearest = None;
        for distance in [by_column, 2 * by_column] {
            let around = [near(-3, distance), near(-1, distance), near(1, distance), near(3, distance)];
            match around {
                // Through four points, cubic; through two, linear; on one side, on from two.
                [Some(a), Some(b), Some(c), Some(d)] => {
                    return Some(mixed(&[(a, -0.0625), (b, 0.5625), (c, 0.5625), (d, -0.0625)]));
                }
                [_, Some(b), Some(c), _] => return Some(mixed(&[(b, 0.5), (c, 0.5)])),
                [_, Some(b), None, _] => {
                    if let Some(far) = near(-2, distance) {
                        return Some(mixed(&[(b, 2.0), (far, -1.0)]));
                    }
                    nearest = nearest.or(Some(b));
                }
                [_, None, Some(c), _] => nearest = nearest.or(Some(c)),
                _ => {}
            }
        }
        // Along k0, where there are too few for a polynomial.
        let at = |row: Option<usize>| self.computed[column].at(row?).map(|node| node.state);
        nearest.or_else(|| {
            [8, 16].into_iter().find_map(|by| at(row.checked_sub(by)).or_else(|| at(Some(row + by))))
        })
    }

    /// The chart so far: what is not computed yet has the value of its nearest point on the lattice before; columns of other
    /// shares are infinite.
    pub fn chart(&self) -> StabilityChart {
        if let Some(chart) = &self.linear {
            return chart.clone();
        }
        let mut radius = self.radius.clone();
        let before = self.lattice.min(LATTICES.len() - 1);
        for row in 0..self.k0.count {
            for column in 0..self.columns.len() {
                let index = self.index(row, column);
                if self.known[index] != Known::Nothing {
                    continue;
                }
                for (by_row, by_column) in LATTICES[..=before].iter().rev() {
                    let coarse = self.index(row / by_row * by_row, column / by_column * by_column);
                    if self.known[coarse] != Known::Nothing {
                        radius[index] = self.radius[coarse];
                        break;
                    }
                }
            }
        }
        StabilityChart {
            omega: self.omega,
            k0: self.k0,
            spectral_radius: radius,
            error: self.error.max(self.tolerance),
            method: "periodic response by Newton's method from its neighbours, variational Taylor series; between them the \
                     characteristic polynomial's coefficients interpolated along k0"
                .into(),
        }
    }
}

fn mixed(parts: &[([f64; 6], f64)]) -> [f64; 6] {
    let mut sum = [0.0; 6];
    for (state, weight) in parts {
        for (sum, value) in sum.iter_mut().zip(state) {
            *sum += weight * value;
        }
    }
    sum
}
