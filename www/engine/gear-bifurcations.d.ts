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
  stable: boolean;
  /** Least and greatest value of each coordinate over the orbit. */
  min: Float64Array;
  max: Float64Array;
  /** True period over T. */
  period: number;
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
  /** First cell in the grid: column, row. */
  cell: [number, number];
  /** Cells it spans: columns, rows. */
  span: [number, number];
  equalAspect: boolean;
  bare: boolean;
}

export type Mark = "curve" | "filled" | "cloud" | "marks" | "band" | "text";

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
  | "interval-spiral";

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

/** A computed figure: plain data that can be cloned, stored, posted and drawn again. */
export interface Figure extends Provenance {
  id: string;
  title: string;
  params: FullParameters;
  /** Grid of cells: columns, rows. */
  grid: [number, number];
  axes: FigureFrame[];
  series: FigureSeries[];
  /** One sentence made from the data. */
  summary: string;
  notes: string[];
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
}

/** From where, and when, a figure is seen. */
export interface ViewOptions {
  /** Radians, -1000 to 1000. */
  azimuth?: number;
  /** Radians, -pi/2 to pi/2. */
  elevation?: number;
  /** Time of an animated figure's motion, 0 to 1e9. */
  time?: number;
}

export interface SvgOptions {
  /** CSS pixels, 120 to 8192. */
  width?: number;
  height?: number;
  theme?: "light" | "dark";
  view?: ViewOptions;
}

export interface DrawOptions {
  theme?: "light" | "dark";
  /** Pixels of the backing store a CSS pixel, 0.5 to 8, default 2. */
  density?: number;
  view?: ViewOptions;
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

/** One step of a figure that fills in while it is computed. */
export interface ProgressStep {
  figure: Figure;
  done: boolean;
}

/** Steps of a computation; stop it with `return()` (a `for ... of` does so by itself). */
export interface FigureProgress extends IterableIterator<ProgressStep> {
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
  figures(): FigureInfo[];
  figure(id: string, p?: Parameters): Figure;
  progress(id: string, p?: Parameters): FigureProgress;
  svg(idOrFigure: string | Figure, p?: Parameters, options?: SvgOptions): string;
  draw(
    idOrFigure: string | Figure,
    p: Parameters | undefined,
    canvas: HTMLCanvasElement,
    options?: DrawOptions,
  ): { frames: FrameMap[] };
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
