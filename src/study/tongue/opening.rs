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
