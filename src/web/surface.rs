//! One surface for both ways of drawing: the chart's code is then compiled once, and not once for each, which the
//! visitor would have to download.

use std::convert::Infallible;

use plotters_backend::{
    BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingBackend, DrawingErrorKind,
};

use crate::chart::surface::{Cloud, Image, Lettering, Stroke};
use crate::chart::{Surface, SvgSurface};
use crate::web::canvas::{CanvasFailure, CanvasSurface};

/// What is drawn on.
pub enum AnySurface {
    /// The canvas of a page.
    Canvas(CanvasSurface),
    /// A text.
    Svg(SvgSurface),
}

type Outcome = Result<(), DrawingErrorKind<CanvasFailure>>;

/// What never fails has no failure to hand on but that of a font.
fn passed(outcome: Result<(), DrawingErrorKind<Infallible>>) -> Outcome {
    outcome.map_err(|error| match error {
        DrawingErrorKind::DrawingError(never) => match never {},
        DrawingErrorKind::FontError(error) => DrawingErrorKind::FontError(error),
    })
}

/// Asks the surface there is.
macro_rules! either {
    ($surface:expr, $inner:ident => $call:expr) => {
        match $surface {
            AnySurface::Canvas($inner) => $call,
            AnySurface::Svg($inner) => passed($call),
        }
    };
}

impl DrawingBackend for AnySurface {
    type ErrorType = CanvasFailure;

    fn get_size(&self) -> (u32, u32) {
        match self {
            Self::Canvas(canvas) => canvas.get_size(),
            Self::Svg(text) => text.get_size(),
        }
    }

    fn ensure_prepared(&mut self) -> Outcome {
        either!(self, inner => inner.ensure_prepared())
    }

    fn present(&mut self) -> Outcome {
        either!(self, inner => inner.present())
    }

    fn draw_pixel(&mut self, point: BackendCoord, color: BackendColor) -> Outcome {
        either!(self, inner => inner.draw_pixel(point, color))
    }

    fn draw_line<S: BackendStyle>(&mut self, from: BackendCoord, to: BackendCoord, style: &S) -> Outcome {
        either!(self, inner => inner.draw_line(from, to, style))
    }

    fn draw_rect<S: BackendStyle>(
        &mut self,
        upper_left: BackendCoord,
        lower_right: BackendCoord,
        style: &S,
        fill: bool,
    ) -> Outcome {
        either!(self, inner => inner.draw_rect(upper_left, lower_right, style, fill))
    }

    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        path: I,
        style: &S,
    ) -> Outcome {
        either!(self, inner => inner.draw_path(path, style))
    }

    fn draw_circle<S: BackendStyle>(
        &mut self,
        center: BackendCoord,
        radius: u32,
        style: &S,
        fill: bool,
    ) -> Outcome {
        either!(self, inner => inner.draw_circle(center, radius, style, fill))
    }

    fn fill_polygon<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        corners: I,
        style: &S,
    ) -> Outcome {
        either!(self, inner => inner.fill_polygon(corners, style))
    }

    fn draw_text<T: BackendTextStyle>(&mut self, text: &str, style: &T, at: BackendCoord) -> Outcome {
        either!(self, inner => inner.draw_text(text, style, at))
    }

    fn estimate_text_size<T: BackendTextStyle>(
        &self,
        text: &str,
        style: &T,
    ) -> Result<(u32, u32), DrawingErrorKind<CanvasFailure>> {
        Ok(crate::chart::surface::plain_size(text, style))
    }
}

impl Surface for AnySurface {
    fn units_per_pixel(&self) -> i32 {
        match self {
            Self::Canvas(canvas) => canvas.units_per_pixel(),
            Self::Svg(text) => text.units_per_pixel(),
        }
    }

    fn lettering(&mut self, lettering: &Lettering<'_>) -> Outcome {
        either!(self, inner => inner.lettering(lettering))
    }

    fn cloud(&mut self, cloud: &Cloud<'_>) -> Outcome {
        either!(self, inner => inner.cloud(cloud))
    }

    fn image(&mut self, image: &Image<'_>, from: BackendCoord, to: BackendCoord) -> Outcome {
        either!(self, inner => inner.image(image, from, to))
    }

    fn image_pixel(&self) -> f64 {
        match self {
            Self::Canvas(canvas) => canvas.image_pixel(),
            Self::Svg(text) => text.image_pixel(),
        }
    }

    fn strokes(&mut self, lines: &[Vec<BackendCoord>], stroke: &Stroke) -> Outcome {
        either!(self, inner => inner.strokes(lines, stroke))
    }

    fn open(&mut self, name: &str, meaning: &str) {
        match self {
            Self::Canvas(canvas) => canvas.open(name, meaning),
            Self::Svg(text) => text.open(name, meaning),
        }
    }

    fn close(&mut self) {
        match self {
            Self::Canvas(canvas) => canvas.close(),
            Self::Svg(text) => text.close(),
        }
    }
}
