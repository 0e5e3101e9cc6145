/**
 * The operating point of each figure, by short names: what the laboratory can start from. A test compares every one with
 * what the figure itself says of its parameters.
 *
 * @typedef {import("./state.js").Given} Given
 */

/** @type {Given} */
const DEFAULTS = Object.freeze({
  m: 1,
  k: 5,
  alpha: -0.2,
  zeta: 0.02,
  k0: 0.5,
  Omega: 1.6,
  F: 0,
  F_p: 0,
  F_g: 0,
  E: 0,
  regime: "homogeneous",
});

const LOADED = { zeta: 0.07, F: 1.5, Omega: 1.6 };

/** @type {Readonly<Record<string, Given>>} */
const OWN = {
  1: { ...LOADED, alpha: 0, regime: "backlash" },
  2: {},
  3: { alpha: 0.2 },
  4: {},
  5: { alpha: 0.2 },
  6: {},
  7: { alpha: 0.2 },
  8: { Omega: 1.65 },
  9: { alpha: 0.2 },
  10: { alpha: 0.2 },
  "11a": { zeta: 0.052, Omega: 1.55 },
  "11b": { zeta: 0.03, Omega: 1.6 },
  "11c": { Omega: 1.65 },
  "12a": { Omega: 3.65 },
  "12b": { Omega: 3.7 },
  "12c": { Omega: 3.75 },
  "13a": { Omega: 5.3 },
  "13b": { Omega: 5.4 },
  "13c": { Omega: 5.5 },
  "14a": { ...LOADED, alpha: 0, regime: "contact" },
  "14b": { ...LOADED, alpha: -1.3, regime: "contact" },
  T: {},
  B: {},
  M: {},
  S: {},
  L: { E: 0.1, F: 1, Omega: 1.2, regime: "contact" },
  A: { Omega: 1.65 },
  U: { ...LOADED, regime: "backlash" },
  P: { Omega: 1.65 },
  W: { ...LOADED, regime: "backlash" },
  E: {},
};

/** @type {ReadonlyMap<string, Given>} */
const ALL = new Map(Object.entries(OWN).map(([id, own]) => [id, Object.freeze({ ...DEFAULTS, ...own })]));

/** The figures that can be started from, in the page's order. */
export const PRESETS = Object.freeze([...ALL.keys()].sort((one, other) => rank(one) - rank(other)));

/**
 * Everything that is given at a figure's operating point.
 *
 * @param {string} id
 * @returns {Given}
 */
export function presetGiven(id) {
  return ALL.get(id) ?? DEFAULTS;
}

/** Numbers before letters, each in its order. @param {string} id */
function rank(id) {
  const order = "TBMSLAUPWE".indexOf(id);
  return order < 0 ? Number.parseInt(id, 10) : 100 + order;
}
