// The canvas itself: sharp on any screen, and back when its context was lost.

import { stand } from "./chart.js";
import { expect, figure, open, settled, test } from "./page.js";

test("a screen of another density gets a picture as sharp as it can show", async ({ page }) => {
  await open(page);
  await stand(page, "2");
  const store = () => figure(page, "2").evaluate((element) => {
    const canvas = element.shadowRoot?.querySelector("canvas");
    return canvas ? canvas.width / canvas.clientWidth : 0;
  });
  expect(await store()).toBeCloseTo(2, 1);
  const client = await page.context().newCDPSession(page);
  const { width: wide, height } = page.viewportSize() ?? { width: 1280, height: 720 };
  await client.send("Emulation.setDeviceMetricsOverride", { width: wide, height, deviceScaleFactor: 3, mobile: false });
  await expect.poll(store).toBeCloseTo(3, 1);
});

test("a canvas whose context was lost is drawn again when it is back", async ({ page }) => {
  await open(page);
  await stand(page, "2");
  await settled(page, "2");
  const dark = () => figure(page, "2").evaluate((element) => {
    const canvas = element.shadowRoot?.querySelector("canvas");
    if (!canvas) return 0;
    const pixels = /** @type {any} */ (window).readPixels(canvas, [0, 0, canvas.width, canvas.height]);
    let count = 0;
    for (let index = 0; index < pixels.length; index += 4) count += pixels[index + 3] > 0 && pixels[index] < 128 ? 1 : 0;
    return count;
  });
  const before = await dark();
  expect(before).toBeGreaterThan(1000);
  // What losing a context does: everything is forgotten, then the event comes.
  await figure(page, "2").evaluate((element) => {
    const canvas = element.shadowRoot?.querySelector("canvas");
    if (!canvas) return;
    canvas.dispatchEvent(new Event("contextlost"));
    canvas.getContext("2d")?.reset();
  });
  await figure(page, "2").evaluate((element) => element.shadowRoot?.querySelector("canvas")?.dispatchEvent(new Event("contextrestored")));
  await expect.poll(dark).toBe(before);
});

test("what is in sight is drawn at two pixels a CSS pixel, what is left behind at one, and on the way back finely again", async ({ page }) => {
  await open(page);
  const fineness = (/** @type {string} */ id) =>
    page.locator(`#fig-${id}`).evaluate((element) => {
      const canvas = element.shadowRoot?.querySelector("canvas");
      return canvas ? Math.round((10 * canvas.width) / canvas.clientWidth) / 10 : 0;
    });
  expect(await page.evaluate(() => devicePixelRatio)).toBe(1);
  await expect.poll(() => fineness("T")).toBe(2);
  await expect.poll(() => fineness("4")).toBe(1);
  await page.locator("#fig-4").evaluate((element) => element.scrollIntoView({ block: "center" }));
  await expect.poll(() => fineness("4")).toBe(2);
  await expect.poll(() => fineness("T")).toBe(1);
  await page.evaluate(() => scrollTo({ top: 0 }));
  await expect.poll(() => fineness("T")).toBe(2);
});
