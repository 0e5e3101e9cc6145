/**
 * The laboratory's charts: figures that share one operating point.
 *
 * @typedef {import("../figure/gear-figure.js").GearFigure} GearFigure
 * @typedef {import("../shell/services.js").RoomServices} RoomServices
 * @typedef {"T" | "B" | "1" | "U" | "P" | "M" | "W"} ChartId
 * @typedef {object} Chart
 * @property {ChartId} id
 * @property {HTMLElement} place  With its heading.
 * @property {GearFigure} figure
 */

import { element, set } from "../controls/dom.js";

/** In the order in which they are read. @type {readonly ChartId[]} */
export const CHARTS = Object.freeze(["T", "B", "1", "U", "P", "M", "W"]);
/** Numbers of a start. */
export const START = Object.freeze(["u_p0", "u_g0", "u0", "u_p_dot0", "u_g_dot0", "u_dot0"]);
/** Those that show a motion from a start. */
const STARTING = new Set(["1", "U", "P", "W"]);
/** What does not depend on the mesh frequency, because it is drawn over it. */
const OVER_OMEGA = new Set(["B"]);

/**
 * @param {RoomServices} services
 * @returns {Map<ChartId, Chart>}
 */
export function createCharts({ engine, store }) {
  const model = [...engine.vocabulary.keys()].filter((name) => !START.includes(name));
  return new Map(
    CHARTS.map((id) => {
      const figure = /** @type {GearFigure} */ (document.createElement("gear-figure"));
      figure.id = `lab-${id}`;
      figure.setAttribute("figure", id);
      figure.setAttribute("controls", "none");
      figure.setAttribute("fit", "");
      const names = OVER_OMEGA.has(id) ? model.filter((name) => name !== "Omega") : model;
      store.share(figure.id, STARTING.has(id) ? [...names, ...START] : names);
      const heading = set(element("h2", ""), `lab.chart.${id}`);
      heading.id = `lab-${id}-name`;
      const place = element("section", `chart chart-${id}`, heading, figure);
      place.setAttribute("aria-labelledby", heading.id);
      return [id, { id, place, figure }];
    }),
  );
}
