//! Figures as plain objects: written so that they can be cloned, posted and stored, and read back with everything
//! checked, so that what is drawn is sound wherever the object has been.

use wasm_bindgen::JsValue;

use crate::chart::drawing::{Axis, Drawing, Frame, Mark, Series};
use crate::error::FigureError;
use crate::figures::{self, Distance, Entry, Fact, Figure, Motion, Orbits, Row, START};
use crate::study::ErrorEstimate;
use crate::web::columns::{Record, parameters_record};
use crate::web::errors::WebError;
use crate::web::options;
use crate::web::part::Part;
use crate::web::vocabulary;

/// Most points in all series of a figure that is read back.
const MOST_POINTS: usize = 2_000_000;
/// Most frames of a figure that is read back.
const MOST_FRAMES: usize = 64;
/// Most series of a figure that is read back.
const MOST_SERIES: usize = 2_000;
/// Longest name, label or title, in bytes.
const LONGEST_LABEL: usize = 1_000;
/// Longest sentence, in bytes.
const LONGEST_SENTENCE: usize = 4_000;
/// Most cells along one side of the grid.
const MOST_CELLS: usize = 16;

/// A figure as a plain object.
pub fn figure_record(figure: &Figure, title: &str) -> Record {
    let drawing = &figure.drawing;
    let record = Record::new()
        .value("id", figure.id)
        .value("title", title)
        .record("params", params_record(figure))
        .pair("grid", whole_pair(drawing.grid))
        .list("axes", drawing.frames.iter().map(frame_record))
        .list("series", drawing.series.iter().map(|series| series_record(series, &drawing.frames)))
        .value("summary", figure.summary.as_str())
        .texts("notes", figure.notes.iter().map(String::as_str))
        .record("facts", facts_record(figure))
        .list("distances", figure.distances.iter().map(distance_record))
        .provenance(&figure.method, &figure.error);
    let record = if figure.table.is_empty() {
        record.value("table", JsValue::NULL)
    } else {
        record.list("table", figure.table.iter().map(row_record))
    };
    let record = match &figure.end {
        None => record.value("end", JsValue::NULL),
        Some(end) => record.column("end", end),
    };
    let record = match &figure.orbits {
        None => record.value("orbits", JsValue::NULL),
        Some(orbits) => record.record("orbits", orbits_record(orbits)),
    };
    match &figure.motion {
        None => record.value("motion", JsValue::NULL),
        Some(motion) => record.record(
            "motion",
            Record::new()
                .column("t", &motion.t)
                .column("u_p", &motion.u_p)
                .column("u_g", &motion.u_g)
                .column("u", &motion.u),
        ),
    }
}

/// Every parameter, and the start of a figure that takes one: given back, they make the same figure.
fn params_record(figure: &Figure) -> Record {
    let start = figure.start.unwrap_or_default();
    let record = parameters_record(&figure.parameters);
    if figure.start.is_none() {
        return record;
    }
    START.iter().zip(start).fold(record, |record, (info, value)| record.number(info.name, value))
}

fn facts_record(figure: &Figure) -> Record {
    figure.facts.iter().fold(Record::new(), |record, (name, fact)| match fact {
        Fact::Number(number) => record.number(name, *number),
        Fact::Word(word) => record.value(name, *word),
        Fact::Truth(truth) => record.value(name, *truth),
    })
}

fn orbits_record(orbits: &Orbits) -> Record {
    Record::new()
        .column("Omega", &orbits.omega)
        .column("maxU_p", &orbits.max_u_p)
        .column("period", &orbits.period)
        .column("stable", &orbits.stable)
        .column("state", &orbits.state)
}

fn distance_record(distance: &Distance) -> Record {
    let record = Record::new().value("what", distance.what.as_str());
    let record = match distance.at {
        Some((axis, at)) => record.value("axis", axis).number("at", at),
        None => record.value("axis", JsValue::NULL).value("at", JsValue::NULL),
    };
    record
        .number("theory", distance.theory)
        .number("exact", distance.exact)
        .number("difference", distance.difference())
}

fn row_record(row: &Row) -> Record {
    let entry = |record: Record, name: &str, entry: &Entry| match entry {
        Entry::Number(number) => record.number(name, *number),
        Entry::Words(words) => record.value(name, *words),
        Entry::Nothing => record.value(name, JsValue::NULL),
    };
    let record = Record::new().value("where", row.place).value("what", row.quantity.as_str());
    let record = entry(record, "printed", &row.printed);
    let record = entry(record, "ours", &row.ours);
    let record = entry(record, "exact", &row.exact);
    let beyond = |number: Option<f64>| Some(number? - row.exact.number()?);
    record
        .optional("deviation", beyond(row.printed.number()))
        .optional("ownDeviation", beyond(row.ours.number()))
        .value("remark", row.remark)
}

fn whole_pair(pair: (usize, usize)) -> (f64, f64) {
    (pair.0 as f64, pair.1 as f64)
}

fn axis_record(axis: &Axis) -> Record {
    Record::new()
        .value("name", axis.name.as_str())
        .value("label", axis.label.as_str())
        .number("low", axis.low)
        .number("high", axis.high)
}

fn frame_record(frame: &Frame) -> Record {
    let record = Record::new()
        .value("frame", frame.name.as_str())
        .value("title", frame.title.as_str())
        .record("x", axis_record(&frame.x))
        .record("y", axis_record(&frame.y));
    let optional = |record: Record, name: &str, axis: &Option<Axis>| match axis {
        None => record.value(name, JsValue::NULL),
        Some(axis) => record.record(name, axis_record(axis)),
    };
    let record = optional(optional(record, "z", &frame.z), "bar", &frame.bar);
    record
        .pair("cell", whole_pair(frame.cell))
        .pair("span", whole_pair(frame.span))
        .value("equalAspect", frame.equal_aspect)
        .value("bare", frame.bare)
}

fn series_record(series: &Series, frames: &[Frame]) -> Record {
    let columns = Record::new().column("x", &series.x).column("y", &series.y);
    let columns = if series.z.is_empty() { columns } else { columns.column("z", &series.z) };
    Record::new()
        .value("frame", frames.get(series.frame).map_or("", |frame| frame.name.as_str()))
        .value("name", series.name.as_str())
        .value("meaning", series.meaning.as_str())
        .value("stable", series.stable.map_or(JsValue::NULL, JsValue::from))
        .value("role", vocabulary::role_word(series.role))
        .value("mark", vocabulary::mark_word(series.mark))
        .value("label", series.label.as_deref().map_or(JsValue::NULL, JsValue::from))
        .number("labelAt", series.label_at)
        .record("columns", columns)
        .indices("pieces", &series.pieces)
}

/// A figure, and its title, from an object that [`figure_record`] has made, here or elsewhere, now or long ago.
///
/// # Errors
/// `drawing` or `unknown-figure`, naming the part that is wrong; or what is wrong with the parameters.
pub fn read_figure(value: &JsValue) -> Result<(Figure, String), WebError> {
    let object = Part::root(value.clone());
    let id = object.get("id")?.text(LONGEST_LABEL)?;
    let specification = figures::specification(&id)?;
    let title = object.get("title")?.text(LONGEST_LABEL)?;
    let params = object.get("params")?;
    if params.is_nothing() {
        return Err(params.wrong("the parameters"));
    }
    let (parameters, start) = options::parameters_and_start(params.value())?;
    let error = object.get("error")?;
    let notes = object.get("notes")?.list(1_000)?;
    let figure = Figure {
        id: specification.id,
        parameters,
        drawing: read_drawing(&object)?,
        summary: object.get("summary")?.text(LONGEST_SENTENCE)?,
        method: object.get("method")?.text(LONGEST_SENTENCE)?,
        error: ErrorEstimate {
            liouville: read_optional(&error, "liouville")?,
            step: read_optional(&error, "step")?,
            residual: read_optional(&error, "residual")?,
        },
        motion: read_motion(&object.get("motion")?)?,
        // Drawing needs rows, facts, distances and orbits no more; the object keeps them.
        table: Vec::new(),
        facts: Vec::new(),
        orbits: None,
        start,
        end: None,
        distances: Vec::new(),
        notes: notes.iter().map(|note| note.text(LONGEST_SENTENCE)).collect::<Result<_, _>>()?,
    };
    Ok((figure, title))
}

fn read_optional(object: &Part, name: &str) -> Result<Option<f64>, WebError> {
    let part = object.get(name)?;
    if part.is_nothing() { Ok(None) } else { part.number().map(Some) }
}

fn read_motion(part: &Part) -> Result<Option<Motion>, WebError> {
    if part.is_nothing() {
        return Ok(None);
    }
    let column = |name: &str| part.get(name)?.numbers(MOST_POINTS);
    let motion = Motion { t: column("t")?, u_p: column("u_p")?, u_g: column("u_g")?, u: column("u")? };
    let rows = motion.t.len();
    if rows < 2 || [&motion.u_p, &motion.u_g, &motion.u].iter().any(|column| column.len() != rows) {
        return Err(part.unfit("columns of other lengths", "columns of one length, two rows at least"));
    }
    if motion.t.windows(2).any(|pair| pair[0] >= pair[1]) {
        return Err(part.unfit("times that do not rise", "at rising times"));
    }
    Ok(Some(motion))
}

fn read_drawing(object: &Part) -> Result<Drawing, WebError> {
    let grid = object.get("grid")?.whole_pair(1, MOST_CELLS)?;
    let axes = object.get("axes")?;
    let mut frames: Vec<Frame> = Vec::new();
    for part in axes.list(MOST_FRAMES)? {
        let frame = read_frame(&part, grid)?;
        if frames.iter().any(|other| other.name == frame.name) {
            return Err(part.unfit("a name that another frame has", "a frame with a name of its own"));
        }
        frames.push(frame);
    }
    if frames.is_empty() {
        return Err(axes.unfit("none", "one frame or more"));
    }
    let mut points_left = MOST_POINTS;
    let mut series = Vec::new();
    for part in object.get("series")?.list(MOST_SERIES)? {
        let one = read_series(&part, &frames, points_left)?;
        points_left -= one.x.len().max(one.z.len());
        series.push(one);
    }
    Ok(Drawing { grid, frames, series })
}

fn read_axis(part: &Part) -> Result<Axis, WebError> {
    let axis = Axis {
        name: part.get("name")?.text(LONGEST_LABEL)?,
        label: part.get("label")?.text(LONGEST_LABEL)?,
        low: part.get("low")?.number()?,
        high: part.get("high")?.number()?,
    };
    if axis.low < axis.high && (axis.high - axis.low).is_finite() {
        Ok(axis)
    } else {
        Err(part.unfit("an empty or boundless range", "an axis whose low is below its high"))
    }
}

fn read_frame(part: &Part, grid: (usize, usize)) -> Result<Frame, WebError> {
    let third = part.get("z")?;
    let bar = part.get("bar")?;
    let frame = Frame {
        name: part.get("frame")?.text(LONGEST_LABEL)?,
        title: part.get("title")?.text(LONGEST_LABEL)?,
        x: read_axis(&part.get("x")?)?,
        y: read_axis(&part.get("y")?)?,
        z: if third.is_nothing() { None } else { Some(read_axis(&third)?) },
        bar: if bar.is_nothing() { None } else { Some(read_axis(&bar)?) },
        cell: part.get("cell")?.whole_pair(0, MOST_CELLS - 1)?,
        span: part.get("span")?.whole_pair(1, MOST_CELLS)?,
        equal_aspect: part.get("equalAspect")?.truth()?,
        bare: part.get("bare")?.truth()?,
    };
    if frame.cell.0 + frame.span.0 > grid.0 || frame.cell.1 + frame.span.1 > grid.1 {
        return Err(part.unfit("cells beyond the grid", "within the grid"));
    }
    Ok(frame)
}

fn read_series(part: &Part, frames: &[Frame], points_left: usize) -> Result<Series, WebError> {
    let frame = part.get("frame")?;
    let frame_name = frame.text(LONGEST_LABEL)?;
    let index = frames.iter().position(|known| known.name == frame_name);
    let index = index.ok_or_else(|| frame.wrong("the name of a frame"))?;
    let role = part.get("role")?;
    let mark = part.get("mark")?;
    let label = part.get("label")?;
    let stable = part.get("stable")?;
    let columns = part.get("columns")?;
    let third = columns.get("z")?;
    let series = Series {
        frame: index,
        name: part.get("name")?.text(LONGEST_LABEL)?,
        meaning: part.get("meaning")?.text(LONGEST_SENTENCE)?,
        stable: if stable.is_nothing() { None } else { Some(stable.truth()?) },
        role: vocabulary::role(&role.text(LONGEST_LABEL)?)
            .ok_or_else(|| role.wrong(&format!("one of {}", vocabulary::role_words())))?,
        mark: vocabulary::mark(&mark.text(LONGEST_LABEL)?)
            .ok_or_else(|| mark.wrong(&format!("one of {}", vocabulary::mark_words())))?,
        label: if label.is_nothing() { None } else { Some(label.text(LONGEST_LABEL)?) },
        label_at: part.get("labelAt")?.number()?.clamp(0.0, 1.0),
        x: columns.get("x")?.numbers(points_left)?,
        y: columns.get("y")?.numbers(points_left)?,
        z: if third.is_nothing() { Vec::new() } else { third.numbers(points_left)? },
        pieces: read_pieces(&part.get("pieces")?)?,
    };
    check_series(part, &series, frames[index].z.is_some())?;
    Ok(series)
}

fn read_pieces(part: &Part) -> Result<Vec<usize>, WebError> {
    let numbers = part.numbers(MOST_POINTS)?;
    if numbers.iter().any(|number| number.fract() != 0.0 || *number < 0.0 || *number > MOST_POINTS as f64) {
        return Err(part.unfit("something else", "indices of points"));
    }
    Ok(numbers.iter().map(|number| *number as usize).collect())
}

fn check_series(part: &Part, series: &Series, in_space: bool) -> Result<(), WebError> {
    let points = series.x.len();
    let third = if in_space { points } else { 0 };
    if series.mark == Mark::Field {
        let fits = !in_space && points > 0 && points * series.y.len() == series.z.len();
        return if fits {
            Ok(())
        } else {
            Err(part.unfit("columns of other lengths", "a z for each pair of x and y, in a plane"))
        };
    }
    if series.y.len() != points || series.z.len() != third {
        return Err(
            part.unfit("columns of other lengths", "columns of one length, z only in a view in space")
        );
    }
    let rising = series.pieces.windows(2).all(|pair| pair[0] <= pair[1]);
    if !rising || series.pieces.iter().any(|piece| *piece > points) {
        return Err(part.unfit("pieces that do not fit", "rising indices of points in pieces"));
    }
    match series.mark {
        Mark::Band if points != 2 => Err(part.unfit("another number of points", "two points for a band")),
        Mark::Text if points == 0 => Err(part.unfit("no point", "a point for a text")),
        _ => Ok(()),
    }
}

/// The parameters' names and values for a figure, and the figure.
///
/// # Errors
/// What is wrong with the id or the parameters, or what the computation fails with.
pub fn computed(id: &JsValue, params: &JsValue) -> Result<(Figure, String), WebError> {
    let id = figure_id(id)?;
    let given = options::named_values(params)?;
    let figure = figures::figure(&id, &given)?;
    Ok((figure, title(&id)?))
}

/// The id of a figure, as text.
///
/// # Errors
/// `unknown-figure`, for anything that is no text.
pub fn figure_id(id: &JsValue) -> Result<String, WebError> {
    id.as_string().ok_or_else(|| WebError::unknown_figure(crate::web::values::given(id)))
}

/// The title of a figure.
///
/// # Errors
/// `unknown-figure`.
pub fn title(id: &str) -> Result<String, FigureError> {
    figures::specification(id).map(|specification| specification.title.to_string())
}
