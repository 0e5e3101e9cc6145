//! The paper's figures: a number and parameters to a drawing, its words and how it was made.
//!
//! [`specifications`] says what there is; [`figure`] computes one at once, a [`Job`] step by step. Every number in a
//! drawing is finite, whatever the parameters within their ranges.

mod compose;
mod determinant;
mod eigenvalues;
mod exponents;
mod exponents_picture;
mod gearing;
mod hopf;
mod job;
mod overall;
mod pitchfork;
mod poincare_map;
mod response;
mod schematic;
mod specification;
mod tongues;

pub use job::{Figure, Job, Motion, at_time, figure};
pub use specification::{Preset, Specification, specification, specifications};
