//! The Taylor coefficients of the motion, one after the other, each product of series written out.
//!
//! Of the recurrences' work nine tenths are products of series: the pulsation times the tooth force, and the cubes of
//! the supports. They are short sums of known length; told their length, the compiler makes straight lines of them,
//! which run twice as fast as loops. In each sum the newest coefficient comes last, because all the others are known long before it.

use crate::model::equations::{Forcing, U, U_DOT};
use crate::model::parameters::Parameters;
use crate::numerics::ode::taylor::Series;

/// Most coefficients that a series of the motion may have.
pub const MOST: usize = 25;

/// What the recurrences take from the parameters; pinion and gear are two lanes.
pub struct Coefficients<const LEN: usize> {
    inverse_mass: [f64; 2],
    /// Stiffness, cubic stiffness and damping of the supports, over their masses.
    stiffness: [f64; 2],
    cubic: [f64; 2],
    damping: [f64; 2],
    mesh_damping: f64,
    /// The tooth function's line on this piece.
    slope: f64,
    offset: f64,
    load: [f64; LEN],
    /// Coefficients of the pulsation, the last one first, so that products run forwards in both factors.
    pulsation: [f64; LEN],
    /// Coefficients so far of the tooth function, of the displacements, of twice these, and of their squares.
    tooth: [f64; LEN],
    position: [[f64; 2]; LEN],
    twice: [[f64; 2]; LEN],
    square: [[f64; 2]; LEN],
}

impl<const LEN: usize> Coefficients<LEN> {
    /// Ready for the piece on which the tooth function is `slope * u - offset`.
    pub fn new(p: &Parameters, forcing: &Forcing<LEN>, (slope, offset): (f64, f64)) -> Self {
        let inverse_mass = [1.0 / p.m_p, 1.0 / p.m_g];
        let over_mass = |pinion: f64, gear: f64| [pinion * inverse_mass[0], gear * inverse_mass[1]];
        let mut pulsation = forcing.pulsation;
        pulsation.reverse();
        Self {
            inverse_mass,
            stiffness: over_mass(p.k_p, p.k_g),
            cubic: over_mass(p.alpha_p, p.alpha_g),
            damping: over_mass(2.0 * p.zeta_p, 2.0 * p.zeta_g),
            mesh_damping: 2.0 * p.zeta,
            slope,
            offset,
            load: forcing.load,
            pulsation,
            tooth: [0.0; LEN],
            position: [[0.0; 2]; LEN],
            twice: [[0.0; 2]; LEN],
            square: [[0.0; 2]; LEN],
        }
    }

    /// Fills all rows of `series` after the first.
    ///
    /// Never inlined: once is enough of so much code.
    #[inline(never)]
    pub fn fill(&mut self, series: &mut Series<6, LEN>) {
        const { assert!(LEN <= MOST, "the motion's series has more coefficients than are written out") };
        macro_rules! each {
            ($($n:literal)*) => { $(self.next::<$n>(series);)* };
        }
        each!(0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23);
    }

    /// Row `N + 1` from the rows up to `N`.
    #[inline(always)]
    #[allow(clippy::inline_always, reason = "the sums' lengths must be known where they stand")]
    fn next<const N: usize>(&mut self, series: &mut Series<6, LEN>) {
        if N + 1 >= LEN {
            return;
        }
        let row = series[N];
        let tooth = self.slope * row[U] - if N == 0 { self.offset } else { 0.0 };
        self.tooth[N] = tooth;
        let cube = self.cube::<N>([row[0], row[1]]);
        let rate = 1.0 / (N + 1) as f64;
        let force = (tooth + self.pulsating::<N>()) * rate;
        let resistance = self.mesh_damping * rate * row[U_DOT];
        let support = |i: usize, pushed: f64| {
            let springs = (self.stiffness[i] * row[i] + self.cubic[i] * cube[i]) * rate;
            let dampers = self.damping[i] * rate * row[3 + i] + pushed * resistance;
            -(springs + pushed * force + dampers)
        };
        let (pinion, gear) = (support(0, self.inverse_mass[0]), support(1, -self.inverse_mass[1]));
        let transmission = (pinion - gear) - (force + resistance) + self.load[N] * rate;
        series[N + 1] = [row[3] * rate, row[4] * rate, row[5] * rate, pinion, gear, transmission];
    }

    /// Coefficient `N` of the pulsation times the tooth function: in two sums, of even and of odd places.
    #[inline(always)]
    #[allow(clippy::inline_always, reason = "as above")]
    fn pulsating<const N: usize>(&self) -> f64 {
        let first = LEN - 1 - N;
        let mut sums = [0.0; 2];
        let mut place = 0;
        if N.is_multiple_of(2) {
            sums[0] = self.pulsation[first] * self.tooth[0];
            place = 1;
        }
        while place < N {
            sums[0] += self.pulsation[first + place] * self.tooth[place];
            sums[1] += self.pulsation[first + place + 1] * self.tooth[place + 1];
            place += 2;
        }
        sums[0] + sums[1]
    }

    /// Coefficient `N` of the cubes of the displacements, whose coefficient `N` is `newest`.
    #[inline(always)]
    #[allow(clippy::inline_always, reason = "as above")]
    fn cube<const N: usize>(&mut self, newest: [f64; 2]) -> [f64; 2] {
        self.position[N] = newest;
        self.twice[N] = newest.map(|value| 2.0 * value);
        // The square: products from the middle outwards, all but the middle one twice.
        let mut square = [0.0; 2];
        if N.is_multiple_of(2) {
            for lane in 0..2 {
                square[lane] = self.position[N / 2][lane] * self.position[N / 2][lane];
            }
        }
        let mut pairs = N.div_ceil(2);
        while pairs > 0 {
            pairs -= 1;
            for lane in 0..2 {
                square[lane] += self.twice[pairs][lane] * self.position[N - pairs][lane];
            }
        }
        self.square[N] = square;
        // The cube: the products with the newest position and the newest square last.
        let (mut even, mut odd) = ([0.0; 2], [0.0; 2]);
        let mut place = 1;
        while place + 1 < N {
            for lane in 0..2 {
                odd[lane] += self.position[place][lane] * self.square[N - place][lane];
                even[lane] += self.position[place + 1][lane] * self.square[N - place - 1][lane];
            }
            place += 2;
        }
        if place < N {
            for lane in 0..2 {
                odd[lane] += self.position[place][lane] * self.square[N - place][lane];
            }
        }
        let mut cube = [0.0; 2];
        for lane in 0..2 {
            cube[lane] = even[lane] + odd[lane] + self.position[0][lane] * square[lane];
            if N > 0 {
                cube[lane] += newest[lane] * self.square[0][lane];
            }
        }
        cube
    }
}
