// What stands around the three views: the switch, undo and the browser's history, palette, settings, help, language.

import { control, data, expect, figure, open, test } from "./page.js";

/** @typedef {import("@playwright/test").Page} Page */

/** A machine with other work to do takes its time over a figure. */
const PATIENT = { timeout: 30_000 };

/** @param {Page} page */
const hash = (page) => page.evaluate(() => location.hash);

/** @param {Page} page @param {string} id @param {string} parameter @param {string} value */
async function set(page, id, parameter, value) {
  const { box } = await control(page, id, parameter);
  await box.fill(value);
  await box.press("Enter");
}

test("three views of one state: switching loses neither the operating point nor the place", async ({ page }) => {
  await open(page);
  await set(page, "T", "k0", "0.35");
  await figure(page, "7").evaluate((element) => element.scrollIntoView());
  const read = await page.evaluate(() => scrollY);
  const views = page.getByRole("navigation", { name: "View" });
  await expect(views.getByRole("link", { name: "Story" })).toHaveAttribute("aria-current", "page");
  await views.getByRole("link", { name: "Lab" }).click();
  await expect(page.locator('main > [data-view="lab"]')).toBeVisible();
  await expect(views).toBeInViewport();
  await expect(figure(page, "7")).toBeHidden();
  await expect.poll(() => hash(page)).toBe("#lab&v=1&k0=0.35");
  await views.getByRole("link", { name: "Class" }).click();
  await expect(page.locator('main > [data-view="class"]')).toBeVisible();
  await expect(views.getByRole("link", { name: "Class" })).toHaveAttribute("aria-current", "page");
  await views.getByRole("link", { name: "Story" }).click();
  // The laboratory has a chart of tongues of its own.
  const shown = await page.locator("#fig-T").evaluate(async (element) => (await /** @type {any} */ (element).data()).params.k0);
  expect(shown).toBe(0.35);
  await expect(figure(page, "7")).toBeInViewport();
  expect(read).toBeGreaterThan(1000);
});

test("undo and redo, by keys, by buttons and by the browser's own", async ({ page }) => {
  await open(page);
  const [undo, redo] = [page.getByRole("button", { name: "Undo" }), page.getByRole("button", { name: "Redo" })];
  await expect(undo).toBeDisabled();
  await set(page, "4", "k", "6");
  await set(page, "4", "m", "2");
  await expect.poll(() => hash(page)).toBe("#story&v=1&4.k=6&4.m=2");
  await page.locator("h1").click();
  await page.keyboard.press("Control+Z");
  await expect.poll(() => hash(page)).toBe("#story&v=1&4.k=6");
  expect((await data(page, "4")).params).toMatchObject({ k_p: 6, m_p: 1 });
  await expect((await control(page, "4", "m")).box).toHaveValue("1");
  await expect(page.locator(".announcer")).toHaveText("Undone: change a parameter");
  await undo.click();
  await expect.poll(() => hash(page)).toBe("");
  await expect(undo).toBeDisabled();
  await redo.click();
  await page.keyboard.press("Control+Y");
  await expect.poll(() => hash(page)).toBe("#story&v=1&4.k=6&4.m=2");
  await expect(redo).toBeDisabled();
  await page.goBack();
  await expect.poll(async () => (await data(page, "4")).params.m_p, PATIENT).toBe(1);
  await expect(redo).toBeEnabled();
  await page.goForward();
  await expect.poll(async () => (await data(page, "4")).params.m_p, PATIENT).toBe(2);
});

test("a box keeps its own undo: what is typed there is not the page's to take back", async ({ page }) => {
  await open(page);
  await set(page, "4", "k", "6");
  const { box } = await control(page, "4", "k");
  await box.focus();
  await page.keyboard.type("?");
  await page.keyboard.press("Control+Z");
  expect((await data(page, "4")).params.k_p).toBe(6);
  await expect(page.getByRole("dialog")).toHaveCount(0);
});

test("dragging a slider is one action, in the page and in the browser's history", async ({ page }) => {
  await open(page);
  const { slider } = await control(page, "4", "k");
  const box = await slider.boundingBox();
  if (box === null) throw new Error("no slider");
  const before = await page.evaluate(() => history.length);
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + 0.9 * box.width, box.y + box.height / 2, { steps: 25 });
  await page.mouse.up();
  await expect.poll(() => hash(page)).toMatch(/^#story&v=1&4\.k=\d+/);
  expect(await page.evaluate(() => history.length)).toBe(before + 1);
  await page.goBack();
  await expect.poll(async () => (await data(page, "4")).params.k_p, PATIENT).toBe(5);
});

test("after a reload the address still shows the same, and back leads to what was before", async ({ page }) => {
  await open(page);
  await set(page, "4", "k", "6");
  await expect.poll(() => hash(page)).toBe("#story&v=1&4.k=6");
  await page.reload();
  await expect.poll(async () => (await data(page, "4")).params.k_p, PATIENT).toBe(6);
  await page.goBack();
  await expect.poll(async () => (await data(page, "4")).params.k_p, PATIENT).toBe(5);
});

test("the palette finds every action by a part of its name, and needs no pointer", async ({ page }) => {
  await open(page);
  await page.keyboard.press("Control+K");
  const palette = page.getByRole("dialog", { name: "All actions" });
  const box = palette.getByRole("combobox", { name: "Find an action" });
  await expect(box).toBeFocused();
  await expect(palette.getByRole("option", { name: "Help and keys" })).toContainText("?");
  await box.fill("figure 12 go");
  await expect(palette.getByRole("option")).toHaveCount(3);
  await box.press("ArrowDown");
  await expect(palette.getByRole("option", { selected: true })).toHaveText("Go to figure 12b");
  await box.fill("nothing like it");
  await expect(palette.getByText("There is no such action.")).toBeVisible();
  await box.fill("LABOR");
  await box.press("Enter");
  await expect(palette).toBeHidden();
  await expect.poll(() => hash(page)).toBe("#lab");
  await page.keyboard.press("Control+K");
  await box.fill("figure 13c start");
  await box.press("Enter");
  await expect.poll(() => hash(page)).toBe("#lab&v=1&preset=13c");
  await expect(page.getByRole("combobox", { name: "Preset" })).toHaveValue("13c");
});

test("what is typed while the palette is fetched is typed into it, and is no key of the page", async ({ page }) => {
  await open(page);
  /** @type {(value?: unknown) => void} */
  let bring = () => {};
  const brought = new Promise((resolve) => (bring = resolve));
  await page.route("**/shell/tools.js", async (route) => {
    await brought;
    await route.continue();
  });
  const theme = () => page.evaluate(() => document.documentElement.dataset.theme);
  const before = await theme();
  await page.keyboard.press("Control+K");
  await page.keyboard.type("tt");
  await page.keyboard.press("Backspace");
  await page.keyboard.press("Backspace");
  await page.keyboard.type("labor");
  await page.keyboard.press("Enter");
  expect(await theme()).toBe(before);
  bring();
  await expect.poll(() => hash(page)).toBe("#lab");
  await expect(page.getByRole("dialog")).toHaveCount(0);
  await page.keyboard.press("t");
  await expect.poll(theme).not.toBe(before);
});

test("every action runs from the palette without an error", async ({ page }) => {
  await open(page);
  const count = await page.evaluate(async () => {
    const { actions } = /** @type {any} */ (window).__gear;
    const ids = actions.all.map((/** @type {any} */ { id }) => id).filter((/** @type {string} */ id) => !["palette", "settings", "help"].includes(id));
    for (const id of ids) {
      actions.run(id);
      await new Promise((resolve) => requestAnimationFrame(resolve));
    }
    return ids.length;
  });
  expect(count).toBeGreaterThan(50);
});

test("help lists the keys, and single keys can be switched off, for good", async ({ page }) => {
  await open(page);
  await page.keyboard.press("?");
  const help = page.getByRole("dialog", { name: "Help and keys" });
  await expect(help.getByText("Ctrl + Shift + Z")).toBeVisible();
  await expect(help.getByText("can be switched off")).toBeVisible();
  await page.keyboard.press("Escape");
  await page.getByRole("button", { name: "Settings" }).click();
  await page.getByRole("checkbox", { name: "Shortcuts of a single key" }).uncheck();
  await page.getByRole("button", { name: "Close" }).click();
  await page.keyboard.press("2");
  await page.keyboard.press("?");
  await expect(page.getByRole("dialog")).toHaveCount(0);
  expect(await page.evaluate(() => document.documentElement.dataset.view)).toBe("story");
  await page.goto("./?test=again");
  await page.getByRole("button", { name: "Help and keys" }).click();
  await expect(help.getByText("are switched off")).toBeVisible();
});

test("German is complete on the page, is kept, and gives way to English again", async ({ page }) => {
  await open(page);
  const { heading } = await page.evaluate(() => ({ heading: document.querySelector("h1")?.innerHTML }));
  await page.getByRole("button", { name: "Settings" }).click();
  await page.getByRole("radio", { name: "Deutsch" }).click();
  await expect(page.locator("html")).toHaveAttribute("lang", "de");
  await expect(page.getByRole("heading", { level: 1 })).toHaveText(/^Warum/);
  await expect(page.getByRole("link", { name: "Geschichte" })).toBeVisible();
  await expect(page.getByRole("button", { name: "Rückgängig" })).toBeEnabled();
  await expect.poll(() => hash(page)).toBe("#story&v=1&language=de");
  // Numbers along axes too.
  const signs = await page.evaluate(async () => {
    const { engine } = /** @type {any} */ (window).__gear;
    const draw = engine.draw.bind(engine);
    /** @type {string[]} */
    const seen = [];
    engine.draw = (/** @type {any[]} */ ...given) => {
      seen.push(given[2].view.decimal);
      return draw(...given);
    };
    /** @type {any} */ (document.querySelector("#fig-T")).paint();
    engine.draw = draw;
    return seen;
  });
  expect(signs).toEqual([","]);
  await page.goto("./?test=again");
  await expect(page.getByRole("heading", { level: 1 })).toHaveText(/^Warum/);
  await page.getByRole("button", { name: "Einstellungen" }).click();
  await page.getByRole("radio", { name: "English" }).click();
  await expect(page.getByRole("heading", { level: 1 })).toHaveText(/^Why/);
  expect(await page.evaluate(() => document.querySelector("h1")?.innerHTML)).toBe(heading);
});

test("the projector mode shows keys and touches, in large type, and takes them away again", async ({ page }) => {
  await open(page);
  const size = () => page.evaluate(() => Number.parseFloat(getComputedStyle(document.documentElement).fontSize));
  const before = await size();
  await page.keyboard.press("p");
  await expect(page.locator(".shown-keys")).toBeAttached();
  expect(await size()).toBeGreaterThan(1.2 * before);
  await page.keyboard.down("ArrowDown");
  await expect(page.locator(".shown-keys kbd").last()).toHaveText("↓");
  await page.keyboard.up("ArrowDown");
  await page.mouse.move(200, 300);
  await page.mouse.down();
  await expect(page.locator(".shown-touch")).toBeVisible();
  await page.mouse.up();
  await expect(page.locator(".shown-touch")).toHaveCount(0);
  await expect(page.locator(".shown-keys kbd")).toHaveCount(0);
  await page.keyboard.press("p");
  await expect(page.locator(".shown-keys")).toHaveCount(0);
  expect(await size()).toBe(before);
});

test("a place in the story keeps what was changed, and back returns from it", async ({ page }) => {
  await open(page, "./?test#story&v=1&4.k=6");
  expect((await data(page, "4")).params.k_p).toBe(6);
  await page.keyboard.press("Control+K");
  await page.getByRole("combobox", { name: "Find an action" }).fill("Go to figure E");
  await page.keyboard.press("Enter");
  await expect(figure(page, "E")).toBeInViewport();
  await expect.poll(() => hash(page)).toBe("#story&v=1&at=fig-E&4.k=6");
  await page.goBack();
  await expect.poll(() => hash(page)).toBe("#story&v=1&4.k=6");
});

test("without storage all works, and nothing complains", async ({ page }) => {
  await page.addInitScript(() => {
    Object.defineProperty(window, "localStorage", {
      get() {
        throw new DOMException("forbidden", "SecurityError");
      },
    });
  });
  await open(page);
  await page.keyboard.press("s");
  await page.getByRole("radio", { name: "dark", exact: true }).check();
  await expect(page.locator("html")).toHaveAttribute("data-theme", "dark");
  await page.keyboard.press("Escape");
  await page.keyboard.press("Control+Z");
  await expect(page.locator("html")).toHaveAttribute("data-theme", "auto");
});

test("what is clicked before the engine runs stays, whatever the page was opened with", async ({ page }) => {
  /** @type {() => void} */
  let release = () => {};
  const held = new Promise((resolve) => (release = () => resolve(undefined)));
  await page.route("**/*.wasm", async (route) => {
    await held;
    await route.continue();
  });
  await page.goto("./?test#story&v=1&k0=0.4", { waitUntil: "commit" });
  await page.getByRole("link", { name: "Class", exact: true }).click();
  await expect(page.locator('main > [data-view="class"]')).toBeVisible();
  release();
  await page.waitForFunction(() => "__gear" in window);
  await expect(page.locator(".classroom h1")).toBeVisible();
  await expect.poll(() => hash(page)).toMatch(/^#class&v=1(&|$)/);
  expect(await page.evaluate(() => /** @type {any} */ (window).__gear.store.state.point)).toEqual({ k0: 0.4 });
});
