/**
 * Zooming and panning by hand. The plain wheel and one finger belong to the page and scroll it; with Ctrl the wheel zooms
 * about the pointer, as a pinch does; two fingers, or a drag with Shift, pan; a rectangle drawn with the mouse zooms onto
 * it; a double click shows the whole again.
 *
 * @typedef {import("./services.js").FrameMap} FrameMap
 * @typedef {import("./services.js").Window} Window
 * @typedef {import("./frames.js").Pixel} Pixel
 */

/**
 * @typedef {object} ZoomHooks
 * @property {(pixel: Pixel) => FrameMap | undefined} plane  The plane with axes under a pixel.
 * @property {(event: PointerEvent) => boolean} grabs  Whether something else takes what a pointer does here.
 * @property {(touch: Pixel) => boolean} holds  Whether one finger here moves something and does not scroll.
 * @property {(frame: string, window: Window, gesture: string) => void} show
 * @property {(pixel: Pixel) => void} whole  Shows all of the frame under a pixel.
 * @property {(pixel: Pixel) => void} click
 */

import { dataAt, pixelUnder } from "./frames.js";
import { between, panned, seen, within, zoomed } from "./windows.js";

/** How much nearer a notch of the wheel (120 units) brings. */
const NOTCH = 1.25;
/** Units of the wheel in a line and in a page. */
const UNITS = [1, 40, 800];
/** What stays within this is a click and no drag, CSS pixels. */
const STILL = 5;
/** Sides of a rectangle below this are none, CSS pixels. */
const FLAT = 9;

let gestures = 0;

/**
 * @param {HTMLCanvasElement} canvas
 * @param {HTMLElement} band  Shows the rectangle while it is drawn.
 * @param {ZoomHooks} hooks
 */
export function watchZooming(canvas, band, hooks) {
  canvas.addEventListener("wheel", (event) => turnWheel(canvas, hooks, event), { passive: false });
  canvas.addEventListener("dblclick", (event) => hooks.whole(pixelUnder(event, canvas)));
  watchMouse(canvas, band, hooks);
  watchFingers(canvas, hooks);
}

/**
 * @param {HTMLCanvasElement} canvas
 * @param {ZoomHooks} hooks
 * @param {WheelEvent} event
 */
function turnWheel(canvas, hooks, event) {
  // A trackpad's pinch comes as a wheel with Ctrl as well.
  if (!event.ctrlKey && !event.metaKey) return;
  const pixel = pixelUnder(event, canvas);
  const map = hooks.plane(pixel);
  if (map === undefined) return;
  event.preventDefault();
  const units = event.deltaY * (UNITS[event.deltaMode] ?? 1);
  hooks.show(map.name, zoomed(seen(map), dataAt(map, pixel), NOTCH ** (-units / 120)), "wheel");
}

/**
 * @param {HTMLCanvasElement} canvas
 * @param {HTMLElement} band
 * @param {ZoomHooks} hooks
 */
function watchMouse(canvas, band, hooks) {
  canvas.addEventListener("pointerdown", (down) => {
    if (down.button !== 0 || hooks.grabs(down)) return;
    const from = pixelUnder(down, canvas);
    const map = hooks.plane(from);
    if (map === undefined) return;
    const gesture = `drag ${(gestures += 1)}`;
    const window = seen(map);
    const end = new AbortController();
    const { signal } = end;
    let moved = false;
    const byFinger = down.pointerType === "touch";
    if (!byFinger) canvas.setPointerCapture(down.pointerId);
    const stop = () => {
      end.abort();
      band.hidden = true;
    };
    /** @param {PointerEvent} event */
    const follow = (event) => {
      if (event.pointerId !== down.pointerId) return;
      const to = pixelUnder(event, canvas);
      const by = { left: to.left - from.left, top: to.top - from.top };
      moved ||= Math.hypot(by.left, by.top) > STILL;
      if (!moved || byFinger) return;
      if (down.shiftKey) hooks.show(map.name, panned(window, map, by), gesture);
      else outline(band, map, from, to);
    };
    canvas.addEventListener("pointermove", follow, { signal });
    canvas.addEventListener(
      "pointerup",
      (event) => {
        if (event.pointerId !== down.pointerId) return;
        follow(event);
        stop();
        const to = pixelUnder(event, canvas);
        if (!moved) {
          if (!down.shiftKey) hooks.click(to);
          return;
        }
        const wished = down.shiftKey || byFinger ? null : between(map, from, to, FLAT);
        if (wished !== null) hooks.show(map.name, wished, gesture);
      },
      { signal },
    );
    canvas.addEventListener("pointercancel", stop, { signal });
    addEventListener(
      "keydown",
      (event) => {
        if (event.key !== "Escape") return;
        if (moved && down.shiftKey) hooks.show(map.name, window, gesture);
        stop();
      },
      { signal },
    );
  });
}

/**
 * @param {HTMLElement} band
 * @param {FrameMap} map
 * @param {Pixel} one
 * @param {Pixel} other
 */
function outline(band, map, one, other) {
  const { plot } = map;
  const [from, to] = [within(map, one), within(map, other)];
  const wide = Math.abs(other.left - one.left) >= FLAT;
  const high = Math.abs(other.top - one.top) >= FLAT;
  const [left, right] = wide ? [Math.min(from.left, to.left), Math.max(from.left, to.left)] : [plot.left, plot.right];
  const [top, bottom] = high ? [Math.min(from.top, to.top), Math.max(from.top, to.top)] : [plot.top, plot.bottom];
  Object.assign(band.style, { left: `${left}px`, top: `${top}px`, width: `${right - left}px`, height: `${bottom - top}px` });
  band.hidden = !wide && !high;
}

/**
 * @param {HTMLCanvasElement} canvas
 * @param {ZoomHooks} hooks
 */
function watchFingers(canvas, hooks) {
  /** @type {{map: FrameMap, window: Window, at: {x: number, y: number}, apart: number, gesture: string} | null} */
  let pinch = null;
  const place = (/** @type {TouchEvent} */ event) => {
    const box = canvas.getBoundingClientRect();
    const [one, other] = event.touches;
    return {
      left: (one.clientX + other.clientX) / 2 - box.left,
      top: (one.clientY + other.clientY) / 2 - box.top,
      apart: Math.max(20, Math.hypot(one.clientX - other.clientX, one.clientY - other.clientY)),
    };
  };
  /** @param {TouchEvent} event */
  const begin = (event) => {
    pinch = null;
    if (event.touches.length === 1) {
      // The finger on a handle moves it; anywhere else it scrolls the page.
      const [{ clientX, clientY }] = event.touches;
      const box = canvas.getBoundingClientRect();
      if (event.cancelable && hooks.holds({ left: clientX - box.left, top: clientY - box.top })) event.preventDefault();
      return;
    }
    if (event.touches.length !== 2) return;
    const { apart, ...middle } = place(event);
    const map = hooks.plane(middle);
    if (map === undefined || !event.cancelable) return;
    event.preventDefault();
    pinch = { map, window: seen(map), at: dataAt(map, middle), apart, gesture: `pinch ${(gestures += 1)}` };
    canvas.classList.add("pinched");
  };
  canvas.addEventListener("touchstart", begin, { passive: false });
  canvas.addEventListener(
    "touchmove",
    (event) => {
      if (pinch === null || event.touches.length !== 2) return;
      if (event.cancelable) event.preventDefault();
      const { map, window, at, gesture } = pinch;
      const { apart, left, top } = place(event);
      const nearer = zoomed(window, at, apart / pinch.apart);
      // What was between the fingers stays between them.
      const { left: wasLeft, top: wasTop } = pixelIn(map, window, at);
      hooks.show(map.name, panned(nearer, map, { left: left - wasLeft, top: top - wasTop }), gesture);
    },
    { passive: false },
  );
  for (const name of /** @type {const} */ (["touchend", "touchcancel"])) {
    canvas.addEventListener(name, (event) => {
      if (event.touches.length < 2) pinch = null;
      if (event.touches.length === 0) canvas.classList.remove("pinched");
    });
  }
}

/**
 * @param {FrameMap} map
 * @param {Window} window
 * @param {{x: number, y: number}} place
 * @returns {Pixel}
 */
function pixelIn({ plot }, { x, y }, place) {
  return {
    left: plot.left + ((place.x - x[0]) / (x[1] - x[0])) * (plot.right - plot.left),
    top: plot.bottom - ((place.y - y[0]) / (y[1] - y[0])) * (plot.bottom - plot.top),
  };
}
