/**
 * What the charts have found at an operating point, in words of the catalogue.
 *
 * @typedef {import("../figure/services.js").Figure} Figure
 * @typedef {Readonly<Record<string, number | string | boolean>>} Facts
 * @typedef {ReadonlyMap<string, Figure>} Figures  The newest of each chart, by its id.
 */

import { number, say } from "../words/say.js";

/** Digits of a number in a sentence. */
const DIGITS = 5;
/** A greatest `|u_p|` below this is rest. */
const REST = 1e-6;

/** @param {number} value */
function short(value) {
  return number(value, { digits: DIGITS });
}

/**
 * The sentence at the foot of the laboratory: what is so here.
 *
 * @param {Figures} figures
 * @returns {string}
 */
export function sentence(figures) {
  const parts = [stability(figures.get("M")?.facts), fate(figures), theory(figures)].filter((part) => part !== "");
  return parts.length === 0 ? say("lab.s.waiting") : `${parts.join(say("lab.s.and"))}.`;
}

/** @param {Facts | undefined} facts  Of figure M. */
function stability(facts) {
  if (facts === undefined || !("stable" in facts)) return "";
  const about = facts.loaded === true ? "response" : "rest";
  const real = Number(facts.im) <= 1e-7 * Math.abs(Number(facts.re));
  const kind = facts.stable === true ? "stable" : real ? "saddle" : "spiral";
  return say(`lab.s.${about}.${kind}`, { size: short(Number(facts.spectralRadius)) });
}

/**
 * What becomes of the motion.
 *
 * @param {Figures} figures
 */
function fate(figures) {
  const map = figures.get("P")?.facts ?? {};
  const time = figures.get("U")?.facts ?? {};
  const escaped = map.escapedAt ?? time.escapedAt;
  if (escaped !== undefined) return say("lab.s.escapes", { time: short(Number(escaped)) });
  const size = Number(map.maxU_p ?? time.maxU_p ?? Number.NaN);
  const values = { period: period(Number(map.period ?? 0)), size: short(size) };
  if (Number.isFinite(size) && size < REST) return say("lab.s.rests");
  if (map.end === "closed") return say("lab.s.closed", { ...values, size: short(Number(time.maxU_p ?? size)) });
  if (map.end === "orbit") return say("lab.s.settles", values);
  if (map.end === "wandering" && Number.isFinite(size)) return say("lab.s.wanders", values);
  return "";
}

/** @param {number} periods */
function period(periods) {
  return periods === 1 ? "T" : `${number(periods)}T`;
}

/**
 * What the first-order theory says of the amplitude here: the greatest of its stable branches.
 *
 * @param {Figures} figures
 */
function theory(figures) {
  const branches = figures.get("B");
  // It speaks of motions about rest: under a load there is none, and where the motion comes to rest nothing to say.
  if (figures.get("M")?.facts.loaded === true || Number(figures.get("U")?.facts.maxU_p) < REST) return "";
  const omega = figures.get("M")?.params.Omega ?? figures.get("U")?.params.Omega;
  if (branches === undefined || omega === undefined) return "";
  let greatest = -Infinity;
  for (const { role, stable, columns } of branches.series) {
    if (role === "corrected-second" && stable) greatest = Math.max(greatest, over(columns.x, columns.y, omega));
  }
  return greatest > 0 ? say("lab.s.theory", { size: short(greatest) }) : "";
}

/**
 * The height of a curve over a place, the greatest where there are several; -Infinity for none.
 *
 * @param {ArrayLike<number>} x
 * @param {ArrayLike<number>} y
 * @param {number} at
 */
export function over(x, y, at) {
  let greatest = -Infinity;
  for (let index = 1; index < x.length; index += 1) {
    const [from, to] = [x[index - 1], x[index]];
    if ((from - at) * (to - at) > 0 || from === to) continue;
    const part = (at - from) / (to - from);
    greatest = Math.max(greatest, y[index - 1] + part * (y[index] - y[index - 1]));
  }
  return greatest;
}

/**
 * The flag of contact: a sign and words, never colour alone.
 *
 * @param {Facts | undefined} facts  Of figure U.
 * @returns {{kind: "kept" | "regained" | "lost" | "unasked" | "unknown", sign: string, words: string}}
 */
export function contact(facts) {
  const kind = /** @type {"kept" | "regained" | "lost" | "unasked" | undefined} */ (facts?.contact) ?? "unknown";
  const sign = { kept: "✓", regained: "✓", lost: "✕", unasked: "–", unknown: "…" }[kind];
  if (facts === undefined || kind === "unknown") return { kind, sign, words: say("lab.c.unknown") };
  const margin = Number(facts.margin);
  const values = { margin: short(Math.abs(margin)), time: short(Number(facts.lostAt)) };
  const never = kind === "lost" && facts.escapedAt !== undefined ? "escaped" : kind;
  return { kind, sign, words: say(`lab.c.${never}`, values) };
}
