// The page in one file, and single figures in files of their own: opened from a disk, without any request.

import { readFileSync, statSync, writeFileSync } from "node:fs";
import { fileURLToPath, pathToFileURL } from "node:url";
import { test, expect } from "@playwright/test";
import { figure, marked, settled } from "./page.js";

/** @typedef {import("@playwright/test").Page} Page */

const FILE = fileURLToPath(new URL("../../dist/gear-bifurcations.html", import.meta.url));
const PAGE = pathToFileURL(FILE).href;
const POLICY =
  "default-src 'none'; script-src 'unsafe-inline' 'wasm-unsafe-eval' blob:; worker-src blob:; style-src 'unsafe-inline'; img-src data: blob:; font-src data:";

/**
 * Everything that a page says or asks for that it should not.
 *
 * @param {Page} page
 */
function listen(page) {
  /** @type {string[]} */
  const noise = [];
  page.on("console", (message) => noise.push(`console ${message.type()}: ${message.text()}`));
  page.on("pageerror", (error) => noise.push(`uncaught: ${error.message}`));
  page.on("request", (request) => {
    if (!/^(data|blob):/.test(request.url()) && !request.isNavigationRequest()) noise.push(`request: ${request.url()}`);
  });
  return noise;
}

test("the file is under 2 MB and forbids every request", () => {
  expect(statSync(FILE).size).toBeLessThan(2_000_000);
  expect(readFileSync(FILE, "utf8")).toContain(`<meta http-equiv="Content-Security-Policy" content="${POLICY}">`);
});

test("opened from a disk its figures live, in workers, and nothing is asked for", async ({ page }) => {
  const noise = listen(page);
  await page.goto(`${PAGE}?test`);
  await expect.poll(() => marked(page, "first-figure"), { timeout: 30_000 }).not.toBeNull();
  await settled(page, "11a");
  await settled(page, "B");
  expect(page.workers().length).toBeGreaterThan(1);
  const orbit = await figure(page, "11a").evaluate(async (element) => {
    const { params, series } = await /** @type {import("../../www/figure/gear-figure.js").GearFigure} */ (element).data();
    return [params.Omega, series.length];
  });
  expect(orbit[0]).toBe(1.55);
  expect(orbit[1]).toBeGreaterThan(2);
  expect(noise).toEqual([]);
});

test("its rooms and its other language are in it", async ({ page }) => {
  const noise = listen(page);
  for (const view of ["lab", "class"]) {
    await page.goto("about:blank");
    await page.goto(`${PAGE}#${view}&language=de`);
    await expect(page.locator("html")).toHaveAttribute("lang", "de");
    await expect(page.locator(`main > [data-view="${view}"] > *`).first()).toBeVisible();
  }
  expect(noise).toEqual([]);
});

test("without scripts its text and still drawings stand there", async ({ browser }) => {
  const context = await browser.newContext({ javaScriptEnabled: false });
  const page = await context.newPage();
  await page.goto(PAGE);
  await expect(page.getByRole("heading", { level: 1 })).toBeVisible();
  const picture = page.locator("#fig-2 img");
  await picture.scrollIntoViewIfNeeded();
  await expect(picture).toBeVisible();
  expect(await picture.evaluate((image) => /** @type {HTMLImageElement} */ (image).src.startsWith("data:image/svg+xml,"))).toBe(true);
  // The heaviest found no room: a sentence stands in their place, and no sign of a picture that is missing.
  for (const image of await page.locator("gear-figure img").all()) {
    await image.scrollIntoViewIfNeeded();
    await expect.poll(() => image.evaluate((it) => /** @type {HTMLImageElement} */ (it).naturalWidth)).toBe(720);
  }
  await context.close();
});

test("an engine that compiles slowly shows the first figure still before it lives; one that does not shows one picture", async ({ page }) => {
  const picture = page.locator("#fig-1 img");
  const source = () => picture.evaluate((image) => image.getAttribute("src"));
  await page.addInitScript(() => {
    const { compileStreaming } = WebAssembly;
    const slow = !location.search.includes("fast");
    WebAssembly.compileStreaming = async (response) => {
      const module = await compileStreaming.call(WebAssembly, response);
      if (slow) await new Promise((resolve) => addEventListener("go-on", resolve));
      return module;
    };
    // As an answer that came in time would.
    if (!slow) performance.mark("first-answer");
  });
  await page.goto(PAGE);
  await expect.poll(source).toContain("data:image/svg+xml,");
  await expect(picture).toBeVisible();
  expect(await page.locator("#fig-2 img").getAttribute("src")).toBeNull();
  expect(await marked(page, "first-figure")).toBeNull();
  await page.evaluate(() => dispatchEvent(new Event("go-on")));
  await expect.poll(() => marked(page, "first-figure"), { timeout: 30_000 }).not.toBeNull();
  await expect(picture).toBeHidden();

  await page.goto(`${PAGE}?fast`);
  await expect.poll(() => marked(page, "first-figure"), { timeout: 30_000 }).not.toBeNull();
  expect(await source()).toBeNull();

  // On a dark page a white picture would be a flash.
  await page.emulateMedia({ colorScheme: "dark" });
  await page.goto(`${PAGE}?dark`);
  await expect.poll(() => page.evaluate(() => performance.now())).toBeGreaterThan(1000);
  expect(await source()).toBeNull();
});

for (const home of ["the single file", "the site"]) {
  test(`a figure saved from ${home} is a live file of its own`, async ({ page, context, baseURL }, info) => {
    const site = home === "the site";
    // In the single file the modules have no addresses: the page hands its own to tests.
    await page.goto(site ? `${baseURL}?test` : `${PAGE}?test`);
    await expect.poll(() => marked(page, "first-figure"), { timeout: 30_000 }).not.toBeNull();
    const text = await page.evaluate(async () => {
      const { figureFile } = await /** @type {any} */ (window).__gear.saving();
      const saved = {
        figure: "11a",
        title: "A map & <more>",
        description: 'The "map"',
        svg: '<svg xmlns="http://www.w3.org/2000/svg" width="720" height="533"><title>Ω</title></svg>',
        given: { Omega: 1.6 },
      };
      return (await figureFile(saved)).text();
    });
    expect(text).not.toMatch(/\{\{[\w-]+\}\}/);
    expect(text).toContain(POLICY);
    expect(text.length).toBeLessThan(2_000_000);
    const saved = info.outputPath("figure.html");
    writeFileSync(saved, text);
    const file = await context.newPage();
    const noise = listen(file);
    await file.goto(pathToFileURL(saved).href);
    await expect(file.getByRole("heading", { name: "A map & <more>" })).toBeVisible();
    await expect.poll(() => marked(file, "first-figure"), { timeout: 30_000 }).not.toBeNull();
    const omega = await figure(file, "11a").evaluate(
      async (element) => (await /** @type {import("../../www/figure/gear-figure.js").GearFigure} */ (element).data()).params.Omega,
    );
    expect(omega).toBe(1.6);
    expect(noise).toEqual([]);
  });
}
