//! Single marks: dot, star, diamond, triangle, cross, ring, each with a rim of the ground about it.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use super::painter::Painter;
use super::surface::Surface;
use super::theme::{Look, Shape, Theme};
use crate::error::ChartError;

/// Width of the rim that parts a mark from the lines under it, CSS pixels.
const RIM: f64 = 1.3;
/// Inner over outer radius of the star whose edges run straight through (a pentagram).
const PENTAGRAM: f64 = 0.381_966_011_250_105;
/// A star a little fuller than the pentagram, which looks thin when small.
const FULLNESS: f64 = 1.12;

/// Draws one mark at a pixel.
///
/// # Errors
/// What the backend fails with.
pub fn draw_mark<S: Surface>(
    painter: &mut Painter<'_, S>,
    center: [f64; 2],
    look: &Look,
    open: bool,
    theme: &Theme,
) -> Result<(), ChartError> {
    let (radius, line) = (look.radius, theme.lines);
    match look.shape {
        Shape::Dot if open => {
            painter.disc(center, radius, theme.ground)?;
            painter.circle(center, radius - 0.8 * line, look.stroke, 1.6 * line)
        }
        Shape::Dot => {
            painter.disc(center, radius + RIM, theme.ground)?;
            painter.disc(center, radius, look.stroke)?;
            match look.outline {
                Some(outline) => painter.circle(center, radius - 0.4 * line, outline, 0.8 * line),
                None => Ok(()),
            }
        }
        Shape::Ring => {
            painter.disc(center, radius + RIM, theme.ground)?;
            painter.circle(center, radius - 0.8 * line, look.stroke, 1.6 * line)?;
            painter.disc(center, radius * 0.4, look.stroke)
        }
        Shape::Cross => {
            let arm = radius * 0.8;
            let arms = [[-arm, -arm], [-arm, arm]]
                .map(|[x, y]| vec![[center[0] + x, center[1] + y], [center[0] - x, center[1] - y]]);
            painter.strokes(&arms, theme.ground, 2.0 * line + 2.0 * RIM, 1.0)?;
            painter.strokes(&arms, look.stroke, 2.0 * line, 1.0)
        }
        Shape::Diamond => {
            let corners = outline(center, &[radius; 4], 0.0);
            filled(painter, &corners, look, theme, true)
        }
        Shape::Triangle => {
            let corners = outline(center, &[radius; 3], -FRAC_PI_2);
            filled(painter, &corners, look, theme, false)
        }
        Shape::Star => {
            let inner = radius * PENTAGRAM * FULLNESS;
            let radii: [f64; 10] = std::array::from_fn(|i| if i % 2 == 0 { radius } else { inner });
            filled(painter, &outline(center, &radii, -FRAC_PI_2), look, theme, open)
        }
    }
}

/// Corners at equal angles about a centre, at these distances, the first in the direction `start` (radians, clockwise from the right).
fn outline(center: [f64; 2], radii: &[f64], start: f64) -> Vec<[f64; 2]> {
    let count = radii.len() as f64;
    radii
        .iter()
        .enumerate()
        .map(|(i, radius)| {
            let (sine, cosine) = (start + TAU * i as f64 / count).rem_euclid(2.0 * PI).sin_cos();
            [center[0] + radius * cosine, center[1] + radius * sine]
        })
        .collect()
}

fn filled<S: Surface>(
    painter: &mut Painter<'_, S>,
    corners: &[[f64; 2]],
    look: &Look,
    theme: &Theme,
    open: bool,
) -> Result<(), ChartError> {
    // The second corner again: so the join at the first is round as the others.
    let closed: Vec<[f64; 2]> = corners.iter().chain(corners.iter().take(2)).copied().collect();
    painter.strokes(std::slice::from_ref(&closed), theme.ground, 2.0 * RIM + 1.0, 1.0)?;
    painter.polygon(corners, if open { theme.ground } else { look.stroke }, 1.0)?;
    let width = if open { 1.5 } else { 0.9 } * theme.lines;
    painter.strokes(&[closed], look.outline.unwrap_or(look.stroke), width, 1.0)
}
