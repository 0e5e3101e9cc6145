/**
 * The two charts over the mesh frequency show the same stretch of it: a part that is looked at in one is looked at in the
 * other.
 *
 * @typedef {import("../state.js").Store} Store
 * @typedef {import("../state.js").State} State
 * @typedef {import("./charts.js").ChartId} ChartId
 * @typedef {import("./charts.js").Chart} Chart
 */

import { figureOf, same, withFigure } from "../state.js";
import { mapOf } from "./cursor.js";

/** The charts with the name of their frame. */
const PAIR = /** @type {const} */ ([
  ["T", "tongues"],
  ["B", "branches"],
]);

/**
 * @param {Store} store
 * @param {State} before
 * @param {ReadonlyMap<ChartId, Chart>} charts
 */
export function shareWindows(store, before, charts) {
  for (const [index, [id, frame]] of PAIR.entries()) {
    const { state } = store;
    const [now, was] = [state, before].map((one) => figureOf(one, `lab-${id}`).windows[frame]);
    if (now === was || same(now, was)) continue;
    const [other, place] = PAIR[1 - index];
    const key = `lab-${other}`;
    const { windows } = figureOf(state, key);
    const there = windows[place];
    if (now === undefined) {
      if (there === undefined || !same(there.x, was?.x)) continue;
      const { [place]: _, ...rest } = windows;
      store.update({ figures: withFigure(state, key, { windows: rest }).figures });
      continue;
    }
    const chart = charts.get(other);
    const map = chart === undefined ? null : mapOf(chart);
    const height = there?.y ?? (map === null ? null : /** @type {const} */ ([map.y.low, map.y.high]));
    if (height === null || same(there?.x, now.x)) continue;
    const window = { x: now.x, y: height };
    store.update({ figures: withFigure(state, key, { windows: { ...windows, [place]: window } }).figures });
  }
}
