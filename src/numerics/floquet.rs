//! Floquet multipliers: eigenvalues of a real 6 x 6 monodromy matrix, and the identities that check it.

use nalgebra::{Complex, SMatrix};

use crate::error::NumericsError;

/// A monodromy matrix, row by row.
pub type Matrix6 = SMatrix<f64, 6, 6>;

/// Real and imaginary parts of the six multipliers, largest modulus first, of a pair the one with the positive
/// imaginary part first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spectrum {
    /// Real parts.
    pub re: [f64; 6],
    /// Imaginary parts.
    pub im: [f64; 6],
}

impl Spectrum {
    /// Largest modulus.
    pub fn radius(&self) -> f64 {
        self.re.iter().zip(&self.im).fold(0.0, |most, (re, im)| most.max(re.hypot(*im)))
    }

    /// Greatest distance between the multipliers of two spectra, each paired with its nearest, as a
    /// measure of how much a refinement changed them.
    pub fn distance(&self, other: &Self) -> f64 {
        let mut free = [true; 6];
        let mut greatest = 0.0_f64;
        for (re, im) in self.re.iter().zip(&self.im) {
            let mut nearest = (f64::INFINITY, 0);
            for (index, (other_re, other_im)) in other.re.iter().zip(&other.im).enumerate() {
                let distance = (re - other_re).hypot(im - other_im);
                if free[index] && distance < nearest.0 {
                    nearest = (distance, index);
                }
            }
            free[nearest.1] = false;
            greatest = greatest.max(nearest.0);
        }
        greatest
    }
}

/// Iterations of the QR algorithm that are granted before another similar matrix is tried.
const QR_ITERATIONS: usize = 300;

/// The six eigenvalues of a real matrix.
///
/// The QR algorithm of nalgebra has no exceptional shifts; where it stalls, the same question is asked of an
/// orthogonally similar matrix, which has the same eigenvalues and stalls elsewhere.
///
/// # Errors
/// [`NumericsError::NotFinite`] for a matrix that is not finite, [`NumericsError::NoConvergence`] where the
/// algorithm stalls on every one of the similar matrices.
pub fn spectrum(matrix: &Matrix6) -> Result<Spectrum, NumericsError> {
    if matrix.iter().any(|value| !value.is_finite()) {
        return Err(NumericsError::NotFinite { time: 0.0 });
    }
    let scale = matrix.amax();
    if scale == 0.0 {
        return Ok(Spectrum { re: [0.0; 6], im: [0.0; 6] });
    }
    // Scaled to entries of at most one, so that neither tiny nor huge matrices defeat the convergence test.
    let mut similar = matrix / scale;
    for attempt in 0..4 {
        if let Some(schur) = nalgebra::linalg::Schur::try_new(similar, f64::EPSILON, QR_ITERATIONS) {
            let eigenvalues = schur.complex_eigenvalues();
            if eigenvalues.iter().all(|value| value.re.is_finite() && value.im.is_finite()) {
                return Ok(sorted(eigenvalues.as_slice(), scale));
            }
        }
        let reflection = householder(attempt);
        similar = reflection * similar * reflection;
    }
    Err(NumericsError::NoConvergence {
        iterations: 4 * QR_ITERATIONS,
        residual: scale,
        tolerance: f64::EPSILON,
    })
}

/// A reflection of no particular direction, another one for each attempt.
fn householder(attempt: usize) -> Matrix6 {
    let mut direction = nalgebra::SVector::<f64, 6>::from_fn(|row, _| {
        // Square roots of primes share no rational relation that a structured matrix could match.
        [2.0_f64, 3.0, 5.0, 7.0, 11.0, 13.0][(row + attempt) % 6].sqrt() - 0.5
    });
    direction.normalize_mut();
    Matrix6::identity() - 2.0 * direction * direction.transpose()
}

/// Six numbers, real and imaginary parts, in the order of a spectrum.
pub fn ordered(values: [(f64, f64); 6]) -> Spectrum {
    sorted(&values.map(|(re, im)| Complex::new(re, im)), 1.0)
}

fn sorted(eigenvalues: &[Complex<f64>], scale: f64) -> Spectrum {
    let mut ordered = [Complex::new(0.0, 0.0); 6];
    ordered.copy_from_slice(eigenvalues);
    // The two of a pair have the same modulus to the last bit, so that they stay together.
    let key = |value: &Complex<f64>| [value.norm(), value.im.abs(), value.im, value.re];
    // Six are sorted soonest by moving each to its place.
    for end in 1..ordered.len() {
        for place in (1..=end).rev() {
            let (left, right) = (key(&ordered[place - 1]), key(&ordered[place]));
            let unlike = (0..4).find(|index| left[*index].total_cmp(&right[*index]).is_ne());
            if unlike.is_none_or(|index| left[index].total_cmp(&right[index]).is_gt()) {
                break;
            }
            ordered.swap(place - 1, place);
        }
    }
    Spectrum { re: ordered.map(|value| value.re * scale), im: ordered.map(|value| value.im * scale) }
}

/// How far a monodromy matrix is from Liouville's identity det M = exp(integral of the trace).
///
/// `log_determinant` is that integral. The answer is relative to exp of it, unless that is so small that the
/// rounding of the matrix's own entries outweighs it; then it is relative to the entries.
pub fn liouville_residual(matrix: &Matrix6, log_determinant: f64) -> f64 {
    let expected = log_determinant.exp();
    let rounding = f64::EPSILON * matrix.norm().powi(6);
    (matrix.determinant() - expected).abs() / expected.max(rounding).max(f64::MIN_POSITIVE)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn eigenvalues_of_known_blocks_come_in_order() {
        let mut matrix = Matrix6::zeros();
        // A rotation by 1 rad of modulus 1.2, a rotation of modulus 0.9, and 2, -0.5.
        for (at, modulus, angle) in [(0, 1.2_f64, 1.0_f64), (2, 0.9, 2.0)] {
            matrix[(at, at)] = modulus * angle.cos();
            matrix[(at, at + 1)] = -modulus * angle.sin();
            matrix[(at + 1, at)] = modulus * angle.sin();
            matrix[(at + 1, at + 1)] = modulus * angle.cos();
        }
        matrix[(4, 4)] = 2.0;
        matrix[(5, 5)] = -0.5;
        let reflection = householder(0);
        let spectrum = spectrum(&(reflection * matrix * reflection)).expect("converges");
        let expected = [(2.0, 0.0), (1.2, 1.0), (1.2, -1.0), (0.9, 2.0), (0.9, -2.0), (-0.5, 0.0)];
        for (index, (modulus, angle)) in expected.into_iter().enumerate() {
            let (re, im) =
                if index == 5 { (-0.5, 0.0) } else { (modulus * f64::cos(angle), modulus * f64::sin(angle)) };
            assert!((spectrum.re[index] - re).abs() < 1e-13 && (spectrum.im[index] - im).abs() < 1e-13);
        }
        assert!((spectrum.radius() - 2.0).abs() < 1e-13);
    }

    #[test]
    fn a_cyclic_permutation_which_stalls_unshifted_qr_is_solved() {
        let permutation = Matrix6::from_fn(|row, column| f64::from(u8::from((column + 1) % 6 == row)));
        let spectrum = spectrum(&permutation).expect("converges");
        for (re, im) in spectrum.re.iter().zip(&spectrum.im) {
            let sixth = Complex::new(*re, *im).powu(6);
            assert!((sixth - Complex::new(1.0, 0.0)).norm() < 1e-12, "{re} {im}");
        }
    }

    #[test]
    fn liouville_residual_sees_a_wrong_determinant() {
        let matrix = Matrix6::identity() * 0.5;
        let log_determinant = 6.0 * 0.5_f64.ln();
        assert!(liouville_residual(&matrix, log_determinant) < 1e-15);
        assert!(liouville_residual(&matrix, log_determinant + 1e-3) > 9e-4);
    }

    #[test]
    fn what_is_not_finite_is_refused() {
        let mut matrix = Matrix6::identity();
        matrix[(2, 3)] = f64::NAN;
        assert!(matches!(spectrum(&matrix), Err(NumericsError::NotFinite { .. })));
    }
}
