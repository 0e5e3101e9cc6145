//! The least load over the mesh frequency.

use super::{LeastLoad, NoLoad, search};
use crate::error::StudyError;
use crate::model::parameters::Parameters;
use crate::study::ErrorEstimate;
use crate::study::grid::Grid;
use crate::study::motion;
use crate::study::multipliers::common_period;
use crate::study::slices::Slices;
use crate::study::sweep::at_frequency;

/// The least load over the mesh frequency.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LeastLoadCurve {
    /// Mesh frequencies done so far.
    pub omega: Vec<f64>,
    /// The least load at each: [`LeastLoad::load`](super::LeastLoad::load).
    pub load: Vec<Option<f64>>,
    /// The same whether the response is stable or not: [`LeastLoad::contact_load`](super::LeastLoad::contact_load).
    pub contact_load: Vec<Option<f64>>,
    /// Why there is none: [`LeastLoad::reason`](super::LeastLoad::reason). A search that took too much work counts as no response.
    pub reason: Vec<Option<NoLoad>>,
    /// How it was computed.
    pub method: String,
    /// What is known of the error: `residual`, the greatest margin at the loads of `contact_load` that are above 0.
    pub error: ErrorEstimate,
}

/// The curve in the making, frequency by frequency.
#[derive(Debug)]
pub struct LeastLoadWork {
    parameters: Parameters,
    omega: Grid,
    tolerance: f64,
    /// The search at the present frequency.
    slices: Option<Slices<Result<LeastLoad, StudyError>>>,
    curve: LeastLoadCurve,
}

impl LeastLoadWork {
    /// Prepares the curve. The loads' frequencies keep their ratio to the mesh frequency.
    ///
    /// # Errors
    /// [`StudyError::Option`] for a tolerance out of range, [`StudyError::Model`] for an incommensurate load.
    pub fn new(p: &Parameters, omega: Grid, tolerance: f64) -> Result<Self, StudyError> {
        motion::check_tolerance(tolerance)?;
        common_period(p)?;
        Ok(Self { parameters: *p, omega, tolerance, slices: None, curve: LeastLoadCurve::default() })
    }

    /// Does a slice of the work; true when all is done.
    ///
    /// # Errors
    /// [`StudyError`] where the question itself is refused; a frequency whose search fails has no load instead.
    pub fn advance(&mut self) -> Result<bool, StudyError> {
        let index = self.curve.omega.len();
        if index >= self.omega.count {
            return Ok(true);
        }
        let omega = self.omega.value(index);
        let p = at_frequency(&self.parameters, omega);
        let slices = self.slices.get_or_insert_with(|| Slices::new(search(p, self.tolerance)));
        let Some(found) = slices.advance() else { return Ok(false) };
        self.slices = None;
        let (load, contact_load, reason) = match found {
            Ok(least) => {
                let most = self.curve.error.residual.unwrap_or(0.0);
                self.curve.error.residual = Some(least.error.residual.unwrap_or(0.0).max(most));
                self.curve.method = least.method;
                (least.load, least.contact_load, least.reason)
            }
            Err(StudyError::Numerics(_)) => (None, None, Some(NoLoad::NoResponse)),
            Err(error) => return Err(error),
        };
        self.curve.omega.push(omega);
        self.curve.load.push(load);
        self.curve.contact_load.push(contact_load);
        self.curve.reason.push(reason);
        Ok(index + 1 >= self.omega.count)
    }

    /// The curve so far.
    pub fn curve(&self) -> &LeastLoadCurve {
        &self.curve
    }
}

/// The least load over the mesh frequency.
///
/// # Errors
/// As [`LeastLoadWork`].
pub fn least_load_curve(p: &Parameters, omega: Grid, tolerance: f64) -> Result<LeastLoadCurve, StudyError> {
    let mut work = LeastLoadWork::new(p, omega, tolerance)?;
    while !work.advance()? {}
    Ok(work.curve)
}
