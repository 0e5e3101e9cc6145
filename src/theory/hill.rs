//! Edges of the primary tongues without integration: the determinant of Hill and Bolotin, to convergence.
//!
//! On an edge there is a motion of twice the mesh period, `u = sum_n u_n exp(i n Omega t / 2)` over odd `n`. The mesh
//! acts through `u` alone, so that of all unknowns of a harmonic (both modes) only `u_n` needs to be kept: with the
//! dynamic stiffness `z` of [`dynamic_stiffness`] at `omega_n = n Omega / 2`
//!
//! `z(omega_n) u_n + (k0/2) (u_(n-2) + u_(n+2)) = 0`, `u_(-1) = conj(u_1)`.
//!
//! Harmonics from 3 on are eliminated by the three-term recurrence of the tridiagonal determinant; what is left is
//! `|Z| = k0/2`, with `|Z| < k0/2` inside the tongue. Nothing is truncated but harmonics that no longer count.

use nalgebra::Complex;

use super::modes::{Mode, Modes};
use super::primary;
use super::roots::ridders;
use super::tongues::Edges;
use crate::error::TheoryError;
use crate::model::parameters::Symmetric;

/// Numerator and denominator of [`dynamic_stiffness`], scaled so that neither exceeds about one: no poles.
fn dynamic_stiffness_parts(symmetric: &Symmetric, frequency: f64) -> [Complex<f64>; 2] {
    let square = frequency * frequency;
    let Symmetric { m, k, zeta, zeta_s, .. } = *symmetric;
    let support = Complex::new(k - m * square, 2.0 * frequency * zeta_s);
    let denominator = Complex::from(2.0 * square) - support;
    let numerator = denominator * Complex::new(1.0, 2.0 * frequency * zeta) + support * square;
    let scale = 1.0 / (k + (m + 2.0) * square + m * square * square);
    [numerator * scale, denominator * scale]
}

/// Force through the teeth per `u` at this frequency, with the mesh stiffness at its mean: zero, without damping, at
/// `omega_2` and `omega_3`. With `s = k - m omega^2 + 2 i omega zeta_s` it is
/// `1 + 2 i omega zeta + omega^2 s / (2 omega^2 - s)`.
///
/// # Errors
/// [`TheoryError::Vanishing`] where `2 omega^2 = s`: there no force moves `u`.
pub fn dynamic_stiffness(symmetric: &Symmetric, frequency: f64) -> Result<Complex<f64>, TheoryError> {
    let [numerator, denominator] = dynamic_stiffness_parts(symmetric, frequency);
    if denominator.norm_sqr() == 0.0 {
        return Err(TheoryError::Vanishing { parameter: "2 omega^2 - s", equation: "Hill" });
    }
    Ok(numerator / denominator)
}

/// `Z` as numerator and denominator: the dynamic stiffness at `Omega/2` less what the higher harmonics take.
/// A common factor is arbitrary.
fn reduced_stiffness(symmetric: &Symmetric, fastest: f64, omega: f64) -> [Complex<f64>; 2] {
    let half = 0.5 * omega;
    let coupling = 0.25 * symmetric.k0 * symmetric.k0;
    // Past twice the fastest natural frequency each further harmonic counts at least 30 times less.
    let last = ((2.0 * fastest / half).min(2e4) as usize | 1) + 32;
    let zero = Complex::from(0.0);
    let (mut ahead, mut further) = (Complex::from(1.0), zero);
    let mut denominator_ahead = zero;
    for n in (3..=last).rev().step_by(2) {
        let [numerator, denominator] = dynamic_stiffness_parts(symmetric, n as f64 * half);
        let here = numerator * ahead - denominator * denominator_ahead * further * coupling;
        let size = here.norm().max(ahead.norm()).max(f64::MIN_POSITIVE);
        (further, ahead) = (ahead / size, here / size);
        denominator_ahead = denominator;
    }
    let [numerator, denominator] = dynamic_stiffness_parts(symmetric, half);
    [numerator * ahead - denominator * denominator_ahead * further * coupling, denominator * ahead]
}

/// The determinant as a number from -1 to 1, smooth in `omega`: below 0 inside the tongue, zero on its edges.
/// Its roots are those of the determinant with all harmonics.
pub fn determinant(modes: &Modes, symmetric: &Symmetric, omega: f64) -> f64 {
    let [numerator, denominator] = reduced_stiffness(symmetric, modes.omega[2], omega);
    let (stiffness, drive) = (numerator.norm_sqr(), 0.25 * symmetric.k0.powi(2) * denominator.norm_sqr());
    if stiffness + drive == 0.0 { 0.0 } else { (stiffness - drive) / (stiffness + drive) }
}

/// The elastic part of `Z`, smooth and zero in the middle of the tongue.
fn elastic_part(modes: &Modes, symmetric: &Symmetric, omega: f64) -> f64 {
    let [numerator, denominator] = reduced_stiffness(symmetric, modes.omega[2], omega);
    let size = numerator.norm_sqr() + denominator.norm_sqr();
    if size == 0.0 { 0.0 } else { (numerator * denominator.conj()).re / size }
}

/// The middle of the tongue, where `Z` has no elastic part, followed from `k0 = 0` to the given `k0`.
fn middle(modes: &Modes, mode: Mode, symmetric: &Symmetric) -> Result<f64, TheoryError> {
    let start = primary::emanating_frequency(modes, mode);
    // The dynamic stiffness rises from zero to about one within this, however small against the frequency.
    let width = primary::half_width(modes, mode);
    let steps = (symmetric.k0 / 0.02).ceil().max(1.0) as usize;
    // At even k0: the middle moves with k0 squared. The two last points predict the next.
    let (mut before, mut middle) = (start, start);
    for step in 1..=steps {
        let part = step as f64 / steps as f64;
        let at = Symmetric { k0: symmetric.k0 * part, ..*symmetric };
        let advance = if step > 1 {
            let squares = (2 * step - 1) as f64 / (2 * step - 3) as f64;
            (middle - before) * squares
        } else {
            0.0
        };
        let next = newton(|omega| elastic_part(modes, &at, omega), middle + advance, width)?;
        (before, middle) = (middle, next);
    }
    Ok(middle)
}

/// Newton's iteration with a difference quotient, for a function that varies over the given width.
fn newton(function: impl Fn(f64) -> f64, start: f64, width: f64) -> Result<f64, TheoryError> {
    let mut x = start;
    let mut residual = f64::INFINITY;
    let difference = 1e-4 * width;
    for _ in 0..60 {
        let value = function(x);
        residual = value.abs();
        let slope = (function(x + difference) - function(x - difference)) / (2.0 * difference);
        let step = value / slope;
        if !step.is_finite() {
            break;
        }
        x -= step.clamp(-0.2 * width, 0.2 * width);
        if step.abs() < 1e-8 * width + 4.0 * f64::EPSILON * start.abs() {
            return Ok(x);
        }
    }
    Err(TheoryError::NoConvergence { residual })
}

/// The deepest point of the tongue near its middle, and the determinant there.
fn deepest(modes: &Modes, mode: Mode, symmetric: &Symmetric) -> Result<(f64, f64), TheoryError> {
    let step = symmetric.k0 * primary::half_width(modes, mode) / 16.0;
    let value = |omega: f64| determinant(modes, symmetric, omega);
    // Damping moves the tongue little but may take the elastic part's zero away, so start from the undamped middle;
    // only where another tongue hides that, damping may help.
    let undamped = Symmetric { zeta: 0.0, zeta_s: 0.0, ..*symmetric };
    let mut centre = middle(modes, mode, &undamped).or_else(|_| middle(modes, mode, symmetric))?;
    let mut depth = value(centre);
    for _ in 0..64 {
        let (left, right) = (value(centre - step), value(centre + step));
        if left < depth && left <= right {
            (centre, depth) = (centre - step, left);
        } else if right < depth {
            (centre, depth) = (centre + step, right);
        } else {
            break;
        }
    }
    // Golden section; the determinant has one minimum between the neighbours.
    let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
    let (mut low, mut high) = (centre - step, centre + step);
    let (mut one, mut two) = (high - golden * (high - low), low + golden * (high - low));
    let (mut at_one, mut at_two) = (value(one), value(two));
    while high - low > 1e-7 * step + 4.0 * f64::EPSILON * centre.abs() {
        if at_one < at_two {
            (high, two, at_two) = (two, one, at_one);
            one = high - golden * (high - low);
            at_one = value(one);
        } else {
            (low, one, at_one) = (one, two, at_two);
            two = low + golden * (high - low);
            at_two = value(two);
        }
    }
    let found = 0.5 * (low + high);
    Ok((found, value(found)))
}

/// Edges of a primary tongue of the exact linear problem at the given `k0` and damping: `None` where it is closed.
///
/// The tongue is the one that starts from [`primary::emanating_frequency`], followed as `k0` grows from zero.
///
/// # Errors
/// [`TheoryError::Model`] for `m` or `k` out of range; [`TheoryError::NoConvergence`] where the tongue cannot be
/// followed, because another one of period `2 T` runs into it.
pub fn edges(symmetric: &Symmetric, mode: Mode) -> Result<Option<Edges>, TheoryError> {
    let modes = Modes::of(symmetric)?;
    if symmetric.k0 == 0.0 {
        return Ok(None);
    }
    let (deepest, depth) = deepest(&modes, mode, symmetric)?;
    if depth >= 0.0 {
        return Ok(None);
    }
    let start = primary::emanating_frequency(&modes, mode);
    let step = symmetric.k0 * primary::half_width(&modes, mode) / 16.0;
    let value = |omega: f64| determinant(&modes, symmetric, omega);
    let outward = |sign: f64| {
        let mut inner = deepest;
        for _ in 0..256 {
            let outer = inner + sign * step;
            if outer < 0.01 * start {
                break;
            }
            if value(outer) >= 0.0 {
                return Ok(ridders(value, inner, outer));
            }
            inner = outer;
        }
        Err(TheoryError::NoConvergence { residual: value(inner).abs() })
    };
    Ok(Some(Edges { left: outward(-1.0)?, right: outward(1.0)? }))
}

/// The tip of a primary tongue: the least `k0` at which it is open, and its mesh frequency there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tip {
    /// Least `k0`.
    pub k0: f64,
    /// Mesh frequency of the tip.
    pub omega: f64,
}

/// The exact threshold of a primary tongue with damping: `None` where it stays closed up to `k0 = 1`. Without damping
/// the tip is at `k0 = 0`.
///
/// # Errors
/// As [`edges`].
pub fn tip(symmetric: &Symmetric, mode: Mode) -> Result<Option<Tip>, TheoryError> {
    let modes = Modes::of(symmetric)?;
    let first_order = super::damped::primary_threshold(&modes, mode, symmetric);
    if first_order == 0.0 {
        return Ok(Some(Tip { k0: 0.0, omega: primary::emanating_frequency(&modes, mode) }));
    }
    let at = |k0: f64| deepest(&modes, mode, &Symmetric { k0, ..*symmetric });
    let (mut closed, mut open) = (0.0, (1.25 * first_order).min(1.0));
    while at(open)?.1 >= 0.0 {
        if open >= 1.0 {
            return Ok(None);
        }
        (closed, open) = (open, (1.25 * open).min(1.0));
    }
    while open - closed > 1e-10 * open {
        let middle = 0.5 * (closed + open);
        if at(middle)?.1 < 0.0 { open = middle } else { closed = middle }
    }
    Ok(Some(Tip { k0: open, omega: at(open)?.0 }))
}

/// `Omega_2` of (31) for both edges of a primary tongue, without damping: the second-order term of the determinant
/// truncated to the harmonics 1/2 and 3/2 of both modes. The edges are
/// `Omega_0 -+ k0 W_j + k0^2 Omega_2 + O(k0^3)`.
///
/// # Errors
/// [`TheoryError::Vanishing`] where three times this mode's frequency is a natural frequency of the other.
pub fn omega_2(modes: &Modes, mode: Mode) -> Result<f64, TheoryError> {
    let Modes { m, k, .. } = *modes;
    let numerator =
        |square: f64| -m * (square - modes.sigma(Mode::Second)) * (square - modes.sigma(Mode::Third));
    let denominator = |square: f64| (m + 2.0) * square - k;
    let sigma = modes.sigma(mode);
    let third_harmonic = numerator(9.0 * sigma);
    if third_harmonic == 0.0 {
        return Err(TheoryError::Vanishing { parameter: "3 omega_j - omega_i", equation: "(31)" });
    }
    // Derivatives of z by omega at its zero, through those by omega^2.
    let slope = -m * (sigma - modes.sigma(mode.partner())) / denominator(sigma);
    let bend = (-2.0 * m - 2.0 * slope * (m + 2.0)) / denominator(sigma);
    let first = 2.0 * modes.frequency(mode) * slope;
    let second = 2.0 * slope + 4.0 * sigma * bend;
    let width = primary::half_width(modes, mode);
    Ok((denominator(9.0 * sigma) / third_harmonic - 0.5 * second * width * width) / (2.0 * first))
}
