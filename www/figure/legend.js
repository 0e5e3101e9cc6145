/**
 * The legend under a chart: an entry for each meaning that is drawn, a button that switches it. The state knows a meaning
 * by a name of its own, such as `exact-unstable`: what is switched off stays off when its curves are computed anew. Names of
 * single series are understood as well.
 *
 * @typedef {import("./services.js").Figure} Figure
 * @typedef {import("../engine/gear-bifurcations.js").FigureSeries} FigureSeries
 * @typedef {import("../engine/gear-bifurcations.js").SeriesLook} SeriesLook
 */

import { say } from "../words/say.js";

/** The meanings, in the order of the legend. */
const MEANINGS = (
  "exact-stable exact-unstable exact quasi-periodic corrected paper attractor trajectory downward saddle unstable-spiral " +
  "supercritical subcritical bifurcation fold torus-bifurcation across-manifold growth basins dead-zone other-regime event " +
  "interval-stable interval-saddle interval-spiral"
).split(" ");
const KNOWN = new Set(MEANINGS);
/** Areas are shown as a filled box, fields by their ramp. */
const AREAS = new Set(["dead-zone", "interval-stable", "interval-saddle", "interval-spiral", "basins"]);
const SVG = "http://www.w3.org/2000/svg";

/**
 * The meaning of a series as the legend has it; null for what is part of the chart's furniture.
 *
 * @param {Pick<FigureSeries, "role" | "stable">} series
 */
export function meaningOf({ role, stable }) {
  if (role === "corrected-second") return "corrected";
  const meaning = role === "exact" && stable !== null ? `exact-${stable ? "stable" : "unstable"}` : role;
  return KNOWN.has(meaning) ? meaning : null;
}

/**
 * The names of a figure's series that are switched off.
 *
 * @param {Figure} figure
 * @param {readonly string[]} hidden  Meanings and names of series.
 * @returns {Set<string>}
 */
export function hiddenSeries(figure, hidden) {
  if (hidden.length === 0) return new Set();
  const off = new Set(hidden);
  return new Set(figure.series.filter((one) => off.has(one.name) || off.has(meaningOf(one) ?? "")).map(({ name }) => name));
}

export class Legend {
  #home;
  #change;
  /** What the entries were made of. */
  #made = "";
  /** @type {Map<string, HTMLButtonElement>} */
  #entries = new Map();
  /** @type {readonly string[]} */
  #hidden = [];

  /**
   * @param {HTMLElement} home
   * @param {(hidden: string[]) => void} change
   */
  constructor(home, change) {
    this.#home = home;
    this.#change = change;
    home.setAttribute("role", "group");
  }

  /**
   * @param {Figure} figure
   * @param {readonly SeriesLook[]} looks
   * @param {readonly string[]} hidden
   */
  show(figure, looks, hidden) {
    this.#hidden = hidden;
    const byName = new Map(looks.map((look) => [look.name, look]));
    /** @type {Map<string, {series: FigureSeries, look: SeriesLook | undefined}>} */
    const found = new Map();
    for (const series of figure.series) {
      const meaning = meaningOf(series);
      if (meaning === null || found.has(meaning) || series.mark === "text" || series.columns.x.length === 0) continue;
      found.set(meaning, { series, look: byName.get(series.name) });
    }
    const meanings = found.size < 2 ? [] : MEANINGS.filter((meaning) => found.has(meaning));
    const made = JSON.stringify([say("legend.name"), meanings.map((meaning) => [say(`legend.${meaning}`), found.get(meaning)?.look])]);
    if (made !== this.#made) {
      this.#made = made;
      this.#build(meanings, found);
    }
    const off = new Set(hidden);
    for (const [meaning, entry] of this.#entries) entry.setAttribute("aria-pressed", String(!off.has(meaning)));
  }

  /**
   * Entries that are there already stay, and with them a reader's place.
   *
   * @param {readonly string[]} meanings
   * @param {ReadonlyMap<string, {series: FigureSeries, look: SeriesLook | undefined}>} found
   */
  #build(meanings, found) {
    this.#home.setAttribute("aria-label", say("legend.name"));
    for (const [meaning, entry] of this.#entries) {
      if (found.has(meaning) && meanings.length > 0) continue;
      entry.remove();
      this.#entries.delete(meaning);
    }
    for (const meaning of meanings) {
      const entry = this.#entries.get(meaning) ?? this.#make(meaning);
      const { series, look } = found.get(meaning) ?? {};
      entry.replaceChildren(swatch(meaning, series, look), say(`legend.${meaning}`));
      this.#home.append(entry);
    }
  }

  /** @param {string} meaning */
  #make(meaning) {
    const entry = document.createElement("button");
    entry.type = "button";
    entry.className = "entry";
    entry.addEventListener("click", () => {
      const off = this.#hidden.includes(meaning);
      this.#change(off ? this.#hidden.filter((one) => one !== meaning) : [...this.#hidden, meaning]);
    });
    this.#entries.set(meaning, entry);
    return entry;
  }
}

/**
 * A small picture of how a meaning looks.
 *
 * @param {string} meaning
 * @param {FigureSeries | undefined} series
 * @param {SeriesLook | undefined} look
 */
function swatch(meaning, series, look) {
  const picture = document.createElementNS(SVG, "svg");
  const stroke = look?.stroke ?? "currentcolor";
  for (const [name, value] of Object.entries({ viewBox: "0 0 26 14", class: `swatch ${meaning}`, "aria-hidden": "true" })) {
    picture.setAttribute(name, value);
  }
  if (meaning === "growth") return picture;
  if (AREAS.has(meaning)) {
    picture.append(shape("rect", { x: 3, y: 1.5, width: 20, height: 11, fill: stroke, "fill-opacity": 0.25, stroke }));
    return picture;
  }
  if (series?.mark === "curve" || series?.mark === "filled") {
    picture.append(shape("path", { d: "M1 7H25", stroke, "stroke-width": look?.width ?? 2, "stroke-dasharray": look?.dash?.join(" ") ?? "none" }));
    if (meaning !== "quasi-periodic") return picture;
  }
  picture.append(...mark(meaning === "quasi-periodic" ? "circle" : (look?.shape ?? "dot"), stroke, look?.outline ?? stroke));
  return picture;
}

/**
 * @param {SeriesLook["shape"] | "circle"} form
 * @param {string} fill
 * @param {string} outline
 * @returns {SVGElement[]}
 */
function mark(form, fill, outline) {
  const edge = { fill, stroke: outline, "stroke-width": 0.8 };
  if (form === "circle") return [shape("circle", { cx: 13, cy: 7, r: 2.6, fill: "var(--ground, #fff)", stroke: fill })];
  if (form === "dot") return [shape("circle", { cx: 13, cy: 7, r: 4, ...edge })];
  if (form === "cross") return [shape("path", { d: "M9 3l8 8m0-8l-8 8", stroke: fill, "stroke-width": 2 })];
  if (form === "diamond") return [shape("path", { d: "M13 1.5L18.5 7 13 12.5 7.5 7z", fill: "var(--ground, #fff)", stroke: fill, "stroke-width": 1.5 })];
  if (form === "triangle") return [shape("path", { d: "M13 1.5L18 11.5H8z", ...edge })];
  if (form === "ring") return [shape("circle", { cx: 13, cy: 7, r: 4.5, stroke: fill, "stroke-width": 1.6, fill: "none" })];
  return [shape("path", { d: "M13 .5l1.8 4.3 4.7.4-3.6 3 1.1 4.6L13 10.4l-4 2.4 1.1-4.6-3.6-3 4.7-.4z", ...edge })];
}

/**
 * @param {string} name
 * @param {Record<string, string | number>} attributes
 * @returns {SVGElement}
 */
function shape(name, attributes) {
  const made = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, String(value));
  return made;
}
