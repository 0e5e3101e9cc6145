//! The stability chart against multipliers computed point by point.

use crate::common::{Generator, numbers};
use gear_bifurcations::model::linear::LinearPair;
use gear_bifurcations::model::parameters::{Parameters, Regime};
use gear_bifurcations::numerics::floquet::{self, Matrix6};
use gear_bifurcations::study::chart_work::ChartWork;
use gear_bifurcations::study::grid::Grid;
use gear_bifurcations::study::linear_floquet::LinearFloquet;
use gear_bifurcations::study::multipliers::multipliers;
use gear_bifurcations::study::stability_chart::{StabilityChart, stability_chart, tongues_in};
use gear_bifurcations::study::tongue::{Tongue, tongue_edges};

fn grid(low: f64, high: f64, count: usize) -> Grid {
    Grid { low, high, count }
}

/// Greatest difference from the multipliers at generated points of the chart.
fn worst(p: &Parameters, chart: &StabilityChart, generator: &mut Generator, points: usize) -> f64 {
    (0..points).fold(0.0, |worst, _| {
        let i = (generator.unit() * chart.omega.count as f64) as usize;
        let j = (generator.unit() * chart.k0.count as f64) as usize;
        let omega = chart.omega.value(i);
        let here = Parameters { omega, omega_p: omega, omega_g: omega, k0: chart.k0.value(j), ..*p };
        let expected = multipliers(&here, 1e-12).expect("computes").spectral_radius;
        f64::max(worst, (chart.spectral_radius[j * chart.omega.count + i] - expected).abs())
    })
}

#[test]
fn charts_agree_with_direct_multipliers_within_the_error_they_state() {
    let mut generator = Generator(3);
    let unequal = [("m_p", 1.3), ("m_g", 0.7), ("k_p", 4.0), ("k_g", 6.5)];
    let with = |more: &[(&str, f64)]| numbers(&[&unequal[..], more].concat());
    let cases = [
        numbers(&[("zeta", 0.02)]),
        numbers(&[("zeta", 0.0)]),
        with(&[("zeta", 0.02)]),
        with(&[("zeta", 0.0)]),
        with(&[("zeta", 0.5), ("zeta_p", 1.5)]),
        numbers(&[("zeta", 0.001), ("m_p", 1.0001)]),
        numbers(&[("zeta", 1.5)]),
        numbers(&[("zeta", 0.0), ("zeta_p", 0.03)]),
    ];
    for p in cases {
        // Wide grids are interpolated, small ones computed at their points.
        for (omega, k0) in
            [(grid(0.4, 7.0, 200), grid(0.0, 1.0, 100)), (grid(0.3, 9.0, 11), grid(0.1, 0.9, 5))]
        {
            let chart = stability_chart(&p, omega, k0, 1e-6).expect("computes");
            // A bound: where multipliers meet it is the square root of rounding times the greatest growth.
            assert!(chart.error < 1e-5, "{}", chart.error);
            let seen = worst(&p, &chart, &mut generator, 60);
            assert!(seen < 1e-6, "{seen:e} {p:?}");
            assert!(seen <= chart.error, "{seen:e} {:e} {p:?}", chart.error);
        }
    }
}

#[test]
fn a_single_frequency_and_a_single_depth_are_charts_too() {
    let p = numbers(&[]);
    for (omega, k0) in [
        (grid(1.6, 1.6, 1), grid(0.0, 1.0, 30)),
        (grid(0.5, 6.0, 300), grid(0.5, 0.5, 1)),
        (grid(1.6, 1.6, 1), grid(0.0, 0.0, 1)),
    ] {
        let chart = stability_chart(&p, omega, k0, 1e-6).expect("computes");
        let seen = worst(&p, &chart, &mut Generator(8), 30);
        assert!(seen <= chart.error, "{seen:e} {:e}", chart.error);
    }
}

#[test]
fn what_cannot_be_charted_is_refused() {
    let p = numbers(&[]);
    let plane = grid(0.5, 6.0, 20);
    assert!(stability_chart(&p, grid(0.0, 6.0, 20), grid(0.0, 1.0, 20), 1e-6).is_err());
    assert!(stability_chart(&p, plane, grid(0.0, 1.5, 20), 1e-6).is_err());
    assert!(stability_chart(&p, plane, grid(0.0, 1.0, 20), f64::NAN).is_err());
    assert!(ChartWork::new(&p, plane, grid(0.0, 1.0, 20), 1e-6, Some((2, 2))).is_err());
}

#[test]
fn a_chart_about_a_loaded_response_agrees_with_its_multipliers() {
    let p = Parameters { load: 1.5, regime: Regime::Contact, ..numbers(&[("zeta", 0.05), ("alpha", -0.2)]) };
    let unequal = Parameters { m_p: 1.3, k_g: 6.0, error: 0.1, ..p };
    let kinked = Parameters { regime: Regime::Backlash, load: 2.0, ..p };
    for p in [p, unequal, kinked] {
        let (omega, k0) = (grid(1.0, 4.0, 25), grid(0.0, 0.4, 33));
        let mut work = ChartWork::new(&p, omega, k0, 1e-6, None).expect("allowed");
        let mut slices = 0;
        while !work.advance().expect("computes") {
            slices += 1;
        }
        assert!(slices > 0 && work.done() == 1.0);
        // Most points follow from others, unless teeth may part.
        assert_eq!(work.interpolated() > 0.5, p.regime == Regime::Contact, "{}", work.interpolated());
        let chart = work.chart();
        assert!(chart.error < 1e-5, "{:e}", chart.error);
        let mut found = 0;
        for (index, radius) in chart.spectral_radius.iter().enumerate() {
            let omega = omega.value(index % 25);
            let here = Parameters { omega, omega_p: omega, omega_g: omega, k0: k0.value(index / 25), ..p };
            if index % 7 == 0 && radius.is_finite() {
                let expected = multipliers(&here, 1e-11).expect("computes").spectral_radius;
                let off = (radius - expected).abs();
                assert!(
                    off <= chart.error,
                    "{radius} {expected} {off:e} {:e} {omega} {}",
                    chart.error,
                    here.k0
                );
                found += 1;
            }
        }
        assert!(found > 80, "{found}");
        // Two shares make the same chart.
        let mut shares =
            [0, 1].map(|share| ChartWork::new(&p, omega, k0, 1e-6, Some((share, 2))).expect("allowed"));
        for share in &mut shares {
            while !share.advance().expect("computes") {}
            for column in share.columns().to_vec() {
                for row in 0..k0.count {
                    let index = row * omega.count + column;
                    let (own, whole) = (share.chart().spectral_radius[index], chart.spectral_radius[index]);
                    assert!(own == whole || (own - whole).abs() < 2.0 * chart.error, "{own} {whole}");
                }
            }
        }
    }
}

#[test]
fn the_chart_shows_the_tongues_and_each_has_edges() {
    let p = numbers(&[("zeta", 0.005), ("k0", 0.5)]);
    let chart = stability_chart(&p, grid(1.2, 6.0, 600), grid(0.0, 0.5, 101), 1e-6).expect("computes");
    let seen = tongues_in(&chart);
    for middle in [1.575, 1.765, 1.856, 2.68, 3.52, 5.41] {
        let of_it = seen.iter().find(|tongue| (tongue.omega - middle).abs() < 0.1 && tongue.k0 > 0.4);
        let tongue = of_it.unwrap_or_else(|| panic!("{middle}: {seen:?}"));
        let here = Parameters { k0: tongue.k0, ..p };
        let edges = tongue_edges(&here, Tongue::Near(tongue.omega), 1e-10).expect("found");
        assert!(edges.left.expect("open") < tongue.omega && tongue.omega < edges.right.expect("open"));
    }
}

/// Parameters of the linear problem all over the ranges in which it is not refused for its stiffness.
fn generated(generator: &mut Generator) -> Parameters {
    let mut p = numbers(&[]);
    (p.m_p, p.k_p) = (10_f64.powf(generator.within(-1.0, 1.5)), 10_f64.powf(generator.within(-1.0, 1.5)));
    (p.m_g, p.k_g) = if generator.unit() < 0.4 {
        (p.m_p, p.k_p)
    } else {
        (10_f64.powf(generator.within(-1.0, 1.5)), 10_f64.powf(generator.within(-1.0, 1.5)))
    };
    let mut damping = || if generator.unit() < 0.2 { 0.0 } else { 10_f64.powf(generator.within(-4.0, 0.3)) };
    (p.zeta, p.zeta_p, p.zeta_g) = (damping(), damping(), damping());
    p
}

#[test]
fn without_pulsation_multipliers_are_exponentials_of_the_spectrum() {
    let mut generator = Generator(17);
    for _ in 0..60 {
        let p = Parameters { k0: 0.0, omega: generator.within(0.5, 8.0), ..generated(&mut generator) };
        let pair = LinearPair::new(&p);
        let (b, s, c) = (pair.coupling(), pair.support_stiffness(), pair.damping_matrix());
        let mut matrix = Matrix6::zeros();
        for i in 0..3 {
            matrix[(i, 3 + i)] = 1.0;
            for j in 0..3 {
                matrix[(3 + i, j)] = -b[i] * b[j] - if i == j { s[i] } else { 0.0 };
                matrix[(3 + i, 3 + j)] = -c[i][j];
            }
        }
        let exponents = floquet::spectrum(&matrix).expect("converges");
        let period = p.mesh_period();
        let found = multipliers(&p, 1e-13).expect("computes");
        for (rate, turn) in exponents.re.iter().zip(&exponents.im) {
            let size = (rate * period).exp();
            let (re, im) = (size * (turn * period).cos(), size * (turn * period).sin());
            let off =
                (0..6).map(|i| (found.re[i] - re).hypot(found.im[i] - im)).fold(f64::INFINITY, f64::min);
            assert!(off < 1e-7, "{off:e} {p:?}");
        }
        // And the factors that the chart starts from.
        let linear = LinearFloquet::new(&p);
        let at_rest = linear.at_rest().expect("converges").propagated(period);
        let radius = at_rest.radius().max(linear.idle_radius(p.omega));
        assert!((radius - found.spectral_radius).abs() < 1e-7, "{radius} {} {p:?}", found.spectral_radius);
    }
}

#[test]
fn charts_of_generated_systems_keep_the_error_they_state() {
    let mut generator = Generator(29);
    let (omega, k0) = (grid(0.5, 8.0, 60), grid(0.0, 1.0, 25));
    for _ in 0..25 {
        let p = generated(&mut generator);
        let chart = stability_chart(&p, omega, k0, 1e-6).expect("computes");
        assert!(chart.error < 1e-5, "{:e} {p:?}", chart.error);
        let seen = worst(&p, &chart, &mut generator, 40);
        assert!(seen <= chart.error, "{seen:e} {:e} {p:?}", chart.error);
    }
}
