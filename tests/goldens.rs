//! Every figure with its own parameters, as SVG text, against `tests/goldens/`: letter by letter.
//!
//! `cargo xtask goldens` draws them anew (it sets GOLDENS=write). The build serves the same files to readers without scripts.

use gear_bifurcations::chart::{Theme, View, svg};
use gear_bifurcations::figures::{Specification, figure, specifications};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// Width of a golden in CSS pixels: the module's own default.
const WIDTH: f64 = 720.0;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/goldens")
}

fn picture(specification: &Specification) -> String {
    let figure = figure(specification.id, &[]).expect("computes");
    let size = (WIDTH, (WIDTH / specification.aspect).round());
    let theme = Theme::by_name("light").expect("a theme");
    svg(&figure.drawing, specification.title, &figure.summary, size, &theme, &View::default()).expect("draws")
}

/// What differs between a golden and a picture, in words; none if nothing does.
fn difference(golden: &str, picture: &str) -> Option<String> {
    if golden == picture {
        return None;
    }
    let lines = golden.lines().zip(picture.lines());
    let same = lines.take_while(|(golden, picture)| golden == picture).count();
    let line =
        |text: &str| text.lines().nth(same).unwrap_or("(nothing more)").chars().take(300).collect::<String>();
    Some(format!("line {}\n  golden: {}\n  now:    {}", same + 1, line(golden), line(picture)))
}

/// The figures, computed on all cores.
fn pictures() -> Vec<(&'static str, String)> {
    let all = specifications();
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| {
        let draw = |first: usize| {
            let share = all.iter().skip(first).step_by(cores);
            share.map(|specification| (specification.id, picture(specification))).collect::<Vec<_>>()
        };
        let workers: Vec<_> = (0..cores).map(|first| scope.spawn(move || draw(first))).collect();
        workers.into_iter().flat_map(|worker| worker.join().expect("every figure is drawn")).collect()
    })
}

#[test]
fn every_figure_is_its_golden() {
    let pictures = pictures();
    if std::env::var_os("GOLDENS").is_some_and(|wish| wish == "write") {
        write(&pictures);
        return;
    }
    let differences: Vec<String> = pictures
        .iter()
        .filter_map(|(id, picture)| {
            let golden = fs::read_to_string(folder().join(format!("{id}.svg"))).unwrap_or_default();
            difference(&golden, picture).map(|difference| format!("figure {id}, {difference}"))
        })
        .collect();
    assert!(
        differences.is_empty(),
        "{}\n`cargo xtask goldens` draws them anew; look at them before you commit",
        differences.join("\n")
    );
}

#[test]
fn there_is_no_golden_without_a_figure() {
    let known: BTreeSet<String> =
        specifications().iter().map(|figure| format!("{}.svg", figure.id)).collect();
    for entry in fs::read_dir(folder()).expect("tests/goldens") {
        let name = entry.expect("an entry").file_name().to_string_lossy().into_owned();
        assert!(known.contains(&name), "tests/goldens/{name} belongs to no figure");
    }
}

fn write(pictures: &[(&str, String)]) {
    let folder = folder();
    fs::create_dir_all(&folder).expect("tests/goldens");
    for (id, picture) in pictures {
        let path = folder.join(format!("{id}.svg"));
        let before = fs::read_to_string(&path).unwrap_or_default();
        if let Some(difference) = difference(&before, picture) {
            println!("figure {id}: {difference}");
            fs::write(path, picture).expect("writes");
        }
    }
}

#[test]
fn a_difference_names_its_first_line() {
    assert_eq!(difference("a\nb\n", "a\nb\n"), None);
    assert_eq!(difference("a\nb\nc", "a\nx\nc").as_deref(), Some("line 2\n  golden: b\n  now:    x"));
    assert!(difference("a\nb\n", "a\n").is_some_and(|words| words.starts_with("line 2\n")));
}
