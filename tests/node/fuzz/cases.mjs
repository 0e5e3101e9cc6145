// A case of the fuzz: a call, its arguments from a seed, and the verdict. The same case comes from the same seed anywhere.

import { random } from "../random.mjs";
import { CALLS } from "./calls.mjs";
import { faultOfAnswer, faultOfError, faultOfShape } from "./judge.mjs";

/** @typedef {import("./calls.mjs").Known} Known */
/** @typedef {{fault: string | null, refused: string | null}} Verdict */

/** Small figures of every kind of mark, for what draws them. */
const DRAWN = ["1", "2", "3", "9", "11a", "14b", "M"];

/** What arguments are made from. @param {any} gear @param {boolean} [small] @returns {Known} */
export function knownOf(gear, small = false) {
  return {
    gear,
    small,
    table: gear.defaults().filter((/** @type {any} */ { name }) => name !== "regime"),
    ids: gear.figures().map((/** @type {any} */ { id }) => id),
    figures: DRAWN.map((id) => gear.figure(id)),
  };
}

/** @param {string} call @param {number} seed @param {number} number */
function chooser(call, seed, number) {
  let mixed = Math.imul(seed ^ 0x9e3779b9, 0x85ebca6b) ^ Math.imul(number + 1, 0xc2b2ae35);
  for (const letter of call) mixed = Math.imul(mixed ^ letter.charCodeAt(0), 0x01000193);
  return random(mixed);
}

/** The arguments of a case. @param {Known} known @param {string} call @param {number} seed @param {number} number */
export function argumentsOf(known, call, seed, number) {
  return CALLS[call].args(known, chooser(call, seed, number));
}

/**
 * @param {Known} known
 * @param {Function} GearError
 * @param {string} call
 * @param {number} seed
 * @param {number} number
 * @returns {Verdict}
 */
export function judged(known, GearError, call, seed, number) {
  const { gear } = known;
  const args = argumentsOf(known, call, seed, number);
  const { run } = CALLS[call];
  let answer;
  try {
    answer = run === undefined ? gear[call](...args) : run(gear, args, chooser(`${call} on`, seed, number));
  } catch (thrown) {
    return { fault: faultOfError(thrown, GearError), refused: /** @type {any} */ (thrown)?.code ?? "?" };
  }
  if (answer === undefined && call === "progress") return { fault: null, refused: null };
  return { fault: faultOfAnswer(answer, call, call) ?? faultOfShape(call, answer), refused: null };
}
