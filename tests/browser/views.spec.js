// What moves: views in space by drag, keys and buttons; the gears of figure 1; the handle of figure 8.

import { data, expect, figure, map, open, settled, test } from "./page.js";

test.use({ moving: true });

/** @typedef {import("@playwright/test").Page} Page */

/** @param {Page} page */
async function projection(page) {
  await settled(page, "3");
  return (await map(page, "3")).find((frame) => frame.projection !== null);
}

/** @param {Page} page @param {string} id @returns {Promise<{x: number, y: number, width: number, height: number}>} */
async function box(page, id) {
  const found = await figure(page, id).locator("canvas").boundingBox();
  if (!found) throw new Error("no canvas");
  return found;
}

test("a drag turns the view in space, and Home turns it back", async ({ page }) => {
  await open(page);
  await figure(page, "3").locator("canvas").scrollIntoViewIfNeeded();
  const before = await projection(page);
  if (!before) throw new Error("figure 3 has a view in space");
  const { plot } = before;
  await page.evaluate(([top]) => {
    const canvas = document.querySelector("#fig-3")?.shadowRoot?.querySelector("canvas");
    scrollBy(0, (canvas?.getBoundingClientRect().top ?? 0) + top - 300);
  }, [plot.top]);
  const at = await box(page, "3");
  const middle = { x: at.x + (plot.left + plot.right) / 2, y: at.y + (plot.top + plot.bottom) / 2 };
  await page.mouse.move(middle.x, middle.y);
  await page.mouse.down();
  await page.mouse.move(middle.x + 60, middle.y + 25, { steps: 4 });
  await page.mouse.up();
  const turned = await projection(page);
  expect(turned?.projection).not.toEqual(before.projection);
  await figure(page, "3").locator("canvas").focus();
  await page.keyboard.press("Home");
  expect((await projection(page))?.projection).toEqual(before.projection);
});

test("arrow keys and buttons turn it as well", async ({ page }) => {
  await open(page);
  const before = await projection(page);
  await figure(page, "3").locator("canvas").focus();
  await page.keyboard.press("ArrowLeft");
  const left = await projection(page);
  expect(left?.projection).not.toEqual(before?.projection);
  await figure(page, "3").getByRole("button", { name: "Turn right" }).click();
  const back = await projection(page);
  for (const row of [0, 1]) {
    back?.projection?.[row].forEach((value, index) => expect(value).toBeCloseTo(before?.projection?.[row][index] ?? NaN, 6));
  }
  await page.keyboard.press("ArrowUp");
});

test("a vertical swipe over a view in space still scrolls the page", async ({ page }) => {
  await open(page);
  await expect(figure(page, "3").locator("canvas")).toHaveCSS("touch-action", "pan-y");
});

/** @param {Page} page */
const picture = (page) =>
  figure(page, "1").evaluate((element) => element.shadowRoot?.querySelector("canvas")?.toDataURL() ?? "");

test("figure 1 moves, pauses by button and by the space bar, and stands while out of sight", async ({ page }) => {
  await open(page);
  await figure(page, "1").scrollIntoViewIfNeeded();
  await settled(page, "1");
  const first = await picture(page);
  await expect.poll(() => picture(page)).not.toBe(first);
  await figure(page, "1").getByRole("button", { name: "Pause" }).click();
  await settled(page, "1");
  const still = await picture(page);
  await settled(page, "1");
  expect(await picture(page)).toBe(still);
  await figure(page, "1").locator("canvas").focus();
  await page.keyboard.press("Space");
  await expect.poll(() => picture(page)).not.toBe(still);
  await figure(page, "14b").scrollIntoViewIfNeeded();
  await expect
    .poll(async () => {
      const one = await picture(page);
      await page.waitForTimeout(200);
      return one === (await picture(page));
    })
    .toBe(true);
});

test.describe("with reduced motion", () => {
  test.use({ moving: false });

  test("figure 1 stands still until it is asked to move", async ({ page }) => {
    await open(page);
    await settled(page, "1");
    const first = await picture(page);
    await page.waitForTimeout(300);
    expect(await picture(page)).toBe(first);
    await figure(page, "1").getByRole("button", { name: "Play" }).click();
    await expect.poll(() => picture(page)).not.toBe(first);
  });
});

test("the handle of figure 8 sets Omega", async ({ page }) => {
  await open(page);
  const shown = await data(page, "8");
  const frame = shown.axes.find(({ x }) => x.name === "Omega");
  const found = (await map(page, "8")).find(({ name }) => name === frame?.frame);
  if (!found) throw new Error("figure 8 has a frame along Omega");
  await figure(page, "8").evaluate((element, top) => {
    const canvas = element.shadowRoot?.querySelector("canvas");
    scrollBy(0, (canvas?.getBoundingClientRect().top ?? 0) + top - 300);
  }, found.plot.top);
  const at = await box(page, "8");
  const y = at.y + (found.plot.top + found.plot.bottom) / 2;
  const x = (/** @type {number} */ part) => at.x + found.plot.left + part * (found.plot.right - found.plot.left);
  await page.mouse.move(x(0.3), y);
  await page.mouse.down();
  await page.mouse.move(x(0.5), y, { steps: 3 });
  await page.mouse.up();
  const expected = (found.x.low + found.x.high) / 2;
  expect(Math.abs((await data(page, "8")).params.Omega - expected)).toBeLessThan(0.02);
});

test("the pointer reads coordinates where it is", async ({ page }) => {
  await open(page);
  await figure(page, "2").locator("canvas").scrollIntoViewIfNeeded();
  const [{ plot }] = await map(page, "2");
  const at = await box(page, "2");
  await page.mouse.move(at.x + (plot.left + plot.right) / 2, at.y + (plot.top + plot.bottom) / 2);
  await expect(figure(page, "2").locator(".readout")).toContainText("Ω1 = 0.00");
  await page.mouse.move(2, 2);
  await expect(figure(page, "2").locator(".readout")).toHaveText("");
});
