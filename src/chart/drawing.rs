//! What is to be drawn, as plain data: frames with axes, and series of points in them.
//!
//! A [`Drawing`] says what each line means; how it looks follows from its [`Role`] and from the theme alone,
//! so that one meaning looks the same everywhere.

/// A whole picture: frames in a grid of cells, and what is drawn in them.
#[derive(Clone, Debug, PartialEq)]
pub struct Drawing {
    /// Grid of cells: columns, rows. Cells share the picture evenly.
    pub grid: (usize, usize),
    /// The coordinate frames.
    pub frames: Vec<Frame>,
    /// Lines, points, bands and texts, in the order in which they are drawn (first lies below).
    pub series: Vec<Series>,
}

/// One coordinate frame (a chart proper) of a drawing.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// Short unique name within the drawing, ASCII, e.g. `hardening-plane`.
    pub name: String,
    /// Title above the frame, in label markup (see [`Axis::label`]); may be empty.
    pub title: String,
    /// Horizontal axis (for a 3-D frame: the first horizontal one).
    pub x: Axis,
    /// Vertical axis (for a 3-D frame: the second horizontal one).
    pub y: Axis,
    /// Scale of the fields in a plane frame, drawn as a bar of colours beside it: up to `low` nothing is painted, from
    /// `high` on everything alike.
    pub bar: Option<Axis>,
    /// Third axis: with it the frame is a 3-D view, `z` upwards, turned by the view's azimuth and elevation.
    pub z: Option<Axis>,
    /// First cell in the grid (column, row) from the upper left.
    pub cell: (usize, usize),
    /// How many cells it spans (columns, rows), each at least 1.
    pub span: (usize, usize),
    /// One unit of x as long as one unit of y (for a schematic).
    pub equal_aspect: bool,
    /// No axes, ticks and grid (for a schematic).
    pub bare: bool,
}

/// One axis of a frame.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// The quantity by its ASCII name, from `docs/symbols.md`, e.g. `Omega_1`.
    pub name: String,
    /// Label in markup: `*x*` is italic, `_{..}` a subscript, `'` a prime; Unicode letters as they are, e.g. `*Ω*_{1}`.
    pub label: String,
    /// Value at the left or lower end.
    pub low: f64,
    /// Value at the right or upper end; more than `low`.
    pub high: f64,
}

/// One thing that is drawn in a frame, with its meaning.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// Index of the frame in [`Drawing::frames`].
    pub frame: usize,
    /// Short name, unique within the drawing, ASCII, e.g. `R_2,3 hardening (63)`.
    pub name: String,
    /// What it means, a phrase in plain words for tables, readout and the ear.
    pub meaning: String,
    /// Stable, unstable, or not a matter of stability.
    pub stable: Option<bool>,
    /// What it is; colour, stroke and mark follow from it.
    pub role: Role,
    /// How the columns are read.
    pub mark: Mark,
    /// Label drawn at the curve, in label markup; none: no label.
    pub label: Option<String>,
    /// Where the label would best sit, as a fraction 0..1 along the points (the chart may move it to keep it clear).
    pub label_at: f64,
    /// First coordinate of each point. All numbers finite.
    pub x: Vec<f64>,
    /// Second coordinate of each point.
    pub y: Vec<f64>,
    /// Third coordinate: empty in a plane frame. For a [`Mark::Field`] the numbers over the grid of `x` and `y`.
    pub z: Vec<f64>,
    /// Index at which each separate piece of a curve begins, rising; empty: one piece.
    pub pieces: Vec<usize>,
}

/// How the columns of a series are read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    /// Connected line, piece by piece, clipped to the frame.
    Curve,
    /// Curve closed piece by piece and filled.
    Filled,
    /// A cloud of many small points, drawn as one image.
    Cloud,
    /// Single marks (dot, star, diamond, triangle, cross, after the role), each of its own.
    Marks,
    /// Two points: opposite corners of a rectangle, which is filled (the dead zone with a hatch) and clipped to the frame.
    Band,
    /// One point: the label is written there.
    Text,
    /// Numbers over a grid, painted as an image: `x` holds the places of the columns, `y` those of the rows, both evenly
    /// spaced and rising, `z` a number for each column of the first row, then of the next.
    Field,
}

/// What a series is; its look follows from this, from `stable` and from the theme.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// Exact numerical answer: blue solid when stable, vermilion dashed when unstable.
    Exact,
    /// The paper's formula as printed: thin grey, solid or dashed.
    Paper,
    /// The corrected or damped formula: bluish green, solid or dashed.
    Corrected,
    /// The second corrected amplitude of a pair (thinner than [`Role::Corrected`]).
    CorrectedSecond,
    /// Supercritical bifurcation: green star.
    Supercritical,
    /// Subcritical bifurcation: yellow star with a dark outline.
    Subcritical,
    /// A bifurcation point of the paper whose kind is not told: black star (ink of the theme).
    Bifurcation,
    /// Saddle at the origin: red dot.
    Saddle,
    /// Unstable spiral at the origin: orange dot.
    UnstableSpiral,
    /// Stable fixed point or attractor of a map: large blue mark or cloud.
    Attractor,
    /// Transient or trajectory: small, light blue.
    Trajectory,
    /// The dead zone of the teeth: light red with a fine hatch.
    DeadZone,
    /// Thin neutral line: an axis, a unit circle, a tongue's edge.
    Reference,
    /// The same quantity in another regime, e.g. `contact` beside `backlash`: neutral, dashed.
    OtherRegime,
    /// Something that the reader moves, or the present state.
    Handle,
    /// A solid body of a schematic: pinion or first body.
    BodyFirst,
    /// A solid body of a schematic: gear or second body.
    BodySecond,
    /// A spring, damper, ground or line of a schematic.
    Link,
    /// An event marked in time (contact lost, escape): vermilion cross.
    Event,
    /// An interval of a scale, stable (centre): blue band.
    IntervalStable,
    /// An interval of a scale, unstable by a real exponent (saddle): vermilion band.
    IntervalSaddle,
    /// An interval of a scale, unstable spiral: orange band.
    IntervalSpiral,
    /// Exact quasi-periodic motion: as [`Role::Exact`], with small open circles along the line.
    QuasiPeriodic,
    /// A fold of a branch: filled triangle.
    Fold,
    /// A torus (Neimark-Sacker) bifurcation: open diamond.
    TorusBifurcation,
    /// A bifurcation across the manifold on which the branch lies: cross.
    AcrossManifold,
    /// A field of growth rates: the ramp of the frame's bar, nothing where nothing grows.
    Growth,
    /// A field of whole numbers, one a region (basin of attraction); -1: escapes, below: not known yet.
    Basins,
    /// What is found while a parameter falls, beside the same while it rises ([`Role::Attractor`]): small, dark.
    Downward,
}
