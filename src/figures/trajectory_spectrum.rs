//! Figure W: the amplitude spectrum of the transmission error where a motion from any start has settled.

use super::compose::{Composer, Line, Points, axis, number, plane};
use super::job::{Fact, Figure, patience};
use crate::chart::drawing::Role;
use crate::error::{FigureError, NumericsError, StudyError};
use crate::model::parameters::Parameters;
use crate::study::settling::closed;
use crate::study::spectrum::{AmplitudeSpectrum, spectrum};

/// Most mesh periods left to settle.
const SETTLING: usize = 400;
/// Mesh periods of the series: lines are 1/64 of the mesh frequency apart.
const PERIODS: usize = 64;
/// Frequencies shown, over the mesh frequency.
const HIGHEST: f64 = 6.0;
/// Powers of ten shown below the greatest amplitude.
const DECADES: f64 = 8.0;
/// Tolerance of the integration.
const TOLERANCE: f64 = 1e-10;
/// A line this far below the largest one is not named.
const WORTH_NAMING: f64 = 1e-3;

/// # Errors
/// What [`spectrum`] fails with, unless the motion escapes.
pub(super) fn figure(id: &'static str, p: &Parameters, start: [f64; 6]) -> Result<Figure, FigureError> {
    // A start on an orbit, which may be unstable, stays there for as long as it is asked to: not at all.
    let settled = closed(p, &start, TOLERANCE)?;
    let patient = (patience(p) / p.mesh_period()) as usize;
    let (transient, periods) = match settled {
        Some(period) => (0, period),
        None => (patient.clamp(50, SETTLING), PERIODS),
    };
    match spectrum(p, Some(start), transient, periods, TOLERANCE) {
        Ok(found) => Ok(drawn(id, p, start, &found)),
        Err(StudyError::Numerics(NumericsError::Escaped { time })) => Ok(Figure {
            summary: format!(
                "The motion escapes at t = {}: it settles on nothing that has a spectrum.",
                number(time, 5)
            ),
            method: "Taylor series".to_owned(),
            facts: vec![("escapedAt", Fact::Number(time))],
            start: Some(start),
            ..Figure::drawn(id, p, empty((-DECADES, 0.0)).0.drawing())
        }),
        Err(error) => Err(error.into()),
    }
}

fn empty(range: (f64, f64)) -> (Composer, usize) {
    let mut composer = Composer::new((1, 1));
    let frame = composer.frame(plane(
        "spectrum",
        "",
        (0, 0),
        axis("frequency", "frequency over *Ω*", (0.0, HIGHEST)),
        axis("log amplitude", "log_{10} amplitude", range),
    ));
    (composer, frame)
}

fn drawn(id: &'static str, p: &Parameters, start: [f64; 6], found: &AmplitudeSpectrum) -> Figure {
    // The mean is no vibration: it has no say in what is loud.
    let lines = || found.frequency.iter().copied().zip(found.amplitude.iter().copied()).skip(1);
    let shown = || lines().take_while(|(frequency, _)| *frequency <= HIGHEST);
    let (loudest, most) = shown().fold((0.0, 0.0), |best, line| if line.1 > best.1 { line } else { best });
    let top = if most > 0.0 { most.log10().ceil() } else { 0.0 };
    let range = (top - DECADES, top + 0.3);
    let (mut composer, frame) = empty(range);
    let at = |amplitude: f64| if amplitude > 0.0 { amplitude.log10().max(range.0) } else { range.0 };
    let exact = found.window == "rectangular";
    let mut points = Points::default();
    if exact {
        let stems = shown().filter(|(_, amplitude)| at(*amplitude) > range.0);
        for (frequency, amplitude) in stems {
            points.piece([(frequency, range.0), (frequency, at(amplitude))]);
        }
    } else {
        points.piece(shown().map(|(frequency, amplitude)| (frequency, at(amplitude))));
    }
    let line = Line::new("amplitude", "amplitude of u, its decimal logarithm", Role::Exact);
    composer.curve(frame, line, points);
    for (frequency, name) in [(0.5, "*Ω*/2"), (1.0, "*Ω*"), (1.5, "3*Ω*/2"), (2.0, "2*Ω*")] {
        let near = shown().filter(|line| (line.0 - frequency).abs() < 0.02).map(|line| line.1);
        let amplitude = near.fold(0.0, f64::max);
        if amplitude > WORTH_NAMING * most && amplitude > 0.0 {
            composer.text(frame, &format!("name {frequency}"), name, (frequency, at(amplitude) + 0.22));
        }
    }
    let mean = found.amplitude.first().copied().unwrap_or(0.0);
    let summary = if most < 1e-9 {
        "Where the motion has settled u does not vibrate: there is nothing to hear.".to_owned()
    } else {
        format!(
            "The loudest line of u is at {} times the mesh frequency, with an amplitude of {}.",
            number(loudest, 4),
            number(most, 5)
        )
    };
    let facts = vec![
        ("loudest", Fact::Number(loudest)),
        ("amplitude", Fact::Number(most)),
        ("mean", Fact::Number(mean)),
        ("lines", Fact::Truth(exact)),
    ];
    Figure {
        summary,
        method: found.method.clone(),
        error: found.error,
        facts,
        start: Some(start),
        ..Figure::drawn(id, p, composer.drawing())
    }
}
