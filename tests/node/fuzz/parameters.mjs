// Parameter sets: sound ones from all of their ranges, and such with something wrong in them.

import { beyond, strange, strangeText, within } from "./values.mjs";

/** @typedef {import("../random.mjs").Choose} Choose */
/** @typedef {import("./values.mjs").Info & {short: string | null, follows: string | null}} Parameter */
/** @typedef {Record<string, any>} Given */

/**
 * @typedef {object} Manner
 * @property {boolean} [equal]  Both supports alike, mostly.
 * @property {boolean} [teeth]  A regime with teeth, mostly.
 * @property {number} [wild]  How often a number lies beyond what its slider covers.
 * @property {readonly string[]} [only]  Nothing but these is given, and the regime.
 */

const REGIMES = ["homogeneous", "contact", "backlash"];
const LOADS = ["F", "F_p", "F_g", "E"];

/**
 * A sound set, but for what only the equations can refuse.
 *
 * @param {Choose} choose
 * @param {readonly Parameter[]} table
 * @param {Manner} [manner]
 * @returns {Given}
 */
export function sound(choose, table, { equal = false, teeth = false, wild = 0.15, only } = {}) {
  /** @type {Given} */
  const p = {};
  const regime = choose.of(teeth && choose.chance(0.95) ? REGIMES.slice(1) : only === undefined ? REGIMES : REGIMES.slice(0, 2));
  if (regime !== "homogeneous" || choose.chance(0.5)) p.regime = regime;
  const same = choose.chance(equal ? 0.95 : 0.5);
  for (const info of table) {
    if (!choose.chance(0.45) || (only !== undefined && !only.includes(info.name))) continue;
    if (LOADS.includes(info.name) && regime === "homogeneous" && !choose.chance(0.02)) continue;
    if (info.follows === "Omega") {
      if (choose.chance(0.3)) p[info.name] = fluctuation(choose, p.Omega ?? 1.6);
      continue;
    }
    const value = within(choose, info, wild);
    if (info.short === null) p[info.name] = value;
    else if (same) p[info.short] = value;
    else p[info.name] = value;
  }
  return p;
}

/** The frequency of a load: mostly with a common period, at times without. @param {Choose} choose @param {number} Omega */
function fluctuation(choose, Omega) {
  const ratio = choose.chance(0.9) ? choose.integer(1, 6) / choose.integer(1, 4) : choose.number(0.1, 3);
  return Math.min(100, Math.max(1e-4, Omega * ratio));
}

/**
 * The same with one thing wrong, or something that is no parameter set at all.
 *
 * @param {Choose} choose
 * @param {readonly Parameter[]} table
 * @param {Manner} [manner]
 * @returns {unknown}
 */
export function broken(choose, table, manner) {
  if (choose.chance(0.3)) return strange(choose);
  const p = sound(choose, table, manner);
  const info = choose.of(table);
  switch (choose.integer(0, 3)) {
    case 0:
      p[choose.of([info.name, info.short ?? info.name, "regime"])] = strange(choose);
      return p;
    case 1:
      p[info.name] = beyond(choose, info);
      return p;
    case 2:
      Object.defineProperty(p, strangeText(choose), { value: within(choose, info), enumerable: true, configurable: true });
      return p;
    default:
      return hiding(choose, p, info.name);
  }
}

/** An object that says a sound set, but not in the usual way. @param {Choose} choose @param {Given} p @param {string} name */
function hiding(choose, p, name) {
  switch (choose.integer(0, 3)) {
    case 0:
      return Object.freeze({ ...p });
    case 1:
      return Object.assign(Object.create(null), p);
    case 2:
      return new Proxy(p, {});
    default: {
      const value = p[name] ?? 1;
      return Object.defineProperty({ ...p }, name, { enumerable: true, configurable: true, get: () => value });
    }
  }
}
