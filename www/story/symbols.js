/**
 * `<gear-symbol name="Omega">`, and `data-symbol="Omega"` within an equation: a symbol that says what it means and which
 * value it has at the present operating point.
 *
 * @typedef {import("../state.js").Given} Given
 * @typedef {import("../engine/gear-bifurcations.js").ParameterInfo} ParameterInfo
 */

import { language, number, say } from "../words/say.js";

/** Digits of a value: more than a reader can place says nothing. */
const DIGITS = 5;

/**
 * What the closed formulas say at a point; null where they say nothing, as with unequal supports.
 *
 * @typedef {object} Formulas
 * @property {{a: number, b: number, omega: ArrayLike<number>}} modes
 * @property {Record<"primary2" | "primary3" | "combination", Tongue>} tongues
 *
 * @typedef {object} Tongue
 * @property {number} Omega0
 * @property {{left: number | null, right: number | null}} corrected
 * @property {number} threshold
 */

/**
 * @typedef {object} Point
 * @property {Given} given  By full or short names.
 * @property {ReadonlyMap<string, ParameterInfo>} vocabulary
 * @property {() => Formulas | null} formulas
 */

export class GearSymbol extends HTMLElement {
  connectedCallback() {
    this.tabIndex = 0;
    this.setAttribute("role", "button");
  }
}

/** @param {Element} element */
export function symbolOf(element) {
  return element.getAttribute("name") ?? element.getAttribute("data-symbol") ?? "";
}

/**
 * Its meaning, and its value where it has one.
 *
 * @param {string} name
 * @param {Point} point
 */
export function describe(name, point) {
  const value = valueOf(name, point);
  const meaning = say(`symbol.${name}`);
  return value === "" ? say("symbol.meaning", { meaning }) : say("symbol.value", { meaning, value });
}

/**
 * @param {string} name
 * @param {Point} point
 * @returns {string} empty where the symbol is no number, or none is known
 */
export function valueOf(name, point) {
  const given = parameter(name, point);
  if (given !== null) return number(given, { digits: DIGITS });
  const formula = FORMULAS[name];
  if (formula === undefined) return "";
  const formulas = point.formulas();
  if (formulas === null && formula !== period) return "";
  const values = formula(/** @type {Formulas} */ (formulas), point).filter((value) => value !== null && Number.isFinite(value));
  const words = values.map((value) => number(/** @type {number} */ (value), { digits: DIGITS }));
  return new Intl.ListFormat(language(), { type: "conjunction" }).format(words);
}

/**
 * The value of a parameter: given, or that of the one it follows, or its default.
 *
 * @param {string} name
 * @param {Point} point
 * @returns {number | null}
 */
function parameter(name, point) {
  const info = point.vocabulary.get(name);
  const given = point.given[name];
  if (typeof given === "number") return given;
  if (info === undefined || "choices" in info) return null;
  // A short form has no default of its own: the parameters that it sets have.
  const full = info.sets.find((one) => one !== name);
  if (full !== undefined) return parameter(full, point);
  return info.follows === null ? info.default : parameter(info.follows, point);
}

/** @param {Tongue} tongue @param {number} k0 */
function halfWidth({ corrected: { left, right } }, k0) {
  return left === null || right === null || k0 === 0 ? null : (right - left) / (2 * k0);
}

/** @param {Tongue} tongue @param {number} k0 */
function decay(tongue, k0) {
  const width = halfWidth(tongue, k0);
  return width === null ? null : (tongue.threshold * width) / 2;
}

/** @param {Formulas | null} _ @param {Point} point */
function period(_, point) {
  const omega = parameter("Omega", point);
  return [omega === null ? null : (2 * Math.PI) / omega];
}

/** @param {Point} point */
const depth = (point) => parameter("k0", point) ?? 0;

/**
 * Symbols that follow from the parameters. Where one stands for two modes, both values are said.
 *
 * @type {Readonly<Record<string, ((formulas: Formulas, point: Point) => (number | null)[]) | undefined>>}
 */
const FORMULAS = {
  T: /** @type {(formulas: Formulas, point: Point) => (number | null)[]} */ (period),
  a: ({ modes }) => [modes.a],
  b: ({ modes }) => [modes.b],
  c_j: ({ modes }) => [modes.a, modes.b],
  omega_j: ({ modes }) => [modes.omega[1], modes.omega[2]],
  omega_2: ({ modes }) => [modes.omega[1]],
  omega_3: ({ modes }) => [modes.omega[2]],
  Omega_0: ({ tongues }) => [tongues.primary2.Omega0, tongues.combination.Omega0, tongues.primary3.Omega0],
  W_2: ({ tongues }, point) => [halfWidth(tongues.primary2, depth(point))],
  W_3: ({ tongues }, point) => [halfWidth(tongues.primary3, depth(point))],
  W_c: ({ tongues }, point) => [halfWidth(tongues.combination, depth(point))],
  W_j: ({ tongues }, point) => [halfWidth(tongues.primary2, depth(point)), halfWidth(tongues.primary3, depth(point))],
  d_2: ({ tongues }, point) => [decay(tongues.primary2, depth(point))],
  d_3: ({ tongues }, point) => [decay(tongues.primary3, depth(point))],
  d_j: ({ tongues }, point) => [decay(tongues.primary2, depth(point)), decay(tongues.primary3, depth(point))],
};
