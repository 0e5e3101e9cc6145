// What is taken away from the page, by keyboard alone; and what is opened again.

import AxeBuilder from "@axe-core/playwright";
import { readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath, pathToFileURL } from "node:url";
import { marked, test, expect } from "./page.js";

/** @typedef {import("@playwright/test").Page} Page */
/** @typedef {import("@playwright/test").Locator} Locator */

const FILE = pathToFileURL(fileURLToPath(new URL("../../dist/gear-bifurcations.html", import.meta.url))).href;

/**
 * Opens a figure's menu and chooses an entry of it, by keys alone.
 *
 * @param {Page} page
 * @param {Locator} figure
 * @param {string} name
 */
async function choose(page, figure, name) {
  await figure.getByRole("button", { name: "Export" }).focus();
  await page.keyboard.press("Enter");
  const menu = figure.getByRole("menu");
  await expect(menu.getByRole("menuitem").first()).toBeFocused();
  const item = menu.getByRole("menuitem", { name, exact: true });
  for (let step = 0; step < 12 && !(await item.evaluate((one) => one.matches(":focus"))); step += 1) await page.keyboard.press("ArrowDown");
  await expect(item).toBeFocused();
  await page.keyboard.press("Enter");
  await expect(menu).toHaveCount(0);
}

/**
 * The file that comes of it.
 *
 * @param {Page} page
 * @param {() => Promise<void>} act
 */
async function fileOf(page, act) {
  const coming = page.waitForEvent("download");
  await act();
  const download = await coming;
  const path = await download.path();
  return { name: download.suggestedFilename(), bytes: readFileSync(path), text: readFileSync(path, "utf8") };
}

/** @param {Page} page */
const state = (page) => page.evaluate(() => JSON.stringify(/** @type {any} */ (window).__gear.store.state));

/**
 * Drops a file onto the page.
 *
 * @param {Page} page
 * @param {string} name
 * @param {string} text
 */
async function drop(page, name, text) {
  const data = await page.evaluateHandle(([file, content]) => {
    const transfer = new DataTransfer();
    transfer.items.add(new File([content], file));
    return transfer;
  }, [name, text]);
  await page.dispatchEvent("main", "drop", { dataTransfer: data });
}

test("from opening the page to a drawing on the disk, by keys alone", async ({ page }) => {
  await page.goto("./");
  // As a reader does who knows no shortcuts: on, until the menu of the first figure is reached.
  const focused = () => page.evaluate(() => {
    let at = document.activeElement;
    while (at?.shadowRoot?.activeElement) at = at.shadowRoot.activeElement;
    return at?.textContent ?? "";
  });
  await page.locator("#fig-1").getByRole("button", { name: "Export" }).waitFor();
  for (let step = 0; step < 80 && (await focused()) !== "Export"; step += 1) await page.keyboard.press("Tab");
  expect(await focused()).toBe("Export");
  await page.keyboard.press("Enter");
  await page.getByRole("menuitem", { name: "Copy a link to it" }).waitFor();
  await page.keyboard.press("d");
  await expect(page.getByRole("menuitem", { name: "Drawing for print (SVG)" })).toBeFocused();
  const { name, text } = await fileOf(page, () => page.keyboard.press("Enter"));
  expect(name).toBe("gear-bifurcations-1.svg");
  expect(text).toMatch(/^<svg [^>]*width="174mm"/);
  // The focus is where it was.
  await expect.poll(focused).toBe("Export");
  // And by name.
  await page.keyboard.press("Control+k");
  await page.getByRole("combobox").waitFor();
  await page.keyboard.type("drawing for print");
  const again = await fileOf(page, () => page.keyboard.press("Enter"));
  expect(again.name).toBe("gear-bifurcations-1.svg");
});

test("every entry of the menu gives what it says", async ({ page, context }) => {
  await context.grantPermissions(["clipboard-read", "clipboard-write"]);
  // One figure alone, which has the machine for itself.
  await page.goto("./embed.html#figure=2&k0=0.4");
  const figure = page.locator("gear-figure");
  const status = figure.locator(".status");
  const pasted = () => page.evaluate(() => navigator.clipboard.readText());

  await figure.getByRole("button", { name: "Export" }).click();
  await figure.getByRole("menu").waitFor();
  const { violations } = await new AxeBuilder({ page }).include("gear-figure").analyze();
  expect(violations.map(({ id }) => id)).toEqual([]);
  const heights = await figure.getByRole("menuitem").evaluateAll((items) => items.map((item) => item.getBoundingClientRect().height));
  expect(Math.min(...heights)).toBeGreaterThanOrEqual(24);
  await page.keyboard.press("Escape");
  await expect(figure.getByRole("button", { name: "Export" })).toBeFocused();

  await choose(page, figure, "Copy a link to it");
  await expect(status).toHaveText("The link is on the clipboard.");
  expect(await pasted()).toMatch(/\/#story&v=1&at=fig-2&2\.k0=0\.4$/);
  await choose(page, figure, "Copy lines for embedding");
  await expect(status).toHaveText("The lines are on the clipboard.");
  expect(await pasted()).toContain('<gear-figure figure="2" k0="0.4">');

  const width = await figure.locator("canvas").evaluate((canvas) => canvas.clientWidth);
  for (const density of [2, 4]) {
    const { name, bytes } = await fileOf(page, () => choose(page, figure, `Picture, ${density}× (PNG)`));
    expect(name).toBe(`gear-bifurcations-2@${density}x.png`);
    await expect(status).toContainText(name);
    expect(bytes.subarray(1, 4).toString()).toBe("PNG");
    expect(bytes.readUInt32BE(16)).toBe(width * density);
    expect(bytes.toString("latin1")).toContain("iTXtSource");
    // The browser can read it, and it is not empty.
    const colors = await page.evaluate(async (data) => {
      const image = Object.assign(new Image(), { src: `data:image/png;base64,${data}` });
      await image.decode();
      const canvas = Object.assign(document.createElement("canvas"), { width: image.width, height: image.height });
      const context = canvas.getContext("2d");
      context?.drawImage(image, 0, 0);
      return new Set(new Uint32Array(context?.getImageData(0, 0, image.width, image.height).data.buffer ?? new ArrayBuffer(0))).size;
    }, bytes.toString("base64"));
    expect(colors).toBeGreaterThan(20);
  }

  const svg = await fileOf(page, () => choose(page, figure, "Drawing for print (SVG)"));
  const read = await page.evaluate(async (text) => {
    const parsed = new DOMParser().parseFromString(text, "image/svg+xml");
    const image = Object.assign(new Image(), { src: `data:image/svg+xml,${encodeURIComponent(text)}` });
    await image.decode();
    return {
      wrong: parsed.querySelector("parsererror")?.textContent ?? null,
      facts: JSON.parse([...parsed.querySelectorAll("metadata *")].find(({ localName }) => localName === "figure")?.textContent ?? "null"),
      faces: text.match(/@font-face/g)?.length ?? 0,
    };
  }, svg.text);
  expect(read.wrong).toBeNull();
  expect(read.faces).toBeGreaterThanOrEqual(2);
  expect(read.facts).toMatchObject({ figure: "2", params: { k0: 0.4 }, method: expect.any(String), error: expect.any(Object), version: expect.stringMatching(/^\d/) });
  expect(read.facts.distances.length).toBeGreaterThan(0);

  const csv = await fileOf(page, () => choose(page, figure, "Numbers as a table (CSV)"));
  expect(csv.text).toMatch(/^# gear-bifurcations, figure 2: /);
  expect(csv.text).toContain("\nframe,series,role,stable,piece,x,y,z\ndeterminant,");
  const json = await fileOf(page, () => choose(page, figure, "Numbers and state (JSON)"));
  expect(JSON.parse(json.text)).toMatchObject({ format: "gear-bifurcations figure", data: { id: "2", params: { k0: 0.4 } } });
  const script = await fileOf(page, () => choose(page, figure, "Script for Node (MJS)"));
  expect(script.text).toContain('gear.figure("2", parameters)');
  const html = await fileOf(page, () => choose(page, figure, "Live figure in one file (HTML)"));
  expect(html.text).toContain('<meta name="source" content="http');
  expect(html.text).toContain('k0="0.4"');
});

test("a saved figure brings the page back to where it was, and a wrong file changes nothing", async ({ page }) => {
  // Listened for from the first: a dialog is caught only some time after that has been asked for.
  const chooser = page.waitForEvent("filechooser", { timeout: 110_000 });
  await page.goto("./?test#lab&v=1&preset=11c&omega=1.7&pin1.k0=0.3&theme=dark&lab-P.window.map=-4..4,-3..3");
  const figure = page.locator("#lab-U");
  await expect(figure.getByRole("button", { name: "Export" })).toBeVisible();
  const before = await state(page);
  const { name, text } = await fileOf(page, () => choose(page, figure, "Numbers and state (JSON)"));
  await expect(figure.locator(".status")).toContainText(name);

  await page.goto("about:blank");
  await page.goto("./?test#story&v=1&3.k0=0.2&theme=light");
  await page.waitForFunction(() => /** @type {any} */ (window).__gear !== undefined);
  const other = await state(page);
  const notice = page.locator(".link-notice");
  for (const [file, content, words] of [
    ["holiday.png", "\ufffdPNG\r\n", "is a picture"],
    ["half.json", text.slice(0, 300), "breaks off or is damaged"],
    ["other.json", '{"a": 1}', "is JSON, but not a figure that was saved here"],
    ["none.json", "", "is empty"],
  ]) {
    await drop(page, file, content);
    await expect(notice).toContainText(`“${file}” ${words}`);
    expect(await state(page)).toBe(other);
  }
  await drop(page, name, text);
  await expect(notice).toContainText("was opened");
  await expect(page.locator("#lab-U")).toBeVisible();
  expect(JSON.parse(await state(page))).toEqual(JSON.parse(before));
  await page.getByRole("button", { name: "Undo" }).click();
  expect(JSON.parse(await state(page))).toEqual(JSON.parse(other));

  // The same by a key and the browser's own dialog.
  await page.keyboard.press("Control+o");
  await (await chooser).setFiles({ name, mimeType: "application/json", buffer: Buffer.from(text) });
  await expect.poll(async () => JSON.parse(await state(page))).toEqual(JSON.parse(before));
});

test("in the single file figures are saved and opened as on the site, and nothing is asked for", async ({ browser }) => {
  const page = await browser.newPage();
  /** @type {string[]} */
  const noise = [];
  page.on("console", (message) => noise.push(message.text()));
  page.on("pageerror", (error) => noise.push(error.message));
  await page.goto(`${FILE}?test#story&v=1&2.k0=0.35`);
  const figure = page.locator("#fig-2");
  await figure.scrollIntoViewIfNeeded();
  const svg = await fileOf(page, () => choose(page, figure, "Drawing for print (SVG)"));
  expect(svg.text.match(/@font-face/g)?.length).toBeGreaterThanOrEqual(2);
  const { name, text } = await fileOf(page, () => choose(page, figure, "Numbers and state (JSON)"));
  const before = await state(page);
  await page.evaluate(() => {
    location.hash = "#lab";
  });
  await expect(page.locator("#lab-T")).toBeVisible();
  await drop(page, name, text);
  await expect.poll(() => state(page)).toBe(before);
  // A figure that was saved from here can be taken away in its turn.
  const html = await fileOf(page, () => choose(page, figure, "Live figure in one file (HTML)"));
  const path = test.info().outputPath(html.name);
  writeFileSync(path, html.text);
  await page.goto(pathToFileURL(path).href);
  await expect.poll(() => marked(page, "first-figure"), { timeout: 30_000 }).not.toBeNull();
  const alone = page.locator("#fig-2");
  await alone.getByRole("button", { name: "Export" }).waitFor();
  const csv = await fileOf(page, () => choose(page, alone, "Numbers as a table (CSV)"));
  expect(csv.text).toMatch(/^# parameters: .*k0 = 0\.35/m);
  expect(noise).toEqual([]);
  await page.close();
});

test("in a frame that may save nothing, the file's content is there to be kept by hand", async ({ browser, baseURL }) => {
  const page = await browser.newPage();
  await page.setContent(`<!doctype html><title>A host</title><iframe title="A figure" sandbox="allow-scripts allow-same-origin" style="width: 800px; height: 700px" src="${baseURL}embed.html#figure=2&k0=0.4"></iframe>`);
  const frame = page.frameLocator("iframe");
  const figure = frame.locator("gear-figure");
  await figure.getByRole("button", { name: "Export" }).waitFor();
  await choose(page, figure, "Numbers as a table (CSV)");
  const sheet = figure.getByRole("dialog", { name: "The file’s content" });
  await expect(sheet).toContainText("forbids it to save files");
  expect(await sheet.getByRole("textbox").inputValue()).toMatch(/^# gear-bifurcations, figure 2: [^]*\n# parameters: .*k0 = 0\.4/);
  await page.keyboard.press("Escape");
  await expect(sheet).toHaveCount(0);
  await choose(page, figure, "Copy a link to it");
  // A frame may be kept from the clipboard's interface, but not from what a reader's own key does.
  await expect(figure.locator(".status")).toHaveText("The link is on the clipboard.");
  await page.evaluate(() => document.body.prepend(document.createElement("textarea")));
  await page.locator("body > textarea").focus();
  await page.keyboard.press("Control+v");
  expect(await page.locator("body > textarea").inputValue()).toBe(`${baseURL}#story&v=1&at=fig-2&2.k0=0.4`);
  await page.close();
});

test("an open menu goes when the page goes elsewhere, and never two are open", async ({ page }) => {
  await page.goto("./?test#lab&v=1");
  await page.locator("#lab-T canvas").waitFor();
  await page.evaluate(() => void (location.hash = "#lab&v=1&Omega=1.7"));
  const menu = page.getByRole("menu");
  const opening = (/** @type {string} */ id) => page.locator(`#lab-${id}`).evaluate((figure) => /** @type {HTMLElement | null | undefined} */ (figure.shadowRoot?.querySelector("button.take"))?.click());
  await opening("T");
  await expect(menu).toHaveCount(1);
  await opening("U");
  await expect(page.locator("#lab-U").getByRole("menu")).toBeVisible();
  await expect(menu).toHaveCount(1);
  await page.goBack();
  await expect(menu).toHaveCount(0);
  // Nothing lies over the page any more.
  await page.getByRole("link", { name: "Story" }).click();
  await expect(page.getByRole("heading", { level: 1 }).first()).toBeVisible();
});
