// A handle that goes ahead of its chart.

import assert from "node:assert/strict";
import { test } from "node:test";
import { withHandleAt } from "../../www/figure/ahead.js";

/** @param {Partial<import("../../www/engine/gear-bifurcations.js").FigureSeries>} given */
const series = (given) => /** @type {any} */ ({ frame: "tongues", name: "present", role: "handle", label: "stable", meaning: "the present", columns: { x: Float64Array.of(1.5), y: Float64Array.of(0.5) }, ...given });
const axes = [{ frame: "tongues", x: { name: "Omega" }, y: { name: "k0" } }, { frame: "map", x: { name: "u_p" }, y: { name: "u_p_dot" } }];
const figure = (/** @type {any[]} */ all) => /** @type {any} */ ({ id: "T", axes, series: all });
const at = (/** @type {Record<string, number>} */ point) => (/** @type {string} */ name) => point[name] ?? null;

test("the handle stands where it is put, and all else is as it was", () => {
  const edge = series({ role: "exact", columns: { x: Float64Array.of(1, 2), y: Float64Array.of(0, 1) } });
  const before = figure([edge, series({})]);
  const after = withHandleAt(before, at({ Omega: 1.7, k0: 0.4 }));
  assert.deepEqual([...after.series[1].columns.x, ...after.series[1].columns.y], [1.7, 0.4]);
  assert.equal(after.series[1].label, "stable");
  assert.equal(after.series[0], edge);
  assert.deepEqual([...before.series[1].columns.x], [1.5]);
});

test("what it says of its old place can be left out", () => {
  const [handle] = withHandleAt(figure([series({})]), at({ Omega: 1.7, k0: 0.4 }), true).series;
  assert.deepEqual([handle.label, handle.meaning], [null, ""]);
});

test("where nothing moves, or no parameter says where to stand, it is the same figure", () => {
  for (const [of, point] of /** @type {[any, Record<string, number>][]} */ ([
    [figure([series({})]), { Omega: 1.5, k0: 0.5 }],
    [figure([series({})]), { Omega: 1.7 }],
    [figure([series({ frame: "map" })]), { Omega: 1.7, k0: 0.4 }],
    [figure([series({ columns: { x: Float64Array.of(1, 2), y: Float64Array.of(0, 1) } })]), { Omega: 1.7, k0: 0.4 }],
  ])) {
    assert.equal(withHandleAt(of, at(point)), of);
  }
});
