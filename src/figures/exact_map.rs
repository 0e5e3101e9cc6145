//! The exact attractors over the trajectories of figures 11-13: periodic points by Newton's method, the invariant circle
//! by collocation, each beside its theory.

use super::compose::{Composer, Line, Points, number};
use super::job::Distance;
use super::tongues::Setting;
use crate::chart::drawing::Role;
use crate::error::StudyError;
use crate::model::parameters::Parameters;
use crate::study::ErrorEstimate;
use crate::study::orbit::{OrbitOptions, PeriodicOrbit, periodic_orbit};
use crate::study::poincare::Strobe;
use crate::study::torus::Torus;
use crate::theory::branches::{cycles, period_two};
use crate::theory::modes::Mode;
use crate::theory::primary::emanating_frequency;

/// Tolerance of periodic points, and of the circle: a line is drawn through it.
const POINTS: f64 = 1e-10;
pub(super) const CIRCLE: f64 = 1e-7;

/// What is looked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sought {
    /// The points of a motion of period 2T.
    Points,
    /// An invariant circle.
    Circle,
}

/// What was found.
#[derive(Clone, Debug)]
pub(super) enum ExactMap {
    /// The states of the orbit at the flashes, with `u_p` and `u_p'` of the theory to leading order.
    Points { orbit: PeriodicOrbit, states: Vec<[f64; 6]>, theory: Option<[f64; 2]> },
    /// The circle, with the theory's greatest `|u_p|`.
    Circle { torus: Torus, theory: Option<f64> },
    /// Nothing, and why.
    Nothing(String),
}

impl ExactMap {
    /// The points of the motion of period 2T.
    pub(super) fn points(p: &Parameters) -> Self {
        let options = OrbitOptions { period: 2, tolerance: POINTS, guess: None };
        let found = periodic_orbit(p, &options).and_then(|orbit| {
            let mut strobe = Strobe::new(p, orbit.state, POINTS)?;
            let mut states = vec![orbit.state];
            for _ in 1..orbit.period {
                states.extend(strobe.next()?);
            }
            let theory = Setting::of(p).ok().and_then(|setting| {
                let away = |mode: Mode| (emanating_frequency(&setting.modes, mode) - p.omega).abs();
                let nearer = away(Mode::Second) < away(Mode::Third);
                let mode = if nearer { Mode::Second } else { Mode::Third };
                let orbits = period_two(&setting.at(p.omega), mode).ok()?;
                let orbit = orbits.into_iter().flatten().find(|orbit| orbit.stable)?;
                // q = R cos(Omega t/2 - angle), u_p = -2 q.
                let (sine, cosine) = orbit.angle.sin_cos();
                Some([-2.0 * orbit.radius * cosine, -p.omega * orbit.radius * sine])
            });
            Ok(Self::Points { orbit, states, theory })
        });
        found.unwrap_or_else(|error| Self::Nothing(error.to_string()))
    }

    /// The invariant circle, from what its search came to.
    pub(super) fn circle(p: &Parameters, found: Result<Torus, StudyError>) -> Self {
        let torus = match found {
            Ok(torus) => torus,
            Err(error) => return Self::Nothing(error.to_string()),
        };
        let theory = Setting::of(p).ok().and_then(|setting| {
            let both = cycles(&setting.at(p.omega)).ok()?;
            let cycle = both.into_iter().flatten().find(|cycle| cycle.stable)?;
            Some(2.0 * (cycle.radius_b + cycle.radius_c))
        });
        Self::Circle { torus, theory }
    }

    pub(super) fn draw(&self, composer: &mut Composer, frame: usize) {
        let place = |state: &[f64; 6]| (state[0], state[3]);
        match self {
            Self::Points { orbit, states, theory } => {
                if let Some(theory) = theory {
                    let both = [(theory[0], theory[1]), (-theory[0], -theory[1])];
                    let line =
                        Line::new("theory", "points of the motion of period 2T by [T7]", Role::Corrected);
                    composer.marks(frame, line.label("theory [T7]", 0.0), Points::plane(both));
                }
                let meaning = format!("exact points of period {}T by Newton's method", orbit.period);
                let line = Line::new("exact points", meaning, Role::Exact).stable(orbit.stable);
                composer.marks(frame, line.label("exact", 0.0), Points::plane(states.iter().map(place)));
            }
            Self::Circle { torus, .. } => {
                let mut points = Points::default();
                for circle in torus.curve.chunks(torus.curve.len() / torus.circles.max(1)) {
                    // Every second of these is smooth enough.
                    points.piece(circle.iter().step_by(2).chain(circle.first()).map(place));
                }
                let line =
                    Line::new("exact circle", "exact invariant circle of the map", Role::QuasiPeriodic);
                composer.curve(frame, line.stable(torus.stable).label("exact", 0.8), points);
            }
            Self::Nothing(_) => {}
        }
    }

    pub(super) fn note(&self) -> String {
        match self {
            Self::Points { orbit, states, theory } => {
                let point = states[0];
                let exact = format!(
                    "Exact, by Newton's method: u_p = {}, u_p' = {} (period {}T, residual {})",
                    number(point[0], 9),
                    number(point[3], 9),
                    orbit.period,
                    number(orbit.error.residual.unwrap_or(0.0), 1)
                );
                let Some(theory) = theory else { return format!("{exact}.") };
                let nearest =
                    states.iter().min_by(|one, other| off(one, theory).total_cmp(&off(other, theory)));
                format!(
                    "{exact}; the theory [T7] is off by {} in the plane drawn.",
                    number(nearest.map_or(0.0, |state| off(state, theory)), 3)
                )
            }
            Self::Circle { torus, theory } => {
                let exact = format!(
                    "Exact invariant circle: mean radius {}, rotation {}, greatest |u_p| {} (residual {})",
                    number(torus.mean_radius, 7),
                    number(torus.rotation, 8),
                    number(torus.max_u_p, 7),
                    number(torus.error.residual.unwrap_or(0.0), 1)
                );
                theory.map_or_else(
                    || format!("{exact}."),
                    |theory| {
                        let by = number(theory - torus.max_u_p, 3);
                        format!(
                            "{exact}; the theory [T8] says |u_p| up to {}, off by {by}.",
                            number(theory, 4)
                        )
                    },
                )
            }
            Self::Nothing(why) => format!("No exact attractor beside the trajectories: {why}."),
        }
    }

    /// The theory beside the exact answer.
    pub(super) fn distances(&self) -> Vec<Distance> {
        let beside = |what: &str, theory: f64, exact: f64| {
            let what = what.to_owned();
            Distance { what, at: None, theory, exact }
        };
        match self {
            Self::Points { states, theory: Some(theory), .. } => {
                let nearest =
                    states.iter().min_by(|one, other| off(one, theory).total_cmp(&off(other, theory)));
                nearest.map_or_else(Vec::new, |state| {
                    let pairs = [("u_p of the point [T7]", 0, 0), ("u_p' of the point [T7]", 1, 3)];
                    pairs.map(|(what, of, at)| beside(what, theory[of], state[at])).into()
                })
            }
            Self::Circle { torus, theory: Some(theory) } => {
                vec![beside("greatest |u_p| of the cycle [T8]", *theory, torus.max_u_p)]
            }
            _ => Vec::new(),
        }
    }

    pub(super) fn method(&self) -> &str {
        match self {
            Self::Points { orbit, .. } => &orbit.method,
            Self::Circle { torus, .. } => &torus.method,
            Self::Nothing(_) => "nothing found",
        }
    }

    pub(super) fn error(&self) -> Option<ErrorEstimate> {
        match self {
            Self::Points { orbit, .. } => Some(orbit.error),
            Self::Circle { torus, .. } => Some(torus.error),
            Self::Nothing(_) => None,
        }
    }
}

/// Distance in the plane that is drawn.
fn off(state: &[f64; 6], theory: &[f64; 2]) -> f64 {
    (state[0] - theory[0]).hypot(state[3] - theory[1])
}
