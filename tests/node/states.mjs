// States of the page at random, and what there is to be named in one.

import { PRESETS } from "../../www/presets.js";
import { INITIAL, LANGUAGES, THEMES, VIEWS, withFigure, withPoint } from "../../www/state.js";
import { PHYSICAL } from "../../www/url.js";
import { gear } from "./support.mjs";

/** @typedef {import("./random.mjs").Choose} Choose */

const infos = [...gear.defaults(), ...gear.figures().flatMap((/** @type {any} */ { parameters }) => parameters)];
/** Short forms that no figure has among its controls are known all the same. */
const short = gear.defaults().filter((/** @type {any} */ info) => info.short).map((/** @type {any} */ info) => ({ ...info, name: info.short }));

/** @type {ReadonlyMap<string, any>} */
export const vocabulary = new Map([...short, ...infos].map((info) => [info.name, info]));
export const PLACES = ["pulse", "fig-12a", "key"];
export const known = { vocabulary, isPlace: (/** @type {string} */ id) => PLACES.includes(id) };

/** @param {Choose} choose @returns {import("../../www/state.js").State} */
export function randomState(choose) {
  let state = {
    ...INITIAL,
    view: choose.of(VIEWS),
    at: choose.chance(0.2) ? choose.of(PLACES) : null,
    preset: choose.of(PRESETS),
    theme: choose.of(THEMES),
    projector: choose.chance(0.3),
    language: choose.of(LANGUAGES),
  };
  state = withPoint(state, randomGiven(choose));
  for (let count = choose.integer(0, 3); count > 0; count -= 1) {
    const key = `${choose.of(["fig-", "lab-", "class-"])}${choose.of(PRESETS)}`;
    state = withFigure(state, key, {
      given: randomGiven(choose),
      windows: Object.fromEntries(
        Array.from({ length: choose.integer(0, 2) }, (_, index) => [`frame-${index}`, { x: interval(choose), y: interval(choose) }]),
      ),
      hidden: Array.from({ length: choose.integer(0, 3) }, () => randomText(choose)),
      view: choose.chance(0.3) ? { azimuth: choose.number(-9, 9), elevation: choose.number(-1.5, 1.5) } : null,
    });
  }
  const pinned = Array.from({ length: choose.integer(0, 2) }, () => {
    const preset = choose.of(PRESETS);
    return { preset, point: withPoint({ ...INITIAL, preset }, randomGiven(choose)).point };
  });
  const lesson = choose.chance(0.3) ? { id: "hopf", step: choose.integer(0, 9), locked: Object.keys(randomGiven(choose)) } : null;
  const si = choose.chance(0.3) ? { [choose.of(PHYSICAL)]: choose.number(-1e9, 1e9), [choose.of(PHYSICAL)]: 1 / 3 } : null;
  return { ...state, pinned, lesson, si };
}

/** @param {Choose} choose */
function randomGiven(choose) {
  /** @type {Record<string, number | string>} */
  const given = {};
  for (let count = choose.integer(0, 4); count > 0; count -= 1) {
    const info = vocabulary.get(choose.of([...vocabulary.keys()]));
    if ("choices" in info) given[info.name] = choose.of(info.choices);
    else given[info.name] = Math.min(info.high, Math.max(info.low, choose.chance(0.5) ? choose.number(info.low, info.high) : choose.of([0, 1e-7, 1.5, 1e21])));
  }
  return given;
}

/** @param {Choose} choose @returns {[number, number]} */
function interval(choose) {
  const low = choose.number(-10, 10) * choose.of([1, 1e-9, 1e9]);
  return [low, low + Math.max(1e-12, Math.abs(low)) * choose.number(0.1, 3)];
}

/** Names of series, and worse. @param {Choose} choose */
export function randomText(choose) {
  return Array.from({ length: choose.integer(1, 12) }, () => choose.of([..."abcK0 ,.&=#%+|±Ω’\"<>/\\é\u{1f600}"])).join("").trim() || "a";
}
