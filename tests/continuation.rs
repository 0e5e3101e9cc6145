//! The continuation that gear pairs are followed by, on systems whose bifurcations are published.

use crate::common;

use common::reference;
use gear_bifurcations::error::NumericsError;
use gear_bifurcations::numerics::continuation::corrector::{Frame, correct, tangent};
use gear_bifurcations::numerics::continuation::detect::{Point, Sign, finish};
use gear_bifurcations::numerics::continuation::step::{Bounds, End, Trace};
use gear_bifurcations::numerics::continuation::switch;
use gear_bifurcations::numerics::continuation::symmetry::{Group, Space, Symmetry};
use gear_bifurcations::numerics::continuation::{Evaluation, Family, Kind, Path, Scale, State};
use gear_bifurcations::numerics::ode::Field;
use gear_bifurcations::numerics::ode::runge_kutta::{RungeKutta, RungeKuttaOptions};
use nalgebra::SMatrix;
use std::f64::consts::TAU;

/// An oscillator of one or two degrees of freedom forced with period 2 pi / omega.
#[derive(Clone, Copy)]
enum Oscillator {
    /// x'' + 2 mu x' + (1 + eps cos(omega t)) x + alpha x^3 = 0.
    Parametric { mu: f64, eps: f64, alpha: f64 },
    /// Two masses in a row, both springs with a cubic part, the first mass forced (Krack and Gross, Harmonic Balance
    /// for Nonlinear Vibration Problems, Springer 2019, solved example 2).
    TwoMasses,
}

/// State of positions, then velocities, then the derivative by the start, row after row.
struct Variational {
    oscillator: Oscillator,
    omega: f64,
}

impl Variational {
    fn size(&self) -> usize {
        match self.oscillator {
            Oscillator::Parametric { .. } => 2,
            Oscillator::TwoMasses => 4,
        }
    }

    /// Right-hand side and its Jacobian, both padded to four coordinates.
    fn linearised(&self, time: f64, x: &[f64]) -> ([f64; 4], [[f64; 4]; 4]) {
        let cosine = (self.omega * time).cos();
        let mut jacobian = [[0.0; 4]; 4];
        match self.oscillator {
            Oscillator::Parametric { mu, eps, alpha } => {
                let stiffness = 1.0 + eps * cosine;
                jacobian[0][1] = 1.0;
                jacobian[1][0] = -stiffness - 3.0 * alpha * x[0] * x[0];
                jacobian[1][1] = -2.0 * mu;
                let force = -2.0 * mu * x[1] - stiffness * x[0] - alpha * x[0].powi(3);
                ([x[1], force, 0.0, 0.0], jacobian)
            }
            Oscillator::TwoMasses => {
                let ([m1, m2], [k1, k2], [d1, d2], [c1, c2]) =
                    ([1.0, 0.05], [1.0, 0.0453], [0.002, 0.013], [1.0, 0.0042]);
                let (gap, rate) = (x[0] - x[1], x[2] - x[3]);
                let between = k2 * gap + c2 * gap.powi(3) + d2 * rate;
                let ground = k1 * x[0] + c1 * x[0].powi(3) + d1 * x[2];
                let (stiff, soft) = (k1 + 3.0 * c1 * x[0] * x[0], k2 + 3.0 * c2 * gap * gap);
                jacobian[0][2] = 1.0;
                jacobian[1][3] = 1.0;
                jacobian[2] = [-(stiff + soft) / m1, soft / m1, -(d1 + d2) / m1, d2 / m1];
                jacobian[3] = [soft / m2, -soft / m2, d2 / m2, -d2 / m2];
                ([x[2], x[3], (0.11 * cosine - ground - between) / m1, between / m2], jacobian)
            }
        }
    }
}

impl Field<20> for Variational {
    fn derivative(&self, time: f64, all: &[f64; 20]) -> [f64; 20] {
        let size = self.size();
        let (velocity, jacobian) = self.linearised(time, &all[..4]);
        let mut rate = [0.0; 20];
        rate[..4].copy_from_slice(&velocity);
        for row in 0..size {
            for column in 0..size {
                rate[4 + 4 * row + column] =
                    (0..size).map(|i| jacobian[row][i] * all[4 + 4 * i + column]).sum();
            }
        }
        rate
    }
}

/// The oscillator as a family in omega; the coordinates that it lacks are mapped to zero.
struct Forced {
    oscillator: Oscillator,
    group: Group,
}

impl Forced {
    fn new(oscillator: Oscillator) -> Self {
        let sign = Symmetry { sign: [-1.0; 6], ..Symmetry::IDENTITY };
        let odd = matches!(oscillator, Oscillator::Parametric { .. });
        Self { oscillator, group: Group::new(odd.then_some(sign), None) }
    }

    fn carried(&self, state: &State, omega: f64, end: f64) -> Result<[f64; 20], NumericsError> {
        let field = Variational { oscillator: self.oscillator, omega };
        let mut all = [0.0; 20];
        all[..4].copy_from_slice(&state[..4]);
        for i in 0..field.size() {
            all[4 + 5 * i] = 1.0;
        }
        let mut integration = RungeKutta::new(&field, 0.0, all, RungeKuttaOptions::with_tolerance(1e-12))?;
        while integration.time() < end {
            integration.step(end)?;
        }
        Ok(*integration.state())
    }
}

impl Family for Forced {
    fn evaluate(&mut self, kind: Kind, state: &State, omega: f64) -> Result<Evaluation, NumericsError> {
        let period = kind.periods as f64 * TAU / omega;
        let all = self.carried(state, omega, period)?;
        let mut image = [0.0; 6];
        image[..4].copy_from_slice(&all[..4]);
        let derivative = SMatrix::from_fn(|i, j| if i < 4 && j < 4 { all[4 + 4 * i + j] } else { 0.0 });
        let element = self.group.element(kind.symmetry).expect("one of the group");
        Ok(Evaluation {
            image: element.apply(&image),
            derivative: element.times(&derivative),
            half: image,
            peaks: [state[0], 0.0],
            gradients: [[0.0; 6]; 2],
            pieces: 0,
        })
    }

    fn image(&mut self, kind: Kind, state: &State, omega: f64) -> Result<State, NumericsError> {
        Ok(self.evaluate(kind, state, omega)?.image)
    }

    fn group(&self) -> &Group {
        &self.group
    }

    fn halves(&self, _periods: usize) -> bool {
        false
    }
}

fn bounds(range: [f64; 2]) -> Bounds {
    let scale = Scale { state: 1.0, parameter: range[1] - range[0] };
    Bounds { range, scale, longest: 0.05, points: 3000, tolerance: 1e-9 }
}

/// The point of a branch at the low end of the range.
fn start(family: &mut Forced, path: Path, bounds: &Bounds) -> Point {
    let space = Space::new(family.group(), path.keeping);
    let frame = Frame { kind: path.kind, space: &space, scale: bounds.scale, tolerance: bounds.tolerance };
    let mut normal = [0.0; 7];
    normal[6] = 1.0;
    let place = bounds.scale.scaled(&[0.0; 6], bounds.range[0]);
    let mut corrected = correct(family, &frame, &place, &normal, None).expect("an orbit");
    corrected.tangent = tangent(family, &frame, &corrected.at, &corrected.evaluation).expect("a tangent");
    finish(corrected, 0.0, &space, 0.0).expect("multipliers")
}

fn followed(family: &mut Forced, path: Path, bounds: Bounds) -> Trace {
    let start = start(family, path, &bounds);
    let group = *family.group();
    let mut trace = Trace::new(path, &group, start, bounds, 0.01);
    trace.run(family);
    trace
}

const STEADY: Kind = Kind { periods: 1, symmetry: 0 };

#[test]
fn the_system_of_two_masses_folds_and_sheds_tori_where_it_is_published_to() {
    let mut family = Forced::new(Oscillator::TwoMasses);
    let bounds = bounds([0.8, 1.4]);
    let trace = followed(&mut family, Path { kind: STEADY, keeping: 1 }, bounds);
    assert_eq!(trace.end, Some(End::Range));
    let at = |sign: Sign| -> Vec<f64> {
        let chosen = trace.found.iter().filter(|(_, located)| located.sign == sign);
        chosen.map(|(_, located)| located.point.at[6] * bounds.scale.parameter).collect()
    };
    let published = &reference("published_and_classical")["two_dof_cubic"];
    for (sign, name) in [(Sign::Plus, "LP"), (Sign::Pair, "NS")] {
        let found = at(sign);
        let expected = common::floats(&published[name]);
        assert_eq!(found.len(), expected.len(), "{name}: {found:?}");
        for value in expected {
            // As many digits as are published.
            assert!(found.iter().any(|found| (found - value).abs() < 2e-8), "{name} {value}: {found:?}");
        }
    }
    assert!(trace.found.iter().all(|(_, located)| located.turns == (located.sign == Sign::Plus)));
}

#[test]
fn the_parametric_duffing_oscillator_doubles_its_period_at_the_edges_and_grows_as_published() {
    let published = &reference("published_and_classical")["parametric_duffing"]["rows"];
    for row in published.as_array().expect("rows") {
        let eps = row["eps"].as_f64().expect("a number");
        let oscillator = Oscillator::Parametric { mu: 0.01, eps, alpha: 1.0 };
        let mut family = Forced::new(oscillator);
        for (omega, amplitude) in row["amplitude"].as_object().expect("an object") {
            let omega: f64 = omega.parse().expect("a number");
            let range = [1.7, omega.max(2.15)];
            let bounds_of_rest = bounds(range);
            let rest = followed(&mut family, Path { kind: STEADY, keeping: 3 }, bounds_of_rest);
            let edges = common::floats(&row["edges"]);
            assert_eq!(rest.found.len(), 2, "{:?}", rest.found.len());
            for ((_, located), edge) in rest.found.iter().zip(edges) {
                assert_eq!(located.sign, Sign::Minus);
                let value = located.point.at[6] * bounds_of_rest.scale.parameter;
                assert!((value - edge).abs() < 1e-8, "{value} {edge}");
            }
            // The branch that is born at the left edge, up to the omega that is asked for.
            let bounds = bounds([1.7, omega]);
            let mut place = rest.found[0].1;
            place.point.at[6] *= bounds_of_rest.scale.parameter / bounds.scale.parameter;
            let group = *family.group();
            let (_, birth) =
                switch::nature(&group, Path { kind: STEADY, keeping: 3 }, &rest.space, bounds.scale, &place);
            let birth = birth.expect("a branch is born");
            assert_eq!(birth.path.kind, Kind { periods: 1, symmetry: 1 });
            let [first, second] =
                switch::start(&mut family, &birth, &place.point, bounds.scale, 1e-9).expect("starts");
            let mut trace = Trace::new(birth.path, &group, first, bounds, 0.01);
            trace.push(second);
            trace.run(&mut family);
            assert_eq!(trace.end, Some(End::Range));
            let (state, at) = bounds.scale.plain(&trace.points.last().expect("points").at);
            assert!((at - omega).abs() < 1e-12);
            let (mut cosine, mut sine) = (0.0, 0.0);
            let samples = 64;
            for n in 0..samples {
                let time = f64::from(n) / f64::from(samples) * 2.0 * TAU / omega;
                let x =
                    if n == 0 { state[0] } else { family.carried(&state, omega, time).expect("moves")[0] };
                cosine += x * (0.5 * omega * time).cos() * 2.0 / f64::from(samples);
                sine += x * (0.5 * omega * time).sin() * 2.0 / f64::from(samples);
            }
            let expected = amplitude.as_f64().expect("a number");
            assert!((cosine.hypot(sine) - expected).abs() < 1e-6, "{eps} {omega}: {}", cosine.hypot(sine));
        }
    }
}
