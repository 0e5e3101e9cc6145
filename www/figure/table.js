/**
 * A figure's numbers as tables, for readers who want them or cannot see the picture.
 *
 * @typedef {import("./services.js").Figure} Figure
 * @typedef {import("../engine/gear-bifurcations.js").FigureSeries} FigureSeries
 * @typedef {import("../engine/gear-bifurcations.js").FigureFrame} FigureFrame
 * @typedef {{name: string, label: string, values: ArrayLike<number>}} Column
 */

import { number, say } from "../words/say.js";
import { FURNITURE } from "./furniture.js";
import { elements, plain, sentence } from "./markup.js";
import { distanceWords, errorWords } from "./trust.js";

/** Rows in all tables of a figure together. */
const ROWS = 360;
/** Rows that even the least of many tables has. */
const FEWEST = 6;
/** Digits of a number in a table: what a reader may want to check, not all that is known. */
const DIGITS = 7;

/**
 * Puts the figure's words and tables under the summary of its details.
 *
 * @param {HTMLDetailsElement} details
 * @param {Figure} figure
 */
export function showTables(details, figure) {
  const words = document.createElement("p");
  words.append(sentence(figure.summary));
  const method = document.createElement("p");
  method.append(say("table.method"), " ", sentence(figure.method));
  const trust = document.createElement("p");
  const errors = errorWords(figure.error);
  if (errors !== "") trust.append(sentence(say("trust.errors", { errors })));
  const apart = distanceWords(figure).map((words) => {
    const line = document.createElement("p");
    line.append(sentence(words));
    return line;
  });
  const scroll = document.createElement("div");
  // A region that scrolls must be reachable by keys.
  scroll.tabIndex = 0;
  scroll.setAttribute("role", "region");
  scroll.setAttribute("aria-label", say("table.numbers"));
  scroll.append(...tables(figure));
  hideTables(details);
  details.append(words, method, ...(errors === "" ? [] : [trust]), ...apart, scroll);
}

/**
 * Nothing under the summary: tables have thousands of nodes, and are made anew when they are wanted.
 *
 * @param {HTMLDetailsElement} details
 */
export function hideTables(details) {
  for (const old of [...details.children].slice(1)) old.remove();
}

/**
 * @param {Figure} figure
 * @returns {HTMLElement[]}
 */
function tables(figure) {
  if (figure.motion !== null) {
    const { t, u_p, u_g, u } = figure.motion;
    const columns = [
      { name: "t", label: "*t*", values: t },
      { name: "u_p", label: "*u*_{p}", values: u_p },
      { name: "u_g", label: "*u*_{g}", values: u_g },
      { name: "u", label: "*u*", values: u },
    ];
    return [table(say("table.motion"), columns, ROWS)];
  }
  const told = figure.series.filter(
    ({ role, mark, columns }) => !FURNITURE.has(role) && !["text", "band", "field"].includes(mark) && columns.x.length > 0,
  );
  const rows = Math.max(FEWEST, Math.floor(ROWS / Math.max(1, told.length)));
  return told.map((series) => seriesTable(figure, series, rows));
}

/**
 * @param {Figure} figure
 * @param {FigureSeries} series
 * @param {number} rows
 */
function seriesTable(figure, series, rows) {
  const frame = figure.axes.find((axes) => axes.frame === series.frame);
  /** @type {Column[]} */
  const columns = [];
  for (const axis of /** @type {const} */ (["x", "y", "z"])) {
    const values = series.columns[axis];
    if (values === undefined || values.length === 0) continue;
    columns.push({ name: frame?.[axis]?.name ?? axis, label: frame?.[axis]?.label ?? axis, values });
  }
  const where = frame?.title ? ` (${plain(frame.title)})` : "";
  return table(`${series.meaning}${where}`, columns, rows);
}

/**
 * @param {string} title
 * @param {readonly Column[]} columns
 * @param {number} rows
 */
function table(title, columns, rows) {
  const made = document.createElement("table");
  const count = columns[0].values.length;
  const shown = Math.min(count, rows);
  const caption = made.createCaption();
  caption.append(sentence(shown < count ? say("table.some", { title, shown, count }) : title));
  const head = made.createTHead().insertRow();
  for (const { label } of columns) {
    const cell = document.createElement("th");
    cell.scope = "col";
    cell.append(elements(label));
    head.append(cell);
  }
  const body = made.createTBody();
  for (let row = 0; row < shown; row += 1) {
    // Evenly thinned, both ends kept.
    const index = shown === 1 ? 0 : Math.round((row * (count - 1)) / (shown - 1));
    const line = body.insertRow();
    for (const { values } of columns) line.insertCell().textContent = inTable(values[index]);
  }
  return made;
}

/** @param {number} value */
function inTable(value) {
  return number(Number(value.toPrecision(DIGITS)));
}
