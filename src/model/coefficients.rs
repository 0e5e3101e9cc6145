//! The Taylor coefficients of the motion, one after the other, each product of series written out.
//!
//! Of the recurrences' work nine tenths are products of series: the pulsation times the tooth force, and the cubes of
//! the supports. They are short sums of known length; told their length, the compiler makes straight lines of them,
//! which run twice as fast as loops.

use crate::model::equations::{Forcing, U, U_DOT};
use crate::model::parameters::Parameters;
use crate::numerics::ode::taylor::Series;

/// Most coefficients that a series of the motion may have.
pub const MOST: usize = 25;

/// What the recurrences take from the parameters; pinion and gear are two lanes.
pub struct Coefficients<'a, const LEN: usize> {
    inverse_mass: [f64; 2],
    /// Stiffness, cubic stiffness and damping of the supports, over their masses.
    stiffness: [f64; 2],
    cubic: [f64; 2],
    damping: [f64; 2],
    mesh_damping: f64,
    /// The tooth function's line on this piece.
    slope: f64,
    offset: f64,
    forcing: &'a Forcing<LEN>,
}

/// What is known of products so far. All of it is at places known to the compiler, which keeps it in registers as it
/// sees fit.
struct Known<const LEN: usize> {
    /// Coefficients of the tooth function, two side by side.
    tooth: [[f64; 2]; LEN],
    /// Of the squares of the displacements.
    square: [[f64; 2]; LEN],
    /// Stiffness of the supports about the displacement that the step starts at, over the masses.
    tangent: [f64; 2],
    /// Mesh stiffness at the start of the step.
    mesh: f64,
    /// Coefficients of the pulsation, each with the one before it: what two coefficients of the tooth function side by side are
    /// multiplied by.
    pulsation: [[f64; 2]; LEN],
}

impl<'a, const LEN: usize> Coefficients<'a, LEN> {
    /// Ready for the piece on which the tooth function is `slope * u - offset`.
    pub fn new(p: &Parameters, forcing: &'a Forcing<LEN>, (slope, offset): (f64, f64)) -> Self {
        let inverse_mass = [1.0 / p.m_p, 1.0 / p.m_g];
        let over_mass = |pinion: f64, gear: f64| [pinion * inverse_mass[0], gear * inverse_mass[1]];
        Self {
            inverse_mass,
            stiffness: over_mass(p.k_p, p.k_g),
            cubic: over_mass(p.alpha_p, p.alpha_g),
            damping: over_mass(2.0 * p.zeta_p, 2.0 * p.zeta_g),
            mesh_damping: 2.0 * p.zeta,
            slope,
            offset,
            forcing,
        }
    }

    /// Fills all rows of `series` after the first.
    ///
    /// Never inlined: once is enough of so much code.
    #[inline(never)]
    pub fn fill(&self, series: &mut Series<6, LEN>) {
        const { assert!(LEN <= MOST, "the motion's series has more coefficients than are written out") };
        let start = [series[0][0], series[0][1]];
        let tangent = |i: usize| self.stiffness[i] + 3.0 * self.cubic[i] * start[i] * start[i];
        let mut pulsation = [[0.0; 2]; LEN];
        for n in 0..LEN - 1 {
            pulsation[n] = [self.forcing.pulsation[n + 1], self.forcing.pulsation[n]];
        }
        let mut known = Known {
            tooth: [[0.0; 2]; LEN],
            square: [[0.0; 2]; LEN],
            tangent: [tangent(0), tangent(1)],
            mesh: 1.0 + self.forcing.pulsation[0],
            pulsation,
        };
        macro_rules! each {
            ($($n:literal)*) => { $(self.next::<$n>(series, &mut known);)* };
        }
        each!(0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23);
    }

    /// Row `N + 1` from the rows up to `N`.
    ///
    /// What the newest coefficients add to a product is taken apart from the rest, which is known long before them: the
    /// shorter the way from one row to the next, the less the processor waits.
    #[inline(always)]
    #[allow(clippy::inline_always, reason = "the sums' lengths must be known where they stand")]
    fn next<const N: usize>(&self, series: &mut Series<6, LEN>, known: &mut Known<LEN>) {
        if N + 1 >= LEN {
            return;
        }
        let older = known.cube::<N>(series);
        let pulsating = known.pulsating::<N>();
        let row = series[N];
        let tooth = self.slope * row[U] - if N == 0 { self.offset } else { 0.0 };
        known.tooth[N / 2][N % 2] = tooth;
        let rate = 1.0 / (N + 1) as f64;
        let force = (pulsating + known.mesh * tooth) + self.mesh_damping * row[U_DOT];
        let pushed = [self.inverse_mass[0], -self.inverse_mass[1]];
        let mut accelerations = [0.0; 2];
        for i in 0..2 {
            let springs = if N == 0 {
                row[i] * (self.stiffness[i] + self.cubic[i] * (row[i] * row[i]))
            } else {
                self.cubic[i] * older[i] + known.tangent[i] * row[i]
            };
            accelerations[i] = -((springs + self.damping[i] * row[3 + i]) + pushed[i] * force);
        }
        let transmission = (accelerations[0] - accelerations[1]) + (self.forcing.load[N] - force);
        series[N + 1] = [
            row[3] * rate,
            row[4] * rate,
            row[5] * rate,
            accelerations[0] * rate,
            accelerations[1] * rate,
            transmission * rate,
        ];
    }
}

impl<const LEN: usize> Known<LEN> {
    /// Coefficient `N` of the pulsation times the tooth function without the newest of it: in two sums, of even and of odd
    /// places.
    #[inline(always)]
    #[allow(clippy::inline_always, reason = "as above")]
    fn pulsating<const N: usize>(&self) -> f64 {
        let mut sums = [0.0; 2];
        let mut place = 0;
        // The coefficient beside the last one of an odd number is still zero.
        while place < N {
            for lane in 0..2 {
                sums[lane] += self.pulsation[N - place - 1][lane] * self.tooth[place / 2][lane];
            }
            place += 2;
        }
        sums[0] + sums[1]
    }

    /// Coefficient `N` of the cubes of the displacements without what the newest displacement adds to it; notes that of
    /// their squares.
    #[inline(always)]
    #[allow(clippy::inline_always, reason = "as above")]
    fn cube<const N: usize>(&mut self, series: &Series<6, LEN>) -> [f64; 2] {
        let at = |place: usize, lane: usize| series[place][lane];
        // The square: products from the middle outwards, all but the middle one twice.
        let (mut square, mut twice) = ([0.0; 2], [0.0; 2]);
        if N.is_multiple_of(2) && N > 0 {
            for lane in 0..2 {
                square[lane] = at(N / 2, lane) * at(N / 2, lane);
            }
        }
        let mut pairs = N.div_ceil(2);
        while pairs > 1 {
            pairs -= 1;
            for lane in 0..2 {
                twice[lane] += at(pairs, lane) * at(N - pairs, lane);
            }
        }
        for lane in 0..2 {
            square[lane] += 2.0 * twice[lane];
        }
        let (mut even, mut odd) = ([0.0; 2], [0.0; 2]);
        let mut place = 1;
        while place + 1 < N {
            for lane in 0..2 {
                odd[lane] += at(place, lane) * self.square[N - place][lane];
                even[lane] += at(place + 1, lane) * self.square[N - place - 1][lane];
            }
            place += 2;
        }
        if place < N {
            for lane in 0..2 {
                odd[lane] += at(place, lane) * self.square[N - place][lane];
            }
        }
        let mut cube = [0.0; 2];
        for lane in 0..2 {
            cube[lane] = (even[lane] + odd[lane]) + at(0, lane) * square[lane];
            let newest = if N == 0 { at(0, lane) } else { 2.0 * at(0, lane) };
            self.square[N][lane] = square[lane] + newest * at(N, lane);
        }
        cube
    }
}
