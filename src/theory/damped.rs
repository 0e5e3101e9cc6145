//! What damping does to the tongues, to first order in `k0`: \[T2\], \[T5\], \[T6\] and the exponents of the origin.
//!
//! The paper has no damping here. Rates and exponents are per unit of dimensionless time.

use nalgebra::Complex;

use super::modes::{Mode, Modes};
use super::tongues::Edges;
use super::{combination, primary};
use crate::error::TheoryError;
use crate::model::parameters::Symmetric;

/// Rate at which a free vibration of the mode decays, \[T2\]:
/// `d_j = zeta c_j sigma_j/(c_j - c_i) + 8 zeta_s sigma_j/(c_j (c_j - c_i))`.
pub fn decay_rate(modes: &Modes, mode: Mode, zeta: f64, zeta_s: f64) -> f64 {
    let sigma = modes.sigma(mode);
    zeta * sigma * modes.coefficient(mode).abs() / modes.spread() + 8.0 * zeta_s * sigma / modes.weight(mode)
}

/// Both decay rates `d_2, d_3` for these parameters.
pub(super) fn decay_rates(modes: &Modes, symmetric: &Symmetric) -> [f64; 2] {
    Mode::BOTH.map(|mode| decay_rate(modes, mode, symmetric.zeta, symmetric.zeta_s))
}

/// Half-width in `Omega` of the primary tongue, \[T5\]: `sqrt((k0 W_j)^2 - (2 d_j)^2)`; `None` where damping closes it.
pub fn primary_half_width(modes: &Modes, mode: Mode, symmetric: &Symmetric) -> Option<f64> {
    let drive = symmetric.k0 * primary::half_width(modes, mode);
    let loss = 2.0 * decay_rate(modes, mode, symmetric.zeta, symmetric.zeta_s);
    (drive > loss).then(|| ((drive - loss) * (drive + loss)).sqrt())
}

/// Edges of the primary tongue, \[T5\]; `None` where damping closes it.
pub fn primary_edges(modes: &Modes, mode: Mode, symmetric: &Symmetric) -> Option<Edges> {
    let half_width = primary_half_width(modes, mode, symmetric)?;
    Some(Edges::about(primary::emanating_frequency(modes, mode), half_width))
}

/// The `k0` above which the primary tongue is open, \[T5\]: `2 d_j / W_j`. May be above 1.
pub fn primary_threshold(modes: &Modes, mode: Mode, symmetric: &Symmetric) -> f64 {
    2.0 * decay_rate(modes, mode, symmetric.zeta, symmetric.zeta_s) / primary::half_width(modes, mode)
}

/// Half-width in `Omega` of the combination tongue, \[T6\]: `(d_2 + d_3) sqrt((k0 W_c)^2/(4 d_2 d_3) - 1)`, without
/// damping \[T4\]; `None` where damping closes it. As the damping vanishes this stays wider than \[T4\].
pub fn combination_half_width(modes: &Modes, symmetric: &Symmetric) -> Option<f64> {
    let drive = symmetric.k0 * combination::half_width(modes);
    let [second, third] = decay_rates(modes, symmetric);
    let loss = 2.0 * (second * third).sqrt();
    if loss == 0.0 {
        return (drive > 0.0).then_some(drive);
    }
    (drive > loss).then(|| (second + third) * ((drive - loss) * (drive + loss)).sqrt() / loss)
}

/// Edges of the combination tongue, \[T6\]; `None` where damping closes it.
pub fn combination_edges(modes: &Modes, symmetric: &Symmetric) -> Option<Edges> {
    let half_width = combination_half_width(modes, symmetric)?;
    Some(Edges::about(combination::emanating_frequency(modes), half_width))
}

/// The `k0` above which the combination tongue is open, \[T6\]: `2 sqrt(d_2 d_3) / W_c`. May be above 1.
pub fn combination_threshold(modes: &Modes, symmetric: &Symmetric) -> f64 {
    let [second, third] = decay_rates(modes, symmetric);
    2.0 * (second * third).sqrt() / combination::half_width(modes)
}

/// Exponents of the origin near a primary tongue at the given `Omega`, first order:
/// `-d_j +- sqrt((k0 W_j)^2 - (Omega - 2 omega_j)^2) / 2`. They are those of the slow flow, whose frame turns at
/// `Omega/2`: the Floquet exponents are these plus `i Omega/2`.
///
/// # Errors
/// [`TheoryError::Model`] for `m` or `k` out of range.
pub fn primary_exponents(symmetric: &Symmetric, mode: Mode) -> Result<[Complex<f64>; 2], TheoryError> {
    let modes = Modes::of(symmetric)?;
    let decay = decay_rate(&modes, mode, symmetric.zeta, symmetric.zeta_s);
    let drive = symmetric.k0 * primary::half_width(&modes, mode);
    let detuning = symmetric.omega - primary::emanating_frequency(&modes, mode);
    let root = Complex::new(0.25 * (drive - detuning) * (drive + detuning), 0.0).sqrt();
    Ok([root - decay, -root - decay])
}

/// Exponents of the origin near the combination tongue at the given `Omega`, first order, with or without damping.
///
/// The first two belong to `beta_2` and the conjugate of `beta_3`, the last two are their conjugates. They are those of
/// the slow flow in which mode `j` turns at `omega_j Omega / Omega_0`: the Floquet exponents are the first two plus
/// `i omega_2 Omega / Omega_0`, and their conjugates.
///
/// # Errors
/// [`TheoryError::Model`] for `m` or `k` out of range.
pub fn combination_exponents(symmetric: &Symmetric) -> Result<[Complex<f64>; 4], TheoryError> {
    let modes = Modes::of(symmetric)?;
    let omega_0 = combination::emanating_frequency(&modes);
    let [second, third] = decay_rates(&modes, symmetric);
    let drive = 0.5 * symmetric.k0 * combination::half_width(&modes);
    let detuning = symmetric.omega - omega_0;
    let mean = Complex::new(second + third, detuning * (modes.omega[1] - modes.omega[2]) / omega_0) * -0.5;
    let half_difference = Complex::new(second - third, detuning) * 0.5;
    let root = (half_difference * half_difference + drive * drive).sqrt();
    let (plus, minus) = (mean + root, mean - root);
    Ok([plus, minus, plus.conj(), minus.conj()])
}
