//! A plotters backend that writes SVG text: the same on every machine, without a document and without fonts.

use std::convert::Infallible;
use std::fmt::Write as _;

use plotters_backend::{
    BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingBackend, DrawingErrorKind,
};

use super::metrics::{FAMILY, Face, width};
use super::png::data_address;
use super::surface::{Cloud, Image, Lettering, Stroke, Surface, UNITS, plain_size, set_plain};
use crate::error::ChartError;

/// Least and greatest side of a picture, CSS pixels.
pub const SIDES: (f64, f64) = (120.0, 8192.0);

/// Letters from so many on are held to their width: fewer cannot run far.
const WORD: usize = 4;

/// Checks the size of a picture in CSS pixels.
///
/// # Errors
/// [`ChartError::Size`] if a side is outside of 120..8192, or is no number.
pub fn check_size(width: f64, height: f64) -> Result<(), ChartError> {
    let fits = |side: f64| (SIDES.0..=SIDES.1).contains(&side);
    if fits(width) && fits(height) { Ok(()) } else { Err(ChartError::Size { width, height }) }
}

/// A path that waits for more of the same style.
struct Pending {
    color: BackendColor,
    width: u32,
    data: String,
}

/// Writes what is drawn on it as SVG.
pub struct SvgSurface {
    width: i32,
    height: i32,
    body: String,
    pending: Option<Pending>,
    /// Whether the picture has a size on paper.
    on_paper: bool,
}

impl SvgSurface {
    /// An empty picture of a width and height in CSS pixels.
    ///
    /// # Errors
    /// [`ChartError::Size`] if a side is outside of 120..8192.
    pub fn new((width, height): (f64, f64)) -> Result<Self, ChartError> {
        check_size(width, height)?;
        let units = f64::from(UNITS);
        Ok(Self {
            width: (width * units).round() as i32,
            height: (height * units).round() as i32,
            body: String::new(),
            pending: None,
            on_paper: false,
        })
    }

    /// The same with a size on paper: its sides are written in millimetres, sizes of letters and widths of lines in points.
    #[must_use]
    pub fn on_paper(self) -> Self {
        Self { on_paper: true, ..self }
    }

    /// A size of letters or a width of a line, units, as it is written.
    fn measure(&self, units: i32) -> String {
        // An inch has 96 CSS pixels and 72 points.
        if self.on_paper { format!("{}pt", number((3 * units + 2).div_euclid(4))) } else { number(units) }
    }

    /// A side of the picture, units, as it is written.
    fn side(&self, units: i32) -> String {
        let millimetres = || (f64::from(units) * 25.4 / 96.0).round() as i32;
        if self.on_paper { format!("{}mm", number(millimetres())) } else { number(units) }
    }

    /// The finished text: a whole SVG document with a title and a description for those who do not see it.
    pub fn finish(mut self, title: &str, description: &str) -> String {
        self.flush();
        let (width, height) = (number(self.width), number(self.height));
        let (wide, high) = (self.side(self.width), self.side(self.height));
        let mut text = String::with_capacity(self.body.len() + 512);
        // A picture without words for the ear is a picture all the same: an empty element would only be noise.
        let words = [("title", title), ("desc", description)]
            .iter()
            .filter(|(_, words)| !words.is_empty())
            .fold(String::new(), |all, (tag, words)| format!("{all}<{tag}>{}</{tag}>\n", escape(words)));
        let family = FAMILY.replace('"', "'");
        let _ = write!(
            text,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{wide}\" height=\"{high}\" \
             viewBox=\"0 0 {width} {height}\" role=\"img\" font-family=\"{family}\" \
             stroke-linejoin=\"round\" fill=\"none\">\n{words}{}</svg>\n",
            self.body
        );
        text
    }

    fn flush(&mut self) {
        if let Some(Pending { color, width, data }) = self.pending.take() {
            let width = self.measure(width.cast_signed());
            let stroke = paint("stroke", color);
            let _ = writeln!(self.body, "<path d=\"{data}\"{stroke} stroke-width=\"{width}\"/>");
        }
    }

    fn element(&mut self, text: &str) {
        self.flush();
        self.body.push_str(text);
        self.body.push('\n');
    }
}

/// Units as pixels: at most two digits after the point.
fn number(units: i32) -> String {
    let (sign, magnitude) = (if units < 0 { "-" } else { "" }, units.unsigned_abs());
    let (whole, part) = (magnitude / UNITS.unsigned_abs(), magnitude % UNITS.unsigned_abs());
    match (part, part % 10) {
        (0, _) => format!("{sign}{whole}"),
        (_, 0) => {
            format!("{sign}{}.{}", if whole == 0 { String::new() } else { whole.to_string() }, part / 10)
        }
        _ => format!("{sign}{}.{part:02}", if whole == 0 { String::new() } else { whole.to_string() }),
    }
}

/// A colour as an attribute, with its opacity if it is not full.
fn paint(attribute: &str, color: BackendColor) -> String {
    let (red, green, blue) = color.rgb;
    let hex = format!(" {attribute}=\"#{red:02x}{green:02x}{blue:02x}\"");
    if color.alpha >= 1.0 { hex } else { format!("{hex} {attribute}-opacity=\"{:.2}\"", color.alpha) }
}

/// Appends a polyline: one absolute point, then steps.
fn append(data: &mut String, points: impl IntoIterator<Item = BackendCoord>) {
    let mut last: Option<BackendCoord> = None;
    for (x, y) in points {
        match last {
            None => {
                let _ = write!(data, "M{} {}", number(x), number(y));
            }
            Some((from_x, from_y)) => {
                let (dx, dy) = (x - from_x, y - from_y);
                if dy == 0 {
                    let _ = write!(data, "h{}", number(dx));
                } else if dx == 0 {
                    let _ = write!(data, "v{}", number(dy));
                } else {
                    let separator = if dy < 0 { "" } else { " " };
                    let _ = write!(data, "l{}{separator}{}", number(dx), number(dy));
                }
            }
        }
        last = Some((x, y));
    }
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

type Outcome = Result<(), DrawingErrorKind<Infallible>>;

impl DrawingBackend for SvgSurface {
    type ErrorType = Infallible;

    fn get_size(&self) -> (u32, u32) {
        (self.width.unsigned_abs(), self.height.unsigned_abs())
    }

    fn ensure_prepared(&mut self) -> Outcome {
        Ok(())
    }

    fn present(&mut self) -> Outcome {
        self.flush();
        Ok(())
    }

    fn draw_pixel(&mut self, (x, y): BackendCoord, color: BackendColor) -> Outcome {
        self.draw_rect((x, y), (x + 1, y + 1), &color, true)
    }

    fn draw_line<S: BackendStyle>(&mut self, from: BackendCoord, to: BackendCoord, style: &S) -> Outcome {
        self.draw_path([from, to], style)
    }

    fn draw_rect<S: BackendStyle>(
        &mut self,
        (left, top): BackendCoord,
        (right, bottom): BackendCoord,
        style: &S,
        fill: bool,
    ) -> Outcome {
        if !fill {
            return self
                .draw_path([(left, top), (right, top), (right, bottom), (left, bottom), (left, top)], style);
        }
        self.element(&format!(
            "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"{}/>",
            number(left),
            number(top),
            number(right - left),
            number(bottom - top),
            paint("fill", style.color())
        ));
        Ok(())
    }

    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        path: I,
        style: &S,
    ) -> Outcome {
        let (color, width) = (style.color(), style.stroke_width());
        if color.alpha <= 0.0 {
            return Ok(());
        }
        let same = |pending: &Pending| {
            pending.color.rgb == color.rgb && pending.color.alpha == color.alpha && pending.width == width
        };
        if !self.pending.as_ref().is_some_and(same) {
            self.flush();
        }
        let pending = self.pending.get_or_insert_with(|| Pending { color, width, data: String::new() });
        append(&mut pending.data, path);
        Ok(())
    }

    fn draw_circle<S: BackendStyle>(
        &mut self,
        (x, y): BackendCoord,
        radius: u32,
        style: &S,
        fill: bool,
    ) -> Outcome {
        let look = if fill {
            paint("fill", style.color())
        } else {
            let width = self.measure(style.stroke_width().cast_signed());
            format!("{} stroke-width=\"{width}\"", paint("stroke", style.color()))
        };
        let radius = number(radius.cast_signed());
        self.element(&format!("<circle cx=\"{}\" cy=\"{}\" r=\"{radius}\"{look}/>", number(x), number(y)));
        Ok(())
    }

    fn fill_polygon<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        corners: I,
        style: &S,
    ) -> Outcome {
        let mut data = String::new();
        append(&mut data, corners);
        self.element(&format!("<path d=\"{data}z\"{}/>", paint("fill", style.color())));
        Ok(())
    }

    fn draw_text<T: BackendTextStyle>(&mut self, text: &str, style: &T, at: BackendCoord) -> Outcome {
        set_plain(self, text, style, at)
    }

    fn estimate_text_size<T: BackendTextStyle>(
        &self,
        text: &str,
        style: &T,
    ) -> Result<(u32, u32), DrawingErrorKind<Infallible>> {
        Ok(plain_size(text, style))
    }
}

impl Surface for SvgSurface {
    fn units_per_pixel(&self) -> i32 {
        UNITS
    }

    fn lettering(&mut self, lettering: &Lettering<'_>) -> Outcome {
        let units = |pixels: f64| (pixels * f64::from(UNITS)).round() as i32;
        let (x, y) = lettering.at;
        let turn = if lettering.upwards {
            format!(" transform=\"rotate(-90 {} {})\"", number(x), number(y))
        } else {
            String::new()
        };
        let halo = lettering.halo.map_or_else(String::new, |Stroke { color, width }| {
            let width = self.measure(width.cast_signed());
            format!("{} stroke-width=\"{width}\" paint-order=\"stroke\"", paint("stroke", color))
        });
        let runs = lettering.runs.iter().fold(String::new(), |all, run| {
            let face = match run.face {
                Face::Regular => "",
                Face::Italic => " font-style=\"italic\"",
                Face::Bold => " font-weight=\"bold\"",
            };
            let (size, text) = (self.measure(units(run.size)), escape(&run.text));
            let place = format!("x=\"{}\" y=\"{}\"", number(x + units(run.x)), number(y + units(run.y)));
            // Where our typeface is missing another one must not run into what follows.
            let room = if run.text.chars().count() < WORD {
                String::new()
            } else {
                let width = number(units(width(&run.text, run.face, run.size)));
                format!(" textLength=\"{width}\" lengthAdjust=\"spacingAndGlyphs\"")
            };
            format!("{all}<tspan {place} font-size=\"{size}\"{face}{room}>{text}</tspan>")
        });
        self.element(&format!("<text{}{halo}{turn}>{runs}</text>", paint("fill", lettering.color)));
        Ok(())
    }

    fn cloud(&mut self, cloud: &Cloud<'_>) -> Outcome {
        // Lines of no length with round ends: a point costs a few characters.
        let mut data = String::with_capacity(cloud.points.len() * 12);
        for &(x, y) in cloud.points {
            let _ = write!(data, "M{} {}h0", number(x), number(y));
        }
        let width = self.measure(cloud.diameter.cast_signed());
        let look = paint("stroke", cloud.color);
        self.element(&format!(
            "<path d=\"{data}\"{look} stroke-width=\"{width}\" stroke-linecap=\"round\"/>"
        ));
        Ok(())
    }

    fn image(
        &mut self,
        image: &Image<'_>,
        (left, top): BackendCoord,
        (right, bottom): BackendCoord,
    ) -> Outcome {
        self.element(&format!(
            "<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\" href=\"{}\"/>",
            number(left),
            number(top),
            number(right - left),
            number(bottom - top),
            data_address(image)
        ));
        Ok(())
    }

    fn image_pixel(&self) -> f64 {
        // A little less fine than the screen: the text stays short, and the curves over a field are sharp all the same.
        1.25
    }

    fn open(&mut self, name: &str, meaning: &str) {
        let (name, meaning) = (escape(name), escape(meaning));
        let words = if meaning.is_empty() { String::new() } else { format!("<title>{meaning}</title>") };
        self.element(&format!("<g data-series=\"{name}\">{words}"));
    }

    fn close(&mut self) {
        self.element("</g>");
    }
}

#[cfg(test)]
mod tests {
    use super::{SvgSurface, number};
    use crate::chart::surface::Stroke;
    use plotters_backend::{BackendColor, DrawingBackend};

    #[test]
    fn units_become_short_decimals() {
        for (units, text) in
            [(0, "0"), (100, "1"), (150, "1.5"), (7, ".07"), (-70, "-.7"), (-1234, "-12.34"), (1203, "12.03")]
        {
            assert_eq!(number(units), text);
        }
    }

    #[test]
    fn neighbours_of_one_style_share_a_path() {
        let mut surface = SvgSurface::new((200.0, 200.0)).unwrap();
        let style = Stroke { color: BackendColor { alpha: 1.0, rgb: (1, 2, 3) }, width: 150 };
        surface.draw_path([(0, 0), (100, 50)], &style).unwrap();
        surface.draw_path([(0, 300), (100, 300)], &style).unwrap();
        let text = surface.finish("a < b", "");
        assert!(
            text.contains("<path d=\"M0 0l1 .5M0 3h1\" stroke=\"#010203\" stroke-width=\"1.5\"/>"),
            "{text}"
        );
        assert!(text.contains("<title>a &lt; b</title>") && !text.contains("<desc>"));
    }

    #[test]
    fn on_paper_sides_are_millimetres_and_lines_points() {
        // 96 pixels are an inch.
        let mut surface = SvgSurface::new((192.0, 384.0)).unwrap().on_paper();
        let style = Stroke { color: BackendColor { alpha: 1.0, rgb: (1, 2, 3) }, width: 200 };
        surface.draw_path([(0, 0), (100, 50)], &style).unwrap();
        let text = surface.finish("", "");
        assert!(text.contains("width=\"50.8mm\" height=\"101.6mm\" viewBox=\"0 0 192 384\""), "{text}");
        assert!(text.contains("stroke-width=\"1.5pt\""), "{text}");
    }

    #[test]
    fn sizes_out_of_range_are_refused() {
        for size in [(119.0, 500.0), (500.0, 8193.0), (f64::NAN, 500.0), (f64::INFINITY, 500.0)] {
            assert!(SvgSurface::new(size).is_err(), "{size:?}");
        }
    }
}
