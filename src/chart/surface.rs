//! What a plotters backend must offer beyond plotters' own trait, so that one drawing code serves them all.
//!
//! Coordinates of a plotters backend are whole numbers. A surface gives every CSS pixel many of them, its units, so
//! that curves stay smooth: at 100 units a pixel a curve is placed to a hundredth of a pixel.

use plotters_backend::text_anchor::{HPos, VPos};
use plotters_backend::{
    BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingBackend, DrawingErrorKind, FontStyle,
    FontTransform,
};

use super::metrics::{ASCENT, DESCENT, Face, width};
use super::text::Run;
use super::theme::Color;

/// Units in a CSS pixel that our own surfaces use.
pub const UNITS: i32 = 100;

/// Colour and width of a stroke or fill.
#[derive(Clone, Copy)]
pub struct Stroke {
    /// The colour.
    pub color: BackendColor,
    /// Width in units.
    pub width: u32,
}

impl BackendStyle for Stroke {
    fn color(&self) -> BackendColor {
        self.color
    }

    fn stroke_width(&self) -> u32 {
        self.width
    }
}

/// Letters to be set at a place.
pub struct Lettering<'a> {
    /// The runs of letters; their places and sizes are in CSS pixels.
    pub runs: &'a [Run],
    /// Left end of the baseline, units.
    pub at: BackendCoord,
    /// Turned to read upwards.
    pub upwards: bool,
    /// Colour of the letters.
    pub color: BackendColor,
    /// Colour and width (units, both sides together) of a rim behind the letters.
    pub halo: Option<Stroke>,
}

/// Many small points that are drawn as one.
pub struct Cloud<'a> {
    /// Centres, units.
    pub points: &'a [BackendCoord],
    /// Diameter of each point, units.
    pub diameter: u32,
    /// Colour of each point; where points overlap it thickens.
    pub color: BackendColor,
}

/// An image of few colours.
pub struct Image<'a> {
    /// The place of each pixel's colour in `colors`, row by row from the top; one beyond them: not painted.
    pub pixels: &'a [u8],
    /// Pixels in a row.
    pub columns: usize,
    /// The colours, at most 255.
    pub colors: &'a [Color],
}

/// A plotters backend with finer coordinates and what figures need beyond plotters' trait.
pub trait Surface: DrawingBackend {
    /// How many units of the backend's coordinates make one CSS pixel; at least 1.
    fn units_per_pixel(&self) -> i32;

    /// Sets letters on a baseline.
    ///
    /// # Errors
    /// What the backend fails with.
    fn lettering(&mut self, lettering: &Lettering<'_>) -> Result<(), DrawingErrorKind<Self::ErrorType>>;

    /// Draws many small points as one image or one path.
    ///
    /// # Errors
    /// What the backend fails with.
    fn cloud(&mut self, cloud: &Cloud<'_>) -> Result<(), DrawingErrorKind<Self::ErrorType>>;

    /// Paints an image over the rectangle between two corners, units.
    ///
    /// # Errors
    /// What the backend fails with.
    fn image(
        &mut self,
        image: &Image<'_>,
        upper_left: BackendCoord,
        lower_right: BackendCoord,
    ) -> Result<(), DrawingErrorKind<Self::ErrorType>>;

    /// Side of an image's pixel that suits this surface, CSS pixels.
    fn image_pixel(&self) -> f64 {
        1.0
    }

    /// Strokes many lines of one style; a surface may make one path of them.
    ///
    /// # Errors
    /// What the backend fails with.
    fn strokes(
        &mut self,
        lines: &[Vec<BackendCoord>],
        stroke: &Stroke,
    ) -> Result<(), DrawingErrorKind<Self::ErrorType>> {
        for line in lines {
            self.draw_path(line.iter().copied(), stroke)?;
        }
        Ok(())
    }

    /// What is drawn from here on belongs to the series of this name, which means this. Surfaces without structure ignore it.
    fn open(&mut self, _name: &str, _meaning: &str) {}

    /// Ends what [`Surface::open`] began.
    fn close(&mut self) {}
}

/// Sets a text given in plotters' own style, by the metric table: for the `draw_text` of a surface.
///
/// # Errors
/// What the backend fails with.
pub fn set_plain<S: Surface, T: BackendTextStyle>(
    surface: &mut S,
    text: &str,
    style: &T,
    position: BackendCoord,
) -> Result<(), DrawingErrorKind<S::ErrorType>> {
    let units = f64::from(surface.units_per_pixel());
    let (face, size) = (face_of(style.style()), style.size() / units);
    let (long, anchor) = (width(text, face, size), style.anchor());
    let along = match anchor.h_pos {
        HPos::Left => 0.0,
        HPos::Center => -long / 2.0,
        HPos::Right => -long,
    };
    let down = size
        * match anchor.v_pos {
            VPos::Top => ASCENT,
            VPos::Center => (ASCENT - DESCENT) / 2.0,
            VPos::Bottom => -DESCENT,
        };
    let upwards = matches!(style.transform(), FontTransform::Rotate270 | FontTransform::Rotate90);
    let (dx, dy) = if upwards { (down, -along) } else { (along, down) };
    let at = (position.0 + (dx * units).round() as i32, position.1 + (dy * units).round() as i32);
    let runs = [Run { text: text.to_owned(), x: 0.0, y: 0.0, size, face }];
    surface.lettering(&Lettering { runs: &runs, at, upwards, color: style.color(), halo: None })
}

/// Size of a text given in plotters' own style, units: for the `estimate_text_size` of a surface.
pub fn plain_size<T: BackendTextStyle>(text: &str, style: &T) -> (u32, u32) {
    let long = width(text, face_of(style.style()), style.size());
    (long.ceil() as u32, ((ASCENT + DESCENT) * style.size()).ceil() as u32)
}

fn face_of(style: FontStyle) -> Face {
    match style {
        FontStyle::Normal => Face::Regular,
        FontStyle::Italic | FontStyle::Oblique => Face::Italic,
        FontStyle::Bold => Face::Bold,
    }
}
