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

use super::compose::{Composer, Line, Points, axis, even, number, plane};
use super::job::Figure;
use super::tongues::{Setting, split};
use crate::chart::drawing::{Drawing, Frame, Mark, Role};
use crate::error::FigureError;
use crate::model::parameters::{Parameters, Regime};
use crate::study::ErrorEstimate;
use crate::study::multipliers::{Multipliers, multipliers};
use crate::theory::damped::{
    combination_edges, combination_exponents, decay_rate, primary_edges, primary_exponents,
};
use crate::theory::modes::Mode;
use crate::theory::tongues::Edges;
use crate::theory::{combination, primary};

type Complex = nalgebra::Complex<f64>;

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
/// Times an edge is halved.
const HALVINGS: usize = 30;
/// Tolerance of the multipliers.
const TOLERANCE: f64 = 1e-10;
/// Growth rates below this are none: rounding, which a double multiplier takes the square root of.
const NO_GROWTH: f64 = 1e-6;

/// What kind of point the origin is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
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

    fn role(self) -> Role {
        match self {
            Self::Stable => Role::IntervalStable,
            Self::Saddle => Role::IntervalSaddle,
            Self::Spiral => Role::IntervalSpiral,
        }
    }

    fn with_article(self, damped: bool) -> &'static str {
        match self {
            Self::Stable if damped => "a stable focus",
            Self::Stable => "a centre",
            Self::Saddle => "a saddle",
            Self::Spiral => "an unstable spiral",
        }
    }

    fn name(self, damped: bool) -> &'static str {
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
    folded: [Complex; 4],
}

/// The work on figure 8, done in slices.
#[derive(Debug)]
pub(super) struct ExponentPaths {
    setting: Setting,
    /// The unloaded gear pair at the reader's frequency.
    parameters: Parameters,
    places: [f64; 3],
    range: (f64, f64),
    waiting: Vec<f64>,
    samples: Vec<Sample>,
    stage: Stage,
    error: ErrorEstimate,
    method: String,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Stage {
    Coarse,
    Fine,
    Done,
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
        let mut waiting: Vec<f64> = even(range.0, range.1, COARSE).chain(places).collect();
        if parameters.omega > range.0 && parameters.omega < range.1 {
            waiting.push(parameters.omega);
        }
        // Taken from the end: from low frequencies to high ones.
        waiting.sort_by(|one, other| other.total_cmp(one));
        waiting.dedup();
        let unloaded = Parameters {
            regime: Regime::Homogeneous,
            load: 0.0,
            load_p: 0.0,
            load_g: 0.0,
            error: 0.0,
            ..*parameters
        };
        Ok(Self {
            setting,
            parameters: unloaded,
            places,
            range,
            waiting,
            samples: Vec::new(),
            stage: Stage::Coarse,
            error: ErrorEstimate::default(),
            method: String::new(),
        })
    }

    pub(super) fn advance(&mut self) -> Result<bool, FigureError> {
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

    fn next_stage(&mut self) -> Result<(), FigureError> {
        self.samples.sort_by(|one, other| one.omega.total_cmp(&other.omega));
        match self.stage {
            Stage::Coarse => {
                self.stage = Stage::Fine;
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
                self.waiting.sort_by(|one, other| other.total_cmp(one));
                if self.waiting.is_empty() {
                    self.stage = Stage::Done;
                }
            }
            Stage::Fine | Stage::Done => self.stage = Stage::Done,
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
    fn relevant(&self, answer: &Multipliers, omega: f64) -> [Complex; 4] {
        let symmetric = &self.setting.symmetric;
        let period = std::f64::consts::TAU / omega;
        let decay = symmetric.zeta_s / symmetric.m;
        let root = Complex::new(decay * decay - symmetric.k / symmetric.m, 0.0).sqrt();
        let mut values: Vec<Complex> = (0..6).map(|i| Complex::new(answer.re[i], answer.im[i])).collect();
        for exponent in [root - decay, -root - decay] {
            let multiplier = (exponent * period).exp();
            let nearest = (0..values.len())
                .min_by(|&i, &j| (values[i] - multiplier).norm().total_cmp(&(values[j] - multiplier).norm()));
            values.remove(nearest.unwrap_or(0));
        }
        std::array::from_fn(|index| {
            // ln(-mu)/T: a turn by half the mesh frequency makes a multiplier of -1 the exponent zero.
            let turned = -values[index];
            let growth = turned.norm().max(f64::MIN_POSITIVE).ln();
            Complex::new(growth, turned.im.atan2(turned.re)) / period
        })
    }

    /// The exponents joined from frequency to frequency, without folds: values may leave the strip.
    fn tracks(&self) -> Vec<(f64, [Complex; 4])> {
        let mut samples: Vec<&Sample> = self.samples.iter().collect();
        samples.sort_by(|one, other| one.omega.total_cmp(&other.omega));
        let mut tracks: Vec<(f64, [Complex; 4])> = Vec::with_capacity(samples.len());
        for sample in samples {
            let expected = match tracks.len() {
                0 => sample.folded,
                1 => tracks[0].1,
                count => {
                    let ((before, old), (now, new)) = (tracks[count - 2], tracks[count - 1]);
                    let ahead = ((sample.omega - now) / (now - before)).min(1.5);
                    std::array::from_fn(|i| new[i] + (new[i] - old[i]) * ahead)
                }
            };
            tracks.push((sample.omega, matched(sample, &expected)));
        }
        tracks
    }

    /// The picture so far.
    pub(super) fn figure(&self, id: &'static str, parameters: &Parameters) -> Figure {
        let tracks = self.tracks();
        let mut notes = Vec::new();
        let inside = parameters.omega > self.range.0 && parameters.omega < self.range.1;
        if !inside {
            notes.push(format!(
                "The present Omega = {} lies outside of what is drawn.",
                number(parameters.omega, 4)
            ));
        }
        if parameters.load != 0.0 {
            notes.push(
                "The load does not matter here: it is the unloaded state whose stability is asked.".into(),
            );
        }
        if self.stage != Stage::Done {
            notes.push(format!("{} frequencies computed, {} to go.", self.samples.len(), self.waiting.len()));
        }
        Figure {
            id,
            parameters: *parameters,
            drawing: self.drawing(&tracks, parameters.omega),
            summary: self.summary(parameters.omega),
            method: format!("exact: {}; slow flow: closed formulas [T5], [T6]", self.method),
            error: self.error,
            motion: None,
            notes,
        }
    }

    fn damped(&self) -> bool {
        self.setting.symmetric.zeta > 0.0 || self.setting.symmetric.zeta_s > 0.0
    }

    /// The samples joined to intervals of one kind: low end, high end, kind.
    fn intervals(&self) -> Vec<(f64, f64, Kind)> {
        let mut samples: Vec<(f64, Kind)> =
            self.samples.iter().map(|sample| (sample.omega, sample.kind)).collect();
        samples.sort_by(|one, other| one.0.total_cmp(&other.0));
        let mut intervals: Vec<(f64, f64, Kind)> = Vec::new();
        for (omega, kind) in samples {
            match intervals.last_mut() {
                Some(last) if last.2 == kind => last.1 = omega,
                Some(last) => {
                    let border = 0.5 * (last.1 + omega);
                    last.1 = border;
                    intervals.push((border, omega, kind));
                }
                None => intervals.push((omega, omega, kind)),
            }
        }
        intervals
    }

    fn summary(&self, omega: f64) -> String {
        let intervals = self.intervals();
        let unstable: Vec<String> = intervals
            .iter()
            .filter(|interval| interval.2 != Kind::Stable)
            .map(|(low, high, kind)| {
                format!(
                    "{} from {} to {}",
                    kind.with_article(self.damped()),
                    number(*low, 5),
                    number(*high, 5)
                )
            })
            .collect();
        let at_present =
            intervals.iter().find(|(low, high, _)| *low <= omega && omega <= *high).map(|interval| {
                format!("at Omega = {} it is {}", number(omega, 5), interval.2.with_article(self.damped()))
            });
        let all = if unstable.is_empty() {
            "Along Omega the origin is stable everywhere".to_owned()
        } else {
            format!("Along Omega the origin is {}, and stable elsewhere", unstable.join(", "))
        };
        match at_present {
            Some(present) => format!("{all}; {present}."),
            None => format!("{all}."),
        }
    }

    fn drawing(&self, tracks: &[(f64, [Complex; 4])], omega: f64) -> Drawing {
        let mut composer = Composer::new((2, 3));
        let [second, middle, third] = self.places;
        let (re, im) = self.reach(tracks);
        for (column, (name, title, ends)) in [
            ("lower", "(a) second mode to combination", (second, middle)),
            ("upper", "(b) combination to third mode", (middle, third)),
        ]
        .into_iter()
        .enumerate()
        {
            let frame = composer.frame(Frame {
                span: (1, 2),
                ..plane(
                    name,
                    title,
                    (column, 0),
                    axis("Re lambda", "Re *λ*", (-re, 0.6 * re)),
                    axis("Im lambda", "Im *λ*", (-im, im)),
                )
            });
            let zero = Line::new(format!("zero {name}"), "where growth turns into decay", Role::Reference);
            composer.curve(frame, zero, Points::plane([(0.0, -im), (0.0, im)]));
            self.slow_flow(&mut composer, frame, name, column == 0, ends);
            Self::exact(&mut composer, frame, name, tracks, ends);
            let here = if column == 0 { omega <= middle } else { omega > middle };
            if let Some(track) = tracks.iter().find(|track| track.0 == omega && here) {
                let line = Line::new("present exponents", "the exponents at the present Omega", Role::Handle);
                let folded = |value: Complex| (value.re, value.im - (value.im / omega).round() * omega);
                composer.marks(frame, line, Points::plane(track.1.map(folded)));
            }
        }
        self.scale(&mut composer, omega);
        composer.drawing()
    }

    fn reach(&self, tracks: &[(f64, [Complex; 4])]) -> (f64, f64) {
        let modes = &self.setting.modes;
        let growth = Mode::BOTH.map(|mode| {
            0.5 * self.setting.symmetric.k0 * primary::half_width(modes, mode)
                + decay_rate(modes, mode, self.setting.symmetric.zeta, self.setting.symmetric.zeta_s)
        });
        let inside = |omega: f64| omega >= self.places[0] && omega <= self.places[2];
        let seen = tracks.iter().filter(|track| inside(track.0)).flat_map(|track| track.1);
        let re = seen.fold(growth[0].max(growth[1]).max(1e-3), |reach, value| reach.max(value.re.abs()));
        (1.15 * re, 1.1 * (modes.omega[2] - modes.omega[1]))
    }

    fn exact(
        composer: &mut Composer,
        frame: usize,
        name: &str,
        tracks: &[(f64, [Complex; 4])],
        ends: (f64, f64),
    ) {
        let within: Vec<(f64, [Complex; 4])> =
            tracks.iter().filter(|track| track.0 >= ends.0 && track.0 <= ends.1).copied().collect();
        for index in 0..4 {
            // A number that is none parts the curve where the fold takes it to the strip's other edge.
            let mut points: Vec<(f64, f64)> = Vec::new();
            let mut fold = None;
            for (omega, values) in &within {
                let value = values[index];
                let turns = (value.im / omega).round();
                if fold.is_some_and(|before| before != turns) {
                    points.push((f64::NEG_INFINITY, f64::NAN));
                }
                fold = Some(turns);
                points.push((value.re, value.im - turns * omega));
            }
            let [decaying, growing] = split(&points, |at| points[at].0 <= NO_GROWTH);
            for (points, stable, word) in [(decaying, true, "decaying"), (growing, false, "growing")] {
                let line = Line::new(
                    format!("exact {} {name} {word}", index + 1),
                    format!("exact exponent {}, {word}", index + 1),
                    Role::Exact,
                )
                .stable(stable);
                let label = index == 2 && stable;
                composer.curve(frame, if label { line.label("exact", 0.5) } else { line }, points);
            }
        }
    }

    fn slow_flow(
        &self,
        composer: &mut Composer,
        frame: usize,
        name: &str,
        lower: bool,
        (low, high): (f64, f64),
    ) {
        let middle = 0.5 * (low + high);
        let (mode, own, other) = if lower {
            (Mode::Second, (low, middle), (middle, high))
        } else {
            (Mode::Third, (middle, high), (low, middle))
        };
        let primary =
            |omega: f64| primary_exponents(&self.setting.at(omega), mode).map(|values| values.to_vec());
        let omega_0 = self.places[1];
        let slower = self.setting.modes.omega[1] / omega_0 - 0.5;
        let combination = |omega: f64| {
            let shift = Complex::new(0.0, slower * omega);
            combination_exponents(&self.setting.at(omega)).map(|values| {
                vec![values[0] + shift, values[1] + shift, values[2] - shift, values[3] - shift]
            })
        };
        let edges = |edges: Option<Edges>| edges.map_or_else(Vec::new, |edges| vec![edges.left, edges.right]);
        let (modes, symmetric) = (&self.setting.modes, &self.setting.symmetric);
        Self::flow_curves(
            composer,
            frame,
            &format!("primary {name}"),
            "damped [T5]",
            own,
            &edges(primary_edges(modes, mode, symmetric)),
            &primary,
        );
        Self::flow_curves(
            composer,
            frame,
            &format!("combination {name}"),
            "damped [T6]",
            other,
            &edges(combination_edges(modes, symmetric)),
            &combination,
        );
    }

    #[allow(clippy::too_many_arguments, reason = "one call draws one flow, all of which it needs")]
    fn flow_curves<E>(
        composer: &mut Composer,
        frame: usize,
        name: &str,
        label: &str,
        (low, high): (f64, f64),
        edges: &[f64],
        exponents: &dyn Fn(f64) -> Result<Vec<Complex>, E>,
    ) {
        let mut frequencies: Vec<f64> = even(low, high, 160).collect();
        for edge in edges.iter().filter(|edge| low < **edge && **edge < high) {
            frequencies.extend((0..9).map(|n| edge + (high - low) * 1e-3 * f64::from(n - 4)));
        }
        frequencies.sort_by(f64::total_cmp);
        let values: Vec<Vec<Complex>> =
            frequencies.into_iter().filter_map(|omega| exponents(omega).ok()).collect();
        for index in 0..values.first().map_or(0, Vec::len) {
            let points: Vec<(f64, f64)> = values.iter().map(|all| (all[index].re, all[index].im)).collect();
            let [decaying, growing] = split(&points, |at| points[at].0 <= NO_GROWTH);
            for (points, stable, word) in [(decaying, true, "decaying"), (growing, false, "growing")] {
                let line = Line::new(
                    format!("slow flow {} {name} {word}", index + 1),
                    format!("eigenvalue {} of the slow flow, {word}, {label}", index + 1),
                    Role::CorrectedSecond,
                )
                .stable(stable);
                composer.curve(
                    frame,
                    if index == 0 && !stable { line.label(label, 0.5) } else { line },
                    points,
                );
            }
        }
    }

    /// Panel (c): what the origin is along the mesh frequency.
    fn scale(&self, composer: &mut Composer, omega: f64) {
        let (low, high) = self.range;
        let width = high - low;
        let frame = composer.frame(Frame {
            span: (2, 1),
            bare: true,
            ..plane(
                "kinds",
                "(c) the origin along *Ω*",
                (0, 2),
                axis("Omega", "*Ω*", (low - 0.2 * width, high + 0.02 * width)),
                axis("row", "", (-0.75, 3.75)),
            )
        });
        let (modes, symmetric) = (&self.setting.modes, &self.setting.symmetric);
        let k0 = symmetric.k0;
        let printed = [
            (self.places[0], primary::half_width(modes, Mode::Second), Kind::Saddle),
            (self.places[1], combination::half_width_printed(modes), Kind::Spiral),
            (self.places[2], primary::half_width(modes, Mode::Third), Kind::Saddle),
        ]
        .map(|(centre, half, kind)| (Some(Edges::about(centre, k0 * half)).filter(|_| k0 > 0.0), kind));
        let damped = [
            (primary_edges(modes, Mode::Second, symmetric), Kind::Saddle),
            (combination_edges(modes, symmetric), Kind::Spiral),
            (primary_edges(modes, Mode::Third, symmetric), Kind::Saddle),
        ];
        let rows = [
            ("paper", "paper", false, self.filled(printed)),
            ("first order damped", "damped [T5], [T6]", self.damped(), self.filled(damped)),
            ("exact", "exact (Floquet)", self.damped(), self.intervals()),
        ];
        for (row, (name, words, damped, intervals)) in rows.into_iter().enumerate() {
            let height = row as f64;
            for (index, (from, to, kind)) in intervals.into_iter().filter(|i| i.1 > i.0).enumerate() {
                let meaning =
                    format!("{}: {} from {} to {}", words, kind.name(damped), number(from, 5), number(to, 5));
                let line = Line::new(format!("kind {name} {}", index + 1), meaning, kind.role())
                    .stable(kind == Kind::Stable);
                composer.add(
                    frame,
                    Mark::Band,
                    line,
                    Points::plane([(from, height - 0.3), (to, height + 0.3)]),
                );
            }
            composer.text(frame, &format!("row {name}"), words, (low - 0.1 * width, height));
        }
        for (place, words) in self.places.into_iter().zip(["saddle", "unstable spiral", "saddle"]) {
            composer.text(frame, &format!("kind at {}", number(place, 4)), words, (place, 2.62));
        }
        for (index, pair) in self.places.windows(2).enumerate() {
            let words = Kind::Stable.name(self.damped());
            composer.text(
                frame,
                &format!("kind between {}", index + 1),
                words,
                (0.5 * (pair[0] + pair[1]), 2.62),
            );
        }
        if omega > low && omega < high {
            let line = Line::new("present Omega", "the present Omega", Role::Handle);
            composer.curve(frame, line, Points::plane([(omega, -0.45), (omega, 3.0)]));
            let words = format!("*Ω* = {}", number(omega, 4));
            composer.text(frame, "present Omega in words", &words, (omega, 3.35));
        }
        let mut ticks = Points::plane([(low, -0.45), (high, -0.45)]);
        for tick in round_numbers(low, high) {
            ticks.piece([(tick, -0.45), (tick, -0.38)]);
            composer.text(frame, &format!("tick {}", number(tick, 6)), &number(tick, 6), (tick, -0.62));
        }
        composer.curve(frame, Line::new("scale", "the mesh frequency", Role::Reference), ticks);
    }

    /// Intervals of first-order tongues, with what is stable between them.
    fn filled(&self, tongues: [(Option<Edges>, Kind); 3]) -> Vec<(f64, f64, Kind)> {
        let (low, high) = self.range;
        let mut intervals = Vec::new();
        let mut reached = low;
        for (edges, kind) in tongues {
            let Some(edges) = edges else { continue };
            let (left, right) = (edges.left.clamp(reached, high), edges.right.clamp(reached, high));
            intervals.extend([(reached, left, Kind::Stable), (left, right, kind)]);
            reached = right;
        }
        intervals.push((reached, high, Kind::Stable));
        intervals
    }
}

/// The four exponents in the order of those expected, each shifted by whole mesh frequencies to be nearest.
fn matched(sample: &Sample, expected: &[Complex; 4]) -> [Complex; 4] {
    let shifted = |value: Complex, near: Complex| {
        let turns = ((near.im - value.im) / sample.omega).round();
        Complex::new(value.re, value.im + turns * sample.omega)
    };
    let mut best = sample.folded;
    let mut least = f64::INFINITY;
    for order in permutations() {
        let candidate: [Complex; 4] = std::array::from_fn(|i| shifted(sample.folded[order[i]], expected[i]));
        let distance: f64 = (0..4).map(|i| (candidate[i] - expected[i]).norm_sqr()).sum();
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

/// Round numbers between two ends, four to nine of them.
fn round_numbers(low: f64, high: f64) -> Vec<f64> {
    let rough = (high - low) / 6.0;
    let power = 10_f64.powf(rough.log10().floor());
    let step = [1.0, 2.0, 5.0, 10.0]
        .into_iter()
        .map(|digit| digit * power)
        .find(|step| *step >= rough)
        .unwrap_or(rough);
    let first = (low / step).ceil() as i64;
    (0..12).map(|n| (first + n) as f64 * step).take_while(|tick| *tick <= high).collect()
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
        let folded = [1.0, 2.0, -1.5, -0.9].map(|im| Complex::new(0.0, im));
        let expected = [-0.95, 1.05, 6.0, 2.45].map(|im| Complex::new(0.0, im));
        let sample = Sample { omega: 4.0, kind: Kind::Stable, folded };
        assert_eq!(matched(&sample, &expected).map(|value| value.im), [-0.9, 1.0, 6.0, 2.5]);
    }
}
