// Has cases run in a worker and watches it: a case that computes for too long is an answer too, and the wrong one.

import { inspect } from "node:util";
import { Worker } from "node:worker_threads";
import { argumentsOf } from "./cases.mjs";

/** @typedef {import("./worker.mjs").Report} Report */

export const SEED = 20_211;

/** How often the watch looks, ms. */
const LOOK = 250;

/** What a case was given, for a person. @param {import("./calls.mjs").Known} known @param {string} call @param {number} number @param {number} [seed] */
export function told(known, call, number, seed = SEED) {
  const args = inspect(argumentsOf(known, call, seed, number), { depth: 4, breakLength: 160, maxArrayLength: 12, maxStringLength: 200 });
  return `${call}, case ${number} of seed ${seed}: ${args}`;
}

export class Runner {
  #worker;
  #at;
  /** Most seconds that a case may compute. */
  #limit;
  /** @type {Promise<void>} */
  #ready;

  /** @param {string} script @param {{seed?: number, limit?: number, small?: boolean}} [options] */
  constructor(script, { seed = SEED, limit = 60, small = false } = {}) {
    const progress = new SharedArrayBuffer(8);
    this.#at = new Int32Array(progress);
    this.#limit = limit;
    this.#worker = new Worker(new URL("./worker.mjs", import.meta.url), { workerData: { script, seed, small, progress } });
    this.#ready = new Promise((resolve, reject) => {
      this.#worker.once("message", () => resolve());
      this.#worker.once("error", reject);
    });
  }

  /**
   * @param {string} call
   * @param {number} first
   * @param {number} count
   * @returns {Promise<Report>} rejected, with the case, where one computes for too long or the thread dies
   */
  async run(call, first, count) {
    await this.#ready;
    return new Promise((resolve, reject) => {
      let seen = -1;
      let since = computed();
      const watch = setInterval(() => {
        const now = Atomics.load(this.#at, 1);
        if (now !== seen) {
          seen = now;
          since = computed();
        } else if (computed() - since > this.#limit) {
          end();
          void this.#worker.terminate();
          reject(new Stuck(call, Atomics.load(this.#at, 0), this.#limit));
        }
      }, LOOK);
      const answered = (/** @type {Report} */ report) => {
        end();
        resolve(report);
      };
      const died = (/** @type {unknown} */ thrown) => {
        end();
        reject(new Error(`${call}, case ${Atomics.load(this.#at, 0)}: the thread died: ${thrown}`));
      };
      const end = () => {
        clearInterval(watch);
        this.#worker.off("message", answered);
        this.#worker.off("error", died);
        this.#worker.off("exit", died);
      };
      this.#worker.on("message", answered);
      this.#worker.on("error", died);
      this.#worker.on("exit", died);
      this.#worker.postMessage({ call, first, count });
    });
  }

  close() {
    return this.#worker.terminate();
  }
}

export class Stuck extends Error {
  /** @param {string} call @param {number} number @param {number} limit */
  constructor(call, number, limit) {
    super(`${call}, case ${number}, computes for more than ${limit} s`);
    this.call = call;
    this.number = number;
  }
}

/** Seconds this process has computed, all threads: while others have the machine they do not pass. */
function computed() {
  const { user, system } = process.cpuUsage();
  return (user + system) / 1e6;
}
