//! Lyapunov exponents: the growth of an orthonormal frame along a motion, which the variational equations carry on and
//! which is made orthonormal again after every step.
//!
//! Source: G. Benettin, L. Galgani, A. Giorgilli, J.-M. Strelcyn, Meccanica 15 (1980) 9-20, doi 10.1007/BF02128236.

use super::ode::taylor::{Options, Propagation, TaylorField};
use crate::error::NumericsError;

/// A motion together with a frame, row after row behind it: entry (row, column) at `N + N row + column`.
#[derive(Clone, Debug, PartialEq)]
pub struct Framed<const N: usize, const SIZE: usize> {
    /// Present time.
    pub time: f64,
    /// The state and the frame.
    pub all: [f64; SIZE],
    /// Steps taken so far.
    pub steps: usize,
}

impl<const N: usize, const SIZE: usize> Framed<N, SIZE> {
    /// Starts with the coordinate axes as the frame.
    pub fn new(time: f64, state: &[f64; N]) -> Self {
        let mut all = [0.0; SIZE];
        all[..N].copy_from_slice(state);
        for i in 0..N {
            all[N + (N + 1) * i] = 1.0;
        }
        Self { time, all, steps: 0 }
    }

    /// The state.
    pub fn state(&self) -> [f64; N] {
        let mut state = [0.0; N];
        state.copy_from_slice(&self.all[..N]);
        state
    }

    /// Puts the motion elsewhere, under the same frame.
    pub fn set_state(&mut self, state: &[f64; N]) {
        self.all[..N].copy_from_slice(state);
    }

    /// Goes on to `end` and gives the logarithms by which the axes of the frame have grown; `stay` is asked after every
    /// step whether the motion is still where the question makes sense.
    ///
    /// # Errors
    /// As [`Propagation::step`]; [`NumericsError::Escaped`] where `stay` says no.
    pub fn advance<F: TaylorField<SIZE>, const LEN: usize>(
        &mut self,
        field: &F,
        end: f64,
        options: Options,
        stay: &mut dyn FnMut(&[f64]) -> bool,
    ) -> Result<[f64; N], NumericsError> {
        let mut growth = [0.0; N];
        while self.time < end {
            if self.steps >= options.steps {
                return Err(NumericsError::TooManySteps { time: self.time, steps: self.steps });
            }
            let mut propagation = Propagation::<F, SIZE, LEN>::new(field, self.time, self.all, options);
            propagation.step(end)?;
            self.time = propagation.time();
            self.all = *propagation.state();
            self.steps += 1;
            if !stay(&self.all[..N]) {
                return Err(NumericsError::Escaped { time: self.time });
            }
            for (sum, part) in growth.iter_mut().zip(self.orthonormalise()) {
                *sum += part;
            }
        }
        Ok(growth)
    }

    /// Makes the columns of the frame orthonormal, in order, and gives the logarithms of their lengths. The modified
    /// Gram-Schmidt process is accurate enough here, because a step deforms the frame little.
    fn orthonormalise(&mut self) -> [f64; N] {
        orthonormalise(&mut self.all[N..], N)
    }
}

/// Makes the `N` columns of a matrix by rows orthonormal and gives the logarithms of the lengths divided out.
pub fn orthonormalise<const N: usize>(frame: &mut [f64], stride: usize) -> [f64; N] {
    let mut logarithms = [0.0; N];
    for column in 0..N {
        let length = (0..N).map(|row| frame[stride * row + column].powi(2)).sum::<f64>().sqrt();
        let length = length.max(f64::MIN_POSITIVE);
        logarithms[column] = length.ln();
        for row in 0..N {
            frame[stride * row + column] /= length;
        }
        for later in column + 1..N {
            let product: f64 =
                (0..N).map(|row| frame[stride * row + column] * frame[stride * row + later]).sum();
            for row in 0..N {
                frame[stride * row + later] -= product * frame[stride * row + column];
            }
        }
    }
    logarithms
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_of_a_triangular_frame_are_its_diagonal() {
        let mut frame = [2.0, 1.0, 5.0, 0.0, 3.0, 7.0, 0.0, 0.0, 0.5];
        let logarithms: [f64; 3] = orthonormalise(&mut frame, 3);
        for (found, expected) in logarithms.iter().zip([2.0_f64, 3.0, 0.5]) {
            assert!((found - expected.ln()).abs() < 1e-15);
        }
        for i in 0..9 {
            assert!((frame[i] - f64::from(u8::from(i % 4 == 0))).abs() < 1e-15);
        }
    }
}
