//! Figure E: what the paper prints, what it should be, and what the exact system says, row by row as they are computed.

use super::compose::{Composer, Line, Points, axis, number, plane};
use super::job::{Entry, Figure, Row, Slices};
use super::tongues::Setting;
use crate::chart::drawing::{Drawing, Frame, Role};
use crate::error::FigureError;
use crate::model::parameters::{Parameters, Regime};
use crate::study::multipliers::multipliers;
use crate::study::orbit::{OrbitOptions, PeriodicOrbit, periodic_orbit};
use crate::study::time_response::{TimeResponseOptions, time_response};
use crate::study::tongue::{Tongue, tongue_edges};
use crate::theory::branches::{cycles, period_two};
use crate::theory::modes::{
    Mode, Modes, characteristic_matrix, characteristic_matrix_printed, eigenvalue_squares,
};
use crate::theory::primary::{Branch, radius_squared};
use crate::theory::{Edges, combination, damped, hill, primary};

/// Tolerance of what is integrated, and of edges.
const TOLERANCE: f64 = 1e-10;
/// The two depths from which a limit at no pulsation is taken: what is left of it goes with the fourth power.
const SHALLOW: [f64; 2] = [0.004, 0.008];
/// The pulsation and damping of the paper's figures.
const K0: f64 = 0.5;
const ZETA: f64 = 0.02;
const ALPHA: f64 = -0.2;
/// The loaded pair of figure 14.
const LOADED: (f64, f64, f64) = (0.07, 1.5, 1.6);
/// A pinion and a gear for (12): moments of inertia, kg m^2, and base radii, m.
const DISKS: [f64; 4] = [4e-4, 2.5e-3, 0.03, 0.06];
/// Widest deviation that is drawn, per cent.
const WIDEST: f64 = 140.0;

/// What the rows are made from.
#[derive(Debug)]
struct Case {
    modes: Modes,
    setting: Setting,
    /// The unloaded pair with the paper's numbers.
    paper: Parameters,
}

/// The work on figure E, one row a slice.
#[derive(Debug)]
pub(super) struct Errata {
    case: Case,
    rows: Vec<Row>,
}

impl Errata {
    /// # Errors
    /// Unequal supports.
    pub(super) fn new(parameters: &Parameters) -> Result<Self, FigureError> {
        let paper = Parameters {
            alpha_p: ALPHA,
            alpha_g: ALPHA,
            zeta: ZETA,
            zeta_p: ZETA,
            zeta_g: ZETA,
            k0: K0,
            load: 0.0,
            load_p: 0.0,
            load_g: 0.0,
            error: 0.0,
            regime: Regime::Homogeneous,
            ..*parameters
        };
        let setting = Setting::of(&paper)?;
        Ok(Self { case: Case { modes: setting.modes, setting, paper }, rows: Vec::new() })
    }

    fn drawing(&self) -> Drawing {
        let told: Vec<(usize, &Row, f64)> = self
            .rows
            .iter()
            .enumerate()
            .filter_map(|(at, row)| Some((at, row, per_cent(row.printed.number()?, row.exact.number()?)?)))
            .collect();
        let mut composer = Composer::new((1, 1));
        let count = told.len().max(1) as f64;
        let frame = composer.frame(Frame {
            bare: true,
            ..plane(
                "deviations",
                "how far off the exact value, per cent",
                (0, 0),
                axis("deviation", "", (-1.5 * WIDEST, 1.25 * WIDEST)),
                axis("row", "", (-count - 0.6, 0.8)),
            )
        });
        let exact = Line::new("exact", "the exact value", Role::Exact).stable(true);
        composer.curve(frame, exact.label("exact", 1.0), Points::plane([(0.0, -count + 0.4), (0.0, 0.5)]));
        for percent in [-100.0, -50.0, 50.0, 100.0] {
            let line =
                Line::new(format!("{percent} per cent"), format!("{percent} per cent off"), Role::Reference);
            composer.curve(frame, line, Points::plane([(percent, -count + 0.4), (percent, -count + 0.2)]));
        }
        for percent in [-100.0, -50.0, 0.0, 50.0, 100.0] {
            let words = if percent > 0.0 { format!("+{percent} %") } else { number(percent, 3) + " %" };
            composer.text(frame, &format!("scale {percent}"), &words, (percent, -count - 0.2));
        }
        let (mut printed, mut ours) = (Points::default(), Points::default());
        let mut stems = Points::default();
        for (index, (at, row, off)) in told.iter().enumerate() {
            let y = -(index as f64);
            let name = format!("row {}", at + 1);
            composer.text(frame, &name, &format!("{}. {}", at + 1, row.place), (-1.2 * WIDEST, y));
            if off.abs() > WIDEST {
                composer.text(
                    frame,
                    &format!("{name} off"),
                    &format!("{} %", number(*off, 3)),
                    (1.12 * WIDEST, y),
                );
            }
            let off = off.clamp(-WIDEST, WIDEST);
            stems.piece([(0.0, y), (off, y)]);
            printed.cloud([(off, y)]);
            let own = row.ours.number().zip(row.exact.number());
            if let Some(own) = own.and_then(|(own, exact)| per_cent(own, exact)) {
                ours.cloud([(own.clamp(-WIDEST, WIDEST), y)]);
            }
        }
        composer.curve(
            frame,
            Line::new("stems", "from the exact value to the printed one", Role::Reference),
            stems,
        );
        let line = Line::new("printed", "as printed, per cent off the exact value", Role::Paper);
        composer.marks(frame, line.label("printed", 0.3), printed);
        let line = Line::new("ours", "corrected, per cent off the exact value", Role::Corrected);
        composer.marks(frame, line.label("corrected", 0.5), ours);
        composer.drawing()
    }
}

impl Slices for Errata {
    fn advance(&mut self) -> Result<bool, FigureError> {
        if let Some(make) = ROWS.get(self.rows.len()) {
            self.rows.push(make(&self.case));
        }
        Ok(self.rows.len() >= ROWS.len())
    }

    fn figure(&self, id: &'static str, parameters: &Parameters) -> Figure {
        let compared =
            self.rows.iter().filter(|row| row.printed.number().is_some() && row.exact.number().is_some());
        let off = |row: &&Row| {
            let (printed, exact) = (row.printed.number(), row.exact.number());
            printed.zip(exact).and_then(|(printed, exact)| per_cent(printed, exact)).unwrap_or(0.0).abs()
        };
        let worst = compared.clone().max_by(|one, other| off(one).total_cmp(&off(other)));
        let worst = worst.map_or_else(String::new, |row| {
            format!("; furthest off, by {} per cent, is {}", number(off(&row), 3), plain(row.place))
        });
        let summary = format!(
            "{} lines set what the paper prints beside what is computed here, {} of them as numbers{worst}.",
            self.rows.len(),
            compared.count()
        );
        Figure {
            summary,
            method: "formulas as printed and corrected; exact: Floquet theory, periodic orbits and integration to 1e-10"
                .to_owned(),
            table: self.rows.clone(),
            ..Figure::drawn(id, parameters, self.drawing())
        }
    }
}

/// A place without the marks of its letters.
fn plain(place: &str) -> String {
    place.chars().filter(|sign| !"*_{}".contains(*sign)).collect()
}

/// How far a number is off, per cent; nothing where that has no meaning.
fn per_cent(number: f64, exact: f64) -> Option<f64> {
    (exact.abs() > 1e-9).then(|| 100.0 * (number / exact - 1.0)).filter(|off| off.is_finite())
}

type Make = fn(&Case) -> Row;

/// The lines, in the paper's order.
const ROWS: [Make; 33] = [
    |_| words("(8), (9)", "mesh damping", "*C* *x*", "*C* *x*'", "the dimension; (11) has it"),
    |_| {
        words(
            "before (11)",
            "how (11) follows",
            "(9) from (8)",
            "(8) *r*_{p}/*I*_{p} less (9) *r*_{g}/*I*_{g}",
            "algebra",
        )
    },
    equivalent_mass,
    |_| words("(15)", "mesh stiffness", "*k*_{0} sin", "*k*_{0} cos", "(10) and (17)"),
    |_| words("(16)", "*F*, *F*_{p}, *F*_{g}, *E*", "as they were", "each over *b*", "the dimension"),
    |_| words("after (22)", "the system", "conservative", "damped and driven", "(17)-(19)"),
    |_| {
        words(
            "(33)",
            "the cubic terms",
            "*u*_{p}^{3}, *u*_{g}^{3}",
            "*u*_{0p}^{3}, *u*_{0g}^{3}",
            "order of epsilon",
        )
    },
    determinant,
    coupling,
    |case| primary_width(case, Mode::Second),
    |_| {
        words(
            "after (67)",
            "Det = 0 means",
            "a pitchfork",
            "a fold, in general",
            "a pitchfork by the symmetry B to -B",
        )
    },
    |case| primary_width(case, Mode::Third),
    |_| {
        words(
            "(90), (91)",
            "signs of *W*_{3}",
            "as in (83), (84)",
            "the opposite",
            "*J* is the derivative of (83), (84)",
        )
    },
    combination_width,
    printed_solutions,
    growth,
    |_| {
        words(
            "(111), (112)",
            "*λ*^{2}, (*a*^{2} − *b*^{2})/2",
            "as said",
            "*λ*, (*a*^{2} + *b*^{2})/2",
            "the polynomial of (110)",
        )
    },
    |_| {
        words("(113)", "at *Ω*_{1} = 0", "an unstable spiral", "no turning: the imaginary part is 0", "(111)")
    },
    |case| primary_edge(case, Mode::Second, true),
    |case| primary_edge(case, Mode::Second, false),
    |case| combination_edge(case, true),
    |case| combination_edge(case, false),
    |case| primary_edge(case, Mode::Third, true),
    |case| primary_edge(case, Mode::Third, false),
    |case| amplitude(case, Mode::Second, 1.65, "Fig. 11 c"),
    |case| amplitude(case, Mode::Third, 5.4, "Fig. 13 b"),
    |case| amplitude(case, Mode::Third, 5.1, "Fig. 10"),
    beyond,
    flash,
    secondary,
    |_| {
        words(
            "Figs. 12, 13",
            "captions",
            "lost",
            "*ζ* = 0.02, *α* = −0.2, *k*_{0} = 0.5",
            "they reproduce what the text says",
        )
    },
    |case| parted(case, true),
    |case| parted(case, false),
];

fn words(
    place: &'static str,
    quantity: &str,
    printed: &'static str,
    ours: &'static str,
    remark: &'static str,
) -> Row {
    let (printed, ours) = (Entry::Words(printed), Entry::Words(ours));
    Row { place, quantity: quantity.to_owned(), printed, ours, exact: Entry::Nothing, remark }
}

fn numbers(
    place: &'static str,
    quantity: impl Into<String>,
    [printed, ours, exact]: [Option<f64>; 3],
    remark: &'static str,
) -> Row {
    let [printed, ours, exact] = [printed, ours, exact].map(Entry::from);
    Row { place, quantity: quantity.into(), printed, ours, exact, remark }
}

fn equivalent_mass(_: &Case) -> Row {
    let [i_p, i_g, r_p, r_g] = DISKS;
    let printed = i_p * i_g / (i_p * r_p * r_p + i_g * r_g * r_g);
    let ours = i_p * i_g / (i_g * r_p * r_p + i_p * r_g * r_g);
    // What a unit force through the teeth accelerates their approach by, from (3) and (4).
    let exact = 1.0 / (r_p * r_p / i_p + r_g * r_g / i_g);
    numbers(
        "(12)",
        "equivalent mass, kg, of disks of 0.4 and 2.5 g m^{2} with radii of 30 and 60 mm",
        [Some(printed), Some(ours), Some(exact)],
        "a unit force through the teeth, by (3) and (4)",
    )
}

fn determinant(case: &Case) -> Row {
    let Modes { m, k, .. } = case.modes;
    let omega_0 = primary::emanating_frequency(&case.modes, Mode::Second);
    let square = eigenvalue_squares(&case.modes, omega_0)[1];
    let value = |matrix: [[f64; 3]; 3]| {
        let minor = |i: usize, j: usize| matrix[1][i] * matrix[2][j] - matrix[1][j] * matrix[2][i];
        matrix[0][0] * minor(1, 2) - matrix[0][1] * minor(0, 2) + matrix[0][2] * minor(0, 1)
    };
    let printed = value(characteristic_matrix_printed(m, k, omega_0, square));
    let ours = value(characteristic_matrix(m, k, omega_0, square));
    numbers(
        "(35), (57)",
        "determinant at (36), second mode",
        [Some(printed), Some(ours), Some(0.0)],
        "it must be singular at its eigenvalues",
    )
}

/// The pair without damping, at a depth of the pulsation.
fn undamped(case: &Case, k0: f64) -> Parameters {
    Parameters { zeta: 0.0, zeta_p: 0.0, zeta_g: 0.0, k0, ..case.paper }
}

/// The limit at no pulsation of what is even in its depth.
fn limit(of: impl Fn(f64) -> Option<f64>) -> Option<f64> {
    let [shallow, deeper] = SHALLOW;
    let (one, other) = (of(shallow)?, of(deeper)?);
    let ratio = (deeper / shallow).powi(2);
    Some((ratio * one - other) / (ratio - 1.0))
}

/// Half the exact width over `k0`, without damping, in the limit of no pulsation.
fn exact_width(of: &dyn Fn(f64) -> Parameters, tongue: Tongue) -> Option<f64> {
    limit(|k0| {
        let edges = tongue_edges(&of(k0), tongue, 1e-12).ok()?;
        Some((edges.right? - edges.left?) / (2.0 * k0))
    })
}

fn coupling(case: &Case) -> Row {
    let equal = Modes::new(case.modes.m, 1.0);
    let ours = equal.as_ref().ok().map(combination::half_width);
    let of = |k0: f64| Parameters { k_p: 1.0, k_g: 1.0, ..undamped(case, k0) };
    numbers(
        "(41), text",
        "half-width of the combination tongue at *k* = 1, where there is said to be no coupling",
        [Some(0.0), ours, exact_width(&of, Tongue::Combination)],
        "the coupling through the pulsating stiffness stays",
    )
}

fn tongue_of(mode: Mode) -> Tongue {
    match mode {
        Mode::Second => Tongue::Primary2,
        Mode::Third => Tongue::Primary3,
    }
}

fn primary_width(case: &Case, mode: Mode) -> Row {
    let (place, quantity) = match mode {
        Mode::Second => ("(56)", "half-width *W*_{2}, over *k*_{0}"),
        Mode::Third => ("(82)", "half-width *W*_{3}, over *k*_{0}"),
    };
    let printed = primary::half_width_printed(&case.modes, mode);
    let ours = primary::half_width(&case.modes, mode);
    let exact = exact_width(&|k0| undamped(case, k0), tongue_of(mode));
    numbers(
        place,
        quantity,
        [Some(printed), Some(ours), exact],
        "right as printed; exact in the limit of no pulsation",
    )
}

fn combination_width(case: &Case) -> Row {
    let (printed, ours) =
        (combination::half_width_printed(&case.modes), combination::half_width(&case.modes));
    let exact = exact_width(&|k0| undamped(case, k0), Tongue::Combination);
    numbers(
        "(105)",
        "half-width of the combination tongue, over *k*_{0}",
        [Some(printed), Some(ours), exact],
        "each mode has a time scale of its own [T4]; exact in the limit of no pulsation",
    )
}

fn printed_solutions(case: &Case) -> Row {
    let printed = combination::printed_solutions_edge(&case.modes);
    let ours = combination::half_width(&case.modes);
    let exact = exact_width(&|k0| undamped(case, k0), Tongue::Combination);
    numbers(
        "(106)-(109)",
        "where solutions leave the origin, of which there are said to be none",
        [Some(printed), Some(ours), exact],
        "solved as printed; neither (105) nor the truth",
    )
}

fn growth(case: &Case) -> Row {
    let printed =
        combination::eigenvalues_111(&case.modes, 0.0).iter().fold(0.0_f64, |most, value| most.max(value.re));
    let ours =
        combination::growth_rates(&case.modes, 0.0).iter().fold(0.0_f64, |most, value| most.max(value.re));
    let omega = combination::emanating_frequency(&case.modes);
    let exact = limit(|k0| {
        let p = Parameters { omega, ..undamped(case, k0) };
        let radius = multipliers(&p, 1e-13).ok()?.spectral_radius;
        Some(radius.ln() / p.mesh_period() / k0)
    });
    numbers(
        "(110)",
        "growth rate at *Ω*_{1} = 0, over *k*_{0}",
        [Some(printed), Some(ours), exact],
        "rows over twice their own mode’s frequency; exact in the limit of no pulsation",
    )
}

fn side(left: bool) -> &'static str {
    if left { "left" } else { "right" }
}

fn end(edges: Option<Edges>, left: bool) -> Option<f64> {
    edges.map(|edges| if left { edges.left } else { edges.right })
}

/// The exact edge at the paper's pulsation.
fn exact_edge(p: &Parameters, tongue: Tongue, left: bool) -> Option<f64> {
    let edges = tongue_edges(p, tongue, TOLERANCE).ok()?;
    if left { edges.left } else { edges.right }
}

fn primary_edge(case: &Case, mode: Mode, left: bool) -> Row {
    let (place, name) = match mode {
        Mode::Second => ("(56) at *k*_{0} = 0.5", "second"),
        Mode::Third => ("(82) at *k*_{0} = 0.5", "third"),
    };
    let p = case.paper;
    let omega_0 = primary::emanating_frequency(&case.modes, mode);
    let printed = Edges::about(omega_0, K0 * primary::half_width_printed(&case.modes, mode));
    let ours = hill::edges(&case.setting.symmetric, mode).ok().flatten();
    numbers(
        place,
        format!("{} edge of the {name} mode’s tongue, *ζ* = 0.02", side(left)),
        [end(Some(printed), left), end(ours, left), exact_edge(&p, tongue_of(mode), left)],
        "first order is not enough: Hill's determinant; exact by Floquet theory",
    )
}

fn combination_edge(case: &Case, left: bool) -> Row {
    let omega_0 = combination::emanating_frequency(&case.modes);
    let printed = Edges::about(omega_0, K0 * combination::half_width_printed(&case.modes));
    let ours = damped::combination_edges(&case.modes, &case.setting.symmetric);
    numbers(
        "(105) at *k*_{0} = 0.5",
        format!("{} edge of the combination tongue, *ζ* = 0.02", side(left)),
        [end(Some(printed), left), end(ours, left), exact_edge(&case.paper, Tongue::Combination, left)],
        "with damping, to first order [T6]; exact by Floquet theory",
    )
}

/// The 2T orbit of the paper's pair at a mesh frequency.
fn orbit(case: &Case, omega: f64) -> Option<PeriodicOrbit> {
    let p = Parameters { omega, omega_p: omega, omega_g: omega, ..case.paper };
    let found = periodic_orbit(&p, &OrbitOptions { period: 2, guess: None, tolerance: TOLERANCE }).ok()?;
    (found.period == 2).then_some(found)
}

fn amplitude(case: &Case, mode: Mode, omega: f64, place: &'static str) -> Row {
    let symmetric = case.setting.at(omega);
    let omega_1 = (omega - primary::emanating_frequency(&case.modes, mode)) / K0;
    let square = radius_squared(&case.modes, mode, Branch::Cosine, ALPHA / K0, omega_1).ok();
    let printed = square.filter(|square| *square > 0.0).map(|square| 2.0 * square.sqrt());
    let stable = period_two(&symmetric, mode)
        .ok()
        .and_then(|both| both.into_iter().flatten().find(|orbit| orbit.stable));
    let ours = stable.map(|orbit| 2.0 * orbit.radius);
    let exact = orbit(case, omega).map(|orbit| orbit.max[0]);
    numbers(
        place,
        format!("greatest *u*_{{p}} at *Ω* = {}, motion of period 2*T*", number(omega, 4)),
        [printed, ours, exact],
        "(64) or (89), twice the radius; with damping [T7]; exact periodic orbit",
    )
}

fn beyond(case: &Case) -> Row {
    let p = Parameters { alpha_p: -ALPHA, alpha_g: -ALPHA, omega: 3.85, ..case.paper };
    let ours = p.symmetric().ok().and_then(|symmetric| cycles(&symmetric).ok()).and_then(|both| both[0]);
    let ours = ours.map(|cycle| 2.0 * (cycle.radius_b + cycle.radius_c));
    let exact = swept_up(&p);
    numbers(
        "3.3; Figs. 7, 9",
        "greatest *u*_{p} of the stable cycle at *Ω* = 3.85, *α* = +0.2, where it is said to be destroyed",
        [Some(0.0), ours, exact],
        "[T8]; exact: swept up from within the tongue",
    )
}

/// The greatest `u_p` of the motion that is carried from within the combination tongue to this frequency.
fn swept_up(p: &Parameters) -> Option<f64> {
    let mut state = [-0.02, 0.02, 0.05, 0.0, 0.0, 0.0];
    let mut greatest = None;
    for omega in [3.7, 3.74, 3.78, 3.82, p.omega] {
        let at = Parameters { omega, omega_p: omega, omega_g: omega, ..*p };
        let options = TimeResponseOptions {
            state,
            periods: if omega == 3.7 { 300.0 } else { 160.0 },
            samples_per_period: 32,
            tolerance: 1e-8,
        };
        let response = time_response(&at, &options).ok()?;
        if response.escaped.is_some() {
            return None;
        }
        state = *response.states.last()?;
        let late = response.states.iter().skip(response.states.len() / 2).map(|state| state[0].abs());
        greatest = Some(late.fold(0.0_f64, f64::max));
    }
    greatest
}

fn flash(case: &Case) -> Row {
    let omega = LOADED.2;
    let p = Parameters { omega, ..case.paper };
    let printed = omega / std::f64::consts::TAU;
    numbers(
        "4.1",
        "time between two points of the section at *Ω* = 1.6",
        [Some(printed), Some(p.mesh_period()), Some(p.mesh_period())],
        "every *T* = 2π/*Ω*, where cos *Ωt* = 1",
    )
}

fn secondary(case: &Case) -> Row {
    let p = Parameters { omega: 0.8, omega_p: 0.8, omega_g: 0.8, ..case.paper };
    let exact = multipliers(&p, TOLERANCE).ok().map(|found| found.spectral_radius);
    Row {
        printed: Entry::Words("at most 1"),
        ours: Entry::Words("a secondary tongue"),
        ..numbers(
            "5, text",
            "largest multiplier at *Ω* = 0.8, outside of the three tongues",
            [None, None, exact],
            "Floquet theory: near *ω*_{2} the origin is unstable as well",
        )
    }
}

fn parted(case: &Case, greatest: bool) -> Row {
    let (zeta, load, omega) = LOADED;
    let p = Parameters {
        zeta,
        zeta_p: zeta,
        zeta_g: zeta,
        alpha_p: 0.0,
        alpha_g: 0.0,
        load,
        omega,
        omega_p: omega,
        omega_g: omega,
        regime: Regime::Backlash,
        ..case.paper
    };
    let options = TimeResponseOptions { periods: 160.0, ..TimeResponseOptions::new(&p) };
    let late =
        time_response(&p, &options).ok().filter(|response| response.escaped.is_none()).map(|response| {
            let u = response.states.iter().skip(response.states.len() * 3 / 4).map(|state| state[2]);
            if greatest { u.fold(f64::MIN, f64::max) } else { u.fold(f64::MAX, f64::min) }
        });
    let orbit = periodic_orbit(&p, &OrbitOptions { period: 2, guess: None, tolerance: TOLERANCE }).ok();
    let exact = orbit.map(|orbit| if greatest { orbit.max[2] } else { orbit.min[2] });
    Row {
        printed: Entry::Words("unbounded"),
        ..numbers(
            "Fig. 14 a",
            format!(
                "{} *u* once it has settled, teeth free to part",
                if greatest { "greatest" } else { "least" }
            ),
            [None, late, exact],
            "with the dead zone of (23): in time, and as a periodic orbit",
        )
    }
}
