//! The speed of the jobs in `study::benchmark`, natively: a line for each: its name, microseconds, and the
//! ceiling in microseconds if it has one, with tabs between.
//!
//! `benches/bench.js` measures the same jobs in the same way in Node and in a browser; `cargo xtask bench` runs all and records them.

use gear_bifurcations::error::StudyError;
use gear_bifurcations::study::benchmark;
use std::time::{Duration, Instant};

/// Samples of which the median is taken.
const SAMPLES: usize = 15;
/// The same of a job that takes longer than `LONG`.
const FEW_SAMPLES: usize = 3;
const LONG: Duration = Duration::from_millis(300);
/// Least time of a sample: long against the clock's grain and the scheduler's whims.
const LEAST: Duration = Duration::from_millis(20);

fn main() -> Result<(), StudyError> {
    // `cargo bench` passes `--bench`; another word selects jobs by a part of their name.
    let wanted: Vec<String> = std::env::args().skip(1).filter(|word| !word.starts_with("--")).collect();
    for benchmark::Job { name, ceiling, .. } in benchmark::JOBS {
        if wanted.iter().all(|word| name.contains(word.as_str())) {
            let ceiling = ceiling.map_or(String::new(), |ceiling| format!("\t{ceiling}"));
            println!("{name}\t{:.4}{ceiling}", median_microseconds(name)?);
        }
    }
    Ok(())
}

fn median_microseconds(job: &str) -> Result<f64, StudyError> {
    // How many repetitions fill a sample; finding it warms the job up.
    let mut repetitions = 1;
    let mut once = time(job, repetitions)?;
    while once < LEAST {
        repetitions *= 2;
        once = time(job, repetitions)?;
    }
    let count = if once > LONG { FEW_SAMPLES } else { SAMPLES };
    let mut samples = Vec::with_capacity(count);
    for _ in 0..count {
        samples.push(time(job, repetitions)?.as_secs_f64() * 1e6 / repetitions as f64);
    }
    samples.sort_by(f64::total_cmp);
    Ok(samples[count / 2])
}

fn time(job: &str, repetitions: usize) -> Result<Duration, StudyError> {
    let start = Instant::now();
    std::hint::black_box(benchmark::run(std::hint::black_box(job), repetitions)?);
    Ok(start.elapsed())
}
