// What the tests of the module share: the built module, the reference numbers, and what a refusal must look like.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";

/** @typedef {import("../../www/engine/gear-bifurcations.js").Gear} Gear */
/** @typedef {import("../../www/engine/gear-bifurcations.js").GearError} GearErrorType */
/** @typedef {import("../../www/engine/gear-bifurcations.js").Figure} Figure */

/** Where the build put the module. */
export const script = new URL("../../dist/gear-bifurcations.js", import.meta.url).href;

/** @type {typeof import("../../www/engine/gear-bifurcations.js")} */
const built = await import(script);
export const { GearError, load } = built;

/** The calls; `any`, because much of what is tested is what types would forbid. */
/** @type {any} */
export const gear = await load();

/** @param {string} name @returns {any} */
export function reference(name) {
  return JSON.parse(readFileSync(new URL(`../reference/${name}.json`, import.meta.url), "utf8"));
}

/**
 * Seconds this process has computed so far: unlike a clock on the wall it does not run while others have the machine.
 *
 * @returns {number}
 */
export function secondsComputed() {
  const { user, system } = process.cpuUsage();
  return (user + system) / 1e6;
}

/** @param {number} actual @param {number} expected @param {number} tolerance @param {string} what */
export function close(actual, expected, tolerance, what) {
  assert.ok(
    Math.abs(actual - expected) <= tolerance,
    `${what}: ${actual} is ${Math.abs(actual - expected)} from ${expected}, allowed is ${tolerance}`,
  );
}

/**
 * Runs what must be refused, and checks that the refusal is a whole GearError.
 *
 * @param {() => unknown} run
 * @param {Partial<GearErrorType>} [expected]
 * @param {string} [what]
 * @returns {GearErrorType}
 */
export function refused(run, expected = {}, what = "") {
  let thrown;
  try {
    run();
  } catch (error) {
    thrown = error;
  }
  checkRefusal(thrown, expected, what);
  return /** @type {GearErrorType} */ (thrown);
}

/** @param {unknown} thrown @param {Partial<GearErrorType>} expected @param {string} what */
export function checkRefusal(thrown, expected, what) {
  assert.ok(thrown instanceof GearError, `${what}: a GearError, and not ${thrown}`);
  assert.equal(thrown.name, "GearError");
  assert.match(thrown.code, /^[a-z-]+$/, what);
  assert.ok(thrown.message.length > 10, `${what}: a sentence`);
  assert.ok(thrown.parameter === null || typeof thrown.parameter === "string", what);
  assert.ok(["number", "string"].includes(typeof thrown.given) || thrown.given === null, what);
  const { allowed } = thrown;
  assert.ok(
    allowed === null ||
      typeof allowed === "string" ||
      (allowed.length === 2 && allowed.every((bound) => Number.isFinite(bound))),
    what,
  );
  for (const [field, value] of Object.entries(expected)) {
    assert.deepEqual(/** @type {any} */ (thrown)[field], value, `${what}: ${field} of "${thrown.message}"`);
  }
}

/**
 * Every number anywhere in a result is finite.
 *
 * @param {any} value
 * @param {string} path
 */
export function allFinite(value, path) {
  if (typeof value === "number") {
    assert.ok(Number.isFinite(value), `${path} is ${value}`);
  } else if (ArrayBuffer.isView(value)) {
    const bad = /** @type {any} */ (value).findIndex((/** @type {number} */ number) => !Number.isFinite(number));
    assert.equal(bad, -1, `${path}[${bad}] is not finite`);
  } else if (value !== null && typeof value === "object") {
    for (const [name, inner] of Object.entries(value)) allFinite(inner, `${path}.${name}`);
  }
}
