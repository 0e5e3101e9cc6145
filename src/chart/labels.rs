//! Labels at the curves themselves: near where they are wanted, clear of lines, marks, each other and the edges.

use super::geometry::Rect;
use super::metrics::Face;
use super::text::{Label, set};
use super::theme::Color;
use crate::order;

/// Side of a cell of the map of ink, CSS pixels.
const CELL: f64 = 3.0;
/// Gaps between a line and its label that are tried, CSS pixels.
const GAPS: [f64; 4] = [3.5, 8.0, 16.0, 28.0];
/// From this gap on a thin line leads from the label to what it names, CSS pixels.
const LEADER_FROM: f64 = 14.0;
/// Width of a plot that counts as small, CSS pixels.
const SMALL: f64 = 320.0;
/// Cost of a label over another, or over the edge: never worth it.
const FORBIDDEN: f64 = 1e4;
/// Cost of a pixel away from where the label is wanted.
const NEARNESS: f64 = 0.12;
/// Cost of a cell of ink under the label.
const INK: f64 = 5.0;
/// Cost of a cell of ink close to the label.
const CLOSE_INK: f64 = 0.5;
/// What candidates may cost by themselves beyond the least, at first and then.
const REACHES: [f64; 3] = [6.0, 30.0, f64::INFINITY];
/// Sizes that are tried, over the wanted one.
const SHRINKS: [f64; 3] = [1.0, 0.9, 0.8];

/// What a label belongs to, in pixels.
#[derive(Clone, Debug)]
pub enum Anchor {
    /// It is written here, around this middle, and nowhere else.
    Place([f64; 2]),
    /// It stands beside a mark of this middle and radius.
    Mark([f64; 2], f64),
    /// It runs along these visible pieces of a curve, best near this point.
    Curve(Vec<Vec<[f64; 2]>>, [f64; 2]),
    /// It stands within this area, best at this fraction of its width.
    Area(Rect, f64),
}

/// A label that seeks its place.
#[derive(Clone, Debug)]
pub struct Request {
    /// Label markup.
    pub markup: String,
    /// Font size, CSS pixels.
    pub size: f64,
    /// Colour.
    pub color: Color,
    /// What it belongs to.
    pub anchor: Anchor,
}

/// A label with its place.
#[derive(Clone, Debug)]
pub struct Placed {
    /// The letters.
    pub label: Label,
    /// Left end of the baseline.
    pub at: [f64; 2],
    /// Colour.
    pub color: Color,
    /// Colour of the rim about its letters.
    pub ground: Color,
    /// A thin line to what it names.
    pub leader: Option<([f64; 2], [f64; 2])>,
}

/// Where ink lies already.
pub struct Crowd {
    area: Rect,
    columns: usize,
    rows: usize,
    ink: Vec<bool>,
    boxes: Vec<Rect>,
    words: Vec<Rect>,
    ground: Color,
    areas: Vec<(Vec<[f64; 2]>, Color)>,
}

impl Crowd {
    /// An empty area of this ground.
    pub fn new(area: Rect, ground: Color) -> Self {
        let count = |length: f64| (length / CELL).ceil().max(1.0) as usize;
        let (columns, rows) = (count(area.width()), count(area.height()));
        Self {
            area,
            columns,
            rows,
            ink: vec![false; columns * rows],
            boxes: Vec::new(),
            words: Vec::new(),
            ground,
            areas: Vec::new(),
        }
    }

    /// Notes a polyline.
    pub fn add_line(&mut self, points: &[[f64; 2]]) {
        for pair in points.windows(2) {
            let (from, to) = (pair[0], pair[1]);
            let steps =
                ((to[0] - from[0]).hypot(to[1] - from[1]) / (0.6 * CELL)).ceil().clamp(1.0, 1e4) as usize;
            for step in 0..=steps {
                let t = step as f64 / steps as f64;
                self.add_point([from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])]);
            }
        }
    }

    /// Notes a point.
    pub fn add_point(&mut self, point: [f64; 2]) {
        let (x, y) = ((point[0] - self.area.left) / CELL, (point[1] - self.area.top) / CELL);
        if x >= 0.0 && y >= 0.0 && (x as usize) < self.columns && (y as usize) < self.rows {
            self.ink[y as usize * self.columns + x as usize] = true;
        }
    }

    /// Notes an area that is filled with a colour, over what was there.
    pub fn add_area(&mut self, corners: Vec<[f64; 2]>, color: Color) {
        self.areas.push((corners, color));
    }

    /// The colour a label at this point is written on.
    fn ground_at(&self, point: [f64; 2]) -> Color {
        let found = self.areas.iter().rev().find(|(corners, _)| within_polygon(corners, point));
        found.map_or(self.ground, |(_, color)| *color)
    }

    /// Notes a box that no label may touch.
    pub fn add_box(&mut self, area: Rect) {
        self.boxes.push(area);
    }

    /// Sums of ink over all cells above and to the left, one row and one column larger than the map.
    fn sums(&self) -> Vec<u32> {
        let wide = self.columns + 1;
        let mut sums = vec![0_u32; wide * (self.rows + 1)];
        for row in 0..self.rows {
            let mut line = 0;
            for column in 0..self.columns {
                line += u32::from(self.ink[row * self.columns + column]);
                sums[(row + 1) * wide + column + 1] = sums[row * wide + column + 1] + line;
            }
        }
        sums
    }

    /// Inked cells that a box touches.
    fn ink_in(&self, sums: &[u32], area: &Rect) -> f64 {
        let clamp = |value: f64, most: usize| value.clamp(0.0, most as f64) as usize;
        let left = clamp(((area.left - self.area.left) / CELL).floor(), self.columns);
        let right = clamp(((area.right - self.area.left) / CELL).ceil(), self.columns);
        let top = clamp(((area.top - self.area.top) / CELL).floor(), self.rows);
        let bottom = clamp(((area.bottom - self.area.top) / CELL).ceil(), self.rows);
        let at = |row: usize, column: usize| f64::from(sums[row * (self.columns + 1) + column]);
        at(bottom, right) + at(top, left) - at(top, right) - at(bottom, left)
    }

    /// What it costs to write where it must be written, whatever is there.
    fn cost_over_words(&self, area: &Rect) -> f64 {
        let over = self.words.iter().any(|taken| taken.grown(-1.0).overlaps(area));
        if over { FORBIDDEN } else { 0.0 }
    }

    /// What it costs to write in this box: [`FORBIDDEN`] over what must stay clear, else by the ink under it and about it.
    fn cost(&self, sums: &[u32], area: &Rect, within: &Rect, most_ink: f64) -> f64 {
        let kept = area.grown(1.5);
        // Words side by side would be read as one: they need more room to their sides.
        let apart = Rect { left: kept.left - 8.0, right: kept.right + 8.0, ..kept };
        let touches = || {
            self.boxes.iter().any(|taken| taken.overlaps(&kept))
                || self.words.iter().any(|taken| taken.overlaps(&apart))
        };
        if !within.holds(&area.grown(2.0)) || touches() {
            return FORBIDDEN;
        }
        let ink = self.ink_in(sums, &kept);
        if ink > most_ink {
            return FORBIDDEN;
        }
        // Ink close by makes a label belong to more than one line.
        INK * ink + CLOSE_INK * self.ink_in(sums, &area.grown(6.0))
    }
}

/// A possible place: the box's middle, what it costs by itself, and the point it would be led to.
struct Candidate {
    middle: [f64; 2],
    cost: f64,
    from: Option<[f64; 2]>,
}

/// Finds a place for each label. One that has no room, even when smaller, is left out: a mixture of words says nothing.
pub fn place(requests: &[Request], crowd: &mut Crowd, within: &Rect) -> Vec<Placed> {
    let sums = crowd.sums();
    // What cannot move goes first, then what has few places to choose from.
    let rank = |request: &&Request| match request.anchor {
        Anchor::Place(_) => 0.0,
        Anchor::Mark(..) => 1.0,
        Anchor::Curve(..) => 2.0,
        Anchor::Area(..) => 3.0,
    };
    let mut in_turn: Vec<&Request> = requests.iter().collect();
    order::by_number(&mut in_turn, rank);
    let mut placed = Vec::new();
    for request in in_turn {
        for shrink in SHRINKS {
            let label = set(&request.markup, request.size * shrink, Face::Regular);
            let Some(best) = best_place(request, &label, crowd, &sums, within) else {
                continue;
            };
            let area = Rect::around(best.middle, label.width, label.height());
            crowd.words.push(area);
            let at = [area.left, area.top + label.ascent];
            let leader = best.from.map(|from| (from, nearest(&area.grown(1.5), from)));
            placed.push(Placed {
                label,
                at,
                color: request.color,
                ground: crowd.ground_at(best.middle),
                leader,
            });
            break;
        }
    }
    placed
}

fn best_place(
    request: &Request,
    label: &Label,
    crowd: &Crowd,
    sums: &[u32],
    within: &Rect,
) -> Option<Candidate> {
    let (width, height) = (label.width, label.height());
    if width <= 0.0 {
        return None;
    }
    let fixed = matches!(request.anchor, Anchor::Place(_));
    // In a small plot a label across several lines hides what it should explain.
    let most_ink =
        if within.width() < SMALL && matches!(request.anchor, Anchor::Curve(..)) { 8.0 } else { f64::MAX };
    let mut all = candidates(&request.anchor, width, height, within);
    let least = all.iter().map(|candidate| candidate.cost).fold(f64::INFINITY, f64::min);
    let mut best: Option<(f64, usize)> = None;
    let mut tried = f64::NEG_INFINITY;
    // Nothing costs less than it does by itself: what does so from the first is tried first, and mostly is enough.
    for reach in REACHES {
        let most = least + reach;
        for (index, candidate) in all.iter().enumerate() {
            let bound = best.map_or(f64::INFINITY, |(cost, _)| cost).min(most);
            if candidate.cost <= tried || candidate.cost > bound {
                continue;
            }
            let area = Rect::around(candidate.middle, width, height);
            let cost = candidate.cost
                + if fixed {
                    crowd.cost_over_words(&area)
                } else {
                    crowd.cost(sums, &area, within, most_ink)
                };
            // Of two that cost the same the earlier one, in whatever order they were tried.
            let better = |(found, at)| cost < found || (cost == found && index < at);
            if cost < FORBIDDEN && best.is_none_or(better) {
                best = Some((cost, index));
            }
        }
        tried = most;
        if best.is_some_and(|(cost, _)| cost < most) {
            break;
        }
    }
    best.map(|(_, index)| all.swap_remove(index))
}

fn candidates(anchor: &Anchor, width: f64, height: f64, within: &Rect) -> Vec<Candidate> {
    match anchor {
        Anchor::Place(middle) => {
            let inside = |value: f64, low: f64, high: f64| value.min(high).max(low);
            let x = inside(middle[0], within.left + width / 2.0, within.right - width / 2.0);
            let y = inside(middle[1], within.top + height / 2.0, within.bottom - height / 2.0);
            vec![Candidate { middle: [x, y], cost: 0.0, from: None }]
        }
        Anchor::Mark(center, radius) => beside_mark(*center, *radius, width, height),
        Anchor::Curve(pieces, wanted) => along_curve(pieces, *wanted, width, height),
        Anchor::Area(area, fraction) => within_area(area, *fraction, width, height),
    }
}

/// Beside a mark: right and left first, then above and below, then farther off with a leading line.
fn beside_mark(center: [f64; 2], radius: f64, width: f64, height: f64) -> Vec<Candidate> {
    const SIDES: [([f64; 2], f64); 8] = [
        ([1.0, -0.75], 0.0),
        ([-1.0, -0.75], 1.0),
        ([1.0, 0.75], 1.5),
        ([-1.0, 0.75], 2.0),
        ([0.0, -1.0], 2.5),
        ([0.0, 1.0], 3.0),
        ([1.0, 0.0], 1.5),
        ([-1.0, 0.0], 2.0),
    ];
    let mut found = Vec::new();
    for gap in [1.5, 8.0, 18.0, 30.0, 44.0] {
        for ([side, rise], cost) in SIDES {
            let middle = [
                center[0] + side * (radius * 0.8 + gap + width / 2.0),
                center[1] + rise * (radius * 0.8 + gap + height / 2.0),
            ];
            let from = (gap > LEADER_FROM).then_some(center);
            found.push(Candidate { middle, cost: cost + gap, from });
        }
    }
    found
}

/// Around points of the curve: above, below, beside and at the four corners. The map of ink keeps the box off the curve itself.
fn along_curve(pieces: &[Vec<[f64; 2]>], wanted: [f64; 2], width: f64, height: f64) -> Vec<Candidate> {
    // Above a line is read first, so other sides cost a little more.
    const SIDES: [([f64; 2], f64); 8] = [
        ([0.0, -1.0], 0.0),
        ([0.0, 1.0], 1.5),
        ([1.0, -1.0], 1.0),
        ([-1.0, -1.0], 1.0),
        ([1.0, 1.0], 2.0),
        ([-1.0, 1.0], 2.0),
        ([1.0, 0.0], 2.0),
        ([-1.0, 0.0], 2.0),
    ];
    let length: f64 =
        pieces.iter().flat_map(|piece| piece.windows(2)).map(|pair| distance(pair[0], pair[1])).sum();
    let step = (length / 120.0).max(4.0);
    let mut found = Vec::new();
    let mut around = |point: [f64; 2]| {
        for gap in GAPS {
            for ([side, rise], cost) in SIDES {
                // At a corner the box is near enough without the gap to its side.
                let (beside, over) = if rise == 0.0 { (gap + 1.5, 0.0) } else { (-0.2 * width, gap) };
                let middle =
                    [point[0] + side * (beside + width / 2.0), point[1] + rise * (over + height / 2.0)];
                let from = (gap > LEADER_FROM).then_some(point);
                found.push(Candidate {
                    middle,
                    cost: NEARNESS * distance(point, wanted) + 1.5 * gap + cost,
                    from,
                });
            }
        }
    };
    for piece in pieces {
        let mut ahead = 0.0;
        for pair in piece.windows(2) {
            let (from, to) = (pair[0], pair[1]);
            let whole = distance(from, to);
            while ahead <= whole && whole > 0.0 {
                let t = ahead / whole;
                around([from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])]);
                ahead += step;
            }
            ahead -= whole;
        }
        piece.last().into_iter().for_each(|end| around(*end));
    }
    found
}

fn within_area(area: &Rect, fraction: f64, width: f64, height: f64) -> Vec<Candidate> {
    const PAD: f64 = 6.0;
    let (least, most) = (area.left + PAD + width / 2.0, area.right - PAD - width / 2.0);
    let (high, low) = (area.top + 3.0 + height / 2.0, area.bottom - 3.0 - height / 2.0);
    let center = area.center();
    let lines = if low > high { vec![center[1], high, low] } else { vec![center[1]] };
    let mut found = Vec::new();
    for step in 0..=40 {
        let t = f64::from(step) / 40.0;
        let x = if most > least { least + t * (most - least) } else { center[0] };
        for (rank, &y) in lines.iter().enumerate() {
            let cost = 30.0 * (t - fraction).abs() + 3.0 * rank as f64;
            found.push(Candidate { middle: [x, y], cost, from: None });
        }
    }
    found
}

/// Whether a point lies within a polygon: a ray to the right crosses its edges an odd number of times.
fn within_polygon(corners: &[[f64; 2]], [x, y]: [f64; 2]) -> bool {
    let mut inside = false;
    for (index, a) in corners.iter().enumerate() {
        let b = &corners[(index + 1) % corners.len()];
        if (a[1] > y) != (b[1] > y) && x < a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0]) {
            inside = !inside;
        }
    }
    inside
}

fn nearest(area: &Rect, point: [f64; 2]) -> [f64; 2] {
    [point[0].clamp(area.left, area.right), point[1].clamp(area.top, area.bottom)]
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    let (x, y) = (a[0] - b[0], a[1] - b[1]);
    (x * x + y * y).sqrt()
}

#[cfg(test)]
mod tests {
    use super::{Anchor, Color, Crowd, Placed, Rect, Request, place};

    const WHITE: Color = Color(255, 255, 255);
    const AREA: Rect = Rect { left: 0.0, top: 0.0, right: 300.0, bottom: 200.0 };

    fn request(markup: &str, anchor: Anchor) -> Request {
        Request { markup: markup.to_owned(), size: 12.0, color: Color(0, 0, 0), anchor }
    }

    fn area(placed: &Placed) -> Rect {
        let (left, top) = (placed.at[0], placed.at[1] - placed.label.ascent);
        Rect { left, top, right: left + placed.label.width, bottom: top + placed.label.height() }
    }

    #[test]
    fn labels_of_many_curves_keep_clear_of_each_other_and_the_lines() {
        let lines: Vec<Vec<[f64; 2]>> =
            (1..6).map(|i| (0..=30).map(|j| [f64::from(j) * 10.0, f64::from(i) * 32.0]).collect()).collect();
        let mut crowd = Crowd::new(AREA, WHITE);
        for line in &lines {
            crowd.add_line(line);
        }
        let requests: Vec<Request> = lines
            .iter()
            .map(|line| request("corrected [T7]", Anchor::Curve(vec![line.clone()], line[15])))
            .collect();
        let placed = place(&requests, &mut crowd, &AREA);
        assert_eq!(placed.len(), 5);
        for (i, one) in placed.iter().enumerate() {
            assert!(AREA.holds(&area(one)));
            for other in &placed[..i] {
                assert!(!area(one).overlaps(&area(other)));
            }
            for line in &lines {
                assert!(line.iter().all(|point| !area(one).holds_point(*point, 0.0)));
            }
        }
    }

    #[test]
    fn a_mark_is_not_covered_by_its_name() {
        let mut crowd = Crowd::new(AREA, WHITE);
        let mark = Rect::around([150.0, 100.0], 14.0, 14.0);
        crowd.add_box(mark);
        let placed = place(&[request("Ω", Anchor::Mark([150.0, 100.0], 7.0))], &mut crowd, &AREA);
        assert!(!area(&placed[0]).overlaps(&mark.grown(-2.0)));
    }

    #[test]
    fn a_label_on_an_area_has_the_rim_of_that_area() {
        let mut crowd = Crowd::new(AREA, WHITE);
        crowd.add_area(vec![[100.0, 50.0], [200.0, 50.0], [150.0, 150.0]], Color(1, 2, 3));
        let texts =
            [request("in", Anchor::Place([150.0, 90.0])), request("out", Anchor::Place([50.0, 90.0]))];
        let placed = place(&texts, &mut crowd, &AREA);
        assert_eq!((placed[0].ground, placed[1].ground), (Color(1, 2, 3), WHITE));
    }

    #[test]
    fn a_label_without_room_is_left_out() {
        let mut crowd = Crowd::new(AREA, WHITE);
        crowd.add_box(AREA);
        assert!(place(&[request("x", Anchor::Area(AREA, 0.5))], &mut crowd, &AREA).is_empty());
    }
}
