// The way of the numbers: workers that die are replaced, what is overtaken is dropped, what is quick stays quick.

import { IDS, control, data, expect, figure, open, settled, test } from "./page.js";

/** @typedef {{__gear: {engine: import("../../www/engine/client.js").Engine}}} Tested */

for (const [manner, words] of /** @type {const} */ ([
  ["error", "by an error are replaced"],
  ["silence", "without a word are missed and replaced, the figure says so"],
])) {
  test(`workers that die ${words}, and the figure completes`, async ({ page }) => {
    test.slow();
    await open(page);
    await data(page, "12a");
    const { box } = await control(page, "12a", "zeta");
    await figure(page, "12a").evaluate((element) => {
      const status = element.shadowRoot?.querySelector(".status");
      if (!status) return;
      const words = (/** @type {any} */ (window).words = /** @type {string[]} */ ([]));
      new MutationObserver(() => words.push(status.textContent ?? "")).observe(status, { childList: true, characterData: true, subtree: true });
    });
    await page.evaluate((how) => /** @type {any} */ (window).__gear.engine.pool.kill(how), manner);
    await box.fill("0.021");
    await box.press("Enter");
    const shown = await data(page, "12a");
    expect(shown.params.zeta).toBe(0.021);
    expect(await page.evaluate(() => /** @type {any} */ (window).__gear.engine.pool.replaced)).toBeGreaterThan(0);
    if (manner === "silence") {
      const said = await page.evaluate(() => /** @type {any} */ (window).words);
      expect(said.join("\n")).toContain("another has taken over");
    }
    // The others answer as well.
    const other = await control(page, "2", "m");
    await other.box.fill("3");
    await other.box.press("Enter");
    expect((await data(page, "2")).params.m_p).toBe(3);
  });
}

test("a worker that dies in the middle of a computation is replaced, and the computation runs once more", async ({ page }) => {
  await open(page);
  await data(page, "12a");
  const outcome = await page.evaluate(async () => {
    const { engine } = /** @type {Tested} */ (/** @type {unknown} */ (window)).__gear;
    let restarted = 0;
    let killed = false;
    const figure = await engine.compute("12a", { zeta: 0.0205 }, {
      restarted: () => (restarted += 1),
      partial: () => {
        if (!killed) engine.pool.kill("error");
        killed = true;
      },
    });
    return { restarted, killed, zeta: figure.params.zeta };
  });
  expect(outcome).toEqual({ restarted: 1, killed: true, zeta: 0.0205 });
});

/** Has the page note in `ready` which figures have been completed. @param {import("@playwright/test").Page} page */
async function noteReady(page) {
  await page.addInitScript(() => {
    const ready = (/** @type {any} */ (window).ready = /** @type {string[]} */ ([]));
    addEventListener("gear-ready", (event) => ready.push(/** @type {CustomEvent} */ (event).detail.figure));
  });
}

test("what is far from the screen stops at its first picture until the reader comes near or somebody asks", async ({ page }) => {
  await noteReady(page);
  await open(page);
  const state = () =>
    page.evaluate(() => {
      const { engine } = /** @type {Tested} */ (/** @type {unknown} */ (window)).__gear;
      const pictured = [...document.querySelectorAll("gear-figure")].filter((one) => /** @type {any} */ (one).shown !== null).length;
      return { busy: engine.pool.busy, pictured, ready: /** @type {string[]} */ (/** @type {any} */ (window).ready) };
    });
  // Nothing is left to compute, and all have a picture.
  await expect.poll(async () => (({ busy, pictured }) => !busy && pictured)(await state())).toBe(IDS.length);
  const { ready } = await state();
  expect(ready).toContain("1");
  for (const far of ["10", "B", "S", "A"]) expect(ready).not.toContain(far);
  await expect(figure(page, "A").locator(".status")).not.toContainText("Computing");
  await page.locator("#fig-A").evaluate((element) => element.scrollIntoView({ block: "center" }));
  await expect.poll(async () => (await state()).ready, { timeout: 60_000 }).toContain("A");
  expect((await state()).ready).not.toContain("10");
  expect((await data(page, "10")).series.length).toBeGreaterThan(2);
  expect((await state()).ready).toContain("10");
});

test("whoever waits for a far figure has it although its parameters change meanwhile", async ({ page }) => {
  await open(page);
  const found = await figure(page, "S").evaluate(async (element) => {
    const { store } = /** @type {any} */ (window).__gear;
    const frame = () => new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
    await /** @type {any} */ (element).data();
    // What is asked for second waits until the first has its picture, and is then the one that is wanted.
    store.give(element.id, { zeta: 0.011 });
    await frame();
    store.give(element.id, { zeta: 0.012 });
    return (await /** @type {any} */ (element).data()).params.zeta;
  });
  expect(found).toBe(0.012);
});

test("whoever waits for a figure has the one that takes its place, and is told when it goes", async ({ page }) => {
  await open(page);
  const told = await page.evaluate(async () => {
    const element = /** @type {import("../../www/figure/gear-figure.js").GearFigure} */ (document.createElement("gear-figure"));
    element.setAttribute("figure", "S");
    document.querySelector("main")?.append(element);
    const frame = () => new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
    await frame();
    const asked = element.data();
    element.setAttribute("figure", "11a");
    const first = (await asked).id;
    element.setAttribute("omega", "1.6");
    await frame();
    const again = element.data().then(() => "an answer", (/** @type {Error} */ { message }) => message);
    element.remove();
    return [first, await again];
  });
  expect(told).toEqual(["11a", "the figure is not in a document"]);
});

test.describe("while nobody does anything", () => {
  test.use({ handsOn: false });

  test("all figures are completed, far as they are", async ({ page }) => {
    await noteReady(page);
    await open(page);
    await expect.poll(() => page.evaluate(() => /** @type {any} */ (window).ready.length), { timeout: 60_000 }).toBe(IDS.length);
    expect(await page.evaluate(() => scrollY)).toBe(0);
  });
});

test("a worker that dies with a figure held at its first picture holds it there again", async ({ page }) => {
  await open(page);
  const outcome = await page.evaluate(async () => {
    const { engine } = /** @type {Tested} */ (/** @type {unknown} */ (window)).__gear;
    let pictures = 0;
    let goOn = () => {};
    const held = new Promise((/** @type {(value: void) => void} */ resolve) => (goOn = resolve));
    const pictured = (/** @type {number} */ wanted) =>
      new Promise((resolve) => {
        const look = () => (pictures >= wanted ? resolve(null) : setTimeout(look, 10));
        look();
      });
    let done = false;
    const answer = engine.compute("9", { zeta: 0.021 }, { held, partial: () => (pictures += 1) });
    void answer.then(() => (done = true));
    await pictured(1);
    engine.pool.kill("error");
    await pictured(2);
    // As when the page is put away: what is held gives its memory back as well.
    engine.rest();
    await new Promise((resolve) => setTimeout(resolve, 300));
    const before = { pictures, done };
    goOn();
    return { before, zeta: (await answer).params.zeta };
  });
  expect(outcome).toEqual({ before: { pictures: 2, done: false }, zeta: 0.021 });
});

test("the newest of many wishes wins, and the figure stays with it", async ({ page }) => {
  await open(page);
  await data(page, "12a");
  const { box } = await control(page, "12a", "Omega");
  for (const value of ["3.66", "3.67", "3.68", "3.69", "3.71"]) {
    await box.fill(value);
    await box.press("Enter");
  }
  expect((await data(page, "12a")).params.Omega).toBe(3.71);
  await settled(page, "12a");
  expect((await data(page, "12a")).params.Omega).toBe(3.71);
});

test("an abandoned computation rejects at once and its late answer is dropped", async ({ page }) => {
  await open(page);
  await data(page, "13c");
  const outcome = await page.evaluate(async () => {
    const { engine } = /** @type {Tested} */ (/** @type {unknown} */ (window)).__gear;
    const abort = new AbortController();
    let shown = 0;
    // A formula is computed in one step: the cancellation comes too late for the worker, but not for us.
    const first = engine.compute("3", {}, { signal: abort.signal, partial: () => (shown += 1) }).then(
      () => "answered",
      (/** @type {Error} */ { name }) => name,
    );
    const before = engine.pool.dropped;
    abort.abort();
    const word = await first;
    await engine.compute("3", { k0: 0.3 });
    return { word, shown, dropped: engine.pool.dropped - before };
  });
  expect(outcome.word).toBe("AbortError");
  expect(outcome.shown).toBe(0);
  expect(outcome.dropped).toBeLessThanOrEqual(1);
});

test("formula figures answer while the step-by-step ones are being computed", async ({ page }) => {
  await open(page);
  const order = await page.evaluate(async () => {
    const { engine } = /** @type {Tested} */ (/** @type {unknown} */ (window)).__gear;
    /** @type {string[]} */
    const answered = [];
    const note = (/** @type {string} */ id) => () => answered.push(id);
    const heavy = ["12a", "12b"].map((id) => engine.compute(id, { zeta: 0.0201 }).then(note(id)));
    await engine.compute("2", { k: 4.9 }).then(note("2"));
    await Promise.all(heavy);
    return answered;
  });
  expect(order[0]).toBe("2");
});

test("stroboscopic maps fill in while they are computed", async ({ page }) => {
  await open(page);
  const lengths = await page.evaluate(async () => {
    const { engine } = /** @type {Tested} */ (/** @type {unknown} */ (window)).__gear;
    const points = (/** @type {import("./page.js").Figure} */ { series }) =>
      series.reduce((sum, { columns }) => sum + columns.x.length, 0);
    /** @type {number[]} */
    const seen = [];
    const whole = await engine.compute("12a", { zeta: 0.0199 }, { partial: (figure) => seen.push(points(figure)) });
    return [...seen, points(whole)];
  });
  expect(lengths.length).toBeGreaterThan(1);
  expect(lengths[0]).toBeLessThan(lengths[lengths.length - 1]);
});

test("the chart about the response to a load is computed by all workers, coarse first, and given up by all", async ({ page }) => {
  await open(page);
  const seen = await page.evaluate(async () => {
    const { engine } = /** @type {Tested} */ (/** @type {unknown} */ (window)).__gear;
    /** @type {[Worker, any][]} */
    const said = [];
    const say = Worker.prototype.postMessage;
    /** @this {Worker} @param {any} message @param {any} more */
    Worker.prototype.postMessage = function (message, more) {
      said.push([this, message]);
      return say.call(this, message, more);
    };
    const given = { k0: 0.4, Omega: 1.6, F: 1, alpha: -0.1, regime: "contact" };
    const values = (/** @type {import("./page.js").Figure} */ { series }) => /** @type {Float64Array} */ (series.find(({ mark }) => mark === "field")?.columns.z);
    /** @type {number[]} */
    const rough = [];
    const abort = new AbortController();
    const whole = values(await engine.compute("T", given, { partial: (figure) => rough.push(values(figure).length) }));
    const first = said.splice(0).filter(([, { type }]) => type === "run");
    const word = await engine.compute("T", { ...given, F: 1.01 }, { signal: abort.signal, partial: () => abort.abort() }).then(
      () => "answered",
      (/** @type {Error} */ { name }) => name,
    );
    const ended = new Set(said.filter(([, { type }]) => type === "cancel").map(([worker]) => worker)).size;
    Worker.prototype.postMessage = say;
    return {
      workers: new Set(first.map(([worker]) => worker)).size,
      parts: first.map(([, { part, parts }]) => [part, parts]),
      size: engine.pool.size,
      finite: whole.every(Number.isFinite),
      rough,
      length: whole.length,
      word,
      ended,
    };
  });
  expect(seen.size).toBeGreaterThan(1);
  expect(seen.workers).toBe(seen.size);
  expect(seen.parts).toEqual(Array.from({ length: seen.size }, (_, part) => [part, seen.size]));
  expect(seen.rough.length).toBeGreaterThan(0);
  expect(new Set(seen.rough)).toEqual(new Set([seen.length]));
  expect(seen.finite).toBe(true);
  expect(seen.word).toBe("AbortError");
  expect(seen.ended).toBe(seen.size);
});

/** Lets a page be as one whose tab is not shown: no frames come, and it is told so. Runs in the page, before all else. */
function canSleep() {
  /** @type {FrameRequestCallback[]} */
  const held = [];
  let asleep = false;
  const frame = window.requestAnimationFrame.bind(window);
  window.requestAnimationFrame = (callback) => (asleep ? -held.push(callback) : frame(callback));
  Object.defineProperty(document, "visibilityState", { get: () => (asleep ? "hidden" : "visible") });
  Object.defineProperty(document, "hidden", { get: () => asleep });
  Object.assign(window, {
    sleep: (/** @type {boolean} */ sleeps) => {
      asleep = sleeps;
      document.dispatchEvent(new Event("visibilitychange"));
      if (!asleep) for (const callback of held.splice(0)) frame(callback);
    },
  });
}

test.describe("with gears that move", () => {
  test.use({ moving: true });

  test("a page that was hidden in the middle of things goes on when it is shown again", async ({ page }) => {
    await page.addInitScript(canSleep);
    await open(page);
    await data(page, "12a");
    const { box } = await control(page, "12a", "zeta");
    const sleep = (/** @type {boolean} */ sleeps) => page.evaluate((value) => /** @type {any} */ (window).sleep(value), sleeps);
    await box.fill("0.0211");
    await box.press("Enter");
    await sleep(true);
    await box.fill("0.0213");
    await box.press("Enter");
    // Other things go on being computed meanwhile.
    await page.evaluate(() => /** @type {any} */ (window).__gear.engine.compute("12b", { zeta: 0.0204 }));
    await sleep(false);
    expect((await data(page, "12a")).params.zeta).toBe(0.0213);
    await settled(page, "12a");
    expect(await page.evaluate(() => /** @type {any} */ (window).__gear.engine.pool.replaced)).toBe(0);
    // And what moves moves on.
    await figure(page, "1").scrollIntoViewIfNeeded();
    await figure(page, "1").evaluate((element) => new Promise((resolve) => element.addEventListener("gear-paint", resolve, { once: true })));
  });
});

for (const [address, asked] of /** @type {const} */ ([["", [{}]], ["#v=1&Omega=1.65", [{ Omega: 1.65 }]]])) {
  test(`the first figure is asked for once${address && ", with what the address says"}`, async ({ page }) => {
    await page.addInitScript(() => {
      const runs = (/** @type {any} */ (window).runs = /** @type {any[]} */ ([]));
      const post = Worker.prototype.postMessage;
      Worker.prototype.postMessage = function (/** @type {any[]} */ ...all) {
        if (all[0]?.type === "run") runs.push({ id: all[0].id, given: all[0].given });
        return post.apply(this, /** @type {any} */ (all));
      };
    });
    await open(page, address);
    expect(await page.locator("gear-figure").first().getAttribute("figure")).toBe(await page.locator("html").getAttribute("data-first-figure"));
    const shown = await data(page, "1");
    const runs = await page.evaluate(() => /** @type {any} */ (window).runs.filter((/** @type {any} */ run) => run.id === "1"));
    expect(runs).toHaveLength(1);
    expect(runs[0].given).toEqual(expect.objectContaining(asked[0]));
    expect(shown.params.Omega).toBe(address === "" ? 1.6 : 1.65);
  });
}
