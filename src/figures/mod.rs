//! The paper's figures: a number and parameters to a drawing, its words and how it was made.
//!
//! [`specifications`] says what there is; [`figure`] computes one at once, a [`Job`] step by step. Every number in a
//! drawing is finite, whatever the parameters within their ranges.

mod basins;
mod beside;
mod branches;
mod compose;
mod determinant;
mod eigenvalues;
mod errata;
mod exact;
mod exact_cycles;
mod exact_exponents;
mod exact_map;
mod exact_pitchforks;
mod exponents;
mod exponents_picture;
mod gearing;
mod hopf;
mod job;
mod load;
mod loaded_stability;
mod multiplier_paths;
mod overall;
mod pitchfork;
mod poincare_map;
mod response;
mod schematic;
mod specification;
mod stability;
mod start;
mod sweep;
mod tongue_range;
mod tongues;
mod trajectory;
mod trajectory_map;
mod trajectory_spectrum;

pub use job::{Distance, Entry, Fact, Figure, Job, Motion, Orbits, Row, at_time, figure};
pub use specification::{Preset, Specification, specification, specifications};
pub use start::START;
