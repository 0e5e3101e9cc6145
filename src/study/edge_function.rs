//! Functions of Omega and k0 that vanish where multipliers of the linear problem reach the unit circle.
//!
//! With M's characteristic polynomial chi(lambda) = lambda^n + c_1 lambda^(n-1) + ... + c_n (n = 4 or 6):
//!
//! - a multiplier -1: chi(-1) = 0; a multiplier +1: chi(1) = 0;
//! - a pair on the circle: lambda^2 + p lambda + 1 divides chi. The division leaves two polynomials in p that must vanish
//!   together; one is solved for p and put into the other.
//!   n = 4: (c_4 - 1) p = c_3 - c_1 and r(p) = p^2 - c_1 p + c_2 - 1 - c_4.
//!   n = 6: (1 - c_6) p^2 + (c_5 - c_1) p + c_2 - 1 + c_6 - c_4 = 0
//!   and r(p) = p^3 - c_1 p^2 + (c_2 - 2 - c_6) p + c_1 + c_5 - c_3.
//! - two pairs that meet on the circle, undamped (Krein collision): chi is reciprocal, and p a double root of the same r.
//!
//! Each is below zero where the multipliers in question have left the circle, and smooth across.

use super::linear_floquet::LinearFloquet;
use super::tongue::EdgeKind;
use crate::error::NumericsError;
use crate::numerics::characteristic::Characteristic;

/// One of the functions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EdgeFunction {
    /// What happens where it vanishes.
    pub kind: EdgeKind,
    /// For pairs: -2 times the cosine of their angle, from which the root p is told from others. Follows the last
    /// [`EdgeFunction::value`].
    pub pair: f64,
    /// For pairs: 1 or -1, so that the function is above zero before they leave the circle.
    pub sign: f64,
}

impl EdgeFunction {
    /// For real multipliers.
    pub fn real(kind: EdgeKind) -> Self {
        Self { kind, pair: 0.0, sign: 1.0 }
    }

    /// For pairs near the angle with this p = -2 cos(angle).
    pub fn pair(linear: &LinearFloquet, pair: f64) -> Self {
        let kind = if linear.undamped() { EdgeKind::Krein } else { EdgeKind::NeimarkSacker };
        Self { kind, pair, sign: 1.0 }
    }

    /// Its value; `pair` moves to the root found.
    ///
    /// # Errors
    /// As [`LinearFloquet::characteristic`].
    pub fn value(&mut self, linear: &LinearFloquet, omega: f64, k0: f64) -> Result<f64, NumericsError> {
        Ok(self.of(&linear.characteristic(omega, k0)?))
    }

    fn of(&mut self, polynomial: &Characteristic) -> f64 {
        match self.kind {
            EdgeKind::PeriodDoubling => polynomial.value(-1.0),
            EdgeKind::PlusOne => polynomial.value(1.0),
            EdgeKind::NeimarkSacker | EdgeKind::Krein => {
                let c = &polynomial.coefficients;
                if polynomial.degree == 4 { self.of_two(c) } else { self.of_three(c) }
            }
        }
    }

    fn of_two(&mut self, c: &[f64; 6]) -> f64 {
        self.pair = if self.kind == EdgeKind::Krein { 0.5 * c[0] } else { (c[2] - c[0]) / (c[3] - 1.0) };
        -(self.pair * (self.pair - c[0]) + c[1] - 1.0 - c[3])
    }

    fn of_three(&mut self, c: &[f64; 6]) -> f64 {
        // The quadratic that p solves: for a collision, the derivative of r.
        let (a, b, last) = if self.kind == EdgeKind::Krein {
            (3.0, -2.0 * c[0], c[1] - 2.0 - c[5])
        } else {
            (1.0 - c[5], c[4] - c[0], c[1] - 1.0 + c[5] - c[3])
        };
        let (middle, square) = (-0.5 * b / a, 0.25 * b * b / (a * a) - last / a);
        let root = square.max(0.0).sqrt();
        let p = if (middle + root - self.pair).abs() < (middle - root - self.pair).abs() {
            middle + root
        } else {
            middle - root
        };
        self.pair = p;
        let value = ((p - c[0]) * p + c[1] - 2.0 - c[5]) * p + c[0] + c[4] - c[2];
        // The extremum of r between two roots is a maximum or a minimum, by the side on which the third one lies.
        let side = if 6.0 * p > 2.0 * c[0] { -1.0 } else { 1.0 };
        self.sign * side * value
    }
}
