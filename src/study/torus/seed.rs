//! A first circle from a long motion, by weighted Birkhoff averages.

use super::{
    Budget, Circle, GearPair, Known, Map, Modes, NumericsError, Parameters, Regime, Section, Strobe,
    StudyError, TAU, birkhoff, branches, common_period, motion, returning, settling, stable_orbit,
};
use crate::numerics::spectrum::{Window, amplitudes};
use crate::study::multipliers::{trivial_state, unloaded};
use crate::study::orbit::{self, OrbitOptions};

/// Mesh periods after which a circle is looked for: at each of these, the earlier ones being the transient.
const STAGES: [usize; 5] = [300, 900, 2700, 8100, 16_200];
/// Points over which averages are taken.
const POINTS: usize = 1024;
/// Points over which the averages of the answer are taken, the circle being known.
const AVERAGED: usize = 1024;
/// The same where they agree slowly, at most.
const MOST_AVERAGED: usize = 8192;
/// Difference of the mean radius over the two halves of these, at which they agree.
const AGREED: f64 = 1e-7;
/// Distance from where the circle's rotation would put it at the end, relative to the circle's size, above which the
/// motion has left the circle.
const LEAVES: f64 = 1e-4;
/// Steps that the search for a loaded pair's response may take.
const RESPONSE_STEPS: usize = 5000;
/// Most circles that the map carries one into the next.
const MOST_CIRCLES: usize = 4;
/// Searches for a circle by collocation that may fail before the motion's averages are taken instead.
const MOST_FAILED: usize = 2;
/// Steps that one such search may take.
const COLLOCATION: usize = 350_000;
/// Points over which averages are taken that stand alone.
const FITTED: usize = 4096;
/// Distance of such points from their Fourier series, relative to the circle's size, up to which it represents them.
const REPRESENTED: f64 = 0.01;
/// Difference of the mean radius over their two halves, likewise, up to which the motion has settled.
const SETTLED: f64 = 1e-5;
/// The seed's defect, relative to its size, below which the collocation is tried.
const PROMISING: f64 = 0.1;

/// What the averages along a long motion give, independently of the collocation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Averages {
    /// Mean of `sqrt(u_p^2 + u_p'^2)`.
    pub mean_radius: f64,
    /// Frequency of the strongest line of `u_p` that is no harmonic of the mesh, over the mesh frequency; in [0, 1/2].
    pub rotation: f64,
}

/// Folds turns into [0, 1/2].
fn folded(turns: f64) -> f64 {
    let part = turns.rem_euclid(1.0);
    part.min(1.0 - part)
}

/// The rotation per mesh period, from that of the map of several periods: that of the answers nearest to the one seen.
pub(super) fn rotation(turns: f64, periods: usize, seen: Option<f64>) -> f64 {
    let answers = (0..periods).map(|whole| folded((turns + whole as f64) / periods as f64));
    match seen {
        Some(seen) => answers.min_by(|a, b| (a - seen).abs().total_cmp(&(b - seen).abs())),
        None => answers.min_by(f64::total_cmp),
    }
    .unwrap_or(0.0)
}

/// Starts from which a motion is followed: the cycles of \[T8\] and smaller ones, then near rest.
fn starts(p: &Parameters) -> Vec<[f64; 6]> {
    let centre = if unloaded(p) {
        trivial_state(p)
    } else {
        let period = common_period(p).unwrap_or(1);
        let options = OrbitOptions { period, ..OrbitOptions::default() };
        orbit::response(p, period, &options, &Budget::of(RESPONSE_STEPS))
            .map_or_else(|_| trivial_state(p), |orbit| orbit.state)
    };
    let mut starts = Vec::new();
    if let Ok(symmetric) = p.symmetric()
        && let (Ok(modes), Ok([Some(cycle), _])) = (Modes::of(&symmetric), branches::cycles(&symmetric))
    {
        for factor in [0.8, 0.5] {
            let (b, c) = (factor * cycle.radius_b, factor * cycle.radius_c);
            let u_p = -2.0 * (b + c);
            starts.push([u_p, -u_p, modes.a * b + modes.b * c, 0.0, 0.0, 0.0]);
        }
    }
    starts.push([-0.02, 0.02, 0.05, 0.0, 0.0, 0.0]);
    for start in &mut starts {
        for (value, centre) in start.iter_mut().zip(centre) {
            *value += centre;
        }
    }
    starts
}

/// The circle that a motion settles on.
pub(super) async fn by_motion<'a>(
    p: &Parameters,
    tolerance: f64,
    budget: &'a Budget,
) -> Result<Known<'a>, StudyError> {
    let pair = GearPair::new(p);
    let mut found = "every motion tried escapes".to_owned();
    for start in starts(p) {
        if motion::check_state(&pair, &start).is_err() {
            continue;
        }
        match settle(p, start, tolerance, budget).await? {
            Ok(known) => return Ok(known),
            Err(words) => found = words,
        }
    }
    Err(StudyError::NotFound { sought: "torus", found })
}

/// Follows one motion; where it comes to no circle, says in words to what.
async fn settle<'a>(
    p: &Parameters,
    start: [f64; 6],
    tolerance: f64,
    budget: &'a Budget,
) -> Result<Result<Known<'a>, String>, StudyError> {
    let mut strobe = Strobe::new(p, start, tolerance)?;
    let mut states = vec![start];
    let mut searches = 0;
    let mut failed = 0;
    for stage in STAGES {
        while states.len() < stage + POINTS {
            let before = strobe.steps();
            let Some(state) = strobe.next()? else { return Ok(Err("the motion escapes".into())) };
            budget.spend(strobe.steps() - before);
            budget.rest().await;
            if budget.left() == 0 {
                return Err(NumericsError::TooManySteps { time: strobe.time(), steps: strobe.steps() }.into());
            }
            states.push(state);
            if states.len() % 100 == 0
                && searches < 4
                && let Some(period) = returning(&states)
            {
                searches += 1;
                if let Some(orbit) = stable_orbit(p, state, period, settling::ELSEWHERE, tolerance, budget) {
                    return Ok(Err(format!("the motion settles on an orbit of period {} T", orbit.period)));
                }
            }
        }
        let latest = &states[states.len() - POINTS..];
        // Where it draws together on an orbit, a circle would be looked for in vain, and for long.
        let orbit = settling::drawn_to(p, latest, (common_period(p)?, settling::LONGEST), tolerance, budget);
        if let Some(orbit) = orbit {
            return Ok(Err(format!("the motion settles on an orbit of period {} T", orbit.period)));
        }
        if failed < MOST_FAILED {
            let (known, whole) = circle(p, latest, tolerance, budget).await?;
            if let Some(known) = known {
                return Ok(Ok(measured(known, tolerance).await?));
            }
            failed += usize::from(!whole);
        }
        // Where it parts the teeth the circle is not smooth, and Fourier nodes may not do: the motion itself is left. In
        // a smooth system nodes that do not converge say that there is no circle.
        if failed > 0
            && p.regime == Regime::Backlash
            && let Some(known) = by_averages(p, &mut strobe, &mut states, tolerance, budget).await?
        {
            return Ok(Ok(known));
        }
    }
    Ok(Err("the motion does not settle on a closed curve".into()))
}

/// Whether these states are on the manifold `u_g = -u_p`, and stay there.
fn on_manifold(p: &Parameters, states: &[[f64; 6]]) -> bool {
    let size = states.iter().map(settling::size).fold(0.0, f64::max);
    let opposed =
        |state: &[f64; 6]| (state[0] + state[1]).abs().max((state[3] + state[4]).abs()) < 1e-9 * size;
    p.symmetric().is_ok() && states.iter().all(opposed)
}

/// The circle as the averages along a motion have it, where collocation does not make it exactly invariant: its Fourier
/// series, as far as that represents the motion's points, with the mean radius and the rotation of the averages.
async fn by_averages<'a>(
    p: &Parameters,
    strobe: &mut Strobe,
    states: &mut Vec<[f64; 6]>,
    tolerance: f64,
    budget: &'a Budget,
) -> Result<Option<Known<'a>>, StudyError> {
    for _ in 0..MOST_AVERAGED / FITTED {
        let until = states.len() + FITTED;
        while states.len() < until {
            let before = strobe.steps();
            let Some(state) = strobe.next()? else { return Ok(None) };
            budget.spend(strobe.steps() - before);
            budget.rest().await;
            if budget.left() == 0 {
                return Ok(None);
            }
            states.push(state);
        }
        let latest = &states[states.len() - FITTED..];
        let on_manifold = on_manifold(p, latest);
        let common = common_period(p)?;
        for periods in (1..=MOST_CIRCLES).map(|circles| circles * common) {
            budget.rest().await;
            let every: Vec<[f64; 6]> = latest.iter().step_by(periods).copied().collect();
            if every.len() < FITTED / 8 {
                break;
            }
            let section = Section { pair: GearPair::new(p), periods, on_manifold, tolerance, budget };
            let Some(circle) = fitted(&section, &every, Fit { mirrored: false, count: 257, most: 100 })
            else {
                continue;
            };
            let off = every.iter().enumerate().map(|(place, state)| {
                let point = circle.point((place as f64 * circle.rotation).fract());
                section
                    .coordinates()
                    .iter()
                    .zip(point)
                    .map(|(&i, value)| (state[i] - value).abs())
                    .fold(0.0, f64::max)
            });
            let defect = off.fold(0.0, f64::max);
            if defect > REPRESENTED * circle.size() {
                continue;
            }
            let radii: Vec<f64> = latest.iter().map(|state| state[0].hypot(state[3])).collect();
            let (first, second) = radii.split_at(FITTED / 2);
            let mean = |part: &[f64]| birkhoff::mean(part, &birkhoff::weights(part.len()));
            if (mean(first) - mean(second)).abs() > SETTLED * circle.size() {
                break;
            }
            let averages = averages(latest, periods);
            return Ok(averages.map(|averages| Known {
                section,
                circle,
                defect,
                averages: Some(averages),
                collocated: false,
            }));
        }
    }
    Ok(None)
}

/// Makes a circle of the last points of a motion, if they lie near one; and whether the search came to its end, not to
/// that of the steps that it may take.
async fn circle<'a>(
    p: &Parameters,
    states: &[[f64; 6]],
    tolerance: f64,
    budget: &'a Budget,
) -> Result<(Option<Known<'a>>, bool), StudyError> {
    let own = Budget::of(COLLOCATION.min(budget.left()));
    let granted = own.left();
    let found = collocated(p, states, tolerance, &own).await;
    budget.spend(granted - own.left());
    match found {
        Ok((found, converges)) => {
            let known = found.map(|known| {
                let Known { section, circle, defect, averages, collocated } = known;
                let section = Section { budget, pair: section.pair, ..section };
                Known { section, circle, defect, averages, collocated }
            });
            Ok((known, converges))
        }
        Err(StudyError::Numerics(NumericsError::TooManySteps { .. })) if budget.left() > 0 => {
            Ok((None, false))
        }
        Err(error) => Err(error),
    }
}

/// As [`circle`], within the budget.
async fn collocated<'a>(
    p: &Parameters,
    states: &[[f64; 6]],
    tolerance: f64,
    budget: &'a Budget,
) -> Result<(Option<Known<'a>>, bool), StudyError> {
    let common = common_period(p)?;
    let on_manifold = on_manifold(p, states);
    let mut converges = true;
    for circles in 1..=MOST_CIRCLES {
        let periods = circles * common;
        let every: Vec<[f64; 6]> = states.iter().step_by(periods).copied().collect();
        if every.len() < 128 {
            break;
        }
        let section = Section { pair: GearPair::new(p), periods, on_manifold, tolerance, budget };
        for mirrored in [true, false] {
            if mirrored && p.regime != Regime::Homogeneous {
                continue;
            }
            let fit = if mirrored {
                Fit { mirrored, count: 32, most: 12 }
            } else {
                Fit { mirrored, count: 65, most: 20 }
            };
            let Some(seed) = fitted(&section, &every, fit) else { continue };
            let map: &mut Map = &mut |point, to, derivative| section.map(point, to, derivative);
            match seed.defect(map, 4) {
                Ok(defect) if defect < PROMISING * seed.size() => (),
                Err(error @ NumericsError::TooManySteps { .. }) => return Err(error.into()),
                _ => continue,
            }
            match section.converge(seed).await {
                Ok((circle, defect)) => {
                    let known = Known { section, circle, defect, averages: None, collocated: true };
                    return Ok((Some(single(known, common).await?), true));
                }
                Err(error @ NumericsError::TooManySteps { .. }) => return Err(error.into()),
                Err(_) => converges = false,
            }
        }
    }
    Ok((None, converges))
}

/// The same circle as one of the map of the least period, if it is: a motion that still grows may have been fitted by
/// every second of its points only.
async fn single(known: Known<'_>, common: usize) -> Result<Known<'_>, StudyError> {
    let several = known.section.periods / common;
    for whole in 0..several {
        if several == 1 {
            break;
        }
        let section = Section { periods: common, pair: known.section.pair, ..known.section };
        let rotation = (known.circle.rotation + whole as f64) / several as f64;
        let circle = Circle { rotation, ..known.circle.clone() };
        let map: &mut Map = &mut |point, to, derivative| section.map(point, to, derivative);
        if circle.defect(map, 4)? < 0.01 * circle.size()
            && let Ok((circle, defect)) = section.converge(circle).await
        {
            return Ok(Known { section, circle, defect, averages: None, collocated: true });
        }
    }
    Ok(known)
}

/// The strongest frequency of a series, its mean taken off, in turns a sample.
fn strongest(series: &[f64], weights: &[f64], forbidden: &dyn Fn(f64) -> bool) -> Option<f64> {
    let mean = birkhoff::mean(series, weights);
    let varying: Vec<f64> = series.iter().map(|value| value - mean).collect();
    let lines = amplitudes(&varying, Window::BlackmanHarris);
    let turns = |line: usize| line as f64 / series.len() as f64;
    let line = (1..lines.len())
        .filter(|&line| !forbidden(turns(line)))
        .max_by(|&i, &j| lines[i].total_cmp(&lines[j]))?;
    (lines[line] > 1e-9).then(|| birkhoff::frequency(&varying, weights, turns(line)))
}

/// How a closed curve is fitted: with which symmetry, by how many nodes, up to which harmonic.
#[derive(Clone, Copy, Debug)]
struct Fit {
    mirrored: bool,
    count: usize,
    most: u32,
}

/// The closed curve through the points of a motion, by its Fourier coefficients as averages.
fn fitted(section: &Section, states: &[[f64; 6]], fit: Fit) -> Option<Circle> {
    let Fit { mirrored, count, most } = fit;
    let weights = birkhoff::weights(states.len());
    let column = |coordinate: usize| -> Vec<f64> { states.iter().map(|state| state[coordinate]).collect() };
    let turns = strongest(&column(0), &weights, &|_| false)?;
    let dimension = section.dimension();
    let spacing = 1.0 / (count * if mirrored { 2 } else { 1 }) as f64;
    let coordinates = section.coordinates();
    let mut nodes = vec![0.0; count * dimension];
    for (place, &coordinate) in coordinates.iter().enumerate() {
        let series = column(coordinate);
        for harmonic in 0..=most {
            if mirrored && harmonic % 2 == 0 {
                continue;
            }
            let [re, im] =
                birkhoff::coefficient(&series, &weights, (f64::from(harmonic) * turns).rem_euclid(1.0));
            let sides = if harmonic == 0 { 1.0 } else { 2.0 };
            for node in 0..count {
                let (sine, cosine) = (TAU * f64::from(harmonic) * node as f64 * spacing).sin_cos();
                nodes[node * dimension + place] += sides * (re * cosine - im * sine);
            }
        }
    }
    Some(Circle { dimension, mirrored, nodes, rotation: turns })
}

/// Adds the averages of a motion that starts on the circle: a motion that came to it may not have settled for long.
async fn measured(mut known: Known<'_>, tolerance: f64) -> Result<Known<'_>, StudyError> {
    let section = known.section;
    let start = section.expand(&known.circle.nodes[..known.circle.dimension]);
    let mut strobe = Strobe::new(&section.pair.parameters, start, tolerance)?;
    let mut states = Vec::with_capacity(AVERAGED);
    let mut count = AVERAGED;
    loop {
        while states.len() < count {
            states.push(strobe.state());
            let before = strobe.steps();
            if strobe.next()?.is_none() {
                return Ok(known);
            }
            section.spend(strobe.steps() - before)?;
            section.budget.rest().await;
        }
        // Where the circle repels, the motion has left it at the end.
        let passages = (count - 1) / section.periods;
        let on_circle = known.circle.point((passages as f64 * known.circle.rotation).fract());
        let last = states[passages * section.periods];
        let near = LEAVES * known.circle.size();
        if section.coordinates().iter().zip(&on_circle).any(|(&i, value)| (last[i] - value).abs() > near) {
            return Ok(known);
        }
        let radii: Vec<f64> = states.iter().map(|state| state[0].hypot(state[3])).collect();
        let mean = |part: &[f64]| birkhoff::mean(part, &birkhoff::weights(part.len()));
        // As long as the two halves differ, more points are wanted.
        let (first, second) = radii.split_at(count / 2);
        if (mean(first) - mean(second)).abs() < AGREED || count >= MOST_AVERAGED {
            break;
        }
        count *= 2;
    }
    known.averages = averages(&states, section.periods);
    Ok(known)
}

/// Mean radius and rotation along a motion of one point a mesh period; the circles are visited in turn, `periods` after
/// one another.
fn averages(states: &[[f64; 6]], periods: usize) -> Option<Averages> {
    let weights = birkhoff::weights(states.len());
    let radii: Vec<f64> = states.iter().map(|state| state[0].hypot(state[3])).collect();
    let series: Vec<f64> = states.iter().map(|state| state[0]).collect();
    let periods = periods as f64;
    // Lines of several circles that belong to the order in which they are visited, not to the motion on them.
    let harmonic = |turns: f64| {
        let nearest = (turns * periods).round();
        periods > 1.0 && (turns * periods - nearest).abs() < 4.0 * periods / states.len() as f64
    };
    let turns = strongest(&series, &weights, &harmonic)?;
    Some(Averages { mean_radius: birkhoff::mean(&radii, &weights), rotation: folded(turns) })
}
