//! Discrete Fourier transform of any length and amplitude spectra.

use std::f64::consts::{PI, TAU};

/// What a series is multiplied with before its transform.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Window {
    /// Nothing: exact where a whole number of periods fits the series.
    Rectangular,
    /// Four-term Blackman-Harris: other frequencies leak by less than -92 dB; a frequency between two lines shows at
    /// 0.91 of its amplitude at least. F. J. Harris, Proceedings of the IEEE 66 (1978) 51-83, doi 10.1109/PROC.1978.10837.
    BlackmanHarris,
}

impl Window {
    /// Its name, for methods in words.
    pub fn name(self) -> &'static str {
        match self {
            Self::Rectangular => "rectangular",
            Self::BlackmanHarris => "Blackman-Harris",
        }
    }

    fn value(self, index: usize, count: usize) -> f64 {
        match self {
            Self::Rectangular => 1.0,
            Self::BlackmanHarris => {
                let angle = TAU * index as f64 / count as f64;
                0.35875 - 0.48829 * angle.cos() + 0.14128 * (2.0 * angle).cos()
                    - 0.01168 * (3.0 * angle).cos()
            }
        }
    }
}

/// Amplitudes of the lines 0 to `count/2` of an evenly sampled series: the mean's own value first, then the amplitude of
/// the cosine of each frequency, in cycles over the length of the series.
pub fn amplitudes(series: &[f64], window: Window) -> Vec<f64> {
    let count = series.len();
    if count == 0 {
        return Vec::new();
    }
    let mut weight = 0.0;
    let mut re: Vec<f64> = series
        .iter()
        .enumerate()
        .map(|(index, value)| {
            let factor = window.value(index, count);
            weight += factor;
            value * factor
        })
        .collect();
    let mut im = vec![0.0; count];
    transform(&mut re, &mut im);
    (0..=count / 2)
        .map(|line| {
            // The line at half the sampling frequency, like the mean, has no mirror image.
            let sides = if line == 0 || 2 * line == count { 1.0 } else { 2.0 };
            sides * re[line].hypot(im[line]) / weight
        })
        .collect()
}

/// The discrete Fourier transform with `exp(-2 pi i j k / n)`, in place; real and imaginary parts have the same length,
/// which may be any.
pub fn transform(re: &mut [f64], im: &mut [f64]) {
    let count = re.len();
    if count.is_power_of_two() {
        radix_2(re, im);
    } else if count > 1 {
        bluestein(re, im);
    }
}

/// J. W. Cooley, J. W. Tukey, Mathematics of Computation 19 (1965) 297-301, doi 10.1090/S0025-5718-1965-0178586-1.
fn radix_2(re: &mut [f64], im: &mut [f64]) {
    let count = re.len();
    let mut reversed = 0;
    for index in 1..count {
        let mut bit = count >> 1;
        while reversed & bit != 0 {
            reversed ^= bit;
            bit >>= 1;
        }
        reversed |= bit;
        if index < reversed {
            re.swap(index, reversed);
            im.swap(index, reversed);
        }
    }
    let turns: Vec<(f64, f64)> = (0..count / 2).map(|k| (TAU * k as f64 / count as f64).sin_cos()).collect();
    let mut length = 2;
    while length <= count {
        let (half, stride) = (length / 2, count / length);
        for start in (0..count).step_by(length) {
            for k in 0..half {
                let (sine, cosine) = turns[k * stride];
                let (low, high) = (start + k, start + k + half);
                let turned = (re[high] * cosine + im[high] * sine, im[high] * cosine - re[high] * sine);
                (re[high], im[high]) = (re[low] - turned.0, im[low] - turned.1);
                (re[low], im[low]) = (re[low] + turned.0, im[low] + turned.1);
            }
        }
        length *= 2;
    }
}

/// Any length as a convolution of a length that is a power of two: L. I. Bluestein, IEEE Transactions on Audio and
/// Electroacoustics 18 (1970) 451-455, doi 10.1109/TAU.1970.1162132.
fn bluestein(re: &mut [f64], im: &mut [f64]) {
    let count = re.len();
    let padded = (2 * count - 1).next_power_of_two();
    // exp(-pi i k^2 / n), with k^2 reduced by whole turns before it loses digits.
    let chirp: Vec<(f64, f64)> = (0..count as u64)
        .map(|k| {
            let angle = PI * (k * k % (2 * count as u64)) as f64 / count as f64;
            (angle.cos(), -angle.sin())
        })
        .collect();
    let (mut left_re, mut left_im) = (vec![0.0; padded], vec![0.0; padded]);
    let (mut right_re, mut right_im) = (vec![0.0; padded], vec![0.0; padded]);
    for (k, &(cosine, sine)) in chirp.iter().enumerate() {
        left_re[k] = re[k] * cosine - im[k] * sine;
        left_im[k] = re[k] * sine + im[k] * cosine;
        for place in [k, (padded - k) % padded] {
            right_re[place] = cosine;
            right_im[place] = -sine;
        }
    }
    radix_2(&mut left_re, &mut left_im);
    radix_2(&mut right_re, &mut right_im);
    for k in 0..padded {
        let product = (
            left_re[k] * right_re[k] - left_im[k] * right_im[k],
            left_re[k] * right_im[k] + left_im[k] * right_re[k],
        );
        // Conjugated, so that the forward transform does the inverse one's work.
        (left_re[k], left_im[k]) = (product.0, -product.1);
    }
    radix_2(&mut left_re, &mut left_im);
    for (k, &(cosine, sine)) in chirp.iter().enumerate() {
        let (value_re, value_im) = (left_re[k] / padded as f64, -left_im[k] / padded as f64);
        re[k] = value_re * cosine - value_im * sine;
        im[k] = value_re * sine + value_im * cosine;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn any_length_agrees_with_the_sum_itself() {
        for count in [1_usize, 2, 3, 8, 12, 35, 64, 97] {
            let start = |k: usize, phase: f64| (1.3 * k as f64 + phase).sin() + 0.1 * k as f64;
            let mut re: Vec<f64> = (0..count).map(|k| start(k, 0.0)).collect();
            let mut im: Vec<f64> = (0..count).map(|k| start(k, 2.0)).collect();
            let (given_re, given_im) = (re.clone(), im.clone());
            transform(&mut re, &mut im);
            for line in 0..count {
                let (mut sum_re, mut sum_im) = (0.0, 0.0);
                for k in 0..count {
                    let (sine, cosine) = (TAU * (line * k % count) as f64 / count as f64).sin_cos();
                    sum_re += given_re[k] * cosine + given_im[k] * sine;
                    sum_im += given_im[k] * cosine - given_re[k] * sine;
                }
                let distance = (re[line] - sum_re).hypot(im[line] - sum_im);
                assert!(distance < 1e-11, "{count} {line}: {distance}");
            }
        }
    }

    #[test]
    fn amplitudes_are_those_of_the_cosines() {
        let count = 600;
        let series: Vec<f64> = (0..count)
            .map(|n| {
                let angle = TAU * f64::from(n) / f64::from(count);
                2.0 + 0.5 * (7.0 * angle + 0.3).cos() + 0.25 * (40.0 * angle).sin()
            })
            .collect();
        for (window, width) in [(Window::Rectangular, 0), (Window::BlackmanHarris, 3)] {
            let found = amplitudes(&series, window);
            assert!((found[0] - 2.0).abs() < 1e-12 && (found[7] - 0.5).abs() < 1e-12, "{window:?}");
            assert!((found[40] - 0.25).abs() < 1e-12);
            assert!(found[12 + width..37].iter().all(|amplitude| *amplitude < 1e-4));
        }
    }
}
