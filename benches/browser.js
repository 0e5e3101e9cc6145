// Measures in Chromium: the first call of the job after "--first", and the jobs named on the command line.
// `cargo xtask bench` calls it after a build, with the page's address in GEAR_ADDRESS.

import { readFile } from "node:fs/promises";
import { chromium } from "@playwright/test";
import { launchOptions } from "../xtask/chromium.js";

const FIRST_CALLS = 5;

const address = process.env.GEAR_ADDRESS;
if (!address) throw new Error("GEAR_ADDRESS says where the page is");
const [, first, ...jobs] = process.argv.slice(2);

const browser = await chromium.launch(launchOptions);
try {
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
