/**
 * What the parameters are at an operating point, whether given or following from others.
 *
 * @typedef {import("./state.js").Given} Given
 * @typedef {import("./figure/services.js").ParameterInfo} ParameterInfo
 * @typedef {ReadonlyMap<string, ParameterInfo>} Vocabulary
 */

/** Short forms, and the two parameters that each sets. */
export const PAIRS = Object.freeze({
  m: ["m_p", "m_g"],
  k: ["k_p", "k_g"],
  alpha: ["alpha_p", "alpha_g"],
  zeta_s: ["zeta_p", "zeta_g"],
});

/** @type {ReadonlyMap<string, string>} */
const SHORT = new Map(Object.entries(PAIRS).flatMap(([short, both]) => both.map((name) => [name, short])));

/**
 * A parameter's value: its own, its short form's, that of the parameter it follows, or its default.
 *
 * @param {Given} given
 * @param {Vocabulary} vocabulary
 * @param {string} name
 * @returns {number | string}
 */
export function valueOf(given, vocabulary, name) {
  if (name in given) return given[name];
  const short = SHORT.get(name);
  if (short !== undefined && short in given) return given[short];
  const info = vocabulary.get(name);
  if (info === undefined) return Number.NaN;
  if ("follows" in info && info.follows !== null) return valueOf(given, vocabulary, info.follows);
  return info.default;
}

/**
 * The same as a number.
 *
 * @param {Given} given
 * @param {Vocabulary} vocabulary
 * @param {string} name
 */
export function numberOf(given, vocabulary, name) {
  return Number(valueOf(given, vocabulary, name));
}

/**
 * What has to be set so that a parameter has a value: a short form takes back what its two were given apart.
 *
 * @param {string} name
 * @param {number | string | undefined} value
 * @returns {Record<string, number | string | undefined>}
 */
export function setting(name, value) {
  const both = PAIRS[/** @type {keyof typeof PAIRS} */ (name)] ?? [];
  return { ...Object.fromEntries(both.map((one) => [one, undefined])), [name]: value };
}
