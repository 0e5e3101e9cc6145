//! Harmonic balance with alternating frequency and time, a method that shares nothing with shooting, at points of
//! branches.
//!
//! T. M. Cameron, J. H. Griffin, An alternating frequency/time domain method for calculating the steady-state response
//! of nonlinear dynamic systems, Journal of Applied Mechanics 56 (1989) 149-154, doi 10.1115/1.3176036.

use crate::common::parameters;
use gear_bifurcations::model::equations::GearPair;
use gear_bifurcations::model::parameters::{Parameters, Regime};
use gear_bifurcations::study::branch::{Branch, BranchOptions, branch};
use nalgebra::{DMatrix, DVector};
use serde_json::{Value, json};
use std::f64::consts::TAU;

/// The motion of the three coordinates as a Fourier sum over `periods` mesh periods.
struct Balance {
    p: Parameters,
    frequency: f64,
    /// Values and first two derivatives of the base functions (columns) at the instants (rows).
    base: [DMatrix<f64>; 3],
    times: Vec<f64>,
}

impl Balance {
    fn new(p: &Parameters, periods: usize, harmonics: usize, instants: usize) -> Self {
        let frequency = p.omega / periods as f64;
        let count = instants * harmonics;
        let times: Vec<f64> = (0..count).map(|n| n as f64 / count as f64 * TAU / frequency).collect();
        let base = [0, 1, 2].map(|order| {
            DMatrix::from_fn(count, 2 * harmonics + 1, |row, column| {
                let rate = column.div_ceil(2) as f64 * frequency;
                // A derivative is a shift by a quarter of a turn.
                let phase = rate * times[row] + 0.25 * TAU * f64::from(order);
                rate.powi(order) * if column % 2 == 0 { phase.cos() } else { phase.sin() }
            })
        });
        Self { p: *p, frequency, base, times }
    }

    fn size(&self) -> usize {
        self.base[0].ncols()
    }

    /// The balance of forces at an instant, as it stands in (22).
    fn residual(&self, t: f64, x: [f64; 3], v: [f64; 3], a: [f64; 3]) -> [f64; 3] {
        let p = &self.p;
        let f = match p.regime {
            Regime::Homogeneous => x[2],
            Regime::Contact => x[2] - 1.0,
            Regime::Backlash => x[2] - x[2].clamp(-1.0, 1.0),
        };
        let mesh = 2.0 * p.zeta * v[2] + (1.0 + p.k0 * (p.omega * t).cos()) * f;
        let load = p.load + p.error * p.omega.powi(2) * (p.omega * t).cos();
        let pinion = 2.0 * p.zeta_p * v[0] + p.k_p * x[0] + p.alpha_p * x[0].powi(3);
        let gear = 2.0 * p.zeta_g * v[1] + p.k_g * x[1] + p.alpha_g * x[1].powi(3);
        [p.m_p * a[0] + pinion + mesh, p.m_g * a[1] + gear - mesh, a[2] - a[0] + a[1] + mesh - load]
    }

    /// Newton's method; how fast it converges depends on the Jacobian, what it converges to does not.
    fn solve(&self, guess: &[DVector<f64>; 3]) -> [DVector<f64>; 3] {
        let size = self.size();
        let (p, pair) = (&self.p, GearPair::new(&self.p));
        let mut coefficients = guess.clone();
        for _ in 0..40 {
            let motion =
                [0, 1, 2].map(|order| [0, 1, 2].map(|i: usize| &self.base[order] * &coefficients[i]));
            let mut errors = [0, 1, 2].map(|_| DVector::zeros(self.times.len()));
            let mut jacobian = DMatrix::zeros(3 * size, 3 * size);
            let mut scaled = [[0, 1, 2]; 3].map(|row| row.map(|_| self.base[0].clone()));
            for (n, &time) in self.times.iter().enumerate() {
                let [x, v, a] = [0, 1, 2].map(|order: usize| [0, 1, 2].map(|i: usize| motion[order][i][n]));
                let residual = self.residual(time, x, v, a);
                (0..3).for_each(|i| errors[i][n] = residual[i]);
                let rows = pair.jacobian(time, &[x[0], x[1], x[2], v[0], v[1], v[2]]);
                // The rows of the accelerations, times the masses as in the residual.
                let linear = |i: usize, j: usize| match i {
                    0 => p.m_p * rows[3][j],
                    1 => p.m_g * rows[4][j],
                    _ => rows[5][j] - rows[3][j] + rows[4][j],
                };
                let mass = [[p.m_p, 0.0, 0.0], [0.0, p.m_g, 0.0], [-1.0, 1.0, 1.0]];
                for i in 0..3 {
                    for j in 0..3 {
                        for column in 0..size {
                            let [position, velocity, acceleration] =
                                [0, 1, 2].map(|order: usize| self.base[order][(n, column)]);
                            scaled[i][j][(n, column)] = mass[i][j] * acceleration
                                - linear(i, j) * position
                                - linear(i, j + 3) * velocity;
                        }
                    }
                }
            }
            // Back to the frequencies: the base functions are orthogonal over the instants.
            let back = self.base[0].transpose() / (0.5 * self.times.len() as f64);
            let mut right = DVector::zeros(3 * size);
            for i in 0..3 {
                right.rows_mut(i * size, size).copy_from(&(&back * &errors[i]));
                for j in 0..3 {
                    jacobian.view_mut((i * size, j * size), (size, size)).copy_from(&(&back * &scaled[i][j]));
                }
            }
            let step = jacobian.lu().solve(&right).expect("regular");
            for i in 0..3 {
                coefficients[i] -= step.rows(i * size, size);
            }
            if step.amax() < 1e-13 {
                return coefficients;
            }
        }
        panic!("harmonic balance does not converge at Omega {}", p.omega)
    }

    fn state(&self, coefficients: &[DVector<f64>; 3]) -> [f64; 6] {
        let value = |order: usize, i: usize| (self.base[order].row(0) * &coefficients[i])[0];
        std::array::from_fn(|i| value(i / 3, i % 3))
    }

    fn greatest(&self, coefficients: &DVector<f64>) -> f64 {
        (&self.base[0] * coefficients).amax()
    }

    /// The lowest harmonics of an orbit, to two decimals only: nearer than that the balance finds its own way.
    fn rough(&self, state: [f64; 6], periods: usize) -> [DVector<f64>; 3] {
        // A state every mesh period is too coarse: the motion is sampled by moving the start of the clock.
        let samples = 32 * periods;
        let motion = self.sampled(state, samples);
        [0, 1, 2].map(|i: usize| {
            DVector::from_fn(self.size(), |column, _| {
                let harmonic = column.div_ceil(2);
                if harmonic > 4 * periods {
                    return 0.0;
                }
                let sum: f64 = (0..samples)
                    .map(|n| {
                        let phase = harmonic as f64 * n as f64 / samples as f64 * TAU;
                        motion[n][i] * if column % 2 == 0 { phase.cos() } else { phase.sin() }
                    })
                    .sum();
                let whole = if column == 0 { 1.0 } else { 2.0 };
                (sum * whole / samples as f64 * 100.0).round() / 100.0
            })
        })
    }

    /// States at equally spaced instants, by the classical Runge-Kutta method.
    fn sampled(&self, mut state: [f64; 6], samples: usize) -> Vec<[f64; 6]> {
        use gear_bifurcations::numerics::ode::Field;
        let pair = GearPair::new(&self.p);
        let steps = 20;
        let h = TAU / self.frequency / (samples * steps) as f64;
        let add = |state: &[f64; 6], rate: &[f64; 6], h: f64| -> [f64; 6] {
            std::array::from_fn(|i| state[i] + h * rate[i])
        };
        let mut all = Vec::with_capacity(samples);
        for n in 0..samples * steps {
            if n % steps == 0 {
                all.push(state);
            }
            let t = n as f64 * h;
            let k1 = pair.derivative(t, &state);
            let k2 = pair.derivative(t + 0.5 * h, &add(&state, &k1, 0.5 * h));
            let k3 = pair.derivative(t + 0.5 * h, &add(&state, &k2, 0.5 * h));
            let k4 = pair.derivative(t + h, &add(&state, &k3, h));
            state = std::array::from_fn(|i| state[i] + h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]));
        }
        all
    }
}

/// Five points spread over a branch, those at its ends left out.
fn five(branch: &Branch) -> [usize; 5] {
    let count = branch.value.len();
    [1, 2, 3, 4, 5].map(|part| part * count / 6)
}

fn at(p: &Parameters, omega: f64) -> Parameters {
    Parameters { omega, omega_p: omega, omega_g: omega, ..*p }
}

/// With so many harmonics, and so many instants for each: greatest deviations of states and of the greatest |u_p| and |u| at five points of a branch.
fn deviations(given: &Value, range: [f64; 2], period: usize, [harmonics, instants]: [usize; 2]) -> [f64; 2] {
    let p = parameters(given);
    let found = branch(&p, &BranchOptions::new(range, period)).expect("a branch");
    assert_eq!(found.period, period);
    let (mut states, mut peaks) = (0.0_f64, 0.0_f64);
    for index in five(&found) {
        let balance = Balance::new(&at(&p, found.value[index]), period, harmonics, instants);
        let coefficients = balance.solve(&balance.rough(found.state[index], period));
        let state = balance.state(&coefficients);
        for i in 0..6 {
            states = states.max((state[i] - found.state[index][i]).abs());
        }
        // Between the instants the greatest value is higher by a part of the square of their distance.
        peaks = peaks.max((balance.greatest(&coefficients[0]) / found.max_u_p[index] - 1.0).abs());
        peaks = peaks.max((balance.greatest(&coefficients[2]) / found.max_u[index] - 1.0).abs());
    }
    [states, peaks]
}

#[test]
fn softening_orbits_of_twice_the_period_balance() {
    let [states, peaks] = deviations(&json!({"Omega": 1.65}), [1.3, 1.68], 2, [50, 4]);
    assert!(states < 1e-8 && peaks < 2e-2, "{states:e} {peaks:e}");
}

#[test]
fn hardening_orbits_of_twice_the_period_balance() {
    let given = json!({"Omega": 1.8, "alpha": 0.2});
    let [states, peaks] = deviations(&given, [1.5, 2.2], 2, [70, 4]);
    assert!(states < 1e-8 && peaks < 2e-2, "{states:e} {peaks:e}");
}

#[test]
fn responses_of_unequal_supports_under_load_balance() {
    let given = json!({"Omega": 1.0, "m_g": 1.3, "k_g": 4.0, "F": 1.0, "E": 0.1, "alpha_p": 0.1, "alpha_g": -0.1,
        "regime": "contact"});
    let [states, peaks] = deviations(&given, [0.8, 1.4], 1, [30, 4]);
    assert!(states < 1e-8 && peaks < 2e-2, "{states:e} {peaks:e}");
}

/// The third derivatives of an orbit that parts the teeth jump, so that its harmonics die out as powers only.
#[test]
fn orbits_that_part_the_teeth_balance() {
    let given = json!({"Omega": 1.6, "zeta": 0.07, "alpha": 0.0, "F": 1.5, "regime": "backlash"});
    let [coarse, _] = deviations(&given, [1.5, 1.65], 2, [16, 64]);
    let [fine, _] = deviations(&given, [1.5, 1.65], 2, [40, 48]);
    assert!(fine < 1e-3 && fine < 0.2 * coarse, "{coarse:e} {fine:e}");
}
