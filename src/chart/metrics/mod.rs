//! How wide the shipped typeface sets a text: figures place their words without asking a browser or a font file.

mod table;

/// One face of the shipped typeface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Face {
    /// Upright.
    Regular,
    /// Slanted: symbols of quantities.
    Italic,
    /// Upright and heavy.
    Bold,
}

/// Families a surface asks for, best first: the shipped one, then those whose widths come close.
pub const FAMILY: &str = "\"STIX Two Text\", \"STIX Two Math\", \"Times New Roman\", Times, serif";

/// Height of a capital over its font size (all faces), dimensionless.
pub const CAPITAL_HEIGHT: f64 = 0.657;
/// Height of a small x over its font size, dimensionless.
pub const X_HEIGHT: f64 = 0.47;
/// Height to which letters reach over the baseline, over the font size, dimensionless.
pub const ASCENT: f64 = 0.72;
/// Depth to which letters reach under the baseline, over the font size, dimensionless.
pub const DESCENT: f64 = 0.22;

/// Advance width of a character in a face over the font size, dimensionless; 0.6 for a character the typeface lacks.
pub fn advance(character: char, face: Face) -> f64 {
    let runs = match face {
        Face::Regular => table::REGULAR,
        Face::Italic => table::ITALIC,
        Face::Bold => table::BOLD,
    };
    let code = u32::from(character);
    lookup(runs, code).or_else(|| lookup(table::SIGNS, code)).map_or(0.6, |width| f64::from(width) / 1000.0)
}

/// Width of a text in one face at a font size, in the unit of the size. Kerning is left out: it stays under one part in a hundred.
pub fn width(text: &str, face: Face, size: f64) -> f64 {
    text.chars().map(|character| advance(character, face)).sum::<f64>() * size
}

fn lookup(runs: &[(u32, &[u16])], code: u32) -> Option<u16> {
    let after = runs.partition_point(|&(start, _)| start <= code);
    let (start, widths) = runs.get(after.checked_sub(1)?)?;
    widths.get((code - start) as usize).copied()
}

#[cfg(test)]
mod tests {
    use super::{Face, advance, width};

    /// Advance widths read from the horizontal metrics of the complete faces.
    #[test]
    fn widths_are_those_of_the_typeface() {
        for (character, face, thousandths) in [
            (' ', Face::Regular, 235.0),
            ('0', Face::Regular, 495.0),
            ('A', Face::Regular, 718.0),
            ('\u{2212}', Face::Regular, 720.0),
            ('\u{2264}', Face::Italic, 720.0),
        ] {
            assert_eq!(advance(character, face) * 1000.0, thousandths, "{character}");
        }
    }

    #[test]
    fn every_digit_is_as_wide_as_every_other() {
        for digit in '0'..='9' {
            assert_eq!(advance(digit, Face::Regular), advance('0', Face::Regular));
        }
    }

    #[test]
    fn greek_and_primes_are_known_in_every_face() {
        for face in [Face::Regular, Face::Italic, Face::Bold] {
            for character in "ΩωζαεσλθψβγδμπΔ′″−·×±→≤∞".chars() {
                assert_ne!(advance(character, face), 0.6, "{character}");
            }
        }
    }

    #[test]
    fn a_text_is_as_wide_as_its_letters() {
        assert!((width("A0", Face::Regular, 10.0) - (7.18 + 4.95)).abs() < 1e-12);
    }
}
