//! The motions that are born at the edges of the tongues, to first order in `k0`, damped or not: \[T7\], \[T8\].
//!
//! Amplitudes are those of the paper: `u_p = -2 (q_2 + q_3)`, `u = a q_2 + b q_3` with `q_2` of amplitude `R_B` and
//! `q_3` of amplitude `R_C`. Here `alpha` is the model's own number, `symmetric.alpha`.

use super::combination;
use super::damped::{combination_half_width, decay_rate, decay_rates, primary_half_width};
use super::modes::{Mode, Modes};
use super::primary::{self, Branch};
use crate::error::TheoryError;
use crate::model::parameters::Symmetric;

/// The second derivatives of `q_2, q_3` on the manifold `u_g = -u_p`, \[T1\], from their values and first derivatives:
/// the model without load in modal coordinates, nothing left out.
///
/// # Errors
/// [`TheoryError::Model`] for `m` or `k` out of range.
pub fn modal_accelerations(
    symmetric: &Symmetric,
    time: f64,
    q: [f64; 2],
    q_dot: [f64; 2],
) -> Result<[f64; 2], TheoryError> {
    let modes = Modes::of(symmetric)?;
    let (u, u_dot) = (modes.a * q[0] + modes.b * q[1], modes.a * q_dot[0] + modes.b * q_dot[1]);
    let (sum, sum_dot) = (q[0] + q[1], q_dot[0] + q_dot[1]);
    let mesh = symmetric.k0 * (symmetric.omega * time).cos() * u + 2.0 * symmetric.zeta * u_dot;
    let support = 16.0 * symmetric.zeta_s * sum_dot + 32.0 * symmetric.alpha * sum.powi(3);
    let of = |mode: Mode, own: f64| {
        let c = modes.coefficient(mode);
        let spread = c - modes.coefficient(mode.partner());
        -modes.sigma(mode) * (own + (mesh + support / c) / spread)
    };
    Ok([of(Mode::Second, q[0]), of(Mode::Third, q[1])])
}

/// A motion of twice the mesh period in a primary tongue, \[T7\]: both its equilibria of the slow flow, "pi apart", are
/// the two stroboscopic points of this one orbit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PeriodTwo {
    /// Sine or cosine: which of the two it becomes without damping.
    pub branch: Branch,
    /// Amplitude `R` of the mode, above 0. To leading order `max |u_p| = 2 R`, `max |u| = |c_j| R`.
    pub radius: f64,
    /// The angle of `x_1, x_2` in the slow flow, in (-pi, pi]; the orbit's other point is pi further.
    pub angle: f64,
    /// Whether it is stable within the slow flow: with damping a node or focus, without it a centre.
    pub stable: bool,
}

/// The branches of \[T7\] at the given `Omega`: sine and cosine, `None` where one does not exist. Without damping they
/// are (63), (64) or (88), (89).
///
/// The branch born at the supercritical edge (left for hardening, right for softening) is stable, the other is not.
///
/// # Errors
/// [`TheoryError::Vanishing`] where `alpha` is zero; [`TheoryError::Model`] for `m` or `k` out of range.
pub fn period_two(symmetric: &Symmetric, mode: Mode) -> Result<[Option<PeriodTwo>; 2], TheoryError> {
    if symmetric.alpha == 0.0 {
        return Err(TheoryError::Vanishing { parameter: "alpha", equation: "[T7]" });
    }
    let modes = Modes::of(symmetric)?;
    let Some(width) = primary_half_width(&modes, mode, symmetric) else {
        return Ok([None, None]);
    };
    let drive = symmetric.k0 * primary::half_width(&modes, mode);
    let loss = 2.0 * decay_rate(&modes, mode, symmetric.zeta, symmetric.zeta_s);
    let detuning = symmetric.omega - primary::emanating_frequency(&modes, mode);
    let factor = modes.weight(mode) / (4.0 * modes.frequency(mode));
    let of = |branch: Branch, edge: f64, direction: [f64; 2], supercritical: bool| {
        let square = factor * (detuning - edge) / (6.0 * symmetric.alpha);
        (square > 0.0).then(|| PeriodTwo {
            branch,
            radius: square.sqrt(),
            angle: direction[1].atan2(direction[0]),
            stable: supercritical,
        })
    };
    let hardening = symmetric.alpha > 0.0;
    Ok([
        of(Branch::Sine, -width, [loss, -(width + drive)], hardening),
        of(Branch::Cosine, width, [-(width + drive), loss], !hardening),
    ])
}

/// State `u_p, u_g, u, u_p', u_g', u'` at `t = 0` on the stable orbit of \[T7\], to start a search for the exact one of
/// period `2 T`: the mode itself and, as (33) gives it, the first-order answer of both modes at half and three
/// halves of the mesh frequency. `None` where the orbit does not exist.
///
/// The answer at three halves matters where that is near the third mode; where it is nearer than first order can
/// bear it is left out.
///
/// # Errors
/// As [`period_two`].
pub fn period_two_guess(symmetric: &Symmetric, mode: Mode) -> Result<Option<[f64; 6]>, TheoryError> {
    let modes = Modes::of(symmetric)?;
    let Some(orbit) = period_two(symmetric, mode)?.into_iter().flatten().find(|orbit| orbit.stable) else {
        return Ok(None);
    };
    Ok(Some(orbit_state(&modes, symmetric, mode, orbit.radius, orbit.angle)))
}

/// The state at `t = 0` of `q_j = R cos(Omega t/2 - angle)` with its first-order answer.
pub fn orbit_state(modes: &Modes, symmetric: &Symmetric, mode: Mode, radius: f64, angle: f64) -> [f64; 6] {
    let half = 0.5 * symmetric.omega;
    let (cosine, sine) = (radius * angle.cos(), radius * angle.sin());
    let cube = [
        [0.75 * radius * radius * cosine, 0.75 * radius * radius * sine],
        [0.25 * radius.powi(3) * (3.0 * angle).cos(), 0.25 * radius.powi(3) * (3.0 * angle).sin()],
    ];
    // cos(Omega t) q_j, split into its parts at Omega/2 and 3 Omega/2.
    let mesh = [[0.5 * cosine, -0.5 * sine], [0.5 * cosine, 0.5 * sine]];
    let velocity = [half * sine, -half * cosine];
    let own = modes.coefficient(mode);
    let mut state = [0.0; 6];
    let mut add = |shape: Mode, frequency: f64, amplitude: [f64; 2]| {
        let [u_p, u_g, u] = modes.shape(shape);
        for (place, part) in [u_p, u_g, u].into_iter().enumerate() {
            state[place] += part * amplitude[0];
            state[place + 3] += part * frequency * amplitude[1];
        }
    };
    add(mode, half, [cosine, sine]);
    for answering in Mode::BOTH {
        let c = modes.coefficient(answering);
        let sigma = modes.sigma(answering);
        let spread = c - modes.coefficient(answering.partner());
        for (harmonic, frequency) in [half, 3.0 * half].into_iter().enumerate() {
            if answering == mode && harmonic == 0 {
                continue;
            }
            let compliance = 1.0 / (sigma - frequency * frequency);
            // The damping does not fall apart into the modes: at the mode's own frequency it drives the partner.
            let friction =
                if harmonic == 0 { 2.0 * symmetric.zeta * own + 16.0 * symmetric.zeta_s / c } else { 0.0 };
            let amplitude = std::array::from_fn(|part| {
                let drive = friction * velocity[part] * sigma / spread
                    + symmetric.k0 * own * mesh[harmonic][part] * sigma / spread
                    + 32.0 * symmetric.alpha * cube[harmonic][part] * sigma / (c * spread);
                -drive * compliance
            });
            let size = f64::hypot(amplitude[0], amplitude[1]);
            if size < 2.0 * radius {
                add(answering, frequency, amplitude);
            }
        }
    }
    state
}

/// A quasi-periodic motion in the combination tongue, \[T8\]: a cycle of the slow flow, a closed curve in the
/// stroboscopic map.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cycle {
    /// Amplitude `R_B = 2 R_2` of the second mode, above 0.
    pub radius_b: f64,
    /// Amplitude `R_C = 2 R_3` of the third mode, above 0. To leading order `max |u_p| = 2 (R_B + R_C)`.
    pub radius_c: f64,
    /// Whether it belongs to the edge at which the bifurcation is supercritical (left for hardening, right for
    /// softening); the other is born at the subcritical edge.
    pub supercritical: bool,
    /// Whether it is stable within the slow flow. Without damping: a centre among the family of cycles.
    pub stable: bool,
    /// Frequencies at which the second and the third mode turn, radians per unit of time; they add up to `Omega`.
    pub frequencies: [f64; 2],
}

/// The cycles of \[T8\] at the given `Omega`: the supercritical edge's and the subcritical edge's, `None` where one does
/// not exist. The first goes on beyond the tongue's other edge.
///
/// Without damping the cycles are a family; given are those with the invariant of Manley and Rowe,
/// `R_2^2/H_2 - R_3^2/H_3`, equal to zero, as for a motion that starts at the origin.
///
/// # Errors
/// [`TheoryError::Vanishing`] where `alpha` is zero; [`TheoryError::Model`] for `m` or `k` out of range.
pub fn cycles(symmetric: &Symmetric) -> Result<[Option<Cycle>; 2], TheoryError> {
    if symmetric.alpha == 0.0 {
        return Err(TheoryError::Vanishing { parameter: "alpha", equation: "[T8]" });
    }
    let modes = Modes::of(symmetric)?;
    let Some(width) = combination_half_width(&modes, symmetric) else {
        return Ok([None, None]);
    };
    let [d_2, d_3] = decay_rates(&modes, symmetric);
    let [h_2, h_3] = combination::couplings(&modes);
    let [g_2, g_3] = combination::frequency_shifts(&modes, symmetric.alpha);
    let undamped = d_2 * d_3 == 0.0;
    let ratio_squared = if undamped { h_2 / h_3 } else { h_2 * d_3 / (h_3 * d_2) };
    let ratio = ratio_squared.sqrt();
    let cos_psi = if undamped {
        1.0
    } else {
        (1.0 - d_2 * d_3 / (symmetric.k0 * symmetric.k0 * h_2 * h_3)).max(0.0).sqrt()
    };
    let shift = g_2 * (ratio_squared + 2.0) + g_3 * (1.0 + 2.0 * ratio_squared);
    let detuning = symmetric.omega - combination::emanating_frequency(&modes);
    let pulls = [symmetric.k0 * h_2 / ratio, symmetric.k0 * h_3 * ratio];
    let of = |supercritical: bool| {
        // The sign of cos psi: the left edge's cycle has it positive, and for hardening that is the supercritical one.
        let sign = if supercritical == (symmetric.alpha > 0.0) { 1.0 } else { -1.0 };
        let square = (detuning + sign * width) / shift;
        (square > 0.0).then(|| {
            let (r_2_squared, r_3_squared) = (ratio_squared * square, square);
            let second_shift = g_2 * (r_2_squared + 2.0 * r_3_squared) - sign * cos_psi * pulls[0];
            let third_shift = g_3 * (r_3_squared + 2.0 * r_2_squared) - sign * cos_psi * pulls[1];
            let slope = [2.0 * (g_2 + 2.0 * g_3) * r_2_squared, 2.0 * (2.0 * g_2 + g_3) * r_3_squared];
            Cycle {
                radius_b: 2.0 * r_2_squared.sqrt(),
                radius_c: 2.0 * r_3_squared.sqrt(),
                supercritical,
                stable: is_stable([d_2, d_3], pulls.map(|pull| sign * cos_psi * pull), slope),
                frequencies: [modes.omega[1] + second_shift, modes.omega[2] + third_shift],
            }
        })
    };
    Ok([of(true), of(false)])
}

/// Stability of a cycle: the slow flow in `ln R_2`, `ln R_3` and the phase `psi`, linearised,
/// `[[-d_2, d_2, p_2], [d_3, -d_3, p_3], [p_3 - p_2 - s_2, p_2 - p_3 - s_3, -d_2 - d_3]]` with the pulls
/// `p_j = k0 H cos psi` and the slopes `s_j` of the detuning; Routh and Hurwitz decide.
fn is_stable([d_2, d_3]: [f64; 2], [p_2, p_3]: [f64; 2], [s_2, s_3]: [f64; 2]) -> bool {
    let (f_2, f_3) = (p_3 - p_2 - s_2, p_2 - p_3 - s_3);
    let sum = d_2 + d_3;
    if sum == 0.0 {
        // On a leaf of the invariant both amplitudes grow together: a centre if the product below is negative.
        return p_2 * (f_2 + f_3) < 0.0;
    }
    let quadratic = 2.0 * sum;
    let linear = sum * sum - p_2 * f_2 - p_3 * f_3;
    let constant = -(d_3 * p_2 + d_2 * p_3) * (f_2 + f_3);
    constant > 0.0 && quadratic * linear > constant
}
