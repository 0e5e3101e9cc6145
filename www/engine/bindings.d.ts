/**
 * What the build puts in the place of `./bindings.js`: a factory over the binding generator's output, so that
 * each instance of the WebAssembly module has glue of its own and nothing is shared between two of them.
 * `src/web/` holds the other side of each of these calls.
 */

/** A figure that is computed in pieces; lives in one instance's memory until `free()`. */
export interface RawProgress {
  /** Whether only a part of the figure is computed. */
  divided(): boolean;
  /** Works for about 15 ms; true when done. */
  advance(): boolean;
  /** What there is so far. */
  figure(): unknown;
  free(): void;
}

/** The raw calls: anything in, plain data out, a plain object with the fields of a GearError thrown. */
export interface Bindings {
  initSync(source: { module: WebAssembly.Module }): { memory: WebAssembly.Memory };
  defaults(): unknown;
  fromPhysical(si: unknown): unknown;
  toPhysical(params: unknown, scales: unknown): unknown;
  modes(params: unknown, options: unknown): unknown;
  tongues(params: unknown, options: unknown): unknown;
  multipliers(params: unknown, options: unknown): unknown;
  timeResponse(params: unknown, options: unknown): unknown;
  poincare(params: unknown, options: unknown): unknown;
  periodicOrbit(params: unknown, options: unknown): unknown;
  tongueEdges(params: unknown, options: unknown): unknown;
  tongueBoundary(params: unknown, options: unknown): unknown;
  stabilityChart(params: unknown, options: unknown): unknown;
  branch(params: unknown, options: unknown): unknown;
  diagram(params: unknown, options: unknown): unknown;
  torus(params: unknown, options: unknown): unknown;
  sweep(params: unknown, options: unknown): unknown;
  lyapunov(params: unknown, options: unknown): unknown;
  basin(params: unknown, options: unknown): unknown;
  contactMargin(params: unknown, options: unknown): unknown;
  leastLoad(params: unknown, options: unknown): unknown;
  spectrum(params: unknown, options: unknown): unknown;
  figures(): unknown;
  figure(id: unknown, params: unknown): unknown;
  progress(id: unknown, params: unknown, options: unknown): RawProgress;
  svg(idOrFigure: unknown, params: unknown, options: unknown): unknown;
  draw(idOrFigure: unknown, params: unknown, canvas: unknown, options: unknown): unknown;
  bench(job: unknown, repetitions: unknown): unknown;
}

/** Fresh glue, not yet joined to an instance. */
export function createBindings(): Bindings;
