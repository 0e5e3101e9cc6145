//! One column of a chart about a loaded response: what was computed along k0, and what follows from it in between.
//!
//! Along k0 the response and the coefficients of the characteristic polynomial of its monodromy are analytic functions
//! wherever the response can be continued, so that far fewer points than a chart has need their own orbit. How far the
//! polynomial through the nearest nodes is to be believed is told by one of lower degree through fewer of them.

use crate::numerics::characteristic::{Characteristic, Factors};

/// A response that was computed.
#[derive(Clone, Debug)]
pub(super) struct Node {
    /// Its row.
    pub row: usize,
    /// The depth of the pulsation there.
    pub k0: f64,
    /// Its state at t = 0.
    pub state: [f64; 6],
    /// The characteristic polynomial of its monodromy.
    pub polynomial: Characteristic,
    /// That polynomial's factors.
    pub factors: Factors,
}

/// What the nodes lead to between them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Between {
    /// State at t = 0.
    pub state: [f64; 6],
    /// The characteristic polynomial.
    pub polynomial: Characteristic,
    /// Factors to refine from: those of the nearest node.
    pub factors: Factors,
    /// Greatest difference that fewer nodes make to a coefficient; infinite where there are too few to tell.
    pub doubt: f64,
}

/// Nodes of the polynomial that is used, and of the one it is judged by.
const NODES: usize = 8;
const FEWER: usize = 6;
/// Least number of nodes that predict a state better than the neighbours along Omega do.
const FEWEST: usize = 4;

/// The nodes of a column in rising rows, and the rows in which no response was found.
#[derive(Clone, Debug, Default)]
pub(super) struct Column {
    nodes: Vec<Node>,
    missing: Vec<usize>,
    /// Whether a response was found elsewhere than, or otherwise than, the nodes around it led to.
    pub distrusted: bool,
    /// Whether what the nodes led to was once compared with what is there.
    pub compared: bool,
}

impl Column {
    pub fn add(&mut self, node: Node) {
        let place = self.nodes.partition_point(|other| other.row < node.row);
        self.nodes.insert(place, node);
    }

    pub fn miss(&mut self, row: usize) {
        self.missing.push(row);
    }

    /// The node of this row.
    pub fn at(&self, row: usize) -> Option<&Node> {
        let place = self.nodes.partition_point(|other| other.row < row);
        self.nodes.get(place).filter(|node| node.row == row)
    }

    /// What the nearest nodes lead to; none where there are too few. No row without a response is bridged.
    pub fn between(&self, row: usize, k0: f64) -> Option<Between> {
        let below = self.missing.iter().filter(|&&missing| missing < row).max().map_or(0, |&row| row + 1);
        let above =
            self.missing.iter().filter(|&&missing| missing > row).min().copied().unwrap_or(usize::MAX);
        let first = self.nodes.partition_point(|node| node.row < below);
        let end = self.nodes.partition_point(|node| node.row < above);
        let all = &self.nodes[first..end];
        let used = nearest(all, k0, NODES);
        if used.len() < FEWEST {
            return None;
        }
        let weights = weights(used, k0);
        let closest =
            used.iter().min_by(|one, other| (one.k0 - k0).abs().total_cmp(&(other.k0 - k0).abs()))?;
        let mut state = [0.0; 6];
        for (node, weight) in used.iter().zip(&weights) {
            (0..6).for_each(|i| state[i] += weight * node.state[i]);
        }
        let polynomial = mixed(used, &weights);
        let doubt = if used.len() == NODES {
            let fewer = nearest(used, k0, FEWER);
            let other = mixed(fewer, &self::weights(fewer, k0));
            let pairs = polynomial.coefficients.iter().zip(&other.coefficients);
            pairs.fold(0.0_f64, |most, (one, other)| most.max((one - other).abs()))
        } else {
            f64::INFINITY
        };
        Some(Between { state, polynomial, factors: closest.factors, doubt })
    }
}

/// The `count` nodes nearest to a depth, which are neighbours.
fn nearest(nodes: &[Node], k0: f64, count: usize) -> &[Node] {
    let place = nodes.partition_point(|node| node.k0 < k0);
    let (mut first, mut end) = (place, place);
    while end - first < count && (first > 0 || end < nodes.len()) {
        let below = first.checked_sub(1).map_or(f64::INFINITY, |index| k0 - nodes[index].k0);
        let above = nodes.get(end).map_or(f64::INFINITY, |node| node.k0 - k0);
        if below <= above {
            first -= 1;
        } else {
            end += 1;
        }
    }
    &nodes[first..end]
}

/// Lagrange's weights of the nodes at a depth; unused ones are zero.
fn weights(nodes: &[Node], k0: f64) -> [f64; NODES] {
    let mut weights = [0.0; NODES];
    for (index, (weight, own)) in weights.iter_mut().zip(nodes).enumerate() {
        let others = nodes.iter().enumerate().filter(|(other, _)| *other != index);
        *weight = others.map(|(_, other)| (k0 - other.k0) / (own.k0 - other.k0)).product();
    }
    weights
}

fn mixed(nodes: &[Node], weights: &[f64; NODES]) -> Characteristic {
    let mut mixed = Characteristic { degree: nodes[0].polynomial.degree, coefficients: [0.0; 6] };
    for (node, weight) in nodes.iter().zip(weights) {
        for (sum, coefficient) in mixed.coefficients.iter_mut().zip(&node.polynomial.coefficients) {
            *sum += weight * coefficient;
        }
    }
    mixed
}

#[cfg(test)]
mod tests {
    use super::*;

    fn column(rows: &[usize]) -> Column {
        let mut column = Column::default();
        for &row in rows {
            let k0 = 0.01 * row as f64;
            let coefficients = std::array::from_fn(|i| ((i as f64 + 1.0) * k0).sin());
            column.add(Node {
                row,
                k0,
                state: [k0.exp(); 6],
                polynomial: Characteristic { degree: 6, coefficients },
                factors: Factors { count: 3, p: [k0; 3], q: [0.0; 3] },
            });
        }
        column
    }

    #[test]
    fn smooth_numbers_are_met_within_the_doubt() {
        let rows: Vec<usize> = (0..=100).step_by(4).collect();
        for row in [2, 33, 50, 99] {
            let k0 = 0.01 * row as f64;
            let between = column(&rows).between(row, k0).expect("enough nodes");
            let exact: [f64; 6] = std::array::from_fn(|i| ((i as f64 + 1.0) * k0).sin());
            let pairs = between.polynomial.coefficients.iter().zip(&exact);
            let off = pairs.fold(0.0_f64, |most, (one, other)| most.max((one - other).abs()));
            assert!(between.doubt < 1e-5 && off <= between.doubt, "{row}: {off:e} {:e}", between.doubt);
            assert!((between.state[3] - k0.exp()).abs() < 1e-12);
        }
    }

    #[test]
    fn the_order_in_which_nodes_come_does_not_matter_and_each_is_found_again() {
        let (up, down) = (column(&[0, 4, 8, 12]), column(&[12, 0, 8, 4]));
        assert_eq!(up.between(6, 0.06).map(|b| b.state), down.between(6, 0.06).map(|b| b.state));
        assert_eq!((down.at(8).map(|node| node.row), down.at(9).map(|node| node.row)), (Some(8), None));
    }

    #[test]
    fn no_gap_is_bridged_and_few_nodes_do_not_tell() {
        let rows: Vec<usize> = (0..=100).step_by(4).collect();
        let mut gapped = column(&rows);
        gapped.miss(50);
        // Only nodes above the gap.
        assert!(gapped.between(54, 0.54).is_some());
        gapped.miss(62);
        assert!(gapped.between(54, 0.54).is_none());
        assert!(column(&[0, 4, 8]).between(6, 0.06).is_none());
        assert_eq!(column(&[0, 4, 8, 12]).between(6, 0.06).map(|between| between.doubt), Some(f64::INFINITY));
    }
}
