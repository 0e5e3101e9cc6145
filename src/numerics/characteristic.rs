//! Characteristic polynomials of real matrices of four or six rows, and their factors: real quadratics, refined by
//! Newton's method from those of a neighbour.

use nalgebra::{Complex, SMatrix};

use super::floquet::{self, Spectrum};
use crate::error::NumericsError;

/// A monic polynomial of degree 4 or 6: lambda^n + c_1 lambda^(n-1) + ... + c_n.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Characteristic {
    /// 4 or 6.
    pub degree: usize,
    /// c_1 to c_n; zeros beyond.
    pub coefficients: [f64; 6],
}

impl Characteristic {
    /// Of a matrix by rows whose determinant is known: by Newton's identities from the traces of its powers.
    pub fn of<const L: usize>(matrix: &[[f64; L]; L], determinant: f64) -> Self {
        let mut powers = [*matrix; 3];
        for power in 1..L / 2 {
            let before = powers[power - 1];
            let next = &mut powers[power];
            *next = [[0.0; L]; L];
            for row in 0..L {
                for inner in 0..L {
                    for lane in 0..L {
                        next[row][lane] += before[row][inner] * matrix[inner][lane];
                    }
                }
            }
        }
        let trace_of = |left: &[[f64; L]; L], right: &[[f64; L]; L]| -> f64 {
            let mut sum = 0.0;
            for row in 0..L {
                for column in 0..L {
                    sum += left[row][column] * right[column][row];
                }
            }
            sum
        };
        let mut traces = [0.0; 6];
        traces[0] = (0..L).map(|i| matrix[i][i]).sum();
        for power in 1..L - 1 {
            let exponent = power + 1;
            traces[power] = trace_of(&powers[exponent.div_ceil(2) - 1], &powers[exponent / 2 - 1]);
        }
        let mut coefficients = [0.0; 6];
        for k in 0..L - 1 {
            let mut sum = traces[k];
            for i in 0..k {
                sum += coefficients[i] * traces[k - 1 - i];
            }
            coefficients[k] = -sum / (k + 1) as f64;
        }
        coefficients[L - 1] = determinant;
        Self { degree: L, coefficients }
    }

    /// The same polynomial made reciprocal: what that of an undamped system is but for rounding.
    #[must_use]
    pub fn reciprocal(mut self) -> Self {
        let n = self.degree;
        for k in 0..n / 2 - 1 {
            let mean = 0.5 * (self.coefficients[k] + self.coefficients[n - 2 - k]);
            self.coefficients[k] = mean;
            self.coefficients[n - 2 - k] = mean;
        }
        self.coefficients[n - 1] = 1.0;
        self
    }

    /// Its value at a real argument.
    pub fn value(&self, at: f64) -> f64 {
        self.coefficients[..self.degree].iter().fold(1.0, |sum, coefficient| sum * at + coefficient)
    }

    /// The greatest root of its `factors` and the slope there, from the polynomial itself.
    pub fn top(&self, factors: &Factors) -> Top {
        let index = factors.top();
        let (half, q) = (-0.5 * factors.p[index], factors.q[index]);
        let square = half * half - q;
        let root = if square < 0.0 {
            Complex::new(half, (-square).sqrt())
        } else {
            Complex::new(half + square.sqrt().copysign(half), 0.0)
        };
        let (mut value, mut slope) = (Complex::new(1.0, 0.0), Complex::new(0.0, 0.0));
        for coefficient in &self.coefficients[..self.degree] {
            slope = slope * root + value;
            value = value * root + *coefficient;
        }
        Top { radius: factors.radius(), slope_square: slope.norm_sqr() }
    }

    /// Its roots, as eigenvalues of the companion matrix; of a polynomial of degree 4 two further zeros.
    ///
    /// # Errors
    /// As [`floquet::spectrum`].
    pub fn roots(&self) -> Result<Spectrum, NumericsError> {
        let mut companion = SMatrix::<f64, 6, 6>::zeros();
        for column in 0..self.degree {
            companion[(0, column)] = -self.coefficients[column];
            if column + 1 < self.degree {
                companion[(column + 1, column)] = 1.0;
            }
        }
        floquet::spectrum(&companion)
    }
}

/// A product of real quadratics lambda^2 + p lambda + q: two or three.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Factors {
    /// Number of quadratics.
    pub count: usize,
    /// Their p.
    pub p: [f64; 3],
    /// Their q.
    pub q: [f64; 3],
}

/// The greatest root of a polynomial.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Top {
    /// Its modulus.
    pub radius: f64,
    /// Square of the polynomial's derivative there; the least of it where several roots are as great.
    pub slope_square: f64,
}

/// Roots whose square is less than the greatest by no more than this part count as being as great.
const AS_GREAT: f64 = 1e-3;

impl Top {
    /// From quadratic factors and the resultant of each with the product of the others.
    fn of<const N: usize>(p: &[f64; N], q: &[f64; N], resultants: &[f64; N]) -> Self {
        let discriminants: [f64; N] = std::array::from_fn(|i| p[i] * p[i] - 4.0 * q[i]);
        let mut squares = *q;
        for i in 0..N {
            if discriminants[i] > 0.0 {
                squares[i] = 0.25 * (p[i].abs() + discriminants[i].sqrt()).powi(2);
            }
        }
        let greatest = squares.iter().fold(0.0_f64, |most, value| most.max(*value));
        let mut slope_square = f64::INFINITY;
        for i in 0..N {
            if squares[i] < (1.0 - AS_GREAT) * greatest {
                continue;
            }
            // The distance from the other root of the factor, then from the roots of the others: of a pair the
            // resultant is the product of both conjugates' distances.
            let mut slope = discriminants[i].abs();
            if discriminants[i] > 0.0 {
                let root = -squares[i].sqrt().copysign(p[i]);
                for j in (0..N).filter(|j| *j != i) {
                    slope *= (root * (root + p[j]) + q[j]).powi(2);
                }
            } else {
                slope *= resultants[i].abs();
            }
            slope_square = slope_square.min(slope);
        }
        Self { radius: greatest.sqrt(), slope_square }
    }
}

/// Newton's iterations granted; where they do not suffice the roots are found anew.
const ITERATIONS: usize = 12;
/// By how much less than the square root of the accuracy the last change must be.
const CAUTION: f64 = 0.1;
/// Error of the factors, relative to 1 + their size, that is rounding.
pub const ROUNDING: f64 = 1e-15;

impl Factors {
    /// The factors with all roots greater by `shift`.
    #[must_use]
    pub fn shifted(&self, shift: f64) -> Self {
        let mut after = *self;
        for i in 0..self.count {
            after.p[i] = self.p[i] - 2.0 * shift;
            after.q[i] = self.q[i] - shift * self.p[i] + shift * shift;
        }
        after
    }

    /// The greatest real part of a root.
    pub fn abscissa(&self) -> f64 {
        (0..self.count).fold(f64::NEG_INFINITY, |most, i| {
            let (half, square) = (0.5 * self.p[i], 0.25 * self.p[i] * self.p[i] - self.q[i]);
            // The slower of two real rates, without the difference of nearly equal numbers.
            let root = square.max(0.0).sqrt();
            most.max(if square > 0.0 && half > 0.0 { -self.q[i] / (half + root) } else { root - half })
        })
    }

    /// The factors with the roots exp(lambda T) where the lambda are the roots of these.
    #[must_use]
    pub fn propagated(&self, period: f64) -> Self {
        let mut after = *self;
        for i in 0..self.count {
            let (half, square) = (0.5 * self.p[i], 0.25 * self.p[i] * self.p[i] - self.q[i]);
            after.q[i] = (-2.0 * half * period).exp();
            after.p[i] = if square < 0.0 {
                -2.0 * (-half * period).exp() * ((-square).sqrt() * period).cos()
            } else {
                let root = square.sqrt();
                -((root - half) * period).exp() - ((-root - half) * period).exp()
            };
        }
        after
    }

    /// From all the roots of a polynomial.
    ///
    /// # Errors
    /// As [`Characteristic::roots`].
    pub fn find(of: &Characteristic) -> Result<Self, NumericsError> {
        let spectrum = of.roots()?;
        let mut factors = Self { count: of.degree / 2, p: [0.0; 3], q: [0.0; 3] };
        // Largest first; of a pair the conjugates are neighbours, real roots are taken two by two.
        let mut filled = 0;
        let mut waiting: Option<f64> = None;
        for index in 0..6 {
            let (re, im) = (spectrum.re[index], spectrum.im[index]);
            if filled == factors.count || im < 0.0 {
                continue;
            }
            if im > 0.0 {
                (factors.p[filled], factors.q[filled]) = (-2.0 * re, re * re + im * im);
                filled += 1;
            } else if let Some(other) = waiting.take() {
                (factors.p[filled], factors.q[filled]) = (-(re + other), re * other);
                filled += 1;
            } else {
                waiting = Some(re);
            }
        }
        Ok(factors)
    }

    /// Newton's method for the factors of `of`, started from these, until the error left is about `accuracy`: the square of
    /// the last change over the factors' distance. Answers the greatest root and how it is conditioned; `None` where the
    /// iteration does not settle, and these factors are then of no use.
    ///
    /// Each correction is the remainder of the polynomial by a factor, divided by the product of the others modulo
    /// that factor: Newton's method for the coefficients of the product (the form of Durand and Kerner's iteration for
    /// quadratic factors).
    pub fn refine(&mut self, of: &Characteristic, accuracy: f64) -> Option<Top> {
        if self.count == 2 { self.refine_by::<2>(of, accuracy) } else { self.refine_by::<3>(of, accuracy) }
    }

    fn refine_by<const N: usize>(&mut self, of: &Characteristic, accuracy: f64) -> Option<Top> {
        let c = &of.coefficients;
        let mut p: [f64; N] = std::array::from_fn(|i| self.p[i]);
        let mut q: [f64; N] = std::array::from_fn(|i| self.q[i]);
        let mut resultants = [0.0; N];
        for _ in 0..ITERATIONS {
            let mut change = 0.0_f64;
            let (p_before, q_before) = (p, q);
            for i in 0..N {
                let (p_i, q_i) = (p_before[i], q_before[i]);
                // Synthetic division by the factor: the remainder is b (lambda + p) + b_next.
                let (mut before, mut now) = (1.0, c[0] - p_i);
                for k in 1..2 * N - 1 {
                    (before, now) = (now, c[k] - p_i * now - q_i * before);
                }
                let last = c[2 * N - 1] - p_i * now - q_i * before;
                let (r_1, r_0) = (now, last + p_i * now);
                // The product of the others modulo this factor, h lambda + g.
                let (mut h, mut g) = (0.0, 1.0);
                for j in 0..N {
                    if j != i {
                        let (h_j, g_j) = (p_before[j] - p_i, q_before[j] - q_i);
                        let square = h * h_j;
                        (h, g) = (h * g_j + g * h_j - p_i * square, g * g_j - q_i * square);
                    }
                }
                let g_minus = g - h * p_i;
                let resultant = g * g_minus + h * h * q_i;
                let inverse = 1.0 / resultant;
                let (delta, epsilon) =
                    ((r_1 * g - h * r_0) * inverse, (g_minus * r_0 + h * q_i * r_1) * inverse);
                resultants[i] = resultant;
                p[i] = p_i + delta;
                q[i] = q_i + epsilon;
                change = change.max((delta.abs() + epsilon.abs()) / (1.0 + p_i.abs() + q_i.abs()));
            }
            if change.is_nan() || change > 1e3 {
                return None;
            }
            let nearest = resultants.iter().fold(1.0_f64, |least, value| least.min(value.abs()));
            if change * change <= CAUTION * accuracy * nearest * nearest {
                self.p[..N].copy_from_slice(&p);
                self.q[..N].copy_from_slice(&q);
                return Some(Top::of(&p, &q, &resultants));
            }
        }
        None
    }

    /// Square of the modulus of the greatest root of one quadratic.
    fn square_of(&self, index: usize) -> f64 {
        let (half, q) = (0.5 * self.p[index], self.q[index]);
        let square = half * half - q;
        if square < 0.0 { q } else { (half.abs() + square.sqrt()).powi(2) }
    }

    /// Index of the quadratic that has the greatest root.
    pub fn top(&self) -> usize {
        (1..self.count).fold(0, |best, i| if self.square_of(i) > self.square_of(best) { i } else { best })
    }

    /// Modulus of the greatest root.
    pub fn radius(&self) -> f64 {
        (0..self.count).fold(0.0_f64, |most, i| most.max(self.square_of(i))).sqrt()
    }

    /// Where three neighbours in even steps, the nearest first, lead to.
    #[must_use]
    pub fn extrapolated(&self, second: &Self, third: &Self) -> Self {
        let mut next = *self;
        for i in 0..self.count {
            next.p[i] = 3.0 * (self.p[i] - second.p[i]) + third.p[i];
            next.q[i] = 3.0 * (self.q[i] - second.q[i]) + third.q[i];
        }
        next
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const KNOWN: Factors = Factors { count: 3, p: [-1.9, 0.4, 2.3], q: [1.1, 0.7, 1.2] };

    fn product(of: &Factors) -> Characteristic {
        let mut powers = vec![1.0];
        for i in 0..of.count {
            let mut next = vec![0.0; powers.len() + 2];
            for (k, value) in powers.iter().enumerate() {
                next[k] += value;
                next[k + 1] += of.p[i] * value;
                next[k + 2] += of.q[i] * value;
            }
            powers = next;
        }
        let mut coefficients = [0.0; 6];
        coefficients[..2 * of.count].copy_from_slice(&powers[1..]);
        Characteristic { degree: 2 * of.count, coefficients }
    }

    #[test]
    fn the_polynomial_of_a_matrix_is_that_of_its_blocks() {
        // Companion blocks of the factors, mixed by a matrix of ones above the diagonal and its inverse.
        let mut blocks = SMatrix::<f64, 6, 6>::zeros();
        for i in 0..3 {
            blocks[(2 * i, 2 * i)] = -KNOWN.p[i];
            blocks[(2 * i, 2 * i + 1)] = -KNOWN.q[i];
            blocks[(2 * i + 1, 2 * i)] = 1.0;
        }
        let mixer = SMatrix::<f64, 6, 6>::from_fn(|i, j| f64::from(u8::from(j >= i)));
        let mixed = mixer * blocks * mixer.try_inverse().expect("triangular");
        let rows: [[f64; 6]; 6] = std::array::from_fn(|i| std::array::from_fn(|j| mixed[(i, j)]));
        let found = Characteristic::of(&rows, KNOWN.q.iter().product());
        for (value, exact) in found.coefficients.iter().zip(&product(&KNOWN).coefficients) {
            assert!((value - exact).abs() < 1e-12, "{found:?}");
        }
        let roots = found.roots().expect("converges");
        for (re, im) in roots.re.iter().zip(&roots.im) {
            let of_factor = |i: usize| {
                (re * re - im * im + KNOWN.p[i] * re + KNOWN.q[i]).hypot(2.0 * re * im + KNOWN.p[i] * im)
            };
            assert!((0..3).any(|i| of_factor(i) < 1e-12), "{roots:?}");
        }
    }

    #[test]
    fn factors_are_refined_from_near_and_found_from_nothing() {
        let polynomial = product(&KNOWN);
        let mut near = KNOWN;
        for i in 0..3 {
            near.p[i] += 0.03 * (i as f64 - 1.0);
            near.q[i] -= 0.02;
        }
        let top = near.refine(&polynomial, ROUNDING).expect("settles");
        assert!((top.radius - 1.5).abs() < 1e-13);
        // (lambda + 0.8) times the other factors at -1.5.
        let slope = -0.7 * (2.25 + 1.9 * 1.5 + 1.1) * (2.25 - 0.4 * 1.5 + 0.7);
        assert!((top.slope_square - slope * slope).abs() < 1e-10, "{top:?} {slope}");
        assert!((polynomial.top(&near).slope_square - slope * slope).abs() < 1e-10);
        // The same of a pair.
        let pair = Factors { p: [-0.3, 0.4, 0.5], q: [0.1, 0.7, 0.06], ..KNOWN };
        let (of, mut same) = (product(&pair), pair);
        let refined = same.refine(&of, ROUNDING).expect("settles");
        assert!((refined.slope_square - of.top(&pair).slope_square).abs() < 1e-12, "{refined:?}");
        assert!((refined.radius - 0.7_f64.sqrt()).abs() < 1e-14);
        for i in 0..3 {
            assert!(
                (near.p[i] - KNOWN.p[i]).abs() < 1e-14 && (near.q[i] - KNOWN.q[i]).abs() < 1e-14,
                "{near:?}"
            );
        }
        let found = Factors::find(&polynomial).expect("converges");
        assert!((found.radius() - KNOWN.radius()).abs() < 1e-13, "{found:?}");
        // The factors' roots are real in the third only: (2.3 + sqrt(0.49))/2.
        assert_eq!(KNOWN.top(), 2);
        assert!((KNOWN.radius() - 1.5).abs() < 1e-15);
    }

    #[test]
    fn refinement_gives_up_where_two_factors_are_one() {
        let twice = Factors { count: 3, p: [0.5, 0.5, 2.0], q: [0.9, 0.9, 0.4] };
        let mut guess = twice;
        guess.p[0] += 1e-3;
        assert_eq!(guess.refine(&product(&twice), ROUNDING), None);
    }

    #[test]
    fn exponents_are_carried_to_multipliers_and_parabolas_continued() {
        // Roots -0.1 +- 2 i, and -1 and -3.
        let exponents = Factors { count: 2, p: [0.2, 4.0, 0.0], q: [4.01, 3.0, 0.0] };
        let after = exponents.propagated(0.7);
        let decay = (-0.07_f64).exp();
        assert!((after.p[0] + 2.0 * decay * 1.4_f64.cos()).abs() < 1e-15);
        assert!((after.q[0] - decay * decay).abs() < 1e-15);
        assert!((after.p[1] + (-0.7_f64).exp() + (-2.1_f64).exp()).abs() < 1e-15);
        assert!((after.q[1] - (-2.8_f64).exp()).abs() < 1e-15);
        assert!((exponents.abscissa() + 0.1).abs() < 1e-15);
        let shifted = exponents.shifted(0.1);
        assert!(shifted.p[0].abs() < 1e-15 && (shifted.q[0] - 4.0).abs() < 1e-15, "{shifted:?}");
        assert!(shifted.abscissa().abs() < 1e-15);
        let at = |t: f64| Factors { count: 2, p: [1.0 + t * t, t, 0.0], q: [2.0 - t, 3.0 * t * t, 0.0] };
        let next = at(2.0).extrapolated(&at(1.0), &at(0.0));
        assert_eq!(next, at(3.0));
    }

    #[test]
    fn reciprocal_polynomials_stay_what_they_are() {
        let circle = product(&Factors { count: 3, p: [-1.2, 0.3, 1.7], q: [1.0; 3] });
        let same = circle.reciprocal();
        for (left, right) in circle.coefficients.iter().zip(&same.coefficients) {
            assert!((left - right).abs() < 1e-15);
        }
        // The product of 2 - p at -1, and of 2 + p at 1.
        assert!((same.value(-1.0) - 3.2 * 1.7 * 0.3).abs() < 1e-14);
        assert!((same.value(1.0) - 0.8 * 2.3 * 3.7).abs() < 1e-14);
    }
}
