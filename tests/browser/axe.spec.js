// axe looks through the whole page, shadow roots too, in every theme.

import { AxeBuilder } from "@axe-core/playwright";
import { expect, figure, open, settled, test } from "./page.js";

/** @param {import("@playwright/test").Page} page */
async function faults(page) {
  const { violations } = await new AxeBuilder({ page }).analyze();
  return violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ target, failureSummary }) => `${target.join(" ")} ${failureSummary}`).join(" | ")}`);
}

for (const theme of ["light", "dark", "contrast"]) {
  test(`axe finds nothing on the page, theme ${theme}`, async ({ page }) => {
    test.slow();
    await open(page);
    await page.evaluate((chosen) => /** @type {any} */ (window).__gear.store.update({ theme: chosen }), theme);
    await figure(page, "2").locator(".panel").waitFor();
    await settled(page, "2");
    expect(await faults(page)).toEqual([]);
  });
}

test("axe finds nothing on the page with contrast preferred in the dark", async ({ page }) => {
  test.slow();
  await page.emulateMedia({ colorScheme: "dark", contrast: "more" });
  await open(page);
  await figure(page, "2").locator(".panel").waitFor();
  expect(await faults(page)).toEqual([]);
});

test("each chart is one thing with a name, a kind, a sentence and a table", async ({ page }) => {
  await open(page);
  for (const id of ["2", "3", "8", "11a", "14a"]) {
    const chart = figure(page, id).getByRole("application");
    await expect(chart).toHaveCount(1);
    await expect(chart).toHaveAccessibleName(/Figure \d+/);
    await expect(chart).toHaveAttribute("aria-roledescription", "chart");
    await settled(page, id);
    const sentence = await figure(page, id).evaluate(async (element) => (await /** @type {any} */ (element).data()).summary);
    const start = sentence.split(" ").find((/** @type {string} */ word) => /^[a-z]{4,}$/.test(word)) ?? "";
    await expect(chart).toHaveAccessibleDescription(new RegExp(start));
    await expect(chart).toHaveAccessibleDescription(/Arrow keys/);
    await expect(figure(page, id).getByText("In words and numbers")).toBeVisible();
  }
});
