//! Thinning of long curves to what the pixels can show.

/// Columns to a CSS pixel: finer than any screen shows.
const COLUMNS_PER_PIXEL: f64 = 3.0;

/// Whether the first coordinates never turn back (rising, or falling).
pub fn is_monotone(points: &[[f64; 2]]) -> bool {
    points.windows(2).all(|pair| pair[0][0] <= pair[1][0])
        || points.windows(2).all(|pair| pair[0][0] >= pair[1][0])
}

/// Thins a curve over a monotone first coordinate, in pixels: of the points in each narrow column the first, the lowest,
/// the highest and the last stay, in their order. Curves with few points, or that turn back, are left as they are.
pub fn decimate(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let (Some(first), Some(last)) = (points.first(), points.last()) else {
        return Vec::new();
    };
    let columns = (last[0] - first[0]).abs() * COLUMNS_PER_PIXEL + 1.0;
    if (points.len() as f64) < 4.0 * columns || !is_monotone(points) {
        return points.to_vec();
    }
    let column = |point: &[f64; 2]| (point[0] * COLUMNS_PER_PIXEL).floor();
    let mut kept = Vec::new();
    let mut start = 0;
    while start < points.len() {
        let own = column(&points[start]);
        let end = start + points[start..].iter().take_while(|point| column(point) == own).count();
        let by_height = |a: &usize, b: &usize| points[*a][1].total_cmp(&points[*b][1]);
        let lowest = (start..end).min_by(by_height).unwrap_or(start);
        let highest = (start..end).max_by(by_height).unwrap_or(start);
        let chosen = [start, lowest.min(highest), lowest.max(highest), end - 1];
        for (order, &index) in chosen.iter().enumerate() {
            if order == 0 || chosen[order - 1] != index {
                kept.push(points[index]);
            }
        }
        start = end;
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::{COLUMNS_PER_PIXEL, decimate};

    fn wave(count: usize) -> Vec<[f64; 2]> {
        (0..count)
            .map(|i| {
                let t = i as f64 / count as f64;
                [t * 300.0, 100.0 + 90.0 * (t * 400.0).sin() * (t * 7.0).cos()]
            })
            .collect()
    }

    #[test]
    fn the_extremes_of_every_column_stay() {
        let long = wave(60_000);
        let short = decimate(&long);
        assert!(short.len() < long.len() / 10);
        for column in 0..(300.0 * COLUMNS_PER_PIXEL) as usize {
            let of = |points: &[[f64; 2]]| {
                points
                    .iter()
                    .filter(|point| (point[0] * COLUMNS_PER_PIXEL).floor() as usize == column)
                    .fold((f64::MAX, f64::MIN), |(low, high), point| (low.min(point[1]), high.max(point[1])))
            };
            assert_eq!(of(&long), of(&short), "column {column}");
        }
        assert_eq!((long.first(), long.last()), (short.first(), short.last()));
    }

    #[test]
    fn order_is_kept() {
        assert!(decimate(&wave(60_000)).windows(2).all(|pair| pair[0][0] <= pair[1][0]));
    }

    #[test]
    fn short_and_turning_curves_are_left_alone() {
        let short = wave(500);
        assert_eq!(decimate(&short), short);
        let circle: Vec<[f64; 2]> =
            (0..50_000).map(|i| [(f64::from(i)).cos(), (f64::from(i)).sin()]).collect();
        assert_eq!(decimate(&circle), circle);
        assert!(decimate(&[]).is_empty());
    }
}
