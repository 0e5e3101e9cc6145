//! The speed of the jobs in `study::benchmark`, natively: a line for each, its name, a tab, microseconds.
//!
//! `benches/bench.js` measures the same jobs in the same way in Node and in a browser; `cargo xtask bench` runs all and records them.

use gear_bifurcations::error::StudyError;
use gear_bifurcations::study::benchmark;
use std::time::{Duration, Instant};

/// Samples of which the median is taken.
const SAMPLES: usize = 15;
/// Least time of a sample: long against the clock's grain and the scheduler's whims.
const LEAST: Duration = Duration::from_millis(20);

fn main() -> Result<(), StudyError> {
    // `cargo bench` passes `--bench`; another word selects jobs by a part of their name.
    let wanted: Vec<String> = std::env::args().skip(1).filter(|word| !word.starts_with("--")).collect();
    for job in benchmark::JOBS.map(|job| job.name) {
        if wanted.iter().all(|word| job.contains(word.as_str())) {
            println!("{job}\t{:.4}", median_microseconds(job)?);
        }
    }
    Ok(())
}

fn median_microseconds(job: &str) -> Result<f64, StudyError> {
    let repetitions = enough_repetitions(job)?;
    let mut samples = Vec::with_capacity(SAMPLES);
    for _ in 0..SAMPLES {
        samples.push(time(job, repetitions)?.as_secs_f64() * 1e6 / repetitions as f64);
    }
    samples.sort_by(f64::total_cmp);
    Ok(samples[SAMPLES / 2])
}

/// The number of repetitions that fills a sample; finding it warms the job up.
fn enough_repetitions(job: &str) -> Result<usize, StudyError> {
    let mut repetitions = 1;
    while time(job, repetitions)? < LEAST {
        repetitions *= 2;
    }
    Ok(repetitions)
}

fn time(job: &str, repetitions: usize) -> Result<Duration, StudyError> {
    let start = Instant::now();
    std::hint::black_box(benchmark::run(std::hint::black_box(job), repetitions)?);
    Ok(start.elapsed())
}
