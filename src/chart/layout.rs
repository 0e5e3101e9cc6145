//! Where each frame's plot lies: cells of the grid, and margins as wide as the words in them need.

use super::bar::Bar;
use super::drawing::{Drawing, Frame};
use super::geometry::{PlaneMap, Rect};
use super::metrics::Face;
use super::svg::SIDES;
use super::text::{Label, set, set_lines};
use super::ticks::{Ticks, ticks};
use crate::order;

/// Length of tick marks, CSS pixels.
pub const TICK: f64 = 4.0;
/// Between a tick mark and its number, CSS pixels.
pub const TICK_GAP: f64 = 3.0;
/// Largest numbers at the axes but for themes of larger letters, CSS pixels.
const LARGEST_TICK: f64 = 13.0;

/// Between a tick mark and its number under it, CSS pixels: large numbers would meet in the corner of the two axes.
pub fn gap_under(size: f64) -> f64 {
    TICK_GAP * (size / LARGEST_TICK).max(1.0)
}
/// Between numbers and the label of the axis, CSS pixels.
const LABEL_GAP: f64 = 5.0;
/// At the edges of the picture, CSS pixels.
const EDGE: f64 = 4.0;
/// Narrowest cell that is still left beside another, CSS pixels.
const NARROW: f64 = 240.0;
/// Lowest row that still holds a plot with its words, CSS pixels.
const LOW: f64 = 130.0;
/// Width over height that suits a plot.
const PLEASANT: f64 = 1.45;

/// Font sizes in CSS pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sizes {
    /// Numbers at the axes.
    pub tick: f64,
    /// Labels of axes and curves.
    pub label: f64,
    /// Titles.
    pub title: f64,
    /// Marks, over their usual size.
    pub mark: f64,
}

impl Sizes {
    /// Sizes that suit a cell of this width: smaller letters only where there is little room. All are `letters` times
    /// their usual size.
    fn for_cell(width: f64, letters: f64) -> Self {
        let tick = (10.5 + (width / letters - 180.0) / 120.0).clamp(10.5, LARGEST_TICK) * letters;
        Self { tick, label: tick + 1.0, title: tick + 1.5, mark: (width / 300.0).clamp(0.75, 1.0) }
    }
}

/// The label of a vertical axis: short ones stand upright, long ones read upwards.
#[derive(Clone, Debug, PartialEq)]
pub enum SideLabel {
    /// Stands upright beside the axis.
    Upright(Label),
    /// Reads upwards along the axis.
    Upwards(Label),
}

/// A frame with its place.
#[derive(Clone, Debug, PartialEq)]
pub struct Panel {
    /// The cells it owns.
    pub cell: Rect,
    /// The plot within the axes.
    pub plot: Rect,
    /// Title, line by line.
    pub title: Vec<Label>,
    /// Left end of the title's lines.
    pub title_left: f64,
    /// Ticks of the horizontal axis (plane frames).
    pub x_ticks: Ticks,
    /// Ticks of the vertical axis (plane frames).
    pub y_ticks: Ticks,
    /// Label of the horizontal axis (plane frames).
    pub x_label: Label,
    /// Label of the vertical axis (plane frames).
    pub y_label: SideLabel,
    /// Where the label of the vertical axis begins.
    pub y_label_left: f64,
    /// The bar of colours beside the plot.
    pub bar: Option<Bar>,
    /// Font sizes.
    pub sizes: Sizes,
}

impl Panel {
    /// The same with another sign before the decimals of its numbers.
    #[must_use]
    pub fn written_with(self, decimal: char) -> Self {
        Self {
            x_ticks: self.x_ticks.written_with(decimal),
            y_ticks: self.y_ticks.written_with(decimal),
            bar: self.bar.map(|bar| bar.written_with(decimal)),
            ..self
        }
    }

    /// The map from data to pixels of a plane frame.
    pub fn map(&self, frame: &Frame) -> PlaneMap {
        PlaneMap { plot: self.plot, x: (frame.x.low, frame.x.high), y: (frame.y.low, frame.y.high) }
    }
}

/// Cells of each frame: first column, first row, columns, rows; in a grid of columns and rows.
#[derive(Clone, Debug, PartialEq)]
struct Arrangement {
    grid: (usize, usize),
    places: Vec<[usize; 4]>,
}

/// The grid as the drawing asks for it.
fn as_asked(drawing: &Drawing) -> Arrangement {
    let places = drawing.frames.iter().map(|frame| [frame.cell.0, frame.cell.1, frame.span.0, frame.span.1]);
    Arrangement { grid: drawing.grid, places: places.collect() }
}

/// The frames stacked in reading order, each as many rows high as it was.
fn stacked(drawing: &Drawing) -> Arrangement {
    let mut in_turn: Vec<usize> = (0..drawing.frames.len()).collect();
    order::by_number(&mut in_turn, |&frame| drawing.frames[frame].cell.0 as f64);
    order::by_number(&mut in_turn, |&frame| drawing.frames[frame].cell.1 as f64);
    let mut places = vec![[0, 0, 1, 1]; in_turn.len()];
    let mut row = 0;
    for frame in in_turn {
        let high = drawing.frames[frame].span.1.max(1);
        places[frame] = [0, row, 1, high];
        row += high;
    }
    Arrangement { grid: (1, row), places }
}

/// The grid as the drawing asks for it, or, where its cells would be too narrow, the frames stacked.
fn arrange(drawing: &Drawing, width: f64, height: f64, letters: f64) -> Arrangement {
    let narrow = NARROW * letters;
    let (asked, stacked) = (as_asked(drawing), stacked(drawing));
    if drawing.grid.0 < 2 || width / drawing.grid.0 as f64 >= narrow || stacked.grid.1 == 0 {
        return asked;
    }
    // How far the cells are from a pleasant form, and how far too narrow; of frames over several rows the whole counts.
    let strain = |arrangement: &Arrangement| {
        let (cell_width, cell_height) =
            (width / arrangement.grid.0 as f64, height / arrangement.grid.1 as f64);
        let forms = arrangement.places.iter().zip(&drawing.frames).map(|(place, frame)| {
            let form = cell_width * place[2] as f64 / (cell_height * place[3] as f64);
            // What has one scale for both axes grows no larger than its cell is high.
            (form / if frame.equal_aspect { 1.0 } else { PLEASANT }).ln().abs()
        });
        forms.sum::<f64>() / arrangement.places.len() as f64 + (narrow / cell_width).ln().max(0.0)
    };
    if strain(&stacked) < strain(&asked) { stacked } else { asked }
}

/// Height that suits a drawing at a width, both in CSS pixels: the width over the aspect where the frames have room beside
/// one another, otherwise so much that they can be stacked. Kept within the sides a picture may have.
pub fn pleasant_height(drawing: &Drawing, aspect: f64, width: f64) -> f64 {
    let columns = drawing.grid.0.max(1);
    let rows = stacked(drawing).grid.1;
    let high = drawing.frames.iter().map(|frame| frame.span.1).max().unwrap_or(1).max(1);
    let height = if columns > 1 && rows > 0 && width / (columns as f64) < NARROW {
        rows as f64 * (width / PLEASANT / high as f64).max(LOW)
    } else {
        (width / aspect).max((width / 1.5).min(220.0) * drawing.grid.1 as f64)
    };
    height.clamp(SIDES.0, SIDES.1)
}

/// Places every frame in a picture of a width and height in CSS pixels, its letters so many times their usual size.
pub fn panels(drawing: &Drawing, width: f64, height: f64, letters: f64) -> Vec<Panel> {
    let arrangement = arrange(drawing, width, height, letters);
    let (columns, rows) = (arrangement.grid.0.max(1), arrangement.grid.1.max(1));
    let sizes = Sizes::for_cell(width / columns as f64, letters);
    let (gap_x, gap_y) =
        (if columns > 1 { 1.2 * sizes.tick } else { 0.0 }, if rows > 1 { 0.8 * sizes.tick } else { 0.0 });
    let cell_width = (width - 2.0 * EDGE - gap_x * (columns - 1) as f64) / columns as f64;
    let cell_height = (height - 2.0 * EDGE - gap_y * (rows - 1) as f64) / rows as f64;
    let cell_of = |place: &[usize; 4]| {
        let left = EDGE + place[0] as f64 * (cell_width + gap_x);
        let top = EDGE + place[1] as f64 * (cell_height + gap_y);
        let (wide, high) = (place[2].max(1) as f64, place[3].max(1) as f64);
        Rect {
            left,
            top,
            right: left + wide * cell_width + (wide - 1.0) * gap_x,
            bottom: top + high * cell_height + (high - 1.0) * gap_y,
        }
    };
    let mut panels: Vec<Panel> = drawing
        .frames
        .iter()
        .zip(&arrangement.places)
        .map(|(frame, place)| first_guess(frame, cell_of(place), sizes))
        .collect();
    // The words decide the margins, the margins the ticks, the ticks the words: twice round settles it.
    for _ in 0..3 {
        settle(drawing, &arrangement, &mut panels);
    }
    for (frame, panel) in drawing.frames.iter().zip(&mut panels) {
        if frame.equal_aspect && frame.z.is_none() {
            keep_aspect(frame, panel);
        }
        for edge in [&mut panel.plot.left, &mut panel.plot.top, &mut panel.plot.right, &mut panel.plot.bottom]
        {
            *edge = edge.floor() + 0.5;
        }
    }
    panels
}

fn first_guess(frame: &Frame, cell: Rect, sizes: Sizes) -> Panel {
    let side = set(&frame.y.label, sizes.label, Face::Regular);
    let y_label =
        if side.width <= 2.8 * sizes.label { SideLabel::Upright(side) } else { SideLabel::Upwards(side) };
    Panel {
        cell,
        plot: Rect { left: cell.left + 4.0 * sizes.tick, ..cell },
        title: Vec::new(),
        title_left: cell.left,
        x_ticks: Ticks::default(),
        y_ticks: Ticks::default(),
        x_label: set(&frame.x.label, sizes.label, Face::Regular),
        y_label,
        y_label_left: cell.left,
        bar: None,
        sizes,
    }
}

/// Margins in the order left, top, right, bottom.
fn margins(frame: &Frame, panel: &Panel) -> [f64; 4] {
    let sizes = panel.sizes;
    let title: f64 = panel.title.iter().map(|line| line.height() + 2.0).sum();
    if frame.bare || frame.z.is_some() {
        return [2.0, if title > 0.0 { title + 4.0 } else { 2.0 }, 2.0, 2.0];
    }
    let numbers = widest(&panel.y_ticks, sizes.tick);
    let side = match &panel.y_label {
        SideLabel::Upright(label) => label.width,
        SideLabel::Upwards(label) => label.height(),
    };
    let left = if side > 0.0 { side + LABEL_GAP + 1.0 } else { 0.0 } + numbers + TICK_GAP + TICK;
    let factor = if panel.y_ticks.exponent == 0 { 0.0 } else { 1.2 * sizes.tick };
    let top = if title > 0.0 { title + 6.0 } else { 0.45 * sizes.tick } + factor;
    let line = |size: f64| size * 0.95;
    let under = if panel.x_label.runs.is_empty() { 0.0 } else { LABEL_GAP + panel.x_label.height() };
    let bottom = TICK + gap_under(sizes.tick) + line(sizes.tick) + under;
    let map = panel.map(frame);
    let overhang =
        panel.x_ticks.values.last().zip(panel.x_ticks.labels.last()).map_or(0.0, |(value, text)| {
            map.pixel(*value, frame.y.low)[0] + set(text, sizes.tick, Face::Regular).width / 2.0
                - panel.plot.right
        });
    [left, top, overhang.max(panel.bar.as_ref().map_or(4.0, Bar::room)), bottom]
}

fn settle(drawing: &Drawing, arrangement: &Arrangement, panels: &mut [Panel]) {
    let own: Vec<[f64; 4]> =
        drawing.frames.iter().zip(panels.iter()).map(|(frame, panel)| margins(frame, panel)).collect();
    let plane = |i: usize| !drawing.frames[i].bare && drawing.frames[i].z.is_none();
    // Plots over one another share their left and right edges, plots beside one another their upper and lower ones.
    let line_of = |i: usize, side: usize| {
        let [column, row, wide, high] = arrangement.places[i];
        [column, row, column + wide, row + high][side]
    };
    let shared = |i: usize, side: usize| {
        (0..panels.len())
            .filter(|&j| j == i || (plane(i) && plane(j) && line_of(i, side) == line_of(j, side)))
            .map(|j| own[j][side])
            .fold(0.0_f64, f64::max)
    };
    let margins: Vec<[f64; 4]> =
        (0..panels.len()).map(|i| std::array::from_fn(|side| shared(i, side))).collect();
    for (i, panel) in panels.iter_mut().enumerate() {
        let (frame, [left, top, right, bottom]) = (&drawing.frames[i], margins[i]);
        let sizes = panel.sizes;
        let cell = panel.cell;
        panel.plot = Rect {
            left: cell.left + left,
            top: cell.top + top,
            right: (cell.right - right).max(cell.left + left + 20.0),
            bottom: (cell.bottom - bottom).max(cell.top + top + 20.0),
        };
        panel.y_label_left = panel.plot.left - own[i][0];
        panel.title_left = if plane(i) { panel.plot.left } else { cell.left + 2.0 };
        panel.title = set_lines(&frame.title, sizes.title, Face::Regular, cell.right - panel.title_left);
        if plane(i) {
            panel.x_ticks = across(frame.x.low, frame.x.high, panel.plot.width(), sizes.tick);
            let most = (panel.plot.height() / (2.7 * sizes.tick)) as usize;
            panel.y_ticks = ticks(frame.y.low, frame.y.high, most.clamp(2, 8));
            panel.bar =
                frame.bar.as_ref().map(|axis| Bar::new(axis, panel.plot.height(), sizes.tick, sizes.label));
            panel.x_label = fitted(&frame.x.label, sizes.label, cell.width());
            if let SideLabel::Upwards(label) = &mut panel.y_label {
                *label = fitted(&frame.y.label, sizes.label, panel.plot.height());
            }
        }
    }
}

/// As many ticks over a width as have room for their numbers.
fn across(low: f64, high: f64, width: f64, size: f64) -> Ticks {
    let most = ((width / (4.6 * size)) as usize).clamp(2, 9);
    for count in (2..=most).rev() {
        let found = ticks(low, high, count);
        let step = match found.values.as_slice() {
            [first, second, ..] => (second - first) / (high - low) * width,
            _ => width,
        };
        if widest(&found, size) + 1.1 * size <= step {
            return found;
        }
    }
    ticks(low, high, 2)
}

/// A label, set smaller where it would not fit, down to three quarters.
fn fitted(markup: &str, size: f64, room: f64) -> Label {
    let label = set(markup, size, Face::Regular);
    if label.width <= room {
        return label;
    }
    set(markup, size * (room / label.width).max(0.75), Face::Regular)
}

fn widest(ticks: &Ticks, size: f64) -> f64 {
    ticks.labels.iter().map(|text| set(text, size, Face::Regular).width).fold(0.0, f64::max)
}

/// Shrinks the plot about its middle until a unit is as long in x as in y.
fn keep_aspect(frame: &Frame, panel: &mut Panel) {
    let (wide, high) = (frame.x.high - frame.x.low, frame.y.high - frame.y.low);
    let scale = (panel.plot.width() / wide).min(panel.plot.height() / high);
    let old = panel.plot;
    panel.plot = Rect::around(old.center(), wide * scale, high * scale);
    panel.y_label_left += panel.plot.left - old.left;
    if !frame.bare {
        panel.title_left = panel
            .title_left
            .max(panel.plot.left)
            .min(panel.cell.right - panel.title.iter().map(|line| line.width).fold(0.0, f64::max));
        panel.x_ticks = across(frame.x.low, frame.x.high, panel.plot.width(), panel.sizes.tick);
        let most = (panel.plot.height() / (2.7 * panel.sizes.tick)) as usize;
        panel.y_ticks = ticks(frame.y.low, frame.y.high, most.clamp(2, 8));
    }
}

#[cfg(test)]
mod tests {
    use super::super::drawing::{Axis, Drawing, Frame};
    use super::{arrange, panels, pleasant_height};

    fn drawing(columns: usize, rows: usize) -> Drawing {
        let axis = |label: &str| Axis { name: "x".into(), label: label.into(), low: -3.0, high: 1234.5 };
        let frames = (0..columns * rows)
            .map(|i| Frame {
                name: format!("{i}"),
                title: "a title of several words".into(),
                x: axis("*Ω*_{1}"),
                y: axis("a long label of a vertical axis"),
                bar: None,
                z: None,
                cell: (i % columns, i / columns),
                span: (1, 1),
                equal_aspect: false,
                bare: false,
            })
            .collect();
        Drawing { grid: (columns, rows), frames, series: Vec::new() }
    }

    #[test]
    fn plots_lie_in_their_cells_and_never_overlap() {
        for (columns, rows) in [(1, 1), (2, 2), (3, 1), (2, 3)] {
            let drawing = drawing(columns, rows);
            for width in [320.0, 360.0, 600.0, 900.0, 1600.0] {
                let height = pleasant_height(&drawing, 1.4, width);
                let found = panels(&drawing, width, height, 1.0);
                for (i, panel) in found.iter().enumerate() {
                    assert!(panel.cell.grown(1.0).holds(&panel.plot), "{columns} {rows} {width}");
                    assert!(panel.plot.width() > 60.0 && panel.plot.height() > 40.0, "{:?}", panel.plot);
                    assert!(panel.x_ticks.values.len() >= 2);
                    assert!(found[..i].iter().all(|other| !other.cell.overlaps(&panel.cell)));
                }
            }
        }
    }

    #[test]
    fn plots_of_one_column_share_their_edges() {
        let mut drawing = drawing(2, 2);
        drawing.frames[2].y.high = 0.001;
        drawing.frames[2].y.low = -0.0012;
        let found = panels(&drawing, 900.0, 600.0, 1.0);
        assert_eq!(found[0].plot.left, found[2].plot.left);
        assert_eq!(found[0].plot.right, found[2].plot.right);
        assert_eq!(found[0].plot.bottom, found[1].plot.bottom);
    }

    #[test]
    fn narrow_pictures_are_stacked_and_keep_the_frames_of_two_rows_high() {
        let mut drawing = drawing(2, 2);
        assert_eq!(arrange(&drawing, 900.0, 600.0, 1.0).grid, (2, 2));
        assert_eq!(arrange(&drawing, 340.0, pleasant_height(&drawing, 1.4, 340.0), 1.0).grid, (1, 4));
        drawing.frames.truncate(2);
        drawing.frames[0].span.1 = 2;
        let found = arrange(&drawing, 340.0, pleasant_height(&drawing, 1.4, 340.0), 1.0);
        assert_eq!((found.grid, found.places), ((1, 3), vec![[0, 0, 1, 2], [0, 2, 1, 1]]));
    }
}
