//! The Runge-Kutta pair on problems whose answers are known, or known to the authors' own Fortran code.

use gear_bifurcations::error::NumericsError;
use gear_bifurcations::numerics::ode::Field;
use gear_bifurcations::numerics::ode::runge_kutta::{
    RungeKutta, RungeKuttaOptions, Work, integrate, rk4_fixed,
};
use std::cell::Cell;
use std::f64::consts::{PI, TAU};

/// A field from a closure.
struct By<C>(C);

impl<const N: usize, C: Fn(f64, &[f64; N]) -> [f64; N]> Field<N> for By<C> {
    fn derivative(&self, time: f64, state: &[f64; N]) -> [f64; N] {
        (self.0)(time, state)
    }
}

fn oscillator() -> impl Field<2> {
    By(|_: f64, x: &[f64; 2]| [x[1], -x[0]])
}

/// Nonlinear, of full dependence on time, with the solution `exp(sin t)`, `cos t exp(sin t)` of its first pair.
fn tangled() -> impl Field<2> {
    By(|t: f64, x: &[f64; 2]| [x[1] * (x[0].ln() - t.sin() + 1.0), x[1] * x[1] / x[0] - x[0] * t.sin()])
}

fn tangled_solution(time: f64) -> [f64; 2] {
    [time.sin().exp(), time.cos() * time.sin().exp()]
}

fn distance<const N: usize>(left: &[f64; N], right: &[f64; N]) -> f64 {
    left.iter().zip(right).fold(0.0, |most, (a, b)| most.max((a - b).abs()))
}

fn tolerance(tolerance: f64) -> RungeKuttaOptions {
    RungeKuttaOptions::with_tolerance(tolerance)
}

#[test]
fn exponentials_grow_and_decay_as_they_should() {
    let field = By(|_: f64, x: &[f64; 2]| [x[0], -3.0 * x[1]]);
    let end = integrate(&field, 0.0, [1.0, 1.0], 4.0, tolerance(1e-12)).expect("integrates");
    assert!((end[0] / 4.0_f64.exp() - 1.0).abs() < 1e-11, "{end:?}");
    assert!((end[1] - (-12.0_f64).exp()).abs() < 1e-12, "{end:?}");
}

#[test]
fn an_oscillator_keeps_time_over_a_thousand_periods() {
    let end = integrate(&oscillator(), 0.0, [1.0, 0.0], 1000.0 * TAU, tolerance(1e-13)).expect("integrates");
    assert!(distance(&end, &[1.0, 0.0]) < 1e-9, "{end:?}");
}

#[test]
fn the_error_follows_the_tolerance() {
    for exponent in [4, 6, 8, 10, 12] {
        let allowed = 10.0_f64.powi(-exponent);
        let end = integrate(&tangled(), 0.0, [1.0, 1.0], 6.0, tolerance(allowed)).expect("integrates");
        let error = distance(&end, &tangled_solution(6.0));
        assert!(error < 20.0 * allowed, "tolerance {allowed:e}: error {error:e}");
    }
}

/// Hairer, Norsett, Wanner, section II.0, (0.1) and (0.2): a satellite that closes its orbit around earth and moon.
#[test]
fn the_arenstorf_orbit_closes() {
    const MOON: f64 = 0.012277471;
    const EARTH: f64 = 1.0 - MOON;
    let field = By(|_: f64, x: &[f64; 4]| {
        let pull = |mass: f64, center: f64| mass / ((x[0] - center).powi(2) + x[1] * x[1]).powf(1.5);
        let (earth, moon) = (pull(EARTH, -MOON), pull(MOON, EARTH));
        [
            x[2],
            x[3],
            x[0] + 2.0 * x[3] - earth * (x[0] + MOON) - moon * (x[0] - EARTH),
            x[1] - 2.0 * x[2] - (earth + moon) * x[1],
        ]
    });
    let start = [0.994, 0.0, 0.0, -2.001_585_106_379_082_5];
    let period = 17.065_216_560_157_964;
    let after =
        |tolerance: RungeKuttaOptions| integrate(&field, 0.0, start, period, tolerance).expect("integrates");
    // The orbit passes so near the moon that errors grow a hundred thousand times.
    let end = after(tolerance(1e-14));
    assert!(distance(&[end[0], end[1]], &[start[0], start[1]]) < 1e-8, "{end:?}");
    let rough = after(tolerance(1e-9));
    assert!(distance(&[rough[0], rough[1]], &[start[0], start[1]]) < 1e-3, "{rough:?}");
}

/// Van der Pol with epsilon = 1e-3, tolerance 1e-9, first step 1e-6: the numbers of the authors' DOP853 as kept in
/// the tests of cpmech/russell (russell_ode/tests/test_dopri8_van_der_pol.rs). It counts the first evaluation twice.
#[test]
fn steps_and_evaluations_are_those_of_the_fortran_code() {
    let field = By(|_: f64, x: &[f64; 2]| [x[1], ((1.0 - x[0] * x[0]) * x[1] - x[0]) / 1e-3]);
    let options = RungeKuttaOptions { first_step: Some(1e-6), ..tolerance(1e-9) };
    let mut integration = RungeKutta::new(&field, 0.0, [2.0, 0.0], options).expect("starts");
    while integration.time() < 2.0 {
        integration.step(2.0).expect("steps");
    }
    assert_eq!(integration.work(), Work { evaluations: 21553 - 1, accepted: 1348, rejected: 121 });
    let end = integration.state();
    assert!((end[0] - 1.763234540172087).abs() < 1e-13, "{end:?}");
    assert!((end[1] + 0.835688681930191).abs() < 1e-12, "{end:?}");
}

/// Least-squares slope of the logarithms.
fn slope(points: &[(f64, f64)]) -> f64 {
    let count = points.len() as f64;
    let logs: Vec<(f64, f64)> = points.iter().map(|(x, y)| (x.ln(), y.ln())).collect();
    let mean = logs.iter().fold((0.0, 0.0), |sum, point| (sum.0 + point.0 / count, sum.1 + point.1 / count));
    let (mut above, mut below) = (0.0, 0.0);
    for (x, y) in logs {
        above += (x - mean.0) * (y - mean.1);
        below += (x - mean.0).powi(2);
    }
    above / below
}

#[test]
fn the_result_converges_with_order_8_and_the_dense_output_with_order_8_locally() {
    let field = tangled();
    let (mut at_the_end, mut within) = (Vec::new(), Vec::new());
    for steps in [8, 12, 16, 24] {
        let length = 4.0 / f64::from(steps);
        let mut integration = RungeKutta::new(&field, 0.0, [1.0, 1.0], tolerance(1.0)).expect("starts");
        for n in 1..=steps {
            integration.step_unchecked(length * f64::from(n)).expect("steps");
        }
        at_the_end.push((length, distance(integration.state(), &tangled_solution(4.0))));
        // From exact values, so that the dense output's own error is seen: a step of order 7 errs by length^8.
        let mut largest = 0.0_f64;
        for n in 0..steps {
            let start = length * f64::from(n);
            let mut fresh =
                RungeKutta::new(&field, start, tangled_solution(start), tolerance(1.0)).expect("starts");
            let dense = fresh.step_unchecked(start + length).expect("steps");
            for part in [0.2, 0.4, 0.6, 0.8] {
                let time = start + part * length;
                largest = largest.max(distance(&dense.value(time), &tangled_solution(time)));
            }
        }
        within.push((length, largest));
    }
    let (order, dense_order) = (slope(&at_the_end), slope(&within) - 1.0);
    assert!((7.6..9.0).contains(&order), "{order}: {at_the_end:?}");
    assert!((6.6..8.0).contains(&dense_order), "{dense_order}: {within:?}");
}

#[test]
fn the_plain_scheme_converges_with_order_4() {
    let errors: Vec<(f64, f64)> = [40, 80, 160]
        .iter()
        .map(|steps| {
            let end = rk4_fixed(&tangled(), 0.0, [1.0, 1.0], 4.0, *steps).expect("integrates");
            (4.0 / *steps as f64, distance(&end, &tangled_solution(4.0)))
        })
        .collect();
    assert!((slope(&errors) - 4.0).abs() < 0.3, "{errors:?}");
}

#[test]
fn dense_output_is_as_good_as_the_steps() {
    let field = tangled();
    let mut integration = RungeKutta::new(&field, 0.0, [1.0, 1.0], tolerance(1e-10)).expect("starts");
    let mut last = 0.0;
    while integration.time() < 10.0 {
        let step = integration.step(10.0).expect("steps");
        assert_eq!(step.start(), last);
        assert_eq!(step.end(), integration.time());
        assert_eq!(step.end_state(), integration.state());
        last = step.end();
        for k in 0..=10 {
            let time = step.start() + 0.1 * f64::from(k) * step.length();
            let error = distance(&step.value(time), &tangled_solution(time));
            assert!(error < 1e-8, "at {time}: {error:e}");
        }
    }
    assert_eq!(last, 10.0);
}

#[test]
fn forced_duffing_agrees_between_tolerances_and_lorenz_does_while_it_can() {
    let duffing = By(|t: f64, x: &[f64; 2]| [x[1], x[0] - x[0].powi(3) - 0.25 * x[1] + 0.3 * t.cos()]);
    let fine = integrate(&duffing, 0.0, [0.1, 0.0], 20.0, tolerance(1e-13)).expect("integrates");
    let rough = integrate(&duffing, 0.0, [0.1, 0.0], 20.0, tolerance(1e-9)).expect("integrates");
    assert!(distance(&fine, &rough) < 1e-6, "{fine:?} {rough:?}");
    let lorenz = By(|_: f64, x: &[f64; 3]| {
        [10.0 * (x[1] - x[0]), x[0] * (28.0 - x[2]) - x[1], x[0] * x[1] - 8.0 / 3.0 * x[2]]
    });
    // Errors grow by about exp(0.9 t).
    let fine = integrate(&lorenz, 0.0, [1.0, 1.0, 1.0], 15.0, tolerance(1e-14)).expect("integrates");
    let rough = integrate(&lorenz, 0.0, [1.0, 1.0, 1.0], 15.0, tolerance(1e-11)).expect("integrates");
    assert!(distance(&fine, &rough) < 1e-4, "{fine:?} {rough:?}");
}

#[test]
fn a_jump_of_the_field_is_found_by_refusing_steps_but_better_told() {
    // The slope jumps from 1 to -2 at t = 1/3.
    let jump = 1.0 / 3.0;
    let field = By(|t: f64, _: &[f64; 1]| [if t < jump { 1.0 } else { -2.0 }]);
    let blind = |allowed: f64| {
        let mut integration = RungeKutta::new(&field, 0.0, [0.0], tolerance(allowed)).expect("starts");
        while integration.time() < 1.0 {
            integration.advance(1.0).expect("steps");
        }
        ((integration.state()[0] + 1.0).abs(), integration.work().rejected)
    };
    // The estimators presume a smooth field: the error falls with the tolerance, but is not below it.
    let (errors, refused): (Vec<f64>, Vec<usize>) = [1e-6, 1e-9, 1e-12].into_iter().map(blind).unzip();
    assert!(errors[0] > 10.0 * errors[1] && errors[1] > 10.0 * errors[2], "{errors:?}");
    assert!(refused.iter().all(|count| *count > 5), "{refused:?}");
    let before = By(|_: f64, _: &[f64; 1]| [1.0]);
    let there = integrate(&before, 0.0, [0.0], jump, tolerance(1e-9)).expect("integrates");
    let told = integrate(&field, jump, there, 1.0, tolerance(1e-9)).expect("integrates");
    assert!((told[0] + 1.0).abs() < 1e-14, "{told:?}");
}

#[test]
fn time_runs_backwards_too() {
    let field = tangled();
    let there = integrate(&field, 0.0, [1.0, 1.0], 7.0, tolerance(1e-12)).expect("integrates");
    let back = integrate(&field, 7.0, there, 0.0, tolerance(1e-12)).expect("integrates");
    assert!(distance(&back, &[1.0, 1.0]) < 1e-9, "{back:?}");
    let mut integration = RungeKutta::new(&field, 0.0, [1.0, 1.0], tolerance(1e-10)).expect("starts");
    while integration.time() > -3.0 {
        let step = integration.step(-3.0).expect("steps");
        assert!(step.length() < 0.0 && step.end() >= -3.0);
        let middle = 0.5 * (step.start() + step.end());
        assert!(distance(&step.value(middle), &tangled_solution(middle)) < 1e-9);
    }
}

#[test]
fn stopping_often_costs_no_more_than_the_stops() {
    let field = oscillator();
    let mut stopped = RungeKutta::new(&field, 0.0, [1.0, 0.0], tolerance(1e-10)).expect("starts");
    for n in 1..=20 {
        // Two stops a hair apart: the hair must not set the next step's length.
        for stop in [f64::from(n) * PI, f64::from(n) * PI + 1e-9] {
            while stopped.time() != stop {
                stopped.advance(stop).expect("steps");
            }
        }
    }
    let mut straight = RungeKutta::new(&field, 0.0, [1.0, 0.0], tolerance(1e-10)).expect("starts");
    while straight.time() < 20.0 * PI {
        straight.advance(20.0 * PI).expect("steps");
    }
    let (stopped, straight) = (stopped.work(), straight.work());
    assert!(stopped.accepted <= straight.accepted + 2 * 20, "{stopped:?} {straight:?}");
}

#[test]
fn a_step_to_the_present_time_has_no_length_and_costs_nothing() {
    let field = oscillator();
    let mut integration = RungeKutta::new(&field, 1.0, [1.0, 2.0], tolerance(1e-10)).expect("starts");
    let before = integration.work();
    let step = integration.step(1.0).expect("steps");
    assert_eq!((step.start(), step.end(), step.value(1.0)), (1.0, 1.0, [1.0, 2.0]));
    assert_eq!(integration.work(), before);
}

#[test]
fn evaluations_are_counted_truly() {
    let count = Cell::new(0_usize);
    let field = By(|_: f64, x: &[f64; 2]| {
        count.set(count.get() + 1);
        [x[1], -x[0]]
    });
    let mut integration = RungeKutta::new(&field, 0.0, [1.0, 0.0], tolerance(1e-8)).expect("starts");
    for _ in 0..5 {
        integration.step(100.0).expect("steps");
        integration.advance(100.0).expect("steps");
    }
    assert_eq!(integration.work().evaluations, count.get());
}

#[test]
fn a_blow_up_ends_in_an_error_with_its_time_and_not_in_a_number() {
    // x' = x^2 from 1 is infinite at t = 1.
    let field = By(|_: f64, x: &[f64; 1]| [x[0] * x[0]]);
    match integrate(&field, 0.0, [1.0], 2.0, tolerance(1e-10)) {
        Err(NumericsError::StepTooSmall { time, .. } | NumericsError::NotFinite { time }) => {
            assert!((time - 1.0).abs() < 1e-6, "{time}");
        }
        other => panic!("{other:?}"),
    }
    // The square root leaves its domain at t = 2.
    let field = By(|_: f64, x: &[f64; 1]| [-x[0].sqrt() - 1e-3]);
    match integrate(&field, 0.0, [1.0], 3.0, tolerance(1e-10)) {
        Err(NumericsError::StepTooSmall { time, .. } | NumericsError::NotFinite { time }) => {
            assert!(time > 1.9 && time < 2.0, "{time}");
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn the_limit_of_steps_and_input_that_is_no_number_are_errors() {
    let options = RungeKuttaOptions { step_limit: 10, ..tolerance(1e-10) };
    assert!(matches!(
        integrate(&oscillator(), 0.0, [1.0, 0.0], 1e6, options),
        Err(NumericsError::TooManySteps { steps: 10, .. })
    ));
    for (start, state, end) in [(f64::NAN, 1.0, 1.0), (0.0, f64::INFINITY, 1.0), (0.0, 1.0, f64::NAN)] {
        assert!(matches!(
            integrate(&oscillator(), start, [state, 0.0], end, tolerance(1e-10)),
            Err(NumericsError::NotFinite { .. })
        ));
    }
    assert!(matches!(
        rk4_fixed(&By(|_: f64, x: &[f64; 1]| [x[0].powi(9)]), 0.0, [2.0], 9.0, 10),
        Err(NumericsError::NotFinite { .. })
    ));
}

#[test]
fn options_out_of_range_count_as_the_nearest_end() {
    let odd = RungeKuttaOptions {
        relative_tolerance: -1.0,
        absolute_tolerance: f64::NAN,
        first_step: Some(-1.0),
        largest_step: f64::NAN,
        step_limit: 10_000,
    };
    let end = integrate(&oscillator(), 0.0, [1.0, 0.0], TAU, odd).expect("integrates");
    assert!(distance(&end, &[1.0, 0.0]) < 1e-10, "{end:?}");
    let field = oscillator();
    let bounded = RungeKuttaOptions { largest_step: 0.125, ..tolerance(1e-2) };
    let mut integration = RungeKutta::new(&field, 0.0, [1.0, 0.0], bounded).expect("starts");
    while integration.time() < 1.0 {
        assert!(integration.step(1.0).expect("steps").length() <= 0.125 * 1.01);
    }
}
