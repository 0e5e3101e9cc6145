//! The bar of colours beside a plot, which says what the shades of its fields stand for.

use super::drawing::Axis;
use super::geometry::Rect;
use super::layout::{Panel, TICK, TICK_GAP};
use super::metrics::{CAPITAL_HEIGHT, Face};
use super::painter::{Align, Painter};
use super::ramp::{SHADES, shade};
use super::surface::Surface;
use super::text::{Label, set};
use super::theme::Theme;
use super::ticks::{Ticks, ticks};
use crate::error::ChartError;

/// Between the plot and the bar, CSS pixels.
const GAP: f64 = 12.0;
/// Width of the bar, CSS pixels.
const WIDTH: f64 = 11.0;
/// Between its numbers and its label, CSS pixels.
const LABEL_GAP: f64 = 4.0;

/// A bar with its words.
#[derive(Clone, Debug, PartialEq)]
pub struct Bar {
    low: f64,
    high: f64,
    ticks: Ticks,
    label: Label,
    numbers: f64,
}

impl Bar {
    /// The bar of a scale, beside a plot of this height.
    pub fn new(axis: &Axis, height: f64, tick: f64, label: f64) -> Self {
        let most = (height / (3.2 * tick)) as usize;
        let ticks = ticks(axis.low, axis.high, most.clamp(2, 6));
        let numbers =
            ticks.labels.iter().map(|text| set(text, tick, Face::Regular).width).fold(0.0, f64::max);
        Self { low: axis.low, high: axis.high, ticks, label: set(&axis.label, label, Face::Regular), numbers }
    }

    /// The same with another sign before the decimals of its numbers.
    #[must_use]
    pub fn written_with(self, decimal: char) -> Self {
        Self { ticks: self.ticks.written_with(decimal), ..self }
    }

    /// How much room it takes beside the plot, CSS pixels.
    pub fn room(&self) -> f64 {
        GAP + WIDTH + TICK + TICK_GAP + self.numbers + LABEL_GAP + self.label.height()
    }
}

/// Draws the bar beside the plot of its panel.
///
/// # Errors
/// What the backend fails with.
pub fn draw_bar<S: Surface>(
    painter: &mut Painter<'_, S>,
    bar: &Bar,
    panel: &Panel,
    theme: &Theme,
) -> Result<(), ChartError> {
    let plot = panel.plot;
    let whole = Rect { left: plot.right + GAP, right: plot.right + GAP + WIDTH, ..plot };
    let step = whole.height() / SHADES as f64;
    for index in 0..SHADES {
        // A little over the next: no seam is seen between two shades.
        let bottom = whole.bottom - index as f64 * step;
        let top = (bottom - step - if index + 1 < SHADES { 0.5 } else { 0.0 }).max(whole.top);
        painter.rectangle(&Rect { top, bottom, ..whole }, shade(theme, index), 1.0)?;
    }
    let corners = [
        [whole.left, whole.top],
        [whole.right, whole.top],
        [whole.right, whole.bottom],
        [whole.left, whole.bottom],
        [whole.left, whole.top],
    ];
    painter.strokes(&[corners.to_vec()], theme.axis, 0.8 * theme.lines, 1.0)?;
    let size = panel.sizes.tick;
    let cap = CAPITAL_HEIGHT * size;
    let mut lines = Vec::new();
    for (&value, text) in bar.ticks.values.iter().zip(&bar.ticks.labels) {
        let y = whole.bottom - (value - bar.low) / (bar.high - bar.low) * whole.height();
        let y = y.floor() + 0.5;
        lines.push(vec![[whole.right, y], [whole.right + TICK, y]]);
        let at = [whole.right + TICK + TICK_GAP, y + cap / 2.0];
        painter.label(&set(text, size, Face::Regular), at, Align::Left, theme.quiet, None)?;
    }
    painter.strokes(&lines, theme.axis, theme.lines, 1.0)?;
    if bar.ticks.exponent != 0 {
        let factor = set(&format!("×10^{{{}}}", bar.ticks.exponent), size, Face::Regular);
        painter.label(&factor, [whole.left, whole.top - 5.0], Align::Left, theme.quiet, None)?;
    }
    let left = whole.right + TICK + TICK_GAP + bar.numbers + LABEL_GAP;
    let at = [left + bar.label.ascent, whole.center()[1]];
    painter.label_upwards(&bar.label, at, Align::Middle, theme.ink)
}
