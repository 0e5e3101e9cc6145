//! Figure 1: pinion and gear on their supports, moving with a computed response.

use super::compose::{Composer, Line, Points, axis, number, plane};
use super::gearing::{
    GEAR_RADIUS, GEAR_TEETH, PINION_TEETH, Point, arc, arrow_head, base_radius, beside, damper, ground,
    line_of_action, outline, spring,
};
use super::job::{Figure, Motion, patience};
use crate::chart::drawing::{Drawing, Frame, Mark, Role};
use crate::error::FigureError;
use crate::model::parameters::Parameters;
use crate::study::settling::closed;
use crate::study::time_response::{TimeResponseOptions, time_response};
use std::f64::consts::{PI, TAU};

/// Half-backlash of an ordinary gear over its pinion's pitch radius: what "exaggerated" is measured against.
const ORDINARY_BACKLASH: f64 = 0.002;
/// Half-backlash as it is drawn between the teeth.
const DRAWN_BACKLASH: f64 = 0.02;
/// Longest displacement of a body as it is drawn.
const LONGEST: f64 = 0.16;
/// Mesh periods left to settle before the stretch that is shown.
const SETTLING: usize = 96;
/// Mesh periods shown: a common multiple of the motion's own period for periods T, 2T, 4T and 8T.
const SHOWN: usize = 8;
/// Samples of the motion in each mesh period.
const SAMPLES: usize = 48;
/// Half the side of the window that the close view shows.
const WINDOW: f64 = 0.27;

/// Computes the motion: a settled stretch from a start (from rest, where none is given); of a start on an orbit that orbit,
/// be it stable or not; or, when the motion escapes, all of it up to there.
///
/// # Errors
/// Those of [`time_response`].
pub(super) fn figure(
    id: &'static str,
    parameters: &Parameters,
    given: Option<[f64; 6]>,
) -> Result<Figure, FigureError> {
    let usual = TimeResponseOptions::new(parameters);
    let state = given.unwrap_or(usual.state);
    let on_orbit = given.is_some() && closed(parameters, &state, usual.tolerance)?.is_some();
    let patient = ((patience(parameters) / parameters.mesh_period()) as usize).min(SETTLING);
    let settling = if on_orbit { 0 } else { patient };
    let options = TimeResponseOptions {
        state,
        periods: (settling + SHOWN) as f64,
        samples_per_period: SAMPLES,
        ..usual
    };
    let response = time_response(parameters, &options)?;
    let count = response.states.len();
    let first = if response.escaped.is_some() { 0 } else { count.saturating_sub(SHOWN * SAMPLES + 1) };
    let start = response.t.get(first).copied().unwrap_or(0.0);
    let column = |index: usize| response.states[first..].iter().map(|state| state[index]).collect::<Vec<_>>();
    let motion = Motion {
        t: response.t[first..].iter().map(|t| t - start).collect(),
        u_p: column(0),
        u_g: column(1),
        u: column(2),
    };
    let (least, greatest) = ends(&motion.u);
    let periods = number(motion.t.last().copied().unwrap_or(0.0) / parameters.mesh_period(), 3);
    let mut notes = Vec::new();
    if let Some(time) = response.escaped {
        notes.push(format!("The motion escapes at t = {}; it is shown up to there.", number(time, 5)));
    }
    let contact = if least > 1.0 {
        format!("the teeth stay in contact, with a margin of {} half-backlashes", number(least - 1.0, 3))
    } else {
        "the teeth part and meet again".to_owned()
    };
    notes.push(format!(
        "The loop shows {periods} mesh periods; the torsion is shared evenly between both bodies, and the \
         compression of teeth in contact is not drawn."
    ));
    notes.push(
        "Exaggerated against a gear pair whose half-backlash is 1/500 of the pinion's pitch radius."
            .to_owned(),
    );
    let summary = format!(
        "Pinion and gear on their supports, moving: u runs from {} to {} half-backlashes, so {contact}.",
        number(least, 4),
        number(greatest, 4)
    );
    let drawing = drawing(parameters, &motion, 0.0);
    Ok(Figure {
        summary,
        start: Some(state),
        method: response.method,
        error: response.error,
        motion: Some(motion),
        notes,
        ..Figure::drawn(id, parameters, drawing)
    })
}

/// The drawing at a time of the figure's motion, which is repeated without end.
pub(super) fn at_time(figure: &Figure, motion: &Motion, time: f64) -> Drawing {
    drawing(&figure.parameters, motion, time)
}

fn drawing(parameters: &Parameters, motion: &Motion, time: f64) -> Drawing {
    let pose = Pose::at(parameters, motion, time);
    let mut composer = Composer::new((3, 2));
    let main = composer.frame(Frame {
        span: (2, 2),
        equal_aspect: true,
        bare: true,
        ..plane("gears", "", (0, 0), axis("x", "", (-2.45, 3.3)), axis("y", "", (-2.35, 2.75)))
    });
    let title = format!("{}, *k*(*t*)/*K* = {:.2}", pose.contact(), pose.mesh_stiffness);
    let close = composer.frame(Frame {
        equal_aspect: true,
        bare: true,
        ..plane("mesh", &title, (2, 0), axis("x", "", (-WINDOW, WINDOW)), axis("y", "", (-WINDOW, WINDOW)))
    });
    supports(&mut composer, main, &pose);
    bodies(&mut composer, main, &pose, "");
    furniture(&mut composer, main, &pose);
    bodies(&mut composer, close, &pose, " close");
    contact(&mut composer, close, &pose);
    trace(&mut composer, motion, &pose);
    composer.drawing()
}

/// Where everything is at one time.
struct Pose {
    time: f64,
    u: f64,
    mesh_stiffness: f64,
    pinion: Point,
    gear: Point,
    pinion_turn: f64,
    gear_turn: f64,
    /// Where the pair of flanks nearest the pitch point meets the line of action: the pinion's and the gear's.
    flanks: [f64; 2],
    /// How many times larger than in an ordinary gear the bodies' displacement is drawn.
    factor: f64,
}

impl Pose {
    fn at(parameters: &Parameters, motion: &Motion, time: f64) -> Self {
        let length = motion.t.last().copied().unwrap_or(0.0);
        let time = if length > 0.0 && time.is_finite() { time.rem_euclid(length) } else { 0.0 };
        let value = |column: &[f64]| interpolate(&motion.t, column, time);
        let (u_p, u_g, u) = (value(&motion.u_p), value(&motion.u_g), value(&motion.u));
        let factor = nice_factor(&motion.u_p, &motion.u_g);
        let scale = factor * ORDINARY_BACKLASH;
        let (pinion, gear) =
            (beside((-1.0, 0.0), scale * u_p, 0.0), beside((GEAR_RADIUS, 0.0), scale * u_g, 0.0));
        // One tooth passes in each mesh period; the deviation is such that the flanks are as far apart as u says.
        let base = base_radius(1.0);
        let base_pitch = base * TAU / PINION_TEETH as f64;
        let teeth = (parameters.omega * time / TAU).rem_euclid((PINION_TEETH * GEAR_TEETH) as f64);
        let travel = base_pitch * teeth;
        let torsion = DRAWN_BACKLASH * u.clamp(-1.0, 1.0) - scale * (u_p - u_g);
        let (pinion_arc, gear_arc) = (travel + 0.5 * torsion, travel - 0.5 * torsion);
        let flank = base * PI / (2.0 * PINION_TEETH as f64) + 0.5 * base_pitch;
        let nominal = |arc: f64, shift: f64| arc + shift + flank;
        let ahead = (nominal(pinion_arc, scale * u_p) / base_pitch).round() * base_pitch;
        Self {
            time,
            u,
            mesh_stiffness: 1.0 + parameters.k0 * (parameters.omega * time).cos(),
            pinion,
            gear,
            pinion_turn: PI / PINION_TEETH as f64 + pinion_arc / base,
            gear_turn: PI - gear_arc / base_radius(GEAR_RADIUS),
            flanks: [
                nominal(pinion_arc, scale * u_p) - 0.5 * DRAWN_BACKLASH - ahead,
                nominal(gear_arc, scale * u_g) + 0.5 * DRAWN_BACKLASH - ahead,
            ],
            factor,
        }
    }

    fn touching(&self) -> bool {
        self.u.abs() >= 1.0
    }

    fn contact(&self) -> &'static str {
        if self.touching() { "teeth in contact" } else { "teeth parted" }
    }
}

/// Value of a column at a time, straight between samples.
fn interpolate(t: &[f64], column: &[f64], time: f64) -> f64 {
    let after = t.partition_point(|&sample| sample <= time).min(t.len().saturating_sub(1));
    match (after.checked_sub(1), column.get(after)) {
        (Some(before), Some(&later)) if t[after] > t[before] => {
            let fraction = ((time - t[before]) / (t[after] - t[before])).clamp(0.0, 1.0);
            column[before] + (later - column[before]) * fraction
        }
        (_, value) => value.copied().unwrap_or(0.0),
    }
}

/// Least and greatest value.
fn ends(column: &[f64]) -> (f64, f64) {
    column
        .iter()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &value| (low.min(value), high.max(value)))
}

/// 1, 2 or 5 times a power of ten: the largest with which no displacement is drawn longer than [`LONGEST`].
fn nice_factor(u_p: &[f64], u_g: &[f64]) -> f64 {
    let largest = u_p.iter().chain(u_g).fold(0.05_f64, |largest, value| largest.max(value.abs()));
    let bound = LONGEST / (largest * ORDINARY_BACKLASH);
    let power = 10_f64.powf(bound.log10().floor());
    [5.0, 2.0, 1.0].into_iter().map(|digit| digit * power).find(|factor| *factor <= bound).unwrap_or(power)
}

fn body(name: &str, meaning: &str, role: Role) -> Line {
    Line::new(name, meaning, role)
}

fn points(all: Vec<Point>) -> Points {
    Points::plane(all)
}

fn pieces(all: impl IntoIterator<Item = Vec<Point>>) -> Points {
    let mut points = Points::default();
    for piece in all {
        points.piece(piece);
    }
    points
}

fn bodies(composer: &mut Composer, frame: usize, pose: &Pose, suffix: &str) {
    let pinion = outline(pose.pinion, PINION_TEETH, pose.pinion_turn, DRAWN_BACKLASH);
    let gear = outline(pose.gear, GEAR_TEETH, pose.gear_turn, DRAWN_BACKLASH);
    let line = body(&format!("pinion{suffix}"), "the pinion's body", Role::BodyFirst);
    composer.add(frame, Mark::Filled, line, points(pinion));
    let line = body(&format!("gear{suffix}"), "the gear's body", Role::BodySecond);
    composer.add(frame, Mark::Filled, line, points(gear));
}

fn supports(composer: &mut Composer, frame: usize, pose: &Pose) {
    let pinion_ground = beside((-1.0, 0.0), -2.05, 0.0);
    let gear_ground = beside((GEAR_RADIUS, 0.0), 2.55, 0.0);
    let mut dampers = Vec::new();
    let mut springs = Vec::new();
    let mut hatches = Vec::new();
    for (body, at, free, side) in
        [(pose.pinion, pinion_ground, 0.58, -1.0), (pose.gear, gear_ground, 0.67, 1.0)]
    {
        springs.push(spring(body, at, 0.2, free));
        dampers.extend(damper(body, at, -0.2, free));
        let (line, hatch) = ground(at, 0.45, side);
        springs.push(line);
        hatches.extend(hatch.into_iter().map(|stroke| stroke.to_vec()));
        springs.push(vec![beside(body, 0.0, -0.2), beside(body, 0.0, 0.2)]);
    }
    composer.curve(frame, body("springs", "the supports' springs", Role::Link), pieces(springs));
    composer.curve(frame, body("dampers", "the supports' dampers", Role::Link), pieces(dampers));
    composer.curve(frame, body("ground", "the fixed ground", Role::Reference), pieces(hatches));
}

fn furniture(composer: &mut Composer, frame: usize, pose: &Pose) {
    let hubs = [(pose.pinion, 1.0, pose.pinion_turn), (pose.gear, GEAR_RADIUS, pose.gear_turn)];
    let mut lines = Vec::new();
    for (centre, radius, turn) in hubs {
        lines.push(arc(centre, 0.09, 0.0, TAU));
        // Marks on the rim, so that the eye sees it turn.
        for spoke in 0..3 {
            let angle = turn + TAU * f64::from(spoke) / 3.0;
            lines.push(arc(
                (centre.0 + 0.62 * radius * angle.cos(), centre.1 + 0.62 * radius * angle.sin()),
                0.11 * radius,
                0.0,
                TAU,
            ));
        }
    }
    let (tip, tail) = (0.4 + PI, 0.4 + PI / 2.0);
    for (centre, from, to) in [((-1.0, 0.0), tail, tip), ((GEAR_RADIUS, 0.0), PI - tail, PI - tip)] {
        let radius = 0.36;
        lines.push(arc(centre, radius, from, to));
        let sense = if to > from { 1.0 } else { -1.0 };
        let end = (centre.0 + radius * to.cos(), centre.1 + radius * to.sin());
        lines.push(arrow_head(end, to + sense * (PI / 2.0 - 0.15), 0.11));
    }
    composer.curve(
        frame,
        body("hubs", "hubs, lightening holes, senses of rotation", Role::Link),
        pieces(lines),
    );
    let (x, y) = line_of_action();
    let reach = 1.5;
    composer.curve(
        frame,
        Line::new("line of action", "the line of action, along which both bodies move", Role::Reference),
        Points::plane([(-reach * x, -reach * y), (reach * x, reach * y)]),
    );
    let at = |origin: Point, along: f64, across: f64| beside(origin, along, across);
    let pinion_ground = at((-1.0, 0.0), -2.05, 0.0);
    let gear_ground = at((GEAR_RADIUS, 0.0), 2.55, 0.0);
    for (name, words, point) in [
        ("label m_p", "*m*_{p}", (pose.pinion.0 + 0.3, pose.pinion.1)),
        ("label m_g", "*m*_{g}", (pose.gear.0 - 0.3, pose.gear.1)),
        ("label k_p", "*k*_{p}, *α*_{p}", at(pinion_ground, 0.42, -0.62)),
        ("label zeta_p", "*ζ*_{p}", at(pinion_ground, 0.42, 0.5)),
        ("label k_g", "*k*_{g}, *α*_{g}", at(gear_ground, -0.42, 0.62)),
        ("label zeta_g", "*ζ*_{g}", at(gear_ground, -0.42, -0.5)),
        ("label line", "line of action", (0.15, 1.62)),
        ("label pinion", "pinion", at((-1.0, 0.0), 1.27, 0.25)),
        ("label gear", "gear", (GEAR_RADIUS + 1.1, -1.5)),
    ] {
        composer.text(frame, name, words, point);
    }
    let scale = format!(
        "displacements × {}, tooth gap × {}",
        number(pose.factor, 3),
        number(DRAWN_BACKLASH / ORDINARY_BACKLASH, 3)
    );
    composer.text(frame, "scale", &scale, (1.3, -2.1));
}

fn contact(composer: &mut Composer, frame: usize, pose: &Pose) {
    let (x, y) = line_of_action();
    let on = |along: f64| (along * x, along * y);
    let reach = 1.2 * WINDOW;
    composer.curve(
        frame,
        Line::new("line of action close", "the line of action", Role::Reference),
        Points::plane([on(-reach), on(reach)]),
    );
    let middle = on(0.5 * (pose.flanks[0] + pose.flanks[1]));
    let (words, role) =
        if pose.touching() { ("teeth in contact", Role::Attractor) } else { ("teeth parted", Role::Event) };
    composer.marks(frame, Line::new("contact", words, role), Points::one(middle));
}

fn trace(composer: &mut Composer, motion: &Motion, pose: &Pose) {
    let length = motion.t.last().copied().filter(|length| *length > 0.0).unwrap_or(1.0);
    let (least, greatest) = ends(&motion.u);
    let (low, high) = (least.clamp(-1e3, -1.5), greatest.clamp(1.5, 1e3));
    let margin = 0.06 * (high - low);
    let frame = composer.frame(plane(
        "u",
        "",
        (2, 1),
        axis("t", "*t*", (0.0, length)),
        axis("u", "*u*", (low - margin, high + margin)),
    ));
    let zone = Line::new("dead zone", "the dead zone, in which no tooth touches", Role::DeadZone)
        .label("parted", 0.5);
    composer.add(frame, Mark::Band, zone, Points::plane([(0.0, -1.0), (length, 1.0)]));
    let line = Line::new("u", "transmission error over half the backlash", Role::Exact);
    composer.curve(frame, line, Points::plane(motion.t.iter().copied().zip(motion.u.iter().copied())));
    let line = Line::new("now", "the moment that is drawn", Role::Handle);
    composer.marks(frame, line, Points::one((pose.time, pose.u)));
}

#[cfg(test)]
mod tests {
    use super::*;

    fn motion(u: f64, u_p: f64) -> Motion {
        Motion { t: vec![0.0, 10.0], u_p: vec![u_p, u_p], u_g: vec![-u_p, -u_p], u: vec![u, u] }
    }

    #[test]
    fn flanks_are_apart_by_what_u_says_and_touch_at_one() {
        let parameters = Parameters::default();
        for (u, gap) in [(1.0, 0.0), (4.0, 0.0), (0.0, 1.0), (-0.45, 1.45), (-1.0, 2.0)] {
            for time in [0.0, 1.3, 4.7, 9.9] {
                let pose = Pose::at(&parameters, &motion(u, -0.3), time);
                let apart = (pose.flanks[1] - pose.flanks[0]) / DRAWN_BACKLASH;
                assert!((apart - gap).abs() < 1e-9, "u = {u}: {apart}");
                assert!(pose.flanks[0].abs() < 0.2, "the pair shown is near the pitch point");
                assert_eq!(pose.touching(), u.abs() >= 1.0);
            }
        }
    }

    #[test]
    fn the_factor_keeps_displacements_within_bounds_and_is_a_round_number() {
        for (largest, factor) in [(0.3, 200.0), (0.5, 100.0), (4.0, 20.0), (1e3, 0.05)] {
            let given = nice_factor(&[largest], &[-largest / 2.0]);
            assert!((given / factor - 1.0).abs() < 1e-12, "{largest}: {given}");
        }
    }

    #[test]
    fn the_motion_is_read_between_its_samples_and_repeats() {
        let t = [0.0, 1.0, 2.0];
        assert_eq!(interpolate(&t, &[0.0, 2.0, 0.0], 0.5), 1.0);
        assert_eq!(interpolate(&t, &[0.0, 2.0, 4.0], 2.0), 4.0);
        assert_eq!(interpolate(&[], &[], 2.0), 0.0);
        let parameters = Parameters::default();
        let one = motion(2.0, 0.1);
        assert_eq!(Pose::at(&parameters, &one, 13.0).time, 3.0);
    }
}
