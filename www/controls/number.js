/**
 * Numbers as readers write and read them, and sentences about those that will not do.
 *
 * @typedef {import("../figure/services.js").ParameterInfo} ParameterInfo
 * @typedef {import("../figure/services.js").GearErrorFields} GearErrorFields
 * @typedef {import("../engine/gear-bifurcations.js").NumberParameterInfo} NumberInfo
 * @typedef {{value: number | string} | {problem: GearErrorFields}} Judgement
 */

import { plain } from "../figure/markup.js";
import { localized, say, unlocalized } from "../words/say.js";

const NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i;

/**
 * The number that a text says, or null: nothing is guessed.
 *
 * @param {string} text
 */
export function parseNumber(text) {
  const written = unlocalized(text.trim()).replace(/^−/, "-").replace(/(e)−/i, "$1-");
  if (!NUMBER.test(written)) return null;
  const number = Number(written);
  return Number.isFinite(number) ? number : null;
}

/**
 * A number as text that reads back as the same number.
 *
 * @param {number} number
 */
export function writeNumber(number) {
  return localized(String(number));
}

/**
 * A number for reading, with a true minus sign.
 *
 * @param {number} number
 */
export function showNumber(number) {
  const size = Math.abs(number);
  const text = size >= 1e6 || (size < 1e-3 && size > 0) ? number.toExponential() : String(number);
  const [mantissa, exponent] = localized(text).replaceAll("-", "−").split("e");
  return exponent === undefined ? mantissa : `${mantissa} × 10^${exponent.replace("+", "")}`;
}

/**
 * A number with so many decimals as a step can tell apart.
 *
 * @param {number} number
 * @param {number} step
 */
export function showTo(number, step) {
  const decimals = Math.min(12, Math.max(0, Math.ceil(-Math.log10(step))));
  const text = number.toFixed(decimals);
  return localized(Number(text) === 0 ? text.replace("-", "") : text).replace("-", "−");
}

/**
 * The range of a parameter in words.
 *
 * @param {NumberInfo} info
 */
export function rangeOf(info) {
  return say("control.range", { low: showRange(info.low), high: showRange(info.high) });
}

/** @param {number} number */
function showRange(number) {
  // Groups of three by hand: the browser's own take 10 ms to come up.
  const text = Math.abs(number) >= 1e4 ? String(number).replace(/\B(?=(\d{3})+$)/g, "\u202f") : localized(String(number));
  return text.replace("-", "−");
}

/**
 * Whether a text will do as a parameter's value.
 *
 * @param {ParameterInfo} info
 * @param {string} text
 * @returns {Judgement}
 */
export function judge(info, text) {
  if ("choices" in info) {
    const word = info.choices.find((choice) => choice === text.trim().toLowerCase());
    if (word !== undefined) return { value: word };
    const allowed = info.choices.join(", ");
    const message = say("control.choice", { name: info.name, allowed, given: text });
    return { problem: { code: "not-a-choice", parameter: info.name, given: text, allowed, message } };
  }
  const symbol = plain(info.symbol);
  /** @type {[number, number]} */
  const allowed = [info.low, info.high];
  const number = parseNumber(text);
  if (number === null) {
    const written = text.trim();
    const key = written === "" ? "control.nothing" : "control.no-number";
    const message = say(key, { symbol, range: rangeOf(info), given: written });
    return { problem: { code: "not-a-number", parameter: info.name, given: text, allowed, message } };
  }
  if (number < info.low || number > info.high) {
    const message = say("control.outside", { symbol, range: rangeOf(info), given: showNumber(number) });
    return { problem: { code: "out-of-range", parameter: info.name, given: number, allowed, message } };
  }
  return { value: number };
}
