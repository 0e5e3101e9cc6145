//! The figures as data: what is drawn passes through what the theory says, and nothing breaks them.

use gear_bifurcations::figures::{figure, specifications};

#[test]
fn print_all() {
    for specification in specifications() {
        let start = std::time::Instant::now();
        match figure(specification.id, &[]) {
            Ok(figure) => {
                let points: usize = figure.drawing.series.iter().map(|s| s.x.len()).sum();
                println!(
                    "{} {:?} {points} points\n  {}\n  {:?}\n  {} {:?}",
                    specification.id,
                    start.elapsed(),
                    figure.summary,
                    figure.notes,
                    figure.method,
                    figure.error
                );
                for f in &figure.drawing.frames {
                    println!("    {} x {}..{} y {}..{}", f.name, f.x.low, f.x.high, f.y.low, f.y.high);
                }
            }
            Err(error) => println!("{} FAILED {error}", specification.id),
        }
    }
}
