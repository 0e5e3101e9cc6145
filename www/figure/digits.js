/**
 * How many digits of a number are true: as many as its error estimate leaves, and never more than a reader can use.
 *
 * @typedef {import("./services.js").Figure} Figure
 */

/** Most significant digits that are shown. */
const MOST = 8;
/** What a formula evaluated in double precision is right to, relatively. */
const ROUNDING = 1e-14;

/**
 * The error of a figure's numbers, absolutely, as far as it is known.
 *
 * @param {Figure} figure
 * @param {number} value
 */
export function errorOf({ error }, value) {
  const known = [error.liouville, error.step, error.residual].filter((part) => typeof part === "number" && part > 0);
  return Math.max(ROUNDING * Math.abs(value), ...known.map(Number));
}

/**
 * The place of the last digit that is true and worth showing: a power of ten.
 *
 * @param {Figure} figure
 * @param {number} value
 * @param {number} range  Of the values beside it: digits far below it say nothing where the value is nearly nothing.
 */
export function lastDigit(figure, value, range) {
  const size = Math.max(Math.abs(value), range * 1e-6, Number.MIN_VALUE);
  const most = 10 ** (Math.floor(Math.log10(size)) - MOST + 1);
  return Math.max(most, 10 ** Math.ceil(Math.log10(errorOf(figure, value))));
}
