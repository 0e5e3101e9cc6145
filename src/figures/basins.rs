//! Figure A: which start goes to which attractor, and which escapes, over a plane of starts.

use super::compose::{Composer, Line, Points, axis, number, plane};
use super::job::{Figure, Slices};
use crate::chart::drawing::{Drawing, Role};
use crate::error::FigureError;
use crate::model::parameters::Parameters;
use crate::study::basin::{Attractor, AttractorKind, Basin, BasinOptions, BasinWork, ESCAPED, UNDECIDED};
use crate::study::grid::Grid;

/// Cells along each side.
const CELLS: usize = 192;
/// How far the plane reaches, over the displacement at which the cubic force equals the linear one.
const REACH: (f64, f64) = (1.0, 1.6);
/// Most regions that are named.
const MOST_NAMED: usize = 12;

/// The work on figure A, done in slices.
#[derive(Debug)]
pub(super) struct Basins {
    work: BasinWork,
    x: Grid,
    y: Grid,
}

impl Basins {
    /// # Errors
    /// Loads whose frequencies have no common period with the mesh.
    pub(super) fn new(parameters: &Parameters) -> Result<Self, FigureError> {
        let p = parameters;
        let size = |k: f64, alpha: f64| if alpha == 0.0 { 5.0 } else { (k / alpha.abs()).sqrt() };
        let size = size(p.k_p, p.alpha_p).min(size(p.k_g, p.alpha_g)).clamp(0.01, 1e3);
        let speed = size * (p.k_p / p.m_p).sqrt().clamp(0.1, 10.0);
        let grid = |reach: f64| Grid { low: -reach, high: reach, count: CELLS };
        let (x, y) = (grid(REACH.0 * size), grid(REACH.1 * 0.5 * speed));
        let work = BasinWork::new(p, &BasinOptions::new(p, x, y))?;
        Ok(Self { work, x, y })
    }

    /// The regions in the order of their numbers: attractor, and at which of its points the motion is at t = 0.
    fn regions(basin: &Basin) -> Vec<(i32, u8)> {
        let mut regions: Vec<(i32, u8)> = basin
            .attractors
            .iter()
            .enumerate()
            .flat_map(|(index, attractor)| {
                let phases = match attractor.kind {
                    AttractorKind::Orbit { period } | AttractorKind::Gap { period } => period.min(64),
                    AttractorKind::Torus => 1,
                };
                (0..phases).map(move |phase| (i32::try_from(index).unwrap_or(i32::MAX), phase as u8))
            })
            .collect();
        regions.truncate(200);
        regions
    }

    fn drawing(&self) -> Drawing {
        let basin = self.work.basin();
        let regions = Self::regions(basin);
        let mut composer = Composer::new((1, 1));
        let frame = composer.frame(plane(
            "starts",
            "",
            (0, 0),
            axis("u_p", "*u*_{p}", (self.x.low, self.x.high)),
            axis("u_p'", "*u*_{p}'", (self.y.low, self.y.high)),
        ));
        let torus = |index: i32| {
            let known = usize::try_from(index).ok().and_then(|index| basin.attractors.get(index));
            known.is_some_and(|attractor| attractor.kind == AttractorKind::Torus)
        };
        let values: Vec<f64> = basin
            .attractor
            .iter()
            .zip(&basin.phase)
            .map(|(&attractor, &phase)| {
                let phase = if torus(attractor) { 0 } else { phase };
                match attractor {
                    ESCAPED | UNDECIDED => f64::from(attractor),
                    _ => regions.iter().position(|region| *region == (attractor, phase)).unwrap_or(0) as f64,
                }
            })
            .collect();
        let places = |grid: &Grid| (0..grid.count).map(|index| grid.value(index)).collect::<Vec<f64>>();
        let field =
            Line::new("basins", "number of the region a start belongs to; -1: it escapes", Role::Basins);
        composer.field(frame, field, places(&self.x), places(&self.y), values);
        for (number_of, &(index, phase)) in regions.iter().enumerate().take(MOST_NAMED) {
            let Some(attractor) = usize::try_from(index).ok().and_then(|index| basin.attractors.get(index))
            else {
                continue;
            };
            let name = format!("attractor {} point {}", index + 1, phase + 1);
            match attractor.kind {
                AttractorKind::Orbit { period } | AttractorKind::Gap { period } => {
                    let Some(state) = attractor.points.get(usize::from(phase)) else { continue };
                    let (meaning, label) = words(attractor, period, phase);
                    let label = format!("{}: {label}", number_of + 1);
                    let line = Line::new(name, meaning, Role::Attractor).stable(true);
                    composer.marks(frame, line.label(&label, 0.0), Points::one((state[0], state[3])));
                }
                AttractorKind::Torus => {
                    let mut points = Points::default();
                    points.cloud(attractor.points.iter().map(|state| (state[0], state[3])));
                    let meaning = "stroboscopic points of a motion that never repeats";
                    let line = Line::new(name, meaning, Role::Attractor).stable(true);
                    let label = format!("{}: torus", number_of + 1);
                    composer.add(frame, crate::chart::drawing::Mark::Cloud, line.label(&label, 0.2), points);
                }
            }
        }
        // The word stands where there is most room for it: high up in the middle, or as near to that as starts escape.
        let wanted = (self.x.count / 2, self.y.count * 9 / 10);
        let off = |cell: &usize| {
            let (column, row) = (cell % self.x.count, cell / self.x.count);
            column.abs_diff(wanted.0) + row.abs_diff(wanted.1)
        };
        let escaping = (0..basin.attractor.len()).filter(|&cell| basin.attractor[cell] == ESCAPED);
        if let Some(cell) = escaping.min_by_key(off) {
            let place = (self.x.value(cell % self.x.count), self.y.value(cell / self.x.count));
            composer.text(frame, "escape", "escape", place);
        }
        composer.drawing()
    }

    /// Share of the cells done so far that has this answer, per cent.
    fn share(basin: &Basin, wanted: impl Fn(i32) -> bool) -> f64 {
        let known = basin.attractor.iter().filter(|&&index| index != UNDECIDED).count().max(1);
        let found = basin.attractor.iter().filter(|&&index| index != UNDECIDED && wanted(index)).count();
        100.0 * found as f64 / known as f64
    }

    fn summary(&self) -> String {
        let basin = self.work.basin();
        let each: Vec<String> = basin
            .attractors
            .iter()
            .enumerate()
            .map(|(index, attractor)| {
                let share = Self::share(basin, |found| usize::try_from(found) == Ok(index));
                let end = match attractor.kind {
                    _ if attractor.is_rest_in_gap() => "come to rest somewhere in the gap".to_owned(),
                    AttractorKind::Orbit { period } => format!("go to a motion of period {period}T"),
                    AttractorKind::Gap { period } => format!(
                        "go to one of a continuous family of motions of period {period}T inside the gap"
                    ),
                    AttractorKind::Torus => "go to a motion that never repeats".to_owned(),
                };
                format!("{} per cent {end}", number(share, 3))
            })
            .collect();
        let escaped = number(Self::share(basin, |found| found == ESCAPED), 3);
        if each.is_empty() {
            return format!("Of the starts in this plane {escaped} per cent escape; no attractor was found.");
        }
        format!("Of the starts in this plane {}, and {escaped} per cent escape.", each.join(", "))
    }
}

/// What a point of an orbit is, and the short form of it.
fn words(attractor: &Attractor, period: usize, phase: u8) -> (String, String) {
    if attractor.is_rest_in_gap() {
        return ("rest in the middle of the gap".to_owned(), "at rest in the gap".to_owned());
    }
    let length = if period == 1 { String::new() } else { period.to_string() };
    let point = phase + 1;
    if matches!(attractor.kind, AttractorKind::Gap { .. }) {
        let meaning = format!("point {point} of the motion of period {period}T in the middle of the gap");
        return (meaning, format!("in the gap, period {length}*T*"));
    }
    (format!("point {point} of a stable motion of period {period}T"), format!("period {length}*T*"))
}

impl Slices for Basins {
    fn advance(&mut self) -> Result<bool, FigureError> {
        Ok(self.work.advance()?)
    }

    fn figure(&self, id: &'static str, parameters: &Parameters) -> Figure {
        let basin = self.work.basin();
        let mut notes = Vec::new();
        if basin.done < basin.cells {
            notes.push(format!("{} of {} starts followed so far.", basin.done, basin.cells));
        }
        Figure {
            summary: self.summary(),
            method: basin.method.clone(),
            error: basin.error,
            notes,
            ..Figure::drawn(id, parameters, self.drawing())
        }
    }
}
