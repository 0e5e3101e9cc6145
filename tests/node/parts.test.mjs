// One figure, computed in parts as by several workers, is the figure computed whole.

import assert from "node:assert/strict";
import { test } from "node:test";
import { merged } from "../../www/engine/parts.js";
import { gear } from "./support.mjs";

/** @typedef {import("../../www/engine/gear-bifurcations.js").Figure} Figure */

/** Loaded, with supports that soften: in some columns there is no response. */
const LOADED = [
  { k0: 0.4, Omega: 1.6, F: 1, alpha: -0.1, regime: "contact" },
  { k0: 0.4, Omega: 1.6, F: 0.02, alpha: -0.6, regime: "contact" },
];

/** @param {Figure} figure @param {string} mark */
function columns(figure, mark) {
  return figure.series.filter((series) => series.mark === mark).map((series) => series.columns);
}

/** @param {Record<string, number | string>} given @param {number} parts */
function begun(given, parts) {
  return Array.from({ length: parts }, (_, part) => gear.progress("T", /** @type {any} */ (given), { part, parts }));
}

for (const given of LOADED) {
  test(`figure T of ${JSON.stringify(given)} in parts`, () => {
    const whole = gear.figure("T", /** @type {any} */ (given));
    for (const parts of [2, 3]) {
      const computed = begun(given, parts).map((steps) => {
        assert.equal(steps.divided, true);
        return [...steps].at(-1)?.figure ?? null;
      });
      const all = merged(computed, computed.map(() => true));
      assert.equal(all.summary, whole.summary);
      const kinds = (/** @type {Figure} */ { series }) => series.map(({ name, mark }) => [name, mark]);
      assert.deepEqual(kinds(all), kinds(whole));
      const [ours, theirs] = [all, whole].map((figure) => columns(figure, "field")[0].z ?? new Float64Array());
      assert.equal(ours.length, theirs.length);
      // Whether a response is found where it hardly exists depends on the neighbours it is sought from; its value does not.
      const found = ours.filter((value, index) => value !== 0 && theirs[index] !== 0);
      assert.ok(found.length > 0.99 * ours.filter((value, index) => value !== 0 || theirs[index] !== 0).length);
      const unlike = ours.filter((value, index) => value !== 0 && theirs[index] !== 0 && Math.abs(value - theirs[index]) > 1e-6);
      assert.deepEqual([...unlike], []);
      // Every point without a response is marked, whoever looked for it.
      const [{ x, y }] = columns(all, "field");
      const missing = [...ours.keys()].filter((index) => ours[index] === 0).map((index) => `${x[index % x.length]} ${y[Math.floor(index / x.length)]}`);
      const marked = columns(all, "cloud").flatMap((cloud) => [...cloud.x].map((value, index) => `${value} ${cloud.y[index]}`));
      assert.deepEqual(marked.sort(), missing.sort());
      assert.ok((all.error.step ?? 0) <= 1e-6 || all.error.step === whole.error.step);
    }
  });
}

test("while some parts are not there, what is there stands for them", () => {
  const steps = begun(LOADED[0], 3);
  const [first, second] = steps.map((one) => one.next().value?.figure ?? null);
  const alone = merged([null, second, null], [false, false, false]);
  const [{ x, z }] = columns(alone, "field");
  assert.equal(z?.length, x.length * columns(alone, "field")[0].y.length);
  assert.ok(z?.every(Number.isFinite));
  const [own] = columns(/** @type {Figure} */ (second), "field");
  const both = columns(merged([first, second, null], [false, false, false]), "field")[0];
  assert.deepEqual([...(both.z ?? [])].filter((_, index) => index % x.length % 3 === 1), [...(own.z ?? [])].filter((_, index) => index % x.length % 3 === 1));
  for (const one of steps) one.return();
});

test("what cannot be divided is computed whole, and a part that there is not is refused", () => {
  const steps = gear.progress("T", {}, { part: 1, parts: 2 });
  assert.equal(steps.divided, false);
  assert.deepEqual([...steps].at(-1)?.figure.summary, gear.figure("T").summary);
  for (const options of [{ part: 2, parts: 2 }, { parts: 0 }, { parts: 65 }, { part: -1, parts: 3 }, { part: 0.5, parts: 2 }]) {
    assert.throws(() => gear.progress("T", {}, options), { code: "option" });
  }
});
