//! The primary tongues at twice the second and twice the third natural frequency, equations (51)-(100).
//!
//! Sections 3.1 and 3.2 of the paper say the same of two modes; each function here holds both, with the number of
//! section 3.1 for [`Mode::Second`] and that of section 3.2 for [`Mode::Third`]. Throughout, `alpha` is the paper's
//! ([`paper_alpha`](super::modes::paper_alpha)), `omega_1` its `Omega_1`, and `x = [x_1, x_2]` are `B_1, B_2` or
//! `C_1, C_2`, the cosine and the sine amplitude of the mode at half the mesh frequency.

use super::modes::{Amplitudes, Expansion, Mode, Modes, resonant_terms};
use crate::error::TheoryError;

/// The equilibria of the slow flow by their angle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Branch {
    /// `R_1`: the origin.
    Origin,
    /// `R_2,3`: sine, the angle is pi/2 or 3 pi/2; it leaves the origin at the left edge.
    Sine,
    /// `R_4,5`: cosine, the angle is 0 or pi; it leaves the origin at the right edge.
    Cosine,
}

/// Mesh frequency `Omega_0` from which the tongue starts, (52) or (78) by way of (51) or (77): twice the mode's own.
pub fn emanating_frequency(modes: &Modes, mode: Mode) -> f64 {
    2.0 * modes.frequency(mode)
}

/// The squares of the three natural frequencies over `Omega_0` at the tongue, (53) or (79).
pub fn natural_frequencies_squared(modes: &Modes, mode: Mode) -> [f64; 3] {
    let stiffness = 2.0 * modes.k - modes.coefficient(mode);
    let first = modes.k / (2.0 * stiffness);
    let partner = modes.k * modes.m / (stiffness * stiffness);
    match mode {
        Mode::Second => [first, 0.25, partner],
        Mode::Third => [first, partner, 0.25],
    }
}

fn secular(
    modes: &Modes,
    mode: Mode,
    alpha: f64,
    omega_1: f64,
    amplitudes: &Amplitudes,
    part: usize,
) -> [[f64; 3]; 3] {
    let expansion = Expansion { omega_0: emanating_frequency(modes, mode), omega_1, alpha };
    let omega_n = natural_frequencies_squared(modes, mode).map(f64::sqrt);
    let mut matrix = resonant_terms(modes, &expansion, omega_n, amplitudes)[part];
    let (column, amplitude) = match mode {
        Mode::Second => (1, amplitudes.b[part]),
        Mode::Third => (2, amplitudes.c[part]),
    };
    let mesh = 0.5 * modes.coefficient(mode) * amplitude;
    for (row, sign) in matrix.iter_mut().zip([-1.0, 1.0, -1.0]) {
        row[column] += sign * mesh;
    }
    matrix
}

/// The secular terms that go with the cosines, (54) or (80): one column a mode.
pub fn secular_cosine(
    modes: &Modes,
    mode: Mode,
    alpha: f64,
    omega_1: f64,
    amplitudes: &Amplitudes,
) -> [[f64; 3]; 3] {
    secular(modes, mode, alpha, omega_1, amplitudes, 0)
}

/// The secular terms that go with the sines, with the minus sign of (48): (55) or (81).
pub fn secular_sine(
    modes: &Modes,
    mode: Mode,
    alpha: f64,
    omega_1: f64,
    amplitudes: &Amplitudes,
) -> [[f64; 3]; 3] {
    secular(modes, mode, alpha, omega_1, amplitudes, 1)
}

/// Half-width of the tongue per `k0`, by the letter of (56) or (82); the edges are at minus and plus this. It is
/// right, see [`half_width`].
pub fn half_width_printed(modes: &Modes, mode: Mode) -> f64 {
    let (own, partner) = (modes.coefficient(mode), modes.coefficient(mode.partner()));
    let omega_0 = emanating_frequency(modes, mode);
    own * (partner + 2.0 * modes.m + 4.0) / (2.0 * modes.m * omega_0 * (own - partner))
}

/// Half-width per `k0`, `W_j = |c_j| omega_j / (2 (a - b))`: what (56) and (82) come to, without cancellation. \[T3\].
pub fn half_width(modes: &Modes, mode: Mode) -> f64 {
    modes.coefficient(mode).abs() * modes.frequency(mode) / (2.0 * modes.spread())
}

/// The three determinants of (57): the matrix of (35) with its first, second or third column replaced. All are zero
/// if and only if the column can be balanced by the matrix. Give it the
/// [corrected](super::modes::characteristic_matrix) or the [printed](super::modes::characteristic_matrix_printed) one.
pub fn solvability(matrix: [[f64; 3]; 3], column: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|place| {
        let mut replaced = matrix;
        for (row, entry) in replaced.iter_mut().zip(column) {
            row[place] = entry;
        }
        determinant_3(replaced)
    })
}

pub(super) fn determinant_3(m: [[f64; 3]; 3]) -> f64 {
    m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
        + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0])
}

/// `c_j (c_j - c_i) / (2 Omega_0)`, the factor of all equations of these sections.
fn factor(modes: &Modes, mode: Mode) -> f64 {
    modes.weight(mode) / (2.0 * emanating_frequency(modes, mode))
}

/// The left sides of the slow flow, (58), (59) or (83), (84), in this order; both zero at an equilibrium.
/// Times [`rate`] and `k0` they are the time derivatives of `x_1, x_2`.
pub fn slow_flow(modes: &Modes, mode: Mode, alpha: f64, omega_1: f64, x: [f64; 2]) -> [f64; 2] {
    let (factor, width) = (factor(modes, mode), half_width(modes, mode));
    let cubic = 6.0 * alpha * (x[0] * x[0] + x[1] * x[1]);
    [(cubic - factor * (omega_1 + width)) * x[1], (-cubic + factor * (omega_1 - width)) * x[0]]
}

/// The same in polar coordinates, (60), (61) or (85), (86): `x = radius (cos angle, sin angle)`.
pub fn slow_flow_polar(
    modes: &Modes,
    mode: Mode,
    alpha: f64,
    omega_1: f64,
    radius: f64,
    angle: f64,
) -> [f64; 2] {
    slow_flow(modes, mode, alpha, omega_1, [radius * angle.cos(), radius * angle.sin()])
}

/// `Omega_0 / (c_j (c_j - c_i))`: what makes [`slow_flow`] a time derivative per `k0`, by averaging.
pub fn rate(modes: &Modes, mode: Mode) -> f64 {
    emanating_frequency(modes, mode) / modes.weight(mode)
}

/// Square of the radius at an equilibrium, (62)-(64) or (87)-(89); below 0 where the branch does not exist.
///
/// # Errors
/// [`TheoryError::Vanishing`] where `alpha` is zero and the branch is not the origin.
pub fn radius_squared(
    modes: &Modes,
    mode: Mode,
    branch: Branch,
    alpha: f64,
    omega_1: f64,
) -> Result<f64, TheoryError> {
    let edge = match branch {
        Branch::Origin => return Ok(0.0),
        Branch::Sine => -half_width(modes, mode),
        Branch::Cosine => half_width(modes, mode),
    };
    if alpha == 0.0 {
        let equation = match (mode, branch) {
            (Mode::Second, Branch::Sine) => "(63)",
            (Mode::Second, _) => "(64)",
            (Mode::Third, Branch::Sine) => "(88)",
            (Mode::Third, _) => "(89)",
        };
        return Err(TheoryError::Vanishing { parameter: "alpha", equation });
    }
    Ok(factor(modes, mode) / (6.0 * alpha) * (omega_1 - edge))
}

fn jacobian_with(
    modes: &Modes,
    mode: Mode,
    alpha: f64,
    omega_1: f64,
    x: [f64; 2],
    width: f64,
) -> [[f64; 2]; 2] {
    let factor = factor(modes, mode);
    let (first, second) = (x[0] * x[0], x[1] * x[1]);
    let mixed = 12.0 * alpha * x[0] * x[1];
    [
        [mixed, 6.0 * alpha * (first + 3.0 * second) - factor * (omega_1 + width)],
        [-6.0 * alpha * (3.0 * first + second) + factor * (omega_1 - width), -mixed],
    ]
}

/// The Jacobian matrix as printed, (65) or (90): in (90) the half-width has the wrong sign.
pub fn jacobian_printed(modes: &Modes, mode: Mode, alpha: f64, omega_1: f64, x: [f64; 2]) -> [[f64; 2]; 2] {
    jacobian_with(modes, mode, alpha, omega_1, x, printed_width(modes, mode))
}

/// The Jacobian matrix of [`slow_flow`], (65) or (90) corrected.
pub fn jacobian(modes: &Modes, mode: Mode, alpha: f64, omega_1: f64, x: [f64; 2]) -> [[f64; 2]; 2] {
    jacobian_with(modes, mode, alpha, omega_1, x, half_width(modes, mode))
}

/// The half-width as it stands in (65), (67) and, with the sign turned, in (90), (91).
fn printed_width(modes: &Modes, mode: Mode) -> f64 {
    match mode {
        Mode::Second => half_width(modes, mode),
        Mode::Third => -half_width(modes, mode),
    }
}

/// The left side of (66): the characteristic polynomial of a 2 x 2 matrix from its trace and determinant.
pub fn characteristic_polynomial(trace: f64, determinant: f64, lambda: f64) -> f64 {
    lambda * lambda - trace * lambda + determinant
}

fn determinant_with(modes: &Modes, mode: Mode, alpha: f64, omega_1: f64, x: [f64; 2], width: f64) -> f64 {
    let factor = factor(modes, mode);
    let (first, second) = (x[0] * x[0], x[1] * x[1]);
    108.0 * alpha * alpha * (first + second).powi(2)
        - 6.0 * alpha * factor * (4.0 * omega_1 * (first + second) + 2.0 * width * (first - second))
        + factor * factor * (omega_1 * omega_1 - width * width)
}

/// The determinant of the Jacobian as printed, (67) or (91): in (91) the half-width has the wrong sign.
pub fn determinant_printed(modes: &Modes, mode: Mode, alpha: f64, omega_1: f64, x: [f64; 2]) -> f64 {
    determinant_with(modes, mode, alpha, omega_1, x, printed_width(modes, mode))
}

/// The determinant of [`jacobian`], (67) or (91) corrected.
pub fn determinant(modes: &Modes, mode: Mode, alpha: f64, omega_1: f64, x: [f64; 2]) -> f64 {
    determinant_with(modes, mode, alpha, omega_1, x, half_width(modes, mode))
}

/// The determinant at an equilibrium, (68)-(70) or (92)-(94); it does not depend on `alpha`. Above 0 a centre, below
/// 0 a saddle. Where it is zero a branch is born.
pub fn determinant_at(modes: &Modes, mode: Mode, branch: Branch, omega_1: f64) -> f64 {
    let (factor, width) = (factor(modes, mode), half_width(modes, mode));
    match branch {
        Branch::Origin => factor * factor * (omega_1 * omega_1 - width * width),
        Branch::Sine => 4.0 * factor * factor * width * (omega_1 + width),
        Branch::Cosine => -4.0 * factor * factor * width * (omega_1 - width),
    }
}

/// Whether the equilibrium exists, (71)-(76) or (95)-(100): for hardening (`alpha > 0`) to the right of the edge
/// where it is born, for softening (`alpha < 0`) to the left of it; for `alpha = 0` only the origin.
pub fn exists(modes: &Modes, mode: Mode, branch: Branch, alpha: f64, omega_1: f64) -> bool {
    let edge = match branch {
        Branch::Origin => return true,
        Branch::Sine => -half_width(modes, mode),
        Branch::Cosine => half_width(modes, mode),
    };
    if alpha > 0.0 { omega_1 > edge } else { alpha < 0.0 && omega_1 < edge }
}
