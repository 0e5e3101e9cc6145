// Measures in the engine that ENGINE names how long the single file takes from being opened to a picture of its first
// figure, still or live, and to the live one.
// `cargo xtask bench` calls it after a build.

import { fileURLToPath, pathToFileURL } from "node:url";
import { start, until } from "../tests/engines/driver.mjs";
import { markedAt } from "../tests/engines/page.mjs";

const OPENINGS = 8;
const FILE = pathToFileURL(fileURLToPath(new URL("../dist/gear-bifurcations.html", import.meta.url))).href;

const browser = await start(process.env.ENGINE ?? "chromium");
try {
  await browser.resize(1440, 900);
  /** @type {Record<"a picture of it" | "live", number[]>} */
  const times = { "a picture of it": [], live: [] };
  for (let index = 0; index < OPENINGS; index += 1) {
    await browser.open(FILE);
    /** @type {number | null} */
    let pictured = null;
    while (pictured === null) pictured = await browser.evaluate(picturedAt);
    const live = await until("the first figure", () => browser.evaluate(markedAt, "first-figure"));
    times["a picture of it"].push(pictured);
    times.live.push(live);
    // What the last opening has begun must not run into the next one.
    await until("all figures", () => browser.evaluate(markedAt, "all-figures"));
  }
  for (const [what, [first, ...others]] of Object.entries(times)) {
    const median = others.sort((one, other) => one - other)[OPENINGS / 2 - 1];
    console.log(`${browser.name}, ${what}, just started\t${(first * 1000).toFixed(0)}`);
    console.log(`${browser.name}, ${what}, median of the ${OPENINGS - 1} openings after it\t${(median * 1000).toFixed(0)}`);
  }
} finally {
  await browser.close();
}

/** When a picture of the first figure was found to stand there, since the document was opened; null where none does, ms. */
function picturedAt() {
  const [mark] = performance.getEntriesByName("first-figure");
  if (mark !== undefined) return mark.startTime;
  const still = document.querySelector("gear-figure img");
  return still instanceof HTMLImageElement && still.complete && still.naturalWidth > 0 ? performance.now() : null;
}
