//! Whatever the parameters within their ranges, every study of attractors answers in finite numbers or refuses with a
//! reason, and does so soon.

use crate::common::Generator;
use gear_bifurcations::error::StudyError;
use gear_bifurcations::model::parameters::{Parameters, Scale, TABLE, Value};
use gear_bifurcations::study::basin::{BasinOptions, basin};
use gear_bifurcations::study::contact::{contact_margin, least_load};
use gear_bifurcations::study::grid::Grid;
use gear_bifurcations::study::lyapunov::lyapunov;
use gear_bifurcations::study::spectrum::spectrum;
use gear_bifurcations::study::sweep::{SweepOptions, sweep};
use gear_bifurcations::study::torus::torus;

/// Parameters from anywhere in their ranges, both ends included; equal supports every other time.
fn anywhere(random: &mut Generator) -> Parameters {
    let regime = ["homogeneous", "contact", "backlash"][(3.0 * random.unit()) as usize];
    let equal = random.unit() < 0.5;
    let mut named: Vec<(&str, f64)> = Vec::new();
    for info in &TABLE {
        let load = info.name.starts_with('F') || info.name == "E";
        if info.name.starts_with("Omega_") || load && (regime == "homogeneous" || random.unit() < 0.5) {
            continue;
        }
        let (low, high) = (info.low, info.high);
        let value = match (10.0 * random.unit()) as usize {
            0 => low,
            1 => high,
            2..6 => random.within(info.slider.0, info.slider.1),
            _ if info.scale == Scale::Logarithmic => random.within(low.ln(), high.ln()).exp(),
            _ => random.within(low, high),
        };
        let twin = info.name.strip_suffix("_g").filter(|_| equal && !load);
        let same = twin.and_then(|stem| named.iter().find(|(name, _)| *name == format!("{stem}_p")));
        let value = same.map_or(value.clamp(low, high), |(_, value)| *value);
        named.push((info.name, value));
    }
    let numbers = named.into_iter().map(|(name, value)| (name, Value::Number(value)));
    Parameters::from_named(numbers.chain([("regime", Value::Text(regime.into()))]))
        .expect("within the ranges")
}

/// That an answer's numbers are finite, or that it was refused in words.
fn sound<T>(answer: Result<T, StudyError>, numbers: impl Fn(&T) -> Vec<f64>, p: &Parameters) {
    match answer {
        Ok(answer) => {
            let numbers = numbers(&answer);
            assert!(numbers.iter().all(|number| number.is_finite()), "{numbers:?} {p:?}");
        }
        Err(error) => assert!(!error.to_string().is_empty()),
    }
}

#[test]
fn every_study_answers_in_finite_numbers_or_refuses() {
    let mut random = Generator(20);
    for _ in 0..6 {
        let p = anywhere(&mut random);
        sound(torus(&p, 1e-7), |t| vec![t.mean_radius, t.rotation, t.r_min, t.r_max, t.growth], &p);
        sound(lyapunov(&p, None, 20, 1e-7), |found| found.exponents.to_vec(), &p);
        sound(spectrum(&p, None, 10, 8, 1e-7), |found| found.amplitude.clone(), &p);
        sound(contact_margin(&p, None, 1e-7), |found| vec![found.margin, found.at], &p);
        let numbers = |load: &Option<f64>| load.iter().copied().collect::<Vec<f64>>();
        sound(least_load(&p, 1e-7), |found| numbers(&found.load), &p);
        let ends = [p.omega.min(90.0), p.omega.min(90.0) * 1.1];
        let omega = Grid::new("Omega", ends, 3, [0.01, 100.0]).expect("allowed");
        let options = SweepOptions { transient: 5, points: 3, ..SweepOptions::new(omega) };
        sound(sweep(&p, &options), |found| [&found.u_p[..], &found.u].concat(), &p);
        let plane = Grid::new("x", [-2.0, 2.0], 4, [-100.0, 100.0]).expect("allowed");
        let options = BasinOptions { periods: Some(50), ..BasinOptions::new(&p, plane, plane) };
        let found = basin(&p, &options);
        sound(found, |found| found.attractors.iter().flat_map(|one| one.state).collect(), &p);
    }
}
