//! The exact edges of a tongue at a given depth of the pulsation.
//!
//! A named tongue is followed from `k0 = 0`: the deepest point of its function ([`EdgeFunction`]) along Omega starts at
//! twice a natural frequency, or at the sum of two, and moves smoothly with `k0^2`. Below zero there the tongue is open, and
//! its edges are the next zeros on both sides.

use super::ErrorEstimate;
use super::edge_function::EdgeFunction;
use super::linear_floquet::{self, LinearFloquet};
use super::motion;
use crate::error::{NumericsError, StudyError};
use crate::model::parameters::Parameters;
use crate::numerics::characteristic::Factors;
use crate::numerics::roots::bracketed_root;
use std::f64::consts::PI;

/// Which tongue.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Tongue {
    /// About twice the slowest natural frequency, `2 omega_2`.
    Primary2,
    /// About twice the fastest one, `2 omega_3`.
    Primary3,
    /// About the sum of these two.
    Combination,
    /// The one that holds this mesh frequency, or else the nearest one within [`NEAR`] of it.
    Near(f64),
}

/// How far from the given frequency a tongue is still looked for, relative to it.
pub const NEAR: f64 = 0.05;

/// What the multipliers do at an edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EdgeKind {
    /// One passes -1.
    PeriodDoubling,
    /// A complex pair leaves the unit circle.
    NeimarkSacker,
    /// One passes +1.
    PlusOne,
    /// Without damping: two pairs meet on the unit circle and leave it.
    Krein,
}

impl EdgeKind {
    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::PeriodDoubling => "period-doubling",
            Self::NeimarkSacker => "neimark-sacker",
            Self::PlusOne => "plus-one",
            Self::Krein => "krein",
        }
    }
}

/// The exact edges; all `None` where the tongue is closed at this depth.
#[derive(Clone, Debug, PartialEq)]
pub struct TongueEdges {
    /// Lower end of the interval of mesh frequencies.
    pub left: Option<f64>,
    /// Upper end.
    pub right: Option<f64>,
    /// What happens at the left and at the right edge.
    pub kind: Option<[EdgeKind; 2]>,
    /// How they were computed.
    pub method: String,
    /// `residual`: distance of the edges from the zero of the function that was solved, along Omega; `step`: their change
    /// when every step is halved.
    pub error: ErrorEstimate,
}

/// One edge: its frequency and its function.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Edge {
    pub omega: f64,
    pub function: EdgeFunction,
}

/// The edges of a tongue at the `k0` of these parameters; `Omega`, loads and cubic terms have no part in it.
///
/// # Errors
/// [`StudyError::Option`] for a tolerance or frequency out of range, [`StudyError::Numerics`] where the tongue cannot be
/// followed or its integration takes more than some seconds.
pub fn tongue_edges(p: &Parameters, tongue: Tongue, tolerance: f64) -> Result<TongueEdges, StudyError> {
    motion::check_tolerance(tolerance)?;
    let linear = LinearFloquet::new(p);
    let found = edges(&linear, tongue, p.k0, tolerance)?;
    let method =
        "zeros of the characteristic polynomial's conditions, Taylor series of order 24 on half a period";
    let Some(edges) = found else {
        return Ok(TongueEdges {
            left: None,
            right: None,
            kind: None,
            method: method.into(),
            error: ErrorEstimate::default(),
        });
    };
    let (mut step, mut residual) = (0.0_f64, 0.0_f64);
    for edge in &edges {
        let (change, value) = edge_error(&linear, edge, p.k0, edges[1].omega - edges[0].omega)?;
        step = step.max(change);
        residual = residual.max(value);
    }
    Ok(TongueEdges {
        left: Some(edges[0].omega),
        right: Some(edges[1].omega),
        kind: Some([edges[0].function.kind, edges[1].function.kind]),
        method: method.into(),
        error: ErrorEstimate { liouville: None, step: Some(step), residual: Some(residual) },
    })
}

/// How far the edge moves when the steps are halved, and how far it is from its function's zero; both along Omega.
pub(super) fn edge_error(
    linear: &LinearFloquet,
    edge: &Edge,
    k0: f64,
    width: f64,
) -> Result<(f64, f64), NumericsError> {
    let function = edge.function;
    let value = function.value(linear, edge.omega, k0)?;
    let finer = function.value(&linear.refined(), edge.omega, k0)?;
    let aside = 1e-4 * width.abs().max(1e-6 * edge.omega);
    let slope = (function.value(linear, edge.omega + aside, k0)?
        - function.value(linear, edge.omega - aside, k0)?)
        / (2.0 * aside);
    let along = |difference: f64| if slope == 0.0 { 0.0 } else { (difference / slope).abs() };
    Ok((along(finer - value), along(value)))
}

/// Left and right edge at this depth; none where the tongue is closed.
pub(super) fn edges(
    linear: &LinearFloquet,
    tongue: Tongue,
    k0: f64,
    tolerance: f64,
) -> Result<Option<[Edge; 2]>, StudyError> {
    if let Tongue::Near(omega) = tongue {
        return near::edges(linear, omega, k0, tolerance);
    }
    let Some((centre, function)) = follow_centre(linear, tongue, k0)? else { return Ok(None) };
    between_zeros(linear, function, centre, k0, tolerance)
}

/// Mesh frequency at which a named tongue starts at `k0 = 0`, and its function.
pub(super) fn origin(linear: &LinearFloquet, tongue: Tongue) -> (f64, EdgeFunction) {
    let frequencies = linear.frequencies();
    let (slow, fast) = (frequencies[0], frequencies[frequencies.len() - 1]);
    match tongue {
        Tongue::Primary2 => (2.0 * slow, EdgeFunction { kind: EdgeKind::PeriodDoubling }),
        Tongue::Primary3 => (2.0 * fast, EdgeFunction { kind: EdgeKind::PeriodDoubling }),
        Tongue::Combination | Tongue::Near(_) => (slow + fast, EdgeFunction::pair(linear)),
    }
}

/// Greatest advance of k0 when the middle of a tongue is followed.
const K0_STEP: f64 = 0.1;

/// The deepest point of a named tongue at this depth, if it is open there, and its function.
fn follow_centre(
    linear: &LinearFloquet,
    tongue: Tongue,
    k0: f64,
) -> Result<Option<(f64, EdgeFunction)>, NumericsError> {
    let (mut centre, function) = origin(linear, tongue);
    if k0 == 0.0 {
        return Ok(None);
    }
    let origin_at = centre;
    let count = (k0 / K0_STEP).ceil();
    let mut before: Option<(f64, f64)> = None;
    let mut deepest = Deepest { omega: centre, value: f64::INFINITY };
    for index in 0..=count as usize {
        let depth = k0 * index as f64 / count;
        // The middle moves with k0^2.
        let guess =
            before.map_or(
                centre,
                |(square, omega)| {
                    if square == depth * depth { centre } else { 2.0 * centre - omega }
                },
            );
        let last = index as f64 == count;
        let widths: &[f64] = if last { &[0.01, 1e-3, 1e-4] } else { &[0.01] };
        let guess = if index < 3 { centre } else { guess };
        deepest = minimise(linear, function, guess, depth, widths)?;
        before = Some((depth * depth, centre));
        centre = deepest.omega;
    }
    let open = deepest.value < 0.0 && is_this_instability(linear, function, origin_at, centre, k0)?;
    Ok(open.then_some((centre, function)))
}

/// How far the middle of a tongue may move from where it starts, relative to that.
const WANDERS: f64 = 0.35;

/// Whether a point where the function is below zero is unstable by multipliers of its kind, not far from where the tongue
/// starts: with strong damping there may be no minimum to follow, and what is met instead is no tongue, or another.
fn is_this_instability(
    linear: &LinearFloquet,
    function: EdgeFunction,
    origin: f64,
    omega: f64,
    k0: f64,
) -> Result<bool, NumericsError> {
    if linear.undamped() {
        return Ok(true);
    }
    let factors = linear_floquet::factors(&linear.characteristic(omega, k0)?)?;
    let top = factors.top();
    let real = 0.25 * factors.p[top] * factors.p[top] >= factors.q[top];
    let of_kind = real == (function.kind == EdgeKind::PeriodDoubling);
    Ok(of_kind && factors.radius() > 1.0 && (omega - origin).abs() < WANDERS * origin)
}

struct Deepest {
    omega: f64,
    value: f64,
}

/// A local minimum along Omega by parabolas through three points, whose distance shrinks.
fn minimise(
    linear: &LinearFloquet,
    function: EdgeFunction,
    start: f64,
    k0: f64,
    widths: &[f64],
) -> Result<Deepest, NumericsError> {
    let mut best = Deepest { omega: start, value: function.value(linear, start, k0)? };
    for width in widths {
        let h = width * start;
        for _ in 0..8 {
            let left = function.value(linear, best.omega - h, k0)?;
            let right = function.value(linear, best.omega + h, k0)?;
            let (slope, curvature) = (0.5 * (right - left), right - 2.0 * best.value + left);
            // Downhill by no more than twice the distance, where there is no minimum within reach.
            let shift =
                if curvature > 0.0 { (-slope / curvature).clamp(-2.0, 2.0) } else { -2.0 * slope.signum() };
            let omega = best.omega + shift * h;
            let value = function.value(linear, omega, k0)?;
            if value < best.value {
                best = Deepest { omega, value };
            }
            if shift.abs() < 1.0 || value > best.value {
                break;
            }
        }
    }
    Ok(best)
}

/// The zeros next to a point where the function is below zero.
fn between_zeros(
    linear: &LinearFloquet,
    function: EdgeFunction,
    centre: f64,
    k0: f64,
    tolerance: f64,
) -> Result<Option<[Edge; 2]>, StudyError> {
    let mut found = [Edge { omega: centre, function }; 2];
    for (edge, direction) in found.iter_mut().zip([-1.0, 1.0]) {
        let mut inside = centre;
        let mut step = 1e-4 * centre;
        let outside = loop {
            let next = inside + direction * step;
            if next <= 0.5 * centre || next >= 1.8 * centre {
                return Err(NumericsError::NoBracket { low: 0.5 * centre, high: 1.8 * centre }.into());
            }
            if edge.function.value(linear, next, k0)? > 0.0 {
                break next;
            }
            inside = next;
            step = (1.5 * step).min(5e-3 * centre);
        };
        edge.omega = zero(linear, edge.function, inside, outside, k0, tolerance)?;
    }
    Ok(Some(found))
}

/// The zero of the function between two frequencies.
pub(super) fn zero(
    linear: &LinearFloquet,
    function: EdgeFunction,
    inside: f64,
    outside: f64,
    k0: f64,
    tolerance: f64,
) -> Result<f64, NumericsError> {
    let mut failed = None;
    let root = bracketed_root(
        |omega| {
            function.value(linear, omega, k0).unwrap_or_else(|error| {
                failed = Some(error);
                f64::NAN
            })
        },
        inside,
        outside,
        0.01 * tolerance * inside,
    );
    failed.map_or(root, Err)
}

mod near {
    //! The interval of instability about or next to a given frequency.

    use super::{
        Edge, EdgeFunction, EdgeKind, Factors, LinearFloquet, NEAR, NumericsError, PI, StudyError,
        linear_floquet, zero,
    };

    /// By how much a modulus must exceed 1 to count. Undamped multipliers that meet on the circle are parted by the
    /// square root of rounding.
    fn slack(linear: &LinearFloquet) -> f64 {
        if linear.undamped() { 3e-6 } else { 1e-11 }
    }

    fn factors(linear: &LinearFloquet, omega: f64, k0: f64) -> Result<Factors, NumericsError> {
        linear_floquet::factors(&linear.characteristic(omega, k0)?)
    }

    fn growth(linear: &LinearFloquet, omega: f64, k0: f64) -> Result<f64, NumericsError> {
        Ok(factors(linear, omega, k0)?.radius() - 1.0 - slack(linear))
    }

    /// A step that neither a multiplier's turn nor a tongue of ordinary width is lost in.
    fn stride(linear: &LinearFloquet, omega: f64) -> f64 {
        let turn: f64 = linear.frequencies().iter().sum();
        (0.1 * omega * omega / (2.0 * PI * turn)).min(1e-3 * omega)
    }

    /// Most steps of the search on each side.
    const MOST: usize = 4000;

    pub(super) fn edges(
        linear: &LinearFloquet,
        omega: f64,
        k0: f64,
        tolerance: f64,
    ) -> Result<Option<[Edge; 2]>, StudyError> {
        if !(0.01..=100.0).contains(&omega) {
            return Err(StudyError::Option {
                option: "tongue",
                given: omega.to_string(),
                allowed: "a mesh frequency from 0.01 to 100".into(),
            });
        }
        let Some(inside) = inside(linear, omega, k0)? else { return Ok(None) };
        let mut found = Vec::with_capacity(2);
        for direction in [-1.0, 1.0] {
            found.push(edge(linear, inside, direction, k0, tolerance)?);
        }
        Ok(Some([found[0], found[1]]))
    }

    /// An unstable frequency: the given one, or the nearest one that the search meets.
    fn inside(linear: &LinearFloquet, omega: f64, k0: f64) -> Result<Option<f64>, NumericsError> {
        if growth(linear, omega, k0)? > 0.0 {
            return Ok(Some(omega));
        }
        let step = stride(linear, omega);
        let count = ((NEAR * omega / step).ceil() as usize).min(MOST);
        // Values of both real functions two and one steps before, on each side.
        let real = [EdgeKind::PeriodDoubling, EdgeKind::PlusOne].map(|kind| EdgeFunction { kind });
        let mut start = [0.0; 2];
        for (value, function) in start.iter_mut().zip(&real) {
            *value = function.value(linear, omega, k0)?;
        }
        let mut before = [[start; 2]; 2];
        for index in 1..=count {
            for (side, direction) in [-1.0, 1.0].into_iter().enumerate() {
                let at = omega + direction * step * index as f64;
                if at <= 0.0 {
                    continue;
                }
                if growth(linear, at, k0)? > 0.0 {
                    return Ok(Some(at));
                }
                for which in 0..2 {
                    let value = real[which].value(linear, at, k0)?;
                    let [far, near] = [before[side][0][which], before[side][1][which]];
                    before[side][0][which] = near;
                    before[side][1][which] = value;
                    let (slope, curvature) = (0.5 * (value - far), value - 2.0 * near + far);
                    if index > 1 && near < far && near <= value && curvature > 0.0 {
                        // A tongue may hide between two steps, where the function dips below zero.
                        let bottom = at - direction * step * (1.0 + slope / curvature);
                        if growth(linear, bottom, k0)? > 0.0 {
                            return Ok(Some(bottom));
                        }
                    }
                }
            }
        }
        Ok(None)
    }

    fn edge(
        linear: &LinearFloquet,
        inside: f64,
        direction: f64,
        k0: f64,
        tolerance: f64,
    ) -> Result<Edge, StudyError> {
        let mut unstable = inside;
        let mut stable = None;
        for _ in 0..MOST {
            let next = unstable + direction * stride(linear, unstable);
            if growth(linear, next, k0)? <= 0.0 {
                stable = Some(next);
                break;
            }
            unstable = next;
        }
        let Some(mut stable) = stable else {
            return Err(
                NumericsError::NoBracket { low: inside.min(unstable), high: inside.max(unstable) }.into()
            );
        };
        let outer = stable;
        while (stable - unstable).abs() > 1e-9 * inside {
            let middle = 0.5 * (stable + unstable);
            if growth(linear, middle, k0)? > 0.0 { unstable = middle } else { stable = middle }
        }
        let at_edge = factors(linear, unstable, k0)?;
        let top = at_edge.top();
        let (p, q) = (at_edge.p[top], at_edge.q[top]);
        let kind = match (0.25 * p * p >= q, p > 0.0) {
            (true, true) => EdgeKind::PeriodDoubling,
            (true, false) => EdgeKind::PlusOne,
            (false, _) => EdgeFunction::pair(linear).kind,
        };
        let function = EdgeFunction { kind };
        // Both sides of the zero, at a distance that its rounding does not blur.
        for distance in [1e-7, 1e-6, 1e-5] {
            let low = unstable - direction * distance * inside;
            let high = stable + direction * (distance * inside).min((outer - stable).abs());
            if function.value(linear, low, k0)? * function.value(linear, high, k0)? < 0.0 {
                let omega = zero(linear, function, low, high, k0, tolerance)?;
                return Ok(Edge { omega, function });
            }
        }
        Ok(Edge { omega: 0.5 * (stable + unstable), function })
    }
}
