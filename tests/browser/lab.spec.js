// The laboratory, by pointer, touch and keyboard: one operating point, and charts that follow it.

import { expect, test } from "./page.js";

/**
 * @typedef {import("@playwright/test").Page} Page
 * @typedef {import("../../www/state.js").State} State
 * @typedef {import("../../www/figure/gear-figure.js").GearFigure} GearFigure
 */

/** @param {Page} page @param {string} id */
const chart = (page, id) => page.locator(`#lab-${id}`);
/** @param {Page} page */
const sentence = (page) => page.locator(".lab .sentence");
/** @param {Page} page */
const flag = (page) => page.locator(".lab .flag");

/**
 * Opens the laboratory and waits for its first sentence.
 *
 * @param {Page} page
 * @param {string} [more]  What else the address says.
 */
async function enter(page, more = "&v=1&preset=11c") {
  await page.goto(`./?test#lab${more}`);
  await expect(sentence(page)).toContainText(/Rest|response|Ruhe|Antwort/, { timeout: 30_000 });
}

/** @param {Page} page @returns {Promise<State>} */
const stateOf = (page) => page.evaluate(() => /** @type {any} */ (window).__gear.store.state);

/**
 * The place of data on the page.
 *
 * @param {Page} page
 * @param {string} id
 * @param {number} x
 * @param {number} y
 */
async function at(page, id, x, y) {
  return chart(page, id).evaluate(
    (element, place) => {
      const canvas = element.shadowRoot?.querySelector("canvas");
      const frame = /** @type {GearFigure} */ (element).map()?.frames[0];
      if (!canvas || !frame) throw new Error("not drawn yet");
      const box = canvas.getBoundingClientRect();
      const { plot } = frame;
      return {
        x: box.left + plot.left + ((place.x - frame.x.low) / (frame.x.high - frame.x.low)) * (plot.right - plot.left),
        y: box.top + plot.bottom - ((place.y - frame.y.low) / (frame.y.high - frame.y.low)) * (plot.bottom - plot.top),
      };
    },
    { x, y },
  );
}

/**
 * Facts of a chart's complete figure.
 *
 * @param {Page} page
 * @param {string} id
 */
const facts = (page, id) => chart(page, id).evaluate(async (element) => (await /** @type {GearFigure} */ (element).data()).facts);

test("it opens at the paper's point and says what is so there", async ({ page }) => {
  await enter(page);
  await expect(sentence(page)).toContainText("Rest is a saddle");
  await expect(sentence(page)).toContainText("settles on a stable orbit of period 2T, |up| up to 1.8515", { timeout: 20_000 });
  await expect(sentence(page)).toContainText("first-order theory says 3.", { timeout: 20_000 });
  await expect(flag(page)).toContainText("contact is not asked in this regime");
  for (const id of ["T", "B", "1", "U", "P", "M", "W"]) await expect(chart(page, id)).toBeVisible();
});

test("both charts on the left have a mesh frequency at the same pixel, and one cursor goes through them", async ({ page }) => {
  await page.setViewportSize({ width: 1440, height: 900 });
  await enter(page);
  await chart(page, "B").evaluate((element) => /** @type {GearFigure} */ (element).data());
  for (const omega of [1.65, 3.7, 5.4]) {
    await expect
      .poll(async () => Math.abs((await at(page, "T", omega, 0.5)).x - (await at(page, "B", omega, 1)).x))
      .toBeLessThan(0.75);
  }
  const line = await page.locator(".lab .cursor").boundingBox();
  expect(Math.abs((line?.x ?? 0) - (await at(page, "T", 1.65, 0)).x)).toBeLessThan(1.5);
});

test("the handle on the chart of tongues moves every chart, and one undo takes the drag back", async ({ page }) => {
  await page.setViewportSize({ width: 1440, height: 900 });
  await enter(page);
  // The two charts stand one above the other when both are there.
  await chart(page, "B").evaluate(async (element) => void (await /** @type {GearFigure} */ (element).data()));
  await expect.poll(async () => Math.abs((await at(page, "T", 2.6, 0.4)).x - (await at(page, "B", 2.6, 1)).x)).toBeLessThan(0.75);
  const [from, to] = [await at(page, "T", 1.65, 0.5), await at(page, "T", 2.6, 0.4)];
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move((from.x + to.x) / 2, (from.y + to.y) / 2, { steps: 6 });
  await page.mouse.move(to.x, to.y, { steps: 6 });
  await page.mouse.up();
  await expect.poll(async () => Number((await stateOf(page)).point.Omega)).toBeCloseTo(2.6, 1);
  expect(Number((await stateOf(page)).point.k0)).toBeCloseTo(0.4, 1);
  await expect(sentence(page)).toContainText("Rest is stable");
  await expect(sentence(page)).toContainText("comes to rest", { timeout: 15_000 });
  await page.evaluate(() => /** @type {any} */ (window).__gear.store.undo());
  await expect(sentence(page)).toContainText("Rest is a saddle");
});

test("the cursor is a slider for the keyboard", async ({ page }) => {
  await enter(page);
  const cursor = page.getByRole("slider", { name: "Mesh frequency Ω in both charts" });
  await cursor.focus();
  await page.keyboard.press("ArrowRight");
  expect(Number((await stateOf(page)).point.Omega)).toBeGreaterThan(1.65);
  await page.keyboard.press("PageDown");
  expect(Number((await stateOf(page)).point.Omega)).toBeLessThan(1.65);
  await page.keyboard.press("End");
  expect(Number((await stateOf(page)).point.Omega)).toBeGreaterThan(5);
  await expect(cursor).toHaveAttribute("aria-valuenow", String((await stateOf(page)).point.Omega));
});

test("a click on a branch shows that orbit, be it unstable", async ({ page }) => {
  await page.setViewportSize({ width: 1440, height: 900 });
  await enter(page);
  const orbits = await chart(page, "B").evaluate(async (element) => {
    const found = (await /** @type {GearFigure} */ (element).data()).orbits;
    if (found === null) throw new Error("no orbits");
    return { Omega: [...found.Omega], maxU_p: [...found.maxU_p], period: [...found.period], stable: [...found.stable] };
  });
  const row = orbits.Omega.findIndex((omega, index) => orbits.stable[index] === 0 && orbits.period[index] === 2 && orbits.maxU_p[index] > 2.1 && omega < 1.6);
  expect(row).toBeGreaterThan(0);
  const place = await at(page, "B", orbits.Omega[row], orbits.maxU_p[row]);
  await page.mouse.click(place.x, place.y);
  await expect(sentence(page)).toContainText("the start lies on an orbit of period 2T", { timeout: 15_000 });
  expect(Number((await facts(page, "U")).maxU_p)).toBeCloseTo(orbits.maxU_p[row], 1);
  const gears = await chart(page, "1").evaluate(async (element) => [...((await /** @type {GearFigure} */ (element).data()).motion?.u_p ?? [])]);
  expect(Math.max(...gears.map(Math.abs))).toBeCloseTo(orbits.maxU_p[row], 1);
});

test("by keyboard the motions over the cursor are taken one after the other", async ({ page }) => {
  await enter(page);
  await chart(page, "B").evaluate((element) => /** @type {GearFigure} */ (element).data());
  const sizes = [];
  for (let turn = 0; turn < 2; turn += 1) {
    await page.evaluate(() => /** @type {any} */ (window).__gear.actions.run("lab.orbit"));
    await expect(sentence(page)).toContainText(/the start lies on|comes to rest/, { timeout: 15_000 });
    sizes.push(Number((await facts(page, "U")).maxU_p));
  }
  expect(sizes[1]).toBeGreaterThan(sizes[0]);
});

test("a click on the map starts a motion there; the number boxes do the same", async ({ page }) => {
  await page.setViewportSize({ width: 1440, height: 900 });
  await enter(page);
  await facts(page, "P");
  const place = await at(page, "P", 0.6, 0.3);
  await page.mouse.click(place.x, place.y);
  await expect.poll(async () => Number((await stateOf(page)).point.u_p0)).toBeCloseTo(0.6, 1);
  const { point } = await stateOf(page);
  expect([point.u_g0, point.u_dot0, point.u0]).toEqual([-Number(point.u_p0), 0, 0]);
  const drawn = () => chart(page, "P").evaluate((element) => /** @type {GearFigure} */ (element).shown?.series.find(({ name }) => name === "start")?.columns.x[0]);
  await expect.poll(drawn).toBe(point.u_p0);

  await page.getByRole("button", { name: "More parameters" }).click();
  await page.getByRole("button", { name: /^start/ }).press("Enter");
  const box = page.getByRole("spinbutton").first();
  await box.fill("-0.25");
  await box.press("Enter");
  await expect.poll(async () => (await stateOf(page)).point.u_p0).toBe(-0.25);
  await expect.poll(drawn).toBe(-0.25);
  await page.getByRole("button", { name: "Start near rest" }).click();
  await expect.poll(async () => (await stateOf(page)).point.u_p0).toBe(undefined);
});

test("play lets the mesh frequency creep, the state carried over, until it is stopped", async ({ page }) => {
  await enter(page, "&v=1&preset=11c&omega=1.7");
  await page.getByRole("combobox", { name: "How fast Ω creeps" }).selectOption("slow");
  await page.locator(".lab .toolbar").getByRole("button", { name: "Play" }).click();
  await expect.poll(async () => Number((await stateOf(page)).point.Omega), { timeout: 20_000, intervals: [50] }).toBeLessThan(1.685);
  await page.locator(".lab .toolbar").getByRole("button", { name: "Stop" }).click();
  const stopped = await stateOf(page);
  expect(Math.abs(Number(stopped.point.u_p0))).toBeGreaterThan(0.05);
  await expect(page.locator(".lab .toolbar").getByRole("button", { name: "Play" })).toBeVisible();
  await expect(sentence(page)).toContainText("stable orbit of period 2T", { timeout: 15_000 });
  expect((await stateOf(page)).point.Omega).toBe(stopped.point.Omega);
  // The whole way is one action.
  await page.evaluate(() => /** @type {any} */ (window).__gear.store.undo());
  expect((await stateOf(page)).point.Omega).toBe(1.7);
});

test("presets are the paper's figures; contact lost is told in words and by a sign", async ({ page }) => {
  await enter(page);
  await page.getByRole("combobox", { name: "Preset" }).selectOption("14a");
  await expect(flag(page)).toContainText("✕ contact lost at t = ", { timeout: 15_000 });
  await page.getByRole("combobox", { name: "Preset" }).selectOption("14b");
  await expect(flag(page)).toContainText(/✓ contact kept, margin 1\.2/, { timeout: 15_000 });
  await page.getByRole("combobox", { name: "Preset" }).selectOption("12b");
  await expect(sentence(page)).toContainText("Rest is an unstable spiral", { timeout: 15_000 });
  expect((await stateOf(page)).point).toEqual({});
});

test("each parameter opens in place; what cannot be is said beside it", async ({ page }) => {
  await enter(page);
  const entry = page.getByRole("button", { name: /^F 0/ });
  await entry.press("Enter");
  const box = page.getByRole("spinbutton");
  await expect(page.getByRole("slider", { name: /^F, / })).toBeFocused();
  await box.fill("1.5");
  await box.press("Enter");
  await expect(page.locator(".lab .complaint").filter({ hasText: /F/ }).first()).toBeVisible();
  await expect(sentence(page)).toHaveClass(/wrong/);
  await page.getByRole("button", { name: /^regime/ }).click();
  await page.getByRole("combobox", { name: "regime" }).selectOption("backlash");
  await expect(sentence(page)).not.toHaveClass(/wrong/, { timeout: 15_000 });
  await expect(flag(page)).toContainText(/contact (kept|lost)/, { timeout: 15_000 });
  await page.keyboard.press("Escape");
  await expect(page.locator(".lab .drawer")).toBeHidden();
  await page.getByRole("button", { name: /^m 1/ }).click();
  const gear = page.locator('.lab .control[data-parameter="m_g"]').getByRole("spinbutton");
  await gear.fill("1.5");
  await gear.press("Enter");
  await expect(page.getByRole("button", { name: /^m 1 \| 1\.5/ })).toBeVisible();
});

test("a gear pair in SI units goes in, and speeds and torques come out", async ({ page }) => {
  await enter(page);
  await page.getByRole("button", { name: "Gear pair in SI units" }).click();
  await page.getByRole("button", { name: "Take over" }).click();
  await expect.poll(async () => Number((await stateOf(page)).point.Omega)).toBeCloseTo((2 * Math.PI * 25 * 6300) / 60 / 1e4, 9);
  const { point } = await stateOf(page);
  expect(point.regime).toBe("backlash");
  expect(Number(point.F)).toBeCloseTo(1.5, 9);
  const pair = page.locator(".lab .pair");
  await expect(pair).toContainText(/the pinion turns at 6300 and the gear at 393[78] revolutions a minute, under a torque of 750 N m/);
  await expect(pair).toContainText(/second mode5\d{3} to 6\d{3} revolutions a minute/);
  await expect(pair).toContainText(/The least torque on the pinion .* N m|no torque keeps/, { timeout: 40_000 });
  const cursor = page.getByRole("slider", { name: "Mesh frequency Ω in both charts" });
  await cursor.focus();
  await page.keyboard.press("PageUp");
  const omega = Number((await stateOf(page)).point.Omega);
  await expect.poll(async () => Number(await page.getByLabel("speed of the pinion").inputValue())).toBeCloseTo((omega * 1e4 * 60) / (2 * Math.PI * 25), -1);
  await page.getByLabel("half the backlash").fill("thin");
  await page.getByRole("button", { name: "Take over" }).click();
  await expect(pair.getByRole("alert")).toContainText("half the backlash must be a number");
});

test("two states can be pinned, compared and gone back to", async ({ page }) => {
  await enter(page);
  await page.getByRole("button", { name: "Pin this state" }).click();
  await page.getByRole("combobox", { name: "Preset" }).selectOption("14b");
  await page.getByRole("button", { name: "Pin this state" }).click();
  await page.getByRole("combobox", { name: "Preset" }).selectOption("12c");
  const compare = page.getByRole("region", { name: "Comparison" });
  await expect(compare.getByRole("columnheader")).toHaveText([/^A/, /^B/, "now"]);
  await expect(compare.getByRole("row", { name: /^Ω, mesh frequency/ }).getByRole("cell")).toHaveText(["1.65", "1.6", "3.75"]);
  await expect(compare.getByRole("row", { name: /^greatest \|u_p\|/ }).getByRole("cell").first()).toContainText("1.8515", { timeout: 20_000 });
  await expect(page.locator(".lab .pin-flag")).toHaveText(["A", "A", "B", "B"], { timeout: 20_000 });
  await compare.getByRole("button", { name: "Go there: A" }).click();
  await expect.poll(async () => (await stateOf(page)).preset).toBe("11c");
  await compare.getByRole("button", { name: "Unpin: B" }).click();
  await expect(compare.getByRole("columnheader")).toHaveText([/^A/, "now"]);
});

test("sound is off until it is asked for, and its volume can be set", async ({ page }) => {
  await enter(page);
  const sound = page.getByRole("button", { name: "Sound" });
  await expect(sound).toHaveAttribute("aria-pressed", "false");
  await expect(page.getByRole("slider", { name: "Volume" })).toBeHidden();
  await page.evaluate(() => {
    const made = window.AudioBufferSourceNode;
    /** @type {any} */ (window).heard = [];
    window.AudioBufferSourceNode = class extends made {
      /** @param {BaseAudioContext} context @param {AudioBufferSourceOptions} [options] */
      constructor(context, options) {
        super(context, options);
        /** @type {any} */ (window).heard.push(options?.buffer?.duration);
      }
    };
  });
  await facts(page, "1");
  await sound.click();
  await expect(sound).toHaveAttribute("aria-pressed", "true");
  // Eight mesh periods at 200 Hz for each unit of Omega.
  await expect.poll(() => page.evaluate(() => /** @type {any} */ (window).heard.at(-1))).toBeCloseTo(8 / (200 * 1.65), 3);
  await page.getByRole("slider", { name: "Volume" }).press("End");
  await sound.click();
  await expect(sound).toHaveAttribute("aria-pressed", "false");
});

test("a link reproduces the laboratory, and German is spoken throughout", async ({ page }) => {
  await enter(page, "&v=1&preset=14a&omega=1.62&u0=1.2&language=de");
  await expect(page.getByRole("group", { name: "Werkzeuge" }).getByRole("button", { name: "Abspielen" })).toBeVisible();
  await expect(flag(page)).toContainText(/Kontakt verloren/, { timeout: 15_000 });
  const { point } = await stateOf(page);
  expect(point).toEqual({ Omega: 1.62, u0: 1.2 });
});

test.describe("on a phone", () => {
  test.use({ viewport: { width: 360, height: 740 }, hasTouch: true, isMobile: true });

  test("one chart at a time, both numbers under the thumb, the sentence always in view", async ({ page }) => {
    await enter(page);
    await expect(chart(page, "T")).toBeVisible();
    await expect(chart(page, "P")).toBeHidden();
    await page.getByRole("button", { name: "Map", exact: true }).tap();
    await expect(chart(page, "P")).toBeVisible();
    await expect(chart(page, "T")).toBeHidden();
    const thumb = page.getByRole("group", { name: "Mesh frequency and depth of the pulsation" });
    const omega = thumb.getByRole("slider").first();
    await omega.focus();
    await page.keyboard.press("PageUp");
    await expect.poll(async () => Number((await stateOf(page)).point.Omega)).toBeGreaterThan(1.65);
    await expect(sentence(page)).toBeInViewport();
    await expect(omega).toBeInViewport();
    const width = await page.evaluate(() => document.documentElement.scrollWidth);
    expect(width).toBeLessThanOrEqual(360);
  });

  test("a touch on the map starts a motion there", async ({ page }) => {
    await enter(page);
    await page.getByRole("button", { name: "Map", exact: true }).tap();
    await facts(page, "P");
    await expect.poll(() => chart(page, "P").evaluate((element) => /** @type {GearFigure} */ (element).map() !== null)).toBe(true);
    const place = await at(page, "P", 0.5, -0.2);
    await page.touchscreen.tap(place.x, place.y);
    await expect.poll(async () => Number((await stateOf(page)).point.u_p0)).toBeCloseTo(0.5, 1);
  });
});
