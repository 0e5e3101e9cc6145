//! Branches of periodic orbits of a forced system of six coordinates, followed in one parameter.
//!
//! An orbit is a fixed point of a map `Q = g Phi_m`: the state is carried over m periods of the forcing and then
//! put through a symmetry g of the equations (the identity, or one of order two). An orbit with `Phi_m x = g x` is
//! so found from half of its period, its multipliers are the squares of those of Q, and a bifurcation that breaks
//! the symmetry is a period doubling of Q, which no step can miss.
//!
//! The followed states are projected onto the space that their symmetries fix, in which every fold is regular and
//! from which no rounding leads away; the multipliers within that space and across it are told apart.
//!
//! Curves of solutions in two parameters are followed through their folds in [`two_parameter`].
//!
//! Sources: H. B. Keller, Numerical solution of bifurcation and nonlinear eigenvalue problems, in Applications of
//! Bifurcation Theory (Academic Press 1977), pp. 359-384 (pseudo-arclength); Yu. A. Kuznetsov, Elements of Applied
//! Bifurcation Theory, 3rd ed. (Springer 2004), doi 10.1007/978-1-4757-3978-8, sections 10.1, 10.2 (test functions,
//! branch switching). Departure: the predictor extrapolates through several points instead of along the tangent.

pub mod corrector;
pub mod criticality;
pub mod detect;
pub mod predictor;
pub mod step;
pub mod switch;
pub mod symmetry;
pub mod two_parameter;

use crate::error::NumericsError;
use crate::numerics::floquet::Matrix6;

/// A state of the system.
pub type State = [f64; 6];
/// State and parameter, each over its scale: what lengths and angles along a branch are measured in.
pub type Scaled = [f64; 7];

/// Which map an orbit is a fixed point of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Kind {
    /// Periods of the forcing over which the state is carried.
    pub periods: usize,
    /// The symmetry that is then applied, as an index into the [`symmetry::Group`]; 0 is the identity.
    pub symmetry: usize,
}

/// What all the orbits of a branch have in common.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Path {
    /// The map that they are fixed points of.
    pub kind: Kind,
    /// The symmetries that leave their states where they are: bit `1 << index` for each element of the group.
    pub keeping: u8,
}

impl Path {
    /// The periods of the forcing after which the states return.
    pub fn period(&self) -> usize {
        let kept = self.keeping & (1 << self.kind.symmetry) != 0;
        if kept { self.kind.periods } else { 2 * self.kind.periods }
    }
}

/// The map at one state and parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Evaluation {
    /// The image of the state.
    pub image: State,
    /// The image's derivative by the state.
    pub derivative: Matrix6,
    /// The state after half of the periods, before any symmetry; the image where the periods cannot be halved.
    pub half: State,
    /// Two numbers of the orbit that are shown along the branch.
    pub peaks: [f64; 2],
    /// Their derivatives by the state.
    pub gradients: [State; 2],
    /// Number of analytic pieces that the orbit visits: it changes where the orbit grazes the end of one.
    pub pieces: usize,
}

/// A family of maps that depends on a parameter.
pub trait Family {
    /// The map with its derivative.
    ///
    /// # Errors
    /// Where the motion cannot be carried so far.
    fn evaluate(&mut self, kind: Kind, state: &State, parameter: f64) -> Result<Evaluation, NumericsError>;

    /// The image alone.
    ///
    /// # Errors
    /// As [`Family::evaluate`].
    fn image(&mut self, kind: Kind, state: &State, parameter: f64) -> Result<State, NumericsError>;

    /// The symmetries of the equations.
    fn group(&self) -> &symmetry::Group;

    /// Whether orbits of this many periods can be orbits of half as many: no, where the forcing itself is longer.
    fn halves(&self, periods: usize) -> bool {
        periods.is_multiple_of(2)
    }

    /// How far a modulus may be above 1 by rounding: 0 for a damped system, more for one whose multipliers lie on
    /// the unit circle.
    fn slack(&self) -> f64 {
        0.0
    }

    /// Work that is left; at 0 the family refuses.
    fn budget(&self) -> usize {
        usize::MAX
    }
}

/// Units in which a branch is measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    /// A change of a coordinate that counts as one.
    pub state: f64,
    /// A change of the parameter that counts as one.
    pub parameter: f64,
}

impl Scale {
    /// State and parameter over their scales.
    pub fn scaled(&self, state: &State, parameter: f64) -> Scaled {
        let mut scaled = [0.0; 7];
        for (value, coordinate) in scaled.iter_mut().zip(state) {
            *value = coordinate / self.state;
        }
        scaled[6] = parameter / self.parameter;
        scaled
    }

    /// The state and the parameter themselves.
    pub fn plain(&self, scaled: &Scaled) -> (State, f64) {
        (std::array::from_fn(|i| scaled[i] * self.state), scaled[6] * self.parameter)
    }
}

/// The scalar product.
pub fn dot<const N: usize>(left: &[f64; N], right: &[f64; N]) -> f64 {
    left.iter().zip(right).map(|(a, b)| a * b).sum()
}

/// The Euclidean length.
pub fn norm<const N: usize>(vector: &[f64; N]) -> f64 {
    dot(vector, vector).sqrt()
}

/// The difference of two vectors.
pub fn minus<const N: usize>(left: &[f64; N], right: &[f64; N]) -> [f64; N] {
    std::array::from_fn(|i| left[i] - right[i])
}

/// The vector of length 1 in the same direction; the vector itself where it has no length.
pub fn unit<const N: usize>(vector: &[f64; N]) -> [f64; N] {
    let length = norm(vector);
    if length > 0.0 { vector.map(|value| value / length) } else { *vector }
}
