//! Questions asked of the model, answered in plain columns.

pub mod basin;
pub mod benchmark;
pub mod branch;
mod chart_column;
pub mod chart_work;
pub mod contact;
pub mod diagram;
pub mod edge_function;
pub mod family;
mod gap;
pub mod grid;
pub mod linear_floquet;
pub mod load_path;
pub mod lyapunov;
pub mod motion;
pub mod multipliers;
pub mod orbit;
pub mod poincare;
pub mod settling;
mod slices;
pub mod spectrum;
pub mod stability_chart;
pub mod sweep;
pub mod time_response;
pub mod tongue;
pub mod tongue_boundary;
pub mod torus;

/// What is known of the error of an answer; each as it applies.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ErrorEstimate {
    /// Relative distance from Liouville's identity.
    pub liouville: Option<f64>,
    /// Change of the answer when every step is halved.
    pub step: Option<f64>,
    /// Residual of the equation that was solved.
    pub residual: Option<f64>,
}

impl ErrorEstimate {
    /// The greater of each of two.
    #[must_use]
    pub fn worse(self, other: Self) -> Self {
        let greater = |one: Option<f64>, other: Option<f64>| one.into_iter().chain(other).reduce(f64::max);
        Self {
            liouville: greater(self.liouville, other.liouville),
            step: greater(self.step, other.step),
            residual: greater(self.residual, other.residual),
        }
    }
}
