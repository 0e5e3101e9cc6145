//! Figure 14: the transmission error in time, in permanent contact and with backlash.

use super::compose::{Composer, Line, Points, axis, number, plane};
use super::job::{Figure, patience};
use crate::chart::drawing::{Mark, Role};
use crate::error::FigureError;
use crate::model::parameters::{Parameters, Regime};
use crate::study::ErrorEstimate;
use crate::study::time_response::{TimeResponse, TimeResponseOptions, time_response};

/// Mesh periods drawn: at the paper's frequency they last to t = 118.
const SHOWN: usize = 30;
/// Most mesh periods computed, to say what the motion settles on.
const COMPUTED: usize = 160;
/// Samples in each period.
const SAMPLES: usize = 64;
/// Periods at the end in which the settled range is looked for.
const LAST: usize = 8;
/// The axis holds no more than this on either side: an escaping motion is cut off by the frame.
const FARTHEST: f64 = 40.0;

/// One regime's motion.
struct Run {
    response: TimeResponse,
    /// Rows that are drawn.
    shown: usize,
    /// Range of `u` over the last periods, unless it escapes.
    settled: Option<(f64, f64)>,
}

impl Run {
    fn new(parameters: &Parameters, regime: Regime) -> Result<Self, FigureError> {
        let parameters = Parameters { regime, ..*parameters };
        let computed = ((patience(&parameters) / parameters.mesh_period()) as usize).clamp(SHOWN, COMPUTED);
        let options = TimeResponseOptions {
            periods: computed as f64,
            samples_per_period: SAMPLES,
            ..TimeResponseOptions::new(&parameters)
        };
        let response = time_response(&parameters, &options)?;
        let shown = (SHOWN * SAMPLES + 1).min(response.t.len());
        let settled = response.escaped.is_none().then(|| {
            let u: Vec<f64> =
                response.states.iter().rev().take(LAST * SAMPLES + 1).map(|state| state[2]).collect();
            extremes(&u)
        });
        Ok(Self { response, shown, settled })
    }

    fn drawn(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        let states = self.response.states.iter().map(|state| state[2]);
        self.response.t.iter().copied().zip(states).take(self.shown)
    }

    /// The time of escape, where that is drawn.
    fn escape_shown(&self) -> Option<f64> {
        self.response.escaped.filter(|_| self.shown == self.response.t.len())
    }
}

/// Least and greatest value of evenly sampled numbers, with a parabola through the samples about each.
pub(super) fn extremes(values: &[f64]) -> (f64, f64) {
    let refined = |sign: f64| {
        let best =
            (0..values.len()).max_by(|&i, &j| (sign * values[i]).total_cmp(&(sign * values[j]))).unwrap_or(0);
        let Some(&middle) = values.get(best) else { return 0.0 };
        match (best.checked_sub(1).and_then(|i| values.get(i)), values.get(best + 1)) {
            (Some(&left), Some(&right)) => {
                let (slope, bend) = (0.5 * (right - left), right - 2.0 * middle + left);
                if bend == 0.0 { middle } else { middle - 0.5 * slope * slope / bend }
            }
            _ => middle,
        }
    };
    (refined(-1.0), refined(1.0))
}

/// # Errors
/// What [`time_response`] fails with.
pub(super) fn figure(id: &'static str, parameters: &Parameters) -> Result<Figure, FigureError> {
    let contact = Run::new(parameters, Regime::Contact)?;
    let backlash = Run::new(parameters, Regime::Backlash)?;
    let whole = SHOWN as f64 * parameters.mesh_period();
    // Where both motions leave, the axis ends soon after.
    let end = match (contact.escape_shown(), backlash.escape_shown()) {
        (Some(one), Some(other)) => f64::min(whole, 1.5 * one.max(other)),
        _ => whole,
    };
    let (low, high) = vertical(&backlash);
    let mut composer = Composer::new((1, 1));
    let frame = composer.frame(plane(
        "response",
        "",
        (0, 0),
        axis("t", "*t*", (0.0, end)),
        axis("u", "*u*", (low, high)),
    ));
    let zone = Line::new("dead zone", "the dead zone: the teeth do not touch", Role::DeadZone)
        .label("dead zone", 0.5);
    composer.add(frame, Mark::Band, zone, Points::plane([(0.0, -1.0), (end, 1.0)]));
    let line = Line::new("contact", "u in permanent contact (25), as in the paper", Role::OtherRegime);
    composer.curve(frame, line.label("contact (25)", 0.285), Points::plane(contact.drawn()));
    let line = Line::new("backlash", "u with the dead zone of (23)", Role::Exact);
    composer.curve(frame, line.label("backlash (22)", 0.155), Points::plane(backlash.drawn()));

    let mut notes = Vec::new();
    let loss = contact.response.contact_loss.first().copied().filter(|time| *time <= end);
    if let Some(time) = loss {
        let line = Line::new("contact lost", "contact is lost for the first time", Role::Event);
        composer.marks(frame, line, Points::one((time, 1.0)));
        // The words stand below the dead zone, where the first swings leave room.
        let height = -1.0 + 0.5 * (low + 1.0);
        let line = Line::new("contact lost from here", "from here on (25) no longer holds", Role::Reference);
        composer.curve(frame, line, Points::plane([(time, 1.0), (time, height)]));
        let words = format!("contact lost at *t* = {}", number(time, 4));
        let at = (time + 0.13 * end).min(0.85 * end);
        composer.text(frame, "contact lost in words", &words, (at, height));
        notes.push(format!(
            "Contact is lost for the first time at t = {}; from here on (25) no longer holds.",
            number(time, 6)
        ));
    }
    let mut marked = None;
    for (run, name) in [(&contact, "contact"), (&backlash, "backlash")] {
        let Some(time) = run.escape_shown() else { continue };
        if marked.replace(time).is_some_and(|before: f64| (before - time).abs() < 1e-3 * end) {
            notes.push(format!("In the regime {name} it escapes at the same time."));
            continue;
        }
        let at = run.response.states.last().map_or(0.0, |state| state[2]).clamp(low, high);
        let label = format!("escapes, *t* = {}", number(time, 4));
        let line = Line::new(
            format!("escape {name}"),
            format!("the motion in the regime {name} escapes"),
            Role::Event,
        );
        composer.marks(frame, line.label(&label, 0.5), Points::one((time, at)));
        notes.push(format!(
            "In the regime {name} the motion escapes at t = {}; it is drawn up to there.",
            number(time, 6)
        ));
    }
    if loss.is_none() {
        notes.push(match contact.response.contact_loss.first() {
            Some(time) => format!(
                "Contact is lost for the first time at t = {}, after what is drawn.",
                number(*time, 6)
            ),
            None => "Contact is never lost: both regimes are the same motion.".to_owned(),
        });
    }
    let summary = format!(
        "From rest at (0, 0, 1): with backlash u {}; in permanent contact u {}.",
        fate(&backlash),
        fate(&contact)
    );
    // Where a motion escapes its last state says nothing about the error of what is drawn.
    let bounded = [&contact, &backlash].into_iter().filter(|run| run.response.escaped.is_none());
    let step = bounded.filter_map(|run| run.response.error.step).reduce(f64::max);
    Ok(Figure {
        summary,
        method: format!("contact: {}; backlash: {}", contact.response.method, backlash.response.method),
        error: ErrorEstimate { step: step.filter(|step| step.is_finite()), ..ErrorEstimate::default() },
        notes,
        ..Figure::drawn(id, parameters, composer.drawing())
    })
}

/// Ends of the vertical axis: what the motion with backlash needs, and the dead zone, with a margin.
fn vertical(backlash: &Run) -> (f64, f64) {
    let (low, high) =
        backlash.drawn().fold((-1.4_f64, 2.0_f64), |(low, high), (_, u)| (low.min(u), high.max(u)));
    let (low, high) = (low.max(-FARTHEST), high.min(FARTHEST));
    let margin = 0.25 * (high - low);
    (low - margin, high + margin)
}

/// What becomes of the motion, in words.
fn fate(run: &Run) -> String {
    match (run.settled, run.response.escaped) {
        (Some((low, high)), _) => format!("settles between {} and {}", number(low, 5), number(high, 5)),
        (None, Some(time)) => format!("grows until it leaves at t = {}", number(time, 5)),
        (None, None) => "moves on".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn extremes_are_found_between_samples() {
        let values: Vec<f64> = (0..100).map(|n| (0.1 * f64::from(n) + 0.043).sin()).collect();
        let (low, high) = extremes(&values);
        assert!((low + 1.0).abs() < 1e-5 && (high - 1.0).abs() < 1e-5, "{low} {high}");
        assert_eq!(extremes(&[2.0]), (2.0, 2.0));
    }
}
