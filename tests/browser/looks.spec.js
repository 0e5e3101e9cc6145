// How a handful of views look, beside how they looked when somebody last approved of it: `looks/NAME.png`, a third as large
// as the screen. `npx playwright test looks --update-snapshots` renews those that differ; look at them before you commit them.

import { existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname } from "node:path";
import { fileURLToPath } from "node:url";
import { test, expect } from "./page.js";

/** @typedef {import("@playwright/test").Page} Page */

/** Pixels of the screen that make one of the picture, along each side. */
const SCALE = 3;
/** Edges of letters and lines come out a little otherwise on another machine; up to this a colour counts as the same, of 255. */
const SHADE = 40;
/** Pixels of a picture that may differ by more: dots of a line that fell on the other side of an edge. */
const STRAY = 4;

const WIDE = { width: 1440, height: 900 };

/**
 * Pages, and what is looked at on each: the name of the picture, the element where it is not all that is seen, and
 * something that is taken away to see whether that would be found out.
 *
 * @type {{hash: string, size: {width: number, height: number}, looks: {name: string, dark?: boolean, element?: string, touch: string}[]}[]}
 */
const PAGES = [
  {
    hash: "",
    size: WIDE,
    looks: [
      { name: "first-screen", touch: "h1" },
      { name: "figure-2", element: "#fig-2", touch: "#fig-2 .legend .entry >> nth=0" },
      { name: "figure-11c", element: "#fig-11c", touch: "#fig-11c .buttons button >> nth=-1" },
    ],
  },
  {
    hash: "#lab",
    size: WIDE,
    looks: [
      { name: "lab-light", touch: ".lab .toolbar button >> nth=0" },
      { name: "lab-dark", dark: true, touch: ".lab .toolbar button >> nth=1" },
    ],
  },
  {
    hash: "#class&v=1&lesson=tongue&projector=on",
    size: { width: 1920, height: 1080 },
    looks: [{ name: "class-projector", touch: ".classroom fieldset label >> nth=0" }],
  },
];

for (const { hash, size, looks } of PAGES) {
  test(`it looks as it did: ${looks.map(({ name }) => name).join(", ")}`, async ({ page }, info) => {
    await page.emulateMedia({ colorScheme: "light", reducedMotion: "reduce" });
    await page.setViewportSize(size);
    await page.goto(`./?test${hash}`);
    for (const { name, dark = false, element, touch } of looks) {
      await page.emulateMedia({ colorScheme: dark ? "dark" : "light" });
      const place = page.locator(element ?? "body");
      await place.scrollIntoViewIfNeeded();
      await complete(page);
      if (element !== undefined) await place.evaluate((one) => one.scrollIntoView({ block: "center" }));
      const shot = () => (element === undefined ? page.screenshot() : place.screenshot());
      const now = await smaller(page, await shot());
      await compare(page, info, name, now);
      // The same with one small thing missing is not the same.
      await page.locator(touch).evaluate((one) => (/** @type {HTMLElement} */ (one).style.visibility = "hidden"));
      const missing = await difference(page, await smaller(page, await shot()), now);
      expect(missing.stray, `${name} without ${touch}`).toBeGreaterThan(2 * STRAY);
      await page.locator(touch).evaluate((one) => (/** @type {HTMLElement} */ (one).style.visibility = ""));
    }
  });
}

/**
 * Compares a picture with the one that is known, or puts it in its place where that is wanted.
 *
 * @param {Page} page
 * @param {import("@playwright/test").TestInfo} info
 * @param {string} name
 * @param {Buffer} now
 */
async function compare(page, info, name, now) {
  const path = fileURLToPath(new URL(`looks/${name}.png`, import.meta.url));
  const known = existsSync(path) ? readFileSync(path) : null;
  const differing = known === null ? { sizes: false, stray: Infinity } : await difference(page, now, known);
  if (differing.stray <= STRAY) return;
  if (["all", "changed"].includes(info.config.updateSnapshots)) {
    mkdirSync(dirname(path), { recursive: true });
    writeFileSync(path, now);
    return;
  }
  const beside = info.outputPath(`${name}.png`);
  writeFileSync(beside, now);
  expect(known, `there is no ${path} yet: renew the pictures`).not.toBeNull();
  expect(differing.sizes, `${path} is as large as what it is now, ${beside}`).toBe(true);
  expect(differing.stray, `pixels in which ${path} differs from what it is now, ${beside}`).toBeLessThanOrEqual(STRAY);
}

/**
 * Waits until every figure that is shown is computed and drawn, and its controls stand.
 *
 * @param {Page} page
 */
async function complete(page) {
  await page.waitForFunction(() => "__gear" in window);
  await page.locator("main > [data-view]:not([hidden]) :is(h1, h2)").first().waitFor();
  const figures = page.locator("main > [data-view]:not([hidden]) gear-figure");
  if ((await page.evaluate(() => document.documentElement.dataset.view)) !== "class") await figures.first().waitFor();
  await page.evaluate(async () => {
    await document.fonts.ready;
    // Those above too: what they say when they are complete moves what is under them.
    const near = (/** @type {Element} */ one) => {
      const { top, width } = one.getBoundingClientRect();
      return width > 0 && top < innerHeight + 200;
    };
    const shown = [...document.querySelectorAll("gear-figure")].filter(near);
    const { painted } = /** @type {any} */ (window).__gear;
    await Promise.all(
      shown.map(async (one) => {
        await /** @type {any} */ (one).data().catch(() => null);
        await painted(one);
      }),
    );
    // Two drawings at most are still to come: the finer one, and that of the typeface.
    for (let frame = 0; frame < 20; frame += 1) await new Promise((resolve) => requestAnimationFrame(resolve));
    await Promise.all(shown.map((one) => painted(one)));
    const panels = () => shown.every((one) => one.getAttribute("controls") === "none" || one.shadowRoot?.querySelector(".panel"));
    while (!panels()) await new Promise((resolve) => requestAnimationFrame(resolve));
  });
}

/**
 * A picture made smaller, each pixel the mean of those that it stands for.
 *
 * @param {Page} page
 * @param {Buffer} png
 */
async function smaller(page, png) {
  const text = await page.evaluate(
    async ([data, scale]) => {
      const image = Object.assign(new Image(), { src: `data:image/png;base64,${data}` });
      await image.decode();
      const [width, height] = [image.width, image.height].map((side) => Math.floor(side / Number(scale)));
      const [whole, small] = [image, { width, height }].map((of) => Object.assign(document.createElement("canvas"), { width: of.width, height: of.height }));
      const [from, to] = [whole, small].map((canvas) => canvas.getContext("2d", { willReadFrequently: true }));
      if (from === null || to === null) throw new Error("no canvas");
      from.drawImage(image, 0, 0);
      const { data: fine } = from.getImageData(0, 0, image.width, image.height);
      const coarse = to.createImageData(width, height);
      const side = Number(scale);
      for (let at = 0; at < width * height; at += 1) {
        const [left, top] = [(at % width) * side, Math.floor(at / width) * side];
        for (let part = 0; part < 4; part += 1) {
          let sum = 0;
          for (let row = 0; row < side; row += 1) for (let column = 0; column < side; column += 1) sum += fine[4 * ((top + row) * image.width + left + column) + part];
          // Fewer shades than the eye tells apart make smaller files.
          coarse.data[4 * at + part] = part === 3 ? 255 : Math.min(255, 8 * Math.round(sum / (8 * side * side)));
        }
      }
      to.putImageData(coarse, 0, 0);
      return small.toDataURL("image/png").split(",")[1];
    },
    /** @type {const} */ ([png.toString("base64"), SCALE]),
  );
  return Buffer.from(text, "base64");
}

/**
 * In how many pixels two pictures differ, each compared with the nearest in its neighbourhood: a line that lies half a
 * pixel further is the same line.
 *
 * @param {Page} page
 * @param {Buffer} one
 * @param {Buffer} other
 */
function difference(page, one, other) {
  return page.evaluate(
    async ([first, second, shade]) => {
      const [left, right] = await Promise.all(
        [first, second].map(async (data) => {
          const image = Object.assign(new Image(), { src: `data:image/png;base64,${data}` });
          await image.decode();
          const canvas = Object.assign(document.createElement("canvas"), { width: image.width, height: image.height });
          const context = canvas.getContext("2d", { willReadFrequently: true });
          context?.drawImage(image, 0, 0);
          return context?.getImageData(0, 0, image.width, image.height) ?? new ImageData(1, 1);
        }),
      );
      if (left.width !== right.width || left.height !== right.height) return { sizes: false, stray: Infinity };
      const { width, height } = left;
      const apart = (/** @type {ImageData} */ from, /** @type {ImageData} */ to, /** @type {number} */ x, /** @type {number} */ y) => {
        let best = 255;
        for (let row = Math.max(0, y - 1); row <= Math.min(height - 1, y + 1); row += 1) {
          for (let column = Math.max(0, x - 1); column <= Math.min(width - 1, x + 1); column += 1) {
            const [here, there] = [4 * (y * width + x), 4 * (row * width + column)];
            const off = Math.max(...[0, 1, 2].map((part) => Math.abs(from.data[here + part] - to.data[there + part])));
            if (off < best) best = off;
          }
        }
        return best;
      };
      let stray = 0;
      for (let at = 0; at < width * height; at += 1) {
        const same = left.data[4 * at] === right.data[4 * at] && left.data[4 * at + 1] === right.data[4 * at + 1] && left.data[4 * at + 2] === right.data[4 * at + 2];
        if (same) continue;
        const [x, y] = [at % width, Math.floor(at / width)];
        if (Math.max(apart(left, right, x, y), apart(right, left, x, y)) > Number(shade)) stray += 1;
      }
      return { sizes: true, stray };
    },
    /** @type {const} */ ([one.toString("base64"), other.toString("base64"), SHADE]),
  );
}
