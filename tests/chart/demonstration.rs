//! Drawings like those of the figures, from closed formulas: what the tests draw.

use gear_bifurcations::chart::{Axis, Drawing, Frame, Mark, Role, Series};

pub fn axis(name: &str, label: &str, low: f64, high: f64) -> Axis {
    Axis { name: name.into(), label: label.into(), low, high }
}

pub fn frame(name: &str, title: &str, cell: (usize, usize), x: Axis, y: Axis) -> Frame {
    Frame {
        name: name.into(),
        title: title.into(),
        x,
        y,
        bar: None,
        z: None,
        cell,
        span: (1, 1),
        equal_aspect: false,
        bare: false,
    }
}

pub fn series(frame: usize, name: &str, role: Role, mark: Mark) -> Series {
    Series {
        frame,
        name: name.into(),
        meaning: format!("demonstration: {name}"),
        stable: None,
        role,
        mark,
        label: None,
        label_at: 0.5,
        x: Vec::new(),
        y: Vec::new(),
        z: Vec::new(),
        pieces: Vec::new(),
    }
}

fn labelled(mut series: Series, label: &str, at: f64) -> Series {
    series.label = Some(label.into());
    series.label_at = at;
    series
}

fn stability(mut series: Series, stable: bool) -> Series {
    series.stable = Some(stable);
    series
}

/// A field with its bar, a quasi-periodic line, and each of the marks of branches.
pub fn field() -> Drawing {
    let mut frame =
        frame("chart", "a field", (0, 0), axis("Omega", "*Ω*", 0.0, 2.0), axis("k0", "*k*_{0}", 0.0, 1.0));
    frame.bar = Some(axis("growth", "growth rate ln|*μ*|/*T*", 0.0, 0.2));
    let mut growth = series(0, "growth", Role::Growth, Mark::Field);
    growth.x = (0..41).map(|i| f64::from(i) / 20.0).collect();
    growth.y = (0..31).map(|i| f64::from(i) / 30.0).collect();
    for y in &growth.y {
        growth.z.extend(growth.x.iter().map(|x| 0.2 * (x - 1.0) * (0.2 + y)));
    }
    let mut all = vec![growth];
    for (name, role, at) in [
        ("fold", Role::Fold, [0.25, 0.3]),
        ("torus point", Role::TorusBifurcation, [0.5, 0.3]),
        ("across", Role::AcrossManifold, [0.75, 0.3]),
    ] {
        let mut mark = labelled(series(0, name, role, Mark::Marks), name, 0.0);
        (mark.x, mark.y) = (vec![at[0]], vec![at[1]]);
        all.push(mark);
    }
    let mut torus = labelled(series(0, "torus", Role::QuasiPeriodic, Mark::Curve), "quasi-periodic", 0.3);
    torus.x = (0..=60).map(|i| 0.1 + 0.03 * f64::from(i)).collect();
    torus.y = torus.x.iter().map(|x| 0.55 + 0.2 * (2.0 * x).sin()).collect();
    all.push(torus);
    Drawing { grid: (1, 1), frames: vec![frame], series: all }
}

/// Half-width of the second tongue at m = 1, k = 5, theory.md [T3].
const HALF_WIDTH: f64 = 0.268_978_51;

fn branch(mut into: Series, from: f64, to: f64, sign: f64, solid: bool) -> Series {
    for side in [1.0, -1.0] {
        into.pieces.push(into.x.len());
        for i in 0..=200 {
            let t = (f64::from(i) / 200.0).powi(2);
            let omega = from + t * (to - from);
            let radius = (sign * (omega - from) * 15.0).max(0.0).sqrt();
            into.x.push(omega);
            into.y.push(if solid {
                if from * sign < 0.0 { 0.0 } else { side * radius }
            } else {
                side * radius
            });
            if solid {
                into.z.push(if from * sign < 0.0 { side * radius } else { 0.0 });
            }
        }
    }
    into
}

fn line(mut into: Series, points: &[[f64; 2]], solid: bool) -> Series {
    for [x, y] in points {
        into.x.push(*x);
        into.y.push(*y);
        if solid {
            into.z.push(0.0);
        }
    }
    into
}

/// A pitchfork diagram for hardening and softening, plane and in space.
pub fn pitchforks() -> Drawing {
    let mut drawing = Drawing { grid: (2, 2), frames: Vec::new(), series: Vec::new() };
    for (row, (word, sign)) in [("hardening", 1.0), ("softening", -1.0)].into_iter().enumerate() {
        let letter = ["(a)", "(b)"][row];
        drawing.frames.push(frame(
            &format!("{word}-plane"),
            &format!("{letter} {word}, *α* = {}0.2", if sign > 0.0 { "" } else { "-" }),
            (0, row),
            axis("Omega_1", "*Ω*_{1}", -0.6, 0.6),
            axis("R", "*R*", -3.8, 3.8),
        ));
        let mut space = frame(
            &format!("{word}-space"),
            "",
            (1, row),
            axis("Omega_1", "*Ω*_{1}", -0.6, 0.6),
            axis("B_1", "*B*_{1}", -3.8, 3.8),
        );
        space.z = Some(axis("B_2", "*B*_{2}", -3.8, 3.8));
        drawing.frames.push(space);
        for solid in [false, true] {
            let at = 2 * row + usize::from(solid);
            let edge = sign * HALF_WIDTH;
            let name = |what: &str| format!("{what} {word} {solid}");
            let exact = |what: &str, stable: bool| {
                stability(series(at, &name(what), Role::Exact, Mark::Curve), stable)
            };
            let origin_out = line(exact("origin outside", true), &[[-0.6, 0.0], [-HALF_WIDTH, 0.0]], solid);
            let origin_in =
                line(exact("origin inside", false), &[[-HALF_WIDTH, 0.0], [HALF_WIDTH, 0.0]], solid);
            let origin_far = line(exact("origin beyond", true), &[[HALF_WIDTH, 0.0], [0.6, 0.0]], solid);
            let end = sign * 0.6;
            let stable = branch(exact("stable branch", true), -edge, end, sign, solid);
            let unstable = branch(exact("unstable branch", false), edge, end, sign, solid);
            let mut paper =
                branch(series(at, &name("paper"), Role::Paper, Mark::Curve), -edge * 1.15, end, sign, solid);
            paper.stable = Some(true);
            let words = !solid;
            drawing.series.push(if words { labelled(paper, "paper (63)", 0.4) } else { paper });
            drawing.series.push(if words { labelled(origin_out, "stable", 0.4) } else { origin_out });
            drawing.series.push(if words { labelled(origin_in, "unstable", 0.5) } else { origin_in });
            drawing.series.push(origin_far);
            drawing.series.push(if words { labelled(stable, "sine branch, stable", 0.3) } else { stable });
            drawing.series.push(if words {
                labelled(unstable, "cosine branch, unstable", 0.9)
            } else {
                unstable
            });
            let left =
                line(series(at, &name("super"), Role::Supercritical, Mark::Marks), &[[-edge, 0.0]], solid);
            let right = line(series(at, &name("sub"), Role::Subcritical, Mark::Marks), &[[edge, 0.0]], solid);
            drawing.series.push(labelled(left, "*Ω*_{L}", 0.0));
            drawing.series.push(labelled(right, "*Ω*_{R}", 0.0));
        }
    }
    drawing
}

/// A reproducible scatter over -1..1 (splitmix64).
fn scatter(index: u64) -> f64 {
    let mut z = index.wrapping_mul(0x9E37_79B9_7F4A_7C15);
    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64 * 2.0 - 1.0
}

/// Poincare maps: clouds, a trajectory, the origin.
pub fn clouds() -> Drawing {
    let mut drawing = Drawing { grid: (3, 1), frames: Vec::new(), series: Vec::new() };
    for (column, omega) in [3.65, 3.70, 3.75].into_iter().enumerate() {
        drawing.frames.push(frame(
            &format!("map-{column}"),
            &format!("({}) *ω* = {omega:.2}", ["a", "b", "c"][column]),
            (column, 0),
            axis("u_p", "*u*_{p}", -0.62, 0.62),
            axis("u_p'", "*u*_{p}'", -3.9, 3.9),
        ));
        let mut transient = series(column, &format!("transient {column}"), Role::Trajectory, Mark::Cloud);
        let mut torus = series(column, &format!("torus {column}"), Role::Attractor, Mark::Cloud);
        for i in 0..1500_u64 {
            let angle = i as f64 * 2.399_963;
            let radius = (i as f64 / 1500.0).sqrt() * (0.9 + 0.1 * scatter(i));
            transient.x.push(0.5 * radius * angle.cos());
            transient.y.push(3.2 * radius * (angle + 0.5).sin());
        }
        for i in 0..2500 {
            let angle = f64::from(i) * 0.618_034 * std::f64::consts::TAU;
            torus.x.push(0.5 * angle.cos() + 0.06 * (3.0 * angle).sin());
            torus.y.push(3.2 * (angle + 0.5).sin());
        }
        drawing.series.push(transient);
        drawing.series.push(if column == 0 { labelled(torus, "limit cycle", 0.1) } else { torus });
        let mut origin = series(column, &format!("origin {column}"), Role::UnstableSpiral, Mark::Marks);
        origin.x.push(0.0);
        origin.y.push(0.0);
        drawing.series.push(labelled(origin, "unstable spiral", 0.0));
    }
    drawing
}

/// A map with two nodes and a trajectory into each.
pub fn nodes() -> Drawing {
    let mut drawing = Drawing {
        grid: (1, 1),
        frames: vec![frame(
            "map",
            "Tongue 2: *ω* = 1.55, *ζ* = 0.052",
            (0, 0),
            axis("u_p", "*u*_{p}", -3.6, 3.6),
            axis("u_p'", "*u*_{p}'", -1.8, 1.8),
        )],
        series: Vec::new(),
    };
    for sign in [1.0, -1.0] {
        let mut path = series(0, &format!("trajectory {sign}"), Role::Trajectory, Mark::Curve);
        let mut dots = series(0, &format!("points {sign}"), Role::Trajectory, Mark::Marks);
        for i in 0..120 {
            let t = f64::from(i) / 8.0;
            let (x, y) = (
                2.9 * (1.0 - (-t * 0.5).exp() * (t * 0.9).cos()),
                -1.6 * (-t * 0.35).exp() * (t * 0.9).sin(),
            );
            path.x.push(sign * x);
            path.y.push(sign * y);
            dots.x.push(sign * x);
            dots.y.push(sign * y);
        }
        drawing.series.push(path);
        drawing.series.push(dots);
        let mut node = series(0, &format!("node {sign}"), Role::Attractor, Mark::Marks);
        node.x.push(sign * 2.9);
        node.y.push(0.0);
        drawing.series.push(labelled(node, "stable node", 0.0));
    }
    let mut saddle = series(0, "saddle", Role::Saddle, Mark::Marks);
    saddle.x.push(0.0);
    saddle.y.push(0.0);
    drawing.series.push(labelled(saddle, "saddle", 0.0));
    drawing
}

/// A time response that grows out of its frame, beside one that does not, over the dead zone.
pub fn response() -> Drawing {
    let mut drawing = Drawing { grid: (1, 2), frames: Vec::new(), series: Vec::new() };
    for (row, title) in ["(a) *α* = 0", "(b) *α* = -1.3"].into_iter().enumerate() {
        drawing.frames.push(frame(
            &format!("response-{row}"),
            title,
            (0, row),
            axis("t", "*t*", 0.0, 120.0),
            axis("u", "*u*", -3.0, 7.0),
        ));
        let mut zone = series(row, &format!("dead zone {row}"), Role::DeadZone, Mark::Band);
        zone.x = vec![0.0, 120.0];
        zone.y = vec![-1.0, 1.0];
        drawing.series.push(labelled(zone, "dead zone", 0.02));
        let mut contact = series(row, &format!("contact {row}"), Role::OtherRegime, Mark::Curve);
        let mut backlash = series(row, &format!("backlash {row}"), Role::Exact, Mark::Curve);
        for i in 0..=9_000 {
            let t = f64::from(i) / 75.0;
            let growth = if row == 0 { 0.8 * (t / 24.0).exp() } else { 1.6 * (-t / 9.0).exp() + 0.3 };
            let bounded =
                if row == 0 { 2.6 * (1.0 - (-t / 14.0).exp()) } else { 1.6 * (-t / 9.0).exp() + 0.3 };
            contact.x.push(t);
            contact.y.push(2.5 - growth * (0.8 * t).cos() - 0.4 * (1.6 * t).sin());
            backlash.x.push(t);
            backlash.y.push(2.5 - bounded * (0.8 * t).cos() - 0.4 * (1.6 * t).sin());
        }
        drawing.series.push(labelled(contact, "contact (25), teeth never part", 0.5));
        drawing.series.push(labelled(backlash, "backlash (22)", 0.85));
        if row == 0 {
            let mut event = series(row, "contact lost", Role::Event, Mark::Marks);
            event.x.push(30.4);
            event.y.push(1.0);
            drawing.series.push(labelled(event, "contact lost at *t* = 30.4", 0.0));
        }
    }
    drawing
}

/// Two bodies on springs.
pub fn schematic() -> Drawing {
    let mut bare = frame("schematic", "", (0, 0), axis("x", "", -6.0, 6.0), axis("y", "", -3.0, 3.0));
    bare.equal_aspect = true;
    bare.bare = true;
    let mut drawing = Drawing { grid: (1, 1), frames: vec![bare], series: Vec::new() };
    for (name, role, center, teeth) in
        [("pinion", Role::BodyFirst, -1.62, 18), ("gear", Role::BodySecond, 1.62, 18)]
    {
        let mut body = series(0, name, role, Mark::Filled);
        for i in 0..teeth * 8 {
            let angle = f64::from(i) / f64::from(teeth * 8) * std::f64::consts::TAU;
            let radius = 1.5 + 0.12 * (f64::from(teeth) * angle).cos().signum();
            body.x.push(center + radius * angle.cos());
            body.y.push(radius * angle.sin());
        }
        drawing.series.push(labelled(body, &format!("*m*_{{{}}}", &name[..1]), 0.5));
    }
    for sign in [1.0, -1.0] {
        let mut spring = series(0, &format!("spring {sign}"), Role::Link, Mark::Curve);
        for i in 0..=12 {
            let x = 3.12 + f64::from(i) * 0.18;
            let y = if i == 0 || i == 12 {
                0.0
            } else if i % 2 == 0 {
                0.3
            } else {
                -0.3
            };
            spring.x.push(sign * x);
            spring.y.push(y);
        }
        drawing.series.push(labelled(spring, "*k*", 0.5));
        let mut wall = series(0, &format!("wall {sign}"), Role::Link, Mark::Curve);
        wall.x = vec![sign * 5.28, sign * 5.28];
        wall.y = vec![-1.0, 1.0];
        drawing.series.push(wall);
    }
    for (text, x) in [("pinion", -1.62), ("gear", 1.62)] {
        let mut word = series(0, &format!("word {text}"), Role::Link, Mark::Text);
        word.x.push(x);
        word.y.push(-2.1);
        drawing.series.push(labelled(word, text, 0.0));
    }
    drawing
}

/// All of them by name, with the width over height that suits each.
pub fn all() -> Vec<(&'static str, Drawing, f64)> {
    vec![
        ("pitchforks", pitchforks(), 1.35),
        ("clouds", clouds(), 2.6),
        ("nodes", nodes(), 1.5),
        ("response", response(), 1.6),
        ("schematic", schematic(), 2.0),
        ("field", field(), 1.6),
    ]
}
