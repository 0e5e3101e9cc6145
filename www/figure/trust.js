/**
 * How far a figure's numbers can be trusted, in words: the errors of what was integrated and solved, and the distance of
 * the theory from the exact answer.
 *
 * @typedef {import("./services.js").Figure} Figure
 * @typedef {import("./services.js").FrameMap} FrameMap
 * @typedef {import("../engine/gear-bifurcations.js").FigureSeries} FigureSeries
 */

import { number, say } from "../words/say.js";

/** What is exact, and what is a formula. */
const EXACT = new Set(["exact", "quasi-periodic"]);
const THEORY = new Set(["paper", "corrected", "corrected-second"]);

/** @param {number} value @param {number} digits */
const written = (value, digits) => number(value, { digits });

/**
 * The errors that a figure gives, in a phrase; empty where there are none: formulas have none.
 *
 * @param {Figure["error"]} error
 */
export function errorWords(error) {
  const kinds = /** @type {const} */ (["residual", "liouville", "step"]);
  const known = kinds.filter((kind) => error[kind] !== undefined && error[kind] !== null);
  return known.map((kind) => say(`trust.${kind}`, { value: written(Number(error[kind]), 1) })).join(", ");
}

/**
 * Every distance of the theory from the exact answer that a figure gives, one sentence each.
 *
 * @param {Figure} figure
 * @returns {string[]}
 */
export function distanceWords(figure) {
  return figure.distances.map(({ what, axis, at, theory, exact, difference }) =>
    say(axis === null || at === null ? "trust.distance" : "trust.distance-at", {
      what,
      axis: axis ?? "",
      at: written(at ?? 0, 5),
      theory: written(theory, 6),
      exact: written(exact, 6),
      difference: written(difference, 2),
    }),
  );
}

/**
 * What can be said of the numbers under the pointer: of something exact its errors, of a formula's curve its distance
 * from the nearest exact one over the same place. Null where there is nothing.
 *
 * @param {Figure} figure
 * @param {FigureSeries} series
 * @param {{x: number, y: number}} at  Where the pointer is, in data.
 */
export function trustWords(figure, series, at) {
  if (EXACT.has(series.role)) return errorWords(figure.error) || null;
  if (!THEORY.has(series.role) || series.mark !== "curve") return null;
  // Boundaries over two parameters are compared along the first of them, everything else over the same place.
  const across = figure.axes.some(({ frame, y }) => frame === series.frame && y.name === "k0");
  const [along, height] = across ? /** @type {const} */ (["y", "x"]) : /** @type {const} */ (["x", "y"]);
  const theory = nearestValue(series, along, height, at[along], at[height]);
  if (theory === null) return null;
  let exact = null;
  for (const other of figure.series) {
    if (other.frame !== series.frame || other.mark !== "curve" || !EXACT.has(other.role)) continue;
    // A stable branch is compared with stable ones.
    if (series.stable !== null && other.stable !== null && series.stable !== other.stable) continue;
    const value = nearestValue(other, along, height, at[along], theory);
    if (value !== null && (exact === null || Math.abs(value - theory) < Math.abs(exact - theory))) exact = value;
  }
  if (exact === null) return null;
  return say("trust.apart", { difference: written(theory - exact, 2) });
}

/**
 * Where a curve passes a place along one of its coordinates, the other one's value that is nearest to a given one; null
 * where it does not reach.
 *
 * @param {FigureSeries} series
 * @param {"x" | "y"} along
 * @param {"x" | "y"} height
 * @param {number} place
 * @param {number} near
 */
function nearestValue({ columns, pieces }, along, height, place, near) {
  const [from, values] = [columns[along], columns[height]];
  const starts = new Set(pieces);
  let best = null;
  for (let index = 1; index < from.length; index += 1) {
    const [one, other] = [from[index - 1], from[index]];
    if (starts.has(index) || (one - place) * (other - place) > 0 || one === other) continue;
    const part = (place - one) / (other - one);
    const value = values[index - 1] + part * (values[index] - values[index - 1]);
    if (best === null || Math.abs(value - near) < Math.abs(best - near)) best = value;
  }
  return best;
}
