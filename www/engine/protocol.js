/**
 * What page and worker say to each other.
 *
 * The page numbers every computation with a ticket. A worker runs several at once, a step of each at a time, and
 * looks at its messages between two steps; so a computation that is no longer wanted ends within a step.
 *
 * @typedef {import("../../gear-bifurcations.js").Figure} Figure
 * @typedef {import("../../gear-bifurcations.js").GearErrorFields} GearErrorFields
 * @typedef {Record<string, number | string>} Given
 * @typedef {{family: string, source: string, style?: string, weight?: string, unicodeRange?: string}} Face  The source is an absolute address.
 * @typedef {Pick<Required<import("../../gear-bifurcations.js").DrawOptions>, "theme" | "density" | "view"> & {width: number, height: number}} Wanted
 *   How a picture is to be drawn, on a backing store of so many pixels.
 * @typedef {{module: WebAssembly.Module, figures: import("../../gear-bifurcations.js").FigureInfo[], defaults: import("../../gear-bifurcations.js").ParameterInfo[]}} Fetched
 *   The compiled module, and what it says of itself: whoever only wants to know that need not start it.
 * @typedef {{bitmap: ImageBitmap, frames: import("../../gear-bifurcations.js").FrameMap[], looks: import("../../gear-bifurcations.js").SeriesLook[]}} Drawn
 */

/**
 * From the page to a worker.
 *
 * @typedef {{type: "start", module: WebAssembly.Module}} Start
 * @typedef {{type: "fetch"}} Fetch  Fetch the module and start it: see `fetching.js`.
 * @typedef {{type: "faces", faces: readonly Face[]}} Faces  Of the drawings' typeface.
 * @typedef {{type: "run", ticket: number, id: string, given: Given, priority: number, part: number, parts: number, picture: Wanted | null, held: boolean}} Run
 *   With a picture, its first part and its end come drawn. Held, it stops at its first picture until `go-on`.
 * @typedef {{type: "go-on", ticket: number}} GoOn
 * @typedef {{type: "cancel", ticket: number}} Cancel
 * @typedef {{type: "ping"}} Ping
 * @typedef {{type: "pace", firstPictures: boolean}} Pace  Whether to stop every computation at its first picture.
 * @typedef {{type: "rest"}} Rest  Give memory back, once there is nothing to compute.
 * @typedef {{type: "fail"}} Fail  Throw an error outside any computation: how tests make a worker die.
 * @typedef {Start | Fetch | Faces | Run | GoOn | Cancel | Ping | Pace | Rest | Fail} ToWorker
 */

/**
 * From a worker to the page. No answer at all follows a `cancel`.
 *
 * @typedef {{type: "ready"}} Ready
 * @typedef {{type: "fetched", fetched: Fetched | null}} Answer  Null where it does not come.
 * @typedef {{type: "partial", ticket: number, figure: Figure, drawn: Drawn | null}} Partial
 * @typedef {{type: "done", ticket: number, figure: Figure, drawn: Drawn | null}} Done
 * @typedef {{type: "failed", ticket: number, error: GearErrorFields}} Failed
 * @typedef {{type: "pong"}} Pong
 * @typedef {{type: "step", ticket: number}} Step  It turns to this computation: if it dies now, this one is to blame.
 * @typedef {Ready | Answer | Partial | Done | Failed | Pong | Step} FromWorker
 */

/** What a reader is waiting for comes before what is out of sight. */
export const PRIORITY = Object.freeze({ shown: 0, hidden: 1 });

/**
 * The buffers of a figure's columns, so that posting it moves them instead of copying.
 *
 * @param {Figure} figure
 * @returns {ArrayBuffer[]}
 */
export function buffersOf(figure) {
  /** @type {Set<ArrayBuffer>} */
  const buffers = new Set();
  /** @param {ArrayBufferView | undefined} column */
  const add = (column) => {
    // A view of a part, or of the module's own memory, must be copied.
    if (column?.buffer instanceof ArrayBuffer && column.byteLength === column.buffer.byteLength) {
      buffers.add(column.buffer);
    }
  };
  for (const { columns, pieces } of figure.series) {
    add(columns.x);
    add(columns.y);
    add(columns.z);
    add(pieces);
  }
  for (const column of Object.values(figure.motion ?? {})) add(column);
  return [...buffers];
}

/**
 * Has a module give its memory back, which only grows.
 *
 * @param {import("../../gear-bifurcations.js").Gear} gear
 * @returns {number} the bytes
 */
export function giveBack(gear) {
  return /** @type {{rest: () => number}} */ (/** @type {unknown} */ (gear)).rest();
}
