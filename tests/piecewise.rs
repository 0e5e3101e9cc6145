//! Motions in pieces, switched at events by the Runge-Kutta pair, against solutions in closed form.

use gear_bifurcations::numerics::ode::Field;
use gear_bifurcations::numerics::ode::event::{Watch, first_crossing};
use gear_bifurcations::numerics::ode::runge_kutta::{RungeKutta, RungeKuttaOptions};
use gear_bifurcations::numerics::roots::bracketed_root;
use std::f64::consts::{PI, TAU};

/// `x'' + 2 zeta x' + slope x - offset = force cos(omega t)`: one piece of an oscillator with a dead zone.
#[derive(Clone, Copy)]
struct Piece {
    zeta: f64,
    slope: f64,
    offset: f64,
    force: f64,
    omega: f64,
}

impl Field<2> for Piece {
    fn derivative(&self, time: f64, x: &[f64; 2]) -> [f64; 2] {
        let force = self.force * (self.omega * time).cos();
        [x[1], force - 2.0 * self.zeta * x[1] - self.slope * x[0] + self.offset]
    }
}

impl Piece {
    /// The closed form of the motion through `state` at `start`.
    fn exact(&self, start: f64, state: [f64; 2], time: f64) -> [f64; 2] {
        let (zeta, omega) = (self.zeta, self.omega);
        // The forced part: the real part of response times exp(i omega t).
        let (re, im) = (self.slope - omega * omega, 2.0 * zeta * omega);
        let size = self.force / (re * re + im * im);
        let forced = |t: f64| {
            let (sine, cosine) = (omega * t).sin_cos();
            [size * (re * cosine + im * sine), size * omega * (im * cosine - re * sine)]
        };
        let (at_start, now, since) = (forced(start), forced(time), time - start);
        let (x, v) = (state[0] - at_start[0], state[1] - at_start[1]);
        if self.slope == 0.0 {
            // x'' + 2 zeta x' = 0.
            let (decay, travel) = if zeta == 0.0 {
                (1.0, since)
            } else {
                ((-2.0 * zeta * since).exp(), -(-2.0 * zeta * since).exp_m1() / (2.0 * zeta))
            };
            return [x + v * travel + now[0], v * decay + now[1]];
        }
        let rest = self.offset / self.slope;
        let frequency = (self.slope - zeta * zeta).sqrt();
        let (sine, cosine) = (frequency * since).sin_cos();
        let decay = (-zeta * since).exp();
        let (x, b) = (x - rest, (v + zeta * (x - rest)) / frequency);
        [
            decay * (x * cosine + b * sine) + rest + now[0],
            decay * (v * cosine - (zeta * b + frequency * x) * sine) + now[1],
        ]
    }
}

/// The three pieces of a dead zone from -1 to 1: behind it, within it, before it.
fn pieces(zeta: f64, force: f64, omega: f64) -> [Piece; 3] {
    [(1.0, -1.0), (0.0, 0.0), (1.0, 1.0)].map(|(slope, offset)| Piece { zeta, slope, offset, force, omega })
}

/// Edges of a piece, and the pieces beyond them.
fn edges(piece: usize) -> Vec<(f64, usize)> {
    [vec![(-1.0, 1)], vec![(-1.0, 0), (1.0, 2)], vec![(1.0, 1)]][piece].clone()
}

/// Follows the motion from event to event with the Runge-Kutta pair: times of all events, and the end.
fn followed(pieces: &[Piece; 3], start: usize, state: [f64; 2], end: f64) -> (Vec<f64>, [f64; 2]) {
    let (mut piece, mut time, mut state) = (start, 0.0, state);
    let (mut times, mut edge_at_start) = (Vec::new(), None);
    let mut options = RungeKuttaOptions::with_tolerance(1e-13);
    loop {
        let mut integration = RungeKutta::new(&pieces[piece], time, state, options).expect("starts");
        let event = loop {
            if integration.time() == end {
                return (times, *integration.state());
            }
            let step = integration.step(end).expect("steps");
            let first = edges(piece)
                .into_iter()
                .filter_map(|(level, beyond)| {
                    let mut coefficients = step.component_coefficients(0);
                    coefficients[0] -= level;
                    let on_edge = step.start() == time && edge_at_start == Some(level);
                    let since = first_crossing(&coefficients, step.length(), on_edge)?;
                    Some((step.start() + since, level, beyond, step.value(step.start() + since)))
                })
                .min_by(|left, right| left.0.total_cmp(&right.0));
            if first.is_some() {
                break first;
            }
        };
        let Some((at, level, beyond, there)) = event else { continue };
        times.push(at);
        options.first_step = integration.proposed_step();
        (time, piece, edge_at_start) = (at, beyond, Some(level));
        state = [level, there[1]];
    }
}

/// The same in closed form: each piece's end is sought by fine sampling and a bracket.
fn exact(pieces: &[Piece; 3], start: usize, state: [f64; 2], end: f64) -> (Vec<f64>, [f64; 2]) {
    let (mut piece, mut time, mut state, mut times) = (start, 0.0, state, Vec::new());
    'pieces: loop {
        let motion = |t: f64| pieces[piece].exact(time, state, t);
        let sample = 1e-3;
        let mut n = 1.0;
        while time + n * sample < end {
            let (before, after) = (time + (n - 1.0) * sample, time + n * sample);
            for (level, beyond) in edges(piece) {
                let off = |t: f64| motion(t)[0] - level;
                // The first sample of a piece is on its edge.
                let from = if n == 1.0 { before + 1e-6 * sample } else { before };
                if off(from) * off(after) < 0.0 {
                    let at = bracketed_root(off, from, after, 0.0).expect("a bracket");
                    times.push(at);
                    let velocity = motion(at)[1];
                    (time, piece, state) = (at, beyond, [level, velocity]);
                    continue 'pieces;
                }
            }
            n += 1.0;
        }
        return (times, motion(end));
    }
}

/// Without damping and force the period is known: two half circles and two flights through the gap.
#[test]
fn free_play_without_damping_keeps_its_period() {
    // An error of the amplitude makes the period wrong by 4 / amplitude^2 times as much, and all that follow: no
    // slow flights here, and few periods.
    for amplitude in [0.3, 0.7, 4.0] {
        let flight = 2.0 / amplitude;
        let period = TAU + 2.0 * flight;
        let start = [1.0 + amplitude, 0.0];
        let (times, end) = followed(&pieces(0.0, 0.0, 1.0), 2, start, 10.0 * period);
        assert_eq!(times.len(), 40, "four events a period");
        for (n, time) in times.iter().enumerate() {
            let known = period * (n / 4) as f64
                + [0.5 * PI, 0.5 * PI + flight, 1.5 * PI + flight, 1.5 * PI + 2.0 * flight][n % 4];
            assert!((time - known).abs() < 1e-9, "{amplitude}, event {n}: {time} {known}");
        }
        assert!((end[0] - start[0]).abs() < 1e-9 && end[1].abs() < 1e-9, "{amplitude}: {end:?}");
    }
}

#[test]
fn forced_and_damped_play_follows_the_closed_form_through_impacts_on_both_sides() {
    for (zeta, force, omega, start) in
        [(0.05, 1.5, 0.7, [0.0, 0.0]), (0.02, 0.8, 1.3, [0.9, -0.4]), (0.1, 3.0, 0.35, [-0.5, 0.1])]
    {
        let pieces = pieces(zeta, force, omega);
        let end = 60.0;
        let (times, state) = followed(&pieces, 1, start, end);
        let (known, known_state) = exact(&pieces, 1, start, end);
        assert!(known.len() > 10, "{known:?}");
        assert_eq!(times.len(), known.len(), "{times:?} {known:?}");
        for (time, known) in times.iter().zip(&known) {
            assert!((time - known).abs() < 1e-9, "{time} {known}");
        }
        for (value, known) in state.iter().zip(known_state) {
            assert!((value - known).abs() < 1e-9, "{state:?} {known_state:?}");
        }
    }
}

#[test]
fn not_telling_the_integrator_of_the_edges_costs_accuracy_or_work() {
    struct Blind([Piece; 3]);
    impl Field<2> for Blind {
        fn derivative(&self, time: f64, x: &[f64; 2]) -> [f64; 2] {
            let piece = if x[0] > 1.0 { 2 } else { usize::from(x[0] >= -1.0) };
            self.0[piece].derivative(time, x)
        }
    }
    let pieces = pieces(0.05, 1.5, 0.7);
    let (_, known) = exact(&pieces, 1, [0.0, 0.0], 40.0);
    let blind = Blind(pieces);
    let mut integration =
        RungeKutta::new(&blind, 0.0, [0.0, 0.0], RungeKuttaOptions::with_tolerance(1e-13)).expect("starts");
    while integration.time() < 40.0 {
        integration.advance(40.0).expect("steps");
    }
    // It still converges: the corner is only found by refusing steps.
    assert!(integration.work().rejected > 20, "{:?}", integration.work());
    assert!((integration.state()[0] - known[0]).abs() < 1e-6, "{:?} {known:?}", integration.state());
}

/// A ball that keeps 0.8 of its speed at each bounce, let fall from 1 at g = 2: impacts at `1 + 2 (r + r^2 + ..)`.
#[test]
fn a_bouncing_ball_bounces_when_it_should() {
    struct Fall;
    impl Field<2> for Fall {
        fn derivative(&self, _: f64, x: &[f64; 2]) -> [f64; 2] {
            [x[1], -2.0]
        }
    }
    const KEPT: f64 = 0.8;
    let options = RungeKuttaOptions::with_tolerance(1e-12);
    let mut integration = RungeKutta::new(&Fall, 0.0, [1.0, 0.0], options).expect("starts");
    let mut watch = Watch::new(1e-13);
    let mut known = 1.0;
    for bounce in 1..=30 {
        let time = loop {
            let step = integration.step(100.0).expect("steps");
            if let Some(crossing) = watch.first_crossing(&step.component_coefficients(0), step.length()) {
                assert!(!crossing.rising);
                let time = step.start() + crossing.since;
                let speed = step.value(time)[1];
                integration.restart(time, [0.0, -KEPT * speed]).expect("restarts");
                watch = Watch::new(1e-13);
                break time;
            }
        };
        assert!((time - known).abs() < 1e-11, "bounce {bounce}: {time} {known}");
        known += 2.0 * KEPT.powi(bounce);
    }
}
