//! The canvas of a page as a surface: plotters' own canvas backend under a finer coordinate grid.
//!
//! The context's transform takes our units to pixels of the backing store, so that whole numbers of units are
//! fractions of a pixel: curves are smooth and sharp at any density of the screen.

use std::cell::RefCell;
use std::fmt;

use plotters_backend::{
    BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingBackend, DrawingErrorKind,
};
use plotters_canvas::CanvasBackend;
use wasm_bindgen::{Clamped, JsCast, JsValue};
use web_sys::{
    CanvasRenderingContext2d, HtmlCanvasElement, ImageData, OffscreenCanvas,
    OffscreenCanvasRenderingContext2d,
};

use crate::chart::cloud::coverage;
use crate::chart::metrics::{FAMILY, Face};
use crate::chart::surface::{Cloud, Image, Lettering, Stroke, Surface, UNITS, plain_size, set_plain};
use crate::chart::svg::check_size;
use crate::chart::theme::Color;
use crate::error::ChartError;

/// All letters are set in this size, CSS pixels, and scaled to theirs: each canvas keeps every font it has ever set, some 30 kB each. It is a
/// large one, for WebKit in its GTK port rounds the widths of letters to whole pixels of it, and words ran into each other.
const TYPE_SIZE: f64 = 100.0;

/// A failure of the canvas, in its own words.
#[derive(Debug)]
pub struct CanvasFailure(String);

impl fmt::Display for CanvasFailure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for CanvasFailure {}

/// A canvas element as a surface. Its context is left as it was found when the surface is dropped.
pub struct CanvasSurface {
    backend: CanvasBackend,
    context: CanvasRenderingContext2d,
    /// Pixels of the backing store.
    store: (u32, u32),
    /// Pixels of the backing store to a CSS pixel.
    density: f64,
}

type Outcome = Result<(), DrawingErrorKind<CanvasFailure>>;

fn failed(error: &JsValue) -> DrawingErrorKind<CanvasFailure> {
    DrawingErrorKind::DrawingError(CanvasFailure(format!("{error:?}")))
}

/// Hands on what plotters' backend says, with our failure instead of its own.
fn passed<E: std::error::Error + Send + Sync>(outcome: Result<(), DrawingErrorKind<E>>) -> Outcome {
    outcome.map_err(|error| match error {
        DrawingErrorKind::DrawingError(inner) => {
            DrawingErrorKind::DrawingError(CanvasFailure(inner.to_string()))
        }
        DrawingErrorKind::FontError(inner) => DrawingErrorKind::FontError(inner),
    })
}

fn css(color: BackendColor) -> String {
    let (red, green, blue) = color.rgb;
    format!("rgba({red},{green},{blue},{})", color.alpha)
}

impl CanvasSurface {
    /// Draws on a canvas whose backing store has `density` pixels to a CSS pixel; the caller sets the store's and the element's size.
    ///
    /// # Errors
    /// [`ChartError::NotFinite`] for a density that is no positive number, [`ChartError::Size`] for a picture outside of 120..8192
    /// CSS pixels a side, [`ChartError::Backend`] for a canvas without a 2-D context.
    pub fn new(canvas: HtmlCanvasElement, density: f64) -> Result<Self, ChartError> {
        if !(density.is_finite() && density > 0.0) {
            return Err(ChartError::NotFinite { name: "density".to_owned() });
        }
        let store = (canvas.width(), canvas.height());
        check_size(f64::from(store.0) / density, f64::from(store.1) / density)?;
        let none = || ChartError::Backend { message: "the canvas gives no 2-D context".to_owned() };
        let context = canvas.get_context("2d").ok().flatten().ok_or_else(none)?;
        let context: CanvasRenderingContext2d = context.dyn_into().map_err(|_| none())?;
        let backend = CanvasBackend::with_canvas_object(canvas).ok_or_else(none)?;
        context.save();
        context.set_line_join("round");
        context.set_line_cap("butt");
        let surface = Self { backend, context, store, density };
        surface.in_units().map_err(|error| ChartError::Backend { message: error.to_string() })?;
        Ok(surface)
    }

    /// Lets the context take coordinates in units.
    fn in_units(&self) -> Outcome {
        let scale = self.density / f64::from(UNITS);
        self.context.set_transform(scale, 0.0, 0.0, scale, 0.0, 0.0).map_err(|error| failed(&error))
    }
}

impl Drop for CanvasSurface {
    fn drop(&mut self) {
        self.context.restore();
    }
}

/// Pixels on a canvas of their own: put straight onto another they would wipe out what lies under them.
fn layer(
    bytes: &[u8],
    (width, height): (u32, u32),
) -> Result<OffscreenCanvas, DrawingErrorKind<CanvasFailure>> {
    let js = |error: JsValue| failed(&error);
    let pixels = ImageData::new_with_u8_clamped_array_and_sh(Clamped(bytes), width, height).map_err(js)?;
    let layer = OffscreenCanvas::new(width, height).map_err(js)?;
    let onto = layer.get_context("2d").map_err(js)?.and_then(|context| context.dyn_into().ok());
    let onto: OffscreenCanvasRenderingContext2d =
        onto.ok_or_else(|| failed(&JsValue::from_str("no 2-D context for an image")))?;
    onto.put_image_data(&pixels, 0.0, 0.0).map_err(js)?;
    Ok(layer)
}

/// A field as it was painted last, with the canvas that holds it.
struct Field {
    pixels: Vec<u8>,
    columns: usize,
    colors: Vec<Color>,
    layer: OffscreenCanvas,
}

thread_local! {
    /// A chart whose handle is dragged is drawn in every frame with the same field: half of its time would go into making that anew.
    static LAST: RefCell<Option<Field>> = const { RefCell::new(None) };
}

/// A field on a canvas of its own: the one painted last, where nothing in it has changed.
fn field_layer(image: &Image<'_>) -> Result<OffscreenCanvas, DrawingErrorKind<CanvasFailure>> {
    let Image { pixels, columns, colors } = *image;
    let known = LAST.with_borrow(|last| {
        let same =
            |field: &&Field| field.columns == columns && field.colors == colors && field.pixels == pixels;
        last.as_ref().filter(same).map(|field| field.layer.clone())
    });
    if let Some(layer) = known {
        return Ok(layer);
    }
    let mut bytes = vec![0_u8; 4 * pixels.len()];
    for (pixel, &index) in bytes.chunks_exact_mut(4).zip(pixels) {
        if let Some(color) = colors.get(usize::from(index)) {
            pixel.copy_from_slice(&[color.0, color.1, color.2, 255]);
        }
    }
    let wide = columns.max(1);
    let layer = layer(&bytes, (wide as u32, (pixels.len() / wide) as u32))?;
    let field = Field { pixels: pixels.to_vec(), columns, colors: colors.to_vec(), layer: layer.clone() };
    LAST.set(Some(field));
    Ok(layer)
}

impl DrawingBackend for CanvasSurface {
    type ErrorType = CanvasFailure;

    fn get_size(&self) -> (u32, u32) {
        let units = |store: u32| (f64::from(store) / self.density * f64::from(UNITS)).round() as u32;
        (units(self.store.0), units(self.store.1))
    }

    fn ensure_prepared(&mut self) -> Outcome {
        passed(self.backend.ensure_prepared())
    }

    fn present(&mut self) -> Outcome {
        passed(self.backend.present())
    }

    fn draw_pixel(&mut self, point: BackendCoord, color: BackendColor) -> Outcome {
        passed(self.backend.draw_pixel(point, color))
    }

    fn draw_line<S: BackendStyle>(&mut self, from: BackendCoord, to: BackendCoord, style: &S) -> Outcome {
        passed(self.backend.draw_line(from, to, style))
    }

    fn draw_rect<S: BackendStyle>(
        &mut self,
        upper_left: BackendCoord,
        lower_right: BackendCoord,
        style: &S,
        fill: bool,
    ) -> Outcome {
        passed(self.backend.draw_rect(upper_left, lower_right, style, fill))
    }

    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        path: I,
        style: &S,
    ) -> Outcome {
        passed(self.backend.draw_path(path, style))
    }

    fn draw_circle<S: BackendStyle>(
        &mut self,
        center: BackendCoord,
        radius: u32,
        style: &S,
        fill: bool,
    ) -> Outcome {
        passed(self.backend.draw_circle(center, radius, style, fill))
    }

    fn fill_polygon<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        corners: I,
        style: &S,
    ) -> Outcome {
        passed(self.backend.fill_polygon(corners, style))
    }

    fn draw_text<T: BackendTextStyle>(&mut self, text: &str, style: &T, at: BackendCoord) -> Outcome {
        set_plain(self, text, style, at)
    }

    fn estimate_text_size<T: BackendTextStyle>(
        &self,
        text: &str,
        style: &T,
    ) -> Result<(u32, u32), DrawingErrorKind<CanvasFailure>> {
        Ok(plain_size(text, style))
    }
}

impl Surface for CanvasSurface {
    fn units_per_pixel(&self) -> i32 {
        UNITS
    }

    fn lettering(&mut self, lettering: &Lettering<'_>) -> Outcome {
        let (density, units) = (self.density, f64::from(UNITS));
        let (x, y) = (f64::from(lettering.at.0) / units, f64::from(lettering.at.1) / units);
        let context = &self.context;
        context.set_text_align("left");
        context.set_text_baseline("alphabetic");
        context.set_fill_style_str(&css(lettering.color));
        if let Some(Stroke { color, .. }) = lettering.halo {
            context.set_stroke_style_str(&css(color));
        }
        // All rims first: the rim of one run must not eat into its neighbour.
        for rim in [true, false] {
            if rim && lettering.halo.is_none() {
                continue;
            }
            for run in lettering.runs {
                let face = match run.face {
                    Face::Regular => "",
                    Face::Italic => "italic ",
                    Face::Bold => "bold ",
                };
                context.set_font(&format!("{face}{TYPE_SIZE}px {FAMILY}"));
                let enlarged = run.size / TYPE_SIZE;
                let scale = density * enlarged;
                let [a, b, c, d] =
                    if lettering.upwards { [0.0, -scale, scale, 0.0] } else { [scale, 0.0, 0.0, scale] };
                context
                    .set_transform(a, b, c, d, x * density, y * density)
                    .map_err(|error| failed(&error))?;
                let (run_x, run_y) = (run.x / enlarged, run.y / enlarged);
                let set = if let Some(Stroke { width, .. }) = lettering.halo.filter(|_| rim) {
                    context.set_line_width(f64::from(width) / units / enlarged);
                    context.stroke_text(&run.text, run_x, run_y)
                } else {
                    context.fill_text(&run.text, run_x, run_y)
                };
                set.map_err(|error| failed(&error))?;
            }
        }
        self.in_units()
    }

    fn cloud(&mut self, cloud: &Cloud<'_>) -> Outcome {
        let scale = self.density / f64::from(UNITS);
        let points: Vec<(f64, f64)> =
            cloud.points.iter().map(|&(x, y)| (f64::from(x) * scale, f64::from(y) * scale)).collect();
        let store = (self.store.0 as usize, self.store.1 as usize);
        let diameter = f64::from(cloud.diameter) * scale;
        let (red, green, blue) = cloud.color.rgb;
        let js = |error: JsValue| failed(&error);
        self.context.set_transform(1.0, 0.0, 0.0, 1.0, 0.0, 0.0).map_err(js)?;
        for image in coverage(&points, diameter, cloud.color.alpha, store) {
            // Most pixels stay empty: their colour does not matter.
            let mut bytes = vec![0_u8; 4 * image.alpha.len()];
            for (pixel, &alpha) in bytes.chunks_exact_mut(4).zip(&image.alpha) {
                if alpha > 0.0 {
                    pixel.copy_from_slice(&[red, green, blue, (alpha * 255.0).round() as u8]);
                }
            }
            let layer = layer(&bytes, (image.size.0 as u32, image.size.1 as u32))?;
            let (left, top) = (image.origin.0 as f64, image.origin.1 as f64);
            self.context.draw_image_with_offscreen_canvas(&layer, left, top).map_err(js)?;
        }
        self.in_units()
    }

    fn image(
        &mut self,
        image: &Image<'_>,
        (left, top): BackendCoord,
        (right, bottom): BackendCoord,
    ) -> Outcome {
        let layer = field_layer(image)?;
        let [x, y, wide, high] = [left, top, right - left, bottom - top].map(f64::from);
        self.context
            .draw_image_with_offscreen_canvas_and_dw_and_dh(&layer, x, y, wide, high)
            .map_err(|error| failed(&error))
    }

    fn strokes(&mut self, lines: &[Vec<BackendCoord>], stroke: &Stroke) -> Outcome {
        self.context.set_stroke_style_str(&css(stroke.color));
        self.context.set_line_width(f64::from(stroke.width));
        self.context.begin_path();
        for line in lines {
            let mut points = line.iter().map(|&(x, y)| (f64::from(x), f64::from(y)));
            if let Some((x, y)) = points.next() {
                self.context.move_to(x, y);
            }
            points.for_each(|(x, y)| self.context.line_to(x, y));
        }
        self.context.stroke();
        Ok(())
    }
}
