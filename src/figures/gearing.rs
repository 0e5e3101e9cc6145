//! Outlines of two involute gears in mesh, of a spring, a damper and the ground: geometry for the schematic.
//!
//! Lengths are over the pinion's pitch radius. The pitch point is the origin, the pinion's centre lies at
//! `(-1, 0)`; the line of action passes through the pitch point, inclined by the pressure angle from the common
//! tangent, and touches both base circles.

use std::f64::consts::{PI, TAU};

/// A point of the drawing's plane.
pub(super) type Point = (f64, f64);

/// Teeth of the drawn pinion: enough that a pressure angle of 20 degrees does not undercut them.
pub(super) const PINION_TEETH: usize = 18;
/// Teeth of the drawn gear.
pub(super) const GEAR_TEETH: usize = 27;
/// Pitch radius of the drawn gear.
pub(super) const GEAR_RADIUS: f64 = GEAR_TEETH as f64 / PINION_TEETH as f64;
/// Pressure angle, 20 degrees.
const PRESSURE_ANGLE: f64 = PI / 9.0;
/// Pitch diameter over the number of teeth.
const MODULE: f64 = 2.0 / PINION_TEETH as f64;
/// Points on each flank.
const FLANK: usize = 7;

/// The unit vector along the line of action, in the sense in which the pinion pushes the gear.
pub(super) fn line_of_action() -> Point {
    (PRESSURE_ANGLE.sin(), PRESSURE_ANGLE.cos())
}

/// `origin` moved by `along` the line of action and by `across` it (to its left).
pub(super) fn beside(origin: Point, along: f64, across: f64) -> Point {
    let (x, y) = line_of_action();
    (origin.0 + along * x - across * y, origin.1 + along * y + across * x)
}

/// Radius of the circle from which the flanks are unwound.
pub(super) fn base_radius(pitch_radius: f64) -> f64 {
    pitch_radius * PRESSURE_ANGLE.cos()
}

/// The involute function `tan a - a` at the radius where the pressure angle is `a`.
fn involute(radius: f64, base: f64) -> f64 {
    let ratio = radius / base;
    (ratio * ratio - 1.0).max(0.0).sqrt() - (1.0 / ratio).min(1.0).acos()
}

/// The outline of a gear, anticlockwise from the middle of a root: `turn` turns it, `thinner` is the length by
/// which each tooth is thinner on the base circle than half the pitch, to leave backlash.
pub(super) fn outline(centre: Point, teeth: usize, turn: f64, thinner: f64) -> Vec<Point> {
    let pitch_radius = teeth as f64 * MODULE / 2.0;
    let base = base_radius(pitch_radius);
    let (root, tip) = (pitch_radius - 1.25 * MODULE, pitch_radius + MODULE);
    let half_at_base =
        PI / (2.0 * teeth as f64) + PRESSURE_ANGLE.tan() - PRESSURE_ANGLE - 0.5 * thinner / base;
    let start = base.max(root);
    // Half a flank, from the root to the tip: radius and half the angle that the tooth subtends there.
    let mut flank = Vec::with_capacity(FLANK + 1);
    if root < start {
        flank.push((root, half_at_base));
    }
    for index in 0..FLANK {
        let fraction = index as f64 / (FLANK - 1) as f64;
        let radius = start + (tip - start) * fraction * fraction;
        flank.push((radius, (half_at_base - involute(radius, base)).max(0.0)));
    }
    let mut points = Vec::with_capacity(teeth * (2 * flank.len() + 1) + 1);
    let mut add = |radius: f64, angle: f64| {
        points.push((centre.0 + radius * angle.cos(), centre.1 + radius * angle.sin()));
    };
    let pitch = TAU / teeth as f64;
    for tooth in 0..teeth {
        let middle = turn + tooth as f64 * pitch;
        add(root, middle - 0.5 * pitch);
        for &(radius, half) in &flank {
            add(radius, middle - half);
        }
        for &(radius, half) in flank.iter().rev() {
            add(radius, middle + half);
        }
    }
    points
}

/// An arc about `centre` from angle `from` to `to`.
pub(super) fn arc(centre: Point, radius: f64, from: f64, to: f64) -> Vec<Point> {
    let steps = ((to - from).abs() / TAU * 48.0).ceil().max(2.0) as usize;
    (0..=steps)
        .map(|index| from + (to - from) * index as f64 / steps as f64)
        .map(|angle| (centre.0 + radius * angle.cos(), centre.1 + radius * angle.sin()))
        .collect()
}

/// The head of an arrow at `tip`, pointing at `angle`.
pub(super) fn arrow_head(tip: Point, angle: f64, size: f64) -> Vec<Point> {
    [angle + PI - 0.42, angle, angle + PI + 0.42]
        .into_iter()
        .enumerate()
        .map(|(index, side)| {
            let reach = if index == 1 { 0.0 } else { size };
            (tip.0 + reach * side.cos(), tip.1 + reach * side.sin())
        })
        .collect()
}

/// A coil spring from `from` to `to`, `across` to the left of the line between: straight up to the fraction
/// `free` of the way, then zigzag.
pub(super) fn spring(from: Point, to: Point, across: f64, free: f64) -> Vec<Point> {
    const TURNS: usize = 5;
    let path = Path::new(from, to, across);
    let mut points = vec![path.at(0.0, 0.0), path.at(free, 0.0)];
    for index in 0..2 * TURNS {
        let side = if index % 2 == 0 { 1.0 } else { -1.0 };
        let fraction = (index as f64 + 0.5) / (2 * TURNS) as f64;
        points.push(path.at(free + (0.94 - free) * fraction, 0.085 * side));
    }
    points.extend([path.at(0.94, 0.0), path.at(1.0, 0.0)]);
    points
}

/// A dashpot from `from` to `to`, `across` to the left of the line between: its rod with the piston, and its
/// cylinder.
pub(super) fn damper(from: Point, to: Point, across: f64, free: f64) -> [Vec<Point>; 3] {
    let path = Path::new(from, to, across);
    let piston = free + 0.45 * (0.94 - free);
    [
        vec![path.at(0.0, 0.0), path.at(piston, 0.0)],
        vec![path.at(piston, 0.075), path.at(piston, -0.075)],
        vec![
            path.at(free + 0.12 * (0.94 - free), 0.1),
            path.at(0.9, 0.1),
            path.at(0.9, 0.0),
            path.at(1.0, 0.0),
            path.at(0.9, 0.0),
            path.at(0.9, -0.1),
            path.at(free + 0.12 * (0.94 - free), -0.1),
        ],
    ]
}

/// The ground: a line across the line of action through `at`, and its hatching on the side `outwards` (1 or -1).
pub(super) fn ground(at: Point, half_width: f64, outwards: f64) -> (Vec<Point>, Vec<[Point; 2]>) {
    let line = vec![beside(at, 0.0, -half_width), beside(at, 0.0, half_width)];
    let hatch = (0..8)
        .map(|index: i32| {
            let across = -half_width + 2.0 * half_width * (f64::from(index) + 0.75) / 8.0;
            [beside(at, 0.0, across), beside(at, outwards * 0.1, across - 0.1)]
        })
        .collect();
    (line, hatch)
}

/// A straight way with its left-hand side.
struct Path {
    from: Point,
    along: Point,
    left: Point,
    across: f64,
}

impl Path {
    fn new(from: Point, to: Point, across: f64) -> Self {
        let along = (to.0 - from.0, to.1 - from.1);
        let length = along.0.hypot(along.1).max(f64::MIN_POSITIVE);
        Self { from, along, left: (-along.1 / length, along.0 / length), across }
    }

    fn at(&self, fraction: f64, aside: f64) -> Point {
        let aside = self.across + aside;
        (
            self.from.0 + self.along.0 * fraction + self.left.0 * aside,
            self.from.1 + self.along.1 * fraction + self.left.1 * aside,
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Where the outline of a gear crosses the line of action within one tooth of the pitch point: distances
    /// along it from the pitch point.
    fn crossings(outline: &[Point]) -> Vec<f64> {
        let (x, y) = line_of_action();
        let aside = |p: Point| -p.0 * y + p.1 * x;
        let along = |p: Point| p.0 * x + p.1 * y;
        (0..outline.len())
            .filter_map(|index| {
                let (a, b) = (outline[index], outline[(index + 1) % outline.len()]);
                let (left, right) = (aside(a), aside(b));
                (left * right < 0.0).then(|| along(a) + (along(b) - along(a)) * left / (left - right))
            })
            .filter(|distance| distance.abs() < 0.2)
            .collect()
    }

    #[test]
    fn thinned_teeth_leave_the_backlash_on_the_line_of_action_at_any_turn() {
        let gap = 0.02;
        let base = base_radius(1.0);
        let pitch = TAU / PINION_TEETH as f64;
        for step in 0..9_i32 {
            let turn = pitch * f64::from(step) / 9.0;
            let pinion = outline((-1.0, 0.0), PINION_TEETH, 0.5 * pitch + turn, gap);
            let gear = outline((GEAR_RADIUS, 0.0), GEAR_TEETH, PI - turn / GEAR_RADIUS, gap);
            // The pinion's driving flanks face up the line of action, the gear's driven flanks down it.
            let nearest = crossings(&pinion)
                .iter()
                .flat_map(|p| crossings(&gear).into_iter().map(move |g| g - p))
                .filter(|distance| *distance > 0.0)
                .fold(f64::INFINITY, f64::min);
            assert!((nearest - gap).abs() < 2e-3, "{step}: {nearest} beside {gap}");
        }
        assert!((base * pitch - PI * MODULE * PRESSURE_ANGLE.cos()).abs() < 1e-15);
    }

    #[test]
    fn the_line_of_action_touches_both_base_circles() {
        let (x, y) = line_of_action();
        for (centre, radius) in [(-1.0, 1.0), (GEAR_RADIUS, GEAR_RADIUS)] {
            let distance: f64 = centre * y;
            assert!((distance.abs() - base_radius(radius)).abs() < 1e-15);
        }
        assert!((x.hypot(y) - 1.0).abs() < 1e-15);
    }
}
