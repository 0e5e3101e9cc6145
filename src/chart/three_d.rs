//! 3-D frames: an orthographic view of a box with axes on its outer edges and a grid on its far walls.

use super::axes::{AXIS_WIDTH, GRID_WIDTH};
use super::drawing::{Axis, Frame};
use super::geometry::Rect;
use super::layout::{Panel, TICK};
use super::metrics::Face;
use super::painter::{Align, Painter};
use super::surface::Surface;
use super::text::{Label, set};
use super::theme::Theme;
use super::ticks::{Ticks, ticks};
use super::view::View;
use crate::error::ChartError;

/// Sides of the box along its three axes, relative to one another.
const SIDES: [f64; 3] = [1.25, 1.0, 0.85];
/// Between the end of a tick and its number, CSS pixels.
const GAP: f64 = 3.0;

/// The map from data to pixels of a 3-D frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Projection {
    /// Pixel right and down: `P (x, y, z, 1)`.
    pub rows: [[f64; 4]; 2],
    /// Depth towards the reader, the same way: greater is nearer.
    pub depth: [f64; 4],
    /// Direction towards the reader along the three axes.
    toward: [f64; 3],
    /// Least and greatest data along the three axes.
    low: [f64; 3],
    high: [f64; 3],
}

impl Projection {
    /// The view of a frame in a plot's rectangle. The scale depends on the elevation alone: the box does not breathe as it is turned.
    pub fn new(axes: [&Axis; 3], plot: &Rect, size: f64, view: &View) -> Self {
        let azimuth = view.azimuth.rem_euclid(std::f64::consts::TAU);
        let elevation = view.elevation.clamp(-std::f64::consts::FRAC_PI_2, std::f64::consts::FRAC_PI_2);
        let ((sin_a, cos_a), (sin_e, cos_e)) = (azimuth.sin_cos(), elevation.sin_cos());
        let right = [-sin_a, cos_a, 0.0];
        let up = [-sin_e * cos_a, -sin_e * sin_a, cos_e];
        let toward = [cos_e * cos_a, cos_e * sin_a, sin_e];
        let base = SIDES[0].hypot(SIDES[1]);
        let (wide, high) = (base, SIDES[2] * cos_e.abs() + base * sin_e.abs());
        // Room for numbers and names beside and under the box.
        let free = Rect {
            left: plot.left + 3.2 * size,
            top: plot.top + 0.5 * size,
            right: plot.right - 3.2 * size,
            bottom: plot.bottom - 3.0 * size,
        };
        let scale = (free.width() / wide).min(free.height() / high).max(10.0);
        let center = free.center();
        let (low, high) = (axes.map(|axis| axis.low), axes.map(|axis| axis.high));
        // One row: factor * direction . (side (value - middle) / (high - low)) + offset.
        let row = |direction: [f64; 3], factor: f64, offset: f64| {
            let mut row = [0.0, 0.0, 0.0, offset];
            for i in 0..3 {
                row[i] = factor * direction[i] * SIDES[i] / (high[i] - low[i]);
                row[3] -= row[i] * f64::midpoint(low[i], high[i]);
            }
            row
        };
        Self {
            rows: [row(right, scale, center[0]), row(up, -scale, center[1])],
            depth: row(toward, 1.0, 0.0),
            toward,
            low,
            high,
        }
    }

    /// The pixel of a triple of data.
    pub fn pixel(&self, point: &[f64; 3]) -> [f64; 2] {
        self.rows.map(|row| row[0] * point[0] + row[1] * point[1] + row[2] * point[2] + row[3])
    }

    /// The depth of a triple of data; greater is nearer to the reader.
    pub fn nearness(&self, point: &[f64; 3]) -> f64 {
        self.depth[0] * point[0] + self.depth[1] * point[1] + self.depth[2] * point[2] + self.depth[3]
    }

    /// Least and greatest data along the three axes.
    pub fn limits(&self) -> (&[f64; 3], &[f64; 3]) {
        (&self.low, &self.high)
    }

    /// The value at the near or the far wall across an axis.
    fn wall(&self, axis: usize, near: bool) -> f64 {
        if (self.toward[axis] > 0.0) == near { self.high[axis] } else { self.low[axis] }
    }
}

/// An edge that carries an axis: its two ends in data.
fn axis_edge(projection: &Projection, axis: usize) -> [[f64; 3]; 2] {
    let mut from = [0.0; 3];
    if axis == 2 {
        // Of the two upright edges of the outline, the one farther left.
        let corner =
            |x_near: bool| [projection.wall(0, x_near), projection.wall(1, !x_near), projection.low[2]];
        let (one, other) = (corner(true), corner(false));
        from = if projection.pixel(&one)[0] <= projection.pixel(&other)[0] { one } else { other };
    } else {
        // Along the floor, on the side where the outline is: near the reader from above, far from below.
        from[1 - axis] = projection.wall(1 - axis, projection.toward[2] >= 0.0);
        from[2] = projection.low[2];
    }
    let mut to = from;
    from[axis] = projection.low[axis];
    to[axis] = projection.high[axis];
    [from, to]
}

/// Draws title, walls, grid and axes of a 3-D frame.
///
/// # Errors
/// What the backend fails with.
pub fn draw_box<S: Surface>(
    painter: &mut Painter<'_, S>,
    frame: &Frame,
    panel: &Panel,
    projection: &Projection,
    theme: &Theme,
    decimal: char,
) -> Result<(), ChartError> {
    super::axes::draw_title(painter, panel, theme)?;
    let Some(third) = &frame.z else { return Ok(()) };
    let axes = [&frame.x, &frame.y, third];
    let found: [Ticks; 3] = std::array::from_fn(|i| {
        let [from, to] = axis_edge(projection, i).map(|end| projection.pixel(&end));
        // Numbers need their width along a level axis, their height along an upright one.
        let size = panel.sizes.tick;
        let room = ((to[0] - from[0]) / (3.6 * size)).hypot((to[1] - from[1]) / (2.2 * size));
        ticks(axes[i].low, axes[i].high, (room as usize).clamp(2, 6)).written_with(decimal)
    });
    draw_walls(painter, projection, &found, theme)?;
    let mut taken: Vec<Rect> = Vec::new();
    for i in 0..3 {
        draw_axis(painter, panel, projection, i, (axes[i], &found[i]), &mut taken, theme)?;
    }
    Ok(())
}

fn draw_walls<S: Surface>(
    painter: &mut Painter<'_, S>,
    projection: &Projection,
    found: &[Ticks; 3],
    theme: &Theme,
) -> Result<(), ChartError> {
    let mut lines: Vec<Vec<[f64; 2]>> = Vec::new();
    for across in 0..3 {
        let wall = projection.wall(across, false);
        let (one, other) = ((across + 1) % 3, (across + 2) % 3);
        for (along, fixed) in [(one, other), (other, one)] {
            let ends = [projection.low[fixed], projection.high[fixed]];
            for &value in found[fixed].values.iter().chain(&ends) {
                let mut from = [0.0; 3];
                (from[across], from[fixed], from[along]) = (wall, value, projection.low[along]);
                let mut to = from;
                to[along] = projection.high[along];
                lines.push(vec![projection.pixel(&from), projection.pixel(&to)]);
            }
        }
    }
    painter.strokes(&lines, theme.grid, GRID_WIDTH * theme.lines, 1.0)
}

fn draw_axis<S: Surface>(
    painter: &mut Painter<'_, S>,
    panel: &Panel,
    projection: &Projection,
    index: usize,
    (axis, found): (&Axis, &Ticks),
    taken: &mut Vec<Rect>,
    theme: &Theme,
) -> Result<(), ChartError> {
    let sizes = panel.sizes;
    let [low, high] = axis_edge(projection, index);
    let (from, to) = (projection.pixel(&low), projection.pixel(&high));
    let long = (to[0] - from[0]).hypot(to[1] - from[1]);
    let mut lines = vec![vec![from, to]];
    if long < 2.5 * sizes.tick {
        return painter.strokes(&lines, theme.axis, AXIS_WIDTH * theme.lines, 1.0);
    }
    let center =
        projection.pixel(&std::array::from_fn(|i| f64::midpoint(projection.low[i], projection.high[i])));
    let middle = [f64::midpoint(from[0], to[0]), f64::midpoint(from[1], to[1])];
    let mut out = [(to[1] - from[1]) / long, (from[0] - to[0]) / long];
    if out[0] * (middle[0] - center[0]) + out[1] * (middle[1] - center[1]) < 0.0 {
        out = out.map(|part| -part);
    }
    // The label's middle, so far out that its box clears a distance from the edge.
    let beyond = |at: [f64; 2], clear: f64, label: &Label| {
        let reach = clear + out[0].abs() * label.width / 2.0 + out[1].abs() * label.ascent / 2.0;
        [at[0] + out[0] * reach, at[1] + out[1] * reach]
    };
    let mut numbers = Vec::new();
    let mut depth: f64 = 0.0;
    for (&value, text) in found.values.iter().zip(&found.labels) {
        let mut point = low;
        point[index] = value;
        let at = projection.pixel(&point);
        lines.push(vec![at, [at[0] + TICK * out[0], at[1] + TICK * out[1]]]);
        let number = set(text, sizes.tick, Face::Regular);
        let place = beyond(at, TICK + GAP, &number);
        depth = depth.max(out[0].abs() * number.width + out[1].abs() * number.ascent);
        let area = Rect::around(place, number.width + 8.0, number.ascent + 2.0);
        if !taken.iter().any(|other| other.overlaps(&area)) {
            taken.push(area);
            numbers.push((number, place));
        }
    }
    painter.strokes(&lines, theme.axis, AXIS_WIDTH * theme.lines, 1.0)?;
    for (number, place) in &numbers {
        let baseline = [place[0], place[1] + number.ascent / 2.0];
        painter.label(number, baseline, Align::Middle, theme.quiet, None)?;
    }
    let factor = if found.exponent == 0 { String::new() } else { format!(" (10^{{{}}})", found.exponent) };
    let label = set(&format!("{}{factor}", axis.label), sizes.label, Face::Regular);
    let place = beyond(middle, TICK + GAP + depth + 5.0, &label);
    // Kept within the cell, and off the numbers of this and the other axes.
    let half = [label.width / 2.0, label.height() / 2.0];
    let kept = [
        place[0].min(panel.cell.right - half[0]).max(panel.cell.left + half[0]),
        place[1].min(panel.cell.bottom - half[1]).max(panel.cell.top + half[1]),
    ];
    taken.push(Rect::around(kept, label.width, label.height()));
    painter.label(&label, [kept[0], kept[1] + label.ascent / 2.0], Align::Middle, theme.ink, None)
}

#[cfg(test)]
mod tests {
    use super::{Axis, Projection, Rect, View};

    fn axis(low: f64, high: f64) -> Axis {
        Axis { name: String::new(), label: String::new(), low, high }
    }

    const PLOT: Rect = Rect { left: 0.0, top: 0.0, right: 400.0, bottom: 300.0 };

    fn seen(azimuth: f64, elevation: f64) -> Projection {
        let (x, y, z) = (axis(-1.0, 3.0), axis(0.0, 10.0), axis(-2.0, 2.0));
        Projection::new([&x, &y, &z], &PLOT, 12.0, &View { azimuth, elevation, ..View::default() })
    }

    #[test]
    fn the_middle_of_the_data_is_the_middle_of_the_plot() {
        let pixel = seen(0.7, 0.3).pixel(&[1.0, 5.0, 0.0]);
        // The box leaves room for words under it: its middle is a little higher than the plot's.
        assert!((pixel[0] - 200.0).abs() < 1e-9 && (pixel[1] - 135.0).abs() < 1e-9, "{pixel:?}");
    }

    #[test]
    fn the_third_axis_points_up_and_the_box_stays_within_the_plot() {
        for step in 0..60 {
            let view = seen(f64::from(step) * 0.37, f64::from(step) / 40.0 - 0.75);
            let (low, high) = (view.low, view.high);
            for corner in 0..8 {
                let point = std::array::from_fn(|i| if corner >> i & 1 == 1 { high[i] } else { low[i] });
                assert!(PLOT.holds_point(view.pixel(&point), 0.0));
            }
            assert!(view.pixel(&[0.0, 0.0, 2.0])[1] < view.pixel(&[0.0, 0.0, -2.0])[1]);
        }
    }

    #[test]
    fn from_the_default_view_the_first_axis_runs_right_and_the_second_away() {
        let view = View::default();
        let projection = seen(view.azimuth, view.elevation);
        assert!(projection.pixel(&[3.0, 0.0, 0.0])[0] > projection.pixel(&[-1.0, 0.0, 0.0])[0]);
        assert!(projection.nearness(&[0.0, 0.0, 0.0]) > projection.nearness(&[0.0, 10.0, 0.0]));
    }
}
