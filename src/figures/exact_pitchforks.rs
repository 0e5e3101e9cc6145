//! The exact motions of period 2T beside the pitchforks of figures 3 and 5, as amplitudes of the mode at half the mesh
//! frequency.

use super::beside::{Part, Told, farthest, modal, unloaded};
use super::compose::Composer;
use super::exact::{Exact, Spot, Style};
use super::job::Figure;
use super::pitchfork::REACH;
use super::tongues::{Setting, Supports};
use crate::chart::drawing::Role;
use crate::error::FigureError;
use crate::model::parameters::Parameters;
use crate::study::ErrorEstimate;
use crate::study::motion::sampled;
use crate::study::sweep::at_frequency;
use crate::theory::modes::Mode;
use crate::theory::primary::{emanating_frequency, half_width};

/// Most branches that are followed: those that are born at rest come first, then what bifurcates from them.
const MOST: usize = 6;
/// Samples of an orbit: its harmonics above the fifteenth count as the first.
const SAMPLES: usize = 16;
/// Orbits turned into amplitudes in one slice.
const SLICE: usize = 40;

/// One sign of the supports.
#[derive(Debug)]
struct Side {
    supports: Supports,
    parameters: Parameters,
    exact: Exact,
    /// All branches are there.
    followed: bool,
    /// Of each branch of period 2T its points, then its events, as `Omega_1, B_1, B_2`; shorter while they are computed.
    places: Vec<Vec<[f64; 3]>>,
}

/// The work on the exact part of figure 3 or 5.
#[derive(Debug)]
pub(super) struct Pitchforks {
    setting: Setting,
    mode: Mode,
    sides: Vec<Side>,
}

impl Pitchforks {
    /// # Errors
    /// Unequal supports.
    pub(super) fn new(parameters: &Parameters, mode: Mode) -> Result<Self, FigureError> {
        let setting = Setting::of(parameters)?;
        let reach = setting.symmetric.k0 * REACH * half_width(&setting.modes, mode);
        let middle = emanating_frequency(&setting.modes, mode);
        let side = |supports: Supports| {
            let p = unloaded(parameters, setting.with(supports).symmetric.alpha);
            let exact = Exact::new(&p, (middle - reach, middle + reach), 2, MOST);
            Side { supports, parameters: p, exact, followed: false, places: Vec::new() }
        };
        let sides =
            if setting.paper_alpha().is_some() { Supports::BOTH.map(side).into() } else { Vec::new() };
        Ok(Self { setting, mode, sides })
    }

    /// The amplitude of a spot.
    fn amplitude(&self, side: &Side, index: usize, spot: Spot) -> Result<[f64; 3], FigureError> {
        let (omega, state, _) = spot.of(&side.exact.branches()[index]);
        let x = (omega - emanating_frequency(&self.setting.modes, self.mode)) / side.parameters.k0;
        let (mut cosine, mut sine) = (0.0, 0.0);
        let p = at_frequency(&side.parameters, omega);
        sampled(&p, state, 2.0, SAMPLES, &mut |time, state| {
            let q = modal(&self.setting.modes, self.mode, state);
            let angle = 0.5 * omega * time;
            cosine += q * angle.cos();
            sine += q * angle.sin();
        })?;
        let scale = 2.0 / SAMPLES as f64;
        Ok([x, scale * cosine, scale * sine])
    }

    /// Turns some more orbits into amplitudes; true once none is left.
    fn convert(&mut self, which: usize) -> Result<bool, FigureError> {
        for _ in 0..SLICE {
            let side = &self.sides[which];
            let branches = side.exact.branches();
            let open = (0..branches.len()).find(|&index| {
                branches[index].period == 2
                    && side.places[index].len() < branches[index].value.len() + branches[index].events.len()
            });
            let Some(index) = open else { return Ok(true) };
            let (done, count) = (side.places[index].len(), branches[index].value.len());
            let spot = if done < count { Spot::Point(done) } else { Spot::Event(done - count) };
            let place = self.amplitude(side, index, spot)?;
            self.sides[which].places[index].push(place);
        }
        Ok(false)
    }

    /// The place of a spot in space; not finite while its amplitude is not known.
    fn place(&self, side: &Side, index: usize, spot: Spot) -> [f64; 3] {
        let branch = &side.exact.branches()[index];
        if branch.period == 1 {
            let middle = emanating_frequency(&self.setting.modes, self.mode);
            return [(spot.of(branch).0 - middle) / side.parameters.k0, 0.0, 0.0];
        }
        let at = match spot {
            Spot::Point(at) => at,
            Spot::Event(at) => branch.value.len() + at,
        };
        side.places.get(index).and_then(|places| places.get(at)).copied().unwrap_or([f64::NAN; 3])
    }

    /// Draws one side: both points of each orbit, in the plane and in space.
    fn draw_side(&self, side: &Side, formulas: &Figure, composer: &mut Composer, told: &mut Told) {
        let name = side.supports.name();
        let frame = |kind: &str| {
            let wanted = format!("{name}-{kind}");
            formulas.drawing.frames.iter().position(|frame| frame.name == wanted)
        };
        let (Some(flat), Some(space)) = (frame("plane"), frame("space")) else { return };
        // What lies well outside of the frame would only make the picture large.
        let top = 1.3 * formulas.drawing.frames[flat].y.high;
        for (sign, suffix) in [(1.0, ""), (-1.0, " opposite")] {
            let in_space = &|index: usize, spot: Spot| {
                let [x, cosine, sine] = self.place(side, index, spot);
                [if cosine.hypot(sine) < top { x } else { f64::NAN }, sign * cosine, sign * sine]
            };
            let in_plane = &|index: usize, spot: Spot| {
                let [x, cosine, sine] = in_space(index, spot);
                [x, sign * cosine.hypot(sine), 0.0]
            };
            let style = Style {
                name: &format!(" {name}{suffix}"),
                place: in_plane,
                space: false,
                marked: sign > 0.0,
            };
            side.exact.draw(composer, flat, &style);
            let style =
                Style { name: &format!(" {name}{suffix} 3-D"), place: in_space, space: true, marked: false };
            side.exact.draw(composer, space, &style);
        }
        told.notes.extend(side.exact.notes());
        let stable = formulas.drawing.series.iter().filter(|series| {
            series.frame == flat
                && series.role == Role::Corrected
                && series.stable == Some(true)
                && series.name.starts_with("R_")
        });
        let radius = &|index: usize, spot: Spot| {
            let [x, cosine, sine] = self.place(side, index, spot);
            [if cosine.hypot(sine) < top { x } else { f64::NAN }, cosine.hypot(sine), 0.0]
        };
        if let Some(found) = farthest(stable, &|x| side.exact.stable_at(x, radius)) {
            told.apart(&format!("{} supports", capital(name)), "Omega_1", found);
        }
    }
}

fn capital(word: &str) -> String {
    let (first, rest) = word.split_at(1);
    first.to_ascii_uppercase() + rest
}

impl Part for Pitchforks {
    fn advance(&mut self) -> Result<bool, FigureError> {
        for which in 0..self.sides.len() {
            let side = &mut self.sides[which];
            if !side.followed {
                side.followed = side.exact.advance()?;
                side.places.resize(side.exact.branches().len(), Vec::new());
                return Ok(false);
            }
            if !self.convert(which)? {
                return Ok(false);
            }
        }
        Ok(true)
    }

    fn draw(&self, formulas: &Figure, composer: &mut Composer, told: &mut Told) {
        for side in &self.sides {
            self.draw_side(side, formulas, composer, told);
        }
    }

    fn method(&self) -> (&'static str, ErrorEstimate) {
        let error = self.sides.iter().map(|side| side.exact.error()).reduce(ErrorEstimate::worse);
        (
            "; exact: continuation of the stroboscopic map, amplitude of the mode at half the mesh frequency",
            error.unwrap_or_default(),
        )
    }
}
