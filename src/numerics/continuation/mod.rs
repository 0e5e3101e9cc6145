//! Curves of solutions followed through their folds.

pub mod two_parameter;
