/**
 * What part of a plane is seen: a window onto its axes, and what zooming and panning make of it. Pure arithmetic.
 *
 * @typedef {import("./services.js").FrameMap} FrameMap
 * @typedef {import("./services.js").Window} Window
 * @typedef {import("../engine/gear-bifurcations.js").FigureFrame} FigureFrame
 * @typedef {import("./frames.js").Pixel} Pixel
 */

import { dataAt } from "./frames.js";

/** Narrowest window over the whole axis: closer by, the curves are seen to be made of straight pieces. */
const CLOSEST = 1e-5;
/** Widest window over the whole axis. */
const WIDEST = 4;
/** How much of the whole axis must stay in sight, over the width of the window. */
const IN_SIGHT = 0.1;
/** A window is kept to this part of itself: finer than a pixel of any screen, and short in an address. */
const FINENESS = 1e-4;

/**
 * The whole of a frame.
 *
 * @param {FigureFrame} frame
 * @returns {Window}
 */
export function whole({ x, y }) {
  return { x: [x.low, x.high], y: [y.low, y.high] };
}

/**
 * What a frame shows as it is drawn.
 *
 * @param {FrameMap} map
 * @returns {Window}
 */
export function seen({ x, y }) {
  return { x: [x.low, x.high], y: [y.low, y.high] };
}

/**
 * A window nearer by or farther off, a place of it kept where it is.
 *
 * @param {Window} window
 * @param {{x: number, y: number}} about
 * @param {number} times  More than 1: nearer.
 * @returns {Window}
 */
export function zoomed({ x, y }, about, times) {
  const part = (/** @type {readonly [number, number]} */ [low, high], /** @type {number} */ at) =>
    /** @type {[number, number]} */ ([at - (at - low) / times, at + (high - at) / times]);
  return { x: part(x, about.x), y: part(y, about.y) };
}

/**
 * A window moved so that its content goes by so many pixels to the right and down.
 *
 * @param {Window} window
 * @param {FrameMap} map
 * @param {Pixel} by
 * @returns {Window}
 */
export function panned({ x, y }, { plot }, { left, top }) {
  const across = (left / (plot.right - plot.left)) * (x[1] - x[0]);
  const up = (top / (plot.bottom - plot.top)) * (y[1] - y[0]);
  return { x: [x[0] - across, x[1] - across], y: [y[0] + up, y[1] + up] };
}

/**
 * The window between two corners. A rectangle that is hardly high takes the whole height, one that is hardly wide the
 * whole width; null for one that is nothing at all.
 *
 * @param {FrameMap} map
 * @param {Pixel} from
 * @param {Pixel} to
 * @param {number} least  Sides below this are none, CSS pixels.
 * @returns {Window | null}
 */
export function between(map, from, to, least) {
  const wide = Math.abs(to.left - from.left) >= least;
  const high = Math.abs(to.top - from.top) >= least;
  if (!wide && !high) return null;
  const [one, other] = [dataAt(map, within(map, from)), dataAt(map, within(map, to))];
  const rising = (/** @type {number} */ a, /** @type {number} */ b) => /** @type {[number, number]} */ (a < b ? [a, b] : [b, a]);
  const now = seen(map);
  return { x: wide ? rising(one.x, other.x) : now.x, y: high ? rising(one.y, other.y) : now.y };
}

/**
 * A pixel, held within the plot.
 *
 * @param {FrameMap} map
 * @param {Pixel} pixel
 * @returns {Pixel}
 */
export function within({ plot }, { left, top }) {
  return {
    left: Math.min(plot.right, Math.max(plot.left, left)),
    top: Math.min(plot.bottom, Math.max(plot.top, top)),
  };
}

/**
 * What becomes of a wish: held within the limits, with no more digits than are seen, a unit as long in x as in y where the
 * frame wants it; null where the whole is wished for.
 *
 * @param {Window} wished
 * @param {FigureFrame} frame
 * @param {FrameMap} map
 * @returns {Window | null}
 */
export function settledWindow(wished, frame, map) {
  const all = whole(frame);
  const even = frame.equalAspect ? evened(wished, all, map) : wished;
  const window = { x: held(even.x, all.x), y: held(even.y, all.y) };
  return same(window.x, all.x) && same(window.y, all.y) ? null : window;
}

/**
 * The least window around one in which the units are as long as in the whole.
 *
 * @param {Window} window
 * @param {Window} all
 * @param {FrameMap} map
 * @returns {Window}
 */
function evened(window, all, { plot }) {
  const [wide, high] = [plot.right - plot.left, plot.bottom - plot.top];
  const unit = Math.max((window.x[1] - window.x[0]) / wide, (window.y[1] - window.y[0]) / high);
  if (!(unit > 0)) return all;
  const around = (/** @type {readonly [number, number]} */ [low, high_], /** @type {number} */ length) => {
    const middle = (low + high_) / 2;
    return /** @type {[number, number]} */ ([middle - (unit * length) / 2, middle + (unit * length) / 2]);
  };
  return { x: around(window.x, wide), y: around(window.y, high) };
}

/**
 * @param {readonly [number, number]} ends
 * @param {readonly [number, number]} all
 * @returns {[number, number]}
 */
function held([low, high], all) {
  const length = all[1] - all[0];
  const span = Math.min(WIDEST * length, Math.max(CLOSEST * length, high - low));
  const middle = (low + high) / 2;
  const reach = span / 2 - IN_SIGHT * Math.min(span, length);
  const kept = Math.min(all[1] + reach, Math.max(all[0] - reach, middle));
  const step = 10 ** Math.floor(Math.log10(span * FINENESS));
  return [rounded(kept - span / 2, step), rounded(kept + span / 2, step)];
}

/**
 * @param {number} value
 * @param {number} step  A power of ten.
 */
function rounded(value, step) {
  const decimals = Math.round(-Math.log10(step));
  return decimals >= 0 ? Number(value.toFixed(Math.min(100, decimals))) : Math.round(value / step) * step;
}

/**
 * @param {readonly [number, number]} one
 * @param {readonly [number, number]} other
 */
function same(one, other) {
  const fine = 2 * FINENESS * (other[1] - other[0]);
  return Math.abs(one[0] - other[0]) < fine && Math.abs(one[1] - other[1]) < fine;
}

/**
 * Those windows of a figure's state that its frames can show: what a link says may be of another figure.
 *
 * @param {Readonly<Record<string, Window>>} windows
 * @param {readonly FigureFrame[]} frames
 * @returns {Record<string, {x: [number, number], y: [number, number]}>}
 */
export function sound(windows, frames) {
  /** @type {Record<string, {x: [number, number], y: [number, number]}>} */
  const kept = {};
  for (const frame of frames) {
    const window = Object.hasOwn(windows, frame.frame) ? windows[frame.frame] : undefined;
    if (window === undefined || frame.bare || frame.z !== null) continue;
    const all = whole(frame);
    const fits = /** @type {const} */ (["x", "y"]).every((axis) => {
      const [low, high] = window[axis];
      const length = all[axis][1] - all[axis][0];
      return high - low >= (CLOSEST / 2) * length && high - low <= 2 * WIDEST * length && high > all[axis][0] - length * WIDEST && low < all[axis][1] + length * WIDEST;
    });
    if (fits) kept[frame.frame] = { x: [...window.x], y: [...window.y] };
  }
  return kept;
}
