//! What the theory's tests share beyond `common`: generated supports, small linear algebra.

#![allow(dead_code, reason = "each test file uses its own part")]

use crate::common::Generator;
use gear_bifurcations::model::parameters::Symmetric;
use nalgebra::{Complex, DMatrix, Schur};

pub fn assert_close(what: &str, value: f64, expected: f64, tolerance: f64) {
    assert!(
        (value - expected).abs() <= tolerance,
        "{what}: {value} is not {expected} within {tolerance} (off by {:e})",
        value - expected
    );
}

/// `zeta_s = zeta`, as the paper's figures have it.
pub fn symmetric(m: f64, k: f64, alpha: f64, zeta: f64, k0: f64, omega: f64) -> Symmetric {
    Symmetric { m, k, alpha, zeta, zeta_s: zeta, k0, omega }
}

/// Pairs `(m, k)`: m from 0.2 to 10, k from 0.2 to 50, even in the logarithm.
pub fn generated(count: usize) -> Vec<(f64, f64)> {
    let mut generator = Generator(7);
    (0..count)
        .map(|_| (0.2 * 50.0_f64.powf(generator.unit()), 0.2 * 250.0_f64.powf(generator.unit())))
        .collect()
}

pub fn times(matrix: [[f64; 3]; 3], vector: [f64; 3]) -> [f64; 3] {
    matrix.map(|row| row.iter().zip(vector).map(|(one, other)| one * other).sum())
}

pub fn determinant<const N: usize>(matrix: [[f64; N]; N]) -> f64 {
    DMatrix::from_fn(N, N, |row, column| matrix[row][column]).determinant()
}

/// Eigenvalues by QR. The matrices here have so much structure that plain shifts can run in circles: a change to
/// generic coordinates takes it away.
pub fn eigenvalues<const N: usize>(matrix: [[f64; N]; N]) -> Vec<Complex<f64>> {
    let mut generator = Generator(11);
    let generic =
        DMatrix::from_fn(N, N, |row, column| if row == column { 1.5 } else { 0.5 * generator.unit() - 0.25 });
    let inverse = generic.clone().try_inverse().expect("diagonally dominant");
    let plain = DMatrix::from_fn(N, N, |row, column| matrix[row][column]);
    let schur = Schur::try_new(generic * plain * inverse, 1e-13, 10_000).expect("converges");
    schur.complex_eigenvalues().iter().copied().collect()
}

/// Central differences of the fourth order.
pub fn numerical_jacobian<const N: usize>(flow: impl Fn([f64; N]) -> [f64; N], x: [f64; N]) -> [[f64; N]; N] {
    let h = 1e-3;
    let mut jacobian = [[0.0; N]; N];
    for column in 0..N {
        let at = |steps: f64| {
            let mut moved = x;
            moved[column] += steps * h;
            flow(moved)
        };
        let [far_left, left, right, far_right] = [-2.0, -1.0, 1.0, 2.0].map(at);
        for row in 0..N {
            jacobian[row][column] =
                (far_left[row] - 8.0 * left[row] + 8.0 * right[row] - far_right[row]) / (12.0 * h);
        }
    }
    jacobian
}

/// Smallest over largest singular value of Hill's matrix with all unknowns: `u_p = -u_g` and `u` in the harmonics
/// `+-1/2 .. +-last/2`, rows scaled to one.
pub fn hill_matrix_gap(point: &Symmetric, omega: f64, last: i32) -> f64 {
    let harmonics: Vec<i32> = (-last..=last).filter(|n| n % 2 != 0).collect();
    let size = 2 * harmonics.len();
    let mut matrix = DMatrix::<Complex<f64>>::zeros(size, size);
    for (place, n) in harmonics.iter().enumerate() {
        let s = Complex::new(0.0, 0.5 * f64::from(*n) * omega);
        let rows = [
            [s * s * point.m + s * 2.0 * point.zeta_s + point.k, s * 2.0 * point.zeta + 1.0],
            [s * s * -2.0, s * s + s * 2.0 * point.zeta + 1.0],
        ];
        for (row, entries) in rows.into_iter().enumerate() {
            let scale = 1.0 / (entries[0].norm() + entries[1].norm());
            for (column, entry) in entries.into_iter().enumerate() {
                matrix[(2 * place + row, 2 * place + column)] = entry * scale;
            }
            for neighbour in [n - 2, n + 2] {
                if let Some(other) = harmonics.iter().position(|harmonic| *harmonic == neighbour) {
                    matrix[(2 * place + row, 2 * other + 1)] = Complex::from(0.5 * point.k0 * scale);
                }
            }
        }
    }
    // Columns scaled as well, so that the gap is a matter of direction and not of units.
    for mut column in matrix.column_iter_mut() {
        let norm = column.norm();
        column /= Complex::from(norm);
    }
    let values = matrix.singular_values();
    values.min() / values.max()
}
