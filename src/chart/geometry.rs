//! Rectangles and the map from data to pixels in a plane frame.

/// A rectangle in CSS pixels, y downwards.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Rect {
    /// Left edge.
    pub left: f64,
    /// Upper edge.
    pub top: f64,
    /// Right edge.
    pub right: f64,
    /// Lower edge.
    pub bottom: f64,
}

impl Rect {
    /// The rectangle of a centre and a width and height.
    pub fn around(center: [f64; 2], width: f64, height: f64) -> Self {
        Self {
            left: center[0] - width / 2.0,
            top: center[1] - height / 2.0,
            right: center[0] + width / 2.0,
            bottom: center[1] + height / 2.0,
        }
    }

    /// Width, pixels.
    pub fn width(&self) -> f64 {
        self.right - self.left
    }

    /// Height, pixels.
    pub fn height(&self) -> f64 {
        self.bottom - self.top
    }

    /// The middle.
    pub fn center(&self) -> [f64; 2] {
        [f64::midpoint(self.left, self.right), f64::midpoint(self.top, self.bottom)]
    }

    /// Larger by a margin on every side (smaller by a negative one).
    #[must_use]
    pub fn grown(&self, margin: f64) -> Self {
        Self {
            left: self.left - margin,
            top: self.top - margin,
            right: self.right + margin,
            bottom: self.bottom + margin,
        }
    }

    /// Whether the two share any area.
    pub fn overlaps(&self, other: &Self) -> bool {
        self.left < other.right
            && other.left < self.right
            && self.top < other.bottom
            && other.top < self.bottom
    }

    /// Whether the other lies wholly within.
    pub fn holds(&self, other: &Self) -> bool {
        self.left <= other.left
            && other.right <= self.right
            && self.top <= other.top
            && other.bottom <= self.bottom
    }

    /// Whether a point lies within, or outside by at most a margin.
    pub fn holds_point(&self, point: [f64; 2], margin: f64) -> bool {
        let own = self.grown(margin);
        (own.left..=own.right).contains(&point[0]) && (own.top..=own.bottom).contains(&point[1])
    }

    /// Least and greatest coordinates.
    pub fn corners(&self) -> ([f64; 2], [f64; 2]) {
        ([self.left, self.top], [self.right, self.bottom])
    }
}

/// The straight map from data to pixels of a plane frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlaneMap {
    /// The plot's rectangle.
    pub plot: Rect,
    /// Data at its left and right edge.
    pub x: (f64, f64),
    /// Data at its lower and upper edge.
    pub y: (f64, f64),
}

impl PlaneMap {
    /// The pixel of a pair of data.
    pub fn pixel(&self, x: f64, y: f64) -> [f64; 2] {
        [
            self.plot.left + (x - self.x.0) / (self.x.1 - self.x.0) * self.plot.width(),
            self.plot.bottom - (y - self.y.0) / (self.y.1 - self.y.0) * self.plot.height(),
        ]
    }
}
