//! The boundary to JavaScript.

pub mod canvas;
