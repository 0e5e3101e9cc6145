//! Taylor series against the Runge-Kutta pair: no number is believed that only one of the two gives.

mod common;

use common::{Generator, numbers};
use gear_bifurcations::model::equations::{Contact, GearPair, U};
use gear_bifurcations::model::parameters::{Parameters, Regime};
use gear_bifurcations::numerics::floquet;
use gear_bifurcations::numerics::ode::Field;
use gear_bifurcations::numerics::ode::event;
use gear_bifurcations::numerics::ode::runge_kutta::{RungeKutta, RungeKuttaOptions, integrate};
use gear_bifurcations::numerics::ode::taylor::TaylorField;
use gear_bifurcations::numerics::periodic::matrix;
use gear_bifurcations::study::motion::{carry, default_state};
use gear_bifurcations::study::multipliers::multipliers;
use gear_bifurcations::study::time_response::{TimeResponseOptions, time_response};

/// The motion of one analytic piece, as if it had no end.
struct OnePiece {
    pair: GearPair,
    contact: Contact,
}

impl Field<6> for OnePiece {
    fn derivative(&self, time: f64, state: &[f64; 6]) -> [f64; 6] {
        let p = &self.pair.parameters;
        let (slope, offset) = self.contact.line();
        let mesh = 2.0 * p.zeta * state[5] + self.pair.mesh_stiffness(time) * (slope * state[U] - offset);
        let support = |i: usize, k: f64, alpha: f64, zeta: f64| {
            -2.0 * zeta * state[3 + i] - k * state[i] - alpha * state[i].powi(3)
        };
        let a_p = (support(0, p.k_p, p.alpha_p, p.zeta_p) - mesh) / p.m_p;
        let a_g = (support(1, p.k_g, p.alpha_g, p.zeta_g) + mesh) / p.m_g;
        [state[3], state[4], state[5], a_p, a_g, a_p - a_g - mesh + self.pair.load(time)]
    }
}

/// A motion with the dead zone by the Runge-Kutta pair, restarted at every crossing of its dense output; also the
/// times at which the teeth part.
fn by_runge_kutta(pair: &GearPair, start: [f64; 6], end: f64) -> ([f64; 6], Vec<f64>) {
    let options = RungeKuttaOptions::with_tolerance(1e-13);
    let (mut time, mut state, mut losses) = (0.0, start, Vec::new());
    let mut on_boundary = None;
    'pieces: while time < end {
        let contact = pair.piece(time, &state);
        let piece = OnePiece { pair: *pair, contact };
        let mut integrator = RungeKutta::new(&piece, time, state, options).expect("valid");
        while integrator.time() < end {
            let step = integrator.step(end).expect("steps");
            let mut first: Option<(f64, f64)> = None;
            for boundary in pair.boundaries(contact).into_iter().flatten() {
                let mut coefficients = step.component_coefficients(boundary.coordinate);
                coefficients[0] -= boundary.level;
                let here = on_boundary == Some(boundary.level);
                let length = first.map_or(step.length(), |(since, _)| since);
                if let Some(since) = event::first_crossing(&coefficients, length, here) {
                    first = Some((since, boundary.level));
                }
            }
            on_boundary = None;
            if let Some((since, level)) = first {
                if contact == Contact::Driving {
                    losses.push(step.start() + since);
                }
                state = step.value(step.start() + since);
                state[U] = level;
                time = step.start() + since;
                on_boundary = Some(level);
                continue 'pieces;
            }
        }
        return (*integrator.state(), losses);
    }
    (state, losses)
}

fn difference(left: &[f64; 6], right: &[f64; 6]) -> f64 {
    left.iter().zip(right).fold(0.0, |most, (a, b)| f64::max(most, (a - b).abs()))
}

fn figure_14(alpha: f64, regime: Regime) -> Parameters {
    Parameters { load: 1.5, regime, ..numbers(&[("zeta", 0.07), ("alpha", alpha)]) }
}

#[test]
fn smooth_motions_agree() {
    let mut random = Generator(11);
    for _ in 0..20 {
        let p = numbers(&[
            ("m_p", random.within(0.5, 2.0)),
            ("k_g", random.within(2.0, 8.0)),
            ("alpha", random.within(-0.3, 0.3)),
            ("zeta", random.within(0.0, 0.1)),
            ("k0", random.within(0.0, 1.0)),
            ("Omega", random.within(0.5, 6.0)),
        ]);
        let p =
            Parameters { regime: Regime::Contact, load: 2.0, load_p: 0.3, omega_p: 0.37, error: 0.1, ..p };
        let pair = GearPair::new(&p);
        let end = 20.0;
        let taylor = carry(&pair, 0.0, default_state(&p), end, 1e-12).expect("computes");
        let options = RungeKuttaOptions::with_tolerance(1e-13);
        let other = integrate(&pair, 0.0, default_state(&p), taylor.time, options).expect("computes");
        let size = taylor.state.iter().fold(1.0, |most: f64, x| most.max(x.abs()));
        assert!(difference(&taylor.state, &other) < 1e-9 * size, "{p:?}");
    }
}

#[test]
fn motions_through_the_dead_zone_agree() {
    for alpha in [0.0, -0.2, 0.3] {
        let p = figure_14(alpha, Regime::Backlash);
        let pair = GearPair::new(&p);
        let end = 30.0 * p.mesh_period();
        let taylor = carry(&pair, 0.0, default_state(&p), end, 1e-12).expect("computes");
        let (other, losses) = by_runge_kutta(&pair, default_state(&p), end);
        assert!(difference(&taylor.state, &other) < 1e-8, "{:?} {other:?}", taylor.state);
        let options = TimeResponseOptions { periods: 30.0, ..TimeResponseOptions::new(&p) };
        let response = time_response(&p, &options).expect("computes");
        assert_eq!(losses.len(), response.contact_loss.len());
        for (ours, theirs) in response.contact_loss.iter().zip(&losses) {
            assert!((ours - theirs).abs() < 1e-8, "{ours} {theirs}");
        }
        assert!(alpha != 0.0 || losses.len() > 10, "Fig. 14 a parts the teeth again and again");
    }
}

#[test]
fn every_crossing_and_no_other_is_an_event_under_hard_shaking() {
    // Teeth rattle through the whole dead zone onto their backs.
    let p = Parameters { load: 0.05, error: 2.0, ..figure_14(-0.05, Regime::Backlash) };
    let pair = GearPair::new(&p);
    let end = 20.0 * p.mesh_period();
    let taylor = carry(&pair, 0.0, default_state(&p), end, 1e-12).expect("computes");
    let (other, losses) = by_runge_kutta(&pair, default_state(&p), end);
    assert!(difference(&taylor.state, &other) < 1e-7, "{:?} {other:?}", taylor.state);
    let options =
        TimeResponseOptions { periods: 20.0, samples_per_period: 2000, ..TimeResponseOptions::new(&p) };
    let response = time_response(&p, &options).expect("computes");
    let u: Vec<f64> = response.states.iter().map(|state| state[U]).collect();
    assert!(u.iter().any(|value| *value < -1.0), "it reaches the back of the teeth");
    let sampled = u.windows(2).filter(|pair| pair[0] > 1.0 && pair[1] <= 1.0).count();
    assert_eq!(response.contact_loss.len(), losses.len());
    assert!(response.contact_loss.len() >= sampled);
}

#[test]
fn multipliers_agree_with_columns_integrated_over_the_whole_period() {
    let mut random = Generator(12);
    for _ in 0..10 {
        let p = numbers(&[
            ("m_p", random.within(0.5, 2.0)),
            ("k_g", random.within(2.0, 8.0)),
            ("zeta", random.within(0.0, 0.1)),
            ("zeta_p", random.within(0.0, 0.1)),
            ("k0", random.within(0.0, 1.0)),
            ("Omega", random.within(0.5, 6.0)),
        ]);
        let linear = GearPair::new(&Parameters { alpha_p: 0.0, alpha_g: 0.0, ..p });
        let mut rows = [[0.0; 6]; 6];
        for column in 0..6 {
            let mut start = [0.0; 6];
            start[column] = 1.0;
            let options = RungeKuttaOptions::with_tolerance(1e-13);
            let end = integrate(&linear, 0.0, start, p.mesh_period(), options).expect("computes");
            for row in 0..6 {
                rows[row][column] = end[row];
            }
        }
        let other = floquet::spectrum(&matrix(&rows)).expect("converges");
        let ours = multipliers(&p, 1e-12).expect("computes");
        let ours = floquet::Spectrum { re: ours.re, im: ours.im };
        assert!(ours.distance(&other) < 1e-9, "{p:?}");
    }
}
