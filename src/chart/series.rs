//! Series by series: checks the columns, and draws each in its frame.

use super::clip::{clip_polygon, clip_polyline, clip_segment};
use super::dash::dashes;
use super::decimate::decimate;
use super::drawing::{Axis, Drawing, Mark, Role, Series};
use super::field::draw_field;
use super::geometry::{PlaneMap, Rect};
use super::labels::{Anchor, Crowd};
use super::marks::draw_mark;
use super::painter::Painter;
use super::surface::Surface;
use super::theme::{Look, Theme};
use super::three_d::Projection;
use crate::error::ChartError;
use crate::order;

/// Distance between the lines of the hatch, CSS pixels.
const HATCH: f64 = 7.0;
/// Distance of the open circles along a quasi-periodic line, CSS pixels.
const BEADS: f64 = 13.0;
/// Length of the stretches of a curve that are sorted by depth, CSS pixels.
const STRETCH: f64 = 16.0;

/// What a frame's series are drawn with.
pub struct Context<'a> {
    /// The theme.
    pub theme: &'a Theme,
    /// Area in which the frame may be drawn on.
    pub plot: Rect,
    /// Size of marks over their usual one.
    pub mark: f64,
    /// Scale of the frame's fields.
    pub bar: Option<&'a Axis>,
    /// Whether the frame is without axes: nothing then ends at the plot's edge.
    pub bare: bool,
}

impl Context<'_> {
    fn look(&self, series: &Series) -> Look {
        let look = self.theme.look(series.role, series.stable);
        Look { radius: look.radius * self.mark, ..look }
    }
}

/// Checks that a drawing can be drawn: finite numbers, columns of one length, frames and axes that make sense.
///
/// # Errors
/// [`ChartError::NotFinite`] or [`ChartError::Malformed`], naming the culprit.
pub fn check(drawing: &Drawing) -> Result<(), ChartError> {
    let malformed =
        |name: &str, fault: &'static str| Err(ChartError::Malformed { name: name.to_owned(), fault });
    for frame in &drawing.frames {
        for axis in
            [Some(&frame.x), Some(&frame.y), frame.z.as_ref(), frame.bar.as_ref()].into_iter().flatten()
        {
            if !(axis.high - axis.low).is_finite() {
                return Err(ChartError::NotFinite { name: axis.name.clone() });
            }
            if axis.high <= axis.low {
                return malformed(&axis.name, "its axis ends before it begins");
            }
        }
        let (column, row) = (frame.cell.0 + frame.span.0, frame.cell.1 + frame.span.1);
        if frame.span.0 == 0 || frame.span.1 == 0 || column > drawing.grid.0 || row > drawing.grid.1 {
            return malformed(&frame.name, "its cells lie outside of the grid");
        }
    }
    for series in &drawing.series {
        let Some(frame) = drawing.frames.get(series.frame) else {
            return malformed(&series.name, "its frame does not exist");
        };
        let count = series.x.len();
        if series.mark == Mark::Field {
            if frame.z.is_some() || count * series.y.len() != series.z.len() || count == 0 {
                return malformed(&series.name, "its grid and its numbers do not belong together");
            }
        } else if series.y.len() != count || (frame.z.is_some() && series.z.len() != count) {
            return malformed(&series.name, "its columns differ in length");
        }
        let ordered = series.pieces.windows(2).all(|pair| pair[0] <= pair[1]);
        if !ordered || series.pieces.last().is_some_and(|&last| last > count) {
            return malformed(&series.name, "its pieces do not follow one another");
        }
        if series.mark == Mark::Band && count != 2 {
            return malformed(&series.name, "a band needs two corners");
        }
        let finite = [&series.x, &series.y, &series.z].into_iter().flatten().all(|value| value.is_finite());
        if !finite || !series.label_at.is_finite() {
            return Err(ChartError::NotFinite { name: series.name.clone() });
        }
    }
    Ok(())
}

/// Ranges of points of the pieces of a series.
fn pieces(series: &Series) -> impl Iterator<Item = std::ops::Range<usize>> + '_ {
    let starts = std::iter::once(0).chain(series.pieces.iter().copied());
    let ends = series.pieces.iter().copied().chain(std::iter::once(series.x.len()));
    starts.zip(ends).map(|(start, end)| start..end).filter(|range| !range.is_empty())
}

/// The point at the label's fraction along the points.
fn wanted(series: &Series) -> Option<usize> {
    let last = series.x.len().checked_sub(1)?;
    Some((series.label_at.clamp(0.0, 1.0) * last as f64).round() as usize)
}

/// Draws a series of a plane frame, notes its ink, and says where its label belongs.
///
/// # Errors
/// [`ChartError::NotFinite`] if the data lie so far off that they have no pixel, and what the backend fails with.
pub fn draw_plane<S: Surface>(
    painter: &mut Painter<'_, S>,
    series: &Series,
    map: &PlaneMap,
    context: &Context<'_>,
    crowd: &mut Crowd,
) -> Result<Option<Anchor>, ChartError> {
    if series.mark == Mark::Field {
        draw_field(painter, series, context.bar, map, context.theme)?;
        return Ok(None);
    }
    let pixels: Vec<[f64; 2]> = series.x.iter().zip(&series.y).map(|(&x, &y)| map.pixel(x, y)).collect();
    if !pixels.iter().flatten().all(|value| value.is_finite()) {
        return Err(ChartError::NotFinite { name: series.name.clone() });
    }
    let look = context.look(series);
    let (low, high) = context.plot.corners();
    let wanted = wanted(series).map(|index| pixels[index]);
    Ok(match series.mark {
        Mark::Curve => {
            let visible: Vec<Vec<[f64; 2]>> = pieces(series)
                .flat_map(|range| clip_polyline(&decimate(&pixels[range]), &low, &high))
                .collect();
            let lines: Vec<Vec<[f64; 2]>> = match look.dash {
                Some(dash) => visible.iter().flat_map(|piece| dashes(piece, dash)).collect(),
                None => visible.clone(),
            };
            painter.strokes(&lines, look.stroke, look.width, 1.0)?;
            if series.role == Role::QuasiPeriodic {
                for center in visible.iter().flat_map(|piece| beads(piece)) {
                    painter.disc(center, look.radius, context.theme.ground)?;
                    painter.circle(center, look.radius - 0.45, look.stroke, 0.9 * context.theme.lines)?;
                }
            }
            for piece in &visible {
                crowd.add_line(piece);
            }
            wanted.filter(|_| !visible.is_empty()).map(|at| Anchor::Curve(visible, at))
        }
        Mark::Filled => {
            let mut area: Option<Rect> = None;
            for range in pieces(series) {
                let corners = clip_polygon(&pixels[range], &low, &high);
                painter.polygon(&corners, look.fill, look.opacity)?;
                let closed: Vec<[f64; 2]> = corners.iter().chain(corners.iter().take(2)).copied().collect();
                painter.strokes(std::slice::from_ref(&closed), look.stroke, look.width, 1.0)?;
                crowd.add_line(&closed);
                crowd.add_area(corners.clone(), look.fill.over(context.theme.ground, look.opacity));
                area = corners.iter().fold(area, |area, point| Some(with_point(area, *point)));
            }
            area.map(|area| Anchor::Area(area, series.label_at))
        }
        Mark::Cloud => {
            let seen: Vec<[f64; 2]> =
                pixels.into_iter().filter(|point| context.plot.holds_point(*point, 0.0)).collect();
            painter.cloud(
                &seen,
                cloud_diameter(series.role) * context.theme.marks,
                look.stroke,
                look.opacity,
            )?;
            for &point in &seen {
                crowd.add_point(point);
            }
            wanted.filter(|_| !seen.is_empty()).map(|at| Anchor::Mark(at, 4.0))
        }
        Mark::Marks => {
            let seen: Vec<[f64; 2]> =
                pixels.into_iter().filter(|point| context.plot.holds_point(*point, 0.5)).collect();
            draw_marks(painter, series, &look, &seen, context.theme, crowd)?;
            wanted.filter(|at| seen.contains(at)).map(|at| Anchor::Mark(at, look.radius))
        }
        Mark::Band => draw_band(painter, [pixels[0], pixels[1]], &look, context)?.map(|area| {
            let corners = vec![
                [area.left, area.top],
                [area.right, area.top],
                [area.right, area.bottom],
                [area.left, area.bottom],
            ];
            crowd.add_area(corners, look.fill.over(context.theme.ground, look.opacity));
            Anchor::Area(area, series.label_at)
        }),
        // A text whose place is not shown names nothing that is.
        Mark::Text => {
            wanted.filter(|at| context.bare || context.plot.holds_point(*at, 0.5)).map(Anchor::Place)
        }
        Mark::Field => None,
    })
}

/// Places along a line for the open circles that tell quasi-periodic motion: evenly spaced, the first half a space from
/// the begin.
fn beads(line: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut places = Vec::new();
    let mut ahead = BEADS / 2.0;
    for pair in line.windows(2) {
        let (from, to) = (pair[0], pair[1]);
        let length = (to[0] - from[0]).hypot(to[1] - from[1]);
        while ahead <= length && length > 0.0 {
            let t = ahead / length;
            places.push([from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])]);
            ahead += BEADS;
        }
        ahead -= length;
    }
    places
}

/// Single marks: many small ones at once as a cloud of larger dots, others one by one.
fn draw_marks<S: Surface>(
    painter: &mut Painter<'_, S>,
    series: &Series,
    look: &Look,
    seen: &[[f64; 2]],
    theme: &Theme,
    crowd: &mut Crowd,
) -> Result<(), ChartError> {
    if matches!(series.role, Role::Trajectory | Role::Downward) {
        painter.cloud(seen, 2.0 * look.radius, look.stroke, 1.0)?;
        for &point in seen {
            crowd.add_point(point);
        }
        return Ok(());
    }
    let open =
        series.stable == Some(false) && matches!(series.role, Role::Exact | Role::Corrected | Role::Paper);
    for &center in seen {
        draw_mark(painter, center, look, open, theme)?;
        crowd.add_box(Rect::around(center, 1.7 * look.radius, 1.7 * look.radius));
    }
    Ok(())
}

fn cloud_diameter(role: Role) -> f64 {
    match role {
        Role::Attractor | Role::Exact => 2.4,
        Role::Downward => 1.1,
        _ => 1.7,
    }
}

fn with_point(area: Option<Rect>, [x, y]: [f64; 2]) -> Rect {
    area.map_or(Rect { left: x, top: y, right: x, bottom: y }, |area| Rect {
        left: area.left.min(x),
        top: area.top.min(y),
        right: area.right.max(x),
        bottom: area.bottom.max(y),
    })
}

/// Fills a band, hatches it if its meaning wants it, and draws the edges that lie within the plot.
fn draw_band<S: Surface>(
    painter: &mut Painter<'_, S>,
    [one, other]: [[f64; 2]; 2],
    look: &Look,
    context: &Context<'_>,
) -> Result<Option<Rect>, ChartError> {
    let plot = context.plot;
    let whole = with_point(Some(with_point(None, one)), other);
    let area = Rect {
        left: whole.left.max(plot.left),
        top: whole.top.max(plot.top),
        right: whole.right.min(plot.right),
        bottom: whole.bottom.min(plot.bottom),
    };
    if area.width() <= 0.0 || area.height() <= 0.0 {
        return Ok(None);
    }
    painter.rectangle(&area, look.fill, look.opacity)?;
    let (low, high) = area.corners();
    if look.hatch {
        let mut lines = Vec::new();
        let first = ((area.left + area.top) / HATCH).ceil() as i64;
        let last = ((area.right + area.bottom) / HATCH).floor() as i64;
        for index in first..=last {
            let sum = index as f64 * HATCH;
            let (from, to) = ([sum - area.bottom, area.bottom], [sum - area.top, area.top]);
            if let Some((enter, leave)) = clip_segment(&from, &to, &low, &high) {
                let at = |t: f64| [from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])];
                lines.push(vec![at(enter), at(leave)]);
            }
        }
        painter.strokes(&lines, look.fill, 0.6 * context.theme.lines, 0.32)?;
    }
    let mut edges = Vec::new();
    for y in [whole.top, whole.bottom].into_iter().filter(|y| (plot.top..=plot.bottom).contains(y)) {
        edges.push(vec![[area.left, y], [area.right, y]]);
    }
    if !look.hatch {
        for x in [whole.left, whole.right].into_iter().filter(|x| (plot.left..=plot.right).contains(x)) {
            edges.push(vec![[x, area.top], [x, area.bottom]]);
        }
    }
    painter.strokes(&edges, look.stroke, 0.8 * context.theme.lines, 1.0)?;
    Ok(Some(area))
}

/// Draws all series of a 3-D frame from back to front, notes their ink, and says where each label belongs.
///
/// # Errors
/// [`ChartError::NotFinite`] if the data lie so far off that they have no pixel, and what the backend fails with.
pub fn draw_solid<S: Surface>(
    painter: &mut Painter<'_, S>,
    all: &[&Series],
    projection: &Projection,
    context: &Context<'_>,
    crowd: &mut Crowd,
) -> Result<Vec<Option<Anchor>>, ChartError> {
    let (low, high) = projection.limits();
    let mut anchors = Vec::with_capacity(all.len());
    let mut stretches: Vec<(f64, usize, Vec<[f64; 2]>)> = Vec::new();
    let mut marks: Vec<(f64, usize, [f64; 2])> = Vec::new();
    for (index, series) in all.iter().enumerate() {
        let look = context.look(series);
        let points: Vec<[f64; 3]> =
            (0..series.x.len()).map(|i| [series.x[i], series.y[i], series.z[i]]).collect();
        if !points.iter().flat_map(|point| projection.pixel(point)).all(f64::is_finite) {
            return Err(ChartError::NotFinite { name: series.name.clone() });
        }
        let within = |point: &[f64; 3]| (0..3).all(|i| (low[i]..=high[i]).contains(&point[i]));
        let wanted = wanted(series).map(|at| points[at]);
        let anchor = match series.mark {
            Mark::Curve | Mark::Filled => {
                let mut visible = Vec::new();
                for piece in pieces(series).flat_map(|range| clip_polyline(&points[range], low, high)) {
                    let flat: Vec<[f64; 2]> = piece.iter().map(|point| projection.pixel(point)).collect();
                    crowd.add_line(&flat);
                    cut_by_depth(&piece, &flat, look.dash, projection, |depth, line| {
                        stretches.push((depth + precedence(series.role), index, line));
                    });
                    visible.push(flat);
                }
                wanted.filter(|_| !visible.is_empty()).map(|at| Anchor::Curve(visible, projection.pixel(&at)))
            }
            Mark::Cloud => {
                let seen: Vec<[f64; 2]> = points
                    .iter()
                    .filter(|point| within(point))
                    .map(|point| projection.pixel(point))
                    .collect();
                painter.cloud(
                    &seen,
                    cloud_diameter(series.role) * context.theme.marks,
                    look.stroke,
                    look.opacity,
                )?;
                None
            }
            Mark::Marks => {
                let seen = points.iter().filter(|point| within(point));
                marks.extend(seen.map(|point| (projection.nearness(point), index, projection.pixel(point))));
                wanted.filter(within).map(|at| Anchor::Mark(projection.pixel(&at), look.radius))
            }
            Mark::Text => wanted.map(|at| Anchor::Place(projection.pixel(&at))),
            Mark::Band | Mark::Field => None,
        };
        anchors.push(anchor);
    }
    order::by_number(&mut stretches, |stretch| stretch.0);
    let mut start = 0;
    while start < stretches.len() {
        let owner = stretches[start].1;
        let end = start + stretches[start..].iter().take_while(|stretch| stretch.1 == owner).count();
        let look = context.look(all[owner]);
        let lines: Vec<Vec<[f64; 2]>> =
            stretches[start..end].iter().map(|stretch| stretch.2.clone()).collect();
        painter.strokes(&lines, look.stroke, look.width, 1.0)?;
        start = end;
    }
    // Marks lie on the curves: they come last, the nearest on top.
    order::by_number(&mut marks, |mark| mark.0);
    for (_, owner, center) in marks {
        let look = context.look(all[owner]);
        draw_marks(painter, all[owner], &look, &[center], context.theme, crowd)?;
    }
    Ok(anchors)
}

/// Depth by which a series comes forward: where two curves run together the same one is on top all along.
fn precedence(role: Role) -> f64 {
    match role {
        Role::Exact => 0.12,
        Role::Corrected | Role::CorrectedSecond => 0.06,
        _ => 0.0,
    }
}

/// Cuts a curve into dashes or short stretches with their mean depth. Stretches overlap by a segment: no seams show.
fn cut_by_depth(
    piece: &[[f64; 3]],
    flat: &[[f64; 2]],
    dash: Option<[f64; 2]>,
    projection: &Projection,
    mut take: impl FnMut(f64, Vec<[f64; 2]>),
) {
    if let Some(dash) = dash {
        // A dash is short: the depth of the curve's nearest point will do.
        let mut from = 0;
        for line in dashes(flat, dash) {
            let middle = line[line.len() / 2];
            let away = |i: usize| (flat[i][0] - middle[0]).hypot(flat[i][1] - middle[1]);
            let reach = (from + 400).min(flat.len());
            let near = (from..reach).min_by(|&a, &b| away(a).total_cmp(&away(b))).unwrap_or(from);
            from = near;
            take(projection.nearness(&piece[near]), line);
        }
        return;
    }
    let mut start = 0;
    while start + 1 < flat.len() {
        let (mut end, mut length) = (start, 0.0);
        while end + 1 < flat.len() && length < STRETCH {
            length += (flat[end + 1][0] - flat[end][0]).hypot(flat[end + 1][1] - flat[end][1]);
            end += 1;
        }
        let depth = piece[start..=end].iter().map(|point| projection.nearness(point)).sum::<f64>()
            / (end - start + 1) as f64;
        take(depth, flat[start..=(end + 1).min(flat.len() - 1)].to_vec());
        start = end;
    }
}
