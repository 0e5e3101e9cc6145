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
    let tooth = |u: [f64; 4]| [0.5 * u[0], -0.5 * u[0], u[1], 0.5 * u[2], -0.5 * u[2], u[3]];
    let rows = [
        body(a, s, 1.0),
        body(a, s, -1.0),
        tooth(u),
        body(a_dot, s_dot, 1.0),
        body(a_dot, s_dot, -1.0),
        tooth(u_dot),
    ];
    (full(all), rows)
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
        // Products of series are spread forwards, as in the equations of motion: of the square, the cube and the
        // tooth force of the motion, and of its linearisation.
        let mut square = [0.0; LEN];
        let mut cube = [0.0; LEN];
        let mut tooth = [0.0; LEN];
        let mut linear_tooth = [[0.0; 4]; LEN];
        let mut linear_cube = [[0.0; 6]; LEN];
        series[0] = *state;
        for n in 0..LEN - 1 {
            let row = series[n];
            let force = slope * row[U] - if n == 0 { offset } else { 0.0 };
            let lanes: [f64; 4] = std::array::from_fn(|i| slope * row[16 + i]);
            tooth[n] += force;
            for lane in 0..4 {
                linear_tooth[n][lane] += lanes[lane];
            }
            if slope != 0.0 {
                for (later, pulsation) in (n..LEN).zip(&forcing.pulsation) {
                    tooth[later] += pulsation * force;
                    for lane in 0..4 {
                        linear_tooth[later][lane] += pulsation * lanes[lane];
                    }
                }
            }
            if p.alpha_p != 0.0 {
                spread_cubes(n, series, &mut square, &mut cube, &mut linear_cube);
            }
            let mesh = mesh_damping * row[3] + tooth[n];
            let a = -(damping * row[2] + p.k_p * row[0] + p.alpha_p * cube[n] + mesh) * inverse_mass;
            let rate = 1.0 / (n + 1) as f64;
            let mut linear_mesh = [0.0; 6];
            for lane in 0..4 {
                linear_mesh[lane] = mesh_damping * row[20 + lane] + linear_tooth[n][lane];
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
                    + 3.0 * p.alpha_p * linear_cube[n][lane]
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

/// Adds to the square and the cube of a, and to the square times the derivative's rows, what their n-th coefficients
/// bring.
#[inline]
fn spread_cubes<const LEN: usize>(
    n: usize,
    series: &Series<SIZE, LEN>,
    square: &mut [f64; LEN],
    cube: &mut [f64; LEN],
    linear: &mut [[f64; 6]; LEN],
) {
    let newest = series[n][0];
    for (j, later) in (n..(2 * n).min(LEN)).enumerate() {
        square[later] += 2.0 * newest * series[j][0];
    }
    if 2 * n < LEN {
        square[2 * n] += newest * newest;
    }
    // The square's coefficients up to n are complete now.
    let mut lanes = [0.0; 6];
    lanes.copy_from_slice(&series[n][4..10]);
    for (j, later) in (n..LEN).enumerate().take(n + 1) {
        if j < n {
            cube[later] += square[n] * series[j][0] + newest * square[j];
        } else {
            cube[later] += square[n] * newest;
        }
        if j < n {
            for lane in 0..6 {
                linear[later][lane] += square[n] * series[j][4 + lane] + lanes[lane] * square[j];
            }
        } else {
            for lane in 0..6 {
                linear[later][lane] += square[n] * lanes[lane];
            }
        }
    }
}
