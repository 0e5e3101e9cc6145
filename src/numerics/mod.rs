//! Algorithms that know no gears: integrators, roots, Floquet theory, periodic orbits.

pub mod continuation;
pub mod floquet;
pub mod newton;
pub mod ode;
pub mod periodic;
pub mod roots;
