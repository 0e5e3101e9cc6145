//! Drawing of plain data on any plotters backend; knows no gears and no studies.
//!
//! | module | what it does |
//! |---|---|
//! | [`drawing`] | what is to be drawn, by its meaning |
//! | [`selection`] | what of it is shown: windows of its axes, series that are switched off |
//! | [`theme`], `palettes` | how each meaning looks |
//! | [`surface`], [`svg`](mod@svg) | what a backend must offer; the one that writes SVG |
//! | [`draw`](mod@draw), `layout`, `axes`, `series`, `three_d`, `labels`, `marks` | the picture and its parts |
//! | `field`, `ramp`, `bar`, `png` | fields as images, their colours, and the bar that explains them |
//! | [`clip`], [`decimate`], [`dash`], [`ticks`], [`text`], [`metrics`], [`cloud`] | what they compute with |

mod axes;
mod bar;
pub mod clip;
pub mod cloud;
pub mod dash;
pub mod decimate;
pub mod draw;
pub mod drawing;
mod field;
mod geometry;
mod labels;
mod layout;
mod marks;
pub mod metrics;
mod painter;
mod palettes;
mod png;
mod ramp;
pub mod selection;
mod series;
pub mod surface;
pub mod svg;
pub mod text;
pub mod theme;
mod three_d;
pub mod ticks;
pub mod view;

pub use draw::{FrameMap, draw, svg};
pub use drawing::{Axis, Drawing, Frame, Mark, Role, Series};
pub use layout::pleasant_height;
pub use selection::{Selection, Window};
pub use surface::Surface;
pub use svg::SvgSurface;
pub use theme::Theme;
pub use view::View;
