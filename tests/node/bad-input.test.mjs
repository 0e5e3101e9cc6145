// Bad input of all kinds, for every call: always a whole GearError, or a finite answer; never anything else.

import assert from "node:assert/strict";
import { test } from "node:test";
import { allFinite, checkRefusal, gear, refused, secondsComputed } from "./support.mjs";

/** A getter that throws, an object that hides, and others that are no plain objects. */
const hostile = {
  "a getter that throws": Object.defineProperty({}, "k0", {
    enumerable: true,
    get() {
      throw new Error("from a getter");
    },
  }),
  "a proxy that throws": new Proxy({}, {
    ownKeys() {
      throw new Error("from a proxy");
    },
  }),
  "a proxy whose prototype throws": new Proxy({}, {
    getPrototypeOf() {
      throw new Error("from a proxy");
    },
  }),
  "a revoked proxy": (() => {
    const { proxy, revoke } = Proxy.revocable({}, {});
    revoke();
    return proxy;
  })(),
  "a name that is a symbol": { [Symbol("k0")]: 1 },
  "a thousand names": Object.fromEntries(Array.from({ length: 1000 }, (_, i) => [`name${i}`, i])),
};
const notObjects = {
  null: null,
  "a number": 3,
  "NaN": Number.NaN,
  "a text": "k0=1",
  "true": true,
  "a BigInt": 3n,
  "a symbol": Symbol("p"),
  "a function": () => ({}),
  "an array": [1],
  "a map": new Map([["k0", 1]]),
  "a date": new Date(0),
  "a typed array": new Float64Array(3),
  "an inheriting object": Object.create({ k0: 0.1 }),
  "a class of its own": new (class Parameters {})(),
};
/** Values that are no finite number. */
const notNumbers = {
  NaN: Number.NaN,
  Infinity: Number.POSITIVE_INFINITY,
  "-Infinity": Number.NEGATIVE_INFINITY,
  "a text": "0.5",
  "an empty text": "",
  null: null,
  undefined: undefined,
  "true": true,
  "a BigInt": 1n,
  "a symbol": Symbol("v"),
  "an array": [0.5],
  "an object": {},
  "a Number object": new Number(0.5),
  "a date": new Date(1),
  "an object with valueOf": { valueOf: () => 0.5 },
};

/** Every call that takes parameters, cheaply. @type {Record<string, (p: any) => unknown>} */
const calls = {
  modes: (p) => gear.modes(p),
  tongues: (p) => gear.tongues(p),
  multipliers: (p) => gear.multipliers(p),
  timeResponse: (p) => gear.timeResponse(p, { periods: 3 }),
  poincare: (p) => gear.poincare(p, { points: 3 }),
  periodicOrbit: (p) => gear.periodicOrbit(p),
  tongueEdges: (p) => gear.tongueEdges(p, { tongue: "primary2" }),
  tongueBoundary: (p) => gear.tongueBoundary(p, { tongue: "primary2", points: 5 }),
  stabilityChart: (p) => gear.stabilityChart(p, { Omega: [1.5, 1.6, 3], k0: [0, 0.5, 3] }),
  branch: (p) => gear.branch(p, { range: [1.5, 1.7], points: 5 }),
  diagram: (p) => gear.diagram(p, { Omega: [1.75, 1.8], maxBranches: 1 }),
  sweep: (p) => gear.sweep(p, { Omega: [2.2, 2.3, 2], transient: 3, points: 2 }),
  lyapunov: (p) => gear.lyapunov(p, { periods: 5 }),
  basin: (p) => gear.basin(p, { x: [-1, 1, 3], y: [-1, 1, 3], periods: 20 }),
  spectrum: (p) => gear.spectrum(p, { transient: 2, periods: 4 }),
  toPhysical: (p) => gear.toPhysical(p, { M: 1, omega_n: 1, b: 1 }),
  figure: (p) => gear.figure("2", p),
  progress: (p) => gear.progress("2", p).next().value,
  svg: (p) => gear.svg("2", p),
};

/** Either a refusal or a finite answer. @param {() => unknown} run @param {string} what */
function refusedOrFinite(run, what) {
  let answer;
  try {
    answer = run();
  } catch (thrown) {
    // Not asked a second time: a refusal may be the end of a long search.
    checkRefusal(thrown, {}, what);
    return;
  }
  allFinite(answer, what);
}

for (const [name, call] of Object.entries(calls)) {
  test(`${name}(): parameters that are no plain object`, () => {
    assert.ok(call(undefined));
    assert.ok(call({}));
    assert.ok(call(Object.assign(Object.create(null), { m: 1 })), "an object without a prototype is plain");
    for (const [what, p] of [...Object.entries(notObjects), ...Object.entries(hostile)]) {
      refused(() => call(p), { code: "not-an-object" }, `${name}: ${what}`);
    }
  });

  test(`${name}(): values that are no number, by name`, () => {
    for (const parameter of ["m", "m_p", "k_g", "alpha", "zeta", "zeta_s", "k0", "Omega", "F", "E", "Omega_p"]) {
      for (const [what, value] of Object.entries(notNumbers)) {
        const error = refused(
          () => call({ [parameter]: value }),
          { code: "not-a-number", parameter },
          `${name}: ${parameter} = ${what}`,
        );
        assert.equal(/** @type {any} */ (error.allowed).length, 2);
        if (typeof value === "number" || typeof value === "string") assert.deepEqual(error.given, value);
      }
    }
  });

  test(`${name}(): unknown names, wrong regimes, numbers out of range, at the ends and beyond`, () => {
    for (const parameter of ["omega", "K0", "", "constructor", "__proto__x", "m_p ", "Ω", "x".repeat(100_000)]) {
      refused(() => call({ [parameter]: 1 }), { code: "unknown-parameter", parameter }, name);
    }
    for (const regime of ["Homogeneous", "", "free", 0, null, undefined, {}, ["contact"], Symbol("r"), 1n]) {
      refused(() => call({ regime }), { code: "not-a-choice", parameter: "regime" }, name);
    }
    for (const { name: parameter, low, high } of gear.defaults().slice(0, -1)) {
      for (const value of [low - 1, high + 1, -1e300, 1e300, high * (1 + 1e-15), -Number.MAX_VALUE]) {
        refused(
          () => call({ [parameter]: value }),
          { code: "out-of-range", parameter, given: value, allowed: [low, high] },
          `${name}: ${parameter} = ${value}`,
        );
      }
    }
    for (const parameter of ["F", "F_p", "F_g", "E"]) {
      refused(() => call({ [parameter]: 1, regime: "homogeneous" }), { code: "not-allowed", parameter }, name);
    }
  });
}

test("the paper's formulas refuse unequal supports", () => {
  for (const parameter of ["m", "k", "alpha", "zeta"]) {
    const p = { [`${parameter}_p`]: 1.5, [`${parameter}_g`]: 1.25 };
    refused(() => gear.modes(p), { code: "asymmetric", parameter });
    refused(() => gear.tongues(p), { code: "asymmetric", parameter });
    refused(() => gear.figure("9", p), { code: "asymmetric", parameter });
  }
});

test("stroboscopic and periodic questions refuse loads without a common period", () => {
  const p = { regime: "contact", F: 5, F_p: 0.1, Omega_p: 1.6 * Math.SQRT2 };
  for (const name of ["multipliers", "poincare", "periodicOrbit"]) {
    const error = refused(() => calls[name](p), { code: "incommensurate", parameter: "Omega_p" }, name);
    assert.equal(error.given, 1.6 * Math.SQRT2);
  }
});

/** Options of each call: a valid value, and what is out of range. @type {Record<string, Record<string, unknown[]>>} */
const wrongOptions = {
  multipliers: { tolerance: [0, -1, 1, 1e-15, 1e-2] },
  timeResponse: {
    tolerance: [0, 1],
    periods: [0, -1, 1e5 + 1, 1e300, -1e-300],
    samplesPerPeriod: [0, -1, 1.5, 10_001, 1e300],
    state: [[], [1], [1, 2, 3, 4, 5], [1, 2, 3, 4, 5, 6, 7], [0, 0, 1e7, 0, 0, 0], [0, 0, Number.NaN, 0, 0, 0],
      [0, 0, "1", 0, 0, 0], new Float64Array(5), new Float64Array(1e6), { length: 6 }, { length: -1 }, { length: 1e300 },
      { length: "6" }, [1e6, 0, 0, 0, 0, 0], new Array(6), "000000"],
  },
  poincare: {
    tolerance: [0, 1],
    transient: [-1, 0.5, 1e6 + 1, 1e300],
    points: [0, -1, 1.5, 1e6 + 1, 2 ** 53],
    state: [[1], [0, 0, 0, 0, 0, Number.POSITIVE_INFINITY]],
  },
  periodicOrbit: { tolerance: [0, 1], period: [0, -1, 1.5, 65, 2 ** 32], guess: [[1], [0, 0, 0, 0, 0, Number.NaN]] },
  svg: {
    width: [0, -1, 119, 8193, 1e300],
    height: [0, 119, 8193],
    theme: ["", "Light", "sepia", "x".repeat(10_000)],
    unit: ["", "cm", "MM", 1, null],
  },
};
/** @type {Record<string, (options: any) => unknown>} */
const withOptions = {
  multipliers: (options) => gear.multipliers({}, options),
  timeResponse: (options) => gear.timeResponse({}, options),
  poincare: (options) => gear.poincare({}, options),
  periodicOrbit: (options) => gear.periodicOrbit({}, options),
  svg: (options) => gear.svg("2", {}, options),
};

for (const [name, call] of Object.entries(withOptions)) {
  test(`${name}(): wrong options`, () => {
    for (const [what, options] of [...Object.entries(notObjects), ...Object.entries(hostile)]) {
      const error = refused(() => call(options), {}, `${name}: ${what}`);
      assert.ok(["not-an-object", "option"].includes(error.code), what);
    }
    for (const option of ["nothing", "Tolerance", "", "length", "x".repeat(100_000)]) {
      refused(() => call({ [option]: 1 }), { code: "option", parameter: option }, `${name}: ${option}`);
    }
    for (const [option, values] of Object.entries(wrongOptions[name])) {
      for (const value of values) {
        refused(() => call({ [option]: value }), { code: "option", parameter: option }, `${name}: ${option} = ${value}`);
      }
      for (const [what, value] of Object.entries(notNumbers)) {
        if (value === undefined || (option === "theme" && typeof value === "string")) continue;
        refused(() => call({ [option]: value }), { code: "option", parameter: option }, `${name}: ${option} = ${what}`);
      }
    }
  });
}

test("an option that is undefined is as if left out", () => {
  const options = { state: undefined, periods: undefined, samplesPerPeriod: undefined, tolerance: undefined };
  assert.deepEqual(gear.timeResponse({}, options), gear.timeResponse({}));
  assert.equal(gear.svg("2", {}, { theme: undefined, view: undefined, width: undefined }), gear.svg("2"));
});

test("sizes are refused before anything is allocated or computed", () => {
  const started = secondsComputed();
  refused(() => gear.timeResponse({}, { periods: 1e5, samplesPerPeriod: 1e4 }), { code: "option", parameter: "periods" });
  refused(() => gear.poincare({}, { points: 1e6, transient: 1 }), { code: "option", parameter: "points" });
  refused(() => gear.modes({}, { anything: 1 }), { code: "option", parameter: "anything" });
  refused(() => gear.svg("12a", {}, { width: 1 }), { code: "option", parameter: "width" });
  assert.ok(secondsComputed() - started < 0.1, "at once");
});

test("windows and hidden series: each part checked, and what is wrong named", () => {
  const frame = gear.figure("2").axes[0].frame;
  for (const windows of [null, 1, "all", [], { [frame]: 1 }, { [frame]: { z: [0, 1] } }, { [frame]: [0, 1] }]) {
    refused(() => gear.svg("2", {}, { view: { windows } }), {}, JSON.stringify(windows));
  }
  const wrong = [[1, 1], [2, 1], [0, 1, 2], [0], [], "01", { 0: 0, 1: 1 }, [Number.NaN, 1], [0, Infinity], [1, 1 + 1e-12], [0, 1e13], [null, 1]];
  for (const x of wrong) {
    refused(() => gear.svg("2", {}, { view: { windows: { [frame]: { x } } } }), { code: "option" }, JSON.stringify(x));
  }
  refused(() => gear.svg("2", {}, { view: { windows: { nowhere: { x: [0, 1] } } } }), { code: "option", parameter: "windows", given: "nowhere" });
  refused(() => gear.svg("1", {}, { view: { windows: { gears: { x: [0, 1] } } } }), { code: "option", parameter: "windows" });
  for (const hidden of [null, 1, "R", {}, [1], [null], [[]], new Array(3000).fill("x")]) {
    refused(() => gear.svg("2", {}, { view: { hidden } }), { code: "option", parameter: "hidden" }, JSON.stringify(hidden)?.slice(0, 40));
  }
  const unknown = refused(() => gear.svg("2", {}, { view: { hidden: ["nothing"] } }), { code: "option", parameter: "hidden", given: "nothing" });
  assert.ok(String(unknown.allowed).includes(gear.figure("2").series[0].name));
  assert.equal(gear.svg("2", {}, { view: { windows: {}, hidden: [] } }), gear.svg("2"));
});

test("sides in millimetres have the range of those in pixels", () => {
  for (const width of [0, 31, 2168, 8192]) {
    refused(() => gear.svg("2", {}, { width, unit: "mm" }), { code: "option", parameter: "width" });
  }
  assert.match(gear.svg("2", {}, { unit: "mm" }), /^<svg[^>]*width="174mm"/);
});

test("views: each part checked", () => {
  for (const view of [null, 1, "front", [], { elevation: 2 }, { azimuth: 1e4 }, { time: -1 }, { zoom: 1 }, { azimuth: "0" }]) {
    refused(() => gear.svg("3", {}, { view }), {}, JSON.stringify(view));
  }
  assert.notEqual(gear.svg("3", {}, { view: { azimuth: 1 } }), gear.svg("3", {}, { view: { azimuth: 1.5 } }));
});

test("figures that do not exist", () => {
  for (const id of ["", "0", "15", "11", "11A", " 2", "T ", "constructor", "2\0"]) {
    for (const call of [gear.figure, gear.progress, gear.svg]) {
      refused(() => call(id), { code: "unknown-figure", given: id });
    }
  }
  refused(() => gear.figure("x".repeat(100_000)), { code: "unknown-figure" });
  for (const id of [undefined, null, 2, Number.NaN, true, 2n, Symbol("2"), () => "2"]) {
    for (const call of [gear.figure, gear.progress, gear.svg]) {
      const error = refused(() => call(id), { code: "unknown-figure" });
      assert.match(String(error.allowed), /11a/);
    }
  }
  for (const id of [{}, ["2"], new String("2")]) refused(() => gear.figure(id), { code: "unknown-figure" });
});

test("draw() without a canvas", () => {
  for (const canvas of [undefined, null, {}, "canvas", 1, [], { getContext: () => null }, hostile["a revoked proxy"]]) {
    refused(() => gear.draw("2", {}, canvas), { code: "option", parameter: "canvas" });
  }
  refused(() => gear.draw("2", {}, null, { density: 100 }), { code: "option", parameter: "density" });
});

test("fromPhysical(): every quantity refused by name", () => {
  const si = {
    M_p: 0.8, M_g: 1.9, I_p: 4e-4, I_g: 2.5e-3, r_p: 0.03, r_g: 0.06, K: 2e8, K_p: 5e8, K_g: 7e8, b: 5e-5, teeth_p: 20,
    rpm_p: 6000,
  };
  assert.ok(gear.fromPhysical(si).params);
  for (const [what, value] of [["undefined", undefined], ...Object.entries(notObjects), ...Object.entries(hostile)]) {
    refused(() => gear.fromPhysical(value), { code: "not-an-object" }, String(what));
  }
  for (const name of Object.keys(si)) {
    const { [name]: _left, ...rest } = /** @type {Record<string, number>} */ (si);
    refused(() => gear.fromPhysical(rest), { code: "missing", parameter: name });
    for (const value of [0, -1, 1e300]) {
      refused(() => gear.fromPhysical({ ...si, [name]: value }), { code: "out-of-range", parameter: name, given: value });
    }
    for (const value of Object.values(notNumbers)) {
      refused(() => gear.fromPhysical({ ...si, [name]: value }), { code: "not-a-number", parameter: name });
    }
  }
  const unknown = refused(() => gear.fromPhysical({ ...si, m_p: 1 }), { code: "unknown-parameter", parameter: "m_p" });
  assert.match(String(unknown.allowed), /M_p, M_g/);
  refused(() => gear.fromPhysical({ ...si, mesh_frequency: 1 }), { code: "unknown-parameter" });
  refused(() => gear.fromPhysical({ ...si, T_p: 100, T_g: 100 }), { code: "unbalanced-torque", parameter: "T_g", given: 100 });
  refused(() => gear.fromPhysical({ ...si, rpm_p: 1e9 }), { code: "out-of-range", parameter: "Omega" });
});

test("toPhysical(): every scale refused by name", () => {
  const scales = { M: 0.1, omega_n: 1e4, b: 5e-5 };
  for (const value of [undefined, ...Object.values(notObjects), ...Object.values(hostile)]) {
    refused(() => gear.toPhysical({}, value));
  }
  for (const name of Object.keys(scales)) {
    const { [name]: _left, ...rest } = /** @type {Record<string, number>} */ (scales);
    refused(() => gear.toPhysical({}, rest), { code: "missing", parameter: name });
    for (const value of [0, -1, 1e300]) refused(() => gear.toPhysical({}, { ...scales, [name]: value }), { code: "out-of-range" });
    for (const value of Object.values(notNumbers)) {
      refused(() => gear.toPhysical({}, { ...scales, [name]: value }), { code: "not-a-number", parameter: name });
    }
  }
  refused(() => gear.toPhysical({}, { ...scales, r_p: 0.03 }), { code: "missing", parameter: "r_g" });
  refused(() => gear.toPhysical({}, { ...scales, teeth: 1 }), { code: "unknown-parameter", parameter: "teeth" });
});

test("parameters at the ends of their ranges: a refusal or a finite answer, in bounded time", () => {
  const table = gear.defaults().slice(0, -1);
  /** @param {Record<string, any>} p @param {string[]} names */
  const ask = (p, names) => {
    for (const name of names) {
      const started = secondsComputed();
      refusedOrFinite(() => calls[name](p), `${name} ${JSON.stringify(p)}`);
      const seconds = secondsComputed() - started;
      assert.ok(seconds < 20, `${name} took ${seconds} s for ${JSON.stringify(p)}`);
    }
  };
  // Each parameter at each end by itself.
  for (const regime of ["contact", "backlash"]) {
    for (const { name, low, high } of table) {
      for (const value of [low, high]) ask({ [name]: value, regime }, Object.keys(calls));
    }
  }
  // Many at once, at random with a fixed seed, at the ends of what sliders cover: the ends of the whole ranges together
  // make periods of a billion radians, which are refused or computed in their own time.
  let seed = 12345;
  const random = () => {
    seed = (Math.imul(seed, 1103515245) + 12345) & 0x7fffffff;
    return seed / 0x7fffffff;
  };
  // The loads' frequencies follow the mesh's: a common period of 35 mesh periods is a search of minutes.
  const within = table.filter((/** @type {any} */ info) => info.follows !== "Omega");
  for (let round = 0; round < 12; round += 1) {
    const corner = within.map((/** @type {any} */ { name, slider, default: usual }) => {
      return [name, [...slider, usual][Math.floor(3 * random())]];
    });
    ask({ ...Object.fromEntries(corner), regime: ["contact", "backlash"][Math.floor(2 * random())] }, Object.keys(calls));
  }
});
