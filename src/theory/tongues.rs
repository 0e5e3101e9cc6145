//! The three tongues in one answer: where each formula puts them at the given `k0`.

use super::modes::{Mode, Modes};
use super::{combination, damped, hill, primary};
use crate::error::TheoryError;
use crate::model::parameters::Symmetric;

/// Left and right edge of a tongue, mesh frequencies `Omega`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Edges {
    /// Left edge.
    pub left: f64,
    /// Right edge.
    pub right: f64,
}

impl Edges {
    /// The edges at this half-width about this centre.
    pub fn about(centre: f64, half_width: f64) -> Self {
        Self { left: centre - half_width, right: centre + half_width }
    }
}

/// One tongue at the given `k0` and damping. `None` means closed; at `k0 = 0` all are.
#[derive(Clone, Debug, PartialEq)]
pub struct Tongue {
    /// Mesh frequency `Omega_0` from which it starts at `k0 = 0`.
    pub omega_0: f64,
    /// First order without damping as printed: (56), (82), (105).
    pub paper: Option<Edges>,
    /// First order without damping, corrected: \[T3\], \[T4\].
    pub corrected: Option<Edges>,
    /// First order with damping: \[T5\], \[T6\].
    pub damped: Option<Edges>,
    /// All orders, with damping, by Hill's determinant; only for the primary tongues.
    pub hill: Option<Edges>,
    /// Why `hill` is missing where it is not for being closed.
    pub hill_error: Option<TheoryError>,
    /// `k0` above which the tongue is open with damping, first order: \[T5\], \[T6\]. May be above 1.
    pub threshold: f64,
}

/// The three tongues.
#[derive(Clone, Debug, PartialEq)]
pub struct Tongues {
    /// About `2 omega_2`.
    pub primary2: Tongue,
    /// About `2 omega_3`.
    pub primary3: Tongue,
    /// About `omega_2 + omega_3`.
    pub combination: Tongue,
}

/// All formulas for the three tongues at the given `m, k, zeta, zeta_s, k0`; `alpha` and `omega` do not matter.
///
/// # Errors
/// [`TheoryError::Model`] for `m` or `k` out of range.
pub fn tongues(symmetric: &Symmetric) -> Result<Tongues, TheoryError> {
    let modes = Modes::of(symmetric)?;
    Ok(Tongues {
        primary2: primary_tongue(&modes, symmetric, Mode::Second),
        primary3: primary_tongue(&modes, symmetric, Mode::Third),
        combination: combination_tongue(&modes, symmetric),
    })
}

fn opened(symmetric: &Symmetric, centre: f64, width: f64) -> Option<Edges> {
    (symmetric.k0 > 0.0).then(|| Edges::about(centre, symmetric.k0 * width))
}

fn primary_tongue(modes: &Modes, symmetric: &Symmetric, mode: Mode) -> Tongue {
    let omega_0 = primary::emanating_frequency(modes, mode);
    let (hill, hill_error) = match hill::edges(symmetric, mode) {
        Ok(edges) => (edges, None),
        Err(error) => (None, Some(error)),
    };
    Tongue {
        omega_0,
        paper: opened(symmetric, omega_0, primary::half_width_printed(modes, mode)),
        corrected: opened(symmetric, omega_0, primary::half_width(modes, mode)),
        damped: damped::primary_edges(modes, mode, symmetric),
        hill,
        hill_error,
        threshold: damped::primary_threshold(modes, mode, symmetric),
    }
}

fn combination_tongue(modes: &Modes, symmetric: &Symmetric) -> Tongue {
    let omega_0 = combination::emanating_frequency(modes);
    Tongue {
        omega_0,
        paper: opened(symmetric, omega_0, combination::half_width_printed(modes)),
        corrected: opened(symmetric, omega_0, combination::half_width(modes)),
        damped: damped::combination_edges(modes, symmetric),
        hill: None,
        hill_error: None,
        threshold: damped::combination_threshold(modes, symmetric),
    }
}
