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
    canvas.classList.toggle("handle", map !== undefined && parameterOf(map) !== null);
    hooks.read(readout(figure, hooks.maps(), pixel));
  };
  /** @param {MouseEvent | null} event */
  const note = (event) => {
    newest = event;
    if (frame === 0) frame = requestAnimationFrame(look);
  };

  /**
   * The parameter that the handle of a frame stands for: the one along its horizontal axis.
   *
   * @param {FrameMap} map
   */
  const parameterOf = (map) => {
    const figure = hooks.figure();
    if (figure === null || map.projection !== null) return null;
    const name = frameOf(figure, map)?.x.name ?? "";
    const handled = figure.series.some(({ frame: home, role }) => home === map.name && role === "handle");
    return handled && hooks.hasParameter(name) ? name : null;
  };
  /** @param {MouseEvent} event */
  const move = (event) => {
    const pixel = pixelUnder(event, canvas);
    // A drag may leave the frame; the nearest frame with a handle keeps it.
    const map = frameAt(hooks.maps(), pixel) ?? hooks.maps().find((candidate) => parameterOf(candidate) !== null);
    const parameter = map === undefined ? null : parameterOf(map);
    if (map === undefined || parameter === null) return;
    const step = 10 ** Math.floor(Math.log10(pixelSize(map).x));
    const value = Math.min(map.x.high, Math.max(map.x.low, dataAt(map, pixel).x));
    hooks.set(parameter, roundTo(value, step));
  };

  canvas.addEventListener("pointermove", (event) => {
    note(event);
    if (event.pointerId === dragging) move(event);
  });
  canvas.addEventListener("pointerleave", () => note(null));
  canvas.addEventListener("pointerdown", (event) => {
    note(event);
    const map = frameAt(hooks.maps(), pixelUnder(event, canvas));
    if (event.button !== 0 || map === undefined || parameterOf(map) === null) return;
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
