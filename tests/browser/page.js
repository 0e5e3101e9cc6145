// What every browser test begins with: a page that must stay silent and at home, and ways to ask its figures.

import { test as base, expect } from "@playwright/test";
import { isLaidOut, markedAt } from "../engines/page.mjs";

/**
 * @typedef {import("@playwright/test").Page} Page
 * @typedef {import("../../www/engine/gear-bifurcations.js").Figure} Figure
 * @typedef {import("../../www/engine/gear-bifurcations.js").FrameMap} FrameMap
 * @typedef {import("../../www/figure/gear-figure.js").GearFigure} GearFigure
 * @typedef {Omit<Figure["series"][number], "columns"> & {columns: {x: number[], y: number[], z?: number[]}}} PlainSeries
 * @typedef {Omit<Figure, "series" | "motion"> & {series: PlainSeries[]}} PlainFigure  A figure as it comes out of the browser.
 * @typedef {[number, number, number]} Color
 */

/** Figures in the order of the page. */
export const IDS = (
  "1 T M 3 2 5 4 7 6 8 9 10 11a 11b 11c 12a 12b 12c 13a 13b 13c B S A 14a 14b L E"
).split(" ");

/** The colours that mean something, light theme. @type {Record<"exact" | "paper" | "corrected" | "supercritical" | "subcritical", Color>} */
export const COLORS = {
  exact: [0, 114, 178],
  paper: [128, 132, 137],
  corrected: [0, 158, 115],
  supercritical: [0, 158, 115],
  subcritical: [246, 205, 34],
};

/** Said by Playwright itself, which keeps service workers out of all tests but their own. */
const BLOCKED = "Service Worker registration blocked by Playwright";

/**
 * @typedef {import("@playwright/test").PlaywrightTestArgs & import("@playwright/test").PlaywrightTestOptions} Args
 * @typedef {import("@playwright/test").PlaywrightWorkerArgs & import("@playwright/test").PlaywrightWorkerOptions} WorkerArgs
 * @typedef {{handsOn: boolean, moving: boolean}} Options  Whether the reader always has a hand on the page, and whether what moves moves,
 *   which a reader can ask it not to: gears that turn, and what is done while nobody does anything, would take half the machine
 *   from the test beside this one.
 */

/** @type {import("@playwright/test").Fixtures<Options, {}, Args, WorkerArgs>} */
const FIXTURES = {
  handsOn: [true, { option: true }],
  moving: [false, { option: true }],
  contextOptions: async ({ moving }, use) => use(moving ? {} : { reducedMotion: "reduce" }),
  page: async ({ page, baseURL, handsOn }, use) => {
    /** @type {string[]} */
    const noise = [];
    const origin = new URL(baseURL ?? "http://127.0.0.1").origin;
    page.on("console", (message) => {
      if (message.text() !== BLOCKED) noise.push(`console ${message.type()}: ${message.text()}`);
    });
    page.on("pageerror", (error) => noise.push(`uncaught: ${error.message}`));
    page.on("request", (request) => {
      const url = request.url();
      if (!url.startsWith(`${origin}/`) && !url.startsWith("data:") && !url.startsWith("blob:")) noise.push(`request: ${url}`);
    });
    page.on("response", (response) => {
      if (response.status() >= 400) noise.push(`status ${response.status()}: ${response.url()}`);
    });
    await page.addInitScript(installReader);
    if (handsOn) await page.addInitScript(() => setInterval(() => dispatchEvent(new Event("input")), 500));
    await use(page);
    expect(noise).toEqual([]);
  },
};

/** Every test: no console line, no uncaught error, no request but to the page's own origin. */
export const test = base.extend(FIXTURES);

export { expect };

/** Gives the page a way to read pixels that leaves the canvas which is read as fast as it was, and the console silent. */
function installReader() {
  Object.assign(window, {
    /**
     * @param {HTMLCanvasElement} canvas
     * @param {[number, number, number, number]} box  Left, top, width, height in pixels of the store.
     */
    readPixels(canvas, [left, top, width, height]) {
      const copy = Object.assign(document.createElement("canvas"), { width, height });
      const context = copy.getContext("2d", { willReadFrequently: true });
      context?.drawImage(canvas, -left, -top);
      return context?.getImageData(0, 0, width, height).data ?? [];
    },
  });
}

/**
 * Opens the page and waits until every figure is drawn and, where the story is shown, all of it has its place.
 *
 * @param {Page} page
 * @param {string} [address]
 */
export async function open(page, address = "./?test") {
  await page.goto(address);
  await page.waitForFunction(markedAt, "all-figures", { timeout: 30_000 });
  await page.waitForFunction(isLaidOut, undefined, { timeout: 30_000 });
}

/**
 * When the page set a mark, ms after navigation; null before.
 *
 * @param {Page} page
 * @param {string} name
 */
export function marked(page, name) {
  return page.evaluate(markedAt, name);
}

/**
 * @param {Page} page
 * @param {string} id
 */
export function figure(page, id) {
  return page.locator(`gear-figure[figure="${id}"]`);
}

/**
 * What a figure's `data()` promises, as plain numbers.
 *
 * @param {Page} page
 * @param {string} id
 * @returns {Promise<PlainFigure>}
 */
export async function data(page, id) {
  const text = await figure(page, id).evaluate(async (element) => {
    const answer = await /** @type {GearFigure} */ (element).data();
    return JSON.stringify(answer, (_, value) => (ArrayBuffer.isView(value) ? [...(/** @type {Float64Array} */ (value))] : value));
  });
  return JSON.parse(text);
}

/**
 * @param {PlainFigure} from
 * @param {string} name
 * @returns {PlainSeries}
 */
export function series(from, name) {
  const found = from.series.find((one) => one.name === name);
  if (!found) throw new Error(`no series "${name}" in figure ${from.id}; there are ${from.series.map((one) => one.name).join(", ")}`);
  return found;
}

/**
 * A series' value over x, by linear interpolation; of several branches over the same x the one with the largest y.
 *
 * @param {PlainSeries} of
 * @param {number} at
 */
export function valueAt(of, at) {
  const { x, y } = of.columns;
  let best = -Infinity;
  for (let index = 1; index < x.length; index += 1) {
    const [left, right] = [x[index - 1], x[index]];
    if ((left - at) * (right - at) > 0 || left === right) continue;
    best = Math.max(best, y[index - 1] + ((at - left) / (right - left)) * (y[index] - y[index - 1]));
  }
  return best;
}

/**
 * The map between pixels and data of a figure's drawing, once that is complete.
 *
 * @param {Page} page
 * @param {string} id
 * @returns {Promise<FrameMap[]>}
 */
export async function map(page, id) {
  await settled(page, id);
  const text = await figure(page, id).evaluate((element) =>
    JSON.stringify(/** @type {GearFigure} */ (element).map(), (_, value) =>
      ArrayBuffer.isView(value) ? [...(/** @type {Float64Array} */ (value))] : value,
    ),
  );
  return JSON.parse(text).frames;
}

/**
 * Waits until a figure's canvas has been drawn with what it last computed. On a busy machine the drawing may take its turn
 * long after the numbers are there: it is asked for, not counted in frames.
 *
 * @param {Page} page
 * @param {string} id
 */
export async function settled(page, id) {
  await figure(page, id).evaluate(async (element) => {
    await /** @type {GearFigure} */ (element).data();
    await /** @type {any} */ (window).__gear.painted(element);
  });
}

/**
 * How many CSS pixels lie between a point of a frame, in data, and the nearest pixel of a colour; Infinity for none within reach.
 *
 * @param {Page} page
 * @param {string} id
 * @param {{frame: string, x: number, y: number, color: Color, reach?: number}} wanted
 */
export async function distanceToColor(page, id, { frame, x, y, color, reach = 12 }) {
  await settled(page, id);
  return figure(page, id).evaluate(
    (element, given) => {
      const canvas = element.shadowRoot?.querySelector("canvas");
      const of = /** @type {GearFigure} */ (element).map()?.frames.find(({ name }) => name === given.frame);
      if (!canvas || !of) throw new Error(`no frame ${given.frame}`);
      const { plot } = of;
      const left = plot.left + ((given.x - of.x.low) / (of.x.high - of.x.low)) * (plot.right - plot.left);
      const top = plot.bottom - ((given.y - of.y.low) / (of.y.high - of.y.low)) * (plot.bottom - plot.top);
      const density = canvas.width / canvas.clientWidth;
      const side = Math.ceil(2 * given.reach * density);
      const from = [Math.round((left - given.reach) * density), Math.round((top - given.reach) * density)];
      const pixels = /** @type {any} */ (window).readPixels(canvas, [from[0], from[1], side, side]);
      let best = Infinity;
      for (let index = 0; index < side * side; index += 1) {
        const off = [0, 1, 2].reduce((sum, part) => sum + Math.abs(pixels[4 * index + part] - given.color[part]), 0);
        if (off > 60) continue;
        const across = (from[0] + (index % side) + 0.5) / density - left;
        const down = (from[1] + Math.floor(index / side) + 0.5) / density - top;
        best = Math.min(best, Math.hypot(across, down));
      }
      return best;
    },
    { frame, x, y, color, reach },
  );
}

/**
 * In how many pixels of each frame's plot the canvas differs from the same figure without its series.
 *
 * @param {Page} page
 * @param {string} id
 * @returns {Promise<Record<string, number>>}
 */
export function ink(page, id) {
  return figure(page, id).evaluate(async (element) => {
    const live = /** @type {GearFigure} */ (element);
    const canvas = element.shadowRoot?.querySelector("canvas");
    const { engine, painted } = /** @type {any} */ (window).__gear;
    const shown = await live.data();
    // The pixels are read in the very task in which they are known to be drawn: what moves goes on moving.
    await painted(live);
    const frames = live.map()?.frames ?? [];
    if (!canvas) throw new Error("no canvas");
    const density = canvas.width / canvas.clientWidth;
    const empty = Object.assign(document.createElement("canvas"), { width: canvas.width, height: canvas.height });
    Object.assign(empty.style, { width: `${canvas.clientWidth}px`, height: `${canvas.clientHeight}px`, position: "fixed", left: "-9999px" });
    document.body.append(empty);
    engine.draw({ ...shown, series: [] }, empty, { theme: "light", density });
    /** @type {Record<string, number>} */
    const counts = {};
    for (const { name, plot } of frames) {
      const box = [
        Math.round(plot.left * density),
        Math.round(plot.top * density),
        Math.round((plot.right - plot.left) * density),
        Math.round((plot.bottom - plot.top) * density),
      ];
      const [full, bare] = [canvas, empty].map((one) => /** @type {any} */ (window).readPixels(one, box));
      counts[name] = 0;
      for (let index = 0; index < full.length; index += 4) {
        const differs = [0, 1, 2].some((part) => Math.abs(full[index + part] - bare[index + part]) > 24);
        counts[name] += differs ? 1 : 0;
      }
    }
    empty.remove();
    return counts;
  });
}

/**
 * A control of a figure; opens the further ones if it is among them.
 *
 * @param {Page} page
 * @param {string} id
 * @param {string} parameter
 */
export async function control(page, id, parameter) {
  const home = figure(page, id);
  await home.scrollIntoViewIfNeeded();
  await home.locator(".panel").waitFor();
  const wanted = home.locator(`.control[data-parameter="${parameter}"]`);
  if ((await wanted.count()) === 0) await home.locator(".more > summary").click();
  return { box: wanted.getByRole("spinbutton"), slider: wanted.getByRole("slider"), complaint: wanted.locator(".complaint") };
}

/** The same in every language: the project, a journal, a licence, kinds of files. */
const NAMES = /^(gear-bifurcations.*|Nonlinear Dynamics|SIL Open Font License|Pitchfork and Hopf bifurcations of geared systems .*|BibTeX|RIS|Export|rustc .*|[0-9a-f]{12}.*)$/;

/**
 * All that is read or heard on the page at present, but for formulas, code and what charts measure: texts and names of elements.
 *
 * @param {Page} page
 * @returns {Promise<string[]>}
 */
export async function readable(page) {
  const found = await page.evaluate(() => {
    /** @type {string[]} */
    const texts = [];
    /** @param {Node} root */
    const walk = (root) => {
      const walker = document.createTreeWalker(root, NodeFilter.SHOW_TEXT | NodeFilter.SHOW_ELEMENT);
      for (let node = walker.nextNode(); node !== null; node = walker.nextNode()) {
        if (node instanceof Element) {
          if (node.shadowRoot !== null) walk(node.shadowRoot);
          if (node.checkVisibility()) for (const name of ["aria-label", "aria-roledescription", "title", "placeholder", "alt"]) texts.push(node.getAttribute(name) ?? "");
        } else if (node.parentElement?.checkVisibility() && !node.parentElement.closest("script, style, math, pre, code, var, i")) texts.push(node.textContent ?? "");
      }
    };
    walk(document.body);
    return texts.map((text) => text.replaceAll(/\s+/g, " ").trim());
  });
  // A word: of more letters than a symbol has, and no function's name.
  return [...new Set(found.filter((text) => /\p{L}{4,}/u.test(text.replaceAll(/Liouville|Amplitude/g, "")) && !NAMES.test(text)))];
}
