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

mod opening {
    //! Where a named tongue has opened by this depth, looked for at one depth after another.

    use super::{EdgeFunction, EdgeKind, Factors, LinearFloquet, NumericsError, PI, linear_floquet};
    use crate::order;

    /// Depths at which the tongue is looked for.
    const LEVELS: usize = 10;
    /// Least and greatest number of frequencies at one depth.
    const SAMPLES: (f64, f64) = (48.0, 320.0);
    /// Distance of frequencies over the tongue's half-width.
    const SPACING: f64 = 0.15;

    /// What two moduli may differ by without damping, where all are 1.
    const NOISE: f64 = 1e-9;

    /// Greatest modulus of a multiplier of the kind that the function is about; 0 where there is none.
    fn growth(factors: &Factors, kind: EdgeKind) -> f64 {
        (0..factors.count).fold(0.0_f64, |most, i| {
            let (half, q) = (-0.5 * factors.p[i], factors.q[i]);
            let square = half * half - q;
            let pair = matches!(kind, EdgeKind::NeimarkSacker | EdgeKind::Krein);
            if square < 0.0 || pair {
                return if square < 0.0 && pair { most.max(q.sqrt()) } else { most };
            }
            let large = half + square.sqrt().copysign(half);
            let small = if large == 0.0 { 0.0 } else { q / large };
            let sign = if kind == EdgeKind::PeriodDoubling { -1.0 } else { 1.0 };
            most.max(sign * large).max(sign * small)
        })
    }

    /// Frequencies next to each other at which there is growth.
    #[derive(Clone, Copy)]
    struct Run {
        low: f64,
        high: f64,
        /// Where it grows most.
        top: f64,
        growth: f64,
    }

    struct Search<'a> {
        linear: &'a LinearFloquet,
        function: EdgeFunction,
        /// What must be exceeded to count as growth.
        threshold: f64,
    }

    impl Search<'_> {
        fn growth(&self, omega: f64, k0: f64) -> Result<f64, NumericsError> {
            let of = self.linear.characteristic(omega, k0)?;
            Ok(growth(&linear_floquet::factors(&of)?, self.function.kind))
        }

        /// The run nearest to `middle` within a window.
        fn nearest(
            &self,
            [low, high]: [f64; 2],
            middle: f64,
            k0: f64,
            spacing: f64,
        ) -> Result<Option<Run>, NumericsError> {
            let count = ((high - low) / spacing).clamp(SAMPLES.0, SAMPLES.1).ceil();
            let step = (high - low) / count;
            let mut values = Vec::with_capacity(count as usize + 1);
            for index in 0..=count as usize {
                let omega = low + step * index as f64;
                values.push((omega, if omega > 0.0 { self.growth(omega, k0)? } else { 0.0 }));
            }
            // A tongue that has just opened may be narrower than the spacing: the greatest values between are looked for.
            let mut peaks = Vec::new();
            for three in values.windows(3) {
                let [left, here, right] = [three[0].1, three[1].1, three[2].1];
                if here <= self.threshold && here > left.max(right) + NOISE {
                    let peak = self.peak(three[1], step, k0)?;
                    if peak.1 > self.threshold {
                        peaks.push(peak);
                    }
                }
            }
            values.extend(peaks);
            order::by_number(&mut values, |value| value.0);
            let mut runs: Vec<Run> = Vec::new();
            let mut continues = false;
            for (omega, growth) in values {
                if growth <= self.threshold {
                    continues = false;
                    continue;
                }
                match runs.last_mut().filter(|_| continues) {
                    Some(run) => {
                        run.high = omega;
                        if growth > run.growth {
                            (run.top, run.growth) = (omega, growth);
                        }
                    }
                    None => runs.push(Run { low: omega, high: omega, top: omega, growth }),
                }
                continues = true;
            }
            let distance = |run: &Run| (run.low - middle).max(middle - run.high).max(0.0);
            Ok(runs.into_iter().min_by(|left, right| distance(left).total_cmp(&distance(right))))
        }

        /// The greatest growth next to a sample that exceeds its neighbours, by golden section.
        fn peak(&self, around: (f64, f64), step: f64, k0: f64) -> Result<(f64, f64), NumericsError> {
            const GOLDEN: f64 = 0.618_033_988_749_895;
            let (mut low, mut high) = (around.0 - step, around.0 + step);
            let mut best = around;
            for _ in 0..24 {
                let length = high - low;
                let (left, right) = (high - GOLDEN * length, low + GOLDEN * length);
                let (at_left, at_right) = (self.growth(left, k0)?, self.growth(right, k0)?);
                for here in [(left, at_left), (right, at_right)] {
                    if here.1 > best.1 {
                        best = here;
                    }
                }
                if best.1 > self.threshold {
                    break;
                }
                if at_left > at_right { high = right } else { low = left }
            }
            Ok(best)
        }
    }

    /// A frequency within the tongue that opened nearest to its `origin`; none where it is closed at this depth.
    ///
    /// `width` is its half-width over k0 to first order. The tongue is recognised where it opens, and from there upwards
    /// as what continues it.
    pub(super) fn inside(
        linear: &LinearFloquet,
        function: EdgeFunction,
        origin: f64,
        width: f64,
        k0: f64,
    ) -> Result<Option<f64>, NumericsError> {
        // Two multipliers that damping has parted little know each other's rounding over their distance.
        let decay = linear.damping_trace() * 2.0 * PI / origin;
        let slack = if linear.undamped() { 3e-6 } else { (3e-13 / decay).clamp(1e-11, 3e-6) };
        let threshold = 1.0 + slack;
        let search = Search { linear, function, threshold };
        let mut before: Option<Run> = None;
        for level in 1..=LEVELS {
            let depth = k0 * level as f64 / LEVELS as f64;
            let spacing = SPACING * width * depth;
            let run = match before {
                None => {
                    let reach = 2.5 * width * depth + origin * depth * (0.02 + 0.15 * depth);
                    search.nearest([origin - reach, origin + reach], origin, depth, spacing)?
                }
                Some(run) => {
                    let reach = (run.high - run.low).max(1e-3 * origin);
                    let middle = 0.5 * (run.low + run.high);
                    search.nearest([run.low - reach, run.high + reach], middle, depth, spacing)?
                }
            };
            before = run;
        }
        let Some(run) = before else { return Ok(None) };
        // The function is below zero in the tongue except where another one overlaps it.
        for share in [None, Some(0.5), Some(0.25), Some(0.75), Some(0.1), Some(0.9)] {
            let omega = share.map_or(run.top, |share| run.low + share * (run.high - run.low));
            if function.value(linear, omega, k0)? < 0.0 {
                return Ok(Some(omega));
            }
        }
        Ok(None)
    }
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
        let kinds = [EdgeKind::PeriodDoubling, EdgeKind::PlusOne, EdgeFunction::pair(linear).kind];
        let functions = kinds.map(|kind| EdgeFunction { kind });
        let start = linear.characteristic(omega, k0)?;
        // Values of the functions two and one steps before, on each side.
        let mut before = [[functions.map(|function| function.of(&start)); 2]; 2];
        for index in 1..=count {
            for (side, direction) in [-1.0, 1.0].into_iter().enumerate() {
                let at = omega + direction * step * index as f64;
                if at <= 0.0 {
                    continue;
                }
                let here = linear.characteristic(at, k0)?;
                if linear_floquet::factors(&here)?.radius() - 1.0 > slack(linear) {
                    return Ok(Some(at));
                }
                for (which, function) in functions.iter().enumerate() {
                    let value = function.of(&here);
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
