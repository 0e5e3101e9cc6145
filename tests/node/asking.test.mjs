// Figures that are answered in the frame in which their parameters changed: which of them, and in what order.

import assert from "node:assert/strict";
import { test } from "node:test";
import { askInFrame } from "../../www/figure/asking.js";

/** @type {(() => void)[]} */
const frames = [];
let now = 0;
Object.assign(globalThis, { requestAnimationFrame: (/** @type {() => void} */ work) => frames.push(work) });
Object.defineProperty(globalThis, "performance", { value: { now: () => now } });

/** @type {string[]} */
let told = [];

/** @param {string} name  @param {number} time  How long it takes here, ms; none for what workers answer. */
function asker(name, time) {
  return {
    here: () => time > 0,
    ask: (/** @type {boolean} */ here) => {
      told.push(`${name} ${here ? "here" : "elsewhere"}`);
      if (here) now += time;
    },
    lead: () => told.push(`${name} leads`),
  };
}

/** @param {ReturnType<typeof asker>[]} askers */
function inOneFrame(askers) {
  told = [];
  for (const one of askers) askInFrame(one);
  for (const frame of frames.splice(0)) frame();
  return told;
}

test("the quickest are answered first once it is known which they are, and none waits behind a slow one", () => {
  const all = [asker("slow", 20), asker("slower", 30), asker("field", 0), asker("quick", 5)];
  assert.deepEqual(inOneFrame(all), ["field elsewhere", "field leads", "slow here", "slower here", "quick elsewhere"]);
  assert.deepEqual(inOneFrame(all), ["field elsewhere", "field leads", "quick here", "slow here", "slower here"]);
  assert.deepEqual(inOneFrame(all), ["field elsewhere", "field leads", "quick here", "slow here", "slower here"]);
});
