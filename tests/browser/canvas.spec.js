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
  expect(await store()).toBeCloseTo(1, 1);
  const client = await page.context().newCDPSession(page);
  const { width: wide, height } = page.viewportSize() ?? { width: 1280, height: 720 };
  // Between two whole numbers it has more than the screen.
  for (const [screen, drawn] of [[3, 3], [1.5, 2], [2, 2]]) {
    await client.send("Emulation.setDeviceMetricsOverride", { width: wide, height, deviceScaleFactor: screen, mobile: false });
    await expect.poll(store).toBeCloseTo(drawn, 1);
  }
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
