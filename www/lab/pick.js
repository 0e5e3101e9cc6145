/**
 * Picking with a click: an orbit on the branches, a start on the Poincare plane.
 *
 * @typedef {import("./charts.js").Chart} Chart
 * @typedef {import("../shell/services.js").RoomServices} RoomServices
 * @typedef {import("../figure/services.js").Figure} Figure
 */

import { dataAt, pixelOf, pixelUnder } from "../figure/frames.js";
import { pointOf, withPoint } from "../state.js";
import { number, say } from "../words/say.js";
import { START } from "./charts.js";
import { mapOf } from "./cursor.js";
import { numberOf, valueOf } from "../values.js";

/** A pointer that moved no further between press and release has clicked, CSS pixels. */
const STILL = 5;
/** An orbit this far from a click is not meant, CSS pixels. */
const REACH = 22;

/**
 * Calls with the place of each click on a chart's plot.
 *
 * @param {Chart} chart
 * @param {(place: {left: number, top: number}, map: import("../figure/services.js").FrameMap) => void} pick
 */
function onClick(chart, pick) {
  const { figure } = chart;
  let from = { x: 0, y: 0 };
  figure.addEventListener("pointerdown", (event) => {
    from = { x: event.clientX, y: event.clientY };
  });
  figure.addEventListener("click", (event) => {
    const canvas = figure.shadowRoot?.querySelector("canvas");
    const map = mapOf(chart);
    if (map === null || !(canvas instanceof HTMLCanvasElement) || event.composedPath()[0] !== canvas) return;
    if (event.detail > 1 || event.shiftKey || event.ctrlKey || event.metaKey) return;
    if (Math.hypot(event.clientX - from.x, event.clientY - from.y) > STILL) return;
    const place = pixelUnder(event, canvas);
    const { plot } = map;
    if (place.left < plot.left || place.left > plot.right || place.top < plot.top || place.top > plot.bottom) return;
    pick(place, map);
  });
}

/**
 * @param {Chart} branches
 * @param {RoomServices} services
 */
export function pickOrbits(branches, services) {
  const { act, announce, store, engine } = services;
  /** @param {number} row @param {NonNullable<Figure["orbits"]>} orbits */
  const take = (row, orbits) => {
    const state = Array.from(orbits.state.subarray(6 * row, 6 * row + 6));
    const values = { Omega: orbits.Omega[row], ...Object.fromEntries(START.map((name, index) => [name, state[index]])) };
    act("lab.act.orbit", (before) => withPoint(before, values));
    const [omega, size] = [number(orbits.Omega[row], { digits: 5 }), number(orbits.maxU_p[row], { digits: 5 })];
    const stable = say(orbits.stable[row] === 1 ? "lab.stable" : "lab.unstable");
    const period = orbits.period[row] === 0 ? say("lab.torus") : say("lab.period", { period: orbits.period[row] });
    announce(say("lab.picked", { period, stable, omega, size }));
  };
  onClick(branches, (place, map) => {
    const orbits = branches.figure.shown?.orbits ?? null;
    let [best, distance] = [-1, REACH];
    for (let row = 0; orbits !== null && row < orbits.Omega.length; row += 1) {
      const at = pixelOf(map, orbits.Omega[row], orbits.maxU_p[row]);
      const off = Math.hypot(at.left - place.left, at.top - place.top);
      if (off < distance) [best, distance] = [row, off];
    }
    if (orbits !== null && best >= 0) take(best, orbits);
    else act("act.parameter", (state) => withPoint(state, { Omega: Number(dataAt(map, place).x.toFixed(4)) }), { merge: "lab Omega" });
  });

  /** Which of the orbits at the present mesh frequency was taken last, from the smallest. */
  let last = -1;
  return {
    /** Takes the next orbit over the cursor, from the smallest to the largest and round again. */
    next() {
      const orbits = branches.figure.shown?.orbits ?? null;
      if (orbits === null) return;
      const rows = nearest(orbits, numberOf(pointOf(store.state), engine.vocabulary, "Omega"));
      if (rows.length === 0) {
        announce(say("lab.none-here"));
        return;
      }
      last = (last + 1) % rows.length;
      take(rows[last], orbits);
    },
  };
}

/**
 * The orbits next to a mesh frequency, one of each branch that passes there, from the smallest to the largest.
 *
 * @param {NonNullable<Figure["orbits"]>} orbits
 * @param {number} omega
 */
export function nearest({ Omega, maxU_p, period }, omega) {
  /** @type {number[]} */
  const rows = [];
  for (let row = 1; row < Omega.length; row += 1) {
    const passes = (Omega[row - 1] - omega) * (Omega[row] - omega) <= 0 && period[row] === period[row - 1];
    // Rows of two branches may follow each other: a branch has no leaps.
    if (!passes || Math.abs(Omega[row] - Omega[row - 1]) > 0.05 * omega) continue;
    const near = Math.abs(Omega[row] - omega) < Math.abs(Omega[row - 1] - omega) ? row : row - 1;
    if (!rows.some((other) => Math.abs(maxU_p[other] - maxU_p[near]) < 1e-6)) rows.push(near);
  }
  return rows.sort((one, other) => maxU_p[one] - maxU_p[other]);
}

/**
 * @param {Chart} plane
 * @param {RoomServices} services
 */
export function pickStarts(plane, { act, announce, store, engine }) {
  onClick(plane, (place, map) => {
    const { x, y } = dataAt(map, place);
    const digits = (/** @type {number} */ low, /** @type {number} */ high) => Math.max(0, Math.ceil(-Math.log10((high - low) / 2000)));
    const u_p = Number(x.toFixed(digits(map.x.low, map.x.high)));
    const rate = Number(y.toFixed(digits(map.y.low, map.y.high)));
    const rest = valueOf(pointOf(store.state), engine.vocabulary, "regime") === "homogeneous" ? 0 : 1;
    // Pinion and gear opposed, the transmission error at rest: as in figure A, so that its basins can be tried.
    const start = { u_p0: u_p, u_g0: -u_p, u0: rest, u_p_dot0: rate, u_g_dot0: -rate, u_dot0: 0 };
    act("lab.act.start", (state) => withPoint(state, start));
    announce(say("lab.started", { x: u_p, y: rate }));
  });
}
