//! The linear modes of the gear pair on equal supports, equations (32)-(50).
//!
//! With equal supports (24) one mode moves both bodies together and leaves the teeth alone; in the other two the
//! bodies move against each other and the teeth are compressed. Those two, called the second and the third, are
//! all that the mesh can excite.

use crate::error::{ModelError, TheoryError};
use crate::model::parameters::{self, Symmetric};

/// One of the two modes that compress the teeth.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// The slower one, shape `(-2, 2, a)`.
    Second,
    /// The faster one, shape `(-2, 2, b)`.
    Third,
}

impl Mode {
    /// Both, the slower one first.
    pub const BOTH: [Self; 2] = [Self::Second, Self::Third];

    /// The other of the two.
    #[must_use]
    pub fn partner(self) -> Self {
        match self {
            Self::Second => Self::Third,
            Self::Third => Self::Second,
        }
    }

    /// The paper's number of the mode, 2 or 3.
    pub fn number(self) -> usize {
        match self {
            Self::Second => 2,
            Self::Third => 3,
        }
    }
}

/// What the linear problem (32) is made of. All dimensionless and finite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Modes {
    /// Mass of each gear body, above 0.
    pub m: f64,
    /// Stiffness of each support, above 0.
    pub k: f64,
    /// Third entry of the second mode's shape (38), above 0.
    pub a: f64,
    /// Third entry of the third mode's shape (39), below 0.
    pub b: f64,
    /// Natural frequencies of the first, second and third mode, in radians per unit of dimensionless time. The
    /// paper's `omega_n` (44) is this over `Omega_0`.
    pub omega: [f64; 3],
}

impl Modes {
    /// The modes for this mass and stiffness of each support.
    ///
    /// The numbers are formed without subtracting nearly equal ones, so they are good to the last digits over the
    /// whole range of parameters, where (38), (39), (44) by the letter are not.
    ///
    /// # Errors
    /// [`TheoryError::Model`] where `m` or `k` is no number or outside the range of the parameter table.
    pub fn new(m: f64, k: f64) -> Result<Self, TheoryError> {
        within_range("m", m)?;
        within_range("k", k)?;
        let root = discriminant(m, k).sqrt();
        let offset = m - k + 2.0;
        let (a, b) = if offset >= 0.0 {
            let b = -offset - root;
            (-8.0 * k / b, b)
        } else {
            let a = root - offset;
            (a, -8.0 * k / a)
        };
        let sum = m + k + 2.0 + root;
        Ok(Self { m, k, a, b, omega: [(k / m).sqrt(), (2.0 * k / sum).sqrt(), (sum / (2.0 * m)).sqrt()] })
    }

    /// The modes for these parameters.
    ///
    /// # Errors
    /// As [`Modes::new`].
    pub fn of(symmetric: &Symmetric) -> Result<Self, TheoryError> {
        Self::new(symmetric.m, symmetric.k)
    }

    /// `c_2 = a`, `c_3 = b`: the third entry of the mode's shape.
    pub fn coefficient(&self, mode: Mode) -> f64 {
        match mode {
            Mode::Second => self.a,
            Mode::Third => self.b,
        }
    }

    /// Natural frequency of the mode, radians per unit of dimensionless time.
    pub fn frequency(&self, mode: Mode) -> f64 {
        self.omega[mode.number() - 1]
    }

    /// `sigma_j = (2 k - c_j) / (2 m)`, the square of [`Modes::frequency`].
    pub fn sigma(&self, mode: Mode) -> f64 {
        self.frequency(mode).powi(2)
    }

    /// `a - b`, above 0.
    pub fn spread(&self) -> f64 {
        self.a - self.b
    }

    /// `c_j (c_j - c_i)` with the partner `i`: the factor that turns the equations of sections 3.1 to 3.3 into
    /// rates. Above 0 for both modes.
    pub fn weight(&self, mode: Mode) -> f64 {
        self.coefficient(mode).abs() * self.spread()
    }

    /// The mode shapes (37): the columns `v_1`, `v_2`, `v_3` in the order `u_p, u_g, u`.
    pub fn shapes(&self) -> [[f64; 3]; 3] {
        [[1.0, 1.0, 0.0], [-2.0, 2.0, self.a], [-2.0, 2.0, self.b]]
    }

    /// Right vector `v_j = (-2, 2, c_j)` of (37).
    pub fn shape(&self, mode: Mode) -> [f64; 3] {
        [-2.0, 2.0, self.coefficient(mode)]
    }

    /// Left vector `l_j = (-2 sigma_j / c_j, 2 sigma_j / c_j, 1)`: it takes the mode's part out of a right-hand side
    /// of (32), since `l_j M v_j = c_j - c_i` and `l_j M v_i = 0` with the mass matrix `M` of (32).
    pub fn left_shape(&self, mode: Mode) -> [f64; 3] {
        let ratio = 2.0 * self.sigma(mode) / self.coefficient(mode);
        [-ratio, ratio, 1.0]
    }
}

fn within_range(name: &'static str, given: f64) -> Result<(), TheoryError> {
    let (low, high) =
        parameters::info(name).map_or((f64::MIN_POSITIVE, f64::MAX), |info| (info.low, info.high));
    if given.is_nan() {
        let given = given.to_string();
        return Err(TheoryError::Model(ModelError::NotANumber { parameter: name.into(), given, low, high }));
    }
    if given < low || given > high {
        return Err(TheoryError::Model(ModelError::OutOfRange { parameter: name.into(), given, low, high }));
    }
    Ok(())
}

/// The paper's own `alpha`, which is multiplied by its small parameter in (27): `alpha / k0`.
///
/// # Errors
/// [`TheoryError::Vanishing`] where `k0` is zero.
pub fn paper_alpha(symmetric: &Symmetric) -> Result<f64, TheoryError> {
    if symmetric.k0 == 0.0 {
        return Err(TheoryError::Vanishing { parameter: "k0", equation: "(27)" });
    }
    Ok(symmetric.alpha / symmetric.k0)
}

/// The paper's `Omega_1` of (31) to first order: `(Omega - Omega_0) / k0`.
///
/// # Errors
/// [`TheoryError::Vanishing`] where `k0` is zero.
pub fn paper_omega_1(symmetric: &Symmetric, omega_0: f64) -> Result<f64, TheoryError> {
    if symmetric.k0 == 0.0 {
        return Err(TheoryError::Vanishing { parameter: "k0", equation: "(31)" });
    }
    Ok((symmetric.omega - omega_0) / symmetric.k0)
}

/// The matrix of (32): masses. Rows are the equations, columns `u_p, u_g, u`.
pub fn mass_matrix(m: f64) -> [[f64; 3]; 3] {
    [[m, 0.0, 0.0], [0.0, m, 0.0], [-1.0, 1.0, 1.0]]
}

/// The matrix of (32): stiffnesses.
pub fn stiffness_matrix(k: f64) -> [[f64; 3]; 3] {
    [[k, 0.0, 1.0], [0.0, k, -1.0], [0.0, 0.0, 1.0]]
}

/// The matrix of (35) as printed: its entry (3,3) is `-Omega_0^2 lambda^2 + 1`, which makes it regular at (36).
pub fn characteristic_matrix_printed(m: f64, k: f64, omega_0: f64, lambda_squared: f64) -> [[f64; 3]; 3] {
    let inertia = omega_0 * omega_0 * lambda_squared;
    [[m * inertia + k, 0.0, 1.0], [0.0, m * inertia + k, -1.0], [-inertia, inertia, 1.0 - inertia]]
}

/// The matrix of (35), corrected: entry (3,3) is `+Omega_0^2 lambda^2 + 1`, as the mass matrix of (32) demands.
pub fn characteristic_matrix(m: f64, k: f64, omega_0: f64, lambda_squared: f64) -> [[f64; 3]; 3] {
    let mut matrix = characteristic_matrix_printed(m, k, omega_0, lambda_squared);
    matrix[2][2] = 1.0 + omega_0 * omega_0 * lambda_squared;
    matrix
}

/// The squares of the eigenvalues (36), all below 0: `-k/(m Omega_0^2)`, `-(2k - a)/(2 m Omega_0^2)`,
/// `-(2k - b)/(2 m Omega_0^2)`.
pub fn eigenvalue_squares(modes: &Modes, omega_0: f64) -> [f64; 3] {
    natural_frequencies_squared(modes, omega_0).map(|square| -square)
}

/// `a` by the letter of (38). [`Modes::new`] forms it with less rounding.
pub fn constant_a(m: f64, k: f64) -> f64 {
    -(m - k + 2.0) + ((m + k + 2.0).powi(2) - 4.0 * k * m).sqrt()
}

/// `b` by the letter of (39). [`Modes::new`] forms it with less rounding.
pub fn constant_b(m: f64, k: f64) -> f64 {
    -(m - k + 2.0) - ((m + k + 2.0).powi(2) - 4.0 * k * m).sqrt()
}

/// What (40) says of `a b`: `-8 k`.
pub fn product_a_b(k: f64) -> f64 {
    -8.0 * k
}

/// The scalar products `v_1.v_2`, `v_1.v_3`, `v_2.v_3` of (41): `0, 0, 8 (1 - k)`.
///
/// The paper's text takes a zero of the last for "no coupling". The coupling through the varying mesh stiffness
/// stays: [`half_width`](super::combination::half_width) at `k = 1` is not zero.
pub fn shape_products(k: f64) -> [f64; 3] {
    [0.0, 0.0, 8.0 * (1.0 - k)]
}

/// The left side of (42), `(m + k + 2)^2 - 4 k m`, formed as `(m - k)^2 + 4 (m + k + 1)`: above 0 for all `m, k > 0`.
pub fn discriminant(m: f64, k: f64) -> f64 {
    (m - k).powi(2) + 4.0 * (m + k + 1.0)
}

/// `2 k - a` and `2 k - b` by the letter of (43), both above 0.
pub fn twice_k_minus(m: f64, k: f64) -> [f64; 2] {
    let root = ((m + k + 2.0).powi(2) - 4.0 * k * m).sqrt();
    [m + k + 2.0 - root, m + k + 2.0 + root]
}

/// The squares `omega_n1^2, omega_n2^2, omega_n3^2` of (44), frequencies over `omega_0`.
pub fn natural_frequencies_squared(modes: &Modes, omega_0: f64) -> [f64; 3] {
    modes.omega.map(|omega| (omega / omega_0).powi(2))
}

/// The right side of (45): `omega_n2^2 omega_n3^2 = k / (m Omega_0^4)`.
pub fn frequency_product(modes: &Modes, omega_0: f64) -> f64 {
    modes.k / (modes.m * omega_0.powi(4))
}

/// The right side of (46): `omega_n1^2 = Omega_0^2 omega_n2^2 omega_n3^2`.
pub fn first_frequency_squared(modes: &Modes, omega_0: f64) -> f64 {
    let [_, second, third] = natural_frequencies_squared(modes, omega_0);
    omega_0 * omega_0 * second * third
}

/// The amplitudes of (47): cosine and sine part of each mode.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Amplitudes {
    /// `A_1, A_2` of the first mode.
    pub a: [f64; 2],
    /// `B_1, B_2` of the second mode.
    pub b: [f64; 2],
    /// `C_1, C_2` of the third mode.
    pub c: [f64; 2],
}

impl Amplitudes {
    /// The abbreviations `X^2, Y^2, Z^2` of (50).
    pub fn squares(&self) -> [f64; 3] {
        let [a, b, c] = [self.a, self.b, self.c].map(|pair| pair[0] * pair[0] + pair[1] * pair[1]);
        [a + 8.0 * b + 8.0 * c, a + 2.0 * b + 4.0 * c, a + 4.0 * b + 2.0 * c]
    }
}

/// The solution (47) of (32) at `tau`: `u_0p, u_0g, u_0`; `omega_n` are the frequencies (44).
pub fn zeroth_order(modes: &Modes, omega_n: [f64; 3], amplitudes: &Amplitudes, tau: f64) -> [f64; 3] {
    let motions = [amplitudes.a, amplitudes.b, amplitudes.c];
    let mut state = [0.0; 3];
    for ((shape, omega), [cosine, sine]) in modes.shapes().into_iter().zip(omega_n).zip(motions) {
        let motion = cosine * (omega * tau).cos() + sine * (omega * tau).sin();
        for (entry, part) in state.iter_mut().zip(shape) {
            *entry += part * motion;
        }
    }
    state
}

/// What stands still in the perturbation equation (33): frequencies and the paper's `alpha`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Expansion {
    /// `Omega_0` of (31).
    pub omega_0: f64,
    /// `Omega_1` of (31).
    pub omega_1: f64,
    /// The paper's `alpha`, see [`paper_alpha`].
    pub alpha: f64,
}

/// The right side of (33), corrected: the cubes are those of the zeroth order, not of the whole solution.
///
/// `u_0` and its second derivative by `tau` are given in the order `u_0p, u_0g, u_0`.
pub fn first_order_forcing(
    modes: &Modes,
    expansion: &Expansion,
    u_0: [f64; 3],
    u_0_second: [f64; 3],
    tau: f64,
) -> [f64; 3] {
    let Expansion { omega_0, omega_1, alpha } = *expansion;
    let mass = mass_matrix(modes.m);
    let mesh = u_0[2] * tau.cos();
    let direct = [-mesh - alpha * u_0[0].powi(3), mesh - alpha * u_0[1].powi(3), -mesh];
    std::array::from_fn(|row| {
        let inertia: f64 = mass[row].iter().zip(u_0_second).map(|(entry, second)| entry * second).sum();
        direct[row] - 2.0 * omega_0 * omega_1 * inertia
    })
}

/// The two matrices of (48) that hold what is resonant at any mesh frequency: the first belongs to
/// `cos(omega_nj tau)`, one column a mode, the second with a minus sign to `sin(omega_nj tau)`.
pub fn resonant_terms(
    modes: &Modes,
    expansion: &Expansion,
    omega_n: [f64; 3],
    amplitudes: &Amplitudes,
) -> [[[f64; 3]; 3]; 2] {
    let Expansion { omega_0, omega_1, alpha } = *expansion;
    let shift = omega_n.map(|omega| 2.0 * omega_0 * omega_1 * omega * omega);
    let [x, y, z] = amplitudes.squares();
    let first = modes.m * shift[0] - 0.75 * alpha * x;
    let second = -2.0 * modes.m * shift[1] + 3.0 * alpha * y;
    let third = -2.0 * modes.m * shift[2] + 3.0 * alpha * z;
    let torsion = [(modes.a + 4.0) * shift[1], (modes.b + 4.0) * shift[2]];
    let of = |part: usize, sign: f64| {
        let (a, b, c) = (sign * amplitudes.a[part], sign * amplitudes.b[part], sign * amplitudes.c[part]);
        [
            [first * a, second * b, third * c],
            [first * a, -second * b, -third * c],
            [0.0, torsion[0] * b, torsion[1] * c],
        ]
    };
    [of(0, 1.0), of(1, -1.0)]
}

/// The frequencies (49) found on the right side of (48): the three natural ones and those shifted by the mesh,
/// `omega_n2 -+ 1`, `omega_n3 -+ 1`.
pub fn forcing_frequencies(omega_n: [f64; 3]) -> [f64; 7] {
    let [first, second, third] = omega_n;
    [first, second, third, second - 1.0, second + 1.0, third - 1.0, third + 1.0]
}
