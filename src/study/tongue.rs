//! The exact edges of a tongue at a given depth of the pulsation.
//!
//! A named tongue is followed from `k0 = 0`: the deepest point of its function ([`EdgeFunction`]) along Omega starts at
//! twice a natural frequency, or at the sum of two, and moves smoothly with `k0^2`. Below zero there the tongue is open, and
//! its edges are the next zeros on both sides.

mod near;
mod opening;

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
    let (origin, function) = origin(linear, tongue);
    let centre = match follow_centre(linear, tongue, k0)? {
        Followed { centre, lost: false } => centre,
        Followed { centre, lost: true } => {
            let width = tongue_width(linear, tongue);
            // Where even that finds none because others overlap it, what following came to is the best there is.
            opening::inside(linear, function, origin, width, k0)?.or(centre)
        }
    };
    let Some(centre) = centre else { return Ok(None) };
    between_zeros(linear, function, centre, k0, tolerance)
}

/// Half-width of a named tongue over k0, for small k0 and without damping, \[T3\] and \[T4\] for any supports.
fn tongue_width(linear: &LinearFloquet, tongue: Tongue) -> f64 {
    let frequencies = linear.frequencies();
    let last = frequencies.len() - 1;
    let [first, second] = match tongue {
        Tongue::Primary2 => [0, 0],
        Tongue::Primary3 => [last, last],
        Tongue::Combination | Tongue::Near(_) => [0, last],
    };
    let share = |mode: usize| linear.participation(frequencies[mode]);
    let product = frequencies[first] * frequencies[second];
    0.5 * (share(first) * share(second) / product).sqrt()
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

/// How far from where it is expected the middle may be found at the next depth, relative to it.
const STRAYS: f64 = 0.015;

/// What following the middle of a named tongue came to.
struct Followed {
    /// The middle, if the tongue is open there.
    centre: Option<f64>,
    /// There was no middle to be followed all the way.
    lost: bool,
}

/// Follows the deepest point of a named tongue to this depth.
fn follow_centre(linear: &LinearFloquet, tongue: Tongue, k0: f64) -> Result<Followed, NumericsError> {
    let (mut centre, function) = origin(linear, tongue);
    if k0 == 0.0 {
        return Ok(Followed { centre: None, lost: false });
    }
    let mut lost = false;
    let origin_at = centre;
    let count = (k0 / K0_STEP).ceil();
    let mut before = centre;
    let mut deepest = Deepest { omega: centre, value: f64::INFINITY, settled: false };
    for index in 0..=count as usize {
        let depth = k0 * index as f64 / count;
        let last = index as f64 == count;
        let widths: &[f64] = if last { &[0.01, 1e-3, 1e-4] } else { &[0.01] };
        let guess = if index < 3 { centre } else { 2.0 * centre - before };
        deepest = minimise(linear, function, guess, depth, widths)?;
        lost |= !deepest.settled || (deepest.omega - guess).abs() > STRAYS * guess;
        before = centre;
        centre = deepest.omega;
    }
    let open = deepest.value < 0.0;
    let here = open && is_this_instability(linear, function, origin_at, centre, k0)?;
    Ok(Followed { centre: here.then_some(centre), lost: lost || open != here })
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
    /// It is a minimum, within reach of the last step.
    settled: bool,
}

/// A local minimum along Omega by parabolas through three points, whose distance shrinks.
fn minimise(
    linear: &LinearFloquet,
    function: EdgeFunction,
    start: f64,
    k0: f64,
    widths: &[f64],
) -> Result<Deepest, NumericsError> {
    let mut best = Deepest { omega: start, value: function.value(linear, start, k0)?, settled: false };
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
            let settled = curvature > 0.0 && shift.abs() < 1.0;
            best.settled = settled;
            if value < best.value {
                best = Deepest { omega, value, settled };
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
