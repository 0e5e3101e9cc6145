/**
 * A figure that is a table: what is printed beside what is computed, a row each, filled in as they come.
 *
 * @typedef {import("./services.js").Figure} Figure
 * @typedef {import("../engine/gear-bifurcations.js").TableRow} TableRow
 */

import { number, say } from "../words/say.js";
import { elements } from "./markup.js";

/** Digits of a number in the table. */
const DIGITS = 8;
/** Digits of a deviation: its size is what matters. */
const FEW = 2;
/** Differences below this are rounding. */
const ROUNDING = 1e-12;

const HEADS = ["line", "where", "what", "printed", "corrected", "exact", "printed-off", "corrected-off", "known"];

/**
 * Puts the rows into their place; those that are there already stay as they are, so that a reader's place is kept.
 *
 * @param {HTMLElement} place
 * @param {Figure} figure
 */
export function showRows(place, figure) {
  const rows = figure.table ?? [];
  const table = place.querySelector("table") ?? begin(place, figure.title);
  const body = table.tBodies[0];
  const key = (/** @type {TableRow} */ row) => JSON.stringify(row);
  const places = placesOf(figure.id, rows);
  rows.forEach((row, index) => {
    const old = body.rows[index];
    if (old?.dataset.key === key(row)) return;
    const made = line(row, index + 1);
    made.dataset.key = key(row);
    made.id = places[index];
    if (old) old.replaceWith(made);
    else body.append(made);
  });
  while (body.rows.length > rows.length) body.deleteRow(-1);
}

/**
 * A name for each row by which it can be linked to: where it stands in the paper, such as `E-106-109`. The second of the
 * same name is `E-56-2`.
 *
 * @param {string} id  The figure's.
 * @param {readonly TableRow[]} rows
 * @returns {string[]}
 */
export function placesOf(id, rows) {
  /** @type {Map<string, number>} */
  const met = new Map();
  return rows.map(({ where }) => {
    const name = `${id}-${where.toLowerCase().replace(/[^a-z0-9]+/g, "-").replace(/^-|-$/g, "")}`;
    const count = (met.get(name) ?? 0) + 1;
    met.set(name, count);
    return count === 1 ? name : `${name}-${count}`;
  });
}

/**
 * @param {HTMLElement} place
 * @param {string} title
 */
function begin(place, title) {
  const table = document.createElement("table");
  table.createCaption().textContent = title;
  const head = table.createTHead().insertRow();
  for (const name of HEADS) {
    const cell = document.createElement("th");
    cell.scope = "col";
    cell.textContent = say(`rows.${name}`);
    head.append(cell);
  }
  table.createTBody();
  place.replaceChildren(table);
  // A region that scrolls must be reachable by keys.
  place.tabIndex = 0;
  place.setAttribute("role", "region");
  place.setAttribute("aria-label", title);
  return table;
}

/**
 * @param {TableRow} row
 * @param {number} number
 */
function line(row, number) {
  const made = document.createElement("tr");
  made.insertCell().textContent = String(number);
  const name = document.createElement("th");
  name.scope = "row";
  name.append(elements(row.where));
  made.append(name);
  made.insertCell().append(elements(row.what));
  for (const entry of [row.printed, row.ours, row.exact]) {
    const cell = made.insertCell();
    if (typeof entry === "number") {
      cell.className = "number";
      cell.textContent = written(entry, DIGITS);
    } else if (entry !== null) {
      cell.append(elements(entry));
    }
  }
  for (const deviation of [row.deviation, row.ownDeviation]) {
    const cell = made.insertCell();
    cell.className = "number";
    if (deviation !== null) cell.textContent = Math.abs(deviation) < ROUNDING ? "0" : written(deviation, FEW);
  }
  made.insertCell().append(elements(row.remark));
  return made;
}

/**
 * @param {number} value
 * @param {number} digits
 */
function written(value, digits) {
  return number(Number(value.toPrecision(digits)));
}
