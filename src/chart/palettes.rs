//! The colours of every theme: one table each.
//!
//! Those after the first two are made of them: every hue is kept, and its contrast with the ground raised by one factor
//! for the whole table, so that what stood out more still does.

use super::theme::{Color, Hue, Theme};

/// All tables, in the order of [`Theme::NAMES`].
pub const TABLES: [&Theme; 6] = [&LIGHT, &DARK, &PROJECTOR, &CONTRAST, &CONTRAST_DARK, &PRINT];

const WHITE: Color = Color(255, 255, 255);
const BLACK: Color = Color(0, 0, 0);

/// Blue #0072B2, vermilion #D55E00 and bluish green #009E73 on paper white.
const LIGHT: Theme = Theme {
    name: "light",
    letters: 1.0,
    lines: 1.0,
    marks: 1.0,
    ground: Color(255, 255, 255),
    ink: Color(27, 31, 36),
    quiet: Color(78, 85, 93),
    axis: Color(72, 79, 87),
    grid: Color(232, 234, 237),
    edge: Color(64, 50, 8),
    blue: Hue { mark: Color(0, 114, 178), text: Color(0, 102, 160) },
    vermilion: Hue { mark: Color(213, 94, 0), text: Color(176, 74, 0) },
    green: Hue { mark: Color(0, 158, 115), text: Color(0, 118, 86) },
    grey: Hue { mark: Color(128, 132, 137), text: Color(98, 103, 109) },
    yellow: Hue { mark: Color(246, 205, 34), text: Color(120, 94, 0) },
    orange: Hue { mark: Color(230, 159, 0), text: Color(140, 92, 0) },
    red: Hue { mark: Color(196, 22, 42), text: Color(176, 16, 36) },
    sky: Hue { mark: Color(66, 146, 198), text: Color(20, 104, 158) },
    neutral: Hue { mark: Color(126, 131, 137), text: Color(90, 96, 103) },
    first: Color(203, 220, 233),
    second: Color(226, 221, 209),
};

/// The same hues in the same order, lifted from a dark ground.
const DARK: Theme = Theme {
    name: "dark",
    letters: 1.0,
    lines: 1.0,
    marks: 1.0,
    ground: Color(20, 23, 27),
    ink: Color(233, 235, 238),
    quiet: Color(176, 183, 191),
    axis: Color(150, 158, 167),
    grid: Color(40, 45, 52),
    edge: Color(250, 240, 205),
    blue: Hue { mark: Color(66, 170, 236), text: Color(108, 190, 243) },
    vermilion: Hue { mark: Color(255, 130, 46), text: Color(255, 158, 94) },
    green: Hue { mark: Color(34, 197, 148), text: Color(74, 214, 170) },
    grey: Hue { mark: Color(140, 147, 155), text: Color(166, 173, 181) },
    yellow: Hue { mark: Color(246, 211, 60), text: Color(246, 217, 98) },
    orange: Hue { mark: Color(244, 176, 42), text: Color(246, 190, 84) },
    red: Hue { mark: Color(240, 84, 92), text: Color(252, 132, 138) },
    sky: Hue { mark: Color(104, 160, 204), text: Color(138, 186, 224) },
    neutral: Hue { mark: Color(132, 140, 149), text: Color(166, 174, 183) },
    first: Color(47, 70, 88),
    second: Color(76, 70, 57),
};

/// For a wall: large letters, thick lines, and colours that a lamp in a lit room does not wash out.
const PROJECTOR: Theme = Theme {
    name: "projector",
    letters: 1.5,
    lines: 1.8,
    marks: 1.5,
    ground: WHITE,
    ink: BLACK,
    quiet: Color(38, 42, 48),
    axis: Color(30, 34, 40),
    grid: Color(214, 218, 223),
    edge: Color(64, 50, 8),
    blue: Hue { mark: Color(0, 91, 142), text: Color(0, 84, 132) },
    vermilion: Hue { mark: Color(174, 77, 0), text: Color(147, 62, 0) },
    green: Hue { mark: Color(0, 130, 95), text: Color(0, 98, 72) },
    grey: Hue { mark: Color(105, 108, 112), text: Color(81, 85, 90) },
    yellow: Hue { mark: Color(246, 205, 34), text: Color(99, 77, 0) },
    orange: Hue { mark: Color(230, 159, 0), text: Color(116, 77, 0) },
    red: Hue { mark: Color(155, 17, 33), text: Color(144, 13, 30) },
    sky: Hue { mark: Color(54, 120, 163), text: Color(17, 86, 131) },
    neutral: Hue { mark: Color(103, 107, 112), text: Color(74, 79, 85) },
    first: Color(203, 220, 233),
    second: Color(226, 221, 209),
};

/// Dark on white for readers who have asked for more contrast.
const CONTRAST: Theme = Theme {
    name: "contrast",
    letters: 1.1,
    lines: 1.3,
    marks: 1.15,
    ground: WHITE,
    ink: BLACK,
    quiet: Color(30, 33, 38),
    axis: BLACK,
    grid: Color(200, 204, 209),
    edge: Color(40, 30, 0),
    blue: Hue { mark: Color(0, 82, 129), text: Color(0, 79, 124) },
    vermilion: Hue { mark: Color(160, 70, 0), text: Color(139, 59, 0) },
    green: Hue { mark: Color(0, 120, 88), text: Color(0, 93, 68) },
    grey: Hue { mark: Color(96, 99, 103), text: Color(77, 81, 86) },
    yellow: Hue { mark: Color(246, 205, 34), text: Color(93, 73, 0) },
    orange: Hue { mark: Color(230, 159, 0), text: Color(110, 72, 0) },
    red: Hue { mark: Color(138, 16, 30), text: Color(135, 12, 28) },
    sky: Hue { mark: Color(50, 110, 150), text: Color(16, 81, 124) },
    neutral: Hue { mark: Color(94, 98, 103), text: Color(70, 74, 80) },
    first: Color(203, 220, 233),
    second: Color(226, 221, 209),
};

/// Light on black for those who want the dark theme and more contrast.
const CONTRAST_DARK: Theme = Theme {
    name: "contrast-dark",
    ground: BLACK,
    ink: WHITE,
    quiet: Color(226, 229, 233),
    axis: WHITE,
    grid: Color(64, 70, 78),
    edge: Color(255, 250, 228),
    blue: Hue { mark: Color(94, 183, 239), text: Color(137, 203, 245) },
    vermilion: Hue { mark: Color(255, 152, 82), text: Color(255, 178, 127) },
    green: Hue { mark: Color(78, 209, 169), text: Color(121, 225, 192) },
    grey: Hue { mark: Color(152, 159, 166), text: Color(180, 186, 192) },
    yellow: Hue { mark: Color(250, 229, 138), text: Color(250, 234, 166) },
    orange: Hue { mark: Color(247, 194, 91), text: Color(249, 208, 132) },
    red: Hue { mark: Color(242, 107, 114), text: Color(253, 153, 158) },
    sky: Hue { mark: Color(122, 172, 210), text: Color(159, 199, 230) },
    neutral: Hue { mark: Color(144, 152, 160), text: Color(180, 187, 194) },
    first: Color(47, 70, 88),
    second: Color(76, 70, 57),
    ..CONTRAST
};

/// For paper: black words and axes, and lines from half a point to one point.
const PRINT: Theme = Theme {
    name: "print",
    letters: 1.0,
    lines: 2.0 / 3.0,
    marks: 0.85,
    ground: WHITE,
    ink: BLACK,
    quiet: BLACK,
    axis: BLACK,
    grid: Color(222, 224, 227),
    edge: Color(40, 30, 0),
    blue: Hue { mark: Color(0, 114, 178), text: Color(0, 84, 132) },
    vermilion: Hue { mark: Color(213, 94, 0), text: Color(147, 62, 0) },
    green: Hue { mark: Color(0, 158, 115), text: Color(0, 98, 72) },
    grey: Hue { mark: Color(128, 132, 137), text: Color(81, 85, 90) },
    yellow: Hue { mark: Color(246, 205, 34), text: Color(99, 77, 0) },
    orange: Hue { mark: Color(230, 159, 0), text: Color(116, 77, 0) },
    red: Hue { mark: Color(196, 22, 42), text: Color(144, 13, 30) },
    sky: Hue { mark: Color(66, 146, 198), text: Color(17, 86, 131) },
    neutral: Hue { mark: Color(126, 131, 137), text: Color(74, 79, 85) },
    first: Color(203, 220, 233),
    second: Color(226, 221, 209),
};
