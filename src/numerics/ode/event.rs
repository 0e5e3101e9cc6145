//! Events on a step's own polynomial: crossings, touches and extrema of a scalar along the step.
//!
//! All work on coefficients in powers of the time since the start of the step, whoever made the step: the Taylor
//! series' are the step itself, the Runge-Kutta pair's come from
//! [`component_coefficients`](super::dense::DenseStep::component_coefficients).

use crate::numerics::roots::{self, Root, RootKind, Side, follow_roots, polynomial_value};

/// A change of sign of a polynomial.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// Time since the start of the step.
    pub since: f64,
    /// From below zero to above.
    pub rising: bool,
}

/// The first time in (0, `length`] at which the polynomial changes sign; a touch without a change is none.
///
/// `starts_on_root`: it is zero at 0 by construction, and that zero does not count.
pub fn first_crossing<const LEN: usize>(
    coefficients: &[f64; LEN],
    length: f64,
    starts_on_root: bool,
) -> Option<f64> {
    let mut first = None;
    visit_crossings(coefficients, length, starts_on_root, &mut |crossing| {
        first = Some(crossing.since);
        true
    });
    first
}

/// Calls `visit` with each change of sign in (0, `length`] (`length` below 0: backwards) in the order met, until
/// it answers true.
///
/// Signs are taken as they are, to the last bit: who follows a scalar over many steps, where rounding at the
/// joints can hide a crossing or show it twice, uses a [`Watch`]. A polynomial that is zero at the end to the last
/// bit crosses there if its continuation does.
pub fn visit_crossings<const LEN: usize>(
    coefficients: &[f64; LEN],
    length: f64,
    starts_on_root: bool,
    visit: &mut impl FnMut(Crossing) -> bool,
) {
    // With the root at 0 divided out, the rest has the same signs ahead, opposite ones backwards.
    let mut rest = *coefficients;
    if starts_on_root {
        rest.rotate_left(1);
        rest[LEN - 1] = 0.0;
    }
    let turned = starts_on_root && length < 0.0;
    let mut stopped = false;
    let side = follow_roots(&rest, length, 0.0, None, &mut |root| {
        let rising = match root.kind {
            RootKind::Rising => true,
            RootKind::Falling => false,
            RootKind::Touch | RootKind::End => return false,
        };
        stopped = visit(Crossing { since: root.at, rising: rising != turned });
        stopped
    });
    if stopped || polynomial_value(&rest, length) != 0.0 {
        return;
    }
    let onwards = polynomial_value(&roots::derivative(&rest), length) * length;
    if let (Some(before), Some(after)) = (side, Side::of(onwards, 0.0))
        && before != after
    {
        visit(Crossing { since: length, rising: (after == Side::Above) != turned });
    }
}

/// Least and greatest value of the polynomial on [0, `length`], interior extrema included.
pub fn range<const LEN: usize>(coefficients: &[f64; LEN], length: f64) -> (f64, f64) {
    let extrema = roots::extrema(coefficients, length);
    (extrema.least, extrema.greatest)
}

/// Follows a scalar from step to step and remembers on which side of zero it is, so that each crossing and each
/// touch is told once, joints between steps included, whatever the rounding there.
///
/// A scalar within the tolerance of zero is on neither side: the start of a motion on the surface tells nothing,
/// and an approach still undecided at the end of a step is told in the step that decides it, at its start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Watch {
    side: Option<Side>,
    tolerance: f64,
}

impl Watch {
    /// Starts without knowing the side.
    ///
    /// `tolerance`, in the unit of the scalar, at least 0: above the rounding errors of its values, so that those
    /// make no events, and below any dip that matters; a dip no deeper counts as a touch.
    pub fn new(tolerance: f64) -> Self {
        Self { side: None, tolerance: tolerance.max(0.0) }
    }

    /// Starts on a known side: after an event at which the motion was stopped, the side it goes to.
    pub fn from_side(side: Side, tolerance: f64) -> Self {
        Self { side: Some(side), ..Self::new(tolerance) }
    }

    /// The side last seen; `None` as long as the scalar has not left the tolerance.
    pub fn side(&self) -> Option<Side> {
        self.side
    }

    /// Calls `visit` with each event of the step in order until it answers true; the watch is then on the side
    /// that this event leads to.
    ///
    /// The coefficients of the scalar are in powers of the time since the start of the step, which lasts `length`
    /// (below 0: backwards). Kinds are [`RootKind::Rising`], [`RootKind::Falling`] and [`RootKind::Touch`].
    pub fn visit<const LEN: usize>(
        &mut self,
        coefficients: &[f64; LEN],
        length: f64,
        visit: &mut impl FnMut(Root) -> bool,
    ) {
        self.side = follow_roots(coefficients, length, self.tolerance, self.side, &mut |root| {
            root.kind != RootKind::End && visit(root)
        });
    }

    /// The first crossing of the step; the watch is then on the side it leads to.
    pub fn first_crossing<const LEN: usize>(
        &mut self,
        coefficients: &[f64; LEN],
        length: f64,
    ) -> Option<Crossing> {
        let mut first = None;
        self.visit(coefficients, length, &mut |root| {
            if root.kind != RootKind::Touch {
                first = Some(Crossing { since: root.at, rising: root.kind == RootKind::Rising });
            }
            first.is_some()
        });
        first
    }
}
