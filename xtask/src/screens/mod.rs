//! `cargo xtask screens`: pictures of the whole page, for the README and for whoever reviews a change to it.

mod palette;

use crate::command::{Options, program, run};
use crate::serve::{Prefix, Server};
use crate::{Failure, build, place, tools};
use palette::Palette;
use std::collections::BTreeMap;
use std::io::BufWriter;
use std::path::{Path, PathBuf};

/// All pictures together may not be larger than this, in bytes: they are part of the repository.
const CEILING: u64 = 8_000_000;

/// Builds, unless what is in `dist/` is to be pictured, serves, has Chromium take the pictures, and makes them small.
pub fn screens(options: &Options) -> Result<(), Failure> {
    let dist = place::root().join("dist");
    if !options.flag("--no-build") {
        build::build(&dist)?.report();
    }
    tools::ensure_node_packages()?;
    let chromium = tools::ensure_chromium()?;
    let tiles = place::scratch().join("screens");
    let _ = std::fs::remove_dir_all(&tiles);
    std::fs::create_dir_all(&tiles).map_err(Failure::file(&tiles))?;
    let address = Server::bind(dist, Prefix::root(), Some(0))?.in_background();
    run(program("node", &["xtask/screens.js"])
        .env("CHROMIUM", chromium)
        .env("GEAR_ADDRESS", address)
        .env("GEAR_SCREENS", &tiles))?;
    let folder = place::root().join("docs/screens");
    renew(&tiles, &folder)
}

/// Joins the tiles of each screen, `NAME.000.png` and so on, into one picture of few colours, in place of all that were
/// in the folder.
fn renew(tiles: &Path, folder: &Path) -> Result<(), Failure> {
    let mut screens: BTreeMap<String, Vec<PathBuf>> = BTreeMap::new();
    for tile in place::files_below(tiles)? {
        if let Some((name, _)) = tile.split_once('.') {
            screens.entry(name.to_owned()).or_default().push(tiles.join(&tile));
        }
    }
    let _ = std::fs::remove_dir_all(folder);
    std::fs::create_dir_all(folder).map_err(Failure::file(folder))?;
    let mut all = 0;
    for (name, parts) in &screens {
        let path = folder.join(format!("{name}.png"));
        join(parts, &path)?;
        let size = std::fs::metadata(&path).map_err(Failure::file(&path))?.len();
        println!("{name}: {size} bytes");
        all += size;
    }
    if all > CEILING {
        return Err(Failure::invalid(
            "docs/screens",
            format!("{all} bytes, more than the ceiling of {CEILING}"),
        ));
    }
    println!("together {all} bytes (ceiling {CEILING})");
    Ok(())
}

/// One picture, row after row.
struct Picture {
    width: usize,
    /// Red, green and blue of each pixel.
    pixels: Vec<[u8; 3]>,
}

/// Puts tiles under each other and writes them with a table of colours.
fn join(parts: &[PathBuf], path: &Path) -> Result<(), Failure> {
    let mut whole = Picture { width: 0, pixels: Vec::new() };
    for part in parts {
        let picture = read(part)?;
        if whole.width != 0 && whole.width != picture.width {
            return Err(Failure::invalid(
                part.display().to_string(),
                "it is not as wide as the tile before it",
            ));
        }
        whole.width = picture.width;
        whole.pixels.extend(picture.pixels);
    }
    let palette = Palette::of(&whole.pixels);
    let mut colors = palette.indices();
    let indices: Vec<u8> = whole.pixels.iter().map(|pixel| colors.index(*pixel)).collect();
    write(path, whole.width, &indices, &palette)
}

fn read(path: &Path) -> Result<Picture, Failure> {
    let broken = |error: png::DecodingError| Failure::invalid(path.display().to_string(), error.to_string());
    let file = std::fs::File::open(path).map_err(Failure::file(path))?;
    let mut decoder = png::Decoder::new(std::io::BufReader::new(file));
    decoder.set_transformations(png::Transformations::normalize_to_color8());
    let mut reader = decoder.read_info().map_err(broken)?;
    let size = reader
        .output_buffer_size()
        .ok_or_else(|| Failure::invalid(path.display().to_string(), "it is too large"))?;
    let mut bytes = vec![0; size];
    let info = reader.next_frame(&mut bytes).map_err(broken)?;
    let samples = info.color_type.samples();
    if samples < 3 {
        return Err(Failure::invalid(path.display().to_string(), "it has no colours"));
    }
    let pixels =
        bytes[..info.buffer_size()].chunks_exact(samples).map(|pixel| [pixel[0], pixel[1], pixel[2]]);
    Ok(Picture { width: info.width as usize, pixels: pixels.collect() })
}

fn write(path: &Path, width: usize, indices: &[u8], palette: &Palette) -> Result<(), Failure> {
    let broken = |error: png::EncodingError| Failure::invalid(path.display().to_string(), error.to_string());
    let size = |length: usize| {
        u32::try_from(length).map_err(|_| Failure::invalid(path.display().to_string(), "it is too large"))
    };
    let file = std::fs::File::create(path).map_err(Failure::file(path))?;
    let (columns, rows) = (size(width)?, size(indices.len() / width.max(1))?);
    let mut encoder = png::Encoder::new(BufWriter::new(file), columns, rows);
    encoder.set_color(png::ColorType::Indexed);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_palette(palette.colors.concat());
    encoder.set_compression(png::Compression::High);
    // Indices are names, not amounts: differences between neighbours say nothing.
    encoder.set_filter(png::Filter::NoFilter);
    encoder.write_header().and_then(|mut writer| writer.write_image_data(indices)).map_err(broken)
}

#[cfg(test)]
mod tests {
    use super::{Palette, join, read, write};

    #[test]
    fn tiles_are_joined_and_colours_kept() {
        let folder = std::env::temp_dir().join(format!("gear-screens-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        let (one, two, whole) =
            (folder.join("a.000.png"), folder.join("a.001.png"), folder.join("whole.png"));
        let (white, ink) = ([255, 255, 255], [27, 31, 36]);
        let palette = Palette::of(&[white, ink]);
        let mut colors = palette.indices();
        let [paper, line] = [white, ink].map(|color| colors.index(color));
        write(&one, 2, &[paper, paper, paper, line], &palette).unwrap();
        write(&two, 2, &[line, paper], &palette).unwrap();
        join(&[one, two], &whole).unwrap();
        assert_eq!(read(&whole).unwrap().pixels, [white, white, white, ink, ink, white]);
        std::fs::remove_dir_all(folder).unwrap();
    }
}
