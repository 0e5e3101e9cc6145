//! The combination tongue at the sum of the second and third natural frequency, equations (101)-(113).
//!
//! As in [`primary`](super::primary), `alpha` is the paper's and `omega_1` its `Omega_1`; `x = [B_1, B_2, C_1, C_2]`.
//! The paper treats its four equations as a flow without giving each mode its own rate; what is printed and what
//! averaging gives stand side by side.

use nalgebra::Complex;

use super::modes::{Amplitudes, Expansion, Mode, Modes, resonant_terms};
use super::roots::real_roots;
use crate::error::TheoryError;

/// Mesh frequency `Omega_0` from which the tongue starts, (102) by way of (101): `omega_2 + omega_3`.
pub fn emanating_frequency(modes: &Modes) -> f64 {
    modes.omega[1] + modes.omega[2]
}

fn secular(modes: &Modes, alpha: f64, omega_1: f64, amplitudes: &Amplitudes, part: usize) -> [[f64; 3]; 3] {
    let omega_0 = emanating_frequency(modes);
    let omega_n = modes.omega.map(|omega| omega / omega_0);
    let expansion = Expansion { omega_0, omega_1, alpha };
    let mut matrix = resonant_terms(modes, &expansion, omega_n, amplitudes)[part];
    let mesh = [0.5 * modes.b * amplitudes.c[part], 0.5 * modes.a * amplitudes.b[part]];
    for (row, sign) in matrix.iter_mut().zip([-1.0, 1.0, -1.0]) {
        row[1] += sign * mesh[0];
        row[2] += sign * mesh[1];
    }
    matrix
}

/// The secular terms that go with the cosines (103): one column a mode.
pub fn secular_cosine(modes: &Modes, alpha: f64, omega_1: f64, amplitudes: &Amplitudes) -> [[f64; 3]; 3] {
    secular(modes, alpha, omega_1, amplitudes, 0)
}

/// The secular terms that go with the sines, with the minus sign of (48): (104).
pub fn secular_sine(modes: &Modes, alpha: f64, omega_1: f64, amplitudes: &Amplitudes) -> [[f64; 3]; 3] {
    secular(modes, alpha, omega_1, amplitudes, 1)
}

/// Half-width per `k0` as printed, (105): `4 k Omega_0 / (a - b)^2`. It is not that of the tongue, see [`half_width`].
pub fn half_width_printed(modes: &Modes) -> f64 {
    4.0 * modes.k * emanating_frequency(modes) / modes.spread().powi(2)
}

/// Half-width per `k0`, `sqrt(W_2 W_3) = sqrt(2 k) (k/m)^(1/4) / (a - b)`: what (105) should be. \[T4\].
pub fn half_width(modes: &Modes) -> f64 {
    (2.0 * modes.k).sqrt() * (modes.k / modes.m).powf(0.25) / modes.spread()
}

/// The couplings `H_2 = |b| omega_2 / (4 (a - b))`, `H_3 = a omega_3 / (4 (a - b))` of \[T8\], by which each mode drives
/// the other, per `k0`.
pub fn couplings(modes: &Modes) -> [f64; 2] {
    Mode::BOTH
        .map(|mode| modes.coefficient(mode.partner()).abs() * modes.frequency(mode) / (4.0 * modes.spread()))
}

/// `g_2 = 48 alpha omega_2 / (a (a - b))`, `g_3 = -48 alpha omega_3 / (b (a - b))` of \[T8\]: how much each mode's
/// frequency rises with the square of its amplitude. Here `alpha` is the model's own, not the paper's.
pub fn frequency_shifts(modes: &Modes, alpha: f64) -> [f64; 2] {
    Mode::BOTH.map(|mode| 48.0 * alpha * modes.frequency(mode) / modes.weight(mode))
}

/// `2 omega_j / (c_j (c_j - c_i))` for the two modes: what each pair of rows of (106)-(109) must be multiplied by to
/// be a time derivative per `k0`.
pub fn rates(modes: &Modes) -> [f64; 2] {
    Mode::BOTH.map(|mode| 2.0 * modes.frequency(mode) / modes.weight(mode))
}

/// The two brackets of (106)-(109) without their sign: `P` of the second mode, `Q` of the third.
fn brackets(modes: &Modes, alpha: f64, omega_1: f64, x: [f64; 4]) -> [f64; 2] {
    let detuning = modes.spread() * omega_1 / (2.0 * emanating_frequency(modes));
    let (second, third) = (x[0] * x[0] + x[1] * x[1], x[2] * x[2] + x[3] * x[3]);
    [
        6.0 * alpha * (second + 2.0 * third) - modes.a * detuning,
        6.0 * alpha * (2.0 * second + third) + modes.b * detuning,
    ]
}

/// The left sides of (106)-(109), in this order, as printed.
pub fn slow_flow_printed(modes: &Modes, alpha: f64, omega_1: f64, x: [f64; 4]) -> [f64; 4] {
    let [second, third] = brackets(modes, alpha, omega_1, x);
    let k = modes.k;
    [second * x[1] + k * x[3], -second * x[0] + k * x[2], third * x[3] + k * x[1], -third * x[2] + k * x[0]]
}

/// (106)-(109) as a flow, corrected: each pair times its own [rate](rates); time derivatives of `x` per `k0`. The
/// modes turn at `omega_j Omega / Omega_0` here; only the sum of the two is fixed by the mesh, so a cycle of this
/// flow need not be an equilibrium of it.
pub fn slow_flow(modes: &Modes, alpha: f64, omega_1: f64, x: [f64; 4]) -> [f64; 4] {
    let [second, third] = rates(modes);
    let [b_1, b_2, c_1, c_2] = slow_flow_printed(modes, alpha, omega_1, x);
    [second * b_1, second * b_2, third * c_1, third * c_2]
}

/// The Jacobian matrix of (106)-(109) at any `x`, as printed.
pub fn jacobian_printed(modes: &Modes, alpha: f64, omega_1: f64, x: [f64; 4]) -> [[f64; 4]; 4] {
    let [second, third] = brackets(modes, alpha, omega_1, x);
    let k = modes.k;
    let by =
        |own: f64, other: f64, place: usize| 12.0 * alpha * if place < 2 { own } else { other } * x[place];
    let mut jacobian = [[0.0; 4]; 4];
    for place in 0..4 {
        let (of_second, of_third) = (by(1.0, 2.0, place), by(2.0, 1.0, place));
        jacobian[0][place] = of_second * x[1];
        jacobian[1][place] = -of_second * x[0];
        jacobian[2][place] = of_third * x[3];
        jacobian[3][place] = -of_third * x[2];
    }
    jacobian[0][1] += second;
    jacobian[0][3] += k;
    jacobian[1][0] -= second;
    jacobian[1][2] += k;
    jacobian[2][3] += third;
    jacobian[2][1] += k;
    jacobian[3][2] -= third;
    jacobian[3][0] += k;
    jacobian
}

/// The Jacobian matrix at the origin as printed, (110).
pub fn origin_jacobian_printed(modes: &Modes, omega_1: f64) -> [[f64; 4]; 4] {
    let detuning = modes.spread() * omega_1 / (2.0 * emanating_frequency(modes));
    let (p, q, k) = (modes.a * detuning, modes.b * detuning, modes.k);
    [[0.0, -p, 0.0, k], [p, 0.0, k, 0.0], [0.0, k, 0.0, q], [k, 0.0, -q, 0.0]]
}

/// (110) with its rows multiplied by their [`rates`]: growth rates per `k0` are the eigenvalues of this.
pub fn origin_jacobian(modes: &Modes, omega_1: f64) -> [[f64; 4]; 4] {
    let [second, third] = rates(modes);
    let mut jacobian = origin_jacobian_printed(modes, omega_1);
    for (row, rate) in jacobian.iter_mut().zip([second, second, third, third]) {
        for entry in row {
            *entry *= rate;
        }
    }
    jacobian
}

/// The two brackets of (111) and (112): the first with the given sum or difference of squares, and that with `a b`.
fn terms(modes: &Modes, omega_1: f64, squares: f64) -> [f64; 2] {
    let coupling = (2.0 * modes.k * emanating_frequency(modes) / modes.spread()).powi(2);
    let detuning = omega_1 * omega_1;
    [coupling - 0.5 * squares * detuning, coupling + modes.a * modes.b * detuning]
}

fn formula_111(modes: &Modes, omega_1: f64, squares: f64) -> [Complex<f64>; 4] {
    let [first, second] = terms(modes, omega_1, squares);
    let inner = Complex::new(first * first - second * second, 0.0).sqrt();
    let scale = modes.spread() / (2.0 * emanating_frequency(modes));
    let [plus, minus] = [inner, -inner].map(|inner| (inner + first).sqrt() * scale);
    [plus, minus, -minus, -plus]
}

/// The right side of (111) by the letter, with `(a^2 - b^2)/2`. The paper calls these `lambda^2`; it uses them as
/// `lambda`, and neither is right, see [`eigenvalues_111`].
pub fn eigenvalues_printed(modes: &Modes, omega_1: f64) -> [Complex<f64>; 4] {
    formula_111(modes, omega_1, modes.a * modes.a - modes.b * modes.b)
}

/// The eigenvalues of (110): (111) with `lambda` for `lambda^2` and `(a^2 + b^2)/2` for `(a^2 - b^2)/2`. They are the
/// printed matrix's, not growth rates; those are [`growth_rates`].
pub fn eigenvalues_111(modes: &Modes, omega_1: f64) -> [Complex<f64>; 4] {
    formula_111(modes, omega_1, modes.a * modes.a + modes.b * modes.b)
}

/// The eigenvalues of [`origin_jacobian`], the slow flow rightly scaled: growth rates in time per `k0`, undamped.
///
/// `lambda = (+-sqrt(4 H_2 H_3 - Omega_1^2) -+ i Omega_1 (omega_2 - omega_3)/Omega_0) / 2`; to first order the
/// Floquet exponents are `k0 lambda` plus `i omega_j Omega / Omega_0` with the frequency of either mode.
pub fn growth_rates(modes: &Modes, omega_1: f64) -> [Complex<f64>; 4] {
    let width = half_width(modes);
    let turn = omega_1 * (modes.omega[1] - modes.omega[2]) / (2.0 * emanating_frequency(modes));
    let root = Complex::new(0.25 * (width * width - omega_1 * omega_1), 0.0).sqrt();
    let turn = Complex::new(0.0, turn);
    [root - turn, -root - turn, root.conj() + turn, -root.conj() + turn]
}

/// The condition (112) as printed, with `(a^2 - b^2)/2`: the paper's "the origin is a centre".
pub fn is_centre_printed(modes: &Modes, omega_1: f64) -> bool {
    let [first, second] = terms(modes, omega_1, modes.a * modes.a - modes.b * modes.b);
    first * first - second * second > 0.0
}

/// The condition (112) with `(a^2 + b^2)/2`: all eigenvalues of (110) are imaginary; just outside of (105).
pub fn is_centre_112(modes: &Modes, omega_1: f64) -> bool {
    let [first, second] = terms(modes, omega_1, modes.a * modes.a + modes.b * modes.b);
    first * first - second * second > 0.0
}

/// The condition (113) as printed: the origin is an unstable spiral. At `omega_1 = 0` itself it is none, the
/// imaginary part is zero there.
pub fn is_spiral_printed(modes: &Modes, omega_1: f64) -> bool {
    omega_1.abs() < half_width_printed(modes)
}

/// Whether the origin is unstable, undamped and to first order: (113) with the right half-width \[T4\].
pub fn is_unstable(modes: &Modes, omega_1: f64) -> bool {
    omega_1.abs() < half_width(modes)
}

/// `Omega_1` at which the nontrivial solutions of (106)-(109) leave the origin: minus and plus
/// `Omega_0 sqrt(k/2) / (a - b)`, neither (105) nor the true edge.
pub fn printed_solutions_edge(modes: &Modes) -> f64 {
    emanating_frequency(modes) * (0.5 * modes.k).sqrt() / modes.spread()
}

/// A nontrivial solution of (106)-(109) as printed: a circle of equilibria.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PrintedSolution {
    /// `sqrt(B_1^2 + B_2^2)`.
    pub radius_b: f64,
    /// `sqrt(C_1^2 + C_2^2)`.
    pub radius_c: f64,
    /// `z` in `C_1 = z B_1`, `C_2 = -z B_2`.
    pub ratio: f64,
    /// Whether no eigenvalue of the printed Jacobian there has a positive real part.
    pub stable: bool,
}

/// All nontrivial solutions of (106)-(109) as printed, which the paper says are none, at most four.
///
/// With `C_1 = z B_1`, `C_2 = -z B_2` the four equations become two, `P = k z` and `Q = k/z`; without the amplitude
/// `z^4 + (a + 2b) s z^3 + (2a + b) s z - 1 = 0` is left, `s = (a - b) Omega_1 / (2 Omega_0 k)`.
///
/// # Errors
/// [`TheoryError::Vanishing`] where `alpha` is zero.
pub fn printed_solutions(
    modes: &Modes,
    alpha: f64,
    omega_1: f64,
) -> Result<Vec<PrintedSolution>, TheoryError> {
    if alpha == 0.0 {
        return Err(TheoryError::Vanishing { parameter: "alpha", equation: "(106)-(109)" });
    }
    let (a, b, k) = (modes.a, modes.b, modes.k);
    let s = modes.spread() * omega_1 / (2.0 * emanating_frequency(modes) * k);
    let roots = real_roots(&[-1.0, (2.0 * a + b) * s, 0.0, (a + 2.0 * b) * s, 1.0]);
    Ok(roots
        .into_iter()
        .filter_map(|z| {
            let square = k * (z + a * s) / (6.0 * alpha * (1.0 + 2.0 * z * z));
            // With B_2 = C_2 = 0 the Jacobian couples only cosines with sines; of its squared eigenvalues one is
            // zero, along the circle, and this with the sign turned is the other.
            let squared_frequency = k * k * (z - 1.0 / z).powi(2) + 72.0 * alpha * k * z * square;
            (square > 0.0).then(|| {
                let radius_b = square.sqrt();
                PrintedSolution {
                    radius_b,
                    radius_c: z.abs() * radius_b,
                    ratio: z,
                    stable: squared_frequency > 0.0,
                }
            })
        })
        .collect())
}
