//! The equations of motion and their variational equations on the manifold `u_g = -u_p` of equal supports (24).
//!
//! There the half sum S of both displacements is zero, and in the linearisation it decouples from the half
//! difference a = u_p and from u, so that of the 36 numbers of the derivative 20 remain: four by four within the
//! manifold and two by two across it.
//!
//! ```text
//! m a'' = -2 zeta_s a' - k a - alpha a^3 - (2 zeta u' + s f(u)),   u'' = 2 a'' - (2 zeta u' + s f(u)) + load
//! m S'' = -2 zeta_s S' - (k + 3 alpha a^2) S
//! ```

use crate::model::equations::{Contact, Forcing, GearPair, contact, contact_boundaries};
use crate::model::parameters::Parameters;
use crate::numerics::ode::taylor::{Boundary, Series, TaylorField};

/// Number of coordinates: `a` and its derivative by the start (four columns), that of `S` (two), `u` and its derivative
/// (four); then the rates of all these in the same order.
pub const SIZE: usize = 24;
/// Half of them.
const HALF: usize = SIZE / 2;
/// So many come first that have to do with the supports, and are multiplied by the square of the displacement; the others
/// have to do with the teeth, and are multiplied by the pulsation.
const SUPPORTS: usize = 7;
/// Index of the derivative of S.
const S: usize = 5;
/// Index of u.
const U: usize = SUPPORTS;
/// Where a and u are: the value, its rate, the value's derivative by the start.
pub const PLACES: [(usize, usize, usize); 2] = [(0, HALF, 1), (U, HALF + U, U + 1)];

/// A gear pair with equal supports on its manifold.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Manifold {
    pair: GearPair,
}

/// Whether a state is on the manifold, to the last bit.
pub fn holds(state: &[f64; 6]) -> bool {
    state[0] == -state[1] && state[3] == -state[4]
}

/// The same state on the manifold to the last bit, for one that is there but for rounding.
pub fn onto_manifold(state: &[f64; 6]) -> [f64; 6] {
    let [u_p, _, u, v_p, _, w] = *state;
    [u_p, -u_p, u, v_p, -v_p, w]
}

impl Manifold {
    /// On the manifold of this pair; none where the supports differ.
    pub fn of(p: &Parameters) -> Option<Self> {
        p.symmetric().is_ok().then(|| Self { pair: GearPair::new(p) })
    }
}

/// The state with the identity as its derivative.
pub fn start(state: &[f64; 6]) -> [f64; SIZE] {
    let mut all = [0.0; SIZE];
    (all[0], all[U], all[HALF], all[HALF + U]) = (state[0], state[2], state[3], state[5]);
    for (first, column) in [(1, 0), (U + 1, 1), (HALF + 1, 2), (HALF + U + 1, 3), (S, 0), (HALF + S, 1)] {
        all[first + column] = 1.0;
    }
    all
}

/// The state of all six coordinates.
pub fn full(all: &[f64; SIZE]) -> [f64; 6] {
    [all[0], -all[0], all[U], all[HALF], -all[HALF], all[HALF + U]]
}

/// The state and the rows of its 6 x 6 derivative.
pub fn split(all: &[f64; SIZE]) -> ([f64; 6], [[f64; 6]; 6]) {
    // Rows of the half difference and of u by a, u, a', u'; rows of the half sum by S, S'.
    let take = |from: usize| -> [f64; 4] { std::array::from_fn(|i| all[from + i]) };
    let (a, a_dot, u, u_dot) = (take(1), take(HALF + 1), take(U + 1), take(HALF + U + 1));
    let (s, s_dot) = ([all[S], all[S + 1]], [all[HALF + S], all[HALF + S + 1]]);
    // u_p = a + S, u_g = S - a; a = (u_p - u_g) / 2, S = (u_p + u_g) / 2.
    let body = |a: [f64; 4], s: [f64; 2], sign: f64| {
        let half = |i: usize| 0.5 * sign * a[i];
        [
            half(0) + 0.5 * s[0],
            -half(0) + 0.5 * s[0],
            sign * a[1],
            half(2) + 0.5 * s[1],
            -half(2) + 0.5 * s[1],
            sign * a[3],
        ]
    };
    let rows = [
        body(a, s, 1.0),
        body(a, s, -1.0),
        gradient(&u),
        body(a_dot, s_dot, 1.0),
        body(a_dot, s_dot, -1.0),
        gradient(&u_dot),
    ];
    (full(all), rows)
}

/// A derivative by (a, u, a', u') as one by all six coordinates.
pub fn gradient(row: &[f64; 4]) -> [f64; 6] {
    [0.5 * row[0], -0.5 * row[0], row[1], 0.5 * row[2], -0.5 * row[2], row[3]]
}

impl TaylorField<SIZE> for Manifold {
    type Piece = Contact;

    fn piece(&self, time: f64, state: &[f64; SIZE]) -> Contact {
        contact(&self.pair, time, &full(state))
    }

    fn boundaries(&self, piece: Contact) -> [Option<Boundary>; 2] {
        contact_boundaries(piece).map(|end| end.map(|boundary| Boundary { coordinate: U, ..boundary }))
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
        let (slope, offset) = piece.line();
        let (inverse_mass, damping, mesh_damping) = (1.0 / p.m_p, 2.0 * p.zeta_p, 2.0 * p.zeta);
        let nonlinear = p.alpha_p != 0.0;
        let mut cubic = [3.0 * p.alpha_p; SUPPORTS];
        cubic[0] = p.alpha_p;
        // One loop over the earlier coefficients makes all products, whose factors, the square of a and the pulsation, lie with
        // the last one first, so that every one of its arrays is run through forwards.
        let mut factors = [[0.0; 2]; LEN];
        for (factors, pulsation) in factors.iter_mut().rev().zip(&forcing.pulsation) {
            factors[1] = *pulsation;
        }
        let mut displacement = [0.0; LEN];
        series[0] = *state;
        for n in 0..LEN - 1 {
            let (known, next) = series.split_at_mut(n + 1);
            let (row, next) = (&known[n], &mut next[0]);
            let factors = &mut factors[LEN - 1 - n..];
            displacement[n] = row[0];
            if nonlinear {
                factors[0][0] = square_of(&displacement[..=n]);
            }
            let mut sums = [0.0; HALF];
            for (earlier, [square, pulsation]) in known.iter().zip(&*factors) {
                let factor: [f64; HALF] =
                    std::array::from_fn(|lane| if lane < SUPPORTS { *square } else { *pulsation });
                for lane in 0..HALF {
                    sums[lane] += factor[lane] * earlier[lane];
                }
            }
            // The tooth force and its derivative, which push the supports' first five.
            let mut mesh = [0.0; SUPPORTS];
            for lane in 0..HALF - SUPPORTS {
                let (at, rate) = (U + lane, HALF + U + lane);
                mesh[lane] = slope * (sums[at] + row[at]) + mesh_damping * row[rate];
            }
            mesh[0] -= offset * (forcing.pulsation[n] + if n == 0 { 1.0 } else { 0.0 });
            let mut accelerations = [0.0; SUPPORTS];
            for lane in 0..SUPPORTS {
                let springs = p.k_p * row[lane] + cubic[lane] * sums[lane];
                accelerations[lane] = -(damping * row[HALF + lane] + springs + mesh[lane]) * inverse_mass;
            }
            let rate = 1.0 / (n + 1) as f64;
            for lane in 0..HALF {
                next[lane] = row[HALF + lane] * rate;
            }
            for lane in 0..SUPPORTS {
                next[HALF + lane] = accelerations[lane] * rate;
            }
            for lane in 0..HALF - SUPPORTS {
                next[HALF + U + lane] = (2.0 * accelerations[lane] - mesh[lane]) * rate;
            }
            next[HALF + U] += forcing.load[n] * rate;
        }
    }
}

/// The last coefficient of the square of a series.
#[inline]
fn square_of(series: &[f64]) -> f64 {
    let (half, odd) = (series.len() / 2, series.len() % 2);
    let (front, back) = (&series[..half], &series[half + odd..]);
    let pairs: f64 = front.iter().zip(back.iter().rev()).map(|(left, right)| left * right).sum();
    2.0 * pairs + if odd == 1 { series[half] * series[half] } else { 0.0 }
}
