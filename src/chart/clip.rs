//! Cutting lines and areas at the edges of a box, in any number of dimensions.
//!
//! Lines by Liang and Barsky, "A new concept and method for line clipping", ACM Transactions on Graphics 3 (1984) 1-22;
//! areas edge by edge by Sutherland and Hodgman, "Reentrant polygon clipping", Communications of the ACM 17 (1974) 32-42.
//! Nothing is ever moved onto an edge: what lies outside is cut off.

/// The part of the segment from `a` to `b` within the box, as fractions of the way; none if it misses the box.
pub fn clip_segment<const N: usize>(
    a: &[f64; N],
    b: &[f64; N],
    low: &[f64; N],
    high: &[f64; N],
) -> Option<(f64, f64)> {
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    for i in 0..N {
        let along = b[i] - a[i];
        if along == 0.0 {
            if a[i] < low[i] || a[i] > high[i] {
                return None;
            }
            continue;
        }
        let (to_low, to_high) = ((low[i] - a[i]) / along, (high[i] - a[i]) / along);
        enter = enter.max(to_low.min(to_high));
        leave = leave.min(to_low.max(to_high));
    }
    (enter <= leave).then_some((enter, leave))
}

/// The pieces of a polyline that lie within the box; a lone touching point is no piece.
pub fn clip_polyline<const N: usize>(
    points: &[[f64; N]],
    low: &[f64; N],
    high: &[f64; N],
) -> Vec<Vec<[f64; N]>> {
    let mut pieces: Vec<Vec<[f64; N]>> = Vec::new();
    let mut open = false;
    for pair in points.windows(2) {
        let (a, b) = (&pair[0], &pair[1]);
        let Some((enter, leave)) = clip_segment(a, b, low, high) else {
            open = false;
            continue;
        };
        // Rounding may leave the cut a last digit outside: the cut coordinate is the edge itself.
        let cut = |t: f64| -> [f64; N] {
            std::array::from_fn(|i| (a[i] + t * (b[i] - a[i])).clamp(low[i], high[i]))
        };
        let first = if enter > 0.0 { cut(enter) } else { *a };
        let last = if leave < 1.0 { cut(leave) } else { *b };
        if !(open && enter <= 0.0) {
            pieces.push(vec![first]);
        }
        if let Some(piece) = pieces.last_mut() {
            piece.push(last);
        }
        open = leave >= 1.0;
    }
    pieces.retain(|piece| piece.iter().any(|point| point != &piece[0]));
    pieces
}

/// The part of a polygon within the box; empty if none is.
pub fn clip_polygon(points: &[[f64; 2]], low: &[f64; 2], high: &[f64; 2]) -> Vec<[f64; 2]> {
    let mut polygon = points.to_vec();
    for axis in 0..2 {
        for (edge, sign) in [(low[axis], 1.0), (high[axis], -1.0)] {
            let inside = |point: &[f64; 2]| (point[axis] - edge) * sign >= 0.0;
            let mut cut = Vec::with_capacity(polygon.len() + 4);
            for (index, point) in polygon.iter().enumerate() {
                let next = &polygon[(index + 1) % polygon.len()];
                if inside(point) {
                    cut.push(*point);
                }
                if inside(point) != inside(next) {
                    let t = (edge - point[axis]) / (next[axis] - point[axis]);
                    let other = 1 - axis;
                    let mut crossing = [0.0; 2];
                    crossing[axis] = edge;
                    crossing[other] = point[other] + t * (next[other] - point[other]);
                    cut.push(crossing);
                }
            }
            polygon = cut;
        }
    }
    polygon
}

#[cfg(test)]
mod tests {
    use super::{clip_polygon, clip_polyline, clip_segment};

    /// A small generator of reproducible numbers (splitmix64), here over -2..3.
    fn numbers(seed: u64) -> impl FnMut() -> f64 {
        let mut state = seed;
        move || {
            state = state.wrapping_add(0x9E37_79B9_7F4A_7C15);
            let mut z = state;
            z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
            z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
            ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64 * 5.0 - 2.0
        }
    }

    #[test]
    fn what_is_kept_is_inside_and_what_is_cut_is_outside() {
        let mut next = numbers(7);
        let (low, high) = ([0.0, 0.0, 0.0], [1.0, 1.0, 1.0]);
        for _ in 0..2000 {
            let (a, b) = ([next(), next(), next()], [next(), next(), next()]);
            let kept = clip_segment(&a, &b, &low, &high);
            for step in 0..=200 {
                let t = f64::from(step) / 200.0;
                let inside = (0..3).all(|i| (0.0..=1.0).contains(&(a[i] + t * (b[i] - a[i]))));
                let said = kept.is_some_and(|(enter, leave)| (enter..=leave).contains(&t));
                let on_edge = (0..3).any(|i| {
                    let x = a[i] + t * (b[i] - a[i]);
                    x.abs() < 1e-12 || (x - 1.0).abs() < 1e-12
                });
                assert!(inside == said || on_edge, "{a:?} {b:?} {t}");
            }
        }
    }

    #[test]
    fn no_piece_leaves_the_box() {
        let mut next = numbers(11);
        let walk: Vec<[f64; 2]> = (0..3000).map(|_| [next(), next()]).collect();
        let pieces = clip_polyline(&walk, &[0.0, 0.0], &[1.0, 1.0]);
        assert!(pieces.len() > 100);
        for point in pieces.iter().flatten() {
            assert!(point.iter().all(|x| (0.0..=1.0).contains(x)), "{point:?}");
        }
    }

    #[test]
    fn a_line_inside_stays_one_piece_untouched() {
        let line = vec![[0.1, 0.2], [0.5, 0.9], [0.7, 0.1]];
        assert_eq!(clip_polyline(&line, &[0.0, 0.0], &[1.0, 1.0]), vec![line]);
    }

    #[test]
    fn a_peak_outside_is_cut_and_not_flattened() {
        let pieces = clip_polyline(&[[0.0, 0.5], [0.5, 2.5], [1.0, 0.5]], &[0.0, 0.0], &[1.0, 1.0]);
        assert_eq!(pieces, vec![vec![[0.0, 0.5], [0.125, 1.0]], vec![[0.875, 1.0], [1.0, 0.5]]]);
    }

    #[test]
    fn far_away_points_do_not_bend_the_line() {
        let pieces = clip_polyline(&[[0.0, 0.0], [1e12, 1e12]], &[0.0, 0.0], &[1.0, 1.0]);
        assert_eq!(pieces.len(), 1);
        assert!((pieces[0][1][0] - pieces[0][1][1]).abs() < 1e-9);
    }

    #[test]
    fn a_square_over_the_corner_keeps_its_quarter() {
        let square = [[-1.0, -1.0], [0.5, -1.0], [0.5, 0.5], [-1.0, 0.5]];
        let kept = clip_polygon(&square, &[0.0, 0.0], &[1.0, 1.0]);
        let area: f64 = (0..kept.len())
            .map(|i| {
                let (p, q) = (kept[i], kept[(i + 1) % kept.len()]);
                (p[0] * q[1] - q[0] * p[1]) / 2.0
            })
            .sum();
        assert!((area.abs() - 0.25).abs() < 1e-12);
        assert!(clip_polygon(&[[2.0, 2.0], [3.0, 2.0], [3.0, 3.0]], &[0.0, 0.0], &[1.0, 1.0]).is_empty());
    }
}
