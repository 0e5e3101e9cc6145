//! Small tools to put a drawing together: frames, series, pieces of curves.
//!
//! They are called hundreds of times, and seldom: what is not inlined is compiled once.

use crate::chart::drawing::{Axis, Drawing, Frame, Mark, Role, Series};

/// A drawing in the making.
#[derive(Clone, Debug)]
pub(super) struct Composer {
    drawing: Drawing,
}

/// An axis from its ASCII name, its label in markup, and its ends.
#[inline(never)]
pub(super) fn axis(name: &str, label: &str, (low, high): (f64, f64)) -> Axis {
    Axis { name: name.to_owned(), label: label.to_owned(), low, high }
}

/// A plane frame with both axes in one cell.
#[inline(never)]
pub(super) fn plane(name: &str, title: &str, cell: (usize, usize), x: Axis, y: Axis) -> Frame {
    Frame {
        name: name.to_owned(),
        title: title.to_owned(),
        x,
        y,
        bar: None,
        z: None,
        cell,
        span: (1, 1),
        equal_aspect: false,
        bare: false,
    }
}

impl Composer {
    /// An empty drawing with this grid of columns and rows.
    pub(super) fn new(grid: (usize, usize)) -> Self {
        Self { drawing: Drawing { grid, frames: Vec::new(), series: Vec::new() } }
    }

    /// More onto a drawing.
    pub(super) fn on(drawing: Drawing) -> Self {
        Self { drawing }
    }

    /// Adds a frame and answers its index.
    #[inline(never)]
    pub(super) fn frame(&mut self, frame: Frame) -> usize {
        self.drawing.frames.push(frame);
        self.drawing.frames.len() - 1
    }

    /// Adds a series of plane points, unless it has none.
    #[inline(never)]
    pub(super) fn add(&mut self, frame: usize, mark: Mark, line: Line, points: Points) {
        if points.x.is_empty() {
            return;
        }
        self.drawing.series.push(Series {
            frame,
            name: line.name,
            meaning: line.meaning,
            stable: line.stable,
            role: line.role,
            mark,
            label: line.label,
            label_at: line.label_at,
            x: points.x,
            y: points.y,
            z: points.z,
            pieces: if points.pieces.len() > 1 { points.pieces } else { Vec::new() },
        });
    }

    /// Adds a connected line.
    #[inline(never)]
    pub(super) fn curve(&mut self, frame: usize, line: Line, points: Points) {
        self.add(frame, Mark::Curve, line, points);
    }

    /// Adds single marks.
    #[inline(never)]
    pub(super) fn marks(&mut self, frame: usize, line: Line, points: Points) {
        self.add(frame, Mark::Marks, line, points);
    }

    /// Adds a field: the places of its columns and rows, and a number for each column of the first row, then of the
    /// next.
    pub(super) fn field(&mut self, frame: usize, line: Line, x: Vec<f64>, y: Vec<f64>, z: Vec<f64>) {
        self.add(frame, Mark::Field, line, Points { x, y, z, pieces: Vec::new() });
    }

    /// Writes words at a point.
    #[inline(never)]
    pub(super) fn text(&mut self, frame: usize, name: &str, words: &str, at: (f64, f64)) {
        let line = Line::new(name, words, Role::Reference).label(words, 0.5);
        self.add(frame, Mark::Text, line, Points::one(at));
    }

    /// The drawing, done.
    pub(super) fn drawing(self) -> Drawing {
        self.drawing
    }
}

/// What a series means: all of it but its points.
#[derive(Clone, Debug)]
pub(super) struct Line {
    name: String,
    meaning: String,
    stable: Option<bool>,
    role: Role,
    label: Option<String>,
    label_at: f64,
}

impl Line {
    /// A line without stability and label.
    pub(super) fn new(name: impl Into<String>, meaning: impl Into<String>, role: Role) -> Self {
        Self { name: name.into(), meaning: meaning.into(), stable: None, role, label: None, label_at: 0.5 }
    }

    /// The same under a name with this at its end, and without its label: for a second view of the same thing.
    #[inline(never)]
    pub(super) fn renamed(mut self, suffix: &str) -> Self {
        self.name.push_str(suffix);
        self.label = None;
        self
    }

    /// With its stability.
    #[inline(never)]
    pub(super) fn stable(mut self, stable: bool) -> Self {
        self.stable = Some(stable);
        self
    }

    /// With a label at a fraction 0..1 of its points.
    #[inline(never)]
    pub(super) fn label(mut self, label: &str, at: f64) -> Self {
        self.label = Some(label.to_owned());
        self.label_at = at;
        self
    }
}

/// Points of a series, in separate pieces or one.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Points {
    pub(super) x: Vec<f64>,
    pub(super) y: Vec<f64>,
    pub(super) z: Vec<f64>,
    pub(super) pieces: Vec<usize>,
}

impl Points {
    /// One point.
    pub(super) fn one((x, y): (f64, f64)) -> Self {
        Self::plane([(x, y)])
    }

    /// Plane points in one piece.
    pub(super) fn plane(points: impl IntoIterator<Item = (f64, f64)>) -> Self {
        let mut all = Self::default();
        all.piece(points);
        all
    }

    /// Points in space in one piece.
    pub(super) fn space(points: impl IntoIterator<Item = (f64, f64, f64)>) -> Self {
        let mut all = Self::default();
        all.piece_in_space(points);
        all
    }

    /// Adds a piece of plane points; points that are not finite end it and begin another.
    pub(super) fn piece(&mut self, points: impl IntoIterator<Item = (f64, f64)>) {
        let mut open = false;
        for (x, y) in points {
            self.push(&mut open, [x, y]);
        }
    }

    /// Adds points that belong to no piece; those that are not finite are left out.
    pub(super) fn cloud(&mut self, points: impl IntoIterator<Item = (f64, f64)>) {
        for (x, y) in points {
            self.push(&mut true, [x, y]);
        }
    }

    /// Adds a piece of points in space; points that are not finite end it and begin another.
    pub(super) fn piece_in_space(&mut self, points: impl IntoIterator<Item = (f64, f64, f64)>) {
        let mut open = false;
        for (x, y, z) in points {
            if self.push(&mut open, [x, if z.is_finite() { y } else { z }]) {
                self.z.push(z);
            }
        }
    }

    /// Adds a point; whether it is finite. One that is not closes the piece, one that finds none open begins it.
    #[inline(never)]
    fn push(&mut self, open: &mut bool, [x, y]: [f64; 2]) -> bool {
        if !(x.is_finite() && y.is_finite()) {
            *open = false;
            return false;
        }
        if !*open {
            self.pieces.push(self.x.len());
            *open = true;
        }
        self.x.push(x);
        self.y.push(y);
        true
    }

    /// The same points shifted into space by a third coordinate of zero between the two: `(x, 0, y)` or
    /// `(x, y, 0)`.
    #[inline(never)]
    pub(super) fn lifted(&self, upright: bool) -> Self {
        let zero = vec![0.0; self.x.len()];
        let (y, z) = if upright { (zero, self.y.clone()) } else { (self.y.clone(), zero) };
        Self { x: self.x.clone(), y, z, pieces: self.pieces.clone() }
    }
}

/// `count` even steps from `low` to `high`, both ends exact; `count` at least 2.
pub(super) fn even(low: f64, high: f64, count: usize) -> impl Iterator<Item = f64> + Clone {
    let last = (count - 1) as f64;
    (0..count).map(move |index| {
        let fraction = index as f64 / last;
        low * (1.0 - fraction) + high * fraction
    })
}

/// `count` steps from `low` to `high`, crowded quadratically at `low`: a square root that begins there is drawn
/// as smoothly as a line.
pub(super) fn crowded(low: f64, high: f64, count: usize) -> impl Iterator<Item = f64> + Clone {
    even(0.0, 1.0, count).map(move |fraction| low + (high - low) * fraction * fraction)
}

/// A number for a sentence: `digits` significant ones, no trailing zeros, a true minus sign.
pub(super) fn number(value: f64, digits: usize) -> String {
    if value == 0.0 || !value.is_finite() {
        return "0".to_owned();
    }
    let magnitude = value.abs().log10().floor();
    let text = if (-4.0..7.0).contains(&magnitude) {
        let places = (digits as f64 - 1.0 - magnitude).max(0.0) as usize;
        let text = format!("{:.places$}", value.abs());
        if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
    } else {
        format!("{:.*e}", digits.saturating_sub(1), value.abs())
    };
    if value < 0.0 && text.contains(|c: char| ('1'..='9').contains(&c)) {
        format!("\u{2212}{text}")
    } else {
        text
    }
}

/// The next of a ladder of round numbers: a frame that grows with its data moves in few steps.
pub(super) fn rounded_up(value: f64) -> f64 {
    if !(value.is_finite() && value > 1e-12) {
        return 1e-3;
    }
    let power = 10_f64.powf(value.log10().floor());
    [1.0, 1.2, 1.4, 1.6, 1.8, 2.0, 2.5, 3.0, 3.5, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0]
        .into_iter()
        .map(|digits| digits * power)
        .find(|step| *step >= value)
        .unwrap_or(10.0 * power)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_in_sentences_keep_their_digits_and_lose_their_zeros() {
        assert_eq!(number(1.50, 4), "1.5");
        assert_eq!(number(-0.26897851, 4), "\u{2212}0.269");
        assert_eq!(number(-0.268_978, 5), "\u{2212}0.26898");
        assert_eq!(number(40.0, 3), "40");
        assert_eq!(number(1234.6, 3), "1235");
        assert_eq!(number(0.0, 3), "0");
        assert_eq!(number(3.2e-9, 2), "3.2e-9");
    }

    #[test]
    fn the_ladder_holds_every_value_and_wastes_little() {
        for value in [1e-9, 0.099, 0.1, 0.54, 1.0, 3.49, 9.3, 123.0] {
            let up = rounded_up(value);
            assert!(up >= value && up <= 1.26 * value, "{value} {up}");
        }
        assert_eq!(rounded_up(0.0), 1e-3);
        assert_eq!(rounded_up(f64::NAN), 1e-3);
    }

    #[test]
    fn a_point_that_is_not_finite_parts_a_curve() {
        let points = Points::plane([(0.0, 1.0), (1.0, f64::NAN), (2.0, 3.0), (3.0, 4.0)]);
        assert_eq!((points.x, points.pieces), (vec![0.0, 2.0, 3.0], vec![0, 1]));
    }

    #[test]
    fn steps_hold_both_ends_exactly() {
        let steps: Vec<f64> = even(0.1, 0.7, 7).collect();
        assert_eq!((steps[0], steps[6], steps.len()), (0.1, 0.7, 7));
        let steps: Vec<f64> = crowded(2.0, -1.0, 5).collect();
        assert_eq!((steps[0], steps[4]), (2.0, -1.0));
        assert!((steps[1] - (2.0 - 3.0 / 16.0)).abs() < 1e-15);
    }
}
