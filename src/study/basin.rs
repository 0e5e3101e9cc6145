//! Basins of attraction over a plane of starts: which start goes to which attractor, and which escapes.
//!
//! The attractors are looked for first, from a few starts spread over the plane, always the same ones, so that several
//! workers who each do a share of the plane number them alike. A start is then followed until it is in a neighbourhood
//! of an attracting orbit that its map is known to contract ([`crate::numerics::contraction`]), near the points of an
//! attractor that never repeats, certain to stay inside the tooth gap, or beyond the bounds of escape. Cells are done
//! from coarse to fine.

use super::ErrorEstimate;
use super::grid::Grid;
use super::motion::{self, TOLERANCE};
use super::multipliers::{Budget, SLICE, common_period, trivial_state};
use super::slices::Slices;
use super::time_response::largest_difference;
use crate::error::StudyError;
use crate::model::equations::GearPair;
use crate::model::lanes::{LANES, OnManifold};
use crate::model::parameters::{Parameters, Regime};

mod attractor;
mod lanes;
use attractor::{Arrival, Known, Search};
pub use attractor::{Attractor, AttractorKind};

/// The start escapes.
pub const ESCAPED: i32 = -1;
/// The start has not been done yet, or has come to no attractor within the periods given.
pub const UNDECIDED: i32 = -2;

/// Steps that a period counts which could not be carried through.
const FAILED: usize = 400_000;
/// Integration steps of a share, and besides of each of its cells: some seconds for a small picture. What is left then
/// stays undecided.
const MOST_STEPS: (usize, usize) = (600_000, 1000);
/// Periods within which a start decides itself, as a rule, and most that are granted to the slowest attractor.
const FEWEST_PERIODS: usize = 600;
const MOST_PERIODS: usize = 6000;
/// Starts along each axis from which attractors are looked for.
const SEARCH: usize = 7;
/// Integration steps of the search for attractors.
const SEARCH_STEPS: usize = 800_000;
/// Most cells.
const MOST_CELLS: usize = 1 << 22;
/// Widest distance of the cells done first.
const COARSEST: usize = 16;

/// What to compute.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BasinOptions {
    /// Which coordinates of the state are the plane's: indices 0 to 5, two different ones.
    pub plane: [usize; 2],
    /// Values of the first.
    pub x: Grid,
    /// Values of the second.
    pub y: Grid,
    /// The other coordinates. Pinion and gear start opposed: a coordinate of the one in the plane gives the other's,
    /// unless both are in it.
    pub state: [f64; 6],
    /// Periods after which a start that has come to no attractor is left undecided, 1 to 100,000; none: as many as the
    /// multipliers of the slowest attractor ask for.
    pub periods: Option<usize>,
    /// Tolerance of the states, 1e-14 to 1e-3: near the edges of the basins it decides.
    pub tolerance: f64,
    /// Which share of how many.
    pub share: (usize, usize),
}

impl BasinOptions {
    /// The plane of `u_p` and `u_p'` about the unloaded state, to 1e-6, all in one share.
    pub fn new(p: &Parameters, x: Grid, y: Grid) -> Self {
        Self { plane: [0, 3], x, y, state: trivial_state(p), periods: None, tolerance: 1e-6, share: (0, 1) }
    }
}

/// The picture so far.
#[derive(Clone, Debug, PartialEq)]
pub struct Basin {
    /// Index of the attractor of each cell, `i_y * n_x + i_x`; [`ESCAPED`], [`UNDECIDED`].
    pub attractor: Vec<i32>,
    /// At which of the orbit's points, in the order of [`Attractor::points`], the cell's motion is at t = 0, in the limit:
    /// two cells of one attractor with different numbers come to the same orbit, some mesh periods apart.
    pub phase: Vec<u8>,
    /// The attractors.
    pub attractors: Vec<Attractor>,
    /// Cells of this share that have been done.
    pub done: usize,
    /// Cells of this share.
    pub cells: usize,
    /// How it was computed.
    pub method: String,
    /// What is known of the error: `step`, the change of a state over one period when the tolerance is a hundredth.
    pub error: ErrorEstimate,
}

/// What remains to be done.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Stage {
    /// The attractors are looked for.
    Search,
    /// The next cell of the order.
    Cells(usize),
    Done,
}

/// A start under way.
#[derive(Clone, Debug, PartialEq)]
struct Cell {
    index: usize,
    state: [f64; 6],
    periods: usize,
    arrival: Arrival,
}

/// What became of a cell in a period.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Carried {
    /// It goes on.
    On,
    /// It escaped.
    Escaped,
    /// Its integration failed.
    Failed,
}

/// Basins in the making.
#[derive(Debug)]
pub struct BasinWork {
    pair: GearPair,
    options: BasinOptions,
    common: usize,
    search: Slices<Result<Found, StudyError>>,
    known: Vec<Known>,
    stage: Stage,
    /// The cells of this share, coarse to fine.
    order: Vec<u32>,
    /// Cells under way: as many as there are lanes, or one.
    cells: Vec<Cell>,
    /// The field of several motions side by side, where all starts are on the manifold `u_g = -u_p`.
    lanes: Option<OnManifold>,
    /// Where the plane is its own mirror image under `u -> -u`: the attractor and the shift of phase that each attractor
    /// and phase turns into.
    mirror: Option<Vec<(i32, Vec<u8>)>>,
    mirrored: bool,
    steps: usize,
    /// Periods after which a start is left undecided.
    most: usize,
    basin: Basin,
}

impl BasinWork {
    /// Prepares the work.
    ///
    /// # Errors
    /// [`StudyError::Option`] for an option out of range, [`StudyError::Model`] for an incommensurate load.
    pub fn new(p: &Parameters, options: &BasinOptions) -> Result<Self, StudyError> {
        motion::check_tolerance(options.tolerance)?;
        check(options)?;
        let common = common_period(p)?;
        let pair = GearPair::new(p);
        let cells = options.x.count * options.y.count;
        let mirrored = is_mirrored(p, options);
        let (share, shares) = options.share;
        let order: Vec<u32> = coarse_to_fine(options.x.count, options.y.count)
            .into_iter()
            // Of two mirror images only the first is followed.
            .filter(|&cell| !mirrored || (cell as usize) <= cells - 1 - cell as usize)
            .enumerate()
            .filter(|(place, _)| place % shares == share)
            .map(|(_, cell)| cell)
            .collect();
        let basin = Basin {
            attractor: vec![UNDECIDED; cells],
            phase: vec![0; cells],
            attractors: Vec::new(),
            done: 0,
            cells: order.len(),
            method: "Taylor series from period to period; orbits by Newton's method, decided in a neighbourhood that the map contracts"
                .into(),
            error: ErrorEstimate::default(),
        };
        Ok(Self {
            pair,
            options: *options,
            common,
            search: Slices::new(search(Box::new(Search {
                pair,
                options: *options,
                common,
                mirrored: mirrored || p.regime == Regime::Homogeneous,
            }))),
            known: Vec::new(),
            stage: Stage::Search,
            order,
            cells: Vec::new(),
            lanes: OnManifold::new(p).filter(|_| common == 1 && starts_on_manifold(options)),
            mirror: None,
            mirrored,
            steps: 0,
            most: options.periods.unwrap_or(FEWEST_PERIODS),
            basin,
        })
    }

    /// Does a slice of the work; true when all is done.
    ///
    /// # Errors
    /// [`StudyError::Numerics`] where the integration fails.
    pub fn advance(&mut self) -> Result<bool, StudyError> {
        if self.stage == Stage::Search {
            if let Some(found) = self.search.advance() {
                let found = found?;
                (self.known, self.basin.error.step) = (found.known, found.change);
                self.close_search();
            }
            return Ok(false);
        }
        let until = self.steps + SLICE;
        while self.steps < until && self.stage != Stage::Done {
            self.follow();
        }
        Ok(self.stage == Stage::Done)
    }

    /// The picture so far.
    pub fn basin(&self) -> &Basin {
        &self.basin
    }

    fn close_search(&mut self) {
        self.basin.attractors = self.known.iter().map(|known| known.attractor.clone()).collect();
        if self.mirrored {
            self.mirror =
                Some(self.known.iter().map(|known| attractor::mirror_image(known, &self.known)).collect());
        }
        if self.options.periods.is_none() {
            let slowest = self.known.iter().filter_map(Known::patience).fold(0.0, f64::max);
            self.most = (slowest as usize).clamp(FEWEST_PERIODS, MOST_PERIODS);
        }
        self.stage = Stage::Cells(0);
    }

    /// The next cell of the order whose start is within the bounds of escape.
    fn next_cell(&mut self) -> Option<Cell> {
        while let Stage::Cells(place) = self.stage {
            let index = *self.order.get(place)? as usize;
            self.stage = Stage::Cells(place + 1);
            let (x, y) = (index % self.options.x.count, index / self.options.x.count);
            let state = self.options.start(self.options.x.value(x), self.options.y.value(y));
            if motion::check_state(&self.pair, &state).is_ok() {
                return Some(Cell { index, state, periods: 0, arrival: Arrival::default() });
            }
            self.decide(index, ESCAPED, 0);
        }
        None
    }

    /// Carries the cells under way through one period, and begins others in the place of those that are decided.
    fn follow(&mut self) {
        if self.steps > MOST_STEPS.0 + MOST_STEPS.1 * self.order.len() {
            self.stage = Stage::Done;
            return;
        }
        let side_by_side = if self.lanes.is_some() { LANES } else { 1 };
        while self.cells.len() < side_by_side {
            let Some(cell) = self.next_cell() else { break };
            self.cells.push(cell);
        }
        if self.cells.is_empty() {
            self.stage = Stage::Done;
            return;
        }
        let mut cells = std::mem::take(&mut self.cells);
        let (escaped, steps) = match &self.lanes {
            Some(field) => lanes::carry(field, &self.pair, &mut cells, self.options.tolerance),
            None => self.carry_alone(&mut cells[0]),
        };
        // To look for a cell among an attractor's thousand points costs about a step.
        let crowds = self.known.iter().filter(|known| known.attractor.kind == AttractorKind::Torus).count();
        self.steps += steps + crowds * cells.len();
        for (lane, mut cell) in cells.into_iter().enumerate() {
            cell.periods += 1;
            let verdict = match escaped[lane] {
                Carried::Escaped => Some((ESCAPED, 0)),
                Carried::Failed => Some((UNDECIDED, 0)),
                Carried::On => {
                    let arrival = &mut cell.arrival;
                    attractor::arrived(
                        &self.pair.parameters,
                        &self.known,
                        &cell.state,
                        cell.periods,
                        self.common,
                        arrival,
                    )
                    .map(|(attractor, phase)| (number(attractor), phase))
                }
            };
            match verdict {
                Some((attractor, phase)) => self.decide(cell.index, attractor, phase),
                None if cell.periods >= self.most => self.decide(cell.index, UNDECIDED, 0),
                None => self.cells.push(cell),
            }
        }
    }

    /// Carries one cell through one period.
    fn carry_alone(&self, cell: &mut Cell) -> ([Carried; LANES], usize) {
        let period = self.pair.parameters.mesh_period();
        let start = (cell.periods % self.common) as f64 * period;
        let reached = motion::carry(&self.pair, start, cell.state, start + period, self.options.tolerance);
        // A period that takes more steps than any study grants it is one that cannot be decided.
        let Ok(reached) = reached else { return ([Carried::Failed; LANES], FAILED) };
        cell.state = reached.state;
        let carried = if reached.escaped.is_some() { Carried::Escaped } else { Carried::On };
        ([carried; LANES], reached.steps)
    }

    fn decide(&mut self, index: usize, attractor: i32, phase: u8) {
        self.basin.done += 1;
        self.basin.attractor[index] = attractor;
        self.basin.phase[index] = phase;
        if !self.mirrored {
            return;
        }
        let image = self.basin.attractor.len() - 1 - index;
        if image == index {
            return;
        }
        let (other, other_phase) = match (usize::try_from(attractor), &self.mirror) {
            (Ok(known), Some(mirror)) => {
                let (other, phases) = &mirror[known];
                (*other, phases.get(phase as usize).copied().unwrap_or(0))
            }
            _ => (attractor, 0),
        };
        self.basin.attractor[image] = other;
        self.basin.phase[image] = other_phase;
    }
}

impl BasinOptions {
    /// The start that belongs to a place in the plane.
    fn start(&self, x: f64, y: f64) -> [f64; 6] {
        let (mut state, plane) = (self.state, self.plane);
        for (coordinate, value) in plane.into_iter().zip([x, y]) {
            state[coordinate] = value;
        }
        for (coordinate, value) in plane.into_iter().zip([x, y]) {
            if let Some(partner) = partner(coordinate)
                && !plane.contains(&partner)
            {
                state[partner] = -value;
            }
        }
        state
    }
}

/// What the search came to: the attractors, and the change of a period that [`Basin::error`] tells.
#[derive(Debug)]
struct Found {
    known: Vec<Known>,
    change: Option<f64>,
}

/// Looks for attractors from starts spread over the plane.
async fn search(search: Box<Search>) -> Result<Found, StudyError> {
    let Search { pair, options, .. } = &*search;
    let change = check_period(pair, options)?;
    let budget = Budget::of(SEARCH_STEPS);
    let mut known = Vec::new();
    let place = |grid: &Grid, index: usize| {
        // Off the middle, where the unloaded state may rest unstably for ever.
        let share = (index as f64 + 0.53) / SEARCH as f64;
        grid.low + (grid.high - grid.low) * share
    };
    for index in 0..SEARCH * SEARCH {
        let start = options.start(place(&options.x, index % SEARCH), place(&options.y, index / SEARCH));
        attractor::explore(&search, start, &mut known, &budget).await?;
        if budget.left() == 0 {
            break;
        }
    }
    Ok(Found { known, change })
}

/// How much a state changes over one period when the tolerance is a hundredth.
fn check_period(pair: &GearPair, options: &BasinOptions) -> Result<Option<f64>, StudyError> {
    let start = options
        .start(0.5 * options.x.high + 0.5 * options.x.low, 0.25 * options.y.low + 0.75 * options.y.high);
    if motion::check_state(pair, &start).is_err() {
        return Ok(None);
    }
    let end = pair.parameters.mesh_period();
    let coarse = motion::carry(pair, 0.0, start, end, options.tolerance)?;
    let finer = (0.01 * options.tolerance).max(TOLERANCE.0);
    let fine = motion::carry(pair, 0.0, start, end, finer)?;
    let both = coarse.escaped.is_none() && fine.escaped.is_none();
    Ok(both.then(|| largest_difference(&coarse.state, &fine.state)))
}

/// An attractor's index as it stands in a cell.
fn number(attractor: usize) -> i32 {
    i32::try_from(attractor).unwrap_or(UNDECIDED)
}

fn check(options: &BasinOptions) -> Result<(), StudyError> {
    let refused = |option: &'static str, given: String, allowed: &str| {
        Err(StudyError::Option { option, given, allowed: allowed.into() })
    };
    let [first, second] = options.plane;
    if first > 5 || second > 5 || first == second {
        return refused("plane", format!("{:?}", options.plane), "two different coordinates of the state");
    }
    if options.state.iter().any(|value| !value.is_finite()) {
        return refused("state", format!("{:?}", options.state), "six finite numbers");
    }
    if let Some(periods) = options.periods.filter(|periods| !(1..=100_000).contains(periods)) {
        return refused("periods", periods.to_string(), "a whole number from 1 to 100000");
    }
    if options.x.count * options.y.count > MOST_CELLS {
        return refused(
            "x, y",
            format!("{} x {}", options.x.count, options.y.count),
            "at most 4194304 cells",
        );
    }
    let (share, shares) = options.share;
    if share >= shares {
        return refused(
            "share",
            format!("{share} of {shares}"),
            "counted from 0 and below the number of shares",
        );
    }
    Ok(())
}

/// Whether all starts of the plane have `u_g = -u_p`.
fn starts_on_manifold(options: &BasinOptions) -> bool {
    [[0, 1], [3, 4]].iter().all(|pair| match pair.iter().filter(|c| options.plane.contains(c)).count() {
        0 => options.state[pair[0]] + options.state[pair[1]] == 0.0,
        // The other wheel's is made opposite.
        1 => true,
        _ => false,
    })
}

/// The other wheel's coordinate.
fn partner(coordinate: usize) -> Option<usize> {
    match coordinate {
        0 => Some(1),
        1 => Some(0),
        3 => Some(4),
        4 => Some(3),
        _ => None,
    }
}

/// Whether `u -> -u`, a symmetry of the homogeneous regime, carries the plane's cells into one another.
fn is_mirrored(p: &Parameters, options: &BasinOptions) -> bool {
    let even = |grid: &Grid| grid.low == -grid.high;
    let rest = (0..6).filter(|coordinate| {
        !options.plane.contains(coordinate)
            && partner(*coordinate).is_none_or(|partner| !options.plane.contains(&partner))
    });
    p.regime == Regime::Homogeneous
        && even(&options.x)
        && even(&options.y)
        && rest.into_iter().all(|coordinate| options.state[coordinate] == 0.0)
}

/// The cells of a plane: first those of a coarse lattice, then those of ever finer ones.
fn coarse_to_fine(columns: usize, rows: usize) -> Vec<u32> {
    let mut order = Vec::with_capacity(columns * rows);
    let mut stride = COARSEST;
    loop {
        for row in (0..rows).step_by(stride) {
            for column in (0..columns).step_by(stride) {
                let earlier = stride < COARSEST && row % (2 * stride) == 0 && column % (2 * stride) == 0;
                if !earlier {
                    order.push((row * columns + column) as u32);
                }
            }
        }
        if stride == 1 {
            return order;
        }
        stride /= 2;
    }
}

/// Basins over a plane of starts.
///
/// # Errors
/// As [`BasinWork`].
pub fn basin(p: &Parameters, options: &BasinOptions) -> Result<Basin, StudyError> {
    let mut work = BasinWork::new(p, options)?;
    while !work.advance()? {}
    Ok(work.basin)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_cell_comes_once_and_the_coarse_ones_first() {
        for (columns, rows) in [(1, 1), (33, 20), (256, 256)] {
            let order = coarse_to_fine(columns, rows);
            let mut sorted = order.clone();
            sorted.sort_unstable();
            assert!(sorted.iter().enumerate().all(|(index, cell)| index == *cell as usize));
            assert_eq!(sorted.len(), columns * rows);
        }
        let order = coarse_to_fine(256, 256);
        assert!(order[..256].iter().all(|cell| cell % 16 == 0 && (cell / 256) % 16 == 0));
    }
}
