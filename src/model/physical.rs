//! SI units.
