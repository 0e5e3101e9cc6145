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

/// Number of coordinates: `a, u, a', u'`, then rows of the derivative by the start: of a (four columns) and S (two),
/// of a' and S', of u (four), of u'.
pub const SIZE: usize = 24;
/// Index of u.
const U: usize = 1;

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
    (all[0], all[1], all[2], all[3]) = (state[0], state[2], state[3], state[5]);
    all[4] = 1.0;
    all[8] = 1.0;
    all[12] = 1.0;
    all[15] = 1.0;
    all[17] = 1.0;
    all[23] = 1.0;
    all
}

/// The state of all six coordinates.
pub fn full(all: &[f64; SIZE]) -> [f64; 6] {
    [all[0], -all[0], all[1], all[2], -all[2], all[3]]
}

/// The state and the rows of its 6 x 6 derivative.
pub fn split(all: &[f64; SIZE]) -> ([f64; 6], [[f64; 6]; 6]) {
    // Rows of the half difference and of u by a, u, a', u'; rows of the half sum by S, S'.
    let take = |from: usize| -> [f64; 4] { std::array::from_fn(|i| all[from + i]) };
    let (a, a_dot, u, u_dot) = (take(4), take(10), take(16), take(20));
    let (s, s_dot) = ([all[8], all[9]], [all[14], all[15]]);
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
        // One loop over the earlier coefficients makes all products, whose factors lie with the last one first, so that
        // every one of its arrays is run through forwards.
        let mut pulsation = forcing.pulsation;
        pulsation.reverse();
        let mut square = [0.0; LEN];
        let nonlinear = p.alpha_p != 0.0;
        series[0] = *state;
        for n in 0..LEN - 1 {
            let first = LEN - 1 - n;
            let row = series[n];
            if nonlinear {
                square[first] = square_of(series, n);
            }
            let (mut cube, mut linear_cube) = (0.0, [0.0; 6]);
            let (mut tooth, mut linear_tooth) = (0.0, [0.0; 4]);
            for ((earlier, square), pulsation) in
                series[..=n].iter().zip(&square[first..]).zip(&pulsation[first..])
            {
                cube += square * earlier[0];
                for lane in 0..6 {
                    linear_cube[lane] += square * earlier[4 + lane];
                }
                tooth += pulsation * earlier[U];
                for lane in 0..4 {
                    linear_tooth[lane] += pulsation * earlier[16 + lane];
                }
            }
            tooth = slope * (tooth + row[U]);
            tooth -= offset * (pulsation[first] + if n == 0 { 1.0 } else { 0.0 });
            for lane in 0..4 {
                linear_tooth[lane] = slope * (linear_tooth[lane] + row[16 + lane]);
            }
            let mesh = mesh_damping * row[3] + tooth;
            let a = -(damping * row[2] + p.k_p * row[0] + p.alpha_p * cube + mesh) * inverse_mass;
            let rate = 1.0 / (n + 1) as f64;
            let mut linear_mesh = [0.0; 6];
            for lane in 0..4 {
                linear_mesh[lane] = mesh_damping * row[20 + lane] + linear_tooth[lane];
            }
            let next = &mut series[n + 1];
            next[0] = row[2] * rate;
            next[1] = row[3] * rate;
            next[2] = a * rate;
            next[3] = (2.0 * a - mesh + forcing.load[n]) * rate;
            let mut accelerations = [0.0; 6];
            for lane in 0..6 {
                accelerations[lane] = -(damping * row[10 + lane]
                    + p.k_p * row[4 + lane]
                    + 3.0 * p.alpha_p * linear_cube[lane]
                    + linear_mesh[lane])
                    * inverse_mass;
                next[4 + lane] = row[10 + lane] * rate;
                next[10 + lane] = accelerations[lane] * rate;
            }
            for lane in 0..4 {
                next[16 + lane] = row[20 + lane] * rate;
                next[20 + lane] = (2.0 * accelerations[lane] - linear_mesh[lane]) * rate;
            }
        }
    }
}

/// Coefficient n of the square of the first coordinate.
#[inline]
fn square_of<const LEN: usize>(series: &Series<SIZE, LEN>, n: usize) -> f64 {
    let mut pairs = 0.0;
    for j in 0..n.div_ceil(2) {
        pairs += series[j][0] * series[n - j][0];
    }
    let middle = if n.is_multiple_of(2) { series[n / 2][0] } else { 0.0 };
    2.0 * pairs + middle * middle
}
