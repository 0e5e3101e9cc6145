//! Fields: numbers over a grid of places, painted as one image.

use super::drawing::{Axis, Role, Series};
use super::geometry::{PlaneMap, Rect};
use super::painter::Painter;
use super::ramp::{SHADES, region, shade};
use super::surface::{Image, Surface};
use super::theme::{Color, Theme};
use crate::error::ChartError;

/// Most regions that are told apart by a number of their own; beyond them colours come round again.
const MOST_REGIONS: usize = 250;
/// Index of pixels that are not painted.
const CLEAR: u8 = u8::MAX;
/// The value of a map of basins whose starts escape.
const ESCAPED: f64 = -1.0;

/// The colours in which the pixels of a field are painted: those of the ramp, or one a region and one for escape.
fn palette(role: Role, theme: &Theme) -> Vec<Color> {
    if role == Role::Basins {
        let regions = (0..MOST_REGIONS).map(|index| region(theme, index));
        regions.chain([theme.escaped()]).collect()
    } else {
        (0..SHADES).map(|index| shade(theme, index)).collect()
    }
}

/// The colour of a value by its place in the [`palette`].
fn color_index(role: Role, value: f64, bar: Option<&Axis>) -> u8 {
    if role == Role::Basins {
        return match value {
            value if value >= 0.0 => (value as usize % MOST_REGIONS) as u8,
            ESCAPED => MOST_REGIONS as u8,
            _ => CLEAR,
        };
    }
    let Some(Axis { low, high, .. }) = bar else { return CLEAR };
    if value <= *low {
        return CLEAR;
    }
    let fraction = (value - low) / (high - low);
    ((fraction * SHADES as f64) as usize).min(SHADES - 1) as u8
}

/// Where a place lies among evenly spaced places: the one before it, and how far it is on the way to the next.
fn between(places: &[f64], wanted: f64) -> (usize, f64) {
    let last = places.len() - 1;
    if last == 0 {
        return (0, 0.0);
    }
    let along = (wanted - places[0]) / (places[last] - places[0]) * last as f64;
    let before = (along.floor().max(0.0) as usize).min(last - 1);
    (before, (along - before as f64).clamp(0.0, 1.0))
}

/// Paints a field over the part of the plot that it covers.
///
/// # Errors
/// What the backend fails with.
pub fn draw_field<S: Surface>(
    painter: &mut Painter<'_, S>,
    series: &Series,
    bar: Option<&Axis>,
    map: &PlaneMap,
    theme: &Theme,
) -> Result<(), ChartError> {
    let Some(area) = covered(series, map) else { return Ok(()) };
    let pixel = painter.image_pixel();
    let count = |length: f64| (length / pixel).round().max(1.0) as usize;
    let (columns, rows) = (count(area.width()), count(area.height()));
    let data_x = |column: usize| {
        let left = area.left + (column as f64 + 0.5) / columns as f64 * area.width();
        map.x.0 + (left - map.plot.left) / map.plot.width() * (map.x.1 - map.x.0)
    };
    let data_y = |row: usize| {
        let top = area.top + (row as f64 + 0.5) / rows as f64 * area.height();
        map.y.1 - (top - map.plot.top) / map.plot.height() * (map.y.1 - map.y.0)
    };
    let across: Vec<(usize, f64)> = (0..columns).map(|column| between(&series.x, data_x(column))).collect();
    let wide = series.x.len();
    let regions = series.role == Role::Basins;
    let mut pixels = Vec::with_capacity(columns * rows);
    // A row's values between the rows of the grid, to be read between its columns.
    let mut line = vec![0.0; wide];
    for row in 0..rows {
        let (below, up) = between(&series.y, data_y(row));
        let above = (below + 1).min(series.y.len() - 1);
        let grid = |row: usize| &series.z[row * wide..(row + 1) * wide];
        for (value, (lower, upper)) in line.iter_mut().zip(grid(below).iter().zip(grid(above))) {
            *value = match (regions, up < 0.5) {
                (true, true) => *lower,
                (true, false) => *upper,
                (false, _) => lower * (1.0 - up) + upper * up,
            };
        }
        for &(before, along) in &across {
            let (left, right) = (line[before], line[(before + 1).min(wide - 1)]);
            let value = match (regions, along < 0.5) {
                (true, true) => left,
                (true, false) => right,
                (false, _) => left * (1.0 - along) + right * along,
            };
            pixels.push(color_index(series.role, value, bar));
        }
    }
    let palette = palette(series.role, theme);
    painter.image(&Image { pixels: &pixels, columns, colors: &palette }, &area)
}

/// The part of the plot that a field covers.
fn covered(series: &Series, map: &PlaneMap) -> Option<Rect> {
    let (first_x, last_x) = (series.x.first()?, series.x.last()?);
    let (first_y, last_y) = (series.y.first()?, series.y.last()?);
    let ([left, bottom], [right, top]) = (map.pixel(*first_x, *first_y), map.pixel(*last_x, *last_y));
    let area = Rect {
        left: left.max(map.plot.left),
        top: top.max(map.plot.top),
        right: right.min(map.plot.right),
        bottom: bottom.min(map.plot.bottom),
    };
    (area.width() > 0.0 && area.height() > 0.0).then_some(area)
}

#[cfg(test)]
mod tests {
    use super::{CLEAR, between, color_index};
    use crate::chart::drawing::{Axis, Role};

    #[test]
    fn a_place_is_found_between_its_neighbours() {
        let places = [0.0, 0.5, 1.0, 1.5];
        assert_eq!(between(&places, 0.75), (1, 0.5));
        assert_eq!(between(&places, -1.0), (0, 0.0));
        assert_eq!(between(&places, 1.5), (2, 1.0));
        assert_eq!(between(&[3.0], 7.0), (0, 0.0));
    }

    #[test]
    fn what_does_not_grow_is_left_clear_and_what_grows_most_has_the_last_shade() {
        let bar = Axis { name: "g".into(), label: "g".into(), low: 0.0, high: 0.2 };
        let index = |value: f64| color_index(Role::Growth, value, Some(&bar));
        assert_eq!((index(-0.1), index(0.0), index(1e-9), index(0.2), index(7.0)), (CLEAR, CLEAR, 0, 63, 63));
        let region = |value: f64| color_index(Role::Basins, value, None);
        assert_eq!((region(-2.0), region(-1.0), region(0.0), region(251.0)), (CLEAR, 250, 0, 1));
    }
}
