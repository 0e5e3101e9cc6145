// The exact answers against the references: tongues, charts, branches, tori, contact.

import assert from "node:assert/strict";
import { test } from "node:test";
import { allFinite, close, gear, reference, refused } from "./support.mjs";

const TONGUES = { "2w2": "primary2", "w2+w3": "combination", "2w3": "primary3" };
const KINDS = { "-1": "period-doubling", NS: "neimark-sacker", Krein: "krein" };

test("tongueEdges() to 1e-9 of the reference, with their kinds, closed ones closed", () => {
  for (const [setting, edges] of Object.entries(reference("tongue_edges").edges)) {
    const [k0, zeta] = [...setting.matchAll(/=([\d.]+)/g)].map((match) => Number(match[1]));
    for (const [key, expected] of Object.entries(/** @type {any} */ (edges))) {
      const tongue = /** @type {any} */ (TONGUES)[key];
      const found = gear.tongueEdges({ k0, zeta }, { tongue });
      allFinite(found, setting);
      const what = `${setting} ${key}`;
      if (expected === null) {
        assert.deepEqual([found.left, found.right, found.kind], [null, null, null], what);
        continue;
      }
      close(found.left, expected.left, 1e-9, `${what} left`);
      close(found.right, expected.right, 1e-9, `${what} right`);
      const kind = /** @type {any} */ (KINDS)[expected.type];
      assert.deepEqual(found.kind, [kind, kind], what);
      const near = gear.tongueEdges({ k0, zeta }, { tongue: { near: (expected.left + expected.right) / 2 } });
      close(near.left, expected.left, 1e-8, `${what} by a frequency within`);
    }
  }
});

test("tongueBoundary() passes through the edges", () => {
  const edges = reference("tongue_edges").edges["k0=0.5 zeta=0.02"]["2w2"];
  const boundary = gear.tongueBoundary({ zeta: 0.02 }, { tongue: "primary2", k0: [0, 0.5], points: 90 });
  allFinite(boundary, "boundary");
  assert.equal(boundary.Omega.length, 90);
  assert.equal(boundary.kind.length, 90);
  close(boundary.Omega[0], edges.left, 1e-9, "it begins at the left edge");
  close(boundary.Omega[89], edges.right, 1e-9, "and ends at the right one");
  assert.ok(boundary.tip.k0 < Math.min(...boundary.k0) + 1e-9, "the tip is the lowest point");
});

test("stabilityChart() is the multipliers' spectral radius, within its own error", () => {
  const chart = gear.stabilityChart({ zeta: 0.02 }, { Omega: [0.5, 6.5, 61], k0: [0, 1, 21] });
  allFinite(chart, "chart");
  for (const [i, j] of [[11, 10], [30, 20], [50, 15], [0, 7], [60, 20]]) {
    const direct = gear.multipliers({ zeta: 0.02, Omega: chart.Omega[i], k0: chart.k0[j] }).spectralRadius;
    close(chart.spectralRadius[j * 61 + i], direct, Math.max(1e-6, chart.error.step), `Omega ${chart.Omega[i]}`);
  }
});

test("branch(): the orbits and bifurcations of the reference", () => {
  const { tongue2, events } = reference("orbit_branch");
  const branch = gear.branch({ zeta: 0.02, Omega: 1.65 }, { period: 2, range: [1.25, 1.75] });
  allFinite(branch, "branch");
  const rows = branch.Omega.length;
  assert.deepEqual([branch.state.length, branch.re.length, branch.im.length], [6 * rows, 6 * rows, 6 * rows]);
  const at = (/** @type {string} */ kind, /** @type {number} */ value) =>
    branch.events.some((/** @type {any} */ event) => event.kind === kind && Math.abs(event.Omega - value) < 1e-7);
  assert.ok(at("fold", events.fold) && at("neimark-sacker", events.torus), JSON.stringify(branch.events.map((/** @type {any} */ e) => [e.kind, e.Omega])));
  const across = branch.events.find((/** @type {any} */ event) => event.breaks === "exchange" && Math.abs(event.Omega - events.branch_point_across_manifold) < 1e-6);
  assert.ok(across, "the pitchfork across the manifold");
  const orbit = tongue2.find((/** @type {any} */ row) => row.Omega === 1.66);
  const from = [orbit.u_p, -orbit.u_p, orbit.u, orbit.u_p_dot, -orbit.u_p_dot, orbit.u_dot];
  const found = gear.branch({ zeta: 0.02, Omega: 1.66 }, { period: 2, from, range: [1.655, 1.665], points: 20 });
  const sizes = Array.from(found.maxU_p);
  assert.ok(Math.min(...sizes) < orbit.max_u_p && orbit.max_u_p < Math.max(...sizes));
});

test("diagram(): from rest through both primary tongues", () => {
  const { branches } = gear.diagram({ zeta: 0.02 }, { Omega: [1.4, 1.8], maxPeriod: 2, maxBranches: 6 });
  allFinite(branches, "diagram");
  const edges = reference("tongue_edges").edges["k0=0.5 zeta=0.02"]["2w2"];
  const doublings = branches[0].events.filter((/** @type {any} */ event) => event.kind === "period-doubling");
  close(doublings[0].Omega, edges.left, 1e-7, "left");
  close(doublings[1].Omega, edges.right, 1e-7, "right");
  assert.equal(branches[0].from, null);
  assert.equal(branches[1].from.branch, 0);
});

test("torus() to 1e-5 and 1e-7 of the reference", () => {
  for (const row of reference("tori").tori) {
    const found = gear.torus({ zeta: 0.02, Omega: row.Omega });
    allFinite(found, "torus");
    close(found.meanRadius, row.mean_radius, 1e-5, `mean radius at ${row.Omega}`);
    close(found.rotation, row.rotation, 1e-7, `rotation at ${row.Omega}`);
  }
});

test("lyapunov(): the sum is the trace, whatever the motion", () => {
  const { exponents } = gear.lyapunov({ zeta: 0.02, Omega: 3.7 }, { periods: 300 });
  // -(2 zeta/m + 2 zeta/m + 2 zeta (1 + 1/m + 1/m)).
  close(exponents.reduce((/** @type {number} */ sum, /** @type {number} */ one) => sum + one, 0), -0.2, 1e-8, "sum");
  assert.deepEqual(Array.from(exponents), Array.from(exponents).sort((x, y) => y - x));
});

test("contactMargin() and leastLoad() of figure 14", () => {
  const params = { zeta: 0.07, alpha: -1.3, F: 1.5, Omega: 1.6, regime: "contact" };
  const { min } = reference("periodic_orbits").orbits.find((/** @type {any} */ orbit) => orbit.figure === "14b");
  close(gear.contactMargin(params).margin, min[2] - 1, 5e-6, "margin");
  refused(() => gear.contactMargin({ F: 0 }), { code: "not-allowed", parameter: "regime" });
  refused(() => gear.leastLoad({}), { code: "not-allowed", parameter: "regime" });
});

test("options of the exact answers are refused by name", () => {
  for (const tongue of [undefined, null, "primary1", 3, {}, { near: -1 }, { near: Number.NaN }, { close: 1 }]) {
    refused(() => gear.tongueEdges({}, { tongue }), {}, `tongue ${JSON.stringify(tongue)}`);
  }
  for (const grid of [undefined, null, [1], [1, 2], [2, 1, 5], [1, 2, 1.5], [1, 2, 5000], [0, 2, 5], ["1", 2, 3], { length: 1e12 }]) {
    refused(() => gear.stabilityChart({}, { Omega: grid, k0: [0, 1, 3] }), { code: "option", parameter: "Omega" });
    refused(() => gear.sweep({}, { Omega: grid }), { code: "option", parameter: "Omega" });
  }
  for (const range of [null, [1], [2, 1], [0, 2], [1, Number.POSITIVE_INFINITY], "1, 2"]) {
    refused(() => gear.branch({}, { range }), { code: "option", parameter: "range" });
    refused(() => gear.diagram({}, { Omega: range }), { code: "option", parameter: "Omega" });
  }
  refused(() => gear.branch({}, { parameter: "omega" }), { code: "option", parameter: "parameter" });
  refused(() => gear.branch({}, { parameter: "Omega_p" }), { code: "option", parameter: "parameter" });
  for (const plane of [null, "u_p", ["u_p"], ["u_p", "u_p"], ["u_p", "x"], ["u_p", "u", "u_g"], [1, 2]]) {
    refused(() => gear.basin({}, { plane, x: [-1, 1, 3], y: [-1, 1, 3] }), { code: "option", parameter: "plane" });
  }
  refused(() => gear.sweep({}, { Omega: [1, 2, 3], direction: "sideways" }), { code: "option", parameter: "direction" });
});
