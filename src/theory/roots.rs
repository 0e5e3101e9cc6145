//! The theory's own root finders, so that it shares nothing with the numerics it is compared with.

/// Root between two points where the function has opposite signs, by Ridders' method: each step fits an exponential
/// through the ends and the middle, and the bracket at least halves.
pub(super) fn ridders(function: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    let (mut at_low, mut at_high) = (function(low), function(high));
    let mut best = 0.5 * (low + high);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        let at_middle = function(middle);
        let root = (at_middle * at_middle - at_low * at_high).sqrt();
        if root == 0.0 {
            return middle;
        }
        let candidate = middle + (middle - low) * (at_low - at_high).signum() * at_middle / root;
        let at_candidate = function(candidate);
        let settled = (candidate - best).abs() <= 2.0 * f64::EPSILON * candidate.abs();
        best = candidate;
        if at_candidate == 0.0 || settled {
            return best;
        }
        if at_middle.signum() != at_candidate.signum() {
            (low, at_low, high, at_high) = (middle, at_middle, candidate, at_candidate);
        } else if at_low.signum() == at_candidate.signum() {
            (low, at_low) = (candidate, at_candidate);
        } else {
            (high, at_high) = (candidate, at_candidate);
        }
        if (high - low).abs() <= 2.0 * f64::EPSILON * best.abs() {
            return best;
        }
    }
    best
}

/// Real roots, in rising order, of the polynomial with these coefficients, the constant first and the last not zero.
///
/// Between two neighbouring roots of its derivative a polynomial has at most one root, which a bracket cannot miss;
/// a double root, where it only touches zero, is found only if rounding leaves it one.
pub(super) fn real_roots(coefficients: &[f64]) -> Vec<f64> {
    let degree = coefficients.len().saturating_sub(1);
    if degree == 0 {
        return Vec::new();
    }
    let leading = coefficients[degree];
    if degree == 1 {
        return vec![-coefficients[0] / leading];
    }
    let value = |z: f64| coefficients.iter().rev().fold(0.0, |sum, coefficient| sum * z + coefficient);
    let derivative: Vec<f64> = coefficients
        .iter()
        .enumerate()
        .skip(1)
        .map(|(power, coefficient)| power as f64 * coefficient)
        .collect();
    // Cauchy's bound on the size of all roots.
    let bound = 1.0 + coefficients[..degree].iter().map(|c| (c / leading).abs()).fold(0.0, f64::max);
    let mut ends = vec![-bound];
    ends.extend(real_roots(&derivative));
    ends.push(bound);
    let mut roots: Vec<f64> = Vec::with_capacity(degree);
    for pair in ends.windows(2) {
        let (left, right) = (value(pair[0]), value(pair[1]));
        if left == 0.0 {
            roots.push(pair[0]);
        } else if left.signum() != right.signum() && right != 0.0 {
            roots.push(ridders(value, pair[0], pair[1]));
        }
    }
    roots.dedup();
    roots
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ridders_finds_a_root_to_the_last_digits() {
        let root = ridders(|x| x.cos() - x, 0.0, 1.0);
        assert!((root - 0.739_085_133_215_160_6).abs() <= 2.0 * f64::EPSILON, "{root}");
        assert!((ridders(|x| (x - 0.3).powi(5), -4.0, 3.0) - 0.3).abs() < 1e-3);
    }

    #[test]
    fn real_roots_are_all_found_and_no_others() {
        // (z - 1)(z + 2)(z - 3)(z + 4)
        let roots = real_roots(&[24.0, -14.0, -13.0, 2.0, 1.0]);
        assert_eq!(roots.len(), 4);
        for (root, expected) in roots.into_iter().zip([-4.0, -2.0, 1.0, 3.0]) {
            assert!((root - expected).abs() < 1e-14, "{root}");
        }
        // z^4 - 1, whose companion matrix turns in circles under QR.
        assert_eq!(real_roots(&[-1.0, 0.0, 0.0, 0.0, 1.0]), [-1.0, 1.0]);
        assert!(real_roots(&[1.0, 0.0, 1.0]).is_empty());
        assert_eq!(real_roots(&[2.0]), []);
    }
}
