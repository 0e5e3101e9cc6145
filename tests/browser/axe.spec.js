// axe looks through the whole page, shadow roots too, in every theme.

import { AxeBuilder } from "@axe-core/playwright";
import { expect, figure, open, settled, test } from "./page.js";

/** @param {import("@playwright/test").Page} page */
async function faults(page) {
  // What is in order it need not describe, which takes a sixth of its time.
  const { violations } = await new AxeBuilder({ page }).options({ resultTypes: ["violations"] }).analyze();
  return violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ target, failureSummary }) => `${target.join(" ")} ${failureSummary}`).join(" | ")}`);
}

/** What each room has when all of it is there. */
const ROOMS = {
  story: (/** @type {import("@playwright/test").Page} */ page) => figure(page, "2").locator(".panel"),
  lab: (/** @type {import("@playwright/test").Page} */ page) => page.locator(".lab .sentence", { hasText: /\w/ }),
  class: (/** @type {import("@playwright/test").Page} */ page) => page.getByRole("heading", { name: "A pair at rest" }),
};

/** @param {import("@playwright/test").Page} page @param {string} rest  Of the address. */
async function checkRooms(page, rest) {
  for (const [room, there] of Object.entries(ROOMS)) {
    await page.evaluate((hash) => void (location.hash = hash), `#${room}&v=1${room === "class" ? "&lesson=tongue" : ""}${rest}`);
    await there(page).first().waitFor();
    expect(await faults(page), room).toEqual([]);
  }
}

for (const theme of ["light", "dark", "contrast"]) {
  test(`axe finds nothing in any room, theme ${theme}`, async ({ page }) => {
    test.slow();
    await open(page);
    await checkRooms(page, `&theme=${theme}`);
  });
}

test("axe finds nothing in any room before a projector", async ({ page }) => {
  test.slow();
  await open(page);
  await checkRooms(page, "&projector=on");
});

test("axe finds nothing with contrast preferred in the dark, nor in what opens over the page", async ({ page }) => {
  test.slow();
  await page.emulateMedia({ colorScheme: "dark", contrast: "more" });
  await open(page);
  for (const name of ["All actions", "Settings", "Help and keys"]) {
    await page.getByRole("button", { name, exact: true }).click();
    const dialog = page.getByRole("dialog");
    await dialog.waitFor();
    expect(await faults(page), name).toEqual([]);
    await page.keyboard.press("Escape");
    await dialog.waitFor({ state: "hidden" });
  }
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
