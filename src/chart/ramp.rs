//! The ramp of fields: cividis, whose lightness rises evenly and which is seen alike with and without colour blindness.

use super::theme::{Color, Theme};

/// Colours of the ramp, evenly spaced from its dark to its light end: J. R. Nunez, C. R. Anderton, R. S. Renslow,
/// "Optimizing colormaps with consideration for color vision deficiency", PLOS ONE 13 (2018) e0199239.
const CIVIDIS: [Color; 10] = [
    Color(0x00, 0x20, 0x4D),
    Color(0x00, 0x33, 0x6F),
    Color(0x39, 0x48, 0x6B),
    Color(0x57, 0x5C, 0x6D),
    Color(0x70, 0x71, 0x73),
    Color(0x8A, 0x87, 0x79),
    Color(0xA6, 0x9D, 0x75),
    Color(0xC4, 0xB5, 0x6C),
    Color(0xE4, 0xCF, 0x5B),
    Color(0xFF, 0xEA, 0x46),
];
/// Shades that a field is painted in: finer ones are not told apart.
pub const SHADES: usize = 64;
/// Colours of the regions of a map of basins on a light ground: pale, so that marks and words stand out on them.
const REGIONS_LIGHT: [Color; 6] = [
    Color(0xC9, 0xE0, 0xF2),
    Color(0xF6, 0xE7, 0xB0),
    Color(0xC8, 0xE9, 0xD9),
    Color(0xEF, 0xD0, 0xE2),
    Color(0xDD, 0xD6, 0xF0),
    Color(0xE2, 0xE8, 0xB8),
];
/// The same on a dark ground.
const REGIONS_DARK: [Color; 6] = [
    Color(0x1E, 0x44, 0x62),
    Color(0x5A, 0x4C, 0x14),
    Color(0x15, 0x4F, 0x3C),
    Color(0x5B, 0x2E, 0x4A),
    Color(0x40, 0x37, 0x66),
    Color(0x49, 0x50, 0x1C),
];

/// The ramp's colour at a fraction 0 to 1, dark to light.
fn cividis(fraction: f64) -> Color {
    let place = fraction.clamp(0.0, 1.0) * (CIVIDIS.len() - 1) as f64;
    let index = (place as usize).min(CIVIDIS.len() - 2);
    CIVIDIS[index + 1].over(CIVIDIS[index], place - index as f64)
}

/// The colour of a shade, 0 the least: the end of the ramp that is nearer to the ground stands for little.
pub fn shade(theme: &Theme, index: usize) -> Color {
    let fraction = (index as f64 + 0.5) / SHADES as f64;
    cividis(if theme.is_light() { 1.0 - fraction } else { fraction })
}

/// The colour of a region of a map of basins; they come round again after six.
pub fn region(theme: &Theme, index: usize) -> Color {
    let regions = if theme.is_light() { REGIONS_LIGHT } else { REGIONS_DARK };
    regions[index % regions.len()]
}

#[cfg(test)]
mod tests {
    use super::{REGIONS_DARK, SHADES, cividis, region, shade};
    use crate::chart::theme::Theme;

    /// CIE lightness, 0 to 100.
    fn lightness(luminance: f64) -> f64 {
        if luminance > 0.008_856 { 116.0 * luminance.cbrt() - 16.0 } else { 903.3 * luminance }
    }

    #[test]
    fn lightness_rises_evenly_along_the_ramp() {
        let at = |fraction: f64| lightness(cividis(fraction).luminance());
        let (low, high) = (at(0.0), at(1.0));
        assert!(low < 15.0 && high > 90.0, "{low} {high}");
        for step in 1..=20 {
            let fraction = f64::from(step) / 20.0;
            let even = low + fraction * (high - low);
            assert!((at(fraction) - even).abs() < 4.0, "{fraction}: {} for {even}", at(fraction));
            assert!(at(fraction) > at(fraction - 0.05));
        }
    }

    #[test]
    fn little_is_near_the_ground_and_much_far_from_it() {
        for name in ["light", "dark"] {
            let theme = Theme::by_name(name).expect("known");
            let contrast = |index: usize| shade(&theme, index).contrast(theme.ground);
            assert!(contrast(SHADES - 1) > 10.0 && contrast(0) < 2.0, "{name}");
        }
    }

    #[test]
    fn words_can_be_read_on_every_region() {
        for name in ["light", "dark"] {
            let theme = Theme::by_name(name).expect("known");
            for index in 0..REGIONS_DARK.len() {
                assert!(theme.ink.contrast(region(&theme, index)) > 4.5, "{name} {index}");
            }
            assert_eq!(region(&theme, 0), region(&theme, REGIONS_DARK.len()));
        }
    }
}
