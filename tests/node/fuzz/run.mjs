// The whole fuzz by command: `cargo xtask fuzz [--cases 100000] [--calls branch,torus] [--seed 1] [--limit 60] [--small] [--one 123]`.
// Without options every call has 100,000 cases, which takes hours; `--one` runs a single case in this thread and prints it.

import { parseArgs } from "node:util";
import { GearError, gear, script } from "../support.mjs";
import { CALLS } from "./calls.mjs";
import { judged, knownOf } from "./cases.mjs";
import { Runner, SEED, Stuck, told } from "./runner.mjs";

const { values } = parseArgs({
  options: { cases: { type: "string" }, calls: { type: "string" }, seed: { type: "string" }, limit: { type: "string" }, first: { type: "string" }, one: { type: "string" }, small: { type: "boolean" } },
});
const names = values.calls?.split(",") ?? Object.keys(CALLS);
const seed = Number(values.seed ?? SEED);
const cases = Number(values.cases ?? 100_000);
const limit = Number(values.limit ?? 60);
const from = Number(values.first ?? 0);
/** Cases between two looks at the module. */
const batch = (/** @type {string} */ call) => (CALLS[call].cheap ? 5000 : 100);
const small = values.small ?? false;
const known = knownOf(gear, small);

if (values.one !== undefined) {
  for (const call of names) {
    console.log(told(known, call, Number(values.one), seed));
    const begin = performance.now();
    console.log(judged(known, GearError, call, seed, Number(values.one)), `${((performance.now() - begin) / 1000).toFixed(3)} s`);
  }
} else {
  process.exitCode = (await all()) > 0 ? 1 : 0;
}

async function all() {
  let faults = 0;
  for (const call of names) {
    let runner = new Runner(script, { seed, limit, small });
    const begin = performance.now();
    let [memory, references, instances, answered, slowest] = [0, 0, 0, 0, { number: 0, seconds: 0 }];
    /** @type {Record<string, number>} */
    const refusals = {};
    for (let first = from; first < from + cases; ) {
      const count = Math.min(batch(call), from + cases - first);
      try {
        const report = await runner.run(call, first, count);
        ({ memory, references, instances } = report);
        answered += report.answered;
        for (const [code, times] of Object.entries(report.refusals)) refusals[code] = (refusals[code] ?? 0) + times;
        if (report.slowest.seconds > slowest.seconds) slowest = report.slowest;
        for (const { number, fault } of report.findings) {
          faults += 1;
          console.log(`FAULT ${fault}\n  ${told(known, call, number, seed)}`);
        }
        first += count;
      } catch (thrown) {
        faults += 1;
        if (!(thrown instanceof Stuck)) throw thrown;
        console.log(`FAULT ${thrown.message}\n  ${told(known, call, thrown.number, seed)}`);
        await runner.close();
        runner = new Runner(script, { seed, limit, small });
        first = thrown.number + 1;
      }
    }
    await runner.close();
    const seconds = (performance.now() - begin) / 1000;
    console.log(
      `${call}: ${cases} cases in ${seconds.toFixed(1)} s, ${answered} answered, slowest ${slowest.seconds.toFixed(2)} s (case ${slowest.number}), ` +
        `memory ${(memory / 2 ** 20).toFixed(1)} MB, references ${references}, instances ${instances}, refused ${JSON.stringify(refusals)}`,
    );
  }
  console.log(faults === 0 ? "no fault" : `${faults} faults`);
  return faults;
}
