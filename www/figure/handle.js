/**
 * The handle of a chart, which stands for parameters along its axes: grasped and dragged, or called by a click. A finger
 * on it moves it; anywhere else it scrolls the page.
 *
 * @typedef {import("./services.js").Figure} Figure
 * @typedef {import("./services.js").FrameMap} FrameMap
 * @typedef {import("./frames.js").Pixel} Pixel
 */

/**
 * @typedef {object} HandleHooks
 * @property {() => Figure | null} figure
 * @property {() => readonly FrameMap[]} maps
 * @property {(parameter: string) => boolean} hasParameter
 * @property {(parameter: string, value: number) => void} set
 * @property {(held: boolean) => void} hold  What is done while it is held is one action.
 */

import { roundTo } from "../controls/scale.js";
import { dataAt, frameAt, frameOf, pixelOf, pixelSize, pixelUnder } from "./frames.js";

/** As near as this the handle is grasped, CSS pixels: with a mouse, and with a finger. */
const NEAR = 12;
const NEAR_BY_TOUCH = 22;
/** Two clicks within this time are one double click, ms. */
const DOUBLE = 500;

export class Handle {
  #hooks;
  /** What the parameters were before the last click called the handle. @type {{time: number, values: Map<string, number>} | null} */
  #before = null;

  /**
   * @param {HTMLCanvasElement} canvas
   * @param {HandleHooks} hooks
   */
  constructor(canvas, hooks) {
    this.#hooks = hooks;
    /** @type {{pointer: number, map: string} | null} */
    let dragged = null;
    canvas.addEventListener("pointerdown", (event) => {
      const pixel = pixelUnder(event, canvas);
      if (event.button !== 0 || !this.grasps(pixel, event.pointerType === "touch")) return;
      const map = frameAt(hooks.maps(), pixel);
      if (map === undefined) return;
      dragged = { pointer: event.pointerId, map: map.name };
      canvas.setPointerCapture(event.pointerId);
      hooks.hold(true);
      if (this.isScale(map)) this.#move(map, pixel);
    });
    canvas.addEventListener("pointermove", (event) => {
      if (dragged === null || event.pointerId !== dragged.pointer) return;
      const map = hooks.maps().find(({ name }) => name === dragged?.map);
      // Moves come together, some in a frame: the last is where the pointer is.
      if (map !== undefined) this.#move(map, pixelUnder(event, canvas));
    });
    for (const end of /** @type {const} */ (["pointerup", "pointercancel"])) {
      canvas.addEventListener(end, (event) => {
        if (dragged === null || event.pointerId !== dragged.pointer) return;
        dragged = null;
        hooks.hold(false);
      });
    }
  }

  /**
   * The axes of a frame along which its handle can be moved.
   *
   * @param {FrameMap | undefined} map
   * @returns {("x" | "y")[]}
   */
  axes(map) {
    const figure = this.#hooks.figure();
    const frame = figure === null || map === undefined || map.projection !== null ? undefined : frameOf(figure, map);
    if (figure === null || map === undefined || frame === undefined) return [];
    const handled = figure.series.some(({ frame: home, role }) => home === map.name && role === "handle");
    const axes = /** @type {const} */ (["x", "y"]);
    return handled ? axes.filter((axis) => this.#hooks.hasParameter(frame[axis].name)) : [];
  }

  /**
   * Whether a frame is a mere scale along one line: all of it is the handle's.
   *
   * @param {FrameMap} map
   */
  isScale(map) {
    const figure = this.#hooks.figure();
    return figure !== null && frameOf(figure, map)?.y.label === "" && this.axes(map).length > 0;
  }

  /**
   * Whether what begins here moves the handle.
   *
   * @param {Pixel} pixel
   * @param {boolean} byTouch
   */
  grasps(pixel, byTouch) {
    const map = frameAt(this.#hooks.maps(), pixel);
    const axes = this.axes(map);
    if (map === undefined || axes.length === 0) return false;
    if (this.isScale(map)) return true;
    const near = byTouch ? NEAR_BY_TOUCH : NEAR;
    const handles = this.#hooks.figure()?.series.filter(({ frame, role }) => frame === map.name && role === "handle") ?? [];
    return handles.some(({ columns }) =>
      [...columns.x].some((x, index) => {
        const at = pixelOf(map, x, columns.y[index]);
        const [across, down] = [Math.abs(at.left - pixel.left), Math.abs(at.top - pixel.top)];
        return axes.length === 2 ? Math.hypot(across, down) <= near : (axes[0] === "x" ? across : down) <= near;
      }),
    );
  }

  /**
   * Calls the handle to a place. The second click of a double click calls nothing.
   *
   * @param {Pixel} pixel
   */
  call(pixel) {
    const map = frameAt(this.#hooks.maps(), pixel);
    const figure = this.#hooks.figure();
    const time = performance.now();
    if (map === undefined || figure === null || (this.#before !== null && time - this.#before.time < DOUBLE)) return;
    const names = this.axes(map).map((axis) => frameOf(figure, map)?.[axis].name ?? "");
    const values = names.map((name) => /** @type {const} */ ([name, Number(new Map(Object.entries(figure.params)).get(name))]));
    this.#before = { time, values: new Map(values) };
    this.#move(map, pixel);
  }

  /** Takes back what the first click of a double click has called. */
  uncall() {
    if (this.#before === null || performance.now() - this.#before.time > 2 * DOUBLE) return;
    for (const [name, value] of this.#before.values) if (Number.isFinite(value)) this.#hooks.set(name, value);
    this.#before = null;
  }

  /**
   * @param {FrameMap} map
   * @param {Pixel} pixel
   */
  #move(map, pixel) {
    const figure = this.#hooks.figure();
    const frame = figure === null ? undefined : frameOf(figure, map);
    if (frame === undefined) return;
    const [place, size] = [dataAt(map, pixel), pixelSize(map)];
    for (const axis of this.axes(map)) {
      const step = 10 ** Math.floor(Math.log10(size[axis]));
      const value = Math.min(map[axis].high, Math.max(map[axis].low, place[axis]));
      this.#hooks.set(frame[axis].name, roundTo(value, step));
    }
  }
}
