// What is held after a collection must not grow: by rounds through lessons, languages and views, and by use in a hurry, two minutes in
// every run and as many as SOAK_MINUTES says: a seeded visitor who slides, drags, zooms, types, undoes, changes views, lessons, themes,
// languages and the window (`cargo xtask soak` takes 30 minutes).

import { expect, open, test } from "./page.js";
import { held, threads } from "./memory.js";
import { random } from "../node/random.mjs";

/** @typedef {import("@playwright/test").Page} Page */
/** @typedef {import("../node/random.mjs").Choose} Choose */

const MINUTES = Number(process.env.SOAK_MINUTES ?? 2);
/** Until everything has been used once, and every cache is as full as it gets: this much of the time, and no less than a round. */
const WARM = 0.5;
/** Bytes that may have been added after that. */
const GROWTH = 2 * 2 ** 20;
/** Nodes and listeners that may in rounds that end where they began: of six lessons that are kept there are hundreds. Chance leaves drawers open, which have some of each. */
const NODES = 200;
const LISTENERS = 60;

const SIZES = [[1280, 720], [360, 740], [800, 600], [1440, 900], [1920, 1080]];
const PLACES = [
  "#story&v=1", "#lab&v=1", "#class&v=1", "#lab&v=1&preset=11c&omega=1.7", "#lab&v=1&preset=14b", "#story&v=1&at=fig-12a&theme=dark", "#lab&v=1&language=de&theme=contrast",
  "#class&v=1&lesson=hopf&step=1", "#class&v=1&lesson=tongue", "#class&v=1&lesson=pitchfork&step=2&language=de", "#story&v=1&11a.omega=1.62&3.view=0.6,0.3&projector=on", "#lab&v=1&pin1.preset=14a&pin1.k0=0.3",
];
const LESSONS = ["tongue", "pitchfork", "hopf", "hysteresis", "contact"];
/** An action that takes longer than this is left alone, ms. */
const STUCK = 20_000;
/** What must come, and does not within this time, is said by its name, ms. */
const LONGEST = 120_000;
/** Time for what stands there to be drawn, ms. */
const LOOK = 500;
const KEYS = ["ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown", "Home", "End", "+", "-", " ", "Escape", "Tab", "Control+z", "Control+y", "Control+Shift+z", "PageDown"];

/** Something on the page that a visitor would touch, by chance: done in the page, where all shadow roots are open. */
function touch(/** @type {number} */ chance, /** @type {number} */ value) {
  /** @param {Document | ShadowRoot | Element} root @returns {Element[]} */
  const all = (root) => [...root.querySelectorAll("*")].flatMap((element) => [element, ...(element.shadowRoot ? all(element.shadowRoot) : [])]);
  const shown = (/** @type {Element} */ element) => element.checkVisibility() && element.getBoundingClientRect().width > 0;
  const wanted = "input[type=range], .control input, button.entry, button.reset, button.whole, button.stop, .buttons button, .more > summary, [data-view=class] button, [data-view=class] input, [data-action=undo], [data-action=redo]";
  // Nothing that saves, prints, speaks or leaves.
  const barred = /save|speich|download|copy|kopier|print|druck|share|teil|link|file|datei|open|öffne|picture|bild|table|tabelle|sound|ton|full|voll/i;
  const found = all(document.body).filter((element) => element.matches(wanted) && shown(element) && !barred.test(`${element.textContent} ${element.getAttribute("aria-label")} ${element.className}`));
  const element = found[Math.floor(chance * found.length)];
  if (element instanceof HTMLInputElement && ["range", "number", "text"].includes(element.type)) {
    const [low, high] = element.type === "range" ? [Number(element.min), Number(element.max)] : [0, 2];
    element.value = String(low + value * (high - low));
    for (const type of ["input", "change"]) element.dispatchEvent(new Event(type, { bubbles: true, composed: true }));
  } else if (element instanceof HTMLElement) element.click();
  return element?.className ?? null;
}

/** A point on a canvas that is on the screen, or null. @param {Page} page @param {Choose} choose */
async function canvas(page, choose) {
  const boxes = await page.evaluate(() =>
    [...document.querySelectorAll("gear-figure")].flatMap((figure) => {
      const { left, top, width, height } = figure.shadowRoot?.querySelector("canvas")?.getBoundingClientRect() ?? new DOMRect();
      return width > 60 && top + height > 40 && top < innerHeight - 40 ? [{ left, top, width, height }] : [];
    }),
  );
  if (boxes.length === 0) return null;
  const { left, top, width, height } = choose.of(boxes);
  return { x: left + choose.next() * width, y: top + choose.next() * height };
}

/** @param {Page} page @param {Choose} choose */
async function act(page, choose) {
  switch (choose.integer(0, 19)) {
    case 0:
      await page.evaluate((hash) => void (location.hash = hash), choose.of(PLACES));
      break;
    case 1: {
      const [width, height] = choose.of(SIZES);
      await page.setViewportSize({ width, height });
      break;
    }
    case 2:
    case 3:
      await page.evaluate((part) => scrollTo({ top: part * (document.body.scrollHeight - innerHeight), behavior: "instant" }), choose.next());
      break;
    case 4:
    case 5: {
      const from = await canvas(page, choose);
      if (from === null) break;
      await page.mouse.move(from.x, from.y);
      await page.mouse.down();
      await page.mouse.move(from.x + choose.number(-150, 150), from.y + choose.number(-100, 100), { steps: 4 });
      await page.mouse.up();
      break;
    }
    case 6: {
      const at = await canvas(page, choose);
      if (at === null) break;
      await page.mouse.move(at.x, at.y);
      await page.mouse.wheel(0, choose.number(-300, 300));
      break;
    }
    case 7:
    case 8:
    case 9:
      for (let count = choose.integer(1, 4); count > 0; count -= 1) await page.keyboard.press(choose.of(KEYS));
      break;
    default:
      await page.evaluate(`(${touch})(${choose.next()}, ${choose.next()})`);
  }
}

/** Waits until an element's canvas shows what it last computed. @param {Page} page @param {string} id */
async function settled(page, id) {
  await page.locator(`#${id}`).evaluate(async (element) => {
    await /** @type {any} */ (element).data();
    await /** @type {any} */ (window).__gear.painted(element);
  });
}

/** Opens the drawers of sliders, or closes all that can be opened beside figures; in the page. @param {boolean} open */
async function setDrawers(open) {
  const drawers = [...document.querySelectorAll("gear-figure")].flatMap((figure) => [.../** @type {NodeListOf<HTMLDetailsElement>} */ (figure.shadowRoot?.querySelectorAll(open ? "details.more" : "details"))]);
  for (const drawer of drawers) drawer.open = open;
  // They are told of it in a task of its own.
  await new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
}

/** What is waited for on the way home: whoever waits in vain is to say at which step. */
let step = "";

/** One and the same place, whatever was done before; a link begins a new history. @param {Page} page */
async function goHome(page) {
  step = "the laboratory's chart";
  await page.keyboard.press("Escape");
  await page.setViewportSize({ width: 1280, height: 720 });
  // The same address twice would be no link.
  await page.evaluate(() => void (location.hash = "#lab&v=1"));
  await settled(page, "lab-T");
  step = "the story's first figures";
  await page.evaluate(() => void (location.hash = "#story&v=1&theme=light&language=en&projector=off"));
  await page.evaluate(() => scrollTo({ top: 0, behavior: "instant" }));
  for (const id of ["fig-1", "fig-T"]) await settled(page, id);
  // What is laid out takes memory: chance has more drawers open the longer it plays.
  await page.evaluate(setDrawers, false);
  step = "a moment with nothing to do";
  // After drags that no hand has made Chromium at times takes one to be under way, and tells of no idle moment any more although it has nothing else.
  await page.evaluate(() => new Promise((resolve) => requestIdleCallback(() => requestAnimationFrame(() => resolve(null)), { timeout: 2000 })));
  step = "all figures of the story";
  // What completes by itself later brings its words and tables then.
  await page.evaluate(() => Promise.all([...document.querySelectorAll("gear-figure[id^=fig]")].map((one) => /** @type {any} */ (one).data().catch(() => null))));
  // Gears that turn are drawn by the page's own module, whose memory is there in one frame and given back in the next.
  await page.locator("#fig-1").evaluate((gears) => /** @type {any} */ (gears).pause());
  step = "idle workers";
  // As when the page is put away: the memory of wasm is not collected, but given back.
  await expect.poll(() => page.evaluate(() => /** @type {any} */ (window).__gear.engine.pool.busy), { timeout: 60_000 }).toBe(false);
  await page.evaluate(() => /** @type {any} */ (window).__gear.engine.rest());
  step = "";
}

class Late extends Error {}

/**
 * @template T
 * @param {string} what
 * @param {Promise<T>} work
 * @param {number} [longest]
 * @returns {Promise<T>}  Rejected with `Late` where it takes longer.
 */
function inTime(what, work, longest = LONGEST) {
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;
  const late = new Promise((/** @type {(value: never) => void} */ _, reject) => {
    timer = setTimeout(() => reject(new Late(`not in time: ${what}${step && `; it waits for ${step}`}`)), longest);
  });
  return Promise.race([work, late]).finally(() => clearTimeout(timer));
}

/** What the page is at when it does not come home, said within ten seconds or not at all. @param {Page} page */
function situation(page) {
  const asked = page.evaluate(async () => {
    const frames = new Promise((resolve) => requestAnimationFrame(() => resolve(true)));
    const patience = new Promise((resolve) => setTimeout(() => resolve(false), 2000));
    const { engine } = /** @type {any} */ (window).__gear;
    const figures = [...document.querySelectorAll("main > :not([hidden]) gear-figure")].map((/** @type {any} */ figure) => {
      const { id, inSight, clientWidth, shown } = figure;
      return `${id}${inSight ? " in sight" : ""} ${clientWidth} ${shown === null ? "without a picture" : ""} ${figure.shadowRoot?.querySelector(".status")?.textContent ?? ""}`.trim();
    });
    return { hash: location.hash, visible: document.visibilityState, frames: await Promise.race([frames, patience]), busy: engine.pool.busy, replaced: engine.pool.replaced, figures };
  });
  return inTime("the page says what it is at", asked, 10_000).catch((/** @type {Error} */ error) => error.message);
}

test("rounds through lessons, languages and views leave nothing behind", async ({ page }) => {
  test.setTimeout(240_000);
  await open(page);
  const all = await threads(page);
  const go = (/** @type {string} */ hash) => page.evaluate((to) => void (location.hash = to), hash);
  const round = async () => {
    for (const lesson of ["hopf&step=1", "tongue"]) {
      await go(`#class&v=1&lesson=${lesson}`);
      await page.locator("main > [data-view=class] h2").first().waitFor();
    }
    for (const language of ["de", "en"]) {
      await go(`#story&v=1&language=${language}`);
      await page.locator(`html[lang=${language}]`).waitFor();
    }
    await go("#lab&v=1&preset=11c&omega=1.7");
    await settled(page, "lab-T");
  };
  /** @type {import("./memory.js").Held[]} */
  const looks = [];
  for (let look = 0; look < 2; look += 1) {
    for (let count = 0; count < 2; count += 1) await round();
    await goHome(page);
    looks.push(await held(all));
  }
  const [first, second] = looks;
  // The modules' memories only grow, to what the largest figure needs, and that may come in any round.
  expect(second.heap + second.buffers - first.heap - first.buffers).toBeLessThan(GROWTH);
  expect(second.nodes - first.nodes).toBeLessThan(NODES);
  expect(second.listeners - first.listeners).toBeLessThan(LISTENERS);
});

test.describe("with gears that move", () => {
  test.use({ moving: true });

  test(`${MINUTES} minutes of random use hold no more memory in the end than after warming up`, async ({ page }) => {
    test.setTimeout(MINUTES * 60_000 + 600_000);
    await open(page);
    const choose = random(5);
    // Every room and every lesson is kept once it has been entered, and the rest of a figure's sliders once their drawer has been opened,
    // which chance might do early or late.
    for (const place of [...PLACES, ...LESSONS.map((lesson) => `#class&v=1&lesson=${lesson}`), "#story&v=1"]) {
      await page.evaluate((hash) => void (location.hash = hash), place);
      await page.locator("main > [data-view]:not([hidden]) :is(h1, h2)").first().waitFor();
      await page.waitForTimeout(LOOK);
    }
    await expect.poll(() => page.locator("main > [data-view=story] gear-figure .panel").count()).toBe(await page.locator("main > [data-view=story] gear-figure").count());
    for (const open of [true, false]) await page.evaluate(setDrawers, open);
    const begin = performance.now();
    const until = async (/** @type {number} */ minutes) => {
      let count = 0;
      while (performance.now() - begin < minutes * 60_000) {
        // A wheel or a drag over what goes away in the same moment is answered by nobody; the page must go on all the same.
        await inTime("an action is over", act(page, choose), STUCK).catch((/** @type {Error} */ error) => {
          if (!(error instanceof Late)) throw error;
        });
        await inTime("the page answers", page.evaluate(() => true));
        count += 1;
      }
      return count;
    };
    const before = await until(Math.min(5, WARM * MINUTES));
    // Asked for anew each time: a worker may have been replaced meanwhile.
    const look = async () => {
      await inTime("the page comes home", goHome(page)).catch(async (/** @type {Error} */ error) => {
        throw new Error(`${error.message}: ${JSON.stringify(await situation(page))}`);
      });
      return inTime("memory is looked at", threads(page).then(held));
    };
    const warm = await look();
    await page.locator("#fig-1").evaluate((gears) => /** @type {any} */ (gears).play());
    const after = await until(MINUTES);
    const last = await look();
    const grown = Object.fromEntries(Object.entries(last).map(([name, value]) => [name, value - warm[/** @type {keyof typeof warm} */ (name)]]));
    test.info().annotations.push({ type: "memory", description: JSON.stringify({ actions: [before, after], warm, last, grown }) });
    process.stdout.write(`soak: ${before} and ${after} actions; ${JSON.stringify({ warm, grown })}\n`);
    expect(after).toBeGreaterThan(20 * MINUTES);
    expect(grown.heap + grown.buffers + grown.wasm).toBeLessThan(GROWTH);
  });
});
