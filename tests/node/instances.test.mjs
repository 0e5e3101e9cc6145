// Loading, in every way; two loads share nothing; a trap is survived.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { GearError, checkRefusal, gear, load, refused, script } from "./support.mjs";

const bytes = await readFile(new URL("gear-bifurcations_bg.wasm", script));

/** @param {any} source @param {string} what */
async function loadRefused(source, what) {
  let thrown;
  try {
    await load(source);
  } catch (error) {
    thrown = error;
  }
  checkRefusal(thrown, { code: "load" }, what);
}

test("load() takes nothing, bytes, views, a response of any type, a promise of one, a compiled module", async () => {
  const copy = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength);
  const response = (/** @type {string} */ type) => new Response(copy, { headers: { "Content-Type": type } });
  const sources = [
    undefined,
    copy,
    new Uint8Array(copy),
    new DataView(copy),
    response("application/wasm"),
    response("text/html"),
    Promise.resolve(response("application/octet-stream")),
    await WebAssembly.compile(bytes),
    gear.module,
  ];
  for (const source of sources) {
    const loaded = await load(/** @type {any} */ (source));
    assert.deepEqual(loaded.modes(), gear.modes());
    assert.ok(loaded.module instanceof WebAssembly.Module);
  }
});

test("what gives no module is refused by load() with a GearError", async () => {
  const empty = new WebAssembly.Module(new Uint8Array([0, 97, 115, 109, 1, 0, 0, 0]));
  const importing = new Uint8Array([
    0, 97, 115, 109, 1, 0, 0, 0, 1, 4, 1, 96, 0, 0, 2, 7, 1, 1, 97, 1, 98, 0, 0,
  ]);
  await loadRefused(new Uint8Array([1, 2, 3]), "no wasm");
  await loadRefused(bytes.subarray(0, 1000), "half a wasm");
  await loadRefused(new Response("not here", { status: 404 }), "a failed response");
  await loadRefused(Promise.reject(new Error("no network")), "a promise that fails");
  await loadRefused("gear-bifurcations_bg.wasm", "a path");
  for (const source of [null, 1, true, {}, [], () => 1, Symbol("s")]) await loadRefused(source, String(source));
  await loadRefused(new Proxy({}, { get() { throw new Error("trap"); } }), "a hostile proxy");
  await loadRefused(empty, "somebody else's module");
  await loadRefused(importing, "a module that asks for what we do not have");
});

test("two loads are independent: a trap in one does not touch the other, nor a job that runs in it", async () => {
  const [first, second] = await Promise.all([load(), load()]);
  const steps = second.progress("12a");
  steps.next();
  refused(() => /** @type {any} */ (first).bench("trap", 1), { code: "internal" });
  assert.equal(steps.next().done, false);
  steps.return();
  assert.deepEqual(first.multipliers(), second.multipliers());
});

test("a trap becomes a GearError, and the next call works as if nothing had been", async () => {
  const own = await load();
  const before = own.multipliers();
  const steps = own.progress("12a");
  steps.next();
  for (let round = 0; round < 3; round += 1) {
    const error = refused(() => /** @type {any} */ (own).bench("trap", 1), { code: "internal" });
    assert.ok(!(error instanceof WebAssembly.RuntimeError));
    assert.deepEqual(own.multipliers(), before);
  }
  refused(() => steps.next(), { code: "internal" }, "a job that was lost says so");
  assert.deepEqual(steps.next(), { value: undefined, done: true }, "and then is over");
  assert.equal([...own.progress("2")].at(-1)?.done, true);
});

test("the module puts nothing into the global scope", async () => {
  const before = new Set(Reflect.ownKeys(globalThis));
  const own = await load();
  own.svg("2");
  const added = Reflect.ownKeys(globalThis).filter((name) => !before.has(name));
  assert.deepEqual(added, []);
  assert.ok(Object.isFrozen(own));
});

test("a GearError keeps its fields through JSON, whatever was given", () => {
  const error = refused(() => gear.modes({ k0: Number.NaN }), { code: "not-a-number", parameter: "k0" });
  assert.ok(Number.isNaN(error.given));
  assert.deepEqual(JSON.parse(JSON.stringify(error)), {
    code: "not-a-number",
    parameter: "k0",
    given: "NaN",
    allowed: [0, 1],
    message: error.message,
  });
  assert.ok(error instanceof Error && error instanceof GearError);
});

test("memory is given back on request, and the next call starts the module anew", async () => {
  const own = await load();
  const rest = () => /** @type {any} */ (own).rest();
  const before = own.multipliers();
  own.figure("14a");
  const grown = rest();
  assert.ok(grown > 3e6, `${grown} bytes`);
  assert.equal(rest(), 0, "there is nothing more to give");
  assert.deepEqual(own.multipliers(), before);
  const steps = own.progress("12a");
  steps.next();
  assert.equal(rest(), 0, "not from under a computation");
  assert.equal(steps.next().done, false);
  steps.return();
  const small = rest();
  assert.ok(small > 0 && small < grown, `${small} bytes`);
});
