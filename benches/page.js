// Measures the page in Chromium as its reader feels it: how soon it shows its figures, what a figure costs another page, how
// charts answer a hand, whether anything holds the page up, and whether drawing again and again leaves anything behind.
// `cargo xtask bench --page` calls it after a build, with the page's address in GEAR_ADDRESS and the folder in GEAR_DIST. It
// writes a line for each measurement: what, how much, and what it should be, with tabs between.

import { pathToFileURL } from "node:url";
import { chromium } from "@playwright/test";
import { launchOptions } from "../xtask/chromium.js";
import { tasksOf } from "./trace.js";

/**
 * @typedef {import("@playwright/test").Page} Page
 * @typedef {import("@playwright/test").BrowserContext} BrowserContext
 */

const OPENINGS = 8;
const PATIENCE = { timeout: 120_000 };
const VIEW = { viewport: { width: 1440, height: 900 }, serviceWorkers: /** @type {const} */ ("block") };
/** The figure that is embedded, and a page around it. */
const HOST = "<!doctype html><meta charset=utf-8><title>A host</title><link rel=icon href=data:,><main style=max-width:45rem><p>Words before.</p>";
const EMBEDS = {
  element: `${HOST}<script type=module src=gear-figure.js></script><gear-figure figure=11a></gear-figure>`,
  frame: `${HOST}<iframe src="embed.html#figure=11a" title="A figure" width=720 height=620></iframe>`,
};
/** After this time an embedded figure has all it will have, ms. */
const SETTLED = 4000;
const DRAGS = 12;
const REDRAWS = 10_000;
/** What takes longer is felt, ms. */
const LONG = 50;

const address = process.env.GEAR_ADDRESS ?? "";
const dist = process.env.GEAR_DIST ?? "";
if (address === "" || dist === "") throw new Error("GEAR_ADDRESS and GEAR_DIST say where the page is");
const wanted = new Set(process.argv.slice(2));

/** @type {Record<string, () => Promise<void>>} */
const PARTS = { opening, single, embeds, formulas, handle, minute, gears, heap };

const browser = await chromium.launch({ ...launchOptions, args: [...(launchOptions.args ?? []), "--js-flags=--expose-gc"] });
try {
  for (const [name, part] of Object.entries(PARTS)) if (wanted.size === 0 || wanted.has(name)) await part();
} finally {
  await browser.close();
}

/**
 * @param {string} what
 * @param {string} found
 * @param {string} aim  Empty for none.
 */
function tell(what, found, aim) {
  console.log([what, found, aim].join("\t"));
}

/** @param {number} time */
function milliseconds(time) {
  return `${time < 10 ? time.toFixed(1) : time.toFixed(0)} ms`;
}

/** @param {readonly number[]} values */
function median(values) {
  return [...values].sort((a, b) => a - b)[values.length >> 1];
}

/** How soon figures stand on the site. */
async function opening() {
  await openings("the site", address);
}

/** The same from a disk. */
async function single() {
  await openings("the page in one file", pathToFileURL(`${dist}/gear-bifurcations.html`).href);
}

/**
 * Opens the page again and again, each time as a new visitor.
 *
 * @param {string} what
 * @param {string} place
 */
async function openings(what, place) {
  const names = /** @type {const} */ (["first-figure", "all-figures"]);
  /** @type {number[][]} */
  const found = [];
  const own = await chromium.launch(launchOptions);
  for (let index = 0; index < OPENINGS; index += 1) {
    const context = await own.newContext(VIEW);
    const page = await context.newPage();
    await page.goto(place);
    await page.waitForFunction((last) => performance.getEntriesByName(last).length > 0, names[1], { ...PATIENCE, polling: 100 });
    found.push(await page.evaluate((marks) => marks.map((mark) => performance.getEntriesByName(mark)[0].startTime), [...names]));
    await context.close();
  }
  await own.close();
  names.forEach((name, index) => {
    const times = found.map((one) => one[index]);
    const until = `${what}: ${name === "first-figure" ? "the first figure" : "all fourteen"}`;
    const aim = name === "first-figure" ? "300 ms" : place === address ? "1 s" : "";
    tell(`${until}, browser just started`, milliseconds(times[0]), aim);
    tell(`${until}, median of ${OPENINGS - 1} more`, milliseconds(median(times.slice(1))), aim);
  });
}

/** What one figure costs the main thread of another page, beyond what the page costs without it. */
async function embeds() {
  const bare = await cost(HOST);
  for (const [name, html] of Object.entries(EMBEDS)) {
    tell(`an embed as ${name === "frame" ? "a frame of the same site" : "an element"}: time of the host's main thread`, milliseconds((await cost(html)) - bare), "60 ms");
  }
}

/**
 * The time that a page's main thread works until it has nothing left to do, ms, the median of five. Not the time that
 * passes: the processor has others to serve.
 *
 * @param {string} html
 */
async function cost(html) {
  const times = [];
  for (let index = 0; index < 5; index += 1) {
    const context = await browser.newContext(VIEW);
    const page = await context.newPage();
    await page.route("**/host.html", (route) => route.fulfill({ contentType: "text/html", body: html }));
    const tasks = await tasksOf(browser, page, async () => {
      await page.goto(new URL("host.html", address).href);
      // Whoever looked into the page meanwhile would be measured with it.
      await page.waitForTimeout(SETTLED);
    });
    // The figure's controls come last.
    const root = html.includes("<iframe") ? page.frameLocator("iframe") : page;
    if (html !== HOST && (await root.locator("gear-figure .panel").count()) === 0) throw new Error("the figure has not come in time");
    times.push(tasks.reduce((sum, { time }) => sum + time, 0));
    await context.close();
  }
  return median(times);
}

/** The laboratory, with all its charts. @returns {Promise<{context: BrowserContext, page: Page}>} */
async function laboratory() {
  const context = await browser.newContext(VIEW);
  const page = await context.newPage();
  await page.goto(new URL("?test#lab", address).href);
  await page.locator(".lab gear-figure").first().waitFor(PATIENCE);
  await quiet(page);
  return { context, page };
}

/** Waits until every chart that has a place is complete and drawn. @param {Page} page */
async function quiet(page) {
  await page.evaluate(async () => {
    const { painted } = /** @type {any} */ (window).__gear;
    const figures = /** @type {any[]} */ ([...document.querySelectorAll("main > :not([hidden]) gear-figure")].filter((figure) => figure.clientWidth > 0));
    await Promise.allSettled(figures.map((figure) => figure.data()));
    await Promise.all(figures.map((figure) => painted(figure)));
  });
}

/** A slider of a figure that is made of formulas is moved by keys: is the picture in the very frame? */
async function formulas() {
  const context = await browser.newContext(VIEW);
  const page = await context.newPage();
  await page.goto(new URL("?test", address).href);
  await page.waitForFunction(() => performance.getEntriesByName("all-figures").length > 0, undefined, { ...PATIENCE, polling: 100 });
  for (const id of ["2", "4"]) {
    await page.locator(`#fig-${id} input[type=range]`).first().focus(PATIENCE);
    await quiet(page);
    await page.waitForTimeout(1000);
    await page.evaluate((key) => {
      /** @type {number[]} */
      const frames = [];
      Object.assign(window, { frames });
      const figure = /** @type {HTMLElement} */ (document.getElementById(`fig-${key}`));
      let passed = NaN;
      const count = () => {
        passed += 1;
        requestAnimationFrame(count);
      };
      requestAnimationFrame(count);
      figure.addEventListener("input", () => (passed = 0), { capture: true });
      figure.addEventListener("gear-paint", () => {
        if (passed >= 0) frames.push(passed);
        passed = NaN;
      });
    }, id);
    for (let index = 0; index < DRAGS; index += 1) {
      await page.keyboard.press("ArrowRight");
      await page.waitForTimeout(100);
    }
    const frames = /** @type {number[]} */ (await page.evaluate(() => /** @type {any} */ (window).frames));
    tell(`slider moved: figure ${id}, of formulas, in the same frame`, `${frames.filter((passed) => passed <= 1).length} of ${DRAGS}`, "all");
  }
  await context.close();
}

/** The handle of the stability chart is moved: when do the charts of the laboratory follow? */
async function handle() {
  const { context, page } = await laboratory();
  await page.evaluate(() => {
    /** @type {any} */ (window).followed = () => {
      /** @type {Record<string, {first: number, last: number}>} */
      const found = {};
      const over = new AbortController();
      const chart = /** @type {HTMLElement} */ (document.querySelector(".lab gear-figure[figure=T]"));
      const canvas = chart.shadowRoot?.querySelector("canvas");
      let begun = 0;
      canvas?.addEventListener(
        "pointermove",
        (event) => {
          begun ||= event.timeStamp;
        },
        { signal: over.signal, capture: true },
      );
      for (const figure of document.querySelectorAll(".lab gear-figure")) {
        const id = figure.getAttribute("figure") ?? "";
        const note = (/** @type {boolean} */ complete) => {
          if (begun === 0) return;
          const after = performance.now() - begun;
          const own = (found[id] ??= { first: after, last: NaN });
          if (complete) own.last = after;
        };
        // What moves is drawn in every frame; it has followed once it moves by what was computed anew.
        if (id !== "1") figure.addEventListener("gear-paint", () => note(false), { signal: over.signal });
        figure.addEventListener("gear-change", () => note(true), { signal: over.signal });
      }
      return () => {
        over.abort();
        return found;
      };
    };
  });
  await page.waitForTimeout(1000);
  const place = await page.locator(".lab gear-figure[figure=T] canvas").boundingBox();
  const at = await page.evaluate(() => {
    const figure = /** @type {any} */ (document.querySelector(".lab gear-figure[figure=T]"));
    const own = figure.map().frames[0];
    const { Omega, k0 } = figure.shown.params;
    const across = (Omega - own.x.low) / (own.x.high - own.x.low);
    const up = (k0 - own.y.low) / (own.y.high - own.y.low);
    return { x: own.plot.left + across * (own.plot.right - own.plot.left), y: own.plot.bottom - up * (own.plot.bottom - own.plot.top) };
  });
  if (place === null) throw new Error("the chart has no place");
  /** @type {Record<string, {first: number, last: number}[]>} */
  const all = {};
  let x = place.x + at.x;
  const y = place.y + at.y;
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let index = 0; index < DRAGS; index += 1) {
    await quiet(page);
    const watch = await page.evaluateHandle(() => /** @type {any} */ (window).followed());
    x += 3;
    await page.mouse.move(x, y);
    await page.waitForTimeout(1500);
    const found = /** @type {typeof all[string][number][]} */ (await watch.evaluate((end) => end()));
    for (const [id, one] of Object.entries(found)) (all[id] ??= []).push(one);
  }
  await page.mouse.up();
  for (const [id, found] of Object.entries(all)) {
    const late = (/** @type {"first" | "last"} */ which) => found.map((one) => one[which]).filter(Number.isFinite);
    tell(`handle moved: chart ${id}, first picture`, milliseconds(median(late("first"))), "50 ms");
    tell(`handle moved: chart ${id}, complete`, late("last").length === 0 ? "not within 1.5 s" : milliseconds(median(late("last"))), "500 ms");
  }
  await context.close();
}

/** A minute of reading and trying, in which nothing may hold the page up. */
async function minute() {
  const context = await browser.newContext(VIEW);
  const page = await context.newPage();
  await page.addInitScript(() => {
    /** @type {any} */ (window).longest = [];
    new PerformanceObserver((list) => {
      for (const { startTime, duration } of list.getEntries()) /** @type {any} */ (window).longest.push({ begin: startTime, time: duration });
    }).observe({ type: "longtask", buffered: true });
  });
  /** @type {{name: string, from: number}[]} */
  const steps = [];
  const tasks = await tasksOf(browser, page, () => use(page, steps));
  const seen = /** @type {import("./trace.js").Task[]} */ (await page.evaluate(() => /** @type {any} */ (window).longest));
  const during = (/** @type {number} */ time) => steps.filter(({ from }) => from <= time).at(-1)?.name ?? "";
  for (const [how, found] of /** @type {const} */ ([["by the clock", seen], ["by the processor's time", tasks.filter(({ time }) => time > LONG)]])) {
    const worst = [...found].sort((a, b) => b.time - a.time);
    const which = worst.length === 0 ? "" : `, the longest ${milliseconds(worst[0].time)} (${during(worst[0].begin)})`;
    tell(`tasks over ${LONG} ms in a minute of use, ${how}`, `${found.length}${which}`, "0");
  }
  if (process.env.GEAR_DETAILS) for (const { begin, time } of tasks.filter(({ time }) => time > 25).sort((a, b) => b.time - a.time)) console.error(`${time.toFixed(0)} ms at ${begin.toFixed(0)}: ${during(begin)}`);
  await context.close();
}

/**
 * The minute itself.
 *
 * @param {Page} page
 * @param {{name: string, from: number}[]} steps  Takes when each began.
 */
async function use(page, steps) {
  const step = async (/** @type {string} */ name, /** @type {() => Promise<unknown>} */ act, seconds = 3) => {
    steps.push({ name, from: await page.evaluate(() => performance.now()).catch(() => 0) });
    await act();
    await page.waitForTimeout(seconds * 1000);
  };
  await step("opening", () => page.goto(new URL("?test", address).href), 6);
  steps[0].from = 0;
  await step("scrolling", async () => {
    for (let index = 0; index < 40; index += 1) {
      await page.mouse.wheel(0, 500);
      await page.waitForTimeout(150);
    }
  });
  await step("back to the top", () => page.keyboard.press("Control+Home"));
  await step("a slider dragged", async () => {
    const slider = page.locator("#fig-2 input[type=range]").first();
    await slider.scrollIntoViewIfNeeded();
    const box = await slider.boundingBox();
    if (box === null) return;
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await page.mouse.down();
    for (let index = 0; index < 40; index += 1) {
      await page.mouse.move(box.x + box.width * (0.5 + 0.3 * Math.sin(index / 6)), box.y + box.height / 2);
      await page.waitForTimeout(50);
    }
    await page.mouse.up();
  });
  await step("the other theme", () => page.keyboard.press("t"));
  await step("the laboratory", () => page.keyboard.press("2"), 6);
  await step("its handle dragged", async () => {
    const chart = await page.locator(".lab gear-figure[figure=T] canvas").boundingBox();
    if (chart === null) return;
    await page.mouse.move(chart.x + chart.width / 3, chart.y + chart.height / 2);
    await page.mouse.down();
    for (let index = 0; index < 40; index += 1) {
      await page.mouse.move(chart.x + chart.width * (0.33 + 0.1 * Math.sin(index / 6)), chart.y + chart.height * (0.5 + 0.1 * Math.cos(index / 6)));
      await page.waitForTimeout(50);
    }
    await page.mouse.up();
  });
  await step("the frequency creeps", () => page.keyboard.press("g"), 6);
  await step("it stops", () => page.keyboard.press("g"));
  await step("the classroom", () => page.keyboard.press("3"));
  await step("the palette", () => page.keyboard.press("Control+k"));
  await step("back to the story", async () => {
    await page.keyboard.press("Escape");
    await page.keyboard.press("1");
  });
}

/** Pictures of the moving gears in a second, with all charts of the laboratory around them. */
async function gears() {
  const { context, page } = await laboratory();
  const [pictures, frames] = await page.evaluate(
    () =>
      new Promise((/** @type {(counted: number[]) => void} */ resolve) => {
        const figure = /** @type {any} */ (document.querySelector(".lab gear-figure[figure='1']"));
        figure.play();
        let [painted, passed] = [0, 0];
        figure.addEventListener("gear-paint", () => (painted += 1));
        const begun = performance.now();
        const count = () => {
          passed += 1;
          if (performance.now() - begun < 5000) requestAnimationFrame(count);
          else resolve([painted / 5, passed / 5]);
        };
        requestAnimationFrame(count);
      }),
  );
  tell("pictures of the moving gears, of frames", `${pictures.toFixed(0)} of ${frames.toFixed(0)} a second`, "60");
  await context.close();
}

/** What is left behind when figures are drawn ten thousand times. */
async function heap() {
  const context = await browser.newContext(VIEW);
  const page = await context.newPage();
  await page.goto(new URL("?test", address).href);
  await page.waitForFunction(() => performance.getEntriesByName("all-figures").length > 0, undefined, { ...PATIENCE, polling: 100 });
  await page.evaluate(() => /** @type {any} */ (document.getElementById("fig-1")).pause());
  await quiet(page);
  const session = await context.newCDPSession(page);
  const used = async () => {
    for (let index = 0; index < 3; index += 1) await session.send("HeapProfiler.collectGarbage");
    return (await session.send("Runtime.getHeapUsage")).usedSize;
  };
  const draw = (/** @type {number} */ times) =>
    page.evaluate(async (wanted) => {
      const figures = /** @type {any[]} */ ([..."2 4 6 9 11a 14b T 1".split(" ")].map((id) => document.getElementById(`fig-${id}`)));
      for (let index = 0; index < wanted; index += 1) {
        figures[index % figures.length].paint();
        if (index % 20 === 0) await new Promise((resolve) => setTimeout(resolve));
      }
    }, times);
  // What is made once is made by then.
  await draw(200);
  const before = await used();
  await draw(REDRAWS);
  const grown = (await used()) - before;
  tell(`heap grown after ${REDRAWS} drawings and a collection`, `${(grown / 1e6).toFixed(2)} MB`, "2 MB");
  await context.close();
}
