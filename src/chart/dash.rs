//! Dashes laid along the arclength of a curve, so that they look alike at any density and on any surface.

/// Cuts a polyline into dashes. Dash and gap (pixels) are stretched together by the little that makes the line begin and
/// end with a full dash; a line shorter than a dash stays whole.
pub fn dashes(points: &[[f64; 2]], [dash, gap]: [f64; 2]) -> Vec<Vec<[f64; 2]>> {
    let length: f64 = points.windows(2).map(|pair| distance(pair[0], pair[1])).sum();
    if length <= dash || dash <= 0.0 || gap <= 0.0 {
        return vec![points.to_vec()];
    }
    let count = ((length - dash) / (dash + gap)).round().max(1.0);
    let stretch = length / (count * (dash + gap) + dash);
    let (dash, gap) = (dash * stretch, gap * stretch);
    let mut pieces: Vec<Vec<[f64; 2]>> = vec![vec![points[0]]];
    let (mut drawing, mut left) = (true, dash);
    for pair in points.windows(2) {
        let (from, to) = (pair[0], pair[1]);
        let whole = distance(from, to);
        let mut done = 0.0;
        while whole - done > left {
            done += left;
            let t = done / whole;
            let at = [from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])];
            if drawing {
                if let Some(piece) = pieces.last_mut() {
                    piece.push(at);
                }
            } else {
                pieces.push(vec![at]);
            }
            drawing = !drawing;
            left = if drawing { dash } else { gap };
        }
        left -= whole - done;
        if let (true, Some(piece)) = (drawing, pieces.last_mut()) {
            piece.push(to);
        }
    }
    pieces.retain(|piece| piece.len() > 1);
    pieces
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

#[cfg(test)]
mod tests {
    use super::{dashes, distance};

    fn length(points: &[[f64; 2]]) -> f64 {
        points.windows(2).map(|pair| distance(pair[0], pair[1])).sum()
    }

    #[test]
    fn all_dashes_are_of_one_length_along_a_curve() {
        let arc: Vec<[f64; 2]> =
            (0..=900).map(|i| (f64::from(i) / 200.0).sin_cos()).map(|(s, c)| [80.0 * c, 80.0 * s]).collect();
        let pieces = dashes(&arc, [7.0, 4.5]);
        let own = length(&pieces[0]);
        assert!((own - 7.0).abs() < 0.35, "{own}");
        for piece in &pieces {
            assert!((length(piece) - own).abs() < 1e-3 * own, "{}", length(piece));
        }
        for pair in pieces.windows(2) {
            let gap = distance(*pair[0].last().unwrap(), pair[1][0]);
            assert!((gap - 4.5).abs() < 0.3, "{gap}");
        }
        assert!(distance(*pieces.last().unwrap().last().unwrap(), *arc.last().unwrap()) < 1e-9);
    }

    #[test]
    fn it_begins_and_ends_with_a_dash() {
        let pieces = dashes(&[[0.0, 0.0], [100.0, 0.0]], [7.0, 4.0]);
        assert_eq!(pieces[0][0], [0.0, 0.0]);
        assert!(distance(*pieces.last().unwrap().last().unwrap(), [100.0, 0.0]) < 1e-9);
        let drawn: f64 = pieces.iter().map(|piece| length(piece)).sum();
        assert!((drawn / 100.0 - 7.0 / 11.0).abs() < 0.03, "{drawn}");
    }

    #[test]
    fn the_cutting_of_the_line_does_not_matter() {
        let fine: Vec<[f64; 2]> = (0..=1000).map(|i| [f64::from(i) / 10.0, 0.0]).collect();
        let (coarse, fine) = (dashes(&[[0.0, 0.0], [100.0, 0.0]], [7.0, 4.0]), dashes(&fine, [7.0, 4.0]));
        assert_eq!(coarse.len(), fine.len());
        for (a, b) in coarse.iter().zip(&fine) {
            assert!(distance(a[0], b[0]) < 1e-6 && distance(*a.last().unwrap(), *b.last().unwrap()) < 1e-6);
        }
    }

    #[test]
    fn a_short_line_stays_whole() {
        assert_eq!(dashes(&[[0.0, 0.0], [3.0, 0.0]], [7.0, 4.0]), vec![vec![[0.0, 0.0], [3.0, 0.0]]]);
    }
}
