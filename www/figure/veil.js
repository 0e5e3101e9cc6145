/**
 * A figure without what would answer a question about it: the word beside the point that stands for the present state, the
 * sentence that says what is seen, its notes and its facts. What is drawn stays.
 *
 * @typedef {import("./services.js").Figure} Figure
 */

/**
 * @param {Figure} figure
 * @returns {Figure}
 */
export function veiled(figure) {
  return {
    ...figure,
    summary: figure.title,
    notes: [],
    facts: {},
    distances: [],
    series: figure.series.map((series) => (series.role === "handle" ? { ...series, label: null, meaning: "" } : series)),
  };
}
