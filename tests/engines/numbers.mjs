// Questions to the module, asked in whatever engine this runs in, and how its answers are held against the native ones.

import { readFile } from "node:fs/promises";

/**
 * @typedef {import("../../www/engine/gear-bifurcations.js").Gear} Gear
 * @typedef {{call: string, id?: string, params: Record<string, number | string>, options?: object, answer: any}} Question
 * @typedef {{name: string, role: string, mark: string, columns: Record<string, number[]>}} Series
 */

/** Numbers agree within this, relative above 1. */
const AGREE = 1e-9;
/** How far a chord between two neighbouring points of a followed branch may be from the branch, in parts of what the series spans. */
const CHORD = 2e-5;

/** @returns {Promise<Question[]>} */
export async function questions() {
  return JSON.parse(await readFile(new URL("./numbers.json", import.meta.url), "utf8"));
}

/**
 * Asks the module: what it answers as plain data, and a sum over the bits of all its numbers. Stands alone, for it travels as text.
 *
 * @param {Gear} gear
 * @param {Pick<Question, "call" | "id" | "params" | "options">} question
 */
export function ask(gear, { call, id, params, options = {} }) {
  const answered = call === "figure" ? gear.figure(id ?? "", params) : /** @type {any} */ (gear)[call](params, options);
  const bits = new DataView(new ArrayBuffer(8));
  let sum = 0;
  /** @param {unknown} value @returns {any} */
  const plain = (value) => {
    if (typeof value === "number") {
      bits.setFloat64(0, value);
      // FNV-1a, a byte at a time in the order of the numbers.
      for (let byte = 0; byte < 8; byte += 1) sum = Math.imul(sum ^ bits.getUint8(byte), 16777619);
      return value;
    }
    if (ArrayBuffer.isView(value) || Array.isArray(value)) return Array.from(/** @type {ArrayLike<unknown>} */ (value), plain);
    if (value !== null && typeof value === "object") return Object.fromEntries(Object.entries(value).map(([name, part]) => [name, plain(part)]));
    return value;
  };
  return { answer: plain(answered), sum };
}

/**
 * Where an answer is not what the native one is, in words.
 *
 * @param {Question} question
 * @param {any} found
 * @returns {string[]}
 */
export function differences({ call, id, params, answer }, found) {
  const at = `${call} ${id ?? ""} ${JSON.stringify(params)}`;
  if (call === "branch") return [...alike(answer.events, found.events, `${at} events`), ...onCurve({ x: answer.Omega, y: answer.maxU_p }, { x: found.Omega, y: found.maxU_p }, at)];
  if (call !== "figure") return alike(answer, found, at);
  return answer.series.flatMap((/** @type {Series} */ native, /** @type {number} */ index) => {
    /** @type {Series | undefined} */
    const ours = found.series[index];
    const place = `${at}, “${native.name}”`;
    if (ours?.name !== native.name) return [`${place}: here “${ours?.name}”`];
    if (FOLLOWED.has(id ?? "") && ours.role.startsWith("exact") && ours.mark === "curve") return onCurve(native.columns, ours.columns, place);
    if (id === "S") return ours.mark === "cloud" ? amongPoints(native.columns, ours.columns, place) : [];
    return alike(native.columns, ours.columns, place);
  });
}

/**
 * Figures with branches that are followed step by step. How far the next step leads depends on how quickly the last one
 * converged, which the last bit of a cosine may decide: the points lie on the same curve, but elsewhere on it. What is
 * located on a branch (folds, period doublings, ends) is compared as all else is.
 */
const FOLLOWED = new Set(["3", "5", "9", "10", "B"]);

/**
 * Number by number; of a long column a part is known, and its length.
 *
 * @param {any} native
 * @param {any} found
 * @param {string} at
 * @returns {string[]}
 */
function alike(native, found, at) {
  if (typeof native === "number") return typeof found === "number" && near(native, found) ? [] : [`${at}: native ${native}, here ${found}`];
  if (native === null || typeof native !== "object") return native === found ? [] : [`${at}: native ${native}, here ${found}`];
  if (isColumn(native)) {
    const [length, numbers] = [lengthOf(native), listed(native)];
    if (length !== found?.length) return [`${at}: native ${length} of them, here ${found?.length}`];
    return numbers.flatMap(({ index, value }) => alike(value, found[index], `${at}[${index}]`));
  }
  return Object.entries(native).flatMap(([name, part]) => alike(part, found?.[name], `${at}.${name}`));
}

/** @param {number} native @param {number} found */
function near(native, found) {
  return Math.abs(native - found) <= AGREE * Math.max(1, Math.abs(native));
}

/** @param {any} native */
function isColumn(native) {
  return Array.isArray(native) || Array.isArray(native.at);
}

/** @param {any} column @returns {number} */
function lengthOf(column) {
  return column.length;
}

/** What is known of a column. @param {any} column @returns {{index: number, value: any}[]} */
function listed(column) {
  if (Array.isArray(column)) return column.map((value, index) => ({ index, value }));
  return column.at.map((/** @type {number} */ index, /** @type {number} */ part) => ({ index, value: column.is[part] }));
}

/**
 * Points of a plane or of space from columns.
 *
 * @param {any} columns
 * @returns {number[][]}
 */
function points(columns) {
  const lists = ["x", "y", "z"].filter((name) => columns[name] !== undefined).map((name) => listed(columns[name]));
  return lists[0].map((_, row) => lists.map((list) => list[row].value));
}

/**
 * Native points of a curve lie on ours, drawn from point to point.
 *
 * @param {any} native
 * @param {any} found
 * @param {string} at
 */
function onCurve(native, found, at) {
  const curve = points(found);
  const spans = curve[0].map((_, axis) => {
    const values = curve.map((point) => point[axis]);
    return Math.max(1e-3, Math.max(...values) - Math.min(...values));
  });
  const scaled = (/** @type {number[]} */ point) => point.map((value, axis) => value / spans[axis]);
  const ours = curve.map(scaled);
  const far = points(native).filter((point) => {
    const wanted = scaled(point);
    return !ours.some((end, index) => toSegment(wanted, ours[Math.max(0, index - 1)], end) <= CHORD);
  });
  return far.map((point) => `${at}: the native point ${point} is not on the curve here`);
}

/** The distance of a point from a stretch of a line. @param {number[]} point @param {number[]} from @param {number[]} to */
function toSegment(point, from, to) {
  const along = to.map((value, axis) => value - from[axis]);
  const length = along.reduce((sum, part) => sum + part * part, 0);
  const part = length === 0 ? 0 : along.reduce((sum, step, axis) => sum + step * (point[axis] - from[axis]), 0) / length;
  const within = Math.min(1, Math.max(0, part));
  return Math.hypot(...along.map((step, axis) => from[axis] + within * step - point[axis]));
}

/**
 * Each native point is among ours. Points of a sweep that come again are left out, and whether one does is a matter of the last bit.
 *
 * @param {any} native
 * @param {any} found
 * @param {string} at
 */
function amongPoints(native, found, at) {
  const ours = points(found);
  const missing = points(native).filter((point) => !ours.some((other) => point.every((value, axis) => near(value, other[axis]))));
  return missing.map((point) => `${at}: the native point ${point} is not among those here`);
}
