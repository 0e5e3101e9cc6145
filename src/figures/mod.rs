//! The paper's figures: a number and parameters to a drawing, its words and how it was made.

mod compose;
mod gearing;
mod job;
mod schematic;
mod specification;

pub use job::{Figure, Job, Motion, at_time, figure};
pub use specification::{Preset, Specification, specification, specifications};
