//! The steady response where it folds back before all of the load acts: followed by pseudo-arclength in the share of
//! the load, through the folds, to where all of it does.

use super::multipliers::{Budget, image, trivial_state};
use crate::error::NumericsError;
use crate::model::equations::GearPair;
use crate::model::parameters::Parameters;
use crate::numerics::continuation::corrector::{self, Frame};
use crate::numerics::continuation::detect::finish;
use crate::numerics::continuation::step::{Bounds, Trace};
use crate::numerics::continuation::symmetry::{Group, Space};
use crate::numerics::continuation::{Evaluation, Family, Kind, Path, Scale, State};
use crate::numerics::periodic::matrix;

/// The parameters under a share of their loads.
pub fn loaded(p: &Parameters, share: f64) -> Parameters {
    Parameters {
        load: share * p.load,
        load_p: share * p.load_p,
        load_g: share * p.load_g,
        error: share * p.error,
        ..*p
    }
}

/// Longest step, over the scales.
const LONGEST: f64 = 0.1;
/// Shares between which the responses are followed: on their way they may pass no load, elsewhere than at rest.
const RANGE: [f64; 2] = [-4.0, 1.0];
/// Most points.
const POINTS: usize = 1500;
/// Length of the last correction of a point, over the scales.
const TOLERANCE: f64 = 1e-7;

/// A gear pair of which the share of the load varies.
struct Loads<'a> {
    parameters: &'a Parameters,
    tolerance: f64,
    budget: &'a Budget,
    group: Group,
}

impl Family for Loads<'_> {
    fn evaluate(&mut self, kind: Kind, state: &State, share: f64) -> Result<Evaluation, NumericsError> {
        let pair = GearPair::new(&loaded(self.parameters, share));
        let (image, rows) = image(&pair, state, kind.periods, self.tolerance, 1.0, self.budget)?;
        Ok(Evaluation {
            image,
            derivative: matrix(&rows),
            half: image,
            peaks: [0.0; 2],
            gradients: [[0.0; 6]; 2],
            pieces: 0,
        })
    }

    fn image(&mut self, kind: Kind, state: &State, share: f64) -> Result<State, NumericsError> {
        Ok(self.evaluate(kind, state, share)?.image)
    }

    fn group(&self) -> &Group {
        &self.group
    }

    fn halves(&self, _: usize) -> bool {
        false
    }

    fn budget(&self) -> usize {
        self.budget.left()
    }
}

/// The orbit of this many periods under all of the load that the trivial state under none leads to; a place near it.
///
/// # Errors
/// [`NumericsError::NoConvergence`] where the responses are lost on the way: the residual is the share of the load that is
/// missing.
pub fn through_folds(
    p: &Parameters,
    periods: usize,
    tolerance: f64,
    budget: &Budget,
) -> Result<State, NumericsError> {
    let mut family = Loads { parameters: p, tolerance, budget, group: Group::new(None, None) };
    let size = |k: f64, alpha: f64| (k / alpha.abs()).sqrt();
    let state = size(p.k_p, p.alpha_p).min(size(p.k_g, p.alpha_g)).clamp(0.1, 5.0);
    let scale = Scale { state, parameter: 1.0 };
    let path = Path { kind: Kind { periods, symmetry: 0 }, keeping: 1 };
    let space = Space::new(&family.group, path.keeping);
    let frame = Frame { kind: path.kind, space: &space, scale, tolerance: TOLERANCE };
    let mut normal = [0.0; 7];
    normal[6] = 1.0;
    let place = scale.scaled(&trivial_state(p), 0.0);
    let mut corrected = corrector::correct(&mut family, &frame, &place, &normal, None)?;
    corrected.tangent = corrector::tangent(&mut family, &frame, &corrected.at, &corrected.evaluation)?;
    let slack = family.slack();
    let start = finish(corrected, 0.0, &space, slack)?;
    let bounds = Bounds { range: RANGE, scale, longest: LONGEST, points: POINTS, tolerance: TOLERANCE };
    let group = family.group;
    let mut trace = Trace::new(path, &group, start, bounds, 0.2 * LONGEST);
    trace.run(&mut family);
    let last = trace.points.last().map_or(place, |point| point.at);
    let (state, share) = scale.plain(&last);
    if share == 1.0 {
        return Ok(state);
    }
    if budget.left() == 0 {
        return Err(NumericsError::TooManySteps { time: 0.0, steps: 0 });
    }
    Err(NumericsError::NoConvergence {
        iterations: trace.points.len(),
        residual: 1.0 - share,
        tolerance: TOLERANCE,
    })
}
