//! Cells carried side by side, as lanes of one integration.

use super::{Carried, Cell, FAILED};
use crate::model::equations::{DIVERGED, GearPair};
use crate::model::lanes::{LANES, OnManifold, SIZE, lane, set_lane};
use crate::numerics::ode::taylor::{Options, Propagation};
use crate::study::motion::{self, ORDER_16};

/// Most steps of one period of all lanes; stiffer motions are carried one by one.
const MOST_STEPS: usize = 4000;

/// Carries at most [`LANES`] cells, at least one, through one mesh period from t = 0; gives what became of each, and the
/// work done in steps of a single motion.
pub(super) fn carry(
    field: &OnManifold,
    pair: &GearPair,
    cells: &mut [Cell],
    tolerance: f64,
) -> ([Carried; LANES], usize) {
    let end = pair.parameters.mesh_period();
    let [bound, _] = pair.escape_bounds();
    let options =
        Options { tolerance: motion::step_tolerance(tolerance), step_factor: 1.0, steps: MOST_STEPS };
    let mut all = [0.0; SIZE];
    for index in 0..LANES {
        // Lanes without a cell repeat the first, so that they ask for no other steps.
        set_lane(&mut all, index, &cells.get(index).unwrap_or(&cells[0]).state);
    }
    let mut carried = [Carried::On; LANES];
    let (mut time, mut taken) = (0.0, 0);
    while time < end {
        let mut propagation = Propagation::<_, SIZE, ORDER_16>::new(field, time, all, options);
        let mut left = None;
        while propagation.time() < end && left.is_none() {
            if propagation.step(end).is_err() {
                let (carried, steps) = one_by_one(pair, cells, tolerance);
                return (carried, 2 * taken + steps);
            }
            taken += 1;
            let now = propagation.state();
            left = (0..LANES).find(|&index| now[index].abs() > bound || now[LANES + index].abs() > DIVERGED);
        }
        (time, all) = (propagation.time(), *propagation.state());
        if let Some(gone) = left {
            carried[gone] = Carried::Escaped;
            // Something tame takes its place.
            let other = (0..LANES).find(|&index| carried[index] == Carried::On);
            match other {
                Some(other) => {
                    let tame = lane(&all, other);
                    set_lane(&mut all, gone, &tame);
                }
                None => break,
            }
        }
    }
    for (index, cell) in cells.iter_mut().enumerate() {
        cell.state = lane(&all, index);
    }
    (carried, 2 * taken)
}

fn one_by_one(pair: &GearPair, cells: &mut [Cell], tolerance: f64) -> ([Carried; LANES], usize) {
    let mut carried = [Carried::On; LANES];
    let mut steps = 0;
    for (cell, carried) in cells.iter_mut().zip(&mut carried) {
        let Ok(reached) = motion::carry(pair, 0.0, cell.state, pair.parameters.mesh_period(), tolerance)
        else {
            steps += FAILED;
            *carried = Carried::Failed;
            continue;
        };
        cell.state = reached.state;
        steps += reached.steps;
        if reached.escaped.is_some() {
            *carried = Carried::Escaped;
        }
    }
    (carried, steps)
}
