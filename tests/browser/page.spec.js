// The page around the figures: complete, quiet, at home, and whole on any screen.

import { IDS, data, expect, figure, map, marked, open, test } from "./page.js";

test("every figure has its heading, its caption, its words for the ear and its static drawing", async ({ page }) => {
  await open(page);
  const found = await page.evaluate(() =>
    Promise.all(
      [...document.querySelectorAll("gear-figure")].map(async (element) => {
        const image = element.querySelector("img");
        const canvas = element.shadowRoot?.querySelector("canvas");
        const aspect = element.shadowRoot?.querySelector(".stage")?.getAttribute("style")?.match(/--aspect: ?([\d.]+)/)?.[1];
        return {
          id: element.id,
          role: canvas?.getAttribute("role"),
          label: canvas?.getAttribute("aria-label") ?? "",
          described: element.shadowRoot?.getElementById(canvas?.getAttribute("aria-describedby")?.split(" ")[0] ?? "")?.textContent ?? "",
          alt: image?.alt ?? "",
          drawing: await (await fetch(image?.src ?? "")).text(),
          ratio: Number(image?.getAttribute("width")) / Number(image?.getAttribute("height")),
          aspect: Number(aspect),
        };
      }),
    ),
  );
  expect(found.map(({ id }) => id)).toEqual(IDS.map((id) => `fig-${id}`));
  for (const { id, role, label, described, alt, drawing, ratio, aspect } of found) {
    expect(role, id).toBe("application");
    expect(label.length, id).toBeGreaterThan(10);
    expect(described.length, id).toBeGreaterThan(20);
    expect(alt.length, id).toBeGreaterThan(10);
    expect(drawing, id).toContain("<svg");
    // As wide over high as the live one, or the page would jump.
    expect(Math.abs(ratio / aspect - 1), id).toBeLessThan(0.005);
  }
  await expect(page.locator("figure > :is(h2, h3)")).toHaveCount(22);
  await expect(page.locator("figure:has(gear-figure) > figcaption")).toHaveCount(22);
});

test("the first live figure and all of them are marked", async ({ page }) => {
  await open(page);
  const [first, all] = [await marked(page, "first-figure"), await marked(page, "all-figures")];
  expect(first).toBeLessThan(/** @type {number} */ (all));
});

test("everything the page loads at first is asked for early", async ({ page }) => {
  await open(page);
  const late = await page.evaluate(() => {
    const early = new Set([...document.querySelectorAll("link[rel=modulepreload]")].map((link) => /** @type {HTMLLinkElement} */ (link).href));
    return performance
      .getEntriesByType("resource")
      .map(({ name }) => name)
      .filter((name) => name.endsWith(".js") && !early.has(name) && !/\/(worker|offline\/register)\.js$/.test(name));
  });
  expect(late).toEqual([]);
});

test("a figure's address leads to it", async ({ page }) => {
  await open(page, "./?test#fig-12a");
  await expect(page.locator("#fig-12a")).toBeInViewport();
});

for (const width of [320, 360, 768]) {
  test(`no sideways scrolling at ${width} px`, async ({ page }) => {
    await page.setViewportSize({ width, height: 740 });
    await open(page);
    await expect(page.locator("#fig-1 .panel")).toBeVisible();
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(width);
  });
}

test.describe("by touch", () => {
  test.use({ hasTouch: true, isMobile: true, viewport: { width: 360, height: 740 } });
  test("targets are large enough for a finger", async ({ page }) => {
    await open(page);
    await expect(page.locator("#fig-3 .panel")).toBeAttached();
    const small = await page.evaluate(() => {
      const found = [...document.querySelectorAll("gear-figure")].flatMap((element) =>
        [...(element.shadowRoot?.querySelectorAll("button, input, select, summary") ?? [])].map((target) => ({
          what: `${element.id} ${target.className || target.tagName}`,
          height: target.getBoundingClientRect().height,
        })),
      );
      // What is not shown at present has no height.
      return found.filter(({ height }) => height > 0 && height < 43.9).map(({ what }) => what);
    });
    expect(small).toEqual([]);
  });
});

test("panels a, b, c stand side by side where there is room", async ({ page }) => {
  await page.setViewportSize({ width: 1440, height: 900 });
  await open(page);
  // All at one moment: while figures above come alive, places move.
  const places = (/** @type {"x" | "y"} */ side) =>
    page.evaluate((axis) => {
      const found = ["11a", "11b", "11c"].map((id) => document.querySelector(`gear-figure[figure="${id}"]`)?.getBoundingClientRect()[axis]);
      return new Set(found.map((place) => Math.round(place ?? NaN))).size;
    }, side);
  await expect.poll(() => places("y")).toBe(1);
  await expect.poll(() => places("x")).toBe(3);
  await page.setViewportSize({ width: 500, height: 900 });
  await expect.poll(() => places("x")).toBe(1);
});

test("a theme is chosen in the settings, figures follow, and the choice is kept", async ({ page }) => {
  await page.emulateMedia({ colorScheme: "light" });
  await open(page);
  const ground = () =>
    figure(page, "2").evaluate((element) => {
      const canvas = element.shadowRoot?.querySelector("canvas");
      return [.../** @type {any} */ (window).readPixels(canvas, [2, 2, 1, 1])].slice(0, 3);
    });
  expect(await ground()).toEqual([255, 255, 255]);
  await page.getByRole("button", { name: "Settings" }).click();
  const settings = page.getByRole("dialog", { name: "Settings" });
  await settings.getByRole("radio", { name: "dark" }).check();
  await expect.poll(ground).toEqual([20, 23, 27]);
  await page.keyboard.press("Escape");
  await expect(settings).toBeHidden();
  await expect(page.getByRole("button", { name: "Settings" })).toBeFocused();
  await page.goto("./?test=again");
  await expect.poll(() => figure(page, "2").evaluate((element) => element.shadowRoot?.querySelector(".stage.live") !== null)).toBe(true);
  await expect.poll(ground).toEqual([20, 23, 27]);
  const same = await page.evaluate(() => getComputedStyle(document.documentElement).backgroundColor);
  expect(same).toBe("rgb(20, 23, 27)");
});

test("what is remembered and addressed is seen before the page's script has come; where it never comes there is the story", async ({ browser, baseURL }) => {
  // A context of its own: that a script does not come is said on its console.
  const context = await browser.newContext({ baseURL, serviceWorkers: "block" });
  const page = await context.newPage();
  await page.addInitScript(() => location.protocol === "http:" && localStorage.setItem("gear-bifurcations.preferences", JSON.stringify({ theme: "dark" })));
  /** @type {(() => void)[]} */
  const waiting = [];
  let comes = true;
  await page.route("**/www/main.js", async (route) => {
    await new Promise((resolve) => waiting.push(() => resolve(null)));
    await (comes ? route.continue() : route.abort());
  });
  const story = page.locator("main > [data-view=story]");
  const ground = () => page.evaluate(() => getComputedStyle(document.documentElement).backgroundColor);
  for (const [address, visible, colour] of /** @type {const} */ ([["#class", false, "rgb(20, 23, 27)"], ["#story", true, "rgb(20, 23, 27)"], ["#lab&v=1&theme=light", false, "rgb(255, 255, 255)"]])) {
    await page.goto("about:blank");
    await page.goto(`./?test${address}`, { waitUntil: "commit" });
    await page.locator("footer").waitFor({ state: "attached" });
    await expect(story).toBeVisible({ visible });
    expect(await ground()).toBe(colour);
    await expect.poll(() => waiting.length).toBeGreaterThan(0);
    if (address.startsWith("#lab")) comes = false;
    for (const go of waiting.splice(0)) go();
    if (comes) await expect(page.locator("main > [data-view]:visible")).toHaveCount(1);
  }
  await expect(story).toBeVisible();
  await context.close();
});

test.describe("with gears that move", () => {
  test.use({ moving: true });

  for (const [address, last, width] of /** @type {const} */ ([
    ["", "#fig-1 .panel", 1280],
    ["#lab", "#lab-W .stage.live", 1280],
    ["#class", "[data-view=class] button", 1280],
    ["#story&language=de", "#fig-1 .panel", 360],
    ["#lab&language=de", "#lab-T .stage.live", 360],
  ]))
    test(`nothing jumps while the page comes alive: ${address || "without an address"}`, async ({ page }) => {
      await page.setViewportSize({ width, height: 740 });
      await page.addInitScript(() => {
        Object.assign(window, { shift: 0 });
        new PerformanceObserver((list) => {
          for (const entry of list.getEntries()) /** @type {any} */ (window).shift += /** @type {any} */ (entry).value;
        }).observe({ type: "layout-shift", buffered: true });
      });
      if (address === "") await open(page);
      else await page.goto(`./?test${address}`);
      await expect(page.locator(last).first()).toBeVisible();
      expect(await page.evaluate(() => /** @type {any} */ (window).shift)).toBeLessThan(0.05);
    });

  test("gears that leave the page before they were to move do not move on unseen", async ({ page }) => {
    await page.addInitScript(() => {
      const ask = requestAnimationFrame.bind(window);
      Object.assign(window, { asked: 0, requestAnimationFrame: (/** @type {FrameRequestCallback} */ call) => ((/** @type {any} */ (window).asked += 1), ask(call)) });
      addEventListener("gear-paint", ({ target }) => target instanceof HTMLElement && target.id === "fig-1" && target.remove(), { capture: true });
    });
    await open(page);
    await expect(page.locator("#fig-2 .panel")).toBeAttached();
    const asked = () => page.evaluate(async () => {
      const before = /** @type {any} */ (window).asked;
      await new Promise((resolve) => setTimeout(resolve, 500));
      return /** @type {any} */ (window).asked - before;
    });
    await expect.poll(asked).toBeLessThan(5);
  });

  test("question, moving gears and the chart with its handle stand on the first screen, and the gears follow the handle", async ({ page }) => {
    await page.setViewportSize({ width: 1440, height: 900 });
    await open(page);
    await expect(page.getByRole("heading", { level: 1 })).toBeInViewport({ ratio: 1 });
    for (const id of ["1", "T"]) await expect(figure(page, id).locator("canvas")).toBeInViewport({ ratio: 1 });
    await expect.poll(async () => (await map(page, "T")).length).toBe(1);
    const [{ plot, x, y }] = await map(page, "T");
    const box = await figure(page, "T").locator("canvas").boundingBox();
    if (box === null) throw new Error("no canvas");
    const at = (/** @type {number} */ omega, /** @type {number} */ depth) => ({
      x: box.x + plot.left + ((omega - x.low) / (x.high - x.low)) * (plot.right - plot.left),
      y: box.y + plot.bottom - ((depth - y.low) / (y.high - y.low)) * (plot.bottom - plot.top),
    });
    const [from, to] = [at(1.6, 0.5), at(2.5, 0.3)];
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    await page.mouse.move(to.x, to.y, { steps: 8 });
    await page.mouse.up();
    const { Omega, k0 } = (await data(page, "1")).params;
    expect(Math.abs(Omega - 2.5)).toBeLessThan(0.02);
    expect(Math.abs(k0 - 0.3)).toBeLessThan(0.01);
    expect((await data(page, "T")).params).toMatchObject({ Omega, k0 });
    await expect.poll(() => page.evaluate(() => location.hash)).toBe(`#story&v=1&omega=${Omega}&k0=${k0}`);
  });
});

test("without scripts the static drawings and the whole text stand there", async ({ browser, baseURL }) => {
  const context = await browser.newContext({ javaScriptEnabled: false, baseURL });
  const page = await context.newPage();
  await page.goto("./");
  const picture = page.locator("#fig-2 img");
  await picture.scrollIntoViewIfNeeded();
  await expect(picture).toBeVisible();
  await expect(page.getByRole("heading", { level: 1 })).toBeVisible();
  await context.close();
});

test("in words and numbers: a table from the data", async ({ page }) => {
  await open(page);
  const home = figure(page, "14b");
  await home.scrollIntoViewIfNeeded();
  await home.locator(".data > summary").click();
  await expect(home.locator(".data table").first()).toBeVisible();
  expect(await home.locator(".data tr").count()).toBeGreaterThan(50);
  expect(await home.locator(".data tr").count()).toBeLessThan(500);
  await home.locator(".data > summary").click();
  await expect(home.locator(".data table")).toHaveCount(0);
});

for (const moves of [true, false]) {
  test(`while the engine is still on its way, what is below the screen comes near ${moves ? "when the reader moves" : "soon all the same"}`, async ({ page }) => {
    /** @type {(value?: void) => void} */
    let arrive = () => {};
    const arrived = new Promise((/** @type {(value?: void) => void} */ resolve) => (arrive = resolve));
    await page.route("**/*.wasm", async (route) => {
      await arrived;
      await route.abort();
    });
    if (moves) {
      // No time is up.
      await page.addInitScript(() => {
        const own = window.setTimeout;
        Object.assign(window, { setTimeout: (/** @type {() => void} */ work, /** @type {number} */ time) => (time >= 1000 ? 0 : own(work, time)) });
      });
    }
    await page.goto("./");
    const near = () => page.locator("#model").evaluate((section) => section.getBoundingClientRect().top < 3 * innerHeight);
    if (moves) {
      expect(await near()).toBe(false);
      await page.mouse.move(640, 360);
      await page.mouse.wheel(0, 400);
    }
    await expect.poll(near).toBe(true);
    arrive();
  });
}
