//! The table itself: name, symbol, default, range and meaning of every parameter.

/// How a number box and a slider treat a range.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// Even steps.
    Linear,
    /// Even ratios.
    Logarithmic,
}

/// One line of the table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ParameterInfo {
    /// The name by which the address, the element and the module know it.
    pub name: &'static str,
    /// Its symbol in label markup: `*x*` italic, `_{..}` subscript.
    pub symbol: &'static str,
    /// Default; for one that follows another, the other's default.
    pub default: f64,
    /// The parameter whose value it takes when not given.
    pub follows: Option<&'static str>,
    /// The short form that sets it together with its twin.
    pub short: Option<&'static str>,
    /// Least allowed value.
    pub low: f64,
    /// Greatest allowed value.
    pub high: f64,
    /// Range that a slider covers; the number box takes the whole one.
    pub slider: (f64, f64),
    /// How the slider divides its range.
    pub scale: Scale,
    /// What it means, a phrase in plain words.
    pub meaning: &'static str,
}

/// One short form, which sets two parameters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ShortForm {
    /// The short name.
    pub name: &'static str,
    /// Its symbol in label markup.
    pub symbol: &'static str,
    /// The parameters it sets.
    pub sets: [&'static str; 2],
    /// What it means.
    pub meaning: &'static str,
}

/// The short forms: equal supports (24).
pub const SHORT_FORMS: [ShortForm; 4] = [
    ShortForm {
        name: "m",
        symbol: "*m*",
        sets: ["m_p", "m_g"],
        meaning: "mass of each gear body over the equivalent mass",
    },
    ShortForm {
        name: "k",
        symbol: "*k*",
        sets: ["k_p", "k_g"],
        meaning: "stiffness of each support over the mean mesh stiffness",
    },
    ShortForm {
        name: "alpha",
        symbol: "*α*",
        sets: ["alpha_p", "alpha_g"],
        meaning: "cubic stiffness of each support: above zero hardening, below zero softening",
    },
    ShortForm {
        name: "zeta_s",
        symbol: "*ζ*_{s}",
        sets: ["zeta_p", "zeta_g"],
        meaning: "damping ratio of each support; without a value of its own, that of the mesh",
    },
];

const fn line(
    name: &'static str,
    symbol: &'static str,
    default: f64,
    range: (f64, f64),
    slider: (f64, f64),
    scale: Scale,
    meaning: &'static str,
) -> ParameterInfo {
    ParameterInfo {
        name,
        symbol,
        default,
        follows: None,
        short: None,
        low: range.0,
        high: range.1,
        slider,
        scale,
        meaning,
    }
}

const fn short(mut info: ParameterInfo, short: &'static str) -> ParameterInfo {
    info.short = Some(short);
    info
}

const fn follows(mut info: ParameterInfo, leader: &'static str) -> ParameterInfo {
    info.follows = Some(leader);
    info
}

const POSITIVE: (f64, f64) = (1e-3, 1e6);
const CUBIC: (f64, f64) = (-1e3, 1e3);
const DAMPING: (f64, f64) = (0.0, 2.0);

/// The table of numerical parameters; the regime, a word, is not in it.
pub const TABLE: [ParameterInfo; 17] = [
    short(
        line(
            "m_p",
            "*m*_{p}",
            1.0,
            POSITIVE,
            (0.1, 10.0),
            Scale::Logarithmic,
            "mass of the pinion's body over the equivalent mass",
        ),
        "m",
    ),
    short(
        line(
            "m_g",
            "*m*_{g}",
            1.0,
            POSITIVE,
            (0.1, 10.0),
            Scale::Logarithmic,
            "mass of the gear's body over the equivalent mass",
        ),
        "m",
    ),
    short(
        line(
            "k_p",
            "*k*_{p}",
            5.0,
            POSITIVE,
            (0.5, 50.0),
            Scale::Logarithmic,
            "stiffness of the pinion's support over the mean mesh stiffness",
        ),
        "k",
    ),
    short(
        line(
            "k_g",
            "*k*_{g}",
            5.0,
            POSITIVE,
            (0.5, 50.0),
            Scale::Logarithmic,
            "stiffness of the gear's support over the mean mesh stiffness",
        ),
        "k",
    ),
    short(
        line(
            "alpha_p",
            "*α*_{p}",
            -0.2,
            CUBIC,
            (-2.0, 2.0),
            Scale::Linear,
            "cubic stiffness of the pinion's support: above zero hardening, below zero softening",
        ),
        "alpha",
    ),
    short(
        line(
            "alpha_g",
            "*α*_{g}",
            -0.2,
            CUBIC,
            (-2.0, 2.0),
            Scale::Linear,
            "cubic stiffness of the gear's support: above zero hardening, below zero softening",
        ),
        "alpha",
    ),
    line("zeta", "*ζ*", 0.02, DAMPING, (0.0, 0.2), Scale::Linear, "damping ratio of the mesh"),
    follows(
        short(
            line(
                "zeta_p",
                "*ζ*_{p}",
                0.02,
                DAMPING,
                (0.0, 0.2),
                Scale::Linear,
                "damping ratio of the pinion's support",
            ),
            "zeta_s",
        ),
        "zeta",
    ),
    follows(
        short(
            line(
                "zeta_g",
                "*ζ*_{g}",
                0.02,
                DAMPING,
                (0.0, 0.2),
                Scale::Linear,
                "damping ratio of the gear's support",
            ),
            "zeta_s",
        ),
        "zeta",
    ),
    line(
        "k0",
        "*k*_{0}",
        0.5,
        (0.0, 1.0),
        (0.0, 1.0),
        Scale::Linear,
        "depth of the mesh stiffness's pulsation, the paper's epsilon",
    ),
    line(
        "Omega",
        "*Ω*",
        1.6,
        (0.01, 100.0),
        (0.4, 7.0),
        Scale::Linear,
        "mesh frequency over the natural frequency of the mesh",
    ),
    line("F", "*F*", 0.0, CUBIC, (0.0, 10.0), Scale::Linear, "mean force transmitted through the teeth"),
    line(
        "F_p",
        "*F*_{p}",
        0.0,
        CUBIC,
        (0.0, 5.0),
        Scale::Linear,
        "amplitude of the pinion's torque fluctuation, as a force",
    ),
    line(
        "F_g",
        "*F*_{g}",
        0.0,
        CUBIC,
        (0.0, 5.0),
        Scale::Linear,
        "amplitude of the gear's torque fluctuation, as a force",
    ),
    line(
        "E",
        "*E*",
        0.0,
        CUBIC,
        (0.0, 1.0),
        Scale::Linear,
        "amplitude of the static transmission error over half the backlash",
    ),
    follows(
        line(
            "Omega_p",
            "*Ω*_{p}",
            1.6,
            (1e-4, 100.0),
            (0.1, 7.0),
            Scale::Linear,
            "frequency of the pinion's torque fluctuation",
        ),
        "Omega",
    ),
    follows(
        line(
            "Omega_g",
            "*Ω*_{g}",
            1.6,
            (1e-4, 100.0),
            (0.1, 7.0),
            Scale::Linear,
            "frequency of the gear's torque fluctuation",
        ),
        "Omega",
    ),
];
