// What changes with the language: all of it, there and back.

import { expect, readable, test } from "./page.js";

for (const [what, place, ready] of /** @type {const} */ ([
  ["the laboratory with a pinned state", "lab&v=1&preset=14b&pin1.preset=14a", ".lab .compare canvas"],
  ["a lesson", "class&v=1&lesson=pitchfork&step=1", ".classroom .chart"],
  ["the list of lessons", "class&v=1", ".classroom .begin"],
])) {
  test(`a change of language leaves no word of the other one: ${what}`, async ({ page }) => {
    await page.goto(`./?test#${place}`);
    const shown = async () => {
      await page.locator(ready).first().waitFor();
      await page.locator("main > [data-view]:not([hidden])").evaluate(async (view) => {
        const charts = [...view.querySelectorAll("gear-figure")].filter(({ clientWidth }) => clientWidth > 0);
        for (const chart of charts) await /** @type {any} */ (chart).data();
        for (const chart of charts) await /** @type {any} */ (window).__gear.painted(chart);
      });
      return readable(page);
    };
    let before = await shown();
    expect(before.length).toBeGreaterThan(20);
    // There and back, for what is left behind by either.
    for (const language of ["de", "en"]) {
      await page.evaluate((to) => void (location.hash = to), `#${place}&language=${language}`);
      await page.locator(`html[lang=${language}]`).waitFor();
      await expect.poll(async () => (await shown()).filter((text) => before.includes(text))).toEqual([]);
      before = await shown();
    }
  });
}
