// The story as a text: contents, equations, symbols, words, citations, in both languages, on any screen and on paper.

import { readFileSync } from "node:fs";
import { data, expect, figure, open, readable, test } from "./page.js";

/** @typedef {import("@playwright/test").Page} Page */

const GERMAN = "./?test#story&v=1&language=de";

test("the contents name every section, lead there, and say which one is being read", async ({ page }) => {
  await open(page);
  const contents = page.getByRole("navigation", { name: "Contents" });
  const entries = await contents.getByRole("link").evaluateAll((links) =>
    links.map((link) => ({ words: link.textContent, target: link.getAttribute("href")?.slice(1) })),
  );
  const sections = await page.locator("main section[id]").evaluateAll((all) =>
    all.map((section) => ({ words: section.querySelector("h2")?.textContent, target: section.id })),
  );
  expect(entries).toEqual(sections);
  expect(sections.length).toBe(14);
  await contents.getByRole("link", { name: "Two modes at once" }).click();
  await expect(page.locator("#hopf")).toBeFocused();
  await expect(page.locator("#hopf h2")).toBeInViewport();
  await expect(contents.locator('[aria-current="location"]')).toHaveText("Two modes at once");
  await expect(page).toHaveURL(/at=hopf/);
});

test("a place is gone to with everything else as it was", async ({ page }) => {
  await open(page, "./?test#story&v=1&k0=0.4");
  await page.getByRole("navigation", { name: "Contents" }).getByRole("link", { name: "Tongues", exact: true }).click();
  await expect(page).toHaveURL(/k0=0\.4/);
  await expect(page).toHaveURL(/at=tongues/);
});

for (const [place, width, height] of /** @type {const} */ ([["errata", 1440, 900], ["hopf", 360, 740]]))
  test(`a link leads to its place, and the place stays while what is above it is drawn: ${place}`, async ({ page }) => {
    await page.setViewportSize({ width, height });
    await page.goto(`./?test#story&v=1&at=${place}`);
    const target = page.locator(`#${place}`);
    // All that grows above it has grown: pictures have their legends and sliders.
    const growing = () => target.evaluate((element) => {
      const above = [...document.querySelectorAll("main gear-figure")].filter((figure) => figure.compareDocumentPosition(element) & Node.DOCUMENT_POSITION_FOLLOWING);
      return above.filter(({ shadowRoot }) => !shadowRoot?.querySelector(".panel")).length;
    });
    await expect.poll(growing, { timeout: 30_000 }).toBe(0);
    const top = () => target.evaluate((element) => element.getBoundingClientRect().top);
    await expect.poll(top).toBeLessThan(40);
    expect(await top()).toBeGreaterThan(-90);
    // Whoever goes on by themselves is not called back.
    await page.keyboard.press("End");
    await expect(page.locator("footer")).toBeInViewport();
    await page.locator("#fig-T").evaluate((figure) => /** @type {HTMLElement} */ (figure.parentElement).style.setProperty("margin-block-end", "50px"));
    await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));
    await expect(page.locator("footer")).toBeInViewport();
  });

test("the story rests while another view is shown, and comes back as it was, all of it", async ({ page }) => {
  await open(page);
  const sections = page.locator("main > [data-view='story'] > section");
  const resting = () => sections.evaluateAll((all) => all.filter((section) => !section.children[1].checkVisibility({ contentVisibilityAuto: true })).map(({ id }) => id));
  const far = () => page.locator("main > [data-view='story'] > section.far").count();
  const heights = () => sections.evaluateAll((all) => all.map((section) => Math.round(section.getBoundingClientRect().height)));
  await page.evaluate(() => Promise.all([...document.querySelectorAll("main gear-figure")].map((figure) => /** @type {any} */ (figure).data())));
  // Whoever takes a picture of the whole page finds nothing blank.
  expect(await resting()).toEqual([]);
  await page.getByRole("navigation", { name: "Contents" }).getByRole("link", { name: "What is printed, and what is so" }).click();
  await expect(page.locator("#errata h2")).toBeInViewport();
  // What is drawn and said last moves what is under it.
  const standing = async () => [await page.evaluate(() => scrollY), ...(await heights())].join();
  let last = "";
  await expect
    .poll(async () => {
      const [before, now] = [last, await standing()];
      last = now;
      return now === before;
    }, { intervals: [500] })
    .toBe(true);
  const [place, before] = [await page.evaluate(() => scrollY), await heights()];
  await page.keyboard.press("2");
  await expect(page.getByRole("heading", { level: 1, name: "The laboratory" })).toBeAttached();
  await expect.poll(far).toBeGreaterThan(9);
  await page.keyboard.press("1");
  await expect(page.locator("#errata h2")).toBeInViewport();
  expect(await page.evaluate(() => scrollY)).toBe(place);
  await expect.poll(far).toBe(0);
  expect(await resting()).toEqual([]);
  expect(await heights()).toEqual(before);
  expect(await page.evaluate(() => scrollY)).toBe(place);
});

test("headings come in order, none is left out", async ({ page }) => {
  await open(page);
  const levels = await page.locator("main > [data-view='story'] :is(h1, h2, h3, h4)").evaluateAll((all) =>
    all.map((heading) => Number(heading.tagName[1])),
  );
  expect(levels[0]).toBe(1);
  expect(levels.filter((level) => level === 1)).toHaveLength(1);
  levels.slice(1).forEach((level, index) => expect(level - levels[index]).toBeLessThanOrEqual(1));
});

test("every link within the page leads somewhere, every number of an equation to its row", async ({ page, request }) => {
  await open(page);
  const broken = await page.locator('main a[href^="#"]').evaluateAll((links) =>
    links.map((link) => link.getAttribute("href")?.slice(1) ?? "").filter((id) => document.getElementById(id) === null),
  );
  expect(broken).toEqual([]);
  const numbers = await page.locator("a.eq").evaluateAll((links) => links.map((link) => link.getAttribute("href") ?? ""));
  expect(numbers.length).toBeGreaterThan(25);
  const [address] = numbers[0].split("#");
  const table = await (await request.get(new URL(address, page.url()).href)).text();
  for (const number of numbers) {
    expect(number.startsWith(`${address}#`), number).toBe(true);
    expect(table, number).toContain(`id="${number.split("#")[1]}"`);
  }
});

test("the table of equations can be read on a phone, and leads back", async ({ page }) => {
  await page.setViewportSize({ width: 320, height: 700 });
  await page.goto("./docs/equations.html#eq-105");
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(320);
  await expect(page.locator("tr:has(#eq-105)")).toBeInViewport();
  await page.getByRole("link", { name: "gear-bifurcations" }).click();
  await expect(page.getByRole("heading", { level: 1 })).toContainText("gears");
});

test("equations are MathML, and each symbol that can be asked has a meaning", async ({ page }) => {
  await open(page);
  expect(await page.locator("math").count()).toBeGreaterThan(15);
  const said = await page.locator("gear-symbol, [data-symbol]").evaluateAll((all) =>
    all.map((symbol) => {
      symbol.dispatchEvent(new PointerEvent("pointerover", { bubbles: true, pointerType: "mouse" }));
      return { name: symbol.getAttribute("name") ?? symbol.getAttribute("data-symbol"), words: document.querySelector(".tip")?.textContent ?? "" };
    }),
  );
  expect(said.length).toBeGreaterThan(30);
  for (const { name, words } of said) {
    expect(words.trim().length, `${name}`).toBeGreaterThan(10);
    expect(words, `${name}`).not.toContain("symbol.");
  }
});

test("a symbol says its present value, also by keyboard, and Escape puts it away", async ({ page }) => {
  await open(page);
  const tip = page.getByRole("tooltip");
  await page.locator('#pulse a.term[href="#term-mesh-frequency"]').focus();
  await page.keyboard.press("Tab");
  const symbol = page.locator('#pulse gear-symbol[name="k0"]');
  await expect(symbol).toBeFocused();
  await expect(tip).toHaveText(/depth of the mesh stiffness.*at present 0\.5$/);
  await expect(symbol).toHaveAttribute("aria-describedby", (await tip.getAttribute("id")) ?? "");
  await page.keyboard.press("Escape");
  await expect(tip).toBeHidden();
  await page.evaluate(() => {
    const { store } = /** @type {any} */ (window).__gear;
    store.act("act.parameter", (/** @type {any} */ state) => ({ ...state, point: { ...state.point, k0: 0.25, k: 4 } }));
  });
  await symbol.hover();
  await expect(tip).toHaveText(/at present 0\.25$/);
  await page.locator('[data-symbol="omega_2"]').first().hover();
  // (44) with (43) at m = 1, k = 4: sigma = (7 - sqrt(49 - 16)) / 2.
  await expect(tip).toHaveText(new RegExp(`at present ${Math.sqrt((7 - Math.sqrt(33)) / 2).toFixed(5)}`));
});

test("words are explained where they come up, and stand in the glossary", async ({ page }) => {
  await open(page);
  const tip = page.getByRole("tooltip");
  const terms = await page.locator("a.term").evaluateAll((all) => all.map((one) => one.getAttribute("href")?.slice(1)));
  expect(new Set(terms).size).toBe(terms.length);
  expect(await page.locator("dfn[id]").evaluateAll((all) => all.map((one) => one.id))).toEqual(terms);
  await page.locator('a.term[href="#term-tongue"]').hover();
  await expect(tip).toContainText("rest is unstable");
  await page.locator('#pitchfork a.term[href="#term-supercritical"]').focus();
  await page.keyboard.press("Tab");
  await expect(page.locator('a.term[href="#term-pitchfork"]')).toBeFocused();
  await expect(tip).toContainText("mirror images");
  await page.keyboard.press("Enter");
  await expect(page.locator("#term-pitchfork")).toBeFocused();
  await expect(page.locator("#term-pitchfork")).toBeInViewport();
});

test.describe("by touch", () => {
  test.use({ hasTouch: true, isMobile: true, viewport: { width: 360, height: 740 } });
  test("the first touch explains a word, the second leads to the glossary", async ({ page }) => {
    await open(page);
    const term = page.locator('a.term[href="#term-tongue"]');
    await term.scrollIntoViewIfNeeded();
    await term.tap();
    const tip = page.getByRole("tooltip");
    await expect(tip).toBeVisible();
    const box = await tip.boundingBox();
    expect(box?.x).toBeGreaterThanOrEqual(0);
    expect((box?.x ?? 0) + (box?.width ?? 0)).toBeLessThanOrEqual(360);
    await term.tap();
    await expect(page.locator("#term-tongue")).toBeInViewport();
  });
});

test("a note leads to its line of figure E", async ({ page }) => {
  // Its last lines are integrated for hundreds of periods, after everything else on the page.
  test.slow();
  await open(page);
  await data(page, "E");
  const notes = await page.locator("aside.note a").evaluateAll((links) => links.map((link) => link.getAttribute("href")?.slice(1) ?? ""));
  expect(notes.length).toBeGreaterThan(20);
  const rows = await figure(page, "E").evaluate((element) =>
    [...(element.shadowRoot?.querySelectorAll("tbody tr") ?? [])].map((row) => ({ id: row.id, where: row.querySelector("th")?.textContent })),
  );
  expect(new Set(rows.map(({ id }) => id)).size).toBe(rows.length);
  for (const note of notes) expect(rows.map(({ id }) => id), note).toContain(note);
  await page.locator('aside.note a[href="#E-105"]').click();
  const row = figure(page, "E").locator("#E-105");
  await expect(row).toBeFocused();
  await expect(row).toBeInViewport();
  await expect(row.locator("th")).toHaveText("(105)");
});

test("citations can be copied, and are the files that can be taken", async ({ page, context, request }) => {
  await context.grantPermissions(["clipboard-read", "clipboard-write"]);
  await open(page);
  for (const [name, ending] of [["BibTeX", "bib"], ["RIS", "ris"]]) {
    const shown = await page.getByRole("region", { name }).textContent();
    const address = await page.getByRole("link", { name: `${name} as a file` }).getAttribute("href");
    expect(address?.endsWith(`.${ending}`)).toBe(true);
    const file = await (await request.get(new URL(address ?? "", page.url()).href)).text();
    expect(shown?.trimEnd()).toBe(file.trimEnd());
    await page.getByRole("button", { name: `Copy ${name}` }).click();
    await expect(page.getByRole("status").filter({ hasText: "Copied." }).last()).toBeVisible();
    expect(await page.evaluate(() => navigator.clipboard.readText())).toBe(shown);
    expect(shown).toContain("10.1007/s11071-021-07110-x");
    expect(shown).toContain(version());
  }
});

/** As in CITATION.cff. */
function version() {
  const text = readFileSync(new URL("../../CITATION.cff", import.meta.url), "utf8");
  return /^version: (.+)$/m.exec(text)?.[1] ?? "?";
}

for (const [width, what] of /** @type {const} */ ([[320, "the narrowest screen"], [360, "1440 px at 400 %"], [2560, "a wall"]])) {
  for (const address of ["./?test", GERMAN]) {
    test(`no sideways scrolling at ${width} px, ${what}, ${address === GERMAN ? "German" : "English"}`, async ({ page }) => {
      await page.setViewportSize({ width, height: 720 });
      await open(page, address);
      expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(width);
      const cut = await page.locator("main :is(p, h1, h2, h3, figcaption, dd, aside, math, .equation)").evaluateAll((all) =>
        all.filter((one) => one.getBoundingClientRect().right > innerWidth + 0.5).map((one) => one.textContent?.slice(0, 40)),
      );
      expect(cut).toEqual([]);
    });
  }
}

test("the column is of a length that reads well", async ({ page }) => {
  await page.setViewportSize({ width: 1440, height: 900 });
  await open(page);
  const characters = await page.locator("#model p").first().evaluate((paragraph) => {
    const range = document.createRange();
    range.selectNodeContents(paragraph);
    const lines = new Set([...range.getClientRects()].map(({ bottom }) => Math.round(bottom / 12))).size;
    return (paragraph.textContent ?? "").length / lines;
  });
  expect(characters).toBeGreaterThan(50);
  expect(characters).toBeLessThan(75);
});

for (const address of ["./?test", GERMAN]) {
  test(`every letter is of the shipped typeface, ${address === GERMAN ? "German" : "English"}`, async ({ page }) => {
    await open(page, address);
    if (address === GERMAN) await expect(page.getByRole("heading", { level: 1 })).toContainText("Zahnräder");
    const session = await page.context().newCDPSession(page);
    await session.send("DOM.enable");
    await session.send("CSS.enable");
    const { root } = await session.send("DOM.getDocument", { depth: -1 });
    /** @type {string[]} */
    const strange = [];
    for (const selector of ["h1", "h2", "h3", "main p", "aside", "figcaption", "dd", "dfn", "math", "header", "footer"]) {
      const { nodeIds } = await session.send("DOM.querySelectorAll", { nodeId: root.nodeId, selector });
      for (const nodeId of nodeIds) {
        const { fonts } = await session.send("CSS.getPlatformFontsForNode", { nodeId });
        for (const { familyName, isCustomFont } of fonts) {
          if (isCustomFont && familyName.startsWith("STIX Two")) continue;
          const { outerHTML } = await session.send("DOM.getOuterHTML", { nodeId });
          strange.push(`${familyName}: ${outerHTML.slice(0, 120)}`);
        }
      }
    }
    expect(strange).toEqual([]);
  });
}

test("in German nothing of the text is English", async ({ page }) => {
  await open(page);
  const read = await readable(page);
  expect(read.length).toBeGreaterThan(300);
  const words = () =>
    page.locator("main > [data-view='story'] [data-word]").evaluateAll((all) =>
      all.map((one) => /** @type {HTMLElement} */ (one).dataset.word + ": " + (one.textContent ?? "").replaceAll(/\s+/g, " ")),
    );
  const symbols = () => page.locator("gear-symbol, a.eq, a.term, aside a").count();
  const [english, counted] = [await words(), await symbols()];
  await page.evaluate(() => {
    location.hash = "#story&v=1&language=de";
  });
  await expect(page.getByRole("heading", { level: 1 })).toContainText("Zahnräder");
  const german = await words();
  // Numbers of the appendices' keys are the same; a few words are, too.
  const same = german.filter((words_) => english.includes(words_) && !/: (Hysterese|Torus|torus)$/.test(words_));
  expect(same).toEqual([]);
  // Charts far from the screen are drawn anew one by one, and their legends with them.
  await expect.poll(async () => (await readable(page)).filter((text) => read.includes(text)), { timeout: 30_000 }).toEqual([]);
  // What stands within the sentences is all there: symbols, numbers of equations, words, lines of figure E.
  expect(await symbols()).toBe(counted);
  expect(german.filter((words_) => /<\/?\d/.test(words_))).toEqual([]);
  await page.locator("#pulse gear-symbol[name='k0']").hover();
  await expect(page.getByRole("tooltip")).toHaveText(/gegenwärtig 0,5$/);
});

test("on paper every figure is there, light, and nothing that only a screen has", async ({ page }) => {
  await page.emulateMedia({ colorScheme: "dark" });
  await open(page);
  await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
  await page.emulateMedia({ media: "print" });
  const found = await page.locator("gear-figure").evaluateAll((all) =>
    all.map((element) => {
      const canvas = element.shadowRoot?.querySelector("canvas");
      const image = element.querySelector("img");
      const live = element.shadowRoot?.querySelector(".stage")?.classList.contains("live") ?? false;
      const corner = canvas && live ? [.../** @type {any} */ (window).readPixels(canvas, [2, 2, 1, 1])].slice(0, 3) : null;
      const shown = live ? canvas : image;
      return { id: element.id, live, corner, width: shown?.getBoundingClientRect().width ?? 0 };
    }),
  );
  for (const { id, live, corner, width } of found) {
    expect(width, id).toBeGreaterThan(100);
    if (live) expect(corner, id).toEqual([255, 255, 255]);
  }
  expect(found.filter(({ live }) => live).length).toBeGreaterThan(15);
  await expect(page.getByRole("navigation", { name: "Contents" })).toBeHidden();
  await expect(page.locator(".note").first()).toBeVisible();
  expect(await page.evaluate(() => getComputedStyle(document.documentElement).getPropertyValue("--ground").trim())).toBe("#ffffff");
});

test("without scripts there are the text, the drawings, the equations and the glossary", async ({ browser, baseURL }) => {
  const context = await browser.newContext({ javaScriptEnabled: false, baseURL });
  const page = await context.newPage();
  await page.goto("./");
  await page.locator('a.term[href="#term-tongue"]').click();
  await expect(page.locator("#term-tongue")).toBeInViewport();
  for (const id of ["1", "T", "3", "E"]) {
    const picture = page.locator(`#fig-${id} img`);
    await picture.scrollIntoViewIfNeeded();
    await expect(picture).toBeVisible();
  }
  await expect(page.locator("math").first()).toBeVisible();
  await context.close();
});

test("when the language changes, charts change the names they are called by, and nothing said in the old one is left", async ({ page }) => {
  await open(page);
  const chart = figure(page, "2");
  const name = () => chart.getByRole("application").getAttribute("aria-label");
  const heard = chart.locator(".heard[aria-live]");
  // An answer to the reader is spoken.
  await chart.getByRole("slider").first().press("ArrowRight");
  await expect(heard).not.toBeEmpty();
  for (const [language, start] of [["de", "Abbildung 2"], ["en", "Figure 2"]]) {
    const said = await heard.innerText();
    await page.evaluate((to) => void (location.hash = `${location.hash.replace(/&language=\w+/, "")}&language=${to}`), language);
    await expect.poll(name).toContain(start);
    if (said !== "") await expect(heard).not.toHaveText(said);
  }
});
