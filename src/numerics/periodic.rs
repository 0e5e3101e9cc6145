//! Periodic orbits of a periodically forced system of six coordinates, as fixed points of a stroboscopic map.

use nalgebra::{SMatrix, SVector};

use super::newton::{self, Linearised, Solution};
use crate::error::NumericsError;

/// A state and the derivative of the map there, by rows.
pub type Image = ([f64; 6], [[f64; 6]; 6]);

/// Finds a fixed point of `map` near `guess`; `map` gives the image of a state and the derivative of the image by it.
///
/// # Errors
/// As [`newton::solve`].
pub fn fixed_point(
    guess: [f64; 6],
    options: newton::Options,
    mut map: impl FnMut(&[f64; 6]) -> Result<Image, NumericsError>,
) -> Result<Solution, NumericsError> {
    newton::solve(guess, options, |state| {
        let (image, derivative) = map(state)?;
        Ok(Linearised {
            residual: SVector::<f64, 6>::from(image) - SVector::<f64, 6>::from(*state),
            jacobian: matrix(&derivative) - SMatrix::<f64, 6, 6>::identity(),
        })
    })
}

/// Newton's correction of a state towards a fixed point, to be taken off it; none where the derivative of the map has a
/// multiplier of one.
pub fn correction(state: &[f64; 6], (image, derivative): &Image) -> Option<[f64; 6]> {
    let residual = SVector::<f64, 6>::from(*image) - SVector::<f64, 6>::from(*state);
    (matrix(derivative) - SMatrix::<f64, 6, 6>::identity()).lu().solve(&residual).map(Into::into)
}

/// A matrix from its rows.
pub fn matrix(rows: &[[f64; 6]; 6]) -> SMatrix<f64, 6, 6> {
    SMatrix::from_fn(|row, column| rows[row][column])
}
