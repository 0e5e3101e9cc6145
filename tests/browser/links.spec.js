// Links: what cannot be applied is said and the rest shown; whatever stands after the `#`, there is always a page.

import { data, expect, figure, open, test } from "./page.js";
import { random } from "../node/random.mjs";

/** A machine with other work to do takes its time over a figure. */
const PATIENT = { timeout: 30_000 };

test("a link shows what it says, exactly, and nothing is complained of", async ({ page }) => {
  await open(page, "./?test#story&v=1&4.k=6.1&2.m=1.0123456789012345&theme=dark&omega=1.7");
  expect((await data(page, "4")).params.k_g).toBe(6.1);
  expect((await data(page, "2")).params.m_p).toBe(1.0123456789012345);
  expect((await data(page, "T")).params.Omega).toBe(1.7);
  await expect(page.locator("html")).toHaveAttribute("data-theme", "dark");
  await expect(page.locator(".link-notice")).toBeHidden();
});

test("a broken link says by name what it could not apply, shows the rest, and the message can be put away", async ({ page }) => {
  await open(page, "./?test#story&v=1&4.k=-7&4.m=2&omgea=2&regime=wet&k0=&v=2");
  const notice = page.locator(".link-notice");
  await expect(notice).toContainText("the rest is shown");
  await expect(notice).toContainText("“4.k” must be within 0.001 .. 1000000; -7 was given.");
  await expect(notice).toContainText("There is nothing called “omgea” here.");
  await expect(notice).toContainText("“regime” is one of homogeneous, contact, backlash; “wet” was given.");
  expect((await data(page, "4")).params).toMatchObject({ k_p: 5, m_p: 2 });
  await notice.getByRole("button", { name: "Dismiss" }).click();
  await expect(notice).toBeHidden();
});

test("a link of a newer version says so", async ({ page }) => {
  await page.goto("./?test#lab&v=9&k0=0.4");
  await expect(page.locator(".link-notice")).toContainText("The link is of version 9, and this page reads version 1.");
  await expect(page.locator('main > [data-view="lab"]')).toBeVisible();
});

test("another link is followed without loading anew, and its message goes with the next one", async ({ page }) => {
  await open(page);
  await page.evaluate(() => Object.assign(window, { same: true }));
  const follow = (/** @type {string} */ hash) => page.evaluate((to) => void (location.hash = to), hash);
  await follow("#story&4.k=6.4&nonsense=1");
  await expect.poll(async () => (await data(page, "4")).params.k_p, PATIENT).toBe(6.4);
  await expect(page.locator(".link-notice")).toContainText("nonsense");
  await follow("#story&4.k=6.5");
  await expect.poll(async () => (await data(page, "4")).params.k_p, PATIENT).toBe(6.5);
  await expect(page.locator(".link-notice")).toBeHidden();
  await page.goBack();
  await expect.poll(async () => (await data(page, "4")).params.k_p, PATIENT).toBe(6.4);
  expect(await page.evaluate(() => /** @type {any} */ (window).same)).toBe(true);
});

/** Addresses as people and programs break them. @param {number} seed @param {number} count */
function addresses(seed, count) {
  const choose = random(seed);
  const pieces = "story lab class & & & = = v=1 k0 omega 3. 11a. T.window.tongues 1..2,0..1 pin1. si.M_p preset=12a lesson=hopf lock= theme=dark language=en at=pulse % %F0 .. - 1e999 NaN <b> ' \" 0.4 ünï \u0000 fig-3 __proto__ constructor".split(" ");
  return Array.from({ length: count }, () => `#${Array.from({ length: choose.integer(0, 14) }, () => choose.of(pieces)).join("")}`);
}

test("10,000 addresses by hash change: no exception, always a page", async ({ page }) => {
  test.setTimeout(600_000);
  await open(page);
  for (let batch = 0; batch < 20; batch += 1) {
    await page.evaluate(async (hashes) => {
      for (const [index, hash] of hashes.entries()) {
        location.hash = hash;
        if (index % 25 === 0) await new Promise((resolve) => setTimeout(resolve));
      }
      await new Promise((resolve) => setTimeout(resolve));
    }, addresses(batch + 1, 500));
  }
  await page.evaluate(() => void (location.hash = "#story&4.k=6.2"));
  await expect.poll(async () => (await data(page, "4")).params.k_p, PATIENT).toBe(6.2);
  await expect(figure(page, "4").locator("canvas")).toBeVisible();
  await expect(page.locator(".link-notice")).toBeHidden();
});

test("50 addresses by full load: no exception, always a page", async ({ page }) => {
  test.setTimeout(240_000);
  for (const hash of addresses(99, 50)) {
    // Another address before the `#` loads anew.
    await page.goto(`./?${Math.random()}${hash}`);
    await expect(page.locator(".views")).toBeVisible();
    await expect.poll(() => page.evaluate(() => [...document.querySelectorAll("main > [data-view]")].filter((view) => !(/** @type {HTMLElement} */ (view).hidden)).length)).toBe(1);
  }
});
