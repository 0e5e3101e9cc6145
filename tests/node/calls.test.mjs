// The shape of every answer, and its numbers against the references.

import assert from "node:assert/strict";
import { test } from "node:test";
import { allFinite, close, gear, reference } from "./support.mjs";

const ESTIMATES = ["liouville", "step", "residual"];
const COLUMNS = ["u_p", "u_g", "u", "u_p_dot", "u_g_dot", "u_dot"];

/** @param {any} result @param {string[]} estimates */
function provenance(result, estimates) {
  assert.ok(result.method.length > 5, "says its method");
  assert.deepEqual(Object.keys(result.error), estimates);
  for (const name of Object.keys(result.error)) {
    assert.ok(ESTIMATES.includes(name));
    assert.ok(result.error[name] >= 0);
  }
  allFinite(result, "result");
}

/** Distance from each expected multiplier to the nearest computed one. @param {any} found @param {number[][]} expected */
function multiplierDistance(found, expected) {
  const distances = expected.map(([re, im]) =>
    Math.min(...Array.from(found.re, (own, i) => Math.hypot(own - re, found.im[i] - im))),
  );
  return Math.max(...distances);
}

test("defaults() lists every parameter with what is known of it", () => {
  const defaults = gear.defaults();
  assert.equal(defaults.length, 18);
  const regime = defaults.pop();
  assert.deepEqual(regime.choices, ["homogeneous", "contact", "backlash"]);
  assert.equal(regime.default, "homogeneous");
  for (const info of defaults) {
    assert.deepEqual(
      Object.keys(info),
      "name symbol default low high range slider scale unit meaning follows short sets".split(" "),
    );
    assert.deepEqual(info.range, [info.low, info.high]);
    assert.ok(info.low <= info.default && info.default <= info.high, info.name);
    assert.deepEqual(info.sets, [info.name]);
    assert.ok(info.meaning.length > 5);
  }
  const own = Object.fromEntries(defaults.map((/** @type {any} */ info) => [info.name, info.default]));
  assert.deepEqual(gear.multipliers(own), gear.multipliers(), "the defaults are what is taken by default");
});

test("modes() agrees with the reference to 1e-12", () => {
  for (const expected of reference("modes_and_tongues")) {
    const modes = gear.modes({ m: expected.m, k: expected.k });
    provenance(modes, []);
    assert.ok(modes.omega instanceof Float64Array && modes.shapes instanceof Float64Array);
    assert.deepEqual([modes.omega.length, modes.shapes.length], [3, 9]);
    close(modes.a, expected.a, 1e-12 * Math.abs(expected.a), "a");
    close(modes.b, expected.b, 1e-12 * Math.abs(expected.b), "b");
    for (const [j, omega] of expected.omega.entries()) close(modes.omega[j], omega, 1e-12, `omega_${j + 1}`);
    assert.deepEqual(Array.from(modes.shapes), [1, 1, 0, -2, 2, modes.a, -2, 2, modes.b]);
  }
});

test("tongues(): formula widths to 1e-12 of the reference", () => {
  for (const expected of reference("modes_and_tongues")) {
    const k0 = 0.25;
    const tongues = gear.tongues({ m: expected.m, k: expected.k, k0, zeta: 0 });
    provenance(tongues, []);
    for (const name of ["primary2", "primary3", "combination"]) {
      const tongue = tongues[name];
      assert.deepEqual(Object.keys(tongue), "Omega0 paper corrected damped hill hillError threshold".split(" "));
      close(tongue.Omega0, expected.Omega0[name], 1e-12, `${name}.Omega0`);
      const paper = expected.half_width_paper[name === "combination" ? "combination_105" : name];
      const corrected =
        name === "combination" ? expected.half_width_corrected.combination_T4 : expected.half_width_paper[name];
      close(tongue.paper.right - tongue.Omega0, k0 * paper, 1e-12, `${name}.paper`);
      close(tongue.Omega0 - tongue.corrected.left, k0 * corrected, 1e-12, `${name}.corrected`);
    }
    assert.equal(tongues.combination.hill, null);
  }
});

test("tongues(): Hill's determinant to 1e-9 of the exact edges, closed ones closed", () => {
  const names = { primary2: "2w2", primary3: "2w3" };
  for (const [setting, edges] of Object.entries(reference("tongue_edges").edges)) {
    const [k0, zeta] = [...setting.matchAll(/=([\d.]+)/g)].map((match) => Number(match[1]));
    const tongues = gear.tongues({ k0, zeta });
    for (const [name, key] of Object.entries(names)) {
      const expected = /** @type {any} */ (edges)[key];
      const { hill } = tongues[name];
      if (expected === null) {
        assert.deepEqual(hill, { left: null, right: null }, `${setting} ${name}`);
      } else {
        close(hill.left, expected.left, 1e-9, `${setting} ${name} left`);
        close(hill.right, expected.right, 1e-9, `${setting} ${name} right`);
      }
    }
  }
});

test("multipliers() to 1e-9 of the reference, equal and unequal supports", () => {
  for (const { params, multipliers } of reference("floquet_multipliers")) {
    const found = gear.multipliers(params);
    provenance(found, ["liouville", "step"]);
    const tolerance = params.zeta === 0 ? 1e-8 : 1e-9; // Undamped, double multipliers on the circle split by sqrt(eps).
    assert.ok(multiplierDistance(found, multipliers) < tolerance, JSON.stringify(params));
    const moduli = Array.from(found.re, (re, i) => Math.hypot(re, found.im[i]));
    // Undamped, all moduli are 1 but for rounding, which orders them otherwise than we can measure them here.
    assert.ok(moduli.every((modulus, i) => i === 0 || modulus <= moduli[i - 1] * (1 + 1e-14)), "largest first");
    close(found.spectralRadius, moduli[0], 1e-12, "spectralRadius");
    assert.equal(found.stable, moduli[0] <= 1 + 1e-9);
    assert.deepEqual(Array.from(found.state), [0, 0, 0, 0, 0, 0]);
  }
});

test("multipliers() of a loaded pair are about its periodic response", () => {
  const params = { zeta: 0.07, alpha: -1.3, F: 1.5, Omega: 1.6, regime: "contact" };
  const found = gear.multipliers(params);
  provenance(found, ["liouville", "step", "residual"]);
  const expected = reference("periodic_orbits").orbits.find((/** @type {any} */ orbit) => orbit.figure === "14b");
  for (const [i, value] of expected.state.entries()) close(found.state[i], value, 1e-8, `state[${i}]`);
  assert.equal(found.stable, true);
});

test("periodicOrbit() to 1e-8 of the reference", () => {
  for (const { figure, params, period_in_T, state, multipliers, min, max } of reference("periodic_orbits").orbits) {
    const orbit = gear.periodicOrbit(params, { period: period_in_T, guess: state });
    provenance(orbit, ["liouville", "step", "residual"]);
    assert.equal(orbit.period, period_in_T);
    assert.equal(orbit.stable, true);
    for (let i = 0; i < 6; i += 1) {
      close(orbit.state[i], state[i], 1e-8, `${figure} state[${i}]`);
      // The reference's are the extremes of samples: never beyond the true ones, and a few 1e-6 short of them.
      for (const beyond of [min[i] - orbit.min[i], orbit.max[i] - max[i]]) {
        assert.ok(beyond > -1e-9 && beyond < 5e-6, `${figure} extremes of coordinate ${i}: ${beyond}`);
      }
    }
    assert.ok(multiplierDistance(orbit.multipliers, multipliers) < 1e-8, `${figure} multipliers`);
    // Without a guess the same orbit, perhaps a period of the mesh later.
    const unguided = gear.periodicOrbit(params, { period: period_in_T });
    close(Math.abs(unguided.state[0]), Math.abs(state[0]), 1e-8, `${figure} without a guess`);
  }
});

test("timeResponse(): columns of one length, evenly spaced, on the periodic orbit after its transient", () => {
  const params = { zeta: 0.07, alpha: -1.3, F: 1.5, Omega: 1.6, regime: "backlash" };
  const motion = gear.timeResponse(params, { periods: 300, samplesPerPeriod: 50 });
  provenance(motion, ["step"]);
  assert.equal(motion.t.length, 15_001);
  for (const name of COLUMNS) assert.equal(motion[name].length, motion.t.length, name);
  const period = (2 * Math.PI) / 1.6;
  close(motion.t[50], period, 1e-12, "t");
  assert.deepEqual([motion.u_p[0], motion.u[0], motion.escaped], [0, 1, null]);
  const { state } = reference("periodic_orbits").orbits.find((/** @type {any} */ orbit) => orbit.figure === "14b");
  for (const [i, name] of COLUMNS.entries()) close(motion[name].at(-1), state[i], 1e-7, name);
});

test("timeResponse(): figure 14 a loses contact in backlash, and escapes or grows in contact", () => {
  const params = { zeta: 0.07, alpha: 0, F: 1.5, Omega: 1.6 };
  const backlash = gear.timeResponse({ ...params, regime: "backlash" }, { periods: 400 });
  assert.equal(backlash.escaped, null);
  const settled = backlash.u.slice(-64 * 20);
  close(Math.min(...settled), -0.4539, 5e-3, "least u");
  close(Math.max(...settled), 4.9618, 5e-3, "greatest u");
  assert.ok(backlash.contactLoss.length > 100);
  for (const time of backlash.contactLoss) assert.ok(time > 0 && time <= backlash.t.at(-1));
  const contact = gear.timeResponse({ ...params, regime: "contact" }, { periods: 100 });
  assert.ok(Math.max(...contact.u) > 50, "it grows without bound");
  assert.ok(contact.contactLoss[0] > 0, "and says where (25) ceases to hold");
});

test("an escape is an answer: drawn up to where it left, with its time", () => {
  const params = { zeta: 0.02, alpha: -0.2, Omega: 1.6 };
  const state = [9, -9, 0, 20, -20, 0];
  const motion = gear.timeResponse(params, { state });
  allFinite(motion, "motion");
  assert.ok(motion.escaped > 0);
  close(motion.t.at(-1), motion.escaped, 1e-12, "the last time");
  const bound = 10 * Math.sqrt(5 / 0.2);
  close(Math.max(Math.abs(motion.u_p.at(-1)), Math.abs(motion.u_g.at(-1))), bound, 1e-6 * bound, "the bound");
  const strobe = gear.poincare(params, { state });
  allFinite(strobe, "strobe");
  close(strobe.escaped, motion.escaped, 1e-8, "the same time");
});

test("poincare() is the time response seen once a period", () => {
  const params = { zeta: 0.02, Omega: 1.65 };
  const strobe = gear.poincare(params, { transient: 5, points: 20, state: [1, -1, 0.5, 0, 0, 0] });
  provenance(strobe, ["step"]);
  const motion = gear.timeResponse(params, { periods: 24, samplesPerPeriod: 1, state: [1, -1, 0.5, 0, 0, 0] });
  assert.equal(strobe.t.length, 20);
  for (const name of ["t", ...COLUMNS]) {
    for (let i = 0; i < 20; i += 1) close(strobe[name][i], motion[name][i + 5], 1e-8, `${name}[${i}]`);
  }
});

test("Omega_p and Omega_g must be commensurate where the question is stroboscopic, and need not in time", () => {
  const params = { regime: "contact", F: 5, F_p: 0.1, zeta: 0.07 };
  gear.timeResponse({ ...params, Omega_p: 1 }, { periods: 5 });
  const third = gear.periodicOrbit({ ...params, Omega_p: 1.6 / 3 }, { period: 3 });
  assert.equal(third.period, 3);
});

test("fromPhysical() and toPhysical() go there and back, with the corrected equivalent mass", () => {
  const si = {
    M_p: 0.8, M_g: 1.9, I_p: 4e-4, I_g: 2.5e-3, r_p: 0.03, r_g: 0.06, K: 2e8, K_amplitude: 6e7, K_p: 5e8, K_g: 7e8,
    K_p3: -1e16, K_g3: 2e16, C: 900, C_p: 400, C_g: 500, b: 5e-5, E: 1e-5, T_p: 150, T_g: 300, T_p_amplitude: 20,
    T_g_amplitude: 30, omega_p: 700, omega_g: 300, teeth_p: 20, teeth_g: 40, rpm_p: 6000,
  };
  const { params, scales, method, error } = gear.fromPhysical(si);
  assert.ok(method && error);
  close(1 / scales.M, 0.03 ** 2 / 4e-4 + 0.06 ** 2 / 2.5e-3, 1e-12, "1/M");
  close(scales.omega_n, Math.sqrt(2e8 / scales.M), 1e-9, "omega_n");
  assert.equal(scales.b, 5e-5);
  // Balanced torques: the tooth force T_p/r_p over K b.
  close(params.F, 150 / 0.03 / (2e8 * 5e-5), 1e-12, "F");
  close(params.Omega, (2 * Math.PI * 2000) / scales.omega_n, 1e-12, "Omega");
  const back = gear.toPhysical(params, scales);
  for (const [name, value] of Object.entries(si)) close(back[name], value, 1e-12 * Math.abs(value), name);
  close(back.mesh_frequency, 2000, 1e-9, "mesh_frequency");
  close(back.rpm_g, 3000, 1e-9, "rpm_g");
  close(back.F, 5000, 1e-8, "F in newtons");
  const bare = gear.toPhysical(params, { M: scales.M, omega_n: scales.omega_n, b: scales.b });
  assert.equal(bare.rpm_p, undefined);
  close(bare.mesh_frequency, 2000, 1e-9, "mesh_frequency needs no geometry");
});
