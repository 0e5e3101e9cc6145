//! The equations of motion (22), their Jacobian, and their Taylor recurrences.
//!
//! State: `[u_p, u_g, u, u_p', u_g', u']`, displacement of pinion and gear along the line of action and dynamic
//! transmission error, all over half the backlash; the prime is the derivative by the dimensionless time.
//! Solved for the accelerations, with `s = 1 + k0 cos(Omega t)` and the tooth force `s f(u)`:
//!
//! ```text
//! m_p u_p'' = -2 zeta_p u_p' - k_p u_p - alpha_p u_p^3 - (2 zeta u' + s f(u))
//! m_g u_g'' = -2 zeta_g u_g' - k_g u_g - alpha_g u_g^3 + (2 zeta u' + s f(u))
//!     u''   = u_p'' - u_g'' - (2 zeta u' + s f(u)) + F + F_p cos(Omega_p t) + F_g cos(Omega_g t) + Omega^2 E cos(Omega t)
//! ```
//!
//! Departure from (8) and (9) as printed: the mesh damping acts on the velocity `u'`, as in (11).

use crate::model::angle::sine_and_cosine;
use crate::model::coefficients::{Coefficients, MOST};
use crate::model::parameters::{Parameters, Regime};
use crate::numerics::ode::Field;
use crate::numerics::ode::taylor::{Boundary, Series, TaylorField};

/// Index of `u` in the state.
pub const U: usize = 2;
/// Index of `u'` in the state.
pub const U_DOT: usize = 5;

/// A piece on which the tooth force is linear: `f(u) = slope * u - offset`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Contact {
    /// `f(u) = u`: deviation from the unloaded state, nothing ends.
    Deviation,
    /// `f(u) = u - 1` without end (25).
    Permanent,
    /// `f(u) = u - 1` down to `u = 1` (23).
    Driving,
    /// `f(u) = 0` for `|u| <= 1` (23).
    Parted,
    /// `f(u) = u + 1` up to `u = -1` (23): contact on the back of the teeth.
    Back,
}

impl Contact {
    /// Slope and offset of `f`.
    pub fn line(self) -> (f64, f64) {
        match self {
            Self::Deviation => (1.0, 0.0),
            Self::Permanent | Self::Driving => (1.0, 1.0),
            Self::Parted => (0.0, 0.0),
            Self::Back => (1.0, -1.0),
        }
    }
}

/// The backlash function (23).
pub fn backlash(u: f64) -> f64 {
    if u > 1.0 {
        u - 1.0
    } else if u < -1.0 {
        u + 1.0
    } else {
        0.0
    }
}

/// A gear pair, ready to be integrated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GearPair {
    /// Its parameters.
    pub parameters: Parameters,
}

impl GearPair {
    /// The gear pair with these parameters.
    pub fn new(parameters: &Parameters) -> Self {
        Self { parameters: *parameters }
    }

    /// Mesh stiffness over its mean, (10): `1 + k0 cos(Omega t)`.
    pub fn mesh_stiffness(&self, time: f64) -> f64 {
        1.0 + self.parameters.k0 * (self.parameters.omega * time).cos()
    }

    /// The load on the right-hand side of (19): `F + F_p cos + F_g cos + Omega^2 E cos`.
    pub fn load(&self, time: f64) -> f64 {
        let p = &self.parameters;
        p.load
            + p.load_p * (p.omega_p * time).cos()
            + p.load_g * (p.omega_g * time).cos()
            + p.omega * p.omega * p.error * (p.omega * time).cos()
    }

    /// `f(u)` of the regime.
    pub fn tooth_function(&self, u: f64) -> f64 {
        match self.parameters.regime {
            Regime::Homogeneous => u,
            Regime::Contact => u - 1.0,
            Regime::Backlash => backlash(u),
        }
    }

    /// The Jacobian of the right-hand side by the state, rows and columns in the order of the state; on a
    /// boundary of the dead zone, of the side inside it.
    pub fn jacobian(&self, time: f64, state: &[f64; 6]) -> [[f64; 6]; 6] {
        let p = &self.parameters;
        let slope = match p.regime {
            Regime::Backlash if state[U].abs() <= 1.0 => 0.0,
            _ => 1.0,
        };
        let mesh = self.mesh_stiffness(time) * slope;
        let damping = 2.0 * p.zeta;
        let mut rows = [[0.0; 6]; 6];
        for i in 0..3 {
            rows[i][i + 3] = 1.0;
        }
        let support = |k: f64, alpha: f64, u: f64| k + 3.0 * alpha * u * u;
        rows[3] = [
            -support(p.k_p, p.alpha_p, state[0]) / p.m_p,
            0.0,
            -mesh / p.m_p,
            -2.0 * p.zeta_p / p.m_p,
            0.0,
            -damping / p.m_p,
        ];
        rows[4] = [
            0.0,
            -support(p.k_g, p.alpha_g, state[1]) / p.m_g,
            mesh / p.m_g,
            0.0,
            -2.0 * p.zeta_g / p.m_g,
            damping / p.m_g,
        ];
        for column in 0..6 {
            rows[5][column] = rows[3][column] - rows[4][column];
        }
        rows[5][2] -= mesh;
        rows[5][5] -= damping;
        rows
    }

    /// The Jacobian's trace, the same everywhere: the rate of Liouville's identity.
    pub fn trace(&self) -> f64 {
        let p = &self.parameters;
        -2.0 * (p.zeta_p + p.zeta) / p.m_p - 2.0 * (p.zeta_g + p.zeta) / p.m_g - 2.0 * p.zeta
    }

    /// Bounds of `|u_p|` and `|u_g|` beyond which the motion counts as escaped over the softening barrier:
    /// `10 max(1, sqrt(k / |alpha|))`; infinite without a cubic term.
    pub fn escape_bounds(&self) -> [f64; 2] {
        let p = &self.parameters;
        [(p.k_p, p.alpha_p), (p.k_g, p.alpha_g)].map(|(k, alpha)| 10.0 * (k / alpha.abs()).sqrt().max(1.0))
    }
}

/// Bound of `|u|` beyond which the motion counts as diverged.
pub const DIVERGED: f64 = 1e6;

impl Field<6> for GearPair {
    fn derivative(&self, time: f64, state: &[f64; 6]) -> [f64; 6] {
        let p = &self.parameters;
        let [u_p, u_g, u, v_p, v_g, w] = *state;
        let mesh = 2.0 * p.zeta * w + self.mesh_stiffness(time) * self.tooth_function(u);
        let a_p = (-2.0 * p.zeta_p * v_p - p.k_p * u_p - p.alpha_p * u_p * u_p * u_p - mesh) / p.m_p;
        let a_g = (-2.0 * p.zeta_g * v_g - p.k_g * u_g - p.alpha_g * u_g * u_g * u_g + mesh) / p.m_g;
        [v_p, v_g, w, a_p, a_g, a_p - a_g - mesh + self.load(time)]
    }
}

/// Adds the Taylor coefficients of `amplitude * cos(frequency * t)` about `time` to a series: those of even powers, and those of
/// odd ones, each from the one two before it.
pub fn add_cosine<const LEN: usize>(series: &mut [f64; LEN], amplitude: f64, frequency: f64, time: f64) {
    const { assert!(LEN >= 2 && LEN <= MOST) };
    let (sine, cosine) = sine_and_cosine(frequency * time);
    let (mut even, mut odd) = (amplitude * cosine, -amplitude * frequency * sine);
    series[0] += even;
    series[1] += odd;
    let square = -frequency * frequency;
    for (two, inverse) in series[2..].chunks_mut(2).zip(&INVERSE_PRODUCTS) {
        even *= square * inverse[0];
        odd *= square * inverse[1];
        two[0] += even;
        if let Some(second) = two.get_mut(1) {
            *second += odd;
        }
    }
}

/// `1 / (n (n - 1))` for n = 2 and 3, 4 and 5, and so on.
const INVERSE_PRODUCTS: [[f64; 2]; MOST / 2] = {
    let mut inverse = [[0.0; 2]; MOST / 2];
    let mut n = 2;
    while n / 2 <= MOST / 2 {
        inverse[n / 2 - 1][n % 2] = 1.0 / (n * (n - 1)) as f64;
        n += 1;
    }
    inverse
};

/// Everything in the recurrences that does not depend on the state: pulsation and load about a time.
pub(crate) struct Forcing<const LEN: usize> {
    /// Coefficients of `k0 cos(Omega t)`.
    pub pulsation: [f64; LEN],
    /// Coefficients of the load.
    pub load: [f64; LEN],
}

impl<const LEN: usize> Forcing<LEN> {
    pub(crate) fn new(p: &Parameters, time: f64) -> Self {
        let mut forcing = Self { pulsation: [0.0; LEN], load: [0.0; LEN] };
        add_cosine(&mut forcing.pulsation, p.k0, p.omega, time);
        forcing.load[0] = p.load;
        let error = p.omega * p.omega * p.error;
        for (amplitude, frequency) in [(p.load_p, p.omega_p), (p.load_g, p.omega_g), (error, p.omega)] {
            if amplitude != 0.0 {
                add_cosine(&mut forcing.load, amplitude, frequency, time);
            }
        }
        forcing
    }
}

/// The piece of the regime's tooth function that holds at a state and just after it.
pub(crate) fn contact(pair: &GearPair, time: f64, state: &[f64; 6]) -> Contact {
    match pair.parameters.regime {
        Regime::Homogeneous => Contact::Deviation,
        Regime::Contact => Contact::Permanent,
        Regime::Backlash => {
            let (u, velocity) = (state[U], state[U_DOT]);
            if u.abs() != 1.0 {
                return if u > 1.0 {
                    Contact::Driving
                } else if u < -1.0 {
                    Contact::Back
                } else {
                    Contact::Parted
                };
            }
            // On a boundary the motion's direction decides, and where it rests there, its acceleration: f is
            // zero on both sides, so that it is the same for both.
            let outwards = if velocity == 0.0 { pair.derivative(time, state)[U_DOT] } else { velocity } * u;
            match (outwards > 0.0, u > 0.0) {
                (true, true) => Contact::Driving,
                (true, false) => Contact::Back,
                (false, _) => Contact::Parted,
            }
        }
    }
}

/// The levels of `u` at which a piece ends.
pub(crate) fn contact_boundaries(piece: Contact) -> [Option<Boundary>; 2] {
    let at = |level| Some(Boundary { coordinate: U, level });
    match piece {
        Contact::Deviation | Contact::Permanent => [None, None],
        Contact::Driving => [at(1.0), None],
        Contact::Parted => [at(1.0), at(-1.0)],
        Contact::Back => [None, at(-1.0)],
    }
}

impl TaylorField<6> for GearPair {
    type Piece = Contact;

    fn piece(&self, time: f64, state: &[f64; 6]) -> Contact {
        contact(self, time, state)
    }

    fn boundaries(&self, piece: Contact) -> [Option<Boundary>; 2] {
        contact_boundaries(piece)
    }

    fn series<const LEN: usize>(
        &self,
        piece: Contact,
        time: f64,
        state: &[f64; 6],
        series: &mut Series<6, LEN>,
    ) {
        let forcing = Forcing::<LEN>::new(&self.parameters, time);
        series[0] = *state;
        Coefficients::new(&self.parameters, &forcing, piece.line()).fill(series);
    }
}
