//! What of a drawing is shown: parts of its axes instead of the whole, and without the series that are switched off.
//!
//! The drawing is changed before anything is placed, so that ticks, labels and fields are made for what is shown.

use super::drawing::{Axis, Drawing};
use crate::error::ChartError;

/// Greatest absolute value at the end of a window.
pub const FARTHEST: f64 = 1e12;
/// Narrowest window over its greatest absolute value: narrower ones need more digits than their ticks have.
pub const NARROWEST: f64 = 1e-9;

/// A part of the axes of a frame.
#[derive(Clone, Debug, PartialEq)]
pub struct Window {
    /// Name of the frame, one with axes.
    pub frame: String,
    /// Least and greatest value of the first axis; none: all of it.
    pub x: Option<[f64; 2]>,
    /// The same for the second axis.
    pub y: Option<[f64; 2]>,
}

/// What of a drawing is shown; by default all of it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Selection {
    /// At most one a frame.
    pub windows: Vec<Window>,
    /// Names of the series that are left out.
    pub hidden: Vec<String>,
}

impl Selection {
    /// The drawing of what is selected.
    ///
    /// # Errors
    /// [`ChartError::Unknown`] for a frame or series that the drawing has not, [`ChartError::Window`] for a window that
    /// does not rise, lies beyond [`FARTHEST`], is too narrow for its numbers to be told apart, or is of a frame without axes.
    pub fn of(&self, mut drawing: Drawing) -> Result<Drawing, ChartError> {
        for window in &self.windows {
            let Some(frame) = drawing.frames.iter_mut().find(|frame| frame.name == window.frame) else {
                let known = drawing.frames.iter().map(|frame| frame.name.clone()).collect();
                return Err(ChartError::Unknown { what: "frame", given: window.frame.clone(), known });
            };
            let bare = frame.bare;
            for (axis, ends) in [(&mut frame.x, window.x), (&mut frame.y, window.y)] {
                if let Some(ends) = ends {
                    narrow(axis, ends, &window.frame, bare)?;
                }
            }
        }
        if let Some(given) = self.hidden.iter().find(|&name| !drawing.series.iter().any(|s| s.name == *name))
        {
            let known = drawing.series.iter().map(|series| series.name.clone()).collect();
            return Err(ChartError::Unknown { what: "series", given: given.clone(), known });
        }
        drawing.series.retain(|series| !self.hidden.contains(&series.name));
        Ok(drawing)
    }
}

fn narrow(axis: &mut Axis, [low, high]: [f64; 2], frame: &str, bare: bool) -> Result<(), ChartError> {
    let largest = low.abs().max(high.abs());
    // Written so that NaN is refused.
    let sound = largest <= FARTHEST && high - low >= NARROWEST * largest && high > low;
    if bare || !sound {
        return Err(ChartError::Window { frame: frame.to_owned(), low, high, bare });
    }
    (axis.low, axis.high) = (low, high);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::super::drawing::{Axis, Drawing, Frame, Mark, Role, Series};
    use super::{Selection, Window};
    use crate::error::ChartError;

    fn drawing() -> Drawing {
        let axis = || Axis { name: "x".into(), label: "x".into(), low: 0.0, high: 10.0 };
        let frame = |name: &str, bare: bool| Frame {
            name: name.into(),
            title: String::new(),
            x: axis(),
            y: axis(),
            bar: None,
            z: None,
            cell: (0, 0),
            span: (1, 1),
            equal_aspect: false,
            bare,
        };
        let series = |name: &str| Series {
            frame: 0,
            name: name.into(),
            meaning: String::new(),
            stable: None,
            role: Role::Exact,
            mark: Mark::Curve,
            label: None,
            label_at: 0.5,
            x: vec![0.0, 1.0],
            y: vec![0.0, 1.0],
            z: Vec::new(),
            pieces: Vec::new(),
        };
        Drawing {
            grid: (1, 1),
            frames: vec![frame("plane", false), frame("gears", true)],
            series: vec![series("one"), series("two")],
        }
    }

    fn window(frame: &str, low: f64, high: f64) -> Selection {
        let windows = vec![Window { frame: frame.into(), x: Some([low, high]), y: None }];
        Selection { windows, hidden: Vec::new() }
    }

    #[test]
    fn a_window_takes_the_place_of_its_axis_and_of_no_other() {
        let shown = window("plane", 2.5, 3.0).of(drawing()).unwrap();
        assert_eq!((shown.frames[0].x.low, shown.frames[0].x.high), (2.5, 3.0));
        assert_eq!((shown.frames[0].y.low, shown.frames[0].y.high), (0.0, 10.0));
        assert_eq!(shown.frames[1], drawing().frames[1]);
        assert_eq!(Selection::default().of(drawing()).unwrap(), drawing());
    }

    #[test]
    fn what_is_hidden_is_gone_and_the_rest_stays() {
        let hidden = |name: &str| Selection { hidden: vec![name.into()], ..Selection::default() };
        let names: Vec<String> =
            hidden("one").of(drawing()).unwrap().series.into_iter().map(|series| series.name).collect();
        assert_eq!(names, ["two"]);
        let refused = hidden("three").of(drawing());
        assert!(
            matches!(refused, Err(ChartError::Unknown { what: "series", known, .. }) if known.len() == 2)
        );
    }

    #[test]
    fn windows_that_show_nothing_are_refused_with_their_numbers() {
        for (low, high) in
            [(3.0, 3.0), (3.0, 2.0), (f64::NAN, 1.0), (0.0, f64::INFINITY), (0.0, 1e13), (1.0, 1.0 + 1e-12)]
        {
            let refused = window("plane", low, high).of(drawing());
            assert!(matches!(refused, Err(ChartError::Window { bare: false, .. })), "{low} {high}");
        }
        assert!(matches!(
            window("gears", 0.0, 1.0).of(drawing()),
            Err(ChartError::Window { bare: true, .. })
        ));
        let unknown = window("plain", 0.0, 1.0).of(drawing());
        assert!(matches!(unknown, Err(ChartError::Unknown { what: "frame", .. })));
    }
}
