//! The range of mesh frequencies in which the tongues lie, for figures over it.

use crate::model::parameters::Parameters;
use crate::theory::modes::Modes;

/// From below the tongue of the second mode to above that of the third. Unequal supports are taken by their means.
pub(super) fn range(p: &Parameters) -> (f64, f64) {
    let modes = Modes::new(0.5 * (p.m_p + p.m_g), 0.5 * (p.k_p + p.k_g));
    let (low, high) = modes.map_or((0.5 * p.omega, 2.0 * p.omega), |modes| {
        (0.55 * 2.0 * modes.omega[1], 2.0 * modes.omega[2] + 1.2 * modes.omega[1])
    });
    let low = low.clamp(0.01, 50.0);
    (low, high.clamp(1.2 * low, 100.0))
}
