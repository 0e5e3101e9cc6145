//! Functions of Omega and k0 that vanish where multipliers of the linear problem reach the unit circle.
//!
//! With M's characteristic polynomial chi(lambda) = lambda^n + c_1 lambda^(n-1) + ... + c_n (n = 4 or 6):
//!
//! - a multiplier -1: chi(-1) = 0; a multiplier +1: chi(1) = 0;
//! - a pair on the circle: lambda^2 + p lambda + 1 divides chi. The division leaves two polynomials in p that must vanish
//!   together: their resultant.
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

/// One of the functions, by what happens where it vanishes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EdgeFunction {
    /// What happens where it vanishes.
    pub kind: EdgeKind,
}

impl EdgeFunction {
    /// For pairs: Neimark-Sacker, or without damping Krein.
    pub fn pair(linear: &LinearFloquet) -> Self {
        Self { kind: if linear.undamped() { EdgeKind::Krein } else { EdgeKind::NeimarkSacker } }
    }

    /// Its value.
    ///
    /// # Errors
    /// As [`LinearFloquet::characteristic`].
    pub fn value(self, linear: &LinearFloquet, omega: f64, k0: f64) -> Result<f64, NumericsError> {
        Ok(self.of(&linear.characteristic(omega, k0)?))
    }

    /// Its value for a characteristic polynomial.
    pub fn of(self, polynomial: &Characteristic) -> f64 {
        match self.kind {
            EdgeKind::PeriodDoubling => polynomial.value(-1.0),
            EdgeKind::PlusOne => polynomial.value(1.0),
            EdgeKind::NeimarkSacker | EdgeKind::Krein => {
                let c = &polynomial.coefficients;
                if polynomial.degree == 4 { self.of_two(c) } else { self.of_three(c) }
            }
        }
    }

    fn of_two(self, c: &[f64; 6]) -> f64 {
        let p = if self.kind == EdgeKind::Krein { 0.5 * c[0] } else { (c[2] - c[0]) / (c[3] - 1.0) };
        -(p * (p - c[0]) + c[1] - 1.0 - c[3])
    }

    fn of_three(self, c: &[f64; 6]) -> f64 {
        // The quadratic that p solves: for a collision, the derivative of r.
        let (a, b, last) = if self.kind == EdgeKind::Krein {
            (3.0, -2.0 * c[0], c[1] - 2.0 - c[5])
        } else {
            (1.0 - c[5], c[4] - c[0], c[1] - 1.0 + c[5] - c[3])
        };
        let (sum, product) = (-b / a, last / a);
        // r modulo the quadratic, e p + f: with p^2 = sum p - product. Its product over both roots is the resultant,
        // smooth where the roots meet.
        let (square, linear, constant) = (-c[0], c[1] - 2.0 - c[5], c[0] + c[4] - c[2]);
        let e = sum * sum - product + square * sum + linear;
        let f = -sum * product - square * product + constant;
        -(e * (e * product + f * sum) + f * f)
    }
}
