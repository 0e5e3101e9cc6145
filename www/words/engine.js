/**
 * Sentences that the engine makes, in another language: titles, labels, summaries, notes and errors are English there and
 * become what they are to be here, by patterns. In a pattern `{1}`, `{2}`, ... stand for what is filled in; the same holes
 * stand in its translation. What is filled in is translated itself where it is a sentence of the list, and a number is
 * written as the language writes it.
 *
 * @typedef {readonly (readonly [english: string, other: string])[]} Patterns
 * @typedef {import("../engine/gear-bifurcations.js").Figure} Figure
 * @typedef {import("../engine/gear-bifurcations.js").Axis} Axis
 */

import { localized } from "./say.js";

/**
 * @typedef {object} Reader
 * @property {ReadonlyMap<string, string>} whole  Sentences without a hole.
 * @property {readonly {expression: RegExp, start: string, other: string, holes: readonly string[]}[]} patterns
 * @property {Map<string, string>} known  What was translated before.
 */

/** @type {Reader | null} */
let reader = null;

/** More sentences than this are not remembered: numbers run on while a slider moves. */
const REMEMBERED = 2000;

const HOLE = /\{(\d)\}/g;
const NUMBER = /(?<![\w.([])[−-]?\d+\.\d+(?=e[−-]?\d|i\b|(?![\w.]))/g;

/** @param {Patterns | null} patterns  Null: sentences stay as they are. */
export function translateEngine(patterns) {
  reader = patterns === null ? null : readerOf(patterns);
}

/**
 * @param {Patterns} patterns
 * @returns {Reader}
 */
function readerOf(patterns) {
  const literal = (/** @type {string} */ english) => english.replace(HOLE, "").length;
  // The more of a sentence is written out, the less else it can mean.
  const withHoles = patterns.filter(([english]) => english.includes("{1}")).sort(([one], [other]) => literal(other) - literal(one));
  return {
    whole: new Map(patterns.filter(([english]) => !english.includes("{1}"))),
    patterns: withHoles.map(([english, other]) => {
      const parts = english.split(HOLE);
      const source = parts.map((part, index) => (index % 2 === 0 ? part.replace(/[\\^$.*+?()[\]{}|]/g, "\\$&") : "(.+?)"));
      return {
        expression: new RegExp(`^${source.join("")}$`, "su"),
        start: parts[0],
        other,
        holes: parts.filter((_, index) => index % 2 === 1),
      };
    }),
    known: new Map(),
  };
}

/**
 * A sentence of the engine as it is to be read.
 *
 * @param {string} text
 * @returns {string}
 */
export function spoken(text) {
  return text === "" ? text : (translation(text) ?? text);
}

/**
 * The translation, or null where the list has none.
 *
 * @param {string} text
 * @returns {string | null}
 */
export function translation(text) {
  if (reader === null) return text;
  const known = reader.whole.get(text) ?? reader.known.get(text);
  if (known !== undefined) return known;
  for (const { expression, start, other, holes } of reader.patterns) {
    const match = text.startsWith(start) ? expression.exec(text) : null;
    if (match === null) continue;
    const made = other.replace(HOLE, (hole, name) => filled(match[1 + holes.indexOf(name)] ?? hole));
    if (reader.known.size > REMEMBERED) reader.known.clear();
    reader.known.set(text, made);
    return made;
  }
  return null;
}

/** What fills a hole: a phrase of the list, or numbers and names. @param {string} text */
function filled(text) {
  return translation(text) ?? text.replace(NUMBER, (number) => localized(number));
}

/**
 * A figure with its words in the language that is spoken. Names by which things are told apart stay as they are.
 *
 * @param {Figure} figure
 * @returns {Figure}
 */
export function spokenFigure(figure) {
  if (reader === null) return figure;
  const axis = (/** @type {Axis} */ one) => ({ ...one, label: spoken(one.label) });
  const cell = (/** @type {number | string | null} */ entry) => (typeof entry === "string" ? spoken(entry) : entry);
  return {
    ...figure,
    title: spoken(figure.title),
    summary: spoken(figure.summary),
    notes: figure.notes.map(spoken),
    method: spoken(figure.method),
    axes: figure.axes.map((frame) => ({
      ...frame,
      title: spoken(frame.title),
      x: axis(frame.x),
      y: axis(frame.y),
      z: frame.z && axis(frame.z),
      bar: frame.bar && axis(frame.bar),
    })),
    series: figure.series.map((series) => ({
      ...series,
      meaning: spoken(series.meaning),
      label: series.label === null ? null : spoken(series.label),
    })),
    distances: figure.distances.map((distance) => ({ ...distance, what: spoken(distance.what) })),
    table:
      figure.table?.map((row) => ({
        ...row,
        where: spoken(row.where),
        what: spoken(row.what),
        printed: cell(row.printed),
        ours: cell(row.ours),
        exact: cell(row.exact),
        remark: spoken(row.remark),
      })) ?? null,
  };
}
