// Pages that mean no good, or merely forbid: strict policies, sandboxes, no storage, wild styles, spoiled globals, messages by the
// hundred thousand. The figure lives, or says in a sentence why it stands still; it obeys nobody but its page; and the page stays
// as it was.

import { ELEMENT, LISTEN, expect, heard, hears, test } from "./host.js";

/** @typedef {import("@playwright/test").Page} Page */
/** @typedef {import("@playwright/test").Locator} Locator */

/** Uncaught errors of a page and of all its frames. @param {Page} page */
function uncaught(page) {
  /** @type {string[]} */
  const errors = [];
  page.on("pageerror", (error) => errors.push(error.message));
  return errors;
}

/** A figure's frame. @param {string | undefined} site @param {string} hash @param {string} [more] */
const FRAME = (site, hash, more = "") => `<iframe id="frame" title="A figure" src="${site}embed.html#${hash}" style="width: 700px; height: 700px; border: 0" ${more}></iframe>`;

/** @param {Page} page @param {unknown} message */
const say = (page, message) =>
  page.evaluate((posted) => /** @type {HTMLIFrameElement} */ (document.querySelector("#frame")).contentWindow?.postMessage(posted, "*"), message);

test("100,000 malformed messages at a high rate: none acted on, none thrown at, and a proper question is answered", async ({ page, host, baseURL }) => {
  test.setTimeout(240_000);
  const errors = uncaught(page);
  // Another site than the figure's: it is a third party here.
  await page.goto(host({ name: "localhost", body: `${LISTEN}${FRAME(baseURL, "figure=2&k=6&controls=none")}` }));
  await hears(page, "ready");
  await hears(page, "resize");
  const frame = page.frames().find((one) => one.url().includes("embed.html"));
  const look = () => frame?.evaluate(() => {
    const figure = document.querySelector("gear-figure");
    return [figure?.getAttributeNames().join(" "), figure?.getAttribute("figure"), location.href, document.title, document.body.childElementCount, window.name, history.length];
  });
  const before = await look();
  // It says its size whenever that changes, asked or not.
  const answers = () => page.evaluate(() => /** @type {any} */ (window).heard.filter((/** @type {any[]} */ [type]) => type !== "resize").length);
  const answersBefore = await answers();
  const sent = await page.evaluate(async () => {
    const [{ malformed }, { random }] = await Promise.all(["/node/fuzz/messages.mjs", "/node/random.mjs"].map((path) => import(path)));
    const choose = random(2021);
    const target = /** @type {HTMLIFrameElement} */ (document.querySelector("#frame")).contentWindow;
    let count = 0;
    for (let batch = 0; batch < 200; batch += 1) {
      for (let index = 0; index < 500; index += 1) {
        target?.postMessage(malformed(choose), "*");
        count += 1;
      }
      await new Promise((resolve) => setTimeout(resolve));
    }
    return count;
  });
  expect(sent).toBe(100_000);
  await say(page, { gear: 1, type: "get", id: "after" });
  await expect.poll(async () => (await heard(page, "change")).length, { timeout: 60_000 }).toBe(1);
  expect((await heard(page, "change"))[0]).toMatchObject({ id: "after", figure: "2", params: { k_p: 6, k_g: 6 } });
  expect(await answers()).toBe(answersBefore + 1);
  expect(await look()).toEqual(before);
  await say(page, { gear: 1, type: "set", params: { k: 7 } });
  await expect.poll(async () => (await heard(page, "change")).at(-1)?.params.k_p, { timeout: 30_000 }).toBe(7);
  expect(await page.evaluate(() => [document.activeElement === document.body, scrollY])).toEqual([true, 0]);
  expect(errors).toEqual([]);
});

test("a page's message sets parameters and nothing else: no script runs, no focus is taken", async ({ page, host, baseURL }) => {
  const errors = uncaught(page);
  const run = "parent.postMessage('I ran', '*')";
  await page.goto(host({ body: `${LISTEN}${FRAME(baseURL, `figure=2&autofocus=1&tabindex=0&onfocus=${run}&contenteditable=true&style=color:red`)}` }));
  await hears(page, "ready");
  for (const name of ["onclick", "onfocus", "onpointerenter", "ONGOTPOINTERCAPTURE", "style", "tabindex", "autofocus", "contenteditable", "popover"]) {
    await say(page, { gear: 1, type: "set", params: { [name]: run.slice(0, 64) } });
  }
  await say(page, { gear: 1, type: "get" });
  await hears(page, "change");
  const figure = page.frameLocator("#frame").locator("gear-figure");
  expect(await figure.evaluate((element) => element.getAttributeNames())).toEqual(["figure"]);
  expect(await page.evaluate(() => document.activeElement === document.body)).toBe(true);
  await figure.locator("canvas").click();
  await say(page, { gear: 1, type: "get" });
  await hears(page, "change", 2);
  expect(await page.evaluate(() => /** @type {any} */ (window).heard.filter((/** @type {any[]} */ [, data]) => data === "I ran").length)).toBe(0);
  expect(errors).toEqual([]);
});

test("messages of other windows are not heard: a stranger's frame, a window that was opened, the page around the page", async ({ page, host, baseURL }) => {
  const set = "{ gear: 1, type: 'set', params: { k: 9 } }";
  const stranger = `<script>addEventListener('message', () => parent.frames[0].postMessage(${set}, '*'))<${""}/script>`;
  // The page with the figure is itself in a frame; the outermost page reaches into it.
  const inner = `${FRAME(baseURL, "figure=2&k=6&controls=none")}<iframe id="stranger" title="A stranger" srcdoc="${stranger.replaceAll('"', "&quot;")}"></iframe>
    <script>addEventListener('message', ({ data }) => parent.postMessage(data, '*'))<${""}/script>`;
  await page.goto(host({ name: "localhost", body: `${LISTEN}<iframe id="middle" title="The page" style="width: 800px; height: 900px" srcdoc="${inner.replaceAll("&", "&amp;").replaceAll('"', "&quot;")}"></iframe>` }));
  await hears(page, "ready");
  await page.evaluate((message) => {
    const middle = /** @type {HTMLIFrameElement} */ (document.querySelector("#middle")).contentWindow;
    const [figure, other] = [middle?.frames[0], middle?.frames[1]];
    figure?.postMessage(message, "*");
    other?.postMessage("now", "*");
  }, { gear: 1, type: "set", params: { k: 9 } });
  await page.evaluate(() => {
    const middle = /** @type {HTMLIFrameElement} */ (document.querySelector("#middle")).contentWindow;
    // Its own page asks: this is heard, after all that was said before.
    const script = Object.assign(document.createElement("script"), { textContent: "document.querySelector('#frame').contentWindow.postMessage({ gear: 1, type: 'get', id: 1 }, '*')" });
    setTimeout(() => middle?.document.body.append(script), 0);
  });
  const [answer] = await hears(page, "change");
  expect(answer).toMatchObject({ id: 1, params: { k_p: 6 } });
});

test("sandboxes: without scripts the still drawing; with scripts alone, as far as its host shares; with both, live", async ({ page, host, elsewhere }) => {
  const errors = uncaught(page);
  const show = async (/** @type {string} */ site, /** @type {string} */ hash, /** @type {string} */ sandbox) => {
    await page.goto(host({ name: "localhost", body: `${LISTEN}${FRAME(site, hash, `sandbox="${sandbox}"`)}` }));
    return page.frameLocator("#frame");
  };
  const closed = elsewhere();
  const still = await show(closed, "figure=2", "");
  await expect(still.locator(".why")).toHaveText(/^Scripts are not allowed here/);
  await expect(still.locator(".why")).toBeVisible();
  await expect(still.locator(".still:visible")).toHaveCount(1);
  await expect(still.locator('[id="figure=2"] img')).toBeVisible();
  await expect(still.locator('[id="figure=2"] img')).not.toHaveJSProperty("naturalWidth", 0);
  // An origin of no name is one of others: without leave to share, its scripts cannot even be fetched.
  const alone = await show(closed, "figure=11a&omega=1.6", "allow-scripts");
  await expect(alone.getByText("The script of the live figure cannot be loaded here")).toBeVisible();
  await expect(alone.locator(".still:visible")).toHaveCount(1);
  await expect(alone.locator('[id="figure=11a"] img')).toBeVisible();
  await expect(alone.locator('[id="figure=11a"] img')).not.toHaveJSProperty("naturalWidth", 0);
  const open = await show(elsewhere({ "Access-Control-Allow-Origin": "*" }), "figure=11a&omega=1.6&controls=none", "allow-scripts");
  await expect(open.locator(".stage.live")).toBeVisible({ timeout: 30_000 });
  expect((await hears(page, "ready"))[0]).toMatchObject({ figure: "11a", params: { Omega: 1.6 } });
  await say(page, { gear: 1, type: "set", params: { Omega: 1.62 } });
  expect((await hears(page, "change"))[0]).toMatchObject({ params: { Omega: 1.62 } });
  const both = await show(elsewhere(), "figure=2&controls=none", "allow-scripts allow-same-origin");
  await expect(both.locator(".stage.live")).toBeVisible({ timeout: 30_000 });
  expect(errors).toEqual([]);
});

test("the whole page without storage, workers of its own kept out, in a sandbox: it lives, and asks for nothing it may not", async ({ page, host, elsewhere }) => {
  const errors = uncaught(page);
  const site = elsewhere({ "Access-Control-Allow-Origin": "*" });
  await page.goto(host({ name: "localhost", body: `<iframe id="frame" title="The page" src="${site}#lab&theme=dark" style="width: 1300px; height: 800px" sandbox="allow-scripts"></iframe>` }));
  const inner = page.frameLocator("#frame");
  await expect(inner.locator('main > [data-view="lab"] gear-figure .stage.live').first()).toBeVisible({ timeout: 60_000 });
  // It really is refused: what the test is about.
  const refused = await page.frames()[1].evaluate(() => {
    try {
      return typeof localStorage.length;
    } catch (error) {
      return /** @type {Error} */ (error).name;
    }
  });
  expect(refused).toBe("SecurityError");
  await inner.getByRole("button", { name: "Settings" }).click();
  await inner.getByRole("radio", { name: "light" }).check();
  await expect(inner.locator("html")).toHaveAttribute("data-theme", "light");
  expect(errors).toEqual([]);
});

const POLICY = (/** @type {string} */ site) =>
  `default-src 'none'; script-src ${site} 'wasm-unsafe-eval'; connect-src ${site}; font-src ${site}; img-src ${site} data:; worker-src blob:; style-src 'none'; base-uri 'none'; form-action 'none'; object-src 'none'`;

test("a policy with no more than docs/embedding.md asks for: the element lives", async ({ page, host, baseURL }) => {
  const errors = uncaught(page);
  /** @type {string[]} */
  const violations = [];
  page.on("console", (message) => message.type() === "error" && violations.push(message.text()));
  const site = new URL(baseURL ?? "").origin;
  await page.goto(host({ name: "localhost", body: `${ELEMENT(baseURL)}<gear-figure figure="11a" controls="full"></gear-figure>`, headers: { "Content-Security-Policy": POLICY(site) } }));
  await expect(page.locator("gear-figure .stage.live")).toBeVisible({ timeout: 30_000 });
  await expect(page.locator("gear-figure .panel")).toBeVisible();
  expect(page.workers().length).toBeGreaterThan(0);
  expect([...errors, ...violations]).toEqual([]);
});

for (const [what, change, sentence] of /** @type {const} */ ([
  ["no wasm", [" 'wasm-unsafe-eval'", ""], "cannot be computed here, so it stands still"],
  ["no workers", [/worker-src [^;]+/, "worker-src 'none'"], "No worker comes up here"],
  ["nothing may be fetched", [/connect-src \S+;/, ""], "cannot be computed here, so it stands still"],
  ["trusted types", ["base-uri 'none'", "require-trusted-types-for 'script'; base-uri 'none'"], "cannot be computed here, so it stands still"],
])) {
  test(`a policy with ${what}: the still drawing stands there, with a sentence why`, async ({ page, host, baseURL }) => {
    const errors = uncaught(page);
    const site = new URL(baseURL ?? "").origin;
    const policy = POLICY(site).replace(change[0], change[1]);
    await page.goto(host({ name: "localhost", body: `${ELEMENT(baseURL)}<gear-figure figure="2"></gear-figure>`, headers: { "Content-Security-Policy": policy } }));
    const figure = page.locator("gear-figure");
    await expect(figure.locator(".status")).toContainText(sentence, { timeout: 60_000 });
    await expect(figure.locator("img")).toBeVisible();
    expect(errors).toEqual([]);
  });
}

test("the page itself where wasm is forbidden: text and still drawings, and each figure says why", async ({ page, elsewhere }) => {
  const errors = uncaught(page);
  await page.goto(elsewhere({ "Content-Security-Policy": "default-src 'self'; script-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data:" }));
  const figure = page.locator("#fig-2");
  await figure.scrollIntoViewIfNeeded();
  await expect(figure.locator("img")).toBeVisible();
  await expect(figure.locator(".status")).toContainText(/WebAssembly|wasm/);
  expect(errors).toEqual([]);
});

/** What a reader sees of a figure's parts: whatever the page around it does, the same. @param {Locator} figure */
async function looks(figure) {
  return figure.evaluate((element) => {
    const names = ["display", "visibility", "opacity", "color", "backgroundColor", "fontFamily", "fontSize", "fontWeight", "fontStyle", "letterSpacing", "wordSpacing", "lineHeight", "textTransform", "textAlign", "direction", "cursor", "borderTopWidth", "paddingLeft", "marginTop", "boxSizing", "transform", "filter", "textIndent", "whiteSpace", "writingMode"];
    const parts = [...(element.shadowRoot?.querySelectorAll("canvas, button, input, .status, .controls label, summary, .stage") ?? [])];
    return parts.slice(0, 40).map((part) => {
      const style = /** @type {any} */ (getComputedStyle(part));
      const { width, height } = part.getBoundingClientRect();
      return [part.tagName, part.className, Math.round(width), Math.round(height), ...names.map((name) => style[name])].join(" | ");
    });
  });
}

const WILD = `<style>
  * { all: initial !important; direction: rtl !important; font: 900 60px/3 cursive !important; color: lime !important; letter-spacing: 9px !important; text-transform: uppercase !important; }
  * { box-sizing: content-box !important; margin: 7px; padding: 9px; border: 5px solid red; transform: none; text-indent: 50px !important; word-spacing: 30px !important; white-space: pre !important; }
  html, body, div, gear-figure { display: block !important; }
  head, script { display: none !important; }
  /* Sizes are in rem: docs/embedding.md says that the root's counts. */
  html { font-size: 16px !important; }
  canvas, button, input, label { display: none !important; }
  :root { --ink: red; --ground: red; --quiet: red; --rule: red; --line: red; --accent: red; --focus: red; --wrong: red; }
</style>`;

test("a page's wild style changes nothing inside, and nothing of ours changes the page", async ({ page, host, baseURL }) => {
  const errors = uncaught(page);
  const body = (/** @type {string} */ style) => `${style}${LISTEN}<div style="width: 700px !important; padding: 0 !important; margin: 0 !important; border: 0 !important"><gear-figure figure="2" theme="light" style="margin: 0; padding: 0; border: 0"></gear-figure></div>
    <div id="own"><button>A button</button><h2>Heading</h2><canvas width="10" height="10"></canvas></div>`;
  const own = () => page.locator("#own").evaluate((element) =>
    [element, ...element.children].map((part) => {
      const style = getComputedStyle(part);
      return [...style].map((name) => `${name}: ${style.getPropertyValue(name)}`).join("; ");
    }),
  );
  const globals = () => page.evaluate(() => [Object.getOwnPropertyNames(window).filter((name) => !/^\d+$/.test(name)).sort(), document.adoptedStyleSheets.length, document.styleSheets.length, document.body.childElementCount, document.head.childElementCount]);
  const seen = [];
  for (const style of ["", WILD]) {
    await page.goto(host({ body: body(style) }));
    const [before, global] = [await own(), await globals()];
    await page.evaluate((src) => new Promise((resolve) => document.head.append(Object.assign(document.createElement("script"), { type: "module", src, onload: resolve }))), `${baseURL}gear-figure.js`);
    await hears(page, "gear-ready");
    await expect(page.locator("gear-figure .panel")).toBeAttached();
    expect(await own()).toEqual(before);
    const after = await globals();
    expect(after.slice(0, 4)).toEqual(global.slice(0, 4));
    expect(after[4]).toBe(Number(global[4]) + 1);
    seen.push(await looks(page.locator("gear-figure")));
  }
  expect(seen[0].length).toBeGreaterThan(10);
  expect(seen[1]).toEqual(seen[0]);
  expect(errors).toEqual([]);
});

test("spoiled prototypes and globals: the figure lives", async ({ page, host, baseURL }) => {
  const errors = uncaught(page);
  const spoil = `<script>
    for (const name of ["extend", "id", "value", "default", "theme", "size", "error", "params", "k0", "gear"]) Object.prototype[name] = function () { return name; };
    for (const name of ["remove", "contains", "last", "clone", "each"]) Array.prototype[name] = function () { return name; };
    String.prototype.format = Number.prototype.times = Function.prototype.bindTo = function () { return "mine"; };
    Array.prototype.toJSON = Object.prototype.toJSON = undefined;
    window.name = "gear"; window.load = window.gear = window.engine = window.say = window.services = window.figure = window.Pool = "mine";
    window.customElements.polyfilled = true; window.$ = window._ = () => { throw new Error("not yours"); };
    window.requestIdleCallback = undefined; delete window.requestIdleCallback;
  </script>`;
  await page.goto(host({ body: `${spoil}${LISTEN}${ELEMENT(baseURL)}<gear-figure figure="11a" omega="1.65" controls="full"></gear-figure>` }));
  expect((await hears(page, "gear-ready"))[0]).toMatchObject({ figure: "11a" });
  const figure = page.locator("gear-figure");
  await expect(figure.locator(".panel")).toBeVisible();
  expect(await figure.evaluate(async (element) => (await /** @type {any} */ (element).data()).params.Omega)).toBe(1.65);
  await figure.getByRole("spinbutton").first().fill("1.6");
  await figure.getByRole("spinbutton").first().press("Enter");
  await hears(page, "gear-change");
  expect(errors).toEqual([]);
});

test("an element is moved, cloned, taken out and put back at a high rate, and lives in the end", async ({ page, host, baseURL }) => {
  const errors = uncaught(page);
  await page.goto(host({ body: `${LISTEN}${ELEMENT(baseURL)}<div id="a"><gear-figure figure="2" controls="none"></gear-figure></div><div id="b"></div>` }));
  await hears(page, "gear-ready");
  await page.evaluate(async () => {
    const figure = /** @type {HTMLElement} */ (document.querySelector("gear-figure"));
    const places = ["#a", "#b"].map((name) => /** @type {HTMLElement} */ (document.querySelector(name)));
    for (let count = 0; count < 200; count += 1) {
      places[count % 2].append(figure);
      if (count % 3 === 0) figure.remove();
      if (count % 5 === 0) figure.setAttribute("figure", ["2", "4", "11a", "nonsense"][count % 4]);
      if (count % 7 === 0) figure.cloneNode(true);
      if (count % 20 === 0) await new Promise((resolve) => requestAnimationFrame(resolve));
    }
    figure.setAttribute("figure", "4");
    places[0].append(figure);
  });
  const figure = page.locator("gear-figure");
  await expect(figure.locator(".stage.live")).toBeVisible({ timeout: 30_000 });
  expect(await figure.evaluate(async (element) => (await /** @type {any} */ (element).data()).id)).toBe("4");
  expect(errors).toEqual([]);
});
