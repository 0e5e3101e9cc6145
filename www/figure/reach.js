/**
 * A chart as something one handles: everything that pointer, fingers and keys do over its canvas, put together.
 *
 * Wheel and one finger scroll the page; zooming and panning see zoom.js; keys while the chart has the focus: plus and minus
 * zoom, 0 shows the whole, arrows with Shift pan, plain arrows walk along the curves, Enter picks, Escape leaves.
 *
 * @typedef {import("./services.js").Figure} Figure
 * @typedef {import("./services.js").FrameMap} FrameMap
 * @typedef {import("./services.js").Window} Window
 * @typedef {import("./frames.js").Pixel} Pixel
 * @typedef {import("./readout.js").Reading} Reading
 * @typedef {import("../engine/gear-bifurcations.js").FigureSeries} FigureSeries
 */

/**
 * @typedef {object} ReachHooks
 * @property {() => Figure | null} figure
 * @property {() => readonly FrameMap[]} maps
 * @property {(series: FigureSeries) => boolean} shown
 * @property {() => Readonly<Record<string, Window>>} windows  By the name of the frame.
 * @property {(windows: Record<string, Window>, gesture: string) => void} look  Shows these parts.
 * @property {(words: DocumentFragment | null) => void} read
 * @property {(words: string) => void} speak
 * @property {(parameter: string) => boolean} hasParameter
 * @property {(parameter: string, value: number) => void} set
 * @property {(held: boolean) => void} hold
 * @property {(detail: {frame: string, x: number, y: number, series: string | null, index: number | null}) => void} pick
 * @property {() => boolean} inSight
 */

import { say } from "../words/say.js";
import { Crosshair } from "./crosshair.js";
import { hearCursors, tellCursor } from "./cursor.js";
import { frameAt, frameOf, pixelUnder } from "./frames.js";
import { Handle } from "./handle.js";
import { pointAt, read, readout } from "./readout.js";
import { Walk } from "./walk.js";
import { panned, seen, settledWindow, zoomed } from "./windows.js";
import { watchZooming } from "./zoom.js";

/** How much nearer a key brings. */
const KEY_ZOOM = 1.5;
/** By what part of the plot a key pans. */
const KEY_PAN = 0.1;

/** Which way keys pan, pixels of the content over the plot's sides. @type {Readonly<Record<string, readonly [number, number]>>} */
const PANS = { ArrowLeft: [1, 0], ArrowRight: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
/** @type {Readonly<Record<string, number>>} */
const ZOOMS = { "+": KEY_ZOOM, "=": KEY_ZOOM, "-": 1 / KEY_ZOOM, _: 1 / KEY_ZOOM, "−": 1 / KEY_ZOOM };

export class Reach {
  #canvas;
  #hooks;
  #crosshair;
  #walk;
  #handle;
  /** Where the pointer is, until it has been looked at. @type {Pixel | null} */
  #pointer = null;
  #frame = 0;
  /** The frame that keys act on: the last that was looked at. @type {string | null} */
  #current = null;
  /** What other charts say. @type {import("./cursor.js").Cursor | null} */
  #cursor = null;
  /** The quantity that this chart has told a value of. @type {string | null} */
  #told = null;

  /**
   * @param {HTMLCanvasElement} canvas
   * @param {{layer: HTMLElement, band: HTMLElement}} over  What lies over the picture.
   * @param {ReachHooks} hooks
   */
  constructor(canvas, { layer, band }, hooks) {
    this.#canvas = canvas;
    this.#hooks = hooks;
    this.#crosshair = new Crosshair(layer);
    this.#walk = new Walk(hooks);
    this.#handle = new Handle(canvas, hooks);
    const plane = (/** @type {Pixel} */ pixel) => this.#plane(frameAt(hooks.maps(), pixel));
    watchZooming(canvas, band, {
      plane,
      grabs: (event) => this.#handle.grasps(pixelUnder(event, canvas), event.pointerType === "touch"),
      holds: (pixel) => this.#handle.grasps(pixel, true),
      show: (frame, window, gesture) => this.#show(frame, window, gesture),
      whole: (pixel) => {
        this.#handle.uncall();
        const map = plane(pixel);
        if (map !== undefined) this.#show(map.name, null, "whole");
      },
      click: (pixel) => this.#click(pixel),
    });
    canvas.addEventListener("pointermove", (event) => {
      this.#walk.leave();
      this.#note(pixelUnder(event, canvas));
    });
    canvas.addEventListener("pointerdown", (event) => this.#note(pixelUnder(event, canvas)));
    canvas.addEventListener("pointerleave", (event) => {
      // A finger that is lifted leaves at once: what it tapped on is read until it taps elsewhere.
      if (event.pointerType !== "touch") this.#note(null);
    });
    canvas.addEventListener("pointercancel", () => this.#note(null));
    canvas.addEventListener("keydown", (event) => {
      if (!this.#press(event)) return;
      event.preventDefault();
      event.stopImmediatePropagation();
    });
    canvas.addEventListener("blur", () => this.#leave());
  }

  /**
   * Listens to the cursors of other charts.
   *
   * @param {HTMLElement} home  The chart's element, whose own cursor it does not hear.
   * @returns {() => void} ends it
   */
  link(home) {
    return hearCursors((cursor, from) => {
      if (from === home) return;
      this.#cursor = cursor;
      if (this.#hooks.inSight()) this.#showLinked();
    });
  }

  /** The picture is another, or shows another part: what lies over it is put in its place. */
  painted() {
    this.#showLinked();
    if (this.#walk.walking) this.#showStep();
    else if (this.#pointer !== null) this.#note(this.#pointer);
  }

  /** Whether any part is shown instead of the whole. */
  get zoomed() {
    return Object.keys(this.#hooks.windows()).length > 0;
  }

  /** @param {string} [gesture] */
  showWhole(gesture = "whole") {
    if (this.zoomed) this.#hooks.look({}, gesture);
  }

  /** @param {FrameMap | undefined} map */
  #plane(map) {
    const figure = this.#hooks.figure();
    if (map === undefined || figure === null || map.projection !== null) return undefined;
    return frameOf(figure, map)?.bare === false ? map : undefined;
  }

  /**
   * @param {string} name
   * @param {Window | null} wished  Null for the whole.
   * @param {string} gesture
   */
  #show(name, wished, gesture) {
    const map = this.#hooks.maps().find((one) => one.name === name);
    const figure = this.#hooks.figure();
    const frame = map === undefined || figure === null ? undefined : frameOf(figure, map);
    if (map === undefined || frame === undefined) return;
    const { [name]: before, ...others } = this.#hooks.windows();
    const window = wished === null ? null : settledWindow(wished, frame, map);
    if (window === null && before === undefined) return;
    this.#current = name;
    this.#hooks.look(window === null ? others : { ...others, [name]: window }, `${name} ${gesture}`);
  }

  /** @param {Pixel | null} pixel */
  #note(pixel) {
    this.#pointer = pixel;
    if (this.#frame === 0) this.#frame = requestAnimationFrame(() => this.#look());
  }

  #look() {
    this.#frame = 0;
    const { classList } = this.#canvas;
    const figure = this.#hooks.figure();
    const pixel = this.#pointer;
    if (this.#walk.walking) return;
    const map = pixel === null ? undefined : frameAt(this.#hooks.maps(), pixel);
    classList.toggle("turns", map !== undefined && map.projection !== null);
    classList.toggle("plane", this.#plane(map) !== undefined);
    const along = pixel !== null && this.#handle.grasps(pixel, false) ? this.#handle.axes(map).length : 0;
    classList.toggle("handle", along === 1);
    classList.toggle("handles", along === 2);
    this.#showReading(figure === null || pixel === null ? null : read(figure, this.#hooks.maps(), pixel, this.#hooks.shown));
  }

  /** @param {Reading | null} reading */
  #showReading(reading) {
    const figure = this.#hooks.figure();
    if (reading === null || figure === null) {
      this.#crosshair.hide();
      this.#hooks.read(null);
    } else {
      this.#current = reading.map.name;
      this.#crosshair.show(reading.map, reading.pixel, reading.point !== null);
      this.#hooks.read(readout(figure, reading));
    }
    this.#tell(reading);
  }

  /** @param {Reading | null} reading */
  #tell(reading) {
    const quantity = reading?.frame.x.name ?? null;
    const { host } = /** @type {ShadowRoot} */ (this.#canvas.getRootNode());
    if (this.#told !== null && this.#told !== quantity) tellCursor(host, { quantity: this.#told, value: null });
    this.#told = quantity;
    if (reading === null || quantity === null) {
      this.#cursor = null;
    } else {
      this.#cursor = { quantity, value: reading.x };
      tellCursor(host, { quantity, value: reading.x });
    }
    this.#showLinked(reading?.map.name);
  }

  /** @param {string} [except]  The frame that has the crosshair itself. */
  #showLinked(except) {
    const figure = this.#hooks.figure();
    const others = this.#hooks.maps().filter(({ name }) => name !== except);
    const cursor = this.#cursor ?? { quantity: "", value: null };
    this.#crosshair.link(cursor, others, (map) => (figure === null ? undefined : frameOf(figure, map)));
  }

  /** @param {Pixel} pixel */
  #click(pixel) {
    const figure = this.#hooks.figure();
    const reading = figure === null ? null : read(figure, this.#hooks.maps(), pixel, this.#hooks.shown);
    if (reading === null) return;
    this.#handle.call(pixel);
    this.#pick(reading);
  }

  /** @param {Pick<Reading, "map" | "x" | "y" | "point">} reading */
  #pick({ map, x, y, point }) {
    this.#hooks.pick({ frame: map.name, x, y, series: point?.series.name ?? null, index: point?.index ?? null });
  }

  /**
   * @param {KeyboardEvent} event
   * @returns {boolean} whether the key did anything
   */
  #press({ key, shiftKey, ctrlKey, altKey, metaKey }) {
    if (ctrlKey || altKey || metaKey) return false;
    if (key in ZOOMS) return this.#zoomByKey(ZOOMS[key]);
    if (shiftKey && key in PANS) return this.#panByKey(PANS[key]);
    if (shiftKey) return false;
    if (key === "0") {
      const was = this.zoomed;
      this.showWhole();
      return was;
    }
    if (key === "Escape") return this.#leave();
    if (key === "Enter") return this.#enter();
    // A view in space is turned by these keys, until somebody begins to walk with Enter.
    const turns = this.#hooks.maps().some(({ projection }) => projection !== null);
    if (turns && !this.#walk.walking) return false;
    if (!this.#walk.press(key)) return false;
    this.#showStep(true);
    return true;
  }

  #enter() {
    const step = this.#walk.at;
    if (step === null) {
      if (!this.#walk.press("ArrowRight")) return false;
      this.#showStep(true);
      return true;
    }
    const map = this.#hooks.maps().find(({ name }) => name === step.series.frame);
    if (map !== undefined) this.#pick({ map, ...pointAt(map, step.series, step.index) });
    return true;
  }

  #leave() {
    const was = this.#walk.walking;
    this.#walk.leave();
    if (!was) return false;
    this.#showReading(null);
    this.#hooks.speak("");
    return true;
  }

  /** @param {boolean} [aloud] */
  #showStep(aloud = false) {
    const figure = this.#hooks.figure();
    const step = this.#walk.at;
    const map = this.#hooks.maps().find(({ name }) => name === step?.series.frame);
    const frame = figure === null || map === undefined ? undefined : frameOf(figure, map);
    if (figure === null || step === null || map === undefined || frame === undefined) return;
    const { series, index } = step;
    /** @type {Reading} */
    const reading = { map, frame, ...pointAt(map, series, index), meaning: series.meaning, value: null };
    this.#showReading(reading);
    if (!aloud) return;
    const count = series.columns.x.length;
    this.#hooks.speak(say("figure.step", { what: readout(figure, reading).textContent ?? "", point: index + 1, count }));
  }

  /** The plane that keys act on. */
  #target() {
    const maps = this.#hooks.maps().filter((map) => this.#plane(map) !== undefined);
    return maps.find(({ name }) => name === (this.#walk.at?.series.frame ?? this.#current)) ?? maps[0];
  }

  /** @param {number} times */
  #zoomByKey(times) {
    const map = this.#target();
    if (map === undefined) return false;
    const step = this.#walk.at;
    const window = seen(map);
    const middle = { x: (window.x[0] + window.x[1]) / 2, y: (window.y[0] + window.y[1]) / 2 };
    const about = step === null ? middle : { x: step.series.columns.x[step.index], y: step.series.columns.y[step.index] };
    this.#show(map.name, zoomed(window, about, times), "key");
    return true;
  }

  /** @param {readonly [number, number]} way */
  #panByKey([across, down]) {
    const map = this.#target();
    if (map === undefined) return false;
    const { plot } = map;
    const by = { left: across * KEY_PAN * (plot.right - plot.left), top: down * KEY_PAN * (plot.bottom - plot.top) };
    this.#show(map.name, panned(seen(map), map, by), "key");
    return true;
  }
}
