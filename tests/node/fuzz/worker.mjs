// Runs cases in a thread of its own, so that one that never ends can be ended; says which it is at, and what its module's
// instances have come to.

import { isDeepStrictEqual } from "node:util";
import { parentPort, workerData } from "node:worker_threads";
import { judged, knownOf } from "./cases.mjs";

/**
 * @typedef {{script: string, seed: number, small: boolean, progress: SharedArrayBuffer}} Data
 * @typedef {{call: string, first: number, count: number}} Order  Cases from `first` on.
 * @typedef {{call: string, number: number, fault: string}} Finding
 * @typedef {{findings: Finding[], refusals: Record<string, number>, answered: number, memory: number, references: number, instances: number, slowest: {number: number, seconds: number}}} Report
 */

const { script, seed, small, progress } = /** @type {Data} */ (workerData);
const at = new Int32Array(progress);

/** Every instance there has been: a second one is there because the first died. @type {WebAssembly.Instance[]} */
const instances = [];
const Plain = WebAssembly.Instance;
WebAssembly.Instance = /** @type {any} */ (
  class extends Plain {
    /** @param {WebAssembly.Module} module @param {WebAssembly.Imports} imports */
    constructor(module, imports) {
      super(module, imports);
      instances.push(this);
    }
  }
);

const { GearError, load } = await import(script);
const gear = await load();
const known = knownOf(gear, small);

/** A little of everything, which must be the same before and after. */
function reference() {
  return [
    gear.modes({ m: 2, k: 3 }),
    gear.multipliers({ Omega: 3.5 }),
    gear.periodicOrbit({ Omega: 1.65 }, { period: 2 }),
    gear.timeResponse({ zeta: 0.07, alpha: 0, F: 1.5, regime: "backlash" }, { periods: 5, samplesPerPeriod: 4 }),
    gear.figure("2"),
    gear.svg("3", { k0: 0.4 }),
  ];
}
const before = reference();

/** @param {Order} order @returns {Report} */
function run({ call, first, count }) {
  /** @type {Report} */
  const report = { findings: [], refusals: {}, answered: 0, memory: 0, references: 0, instances: 0, slowest: { number: 0, seconds: 0 } };
  for (let number = first; number < first + count; number += 1) {
    Atomics.store(at, 0, number);
    Atomics.add(at, 1, 1);
    const begin = performance.now();
    const { fault, refused } = judged(known, GearError, call, seed, number);
    const seconds = (performance.now() - begin) / 1000;
    if (seconds > report.slowest.seconds) report.slowest = { number, seconds };
    if (refused === null) report.answered += 1;
    else report.refusals[refused] = (report.refusals[refused] ?? 0) + 1;
    if (fault !== null && report.findings.length < 20) report.findings.push({ call, number, fault });
  }
  if (!isDeepStrictEqual(reference(), before)) report.findings.push({ call, number: first, fault: "afterwards the module answers something else than before" });
  const { memory, __wbindgen_externrefs: table } = /** @type {any} */ (instances[instances.length - 1].exports);
  report.memory = memory.buffer.byteLength;
  report.references = table?.length ?? 0;
  report.instances = instances.length;
  return report;
}

parentPort?.on("message", (/** @type {Order} */ order) => parentPort?.postMessage(run(order)));
parentPort?.postMessage("ready");
