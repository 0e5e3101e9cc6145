//! Initial-value problems: Taylor series, a Runge-Kutta pair as second opinion, events on their dense output.

pub mod dense;
mod dop853_coefficients;
pub mod event;
pub mod runge_kutta;
pub mod taylor;

/// A first-order system x' = f(t, x) of N equations.
pub trait Field<const N: usize> {
    /// The derivative at time `t` and state `state`.
    fn derivative(&self, time: f64, state: &[f64; N]) -> [f64; N];
}
