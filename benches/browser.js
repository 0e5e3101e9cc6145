// Measures in Chromium: how long the page takes to its first and to all of its figures, the first call of the job after
// "--first", and the jobs named on the command line.
// `cargo xtask bench` calls it after a build, with the page's address in GEAR_ADDRESS.

import { readFile } from "node:fs/promises";
import { chromium } from "@playwright/test";
import { launchOptions } from "../xtask/chromium.js";

const OPENINGS = 8;
const FIRST_CALLS = 5;
const PATIENCE_MILLISECONDS = 60_000;
const MARKS = ["first-figure", "all-figures"];

const address = process.env.GEAR_ADDRESS;
if (!address) throw new Error("GEAR_ADDRESS says where the page is");
const [, first, ...jobs] = process.argv.slice(2);

const browser = await chromium.launch(launchOptions);
try {
  /** @type {number[][]} */
  const openings = [];
  for (let index = 0; index < OPENINGS; index += 1) openings.push(await opening(address));
  MARKS.forEach((mark, index) => {
    const times = openings.map((opening) => opening[index]);
    console.log(`${mark}, browser just started\t${(times[0] * 1000).toFixed(0)}`);
    const median = times.slice(1).sort((a, b) => a - b)[OPENINGS / 2 - 1];
    console.log(`${mark}, median of the ${OPENINGS - 1} openings after it\t${(median * 1000).toFixed(0)}`);
  });
  const firsts = [];
  for (let index = 0; index < FIRST_CALLS; index += 1) {
    const context = await browser.newContext();
    firsts.push(Number(await inEmptyPage(await context.newPage(), address, { first, jobs: [] })));
    await context.close();
  }
  console.log(`${first}\t${firsts.sort((a, b) => a - b)[(FIRST_CALLS - 1) / 2].toFixed(0)}`);
  console.log(await inEmptyPage(await browser.newPage(), address, { first: "", jobs }));
} finally {
  await browser.close();
}

/**
 * Opens the page as a new visitor and waits for its marks; milliseconds since navigation began.
 *
 * @param {string} address
 */
async function opening(address) {
  const context = await browser.newContext({ viewport: { width: 1440, height: 900 } });
  const page = await context.newPage();
  await page.goto(address);
  const deadline = Date.now() + PATIENCE_MILLISECONDS;
  for (;;) {
    const times = await page.evaluate(
      (marks) => marks.map((mark) => performance.getEntriesByName(mark)[0]?.startTime),
      MARKS,
    );
    const found = times.filter((time) => time !== undefined);
    if (found.length === MARKS.length) {
      await context.close();
      return found;
    }
    if (Date.now() > deadline) throw new Error(`the page never marked all of: ${MARKS.join(", ")}`);
    await new Promise((resolve) => setTimeout(resolve, 100));
  }
}

/**
 * Runs the jobs, or one job for the first time, in an otherwise empty page of the same origin.
 *
 * @param {import("@playwright/test").Page} page
 * @param {string} address
 * @param {{first: string, jobs: string[]}} wanted
 */
async function inEmptyPage(page, address, wanted) {
  const bench = await readFile(new URL("./bench.js", import.meta.url), "utf8");
  await page.route("**/bench.html", (route) => route.fulfill({ contentType: "text/html", body: "<!doctype html>" }));
  await page.route("**/bench.js", (route) => route.fulfill({ contentType: "text/javascript", body: bench }));
  await page.goto(new URL("bench.html", address).href);
  return page.evaluate(
    async ({ first, jobs, module, bench }) => {
      const { load } = await import(module);
      const { firstCall, measure } = await import(bench);
      const gear = await load();
      return first === "" ? measure(gear, jobs) : firstCall(gear, first);
    },
    { ...wanted, module: new URL("gear-bifurcations.js", address).href, bench: new URL("bench.js", address).href },
  );
}
