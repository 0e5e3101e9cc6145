/**
 * Draws once where nobody sees it, while the workers compute the first figures: a browser compiles the code that draws
 * when it is first called, and the first reader's picture should not wait for that.
 *
 * @typedef {import("../../gear-bifurcations.js").Gear} Gear
 * @typedef {import("../../gear-bifurcations.js").Figure} Figure
 */

/** @param {Gear} gear */
export function warmDrawing(gear) {
  const canvas = document.createElement("canvas");
  try {
    gear.draw(sample(gear), undefined, canvas, { density: 1 });
  } catch {
    // What fails here fails again where it can be told to somebody.
  }
}

/**
 * A little of all that a formula figure is made of.
 *
 * @param {Gear} gear
 * @returns {Figure}
 */
function sample(gear) {
  const params = Object.fromEntries(gear.defaults().map((info) => [info.name, info.default]));
  const axis = (/** @type {string} */ name) => ({ name, label: `*${name}*_{1}`, low: 0, high: 1 });
  /**
   * @param {import("../../gear-bifurcations.js").Mark} mark
   * @param {import("../../gear-bifurcations.js").Role} role
   * @param {boolean | null} stable
   */
  const series = (mark, role, stable) => ({
    frame: "sample",
    name: `${mark} ${role}`,
    meaning: "",
    stable,
    role,
    mark,
    label: mark === "curve" ? "*sample*" : null,
    labelAt: 0.5,
    columns: { x: new Float64Array([0.1, 0.5, 1.5]), y: new Float64Array([0.1, 0.9, 0.2]) },
    pieces: new Uint32Array(),
  });
  return {
    id: "2",
    title: "",
    params: /** @type {any} */ (params),
    grid: [1, 1],
    axes: [
      { frame: "sample", title: "*Sample*", x: axis("x"), y: axis("y"), z: null, bar: null, cell: [0, 0], span: [1, 1], equalAspect: false, bare: false },
    ],
    series: [
      series("curve", "paper", true),
      series("curve", "corrected", false),
      series("marks", "supercritical", null),
      series("marks", "subcritical", null),
    ],
    summary: "",
    notes: [],
    facts: {},
    end: null,
    orbits: null,
    distances: [],
    method: "",
    error: {},
    table: null,
    motion: null,
  };
}
