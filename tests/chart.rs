//! The charts from outside: whole drawings on the SVG backend and on a recording one.

#[path = "chart/demonstration.rs"]
mod demonstration;

use demonstration::all;
use gear_bifurcations::chart::{Theme, View, svg};

/// Writes every demonstration in every theme and two widths to `target/gallery`, to be looked at:
/// `cargo test --test chart gallery -- --ignored`.
#[test]
#[ignore = "writes pictures to look at"]
fn gallery() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("target/gallery");
    std::fs::create_dir_all(&folder).unwrap();
    for (name, drawing, aspect) in all() {
        for theme in ["light", "dark"] {
            for width in [900.0_f64, 360.0] {
                let height = (width / aspect).max(260.0);
                let look = Theme::by_name(theme).unwrap();
                let text = svg(&drawing, name, "", (width, height), &look, &View::default()).unwrap();
                std::fs::write(folder.join(format!("{name}-{theme}-{width}.svg")), text).unwrap();
            }
        }
    }
}
