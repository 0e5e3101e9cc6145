/**
 * All words of the page come from here: `say("view.lab")`. English is at hand from the start, each room bringing its own
 * with `learn`; another language replaces it whole.
 *
 * @typedef {Readonly<Record<string, string>>} Words  A sentence by its key; `{name}` stands for a value.
 * @typedef {Readonly<Record<string, string | number>>} Values
 */

/** @type {Record<string, string>} */
const english = Object.create(null);
/** @type {Words | null} */
let foreign = null;
let spoken = "en";
/** @type {Set<() => void>} */
const listeners = new Set();

/**
 * @param {Words} words  Of a room, in English.
 */
export function learn(words) {
  Object.assign(english, words);
}

/**
 * Speaks another language from now on.
 *
 * @param {string} language
 * @param {Words | null} words  Null for English.
 */
export function speak(language, words) {
  spoken = language;
  foreign = words;
  for (const listener of [...listeners]) listener();
}

/** The language that is spoken, as in `<html lang>`. */
export function language() {
  return spoken;
}

/**
 * Called when another language is spoken: whoever shows words shows them anew.
 *
 * @param {() => void} listener
 * @returns {() => void} ends it
 */
export function onLanguage(listener) {
  listeners.add(listener);
  return () => listeners.delete(listener);
}

/**
 * A sentence. Numbers among the values are written as the language writes them.
 *
 * @param {string} key
 * @param {Values} [values]
 * @returns {string}
 */
export function say(key, values = {}) {
  const sentence = foreign?.[key] ?? english[key] ?? key;
  return sentence.replace(/\{(\w+)\}/g, (hole, name) => {
    const value = values[name];
    if (value === undefined) return hole;
    return typeof value === "number" ? number(value) : value;
  });
}

/**
 * A number for reading: with the language's decimal sign and a true minus. In files, addresses and boxes that are to be
 * read by programs numbers stay plain.
 *
 * @param {number} value
 * @param {{digits?: number, decimals?: number}} [options]  Significant digits, or decimals; as many as it has by default.
 * @returns {string}
 */
export function number(value, { digits, decimals } = {}) {
  if (!Number.isFinite(value)) return String(value);
  const size = Math.abs(value);
  if (size >= 1e6 || (size < 1e-4 && size > 0 && decimals === undefined)) return powerOfTen(value, digits);
  // Done without `Intl.NumberFormat`, which takes 10 ms to come up. What ends in a five is rounded away from zero, as it is
  // read, though as a binary number it may be a hair less.
  const up = value * (1 + Number.EPSILON);
  const rounded = decimals !== undefined ? up.toFixed(decimals) : digits === undefined ? value : Number(up.toPrecision(digits));
  const plain = localized(String(rounded));
  return plain.replace(/^-(?=[0.,]*$)/, "").replace("-", "−");
}

/**
 * @param {number} value
 * @param {number | undefined} digits
 */
function powerOfTen(value, digits) {
  const [mantissa, exponent] = value.toExponential(digits === undefined ? undefined : Math.max(0, digits - 1)).split("e");
  return `${localized(mantissa)} × 10^${exponent.replace("+", "")}`.replaceAll("-", "−");
}

/** What stands before the decimals. @returns {"." | ","} */
export function decimalSign() {
  return spoken === "de" ? "," : ".";
}

/** A plain number with the language's decimal sign. @param {string} plain */
export function localized(plain) {
  return plain.replace(".", decimalSign());
}

/**
 * The plain form of a number as the language writes it, for reading what somebody typed.
 *
 * @param {string} text
 */
export function unlocalized(text) {
  return text.replace(decimalSign(), ".");
}
