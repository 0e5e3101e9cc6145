//! The gear pair: its parameters, its units, its equations of motion.

pub mod equations;
pub mod linear;
pub mod manifold;
pub mod parameters;
pub mod physical;
pub mod variational;
