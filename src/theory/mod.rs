//! The paper's formulas, as printed and corrected: one function an equation, its number in its doc.
//!
//! `_printed` in a name means by the letter of the paper where the paper errs or another form computes better; the
//! plain name is what holds. Numbers in round brackets are the paper's; those in square brackets, \[T1\] to \[T8\], are
//! results beyond it, listed in `docs/equations.md`. Nothing here integrates or uses `numerics`, so that comparing the
//! two means something.
//!
//! Scales: `alpha` of [`primary`] and [`combination`] is the paper's (`alpha / k0`), their `omega_1` its `Omega_1`
//! with `Omega = Omega_0 + k0 Omega_1`. [`damped`], [`branches`], [`hill`] and [`tongues`](mod@tongues) take
//! [`Symmetric`](crate::model::parameters::Symmetric) with the model's own `alpha` and `Omega`.

pub mod branches;
pub mod combination;
pub mod damped;
pub mod hill;
pub mod modes;
pub mod primary;
mod roots;
pub mod tongues;

pub use branches::{Cycle, PeriodTwo, cycles, period_two, period_two_guess};
pub use combination::PrintedSolution;
pub use damped::{combination_exponents, primary_exponents};
pub use modes::{Mode, Modes, paper_alpha, paper_omega_1};
/// The complex number of the answers, so that who reads them needs no `nalgebra`.
pub use nalgebra::Complex;
pub use primary::Branch;
pub use tongues::{Edges, Tongue, Tongues, tongues};
