/**
 * Pitchfork and Hopf bifurcations of gear pairs: the model, its theory and its figures.
 *
 * One ES module for pages, workers and Node 20 or newer. All quantities are dimensionless unless a unit is
 * said: lengths over half the backlash, time times the natural frequency of the mesh. `docs/api.md` has the
 * whole contract with a runnable example for each call.
 */

/** Mesh regime: what the tooth force is a function of. */
export type Regime = "homogeneous" | "contact" | "backlash";

/**
 * Parameters by name; what is not given takes its default. A full name (`m_p`) beats its short form (`m`).
 * The ranges stand in `defaults()` and in `docs/api.md`.
 */
export interface Parameters {
  m?: number;
  m_p?: number;
  m_g?: number;
  k?: number;
  k_p?: number;
  k_g?: number;
  alpha?: number;
  alpha_p?: number;
  alpha_g?: number;
  zeta?: number;
  zeta_s?: number;
  zeta_p?: number;
  zeta_g?: number;
  k0?: number;
  Omega?: number;
  F?: number;
  F_p?: number;
  F_g?: number;
  E?: number;
  Omega_p?: number;
  Omega_g?: number;
  regime?: Regime;
}

/** Every parameter by its full name, as results carry them. */
export interface FullParameters {
  m_p: number;
  m_g: number;
  k_p: number;
  k_g: number;
  alpha_p: number;
  alpha_g: number;
  zeta: number;
  zeta_p: number;
  zeta_g: number;
  k0: number;
  Omega: number;
  F: number;
  F_p: number;
  F_g: number;
  E: number;
  Omega_p: number;
  Omega_g: number;
  regime: Regime;
}

/** What is known of one numerical parameter. */
export interface NumberParameterInfo {
  name: string;
  /** Label markup: `*x*` is italic, `_{..}` a subscript. */
  symbol: string;
  default: number;
  /** Least allowed value. */
  low: number;
  /** Greatest allowed value. */
  high: number;
  /** `[low, high]`. */
  range: [number, number];
  /** Range a slider covers; a number box takes the whole one. */
  slider: [number, number];
  scale: "linear" | "logarithmic";
  unit: "dimensionless";
  meaning: string;
  /** The parameter whose value it takes when it is not given. */
  follows: string | null;
  /** The short form that sets it together with its twin. */
  short: string | null;
  /** The parameters that it sets: itself, or for a short form both of the pair. */
  sets: string[];
}

/** What is known of the regime. */
export interface RegimeInfo {
  name: "regime";
  choices: Regime[];
  default: Regime;
  meaning: string;
}

export type ParameterInfo = NumberParameterInfo | RegimeInfo;

/** A real gear pair, SI units; case matters. */
export interface PhysicalPair {
  /** Mass of the pinion's body, kg. */
  M_p: number;
  /** Mass of the gear's body, kg. */
  M_g: number;
  /** Moment of inertia of the pinion, kg m^2. */
  I_p: number;
  /** Moment of inertia of the gear, kg m^2. */
  I_g: number;
  /** Base radius of the pinion, m. */
  r_p: number;
  /** Base radius of the gear, m. */
  r_g: number;
  /** Mean mesh stiffness, N/m. */
  K: number;
  /** Amplitude of the mesh stiffness, N/m. */
  K_amplitude?: number;
  /** Stiffness of the supports, N/m. */
  K_p: number;
  K_g: number;
  /** Cubic stiffness of the supports, N/m^3. */
  K_p3?: number;
  K_g3?: number;
  /** Damping of the mesh and of the supports, N s/m. */
  C?: number;
  C_p?: number;
  C_g?: number;
  /** Half the backlash, m. */
  b: number;
  /** Amplitude of the static transmission error, m. */
  E?: number;
  /** Mean torque on the pinion, N m. */
  T_p?: number;
  /** Mean torque on the gear, N m; when absent the one that balances. */
  T_g?: number;
  /** Amplitudes of the torques, N m. */
  T_p_amplitude?: number;
  T_g_amplitude?: number;
  /** Frequencies of the torques, rad/s; when absent those of the shafts. */
  omega_p?: number;
  omega_g?: number;
  /** Numbers of teeth. */
  teeth_p: number;
  teeth_g?: number;
  /** Speed of the pinion, revolutions a minute. */
  rpm_p: number;
}

/** The units of one gear pair: what the dimensionless numbers are to be multiplied with. */
export interface Scales {
  /** Equivalent mass, kg. */
  M: number;
  /** Natural frequency of the mesh, rad/s. */
  omega_n: number;
  /** Half the backlash, m. */
  b: number;
  /** Base radii, m; these six together, or none: without them speeds and torques are not given back. */
  r_p?: number;
  r_g?: number;
  /** Moments of inertia, kg m^2. */
  I_p?: number;
  I_g?: number;
  teeth_p?: number;
  teeth_g?: number;
}

/** How far a result can be trusted; those that apply are present. */
export interface ErrorEstimate {
  /** Relative deviation of the monodromy's determinant from Liouville's identity. */
  liouville?: number;
  /** Difference to the same computation with half the step or another integrator. */
  step?: number;
  /** What is left of the equation that was solved. */
  residual?: number;
}

/** What every result says of itself. */
export interface Provenance {
  /** How it was computed, in words. */
  method: string;
  error: ErrorEstimate;
}

/** State order everywhere: u_p, u_g, u, u_p', u_g', u'. */
export type State = ArrayLike<number>;

export interface Modes extends Provenance {
  /** Coupling numbers (38), (39). */
  a: number;
  b: number;
  /** Natural frequencies omega_1, omega_2, omega_3. */
  omega: Float64Array;
  /** Mode shapes (u_p, u_g, u), three a row, in the order of `omega`. */
  shapes: Float64Array;
}

/** An interval of Omega; nulls where it is closed. */
export interface Interval {
  left: number | null;
  right: number | null;
}

/** One tongue of instability. */
export interface Tongue {
  /** Where it starts from at k0 = 0. */
  Omega0: number;
  /** First order, as printed in the paper. */
  paper: Interval;
  /** First order, corrected, undamped. */
  corrected: Interval;
  /** First order with damping. */
  damped: Interval;
  /** Converged Hill determinant; null for the combination tongue and where it was not found. */
  hill: Interval | null;
  /** Why it was not found. */
  hillError: string | null;
  /** Least k0 at which the damped tongue is open. */
  threshold: number;
}

export interface Tongues extends Provenance {
  primary2: Tongue;
  primary3: Tongue;
  combination: Tongue;
}

export interface Multipliers extends Provenance {
  /** Real parts, six, largest modulus first. */
  re: Float64Array;
  /** Imaginary parts. */
  im: Float64Array;
  spectralRadius: number;
  stable: boolean;
  /** The periodic state at t = 0 that they are about. */
  state: Float64Array;
}

export interface TimeResponse extends Provenance {
  t: Float64Array;
  u_p: Float64Array;
  u_g: Float64Array;
  u: Float64Array;
  u_p_dot: Float64Array;
  u_g_dot: Float64Array;
  u_dot: Float64Array;
  /** Times at which u falls through 1. */
  contactLoss: Float64Array;
  /** Time at which the motion left over the softening barrier or diverged, or null. */
  escaped: number | null;
}

export interface Poincare extends Provenance {
  /** Times of the points, n T. */
  t: Float64Array;
  u_p: Float64Array;
  u_g: Float64Array;
  u: Float64Array;
  u_p_dot: Float64Array;
  u_g_dot: Float64Array;
  u_dot: Float64Array;
  escaped: number | null;
}

export interface PeriodicOrbit extends Provenance {
  /** State at t = 0. */
  state: Float64Array;
  multipliers: { re: Float64Array; im: Float64Array };
  /** All multipliers inside the unit circle; inside the tooth gap but for the one of a displacement of u, which is 1. */
  stable: boolean;
  /** Least and greatest value of each coordinate over the orbit. */
  min: Float64Array;
  max: Float64Array;
  /** True period over T. */
  period: number;
}

/** Which tongue: one of the three, or the one that holds or is next to a mesh frequency. */
export type TongueName = "primary2" | "primary3" | "combination" | { near: number };
/** What the multipliers do at an edge. */
export type EdgeKind = "period-doubling" | "neimark-sacker" | "plus-one" | "krein";
/** Evenly spaced values: low, high, number (2 to 4096). */
export type GridOption = ArrayLike<number>;
/** Low and high. */
export type RangeOption = ArrayLike<number>;
/** A coordinate of the state by name. */
export type Coordinate = "u_p" | "u_g" | "u" | "u_p_dot" | "u_g_dot" | "u_dot";

export interface TongueEdgesOptions extends ToleranceOption {
  tongue: TongueName;
}

export interface TongueEdges extends Interval, Provenance {
  /** At the left and at the right edge; null where the tongue is closed. */
  kind: [EdgeKind, EdgeKind] | null;
}

export interface TongueBoundaryOptions extends ToleranceOption {
  tongue: TongueName;
  /** Depths between which it is followed, default [0, 1]. */
  k0?: RangeOption;
  /** Points, 3 to 4096, default 90. */
  points?: number;
}

/** From the left leg over the tip to the right leg; empty where the tongue is closed at all these depths. */
export interface TongueBoundary extends Provenance {
  Omega: Float64Array;
  k0: Float64Array;
  kind: EdgeKind[];
  /** Points of the left leg, the first of the columns; without a tip the right leg is a curve of its own. */
  left: number;
  tip: { Omega: number; k0: number } | null;
}

export interface StabilityChartOptions {
  Omega: GridOption;
  k0: GridOption;
  /** Of the spectral radius, absolute, default 1e-6. */
  tolerance?: number;
}

/** Index of a point: i_k0 * Omega.length + i_Omega. `error.step` bounds the error of every point absolutely. */
export interface StabilityChart extends Provenance {
  Omega: Float64Array;
  k0: Float64Array;
  /** -1 where there is no periodic response that it could be about. */
  spectralRadius: Float64Array;
  /** How many such points there are. */
  missing: number;
}

export interface BranchOptions extends ToleranceOption {
  /** Any number of the model but Omega_p and Omega_g, default Omega. */
  parameter?: string;
  /** Within which it is followed; default the slider's range of the parameter. */
  range?: RangeOption;
  /** In mesh periods, 1 to 64. */
  period?: number;
  /** A state near an orbit of the branch. */
  from?: State;
  /** Most points each way, default 400. */
  points?: number;
  maxStep?: number;
}

export interface BranchEvent {
  kind: "fold" | "period-doubling" | "pitchfork" | "neimark-sacker" | "branch-point" | "grazing";
  /** Under the parameter's name its value. */
  [parameter: string]: unknown;
  state: Float64Array;
  /** Of a pitchfork, the symmetry that it breaks: u to -u, or pinion and gear. */
  breaks: "sign" | "exchange" | null;
  maxU_p: number;
  maxU: number;
  /** Of a period doubling or pitchfork; null also where it is too near the border between both to be told. */
  supercritical: boolean | null;
  /** Index of the point that it comes after, or is. */
  after: number;
}

export interface Branch extends Provenance {
  parameter: string;
  period: number;
  /** Under the parameter's name its values. */
  [parameter: string]: unknown;
  maxU_p: Float64Array;
  maxU: Float64Array;
  /** Six a row. */
  state: Float64Array;
  /** 1 or 0. */
  stable: Float64Array;
  /** Number of multipliers outside the unit circle. */
  unstable: Float64Array;
  /** Multipliers, six a row. */
  re: Float64Array;
  im: Float64Array;
  events: BranchEvent[];
  /** Why it ends at its first and at its last point. */
  ends: { kind: string; period: number | null; reason: string | null }[];
}

export interface DiagramOptions extends ToleranceOption {
  Omega?: RangeOption;
  /** Default 4. */
  maxPeriod?: number;
  /** Default 64. */
  maxBranches?: number;
}

export interface Diagram extends Provenance {
  branches: (Branch & { from: { branch: number; event: number } | null })[];
  /** False where there was more to follow than was allowed. */
  complete: boolean;
}

export interface Torus extends Provenance {
  /** Mean of sqrt(u_p^2 + u_p_dot^2). */
  meanRadius: number;
  /** Its frequency over Omega, folded into [0, 1/2]. */
  rotation: number;
  /** States along the circle, six a row. */
  curve: Float64Array;
  stable: boolean;
  /** Fastest growth across the circle, per unit of t. */
  growth: number;
  rMin: number;
  rMax: number;
  maxU_p: number;
  maxU: number;
  /** Circles that the map carries one into the next. */
  circles: number;
  /** The same by averages over a long motion; null where the circle attracts none. */
  averages: { meanRadius: number; rotation: number } | null;
}

export interface SweepOptions extends ToleranceOption {
  Omega: GridOption;
  direction?: "up" | "down";
  transient?: number;
  points?: number;
  state?: State;
}

export interface Sweep extends Provenance {
  Omega: Float64Array;
  u_p: Float64Array;
  u: Float64Array;
  /** Omega at which the motion escaped, or null. */
  escaped: number | null;
}

export interface LyapunovOptions extends ToleranceOption {
  state?: State;
  /** Default 2000. */
  periods?: number;
}

export interface Lyapunov extends Provenance {
  /** Six, largest first, per unit of t. */
  exponents: Float64Array;
  state: Float64Array;
}

export interface BasinOptions {
  /** Default u_p and u_p_dot. */
  plane?: [Coordinate, Coordinate];
  x: GridOption;
  y: GridOption;
  /** The other coordinates. */
  state?: State;
  /** After which a start is left undecided; default: as many as the slowest attractor asks for, 600 to 6000. */
  periods?: number;
  /** Default 1e-6. */
  tolerance?: number;
}

/** Index of a cell: i_y * n_x + i_x. */
export interface Basin extends Provenance {
  /** Index of the attractor, -1: escapes, -2: undecided. */
  attractor: Float64Array;
  /** At which of the orbit's points the motion is at t = 0, in the limit. */
  phase: Float64Array;
  attractors: {
    kind: "orbit" | "torus";
    period: number | null;
    state: Float64Array;
    /** Six a row. */
    points: Float64Array;
    /** Where the first is 1, this is the middle one of a continuous family of orbits inside the tooth gap. */
    multipliers: { re: Float64Array; im: Float64Array } | null;
  }[];
}

export interface ContactMarginOptions extends ToleranceOption {
  state?: State;
}

export interface ContactMargin extends Provenance {
  /** min u - 1. */
  margin: number;
  /** Time of the least u. */
  at: number;
  state: Float64Array;
  stable: boolean;
  /** In mesh periods. */
  period: number;
}

export interface LeastLoad extends Provenance {
  /** Smallest F with a stable response that keeps contact; null where no F helps. */
  F: number | null;
  /** The same without asking for stability. */
  contactF: number | null;
  /** What decides. */
  limit: "contact" | "stability" | "none";
  reason: "unstable" | "parted" | "no-response" | null;
  state: Float64Array | null;
}

export interface SpectrumOptions extends ToleranceOption {
  state?: State;
  /** Default 500. */
  transient?: number;
  /** Default 128. */
  periods?: number;
}

export interface AmplitudeSpectrum extends Provenance {
  /** Over Omega. */
  frequency: Float64Array;
  /** Of u. */
  amplitude: Float64Array;
  window: string;
}

export interface ToleranceOption {
  /** Tolerance of the integration, 1e-14 to 1e-3, default 1e-10. */
  tolerance?: number;
}

export interface TimeResponseOptions extends ToleranceOption {
  /** State at t = 0: six numbers, each from -1e6 to 1e6. */
  state?: State;
  /** Duration in mesh periods, above 0 and up to 100000, default 100. */
  periods?: number;
  /** Rows a period, 1 to 10000, default 64; at most 1000000 rows in all. */
  samplesPerPeriod?: number;
}

export interface PoincareOptions extends ToleranceOption {
  state?: State;
  /** Periods that are left out first, 0 to 1000000, default 0. */
  transient?: number;
  /** Points that are kept; with the transient at most 1000000; 1 to 1000000, default 1000. */
  points?: number;
}

export interface PeriodicOrbitOptions extends ToleranceOption {
  /** Period in mesh periods, 1 to 64, default 1. */
  period?: number;
  /** State to start the search from. */
  guess?: State;
}

/** One axis of a frame. */
export interface Axis {
  /** ASCII name of the quantity. */
  name: string;
  /** Label markup. */
  label: string;
  low: number;
  high: number;
}

/** One coordinate frame of a figure. */
export interface FigureFrame {
  /** Short unique name. */
  frame: string;
  title: string;
  x: Axis;
  y: Axis;
  /** Third axis of a view in space, or null. */
  z: Axis | null;
  /** Scale of the frame's fields, or null: nothing is painted up to `low`, everything alike from `high` on. */
  bar: Axis | null;
  /** First cell in the grid: column, row. */
  cell: [number, number];
  /** Cells it spans: columns, rows. */
  span: [number, number];
  equalAspect: boolean;
  bare: boolean;
}

export type Mark = "curve" | "filled" | "cloud" | "marks" | "band" | "text" | "field";

export type Role =
  | "exact"
  | "paper"
  | "corrected"
  | "corrected-second"
  | "supercritical"
  | "subcritical"
  | "bifurcation"
  | "saddle"
  | "unstable-spiral"
  | "attractor"
  | "trajectory"
  | "dead-zone"
  | "reference"
  | "other-regime"
  | "handle"
  | "body-first"
  | "body-second"
  | "link"
  | "event"
  | "interval-stable"
  | "interval-saddle"
  | "interval-spiral"
  | "quasi-periodic"
  | "fold"
  | "torus-bifurcation"
  | "across-manifold"
  | "growth"
  | "basins"
  | "downward";

/** One thing that is drawn, with its meaning and its numbers. */
export interface FigureSeries {
  /** Name of its frame. */
  frame: string;
  name: string;
  meaning: string;
  /** Stable, unstable, or not a matter of stability. */
  stable: boolean | null;
  role: Role;
  mark: Mark;
  label: string | null;
  /** Where the label sits, 0 to 1 along the points. */
  labelAt: number;
  /** Of a `field`: `x` the columns' places, `y` the rows', `z` the numbers, index i_y * x.length + i_x. */
  columns: { x: Float64Array; y: Float64Array; z?: Float64Array };
  /** Index at which each separate piece begins; empty: one piece. */
  pieces: Uint32Array;
}

/** The motion of an animated figure, one row a moment; it loops. */
export interface Motion {
  t: Float64Array;
  u_p: Float64Array;
  u_g: Float64Array;
  u: Float64Array;
}

/** Where a motion starts: a state at t = 0, number by number. */
export interface Start {
  u_p0: number;
  u_g0: number;
  u0: number;
  u_p_dot0: number;
  u_g_dot0: number;
  u_dot0: number;
}

/** Orbits on branches, a row each. */
export interface Orbits {
  Omega: Float64Array;
  maxU_p: Float64Array;
  /** In mesh periods; 0 for a torus, which has none. */
  period: Float64Array;
  /** 1 or 0. */
  stable: Float64Array;
  /** Six numbers a row. */
  state: Float64Array;
}

/** A line of a figure that is a table: what is printed beside what is computed. */
export interface TableRow {
  /** Where it is printed, in label markup. */
  where: string;
  /** The quantity, in label markup. */
  what: string;
  /** A number, words, or null where there is nothing. */
  printed: number | string | null;
  /** As corrected here. */
  ours: number | string | null;
  /** As the exact system has it. */
  exact: number | string | null;
  /** Printed less exact, where both are numbers. */
  deviation: number | null;
  /** Corrected less exact. */
  ownDeviation: number | null;
  /** How it is known. */
  remark: string;
}

/** A computed figure: plain data that can be cloned, stored, posted and drawn again. */
/** A formula's number beside the exact one. */
export interface FigureDistance {
  /** What it is, in words. */
  what: string;
  /** Where: the axis by its name, and the place on it; null for a number that has no place. */
  axis: string | null;
  at: number | null;
  theory: number;
  exact: number;
  /** Theory minus exact. */
  difference: number;
}

export interface Figure extends Provenance {
  id: string;
  title: string;
  /** Every parameter, and the start of a figure that shows a motion from one: given back they make the same figure. */
  params: FullParameters & Partial<Start>;
  /** Grid of cells: columns, rows. */
  grid: [number, number];
  axes: FigureFrame[];
  series: FigureSeries[];
  /** One sentence made from the data. */
  summary: string;
  notes: string[];
  /** What the summary is made of, by name: numbers, words, or whether something is so. */
  facts: Record<string, number | string | boolean>;
  /** How far the theory is from the exact answer, place by place; empty where there is only one of them. */
  distances: FigureDistance[];
  /** The lines of a figure that is a table (figure E); null for the others. */
  table: TableRow[] | null;
  /** The state in which what was computed of a motion ends, after whole mesh periods (figure U); else null. */
  end: Float64Array | null;
  /** The orbits behind the branches drawn (figure B); null for the others. */
  orbits: Orbits | null;
  motion: Motion | null;
}

/** What is known of a figure before it is computed. */
export interface FigureInfo {
  id: string;
  title: string;
  caption: string;
  /** What it depends on, in the order of its controls; the defaults are this figure's own. */
  parameters: ParameterInfo[];
  /** It has a view in space that can be turned. */
  turnable: boolean;
  /** It moves. */
  animated: boolean;
  /** Width over height. */
  aspect: number;
  /** It takes long enough to be computed step by step with `progress()`. */
  heavy: boolean;
  /** With some parameters it can be computed in parts, by several workers: see the options of `progress()`. */
  divisible: boolean;
}

/** How everything looks; colours, and how thick and large. */
export type ThemeName = "light" | "dark" | "projector" | "contrast" | "contrast-dark" | "print";

/** A part of the axes of a frame; what is not given is shown whole. */
export interface Window {
  /** Least and greatest value shown, rising, within 1e12, apart by more than a billionth of the greater. */
  x?: [number, number];
  y?: [number, number];
}

/** From where, and when, a figure is seen, and what of it. */
export interface ViewOptions {
  /** Radians, -1000 to 1000. */
  azimuth?: number;
  /** Radians, -pi/2 to pi/2. */
  elevation?: number;
  /** Time of an animated figure's motion, 0 to 1e9. */
  time?: number;
  /** The sign before the decimals of numbers along axes, default a point. */
  decimal?: "." | ",";
  /** Parts of the axes instead of the whole, by the frame's name; ticks, labels and fields are made anew for them. */
  windows?: Record<string, Window>;
  /** Names of series that are not drawn. */
  hidden?: string[];
}

export interface SvgOptions {
  /** CSS pixels, 120 to 8192; or in `unit`: "mm" 31.75 to 2167.47 millimetres. */
  width?: number;
  height?: number;
  /** "mm": the sides in millimetres, letters and lines in points, for paper. Default "px". */
  unit?: "px" | "mm";
  theme?: ThemeName;
  view?: ViewOptions;
  /** Says each title and label in other words, such as those of another language. */
  words?: (text: string) => string;
}

export interface DrawOptions {
  theme?: ThemeName;
  /** Pixels of the backing store a CSS pixel, 0.5 to 8, default 2. */
  density?: number;
  view?: ViewOptions;
  /** Says each title and label in other words, such as those of another language. */
  words?: (text: string) => string;
}

/** The map between pixels and data of one frame as it was drawn. */
export interface FrameMap {
  name: string;
  /** The plot area in CSS pixels of the canvas. */
  plot: { left: number; top: number; right: number; bottom: number };
  /** Data at the left and right edge. */
  x: { low: number; high: number };
  /** Data at the lower and upper edge. */
  y: { low: number; high: number };
  /** For a view in space: two rows of four; pixel = row . (x, y, z, 1). */
  projection: [Float64Array, Float64Array] | null;
}

/** How a series looks in the theme it was drawn in, for a legend. */
export interface SeriesLook {
  name: string;
  /** Colour of lines and marks, `#rrggbb`. */
  stroke: string;
  /** Width of lines, CSS pixels. */
  width: number;
  /** Lengths of dash and gap, CSS pixels; null: solid. */
  dash: [number, number] | null;
  /** Colour of the outline of marks, or null. */
  outline: string | null;
  /** Form of single marks. */
  shape: "dot" | "star" | "diamond" | "triangle" | "cross" | "ring";
}

/** One step of a figure that fills in while it is computed. */
export interface ProgressStep {
  figure: Figure;
  done: boolean;
}

/** One of several parts of a figure that are computed side by side, counted from 0. */
export interface PartOption {
  part?: number;
  parts?: number;
}

/** Steps of a computation; stop it with `return()` (a `for ... of` does so by itself). */
export interface FigureProgress extends IterableIterator<ProgressStep> {
  /** Only the part asked for is computed: every `parts`-th column of the field, from column `part` on. False: all of it. */
  readonly divided: boolean;
  next(): IteratorResult<ProgressStep, undefined>;
  return(): IteratorResult<ProgressStep, undefined>;
  [Symbol.iterator](): FigureProgress;
}

/** The calls; all synchronous, each throws {@link GearError} and nothing else. */
export interface Gear {
  /** The compiled module, to be posted to a worker and given to its `load()`. */
  readonly module: WebAssembly.Module;
  defaults(): ParameterInfo[];
  fromPhysical(si: PhysicalPair): { params: FullParameters; scales: Scales } & Provenance;
  toPhysical(p: Parameters, scales: Scales): PhysicalAnswer;
  modes(p?: Parameters): Modes;
  tongues(p?: Parameters): Tongues;
  multipliers(p?: Parameters, options?: ToleranceOption): Multipliers;
  timeResponse(p?: Parameters, options?: TimeResponseOptions): TimeResponse;
  poincare(p?: Parameters, options?: PoincareOptions): Poincare;
  periodicOrbit(p?: Parameters, options?: PeriodicOrbitOptions): PeriodicOrbit;
  tongueEdges(p: Parameters | undefined, options: TongueEdgesOptions): TongueEdges;
  tongueBoundary(p: Parameters | undefined, options: TongueBoundaryOptions): TongueBoundary;
  stabilityChart(p: Parameters | undefined, options: StabilityChartOptions): StabilityChart;
  branch(p?: Parameters, options?: BranchOptions): Branch;
  diagram(p?: Parameters, options?: DiagramOptions): Diagram;
  torus(p?: Parameters, options?: ToleranceOption): Torus;
  sweep(p: Parameters | undefined, options: SweepOptions): Sweep;
  lyapunov(p?: Parameters, options?: LyapunovOptions): Lyapunov;
  basin(p: Parameters | undefined, options: BasinOptions): Basin;
  contactMargin(p: Parameters, options?: ContactMarginOptions): ContactMargin;
  leastLoad(p: Parameters, options?: ToleranceOption): LeastLoad;
  spectrum(p?: Parameters, options?: SpectrumOptions): AmplitudeSpectrum;
  figures(): FigureInfo[];
  figure(id: string, p?: Parameters): Figure;
  progress(id: string, p?: Parameters, options?: PartOption): FigureProgress;
  svg(idOrFigure: string | Figure, p?: Parameters, options?: SvgOptions): string;
  draw(
    idOrFigure: string | Figure,
    p: Parameters | undefined,
    canvas: HTMLCanvasElement,
    options?: DrawOptions,
  ): { frames: FrameMap[]; looks: SeriesLook[] };
}

/** The dimensionless parameters in the units of a real gear pair, named as in {@link PhysicalPair}. */
export interface PhysicalAnswer {
  M_p: number;
  M_g: number;
  K: number;
  K_amplitude: number;
  K_p: number;
  K_g: number;
  K_p3: number;
  K_g3: number;
  C: number;
  C_p: number;
  C_g: number;
  b: number;
  E: number;
  omega_p: number;
  omega_g: number;
  /** Teeth meeting in a second, Hz. */
  mesh_frequency: number;
  /** Mean force through the teeth and the fluctuations' amplitudes as forces on them, N. */
  F: number;
  F_p: number;
  F_g: number;
  /** From here on only where the scales hold radii, inertias and teeth. */
  I_p?: number;
  I_g?: number;
  r_p?: number;
  r_g?: number;
  teeth_p?: number;
  teeth_g?: number;
  rpm_p?: number;
  rpm_g?: number;
  T_p?: number;
  T_g?: number;
  T_p_amplitude?: number;
  T_g_amplitude?: number;
}

/** What a {@link GearError} is about. */
export type GearErrorCode =
  | "unknown-parameter"
  | "not-a-number"
  | "out-of-range"
  | "not-a-choice"
  | "not-allowed"
  | "not-an-object"
  | "asymmetric"
  | "incommensurate"
  | "missing"
  | "unbalanced-torque"
  | "unknown-figure"
  | "option"
  | "no-convergence"
  | "escaped"
  | "not-found"
  | "numerics"
  | "theory"
  | "drawing"
  | "load"
  | "internal";

/** The one error that every call throws. */
export class GearError extends Error {
  constructor(fields: GearErrorFields);
  readonly name: "GearError";
  readonly code: GearErrorCode;
  /** The parameter or option it is about, or null. */
  readonly parameter: string | null;
  /** What was given, or null. */
  readonly given: number | string | null;
  /** What is allowed: a range, or words, or null. */
  readonly allowed: [number, number] | string | null;
  /** The fields as a plain object, for posting and saving. */
  toJSON(): GearErrorFields;
}

/** The fields of a {@link GearError}. */
export interface GearErrorFields {
  code: GearErrorCode;
  parameter: string | null;
  given: number | string | null;
  allowed: [number, number] | string | null;
  message: string;
}

/**
 * Loads the module. Without a source: a page or worker fetches `gear-bifurcations_bg.wasm` from beside the
 * script, Node reads it from there. Two loads share nothing.
 *
 * @throws {GearError} with code `load` (as a rejection) when there is no such module
 */
export function load(
  source?: LoadSource | PromiseLike<LoadSource>,
): Promise<Gear>;

/** What `load()` takes: the bytes, a response that holds them, or the compiled module. */
export type LoadSource = ArrayBuffer | ArrayBufferView | Response | WebAssembly.Module;
