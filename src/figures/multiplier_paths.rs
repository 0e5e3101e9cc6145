//! Figure M: the six Floquet multipliers beside the unit circle, and how they move with the mesh frequency.

use super::compose::{Composer, Line, Points, axis, even, number, plane};
use super::job::{Fact, Figure, Slices};
use super::tongue_range::range;
use super::tongues::split;
use crate::chart::drawing::{Drawing, Frame, Role};
use crate::error::FigureError;
use crate::model::parameters::{Parameters, Regime};
use crate::order;
use crate::study::multipliers::{Multipliers, multipliers, spectrum, unloaded};
use std::f64::consts::TAU;

/// How far the path beside the circle reaches on either side, over the present mesh frequency.
const REACH: f64 = 0.15;
/// Frequencies on the path beside the circle, and over the whole range.
const NEAR: usize = 161;
const FAR: usize = 300;
/// The same about the response to a load, each of which must be found first.
const NEAR_LOADED: usize = 41;
const FAR_LOADED: usize = 60;
/// Frequencies computed in one slice, mostly all of them: they take some milliseconds. With a load one by one.
const SLICE: usize = 512;
/// Tolerance of the multipliers at the handle, and of those along the way.
const TOLERANCE: f64 = 1e-10;
const ALONG: f64 = 1e-8;
/// Growth below this in a period is none: rounding, of which a double multiplier takes the square root.
const NO_GROWTH: f64 = 1e-6;

/// One multiplier.
type Place = (f64, f64);

/// The multipliers at one mesh frequency, largest modulus first; none where there is no response to speak of.
type Sample = (f64, Option<[Place; 6]>);

/// The work on figure M, done in slices.
#[derive(Debug)]
pub(super) struct MultiplierPaths {
    parameters: Parameters,
    loaded: bool,
    range: (f64, f64),
    here: Option<Multipliers>,
    /// Frequencies to come, the next at the end: those beside the circle, then those of the whole range.
    waiting: Vec<(f64, bool)>,
    near: Vec<Sample>,
    far: Vec<Sample>,
}

impl MultiplierPaths {
    pub(super) fn new(parameters: &Parameters) -> Self {
        let loaded = !unloaded(parameters);
        let omega = parameters.omega;
        let range = widened(parameters);
        let (near, far) = if loaded { (NEAR_LOADED, FAR_LOADED) } else { (NEAR, FAR) };
        let reach = (omega / (1.0 + REACH), omega * (1.0 + REACH));
        let mut waiting: Vec<(f64, bool)> = even(range.0, range.1, far).map(|omega| (omega, false)).collect();
        waiting.extend(even(reach.0, reach.1, near).map(|omega| (omega, true)));
        Self {
            parameters: *parameters,
            loaded,
            range,
            here: None,
            waiting,
            near: Vec::new(),
            far: Vec::new(),
        }
    }

    /// The multipliers at another frequency, loads going with the mesh as they do now.
    fn sample(&self, omega: f64) -> Option<[Place; 6]> {
        let p = &self.parameters;
        let ratio = omega / p.omega;
        let at = Parameters { omega, omega_p: p.omega_p * ratio, omega_g: p.omega_g * ratio, ..*p };
        let found = spectrum(&at, ALONG).ok()?;
        Some(std::array::from_fn(|index| (found.re[index], found.im[index])))
    }

    fn drawing(&self) -> Drawing {
        let mut composer = Composer::new((2, 1));
        let largest = |samples: &[Sample]| {
            let moduli = samples.iter().filter_map(|sample| sample.1).map(|all| modulus(all[0]));
            moduli.fold(1.0_f64, f64::max)
        };
        let here = self.here.as_ref().map_or(1.0, |here| here.spectral_radius);
        let reach = 1.12 * largest(&self.near).max(here);
        let circle = composer.frame(Frame {
            equal_aspect: true,
            ..plane(
                "circle",
                "beside the unit circle",
                (0, 0),
                axis("Re mu", "Re *μ*", (-reach, reach)),
                axis("Im mu", "Im *μ*", (-reach, reach)),
            )
        });
        let top = 1.08 * largest(&self.far).max(here);
        let least =
            self.far.iter().chain(&self.near).filter_map(|sample| sample.1).map(|all| modulus(all[5]));
        let bottom = least.fold(1.0_f64, f64::min);
        let moduli = composer.frame(plane(
            "moduli",
            "their magnitudes over *Ω*",
            (1, 0),
            axis("Omega", "*Ω*", self.range),
            axis("modulus", "|*μ*|", (0.94 * bottom, top)),
        ));
        let unit =
            Line::new("unit circle", "the unit circle: outside of it deviations grow", Role::Reference);
        composer.curve(
            circle,
            unit,
            Points::plane(even(0.0, TAU, 181).map(|angle| (angle.cos(), angle.sin()))),
        );
        let one = Line::new("one", "neither growth nor decay", Role::Reference);
        composer.curve(moduli, one, Points::plane([(self.range.0, 1.0), (self.range.1, 1.0)]));
        self.paths(&mut composer, circle);
        self.moduli(&mut composer, moduli);
        if let Some(here) = &self.here {
            let all: Vec<Place> = (0..6).map(|index| (here.re[index], here.im[index])).collect();
            let line = |name: &str| Line::new(name, "the multipliers at the present Omega", Role::Handle);
            let label = format!("*Ω* = {}", number(self.parameters.omega, 5));
            composer.marks(circle, line("present"), Points::plane(all.iter().copied()));
            let over = all.iter().map(|place| (self.parameters.omega, modulus(*place)));
            composer.marks(moduli, line("present magnitudes").label(&label, 0.0), Points::plane(over));
        }
        composer.drawing()
    }

    /// The way of each multiplier as the mesh frequency goes through the neighbourhood of the present one.
    fn paths(&self, composer: &mut Composer, frame: usize) {
        let mut samples: Vec<&Sample> = self.near.iter().collect();
        order::by_number(&mut samples, |sample| sample.0);
        let mut tracks: [Vec<Place>; 6] = Default::default();
        let mut before: Option<[Place; 6]> = None;
        for (_, all) in samples {
            let Some(all) = all else {
                for track in &mut tracks {
                    track.push((f64::NAN, f64::NAN));
                }
                before = None;
                continue;
            };
            let ordered = before.map_or(*all, |before| in_order(&before, all));
            tracks.iter_mut().zip(ordered).for_each(|(track, place)| track.push(place));
            before = Some(ordered);
        }
        for (index, track) in tracks.iter().enumerate() {
            let within = |at: usize| !grows(modulus(track[at]));
            for (points, stable) in split(track, within).into_iter().zip([true, false]) {
                let word = if stable { "inside" } else { "outside" };
                let meaning =
                    format!("way of a multiplier as Omega changes by 15 per cent, {word} the unit circle");
                let line =
                    Line::new(format!("path {} {word}", index + 1), meaning, Role::Exact).stable(stable);
                composer.curve(frame, line, points);
            }
        }
    }

    fn moduli(&self, composer: &mut Composer, frame: usize) {
        let mut samples: Vec<&Sample> = self.near.iter().chain(&self.far).collect();
        samples.retain(|sample| self.range.0 <= sample.0 && sample.0 <= self.range.1);
        order::by_number(&mut samples, |sample| sample.0);
        for index in 0..6 {
            // The n-th largest magnitude is a continuous function, whoever it belongs to.
            let track: Vec<Place> = samples
                .iter()
                .map(|(omega, all)| (*omega, all.map_or(f64::NAN, |all| modulus(all[index]))))
                .collect();
            let within = |at: usize| !grows(track[at].1);
            for (points, stable) in split(&track, within).into_iter().zip([true, false]) {
                let word = if stable { "decaying" } else { "growing" };
                let meaning = format!("magnitude of multiplier {}, {word}", index + 1);
                let line = Line::new(format!("magnitude {} {word}", index + 1), meaning, Role::Exact);
                let line = line.stable(stable);
                composer.curve(
                    frame,
                    if index == 0 && !stable { line.label("grows", 0.6) } else { line },
                    points,
                );
            }
        }
    }

    fn summary(&self, here: &Multipliers) -> String {
        let about = if self.loaded { "the periodic response" } else { "rest" };
        let (re, im) = (here.re[0], here.im[0]);
        let real = im.abs() <= 1e-7 * re.abs();
        let largest = if real {
            format!("{} (a real one)", number(re, 6))
        } else {
            format!("{} {} {}i (a pair)", number(re, 6), '\u{b1}', number(im.abs(), 6))
        };
        let outcome = match (here.stable, real, re < 0.0) {
            (true, ..) => "deviations die away".to_owned(),
            (false, true, true) => "deviations grow and change sides with every period".to_owned(),
            (false, true, false) => "deviations grow on one side".to_owned(),
            (false, false, _) => "deviations grow and turn, in a spiral".to_owned(),
        };
        let state = if here.stable { "stable" } else { "unstable" };
        format!(
            "At Omega = {} {about} is {state}: the largest multiplier is {largest}, of magnitude {}; {outcome}.",
            number(self.parameters.omega, 6),
            number(here.spectral_radius, 8)
        )
    }
}

impl Slices for MultiplierPaths {
    fn advance(&mut self) -> Result<bool, FigureError> {
        if self.here.is_none() {
            self.here = Some(multipliers(&self.parameters, TOLERANCE)?);
        }
        for _ in 0..if self.loaded { 1 } else { SLICE } {
            let Some((omega, near)) = self.waiting.pop() else { break };
            let sample = (omega, self.sample(omega));
            if near {
                self.near.push(sample);
            } else {
                self.far.push(sample);
            }
        }
        Ok(self.waiting.is_empty())
    }

    fn figure(&self, id: &'static str, parameters: &Parameters) -> Figure {
        let Some(here) = &self.here else { return Figure::waiting(id, parameters) };
        let mut figure = Figure {
            summary: self.summary(here),
            method: here.method.clone(),
            error: here.error,
            facts: vec![
                ("stable", Fact::Truth(here.stable)),
                ("spectralRadius", Fact::Number(here.spectral_radius)),
                ("re", Fact::Number(here.re[0])),
                ("im", Fact::Number(here.im[0].abs())),
                ("loaded", Fact::Truth(self.loaded)),
            ],
            ..Figure::drawn(id, parameters, self.drawing())
        };
        if !self.loaded && self.parameters.regime == Regime::Backlash {
            figure.notes.push(
                "This is rest with teeth that just touch; at rest in the gap nothing acts on them.".into(),
            );
        }
        let missing = self.near.iter().chain(&self.far).filter(|sample| sample.1.is_none()).count();
        if missing > 0 {
            figure.notes.push(format!(
                "At {missing} mesh frequencies no periodic response was found; the lines have gaps there."
            ));
        }
        figure
    }
}

fn modulus(place: Place) -> f64 {
    place.0.hypot(place.1)
}

/// Whether a modulus means growth; one that is not known does not.
fn grows(modulus: f64) -> bool {
    modulus > 1.0 + NO_GROWTH
}

/// The range of the tongues, widened to hold the present frequency.
fn widened(p: &Parameters) -> (f64, f64) {
    let (low, high) = range(p);
    (low.min(0.85 * p.omega).max(0.01), high.max(1.15 * p.omega).min(100.0))
}

/// The multipliers in the order of their predecessors: the nearest pair first, then the nearest of the rest.
fn in_order(before: &[Place; 6], now: &[Place; 6]) -> [Place; 6] {
    let mut ordered = *now;
    let (mut open, mut left) = ([true; 6], [true; 6]);
    for _ in 0..6 {
        let mut best = (f64::INFINITY, 0, 0);
        for (from, old) in before.iter().enumerate().filter(|(from, _)| open[*from]) {
            for (to, new) in now.iter().enumerate().filter(|(to, _)| left[*to]) {
                let distance = (old.0 - new.0).hypot(old.1 - new.1);
                if distance < best.0 {
                    best = (distance, from, to);
                }
            }
        }
        (open[best.1], left[best.2]) = (false, false);
        ordered[best.1] = now[best.2];
    }
    ordered
}

#[cfg(test)]
mod tests {
    use super::in_order;

    #[test]
    fn multipliers_keep_their_order_along_the_way() {
        let before = [(1.2, 0.0), (0.5, 0.5), (0.5, -0.5), (-0.3, 0.1), (-0.3, -0.1), (0.8, 0.0)];
        let mut now = before.map(|(re, im)| (re + 0.01, im * 1.02));
        now.swap(0, 3);
        now.swap(1, 2);
        let ordered = in_order(&before, &now);
        for (old, new) in before.iter().zip(ordered) {
            assert!((old.0 - new.0).hypot(old.1 - new.1) < 0.02);
        }
    }
}
