/**
 * Play: the mesh frequency creeps, so slowly that the motion follows, its state carried over from one value to the next.
 *
 * @typedef {import("../shell/services.js").RoomServices} RoomServices
 */

import { pointOf, withPoint } from "../state.js";
import { START } from "./charts.js";
import { numberOf } from "../values.js";

/** Steps a second at most: charts must have time to follow. */
const PAUSE = 120;
/** By so much the state is disturbed at each step, as in any real machine: what is unstable must be left. */
const DISTURBANCE = [-4e-4, 4.2e-4, 1e-3, 0, 0, 0];
/** Parts of the range passed in one step, by the word for the pace. */
export const PACES = Object.freeze({ slow: 1 / 1600, normal: 1 / 640, fast: 1 / 240 });

/**
 * @typedef {object} Hooks
 * @property {() => [number, number]} range  Of the mesh frequencies that are shown; at its end creeping stops.
 * @property {() => void} changed  It runs, or does not any more.
 * @property {() => void} stepped
 * @property {(time: number) => void} escaped
 */

export class Creep {
  /** @type {keyof typeof PACES} */
  pace = "normal";
  /** @type {1 | -1} */
  direction = -1;
  #services;
  #hooks;
  /** @type {AbortController | null} */
  #running = null;

  /**
   * @param {RoomServices} services
   * @param {Hooks} hooks
   */
  constructor(services, hooks) {
    this.#services = services;
    this.#hooks = hooks;
  }

  get running() {
    return this.#running !== null;
  }

  start() {
    if (this.#running !== null) return;
    this.#running = new AbortController();
    this.#services.store.hold();
    this.#hooks.changed();
    void this.#run(this.#running);
  }

  stop() {
    if (this.#running === null) return;
    this.#running.abort();
    this.#running = null;
    this.#services.store.release();
    this.#hooks.changed();
  }

  /** @param {AbortController} run */
  async #run(run) {
    const { engine, store, act } = this.#services;
    const isRunning = () => this.#running === run;
    while (isRunning()) {
      const begun = performance.now();
      const given = pointOf(store.state);
      const [low, high] = this.#hooks.range();
      const omega = numberOf(given, engine.vocabulary, "Omega") + this.direction * (high - low) * PACES[this.pace];
      if (omega < Math.max(low, 0.01) || omega > high) break;
      let figure;
      try {
        figure = await engine.compute("U", given, { signal: run.signal });
      } catch {
        // Stopped, or a point that allows no motion: its charts say why.
        break;
      }
      if (!isRunning()) return;
      if (figure.end === null) {
        this.#hooks.escaped(Number(figure.facts.escapedAt));
        break;
      }
      const state = Array.from(figure.end, (value, index) => Number((value + DISTURBANCE[index]).toPrecision(9)));
      const start = Object.fromEntries(START.map((name, index) => [name, state[index]]));
      act("lab.act.creep", (before) => withPoint(before, { ...start, Omega: Number(omega.toFixed(5)) }), { merge: "lab creep" });
      this.#hooks.stepped();
      await new Promise((resolve) => setTimeout(resolve, Math.max(0, PAUSE - (performance.now() - begun))));
    }
    if (isRunning()) this.stop();
  }
}
