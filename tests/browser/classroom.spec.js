// The classroom as a pupil and a teacher use it.

import { readFile } from "node:fs/promises";
import { expect, test } from "./page.js";

/** @param {import("@playwright/test").Page} page @param {string} hash */
async function enter(page, hash = "#class") {
  await page.goto(`./?test${hash}`);
  await expect(page.getByRole("heading", { level: 1 }).and(page.locator(".classroom h1"))).toBeVisible();
}

test("a lesson asks before it shows, says what is right, and goes on", async ({ page }) => {
  await enter(page);
  await page.getByRole("button", { name: "A tongue", exact: true }).click();
  await expect(page.getByRole("heading", { name: "A pair at rest" })).toBeVisible();
  await expect(page.getByRole("button", { name: "Next step" })).toBeDisabled();
  await expect(page.locator("#class-U")).toHaveCount(0);
  // The chart keeps to itself what is asked: beside the point, for the ear and for whoever asks by script what is shown.
  const present = () =>
    page.locator("#class-T").evaluate(async (element) => {
      const figure = /** @type {import("../../www/figure/gear-figure.js").GearFigure} */ (element);
      await figure.data();
      const said = figure.shadowRoot?.querySelector("#described")?.textContent ?? "";
      return { label: figure.shown?.series.find(({ role }) => role === "handle")?.label, told: /stable/.test(said) };
    });
  await expect.poll(present).toEqual({ label: null, told: false });
  await page.getByRole("button", { name: "Answer", exact: true }).click();
  await expect(page.getByRole("alert")).toHaveText("Choose one of them first.");
  await page.getByRole("radio", { name: "The vibration grows." }).check();
  await page.getByRole("button", { name: "Answer", exact: true }).click();
  await expect(page.locator(".verdict")).toContainText("Not so. It is: The vibration dies away.");
  await expect(page.locator(".reveal")).toContainText(/at most by the factor 0\.\d+/);
  await expect(page.locator("#class-U")).toBeVisible();
  await expect.poll(present).toEqual({ label: "stable", told: true });
  await page.getByRole("button", { name: "Next step" }).click();
  await expect(page.getByRole("heading", { name: "Another speed" })).toBeFocused();
  await page.getByRole("radio", { name: "The vibration grows." }).check();
  await page.getByRole("button", { name: "Answer", exact: true }).click();
  await expect(page.locator(".verdict")).toContainText("Right.");
  // Undone, the first step is there again with its answer.
  await page.keyboard.press("Control+z");
  await expect(page.getByRole("heading", { name: "A pair at rest" })).toBeVisible();
  await expect(page.locator(".verdict")).toContainText("Not so.");
});

test("a figure can be taken away once it keeps nothing to itself", async ({ page }) => {
  await enter(page, "#class&v=1&lesson=tongue");
  const exporting = page.locator("#class-T").getByRole("button", { name: "Export" });
  await expect(page.locator("#class-T").getByRole("button", { name: "Reset" })).toBeVisible();
  await expect(exporting).toHaveCount(0);
  await page.getByRole("radio", { name: "The vibration dies away." }).check();
  await page.getByRole("button", { name: "Answer", exact: true }).click();
  await exporting.click();
  const menu = page.getByRole("menu");
  await expect(menu.getByRole("menuitem", { name: /CSV/ })).toBeVisible();
  const download = page.waitForEvent("download");
  await menu.getByRole("menuitem", { name: /CSV/ }).click();
  const path = await (await download).path();
  expect(await readFile(path, "utf8")).toContain("k0");
});

test("by keyboard alone, from the list to a number answered", async ({ page }) => {
  await enter(page, "#class&v=1&lesson=tongue&step=2");
  const box = page.getByRole("textbox", { name: /By what factor|by what factor/ });
  await box.focus();
  await page.keyboard.type("about one");
  await page.keyboard.press("Enter");
  await expect(page.getByRole("alert")).toHaveText("Write a number first.");
  await box.fill("1.24");
  await page.keyboard.press("Enter");
  await expect(page.locator(".verdict")).toContainText("Right. Yours: 1.24; computed: 1.2404.".replace("1.2404", "1.24"));
});

test("a point is looked for until it is found", async ({ page }) => {
  await enter(page, "#class&v=1&lesson=tongue&step=3");
  const here = page.getByRole("button", { name: "It is here" });
  await here.click();
  await expect(page.getByRole("alert")).toContainText("Not there yet.");
  const omega = page.locator(".classroom .control").getByRole("spinbutton").first();
  await omega.fill("5.4");
  await omega.press("Enter");
  await here.click();
  await expect(page.locator(".verdict")).toContainText("Right.");
});

test("a link locks what it names", async ({ page }) => {
  await enter(page, "#class&v=1&zeta=0.05&lesson=tongue&step=4&lock=zeta");
  await expect(page.getByText("Locked for this lesson: zeta")).toBeVisible();
  await expect(page.locator(".classroom .control")).toHaveCount(0);
  await page.getByRole("button", { name: "I do not know" }).click();
  await expect(page.locator(".verdict")).toContainText("This is how it is.");
  const zeta = await page.evaluate(() => /** @type {any} */ (window).__gear.store.state.point.zeta);
  expect(zeta).toBe(0.05);
});

test("answers are saved as one file, and taken from it", async ({ page }) => {
  await enter(page, "#class&v=1&lesson=pitchfork&step=1");
  await page.getByRole("radio", { name: "One, which jumps between the points." }).check();
  await page.getByRole("button", { name: "Answer", exact: true }).click();
  await expect(page.locator(".verdict")).toContainText("Right.");
  const waiting = page.waitForEvent("download");
  await page.getByRole("button", { name: "Save answers" }).click();
  const download = await waiting;
  const saved = JSON.parse(await readFile(await download.path(), "utf8"));
  expect(saved.answers).toMatchObject([{ lesson: "pitchfork", step: 1, answer: 1, right: true }]);
  await page.goto("about:blank");
  await enter(page);
  await page.locator(".classroom input[type=file]").setInputFiles({ name: "answers.json", mimeType: "application/json", buffer: Buffer.from(JSON.stringify(saved)) });
  await expect(page.getByText("Answers taken from the file: 1.")).toBeVisible();
  await expect(page.getByText("Answered: 1, right: 1")).toBeVisible();
});

test("a teacher's own lesson is opened; one that is wrong is told by place", async ({ page }) => {
  await enter(page);
  const text = await readFile(new URL("../../docs/lessons.md", import.meta.url), "utf8");
  const [, lesson] = /```json\n([\s\S]*?)```/.exec(text) ?? [];
  const open = (/** @type {string} */ content) =>
    page.locator(".classroom input[type=file]").setInputFiles({ name: "mine.json", mimeType: "application/json", buffer: Buffer.from(content) });
  await open(lesson.replace('"choice"', '"guess"'));
  await expect(page.locator(".classroom .message")).toContainText('mine.json, steps[0].question.kind: "guess" will not do');
  await open(lesson);
  await expect(page.getByText("The lesson “Two speeds” is in the list now.")).toBeVisible();
  await page.getByRole("button", { name: "Two speeds" }).click();
  await page.getByRole("radio", { name: "No" }).check();
  await page.getByRole("button", { name: "Answer", exact: true }).click();
  await expect(page.locator(".verdict")).toContainText("Right.");
  await expect(page.locator(".reveal")).toContainText("The largest multiplier has the size 1.24.");
});

test("in German, the lesson is German and what was answered stays", async ({ page }) => {
  await enter(page, "#class&v=1&lesson=tongue&language=de");
  await expect(page.getByRole("heading", { name: "Ein Paar in Ruhe" })).toBeVisible();
  await page.getByRole("radio", { name: "Die Schwingung klingt ab." }).check();
  await page.getByRole("button", { name: "Antworten", exact: true }).click();
  await expect(page.locator(".verdict")).toContainText("Richtig.");
  await expect(page.locator(".reveal")).toContainText(/höchstens um den Faktor 0,\d+/);
});

test("a lesson that is not here is said", async ({ page }) => {
  await enter(page, "#class&v=1&lesson=alchemy");
  await expect(page.getByText("There is no lesson “alchemy” here.")).toBeVisible();
});
