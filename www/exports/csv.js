/**
 * A figure's numbers as a table: comments that say whence they come, a line of names, a line for each point.
 *
 * @typedef {import("../figure/services.js").Figure} Figure
 * @typedef {import("../engine/gear-bifurcations.js").FigureSeries} FigureSeries
 * @typedef {string | number | boolean | null | undefined} Cell
 */

import { FURNITURE } from "../figure/furniture.js";
import { plain } from "../figure/markup.js";
import { oneLine } from "./colophon.js";

const POINTS = "frame,series,role,stable,piece,x,y,z";

/**
 * @param {Figure} figure  As the module gave it.
 * @param {readonly string[]} comments
 * @returns {string}
 */
export function csv(figure, comments) {
  const { says, names, rows } = table(figure);
  return `${[...comments.map(oneLine), ...says.map(oneLine)].map((line) => `# ${line}\n`).join("")}${names}\n${rows.map((row) => `${row.map(written).join(",")}\n`).join("")}`;
}

/**
 * @param {Figure} figure
 * @returns {{says: string[], names: string, rows: Cell[][]}}
 */
function table(figure) {
  if (figure.table !== null) {
    const names = /** @type {const} */ (["where", "what", "printed", "ours", "exact", "deviation", "ownDeviation", "remark"]);
    return { says: [], names: names.join(","), rows: figure.table.map((line) => names.map((name) => worded(line[name]))) };
  }
  if (figure.motion !== null) {
    const { t, u_p, u_g, u } = figure.motion;
    return { says: ["the motion that is shown, a line each moment"], names: "t,u_p,u_g,u", rows: Array.from(t, (time, at) => [time, u_p[at], u_g[at], u[at]]) };
  }
  const told = figure.series.filter(({ role, mark, columns }) => !FURNITURE.has(role) && mark !== "text" && columns.x.length > 0);
  const shown = new Set(told.map(({ frame }) => frame));
  const frames = figure.axes.filter(({ frame }) => shown.has(frame));
  return {
    says: [
      ...frames.map(({ frame, x, y, z, bar }) => {
        const third = z ?? bar;
        return `frame ${frame}: x = ${x.name}, y = ${y.name}${third ? `, z = ${third.name}` : ""}`;
      }),
      ...told.map(({ name, frame, meaning }) => `series ${name} of ${frame}: ${plain(meaning)}`),
    ],
    names: POINTS,
    rows: told.flatMap((series) => (series.mark === "field" ? fieldRows(series) : pointRows(series))),
  };
}

/** @param {FigureSeries} series @returns {Cell[][]} */
function pointRows({ frame, name, role, stable, columns: { x, y, z }, pieces }) {
  const starts = new Set(pieces);
  let piece = 0;
  return Array.from(x, (value, index) => {
    if (index > 0 && starts.has(index)) piece += 1;
    return [frame, name, role, stable, piece, value, y[index], z?.[index]];
  });
}

/** A field has its places as columns and rows, and a number for each crossing. @param {FigureSeries} series @returns {Cell[][]} */
function fieldRows({ frame, name, role, stable, columns: { x, y, z } }) {
  return Array.from(y).flatMap((height, row) => Array.from(x, (value, column) => [frame, name, role, stable, 0, value, height, z?.[row * x.length + column]]));
}

/** @param {string | number | null} cell */
function worded(cell) {
  return typeof cell === "string" ? plain(cell) : cell;
}

/** A cell as RFC 4180 has it; what is not there is empty. @param {Cell} cell */
function written(cell) {
  if (cell === null || cell === undefined) return "";
  const text = String(cell);
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}
