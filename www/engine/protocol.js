/**
 * What page and worker say to each other.
 *
 * The page numbers every computation with a ticket. A worker runs several at once, a step of each at a time, and
 * looks at its messages between two steps; so a computation that is no longer wanted ends within a step.
 *
 * @typedef {import("../../gear-bifurcations.js").Figure} Figure
 * @typedef {import("../../gear-bifurcations.js").GearErrorFields} GearErrorFields
 * @typedef {Record<string, number | string>} Given
 */

/**
 * From the page to a worker.
 *
 * @typedef {{type: "start", module: WebAssembly.Module}} Start
 * @typedef {{type: "run", ticket: number, id: string, given: Given, heavy: boolean, priority: number, part: number, parts: number}} Run
 * @typedef {{type: "cancel", ticket: number}} Cancel
 * @typedef {{type: "ping"}} Ping
 * @typedef {{type: "pace", firstPictures: boolean}} Pace  Whether to stop every computation at its first picture.
 * @typedef {{type: "rest"}} Rest  Give memory back, if there is nothing to compute.
 * @typedef {{type: "fail"}} Fail  Throw an error outside any computation: how tests make a worker die.
 * @typedef {Start | Run | Cancel | Ping | Pace | Rest | Fail} ToWorker
 */

/**
 * From a worker to the page. No answer at all follows a `cancel`.
 *
 * @typedef {{type: "ready"}} Ready
 * @typedef {{type: "partial", ticket: number, figure: Figure}} Partial
 * @typedef {{type: "done", ticket: number, figure: Figure}} Done
 * @typedef {{type: "failed", ticket: number, error: GearErrorFields}} Failed
 * @typedef {{type: "pong"}} Pong
 * @typedef {{type: "step", ticket: number}} Step  It turns to this computation: if it dies now, this one is to blame.
 * @typedef {Ready | Partial | Done | Failed | Pong | Step} FromWorker
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
