//! Colours, strokes and marks: one look for each meaning, in each theme.
//!
//! Text stands out from the ground by at least 4.5 : 1, lines and marks by 3 : 1; the tests compute it. The colours
//! themselves stand in `palettes`.

use plotters_backend::BackendColor;

use super::drawing::Role;
use super::palettes::TABLES;

/// A colour in sRGB, red, green, blue from 0 to 255.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Color(pub u8, pub u8, pub u8);

impl Color {
    /// The colour with an opacity from 0 (unseen) to 1, for a backend.
    pub fn backend(self, alpha: f64) -> BackendColor {
        BackendColor { alpha, rgb: (self.0, self.1, self.2) }
    }

    /// The colour laid over a ground with an opacity from 0 to 1.
    #[must_use]
    pub fn over(self, ground: Self, alpha: f64) -> Self {
        let mix =
            |top: u8, under: u8| (f64::from(top) * alpha + f64::from(under) * (1.0 - alpha)).round() as u8;
        Self(mix(self.0, ground.0), mix(self.1, ground.1), mix(self.2, ground.2))
    }

    /// Relative luminance by WCAG 2.2, 0 (black) to 1 (white).
    pub fn luminance(self) -> f64 {
        let linear = |channel: u8| {
            let value = f64::from(channel) / 255.0;
            if value <= 0.04045 { value / 12.92 } else { ((value + 0.055) / 1.055).powf(2.4) }
        };
        0.2126 * linear(self.0) + 0.7152 * linear(self.1) + 0.0722 * linear(self.2)
    }

    /// Contrast ratio with another colour by WCAG 2.2, 1 to 21.
    pub fn contrast(self, other: Self) -> f64 {
        let (a, b) = (self.luminance(), other.luminance());
        (a.max(b) + 0.05) / (a.min(b) + 0.05)
    }
}

/// Form of a single mark.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// Round.
    Dot,
    /// Five points: a bifurcation.
    Star,
    /// Open: a torus bifurcation.
    Diamond,
    /// Filled: a fold.
    Triangle,
    /// Across: an event, or a bifurcation across the manifold.
    Cross,
    /// A ring about a dot: what the reader moves.
    Ring,
}

/// How a series looks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Look {
    /// Colour of lines and marks.
    pub stroke: Color,
    /// Width of lines, CSS pixels.
    pub width: f64,
    /// Lengths of dash and gap, CSS pixels; none: solid.
    pub dash: Option<[f64; 2]>,
    /// Colour of filled areas.
    pub fill: Color,
    /// Opacity of filled areas and of the points of a cloud, 0 to 1.
    pub opacity: f64,
    /// Colour of the label.
    pub text: Color,
    /// Form of single marks.
    pub shape: Shape,
    /// Radius of single marks, CSS pixels.
    pub radius: f64,
    /// Outline of single marks.
    pub outline: Option<Color>,
    /// Fine hatch over filled areas.
    pub hatch: bool,
}

/// A colour as mark and as text: the text is set deeper where the mark alone would be too faint to read.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hue {
    /// Of lines and marks.
    pub mark: Color,
    /// Of words.
    pub text: Color,
}

/// The look of every meaning on one ground.
#[derive(Clone, Debug, PartialEq)]
pub struct Theme {
    /// Name by which it is asked for, one of [`Theme::NAMES`].
    pub name: &'static str,
    /// Size of letters over their usual size.
    pub letters: f64,
    /// Width of lines over their usual width.
    pub lines: f64,
    /// Size of marks over their usual size.
    pub marks: f64,
    /// The ground everything is drawn on.
    pub ground: Color,
    /// Titles and labels of axes.
    pub ink: Color,
    /// Numbers at the axes.
    pub quiet: Color,
    /// Lines of the axes.
    pub axis: Color,
    /// Lines of the grid: they guide the eye and say nothing of their own.
    pub grid: Color,
    /// Edge of marks whose own colour is too light or too dark for the ground.
    pub edge: Color,
    pub(super) blue: Hue,
    pub(super) vermilion: Hue,
    pub(super) green: Hue,
    pub(super) grey: Hue,
    pub(super) yellow: Hue,
    pub(super) orange: Hue,
    pub(super) red: Hue,
    pub(super) sky: Hue,
    pub(super) neutral: Hue,
    pub(super) first: Color,
    pub(super) second: Color,
}

/// Dash and gap of lines two pixels wide, CSS pixels.
const DASH: [f64; 2] = [7.0, 4.5];
/// Dash and gap of thin lines, CSS pixels.
const FINE_DASH: [f64; 2] = [5.0, 3.5];

impl Theme {
    /// Names of all themes.
    pub const NAMES: [&'static str; 6] = ["light", "dark", "projector", "contrast", "contrast-dark", "print"];

    /// The theme of a name, one of [`Theme::NAMES`].
    pub fn by_name(name: &str) -> Option<Self> {
        TABLES.iter().find(|theme| theme.name == name).map(|theme| (*theme).clone())
    }

    /// How a series of this role looks: dashed when unstable, solid when stable or when that is no question.
    pub fn look(&self, role: Role, stable: Option<bool>) -> Look {
        let unstable = stable == Some(false);
        let plain = |hue: Hue, width: f64| Look {
            stroke: hue.mark,
            width: width * self.lines,
            dash: unstable.then_some(self.dash(if width < 1.8 { FINE_DASH } else { DASH })),
            fill: hue.mark,
            opacity: 1.0,
            text: hue.text,
            shape: Shape::Dot,
            radius: 3.5 * self.marks,
            outline: None,
            hatch: false,
        };
        let mark = |hue: Hue, shape: Shape, radius: f64, outline: Option<Color>| Look {
            shape,
            radius: radius * self.marks,
            outline,
            dash: None,
            ..plain(hue, 1.5)
        };
        let area = |hue: Hue, opacity: f64| Look { opacity, dash: None, ..plain(hue, 1.0) };
        let ink = Hue { mark: self.ink, text: self.ink };
        match role {
            Role::Exact => plain(if unstable { self.vermilion } else { self.blue }, 2.0),
            Role::Paper => plain(self.grey, 1.2),
            Role::Corrected => plain(self.green, 2.0),
            Role::CorrectedSecond => plain(self.green, 1.2),
            Role::Supercritical => mark(self.green, Shape::Star, 7.5, Some(self.deepened(self.green.mark))),
            Role::Subcritical => mark(self.yellow, Shape::Star, 7.5, Some(self.edge)),
            Role::Bifurcation => mark(ink, Shape::Star, 7.0, None),
            Role::Saddle => mark(self.red, Shape::Dot, 4.5, None),
            Role::UnstableSpiral => mark(self.orange, Shape::Dot, 4.5, Some(self.deepened(self.orange.mark))),
            Role::Attractor => Look { dash: None, radius: 4.5 * self.marks, ..plain(self.blue, 1.6) },
            Role::Trajectory => {
                Look { dash: None, radius: 1.7 * self.marks, opacity: 0.85, ..plain(self.sky, 0.9) }
            }
            Role::DeadZone => Look { hatch: true, ..area(self.red, 0.1) },
            Role::Reference => Look { dash: None, radius: 3.0 * self.marks, ..plain(self.neutral, 1.0) },
            Role::OtherRegime => Look { dash: Some(self.dash(FINE_DASH)), ..plain(self.grey, 1.4) },
            Role::Handle => mark(ink, Shape::Ring, 6.0, None),
            Role::BodyFirst => Look { fill: self.first, dash: None, ..plain(ink, 1.3) },
            Role::BodySecond => Look { fill: self.second, dash: None, ..plain(ink, 1.3) },
            Role::Link => Look { dash: None, radius: 2.5 * self.marks, ..plain(ink, 1.3) },
            Role::Event => mark(self.vermilion, Shape::Cross, 4.5, None),
            Role::IntervalStable => area(self.blue, 0.16),
            Role::IntervalSaddle => area(self.vermilion, 0.14),
            Role::IntervalSpiral => Look { stroke: self.orange.text, ..area(self.orange, 0.24) },
            Role::QuasiPeriodic => {
                let hue = if unstable { self.vermilion } else { self.blue };
                Look { radius: 2.3 * self.marks, ..plain(hue, 1.6) }
            }
            Role::Fold => mark(ink, Shape::Triangle, 5.6, None),
            Role::TorusBifurcation => mark(ink, Shape::Diamond, 5.8, None),
            Role::AcrossManifold => mark(ink, Shape::Cross, 5.2, None),
            Role::Growth | Role::Basins => area(ink, 1.0),
            Role::Downward => Look { dash: None, radius: 2.2 * self.marks, opacity: 0.9, ..plain(ink, 1.0) },
        }
    }

    /// Lengths of dash and gap that suit its lines: thicker lines need longer ones to be seen as dashed.
    fn dash(&self, [dash, gap]: [f64; 2]) -> [f64; 2] {
        let stretch = self.lines.max(1.0);
        [dash * stretch, gap * stretch]
    }

    /// Whether it is dark on light.
    pub fn is_light(&self) -> bool {
        self.ground.luminance() > self.ink.luminance()
    }

    /// The colour of the region whose starts escape.
    pub fn escaped(&self) -> Color {
        self.neutral.mark.over(self.ground, 0.45)
    }

    /// A colour moved towards the ink, so that it can edge an area of itself.
    fn deepened(&self, color: Color) -> Color {
        self.ink.over(color, 0.55)
    }
}

#[cfg(test)]
mod tests {
    use super::{Color, Look, Role, Theme};

    const ROLES: [Role; 29] = [
        Role::Exact,
        Role::Paper,
        Role::Corrected,
        Role::CorrectedSecond,
        Role::Supercritical,
        Role::Subcritical,
        Role::Bifurcation,
        Role::Saddle,
        Role::UnstableSpiral,
        Role::Attractor,
        Role::Trajectory,
        Role::DeadZone,
        Role::Reference,
        Role::OtherRegime,
        Role::Handle,
        Role::BodyFirst,
        Role::BodySecond,
        Role::Link,
        Role::Event,
        Role::IntervalStable,
        Role::IntervalSaddle,
        Role::IntervalSpiral,
        Role::QuasiPeriodic,
        Role::Fold,
        Role::TorusBifurcation,
        Role::AcrossManifold,
        Role::Growth,
        Role::Basins,
        Role::Downward,
    ];

    fn looks(theme: &Theme) -> impl Iterator<Item = (Role, Look)> {
        ROLES
            .iter()
            .flat_map(|&role| [None, Some(true), Some(false)].map(|stable| (role, theme.look(role, stable))))
    }

    #[test]
    fn contrast_is_that_of_the_standard() {
        assert!((Color(0, 0, 0).contrast(Color(255, 255, 255)) - 21.0).abs() < 1e-12);
        // #767676 is the lightest grey that passes 4.5 : 1 on white.
        let ratio = Color(0x76, 0x76, 0x76).contrast(Color(255, 255, 255));
        assert!((4.5..4.6).contains(&ratio), "{ratio}");
    }

    #[test]
    fn text_is_readable() {
        for name in Theme::NAMES {
            let theme = Theme::by_name(name).unwrap();
            for (meaning, color) in [("ink", theme.ink), ("quiet", theme.quiet)] {
                assert!(color.contrast(theme.ground) >= 4.5, "{name} {meaning}");
            }
            for (role, look) in looks(&theme) {
                let ratio = look.text.contrast(theme.ground);
                assert!(ratio >= 4.5, "{name} {role:?} {ratio}");
                // On an area of its own the label must be read as well.
                let area = look.fill.over(theme.ground, look.opacity);
                if look.opacity < 0.5 {
                    assert!(
                        look.text.contrast(area) >= 4.5,
                        "{name} {role:?} on its area: {}",
                        look.text.contrast(area)
                    );
                }
            }
        }
    }

    #[test]
    fn lines_and_marks_stand_out() {
        for name in Theme::NAMES {
            let theme = Theme::by_name(name).unwrap();
            assert!(theme.axis.contrast(theme.ground) >= 3.0);
            for (role, look) in looks(&theme) {
                let outline = look.outline.map_or(0.0, |color| color.contrast(theme.ground));
                let ratio = look.stroke.contrast(theme.ground).max(outline);
                assert!(ratio >= 3.0, "{name} {role:?} {ratio}");
            }
        }
    }

    #[test]
    fn where_contrast_is_asked_for_there_is_more_of_it() {
        for name in ["projector", "contrast", "contrast-dark"] {
            let theme = Theme::by_name(name).unwrap();
            for (role, look) in looks(&theme) {
                let outline = look.outline.map_or(0.0, |color| color.contrast(theme.ground));
                let line = look.stroke.contrast(theme.ground).max(outline);
                assert!(line >= 4.5, "{name} {role:?} {line}");
                let text = look.text.contrast(theme.ground);
                assert!(text >= 7.0, "{name} {role:?} {text}");
            }
            assert!(theme.ink.contrast(theme.ground) >= 20.0 && theme.lines > 1.0 && theme.letters > 1.0);
        }
        let print = Theme::by_name("print").unwrap();
        assert_eq!((print.ground, print.ink), (Color(255, 255, 255), Color(0, 0, 0)));
        assert!(looks(&print).all(|(_, look)| look.text.contrast(print.ground) >= 7.0));
    }

    /// Hue of a colour, degrees.
    fn hue(Color(red, green, blue): Color) -> f64 {
        let [red, green, blue] = [red, green, blue].map(f64::from);
        let side = 3.0_f64.sqrt() * (green - blue);
        side.atan2(2.0 * red - green - blue).to_degrees().rem_euclid(360.0)
    }

    #[test]
    fn a_meaning_keeps_its_hue_and_its_rank_in_every_theme() {
        let light = Theme::by_name("light").unwrap();
        let dark = Theme::by_name("dark").unwrap();
        for name in Theme::NAMES {
            let theme = Theme::by_name(name).unwrap();
            for (role, stable) in [
                (Role::Exact, Some(true)),
                (Role::Exact, Some(false)),
                (Role::Corrected, None),
                (Role::Subcritical, None),
                (Role::Saddle, None),
                (Role::Trajectory, None),
            ] {
                let turn = hue(theme.look(role, stable).stroke) - hue(light.look(role, stable).stroke);
                let turn = (turn + 180.0).rem_euclid(360.0) - 180.0;
                assert!(turn.abs() < 12.0, "{name} {role:?} {turn}");
            }
            // What stands out more on the plain ground of its kind stands out more here.
            let plain = if theme.is_light() { &light } else { &dark };
            let ranked = |theme: &Theme| {
                let mut roles = [Role::Exact, Role::Corrected, Role::Paper, Role::Saddle];
                roles.sort_by(|&one, &other| {
                    let of = |role| theme.look(role, Some(true)).stroke.contrast(theme.ground);
                    of(one).total_cmp(&of(other))
                });
                roles
            };
            assert_eq!(ranked(&theme), ranked(plain), "{name}");
        }
    }

    #[test]
    fn the_light_theme_uses_the_colours_promised() {
        let light = Theme::by_name("light").unwrap();
        assert_eq!(light.look(Role::Exact, Some(true)).stroke, Color(0x00, 0x72, 0xB2));
        assert_eq!(light.look(Role::Exact, Some(false)).stroke, Color(0xD5, 0x5E, 0x00));
        assert_eq!(light.look(Role::Corrected, None).stroke, Color(0x00, 0x9E, 0x73));
    }

    #[test]
    fn stability_shows_in_the_line() {
        let light = Theme::by_name("light").unwrap();
        for role in [Role::Exact, Role::QuasiPeriodic, Role::Paper, Role::Corrected, Role::CorrectedSecond] {
            assert!(light.look(role, Some(true)).dash.is_none());
            assert!(light.look(role, None).dash.is_none());
            assert!(light.look(role, Some(false)).dash.is_some());
        }
    }

    #[test]
    fn unknown_themes_are_not_guessed() {
        assert!(Theme::by_name("Light").is_none());
    }
}
