//! Events along steps: nothing between two ends of a step is missed, nothing at a joint is told twice.

use crate::common::Generator;
use crate::generated::{below, parted, with_roots};
use gear_bifurcations::numerics::ode::Field;
use gear_bifurcations::numerics::ode::dense::DenseStep;
use gear_bifurcations::numerics::ode::event::{Crossing, Watch, first_crossing, range, visit_crossings};
use gear_bifurcations::numerics::ode::runge_kutta::{RungeKutta, RungeKuttaOptions};
use gear_bifurcations::numerics::roots::{RootKind, Side};
use std::f64::consts::{PI, TAU};

#[derive(Clone)]
struct By<C>(C);

impl<const N: usize, C: Fn(f64, &[f64; N]) -> [f64; N]> Field<N> for By<C> {
    fn derivative(&self, time: f64, state: &[f64; N]) -> [f64; N] {
        (self.0)(time, state)
    }
}

fn crossings<const LEN: usize>(coefficients: &[f64; LEN], length: f64, on_root: bool) -> Vec<Crossing> {
    let mut all = Vec::new();
    visit_crossings(coefficients, length, on_root, &mut |crossing| {
        all.push(crossing);
        false
    });
    all
}

#[test]
fn a_start_on_a_root_does_not_count_and_what_follows_does() {
    let mut generator = Generator(11);
    for _ in 0..200 {
        let count = below(&mut generator, 4);
        let known = parted(&mut generator, count, 0.05, (0.05, 0.95));
        let roots = [&known[..], &[0.0]].concat();
        for length in [0.7, -0.7] {
            let polynomial = with_roots::<9>(&roots, &[(0.5, 0.4)], length);
            let found = crossings(&polynomial, length, true);
            assert_eq!(found.len(), known.len(), "{known:?}: {found:?}");
            for (n, (crossing, root)) in found.iter().zip(&known).enumerate() {
                assert!((crossing.since / length - root).abs() < 1e-9);
                // The leading coefficient is 1: above zero after the last root.
                assert_eq!(crossing.rising, (known.len() - n) % 2 == 1, "{known:?}: {found:?}");
            }
            assert_eq!(first_crossing(&polynomial, length, true), found.first().map(|first| first.since));
        }
    }
}

#[test]
fn a_root_at_the_end_counts_if_the_continuation_crosses() {
    // s - 1 and (s - 1)^2 on [0, 1].
    assert_eq!(crossings(&[-1.0, 1.0, 0.0], 1.0, false), [Crossing { since: 1.0, rising: true }]);
    assert_eq!(crossings(&[1.0, -2.0, 1.0], 1.0, false), []);
    // s (1 - s), started on its root at 0.
    assert_eq!(crossings(&[0.0, 1.0, -1.0], 1.0, true), [Crossing { since: 1.0, rising: false }]);
    assert_eq!(first_crossing(&[0.0, 1.0, -1.0], 0.99, true), None);
}

#[test]
fn the_range_includes_interior_extrema() {
    // 4 s (1 - s) on [0, 1] and on its rising half.
    let (low, high) = range(&[0.0, 4.0, -4.0], 1.0);
    assert_eq!(low, 0.0);
    assert!((high - 1.0).abs() < 1e-15);
    assert_eq!(range(&[0.0, 4.0, -4.0], 0.25), (0.0, 0.75));
}

/// All events of a scalar along an integration: time and kind.
fn watched<F: Field<N>, const N: usize>(
    mut integration: RungeKutta<'_, F, N>,
    end: f64,
    scalar: impl Fn(&DenseStep<N>) -> [f64; 8],
    tolerance: f64,
) -> Vec<(f64, RootKind)> {
    let mut watch = Watch::new(tolerance);
    let mut events = Vec::new();
    while integration.time() != end {
        let step = integration.step(end).expect("steps");
        watch.visit(&scalar(&step), step.length(), &mut |root| {
            events.push((step.start() + root.at, root.kind));
            false
        });
    }
    events
}

/// The scalar may cross twice between two ends of a step, which comparing its signs there does not show
/// (github.com/scipy/scipy issue 9228): a ball in free flight, of which the integrator makes a single step.
#[test]
fn two_crossings_within_one_step_are_found() {
    let field = By(|_: f64, x: &[f64; 2]| [x[1], -9.81]);
    let mut integration =
        RungeKutta::new(&field, 0.0, [0.0, 10.0], RungeKuttaOptions::with_tolerance(1e-6)).expect("starts");
    integration.advance(1e-3).expect("steps");
    let step = integration.step_unchecked(2.0).expect("steps");
    let height = 5.0;
    let mut above = step.component_coefficients(0);
    above[0] -= height;
    assert!(step.start_state()[0] < height && step.end_state()[0] < height, "both ends are below");
    let found = crossings(&above, step.length(), false);
    let root = (100.0_f64 - 2.0 * 9.81 * height).sqrt();
    let known = [(10.0 - root) / 9.81, (10.0 + root) / 9.81];
    assert_eq!(found.len(), 2, "{found:?}");
    for (crossing, time) in found.iter().zip(known) {
        assert!((step.start() + crossing.since - time).abs() < 1e-12, "{found:?} {known:?}");
    }
    assert!(found[0].rising && !found[1].rising);
    let (_, top) = range(&above, step.length());
    assert!((top + height - 100.0 / (2.0 * 9.81)).abs() < 1e-12);
}

#[test]
fn long_steps_miss_no_crossing_of_a_fast_scalar() {
    // The watched scalar depends on a component that the tolerance lets pass in large steps.
    let field = By(|_: f64, x: &[f64; 2]| [x[1], -x[0]]);
    let integration =
        RungeKutta::new(&field, 0.0, [0.0, 1.0], RungeKuttaOptions::with_tolerance(1e-3)).expect("starts");
    let found = watched(integration, 40.0 * PI + 1.0, |step| step.component_coefficients(0), 1e-9);
    assert_eq!(found.len(), 40, "{found:?}");
    for (n, (time, kind)) in found.iter().enumerate() {
        assert!((time - (n + 1) as f64 * PI).abs() < 0.2, "{n}: {time}");
        assert_eq!(*kind, if n % 2 == 0 { RootKind::Falling } else { RootKind::Rising });
    }
}

#[test]
fn crossings_at_the_joints_of_steps_are_told_once() {
    // Steps end exactly on the zeros of sin, where its value is rounding.
    let field = By(|_: f64, x: &[f64; 2]| [x[1], -x[0]]);
    for parts in [1, 2, 3, 7] {
        let mut integration =
            RungeKutta::new(&field, 0.0, [0.0, 1.0], RungeKuttaOptions::with_tolerance(1e-13))
                .expect("starts");
        let mut watch = Watch::new(1e-9);
        let mut times = Vec::new();
        for n in 1..=20 * parts {
            let stop = f64::from(n) * PI / f64::from(parts);
            while integration.time() != stop {
                let step = integration.step(stop).expect("steps");
                watch.visit(&step.component_coefficients(0), step.length(), &mut |root| {
                    times.push(step.start() + root.at);
                    false
                });
            }
        }
        // The twentieth is undecided: the motion ends there.
        assert_eq!(times.len(), 19, "{parts}: {times:?}");
        for (n, time) in times.iter().enumerate() {
            assert!((time - (n + 1) as f64 * PI).abs() < 1e-8, "{parts}: {times:?}");
        }
    }
}

#[test]
fn grazing_is_a_touch_within_the_tolerance_and_nothing_or_a_pair_beyond() {
    let field = By(|_: f64, x: &[f64; 2]| [x[1], -x[0]]);
    for (lift, kinds) in [
        (0.0, vec![RootKind::Touch; 3]),
        (5e-7, vec![RootKind::Touch; 3]),
        (-5e-7, vec![RootKind::Touch; 3]),
        (1e-5, vec![]),
        (-1e-5, [RootKind::Falling, RootKind::Rising].repeat(3)),
    ] {
        let integration = RungeKutta::new(&field, 0.0, [1.0, 0.0], RungeKuttaOptions::with_tolerance(1e-12))
            .expect("starts");
        let lifted = |step: &DenseStep<2>| {
            let mut coefficients = step.component_coefficients(0);
            coefficients[0] += 1.0 + lift;
            coefficients
        };
        let found = watched(integration, 3.0 * TAU, lifted, 1e-6);
        assert_eq!(found.iter().map(|(_, kind)| *kind).collect::<Vec<_>>(), kinds, "{lift:e}: {found:?}");
        for (time, _) in found {
            let nearest = ((time - PI) / TAU).round() * TAU + PI;
            assert!((time - nearest).abs() < 5e-3, "{lift:e}: {time}");
        }
    }
}

#[test]
fn events_backwards_are_those_forwards_in_reverse() {
    let field = By(|t: f64, x: &[f64; 2]| [x[1], -x[0] - 0.3 * x[0].powi(3) + 0.5 * (1.7 * t).cos()]);
    let options = RungeKuttaOptions::with_tolerance(1e-12);
    let scalar = |step: &DenseStep<2>| step.component_coefficients(0);
    let forwards = RungeKutta::new(&field, 0.0, [0.5, 0.1], options).expect("starts");
    let mut end = forwards.clone();
    while end.time() < 30.0 {
        end.advance(30.0).expect("steps");
    }
    let backwards = RungeKutta::new(&field, 30.0, *end.state(), options).expect("starts");
    let there = watched(forwards, 30.0, scalar, 1e-9);
    let back = watched(backwards, 0.0, scalar, 1e-9);
    assert!(there.len() > 8, "{there:?}");
    assert_eq!(there.len(), back.len());
    for ((time, kind), (same_time, same_kind)) in there.iter().zip(back.iter().rev()) {
        assert!((time - same_time).abs() < 1e-8, "{time} {same_time}");
        assert_ne!(kind, same_kind, "followed backwards a rise is a fall");
    }
}

#[test]
fn a_watch_started_on_a_side_sees_the_return_and_not_the_start() {
    // Just past a falling crossing, by rounding still above zero.
    let mut watch = Watch::from_side(Side::Below, 1e-12);
    let rounding = [1e-17, -1.0, 1.0, 0.0];
    let crossing = watch.first_crossing(&rounding, 1.5).expect("it comes back at 1");
    assert!((crossing.since - 1.0).abs() < 1e-15 && crossing.rising);
    assert_eq!(watch.side(), Some(Side::Above));
    // A jump to the other side between steps is a crossing at once.
    let jumped = watch.first_crossing(&[-1.0, 0.1, 0.0, 0.0], 1.0);
    assert_eq!(jumped, Some(Crossing { since: 0.0, rising: false }));
    assert_eq!(Watch::new(1e-3).first_crossing(&[1e-4, 1e-4], 1.0), None);
}
