//! Drawing: onto a canvas and as SVG text, by an id or from a figure object.

use wasm_bindgen::prelude::wasm_bindgen;
use wasm_bindgen::{JsCast, JsValue};
use web_sys::HtmlCanvasElement;
use web_sys::js_sys::{Array, Float64Array, Function};

use crate::chart::drawing::{Drawing, Series};
use crate::chart::svg::check_size;
use crate::chart::theme::{Color, Shape};
use crate::chart::{self, FrameMap, Selection, SvgSurface, Theme, View, Window};
use crate::figures::{self, Figure};
use crate::web::canvas::CanvasSurface;
use crate::web::columns::Record;
use crate::web::drawing;
use crate::web::errors::{Allowed, Given, WebError};
use crate::web::options::Options;
use crate::web::surface::AnySurface;
use crate::web::values;

/// Sides of a picture, CSS pixels.
const SIDE: (f64, f64) = (120.0, 8192.0);
/// Default width of an SVG picture; its height follows from the figure's aspect.
const WIDTH: f64 = 720.0;
/// Longest side of a canvas's backing store that every browser makes, pixels.
const LARGEST_STORE: f64 = 16_384.0;
/// CSS pixels in a millimetre: an inch has 96 of them.
const MILLIMETRE: f64 = 96.0 / 25.4;
/// Default width of an SVG picture in millimetres: the width of a journal's page of text.
const PAGE_WIDTH: f64 = 174.0;
/// Most series that may be hidden, and more than any figure has.
const MOST_HIDDEN: usize = 2_000;

/// What of a figure is shown, and how.
struct Shown {
    view: View,
    time: Option<f64>,
    selection: Selection,
    words: Option<Function>,
}

/// SVG text of a figure: `svg(idOrFigure, params, {width, height, unit, theme, view, words})`.
///
/// # Errors
/// The plain object of a `GearError`.
#[wasm_bindgen]
pub fn svg(id_or_figure: &JsValue, params: &JsValue, options: &JsValue) -> Result<String, JsValue> {
    let options = Options::read(options, &["width", "height", "unit", "theme", "view", "words"])?;
    let theme = theme(&options)?;
    let shown = shown(&options)?;
    // Sizes are refused before anything is computed.
    let on_paper = on_paper(&options)?;
    let (pixels, usual) = if on_paper { (MILLIMETRE, PAGE_WIDTH) } else { (1.0, WIDTH) };
    let sides = (SIDE.0 / pixels, SIDE.1 / pixels);
    let width = options.number("width", sides, usual)? * pixels;
    let given_height = options.number("height", sides, f64::NAN)? * pixels;
    let (figure, title) = figure(id_or_figure, params)?;
    let aspect = figures::specification(figure.id).map_err(WebError::from)?.aspect;
    let height =
        if given_height.is_nan() { (width / aspect).round().clamp(SIDE.0, SIDE.1) } else { given_height };
    let picture = picture(&figure, &shown)?;
    let surface = SvgSurface::new((width, height)).map_err(WebError::from)?;
    let mut surface = AnySurface::Svg(if on_paper { surface.on_paper() } else { surface });
    chart::draw(&mut surface, &picture, &theme, &shown.view).map_err(WebError::from)?;
    match surface {
        AnySurface::Svg(text) => Ok(text.finish(&title, &figure.summary)),
        AnySurface::Canvas(_) => Err(WebError::internal("a text became a canvas".into()).into()),
    }
}

/// Draws onto a canvas: `draw(idOrFigure, params, canvas, {theme, density, view, words})`; answers the map between pixels
/// and data of each frame, and how each series looks.
///
/// # Errors
/// The plain object of a `GearError`.
#[wasm_bindgen]
pub fn draw(
    id_or_figure: &JsValue,
    params: &JsValue,
    canvas: &JsValue,
    options: &JsValue,
) -> Result<JsValue, JsValue> {
    let options = Options::read(options, &["theme", "density", "view", "words"])?;
    let theme = theme(&options)?;
    let shown = shown(&options)?;
    let density = options.number("density", (0.5, 8.0), 2.0)?;
    let canvas = canvas.dyn_ref::<HtmlCanvasElement>().ok_or_else(|| {
        WebError::option("canvas", values::given(canvas), Allowed::Text("an HTMLCanvasElement".into()))
    })?;
    let (figure, _) = figure(id_or_figure, params)?;
    let looks: Vec<Record> = figure.drawing.series.iter().map(|series| look(series, &theme)).collect();
    let picture = picture(&figure, &shown)?;
    let density = fit_store(canvas, density)?;
    let surface = CanvasSurface::new(canvas.clone(), density).map_err(WebError::from)?;
    let mut surface = AnySurface::Canvas(surface);
    let maps = chart::draw(&mut surface, &picture, &theme, &shown.view).map_err(WebError::from)?;
    Ok(Record::new().list("frames", maps.iter().map(frame_map)).list("looks", looks).finish()?)
}

/// Gives the canvas as many pixels as its place on the page needs at this density; a canvas without a place keeps its
/// own. Answers the density that was used.
///
/// # Errors
/// `drawing`, for a canvas too small or too large; it is then left as it was.
fn fit_store(canvas: &HtmlCanvasElement, density: f64) -> Result<f64, WebError> {
    let place = (canvas.client_width(), canvas.client_height());
    if place.0 <= 0 || place.1 <= 0 {
        return Ok(density);
    }
    let (width, height) = (f64::from(place.0), f64::from(place.1));
    check_size(width, height)?;
    let density = density.min(LARGEST_STORE / width.max(height));
    let store = ((width * density).round() as u32, (height * density).round() as u32);
    if (canvas.width(), canvas.height()) != store {
        canvas.set_width(store.0);
        canvas.set_height(store.1);
        if (canvas.client_width(), canvas.client_height()) != place {
            // No style gives it a size: its place follows its pixels, and would grow with every drawing.
            let style = canvas.style();
            for (name, side) in [("width", width), ("height", height)] {
                let set = style.set_property(name, &format!("{side}px"));
                set.map_err(|_| WebError::internal("the canvas cannot be given a size".into()))?;
            }
        }
    }
    Ok(density)
}

/// A figure by its id, computed, or from a figure object, read back.
fn figure(id_or_figure: &JsValue, params: &JsValue) -> Result<(Figure, String), WebError> {
    if id_or_figure.is_object() && !id_or_figure.is_function() {
        drawing::read_figure(id_or_figure)
    } else {
        drawing::computed(id_or_figure, params)
    }
}

/// What of a figure is to be drawn.
fn picture(figure: &Figure, shown: &Shown) -> Result<Drawing, WebError> {
    let whole = shown.time.map_or_else(|| figure.drawing.clone(), |time| figures::at_time(figure, time));
    let selected = shown.selection.of(whole)?;
    Ok(match &shown.words {
        Some(words) => in_words(selected, words)?,
        None => selected,
    })
}

/// Titles and labels as the reader's function says them: those of a figure that moves are made anew for every moment.
fn in_words(mut drawing: Drawing, words: &Function) -> Result<Drawing, WebError> {
    for frame in &mut drawing.frames {
        let bar = frame.bar.as_mut().map(|axis| &mut axis.label);
        let third = frame.z.as_mut().map(|axis| &mut axis.label);
        let texts = [&mut frame.title, &mut frame.x.label, &mut frame.y.label];
        for text in texts.into_iter().chain(bar).chain(third) {
            say(text, words)?;
        }
    }
    for text in drawing.series.iter_mut().filter_map(|series| series.label.as_mut()) {
        say(text, words)?;
    }
    Ok(drawing)
}

fn say(text: &mut String, words: &Function) -> Result<(), WebError> {
    if text.is_empty() {
        return Ok(());
    }
    let said = words.call1(&JsValue::NULL, &JsValue::from_str(text)).ok().and_then(|said| said.as_string());
    let allowed = || Allowed::Text("a function from text to text".into());
    *text = said.ok_or_else(|| WebError::option("words", Given::Text(text.clone()), allowed()))?;
    Ok(())
}

fn theme(options: &Options) -> Result<Theme, WebError> {
    let names = Theme::NAMES.join(", ");
    let word = options.word("theme", &names)?;
    let word = word.as_deref().unwrap_or("light");
    Theme::by_name(word)
        .ok_or_else(|| WebError::option("theme", Given::Text(word.into()), Allowed::Text(names)))
}

/// Whether sides are given in millimetres and not in CSS pixels.
fn on_paper(options: &Options) -> Result<bool, WebError> {
    const UNITS: &str = "px, mm";
    match options.word("unit", UNITS)?.as_deref() {
        None | Some("px") => Ok(false),
        Some("mm") => Ok(true),
        Some(other) => Err(WebError::option("unit", Given::Text(other.into()), Allowed::Text(UNITS.into()))),
    }
}

/// The sign before the decimals of numbers along axes.
fn decimal(view: &Options) -> Result<char, WebError> {
    const SIGNS: &str = "a point, a comma";
    match view.word("decimal", SIGNS)?.as_deref() {
        None | Some(".") => Ok('.'),
        Some(",") => Ok(','),
        Some(other) => {
            Err(WebError::option("decimal", Given::Text(other.into()), Allowed::Text(SIGNS.into())))
        }
    }
}

fn shown(options: &Options) -> Result<Shown, WebError> {
    let given = options.nested("view", &["azimuth", "elevation", "time", "windows", "hidden", "decimal"])?;
    let start = View::default();
    let right_angle = std::f64::consts::FRAC_PI_2;
    let view = View {
        azimuth: given.number("azimuth", (-1e3, 1e3), start.azimuth)?,
        elevation: given.number("elevation", (-right_angle, right_angle), start.elevation)?,
        decimal: decimal(&given)?,
    };
    let time = given.number("time", (0.0, 1e9), -1.0)?;
    let windows = given
        .nested_each("windows", &["x", "y"])?
        .into_iter()
        .map(|(frame, ends)| Ok(Window { frame, x: ends.ends("x")?, y: ends.ends("y")? }))
        .collect::<Result<_, WebError>>()?;
    let selection = Selection { windows, hidden: given.texts("hidden", MOST_HIDDEN)? };
    let value = options.value("words");
    let words = match value.dyn_ref::<Function>() {
        Some(function) => Some(function.clone()),
        None if value.is_undefined() => None,
        None => {
            let allowed = Allowed::Text("a function from text to text".into());
            return Err(WebError::option("words", values::given(&value), allowed));
        }
    };
    Ok(Shown { view, time: (time >= 0.0).then_some(time), selection, words })
}

/// How a series looks, for a legend.
fn look(series: &Series, theme: &Theme) -> Record {
    let look = theme.look(series.role, series.stable);
    let hex = |Color(red, green, blue): Color| format!("#{red:02x}{green:02x}{blue:02x}");
    let dash = look.dash.map_or(JsValue::NULL, |[dash, gap]| Array::of2(&dash.into(), &gap.into()).into());
    let shape = match look.shape {
        Shape::Dot => "dot",
        Shape::Star => "star",
        Shape::Diamond => "diamond",
        Shape::Triangle => "triangle",
        Shape::Cross => "cross",
        Shape::Ring => "ring",
    };
    Record::new()
        .value("name", series.name.as_str())
        .value("stroke", hex(look.stroke))
        .number("width", look.width)
        .value("dash", dash)
        .value("outline", look.outline.map_or(JsValue::NULL, |color| hex(color).into()))
        .value("shape", shape)
}

fn frame_map(map: &FrameMap) -> Record {
    let [left, top, right, bottom] = map.plot;
    let plot =
        Record::new().number("left", left).number("top", top).number("right", right).number("bottom", bottom);
    let range = |(low, high)| Record::new().number("low", low).number("high", high);
    let projection = map.projection.map_or(JsValue::NULL, |[first, second]| {
        Array::of2(&Float64Array::new_from_slice(&first), &Float64Array::new_from_slice(&second)).into()
    });
    Record::new()
        .value("name", map.name.as_str())
        .record("plot", plot)
        .record("x", range(map.x))
        .record("y", range(map.y))
        .value("projection", projection)
}
