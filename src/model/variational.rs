//! The equations of motion together with their variational equations: how the motion answers small changes of
//! its start.
//!
//! State: the six of the motion, then the 6 x 6 derivative by the start, row after row. In the dead zone the
//! mesh damping goes on acting, so that the field is continuous at `|u| = 1` and the derivative has no jump
//! there: only its matrix switches, together with the piece of the motion.

use crate::model::equations::{Contact, Forcing, GearPair, contact, contact_boundaries};
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
        // One loop over the earlier coefficients makes all products, whose factors lie with the last one first.
        let factors = factors(&motion, &forcing.pulsation);
        series[0] = *state;
        for n in 0..LEN - 1 {
            let row = series[n];
            let (mut cubes, mut mesh) = ([[0.0; 6]; 2], [0.0; 6]);
            for (earlier, [pinion, gear, pulsation]) in series[..=n].iter().zip(&factors[LEN - 1 - n..]) {
                for lane in 0..6 {
                    cubes[0][lane] += pinion * earlier[6 + lane];
                    cubes[1][lane] += gear * earlier[12 + lane];
                    mesh[lane] += pulsation * earlier[18 + lane];
                }
            }
            for lane in 0..6 {
                mesh[lane] = slope * (mesh[lane] + row[18 + lane]) + 2.0 * p.zeta * row[36 + lane];
            }
            let mut accelerations = [[0.0; 6]; 3];
            for i in 0..2 {
                let pushed = if i == 0 { 1.0 } else { -1.0 };
                for lane in 0..6 {
                    let force = pushed * mesh[lane]
                        + damping[i] * row[24 + 6 * i + lane]
                        + stiffness[i] * row[6 + 6 * i + lane]
                        + 3.0 * cubic[i] * cubes[i][lane];
                    accelerations[i][lane] = -force * inverse_mass[i];
                }
            }
            for lane in 0..6 {
                accelerations[2][lane] = accelerations[0][lane] - accelerations[1][lane] - mesh[lane];
            }
            let rate = 1.0 / (n + 1) as f64;
            let next = &mut series[n + 1];
            next[..6].copy_from_slice(&motion[n + 1]);
            for i in 0..3 {
                for lane in 0..6 {
                    next[6 + 6 * i + lane] = row[24 + 6 * i + lane] * rate;
                    next[24 + 6 * i + lane] = accelerations[i][lane] * rate;
                }
            }
        }
    }
}

/// Coefficients of `u_p^2`, of `u_g^2` and of the pulsation, the last one first.
fn factors<const LEN: usize>(motion: &Series<6, LEN>, pulsation: &[f64; LEN]) -> [[f64; 3]; LEN] {
    let mut factors = [[0.0; 3]; LEN];
    for n in 0..LEN {
        let mut sum = [0.0; 2];
        for j in 0..=n {
            for lane in 0..2 {
                sum[lane] += motion[j][lane] * motion[n - j][lane];
            }
        }
        factors[LEN - 1 - n] = [sum[0], sum[1], pulsation[n]];
    }
    factors
}
