// Every call with made-up parameters and options: a finite answer or a whole GearError, in bounded time and memory, and the very
// same instance of the module answers as before when it is over. `cargo xtask fuzz` makes 100,000 cases of every call.

import assert from "node:assert/strict";
import { after, test } from "node:test";
import { gear, load, script } from "./support.mjs";
import { CALLS } from "./fuzz/calls.mjs";
import { knownOf } from "./fuzz/cases.mjs";
import { Runner, Stuck, told } from "./fuzz/runner.mjs";

/** Cases of the cheap calls, 100,000 in all; every other call has `HEAVY`. */
const CHEAP = { defaults: 500, figures: 500, fromPhysical: 30_000, toPhysical: 30_000, modes: 36_000, tongues: 3_000 };
const HEAVY = 300;
/** More memory than this no case needs, bytes: small sizes, and drawings of 8192 by 8192 at most. */
const MEMORY = 128 * 2 ** 20;
/** References to JavaScript's values that an instance may hold when nothing is being computed. */
const REFERENCES = 4096;
/** Most seconds that a case may compute. */
const LIMIT = 30;

const known = knownOf(gear, true);
/** Two lines of calls, each in a thread with a module of its own. */
const lines = [new Runner(script, { small: true, limit: 2 * LIMIT }), new Runner(script, { small: true, limit: 2 * LIMIT })];
after(() => Promise.all(lines.map((line) => line.close())));

test("100,000 cases of the cheap calls, 300 of each heavy one", { concurrency: 2 }, async (context) => {
  const waiting = Object.keys(CALLS).reverse();
  assert.deepEqual(Object.keys(gear).filter((name) => !waiting.includes(name)), ["module"], "every call is fuzzed");
  const line = async (/** @type {Runner} */ runner) => {
    for (let call = waiting.pop(); call !== undefined; call = waiting.pop()) {
      const name = call;
      await context.test(`${name}()`, () => check(runner, name));
    }
  };
  await Promise.all(lines.map(line));
});

/** @param {Runner} runner @param {string} call */
async function check(runner, call) {
  const cases = CALLS[call].cheap ? CHEAP[/** @type {keyof typeof CHEAP} */ (call)] : HEAVY;
  const report = await runner.run(call, 0, cases).catch((thrown) => {
    assert.ok(!(thrown instanceof Stuck), thrown instanceof Stuck ? `${thrown.message}: ${told(known, call, thrown.number)}` : "");
    throw thrown;
  });
  assert.deepEqual(report.findings.map(({ number, fault }) => `${fault}\n${told(known, call, number)}`), []);
  assert.equal(report.instances, 1, "no call has ended the instance");
  assert.ok(report.memory <= MEMORY, `${report.memory} bytes of memory`);
  assert.ok(report.references <= REFERENCES, `${report.references} references`);
  const answered = report.answered;
  assert.ok(call === "draw" || answered > cases / 25, `only ${answered} of ${cases} cases were answered: that tests nothing`);
}

test("the fuzz finds what it is for: a trap, a number that is none, a code of ours, something else thrown", async () => {
  const { faultOfAnswer, faultOfError, faultOfShape } = await import("./fuzz/judge.mjs");
  const { GearError } = await import(script);
  const error = (/** @type {object} */ fields) => new GearError({ code: "option", parameter: "k0", given: 1, allowed: [0, 1], message: "a sentence of some length", ...fields });
  assert.equal(faultOfError(error({}), GearError), null);
  for (const wrong of [error({ code: "internal" }), error({ code: "new" }), error({ message: "" }), error({ given: {} }), error({ allowed: [0, Number.NaN] }), error({ parameter: null }), error({ code: "escaped", given: Number.NaN }), new TypeError("x"), "x", undefined]) {
    assert.notEqual(faultOfError(wrong, GearError), null);
  }
  assert.equal(faultOfAnswer({ method: "m", error: {}, left: null, list: [1, { state: null }], column: new Float64Array(2) }, "x", "x"), null);
  for (const wrong of [Number.NaN, { a: [Infinity] }, { column: new Float64Array([1, Number.NaN]) }, { m: undefined }, { meanRadius: null }, { f: () => 1 }, new Map()]) {
    assert.notEqual(faultOfAnswer(wrong, "x", "x"), null);
  }
  assert.notEqual(faultOfShape("torus", { error: {} }), null);
  const own = await load();
  assert.throws(() => /** @type {any} */ (own).bench("trap", 1), (thrown) => faultOfError(thrown, GearError)?.startsWith("code internal") ?? false);
});

test("memory comes to rest: the same cases once more need no more of it", async () => {
  const [runner] = lines;
  for (const call of ["timeResponse", "svg", "progress", "multipliers"]) await runner.run(call, 0, 100);
  const before = await runner.run("svg", 0, 200);
  for (const call of ["timeResponse", "progress", "multipliers"]) await runner.run(call, 0, 100);
  const after = await runner.run("svg", 0, 200);
  assert.ok(after.memory - before.memory <= 2 ** 20, `${before.memory} and ${after.memory} bytes`);
  assert.ok(after.references - before.references <= 256, `${before.references} and ${after.references} references`);
});

test("a case that never ends is found, with what it was given", async () => {
  const runner = new Runner(new URL("./fuzz/endless.mjs", import.meta.url).href, { limit: 0.5 });
  await assert.rejects(runner.run("modes", 3, 2), (thrown) => thrown instanceof Stuck && thrown.call === "modes" && thrown.number === 3);
});
