// A control changes the right numbers; what will not do is named beside it, and the last good picture stays.

import { control, data, expect, figure, open, series, settled, test, valueAt } from "./page.js";

/** Half the width of the second mode's tongue, (56). @param {number} m @param {number} k */
function halfWidth(m, k) {
  // Squared frequencies of the modes with opposed bodies: m s^2 - (k + m + 2) s + k = 0; then c = 2 k - 2 m s.
  const half = (2 + k + m) / 2;
  const spread = Math.sqrt(half * half - k * m);
  const sigma = [(half - spread) / m, (half + spread) / m];
  const [c2, c3] = sigma.map((value) => 2 * k - 2 * m * value);
  return (Math.abs(c2) * Math.sqrt(sigma[0])) / (2 * (c2 - c3));
}

/** @param {import("./page.js").PlainFigure} shown */
const rightEdge = (shown) => series(shown, "Omega_R").columns.x[0];

test("the number box takes an exact value, also beyond the slider, and the numbers follow the formula", async ({ page }) => {
  await open(page);
  expect(rightEdge(await data(page, "2"))).toBeCloseTo(halfWidth(1, 5), 10);
  const { box, slider } = await control(page, "2", "k");
  await box.fill("3.14159");
  await box.press("Enter");
  expect(rightEdge(await data(page, "2"))).toBeCloseTo(halfWidth(1, 3.14159), 10);
  await box.fill("70");
  await box.press("Enter");
  expect(rightEdge(await data(page, "2"))).toBeCloseTo(halfWidth(1, 70), 10);
  await expect(box).toHaveValue("70");
  await expect(slider).toHaveAttribute("aria-valuetext", "70");
});

test("a slider moves by keys and takes its numbers along", async ({ page }) => {
  await open(page);
  const { box, slider } = await control(page, "3", "alpha");
  const at = 0.3;
  const radius = async () => valueAt(series(await data(page, "3"), "R_2,3 hardening (63)"), at);
  const before = await radius();
  await slider.focus();
  await slider.press("ArrowRight");
  await expect(box).not.toHaveValue("0.2");
  const alpha = Number(await box.inputValue());
  expect(alpha).toBeGreaterThan(0.2);
  // R goes as 1/sqrt(alpha).
  expect((await radius()) / before).toBeCloseTo(Math.sqrt(0.2 / alpha), 6);
  await slider.press("End");
  await expect(box).toHaveValue("2");
  expect((await radius()) / before).toBeCloseTo(Math.sqrt(0.1), 6);
  await figure(page, "3").getByRole("button", { name: "Reset" }).click();
  await expect(box).toHaveValue("0.2");
  expect(await radius()).toBeCloseTo(before, 12);
});

test("arrow keys step in the number box", async ({ page }) => {
  await open(page);
  const { box } = await control(page, "3", "zeta");
  await box.focus();
  await box.press("ArrowUp");
  await expect(box).toHaveValue("0.0201");
  await box.press("PageDown");
  await expect(box).toHaveValue("0.0191");
  expect((await data(page, "3")).params.zeta).toBe(0.0191);
});

test("bad input: a sentence beside the control, the picture kept, and mended again", async ({ page }) => {
  await open(page);
  const { box, complaint } = await control(page, "3", "k0");
  await settled(page, "3");
  const before = await figure(page, "3").evaluate(picture);
  await page.evaluate(() => {
    document.addEventListener("gear-error", (event) => Object.assign(window, { told: /** @type {CustomEvent} */ (event).detail }));
  });
  for (const [written, sentence] of [
    ["1.5", "*k*0 must lie from 0 to 1; 1.5 was given."],
    ["a lot", "*k*0 must be a number from 0 to 1; “a lot” is none."],
    ["", "*k*0 must be a number from 0 to 1; nothing was given."],
    ["1e999", "*k*0 must be a number from 0 to 1; “1e999” is none."],
  ]) {
    await page.evaluate(() => Object.assign(window, { told: null }));
    await box.fill(written);
    await box.press("Enter");
    await expect(complaint).toHaveText(sentence.replaceAll("*", ""));
    await expect(box).toHaveAttribute("aria-invalid", "true");
    expect(await page.evaluate(() => /** @type {any} */ (window).told)).toMatchObject({ parameter: "k0", allowed: [0, 1] });
    await settled(page, "3");
    expect(await figure(page, "3").evaluate(picture)).toBe(before);
    expect((await data(page, "3")).params.k0).toBe(0.5);
    for (const mended of [0.4, 0.5]) {
      await box.fill(String(mended));
      await box.press("Enter");
      await expect(complaint).toHaveText("");
      await expect(box).not.toHaveAttribute("aria-invalid");
      expect((await data(page, "3")).params.k0).toBe(mended);
    }
    await settled(page, "3");
  }
});

test("each box says its range where a screen reader finds it", async ({ page }) => {
  await open(page);
  const { box } = await control(page, "3", "k0");
  await expect(box).toHaveAccessibleDescription(/0 to 1/);
  await expect(box).toHaveAttribute("aria-valuemax", "1");
});

test("attributes give parameters in any letter case, and what is wrong with them is said", async ({ page }) => {
  await open(page);
  // What is in sight is computed first.
  await figure(page, "3").scrollIntoViewIfNeeded();
  await page.evaluate(() => {
    document.querySelector("#fig-3")?.setAttribute("K0", "0.25");
  });
  expect((await data(page, "3")).params.k0).toBe(0.25);
  await page.evaluate(() => {
    document.querySelector("#fig-3")?.setAttribute("omgea", "1");
    document.querySelector("#fig-3")?.setAttribute("zeta", "3");
  });
  const status = page.locator("#fig-3 .status");
  await expect(status).toContainText("There is no parameter “omgea”");
  await expect(status).toContainText("ζ must lie from 0 to 2; 3 was given.");
  expect((await data(page, "3")).params).toMatchObject({ k0: 0.25, zeta: 0.02 });
});

test("what was changed is told: gear-change with the full parameters", async ({ page }) => {
  await open(page);
  // Only what has been ready can change.
  await data(page, "4");
  const { box } = await control(page, "4", "m");
  const told = page.evaluate(
    () =>
      new Promise((resolve) => {
        document.addEventListener("gear-change", (event) => resolve(/** @type {CustomEvent} */ (event).detail), { once: true });
      }),
  );
  await box.fill("2");
  await box.press("Enter");
  expect(await told).toMatchObject({ figure: "4", params: { m_p: 2, m_g: 2, k_p: 5 } });
});

/** @param {Element} element */
function picture(element) {
  return element.shadowRoot?.querySelector("canvas")?.toDataURL() ?? "";
}
