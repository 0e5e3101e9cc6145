/**
 * The pointer over a canvas: what is read under it, and the handle that it moves.
 *
 * @typedef {import("./services.js").Figure} Figure
 * @typedef {import("./services.js").FrameMap} FrameMap
 */

/**
 * @typedef {object} Hooks
 * @property {() => Figure | null} figure
 * @property {() => readonly FrameMap[]} maps
 * @property {(words: DocumentFragment | null) => void} read
 * @property {(parameter: string) => boolean} hasParameter
 * @property {(parameter: string, value: number) => void} set
 */

import { dataAt, frameAt, frameOf, pixelSize, pixelUnder } from "./frames.js";
import { readout } from "./readout.js";
import { roundTo } from "../controls/scale.js";

/**
 * @param {HTMLCanvasElement} canvas
 * @param {Hooks} hooks
 */
export function watchPointer(canvas, hooks) {
  /** @type {MouseEvent | null} */
  let newest = null;
  let frame = 0;
  /** @type {number | null} */
  let dragging = null;

  const look = () => {
    frame = 0;
    const figure = hooks.figure();
    if (newest === null || figure === null) {
      hooks.read(null);
      return;
    }
    const pixel = pixelUnder(newest, canvas);
    const map = frameAt(hooks.maps(), pixel);
    canvas.classList.toggle("turns", map !== undefined && map.projection !== null);
    canvas.classList.toggle("plane", map !== undefined && map.projection === null);
    const along = map === undefined ? [] : movable(map);
    canvas.classList.toggle("handle", along.length === 1);
    canvas.classList.toggle("handles", along.length === 2);
    hooks.read(readout(figure, hooks.maps(), pixel));
  };
  /** @param {MouseEvent | null} event */
  const note = (event) => {
    newest = event;
    if (frame === 0) frame = requestAnimationFrame(look);
  };

  /**
   * The parameters that the handle of a frame stands for: those along its axes.
   *
   * @param {FrameMap} map
   * @returns {("x" | "y")[]} the axes along which it can be moved
   */
  const movable = (map) => {
    const figure = hooks.figure();
    const frame = figure === null || map.projection !== null ? undefined : frameOf(figure, map);
    if (figure === null || frame === undefined) return [];
    const handled = figure.series.some(({ frame: home, role }) => home === map.name && role === "handle");
    const axes = /** @type {const} */ (["x", "y"]);
    return handled ? axes.filter((axis) => hooks.hasParameter(frame[axis].name)) : [];
  };
  /** @param {MouseEvent} event */
  const move = (event) => {
    const pixel = pixelUnder(event, canvas);
    // A drag may leave the frame; the nearest frame with a handle keeps it.
    const map = frameAt(hooks.maps(), pixel) ?? hooks.maps().find((candidate) => movable(candidate).length > 0);
    const figure = hooks.figure();
    const frame = figure === null || map === undefined ? undefined : frameOf(figure, map);
    if (map === undefined || frame === undefined) return;
    const [place, size] = [dataAt(map, pixel), pixelSize(map)];
    for (const axis of movable(map)) {
      const step = 10 ** Math.floor(Math.log10(size[axis]));
      const value = Math.min(map[axis].high, Math.max(map[axis].low, place[axis]));
      hooks.set(frame[axis].name, roundTo(value, step));
    }
  };

  canvas.addEventListener("pointermove", (event) => {
    note(event);
    if (event.pointerId === dragging) move(event);
  });
  canvas.addEventListener("pointerleave", () => note(null));
  canvas.addEventListener("pointerdown", (event) => {
    note(event);
    const map = frameAt(hooks.maps(), pixelUnder(event, canvas));
    if (event.button !== 0 || map === undefined || movable(map).length === 0) return;
    dragging = event.pointerId;
    canvas.setPointerCapture(event.pointerId);
    move(event);
  });
  for (const end of ["pointerup", "pointercancel"]) {
    canvas.addEventListener(end, () => {
      dragging = null;
    });
  }
}
