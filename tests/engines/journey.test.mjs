// The whole journey of a reader, in the engine that the variable ENGINE names: chromium, firefox or webkit. Each test goes on
// with the page that the one before it has left, unless it opens another. `cargo xtask test --only Firefox` runs it in Firefox;
// with PICTURES=some/folder it leaves a picture of every station there.

import assert from "node:assert/strict";
import { mkdir, mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import { pause, start, until } from "./driver.mjs";
import { ask, differences, questions } from "./numbers.mjs";
import { catchFiles, dataOf, focusOn, inkOf, installHands, isLaidOut, lastFile, markedAt, middleOf, placesOf, standStill } from "./page.mjs";
import { DIST, serveHost, serveSite, withHead } from "./servers.mjs";

/** @typedef {import("./page.mjs").Wanted} Wanted */

/** Figures in the order of the page. */
const IDS = "1 T M 3 2 5 4 7 6 8 9 10 11a 11b 11c 12a 12b 12c 13a 13b 13c B S A 14a 14b L E".split(" ");
/** So many pixels at least differ where a figure has drawn something. */
const INK = 150;

/** @type {import("./driver.mjs").Driver} */
let browser;
/** @type {import("./servers.mjs").Serving} */
let site;
/** @type {string} */
let folder;

before(async () => {
  folder = await mkdtemp(join(tmpdir(), "gear-journey-"));
  browser = await start(process.env.ENGINE ?? "chromium");
  console.log(`in ${browser.name}`);
  site = await serveSite(browser.inserted);
  await browser.resize(1440, 900);
});

after(async () => {
  await browser?.close();
  await site?.close();
  await rm(folder, { recursive: true, force: true });
});

/**
 * A station: when it is reached nothing has been complained of, and a picture is taken if one is wanted.
 *
 * @param {string} name
 * @param {() => Promise<void>} work
 */
function station(name, work) {
  test(name, { timeout: 180_000 }, async () => {
    try {
      await work();
      assert.deepEqual(await browser.noise(), []);
      assert.deepEqual(site.missed.splice(0), []);
    } finally {
      const pictures = process.env.PICTURES;
      if (pictures) {
        await mkdir(pictures, { recursive: true });
        await writeFile(join(pictures, `${process.env.ENGINE}-${name.replace(/\W+/g, "-").slice(0, 60)}.png`), await browser.picture());
      }
    }
  });
}

/** Nothing may differ; where much does, the first of it tells enough. @param {string[]} found */
function agree(found) {
  assert.deepEqual(found.slice(0, 5), [], `${found.length} numbers differ`);
}

/** Opens one of the other views. @param {string} address */
async function openRoom(address) {
  await browser.open(address);
  await browser.evaluate(installHands);
}

/** Opens a page of ours and waits until its paper's figures are drawn. @param {string} address */
async function open(address) {
  await browser.open(address);
  await browser.evaluate(installHands);
  await until("all figures are drawn", () => browser.evaluate(markedAt, "all-figures"));
  await until("all has its place", () => browser.evaluate(isLaidOut));
  await browser.evaluate(standStill);
}

/** @param {Wanted} wanted */
async function click(wanted) {
  await browser.drag([await until(`${wanted.role} “${wanted.name}”`, () => browser.evaluate(middleOf, wanted))]);
}

/**
 * Places in the window of data in a figure's first frame, once they stay where they are: a page that has just been opened goes on laying itself out.
 *
 * @param {string} selector
 * @param {[number, number][]} points
 */
function standing(selector, points) {
  return until(`${selector} stands still`, async () => {
    const before = await browser.evaluate(placesOf, selector, points);
    await pause(300);
    const now = await browser.evaluate(placesOf, selector, points);
    return JSON.stringify(now) === JSON.stringify(before) && now;
  });
}

/** @param {Wanted} wanted */
async function focus(wanted) {
  await until(`${wanted.role} “${wanted.name}”`, () => browser.evaluate(focusOn, wanted));
}

const hash = () => browser.evaluate(() => location.hash);
/** The text of the first element of a selector. @param {string} selector */
const textOf = (selector) => browser.evaluate((wanted) => document.querySelector(wanted)?.textContent ?? "", selector);
/** @param {string} selector @param {RegExp} words */
const says = (selector, words) => until(`${selector} says ${words}`, async () => words.test(await textOf(selector)));

station("the page opens below a path, from a host with no headers set", async () => {
  await open(`${site.address}?test`);
  const first = await browser.evaluate(markedAt, "first-figure");
  assert.ok(first !== null && first < /** @type {number} */ (await browser.evaluate(markedAt, "all-figures")));
  assert.match(await textOf("h1"), /^Why do gears/);
  // Indices, powers and fractions are made of two parts each.
  const broken = await browser.evaluate(() => [...document.querySelectorAll("msub, msup, mfrac")].filter(({ childElementCount }) => childElementCount !== 2).map(({ outerHTML }) => outerHTML));
  assert.deepEqual(broken, []);
});

station("every figure computes and draws, in every one of its frames", async () => {
  for (const id of IDS) {
    const ink = Object.entries(await browser.evaluate(inkOf, `#fig-${id}`));
    assert.ok(ink.length > 0, `figure ${id} has frames`);
    for (const [frame, count] of ink) assert.ok(count > INK, `figure ${id}, ${frame}: ${count} pixels`);
  }
});

station("what the figures on the page show are the native numbers", async () => {
  const asked = (await questions()).filter(({ id, params }) => id !== undefined && Object.keys(params).length === 0);
  assert.ok(asked.length > 25);
  for (const question of asked) agree(differences(question, await browser.evaluate(dataOf, `#fig-${question.id}`)));
});

station("the module's answers are the native ones, and to the bit those of Node", async () => {
  const { load } = await import(new URL("gear-bifurcations.js", pathToFileURL(DIST)).href);
  const gear = await load();
  await browser.evaluate(async (address, source) => {
    const { load: loadHere } = await import(address);
    Object.assign(globalThis, { __module: await loadHere(), __ask: new Function(`return ${source}`)() });
  }, `${site.address}gear-bifurcations.js`, `${ask}`);
  const asked = (/** @type {import("./numbers.mjs").Question} */ question) =>
    browser.evaluate((wanted) => /** @type {any} */ (globalThis).__ask(/** @type {any} */ (globalThis).__module, wanted), { ...question, answer: null });
  for (const question of (await questions()).filter(({ id, params }) => id === undefined || Object.keys(params).length > 0)) {
    const { answer, sum } = await asked(question);
    agree(differences(question, answer));
    const inNode = ask(gear, question);
    if (sum === inNode.sum) continue;
    // Seen once, in WebKit on a busy machine, and never again in a thousand tries: told, and asked again.
    console.log(`other bits than in Node: ${question.call} ${JSON.stringify(question.params)}`);
    assert.deepEqual((await asked(question)).answer, inNode.answer);
  }
});

station("a slider takes its numbers along, by keys and by the mouse, and the box takes an exact value", async () => {
  const within = "#fig-3";
  const meaning = "cubic stiffness of each support: above zero hardening, below zero softening";
  const radius = async () => {
    const { series, params } = await browser.evaluate(dataOf, within);
    const { x, y } = series.find(({ name }) => name === "R_2,3 hardening (63)")?.columns ?? { x: [], y: [] };
    return { radius: Math.max(...y), at: x[y.indexOf(Math.max(...y))], alpha: Number(params.alpha_p) };
  };
  const before = await radius();
  assert.equal(before.alpha, 0.2);
  await focus({ role: "slider", name: `α, ${meaning}`, within });
  await browser.press("ArrowRight");
  const right = await until("alpha is larger", async () => {
    const now = await radius();
    return now.alpha > before.alpha && now;
  });
  // R goes as one over the root of alpha.
  assert.ok(Math.abs(right.radius / before.radius - Math.sqrt(before.alpha / right.alpha)) < 1e-9);
  const place = await browser.evaluate(middleOf, { role: "slider", name: `α, ${meaning}`, within });
  await browser.drag([place, ...[10, 20, 30].map((by) => ({ x: place.x + by, y: place.y }))]);
  const dragged = await until("alpha follows the mouse", async () => {
    const now = await radius();
    return now.alpha !== right.alpha && now;
  });
  assert.ok(Math.abs(dragged.radius / before.radius - Math.sqrt(before.alpha / dragged.alpha)) < 1e-9);
  await click({ role: "spinbutton", name: "α", within });
  await browser.press("Control+a");
  await browser.type("0.123456");
  await browser.press("Enter");
  await until("alpha is what was written", async () => (await radius()).alpha === 0.123456);
  await click({ role: "button", name: "Reset", within });
  await until("alpha is what it was", async () => (await radius()).alpha === before.alpha);
});

station("the handle on the chart of tongues leads the gears, by the mouse and by keys", async () => {
  await open(`${site.address}?test`);
  const [from, between, to] = await standing("#fig-T", [[1.6, 0.5], [2.1, 0.4], [2.5, 0.3]]);
  await browser.drag([from, between, to]);
  const followed = await until("the gears follow", async () => {
    const { params } = await browser.evaluate(dataOf, "#fig-1");
    return params.Omega !== 1.6 && params;
  });
  assert.ok(Math.abs(Number(followed.Omega) - 2.5) < 0.02 && Math.abs(Number(followed.k0) - 0.3) < 0.01, JSON.stringify(followed));
  await until("the address says so", async () => (await hash()) === `#story&v=1&omega=${followed.Omega}&k0=${followed.k0}`);
  await focus({ role: "slider", name: "Ω, mesh frequency over the natural frequency of the mesh", within: "#fig-T" });
  await browser.press("ArrowLeft");
  const stepped = await until("the gears follow the key", async () => {
    const { params } = await browser.evaluate(dataOf, "#fig-1");
    return Number(params.Omega) < Number(followed.Omega) && params;
  });
  // What comes next goes by the address, which is written when an action is over.
  await until("the address follows the key", async () => (await hash()) === `#story&v=1&omega=${stepped.Omega}&k0=${stepped.k0}`);
});

station("what was done is undone by key and button, and a link shows the same elsewhere", async () => {
  const changed = await hash();
  await click({ role: "heading", name: "Figure T. Tongues of instability" });
  await browser.press("Control+z");
  const before = await until("the key is undone", async () => (await hash()) !== changed && hash());
  await click({ role: "button", name: "Undo" });
  await until("the drag is undone", async () => (await hash()) === "");
  await click({ role: "button", name: "Redo" });
  await until("the drag is done again", async () => (await hash()) === before);
  const { params, series } = await browser.evaluate(dataOf, "#fig-T");
  await open(`${site.address}?test${before}`);
  const there = await browser.evaluate(dataOf, "#fig-T");
  assert.deepEqual(there.params, params);
  assert.deepEqual(there.series, series);
});

station("charts are zoomed by a rectangle, and shown whole again", async () => {
  await open(`${site.address}?test`);
  const width = () => browser.evaluate(() => {
    const frame = /** @type {import("./page.mjs").GearFigure | null} */ (document.querySelector("#fig-2"))?.map()?.frames[0];
    return frame ? frame.x.high - frame.x.low : 0;
  });
  const [from, between, to] = await standing("#fig-2", [[-0.02, 0.05], [0, 0], [0.02, -0.05]]);
  const whole = await width();
  await browser.drag([from, between, to]);
  await until("a part is shown", async () => (await width()) < 0.8 * whole);
  await click({ role: "button", name: "Show all", within: "#fig-2" });
  await until("all is shown", async () => (await width()) === whole);
});

station("the laboratory comes up, and its charts follow one point", async () => {
  await click({ role: "link", name: "Lab" });
  await says(".lab .sentence", /Rest|response/);
  await openRoom(`${site.address}?test#lab&v=1&preset=11c`);
  await says(".lab .sentence", /Rest is a saddle.*settles on a stable orbit of period 2T, \|up\| up to 1\.8515/);
  // The chart takes its place above the branches once they are there.
  await browser.evaluate(dataOf, "#lab-B");
  const [from, between, to] = await standing("#lab-T", [[1.65, 0.5], [2.2, 0.45], [2.6, 0.4]]);
  await browser.drag([from, between, to]);
  await says(".lab .sentence", /Rest is stable.*comes to rest/);
  for (const id of ["T", "B", "1", "U", "P", "M", "W"]) assert.ok(Object.values(await browser.evaluate(inkOf, `#lab-${id}`)).every((count) => count > 50), `chart ${id}`);
});

station("the classroom asks, judges and shows", async () => {
  await click({ role: "link", name: "Class" });
  await click({ role: "button", name: "A tongue" });
  await click({ role: "radio", name: "The vibration dies away." });
  await click({ role: "button", name: "Answer" });
  await says(".verdict", /Right\./);
  await says(".reveal", /at most by the factor 0\.\d+/);
  assert.ok(Object.values(await browser.evaluate(inkOf, "#class-U")).every((count) => count > 50));
});

station("German is spoken throughout", async () => {
  await browser.press("Control+k");
  await browser.type("deutsch");
  await browser.press("Enter");
  await until("the page is German", () => browser.evaluate(() => document.documentElement.lang === "de"));
  await says("h1", /Zahnräder/);
  await click({ role: "link", name: "Geschichte" });
  const { summary } = await browser.evaluate(dataOf, "#fig-T");
  assert.ok(summary.length > 20);
});

station("a figure is taken away as a drawing, a table and a live file, which opens from a disk", async () => {
  await open(`${site.address}?test#story&v=1&language=en&11a.omega=1.6`);
  await browser.evaluate(catchFiles);
  const within = "#fig-11a";
  /** @param {string} entry @param {RegExp} called */
  const take = async (entry, called) => {
    await click({ role: "button", name: "Export", within });
    await click({ role: "menuitem", name: entry, within });
    const { name, text } = await until(entry, async () => {
      const file = await browser.evaluate(lastFile);
      return file !== null && called.test(file.name) && file;
    });
    assert.ok(name.length > 4);
    return text;
  };
  assert.match(await take("Drawing for print (SVG)", /\.svg$/), /^(<\?xml[^>]*>\s*)?<svg/);
  assert.match(await take("Numbers as a table (CSV)", /\.csv$/), /1\.6/);
  const { params } = await fromDisk("figure.html", await take("Live figure in one file (HTML)", /\.html$/), '[figure="11a"]');
  assert.equal(params.Omega, 1.6);
});

station("the element lives in a page of another origin, and leaves that page as it is", async () => {
  const listen = `<script>window.told = []; for (const type of ["gear-ready", "gear-change", "gear-error"]) addEventListener(type, ({ detail }) => told.push({ type, figure: detail.figure, params: detail.params }));</script>`;
  const host = await serveHost(
    `<style>* { letter-spacing: 1em; text-transform: uppercase }</style>${listen}<script type="module" src="${site.address}gear-figure.js"></script>
     <gear-figure figure="11a" omega="1.6" controls="compact" style="display: block; max-width: 40rem"></gear-figure>`,
    browser.inserted,
  );
  try {
    await openRoom(host.address);
    const ready = await until("it is ready", () => browser.evaluate(() => /** @type {any} */ (globalThis).told.find((/** @type {any} */ { type }) => type === "gear-ready")));
    assert.equal(ready.figure, "11a");
    assert.equal(ready.params.Omega, 1.6);
    const { series } = await browser.evaluate(dataOf, "gear-figure");
    assert.ok(series.length > 2);
    assert.deepEqual(await browser.evaluate(() => [document.activeElement === document.body, scrollY]), [true, 0]);
    await browser.evaluate(() => document.querySelector("gear-figure")?.setAttribute("omega", "1.62"));
    await until("it follows its attribute", async () => (await browser.evaluate(dataOf, "gear-figure")).params.Omega === 1.62);
    const spacing = await browser.evaluate(() => {
      const button = document.querySelector("gear-figure")?.shadowRoot?.querySelector("button");
      return button ? getComputedStyle(button).letterSpacing : "";
    });
    assert.ok(["normal", "0px"].includes(spacing), spacing);
    assert.deepEqual(host.missed, []);
  } finally {
    await browser.open("about:blank");
    await host.close();
  }
});

station("the frame tells its size, answers its page, and does what it is told", async () => {
  const host = await serveHost(
    `<script>window.told = []; addEventListener("message", ({ data }) => told.push(data));</script><script src="${site.address}gear-host.js"></script>
     <iframe title="A map" src="${site.address}embed.html#figure=11a&omega=1.6&controls=none" style="width: 600px; height: 10px; border: 0"></iframe>`,
    browser.inserted,
  );
  const told = (/** @type {string} */ type) => browser.evaluate((wanted) => /** @type {any} */ (globalThis).told.filter((/** @type {any} */ message) => message.type === wanted), type);
  try {
    await openRoom(host.address);
    const [ready] = await until("it is ready", async () => ((await told("ready")).length > 0 ? told("ready") : null));
    assert.deepEqual([ready.gear, ready.figure, ready.params.Omega], [1, "11a", 1.6]);
    await until("the frame is as high as its figure", () => browser.evaluate(() => (document.querySelector("iframe")?.clientHeight ?? 0) > 400));
    await browser.evaluate(() => {
      const { contentWindow, src } = /** @type {HTMLIFrameElement} */ (document.querySelector("iframe"));
      for (const message of [{ type: "set", params: { Omega: 1.62 } }, { type: "get", id: 7, data: true }]) contentWindow?.postMessage({ gear: 1, ...message }, new URL(src).origin);
    });
    const answer = await until("it answers", async () => (await told("change")).find((/** @type {any} */ { id }) => id === 7));
    assert.ok(answer.data.series.length > 2);
    await until("it has changed", async () => (await told("change")).some((/** @type {any} */ { params }) => params.Omega === 1.62));
    assert.deepEqual(host.missed, []);
  } finally {
    await browser.open("about:blank");
    await host.close();
  }
});

station("the single file opens from a disk, computes in workers, and asks for nothing", async () => {
  const { params } = await fromDisk("gear-bifurcations.html", await readFile(join(DIST, "gear-bifurcations.html"), "utf8"), "#fig-11a");
  assert.equal(params.Omega, 1.55);
  const { workers, asked } = await browser.evaluate(() => ({
    workers: /** @type {any} */ (globalThis).__gear.engine.pool.size,
    asked: performance.getEntriesByType("resource").map(({ name }) => name).filter((name) => !/^(data|blob):/.test(name)),
  }));
  assert.ok(workers > 1);
  assert.deepEqual(asked, []);
  for (const view of ["lab", "class"]) {
    await openRoom(`${pathToFileURL(join(folder, "gear-bifurcations.html")).href}?test#${view}&language=de`);
    await until(`${view} comes up in German`, () => browser.evaluate((wanted) => {
      const first = document.querySelector(`main > [data-view="${wanted}"] > *`);
      return document.documentElement.lang === "de" && first !== null && first.getClientRects().length > 0;
    }, view));
  }
});

station("the page is kept for when there is no network, even where the browser has cleared its store", async () => {
  // An address of its own: nobody has been there before.
  const away = await serveSite(browser.inserted);
  try {
    await open(away.address);
    const kept = await browser.evaluate(async () => {
      if (!("serviceWorker" in navigator)) return false;
      const ready = navigator.serviceWorker.ready.then(() => true);
      return Promise.race([ready, new Promise((resolve) => setTimeout(() => resolve(false), 20_000))]);
    });
    assert.deepEqual(away.missed, []);
    assert.deepEqual(await browser.noise(), []);
    // Where service workers are refused the page has come up all the same, which is all that is wanted.
    console.log(`service workers: ${kept ? "yes" : "no"}`);
    if (!kept) return;
    const stored = () => browser.evaluate(async () => {
      const [name] = await caches.keys();
      return name === undefined ? 0 : (await (await caches.open(name)).keys()).length;
    });
    await until("all is kept", async () => (await stored()) > 15);
    await browser.evaluate(async () => {
      const [name] = await caches.keys();
      const store = await caches.open(name);
      for (const request of await store.keys()) await store.delete(request);
    });
    assert.equal(await stored(), 0);
    await browser.reload();
    await until("the page is up", () => browser.evaluate(markedAt, "all-figures"));
    await until("what it needs is kept again", async () => (await stored()) > 10);
    await away.close();
    await browser.reload();
    await until("the page opens without a network", () => browser.evaluate(markedAt, "first-figure"));
    assert.match(await textOf("h1"), /\w/);
    // The browser itself looks for a newer service worker, in vain, and may say so.
    await browser.noise();
  } finally {
    await away.close();
  }
});

/**
 * Opens a file from a disk, and says what a figure in it shows.
 *
 * @param {string} name
 * @param {string} text
 * @param {string} selector
 */
async function fromDisk(name, text, selector) {
  const path = join(folder, name);
  await writeFile(path, withHead(text, browser.inserted));
  await openRoom(`${pathToFileURL(path).href}?test`);
  await until("its first figure is drawn", () => browser.evaluate(markedAt, "first-figure"));
  assert.equal(await browser.evaluate(() => location.protocol), "file:");
  return browser.evaluate(dataOf, selector);
}
