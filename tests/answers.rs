//! The answers: numerics, studies, theory and figures against references, properties and each other, as one program, for to link thirty
//! took longer than to run them. One of its rooms alone: `cargo test --test answers branches::`.

mod attractors;
mod basins;
mod bounded_work;
mod branches;
mod common;
mod contact;
mod continuation;
mod equations;
mod events;
mod exact_beside;
mod figures;
mod generated;
mod harmonic_balance;
mod lanes;
mod loaded_chart;
mod lyapunov;
mod multiple_shooting;
mod piecewise;
mod properties;
mod references;
mod roots;
mod runge_kutta;
mod second_opinion;
mod stability_chart;
mod theory;
mod theory_against_floquet;
mod theory_branches;
mod theory_support;
mod tongues;
mod torus_branch;
mod trajectories;
