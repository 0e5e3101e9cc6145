//! The exact linear problem as charts and tongues need it: natural frequencies, characteristic polynomials, and the
//! mode that takes no part taken out.
//!
//! Where both supports have the same frequency and the same damping rate (equal supports, for one), one combination of
//! `u_p` and `u_g` moves without compressing the teeth. It knows nothing of the pulsation, its two multipliers are known
//! exactly and meet those of the others without a consequence: what is left has two degrees of freedom.

use crate::error::NumericsError;
use crate::model::linear::LinearPair;
use crate::model::parameters::Parameters;
use crate::numerics::characteristic::{self, Characteristic, Factors, Top};
use crate::numerics::parametric::Parametric;
use crate::numerics::roots::bracketed_root;
use crate::order;
use std::cell::Cell;
use std::f64::consts::PI;

/// Most steps of one characteristic polynomial: some tenths of a second.
pub const MOST_STEPS: usize = 400_000;

/// The part of the linear problem that the pulsation acts on.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Coupled {
    Two(Parametric<2, 4>),
    Three(Parametric<3, 6>),
}

/// Steps that all characteristic polynomials of one question may take: some seconds, a hundred times what ordinary
/// parameters need.
pub const BUDGET: f64 = 1e6;

/// Squares of frequencies that differ by less, relative to them, are equal.
const EQUAL: f64 = 1e-13;

/// The linear problem with its idle mode apart, and what is left of its [`BUDGET`].
#[derive(Clone, Debug, PartialEq)]
pub struct LinearFloquet {
    coupled: Coupled,
    /// Stiffness and damping of the idle mode x'' + d x' + s x = 0.
    idle: Option<[f64; 2]>,
    damping_trace: f64,
    refinement: f64,
    left: Cell<f64>,
}

impl LinearFloquet {
    /// The linear problem of these parameters; their `k0`, `Omega`, loads and cubic terms have no part in it.
    pub fn new(p: &Parameters) -> Self {
        let pair = LinearPair::new(p);
        let (coupling, stiffness) = (pair.coupling(), pair.support_stiffness());
        let (damping, mutual_damping) = (pair.support_damping(), pair.mesh_damping());
        let alike = |values: [f64; 3]| {
            (values[0] - values[1]).abs() <= 4.0 * f64::EPSILON * values[0].abs().max(values[1].abs())
        };
        if alike(stiffness) && alike(damping) {
            let coupled = Parametric {
                stiffness: [stiffness[0], stiffness[2]],
                damping: [damping[0], damping[2]],
                coupling: [coupling[0].hypot(coupling[1]), coupling[2]],
                mutual_damping,
            };
            return Self {
                coupled: Coupled::Two(coupled),
                idle: Some([stiffness[0], damping[0]]),
                damping_trace: coupled.damping_trace(),
                refinement: 1.0,
                left: Cell::new(BUDGET),
            };
        }
        let coupled = Parametric { stiffness, damping, coupling, mutual_damping };
        Self {
            coupled: Coupled::Three(coupled),
            idle: None,
            damping_trace: coupled.damping_trace(),
            refinement: 1.0,
            left: Cell::new(BUDGET),
        }
    }

    /// The same, integrated in twice as many steps: for estimates of the error.
    #[must_use]
    pub fn refined(&self) -> Self {
        Self { refinement: 2.0, ..self.clone() }
    }

    /// About the error of the coefficients of a characteristic polynomial, relative to the greatest: a little more
    /// than was measured against finer steps at thousands of points.
    pub fn truncation(&self) -> f64 {
        if self.refinement > 1.0 { 3e-14 } else { 3e-12 }
    }

    /// Degrees of freedom that the pulsation acts on: two or three.
    pub fn modes(&self) -> usize {
        match self.coupled {
            Coupled::Two(_) => 2,
            Coupled::Three(_) => 3,
        }
    }

    /// Whether nothing damps the modes that the pulsation acts on.
    pub fn undamped(&self) -> bool {
        self.damping_trace == 0.0
    }

    /// Logarithm of the determinant of the monodromy matrix over time, with its sign turned.
    pub fn damping_trace(&self) -> f64 {
        self.damping_trace
    }

    /// Steps that one characteristic polynomial takes, as a measure of work.
    pub fn steps(&self, omega: f64, k0: f64) -> f64 {
        match &self.coupled {
            Coupled::Two(system) => system.steps(k0, omega),
            Coupled::Three(system) => system.steps(k0, omega),
        }
    }

    /// The characteristic polynomial of the monodromy over one mesh period, of the modes that the pulsation acts on.
    ///
    /// # Errors
    /// [`NumericsError::TooManySteps`] in stiff and slow corners, [`NumericsError::NotFinite`] for growth beyond all
    /// numbers.
    pub fn characteristic(&self, omega: f64, k0: f64) -> Result<Characteristic, NumericsError> {
        // A polynomial costs about as much as one more step.
        let left = self.left.get() - self.steps(omega, k0) - 1.0;
        if left.is_nan() || left <= 0.0 {
            return Err(NumericsError::TooManySteps { time: 0.0, steps: BUDGET as usize });
        }
        self.left.set(left);
        let found = match &self.coupled {
            Coupled::Two(system) => system.characteristic(k0, omega, MOST_STEPS, self.refinement),
            Coupled::Three(system) => system.characteristic(k0, omega, MOST_STEPS, self.refinement),
        }?;
        Ok(if self.undamped() { found.reciprocal() } else { found })
    }

    /// Modulus of the idle mode's greater multiplier; 0 where there is none.
    pub fn idle_radius(&self, omega: f64) -> f64 {
        let Some([stiffness, damping]) = self.idle else { return 0.0 };
        let square = 0.25 * damping * damping - stiffness;
        let rate = if square > 0.0 {
            // The slower of two real rates, without the difference of nearly equal numbers.
            -stiffness / (0.5 * damping + square.sqrt())
        } else {
            -0.5 * damping
        };
        (rate * 2.0 * PI / omega).exp()
    }

    /// Natural frequencies without damping and pulsation, of the modes that the pulsation acts on, rising: with two,
    /// omega_2 and omega_3; with three, omega_2, omega_1, omega_3, as for equal supports.
    ///
    /// They are the zeros of 1 + sum b_i^2/(s_i - sigma), one above each s_i; those of the squares are bracketed.
    pub fn frequencies(&self) -> Vec<f64> {
        let (stiffness, coupling): (&[f64], &[f64]) = match &self.coupled {
            Coupled::Two(system) => (&system.stiffness, &system.coupling),
            Coupled::Three(system) => (&system.stiffness, &system.coupling),
        };
        let mut poles: Vec<[f64; 2]> = stiffness.iter().zip(coupling).map(|(s, b)| [*s, b * b]).collect();
        order::by_number(&mut poles, |pole| pole[0]);
        // Of equal poles all but one are natural frequencies themselves: one combination moves without the others. The
        // polynomial vanishes there, and would be taken for zero at the ends of both intervals beside them.
        let mut found = Vec::with_capacity(poles.len());
        let mut distinct: Vec<[f64; 2]> = Vec::with_capacity(poles.len());
        for [s, square] in poles {
            match distinct.last_mut().filter(|last| s - last[0] <= EQUAL * s) {
                Some(last) => {
                    last[1] += square;
                    found.push(s.sqrt());
                }
                None => distinct.push([s, square]),
            }
        }
        let poles = distinct;
        let above: f64 = poles.iter().map(|pole| pole[1]).sum();
        // Times all s_i - sigma, so that it is a polynomial.
        let secular = |sigma: f64| {
            let mut whole: f64 = poles.iter().map(|pole| pole[0] - sigma).product();
            for i in 0..poles.len() {
                let others: f64 = (0..poles.len()).filter(|j| *j != i).map(|j| poles[j][0] - sigma).product();
                whole += poles[i][1] * others;
            }
            whole
        };
        found.extend((0..poles.len()).map(|i| {
            let low = poles[i][0];
            let high = poles.get(i + 1).map_or(low + above, |pole| pole[0]);
            // The last one is at most `above` beyond the greatest pole; rounding may hide the change of sign there.
            let high = if i + 1 == poles.len() { high * (1.0 + 1e-12) } else { high };
            bracketed_root(secular, low, high, 0.0).unwrap_or(0.5 * (low + high)).sqrt()
        }));
        order::by_number(&mut found, |frequency| *frequency);
        found
    }

    /// The square of the part that the mode of a natural frequency has in the compression of the teeth, at unit modal
    /// mass: of (K - sigma) x = 0 with the rank-one K the vector is x_i = b_i/(s_i - sigma), for which b.x = -1.
    pub fn participation(&self, frequency: f64) -> f64 {
        let (stiffness, coupling): (&[f64], &[f64]) = match &self.coupled {
            Coupled::Two(system) => (&system.stiffness, &system.coupling),
            Coupled::Three(system) => (&system.stiffness, &system.coupling),
        };
        let sigma = frequency * frequency;
        let mass: f64 = stiffness.iter().zip(coupling).map(|(s, b)| (b / (s - sigma)).powi(2)).sum();
        1.0 / mass
    }

    /// Quadratic factors of the characteristic polynomial of the system's exponents at `k0 = 0`: of
    /// det(lambda^2 + C lambda + K) = prod(lambda^2 + d_i lambda + s_i) + (z lambda + 1) sum b_i^2 (the others' product).
    ///
    /// # Errors
    /// As [`Factors::find`].
    pub fn at_rest(&self) -> Result<Factors, NumericsError> {
        let (stiffness, damping, coupling, mutual): (&[f64], &[f64], &[f64], f64) = match &self.coupled {
            Coupled::Two(s) => (&s.stiffness, &s.damping, &s.coupling, s.mutual_damping),
            Coupled::Three(s) => (&s.stiffness, &s.damping, &s.coupling, s.mutual_damping),
        };
        let n = stiffness.len();
        // Coefficients of rising powers.
        let product = |without: Option<usize>| {
            let mut powers = vec![1.0];
            for i in (0..n).filter(|i| Some(*i) != without) {
                let mut next = vec![0.0; powers.len() + 2];
                for (k, value) in powers.iter().enumerate() {
                    next[k] += stiffness[i] * value;
                    next[k + 1] += damping[i] * value;
                    next[k + 2] += value;
                }
                powers = next;
            }
            powers
        };
        let mut powers = product(None);
        for i in 0..n {
            let square = coupling[i] * coupling[i];
            for (k, value) in product(Some(i)).into_iter().enumerate() {
                powers[k] += square * value;
                powers[k + 1] += mutual * square * value;
            }
        }
        let mut coefficients = [0.0; 6];
        for (k, coefficient) in coefficients[..2 * n].iter_mut().enumerate() {
            *coefficient = powers[2 * n - 1 - k];
        }
        Factors::find(&Characteristic { degree: 2 * n, coefficients })
    }
}

/// Factors of a characteristic polynomial found anew, to about `accuracy`, and its greatest root.
///
/// # Errors
/// As [`Factors::find`].
pub fn factorise(of: &Characteristic, accuracy: f64) -> Result<(Factors, Top), NumericsError> {
    let found = Factors::find(of)?;
    let mut factors = found;
    // The eigenvalues are good to the rounding of the companion matrix; Newton's method makes them good to their own.
    match factors.refine(of, accuracy) {
        Some(top) => Ok((factors, top)),
        // Factors meet; it may be small ones, far from the greatest root.
        None => Ok((found, of.top(&found))),
    }
}

/// Factors from nothing, to rounding.
///
/// # Errors
/// As [`Factors::find`].
pub fn factors(of: &Characteristic) -> Result<Factors, NumericsError> {
    Ok(factorise(of, characteristic::ROUNDING)?.0)
}
