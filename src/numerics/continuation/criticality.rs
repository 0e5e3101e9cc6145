//! Whether orbits are born at a bifurcation where the old ones are less stable (supercritical) or where they are more stable.
//!
//! Along the direction in which the born orbits leave, the map moves a state at distance a by `l a + C a^3`, where l goes
//! through zero at the bifurcation: at a fixed parameter, the state is sought at each distance that the map moves in no
//! other way (the reduction of Lyapunov and Schmidt). The born orbits, `a^2 = -l / C`, are where l is above zero if C is
//! below it. The parameter along the born branch would tell the same, but near its birth the equation for it is singular.
//!
//! Source: Yu. A. Kuznetsov, Elements of Applied Bifurcation Theory, 3rd ed. (Springer 2004),
//! doi 10.1007/978-1-4757-3978-8, sections 4.5 and 5.4. Departure: the coefficient is a quotient of differences instead of
//! a derivative, as only the map and its first derivative are there.

use super::detect::Point;
use super::switch::Birth;
use super::symmetry::Space;
use super::{Family, Scale, State};
use crate::numerics::elimination::Factors;

/// The distances tried, over the scale: the first, and how many.
const FIRST: f64 = 1e-2;
const MOST: usize = 10;
/// The next distance after one at which the state was found, and after one at which it was not.
const NEARER: f64 = 0.5;
const MUCH_NEARER: f64 = 0.2;
/// Iterations at each distance.
const ITERATIONS: usize = 10;
/// Part of the square of a distance by which the last iteration may move the state.
const SETTLED: f64 = 1e-4;
/// A rate so much greater than what it is at the bifurcation, where that is zero to all that can be located.
const CLEAR: f64 = 1e-6;
/// The least that rounding makes of the way along the direction, over the scale.
const ROUNDING: f64 = 1e-13;
/// How many times that differences have to be.
const SURE: f64 = 10.0;

/// Whether the born orbits are on the side where the old ones are less stable; none where the coefficient is so near zero,
/// or the map so steep, that it is not the same at neighbouring distances, or no more than what rounding makes.
pub fn supercritical(family: &mut dyn Family, birth: &Birth, at: &Point, scale: Scale) -> Option<bool> {
    let mut reduced = Reduced::new(family, birth, at, scale)?;
    let rounding = at.evaluation.derivative.amax() * f64::EPSILON;
    let mut tried: Vec<Tried> = Vec::with_capacity(MOST);
    let mut distance = FIRST;
    for _ in 0..MOST {
        let both = reduced
            .moved(family, distance)
            .and_then(|there| Some((there, reduced.moved(family, -distance)?)));
        let Some((there, opposite)) = both else {
            tried.clear();
            distance *= MUCH_NEARER;
            continue;
        };
        // What is even in the distance has no part in the rate.
        let (rate, even) = (0.5 * (there - opposite) / distance, 0.5 * (there + opposite));
        tried.push(Tried { square: distance * distance, rate, even });
        if let [.., last, now] = tried[..] {
            let whole = [last.rate / last.square, now.rate / now.square];
            if now.rate.abs() > CLEAR + SURE * rounding / distance && alike(whole[0], whole[1]) {
                return Some(now.rate < 0.0);
            }
        }
        if let [.., before, last, now] = tried[..] {
            // Without l, which is zero but for what the bifurcation was located to.
            let coefficients = [before.slope(&last), last.slope(&now)];
            let change = (last.rate - now.rate).abs();
            let noise = last.noise(&before, &now).max(SURE * ROUNDING) / distance;
            if alike(coefficients[0], coefficients[1]) && change > noise {
                return Some(coefficients[1] < 0.0);
            }
        }
        distance *= NEARER;
    }
    None
}

/// What the map does at one distance.
#[derive(Clone, Copy)]
struct Tried {
    /// The square of the distance.
    square: f64,
    /// The odd part of the way along the direction, over the distance.
    rate: f64,
    /// The even part of it.
    even: f64,
}

impl Tried {
    /// The rate's change over that of the square.
    fn slope(&self, nearer: &Self) -> f64 {
        (self.rate - nearer.rate) / (self.square - nearer.square)
    }

    /// How far the even part is from a line in the square, between one further off and one nearer: but for terms of higher order
    /// that is what the map's rounding makes of it, and of the odd part as well.
    fn noise(&self, further: &Self, nearer: &Self) -> f64 {
        let share = (self.square - nearer.square) / (further.square - self.square);
        ((self.even - nearer.even) - share * (further.even - self.even)).abs()
    }
}

fn alike(one: f64, other: f64) -> bool {
    let ratio = one / other;
    ratio > 0.6 && ratio < 1.0 / 0.6
}

/// The map about a bifurcation, bordered by the direction of the born branch.
struct Reduced<'a> {
    birth: &'a Birth,
    space: Space,
    scale: Scale,
    state: State,
    parameter: f64,
    /// The direction, in the coordinates of the space.
    direction: State,
    factors: Factors,
    /// Steps shorter than this may be rounding.
    shortest: f64,
    /// The state found last, less the bifurcation's and its part along the direction, over the square of its distance.
    aside: [State; 2],
}

impl<'a> Reduced<'a> {
    fn new(family: &mut dyn Family, birth: &'a Birth, at: &Point, scale: Scale) -> Option<Self> {
        let space = Space::new(family.group(), birth.path.keeping);
        let (state, parameter) = scale.plain(&at.at);
        let state = space.project(&state);
        let derivative = family.evaluate(birth.path.kind, &state, parameter).ok()?.derivative;
        let inside = space.inside(&derivative);
        let towards: State = std::array::from_fn(|i| birth.towards[i]);
        let direction = space.components(&towards);
        let size = space.fixed + 1;
        let mut rows = vec![0.0; size * size];
        for row in 0..space.fixed {
            for column in 0..space.fixed {
                rows[row * size + column] = inside[(row, column)] - f64::from(u8::from(row == column));
            }
            rows[row * size + space.fixed] = direction[row];
            rows[space.fixed * size + row] = direction[row];
        }
        let factors = Factors::new(size, rows).ok()?;
        let shortest = 1e3 * f64::EPSILON * derivative.amax();
        let aside = [[0.0; 6]; 2];
        Some(Self { birth, space, scale, state, parameter, direction, factors, shortest, aside })
    }

    /// By how much the map moves the state at this distance that it moves along the direction only.
    fn moved(&mut self, family: &mut dyn Family, distance: f64) -> Option<f64> {
        let fixed = self.space.fixed;
        let side = usize::from(distance < 0.0);
        let mut place: State =
            std::array::from_fn(|i| distance * self.direction[i] + distance * distance * self.aside[side][i]);
        let (mut along, mut last) = (0.0, f64::INFINITY);
        for _ in 0..ITERATIONS {
            let shift = self.space.vector(&place);
            let state: State = std::array::from_fn(|i| self.state[i] + self.scale.state * shift[i]);
            let image = family.image(self.birth.path.kind, &state, self.parameter).ok()?;
            let moved: State = std::array::from_fn(|i| (image[i] - state[i]) / self.scale.state);
            let moved = self.space.components(&moved);
            let mut right = vec![0.0; fixed + 1];
            let off: f64 = (0..fixed).map(|i| self.direction[i] * place[i]).sum();
            for row in 0..fixed {
                right[row] = -(moved[row] - along * self.direction[row]);
            }
            right[fixed] = distance - off;
            self.factors.solve(&mut right);
            let size = right[..fixed].iter().fold(0.0_f64, |most, value| most.max(value.abs()));
            for row in 0..fixed {
                place[row] += right[row];
            }
            along -= right[fixed];
            if size <= SETTLED * distance * distance || (size > 0.5 * last && size < self.shortest) {
                let square = distance * distance;
                self.aside[side] =
                    std::array::from_fn(|i| (place[i] - distance * self.direction[i]) / square);
                return along.is_finite().then_some(along);
            }
            if size.is_nan() || size > 0.7 * last {
                return None;
            }
            last = size;
        }
        None
    }
}
