//! Symmetries of the equations: which of them an orbit has, and what it splits its linearisation into.

use super::State;
use crate::numerics::floquet::Matrix6;

/// A symmetry of order two: coordinates are exchanged, changed in sign, or both, about a centre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Symmetry {
    /// Which coordinate of the old state the new one is.
    pub from: [usize; 6],
    /// With which sign.
    pub sign: [f64; 6],
    /// The state about which it acts.
    pub centre: State,
}

impl Symmetry {
    /// Leaves every state as it is.
    pub const IDENTITY: Self = Self { from: [0, 1, 2, 3, 4, 5], sign: [1.0; 6], centre: [0.0; 6] };

    /// The state it maps a state to.
    pub fn apply(&self, state: &State) -> State {
        std::array::from_fn(|i| {
            let from = self.from[i];
            self.sign[i] * (state[from] - self.centre[from]) + self.centre[i]
        })
    }

    /// What it does to a difference of states.
    pub fn turn(&self, vector: &State) -> State {
        std::array::from_fn(|i| self.sign[i] * vector[self.from[i]])
    }

    /// The matrix of [`Symmetry::turn`] times another matrix.
    pub fn times(&self, matrix: &Matrix6) -> Matrix6 {
        Matrix6::from_fn(|row, column| self.sign[row] * matrix[(self.from[row], column)])
    }
}

/// Up to two commuting symmetries and their product. The index of an element is a set of bits, 1 for the first and 2
/// for the second, so that the product of two elements has the exclusive-or of their indices.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Group {
    elements: [Option<Symmetry>; 4],
}

impl Group {
    /// The group that these generate.
    pub fn new(first: Option<Symmetry>, second: Option<Symmetry>) -> Self {
        let both = first.zip(second).map(|(one, two)| Symmetry {
            from: std::array::from_fn(|i| two.from[one.from[i]]),
            sign: std::array::from_fn(|i| one.sign[i] * two.sign[one.from[i]]),
            // Commuting symmetries of one system act about a centre that both keep.
            centre: one.centre,
        });
        Self { elements: [Some(Symmetry::IDENTITY), first, second, both] }
    }

    /// The element of an index.
    pub fn element(&self, index: usize) -> Option<&Symmetry> {
        self.elements.get(index)?.as_ref()
    }

    /// The elements with their indices, the identity first.
    pub fn elements(&self) -> impl Iterator<Item = (usize, &Symmetry)> {
        self.elements.iter().enumerate().filter_map(|(index, element)| element.as_ref().map(|it| (index, it)))
    }

    /// The image of a state under the element of an index; the state itself where there is none.
    pub fn apply(&self, index: usize, state: &State) -> State {
        self.element(index).map_or(*state, |element| element.apply(state))
    }

    /// The set (bit `1 << index`) of the elements that leave a state where it is, to within `tolerance`.
    pub fn keeping(&self, state: &State, tolerance: f64) -> u8 {
        self.set(|element| near(&element.apply(state), state, tolerance))
    }

    /// Of a set, the elements that turn a vector into its opposite.
    pub fn opposing(&self, among: u8, vector: &State, tolerance: f64) -> u8 {
        among & self.set(|element| near(&element.turn(vector), &vector.map(|value| -value), tolerance))
    }

    /// Of a set, the elements that leave a vector as it is.
    pub fn sparing(&self, among: u8, vector: &State, tolerance: f64) -> u8 {
        among & self.set(|element| near(&element.turn(vector), vector, tolerance))
    }

    fn set(&self, chosen: impl Fn(&Symmetry) -> bool) -> u8 {
        self.elements().filter(|(_, element)| chosen(element)).fold(0, |set, (index, _)| set | 1 << index)
    }
}

fn near(left: &State, right: &State, tolerance: f64) -> bool {
    left.iter().zip(right).all(|(a, b)| (a - b).abs() <= tolerance)
}

/// The coordinates in which the linearisation about a symmetric orbit falls apart: an orthonormal basis, first of
/// the directions within the space that the orbit's symmetries fix, then of those across it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Space {
    basis: Matrix6,
    /// Dimension of the fixed space: 6 without symmetries.
    pub fixed: usize,
    /// Ends of the blocks: the first starts at 0, the second, if any, at the end of the first.
    pub blocks: [usize; 2],
    centre: State,
}

impl Space {
    /// The space of the orbits that a set of elements of a group leaves where they are.
    pub fn new(group: &Group, keeping: u8) -> Self {
        let kept = |index: usize| if keeping & (1 << index) != 0 { group.element(index) } else { None };
        let kept: Vec<&Symmetry> = (1..4).filter_map(kept).collect();
        let mut columns: Vec<State> = Vec::new();
        // The fixed space first.
        let mut fixed = 0;
        // One element splits the space into even and odd; with all of the group, the first that is not a plain
        // change of sign does.
        let split = kept.iter().find(|element| element.from != Symmetry::IDENTITY.from);
        for pass in 0..3 {
            for axis in 0..6 {
                let mut vector: State = std::array::from_fn(|i| f64::from(u8::from(i == axis)));
                match (pass, split) {
                    (0, _) => {
                        for element in &kept {
                            let turned = element.turn(&vector);
                            vector = std::array::from_fn(|i| 0.5 * (vector[i] + turned[i]));
                        }
                    }
                    (1, Some(element)) => {
                        let turned = element.turn(&vector);
                        vector = std::array::from_fn(|i| 0.5 * (vector[i] + turned[i]));
                    }
                    (1, None) => continue,
                    _ => {}
                }
                push_orthogonal(&mut columns, vector);
            }
            if pass == 0 {
                fixed = columns.len();
            } else if pass == 1 && split.is_some() {
                // Even under the splitting element, whether fixed by the others or not.
                debug_assert!(columns.len() <= 6);
            }
        }
        let even = split.map_or(6, |element| {
            (0..6).filter(|&i| near(&element.turn(&columns[i]), &columns[i], 1e-12)).count()
        });
        let basis = Matrix6::from_fn(|row, column| columns[column][row]);
        let centre = kept.first().map_or([0.0; 6], |element| element.centre);
        Self { basis, fixed, blocks: [even, 6], centre }
    }

    /// The nearest state of the fixed space.
    pub fn project(&self, state: &State) -> State {
        if self.fixed == 6 {
            return *state;
        }
        let mut projected = self.centre;
        for column in 0..self.fixed {
            let along: f64 = (0..6).map(|i| self.basis[(i, column)] * (state[i] - self.centre[i])).sum();
            for i in 0..6 {
                projected[i] += self.basis[(i, column)] * along;
            }
        }
        projected
    }

    /// A matrix in these coordinates.
    pub fn inside(&self, matrix: &Matrix6) -> Matrix6 {
        if self.whole() { *matrix } else { self.basis.transpose() * matrix * self.basis }
    }

    /// A vector in these coordinates.
    pub fn components(&self, vector: &State) -> State {
        if self.whole() {
            return *vector;
        }
        std::array::from_fn(|column| (0..6).map(|i| self.basis[(i, column)] * vector[i]).sum())
    }

    /// The vector of these coordinates.
    pub fn vector(&self, components: &State) -> State {
        if self.whole() {
            return *components;
        }
        std::array::from_fn(|i| (0..6).map(|column| self.basis[(i, column)] * components[column]).sum())
    }

    /// Whether there is one block only.
    pub fn whole(&self) -> bool {
        self.blocks[0] == 6 || self.blocks[0] == 0
    }

    /// Start and end of each block.
    pub fn ranges(&self) -> impl Iterator<Item = (usize, usize)> {
        let [first, second] = self.blocks;
        [(0, first), (first, second)].into_iter().filter(|(from, to)| to > from)
    }
}

/// Adds what is new in a vector to an orthonormal list.
fn push_orthogonal(columns: &mut Vec<State>, mut vector: State) {
    // Twice is enough (Kahan, Parlett).
    for _ in 0..2 {
        for column in columns.iter() {
            let along = super::dot(column, &vector);
            vector = std::array::from_fn(|i| vector[i] - along * column[i]);
        }
    }
    if super::norm(&vector) > 1e-6 {
        columns.push(super::unit(&vector));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sign() -> Symmetry {
        Symmetry { sign: [-1.0; 6], ..Symmetry::IDENTITY }
    }

    fn exchange() -> Symmetry {
        Symmetry { from: [1, 0, 2, 4, 3, 5], sign: [-1.0, -1.0, 1.0, -1.0, -1.0, 1.0], centre: [0.0; 6] }
    }

    #[test]
    fn the_manifold_has_four_directions_within_and_two_across() {
        let group = Group::new(Some(sign()), Some(exchange()));
        let state = [2.0, -2.0, 0.5, 0.1, -0.1, 3.0];
        assert_eq!(group.keeping(&state, 1e-9), 0b0101);
        let space = Space::new(&group, 0b0101);
        assert_eq!((space.fixed, space.blocks), (4, [4, 6]));
        let projected = space.project(&state);
        assert!(near(&projected, &state, 1e-15) && projected[0] == -projected[1], "{projected:?}");
        let off = space.project(&[2.0, -1.0, 0.5, 0.1, -0.1, 3.0]);
        assert!((off[0] - 1.5).abs() < 1e-15 && off[0] == -off[1], "{off:?}");
        let across = [1.0, 1.0, 0.0, 0.0, 0.0, 0.0];
        assert_eq!(group.opposing(0b0101, &across, 1e-9), 0b0100);
    }

    #[test]
    fn the_trivial_state_fixes_nothing_but_still_splits() {
        let group = Group::new(Some(sign()), Some(exchange()));
        let space = Space::new(&group, 0b1111);
        assert_eq!((space.fixed, space.blocks), (0, [4, 6]));
        let supports_only = Space::new(&group, 0b1001);
        assert_eq!((supports_only.fixed, supports_only.blocks), (2, [2, 6]));
        assert_eq!(Space::new(&group, 1).blocks, [6, 6]);
        assert_eq!(Space::new(&Group::new(Some(sign()), None), 0b11).fixed, 0);
    }

    #[test]
    fn products_are_those_of_the_elements() {
        let group = Group::new(Some(sign()), Some(exchange()));
        let state = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0];
        let one_by_one = group.apply(1, &group.apply(2, &state));
        assert_eq!(group.apply(3, &state), one_by_one);
    }
}
