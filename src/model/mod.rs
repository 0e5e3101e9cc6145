//! The gear pair: its parameters, its units, its equations of motion.

mod coefficients;
pub mod equations;
pub mod lanes;
pub mod linear;
pub mod manifold;
pub mod parameters;
pub mod physical;
pub mod variational;
