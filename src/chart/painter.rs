//! Drawing in CSS pixels: turns them into the surface's units, and the surface's failures into ours.

use std::fmt::Display;

use plotters_backend::BackendCoord;

use super::geometry::Rect;
use super::surface::{Cloud, Image, Lettering, Stroke, Surface};
use super::text::Label;
use super::theme::Color;
use crate::error::ChartError;

/// Where a label stands relative to its anchor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Align {
    /// The anchor is its left end.
    Left,
    /// The anchor is its middle.
    Middle,
    /// The anchor is its right end.
    Right,
}

/// A surface drawn on in CSS pixels.
pub struct Painter<'a, S: Surface> {
    surface: &'a mut S,
    units: f64,
}

fn failed(error: impl Display) -> ChartError {
    ChartError::Backend { message: error.to_string() }
}

impl<'a, S: Surface> Painter<'a, S> {
    /// Draws on a surface.
    pub fn new(surface: &'a mut S) -> Self {
        let units = f64::from(surface.units_per_pixel().max(1));
        Self { surface, units }
    }

    /// Size of the surface, CSS pixels.
    pub fn size(&self) -> (f64, f64) {
        let (width, height) = self.surface.get_size();
        (f64::from(width) / self.units, f64::from(height) / self.units)
    }

    /// Readies the surface.
    ///
    /// # Errors
    /// What the backend fails with.
    pub fn begin(&mut self) -> Result<(), ChartError> {
        self.surface.ensure_prepared().map_err(failed)
    }

    /// Shows what was drawn.
    ///
    /// # Errors
    /// What the backend fails with.
    pub fn finish(&mut self) -> Result<(), ChartError> {
        self.surface.present().map_err(failed)
    }

    /// Begins a series.
    pub fn open(&mut self, name: &str, meaning: &str) {
        self.surface.open(name, meaning);
    }

    /// Ends a series.
    pub fn close(&mut self) {
        self.surface.close();
    }

    /// Strokes polylines of one style as one.
    ///
    /// # Errors
    /// What the backend fails with.
    pub fn strokes(
        &mut self,
        lines: &[Vec<[f64; 2]>],
        color: Color,
        width: f64,
        alpha: f64,
    ) -> Result<(), ChartError> {
        let lines: Vec<Vec<BackendCoord>> =
            lines.iter().map(|line| self.path(line)).filter(|line| line.len() > 1).collect();
        if lines.is_empty() {
            return Ok(());
        }
        let stroke = self.stroke(color, width, alpha);
        self.surface.strokes(&lines, &stroke).map_err(failed)
    }

    /// Strokes one straight line.
    ///
    /// # Errors
    /// What the backend fails with.
    pub fn line(&mut self, from: [f64; 2], to: [f64; 2], color: Color, width: f64) -> Result<(), ChartError> {
        self.strokes(&[vec![from, to]], color, width, 1.0)
    }

    /// Fills a polygon.
    ///
    /// # Errors
    /// What the backend fails with.
    pub fn polygon(&mut self, corners: &[[f64; 2]], color: Color, alpha: f64) -> Result<(), ChartError> {
        let path = self.path(corners);
        if path.len() < 3 {
            return Ok(());
        }
        self.surface.fill_polygon(path, &self.stroke(color, 0.0, alpha)).map_err(failed)
    }

    /// Fills a rectangle.
    ///
    /// # Errors
    /// What the backend fails with.
    pub fn rectangle(&mut self, area: &Rect, color: Color, alpha: f64) -> Result<(), ChartError> {
        let (upper, lower) = (self.at([area.left, area.top]), self.at([area.right, area.bottom]));
        self.surface.draw_rect(upper, lower, &self.stroke(color, 0.0, alpha), true).map_err(failed)
    }

    /// Fills a disc.
    ///
    /// # Errors
    /// What the backend fails with.
    pub fn disc(&mut self, center: [f64; 2], radius: f64, color: Color) -> Result<(), ChartError> {
        let (at, radius) = (self.at(center), self.length(radius));
        self.surface.draw_circle(at, radius, &self.stroke(color, 0.0, 1.0), true).map_err(failed)
    }

    /// Strokes a circle.
    ///
    /// # Errors
    /// What the backend fails with.
    pub fn circle(
        &mut self,
        center: [f64; 2],
        radius: f64,
        color: Color,
        width: f64,
    ) -> Result<(), ChartError> {
        let (at, radius) = (self.at(center), self.length(radius));
        self.surface.draw_circle(at, radius, &self.stroke(color, width, 1.0), false).map_err(failed)
    }

    /// Draws many small points as one.
    ///
    /// # Errors
    /// What the backend fails with.
    pub fn cloud(
        &mut self,
        points: &[[f64; 2]],
        diameter: f64,
        color: Color,
        alpha: f64,
    ) -> Result<(), ChartError> {
        if points.is_empty() {
            return Ok(());
        }
        let points: Vec<BackendCoord> = points.iter().map(|point| self.at(*point)).collect();
        let diameter = self.length(diameter);
        self.surface.cloud(&Cloud { points: &points, diameter, color: color.backend(alpha) }).map_err(failed)
    }

    /// Paints an image over an area.
    ///
    /// # Errors
    /// What the backend fails with.
    pub fn image(&mut self, image: &Image<'_>, area: &Rect) -> Result<(), ChartError> {
        let (upper, lower) = (self.at([area.left, area.top]), self.at([area.right, area.bottom]));
        self.surface.image(image, upper, lower).map_err(failed)
    }

    /// Side of an image's pixel that suits the surface, CSS pixels.
    pub fn image_pixel(&self) -> f64 {
        self.surface.image_pixel().max(0.1)
    }

    /// Sets a label on a baseline, with a rim of another colour if one is given.
    ///
    /// # Errors
    /// What the backend fails with.
    pub fn label(
        &mut self,
        label: &Label,
        anchor: [f64; 2],
        align: Align,
        color: Color,
        halo: Option<Color>,
    ) -> Result<(), ChartError> {
        let left = anchor[0] - label.width * fraction(align);
        self.letters(label, [left, anchor[1]], false, color, halo)
    }

    /// Sets a label that reads upwards; the anchor is on its baseline.
    ///
    /// # Errors
    /// What the backend fails with.
    pub fn label_upwards(
        &mut self,
        label: &Label,
        anchor: [f64; 2],
        align: Align,
        color: Color,
    ) -> Result<(), ChartError> {
        let start = anchor[1] + label.width * fraction(align);
        self.letters(label, [anchor[0], start], true, color, None)
    }

    fn letters(
        &mut self,
        label: &Label,
        at: [f64; 2],
        upwards: bool,
        color: Color,
        halo: Option<Color>,
    ) -> Result<(), ChartError> {
        if label.runs.is_empty() {
            return Ok(());
        }
        let halo = halo.map(|rim| self.stroke(rim, 3.6, 0.92));
        let at = self.at(at);
        let color = color.backend(1.0);
        self.surface.lettering(&Lettering { runs: &label.runs, at, upwards, color, halo }).map_err(failed)
    }

    fn at(&self, point: [f64; 2]) -> BackendCoord {
        ((point[0] * self.units).round() as i32, (point[1] * self.units).round() as i32)
    }

    /// A polyline in units, without points that fall onto their predecessor.
    fn path(&self, points: &[[f64; 2]]) -> Vec<BackendCoord> {
        let mut path: Vec<BackendCoord> = points.iter().map(|point| self.at(*point)).collect();
        path.dedup();
        path
    }

    fn length(&self, pixels: f64) -> u32 {
        (pixels * self.units).round() as u32
    }

    fn stroke(&self, color: Color, width: f64, alpha: f64) -> Stroke {
        Stroke { color: color.backend(alpha), width: self.length(width) }
    }
}

fn fraction(align: Align) -> f64 {
    match align {
        Align::Left => 0.0,
        Align::Middle => 0.5,
        Align::Right => 1.0,
    }
}
