// Figures in pages of other origins: by the element and in a frame.

import { ELEMENT, LISTEN, expect, heard, hears, test } from "./host.js";

test("one script brings the element to any page, and it wears its own clothes", async ({ page, host, baseURL }) => {
  const address = host({
    body: `<style>* { letter-spacing: 1em; text-transform: uppercase; font: 40px cursive } :root { --ink: red }</style>${LISTEN}${ELEMENT(baseURL)}
      <gear-figure figure="2" k="6" controls="compact" style="--gear-accent: rgb(1, 2, 3)"></gear-figure>
      <div style="height: 6000px"></div>
      <gear-figure id="far" figure="4" controls="none"></gear-figure>`,
  });
  await page.goto(address);
  const [ready] = await hears(page, "gear-ready");
  expect(ready).toMatchObject({ figure: "2", params: { k_p: 6, k_g: 6 } });
  // The other is far away: nothing of it is computed yet.
  expect((await heard(page, "gear-ready")).length).toBe(1);
  expect(await page.evaluate(() => [document.activeElement === document.body, scrollY])).toEqual([true, 0]);
  const worn = await page.locator("gear-figure").first().evaluate((element) => {
    const button = /** @type {Element} */ (element.shadowRoot?.querySelector("button"));
    const { letterSpacing, textTransform, color } = getComputedStyle(button);
    return { letterSpacing, textTransform, color, accent: getComputedStyle(element).getPropertyValue("--accent") };
  });
  expect(worn).toEqual({ letterSpacing: "normal", textTransform: "none", color: "rgb(27, 31, 36)", accent: "rgb(1, 2, 3)" });
  const workers = page.workers().length;
  await page.locator("#far").scrollIntoViewIfNeeded();
  await hears(page, "gear-ready", 2);
  expect(page.workers().length).toBe(workers);
  expect(await page.locator("#far").evaluate((element) => element.shadowRoot?.querySelector(".panel"))).toBeNull();
});

test("its first picture comes drawn from the one worker there is, and is what the page would have drawn, which starts the module only then", async ({ page, host, baseURL }) => {
  await page.addInitScript(() => {
    const shown = (/** @type {any} */ (window).shown = /** @type {ImageBitmap[]} */ ([]));
    const draw = CanvasRenderingContext2D.prototype.drawImage;
    CanvasRenderingContext2D.prototype.drawImage = function (/** @type {any[]} */ ...all) {
      if (all[0] instanceof ImageBitmap && this.canvas.getRootNode() instanceof ShadowRoot) shown.push(all[0]);
      return /** @type {any} */ (draw).apply(this, all);
    };
    const Plain = WebAssembly.Instance;
    Object.assign(window, { started: 0 });
    WebAssembly.Instance = /** @type {any} */ (
      class extends Plain {
        /** @param {WebAssembly.Module} module @param {WebAssembly.Imports} imports */
        constructor(module, imports) {
          super(module, imports);
          /** @type {any} */ (window).started += 1;
        }
      }
    );
  });
  await page.goto(host({ body: `${LISTEN}${ELEMENT(baseURL)}<main style="inline-size: 40rem"><gear-figure figure="11a" theme="light" controls="none"></gear-figure></main>` }));
  await hears(page, "gear-ready");
  const started = () => page.evaluate(() => /** @type {any} */ (window).started);
  expect([page.workers().length, await started()]).toEqual([1, 0]);
  const found = await page.locator("gear-figure").evaluate(async (element) => {
    const canvas = /** @type {HTMLCanvasElement} */ (element.shadowRoot?.querySelector("canvas"));
    const { width, height } = canvas;
    const pixels = () => {
      const copy = new OffscreenCanvas(width, height);
      const context = /** @type {OffscreenCanvasRenderingContext2D} */ (copy.getContext("2d"));
      context.drawImage(canvas, 0, 0);
      return context.getImageData(0, 0, width, height).data;
    };
    const painted = () => new Promise((resolve) => element.addEventListener("gear-paint", () => resolve(undefined), { once: true }));
    const shown = /** @type {any} */ (window).shown.length;
    const came = pixels();
    const worn = [];
    for (const theme of ["dark", "light"]) {
      const then = painted();
      element.setAttribute("theme", theme);
      await then;
      worn.push(pixels());
    }
    const differing = (/** @type {Uint8ClampedArray} */ other) => {
      let count = 0;
      for (let index = 0; index < came.length; index += 4) count += [0, 1, 2].some((part) => Math.abs(came[index + part] - other[index + part]) > 48) ? 1 : 0;
      return count / (width * height);
    };
    return { shown, later: /** @type {any} */ (window).shown.length - shown, dark: differing(worn[0]), light: differing(worn[1]) };
  });
  expect(await started()).toBe(1);
  expect(found.shown).toBeGreaterThan(0);
  expect(found.later).toBe(0);
  expect(found.dark).toBeGreaterThan(0.5);
  expect(found.light).toBeLessThan(0.002);
});

test("where wasm is forbidden the still drawing stands there, with a sentence why", async ({ page, host, baseURL }) => {
  const site = new URL(baseURL ?? "").origin;
  const address = host({
    body: `${ELEMENT(baseURL)}<gear-figure figure="2"></gear-figure>`,
    headers: { "Content-Security-Policy": `default-src 'none'; script-src ${site}; img-src ${site}; connect-src ${site}; worker-src ${site} blob:` },
  });
  await page.goto(address);
  const figure = page.locator("gear-figure");
  await expect(figure.locator("img")).toBeVisible();
  expect(await figure.locator("img").evaluate((image) => /** @type {HTMLImageElement} */ (image).decode().then(() => true))).toBe(true);
  await expect(figure.locator(".status")).toContainText("cannot be computed here, so it stands still");
});

test("a frame tells its size, obeys its page, and hears nobody else", async ({ page, host, baseURL }) => {
  const address = host({
    body: `${LISTEN}<script src="${baseURL}gear-host.js"></script>
      <iframe id="frame" title="A figure" src="${baseURL}embed.html#figure=11a&omega=1.65&controls=none" style="width: 600px; height: 10px; border: 0"></iframe>
      <iframe id="stranger" title="A stranger" srcdoc="<script>addEventListener('message', () => parent.frames[0].postMessage({ gear: 1, type: 'set', params: { Omega: 1.5 } }, '*'))</script>"></iframe>`,
  });
  await page.goto(address);
  const say = (/** @type {unknown} */ message) =>
    page.evaluate((posted) => /** @type {HTMLIFrameElement} */ (document.querySelector("#frame")).contentWindow?.postMessage(posted, "*"), message);
  const [ready] = await hears(page, "ready");
  expect(ready).toMatchObject({ gear: 1, figure: "11a", params: { Omega: 1.65 } });
  const [{ height }] = (await hears(page, "resize")).slice(-1);
  expect(height).toBeGreaterThan(400);
  await expect.poll(() => page.locator("#frame").evaluate((frame) => frame.clientHeight)).toBeGreaterThan(400);
  await say({ gear: 1, type: "set", params: { Omega: 1.6 } });
  expect((await hears(page, "change"))[0]).toMatchObject({ figure: "11a", params: { Omega: 1.6 } });
  // Nothing that is not of the form is acted on; nor is what somebody else says.
  for (const wrong of [null, 3, "set", { type: "set" }, { gear: 1, type: "set", params: { Omega: "x".repeat(99) } }, { gear: 2, type: "reset" }, { gear: 1, type: "set", figure: "../1" }]) {
    await say(wrong);
  }
  await page.evaluate(() => /** @type {HTMLIFrameElement} */ (document.querySelector("#stranger")).contentWindow?.postMessage("now", "*"));
  await say({ gear: 1, type: "get", id: 7, data: true });
  const answer = (await hears(page, "change", 2))[1];
  expect(answer).toMatchObject({ id: 7, figure: "11a", params: { Omega: 1.6 } });
  expect(answer.data.series.length).toBeGreaterThan(1);
  await say({ gear: 1, type: "set", params: { Omega: 1000 } });
  expect((await hears(page, "error"))[0]).toMatchObject({ parameter: "Omega" });
  expect(await page.evaluate(() => [document.activeElement === document.body, scrollY])).toEqual([true, 0]);
});

test("a frame asks for its letters before the drawing does: what they come too late for is drawn twice", async ({ page, baseURL }) => {
  await page.goto(`${baseURL}embed.html#figure=11a&controls=none`);
  await expect(page.locator("gear-figure .stage.live")).toBeVisible({ timeout: 30_000 });
  const faces = await page.evaluate(async () => {
    await document.fonts.ready;
    return [...document.fonts].filter(({ family }) => !family.includes("Equations")).map(({ family, style, weight, status }) => `${family.replaceAll('"', "")} ${style} ${weight} ${status}`);
  });
  expect(faces.sort()).toEqual(["STIX Two Math normal 400 loaded", ...["italic 400", "normal 400", "normal 700"].map((face) => `STIX Two Text ${face} loaded`)]);
  // And none of the still drawings has been read, which are for readers without scripts.
  expect(await page.locator("img").count()).toBe(0);
});
