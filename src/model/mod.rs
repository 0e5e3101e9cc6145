//! The gear pair: its parameters, its units, its equations of motion.

pub mod parameters;
