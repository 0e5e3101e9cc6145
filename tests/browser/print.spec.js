// On paper: every figure in its present state, whether it had been seen or not.

import { test, expect } from "./page.js";

test.use({ moving: true });

test("printed as soon as it opens, the page has every figure drawn, in its present state, for white paper", async ({ page }) => {
  await page.goto("./?test#story&v=1&theme=dark&11a.omega=1.6&3.k0=0.4");
  await page.waitForFunction(() => performance.getEntriesByName("first-figure").length > 0);
  const figures = await page.evaluate(() => {
    dispatchEvent(new Event("beforeprint"));
    return [...document.querySelectorAll('main > [data-view="story"] gear-figure')].map((element) => {
      const canvas = element.shadowRoot?.querySelector("canvas");
      if (!canvas) throw new Error("no canvas");
      const small = Object.assign(document.createElement("canvas"), { width: 200, height: 120 });
      const context = small.getContext("2d", { willReadFrequently: true });
      context?.drawImage(canvas, 0, 0, 200, 120);
      const pixels = new Uint32Array(context?.getImageData(0, 0, 200, 120).data.buffer ?? new ArrayBuffer(0));
      return {
        id: element.getAttribute("figure"),
        white: pixels[0] === 0xffffffff,
        drawn: pixels.filter((pixel) => pixel !== 0xffffffff).length,
        words: element.shadowRoot?.querySelector(".printed")?.textContent ?? "",
      };
    });
  });
  expect(figures.length).toBeGreaterThan(25);
  for (const { id, white, drawn, words } of figures) {
    expect(white, `the ground of figure ${id}`).toBe(true);
    expect(drawn, `figure ${id}`).toBeGreaterThan(200);
    if (id === "11a") expect(words).toMatch(/^At Ω = 1\.6\./);
    else if (id === "3") expect(words).toMatch(/^At k0 = 0\.4\./);
    else expect(words).not.toMatch(/^At/);
  }
  await page.emulateMedia({ media: "print" });
  const seen = page.locator("#fig-11a .printed");
  await expect(seen).toBeVisible();
  for (const hidden of ["#fig-11a .bar", "#fig-11a .panel-place", "header .tools"]) await expect(page.locator(hidden).first()).toBeHidden();
  // Nothing is cut off at the edges of a sheet.
  await page.setViewportSize({ width: 627, height: 926 });
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(627);
  // Back on the screen all is as it was.
  await page.emulateMedia({ media: "screen" });
  await page.evaluate(() => dispatchEvent(new Event("afterprint")));
  await expect(seen).toBeHidden();
});
