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
/// Rows of one band. A whole picture at once would take tens of megabytes, which a module's memory never gives back.
const BAND: usize = 64;

/// A disc: the first pixel of its stamp, and which stamp.
struct Disc {
    column: i32,
    row: i32,
    place: usize,
}

/// Opacity of discs of a diameter (at least half a pixel is drawn) at these places, all in pixels of the picture; overlapping discs add up as
/// layers of paint do. It comes in bands from above, each as wide as what is in it; none where there is nothing in the picture of this size.
pub fn coverage(
    points: &[(f64, f64)],
    diameter: f64,
    alpha: f64,
    (width, height): (usize, usize),
) -> impl Iterator<Item = Coverage> {
    let radius = diameter.max(0.5) / 2.0;
    let reach = (radius + 1.0).ceil();
    let side = 2 * reach as usize + 1;
    let mut bands: Vec<Vec<Disc>> = (0..height.div_ceil(BAND)).map(|_| Vec::new()).collect();
    for &(x, y) in points {
        if !(x >= -reach && y >= -reach && x <= width as f64 + reach && y <= height as f64 + reach) {
            continue;
        }
        // The place within the pixel, to an eighth: finer is not seen.
        let eighths = |value: f64| (value * f64::from(PLACES)).round() as i32;
        let (fine_x, fine_y) = (eighths(x), eighths(y));
        let place = (fine_y.rem_euclid(PLACES) * PLACES + fine_x.rem_euclid(PLACES)) as usize;
        let [column, row] = [fine_x, fine_y].map(|fine| fine.div_euclid(PLACES) - reach as i32);
        let last = row.saturating_add_unsigned(side as u32 - 1);
        if last < 0 {
            continue;
        }
        let touched = row.max(0) as usize / BAND..=last as usize / BAND;
        for band in bands.iter_mut().take(*touched.end() + 1).skip(*touched.start()) {
            band.push(Disc { column, row, place });
        }
    }
    let stamps = stamps(radius, side, alpha);
    bands.into_iter().enumerate().filter_map(move |(band, discs)| {
        let top = band * BAND;
        painted(&discs, &stamps, side, (top, BAND.min(height - top)), width)
    })
}

/// The discs' opacity in so many rows from a first one on; none where they leave nothing there.
fn painted(
    discs: &[Disc],
    stamps: &[Vec<f32>],
    side: usize,
    (top, rows): (usize, usize),
    width: usize,
) -> Option<Coverage> {
    let left = discs.iter().map(|disc| disc.column).min()?.max(0) as usize;
    let right =
        discs.iter().map(|disc| disc.column.saturating_add_unsigned(side as u32)).max()?.max(0) as usize;
    let columns = right.min(width).checked_sub(left).filter(|&columns| columns > 0)?;
    let mut image = vec![1.0_f32; columns * rows];
    for disc in discs {
        let stamp = &stamps[disc.place];
        for row in 0..side {
            let Some(to_row) = index(disc.row, row, top, rows) else { continue };
            for column in 0..side {
                if let Some(to_column) = index(disc.column, column, left, columns) {
                    image[to_row * columns + to_column] *= stamp[row * side + column];
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
        // The last two lie across the edge of two bands.
        for place in [(20.0, 30.0), (20.37, 30.81), (25.5, 33.5), (40.2, 64.0), (41.0, 62.3)] {
            let mut sums = [0.0_f64; 3];
            for image in coverage(&[place], 6.0, 1.0, (100, 100)) {
                for (pixel, &alpha) in image.alpha.iter().enumerate() {
                    let x = image.origin.0 as f64 + (pixel % image.size.0) as f64 + 0.5;
                    let y = image.origin.1 as f64 + (pixel / image.size.0) as f64 + 0.5;
                    let alpha = f64::from(alpha);
                    sums = [sums[0] + alpha, sums[1] + alpha * x, sums[2] + alpha * y];
                }
            }
            assert!((sums[0] / (std::f64::consts::PI * 9.0) - 1.0).abs() < 0.03, "{}", sums[0]);
            assert!((sums[1] / sums[0] - place.0).abs() < 0.08 && (sums[2] / sums[0] - place.1).abs() < 0.08);
        }
    }

    #[test]
    fn overlapping_points_thicken_and_never_exceed_one() {
        let most = |points: &[(f64, f64)]| {
            let images = coverage(points, 2.0, 0.5, (10, 10));
            images.flat_map(|image| image.alpha).fold(0.0, f32::max)
        };
        let (once, often) = (most(&[(5.0, 5.0)]), most(&[(5.0, 5.0); 9]));
        assert!(often > once && often <= 1.0);
    }

    #[test]
    fn points_outside_leave_nothing_and_do_no_harm() {
        let nowhere = [(-50.0, 5.0), (5.0, 1e9), (f64::NAN, 5.0)];
        assert!(coverage(&nowhere, 2.0, 1.0, (10, 10)).next().is_none());
        assert!(coverage(&[], 2.0, 1.0, (10, 10)).next().is_none());
        let images: Vec<_> = coverage(&[(0.0, 0.0), (10.0, 10.0)], 3.0, 1.0, (10, 10)).collect();
        assert_eq!((images[0].origin, images[0].size, images.len()), ((0, 0), (10, 10), 1));
    }

    #[test]
    fn bands_hold_little_and_meet() {
        let points: Vec<(f64, f64)> = (0..3000).map(|k| (f64::from(k) * 0.5, f64::from(k % 900))).collect();
        let images: Vec<_> = coverage(&points, 3.0, 0.4, (1500, 900)).collect();
        assert!(images.iter().all(|image| image.alpha.len() <= 1500 * 64));
        let rows: usize = images.iter().map(|image| image.size.1).sum();
        assert!(images.is_sorted_by_key(|image| image.origin.1) && rows == 900);
    }
}
