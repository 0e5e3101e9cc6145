//! What there is to see: every figure's number, words, preset and the parameters it depends on.

use crate::error::FigureError;
use crate::model::parameters::{Parameters, Value};
use crate::study::motion::default_state;

/// The value a figure gives a parameter where the reader has given none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Preset {
    /// A number, dimensionless.
    Number(f64),
    /// A word (of the regime).
    Word(&'static str),
}

impl Preset {
    fn value(self) -> Value {
        match self {
            Self::Number(number) => Value::Number(number),
            Self::Word(word) => Value::Text(word.to_owned()),
        }
    }
}

/// One figure: its words, its preset, and what a page must know before it is computed.
#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(
    clippy::struct_excessive_bools,
    reason = "each is told to the page by itself, none excludes another"
)]
pub struct Specification {
    /// The figure's number, e.g. `11a`.
    pub id: &'static str,
    /// A short title.
    pub title: &'static str,
    /// The caption, in label markup (see `chart::drawing::Axis::label`).
    pub caption: &'static str,
    /// Names of the parameters it depends on (short forms where it needs equal supports), in the order of its
    /// controls.
    pub parameters: &'static [&'static str],
    /// What it takes where the reader gives nothing, by name; a parameter not named takes its default.
    pub preset: &'static [(&'static str, Preset)],
    /// It holds a 3-D view that can be turned.
    pub turnable: bool,
    /// It moves: see [`super::at_time`].
    pub animated: bool,
    /// It shows a motion from a start, whose numbers it takes beside the parameters (see [`super::START`]).
    pub starts: bool,
    /// Width over height at which it looks best.
    pub aspect: f64,
    /// It takes longer than a frame, so that it must not stand in the way of the quick ones; most such figures are
    /// computed step by step, with a partial picture at any time (see [`super::Job`]).
    pub heavy: bool,
    /// With some parameters its field is computed in parts, by several workers side by side.
    pub divisible: bool,
}

const MODAL: &[&str] = &["m", "k"];
const BRANCHES: &[&str] = &["m", "k", "alpha", "zeta", "k0"];
const LINEAR: &[&str] = &["m", "k", "zeta", "k0"];
const LINEAR_AT: &[&str] = &["m", "k", "zeta", "k0", "Omega"];
const MAP: &[&str] = &["m", "k", "alpha", "zeta", "k0", "Omega"];
const LOADED: &[&str] = &["m", "k", "alpha", "zeta", "k0", "Omega", "F", "F_p", "F_g", "E"];

/// The paper's pair of cubic stiffnesses is +0.2 and -0.2: one control holds their magnitude.
const MAGNITUDE: &[(&str, Preset)] = &[("alpha", Preset::Number(0.2))];

/// An empty line of the table: a drawing that stands still, at once, without a control.
const BLANK: Specification = Specification {
    id: "",
    title: "",
    caption: "",
    parameters: &[],
    preset: &[],
    turnable: false,
    animated: false,
    starts: false,
    aspect: 1.7,
    heavy: false,
    divisible: false,
};

const fn determinants(id: &'static str, title: &'static str, caption: &'static str) -> Specification {
    Specification { id, title, caption, parameters: MODAL, ..BLANK }
}

const fn branches(id: &'static str, title: &'static str, caption: &'static str) -> Specification {
    Specification {
        id,
        title,
        caption,
        parameters: BRANCHES,
        preset: MAGNITUDE,
        turnable: true,
        aspect: 1.25,
        heavy: true,
        ..BLANK
    }
}

const fn overall(id: &'static str, title: &'static str, caption: &'static str) -> Specification {
    Specification {
        id,
        title,
        caption,
        parameters: BRANCHES,
        preset: MAGNITUDE,
        aspect: 1.8,
        heavy: true,
        ..BLANK
    }
}

const fn map(
    id: &'static str,
    title: &'static str,
    caption: &'static str,
    preset: &'static [(&'static str, Preset)],
) -> Specification {
    Specification { id, title, caption, parameters: MAP, preset, aspect: 1.35, heavy: true, ..BLANK }
}

const fn response(
    id: &'static str,
    title: &'static str,
    caption: &'static str,
    preset: &'static [(&'static str, Preset)],
) -> Specification {
    Specification { id, title, caption, parameters: LOADED, preset, aspect: 2.0, heavy: true, ..BLANK }
}

macro_rules! preset {
    ($($name:literal = $value:literal),* $(; regime = $regime:literal)?) => {
        &[$(($name, Preset::Number($value)),)* $(("regime", Preset::Word($regime)),)?]
    };
}

const NODES_CAPTION: &str = "The motion looked at once every mesh period, *T* = 2π/*Ω*, at cos *Ωt* = 1. Starts near the \
    origin leave it along its unstable direction, change sides with every period, and end in the two nodes, which are \
    the two points of one motion of period 2*T*. Thin lines join every second point.";

const CYCLE_CAPTION: &str = "The motion looked at once every mesh period, *T* = 2π/*Ω*. The origin is an unstable spiral; \
    what leaves it (light) winds onto a closed curve (dark): a motion of two frequencies, the limit cycle of the slow \
    flow, whose size shrinks as *Ω* nears the tongue's right edge.";

static SPECIFICATIONS: [Specification; 31] = [
    Specification {
        id: "1",
        title: "Pinion and gear on their supports",
        caption: "Both bodies slide along the line of action on a spring, cubic as well as linear, and a damper; the \
            teeth join them by the pulsating stiffness *k*(*t*), while they touch. The bodies move with a computed \
            response of the full model with its dead zone; displacements are exaggerated by the factor shown.",
        parameters: LOADED,
        preset: preset!["zeta" = 0.07, "alpha" = 0.0, "F" = 1.5, "Omega" = 1.6; regime = "backlash"],
        animated: true,
        starts: true,
        aspect: 1.6,
        heavy: true,
        ..BLANK
    },
    determinants(
        "2",
        "Determinants in the tongue of the second mode",
        "Determinant of the slow flow's Jacobian at its equilibria, (68)–(70): above zero a centre, below zero a \
            saddle. The stars at *Ω*_{L} and *Ω*_{R} mark the pitchforks, where two of the curves meet on the axis; the \
            blue dots are the exact edges, with damping and without.",
    ),
    branches(
        "3",
        "Pitchforks in the tongue of the second mode",
        "Amplitude *R*_{B} of the second mode over the detuning *Ω*_{1} = (*Ω* − *Ω*_{0})/*k*_{0}, for hardening (+*α*) and \
            softening (−*α*) supports, as a plane diagram and in space. Grey: the paper's (62)–(64), without damping; \
            green: with damping; blue and vermilion: exact. Solid is stable, dashed unstable; the green star is a \
            supercritical pitchfork, the yellow star a subcritical one.",
    ),
    determinants(
        "4",
        "Determinants in the tongue of the third mode",
        "The same as figure 2 for the third mode, (92)–(94): the Jacobian's determinant at the equilibria over \
            *Ω*_{1}, with the pitchforks at *Ω*_{L} and *Ω*_{R}.",
    ),
    branches(
        "5",
        "Pitchforks in the tongue of the third mode",
        "The same as figure 3 for the third mode: amplitude *R*_{C} over *Ω*_{1} for hardening and softening supports. \
            Grey: the paper's (87)–(89), without damping; green: with damping, which narrows this tongue by much more; \
            blue and vermilion: exact.",
    ),
    Specification {
        id: "6",
        title: "Eigenvalues at the origin in the combination tongue",
        caption: "Real and imaginary parts of the slow flow's four eigenvalues at the origin over *Ω*_{1}. Grey: (111) \
            as printed, on the paper's scale; thin green: with the time scale of each mode, so that they are growth \
            rates; bold green: with damping as well. Stars mark the Hopf points of each. Blue and vermilion: exact, from \
            the multipliers; diamonds: the exact edges.",
        parameters: LINEAR,
        aspect: 1.7,
        heavy: true,
        ..BLANK
    },
    branches(
        "7",
        "Hopf bifurcations in the combination tongue",
        "Radii *R*_{B} and *R*_{C} of the limit cycles over *Ω*_{1}, for hardening and softening supports, and the cycles \
            in space. With damping (green) a stable cycle is born at the supercritical edge and goes on beyond the other \
            edge, where an unstable one is born. Grey: the nontrivial solutions of (106)–(109) as printed; blue: exact tori.",
    ),
    Specification {
        id: "8",
        title: "Eigenvalues of the origin across three tongues",
        caption: "(a), (b) Characteristic exponents of the origin as *Ω* runs from the second mode's tongue through the \
            combination tongue to the third mode's, seen in a frame that turns with *Ω*/2. Blue and vermilion: exact, \
            ln(multiplier)/*T*; green: slow flow of each tongue. The ring marks the present *Ω*. (c) What kind of \
            point the origin is along *Ω*.",
        parameters: LINEAR_AT,
        preset: preset!["Omega" = 1.65],
        aspect: 1.15,
        heavy: true,
        ..BLANK
    },
    overall(
        "9",
        "The whole diagram, hardening supports",
        "All first-order branches over *Ω*, hardening supports (+*α*): the pitchforks of the second and third modes \
            and the limit cycles between them. Grey: as printed, undamped; green: corrected, with damping; blue and \
            vermilion: exact, as half of the greatest |*u*_{p}|, which for a torus is both radii together.",
    ),
    overall(
        "10",
        "The whole diagram, softening supports",
        "The same as figure 9 for softening supports (−*α*): every branch leans to lower *Ω*, and the supercritical edge of \
            each tongue is the right one.",
    ),
    map(
        "11a",
        "Stroboscopic map, second mode's tongue, Ω = 1.55",
        NODES_CAPTION,
        preset!["zeta" = 0.052, "Omega" = 1.55],
    ),
    map(
        "11b",
        "Stroboscopic map, second mode's tongue, Ω = 1.60",
        NODES_CAPTION,
        preset!["zeta" = 0.03, "Omega" = 1.6],
    ),
    map(
        "11c",
        "Stroboscopic map, second mode's tongue, Ω = 1.65",
        NODES_CAPTION,
        preset!["zeta" = 0.02, "Omega" = 1.65],
    ),
    map(
        "12a",
        "Stroboscopic map, combination tongue, Ω = 3.65",
        CYCLE_CAPTION,
        preset!["zeta" = 0.02, "Omega" = 3.65],
    ),
    map(
        "12b",
        "Stroboscopic map, combination tongue, Ω = 3.70",
        CYCLE_CAPTION,
        preset!["zeta" = 0.02, "Omega" = 3.7],
    ),
    map(
        "12c",
        "Stroboscopic map, combination tongue, Ω = 3.75",
        CYCLE_CAPTION,
        preset!["zeta" = 0.02, "Omega" = 3.75],
    ),
    map(
        "13a",
        "Stroboscopic map, third mode's tongue, Ω = 5.30",
        NODES_CAPTION,
        preset!["zeta" = 0.02, "Omega" = 5.3],
    ),
    map(
        "13b",
        "Stroboscopic map, third mode's tongue, Ω = 5.40",
        NODES_CAPTION,
        preset!["zeta" = 0.02, "Omega" = 5.4],
    ),
    map(
        "13c",
        "Stroboscopic map, third mode's tongue, Ω = 5.50",
        NODES_CAPTION,
        preset!["zeta" = 0.02, "Omega" = 5.5],
    ),
    response(
        "14a",
        "Time response, linear supports",
        "Transmission error *u* from rest at (0, 0, 1), in the second mode's tongue, supports without cubic part. Dashed: \
            permanent contact (25), as in the paper, which grows without bound; blue: with the dead zone of (23), which \
            settles on a bounded motion that loses contact. Light red: the dead zone.",
        preset!["zeta" = 0.07, "alpha" = 0.0, "F" = 1.5, "Omega" = 1.6; regime = "contact"],
    ),
    response(
        "14b",
        "Time response, softening supports",
        "The same as figure 14 a with softening supports: the motion stays bounded and clear of the dead zone, so that both \
            regimes agree.",
        preset!["zeta" = 0.07, "alpha" = -1.3, "F" = 1.5, "Omega" = 1.6; regime = "contact"],
    ),
    Specification {
        id: "T",
        title: "Tongues of instability",
        caption: "Where rest is unstable, over mesh frequency and depth of the pulsation. Colour: the exact growth rate; white: \
            stable. Blue: exact boundaries, where a multiplier passes −1 (plain) or a pair leaves the unit circle \
            (small circles). Grey: the paper\u{2019}s first order; green: first order with damping. The ring is the \
            present *Ω* and *k*_{0}: drag it. Of a loaded pair with cubic supports it is the response to the load whose growth is \
            shown.",
        parameters: LINEAR_AT,
        aspect: 1.6,
        divisible: true,
        ..BLANK
    },
    Specification {
        id: "B",
        title: "All branches, exact",
        caption: "Every periodic motion that can be reached from rest by bifurcations, up to period 4*T*, followed without a \
            guess, as greatest |*u*_{p}| over *Ω*; and the tori of the combination tongue (small circles). Blue is stable, \
            vermilion dashed unstable. Green: the theory. Each bifurcation has its mark and its name.",
        parameters: BRANCHES,
        aspect: 1.6,
        heavy: true,
        ..BLANK
    },
    Specification {
        id: "M",
        title: "Multipliers beside the unit circle",
        caption: "By what factors small deviations change in one mesh period: the six Floquet multipliers at the present \
            *Ω* (rings), the way they take as *Ω* changes by 15 per cent to either side, and their magnitudes over all \
            of *Ω*. Outside of the unit circle, or above one, a deviation grows: through −1 at the edges of the primary \
            tongues, as a pair at those of the combination tongue.",
        parameters: LINEAR_AT,
        aspect: 1.9,
        heavy: true,
        ..BLANK
    },
    Specification {
        id: "S",
        title: "Raised and lowered",
        caption: "No theory, only patience: *Ω* is raised in small steps and the pair is given time to settle at each, then \
            lowered again. Dots are its positions once a mesh period. Where blue and dark dots differ, what the pair \
            does depends on where it comes from.",
        parameters: BRANCHES,
        aspect: 1.8,
        heavy: true,
        ..BLANK
    },
    Specification {
        id: "L",
        title: "The least load that keeps the teeth together",
        caption: "Left: the smallest mean load *F* under which the steady response is stable and its teeth never part, over \
            *Ω*; in the bands no load helps. Right: one period of the response at the ring, with its least *u*. Drag the \
            ring to change *Ω* and *F*.",
        parameters: LOADED,
        preset: preset!["E" = 0.1, "F" = 1.0, "Omega" = 1.2; regime = "contact"],
        aspect: 1.9,
        heavy: true,
        ..BLANK
    },
    Specification {
        id: "A",
        title: "Which start goes where",
        caption: "Each point is a start, pinion and gear opposed, the transmission error at rest. Its colour says where the \
            motion ends: at which point of which attractor it is at the flash, or that it escapes (grey). The picture \
            grows finer as it is computed.",
        parameters: MAP,
        preset: preset!["zeta" = 0.02, "Omega" = 1.65],
        aspect: 1.2,
        heavy: true,
        ..BLANK
    },
    Specification {
        id: "U",
        title: "The motion in time",
        caption: "Transmission error *u* from any start. Light red: the dead zone, where no tooth touches; a cross marks where \
            contact is lost for the first time. A start on an orbit shows that orbit, be it stable or not.",
        parameters: LOADED,
        preset: preset!["zeta" = 0.07, "F" = 1.5, "Omega" = 1.6; regime = "backlash"],
        starts: true,
        aspect: 2.0,
        heavy: true,
        ..BLANK
    },
    Specification {
        id: "P",
        title: "The motion once a mesh period",
        caption: "Stroboscopic map: where a motion from any start is at each flash, *T* = 2π/*Ω* apart. Light: on its way; dark \
            blue: what it settles on, or stays near; red, orange: the fixed point in the middle, where it is unstable. The map \
            fills in as it is computed.",
        parameters: LOADED,
        preset: preset!["Omega" = 1.65],
        starts: true,
        aspect: 1.35,
        heavy: true,
        ..BLANK
    },
    Specification {
        id: "W",
        title: "The whine: a spectrum",
        caption: "Amplitudes of *u* over frequency, on a logarithmic scale, where the motion from a start has settled. Lines at \
            multiples of the mesh frequency *Ω*: a motion of period *T*; at its halves: one of period 2*T*; lines between \
            them: one of two frequencies.",
        parameters: LOADED,
        preset: preset!["zeta" = 0.07, "F" = 1.5, "Omega" = 1.6; regime = "backlash"],
        starts: true,
        aspect: 2.0,
        heavy: true,
        ..BLANK
    },
    Specification {
        id: "E",
        title: "What the paper prints, and what is so",
        caption: "Line by line: where it stands, what is printed, what it should be, and what the exact system says, \
            computed as the page loads. The drawing shows the numbers among them: how far the printed one (grey) and \
            the corrected one (green) are off the exact one.",
        parameters: MODAL,
        aspect: 1.5,
        heavy: true,
        ..BLANK
    },
];

/// Every figure: the paper's in its order, then those beyond it.
pub fn specifications() -> &'static [Specification] {
    &SPECIFICATIONS
}

/// The figure of that id.
///
/// # Errors
/// [`FigureError::UnknownFigure`] where there is none.
pub fn specification(id: &str) -> Result<&'static Specification, FigureError> {
    SPECIFICATIONS
        .iter()
        .find(|specification| specification.id == id)
        .ok_or_else(|| FigureError::UnknownFigure { given: id.to_owned() })
}

impl Specification {
    /// Where the motion shown starts with the figure's own parameters when nothing is said; zeros for a figure without one.
    pub fn usual_start(&self) -> [f64; 6] {
        if self.starts { self.with(&[]).map(|p| default_state(&p)).unwrap_or_default() } else { [0.0; 6] }
    }

    /// The parameters of this figure: what was given, the preset for what was not, the defaults for the rest.
    ///
    /// # Errors
    /// The [`crate::error::ModelError`] of [`Parameters::from_named`], as a [`FigureError`].
    pub fn with(&self, given: &[(String, Value)]) -> Result<Parameters, FigureError> {
        let preset = self.preset.iter().map(|(name, preset)| (*name, preset.value()));
        let given = given.iter().map(|(name, value)| (name.as_str(), value.clone()));
        Ok(Parameters::from_named(preset.chain(given))?)
    }
}
