//! Figure U: the transmission error in time from any start, with the dead zone, and what becomes of the teeth's contact.

use super::compose::{Composer, Line, Points, axis, number, plane, rounded_up};
use super::job::{Fact, Figure, patience};
use super::response::extremes;
use crate::chart::drawing::{Mark, Role};
use crate::error::FigureError;
use crate::model::parameters::{Parameters, Regime};
use crate::study::settling::closed;
use crate::study::time_response::{TimeResponse, TimeResponseOptions, time_response};

/// Mesh periods drawn.
const SHOWN: usize = 30;
/// Most mesh periods computed, to say what the motion settles on.
const COMPUTED: usize = 200;
/// Samples in each period.
const SAMPLES: usize = 64;
/// Periods at the end in which the settled range is looked for: of motions of period T to 8T all of it.
const LAST: usize = 8;
/// The axis holds no more than this on either side: an escaping motion is cut off by the frame.
const FARTHEST: f64 = 40.0;
/// Tolerance of the integration.
const TOLERANCE: f64 = 1e-10;

/// What becomes of the contact of the teeth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Contact {
    /// `u` is a deviation only: nothing is said of the teeth.
    Unasked,
    /// Never lost, with this margin.
    Kept(f64),
    /// Lost at first, and kept with this margin where the motion has settled.
    Regained { lost: f64, margin: f64 },
    /// Lost at this time, and again and again; where the motion has settled `u` falls so far below 1.
    Lost { at: f64, by: f64 },
}

impl Contact {
    /// From the times of loss and the least `u` at the end.
    pub(super) fn of(regime: Regime, losses: &[f64], least: f64) -> Self {
        match (regime, losses.first()) {
            (Regime::Homogeneous, _) => Self::Unasked,
            (_, None) if least >= 1.0 - 1e-9 => Self::Kept((least - 1.0).max(0.0)),
            (_, Some(&lost)) if least > 1.0 => Self::Regained { lost, margin: least - 1.0 },
            // A motion that starts with the teeth apart has no time of loss: they are apart from the start.
            (_, lost) => Self::Lost { at: lost.copied().unwrap_or(0.0), by: 1.0 - least },
        }
    }

    pub(super) fn facts(self) -> Vec<(&'static str, Fact)> {
        let (word, margin, lost) = match self {
            Self::Unasked => ("unasked", None, None),
            Self::Kept(margin) => ("kept", Some(margin), None),
            Self::Regained { lost, margin } => ("regained", Some(margin), Some(lost)),
            Self::Lost { at, by } => ("lost", Some(-by), Some(at)),
        };
        let mut facts = vec![("contact", Fact::Word(word))];
        facts.extend(margin.map(|margin| ("margin", Fact::Number(margin))));
        facts.extend(lost.map(|lost| ("lostAt", Fact::Number(lost))));
        facts
    }

    fn words(self, escaped: bool) -> String {
        match self {
            Self::Unasked => {
                "u is the deviation from rest, so that the contact of the teeth is not asked".to_owned()
            }
            Self::Kept(margin) => {
                format!("contact is kept, with a margin of {} half-backlashes", number(margin, 4))
            }
            Self::Regained { lost, margin } => format!(
                "contact is lost at t = {} and kept in the end, with a margin of {} half-backlashes",
                number(lost, 5),
                number(margin, 4)
            ),
            Self::Lost { at, .. } if escaped => {
                format!("contact is lost at t = {}", number(at, 5))
            }
            Self::Lost { at, by } => format!(
                "contact is lost, for the first time at t = {}; in the end u falls {} below contact",
                number(at, 5),
                number(by, 4)
            ),
        }
    }
}

/// The motion of figure U, and what it comes to.
struct Run {
    response: TimeResponse,
    /// After so many mesh periods it is back at its start, which then lies on an orbit.
    closed: Option<usize>,
    /// Range of `u` over the last periods, unless it escapes.
    settled: Option<(f64, f64)>,
    /// Greatest `|u_p|` over the last periods.
    max_u_p: f64,
    /// Its last state, unless it escapes.
    end: Option<[f64; 6]>,
}

impl Run {
    fn new(p: &Parameters, start: [f64; 6]) -> Result<Self, FigureError> {
        // A start on an orbit, which may well be unstable, is shown as the orbit that it is.
        let closed = closed(p, &start, TOLERANCE).unwrap_or(None);
        let most = ((patience(p) / p.mesh_period()) as usize).clamp(SHOWN, COMPUTED);
        let options = TimeResponseOptions {
            state: start,
            periods: closed.unwrap_or(most) as f64,
            samples_per_period: SAMPLES,
            tolerance: TOLERANCE,
        };
        let mut response = time_response(p, &options)?;
        let end = response.states.last().copied().filter(|_| response.escaped.is_none());
        if let Some(period) = closed {
            repeat(&mut response, period, p.mesh_period());
        }
        let settled = response.escaped.is_none().then(|| {
            let last = response.states.iter().rev().take(LAST * SAMPLES + 1);
            extremes(&last.map(|state| state[2]).collect::<Vec<_>>())
        });
        let last = response.states.iter().rev().take(LAST * SAMPLES + 1);
        let (low, high) = extremes(&last.map(|state| state[0]).collect::<Vec<_>>());
        let max_u_p = high.max(-low);
        Ok(Self { response, closed, settled, max_u_p, end })
    }

    fn drawn(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        let states = self.response.states.iter().map(|state| state[2]);
        self.response.t.iter().copied().zip(states).take(SHOWN * SAMPLES + 1)
    }

    fn contact(&self, regime: Regime) -> Contact {
        let least = self.settled.map_or_else(
            || self.response.states.iter().fold(f64::INFINITY, |least, state| least.min(state[2])),
            |settled| settled.0,
        );
        Contact::of(regime, &self.response.contact_loss, least)
    }
}

/// An orbit goes on as it began: from one turn of it to all that is drawn.
fn repeat(response: &mut TimeResponse, period: usize, mesh_period: f64) {
    if response.escaped.is_some() {
        return;
    }
    let turn = period * SAMPLES;
    let length = period as f64 * mesh_period;
    response.t.truncate(turn + 1);
    response.states.truncate(turn + 1);
    while response.states.len() <= SHOWN * SAMPLES && response.states.len() > turn {
        let next = response.states.len() - turn;
        response.t.push(response.t[next] + length);
        response.states.push(response.states[next]);
    }
}

/// # Errors
/// What [`time_response`] fails with.
pub(super) fn figure(id: &'static str, p: &Parameters, start: [f64; 6]) -> Result<Figure, FigureError> {
    let run = Run::new(p, start)?;
    let whole = SHOWN as f64 * p.mesh_period();
    let escaped = run.response.escaped.filter(|time| *time <= whole);
    let end = escaped.map_or(whole, |time| f64::min(whole, 1.3 * time).max(0.02 * whole));
    let contact = run.contact(p.regime);
    let (low, high) = vertical(&run, p.regime);

    let mut composer = Composer::new((1, 1));
    let frame = composer.frame(plane(
        "response",
        "",
        (0, 0),
        axis("t", "*t*", (0.0, end)),
        axis("u", "*u*", (low, high)),
    ));
    if p.regime != Regime::Homogeneous {
        let zone = Line::new("dead zone", "the dead zone: the teeth do not touch", Role::DeadZone)
            .label("dead zone", 0.5);
        composer.add(frame, Mark::Band, zone, Points::plane([(0.0, -1.0), (end, 1.0)]));
    }
    let line = Line::new("u", "transmission error over half the backlash", Role::Exact);
    composer.curve(frame, line, Points::plane(run.drawn()));
    let mut notes = Vec::new();
    let lost = run.response.contact_loss.first().copied();
    if let Some(time) = lost.filter(|time| *time <= end) {
        let line = Line::new("contact lost", "contact is lost for the first time", Role::Event);
        let label = format!("contact lost, *t* = {}", number(time, 4));
        composer.marks(frame, line.label(&label, 0.5), Points::one((time, 1.0)));
    }
    if p.regime == Regime::Contact
        && let Some(time) = lost
    {
        notes.push(format!(
            "At t = {} the teeth would part: from there on the regime contact no longer holds.",
            number(time, 6)
        ));
    }
    if let Some(time) = run.response.escaped {
        let at = run.response.states.last().map_or(0.0, |state| state[2]).clamp(low, high);
        let line = Line::new("escape", "the motion escapes", Role::Event);
        if time <= end {
            let label = format!("escapes, *t* = {}", number(time, 4));
            composer.marks(frame, line.label(&label, 0.5), Points::one((time, at)));
        }
        notes.push(format!("The motion escapes at t = {}; it is known up to there.", number(time, 6)));
    }
    notes.push(format!(
        "Start: {}.",
        ["u_p", "u_g", "u", "u_p'", "u_g'", "u'"]
            .iter()
            .zip(start)
            .map(|(name, value)| format!("{name} = {}", number(value, 6)))
            .collect::<Vec<_>>()
            .join(", ")
    ));
    let fate = match (run.closed, run.settled, run.response.escaped) {
        (Some(period), Some((low, high)), _) => {
            format!("A motion of period {period}T: u goes between {} and {}", number(low, 5), number(high, 5))
        }
        (_, _, Some(time)) => format!("The motion grows until it escapes at t = {}", number(time, 5)),
        (_, Some((low, high)), _) => {
            format!("The motion settles between u = {} and {}", number(low, 5), number(high, 5))
        }
        (_, None, None) => "The motion goes on".to_owned(),
    };
    let mut facts = contact.facts();
    facts.extend(run.closed.map(|period| ("period", Fact::Number(period as f64))));
    facts.extend(run.response.escaped.map(|time| ("escapedAt", Fact::Number(time))));
    if let Some((low, high)) = run.settled {
        facts.extend([
            ("lowest", Fact::Number(low)),
            ("highest", Fact::Number(high)),
            ("maxU_p", Fact::Number(run.max_u_p)),
        ]);
    }
    Ok(Figure {
        summary: format!("{fate}; {}.", contact.words(run.response.escaped.is_some())),
        method: run.response.method.clone(),
        error: run.response.error,
        notes,
        facts,
        start: Some(start),
        end: run.end,
        ..Figure::drawn(id, p, composer.drawing())
    })
}

/// Ends of the vertical axis, from a ladder of round numbers, so that they stand still while a parameter moves.
fn vertical(run: &Run, regime: Regime) -> (f64, f64) {
    let (low, high) = run.drawn().fold((0.0_f64, 0.0_f64), |(low, high), (_, u)| (low.min(u), high.max(u)));
    let least = if regime == Regime::Homogeneous { 0.0 } else { 1.2 };
    let end = |reach: f64| rounded_up(1.08 * reach.max(least).min(FARTHEST));
    (-end(-low), end(high))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn contact_is_judged_by_where_the_motion_settles_and_by_its_losses() {
        use Regime::{Backlash, Contact as Permanent, Homogeneous};
        assert_eq!(Contact::of(Homogeneous, &[], -3.0), Contact::Unasked);
        assert_eq!(Contact::of(Backlash, &[], 1.25), Contact::Kept(0.25));
        assert_eq!(Contact::of(Permanent, &[2.0], 1.5), Contact::Regained { lost: 2.0, margin: 0.5 });
        assert_eq!(Contact::of(Backlash, &[2.0, 4.0], 0.5), Contact::Lost { at: 2.0, by: 0.5 });
        assert_eq!(Contact::of(Backlash, &[], 0.5), Contact::Lost { at: 0.0, by: 0.5 });
    }
}
