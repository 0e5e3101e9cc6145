//! The whole picture: ground, axes, series, labels, frame by frame.

use super::axes::draw_axes;
use super::bar::draw_bar;
use super::drawing::{Drawing, Mark, Series};
use super::geometry::Rect;
use super::labels::{Anchor, Crowd, Request, place};
use super::layout::{Panel, panels};
use super::painter::{Align, Painter};
use super::series::{Context, check, draw_plane, draw_solid};
use super::surface::Surface;
use super::svg::{SvgSurface, check_size};
use super::theme::Theme;
use super::three_d::{Projection, draw_box};
use super::view::View;
use crate::error::ChartError;

/// Thinner lines are not printed everywhere, CSS pixels: 0.4 points.
const THINNEST: f64 = 0.55;

/// How the pixels of a frame and its data belong together.
#[derive(Clone, Debug, PartialEq)]
pub struct FrameMap {
    /// Name of the frame.
    pub name: String,
    /// Left, top, right and bottom of the plot, CSS pixels.
    pub plot: [f64; 4],
    /// Data at the left and the right edge (3-D: ends of the first axis).
    pub x: (f64, f64),
    /// Data at the lower and the upper edge (3-D: ends of the second axis).
    pub y: (f64, f64),
    /// 3-D: rows of P in pixel = P (x, y, z, 1).
    pub projection: Option<[[f64; 4]; 2]>,
}

/// Draws a drawing on a surface, over all of it, and says where the frames came to lie.
///
/// # Errors
/// [`ChartError::Size`] outside of 120..8192 CSS pixels a side, [`ChartError::NotFinite`] and [`ChartError::Malformed`]
/// before anything is drawn, [`ChartError::Backend`] with the surface's own words.
pub fn draw<S: Surface>(
    surface: &mut S,
    drawing: &Drawing,
    theme: &Theme,
    view: &View,
) -> Result<Vec<FrameMap>, ChartError> {
    let mut painter = Painter::new(surface);
    let (width, height) = painter.size();
    check_size(width, height)?;
    check(drawing)?;
    if !(view.azimuth.is_finite() && view.elevation.is_finite()) {
        return Err(ChartError::NotFinite { name: "view".to_owned() });
    }
    painter.begin()?;
    painter.rectangle(&Rect { left: 0.0, top: 0.0, right: width, bottom: height }, theme.ground, 1.0)?;
    let mut maps = Vec::with_capacity(drawing.frames.len());
    for (index, panel) in panels(drawing, width, height, theme.letters).into_iter().enumerate() {
        let panel = &panel.written_with(view.decimal);
        let own: Vec<&Series> = drawing.series.iter().filter(|series| series.frame == index).collect();
        maps.push(draw_frame(&mut painter, drawing, index, panel, &own, theme, view)?);
    }
    painter.finish()?;
    Ok(maps)
}

/// A drawing as SVG text of a width and height in CSS pixels, with a title and a description for those who do not see it.
///
/// # Errors
/// As [`draw`].
pub fn svg(
    drawing: &Drawing,
    title: &str,
    description: &str,
    size: (f64, f64),
    theme: &Theme,
    view: &View,
) -> Result<String, ChartError> {
    let mut surface = SvgSurface::new(size)?;
    draw(&mut surface, drawing, theme, view)?;
    Ok(surface.finish(title, description))
}

fn draw_frame<S: Surface>(
    painter: &mut Painter<'_, S>,
    drawing: &Drawing,
    index: usize,
    panel: &Panel,
    own: &[&Series],
    theme: &Theme,
    view: &View,
) -> Result<FrameMap, ChartError> {
    let frame = &drawing.frames[index];
    let mut crowd = Crowd::new(panel.cell, theme.ground);
    let solid = frame
        .z
        .as_ref()
        .map(|z| Projection::new([&frame.x, &frame.y, z], &panel.plot, panel.sizes.tick, view));
    let context = Context {
        theme,
        plot: panel.plot,
        mark: panel.sizes.mark,
        bar: frame.bar.as_ref(),
        bare: frame.bare,
    };
    let anchors = if let Some(projection) = &solid {
        draw_box(painter, frame, panel, projection, theme, view.decimal)?;
        draw_solid(painter, own, projection, &context, &mut crowd)?
    } else {
        draw_axes(painter, frame, panel, theme)?;
        if let Some(bar) = &panel.bar {
            draw_bar(painter, bar, panel, theme)?;
        }
        let map = panel.map(frame);
        let mut anchors = Vec::with_capacity(own.len());
        for series in own {
            let drawn = series.mark != Mark::Text;
            if drawn {
                painter.open(&series.name, &series.meaning);
            }
            anchors.push(draw_plane(painter, series, &map, &context, &mut crowd)?);
            if drawn {
                painter.close();
            }
        }
        anchors
    };
    let within = if frame.bare || solid.is_some() { panel.cell } else { panel.plot };
    draw_labels(painter, own, anchors, panel, &mut crowd, &within, theme)?;
    let plot = panel.plot;
    Ok(FrameMap {
        name: frame.name.clone(),
        plot: [plot.left, plot.top, plot.right, plot.bottom],
        x: (frame.x.low, frame.x.high),
        y: (frame.y.low, frame.y.high),
        projection: solid.map(|projection| projection.rows),
    })
}

fn draw_labels<S: Surface>(
    painter: &mut Painter<'_, S>,
    own: &[&Series],
    anchors: Vec<Option<Anchor>>,
    panel: &Panel,
    crowd: &mut Crowd,
    within: &Rect,
    theme: &Theme,
) -> Result<(), ChartError> {
    let requests: Vec<Request> = own
        .iter()
        .zip(anchors)
        .filter_map(|(series, anchor)| {
            let markup = series.label.as_ref().filter(|label| !label.is_empty())?.clone();
            let look = theme.look(series.role, series.stable);
            let size = panel.sizes.tick + 0.5;
            Some(Request { markup, size, color: look.text, anchor: anchor? })
        })
        .collect();
    let placed = place(&requests, crowd, within);
    for found in &placed {
        if let Some((from, to)) = found.leader {
            painter.line(from, to, found.color, (0.7 * theme.lines).max(THINNEST))?;
        }
    }
    for found in &placed {
        painter.label(&found.label, found.at, Align::Left, found.color, Some(found.ground))?;
    }
    Ok(())
}
