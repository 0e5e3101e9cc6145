//! Several motions on the manifold `u_g = -u_p` at once, side by side as lanes: for studies that follow thousands of
//! starts.
//!
//! With equal supports the manifold is invariant, and what is left of (22) on it is, with `s = 1 + k0 cos(Omega t)`,
//!
//! ```text
//! m u_p'' = -2 zeta_s u_p' - k u_p - alpha u_p^3 - F_m,    F_m = 2 zeta u' + s f(u),
//!   u''   = 2 u_p'' - F_m + F + F_p cos(Omega_p t) + F_g cos(Omega_g t) + Omega^2 E cos(Omega t).
//! ```

use crate::model::equations::Forcing;
use crate::model::parameters::{Parameters, Regime};
use crate::numerics::ode::taylor::{Boundary, Series, TaylorField};

/// Motions side by side.
pub const LANES: usize = 4;
/// Coordinates of all of them: `u_p` of each, then `u`, `u_p'`, `u'`.
pub const SIZE: usize = 4 * LANES;

/// A gear pair with equal supports and one tooth function, restricted to the manifold.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OnManifold {
    parameters: Parameters,
    /// Offset of `f(u) = u - offset`.
    offset: f64,
}

impl OnManifold {
    /// None where the supports differ or the teeth can part: then the motion may leave the manifold, or its field has
    /// pieces, which the lanes would enter at different times.
    pub fn new(p: &Parameters) -> Option<Self> {
        p.symmetric().ok()?;
        let offset = match p.regime {
            Regime::Homogeneous => 0.0,
            Regime::Contact => 1.0,
            Regime::Backlash => return None,
        };
        Some(Self { parameters: *p, offset })
    }
}

/// Puts a state, whose gear is opposed to its pinion, into a lane.
pub fn set_lane(all: &mut [f64; SIZE], lane: usize, state: &[f64; 6]) {
    for (place, coordinate) in [0, 2, 3, 5].into_iter().enumerate() {
        all[place * LANES + lane] = state[coordinate];
    }
}

/// The state in a lane.
pub fn lane(all: &[f64; SIZE], lane: usize) -> [f64; 6] {
    let at = |place: usize| all[place * LANES + lane];
    [at(0), -at(0), at(1), at(2), -at(2), at(3)]
}

type Lanes = [f64; LANES];

#[inline]
fn add_product(sum: &mut Lanes, left: &Lanes, right: &Lanes) {
    for lane in 0..LANES {
        sum[lane] += left[lane] * right[lane];
    }
}

impl TaylorField<SIZE> for OnManifold {
    type Piece = ();

    fn piece(&self, _time: f64, _state: &[f64; SIZE]) {}

    fn boundaries(&self, _piece: ()) -> [Option<Boundary>; 2] {
        [None, None]
    }

    fn series<const LEN: usize>(
        &self,
        _piece: (),
        time: f64,
        state: &[f64; SIZE],
        series: &mut Series<SIZE, LEN>,
    ) {
        let p = &self.parameters;
        let forcing = Forcing::<LEN>::new(p, time);
        let inverse_mass = 1.0 / p.m_p;
        let (mut position, mut square, mut tooth) =
            ([[0.0; LANES]; LEN], [[0.0; LANES]; LEN], [[0.0; LANES]; LEN]);
        series[0] = *state;
        for n in 0..LEN - 1 {
            let row = &series[n];
            let part = |place: usize| -> Lanes { std::array::from_fn(|lane| row[place * LANES + lane]) };
            let (u_p, u, v, w) = (part(0), part(1), part(2), part(3));
            position[n] = u_p;
            tooth[n] = if n == 0 { u.map(|u| u - self.offset) } else { u };
            let mut mesh: Lanes = std::array::from_fn(|lane| 2.0 * p.zeta * w[lane] + tooth[n][lane]);
            for (pulsation, tooth) in forcing.pulsation[..=n].iter().rev().zip(&tooth) {
                for lane in 0..LANES {
                    mesh[lane] += pulsation * tooth[lane];
                }
            }
            let mut cube = [0.0; LANES];
            if p.alpha_p != 0.0 {
                // Twice the products of the first half, and the middle's own square.
                for j in 0..n.div_ceil(2) {
                    add_product(&mut square[n], &position[j], &position[n - j]);
                }
                square[n] = square[n].map(|half| 2.0 * half);
                if n % 2 == 0 {
                    let middle = position[n / 2];
                    add_product(&mut square[n], &middle, &middle);
                }
                for (square, position) in square[..=n].iter().rev().zip(&position) {
                    add_product(&mut cube, square, position);
                }
            }
            let rate = 1.0 / (n + 1) as f64;
            let next = &mut series[n + 1];
            for lane in 0..LANES {
                let support = 2.0 * p.zeta_p * v[lane] + p.k_p * u_p[lane] + p.alpha_p * cube[lane];
                let a = -(support + mesh[lane]) * inverse_mass;
                next[lane] = v[lane] * rate;
                next[LANES + lane] = w[lane] * rate;
                next[2 * LANES + lane] = a * rate;
                next[3 * LANES + lane] = (2.0 * a - mesh[lane] + forcing.load[n]) * rate;
            }
        }
    }
}
