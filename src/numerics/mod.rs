//! Algorithms that know no gears: integrators, roots, Floquet theory, periodic orbits.

pub mod birkhoff;
pub mod characteristic;
pub mod chebyshev;
pub mod continuation;
pub mod contraction;
pub mod elimination;
pub mod floquet;
pub mod lyapunov;
pub mod multiple_shooting;
pub mod newton;
pub mod ode;
pub mod parametric;
pub mod periodic;
pub mod roots;
pub mod spectrum;
pub mod torus;
