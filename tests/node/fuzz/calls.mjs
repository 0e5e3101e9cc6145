// Every call of the module with arguments made from a seed: what is fuzzed, how large, and which answers may be null where.

import { broken, sound } from "./parameters.mjs";
import { beyond, strange, strangeText, within } from "./values.mjs";

/** @typedef {import("../random.mjs").Choose} Choose */
/** @typedef {import("./parameters.mjs").Parameter} Parameter */
/** @typedef {import("./parameters.mjs").Manner} Manner */
/** @typedef {(choose: Choose, option: string) => unknown} Make  A sound value of an option. */

/**
 * What arguments are made from.
 *
 * @typedef {object} Known
 * @property {any} gear
 * @property {readonly Parameter[]} table
 * @property {readonly string[]} ids
 * @property {readonly any[]} figures  Some that are computed, to be drawn.
 * @property {boolean} small  Every case must be quick: what alone can take a minute is left to the fuzz by command.
 */

/**
 * @typedef {object} Call
 * @property {boolean} cheap  Some microseconds.
 * @property {(known: Known, choose: Choose) => unknown[]} args
 * @property {(gear: any, args: any[], choose: Choose) => unknown} [run]  Where it is not simply called.
 */

const COORDINATES = ["u_p", "u_g", "u", "u_p_dot", "u_g_dot", "u_dot"];

/** @type {Make} */
const tolerance = (choose) => 10 ** choose.number(-10, -4);
/** @param {number} low @param {number} high @returns {Make} */
const whole = (low, high) => (choose) => choose.integer(low, high);

/** A state, mostly of the size of the motions there are. @type {Make} */
const state = (choose) => {
  const size = choose.of([1e-6, 0.1, 1, 3, 10, 1e3, 1e6]);
  const numbers = Array.from({ length: 6 }, () => choose.number(-size, size));
  return choose.chance(0.5) ? numbers : new Float64Array(numbers);
};

/** @param {number} low @param {number} high @param {number} [most] @returns {Make} */
const grid = (low, high, most = 4) => (choose) => [...ends(choose, low, high), choose.integer(2, most)];

/** Two numbers, the first below the second. @param {Choose} choose @param {number} low @param {number} high */
function ends(choose, low, high) {
  if (choose.chance(0.1)) return [low, high];
  const from = choose.number(low, high);
  return [from, Math.min(high, from + choose.number(0, 0.2) * (high - low) + 1e-6)];
}

/** @type {Make} */
const tongue = (choose) => (choose.chance(0.7) ? choose.of(["primary2", "primary3", "combination"]) : { near: choose.number(0.4, 7) });

/**
 * Options, each given or not; seldom one of them wrong, or all of it.
 *
 * @param {Choose} choose
 * @param {Record<string, Make>} makers
 * @param {readonly string[]} needed  Left out they would be refused, or make a large computation.
 * @param {number} wrong  How often something is.
 * @returns {unknown}
 */
function options(choose, makers, needed, wrong) {
  /** @type {Record<string, unknown>} */
  const made = {};
  for (const [name, make] of Object.entries(makers)) {
    if (needed.includes(name) || choose.chance(0.4)) made[name] = make(choose, name);
  }
  if (!choose.chance(wrong)) return made;
  switch (choose.integer(0, 3)) {
    case 0:
      return strange(choose);
    case 1:
      Object.defineProperty(made, strangeText(choose), { value: 1, enumerable: true, configurable: true });
      return made;
    default: {
      const name = choose.of(Object.keys(makers));
      made[name] = spoiled(choose, made[name]);
      return needed.includes(name) && made[name] === undefined ? null : made;
    }
  }
}

/** A value that is near to a sound one, or far. @param {Choose} choose @param {unknown} value @returns {unknown} */
function spoiled(choose, value) {
  if (typeof value === "number" && choose.chance(0.5)) return choose.of([-value - 1, value + 0.5, 1e9, 1e300, -0, Number.NaN]);
  if (Array.isArray(value) && choose.chance(0.6)) {
    const list = [...value];
    list[choose.integer(0, list.length)] = strange(choose);
    return list;
  }
  return strange(choose);
}

/** @typedef {Manner & {needed?: readonly string[], cheap?: boolean, quick?: Manner}} Traits  `quick`: the manner where cases must be. */

/** Few stiff and slow ones, each of which takes its time. */
const CALM = { wild: 0.04 };
/** Where attractors are sought these take all too much of it. */
const LIGHT = { wild: 0, only: ["alpha_p", "alpha_g", "zeta", "k0", "Omega"] };

/**
 * A call of parameters and options.
 *
 * @param {Record<string, Make>} makers
 * @param {Traits} [traits]
 * @returns {Call}
 */
function study(makers, { needed = [], cheap = false, quick, ...usual } = {}) {
  return {
    cheap,
    args: ({ table, small }, choose) => {
      const manner = small && quick !== undefined ? quick : usual;
      const p = choose.chance(0.85) ? sound(choose, table, manner) : broken(choose, table, manner);
      return [p, options(choose, makers, needed, 0.15)];
    },
  };
}

/** Rough sizes of a gear pair in SI units, and what else may be said of one. */
const PAIR = { M_p: 0.8, M_g: 1.9, I_p: 4e-4, I_g: 2.5e-3, r_p: 0.03, r_g: 0.06, K: 2e8, K_p: 5e8, K_g: 7e8, b: 5e-5, teeth_p: 20, rpm_p: 6000 };
const MORE = { K_amplitude: 6e7, K_p3: 1e16, K_g3: -1e16, C: 900, C_p: 500, C_g: 400, E: 1e-5, T_p: 150, T_p_amplitude: 10, T_g_amplitude: 20, omega_p: 600, omega_g: 300, teeth_g: 40 };

/** @param {Choose} choose @returns {unknown} */
function pair(choose) {
  /** @type {Record<string, unknown>} */
  const si = {};
  const near = (/** @type {number} */ value) => value * 10 ** choose.number(-0.3, 0.3) * (choose.chance(0.02) ? 1e12 : 1);
  for (const [name, value] of Object.entries(PAIR)) if (!choose.chance(0.003)) si[name] = near(value);
  for (const [name, value] of Object.entries(MORE)) if (choose.chance(0.4)) si[name] = near(value);
  if (choose.chance(0.2)) si[choose.of([...Object.keys(PAIR), "T_g", "mesh_frequency", strangeText(choose)])] = strange(choose);
  return choose.chance(0.05) ? strange(choose) : si;
}

/** @param {Choose} choose @returns {unknown} */
function scales(choose) {
  if (choose.chance(0.1)) return strange(choose);
  /** @type {Record<string, unknown>} */
  const made = { M: 10 ** choose.number(-12, 15), omega_n: 10 ** choose.number(-12, 15), b: 10 ** choose.number(-12, 15) };
  if (choose.chance(0.5)) for (const name of ["r_p", "r_g", "I_p", "I_g", "teeth_p", "teeth_g"]) made[name] = 10 ** choose.number(-12, 15);
  if (choose.chance(0.2)) made[choose.of([...Object.keys(made), strangeText(choose)])] = strange(choose);
  return made;
}

/**
 * A figure that was computed once, with something in it changed.
 *
 * @param {Known} known
 * @param {Choose} choose
 */
function spoiledFigure({ figures }, choose) {
  const figure = structuredClone(choose.of(figures));
  for (let count = choose.integer(0, 3); count > 0; count -= 1) {
    try {
      spoil(choose, figure);
    } catch {
      // It came to what an earlier change has put there, which lets nobody look into it.
    }
  }
  return figure;
}

/** Changes something somewhere in an object. @param {Choose} choose @param {any} object */
function spoil(choose, object) {
  for (let place = object; ; ) {
    const names = Object.keys(place);
    if (names.length === 0 || place === globalThis) return;
    const name = choose.of(names);
    const inner = place[name];
    if (typeof inner === "object" && inner !== null && !choose.chance(0.12)) {
      place = inner;
      continue;
    }
    // A view takes numbers only; what is not one becomes NaN in it.
    if (ArrayBuffer.isView(place)) /** @type {any} */ (place)[name] = choose.of([Number.NaN, Infinity, 1e300, -1e9, 0]);
    else if (choose.chance(0.2)) delete place[name];
    else place[name] = spoiled(choose, inner);
    return;
  }
}

/** @param {Known} known @param {Choose} choose */
function drawingOptions({ figures }, choose) {
  const frames = figures.flatMap(({ axes }) => axes);
  const names = figures.flatMap(({ series }) => series.map((/** @type {any} */ { name }) => name));
  /** @type {Make} */
  const view = () => ({
    ...(choose.chance(0.3) && { azimuth: choose.number(-1000, 1000), elevation: choose.number(-1.57, 1.57) }),
    ...(choose.chance(0.3) && { time: choose.of([0, choose.number(0, 100), 1e9, -1]) }),
    ...(choose.chance(0.4) && { windows: Object.fromEntries([[choose.of(frames).frame, window(choose)]]) }),
    ...(choose.chance(0.3) && { hidden: Array.from({ length: choose.integer(0, 3) }, () => choose.of(names)) }),
    ...(choose.chance(0.1) && { [strangeText(choose)]: strange(choose) }),
  });
  /** @type {Record<string, Make>} */
  const makers = {
    width: () => choose.of([120, 8192, 200, choose.number(120, 2000)]),
    height: () => choose.of([120, 8192, 200, choose.number(120, 2000)]),
    unit: () => choose.of(["px", "mm"]),
    theme: () => choose.of(["light", "dark", "projector", "contrast", "contrast-dark", "print"]),
    view,
    words: () => choose.of([(/** @type {string} */ text) => text, () => "", () => "ü".repeat(500), () => 1, () => "<script>&\0*_{", strange]),
  };
  return options(choose, makers, [], 0.15);
}

/** @param {Choose} choose */
function window(choose) {
  const span = () => {
    const middle = choose.of([0, 1, choose.number(-10, 10), 1e6, 1e12]);
    const half = 10 ** choose.number(-12, 12);
    return choose.chance(0.1) ? strange(choose) : [middle - half, middle + half];
  };
  return { ...(choose.chance(0.8) && { x: span() }), ...(choose.chance(0.6) && { y: span() }) };
}

/** Figures that are made of many motions: progress() has them, in pieces. */
const SLOW = ["A", "B", "S", "L", "P", "E"];

/** An id and its parameters. @param {Known} known @param {Choose} choose @returns {unknown[]} */
function idAndParameters({ gear, ids, table, small }, choose) {
  const id = choose.chance(0.92) ? choose.of(small ? ids.filter((one) => !SLOW.includes(one)) : ids) : choose.chance(0.5) ? strangeText(choose) : strange(choose);
  // A figure is asked about what it has controls for, within what they cover: else most of them are refused.
  const info = gear.figures().find((/** @type {any} */ figure) => figure.id === id);
  if (info === undefined || choose.chance(0.2)) return [id, choose.chance(0.5) ? sound(choose, table) : broken(choose, table)];
  /** @type {Record<string, unknown>} */
  const p = {};
  for (const control of info.parameters) {
    if (!choose.chance(0.4)) continue;
    p[control.name] = "choices" in control ? choose.of(control.choices) : within(choose, control, 0.1);
  }
  if (choose.chance(0.1)) p[choose.of([...Object.keys(p), "k0"])] = choose.chance(0.5) ? strange(choose) : beyond(choose, { low: 0, high: 1 });
  return [id, p];
}

/** The same of every figure. @type {Call["args"]} */
const anyIdAndParameters = (known, choose) => idAndParameters({ ...known, small: false }, choose);

/** Some steps of a computation in pieces, and then another end than the usual one. @type {Call["run"]} */
const someSteps = (gear, args, choose) => {
  const steps = gear.progress(...args);
  let last;
  for (let count = choose.integer(1, 4); count > 0; count -= 1) {
    const { value, done } = steps.next();
    if (done) break;
    last = value;
  }
  // At times it is merely forgotten.
  if (choose.chance(0.8)) steps.return();
  if (choose.chance(0.3)) {
    const after = steps.next();
    if (choose.chance(0.5)) steps.return();
    if (last === undefined) return after.value;
  }
  return last;
};

/** @type {Readonly<Record<string, Call>>} */
export const CALLS = {
  defaults: { cheap: true, args: (_, choose) => (choose.chance(0.5) ? [] : [strange(choose)]) },
  figures: { cheap: true, args: (_, choose) => (choose.chance(0.5) ? [] : [strange(choose)]) },
  fromPhysical: { cheap: true, args: (_, choose) => [pair(choose)] },
  toPhysical: { cheap: true, args: ({ table }, choose) => [choose.chance(0.9) ? sound(choose, table, { wild: 0.5 }) : broken(choose, table), scales(choose)] },
  modes: study({}, { cheap: true, equal: true, wild: 0.5 }),
  tongues: study({}, { cheap: true, equal: true, wild: 0.3 }),
  multipliers: study({ tolerance }, { quick: CALM }),
  timeResponse: study({ state, periods: (choose) => choose.number(0.01, 4), samplesPerPeriod: whole(1, 16), tolerance }, { needed: ["periods"], wild: 0.3 }),
  poincare: study({ state, transient: whole(0, 4), points: whole(1, 4), tolerance }, { needed: ["points"], wild: 0.3 }),
  periodicOrbit: study({ period: whole(1, 3), guess: state, tolerance }, { quick: CALM }),
  tongueEdges: study({ tongue, tolerance }, { needed: ["tongue"], quick: CALM }),
  tongueBoundary: study({ tongue, k0: (choose) => ends(choose, 0, 1), points: whole(3, 8), tolerance }, { needed: ["tongue", "points"], quick: CALM }),
  stabilityChart: study({ Omega: grid(0.4, 7), k0: grid(0, 1), tolerance }, { needed: ["Omega", "k0"], quick: CALM }),
  branch: study(
    {
      parameter: (choose) => choose.of(["Omega", "k0", "zeta", "F", "E", "alpha", "m", "k_p"]),
      range: (choose) => ends(choose, 0.4, 7),
      period: whole(1, 2),
      from: state,
      points: whole(2, 6),
      maxStep: (choose) => choose.number(0.001, 0.5),
      tolerance,
    },
    { needed: ["points"], quick: CALM },
  ),
  diagram: study(
    { Omega: (choose) => [1.7 + 0.04 * choose.next(), 1.75], maxPeriod: whole(1, 2), maxBranches: whole(1, 2), tolerance },
    { needed: ["Omega", "maxPeriod", "maxBranches"], quick: CALM },
  ),
  torus: study({ tolerance }, { quick: CALM }),
  sweep: study({ Omega: grid(0.4, 7, 3), direction: (choose) => choose.of(["up", "down"]), transient: whole(0, 4), points: whole(1, 3), state, tolerance }, { needed: ["Omega", "transient", "points"] }),
  lyapunov: study({ state, periods: whole(1, 10), tolerance }, { needed: ["periods"] }),
  basin: study(
    {
      plane: (choose) => [choose.of(COORDINATES), choose.of(COORDINATES)],
      x: grid(-4, 4, 3),
      y: grid(-4, 4, 3),
      state,
      periods: whole(1, 20),
      tolerance,
    },
    { needed: ["x", "y", "periods"], quick: LIGHT },
  ),
  contactMargin: study({ state, tolerance }, { teeth: true }),
  leastLoad: study({ tolerance }, { teeth: true }),
  spectrum: study({ state, transient: whole(0, 4), periods: whole(1, 8), tolerance }, { needed: ["transient", "periods"] }),
  figure: { cheap: false, args: idAndParameters },
  progress: { cheap: false, args: anyIdAndParameters, run: someSteps },
  svg: {
    cheap: false,
    args: (known, choose) => [spoiledFigure(known, choose), choose.chance(0.5) ? undefined : strange(choose), drawingOptions(known, choose)],
  },
  // Without a document there is no canvas: everything is refused, at the latest for that. hostile.spec.js draws.
  draw: {
    cheap: false,
    args: (known, choose) => [spoiledFigure(known, choose), undefined, strange(choose), drawingOptions(known, choose)],
  },
};

/** Where a result may say null: docs/api.md and the declarations name each. */
export const NULLABLE = new Set(
  ("follows short left right hill hillError escaped kind tip breaks supercritical period reason from averages multipliers F contactF state z bar stable label " +
    "axis at printed ours exact deviation ownDeviation table end orbits motion").split(" "),
);
