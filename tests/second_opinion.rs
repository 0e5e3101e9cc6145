//! The gear pair integrated twice, by the Taylor series and by the Runge-Kutta pair: no number is believed that
//! only one of the two gives. They share the parameters; one works on recurrences, the other on values.

use crate::common::{Generator, floats, numbers, parameters, reference};
use gear_bifurcations::model::equations::{Contact, GearPair, U};
use gear_bifurcations::model::parameters::{Parameters, Regime};
use gear_bifurcations::numerics::floquet;
use gear_bifurcations::numerics::ode::Field;
use gear_bifurcations::numerics::ode::event::first_crossing;
use gear_bifurcations::numerics::ode::runge_kutta::{RungeKutta, RungeKuttaOptions, integrate};
use gear_bifurcations::numerics::ode::taylor::{self, Propagation, TaylorField};
use gear_bifurcations::numerics::periodic::matrix;
use gear_bifurcations::study::multipliers::multipliers;
use gear_bifurcations::study::time_response::{TimeResponseOptions, time_response};

const LEN: usize = 25;

fn by_taylor(pair: &GearPair, state: [f64; 6], end: f64) -> [f64; 6] {
    let options = taylor::Options { tolerance: 1e-15, ..taylor::Options::default() };
    taylor::integrate::<GearPair, 6, LEN>(pair, 0.0, state, end, options).expect("integrates")
}

fn distance(left: &[f64; 6], right: &[f64; 6]) -> f64 {
    left.iter().zip(right).fold(0.0, |most, (a, b)| most.max((a - b).abs()))
}

/// One piece of the tooth force, continued beyond its edges.
struct Piece(GearPair, Contact);

impl Field<6> for Piece {
    fn derivative(&self, time: f64, state: &[f64; 6]) -> [f64; 6] {
        let (pair, (slope, offset)) = (&self.0, self.1.line());
        let p = &pair.parameters;
        // The tooth force of this piece less that which the regime has.
        let more = pair.mesh_stiffness(time) * (slope * state[U] - offset - pair.tooth_function(state[U]));
        let mut derivative = pair.derivative(time, state);
        derivative[3] -= more / p.m_p;
        derivative[4] += more / p.m_g;
        derivative[5] -= more * (1.0 + 1.0 / p.m_p + 1.0 / p.m_g);
        derivative
    }
}

/// The motion by the Runge-Kutta pair, switched at the edges of the dead zone: times of switching, and the end.
fn by_runge_kutta(pair: &GearPair, state: [f64; 6], end: f64) -> (Vec<f64>, [f64; 6]) {
    let (mut time, mut state, mut times) = (0.0, state, Vec::new());
    let mut edge_at_start = pair
        .boundaries(pair.piece(0.0, &state))
        .into_iter()
        .flatten()
        .map(|edge| edge.level)
        .find(|level| *level == state[U]);
    let mut options = RungeKuttaOptions::with_tolerance(1e-14);
    'pieces: loop {
        let piece = Piece(*pair, pair.piece(time, &state));
        let mut integration = RungeKutta::new(&piece, time, state, options).expect("starts");
        while integration.time() != end {
            let step = integration.step(end).expect("steps");
            let mut first: Option<(f64, f64)> = None;
            for edge in pair.boundaries(piece.1).into_iter().flatten() {
                let mut coefficients = step.component_coefficients(U);
                coefficients[0] -= edge.level;
                let on_edge = step.start() == time && edge_at_start == Some(edge.level);
                let length = first.map_or(step.length(), |(since, _)| since);
                if let Some(since) = first_crossing(&coefficients, length, on_edge) {
                    first = Some((since, edge.level));
                }
            }
            if let Some((since, level)) = first {
                times.push(step.start() + since);
                (time, edge_at_start) = (step.start() + since, Some(level));
                state = step.value(time);
                state[U] = level;
                options.first_step = integration.proposed_step();
                continue 'pieces;
            }
        }
        return (times, *integration.state());
    }
}

#[test]
fn smooth_responses_agree_over_twenty_periods() {
    for (regime, load, alpha) in
        [(Regime::Homogeneous, 0.0, -0.2), (Regime::Contact, 1.5, 0.2), (Regime::Contact, 1.5, -0.02)]
    {
        let p = numbers(&[
            ("Omega", 1.3),
            ("k0", 0.4),
            ("zeta", 0.05),
            ("m_g", 1.3),
            ("k_p", 4.0),
            ("alpha", alpha),
        ]);
        let pair = GearPair::new(&Parameters { load, regime, ..p });
        let start = [0.02, -0.05, 0.1 + load, 0.03, 0.0, -0.04];
        let end = 20.0 * pair.parameters.mesh_period();
        let ours =
            integrate(&pair, 0.0, start, end, RungeKuttaOptions::with_tolerance(1e-13)).expect("integrates");
        let theirs = by_taylor(&pair, start, end);
        assert!(distance(&ours, &theirs) < 1e-10, "{ours:?} {theirs:?}");
    }
}

/// Fig. 14 a with the dead zone: contact is lost and found again, over and over.
#[test]
fn contact_is_lost_and_found_at_the_same_times() {
    let p = numbers(&[("m", 1.0), ("k", 5.0), ("zeta", 0.07), ("k0", 0.5), ("Omega", 1.6), ("alpha", 0.0)]);
    let pair = GearPair::new(&Parameters { load: 1.5, regime: Regime::Backlash, ..p });
    for start in [[0.0, 0.0, 1.0, 0.0, 0.0, 0.0], [0.4, -0.4, -1.5, 0.3, 0.0, 1.0]] {
        let end = 60.0 * pair.parameters.mesh_period();
        let (times, state) = by_runge_kutta(&pair, start, end);
        let options = taylor::Options { tolerance: 1e-15, ..taylor::Options::default() };
        let mut propagation = Propagation::<GearPair, 6, LEN>::new(&pair, 0.0, start, options);
        let mut known = Vec::new();
        while propagation.time() < end {
            let before = propagation.piece();
            propagation.step(end).expect("steps");
            if propagation.piece() != before {
                known.push(propagation.time());
            }
        }
        assert!(times.len() > 10, "{times:?}");
        assert_eq!(times.len(), known.len(), "{times:?} {known:?}");
        for (time, known) in times.iter().zip(&known) {
            assert!((time - known).abs() < 1e-9, "{time} {known}");
        }
        assert!(distance(&state, propagation.state()) < 1e-9, "{state:?} {:?}", propagation.state());
    }
}

#[test]
fn reference_orbits_close_and_reference_multipliers_have_their_sum() {
    for row in reference("periodic_orbits")["orbits"].as_array().expect("rows") {
        let pair = GearPair::new(&parameters(&row["params"]));
        let period = row["period_in_T"].as_f64().expect("a number") * pair.parameters.mesh_period();
        let start: [f64; 6] = floats(&row["state"]).try_into().expect("six numbers");
        let end = integrate(&pair, 0.0, start, period, RungeKuttaOptions::with_tolerance(1e-13))
            .expect("integrates");
        assert!(distance(&end, &start) < 1e-8, "{}: {end:?}", row["figure"]);
    }
    for row in reference("floquet_multipliers").as_array().expect("rows") {
        let p = Parameters { alpha_p: 0.0, alpha_g: 0.0, ..parameters(&row["params"]) };
        let pair = GearPair::new(&Parameters { load: 0.0, regime: Regime::Homogeneous, ..p });
        let mut trace = 0.0;
        for column in 0..6 {
            let mut start = [0.0; 6];
            start[column] = 1.0;
            let end = integrate(&pair, 0.0, start, p.mesh_period(), RungeKuttaOptions::with_tolerance(1e-13));
            trace += end.expect("integrates")[column];
        }
        let sum: f64 = row["multipliers"].as_array().expect("pairs").iter().map(|pair| floats(pair)[0]).sum();
        assert!((trace - sum).abs() < 1e-9, "{row}: {trace} {sum}");
    }
}

#[test]
fn rattling_onto_the_backs_of_the_teeth_agrees() {
    // Little load and much transmission error: through the whole dead zone and back.
    let p = Parameters {
        load: 0.05,
        error: 2.0,
        regime: Regime::Backlash,
        ..numbers(&[("zeta", 0.07), ("alpha", -0.05)])
    };
    let pair = GearPair::new(&p);
    let (start, end) = ([0.0, 0.0, 1.0, 0.0, 0.0, 0.0], 20.0 * p.mesh_period());
    let (times, other) = by_runge_kutta(&pair, start, end);
    assert!(distance(&by_taylor(&pair, start, end), &other) < 1e-7);
    let options =
        TimeResponseOptions { periods: 20.0, samples_per_period: 2000, ..TimeResponseOptions::new(&p) };
    let response = time_response(&p, &options).expect("computes");
    let u: Vec<f64> = response.states.iter().map(|state| state[U]).collect();
    assert!(u.iter().any(|value| *value < -1.0), "it reaches the backs of the teeth");
    let sampled = u.windows(2).filter(|pair| pair[0] > 1.0 && pair[1] <= 1.0).count();
    assert!(sampled > 5 && response.contact_loss.len() >= sampled, "no loss of contact is missed");
    for loss in &response.contact_loss {
        assert!(times.iter().any(|time| (time - loss).abs() < 1e-8), "{loss} is a switching of both");
    }
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
