//! The gear pair as a family of stroboscopic maps that depends on one of its parameters: what branches are made of.

use super::motion::{self, ORDER_16};
use super::multipliers::{common_period, trivial_state, unloaded};
use crate::error::{NumericsError, StudyError};
use crate::model::equations::{DIVERGED, GearPair};
use crate::model::manifold::{self, Manifold};
use crate::model::parameters::{Parameters, Regime, SHORT_FORMS, TABLE};
use crate::model::variational::{self, Variational};
use crate::numerics::continuation::symmetry::{Group, Symmetry};
use crate::numerics::continuation::{Evaluation, Family, Kind, State};
use crate::numerics::ode::taylor::{Options, Propagation, Step, TaylorField};
use crate::numerics::periodic::matrix;
use crate::numerics::roots::polynomial_value;

/// A gear pair of which one parameter varies.
#[derive(Clone, Debug)]
pub struct GearFamily {
    base: Parameters,
    parameter: &'static str,
    tolerance: f64,
    /// Factor by which every step is shortened, for estimates of the error.
    pub step_factor: f64,
    group: Group,
    common: usize,
    left: usize,
}

/// The parameter of this name, full or short, with its range; as the option `parameter` in errors.
///
/// # Errors
/// [`StudyError::Option`] for a name that is none, and for the frequencies of the loads: an orbit that is periodic at
/// one value of those is not at the next.
pub fn parameter_named(name: &str) -> Result<(&'static str, [f64; 2]), StudyError> {
    let refused = |allowed: &str| {
        Err(StudyError::Option { option: "parameter", given: name.into(), allowed: allowed.into() })
    };
    if name == "Omega_p" || name == "Omega_g" {
        return refused("any number of the model except Omega_p and Omega_g, which follow Omega");
    }
    let by_short = SHORT_FORMS.iter().find(|form| form.name == name);
    let full = by_short.map_or(name, |form| form.sets[0]);
    match TABLE.iter().find(|info| info.name == full) {
        Some(info) => Ok((by_short.map_or(info.name, |form| form.name), [info.low, info.high])),
        None => refused("the name of a number of the model, such as Omega, k0 or alpha"),
    }
}

/// The exchange of pinion and gear, of which equal supports take no notice: (u_p, u_g, u) to (-u_g, -u_p, u).
const EXCHANGE: Symmetry =
    Symmetry { from: [1, 0, 2, 4, 3, 5], sign: [-1.0, -1.0, 1.0, -1.0, -1.0, 1.0], centre: [0.0; 6] };
/// The index of the change of sign in the group, as a bit.
pub const SIGN: usize = 1;
/// The index of the exchange in the group, as a bit.
pub const SWAP: usize = 2;

impl GearFamily {
    /// The family at these parameters, of which the named one will vary within `range`; `steps` of the integration
    /// are granted for all that is asked of it.
    ///
    /// # Errors
    /// [`StudyError::Model`] for an incommensurate load.
    pub fn new(
        p: &Parameters,
        parameter: &'static str,
        range: [f64; 2],
        tolerance: f64,
        steps: usize,
    ) -> Result<Self, StudyError> {
        let common = common_period(p)?;
        let mut family = Self {
            base: *p,
            parameter,
            tolerance,
            step_factor: 1.0,
            group: Group::new(None, None),
            common,
            left: steps,
        };
        // A symmetry counts only if it holds all along: at both ends and at a point between that is no special one.
        let trials = [range[0], range[1], range[0] + 0.381_966 * (range[1] - range[0])];
        let always = |holds: &dyn Fn(&Parameters) -> bool| trials.iter().all(|&at| holds(&family.at(at)));
        let sign = always(&unloaded).then(|| Symmetry {
            sign: [-1.0; 6],
            centre: if p.regime == Regime::Contact { trivial_state(p) } else { [0.0; 6] },
            ..Symmetry::IDENTITY
        });
        let exchange = always(&|p| p.symmetric().is_ok())
            .then(|| Symmetry { centre: sign.map_or([0.0; 6], |sign| sign.centre), ..EXCHANGE });
        family.group = Group::new(sign, exchange);
        Ok(family)
    }

    /// The parameters at a value of the one that varies.
    ///
    /// What follows another by default goes on following where it does at the start: the loads' frequencies keep
    /// their ratio to Omega, the supports' damping that equals the mesh's goes with it.
    pub fn at(&self, value: f64) -> Parameters {
        let mut p = self.base;
        let follows = self.base.zeta_p == self.base.zeta && self.base.zeta_g == self.base.zeta;
        match self.parameter {
            "m_p" => p.m_p = value,
            "m_g" => p.m_g = value,
            "m" => (p.m_p, p.m_g) = (value, value),
            "k_p" => p.k_p = value,
            "k_g" => p.k_g = value,
            "k" => (p.k_p, p.k_g) = (value, value),
            "alpha_p" => p.alpha_p = value,
            "alpha_g" => p.alpha_g = value,
            "alpha" => (p.alpha_p, p.alpha_g) = (value, value),
            "zeta" if follows => (p.zeta, p.zeta_p, p.zeta_g) = (value, value, value),
            "zeta" => p.zeta = value,
            "zeta_p" => p.zeta_p = value,
            "zeta_g" => p.zeta_g = value,
            "zeta_s" => (p.zeta_p, p.zeta_g) = (value, value),
            "k0" => p.k0 = value,
            "F" => p.load = value,
            "F_p" => p.load_p = value,
            "F_g" => p.load_g = value,
            "E" => p.error = value,
            _ => {
                p.omega_p = self.base.omega_p / self.base.omega * value;
                p.omega_g = self.base.omega_g / self.base.omega * value;
                p.omega = value;
            }
        }
        p
    }

    /// The value of the parameter that varies, at the start.
    pub fn value(&self) -> f64 {
        let named = SHORT_FORMS.iter().find(|form| form.name == self.parameter);
        let name = named.map_or(self.parameter, |form| form.sets[0]);
        self.base.named().iter().find(|(other, _)| *other == name).map_or(f64::NAN, |(_, value)| *value)
    }

    /// The common period of mesh and load, in mesh periods.
    pub fn common(&self) -> usize {
        self.common
    }

    fn spend(&mut self, time: f64) -> Result<(), NumericsError> {
        if self.left == 0 {
            return Err(NumericsError::TooManySteps { time, steps: 0 });
        }
        self.left -= 1;
        Ok(())
    }

    fn options(&self) -> Options {
        Options {
            tolerance: motion::step_tolerance(self.tolerance),
            step_factor: self.step_factor,
            ..Options::default()
        }
    }

    /// Carries a field over the periods, in two halves where there are any: the state after the first half, at the
    /// end, and what was seen on the way.
    fn carry<F: TaylorField<N>, const N: usize>(
        &mut self,
        field: &F,
        start: [f64; N],
        periods: usize,
        parameters: &Parameters,
        seen: &mut Seen<'_>,
    ) -> Result<[[f64; N]; 2], NumericsError> {
        let period = parameters.mesh_period();
        let [pinion, gear] = GearPair::new(parameters).escape_bounds();
        let bound = pinion.max(gear);
        let mut half = start;
        let mut propagation = Propagation::<F, N, ORDER_16>::new(field, 0.0, start, self.options());
        let stops = if self.halves(periods) { vec![periods / 2, periods] } else { vec![periods] };
        for stop in stops {
            let end = stop as f64 * period;
            while propagation.time() < end {
                self.spend(propagation.time())?;
                let piece = propagation.piece();
                propagation.advance(end)?;
                seen.look(propagation.latest(), propagation.state());
                seen.pieces += usize::from(propagation.piece() != piece);
                if seen.beyond(propagation.state(), bound) {
                    return Err(NumericsError::Escaped { time: propagation.time() });
                }
            }
            if stop < periods {
                half = *propagation.state();
            }
        }
        Ok([half, *propagation.state()])
    }
}

/// Where among the coordinates of a field a displacement, its velocity, and the row of the displacement's derivative
/// by the start are.
type Place = (usize, usize, usize);

/// An extreme value and its derivative by the start.
#[derive(Clone, Copy)]
struct Extreme {
    value: f64,
    gradient: State,
}

/// Extremes and pieces met along an orbit.
struct Seen<'a> {
    /// Of pinion, gear (unless on the manifold) and u.
    places: &'a [Place],
    low: [Extreme; 3],
    high: [Extreme; 3],
    pieces: usize,
}

impl<'a> Seen<'a> {
    fn new(places: &'a [Place]) -> Self {
        let none = |value: f64| [Extreme { value, gradient: [0.0; 6] }; 3];
        Self { places, low: none(f64::INFINITY), high: none(f64::NEG_INFINITY), pieces: 0 }
    }

    fn look<const N: usize>(&mut self, step: &Step<N, ORDER_16>, end: &[f64; N]) {
        for (index, &(displacement, velocity, row)) in self.places.iter().enumerate() {
            let (low, high) = (&mut self.low[index], &mut self.high[index]);
            let mut take = |value: f64, gradient: &dyn Fn() -> State| {
                if value < low.value {
                    *low = Extreme { value, gradient: gradient() };
                }
                if value > high.value {
                    *high = Extreme { value, gradient: gradient() };
                }
            };
            take(end[displacement], &|| [0.0; 6]);
            if step.series[0][velocity] * end[velocity] < 0.0 {
                let since = turning(&step.coordinate(velocity), step.length);
                take(polynomial_value(&step.coordinate(displacement), since), &|| {
                    let entry = |column: usize| polynomial_value(&step.coordinate(row + column), since);
                    if N == manifold::SIZE {
                        manifold::gradient(&std::array::from_fn(entry))
                    } else {
                        std::array::from_fn(entry)
                    }
                });
            }
        }
    }

    fn beyond<const N: usize>(&self, state: &[f64; N], bound: f64) -> bool {
        // Without places nothing is looked at: a motion next to one that was is asked for.
        let last = self.places.len().saturating_sub(1);
        self.places.iter().enumerate().any(|(index, &(displacement, ..))| {
            let limit = if index == last { DIVERGED } else { bound };
            let size = state[displacement].abs();
            size.is_nan() || size > limit
        })
    }

    /// Greatest |u_p| and |u| of the orbit, whose second half is the first under a symmetry, with their gradients.
    fn peaks(&self, symmetry: usize, centre: f64) -> ([f64; 2], [State; 2]) {
        let signed = |sign: f64, offset: f64, extreme: &Extreme| Extreme {
            value: sign * extreme.value + offset,
            gradient: extreme.gradient.map(|value| sign * value),
        };
        let larger = |best: Extreme, other: Extreme| if other.value > best.value { other } else { best };
        let largest =
            |index: usize| larger(signed(1.0, 0.0, &self.high[index]), signed(-1.0, 0.0, &self.low[index]));
        let last = self.places.len() - 1;
        let mut pinion = largest(0);
        if last == 2 && symmetry & SWAP != 0 {
            pinion = larger(pinion, largest(1));
        }
        let mut mesh = largest(last);
        if symmetry & SIGN != 0 {
            // The other half is at 2 centre - u.
            mesh = larger(mesh, signed(1.0, -2.0 * centre, &self.high[last]));
            mesh = larger(mesh, signed(-1.0, 2.0 * centre, &self.low[last]));
        }
        ([pinion.value, mesh.value], [pinion.gradient, mesh.gradient])
    }
}

/// The root of a velocity whose sign differs at both ends of a step: Newton's method within the bracket.
fn turning(velocity: &[f64; ORDER_16], length: f64) -> f64 {
    let (mut low, mut high) = (0.0, length);
    let rising = velocity[0] < 0.0;
    let mut at = 0.5 * length;
    for _ in 0..30 {
        let (mut value, mut slope) = (0.0, 0.0);
        for coefficient in velocity.iter().rev() {
            slope = slope * at + value;
            value = value * at + coefficient;
        }
        *(if (value > 0.0) == rising { &mut high } else { &mut low }) = at;
        let newton = at - value / slope;
        let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
        // The displacement is flat there: half of the digits are enough.
        if (next - at).abs() < 1e-9 * length {
            return next;
        }
        at = next;
    }
    at
}

impl Family for GearFamily {
    fn evaluate(&mut self, kind: Kind, state: &State, parameter: f64) -> Result<Evaluation, NumericsError> {
        let p = self.at(parameter);
        let (half, image, derivative, (peaks, gradients), pieces);
        let centre = self.group.element(SIGN).map_or(0.0, |sign| sign.centre[2]);
        match Manifold::of(&p) {
            Some(field) if manifold::holds(state) => {
                let mut seen = Seen::new(&manifold::PLACES);
                let [middle, end] =
                    self.carry(&field, manifold::start(state), kind.periods, &p, &mut seen)?;
                half = manifold::full(&middle);
                (image, derivative) = manifold::split(&end);
                ((peaks, gradients), pieces) = (seen.peaks(kind.symmetry, centre), seen.pieces);
            }
            _ => {
                let field = Variational { pair: GearPair::new(&p) };
                let mut seen = Seen::new(&[(0, 3, 6), (1, 4, 12), (2, 5, 18)]);
                let [middle, end] =
                    self.carry(&field, variational::start(state), kind.periods, &p, &mut seen)?;
                half = variational::split(&middle).0;
                (image, derivative) = variational::split(&end);
                ((peaks, gradients), pieces) = (seen.peaks(kind.symmetry, centre), seen.pieces);
            }
        }
        let derivative = matrix(&derivative);
        let (image, derivative) = match self.group.element(kind.symmetry) {
            Some(symmetry) if kind.symmetry != 0 => (symmetry.apply(&image), symmetry.times(&derivative)),
            _ => (image, derivative),
        };
        Ok(Evaluation { image, derivative, half, peaks, gradients, pieces })
    }

    fn image(&mut self, kind: Kind, state: &State, parameter: f64) -> Result<State, NumericsError> {
        let p = self.at(parameter);
        let pair = GearPair::new(&p);
        let mut seen = Seen::new(&[]);
        let [_, end] = self.carry(&pair, *state, kind.periods, &p, &mut seen)?;
        Ok(self.group.apply(kind.symmetry, &end))
    }

    fn group(&self) -> &Group {
        &self.group
    }

    fn halves(&self, periods: usize) -> bool {
        periods.is_multiple_of(2 * self.common)
    }

    fn slack(&self) -> f64 {
        if GearPair::new(&self.base).trace() == 0.0 { 1e-6 } else { 0.0 }
    }

    fn budget(&self) -> usize {
        self.left
    }
}
