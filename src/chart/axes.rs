//! Axes of a plane frame: grid, lines, ticks, numbers, labels and title.

use super::drawing::Frame;
use super::layout::{Panel, SideLabel, TICK, TICK_GAP, gap_under};
use super::metrics::{CAPITAL_HEIGHT, Face};
use super::painter::{Align, Painter};
use super::surface::Surface;
use super::text::set;
use super::theme::Theme;
use crate::error::ChartError;

/// Width of the lines of axes and ticks, CSS pixels.
pub const AXIS_WIDTH: f64 = 1.0;
/// Width of the lines of the grid, CSS pixels.
pub const GRID_WIDTH: f64 = 1.0;

/// Draws title, grid and axes of a plane frame.
///
/// # Errors
/// What the backend fails with.
pub fn draw_axes<S: Surface>(
    painter: &mut Painter<'_, S>,
    frame: &Frame,
    panel: &Panel,
    theme: &Theme,
) -> Result<(), ChartError> {
    draw_title(painter, panel, theme)?;
    if frame.bare {
        return Ok(());
    }
    let (map, plot, sizes) = (panel.map(frame), panel.plot, panel.sizes);
    // Lines lie on half pixels: one pixel wide they are sharp at any whole density.
    let snap = |pixel: f64| pixel.floor() + 0.5;
    let columns: Vec<f64> =
        panel.x_ticks.values.iter().map(|&value| snap(map.pixel(value, frame.y.low)[0])).collect();
    let rows: Vec<f64> =
        panel.y_ticks.values.iter().map(|&value| snap(map.pixel(frame.x.low, value)[1])).collect();
    let mut grid: Vec<Vec<[f64; 2]>> = Vec::new();
    grid.extend(
        columns.iter().filter(|&&x| x - plot.left > 1.5).map(|&x| vec![[x, plot.top], [x, plot.bottom]]),
    );
    grid.extend(
        rows.iter().filter(|&&y| plot.bottom - y > 1.5).map(|&y| vec![[plot.left, y], [plot.right, y]]),
    );
    painter.strokes(&grid, theme.grid, GRID_WIDTH * theme.lines, 1.0)?;
    let mut lines = vec![vec![[plot.left, plot.top], [plot.left, plot.bottom], [plot.right, plot.bottom]]];
    lines.extend(columns.iter().map(|&x| vec![[x, plot.bottom], [x, plot.bottom + TICK]]));
    lines.extend(rows.iter().map(|&y| vec![[plot.left, y], [plot.left - TICK, y]]));
    painter.strokes(&lines, theme.axis, AXIS_WIDTH * theme.lines, 1.0)?;

    let cap = CAPITAL_HEIGHT * sizes.tick;
    let number_line = plot.bottom + TICK + gap_under(sizes.tick) + cap + 1.0;
    for (&x, text) in columns.iter().zip(&panel.x_ticks.labels) {
        let number = set(text, sizes.tick, Face::Regular);
        // A minus sign hangs out to the left, so that the digits stand under their tick.
        let hang = if text.starts_with('\u{2212}') {
            set("\u{2212}", sizes.tick, Face::Regular).width / 4.0
        } else {
            0.0
        };
        painter.label(&number, [x - hang, number_line], Align::Middle, theme.quiet, None)?;
    }
    let mut last = f64::INFINITY;
    for (&y, text) in rows.iter().zip(&panel.y_ticks.labels) {
        // In a very low plot not every number finds its line.
        if last - y < sizes.tick {
            continue;
        }
        last = y;
        let number = set(text, sizes.tick, Face::Regular);
        let at = [plot.left - TICK - TICK_GAP, y + cap / 2.0];
        painter.label(&number, at, Align::Right, theme.quiet, None)?;
    }
    if panel.y_ticks.exponent != 0 {
        let factor = set(&format!("×10^{{{}}}", panel.y_ticks.exponent), sizes.tick, Face::Regular);
        painter.label(&factor, [plot.left, plot.top - 5.0], Align::Left, theme.quiet, None)?;
    }
    let label_line = number_line + 0.25 * sizes.tick + 5.0 + panel.x_label.ascent;
    if panel.x_ticks.exponent != 0 {
        let factor = set(&format!("×10^{{{}}}", panel.x_ticks.exponent), sizes.tick, Face::Regular);
        painter.label(&factor, [plot.right, label_line], Align::Right, theme.quiet, None)?;
    }
    let half = panel.x_label.width / 2.0;
    let (least, most) = (panel.cell.left + half, panel.cell.right - half);
    let middle = plot.center()[0].max(least).min(most.max(least));
    painter.label(&panel.x_label, [middle, label_line], Align::Middle, theme.ink, None)?;
    let center = plot.center()[1];
    match &panel.y_label {
        SideLabel::Upright(label) => {
            // Between two numbers, not beside one: the eye would read them as one word.
            let at = [panel.y_label_left, center + 0.3 * sizes.label];
            painter.label(label, at, Align::Left, theme.ink, None)
        }
        SideLabel::Upwards(label) => painter.label_upwards(
            label,
            [panel.y_label_left + label.ascent, center],
            Align::Middle,
            theme.ink,
        ),
    }
}

/// Draws the title of a frame at the upper left.
///
/// # Errors
/// What the backend fails with.
pub fn draw_title<S: Surface>(
    painter: &mut Painter<'_, S>,
    panel: &Panel,
    theme: &Theme,
) -> Result<(), ChartError> {
    let mut line_top = panel.cell.top;
    for line in &panel.title {
        painter.label(line, [panel.title_left, line_top + line.ascent], Align::Left, theme.ink, None)?;
        line_top += line.height() + 2.0;
    }
    Ok(())
}
