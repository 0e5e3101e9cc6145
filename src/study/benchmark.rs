//! Jobs whose speed is measured, each beside a plain baseline in the same run that reaches the same error;
//! `docs/benchmarks.md` holds the figures.
//!
//! The baseline is the classical Runge-Kutta method, scalar and with a fixed step, which is what one writes first. Where
//! its job would take seconds it does an even part of it, which its name tells.

use super::basin::{BasinOptions, basin};
use super::branch::{BranchOptions, branch};
use super::chart_work::ChartWork;
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
    /// The most it may take in a single worker in wasm in Chromium, warm, in microseconds; none for a baseline.
    pub ceiling: Option<f64>,
    run: fn(&Parameters) -> Result<f64, StudyError>,
}

const fn ours(name: &'static str, ceiling: f64, run: fn(&Parameters) -> Result<f64, StudyError>) -> Job {
    Job { name, ceiling: Some(ceiling), run }
}

const fn baseline(name: &'static str, run: fn(&Parameters) -> Result<f64, StudyError>) -> Job {
    Job { name, ceiling: None, run }
}

/// The jobs. Each of ours is followed by its baseline, if it has one: its name begins with "plain RK4", and where it ends
/// with "N of M" it does that part.
pub const JOBS: [Job; 20] = [
    Job { name: "monodromy to 1e-10", ceiling: None, run: |p| Ok(linear_monodromy(p, 1e-10, 1.0)?[0][0]) },
    baseline("plain RK4: monodromy to 1e-10", |p| plain_monodromy(p, 1.0 / FINE)),
    ours("100 periods to 1e-10", 500.0, hundred_periods),
    baseline(
        "plain RK4: 100 periods to 1e-10, 5 of 100",
        |p| Ok(plain_motion(p, ORBIT, 5.0, 1.0 / FINE)?[0]),
    ),
    ours("stability chart 200 x 200 to 1e-6", 6e3, chart),
    baseline("plain RK4: stability chart to 1e-6, 100 of 40000 points", plain_chart),
    ours("branch of 200 points with multipliers to 1e-8", 8e3, |p| Ok(branch_of_200(p)?.0)),
    baseline("plain RK4: one Newton step a point to 1e-8, 4 of 200 points", plain_branch),
    ours("boundary of tongue 2, 90 points to 1e-9", 2e3, |p| boundary(p, Tongue::Primary2, 90)),
    baseline("plain RK4: two monodromies a point to 1e-9, 5 of 90 points", |p| plain_boundary(p, 5)),
    ours("boundary of the combination tongue, 80 points to 1e-9", 2e3, |p| {
        boundary(p, Tongue::Combination, 80)
    }),
    baseline("plain RK4: two monodromies a point to 1e-9, 4 of 80 points", |p| plain_boundary(p, 4)),
    ours("invariant circle, converged", 60e3, |p| Ok(torus(&at(p, 3.7), 1e-8)?.mean_radius)),
    baseline("plain RK4: the map and its derivative at each node once, 2 of 65 points", plain_circle),
    ours("automatic diagram of figure 10, exact, Omega 1 to 6", 500e3, whole_diagram),
    ours("chart about the response to a load, 100 x 100 to 1e-6", 1e6, loaded_chart),
    baseline("plain RK4: one Newton step a point to 1e-6, 25 of 10000 points", plain_loaded_chart),
    ours("basins of figure 11 c, 256 x 256 starts, one of two shares", 8e6, |p| basins(p, 256, (0, 2))),
    ours("basins of figure 11 c, a first picture of 64 x 64 starts, one of two shares", 500e3, |p| {
        basins(p, 64, (0, 2))
    }),
    baseline("plain RK4: starts carried over 100 periods to 1e-6, 4 of 2048 points", plain_basins),
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

fn basins(p: &Parameters, count: usize, share: (usize, usize)) -> Result<f64, StudyError> {
    let grid = Grid { low: -4.0, high: 4.0, count };
    let found = basin(p, &BasinOptions { share, ..BasinOptions::new(p, grid, grid) })?;
    Ok(found.attractor.iter().map(|index| f64::from(*index)).sum())
}

/// The same pair under a load in permanent contact.
fn loaded(p: &Parameters) -> Parameters {
    Parameters { regime: Regime::Contact, load: 2.0, ..*p }
}

fn loaded_chart(p: &Parameters) -> Result<f64, StudyError> {
    let grid = |low, high| Grid { low, high, count: 100 };
    let mut work = ChartWork::new(&loaded(p), grid(0.4, 7.0), grid(0.0, 1.0), 1e-6, None)?;
    while !work.advance()? {}
    Ok(work.chart().spectral_radius.iter().filter(|radius| radius.is_finite()).sum())
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

/// A motion and its six variations, as differences: what one step of Newton's method needs.
fn plain_variations(p: &Parameters, start: [f64; 6], periods: f64, step: f64) -> Result<f64, StudyError> {
    let mut sum = plain_motion(p, start, periods, step)?[0];
    for column in 0..6 {
        let mut start = start;
        start[column] += 1e-6;
        sum += plain_motion(p, start, periods, step)?[column];
    }
    Ok(sum)
}

fn plain_branch(p: &Parameters) -> Result<f64, StudyError> {
    let points = (0..4).map(|point| at(p, 1.64 + 0.005 * f64::from(point)));
    points.map(|p| plain_variations(&p, ORBIT, 2.0, 1.0 / MEDIUM)).sum()
}

/// Only what Newton's method on the collocated circle needs in one of its steps.
fn plain_circle(p: &Parameters) -> Result<f64, StudyError> {
    let p = at(p, 3.7);
    let points = (0..2).map(|point| ORBIT.map(|coordinate| 0.1 * coordinate * f64::from(point + 1)));
    points.map(|start| plain_variations(&p, start, 1.0, 1.0 / MEDIUM)).sum()
}

fn plain_loaded_chart(p: &Parameters) -> Result<f64, StudyError> {
    let mut sum = 0.0;
    for row in 0..5 {
        for column in 0..5 {
            let omega = 1.06 + 1.32 * f64::from(column);
            let p = Parameters { k0: (f64::from(row) + 0.5) / 5.0, ..at(&loaded(p), omega) };
            sum += plain_variations(&p, [-0.4, 0.4, 2.8, 0.0, 0.0, 0.0], 1.0, 1.0 / COARSE)?;
        }
    }
    Ok(sum)
}

/// Most starts need some 100 periods until it is certain where they go.
fn plain_basins(p: &Parameters) -> Result<f64, StudyError> {
    let mut sum = 0.0;
    for point in 0..4 {
        let place = 0.3 * f64::from(point + 1);
        sum += plain_motion(p, [place, -place, 0.0, 0.0, 0.0, 0.0], 100.0, 1.0 / COARSE)?[0];
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
