//! The charts from outside: whole drawings on the SVG backend and on a recording one.

#[path = "chart/demonstration.rs"]
mod demonstration;
#[path = "chart/recorder.rs"]
mod recorder;

use demonstration::{all, axis, frame, pitchforks, response, series};
use gear_bifurcations::chart::metrics::width;
use gear_bifurcations::chart::{
    Drawing, FrameMap, Mark, Role, Selection, SvgSurface, Theme, View, Window, draw, pleasant_height, svg,
};
use gear_bifurcations::error::ChartError;
use plotters::prelude::{IntoFont, TextStyle};
use plotters_backend::DrawingBackend;
use recorder::{Call, Recorder};

const WIDTHS: [f64; 5] = [320.0, 360.0, 520.0, 900.0, 1600.0];

fn light() -> Theme {
    Theme::by_name("light").unwrap()
}

fn recorded(drawing: &Drawing, size: (f64, f64), units: i32) -> (Vec<FrameMap>, Vec<(Option<String>, Call)>) {
    let mut recorder = Recorder::new(size.0, size.1, units);
    let maps = draw(&mut recorder, drawing, &light(), &View::default()).unwrap();
    (maps, recorder.calls)
}

/// Boxes of all letters: left, top, right, bottom; capitals and descenders, without the air about them.
fn letter_boxes(calls: &[(Option<String>, Call)]) -> Vec<(String, [f64; 4])> {
    calls
        .iter()
        .filter_map(|(_, call)| match call {
            Call::Letters { runs, at, upwards } => {
                let text: String = runs.iter().map(|run| run.text.as_str()).collect();
                let end =
                    runs.iter().map(|run| run.x + width(&run.text, run.face, run.size)).fold(0.0, f64::max);
                let over = runs.iter().map(|run| 0.66 * run.size - run.y).fold(0.0, f64::max);
                let under = runs.iter().map(|run| 0.1 * run.size + run.y).fold(0.0, f64::max);
                Some(if *upwards {
                    (text, [at[0] - over, at[1] - end, at[0] + under, at[1]])
                } else {
                    (text, [at[0], at[1] - over, at[0] + end, at[1] + under])
                })
            }
            _ => None,
        })
        .collect()
}

/// Nothing but single marks is drawn outside of the frame it belongs to; says how many points were looked at.
fn assert_within(name: &str, drawing: &Drawing, size: (f64, f64)) -> usize {
    let (maps, calls) = recorded(drawing, size, 100);
    let mut checked = 0;
    for (owner, call) in &calls {
        let Some(series) = owner.as_ref().and_then(|name| drawing.series.iter().find(|s| s.name == *name))
        else {
            continue;
        };
        let points = match call {
            Call::Path { points, .. } | Call::Cloud { points, .. } => points.clone(),
            Call::Polygon { corners } => corners.clone(),
            Call::Rectangle { corners } | Call::Image { corners, .. } => corners.to_vec(),
            Call::Circle { .. } | Call::Letters { .. } => continue,
        };
        if series.mark == Mark::Marks {
            continue;
        }
        let [left, top, right, bottom] = maps[series.frame].plot;
        for [x, y] in points {
            let inside = (left..=right).contains(&x) && (top..=bottom).contains(&y);
            assert!(inside, "{name} at {size:?}: {} at {x}, {y}", series.name);
            checked += 1;
        }
    }
    checked
}

/// No word is cut off by the picture's edge, and none lies over another.
fn assert_words_apart(name: &str, calls: &[(Option<String>, Call)], (width, height): (f64, f64)) {
    let boxes = letter_boxes(calls);
    assert!(boxes.len() > 3);
    for (i, (text, [left, top, right, bottom])) in boxes.iter().enumerate() {
        let inside = *left >= 0.0 && *top >= 0.0 && *right <= width && *bottom <= height;
        assert!(inside, "{name} at {width}: \"{text}\" is cut off");
        for (other, [l, t, r, b]) in &boxes[..i] {
            let apart = r <= left || right <= l || b <= top || bottom <= t;
            assert!(apart, "{name} at {width}: \"{text}\" lies over \"{other}\"");
        }
    }
}

/// The part of every frame about a place (fractions of its axes) that is so much smaller than the whole.
fn zoomed(drawing: &Drawing, place: [f64; 2], zoom: f64) -> Drawing {
    let windows = drawing.frames.iter().filter(|frame| !frame.bare && frame.z.is_none()).map(|frame| {
        let part = |low: f64, high: f64, fraction: f64| {
            let (middle, half) = (low + fraction * (high - low), 0.5 * (high - low) / zoom);
            Some([middle - half, middle + half])
        };
        Window {
            frame: frame.name.clone(),
            x: part(frame.x.low, frame.x.high, place[0]),
            y: part(frame.y.low, frame.y.high, place[1]),
        }
    });
    Selection { windows: windows.collect(), hidden: Vec::new() }.of(drawing.clone()).unwrap()
}

#[test]
fn no_curve_band_or_cloud_leaves_its_frame() {
    for (name, drawing, aspect) in all() {
        for width in WIDTHS {
            let size = (width, pleasant_height(&drawing, aspect, width));
            let checked = assert_within(name, &drawing, size);
            assert!(checked > 20, "{name} at {width}: only {checked} points");
        }
    }
}

#[test]
fn nothing_leaves_its_frame_when_a_part_of_it_is_shown() {
    for (name, drawing, aspect) in all() {
        let size = (640.0, pleasant_height(&drawing, aspect, 640.0));
        for place in [[0.5, 0.5], [0.3, 0.7], [0.0, 0.0], [0.93, 0.4]] {
            for zoom in [0.5, 3.0, 40.0, 1e4, 1e6] {
                assert_within(name, &zoomed(&drawing, place, zoom), size);
            }
        }
    }
}

#[test]
fn a_window_has_ticks_and_a_map_of_its_own_and_words_that_keep_apart() {
    for (name, drawing, aspect) in all() {
        let size = (640.0, pleasant_height(&drawing, aspect, 640.0));
        for zoom in [0.6, 3.0, 40.0, 2000.0] {
            let part = zoomed(&drawing, [0.4, 0.55], zoom);
            let (maps, calls) = recorded(&part, size, 100);
            assert_words_apart(name, &calls, size);
            for (map, frame) in maps.iter().zip(&part.frames) {
                assert_eq!((map.x, map.y), ((frame.x.low, frame.x.high), (frame.y.low, frame.y.high)));
            }
        }
    }
}

#[test]
fn a_field_is_sharp_when_a_part_of_it_is_shown() {
    let pixels = |drawing: &Drawing| {
        let (_, calls) = recorded(drawing, (700.0, 420.0), 100);
        calls.into_iter().find_map(|(_, call)| match call {
            Call::Image { columns, pixels, corners } => Some((columns, pixels, corners)),
            _ => None,
        })
    };
    let whole = demonstration::field();
    let (columns, image, [upper, lower]) = pixels(&zoomed(&whole, [0.75, 0.5], 20.0)).expect("an image");
    // As many pixels as the plot has, whatever part is shown, and neighbours that hardly differ.
    assert!((columns as f64 - (lower[0] - upper[0])).abs() <= 1.0, "{columns}");
    let shades: Vec<u8> = image[..columns].iter().copied().filter(|&shade| shade < 64).collect();
    assert!(shades.len() > columns / 2, "{} of {columns}", shades.len());
    assert!(shades.windows(2).all(|pair| pair[0].abs_diff(pair[1]) <= 1));
}

#[test]
fn no_word_is_cut_off_and_none_lies_over_another() {
    for (name, drawing, aspect) in all() {
        for width in WIDTHS {
            let size = (width, pleasant_height(&drawing, aspect, width));
            assert_words_apart(name, &recorded(&drawing, size, 100).1, size);
        }
    }
}

#[test]
fn large_letters_keep_apart_as_well() {
    let projector = Theme::by_name("projector").unwrap();
    for (name, drawing, aspect) in all() {
        for width in [720.0, 1280.0, 1920.0] {
            let size = (width, pleasant_height(&drawing, aspect, width));
            let mut recorder = Recorder::new(size.0, size.1, 100);
            draw(&mut recorder, &drawing, &projector, &View::default()).unwrap();
            assert_words_apart(name, &recorder.calls, size);
            let largest = recorder.calls.iter().filter_map(|(_, call)| match call {
                Call::Letters { runs, .. } => runs.first().map(|run| run.size),
                _ => None,
            });
            assert!(largest.fold(0.0, f64::max) >= 17.0);
        }
    }
}

#[test]
fn a_field_is_painted_where_its_numbers_are_and_its_bar_beside_the_plot() {
    let drawing = demonstration::field();
    let (maps, calls) = recorded(&drawing, (700.0, 420.0), 100);
    let [left, top, right, bottom] = maps[0].plot;
    let image = calls.iter().find_map(|(owner, call)| match call {
        Call::Image { columns, pixels, corners } => {
            assert_eq!(owner.as_deref(), Some("growth"));
            Some((*columns, pixels.clone(), *corners))
        }
        _ => None,
    });
    let (columns, pixels, [upper, lower]) = image.expect("an image");
    assert!(upper[0] >= left && upper[1] >= top && lower[0] <= right && lower[1] <= bottom);
    // The number grows to the right and upwards, and is nothing in the left half.
    let rows = pixels.len() / columns;
    let at = |column: usize, row: usize| pixels[row * columns + column];
    assert_eq!(at(columns / 4, rows / 2), 255, "clear");
    assert!(at(columns - 1, 0) > at(columns - 1, rows - 1), "more at the top");
    assert!(at(columns - 1, 0) > at(columns * 6 / 10, 0), "more at the right");
    let bar: Vec<f64> = calls
        .iter()
        .filter_map(|(owner, call)| match (owner, call) {
            (None, Call::Rectangle { corners }) if corners[0][0] > right => Some(corners[1][0]),
            _ => None,
        })
        .collect();
    assert_eq!(bar.len(), 64, "one rectangle a shade");
    assert!(bar.iter().all(|right| *right < 700.0));
}

#[test]
fn quasi_periodic_lines_carry_open_circles_and_every_mark_is_drawn() {
    let drawing = demonstration::field();
    let (_, calls) = recorded(&drawing, (700.0, 420.0), 100);
    let of = |name: &str| calls.iter().filter(|(owner, _)| owner.as_deref() == Some(name)).count();
    let circles = calls
        .iter()
        .filter(|(owner, call)| owner.as_deref() == Some("torus") && matches!(call, Call::Circle { .. }))
        .count();
    assert!(circles > 20, "{circles} circles along the line");
    for name in ["fold", "torus point", "across"] {
        assert!(of(name) >= 2, "{name}");
    }
}

#[test]
fn a_field_whose_grid_does_not_fit_is_refused() {
    let mut drawing = demonstration::field();
    drawing.series[0].z.pop();
    let refused = svg(&drawing, "", "", (400.0, 300.0), &light(), &View::default());
    assert!(matches!(refused, Err(ChartError::Malformed { name, .. }) if name == "growth"));
}

#[test]
fn the_frame_map_is_where_the_curve_is() {
    let (low, high) = (-2.0, 7.0);
    let mut line = series(0, "line", Role::Exact, Mark::Curve);
    (line.x, line.y) = (vec![0.5, 3.5], vec![-1.0, 6.0]);
    let drawing = Drawing {
        grid: (1, 1),
        frames: vec![frame("f", "title", (0, 0), axis("x", "*x*", 0.0, 4.0), axis("y", "*y*", low, high))],
        series: vec![line],
    };
    let (maps, calls) = recorded(&drawing, (500.0, 300.0), 100);
    let map = &maps[0];
    let pixel = |x: f64, y: f64| {
        let [left, top, right, bottom] = map.plot;
        let across = (x - map.x.0) / (map.x.1 - map.x.0);
        let up = (y - map.y.0) / (map.y.1 - map.y.0);
        [left + across * (right - left), bottom - up * (bottom - top)]
    };
    let found: Vec<[f64; 2]> = calls
        .iter()
        .filter_map(|(owner, call)| match call {
            Call::Path { points, .. } if owner.as_deref() == Some("line") => Some(points.clone()),
            _ => None,
        })
        .flatten()
        .collect();
    let expected = [pixel(0.5, -1.0), pixel(3.5, 6.0)];
    assert_eq!(found.len(), 2);
    for (one, other) in found.iter().zip(&expected) {
        assert!(
            (one[0] - other[0]).abs() <= 0.005 && (one[1] - other[1]).abs() <= 0.005,
            "{one:?} {other:?}"
        );
    }
}

#[test]
fn the_projection_is_where_the_mark_is() {
    let drawing = pitchforks();
    let (maps, calls) = recorded(&drawing, (900.0, 660.0), 100);
    let rows = maps[1].projection.expect("the second frame is one in space");
    let star = drawing.series.iter().find(|s| s.frame == 1 && s.role == Role::Supercritical).unwrap();
    let point = [star.x[0], star.y[0], star.z[0], 1.0];
    let pixel = rows.map(|row| row.iter().zip(&point).map(|(a, b)| a * b).sum::<f64>());
    // The star's polygon has its middle there: five tips and five notches about it.
    let hit = calls.iter().any(|(_, call)| match call {
        Call::Polygon { corners } if corners.len() == 10 => (0..2).all(|i| {
            let middle = corners.iter().map(|corner| corner[i]).sum::<f64>() / 10.0;
            (middle - pixel[i]).abs() < 0.02
        }),
        _ => false,
    });
    assert!(hit, "{pixel:?}");
}

#[test]
fn the_fineness_of_the_units_does_not_change_the_picture() {
    let drawing = response();
    let size = (640.0, 420.0);
    let (coarse, fine) = (recorded(&drawing, size, 10), recorded(&drawing, size, 1000));
    assert_eq!(coarse.0, fine.0);
    let dashes = |calls: &[(Option<String>, Call)]| -> Vec<[f64; 2]> {
        calls
            .iter()
            .filter(|(owner, _)| owner.as_deref() == Some("contact 0"))
            .filter_map(|(_, call)| match call {
                Call::Path { points, .. } => Some(points[0]),
                _ => None,
            })
            .collect()
    };
    let (coarse, fine) = (dashes(&coarse.1), dashes(&fine.1));
    assert!(coarse.len() > 100);
    assert_eq!(coarse.len(), fine.len());
    for (a, b) in coarse.iter().zip(&fine) {
        assert!((a[0] - b[0]).abs() < 0.06 && (a[1] - b[1]).abs() < 0.06, "{a:?} {b:?}");
    }
}

#[test]
fn svg_is_the_same_every_time_and_holds_numbers_only() {
    for (name, drawing, aspect) in all() {
        let size = (700.0, pleasant_height(&drawing, aspect, 700.0));
        let make = || svg(&drawing, "Title", "What it shows", size, &light(), &View::default()).unwrap();
        let text = make();
        assert_eq!(text, make(), "{name}");
        for word in ["NaN", "inf", "e-", "e+"] {
            assert!(
                !text
                    .split('"')
                    .skip(1)
                    .step_by(2)
                    .any(|value| value.contains(word) && value.starts_with('M'))
            );
        }
        assert!(text.contains("<title>Title</title>") && text.contains("<desc>What it shows</desc>"));
        assert!(text.contains("role=\"img\"") && text.contains("viewBox=\"0 0 700"));
        assert_eq!(text.matches("<g ").count(), text.matches("</g>").count());
    }
}

#[test]
fn a_cloud_is_one_path() {
    let drawing = demonstration::clouds();
    let text = svg(&drawing, "", "", (900.0, 350.0), &light(), &View::default()).unwrap();
    assert_eq!(text.matches("stroke-linecap=\"round\"").count(), 6);
    assert!(text.matches("h0M").count() > 9000);
}

#[test]
fn what_is_no_number_is_refused_before_anything_is_drawn() {
    let spoilers: [fn(&mut Drawing); 5] = [
        |drawing| drawing.series[1].y[3] = f64::NAN,
        |drawing| drawing.series[1].x[0] = f64::INFINITY,
        |drawing| drawing.frames[0].x.high = f64::NAN,
        |drawing| drawing.series[0].label_at = f64::NAN,
        |drawing| drawing.frames[1].y.low = f64::NEG_INFINITY,
    ];
    for spoil in spoilers {
        let mut drawing = response();
        spoil(&mut drawing);
        let mut recorder = Recorder::new(500.0, 400.0, 100);
        let answer = draw(&mut recorder, &drawing, &light(), &View::default());
        assert!(matches!(answer, Err(ChartError::NotFinite { .. })), "{answer:?}");
        assert!(recorder.calls.is_empty());
    }
    let turned = View { azimuth: f64::NAN, ..View::default() };
    assert!(draw(&mut Recorder::new(500.0, 400.0, 100), &pitchforks(), &light(), &turned).is_err());
}

#[test]
fn drawings_that_contradict_themselves_are_refused() {
    let spoilers: [fn(&mut Drawing); 6] = [
        |drawing| drawing.series[1].frame = 9,
        |drawing| drawing.series[1].x.truncate(5),
        |drawing| drawing.frames[0].x.high = drawing.frames[0].x.low,
        |drawing| drawing.frames[0].cell = (1, 0),
        |drawing| drawing.series[1].pieces = vec![5, 2],
        |drawing| drawing.series[0].x.push(1.0),
    ];
    for spoil in spoilers {
        let mut drawing = response();
        spoil(&mut drawing);
        let answer = draw(&mut Recorder::new(500.0, 400.0, 100), &drawing, &light(), &View::default());
        assert!(matches!(answer, Err(ChartError::Malformed { .. })), "{answer:?}");
    }
}

#[test]
fn pictures_too_small_or_too_large_are_refused() {
    for size in [(119.0, 300.0), (300.0, 119.0), (9000.0, 300.0), (f64::NAN, 300.0)] {
        let answer = svg(&response(), "", "", size, &light(), &View::default());
        assert!(matches!(answer, Err(ChartError::Size { .. })), "{size:?}");
    }
    for size in [(120.0, 120.0), (8192.0, 200.0)] {
        for (name, drawing, _) in all() {
            assert!(svg(&drawing, "", "", size, &light(), &View::default()).is_ok(), "{name} {size:?}");
        }
    }
}

#[test]
fn wild_numbers_are_drawn_or_refused_but_never_passed_on() {
    let wild = [0.0, -0.0, 1e-300, -1e-300, 1e300, -1e300, f64::MAX, f64::MIN, 1.0, -3.5, 1e9];
    for (i, &a) in wild.iter().enumerate() {
        for (j, &b) in wild.iter().enumerate() {
            let mut drawing = response();
            let line = &mut drawing.series[1];
            (line.x[7], line.y[7]) = (a, b);
            let (low, high) = if a < b { (a, b) } else { (0.0, 1.0) };
            (drawing.frames[1].x.low, drawing.frames[1].x.high) = (low, high);
            let mut recorder = Recorder::new(400.0, 300.0, 100);
            let answer = draw(&mut recorder, &drawing, &light(), &View::default());
            if answer.is_err() {
                assert!(matches!(answer, Err(ChartError::NotFinite { .. })), "{i} {j} {answer:?}");
            }
            let far = |point: &[f64; 2]| !point.iter().all(|value| (-400.0..=1000.0).contains(value));
            assert!(!recorder.calls.iter().any(|(_, call)| match call {
                Call::Path { points, .. } => points.iter().any(far),
                _ => false,
            }));
        }
    }
}

#[test]
fn turning_the_view_moves_what_is_in_space_alone() {
    let drawing = pitchforks();
    let maps = |azimuth: f64| {
        let mut recorder = Recorder::new(900.0, 660.0, 100);
        draw(&mut recorder, &drawing, &light(), &View { azimuth, elevation: 0.4, ..View::default() }).unwrap()
    };
    let (one, other) = (maps(0.3), maps(0.9));
    assert_eq!(one[0], other[0]);
    assert_eq!(one[1].plot, other[1].plot);
    assert_ne!(one[1].projection, other[1].projection);
    // A whole turn changes nothing, but for rounding.
    let whole = maps(0.3 + std::f64::consts::TAU);
    for (a, b) in
        one[1].projection.unwrap().iter().flatten().zip(whole[1].projection.unwrap().iter().flatten())
    {
        assert!((a - b).abs() < 1e-9);
    }
}

#[test]
fn plotters_own_text_needs_no_font() {
    let mut surface = SvgSurface::new((200.0, 200.0)).unwrap();
    let style = TextStyle::from(("serif", 1200.0).into_font());
    let (wide, _) = surface.estimate_text_size("00", &style).unwrap();
    assert_eq!(wide, 1188);
    surface.draw_text("00", &style, (1000, 1000)).unwrap();
    assert!(surface.finish("", "").contains(">00</tspan>"));
}

/// Every demonstration in every theme and two widths; also left in `target/gallery`, to be looked at.
#[test]
fn every_demonstration_is_drawn_in_every_theme_and_width() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("target/gallery");
    std::fs::create_dir_all(&folder).unwrap();
    for (name, drawing, aspect) in all() {
        for theme in Theme::NAMES {
            for width in [900.0_f64, 360.0] {
                let size = (width, pleasant_height(&drawing, aspect, width));
                let look = Theme::by_name(theme).unwrap();
                let text = svg(&drawing, name, "", size, &look, &View::default()).unwrap();
                assert!(
                    text.starts_with("<svg") && text.trim_end().ends_with("</svg>"),
                    "{name} {theme} {width}"
                );
                std::fs::write(folder.join(format!("{name}-{theme}-{width}.svg")), text).unwrap();
            }
        }
    }
}
