// The module by itself, without the page: the same file, the same numbers in Node, in a page and in a module worker; drawing on
// canvases of every kind; a server that gets the type wrong or has no wasm.

import { test as anyPage } from "@playwright/test";
import { expect, test } from "./page.js";

/**
 * @typedef {import("@playwright/test").Page} Page
 * @typedef {import("../../www/engine/gear-bifurcations.js").Gear} Gear
 */

/** The page of these tests: nothing but what each of them puts into it. @param {Page} page @param {string} [body] */
async function blank(page, body = "") {
  await page.route("**/blank.html", (route) =>
    route.fulfill({
      contentType: "text/html",
      body: `<!doctype html><meta charset="utf-8"><title>module</title><link rel="icon" href="data:,">${body}`,
    }),
  );
  await page.goto("./blank.html");
}

/**
 * A bit of everything that computes, as plain lists of numbers. As text, so that page and worker run the very same.
 */
const COLLECT = `(gear) => {
  const flat = (value) =>
    ArrayBuffer.isView(value) || Array.isArray(value) ? Array.from(value, flat)
    : value !== null && typeof value === "object" ? Object.fromEntries(Object.entries(value).map(([k, v]) => [k, flat(v)]))
    : value;
  return flat({
    modes: gear.modes({ m: 2, k: 3 }),
    tongues: gear.tongues({ k0: 0.3 }),
    multipliers: gear.multipliers({ Omega: 3.5 }),
    orbit: gear.periodicOrbit({ Omega: 1.65 }, { period: 2 }),
    motion: gear.timeResponse({ zeta: 0.07, alpha: 0, F: 1.5, regime: "backlash" }, { periods: 20, samplesPerPeriod: 8 }),
    strobe: gear.poincare({ Omega: 3.7 }, { points: 50 }),
    figure: gear.figure("9"),
    map: gear.figure("11a"),
    svg: gear.svg("3", { k0: 0.4 }),
  });
}`;

/** The module's address, seen from the blank page. */
const MODULE = "./gear-bifurcations.js";

/** Every number of one is within 1e-12 (relative above 1) of the other's; all else is equal. @param {any} one @param {any} other @param {string} path */
function agree(one, other, path) {
  if (typeof one === "number" && typeof other === "number") {
    const distance = Math.abs(one - other);
    if (!(distance <= 1e-12 * Math.max(1, Math.abs(one)))) throw new Error(`${path}: ${one} and ${other}`);
  } else if (one !== null && typeof one === "object" && other !== null && typeof other === "object") {
    expect(Object.keys(one), path).toEqual(Object.keys(other));
    for (const name of Object.keys(one)) agree(one[name], other[name], `${path}.${name}`);
  } else {
    expect(one, path).toBe(other);
  }
}

test("the same numbers in Node, in a page and in a module worker", async ({ page }) => {
  const { load } = await import(new URL("../../dist/gear-bifurcations.js", import.meta.url).href);
  const node = new Function(`return ${COLLECT}`)()(await load());

  await blank(page);
  const inPage = await page.evaluate(
    async ({ module, collect }) => {
      const { load } = await import(new URL(module, location.href).href);
      return new Function(`return ${collect}`)()(await load());
    },
    { module: MODULE, collect: COLLECT },
  );
  const inWorker = await page.evaluate(
    async ({ module, collect }) => {
      const address = new URL(module, location.href).href;
      const source = `
        import { load } from ${JSON.stringify(address)};
        // Once by itself, once from the module that the page has compiled.
        onmessage = async ({ data }) => postMessage((${collect})(await load(data)));
      `;
      const { load } = await import(address);
      const worker = new Worker(URL.createObjectURL(new Blob([source], { type: "text/javascript" })), { type: "module" });
      /** @param {unknown} message */
      const ask = (message) =>
        new Promise((resolve, reject) => {
          worker.onmessage = ({ data }) => resolve(data);
          worker.onerror = (event) => reject(new Error(event.message));
          worker.postMessage(message);
        });
      const answers = [await ask(undefined), await ask((await load()).module)];
      worker.terminate();
      return answers;
    },
    { module: MODULE, collect: COLLECT },
  );
  agree(inPage, node, "page");
  agree(inWorker[0], node, "worker");
  agree(inWorker[1], node, "worker with a posted module");
});

test("draw() fills canvases of every kind, and says where the data are", async ({ page }) => {
  await blank(
    page,
    `<canvas id="styled" style="width: 600px; height: 400px"></canvas>
     <canvas id="plain" width="500" height="300"></canvas>
     <iframe id="other" srcdoc="<canvas id=inner style='width: 300px; height: 200px'></canvas>"></iframe>`,
  );
  const seen = await page.evaluate(async (module) => {
    const { load } = await import(new URL(module, location.href).href);
    /** @type {Gear} */
    const gear = await load();
    /** @param {string} id */
    const canvas = (id) => /** @type {HTMLCanvasElement} */ (document.getElementById(id));
    /** How many different colours there are. @param {HTMLCanvasElement} canvas */
    const colors = (canvas) => {
      const { data } = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d")).getImageData(0, 0, canvas.width, canvas.height);
      return new Set(new Uint32Array(data.buffer)).size;
    };
    /** @param {HTMLCanvasElement} canvas */
    const size = (canvas) => [canvas.width, canvas.height, canvas.clientWidth, canvas.clientHeight];
    const styled = canvas("styled");
    const first = gear.draw("9", {}, styled, { density: 2 });
    const sizes = { styled: size(styled) };
    gear.draw("9", {}, styled, { density: 1.5 });
    const plain = canvas("plain");
    const plainSizes = [1, 2, 3].map(() => {
      gear.draw("2", {}, plain, { density: 2, theme: "dark" });
      return size(plain);
    });
    const loose = document.createElement("canvas");
    Object.assign(loose, { width: 800, height: 600 });
    const looseFrames = gear.draw(gear.figure("3"), undefined, loose, { density: 2 }).frames;
    const before = styled.toDataURL();
    /** @type {string[]} */
    const refusals = [];
    const inner = /** @type {HTMLIFrameElement} */ (document.getElementById("other")).contentDocument?.getElementById("inner");
    const tiny = document.createElement("canvas");
    for (const run of [
      () => gear.draw("9", { k0: 2 }, styled),
      () => gear.draw("99", {}, styled),
      () => gear.draw("9", {}, styled, { density: 100 }),
      () => gear.draw({ .../** @type {any} */ (gear.figure("9")), series: [{}] }, {}, styled),
      () => gear.draw("9", {}, /** @type {any} */ (document.body)),
      () => gear.draw("9", {}, /** @type {any} */ (inner)),
      () => gear.draw("9", {}, Object.assign(tiny, { width: 10 })),
    ]) {
      try {
        run();
        refusals.push("none");
      } catch (error) {
        refusals.push(/** @type {any} */ (error).code);
      }
    }
    return {
      frames: first.frames,
      sizes,
      secondSize: size(styled),
      plainSizes,
      looseFrames,
      colors: [colors(styled), colors(plain), colors(loose)],
      kept: styled.toDataURL() === before,
      refusals,
    };
  }, MODULE);

  expect(seen.sizes.styled).toEqual([1200, 800, 600, 400]);
  expect(seen.secondSize).toEqual([900, 600, 600, 400]);
  expect(seen.plainSizes).toEqual([1, 2, 3].map(() => [1000, 600, 500, 300]));
  for (const count of seen.colors) expect(count).toBeGreaterThan(20);
  const [frame] = seen.frames;
  expect(frame.plot.left).toBeGreaterThan(10);
  expect(frame.plot.right).toBeLessThanOrEqual(600);
  expect(frame.plot.top).toBeLessThan(frame.plot.bottom);
  expect(frame.x.low).toBeLessThan(frame.x.high);
  expect(frame.projection).toBeNull();
  expect(seen.looseFrames.some((map) => map.projection !== null && Object.keys(map.projection[0]).length === 4)).toBe(true);
  expect(seen.kept, "the last good picture is kept").toBe(true);
  expect(seen.refusals).toEqual([
    "out-of-range", "unknown-figure", "option", "drawing", "option", "option", "drawing",
  ]);
});

test("a server that does not know the type of wasm is no obstacle", async ({ page }) => {
  await page.route("**/gear-bifurcations_bg.wasm", async (route) => {
    const response = await route.fetch();
    await route.fulfill({ response, headers: { ...response.headers(), "content-type": "application/octet-stream" } });
  });
  await blank(page);
  const a = await page.evaluate(async (module) => {
    const { load } = await import(new URL(module, location.href).href);
    return (await load()).modes().a;
  }, MODULE);
  expect(a).toBeCloseTo(8.6332495807108, 12);
});

// Not the silent page: the browser itself writes a line for a status of 404.
anyPage("a missing wasm is a GearError that says so", async ({ page }) => {
  await page.route("**/gear-bifurcations_bg.wasm", (route) => route.fulfill({ status: 404, body: "not here" }));
  await blank(page);
  const error = await page.evaluate(async (module) => {
    const { GearError, load } = await import(new URL(module, location.href).href);
    try {
      await load();
      return null;
    } catch (error) {
      return { ours: error instanceof GearError, ...JSON.parse(JSON.stringify(error)) };
    }
  }, MODULE);
  expect(error).toMatchObject({ ours: true, code: "load" });
  expect(error.message).toContain("404");
});
