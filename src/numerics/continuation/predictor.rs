//! Where the next point of a branch will be: a polynomial through the last ones.

use super::{Scaled, dot, unit};

/// Most points that a prediction uses: degree 7. Measured on the branch of tongue 2, that takes a quarter less work
/// than degree 5; each further degree doubles the rounding of the points.
pub const MOST: usize = 8;
/// Fewest points that a polynomial is led through; with fewer, tangents count.
pub const FEWEST: usize = 4;

/// A point as the predictor sees it: arclength, place and unit tangent.
pub type Knot = (f64, Scaled, Scaled);

/// The place at an arclength, on the polynomial through the given points (Lagrange); with fewer than four of them the
/// tangents of the last two count as well (Hermite).
///
/// The points need not be in order, and the arclength may lie between them or beyond.
pub fn place(knots: &[Knot], arc: f64) -> Scaled {
    match knots {
        [] => [0.0; 7],
        [(start, at, tangent)] => std::array::from_fn(|i| at[i] + (arc - start) * tangent[i]),
        [.., before, last] if knots.len() < FEWEST => hermite(before, last, arc),
        _ => {
            let mut sum = [0.0; 7];
            for (index, (here, at, _)) in knots.iter().enumerate() {
                let mut weight = 1.0;
                for (other, (there, _, _)) in knots.iter().enumerate() {
                    if other != index {
                        weight *= (arc - there) / (here - there);
                    }
                }
                for (sum, value) in sum.iter_mut().zip(at) {
                    *sum += weight * value;
                }
            }
            sum
        }
    }
}

/// The unit tangent at an arclength of the polynomial through at least four points; none with fewer.
pub fn direction(knots: &[Knot], arc: f64) -> Option<Scaled> {
    if knots.len() < FEWEST {
        return None;
    }
    let mut sum = [0.0; 7];
    for (index, (here, at, _)) in knots.iter().enumerate() {
        let (mut weight, mut slope) = (1.0, 0.0);
        for (other, (there, ..)) in knots.iter().enumerate() {
            if other != index {
                let factor = 1.0 / (here - there);
                slope = (slope * (arc - there) + weight) * factor;
                weight *= (arc - there) * factor;
            }
        }
        for (sum, value) in sum.iter_mut().zip(at) {
            *sum += slope * value;
        }
    }
    Some(unit(&sum))
}

/// The cubic with these places and tangents at both points.
pub fn hermite(from: &Knot, to: &Knot, arc: f64) -> Scaled {
    let length = to.0 - from.0;
    let s = (arc - from.0) / length;
    let (h00, h10) = ((1.0 + 2.0 * s) * (1.0 - s) * (1.0 - s), s * (1.0 - s) * (1.0 - s));
    let (h01, h11) = (s * s * (3.0 - 2.0 * s), s * s * (s - 1.0));
    std::array::from_fn(|i| h00 * from.1[i] + h01 * to.1[i] + length * (h10 * from.2[i] + h11 * to.2[i]))
}

/// The length of the branch between two points: the chord, lengthened as a circle's arc is by the angle between the
/// tangents, so that a polynomial in the sum of these lengths is as good as one in the true arclength.
pub fn length(chord: f64, tangents: (&Scaled, &Scaled)) -> f64 {
    let cosine = dot(tangents.0, tangents.1).clamp(-1.0, 1.0);
    let half = 0.5 * cosine.acos();
    if half < 1e-8 { chord } else { chord * half / half.sin() }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn on_circle(angle: f64) -> Knot {
        let (sine, cosine) = angle.sin_cos();
        let mut at = [0.0; 7];
        let mut tangent = [0.0; 7];
        (at[0], at[6], tangent[0], tangent[6]) = (cosine, sine, -sine, cosine);
        (angle, at, tangent)
    }

    #[test]
    fn six_points_of_a_circle_predict_the_seventh_to_the_sixth_power_of_the_step() {
        let error = |step: f64| {
            let knots: Vec<Knot> = (0..6).map(|n| on_circle(step * f64::from(n))).collect();
            let predicted = place(&knots, 6.0 * step);
            let (_, at, _) = on_circle(6.0 * step);
            super::super::norm(&super::super::minus(&predicted, &at))
        };
        assert!(error(0.1) < 2e-6);
        let order = (error(0.2) / error(0.1)).log2();
        assert!((order - 6.0).abs() < 0.3, "{order}");
    }

    #[test]
    fn lengths_of_arcs_are_those_of_a_circle() {
        let (from, to) = (on_circle(0.2), on_circle(0.9));
        let chord = super::super::norm(&super::super::minus(&from.1, &to.1));
        assert!((length(chord, (&from.2, &to.2)) - 0.7).abs() < 1e-14);
    }
}
