//! Gear pairs under parametric resonance: a nonlinear-dynamics paper made live.
//!
//! | module | what lives there |
//! |---|---|
//! | [`error`] | one error enum a layer, variants carry the numbers |
//! | [`order`] | sorting by a number |
//! | [`numerics`] | algorithms that know no gears: integrators, Floquet, periodic orbits |
//! | [`model`] | the gear pair: parameters, SI units, equations of motion |
//! | [`theory`] | the paper's formulas, as printed and corrected |
//! | [`study`] | a question asked of the model, answered in plain columns |
//! | [`chart`] | drawing on any plotters backend |
//! | [`figures`] | the paper's figures: number to parameters, studies and drawing |
//!
//! `web` (only for wasm32) is the boundary to JavaScript. `ARCHITECTURE.md` says who may import whom.

pub mod chart;
pub mod error;
pub mod figures;
pub mod model;
pub mod numerics;
pub mod order;
pub mod study;
pub mod theory;
#[cfg(target_arch = "wasm32")]
pub mod web;
