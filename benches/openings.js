// Measures in the engine that ENGINE names how long the single file takes from being opened to its first figure.
// `cargo xtask bench` calls it after a build.

import { fileURLToPath, pathToFileURL } from "node:url";
import { start, until } from "../tests/engines/driver.mjs";
import { markedAt } from "../tests/engines/page.mjs";

const OPENINGS = 8;
const FILE = pathToFileURL(fileURLToPath(new URL("../dist/gear-bifurcations.html", import.meta.url))).href;

const browser = await start(process.env.ENGINE ?? "chromium");
try {
  await browser.resize(1440, 900);
  /** @type {number[]} */
  const times = [];
  for (let index = 0; index < OPENINGS; index += 1) {
    await browser.open(FILE);
    times.push(await until("the first figure", () => browser.evaluate(markedAt, "first-figure")));
    // What the last opening has begun must not run into the next one.
    await until("all figures", () => browser.evaluate(markedAt, "all-figures"));
  }
  const [first, ...others] = times;
  const median = others.sort((one, other) => one - other)[OPENINGS / 2 - 1];
  console.log(`${browser.name}, just started\t${(first * 1000).toFixed(0)}`);
  console.log(`${browser.name}, median of the ${OPENINGS - 1} openings after it\t${(median * 1000).toFixed(0)}`);
} finally {
  await browser.close();
}
