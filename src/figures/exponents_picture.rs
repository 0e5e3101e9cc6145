//! Figure 8 as a picture: paths of the exponents, the slow flow beside them, and what the origin is along `Omega`.

use super::beside::Told;
use super::compose::{Composer, Line, Points, axis, even, number, plane};
use super::exponents::{Exponent, ExponentPaths, Kind, NO_GROWTH, Track};
use super::job::{Distance, Figure};
use super::tongues::split;
use crate::chart::drawing::{Drawing, Frame, Mark, Role};
use crate::model::parameters::Parameters;
use crate::order;
use crate::theory::damped::{
    combination_edges, combination_exponents, decay_rate, primary_edges, primary_exponents,
};
use crate::theory::modes::Mode;
use crate::theory::tongues::Edges;
use crate::theory::{combination, primary};

/// What an exponent on the strip's edge may be beyond it, in mesh frequencies.
const ROUNDING: f64 = 1e-6;

impl ExponentPaths {
    /// The picture so far.
    pub(super) fn picture(&self, id: &'static str, parameters: &Parameters) -> Figure {
        let tracks = self.tracks();
        let mut told = Told::default();
        let notes = &mut told.notes;
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
        if let (done, Some(left)) = self.progress() {
            notes.push(format!("{done} frequencies computed, {left} to go."));
        } else {
            self.edges_apart(&mut told);
        }
        let mut figure = Figure {
            summary: self.summary(parameters.omega),
            method: format!("exact: {}; slow flow: closed formulas [T5], [T6]", self.method),
            error: self.error,
            ..Figure::drawn(id, parameters, self.drawing(&tracks, parameters.omega))
        };
        told.onto(&mut figure);
        figure
    }

    /// The distance of the first-order edges from the exact ones between which they lie.
    fn edges_apart(&self, told: &mut Told) {
        let (modes, symmetric) = (&self.setting.modes, &self.setting.symmetric);
        let exact = self.intervals();
        let formulas = [
            ("second mode [T5]", primary_edges(modes, Mode::Second, symmetric)),
            ("combination [T6]", combination_edges(modes, symmetric)),
            ("third mode [T5]", primary_edges(modes, Mode::Third, symmetric)),
        ];
        for ((name, edges), place) in formulas.into_iter().zip(self.places) {
            let Some(edges) = edges else { continue };
            let found = exact.iter().find(|(left, right, kind)| {
                *kind != Kind::Stable && *left < edges.right.max(place) && *right > edges.left.min(place)
            });
            let Some((left, right, _)) = found else { continue };
            told.notes.push(format!(
                "Edges of the {name}: exact {} and {}, the formula is off by {} and {}.",
                number(*left, 6),
                number(*right, 6),
                number(edges.left - left, 2),
                number(edges.right - right, 2)
            ));
            for (side, theory, exact) in [("left", edges.left, *left), ("right", edges.right, *right)] {
                let what = format!("Omega of the {side} edge, {name}");
                told.distances.push(Distance { what, at: None, theory, exact });
            }
        }
    }

    fn damped(&self) -> bool {
        self.setting.symmetric.zeta > 0.0 || self.setting.symmetric.zeta_s > 0.0
    }

    /// The samples joined to intervals of one kind: low end, high end, kind.
    fn intervals(&self) -> Vec<(f64, f64, Kind)> {
        let mut intervals: Vec<(f64, f64, Kind)> = Vec::new();
        for (omega, kind) in self.kinds() {
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

    fn drawing(&self, tracks: &[Track], omega: f64) -> Drawing {
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
                    axis("Re lambda", "Re *λ*", re),
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
                let folded = |value: Exponent| (value.re, value.im - (value.im / omega).round() * omega);
                composer.marks(frame, line, Points::plane(track.1.map(folded)));
            }
        }
        self.scale(&mut composer, omega);
        composer.drawing()
    }

    /// Ends of the real axis, and half the height of the imaginary one.
    fn reach(&self, tracks: &[Track]) -> ((f64, f64), f64) {
        let (modes, symmetric) = (&self.setting.modes, &self.setting.symmetric);
        let mut re = (-1e-3_f64, 1e-3_f64);
        for mode in Mode::BOTH {
            let drive = 0.5 * symmetric.k0 * primary::half_width(modes, mode);
            let decay = decay_rate(modes, mode, symmetric.zeta, symmetric.zeta_s);
            re = (re.0.min(-decay - drive), re.1.max(drive - decay));
        }
        let inside = |omega: f64| omega >= self.places[0] && omega <= self.places[2];
        for value in tracks.iter().filter(|track| inside(track.0)).flat_map(|track| track.1) {
            re = (re.0.min(value.re), re.1.max(value.re));
        }
        let margin = 0.12 * (re.1 - re.0);
        ((re.0 - margin, re.1 + margin), 1.1 * (modes.omega[2] - modes.omega[1]))
    }

    fn exact(composer: &mut Composer, frame: usize, name: &str, tracks: &[Track], ends: (f64, f64)) {
        let within: Vec<Track> =
            tracks.iter().filter(|track| track.0 >= ends.0 && track.0 <= ends.1).copied().collect();
        for index in 0..4 {
            // A number that is none parts the curve where the fold takes it to the strip's other edge.
            let mut points: Vec<(f64, f64)> = Vec::new();
            let mut fold = None;
            for (omega, values) in &within {
                let value = values[index];
                let free = value.im / omega;
                // Real multipliers lie on the strip's very edge, where rounding must not throw them from side to side.
                let stays = fold.filter(|turns: &f64| (free - turns).abs() < 0.5 + ROUNDING);
                let turns = stays.unwrap_or_else(|| free.round());
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
        let primary = |omega: f64| -> Vec<(f64, f64)> {
            let values = primary_exponents(&self.setting.at(omega), mode);
            values.map_or_else(
                |_| Vec::new(),
                |values| values.iter().map(|value| (value.re, value.im)).collect(),
            )
        };
        let omega_0 = self.places[1];
        let slower = self.setting.modes.omega[1] / omega_0 - 0.5;
        let combination = |omega: f64| -> Vec<(f64, f64)> {
            let shifts = [slower, slower, -slower, -slower].map(|shift| shift * omega);
            let Ok(values) = combination_exponents(&self.setting.at(omega)) else { return Vec::new() };
            values.iter().zip(shifts).map(|(value, shift)| (value.re, value.im + shift)).collect()
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
    fn flow_curves(
        composer: &mut Composer,
        frame: usize,
        name: &str,
        label: &str,
        (low, high): (f64, f64),
        edges: &[f64],
        exponents: &dyn Fn(f64) -> Vec<(f64, f64)>,
    ) {
        let mut frequencies: Vec<f64> = even(low, high, 160).collect();
        for edge in edges.iter().filter(|edge| low < **edge && **edge < high) {
            frequencies.extend((0..9).map(|n| edge + (high - low) * 1e-3 * f64::from(n - 4)));
        }
        order::ascending(&mut frequencies);
        let values: Vec<Vec<(f64, f64)>> =
            frequencies.into_iter().map(exponents).filter(|values| !values.is_empty()).collect();
        for index in 0..values.first().map_or(0, Vec::len) {
            let points: Vec<(f64, f64)> = values.iter().map(|all| all[index]).collect();
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
                axis("row", "", (-0.75, 4.2)),
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
            ("first order damped", "damped", self.damped(), self.filled(damped)),
            ("exact", "exact", self.damped(), self.intervals()),
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
            composer.text(frame, &format!("kind at {}", number(place, 4)), words, (place, 3.15));
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
            composer.curve(frame, line, Points::plane([(omega, -0.45), (omega, 3.5)]));
            let words = format!("*Ω* = {}", number(omega, 4));
            composer.text(frame, "present Omega in words", &words, (omega, 3.85));
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
