//! The gear pair: its parameters, its units, its equations of motion.

pub mod angle;
mod coefficients;
pub mod equations;
pub mod lanes;
pub mod linear;
pub mod manifold;
pub mod parameters;
pub mod physical;
pub mod variational;
