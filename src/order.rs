//! Sorting by a number, for every layer.
//!
//! The standard library's sort is compiled anew for each kind of element and each comparison, some three kilobytes a time;
//! what a browser loads should hold it once. Here the numbers alone are sorted, always as the same type, and the
//! elements are then moved to their places.

/// Sorts by a number, least first, as [`f64::total_cmp`] has it; what has the same number keeps its order.
///
/// ```
/// let mut words = ["three", "a", "to", "b"];
/// gear_bifurcations::order::by_number(&mut words, |word| word.len() as f64);
/// assert_eq!(words, ["a", "b", "to", "three"]);
/// ```
pub fn by_number<T>(items: &mut [T], number: impl Fn(&T) -> f64) {
    let mut numbered: Vec<(f64, usize)> = items.iter().map(number).zip(0..).collect();
    sort(&mut numbered);
    for place in 0..items.len() {
        // Whoever stood there first has been moved since if that place is filled already.
        let mut from = numbered[place].1;
        while from < place {
            from = numbered[from].1;
        }
        items.swap(place, from);
    }
}

/// Sorts numbers, least first, as [`f64::total_cmp`] has it.
pub fn ascending(numbers: &mut [f64]) {
    by_number(numbers, |number| *number);
}

/// Sorts numbers, greatest first.
pub fn descending(numbers: &mut [f64]) {
    by_number(numbers, |number| -*number);
}

#[inline(never)]
fn sort(numbered: &mut [(f64, usize)]) {
    numbered.sort_unstable_by(|one, other| one.0.total_cmp(&other.0).then(one.1.cmp(&other.1)));
}

#[cfg(test)]
mod tests {
    use super::{ascending, by_number, descending};

    #[test]
    fn numbers_are_sorted_as_the_standard_library_does_it() {
        // A fixed sequence without an evident pattern, with ties.
        let numbers: Vec<f64> =
            (0..200_u64).map(|n| ((n.wrapping_mul(2654435761) >> 7) % 83) as f64 - 41.0).collect();
        let mut expected = numbers.clone();
        expected.sort_by(f64::total_cmp);
        let mut ours = numbers.clone();
        ascending(&mut ours);
        assert_eq!(ours, expected);
        expected.reverse();
        let mut ours = numbers;
        descending(&mut ours);
        assert_eq!(ours, expected);
    }

    #[test]
    fn what_has_the_same_number_keeps_its_order() {
        let mut items: Vec<(usize, usize)> = (0..100).map(|n| ((n * 37) % 7, n)).collect();
        let mut expected = items.clone();
        expected.sort_by_key(|item| item.0);
        by_number(&mut items, |item| item.0 as f64);
        assert_eq!(items, expected);
    }

    #[test]
    fn nothing_and_one_thing_are_in_order() {
        ascending(&mut []);
        let mut one = [f64::NAN];
        ascending(&mut one);
        assert!(one[0].is_nan());
    }
}
