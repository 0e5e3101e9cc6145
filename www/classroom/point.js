/**
 * The operating point in the classroom: which parameters can be changed, and what figures find at it.
 *
 * @typedef {import("../shell/services.js").RoomServices} RoomServices
 * @typedef {import("../state.js").Given} Given
 * @typedef {import("./lesson.js").Plain} Plain
 * @typedef {import("./judge.js").World} World
 * @typedef {import("../figure/services.js").Figure} Figure
 */

import { valueOf } from "../values.js";

/** Numbers of a start: `u_p0`, `u_dot0`. */
const STARTS = /^u(_[pg])?(_dot)?0$/;

/**
 * The parameters that a figure takes: those of the model, and those of a start where it shows a motion from one.
 *
 * @param {{figures: RoomServices["engine"]["figures"], vocabulary: RoomServices["engine"]["vocabulary"]}} engine
 * @param {string} figure
 * @returns {readonly string[]}
 */
export function parametersOf({ figures, vocabulary }, figure) {
  const own = new Set(figures.get(figure)?.parameters.map(({ name }) => name));
  return [...vocabulary.keys()].filter((name) => own.has(name) || !STARTS.test(name));
}

/**
 * What of a point a figure takes.
 *
 * @param {RoomServices["engine"]} engine
 * @param {string} figure
 * @param {Given} given
 */
export function givenTo(engine, figure, given) {
  const names = parametersOf(engine, figure);
  return Object.fromEntries(Object.entries(given).filter(([name]) => names.includes(name)));
}

/**
 * What there is to ask at a point. Each figure is computed once, however many of its facts are asked for.
 *
 * @param {RoomServices} services
 * @param {Given} given
 * @param {AbortSignal} signal
 * @returns {World}
 */
export function worldAt({ engine }, given, signal) {
  /** @type {Map<string, Promise<Figure>>} */
  const figures = new Map();
  return {
    given,
    parameter: (name) => valueOf(given, engine.vocabulary, name),
    async fact(id, name) {
      let figure = figures.get(id);
      if (figure === undefined) {
        figure = engine.compute(id, givenTo(engine, id, given), { signal });
        figures.set(id, figure);
      }
      return (await figure).facts[name];
    },
  };
}
