//! Properties that must hold for any parameters, on generated ones.

use crate::common::{Generator, numbers};
use gear_bifurcations::model::equations::GearPair;
use gear_bifurcations::model::linear::{self, LinearPair};
use gear_bifurcations::model::parameters::{Parameters, Regime};
use gear_bifurcations::numerics::floquet::{self, liouville_residual};
use gear_bifurcations::numerics::ode::Field;
use gear_bifurcations::numerics::ode::taylor::{Options, integrate};
use gear_bifurcations::numerics::periodic::matrix;
use gear_bifurcations::study::motion::{self, carry};
use gear_bifurcations::study::multipliers::{Budget, image, linear_monodromy, multipliers};
use gear_bifurcations::study::orbit::{OrbitOptions, periodic_orbit};
use gear_bifurcations::study::poincare::{PoincareOptions, poincare};

fn generated(random: &mut Generator) -> Parameters {
    numbers(&[
        ("m_p", random.within(0.3, 4.0)),
        ("m_g", random.within(0.3, 4.0)),
        ("k_p", random.within(1.0, 12.0)),
        ("k_g", random.within(1.0, 12.0)),
        ("alpha_p", random.within(-0.5, 0.5)),
        ("alpha_g", random.within(-0.5, 0.5)),
        ("zeta", random.within(0.0, 0.1)),
        ("zeta_p", random.within(0.0, 0.1)),
        ("zeta_g", random.within(0.0, 0.1)),
        ("k0", random.within(0.0, 1.0)),
        ("Omega", random.within(0.5, 7.0)),
    ])
}

fn state(random: &mut Generator, size: f64) -> [f64; 6] {
    std::array::from_fn(|_| random.within(-size, size))
}

fn difference(left: &[f64; 6], right: &[f64; 6]) -> f64 {
    left.iter().zip(right).fold(0.0, |most, (a, b)| f64::max(most, (a - b).abs()))
}

#[test]
fn the_jacobian_is_the_derivative_in_every_regime() {
    let mut random = Generator(1);
    for _ in 0..50 {
        let p = generated(&mut random);
        for regime in [Regime::Homogeneous, Regime::Contact, Regime::Backlash] {
            let pair = GearPair::new(&Parameters { regime, ..p });
            let (at, time) = (state(&mut random, 3.0), random.within(0.0, 10.0));
            let jacobian = pair.jacobian(time, &at);
            for column in 0..6 {
                let moved = |by: f64| {
                    let mut moved = at;
                    moved[column] += by;
                    pair.derivative(time, &moved)
                };
                let (forward, back) = (moved(1e-5), moved(-1e-5));
                for row in 0..6 {
                    let slope = (forward[row] - back[row]) / 2e-5;
                    assert!((slope - jacobian[row][column]).abs() < 1e-6, "{regime:?} {row} {column}");
                }
            }
            let trace: f64 = (0..6).map(|i| jacobian[i][i]).sum();
            assert!((trace - pair.trace()).abs() < 1e-12);
        }
    }
}

#[test]
fn half_a_period_gives_the_whole_monodromy_for_any_supports_and_damping() {
    let mut random = Generator(2);
    for _ in 0..40 {
        let p = generated(&mut random);
        let by_half = matrix(&linear_monodromy(&p, 1e-12, 1.0).expect("computes"));
        let options = Options { tolerance: 1e-14, ..Options::default() };
        let whole = integrate::<_, { linear::SIZE }, 25>(
            &LinearPair::new(&p),
            0.0,
            linear::start(),
            p.mesh_period(),
            options,
        )
        .expect("computes");
        let whole = matrix(&linear::rows(&whole));
        assert!((by_half - whole).amax() < 1e-10 * whole.amax().max(1.0), "{p:?}");
    }
}

#[test]
fn liouville_holds_along_linear_and_nonlinear_motions() {
    let mut random = Generator(3);
    for _ in 0..40 {
        let p = generated(&mut random);
        let found = multipliers(&p, 1e-10).expect("computes");
        assert!(found.error.liouville.is_some_and(|residual| residual < 1e-9), "{p:?} {found:?}");
        let pair = GearPair::new(&p);
        let (_, derivative) =
            image(&pair, &state(&mut random, 0.3), 2, 1e-10, 1.0, &Budget::default()).expect("stays small");
        let (derivative, log_determinant) = (matrix(&derivative), pair.trace() * 2.0 * p.mesh_period());
        let residual = liouville_residual(&derivative, log_determinant);
        // Hadamard's bound of the determinant, times the states' error, is what it can be known to.
        let hadamard: f64 = derivative.row_iter().map(|row| row.norm()).product();
        let known_to = 1e-11 * hadamard / log_determinant.exp();
        assert!(residual < 1e-10 + known_to, "{residual:e} {known_to:e} {p:?}");
    }
}

#[test]
fn undamped_multipliers_come_in_reciprocal_pairs() {
    let mut random = Generator(4);
    for _ in 0..40 {
        let p = Parameters { zeta: 0.0, zeta_p: 0.0, zeta_g: 0.0, ..generated(&mut random) };
        let found = multipliers(&p, 1e-12).expect("computes");
        for (re, im) in found.re.iter().zip(&found.im) {
            let square = re * re + im * im;
            let nearest = found
                .re
                .iter()
                .zip(&found.im)
                .map(|(a, b)| (a - re / square).hypot(b + im / square))
                .fold(f64::INFINITY, f64::min);
            // Where two multipliers meet, rounding moves each by its square root.
            assert!(nearest < 1e-6, "{p:?} {found:?}");
        }
    }
}

#[test]
fn without_pulsation_multipliers_are_exponentials_of_the_spectrum() {
    let mut random = Generator(5);
    for _ in 0..20 {
        let p = Parameters { k0: 0.0, ..generated(&mut random) };
        let found = multipliers(&p, 1e-12).expect("computes");
        let jacobian = matrix(&GearPair::new(&p).jacobian(0.0, &[0.0; 6]));
        let exponents = floquet::spectrum(&jacobian).expect("converges");
        for (rate, frequency) in exponents.re.iter().zip(&exponents.im) {
            let (modulus, angle) = ((rate * p.mesh_period()).exp(), frequency * p.mesh_period());
            let nearest = found
                .re
                .iter()
                .zip(&found.im)
                .map(|(re, im)| (re - modulus * angle.cos()).hypot(im - modulus * angle.sin()))
                .fold(f64::INFINITY, f64::min);
            assert!(nearest < 1e-9, "{p:?}");
        }
    }
}

#[test]
fn the_homogeneous_system_is_symmetric_in_sign_and_equal_supports_in_exchange() {
    let mut random = Generator(6);
    for _ in 0..20 {
        let p = generated(&mut random);
        let pair = GearPair::new(&p);
        let (start, end) = (state(&mut random, 0.5), 5.0 * p.mesh_period());
        let reached = carry(&pair, 0.0, start, end, 1e-12).expect("computes");
        let mirrored = carry(&pair, 0.0, start.map(|x| -x), end, 1e-12).expect("computes");
        assert_eq!(reached.state.map(|x| -x), mirrored.state);

        let equal = Parameters { m_g: p.m_p, k_g: p.k_p, alpha_g: p.alpha_p, zeta_g: p.zeta_p, ..p };
        let exchange = |s: [f64; 6]| [-s[1], -s[0], s[2], -s[4], -s[3], s[5]];
        let pair = GearPair::new(&equal);
        let reached = carry(&pair, 0.0, start, end, 1e-12).expect("computes");
        let exchanged = carry(&pair, 0.0, exchange(start), end, 1e-12).expect("computes");
        assert!(difference(&exchange(reached.state), &exchanged.state) < 1e-9);
    }
}

#[test]
fn the_variational_flow_is_the_derivative_of_the_motion_through_contact_loss() {
    let p = Parameters {
        regime: Regime::Backlash,
        load: 1.5,
        alpha_p: 0.0,
        alpha_g: 0.0,
        ..numbers(&[("zeta", 0.07)])
    };
    let pair = GearPair::new(&p);
    let orbit = periodic_orbit(&p, &OrbitOptions { period: 2, ..OrbitOptions::default() }).expect("found");
    assert!(orbit.min[2] < 1.0, "the orbit parts the teeth");
    let (_, derivative) = image(&pair, &orbit.state, 2, 1e-12, 1.0, &Budget::default()).expect("computes");
    for column in 0..6 {
        let end = 2.0 * p.mesh_period();
        let moved = |by: f64| {
            let mut start = orbit.state;
            start[column] += by;
            carry(&pair, 0.0, start, end, 1e-13).expect("computes").state
        };
        let (forward, back) = (moved(1e-5), moved(-1e-5));
        for row in 0..6 {
            let slope = (forward[row] - back[row]) / 2e-5;
            assert!((slope - derivative[row][column]).abs() < 2e-6, "{row} {column}: {slope} {derivative:?}");
        }
    }
}

#[test]
fn unloaded_contact_is_the_homogeneous_system_about_one() {
    let homogeneous = numbers(&[]);
    let contact = Parameters { regime: Regime::Contact, ..homogeneous };
    let start = [-0.02, 0.02, 0.05, 0.0, 0.0, 0.0];
    let shifted = [-0.02, 0.02, 1.05, 0.0, 0.0, 0.0];
    let points = |p: &Parameters, state| {
        poincare(p, &PoincareOptions { state, points: 50, ..PoincareOptions::new(p) })
            .expect("computes")
            .states
    };
    for (deviation, whole) in points(&homogeneous, start).iter().zip(points(&contact, shifted)) {
        let mut expected = *deviation;
        expected[2] += 1.0;
        assert!(difference(&expected, &whole) < 1e-9);
    }
}

#[test]
fn escape_over_the_softening_barrier_is_an_answer_with_its_time() {
    let p = numbers(&[("Omega", 1.2), ("alpha", -0.2)]);
    let start = [4.9, -5.1, 0.0, 3.0, -3.0, 0.0];
    let found = poincare(&p, &PoincareOptions { state: start, points: 100, ..PoincareOptions::new(&p) })
        .expect("answers");
    let time = found.escaped.expect("escapes");
    let bound = GearPair::new(&p).escape_bounds()[0];
    assert_eq!(bound, 10.0 * (5.0_f64 / 0.2).sqrt());
    let reached = carry(&GearPair::new(&p), 0.0, start, 1e3, 1e-10).expect("answers");
    assert!((reached.time - time).abs() < 1e-9);
    let largest = reached.state[0].abs().max(reached.state[1].abs());
    assert!((largest / bound - 1.0).abs() < 1e-9, "the escape is located: {largest}");
}

#[test]
fn incommensurate_loads_are_refused_and_commensurate_ones_have_their_common_period() {
    let loaded = |omega_p: f64| {
        let p = numbers(&[("zeta", 0.07), ("Omega", 1.3), ("alpha", -0.1)]);
        Parameters { regime: Regime::Contact, load: 3.0, load_p: 0.1, omega_p, ..p }
    };
    let third = loaded(1.3 / 3.0);
    let orbit =
        periodic_orbit(&third, &OrbitOptions { period: 3, ..OrbitOptions::default() }).expect("found");
    assert_eq!(orbit.period, 3);
    assert!(orbit.error.residual.is_some_and(|residual| residual < 1e-9));
    assert!(multipliers(&third, 1e-10).is_ok());
    let shortest = periodic_orbit(&third, &OrbitOptions::default()).expect("found");
    assert_eq!(shortest.period, 3, "the shortest there can be");
    assert!(periodic_orbit(&third, &OrbitOptions { period: 2, ..OrbitOptions::default() }).is_err());
    assert!(multipliers(&loaded(1.3 / 2.0_f64.sqrt()), 1e-10).is_err());
    let state = motion::default_state(&third);
    assert!(state.iter().all(|value| value.is_finite()));
}

#[test]
fn corners_of_the_ranges_are_answered_or_refused_within_the_budget() {
    // Stiff supports, slow meshing, fluctuations of long common period: each took minutes without a budget.
    let slow = |given: &[(&str, f64)], regime| Parameters { regime, ..numbers(given) };
    let corners = [
        Parameters {
            load: -1e3,
            load_g: -1e3,
            error: 1e3,
            omega_p: 1e-4,
            omega_g: 100.0,
            ..slow(&[("m", 1e6), ("k_p", 1e-3), ("zeta", 0.0), ("Omega", 0.01)], Regime::Backlash)
        },
        Parameters {
            load: -1e3,
            load_g: 1e3,
            ..slow(
                &[("m_p", 1e6), ("m_g", 1e-3), ("k_g", 1e-3), ("alpha", 1e3), ("zeta", 2.0)],
                Regime::Contact,
            )
        },
        Parameters { load_g: 5.0, omega_g: 1.6, ..slow(&[("Omega", 7.0)], Regime::Backlash) },
        Parameters { load: 1.0, ..slow(&[("m", 1e-3), ("k", 1e6), ("Omega", 0.01)], Regime::Contact) },
    ];
    for p in &corners {
        if let Ok(found) = multipliers(p, 1e-10) {
            assert!(found.re.iter().chain(&found.im).all(|value| value.is_finite()));
        }
        if let Ok(orbit) = periodic_orbit(p, &OrbitOptions::default()) {
            assert!(orbit.state.iter().chain(&orbit.max).all(|value| value.is_finite()));
        }
    }
}
