//! Jobs whose speed is measured, each beside a plain baseline in the same run that reaches the same error;
//! `docs/benchmarks.md` holds the figures.
//!
//! The baseline is the classical Runge-Kutta method, scalar and with a fixed step, which is what one writes first. Where
//! its job would take seconds it does an even part of it, which its name tells.

use super::basin::{BasinOptions, basin};
use super::branch::{BranchOptions, branch};
use super::diagram::{DiagramOptions, diagram};
use super::grid::Grid;
use super::motion;
use super::multipliers::linear_monodromy;
use super::stability_chart::stability_chart;
use super::tongue::Tongue;
use super::tongue_boundary::tongue_boundary;
use super::torus::torus;
use crate::error::{NumericsError, StudyError};
use crate::model::equations::GearPair;
use crate::model::parameters::{Parameters, Regime};
use crate::numerics::ode::runge_kutta::rk4_fixed;

/// A job and its name.
pub struct Job {
    /// What is done, and how well.
    pub name: &'static str,
    run: fn(&Parameters) -> Result<f64, StudyError>,
}

/// The jobs. Each of ours is followed by its baseline, if it has one: its name begins with "plain RK4", and where it ends
/// with "N of M" it does that part.
pub const JOBS: [Job; 15] = [
    Job { name: "monodromy to 1e-10", run: |p| Ok(linear_monodromy(p, 1e-10, 1.0)?[0][0]) },
    Job { name: "plain RK4: monodromy to 1e-10", run: |p| plain_monodromy(p, 1.0 / FINE) },
    Job { name: "100 periods to 1e-10", run: hundred_periods },
    Job {
        name: "plain RK4: 100 periods to 1e-10, 5 of 100",
        run: |p| Ok(plain_motion(p, ORBIT, 5.0, 1.0 / FINE)?[0]),
    },
    Job { name: "stability chart 200 x 200 to 1e-6", run: chart },
    Job { name: "plain RK4: stability chart to 1e-6, 100 of 40000 points", run: plain_chart },
    Job { name: "branch of 200 points with multipliers to 1e-8", run: |p| Ok(branch_of_200(p)?.0) },
    Job { name: "plain RK4: one Newton step a point to 1e-8, 4 of 200 points", run: plain_branch },
    Job { name: "boundary of tongue 2, 90 points to 1e-9", run: |p| boundary(p, Tongue::Primary2, 90) },
    Job { name: "plain RK4: two monodromies a point to 1e-9, 5 of 90 points", run: |p| plain_boundary(p, 5) },
    Job {
        name: "boundary of the combination tongue, 80 points to 1e-9",
        run: |p| boundary(p, Tongue::Combination, 80),
    },
    Job { name: "plain RK4: two monodromies a point to 1e-9, 4 of 80 points", run: |p| plain_boundary(p, 4) },
    Job { name: "invariant circle, converged", run: |p| Ok(torus(&at(p, 3.7), 1e-8)?.mean_radius) },
    Job { name: "automatic diagram of figure 10", run: whole_diagram },
    Job { name: "basins of figure 11 c, 64 x 64 starts", run: basins },
];

/// Does a job `repetitions` times; answers a number that depends on all its results, so that none can be left out.
///
/// # Errors
/// [`StudyError::Option`] for a job that does not exist; [`StudyError::Numerics`] where it fails.
pub fn run(job: &str, repetitions: usize) -> Result<f64, StudyError> {
    let found = JOBS.iter().find(|known| known.name == job).ok_or_else(|| StudyError::Option {
        option: "job",
        given: job.into(),
        allowed: JOBS.map(|job| job.name).join(", "),
    })?;
    let p = at(&Parameters { regime: Regime::Homogeneous, ..Parameters::default() }, 1.65);
    let mut sum = 0.0;
    for index in 0..repetitions {
        sum += (found.run)(&Parameters { k0: 0.5 + 1e-9 * index as f64, ..p })?;
    }
    Ok(sum)
}

fn at(p: &Parameters, omega: f64) -> Parameters {
    Parameters { omega, omega_p: omega, omega_g: omega, ..*p }
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

/// Steps a unit of time by which the baseline reaches 1e-10, and 1e-8, and 1e-6.
const FINE: f64 = 1200.0;
const MEDIUM: f64 = 400.0;
const COARSE: f64 = 75.0;

fn hundred_periods(p: &Parameters) -> Result<f64, StudyError> {
    let end = 100.0 * p.mesh_period();
    Ok(motion::carry(&GearPair::new(p), 0.0, ORBIT, end, 1e-10)?.state[0])
}

fn chart(p: &Parameters) -> Result<f64, StudyError> {
    let grid = |low, high| Grid { low, high, count: 200 };
    let chart = stability_chart(p, grid(0.4, 7.0), grid(0.0, 1.0), 1e-6)?;
    Ok(chart.spectral_radius.iter().sum())
}

/// A branch of about 200 points: tongue 2, from its right edge over the fold.
fn branch_of_200(p: &Parameters) -> Result<(f64, usize), StudyError> {
    let options = BranchOptions { points: 190, tolerance: 1e-8, ..BranchOptions::new([1.27, 1.8], 2) };
    let branch = branch(p, &options)?;
    Ok((branch.max_u_p.iter().chain(branch.re.iter().flatten()).sum(), branch.value.len()))
}

fn boundary(p: &Parameters, tongue: Tongue, points: usize) -> Result<f64, StudyError> {
    Ok(tongue_boundary(p, tongue, [0.0, 0.5], points, 1e-9)?.omega.iter().sum())
}

fn whole_diagram(p: &Parameters) -> Result<f64, StudyError> {
    let diagram = diagram(p, &DiagramOptions::new([1.0, 6.0]))?;
    Ok(diagram.branches.iter().flat_map(|branch| &branch.max_u_p).sum())
}

fn basins(p: &Parameters) -> Result<f64, StudyError> {
    let grid = |reach: f64| Grid { low: -reach, high: reach, count: 64 };
    let found = basin(p, &BasinOptions::new(p, grid(4.0), grid(4.0)))?;
    Ok(found.attractor.iter().map(|index| f64::from(*index)).sum())
}

fn plain_motion(p: &Parameters, start: [f64; 6], periods: f64, step: f64) -> Result<[f64; 6], NumericsError> {
    let end = periods * p.mesh_period();
    rk4_fixed(&GearPair::new(p), 0.0, start, end, (end / step).ceil() as usize)
}

/// The linear problem is the motion without its cubic terms, column by column.
fn plain_monodromy(p: &Parameters, step: f64) -> Result<f64, StudyError> {
    let linear = Parameters { alpha_p: 0.0, alpha_g: 0.0, ..*p };
    let mut sum = 0.0;
    for column in 0..6 {
        let mut start = [0.0; 6];
        start[column] = 1.0;
        sum += plain_motion(&linear, start, 1.0, step)?[column];
    }
    Ok(sum)
}

fn plain_chart(p: &Parameters) -> Result<f64, StudyError> {
    let mut sum = 0.0;
    for row in 0..10 {
        for column in 0..10 {
            let p =
                Parameters { k0: (f64::from(row) + 0.5) / 10.0, ..at(p, 0.73 + 0.66 * f64::from(column)) };
            sum += plain_monodromy(&p, 1.0 / COARSE)?;
        }
    }
    Ok(sum)
}

/// The orbit and its six variations over 2T, as differences: what one step of Newton's method needs.
fn plain_branch(p: &Parameters) -> Result<f64, StudyError> {
    let mut sum = 0.0;
    for point in 0..4 {
        let p = at(p, 1.64 + 0.005 * f64::from(point));
        sum += plain_motion(&p, ORBIT, 2.0, 1.0 / MEDIUM)?[0];
        for column in 0..6 {
            let mut start = ORBIT;
            start[column] += 1e-6;
            sum += plain_motion(&p, start, 2.0, 1.0 / MEDIUM)?[column];
        }
    }
    Ok(sum)
}

fn plain_boundary(p: &Parameters, points: usize) -> Result<f64, StudyError> {
    (0..2 * points).map(|index| plain_monodromy(&at(p, 1.6 + 0.01 * index as f64), 1.0 / FINE)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parameters(omega: f64) -> Parameters {
        at(&Parameters { regime: Regime::Homogeneous, ..Parameters::default() }, omega)
    }

    #[test]
    fn the_baselines_reach_the_errors_they_are_set_against() {
        let jobs = [(1.65, FINE, 1e-10), (1.65, MEDIUM, 1e-8), (0.5, COARSE, 1e-6), (6.67, COARSE, 1e-6)];
        for (omega, steps, error) in jobs {
            let linear = Parameters { alpha_p: 0.0, alpha_g: 0.0, k0: 1.0, ..parameters(omega) };
            let mut worst = 0.0_f64;
            for column in 0..6 {
                let mut start = [0.0; 6];
                start[column] = 1.0;
                let end = linear.mesh_period();
                let exact = motion::carry(&GearPair::new(&linear), 0.0, start, end, 1e-13).expect("carries");
                let plain = plain_motion(&linear, start, 1.0, 1.0 / steps).expect("runs");
                for (plain, exact) in plain.into_iter().zip(exact.state) {
                    worst = worst.max((plain - exact).abs());
                }
            }
            // A baseline much finer than needed would be a straw man.
            assert!(worst < error && worst > 0.02 * error, "{omega}, {steps} steps: {worst:e}");
        }
    }

    #[test]
    fn the_branch_has_as_many_points_as_its_name_says() {
        let (_, points) = branch_of_200(&parameters(1.65)).expect("traced");
        assert!((190..=210).contains(&points), "{points}");
    }

    #[test]
    fn quick_jobs_run_and_unknown_ones_do_not() {
        for job in &JOBS[..4] {
            assert!(run(job.name, 1).expect("runs").is_finite());
        }
        assert!(run("nothing", 1).is_err());
    }
}
