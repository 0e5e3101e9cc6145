//! Jobs whose speed is measured, beside a plain baseline in the same run; `docs/benchmarks.md` holds the figures.

use super::motion;
use super::multipliers::linear_monodromy;
use crate::error::{NumericsError, StudyError};
use crate::model::equations::GearPair;
use crate::model::parameters::{Parameters, Regime};
use crate::numerics::ode::runge_kutta::rk4_fixed;

/// Steps a period of the baseline: a fixed step of the classical Runge-Kutta method.
const PLAIN_STEPS: usize = 200;

/// The jobs by name: each of ours is followed by its baseline.
pub const JOBS: [&str; 4] =
    ["monodromy to 1e-10", "monodromy by plain RK4", "100 periods to 1e-10", "100 periods by plain RK4"];

/// Does a job `repetitions` times; answers a number that depends on all its results, so that none can be left out.
///
/// # Errors
/// [`StudyError::Option`] for a job that does not exist; [`StudyError::Numerics`] where it fails.
pub fn run(job: &str, repetitions: usize) -> Result<f64, StudyError> {
    let p = Parameters {
        omega: 1.65,
        omega_p: 1.65,
        omega_g: 1.65,
        regime: Regime::Homogeneous,
        ..Parameters::default()
    };
    let mut sum = 0.0;
    for index in 0..repetitions {
        let p = Parameters { k0: 0.5 + 1e-9 * index as f64, ..p };
        sum += match job {
            "monodromy to 1e-10" => linear_monodromy(&p, 1e-10, 1.0)?[0][0],
            "monodromy by plain RK4" => plain_monodromy(&p)?,
            "100 periods to 1e-10" => {
                let end = 100.0 * p.mesh_period();
                motion::carry(&GearPair::new(&p), 0.0, ORBIT, end, 1e-10)?.state[0]
            }
            "100 periods by plain RK4" => plain_motion(&p, ORBIT, 100)?[0],
            _ => {
                return Err(StudyError::Option {
                    option: "job",
                    given: job.into(),
                    allowed: JOBS.join(", "),
                });
            }
        };
    }
    Ok(sum)
}

/// A state on the 2T orbit of Fig. 11 c.
const ORBIT: [f64; 6] = [
    1.8492753921814418,
    -1.8492753921814413,
    -0.7618399494429711,
    0.1765796294591582,
    -0.17657962945915498,
    1.359097317974977,
];

fn plain_motion(p: &Parameters, start: [f64; 6], periods: usize) -> Result<[f64; 6], NumericsError> {
    let end = periods as f64 * p.mesh_period();
    rk4_fixed(&GearPair::new(p), 0.0, start, end, periods * PLAIN_STEPS)
}

fn plain_monodromy(p: &Parameters) -> Result<f64, NumericsError> {
    // The linear problem is the motion without its cubic terms, column by column.
    let linear = Parameters { alpha_p: 0.0, alpha_g: 0.0, ..*p };
    (0..6)
        .map(|column| {
            let mut start = [0.0; 6];
            start[column] = 1.0;
            Ok(plain_motion(&linear, start, 1)?[column])
        })
        .sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_job_runs_and_the_pairs_agree() {
        let result = |job: &str| run(job, 1).expect("runs");
        assert!(
            (result(JOBS[2]) - result(JOBS[3])).abs() < 1e-4,
            "the baseline is right to its own accuracy"
        );
        assert!(JOBS.iter().all(|job| result(job).is_finite()));
        assert!(run("nothing", 1).is_err());
    }
}
