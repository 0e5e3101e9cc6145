//! Clouds as images: the coverage of many small discs, counted pixel by pixel.

/// An image of opacities over a part of a larger picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Coverage {
    /// Left and upper pixel of the image within the picture.
    pub origin: (usize, usize),
    /// Columns and rows.
    pub size: (usize, usize),
    /// Opacity of each pixel, 0 to 1, row by row.
    pub alpha: Vec<f32>,
}

/// Sub-pixel places in each direction for which a disc is computed once.
const PLACES: i32 = 8;

/// Opacity of discs of a diameter (at least half a pixel is drawn) at these places, all in pixels of the picture; overlapping discs add up as
/// layers of paint do. None without points, or if all lie outside of the picture of this size.
pub fn coverage(
    points: &[(f64, f64)],
    diameter: f64,
    alpha: f64,
    (width, height): (usize, usize),
) -> Option<Coverage> {
    let radius = diameter.max(0.5) / 2.0;
    let reach = (radius + 1.0).ceil();
    let inside = |&&(x, y): &&(f64, f64)| {
        x >= -reach && y >= -reach && x <= width as f64 + reach && y <= height as f64 + reach
    };
    let (mut left, mut top, mut right, mut bottom) = (f64::MAX, f64::MAX, f64::MIN, f64::MIN);
    for &(x, y) in points.iter().filter(inside) {
        (left, top, right, bottom) = (left.min(x), top.min(y), right.max(x), bottom.max(y));
    }
    if left > right {
        return None;
    }
    let (left, top) = ((left - reach).floor().max(0.0) as usize, (top - reach).floor().max(0.0) as usize);
    let (right, bottom) =
        (((right + reach).ceil() as usize).min(width), ((bottom + reach).ceil() as usize).min(height));
    let (columns, rows) = (right.saturating_sub(left), bottom.saturating_sub(top));
    if columns == 0 || rows == 0 {
        return None;
    }
    let side = 2 * reach as usize + 1;
    let stamps = stamps(radius, side, alpha);
    let mut image = vec![1.0_f32; columns * rows];
    for &(x, y) in points.iter().filter(inside) {
        // The place within the pixel, to an eighth: finer is not seen.
        let eighths = |value: f64| (value * f64::from(PLACES)).round() as i32;
        let (fine_x, fine_y) = (eighths(x), eighths(y));
        let place = (fine_y.rem_euclid(PLACES) * PLACES + fine_x.rem_euclid(PLACES)) as usize;
        let first = [fine_x, fine_y].map(|fine| fine.div_euclid(PLACES) - reach as i32);
        for row in 0..side {
            let Some(to_row) = index(first[1], row, top, rows) else { continue };
            for column in 0..side {
                if let Some(to_column) = index(first[0], column, left, columns) {
                    image[to_row * columns + to_column] *= stamps[place][row * side + column];
                }
            }
        }
    }
    // Held until here is what each pixel lets through.
    for through in &mut image {
        *through = 1.0 - *through;
    }
    Some(Coverage { origin: (left, top), size: (columns, rows), alpha: image })
}

/// Position within the image of a pixel so many after the first, if it is within.
fn index(first: i32, after: usize, origin: usize, count: usize) -> Option<usize> {
    let offset = after.checked_add_signed(first as isize)?.checked_sub(origin)?;
    (offset < count).then_some(offset)
}

/// What a disc lets through of each pixel around it, for every place of its middle within a pixel.
fn stamps(radius: f64, side: usize, alpha: f64) -> Vec<Vec<f32>> {
    let reach = (side / 2) as f64;
    (0..PLACES * PLACES)
        .map(|place| {
            let middle =
                [place % PLACES, place / PLACES].map(|part| f64::from(part) / f64::from(PLACES) + reach);
            (0..side * side)
                .map(|pixel| {
                    let corner = [(pixel % side) as f64, (pixel / side) as f64];
                    (1.0 - alpha * disc_share(corner, middle, radius)) as f32
                })
                .collect()
        })
        .collect()
}

/// Share of a pixel that a disc covers, by sampling 4 x 4 points.
fn disc_share(corner: [f64; 2], middle: [f64; 2], radius: f64) -> f64 {
    const SAMPLES: usize = 4;
    let hit = (0..SAMPLES * SAMPLES)
        .filter(|sample| {
            let at = |part: usize| (part as f64 + 0.5) / SAMPLES as f64;
            let x = corner[0] + at(sample % SAMPLES) - middle[0];
            let y = corner[1] + at(sample / SAMPLES) - middle[1];
            x * x + y * y <= radius * radius
        })
        .count();
    hit as f64 / (SAMPLES * SAMPLES) as f64
}

#[cfg(test)]
mod tests {
    use super::coverage;

    #[test]
    fn a_disc_covers_its_area_about_its_middle() {
        for place in [(20.0, 30.0), (20.37, 30.81), (25.5, 33.5)] {
            let image = coverage(&[place], 6.0, 1.0, (100, 100)).unwrap();
            let mut sums = [0.0_f64; 3];
            for (pixel, &alpha) in image.alpha.iter().enumerate() {
                let x = image.origin.0 as f64 + (pixel % image.size.0) as f64 + 0.5;
                let y = image.origin.1 as f64 + (pixel / image.size.0) as f64 + 0.5;
                let alpha = f64::from(alpha);
                sums = [sums[0] + alpha, sums[1] + alpha * x, sums[2] + alpha * y];
            }
            assert!((sums[0] / (std::f64::consts::PI * 9.0) - 1.0).abs() < 0.03, "{}", sums[0]);
            assert!((sums[1] / sums[0] - place.0).abs() < 0.08 && (sums[2] / sums[0] - place.1).abs() < 0.08);
        }
    }

    #[test]
    fn overlapping_points_thicken_and_never_exceed_one() {
        let once = coverage(&[(5.0, 5.0)], 2.0, 0.5, (10, 10)).unwrap();
        let often = coverage(&[(5.0, 5.0); 9], 2.0, 0.5, (10, 10)).unwrap();
        let most = |alpha: &[f32]| alpha.iter().copied().fold(0.0, f32::max);
        assert!(most(&often.alpha) > most(&once.alpha) && most(&often.alpha) <= 1.0);
    }

    #[test]
    fn points_outside_leave_nothing_and_do_no_harm() {
        assert!(coverage(&[(-50.0, 5.0), (5.0, 1e9)], 2.0, 1.0, (10, 10)).is_none());
        assert!(coverage(&[], 2.0, 1.0, (10, 10)).is_none());
        let image = coverage(&[(0.0, 0.0), (10.0, 10.0)], 3.0, 1.0, (10, 10)).unwrap();
        assert_eq!((image.origin, image.size), ((0, 0), (10, 10)));
    }
}
