//! The equations of motion together with their variational equations: how the motion answers small changes of
//! its start.
//!
//! State: the six of the motion, then the 6 x 6 derivative by the start, row after row. In the dead zone the
//! mesh damping goes on acting, so that the field is continuous at `|u| = 1` and the derivative has no jump
//! there: only its matrix switches, together with the piece of the motion.

use crate::model::equations::{Contact, Forcing, GearPair, U, contact, contact_boundaries};
use crate::model::manifold::convolved;
use crate::numerics::ode::taylor::{Boundary, Series, TaylorField};

/// Number of coordinates: six of the motion and 36 of its derivative.
pub const SIZE: usize = 42;

/// A gear pair with its variational equations.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Variational {
    /// The gear pair.
    pub pair: GearPair,
}

/// The state of the motion with the identity as its derivative.
pub fn start(state: &[f64; 6]) -> [f64; SIZE] {
    let mut all = [0.0; SIZE];
    all[..6].copy_from_slice(state);
    for i in 0..6 {
        all[6 + 7 * i] = 1.0;
    }
    all
}

/// Takes the motion and the rows of its derivative apart.
pub fn split(all: &[f64; SIZE]) -> ([f64; 6], [[f64; 6]; 6]) {
    let take = |from: usize| {
        let mut six = [0.0; 6];
        six.copy_from_slice(&all[from..from + 6]);
        six
    };
    (take(0), std::array::from_fn(|row| take(6 + 6 * row)))
}

/// One coordinate of the motion (0) or one row of its derivative (1 to 6): the six columns as lanes.
fn lanes(row: &[f64; SIZE], coordinate: usize) -> [f64; 6] {
    let mut six = [0.0; 6];
    six.copy_from_slice(&row[6 + 6 * coordinate..12 + 6 * coordinate]);
    six
}

#[inline]
fn add_scaled(sum: &mut [f64; 6], factor: f64, lanes: &[f64; 6]) {
    for (sum, lane) in sum.iter_mut().zip(lanes) {
        *sum += factor * lane;
    }
}

impl TaylorField<SIZE> for Variational {
    type Piece = Contact;

    fn piece(&self, time: f64, state: &[f64; SIZE]) -> Contact {
        contact(&self.pair, time, &split(state).0)
    }

    fn boundaries(&self, piece: Contact) -> [Option<Boundary>; 2] {
        contact_boundaries(piece)
    }

    fn series<const LEN: usize>(
        &self,
        piece: Contact,
        time: f64,
        state: &[f64; SIZE],
        series: &mut Series<SIZE, LEN>,
    ) {
        let p = &self.pair.parameters;
        let forcing = Forcing::<LEN>::new(p, time);
        let (slope, _) = piece.line();
        let cubic = [p.alpha_p, p.alpha_g];
        let inverse_mass = [1.0 / p.m_p, 1.0 / p.m_g];
        let stiffness = [p.k_p, p.k_g];
        let damping = [2.0 * p.zeta_p, 2.0 * p.zeta_g];
        let mut motion = [[0.0; 6]; LEN];
        let mut six = [0.0; 6];
        six.copy_from_slice(&state[..6]);
        self.pair.series(piece, time, &six, &mut motion);
        let squares = squares(&motion);
        let nonlinear = cubic != [0.0; 2];
        // The rows of the derivative that enter products, each coefficient's lanes side by side.
        let mut displacements = [[[0.0; 6]; LEN]; 3];
        series[0] = *state;
        for n in 0..LEN - 1 {
            let row = series[n];
            for (i, displacement) in displacements.iter_mut().enumerate() {
                displacement[n] = lanes(&row, i);
            }
            let mut mesh = [0.0; 6];
            if slope != 0.0 {
                mesh = convolved(&forcing.pulsation, &displacements[U], n);
                add_scaled(&mut mesh, 1.0, &displacements[U][n]);
            }
            add_scaled(&mut mesh, 2.0 * p.zeta, &lanes(&row, 5));
            let mut accelerations = [[0.0; 6]; 3];
            for i in 0..2 {
                let mut force = mesh;
                if i == 1 {
                    force = force.map(|value| -value);
                }
                add_scaled(&mut force, damping[i], &lanes(&row, 3 + i));
                add_scaled(&mut force, stiffness[i], &displacements[i][n]);
                if nonlinear {
                    let cubes = convolved(&squares[i], &displacements[i], n);
                    add_scaled(&mut force, 3.0 * cubic[i], &cubes);
                }
                accelerations[i] = force.map(|value| -value * inverse_mass[i]);
            }
            for lane in 0..6 {
                accelerations[2][lane] = accelerations[0][lane] - accelerations[1][lane] - mesh[lane];
            }
            let rate = 1.0 / (n + 1) as f64;
            let next = &mut series[n + 1];
            next[..6].copy_from_slice(&motion[n + 1]);
            for i in 0..3 {
                let velocities = lanes(&row, 3 + i);
                for lane in 0..6 {
                    next[6 + 6 * i + lane] = velocities[lane] * rate;
                    next[24 + 6 * i + lane] = accelerations[i][lane] * rate;
                }
            }
        }
    }
}

/// Coefficients of `u_p^2` and of `u_g^2`.
fn squares<const LEN: usize>(motion: &Series<6, LEN>) -> [[f64; LEN]; 2] {
    let mut squares = [[0.0; LEN]; 2];
    for n in 0..LEN {
        let mut sum = [0.0; 2];
        for j in 0..=n {
            for lane in 0..2 {
                sum[lane] += motion[j][lane] * motion[n - j][lane];
            }
        }
        (squares[0][n], squares[1][n]) = (sum[0], sum[1]);
    }
    squares
}
