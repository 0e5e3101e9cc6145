// What tests of charts as things one handles share: where things are, and what the state says.

import { data, expect, figure, map, settled } from "./page.js";

/**
 * @typedef {import("@playwright/test").Page} Page
 * @typedef {import("../../www/engine/gear-bifurcations.js").FrameMap} FrameMap
 * @typedef {import("../../www/state.js").FigureState} FigureState
 */

/**
 * Brings a frame of a figure into the middle of the window; where its plot is in it, and how to get from its data there.
 *
 * @param {Page} page
 * @param {string} id
 * @param {number} [index]  Of the frame.
 */
export async function stand(page, id, index = 0) {
  await settled(page, id);
  const own = (await map(page, id))[index];
  await figure(page, id).evaluate((element, { top, bottom }) => {
    const canvas = element.shadowRoot?.querySelector("canvas");
    const at = canvas?.getBoundingClientRect().top ?? 0;
    scrollBy({ top: at + (top + bottom) / 2 - innerHeight / 2, behavior: "instant" });
  }, own.plot);
  const box = await still(page, id);
  const { plot } = own;
  /** A place in the window from fractions of the plot, from its lower left corner. @param {number} across @param {number} up */
  const at = (across, up) => ({
    x: box.x + plot.left + across * (plot.right - plot.left),
    y: box.y + plot.bottom - up * (plot.bottom - plot.top),
  });
  /** A place in the window from data. @param {number} x @param {number} y */
  const of = (x, y) => at((x - own.x.low) / (own.x.high - own.x.low), (y - own.y.low) / (own.y.high - own.y.low));
  return { own, at, of };
}

/**
 * Where a figure's canvas is in the window, once it and the page have kept their places for some frames: figures that the reader has
 * come near are completed, and bring their words.
 *
 * @param {Page} page
 * @param {string} id
 * @returns {Promise<{x: number, y: number}>}
 */
function still(page, id) {
  return figure(page, id).evaluate(async (element) => {
    const canvas = element.shadowRoot?.querySelector("canvas");
    if (!canvas) throw new Error("no canvas");
    // Longer than the page takes to see that nothing is scrolled any more.
    const FRAMES = 15;
    const { pool } = /** @type {any} */ (window).__gear.engine;
    let last = { x: NaN, y: NaN, scrolled: NaN };
    for (let same = 0; same < FRAMES; ) {
      await new Promise((resolve) => requestAnimationFrame(resolve));
      const { x, y } = canvas.getBoundingClientRect();
      const scrolled = scrollY;
      same = x === last.x && y === last.y && scrolled === last.scrolled && !pool.busy ? same + 1 : 0;
      last = { x, y, scrolled };
    }
    return last;
  });
}

/**
 * A computed point of a figure's first frame, somewhere in the middle of what is drawn of a curve.
 *
 * @param {Page} page
 * @param {string} id
 */
export async function point(page, id) {
  const { series } = await data(page, id);
  const { name, x, y } = await frame(page, id);
  for (const curve of series) {
    if (curve.mark !== "curve" || curve.role === "reference" || curve.frame !== name) continue;
    const inside = [...curve.columns.x.keys()].filter((at) => {
      const [left, up] = [curve.columns.x[at], curve.columns.y[at]];
      return left > x.low && left < x.high && up > y.low && up < y.high;
    });
    const at = inside[Math.floor(inside.length / 3)];
    if (at !== undefined) return { curve, x: curve.columns.x[at], y: curve.columns.y[at] };
  }
  throw new Error(`figure ${id} draws no curve in its first frame`);
}

/**
 * What the page's state says about a figure.
 *
 * @param {Page} page
 * @param {string} id
 * @returns {Promise<FigureState>}
 */
export function state(page, id) {
  return page.evaluate((key) => /** @type {any} */ (window).__gear.store.shown(key), `fig-${id}`);
}

/**
 * The frame as it is drawn now.
 *
 * @param {Page} page
 * @param {string} id
 * @param {number} [index]
 */
export async function frame(page, id, index = 0) {
  await settled(page, id);
  return (await map(page, id))[index];
}

/**
 * Puts the focus on a figure's chart, as the Tab key would.
 *
 * @param {Page} page
 * @param {string} id
 */
export async function focus(page, id) {
  await settled(page, id);
  const chart = figure(page, id).getByRole("application");
  await chart.focus();
  await expect(chart).toBeFocused();
}
