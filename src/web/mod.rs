//! The boundary to JavaScript: plain objects in, plain objects with `Float64Array` columns out.
//!
//! Thin on purpose. Each export reads and checks what it is given, asks one of the layers below, and writes the answer
//! down; `docs/api.md` is its contract and `www/engine/gear-bifurcations.js` its other half.
//!
//! | file | what it does |
//! |---|---|
//! | `values`, `options` | read whatever comes from JavaScript: names, types, ranges, sizes, before anything is done |
//! | `columns` | write results; no number that is not finite gets past it |
//! | `errors` | the one place where a typed error becomes a `GearError` |
//! | `theory`, `study`, `linear`, `branches`, `attractors`, `physical`, `figure`, `draw` | the calls |
//! | `drawing`, `part`, `vocabulary` | figures as plain objects, there and back |
//! | `canvas`, `surface` | the drawing surface over a canvas; one surface for canvas and SVG |
//! | `bench` | what measurements and the test of a trap need |

pub mod attractors;
pub mod bench;
pub mod branches;
pub mod canvas;
mod columns;
pub mod draw;
mod drawing;
pub mod errors;
pub mod figure;
pub mod linear;
mod options;
mod part;
pub mod physical;
pub mod study;
mod surface;
pub mod theory;
mod values;
mod vocabulary;
