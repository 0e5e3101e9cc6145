mod common;
use common::Generator;
use gear_bifurcations::model::parameters::Parameters;
use gear_bifurcations::study::grid::Grid;
use gear_bifurcations::study::multipliers::multipliers;
use gear_bifurcations::study::stability_chart::stability_chart;
use gear_bifurcations::study::tongue::{Tongue, tongue_edges};
use gear_bifurcations::study::tongue_boundary::tongue_boundary;
use std::time::Instant;
fn draw(g: &mut Generator, wide: bool) -> Parameters {
    let e = if wide { (1e-3f64.ln(), 1e6f64.ln()) } else { (0.2f64.ln(), 20f64.ln()) };
    let mut l = || g.within(e.0, e.1).exp();
    let (m_p, k_p, mut m_g, mut k_g) = (l(), l(), l(), l());
    if g.unit() < 0.4 {
        m_g = m_p;
        k_g = k_p;
    }
    let z = if wide { 2.0 } else { 0.05 };
    let mut zz = || if g.unit() < 0.2 { 0.0 } else { z * g.unit() * g.unit() };
    let (zeta, zeta_p, zeta_g) = (zz(), zz(), zz());
    let same = g.unit() < 0.5;
    Parameters {
        m_p,
        m_g,
        k_p,
        k_g,
        zeta,
        zeta_p: if same { zeta } else { zeta_p },
        zeta_g: if same { zeta } else { zeta_g },
        k0: g.unit(),
        ..Parameters::default()
    }
}
#[test]
fn robust() {
    for (wide, n) in [(false, 40), (true, 40)] {
        let mut g = Generator(if wide { 77 } else { 5 });
        let (mut errors, mut open, mut closed, mut slowest) = (0, 0, 0, 0.0f64);
        for case in 0..n {
            let p = draw(&mut g, wide);
            for tongue in
                [Tongue::Primary2, Tongue::Primary3, Tongue::Combination, Tongue::Near(g.within(0.5, 5.0))]
            {
                let s = Instant::now();
                let e = tongue_edges(&p, tongue, 1e-10);
                let t = s.elapsed().as_secs_f64();
                if t > 1.0 {
                    println!("SLOW {wide} {case} {tongue:?} {t} {p:?}");
                }
                slowest = slowest.max(t);
                match &e {
                    Err(x) => {
                        errors += 1;
                        println!("ERR {wide} {case} {tongue:?} {x} {p:?}");
                    }
                    Ok(e) => match (e.left, e.right) {
                        (Some(a), Some(b)) => {
                            open += 1;
                            if !(a < b) {
                                println!("BAD order {a} {b}");
                            }
                            let r = |o: f64| {
                                multipliers(&Parameters { omega: o, ..p }, 1e-12).map(|m| m.spectral_radius)
                            };
                            let kind = e.kind.unwrap();
                            for (edge, d) in [(a, 1.0), (b, -1.0)] {
                                let w = b - a;
                                let (inn, out) = (r(edge + d * 1e-3 * w), r(edge - d * 1e-3 * w));
                                if let (Ok(i), Ok(o)) = (inn, out) {
                                    if !(i > 1.0 - 1e-12)
                                        || o > 1.0 + 1e-6 && !matches!(tongue, Tongue::Near(_))
                                        || (o > 1.0 + 1e-6)
                                    {
                                        println!(
                                            "ODD {wide} {case} {tongue:?} edge {edge} of {a} {b} {kind:?} in {i} out {o} k0 {} err {:?}",
                                            p.k0, e.error
                                        );
                                    }
                                }
                            }
                        }
                        (None, None) => closed += 1,
                        _ => println!("HALF"),
                    },
                }
                let s = Instant::now();
                let b = tongue_boundary(&p, tongue, [0.0, p.k0.max(0.01)], 40, 1e-9);
                let t = s.elapsed().as_secs_f64();
                if t > 1.0 {
                    println!("SLOW {wide} {case} {tongue:?} {t} {p:?}");
                }
                slowest = slowest.max(t);
                match b {
                    Err(x) => {
                        errors += 1;
                        println!("BERR {wide} {case} {tongue:?} {x} {p:?}");
                    }
                    Ok(b) => {
                        if b.omega.iter().chain(&b.k0).any(|v| !v.is_finite()) {
                            println!("NAN boundary");
                        }
                        if let Ok(e) = &e {
                            if e.left.is_some() != !b.omega.is_empty() {
                                println!("MISMATCH");
                            }
                        }
                    }
                }
            }
            let s = Instant::now();
            let c = stability_chart(
                &p,
                Grid { low: 0.3, high: 6.0, count: 23 },
                Grid { low: 0.0, high: 1.0, count: 17 },
                1e-6,
            );
            slowest = slowest.max(s.elapsed().as_secs_f64());
            match c {
                Err(x) => {
                    errors += 1;
                    println!("CERR {wide} {case} {x} {p:?}");
                }
                Ok(c) => {
                    if c.spectral_radius.iter().any(|v| !v.is_finite()) {
                        println!("NAN chart");
                    }
                    for _ in 0..6 {
                        let i = (g.unit() * 23.0) as usize;
                        let j = (g.unit() * 17.0) as usize;
                        let o = c.omega.value(i);
                        if let Ok(m) = multipliers(&Parameters { omega: o, k0: c.k0.value(j), ..p }, 1e-13) {
                            let d = (m.spectral_radius - c.spectral_radius[j * 23 + i]).abs();
                            if d > c.error.max(1e-12) {
                                println!(
                                    "CHART {wide} {case} off {d:e} said {:e} radius {} at {o} {}; qr step {:?}",
                                    c.error,
                                    m.spectral_radius,
                                    c.k0.value(j),
                                    m.error
                                );
                            }
                        }
                    }
                    if c.error > 1e-5 {
                        println!(
                            "LARGE error {wide} {case} {:e} max {:e}",
                            c.error,
                            c.spectral_radius.iter().fold(0.0f64, |a, b| a.max(*b))
                        );
                    }
                }
            }
        }
        println!("SUM wide {wide}: errors {errors} open {open} closed {closed} slowest {slowest}");
    }
}
