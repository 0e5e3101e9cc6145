//! Figure 8: how the origin's exponents move as the mesh frequency runs through three tongues.
//!
//! A Floquet exponent `s = ln(multiplier)/T` is given only up to multiples of `i Omega`, and the slow flow's
//! eigenvalues are seen from a turning frame. Both become one picture in a frame that turns with `Omega/2`:
//! `lambda = s - i Omega/2`. There a mode far from any resonance sits at `-d_j +- i (omega_j - Omega/2)`. In its own
//! primary tongue the pair meets on the real axis: a saddle. In the combination tongue, at `Omega = omega_2 + omega_3`,
//! the second mode on its way up meets the third on its way down, and both leave the imaginary direction: a spiral.
//! The slow flow of a primary tongue is in this frame as it stands; that of the combination tongue, in which mode `j`
//! turns at `omega_j Omega/Omega_0`, is shifted by `i (omega_j/Omega_0 - 1/2) Omega`.
//!
//! Exact exponents are folded into the strip `|Im lambda| <= Omega/2`, one representative of each: a mode cannot be
//! followed through all of the range by its name, for where the third mode, folded, meets the second (about
//! `Omega = omega_3 - omega_2`) the two exchange their characters.

use super::compose::even;
use super::job::{Figure, Slices};
use super::tongues::Setting;
use crate::chart::drawing::Role;
use crate::error::FigureError;
use crate::model::parameters::{Parameters, Regime};
use crate::order;
use crate::study::ErrorEstimate;
use crate::study::multipliers::{Multipliers, multipliers};
use crate::theory::modes::Mode;
use crate::theory::{combination, primary};

/// Frequencies at which multipliers are computed before the edges are known.
const COARSE: usize = 300;
/// Frequencies put between two neighbours that differ in stability.
const FINE: usize = 12;
/// Frequencies computed in one slice.
const SLICE: usize = 64;
/// Two neighbours whose real parts differ by more than this, over the widest seen, get [`BETWEEN`] more between them.
const STEEP: f64 = 0.02;
/// See [`STEEP`].
const BETWEEN: usize = 4;
/// How often frequencies are put between such neighbours: where two exponents meet they part like a square root, steeper the nearer.
const ROUNDS: usize = 3;
/// Times an edge is halved.
const HALVINGS: usize = 30;
/// Tolerance of the multipliers.
const TOLERANCE: f64 = 1e-10;
/// Growth rates below this are none: rounding, which a double multiplier takes the square root of.
pub(super) const NO_GROWTH: f64 = 1e-6;

/// An exponent, growth and turn per unit of time.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Exponent {
    /// Growth rate.
    pub(super) re: f64,
    /// Angular frequency in the turning frame.
    pub(super) im: f64,
}

impl Exponent {
    fn distance_squared(self, other: Self) -> f64 {
        (self.re - other.re).powi(2) + (self.im - other.im).powi(2)
    }

    /// As far beyond `self` as `ahead` times the way from `before`.
    fn extrapolated(self, before: Self, ahead: f64) -> Self {
        Self { re: self.re + (self.re - before.re) * ahead, im: self.im + (self.im - before.im) * ahead }
    }
}

/// Exponents at one mesh frequency, in the order of their paths.
pub(super) type Track = (f64, [Exponent; 4]);

/// What kind of point the origin is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// Nothing grows: a centre, with damping a focus.
    Stable,
    /// A real multiplier is largest and beyond the unit circle.
    Saddle,
    /// A complex pair is.
    Spiral,
}

impl Kind {
    fn of(re: &[f64], im: &[f64], period: f64) -> Self {
        let growth = |index: usize| re[index].hypot(im[index]).ln() / period;
        let largest = (0..re.len()).max_by(|&one, &other| growth(one).total_cmp(&growth(other))).unwrap_or(0);
        if growth(largest) <= NO_GROWTH {
            Self::Stable
        } else if im[largest].abs() <= 1e-7 * re[largest].abs() {
            Self::Saddle
        } else {
            Self::Spiral
        }
    }

    pub(super) fn role(self) -> Role {
        match self {
            Self::Stable => Role::IntervalStable,
            Self::Saddle => Role::IntervalSaddle,
            Self::Spiral => Role::IntervalSpiral,
        }
    }

    pub(super) fn with_article(self, damped: bool) -> &'static str {
        match self {
            Self::Stable if damped => "a stable focus",
            Self::Stable => "a centre",
            Self::Saddle => "a saddle",
            Self::Spiral => "an unstable spiral",
        }
    }

    pub(super) fn name(self, damped: bool) -> &'static str {
        match self {
            Self::Stable if damped => "stable focus",
            Self::Stable => "centre",
            Self::Saddle => "saddle",
            Self::Spiral => "unstable spiral",
        }
    }
}

/// The origin at one mesh frequency.
#[derive(Clone, Debug)]
struct Sample {
    omega: f64,
    kind: Kind,
    /// The four exponents of the second and third mode in the frame that turns with `Omega/2`, folded into
    /// `|Im| <= Omega/2`.
    folded: [Exponent; 4],
}

/// The work on figure 8, done in slices.
#[derive(Debug)]
pub(super) struct ExponentPaths {
    pub(super) setting: Setting,
    /// The unloaded gear pair at the reader's frequency.
    parameters: Parameters,
    pub(super) places: [f64; 3],
    pub(super) range: (f64, f64),
    waiting: Vec<f64>,
    samples: Vec<Sample>,
    stage: Stage,
    pub(super) error: ErrorEstimate,
    pub(super) method: String,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Stage {
    Coarse,
    /// Between neighbours that are far apart, so often still.
    Fine(usize),
    Done,
}

impl Slices for ExponentPaths {
    fn advance(&mut self) -> Result<bool, FigureError> {
        for _ in 0..SLICE {
            let Some(omega) = self.waiting.pop() else { break };
            let sample = self.sample(omega)?;
            self.samples.push(sample);
        }
        if self.waiting.is_empty() {
            self.next_stage()?;
        }
        Ok(self.stage == Stage::Done)
    }

    fn figure(&self, id: &'static str, parameters: &Parameters) -> Figure {
        self.picture(id, parameters)
    }
}

impl ExponentPaths {
    /// # Errors
    /// Unequal supports.
    pub(super) fn new(parameters: &Parameters) -> Result<Self, FigureError> {
        let setting = Setting::of(parameters)?;
        let modes = &setting.modes;
        let places = [
            primary::emanating_frequency(modes, Mode::Second),
            combination::emanating_frequency(modes),
            primary::emanating_frequency(modes, Mode::Third),
        ];
        let margin = 0.35 * (places[1] - places[0]);
        let range = ((places[0] - margin).max(0.5 * places[0]), places[2] + margin);
        Ok(Self::over(parameters, setting, places, range, COARSE))
    }

    /// The same over a range of mesh frequencies.
    pub(super) fn over(
        parameters: &Parameters,
        setting: Setting,
        places: [f64; 3],
        range: (f64, f64),
        count: usize,
    ) -> Self {
        let inside = places.into_iter().filter(|place| range.0 < *place && *place < range.1);
        let mut waiting: Vec<f64> = even(range.0, range.1, count).chain(inside).collect();
        if parameters.omega > range.0 && parameters.omega < range.1 {
            waiting.push(parameters.omega);
        }
        // Taken from the end: from low frequencies to high ones.
        order::descending(&mut waiting);
        waiting.dedup();
        let unloaded = Parameters {
            regime: Regime::Homogeneous,
            load: 0.0,
            load_p: 0.0,
            load_g: 0.0,
            error: 0.0,
            ..*parameters
        };
        Self {
            setting,
            parameters: unloaded,
            places,
            range,
            waiting,
            samples: Vec::new(),
            stage: Stage::Coarse,
            error: ErrorEstimate::default(),
            method: String::new(),
        }
    }

    fn next_stage(&mut self) -> Result<(), FigureError> {
        order::by_number(&mut self.samples, |sample| sample.omega);
        match self.stage {
            Stage::Coarse => {
                self.stage = Stage::Fine(ROUNDS);
                for index in 1..self.samples.len() {
                    let (before, after) = (&self.samples[index - 1], &self.samples[index]);
                    if before.kind == after.kind {
                        continue;
                    }
                    let (omega, kind, end) = (before.omega, before.kind, after.omega);
                    let edge = self.edge(omega, kind, end)?;
                    // Roots leave the edge like a square root: crowd the frequencies there.
                    for step in even(0.0, 1.0, FINE).skip(1) {
                        let fraction = step * step;
                        for far in [omega, end] {
                            self.waiting.push(edge + (far - edge) * fraction * 0.98);
                        }
                    }
                }
                self.refine();
            }
            Stage::Fine(left) => {
                self.stage = Stage::Fine(left - 1);
                if left > 1 {
                    self.refine();
                }
            }
            Stage::Done => {}
        }
        order::descending(&mut self.waiting);
        if self.waiting.is_empty() {
            self.stage = Stage::Done;
        }
        Ok(())
    }

    /// Asks for frequencies between neighbours whose exponents are far apart, so that corners are drawn as corners.
    fn refine(&mut self) {
        let tracks = self.tracks();
        let widest = tracks
            .iter()
            .flat_map(|track| track.1)
            .fold(1e-3_f64, |widest, value| widest.max(value.re.abs()));
        for pair in tracks.windows(2) {
            let [(before, old), (after, new)] = [pair[0], pair[1]];
            if (0..4).any(|index| (new[index].re - old[index].re).abs() > STEEP * widest) {
                self.waiting.extend(even(before, after, BETWEEN + 2).skip(1).take(BETWEEN));
            }
        }
    }

    /// Where the kind changes between two frequencies.
    fn edge(&self, mut low: f64, kind: Kind, mut high: f64) -> Result<f64, FigureError> {
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            let at = self.at(middle)?;
            if Kind::of(&at.re, &at.im, std::f64::consts::TAU / middle) == kind {
                low = middle;
            } else {
                high = middle;
            }
            if high - low < 1e-6 * high {
                break;
            }
        }
        Ok(0.5 * (low + high))
    }

    fn at(&self, omega: f64) -> Result<Multipliers, FigureError> {
        let parameters = Parameters { omega, omega_p: omega, omega_g: omega, ..self.parameters };
        Ok(multipliers(&parameters, TOLERANCE)?)
    }

    fn sample(&mut self, omega: f64) -> Result<Sample, FigureError> {
        let answer = self.at(omega)?;
        let worst = |one: Option<f64>, other: Option<f64>| one.into_iter().chain(other).reduce(f64::max);
        self.error = ErrorEstimate {
            liouville: worst(self.error.liouville, answer.error.liouville),
            step: worst(self.error.step, answer.error.step),
            residual: None,
        };
        let period = std::f64::consts::TAU / omega;
        let kind = Kind::of(&answer.re, &answer.im, period);
        let folded = self.relevant(&answer, omega);
        self.method = answer.method;
        Ok(Sample { omega, kind, folded })
    }

    /// The exponents without the pair of the first mode, which the mesh does not touch: its bodies move together.
    fn relevant(&self, answer: &Multipliers, omega: f64) -> [Exponent; 4] {
        let symmetric = &self.setting.symmetric;
        let period = std::f64::consts::TAU / omega;
        let decay = symmetric.zeta_s / symmetric.m;
        let square = symmetric.k / symmetric.m - decay * decay;
        let root = square.abs().sqrt();
        let first_mode = if square > 0.0 {
            [(-decay, root), (-decay, -root)]
        } else {
            [(root - decay, 0.0), (-root - decay, 0.0)]
        };
        let mut values: Vec<(f64, f64)> = answer.re.into_iter().zip(answer.im).collect();
        for (growth, turn) in first_mode {
            let (size, angle) = ((growth * period).exp(), turn * period);
            let distance =
                |value: (f64, f64)| (value.0 - size * angle.cos()).hypot(value.1 - size * angle.sin());
            let nearest =
                (0..values.len()).min_by(|&i, &j| distance(values[i]).total_cmp(&distance(values[j])));
            values.remove(nearest.unwrap_or(0));
        }
        std::array::from_fn(|index| {
            // ln(-mu)/T: a turn by half the mesh frequency makes a multiplier of -1 the exponent zero.
            let (re, im) = (-values[index].0, -values[index].1);
            Exponent { re: re.hypot(im).max(f64::MIN_POSITIVE).ln() / period, im: im.atan2(re) / period }
        })
    }

    /// Frequencies done and those still to be done; none of the latter once all is done.
    pub(super) fn progress(&self) -> (usize, Option<usize>) {
        (self.samples.len(), (self.stage != Stage::Done).then_some(self.waiting.len()))
    }

    /// Each frequency with what the origin is there, rising.
    pub(super) fn kinds(&self) -> Vec<(f64, Kind)> {
        let mut kinds: Vec<(f64, Kind)> =
            self.samples.iter().map(|sample| (sample.omega, sample.kind)).collect();
        order::by_number(&mut kinds, |kind| kind.0);
        kinds
    }

    /// The exponents joined from frequency to frequency, without folds: values may leave the strip.
    pub(super) fn tracks(&self) -> Vec<Track> {
        let mut samples: Vec<&Sample> = self.samples.iter().collect();
        order::by_number(&mut samples, |sample| sample.omega);
        let mut tracks: Vec<Track> = Vec::with_capacity(samples.len());
        for sample in samples {
            let expected = match tracks.len() {
                0 => sample.folded,
                1 => tracks[0].1,
                count => {
                    let ((before, old), (now, new)) = (tracks[count - 2], tracks[count - 1]);
                    let ahead = ((sample.omega - now) / (now - before)).min(1.5);
                    std::array::from_fn(|i| new[i].extrapolated(old[i], ahead))
                }
            };
            tracks.push((sample.omega, matched(sample, &expected)));
        }
        tracks
    }
}

/// The four exponents in the order of those expected, each shifted by whole mesh frequencies to be nearest.
fn matched(sample: &Sample, expected: &[Exponent; 4]) -> [Exponent; 4] {
    let shifted = |value: Exponent, near: Exponent| {
        let turns = ((near.im - value.im) / sample.omega).round();
        Exponent { im: value.im + turns * sample.omega, ..value }
    };
    let mut best = sample.folded;
    let mut least = f64::INFINITY;
    for order in permutations() {
        let candidate: [Exponent; 4] = std::array::from_fn(|i| shifted(sample.folded[order[i]], expected[i]));
        let distance: f64 = (0..4).map(|i| candidate[i].distance_squared(expected[i])).sum();
        if distance < least {
            (best, least) = (candidate, distance);
        }
    }
    best
}

/// All orders of four things.
fn permutations() -> impl Iterator<Item = [usize; 4]> {
    (0..256_usize)
        .map(|code| [code & 3, (code >> 2) & 3, (code >> 4) & 3, (code >> 6) & 3])
        .filter(|order| (0..4).all(|thing| order.contains(&thing)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn there_are_24_orders_of_four_things() {
        assert_eq!(permutations().count(), 24);
    }

    #[test]
    fn multipliers_tell_the_kind() {
        let period = 2.0;
        assert_eq!(Kind::of(&[0.9, -0.5], &[0.0, 0.0], period), Kind::Stable);
        assert_eq!(Kind::of(&[0.9, -1.2], &[0.0, 0.0], period), Kind::Saddle);
        assert_eq!(Kind::of(&[0.9, 0.9, 0.1], &[0.9, -0.9, 0.0], period), Kind::Spiral);
        // Undamped: on the unit circle but for rounding.
        assert_eq!(Kind::of(&[0.6, 0.6], &[0.8 + 1e-10, -0.8], period), Kind::Stable);
    }

    #[test]
    fn exponents_are_matched_across_the_fold() {
        let folded = [1.0, 2.0, -1.5, -0.9].map(|im| Exponent { re: 0.0, im });
        let expected = [-0.95, 1.05, 6.0, 2.45].map(|im| Exponent { re: 0.0, im });
        let sample = Sample { omega: 4.0, kind: Kind::Stable, folded };
        assert_eq!(matched(&sample, &expected).map(|value| value.im), [-0.9, 1.0, 6.0, 2.5]);
    }
}
