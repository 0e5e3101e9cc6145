//! Weighted Birkhoff averages: means along an orbit, with a weight that vanishes smoothly at both ends.
//!
//! Along a quasi-periodic orbit the plain mean of n points errs like 1/n; with the bump function as weight the error
//! falls faster than any power of n. Source: S. Das, Y. Saiki, E. Sander, J. A. Yorke, Quantitative quasiperiodicity,
//! Nonlinearity 30 (2017) 4111-4140, doi 10.1088/1361-6544/aa84c2, equations (3), (4).

use std::f64::consts::TAU;

/// Weights of `count` points, adding up to 1: `exp(-1/(t (1 - t)))` at `t = (n + 1)/(count + 1)`.
pub fn weights(count: usize) -> Vec<f64> {
    let mut weights: Vec<f64> = (0..count)
        .map(|n| {
            let t = (n + 1) as f64 / (count + 1) as f64;
            // The least exponent is 4, at the middle: without it, short orbits would lose nothing but scale.
            (4.0 - 1.0 / (t * (1.0 - t))).exp()
        })
        .collect();
    let sum: f64 = weights.iter().sum();
    for weight in &mut weights {
        *weight /= sum;
    }
    weights
}

/// The weighted mean of a series.
pub fn mean(series: &[f64], weights: &[f64]) -> f64 {
    series.iter().zip(weights).map(|(value, weight)| value * weight).sum()
}

/// The coefficient of `exp(2 pi i frequency n)` in a series, real and imaginary part: the weighted mean of the series
/// turned back by that frequency (cycles a sample).
pub fn coefficient(series: &[f64], weights: &[f64], frequency: f64) -> [f64; 2] {
    let mut sum = [0.0; 2];
    let (turn_sin, turn_cos) = (TAU * frequency).sin_cos();
    let (mut cosine, mut sine) = (1.0, 0.0);
    for (n, (value, weight)) in series.iter().zip(weights).enumerate() {
        // The recurrence drifts by a rounding a step: begin afresh now and then.
        if n % 64 == 0 {
            (sine, cosine) = (TAU * (frequency * n as f64).fract()).sin_cos();
        }
        sum[0] += weight * value * cosine;
        sum[1] -= weight * value * sine;
        (cosine, sine) = (cosine * turn_cos - sine * turn_sin, sine * turn_cos + cosine * turn_sin);
    }
    sum
}

/// The frequency near `guess`, in cycles a sample, at which [`coefficient`] is largest; looked for within one
/// resolution, `1/count`, of it.
///
/// Source of the idea, frequencies as maxima of a windowed Fourier integral: J. Laskar, Icarus 88 (1990) 266-291, doi
/// 10.1016/0019-1035(90)90084-M.
pub fn frequency(series: &[f64], weights: &[f64], guess: f64) -> f64 {
    let height = |frequency: f64| {
        let [re, im] = coefficient(series, weights, frequency);
        re * re + im * im
    };
    let resolution = 1.0 / series.len().max(1) as f64;
    let (mut low, mut high) = (guess - resolution, guess + resolution);
    // Golden section down to where the rounding of the height hides the maximum, then the slope's zero.
    let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
    let (mut left, mut right) = (high - golden * (high - low), low + golden * (high - low));
    let (mut at_left, mut at_right) = (height(left), height(right));
    while high - low > 1e-3 * resolution {
        if at_left > at_right {
            (high, right, at_right) = (right, left, at_left);
            left = high - golden * (high - low);
            at_left = height(left);
        } else {
            (low, left, at_left) = (left, right, at_right);
            right = low + golden * (high - low);
            at_right = height(right);
        }
    }
    let mut at = 0.5 * (low + high);
    for _ in 0..4 {
        let (slope, curvature) = slope_and_curvature(series, weights, at);
        let step = slope / curvature;
        if !(curvature < 0.0 && step.abs() < resolution) {
            break;
        }
        at -= step;
    }
    at
}

/// First and second derivative of the squared [`coefficient`] by the frequency.
fn slope_and_curvature(series: &[f64], weights: &[f64], frequency: f64) -> (f64, f64) {
    // The moments of the turned series in n about its middle: c, c', c'' up to powers of 2 pi i.
    let middle = 0.5 * series.len() as f64;
    let mut moments = [[0.0; 2]; 3];
    for (n, (value, weight)) in series.iter().zip(weights).enumerate() {
        let from_middle = n as f64 - middle;
        let (sine, cosine) = (TAU * (frequency * from_middle).fract()).sin_cos();
        let mut factor = weight * value;
        for moment in &mut moments {
            moment[0] += factor * cosine;
            moment[1] -= factor * sine;
            factor *= from_middle * TAU;
        }
    }
    let [c, first, second] = moments;
    // d/df c = -i first, d2/df2 c = -second.
    let slope = 2.0 * (c[0] * first[1] - c[1] * first[0]);
    let curvature = 2.0 * (first[0].powi(2) + first[1].powi(2)) - 2.0 * (c[0] * second[0] + c[1] * second[1]);
    (slope, curvature)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn signal(count: usize, rotation: f64) -> Vec<f64> {
        (0..count)
            .map(|n| {
                let angle = TAU * (rotation * n as f64 + 0.1);
                0.7 + angle.cos() + 0.2 * (2.0 * angle).sin() + 0.05 * (5.0 * angle).cos()
            })
            .collect()
    }

    #[test]
    fn mean_and_frequency_of_a_quasi_periodic_series_come_to_rounding() {
        let rotation = 0.229586235;
        let series = signal(4000, rotation);
        let weights = weights(series.len());
        assert!((mean(&series, &weights) - 0.7).abs() < 1e-14);
        let found = frequency(&series, &weights, rotation + 1e-4);
        assert!((found - rotation).abs() < 1e-14, "{found}");
        let [re, im] = coefficient(&series, &weights, 2.0 * rotation);
        assert!((re.hypot(im) - 0.1).abs() < 1e-13);
    }

    #[test]
    fn the_plain_mean_is_far_worse() {
        let series = signal(4000, 0.229586235);
        let plain: f64 = series.iter().sum::<f64>() / series.len() as f64;
        assert!((plain - 0.7).abs() > 1e-6);
    }
}
