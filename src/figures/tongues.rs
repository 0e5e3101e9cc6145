//! What figures 2-10 share: the slow flow's setting for one sign of `alpha`, ranges, curves that begin at an edge.

use super::compose::{Line, Points, crowded};
use crate::chart::drawing::Role;
use crate::error::FigureError;
use crate::model::parameters::{Parameters, Symmetric};
use crate::theory::modes::Modes;

/// Points on a curve that begins at an edge.
const CURVE: usize = 90;

/// The supports' two kinds, side by side in figures 3, 5, 7.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Supports {
    /// `alpha > 0`.
    Hardening,
    /// `alpha < 0`.
    Softening,
}

impl Supports {
    pub(super) const BOTH: [Self; 2] = [Self::Hardening, Self::Softening];

    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Hardening => "hardening",
            Self::Softening => "softening",
        }
    }

    /// The sign of `alpha`, which is also the side of an edge on which its branch lies.
    pub(super) fn sign(self) -> f64 {
        match self {
            Self::Hardening => 1.0,
            Self::Softening => -1.0,
        }
    }

    /// The title of a panel, with the value of `alpha`.
    pub(super) fn title(self, magnitude: f64) -> String {
        let sign = if self == Self::Hardening { "+" } else { "\u{2212}" };
        format!("{}, *α* = {sign}{}", self.name(), super::compose::number(magnitude, 4))
    }
}

/// Equal supports with their modes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Setting {
    pub(super) symmetric: Symmetric,
    pub(super) modes: Modes,
}

impl Setting {
    /// # Errors
    /// Unequal supports, as a [`FigureError`].
    pub(super) fn of(parameters: &Parameters) -> Result<Self, FigureError> {
        let symmetric = parameters.symmetric()?;
        Ok(Self { symmetric, modes: Modes::of(&symmetric)? })
    }

    /// The same with `|alpha|` of these supports' sign.
    pub(super) fn with(&self, supports: Supports) -> Self {
        let alpha = supports.sign() * self.symmetric.alpha.abs();
        Self { symmetric: Symmetric { alpha, ..self.symmetric }, ..*self }
    }

    /// The same at another mesh frequency.
    pub(super) fn at(&self, omega: f64) -> Symmetric {
        Symmetric { omega, ..self.symmetric }
    }

    /// The paper's `alpha`, where it is a finite number other than zero.
    pub(super) fn paper_alpha(&self) -> Option<f64> {
        let alpha = self.symmetric.alpha / self.symmetric.k0;
        (alpha.is_finite() && alpha != 0.0).then_some(alpha)
    }
}

/// Both signs of a root that leaves zero at `edge` and is followed to `end`: from the one end through the edge to
/// the other.
pub(super) fn parabola(edge: f64, end: f64, radius: impl Fn(f64) -> Option<f64>) -> Vec<(f64, f64)> {
    let half = half_parabola(edge, end, radius);
    half.iter().rev().map(|&(x, y)| (x, -y)).chain(half.iter().skip(1).copied()).collect()
}

/// A root that leaves zero at `edge`, followed to `end`.
pub(super) fn half_parabola(edge: f64, end: f64, radius: impl Fn(f64) -> Option<f64>) -> Vec<(f64, f64)> {
    let rest = crowded(edge, end, CURVE).skip(1).filter_map(|x| Some((x, radius(x)?)));
    std::iter::once((edge, 0.0)).chain(rest).collect()
}

/// The origin along an axis: stable outside the edges, unstable between them; without edges stable everywhere.
pub(super) fn origin(
    (low, high): (f64, f64),
    edges: Option<(f64, f64)>,
    name: &str,
    role: Role,
) -> Vec<(Line, Points)> {
    let line = |stable: bool| {
        let word = if stable { "stable" } else { "unstable" };
        Line::new(format!("{name} {word}"), format!("the origin, {word}"), role).stable(stable)
    };
    let mut outside = Points::default();
    let Some((left, right)) = edges else {
        outside.piece([(low, 0.0), (high, 0.0)]);
        return vec![(line(true), outside)];
    };
    if low < left {
        outside.piece([(low, 0.0), (left, 0.0)]);
    }
    if right < high {
        outside.piece([(right, 0.0), (high, 0.0)]);
    }
    let inside = Points::plane([(left, 0.0), (right, 0.0)]);
    vec![(line(true), outside), (line(false), inside)]
}

/// Ends of an axis that must hold `reach` on either side of zero: never empty.
pub(super) fn about_zero(reach: f64) -> (f64, f64) {
    let reach = if reach.is_finite() && reach > 1e-9 { reach } else { 1.0 };
    (-reach, reach)
}

/// Splits a sampled curve where a condition changes, so that pieces for either answer meet at the sample between.
pub(super) fn split(points: &[(f64, f64)], good: impl Fn(usize) -> bool) -> [Points; 2] {
    let mut parts = [Points::default(), Points::default()];
    let mut start = 0;
    while start < points.len() {
        let answer = good(start);
        let end = (start..points.len()).find(|&index| good(index) != answer).unwrap_or(points.len());
        // The piece reaches to the first point of the next, so that no gap is seen.
        let last = (end + 1).min(points.len());
        parts[usize::from(!answer)].piece(points[start..last].iter().copied());
        start = end;
    }
    parts
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_parabola_passes_through_its_edge_and_both_ends() {
        let curve = parabola(1.0, 5.0, |x| Some((x - 1.0).sqrt()));
        assert_eq!(curve.first(), Some(&(5.0, -2.0)));
        assert_eq!(curve.last(), Some(&(5.0, 2.0)));
        assert_eq!(curve[CURVE - 1], (1.0, 0.0));
        // Steps in y are even, so the tip is as smooth as the rest.
        assert!((curve[CURVE].1 - 2.0 / (CURVE - 1) as f64).abs() < 1e-12);
    }

    #[test]
    fn the_parts_of_a_split_curve_meet() {
        let points: Vec<(f64, f64)> = (0..6).map(|n| (f64::from(n), 0.0)).collect();
        let [good, bad] = split(&points, |index| !(2..=3).contains(&index));
        assert_eq!((good.x, good.pieces), (vec![0.0, 1.0, 2.0, 4.0, 5.0], vec![0, 3]));
        assert_eq!(bad.x, vec![2.0, 3.0, 4.0]);
    }

    #[test]
    fn the_origin_is_whole_where_there_are_no_edges() {
        assert_eq!(origin((-1.0, 1.0), None, "origin", Role::Paper).len(), 1);
        let parts = origin((-1.0, 1.0), Some((-0.5, 0.25)), "origin", Role::Paper);
        assert_eq!(parts[0].1.x, vec![-1.0, -0.5, 0.25, 1.0]);
        assert_eq!(parts[1].1.x, vec![-0.5, 0.25]);
    }
}
