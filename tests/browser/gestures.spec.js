// A chart as something one handles: every gesture of pointer, fingers and keys, and what it must leave alone.

import { focus, frame, point, stand, state } from "./chart.js";
import { data, expect, figure, map, open, settled, test } from "./page.js";

/** @typedef {import("@playwright/test").Page} Page */

/** @param {{low: number, high: number}} range */
const width = ({ low, high }) => high - low;

test.describe("the wheel", () => {
  test("scrolls the page over a chart, and zooms nothing", async ({ page }) => {
    await open(page);
    const { at, own } = await stand(page, "2");
    const place = at(0.5, 0.5);
    await page.mouse.move(place.x, place.y);
    const before = await page.evaluate(() => scrollY);
    await page.mouse.wheel(0, 120);
    await expect.poll(() => page.evaluate(() => scrollY)).toBeGreaterThan(before + 50);
    expect((await frame(page, "2")).x).toEqual(own.x);
  });

  test("with Ctrl zooms about the pointer, and the page stays", async ({ page }) => {
    await open(page);
    const { at, own } = await stand(page, "2");
    const place = at(0.25, 0.6);
    const scrolled = await page.evaluate(() => scrollY);
    await page.mouse.move(place.x, place.y);
    await page.keyboard.down("Control");
    await page.mouse.wheel(0, -240);
    await page.keyboard.up("Control");
    await expect.poll(async () => width((await frame(page, "2")).x)).toBeLessThan(0.7 * width(own.x));
    const now = await frame(page, "2");
    const under = (/** @type {{low: number, high: number}} */ range, /** @type {number} */ part) => range.low + part * width(range);
    expect(Math.abs(under(now.x, 0.25) - under(own.x, 0.25))).toBeLessThan(0.01 * width(own.x));
    expect(Math.abs(under(now.y, 0.6) - under(own.y, 0.6))).toBeLessThan(0.01 * width(own.y));
    expect(await page.evaluate(() => scrollY)).toBe(scrolled);
  });
});

test.describe("the mouse", () => {
  test("draws a rectangle and zooms onto it; the button shows all again and goes", async ({ page }) => {
    await open(page);
    const { at, own } = await stand(page, "2");
    const all = figure(page, "2").getByRole("button", { name: "Show all" });
    await expect(all).toBeHidden();
    const [from, to] = [at(0.2, 0.3), at(0.6, 0.8)];
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    await page.mouse.move(to.x, to.y, { steps: 3 });
    await expect(figure(page, "2").locator(".band")).toBeVisible();
    await page.mouse.up();
    const now = await frame(page, "2");
    const part = (/** @type {{low: number, high: number}} */ range, /** @type {number} */ fraction) => range.low + fraction * width(range);
    for (const [got, wanted] of [[now.x.low, part(own.x, 0.2)], [now.x.high, part(own.x, 0.6)]]) {
      expect(Math.abs(got - wanted)).toBeLessThan(0.01 * width(own.x));
    }
    for (const [got, wanted] of [[now.y.low, part(own.y, 0.3)], [now.y.high, part(own.y, 0.8)]]) {
      expect(Math.abs(got - wanted)).toBeLessThan(0.01 * width(own.y));
    }
    await expect(figure(page, "2").locator(".band")).toBeHidden();
    expect(Object.keys((await state(page, "2")).windows)).toEqual([own.name]);
    await all.click();
    await expect(all).toBeHidden();
    expect((await frame(page, "2")).x).toEqual(own.x);
    expect((await state(page, "2")).windows).toEqual({});
  });

  test("draws a flat rectangle and zooms along one axis", async ({ page }) => {
    await open(page);
    const { at, own } = await stand(page, "2");
    const [from, to] = [at(0.2, 0.5), at(0.6, 0.5)];
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    await page.mouse.move(to.x, to.y + 3, { steps: 3 });
    await page.mouse.up();
    const now = await frame(page, "2");
    expect(width(now.x)).toBeLessThan(0.5 * width(own.x));
    expect(now.y.low).toBeCloseTo(own.y.low, 2);
    expect(now.y.high).toBeCloseTo(own.y.high, 2);
  });

  test("with Shift pans, and a double click shows all again", async ({ page }) => {
    await open(page);
    const { at, own } = await stand(page, "2");
    const [from, to] = [at(0.5, 0.5), at(0.7, 0.4)];
    await page.keyboard.down("Shift");
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    await page.mouse.move(to.x, to.y, { steps: 4 });
    await page.mouse.up();
    await page.keyboard.up("Shift");
    const now = await frame(page, "2");
    expect(width(now.x) / width(own.x)).toBeCloseTo(1, 2);
    expect((own.x.low - now.x.low) / width(own.x)).toBeCloseTo(0.2, 2);
    expect((now.y.low - own.y.low) / width(own.y)).toBeCloseTo(0.1, 2);
    await page.mouse.dblclick(from.x, from.y);
    expect((await frame(page, "2")).x).toEqual(own.x);
  });

  test("gives up a rectangle at Escape", async ({ page }) => {
    await open(page);
    const { at, own } = await stand(page, "2");
    const [from, to] = [at(0.2, 0.3), at(0.6, 0.8)];
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    await page.mouse.move(to.x, to.y, { steps: 2 });
    await page.keyboard.press("Escape");
    await page.mouse.up();
    expect((await frame(page, "2")).x).toEqual(own.x);
    await expect(figure(page, "2").locator(".band")).toBeHidden();
  });

  test("reads a computed point with the digits that are true", async ({ page }) => {
    await open(page);
    const { x, y } = await point(page, "2");
    const place = (await stand(page, "2")).of(x, y);
    await page.mouse.move(place.x, place.y);
    const readout = figure(page, "2").locator(".readout");
    await expect(readout).toContainText(/Ω1 = −?\d+\.\d{4,}/);
    await expect(figure(page, "2").locator(".dot")).toBeVisible();
  });
});

test("windows, undone and redone", async ({ page }) => {
  await open(page);
  const { own } = await stand(page, "2");
  await focus(page, "2");
  await page.keyboard.press("+");
  const near = await frame(page, "2");
  expect(width(near.x)).toBeLessThan(width(own.x));
  await page.evaluate(() => /** @type {any} */ (window).__gear.store.undo());
  expect((await frame(page, "2")).x).toEqual(own.x);
  await page.evaluate(() => /** @type {any} */ (window).__gear.store.redo());
  expect((await frame(page, "2")).x).toEqual(near.x);
});

test.describe("fingers", () => {
  test.use({ hasTouch: true });

  /**
   * Touches with as many fingers as there are places, along paths of places.
   *
   * @param {Page} page
   * @param {readonly {x: number, y: number}[][]} moments
   */
  async function touch(page, moments) {
    const client = await page.context().newCDPSession(page);
    const [first, ...rest] = moments;
    await client.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: [...first] });
    for (const touchPoints of rest) await client.send("Input.dispatchTouchEvent", { type: "touchMove", touchPoints: [...touchPoints] });
    await client.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
  }

  test("one scrolls the page, and zooms nothing", async ({ page }) => {
    await open(page);
    const { at, own } = await stand(page, "2");
    const { x, y } = at(0.5, 0.5);
    const before = await page.evaluate(() => scrollY);
    await touch(page, [0, -20, -60, -100, -140].map((by) => [{ x, y: y + by }]));
    await expect.poll(() => page.evaluate(() => scrollY)).toBeGreaterThan(before + 60);
    expect((await frame(page, "2")).x).toEqual(own.x);
  });

  test("two pinch and zoom about what is between them", async ({ page }) => {
    await open(page);
    const { at, own } = await stand(page, "2");
    const { x, y } = at(0.3, 0.5);
    const scrolled = await page.evaluate(() => scrollY);
    await touch(page, [30, 45, 60].map((apart) => [{ x: x - apart, y }, { x: x + apart, y }]));
    await expect.poll(async () => width((await frame(page, "2")).x) / width(own.x)).toBeCloseTo(0.5, 2);
    const now = await frame(page, "2");
    expect(Math.abs(now.x.low + 0.3 * width(now.x) - (own.x.low + 0.3 * width(own.x)))).toBeLessThan(0.01 * width(own.x));
    expect(await page.evaluate(() => scrollY)).toBe(scrolled);
  });

  test("two together pan", async ({ page }) => {
    await open(page);
    const { at, own } = await stand(page, "2");
    const { x, y } = at(0.5, 0.5);
    await touch(page, [0, 20, 40].map((by) => [{ x: x - 40 + by, y }, { x: x + 40 + by, y }]));
    const { plot } = own;
    await expect
      .poll(async () => ((own.x.low - (await frame(page, "2")).x.low) / width(own.x)) * (plot.right - plot.left))
      .toBeCloseTo(40, 0);
    expect(width((await frame(page, "2")).x) / width(own.x)).toBeCloseTo(1, 2);
  });

  test("buttons and legend are large enough for them", async ({ page }) => {
    await open(page);
    await stand(page, "2");
    for (const entry of await figure(page, "2").locator("button.entry").all()) {
      expect((await entry.boundingBox())?.height ?? 0).toBeGreaterThanOrEqual(24);
    }
  });
});

test.describe("keys", () => {
  test("plus, minus and 0 zoom and show all; Shift with arrows pans", async ({ page }) => {
    await open(page);
    const { own } = await stand(page, "2");
    await focus(page, "2");
    await page.keyboard.press("+");
    const near = await frame(page, "2");
    expect(width(near.x) / width(own.x)).toBeCloseTo(1 / 1.5, 2);
    await page.keyboard.press("Shift+ArrowRight");
    const right = await frame(page, "2");
    expect((right.x.low - near.x.low) / width(near.x)).toBeCloseTo(0.1, 2);
    await page.keyboard.press("Shift+ArrowUp");
    expect((await frame(page, "2")).y.low).toBeGreaterThan(right.y.low);
    await page.keyboard.press("-");
    expect(width((await frame(page, "2")).x) / width(own.x)).toBeCloseTo(1, 2);
    await page.keyboard.press("0");
    expect((await frame(page, "2")).x).toEqual(own.x);
  });

  test("arrows walk along the curves and say where they are; Escape leaves", async ({ page }) => {
    await open(page);
    await stand(page, "2");
    await focus(page, "2");
    const heard = figure(page, "2").locator("[aria-live]");
    const readout = figure(page, "2").locator(".readout");
    await page.keyboard.press("ArrowRight");
    await expect(heard).toContainText(/Ω1 = .*Point \d+ of \d+\./);
    const first = (await heard.textContent()) ?? "";
    await page.keyboard.press("ArrowRight");
    await expect(heard).not.toHaveText(first);
    const point = (/** @type {string} */ words) => Number(/Point (\d+)/.exec(words)?.[1]);
    expect(point((await heard.textContent()) ?? "")).toBe(point(first) + 1);
    await page.keyboard.press("ArrowLeft");
    await expect(heard).toHaveText(first);
    const meaning = (/** @type {string} */ words) => words.split(": ")[1]?.split(". Point")[0];
    await page.keyboard.press("ArrowUp");
    await expect(heard).not.toHaveText(first);
    expect(meaning((await heard.textContent()) ?? "")).not.toBe(meaning(first));
    await page.keyboard.press("Home");
    await expect(heard).toContainText("Point");
    await expect(figure(page, "2").locator(".dot")).toBeVisible();
    await page.keyboard.press("Escape");
    await expect(figure(page, "2").locator(".dot")).toBeHidden();
    await expect(readout).toHaveText("");
  });

  test("a view in space keeps its arrows until a walk is begun with Enter", async ({ page }) => {
    await open(page);
    await stand(page, "3");
    await focus(page, "3");
    const turned = async () => (await map(page, "3")).find(({ projection }) => projection !== null)?.projection;
    await settled(page, "3");
    await page.keyboard.press("Enter");
    await expect(figure(page, "3").locator("[aria-live]")).toContainText("Point");
    const before = await turned();
    await page.keyboard.press("ArrowRight");
    await settled(page, "3");
    expect(await turned()).toEqual(before);
    await page.keyboard.press("Escape");
    await page.keyboard.press("ArrowRight");
    await settled(page, "3");
    expect(await turned()).not.toEqual(before);
    // From where it is seen is part of the state: it can be undone, and a link holds it.
    expect((await state(page, "3")).view).not.toBeNull();
    await page.evaluate(() => /** @type {any} */ (window).__gear.store.undo());
    await settled(page, "3");
    expect(await turned()).toEqual(before);
  });

  test("Tab leads from chart to legend to buttons, and out again", async ({ page }) => {
    await open(page);
    await stand(page, "2");
    await focus(page, "2");
    await page.keyboard.press("Tab");
    await expect(figure(page, "2").locator("button.entry").first()).toBeFocused();
    await page.keyboard.press("Shift+Tab");
    await expect(figure(page, "2").getByRole("application")).toBeFocused();
  });
});

test("legend entries switch what they name, by pointer and by key, and the state holds it", async ({ page }) => {
  await open(page);
  await stand(page, "2");
  const legend = figure(page, "2").getByRole("group", { name: "What is shown" });
  const paper = legend.getByRole("button", { name: "paper" });
  await expect(paper).toHaveAttribute("aria-pressed", "true");
  const picture = () => figure(page, "2").evaluate((element) => element.shadowRoot?.querySelector("canvas")?.toDataURL() ?? "");
  await settled(page, "2");
  const before = await picture();
  await paper.click();
  await expect(paper).toHaveAttribute("aria-pressed", "false");
  expect((await state(page, "2")).hidden).toEqual(["paper"]);
  await settled(page, "2");
  expect(await picture()).not.toBe(before);
  await paper.focus();
  await page.keyboard.press("Space");
  await expect(paper).toHaveAttribute("aria-pressed", "true");
  expect((await state(page, "2")).hidden).toEqual([]);
});

test("charts over one quantity share a cursor, and others can set it", async ({ page }) => {
  await open(page);
  const { at, own } = await stand(page, "2");
  // Figure 4 has the same axis and is brought near enough to be drawn.
  const linked = figure(page, "4").locator(".linked");
  await page.evaluate(() => {
    const told = /** @type {object[]} */ ([]);
    Object.assign(window, { told });
    document.addEventListener("gear-cursor", (event) => told.push(/** @type {CustomEvent} */ (event).detail));
  });
  const place = at(0.5, 0.02);
  await page.mouse.move(place.x, place.y);
  await expect.poll(() => page.evaluate(() => /** @type {any} */ (window).told.length)).toBeGreaterThan(0);
  const [told] = await page.evaluate(() => /** @type {any} */ (window).told);
  expect(told.quantity).toBe("Omega_1");
  expect(Math.abs(told.value - (own.x.low + own.x.high) / 2)).toBeLessThan(0.02 * width(own.x));
  await page.mouse.move(1, 1);
  await expect.poll(() => page.evaluate(() => /** @type {any} */ (window).told.at(-1).value)).toBeNull();
  await stand(page, "4");
  await page.evaluate(() => document.dispatchEvent(new CustomEvent("gear-cursor", { detail: { quantity: "Omega_1", value: 0.05 } })));
  await expect(linked.first()).toBeVisible();
  await page.evaluate(() => document.dispatchEvent(new CustomEvent("gear-cursor", { detail: { quantity: "Omega_1", value: null } })));
  await expect(linked.first()).toBeHidden();
});

test("a handle is grasped where it is, and a drag beside it draws a rectangle", async ({ page }) => {
  await open(page);
  const shown = await data(page, "T");
  const handle = shown.series.find(({ role }) => role === "handle");
  if (handle === undefined) throw new Error("figure T has a handle");
  const { of, at, own } = await stand(page, "T");
  const from = of(handle.columns.x[0], handle.columns.y[0]);
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  const to = at(0.5, 0.5);
  await page.mouse.move(to.x, to.y, { steps: 4 });
  await page.mouse.up();
  const { params } = await data(page, "T");
  expect(Math.abs(params.Omega - (own.x.low + own.x.high) / 2)).toBeLessThan(0.02 * width(own.x));
  expect(Math.abs(params.k0 - (own.y.low + own.y.high) / 2)).toBeLessThan(0.02 * width(own.y));
  const [one, other] = [at(0.6, 0.6), at(0.8, 0.9)];
  await page.mouse.move(one.x, one.y);
  await page.mouse.down();
  await page.mouse.move(other.x, other.y, { steps: 3 });
  await page.mouse.up();
  expect(width((await frame(page, "T")).x) / width(own.x)).toBeCloseTo(0.2, 1);
  expect((await data(page, "T")).params.Omega).toBe(params.Omega);
});

test("a figure made of formulas is drawn in the very frame in which its parameters change", async ({ page }) => {
  await open(page);
  await stand(page, "2");
  let k0 = 0.3;
  await expect
    .poll(() =>
      figure(page, "2").evaluate((element, value) => {
        const canvas = element.shadowRoot?.querySelector("canvas");
        const before = canvas?.toDataURL();
        /** @type {any} */ (window).__gear.store.give("fig-2", { k0: value });
        // Asked for after the figure has asked: it comes after the figure in the same frame.
        return new Promise((resolve) => requestAnimationFrame(() => resolve(canvas?.toDataURL() !== before)));
      }, (k0 += 0.01)),
    )
    .toBe(true);
});

test("a click in a chart tells what was picked", async ({ page }) => {
  await open(page);
  const { curve, x: wanted, y } = await point(page, "2");
  // The listener stands before the click, and the place is asked anew while the page still comes to rest.
  await page.evaluate(() => {
    document.addEventListener("gear-pick", (event) => Object.assign(window, { picked: /** @type {CustomEvent} */ (event).detail }));
  });
  const picked = () => page.evaluate(() => /** @type {any} */ (window).picked ?? null);
  await expect(async () => {
    const place = (await stand(page, "2")).of(wanted, y);
    await page.mouse.click(place.x, place.y);
    await expect.poll(picked, { timeout: 2000 }).not.toBeNull();
  }).toPass();
  const { figure: id, frame: where, x, series } = await picked();
  expect(id).toBe("2");
  expect(where).toBe(curve.frame);
  expect(typeof series).toBe("string");
  expect(Math.abs(x - wanted)).toBeLessThan(0.02);
});

test.describe("with more contrast preferred", () => {
  test.use({ contextOptions: { contrast: "more" } });
  test("figures have the theme of more contrast, and a chosen theme counts more", async ({ page }) => {
    await open(page);
    await stand(page, "2");
    const legend = figure(page, "2").getByRole("group", { name: "What is shown" });
    const stroke = () => legend.getByRole("button", { name: "paper" }).locator("path").first().getAttribute("stroke");
    expect(await stroke()).toBe("#606367");
    await page.evaluate(() => /** @type {any} */ (window).__gear.store.update({ theme: "light" }));
    await expect.poll(stroke).toBe("#808489");
  });
});

test.describe("with forced colours", () => {
  test.use({ contextOptions: { forcedColors: "active" } });
  test("lines over the picture, entries and their pictures can be seen", async ({ page }) => {
    await open(page);
    const { at } = await stand(page, "2");
    const place = at(0.5, 0.5);
    await page.mouse.move(place.x, place.y);
    const upright = figure(page, "2").locator(".upright");
    await expect(upright).toBeVisible();
    await expect(upright).toHaveCSS("opacity", "1");
    await expect(figure(page, "2").locator(".swatch").first()).toHaveCSS("forced-color-adjust", "none");
  });
});
