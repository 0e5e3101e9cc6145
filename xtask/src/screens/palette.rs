//! At most 256 colours for a picture that has more: those it has most of exactly, so that ground, text and lines stay what they
//! are, and for the rest, which are ramps and soft edges, the means of what lies near together.

use std::collections::{BTreeMap, HashMap};

type Color = [u8; 3];

/// Colours of the table for a picture that fits a screen or two.
const ALL: usize = 256;
/// Those of a larger one: with more it looks the same but for its ramps, and the repository has not the room.
const OF_LARGE: usize = 72;
/// Pixels from which a picture is large.
const LARGE: usize = 4_000_000;
/// Sides of the grid's cells to be tried; the coarsest has fewer cells than the table has room for.
const STEPS: [u8; 9] = [8, 12, 16, 20, 24, 32, 48, 64, 86];

/// The table.
pub struct Palette {
    /// At most 256.
    pub colors: Vec<Color>,
}

impl Palette {
    /// The table for a picture.
    pub fn of(pixels: &[Color]) -> Self {
        let mut counts: HashMap<Color, u32> = HashMap::new();
        for pixel in pixels {
            *counts.entry(*pixel).or_default() += 1;
        }
        let mut often: Vec<(Color, u32)> = counts.into_iter().collect();
        often.sort_unstable_by_key(|(color, count)| (std::cmp::Reverse(*count), *color));
        let most = if pixels.len() < LARGE { ALL } else { OF_LARGE };
        if often.len() <= most {
            return Self { colors: often.into_iter().map(|(color, _)| color).collect() };
        }
        let (exact, rest) = often.split_at(most / 2);
        let mut colors: Vec<Color> = exact.iter().map(|(color, _)| *color).collect();
        colors.extend(means(rest, most - exact.len()));
        Self { colors }
    }

    /// Finds the nearest colour of the table, remembering what it has found.
    pub fn indices(&self) -> Indices<'_> {
        Indices { palette: self, known: HashMap::new() }
    }
}

/// The means of the cells of a grid that is as fine as the table has room for.
fn means(colors: &[(Color, u32)], wanted: usize) -> Vec<Color> {
    let fitting = STEPS.iter().map(|step| cells(colors, *step)).find(|means| means.len() <= wanted);
    fitting.unwrap_or_default()
}

fn cells(colors: &[(Color, u32)], step: u8) -> Vec<Color> {
    let mut cells: BTreeMap<Color, ([u64; 3], u64)> = BTreeMap::new();
    for (color, count) in colors {
        let (sums, all) = cells.entry(color.map(|part| part / step)).or_default();
        for (sum, part) in sums.iter_mut().zip(color) {
            *sum += u64::from(*part) * u64::from(*count);
        }
        *all += u64::from(*count);
    }
    let mean = |sum: u64, count: u64| u8::try_from(sum / count.max(1)).unwrap_or(u8::MAX);
    cells.into_values().map(|(sums, count)| sums.map(|sum| mean(sum, count))).collect()
}

/// A table with what was looked up in it.
pub struct Indices<'a> {
    palette: &'a Palette,
    known: HashMap<Color, u8>,
}

impl Indices<'_> {
    /// The place in the table of the colour that is nearest.
    pub fn index(&mut self, color: Color) -> u8 {
        let palette = self.palette;
        *self.known.entry(color).or_insert_with(|| {
            let nearest = palette.colors.iter().enumerate().min_by_key(|(_, other)| distance(color, **other));
            nearest.map_or(0, |(index, _)| u8::try_from(index).unwrap_or(u8::MAX))
        })
    }
}

/// The eye sees green best.
fn distance(one: Color, other: Color) -> u32 {
    let [red, green, blue] = [0, 1, 2].map(|part| u32::from(one[part].abs_diff(other[part])).pow(2));
    2 * red + 4 * green + blue
}

#[cfg(test)]
mod tests {
    use super::{ALL, Palette};

    #[test]
    fn few_colours_stay_exactly_what_they_are() {
        let pixels = [[255, 255, 255], [0, 114, 178], [255, 255, 255]];
        let palette = Palette::of(&pixels);
        let mut indices = palette.indices();
        for pixel in pixels {
            assert_eq!(palette.colors[usize::from(indices.index(pixel))], pixel);
        }
    }

    #[test]
    fn of_many_the_frequent_stay_and_the_others_come_near() {
        let ground = [20, 23, 27];
        let mut pixels = vec![ground; 100_000];
        pixels.extend((0..=255).flat_map(|blue| (0..=255).map(move |green| [80, green, blue])));
        let palette = Palette::of(&pixels);
        assert!(palette.colors.len() <= ALL);
        let mut indices = palette.indices();
        assert_eq!(palette.colors[usize::from(indices.index(ground))], ground);
        let far = pixels.iter().map(|pixel| {
            let found = palette.colors[usize::from(indices.index(*pixel))];
            (0..3).map(|part| found[part].abs_diff(pixel[part])).max().unwrap_or(0)
        });
        let far = far.max();
        assert!(far.is_some_and(|far| far <= 32), "{far:?}");
    }
}
