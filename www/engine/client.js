/**
 * The engine as the rest of the page knows it: workers that compute, and one instance of the module here that
 * draws and answers what needs no computing.
 *
 * @typedef {import("../../gear-bifurcations.js").Gear} Gear
 * @typedef {import("../../gear-bifurcations.js").Figure} Figure
 * @typedef {import("../../gear-bifurcations.js").FigureInfo} FigureInfo
 * @typedef {import("../../gear-bifurcations.js").ParameterInfo} ParameterInfo
 * @typedef {import("../../gear-bifurcations.js").FrameMap} FrameMap
 * @typedef {import("../../gear-bifurcations.js").SeriesLook} SeriesLook
 * @typedef {import("../../gear-bifurcations.js").DrawOptions} DrawOptions
 * @typedef {import("./protocol.js").Given} Given
 */

/**
 * @typedef {object} ComputeOptions
 * @property {AbortSignal} [signal]  Ends the computation; what it still answers is dropped.
 * @property {number} [priority]  See `PRIORITY` in protocol.js.
 * @property {(figure: Figure) => void} [partial]  What there is so far.
 * @property {() => void} [restarted]  The worker died and the computation begins anew in its successor.
 * @property {import("./protocol.js").Wanted | null} [picture]  How it will be drawn: where that can be the worker draws it too.
 * @property {Promise<void> | null} [held]  Until this is over it stops at its first picture.
 */

import { GearError, load } from "../../gear-bifurcations.js";
import { wasm } from "./delivery.js";
import { merged } from "./parts.js";
import { Pool, poolSize } from "./pool.js";
import { PRIORITY, giveBack } from "./protocol.js";

export { GearError, PRIORITY };

/**
 * A pair's short form, which may be given even where no figure has it among its controls.
 *
 * @param {ParameterInfo} info
 * @returns {ParameterInfo[]}
 */
function shortForm(info) {
  if ("choices" in info || info.short === null) return [];
  const { name, short } = info;
  const sets = ["p", "g"].map((body) => name.replace(/[pg]$/, body));
  return [{ ...info, name: short, symbol: info.symbol.replace(/_\{[pg]\}/, "_{s}"), short: null, sets }];
}

/**
 * Figures of the paper have its numbers; those beyond it have letters, and wait until the paper's are there, but for the
 * chart that the page opens with.
 */
const AT_ONCE = /^(\d|T$)/;

/** What may be computed in the page's own thread, ms: half a frame. */
const MOMENT = 8;
/** What takes longer so many times running, or once twice as long, is left to the workers, */
const PATIENCE = 3;
/** so many times at first; each time it is no better when it is tried again, for twice as many, up to the most. */
const REST = Object.freeze({ least: 2, most: 1024 });

export class Engine {
  #gear;
  #pool;
  /** Figures that came with their picture, until they are drawn. @type {WeakMap<Figure, {wanted: import("./protocol.js").Wanted, drawn: import("./protocol.js").Drawn}>} */
  #pictures = new WeakMap();
  /** What was asked before anybody could, and not taken up yet. @type {Early | null} */
  #early;
  /**
   * How glances at each figure went: how many took too long running, how often it is not to be tried now, and the next time.
   *
   * @type {Map<string, {late: number, left: number, rest: number}>}
   */
  #glances = new Map();
  #open = () => {};
  /** @type {Promise<void>} */
  #opened = new Promise((resolve) => {
    this.#open = resolve;
  });
  /** Says a sentence of the engine in the language of the page; null for English. @type {((text: string) => string) | null} */
  words = null;
  /** What is known of each figure, in the paper's order. @type {ReadonlyMap<string, FigureInfo>} */
  figures;
  /** Every parameter there is, full names and short forms. @type {ReadonlyMap<string, ParameterInfo>} */
  vocabulary;

  /**
   * @param {Gear} gear
   * @param {Pool} pool
   * @param {object} [options]
   * @param {Early | null} [options.early]
   * @param {boolean} [options.draws]
   * @param {Omit<import("./protocol.js").Fetched, "module">} [options.known]  What the module would say of itself.
   */
  constructor(gear, pool, { early = null, draws = false, known = { figures: gear.figures(), defaults: gear.defaults() } } = {}) {
    this.#gear = gear;
    this.#pool = pool;
    this.#early = early;
    this.draws = draws;
    this.figures = new Map(known.figures.map((info) => [info.id, info]));
    const parameters = [...known.defaults, ...[...this.figures.values()].flatMap((info) => info.parameters)];
    this.vocabulary = new Map([...parameters.flatMap(shortForm), ...parameters].map((info) => [info.name, info]));
  }

  /**
   * Computes a figure in a worker.
   *
   * @param {string} id
   * @param {Given} given
   * @param {ComputeOptions} [options]
   * @returns {Promise<Figure>} rejected with a `GearError`, or with the signal's reason
   */
  compute(id, given, { signal, priority = PRIORITY.shown, partial, restarted, picture: wanted = null, held = null } = {}) {
    return new Promise((resolve, reject) => {
      if (signal?.aborted) {
        reject(signal.reason);
        return;
      }
      const heavy = this.figures.get(id)?.heavy ?? false;
      /** @type {number[]} */
      const tickets = [];
      const stop = () => tickets.forEach((ticket) => this.#pool.cancel(ticket));
      const early = this.#takeEarly(id, given);
      const abandon = () => {
        stop();
        reject(signal?.reason);
      };
      const over = () => signal?.removeEventListener("abort", abandon);
      const run = () => {
        if (signal?.aborted) return;
        const parts = early === null ? this.#parts(id, given) : 1;
        const pictures = Array(parts).fill(null);
        const done = Array(parts).fill(false);
        for (let part = 0; part < parts; part += 1) {
          /**
           * @param {Figure} figure
           * @param {import("./protocol.js").Drawn | null} drawn
           */
          const picture = (figure, drawn) => {
            if (drawn !== null && wanted !== null) this.#pictures.set(figure, { wanted, drawn });
            pictures[part] = figure;
            return parts === 1 ? figure : merged(pictures, done);
          };
          /** @type {import("./pool.js").Answers} */
          const answers = {
            partial: (figure, drawn) => partial?.(picture(figure, drawn)),
            restarted: () => restarted?.(),
            done: (figure, drawn) => {
              done[part] = true;
              const all = picture(figure, drawn);
              if (!done.every(Boolean)) return;
              over();
              resolve(all);
            },
            failed: (error) => {
              over();
              stop();
              reject(new GearError(error));
            },
          };
          tickets.push(early === null ? this.#pool.run({ id, given, heavy, priority, part, parts, picture: parts === 1 ? wanted : null, held: held !== null }, answers) : early.takenUp(answers));
        }
        void held?.then(() => tickets.forEach((ticket) => this.#pool.goOn(ticket)));
      };
      signal?.addEventListener("abort", abandon, { once: true });
      if (AT_ONCE.test(id)) run();
      else void this.#opened.then(run);
    });
  }

  /**
   * The question that was asked early, if it is this one: to be had once. Where it is another it was a wrong guess.
   *
   * @param {string} id
   * @param {Given} given
   */
  #takeEarly(id, given) {
    const early = this.#early;
    if (early === null || early.id !== id) return null;
    this.#early = null;
    const parameters = this.figures.get(id)?.parameters ?? [];
    const own = Object.entries(given).every(([name, value]) => parameters.some((info) => info.name === name && info.default === value));
    if (own) return early;
    this.#pool.cancel(early.ticket);
    return null;
  }

  /**
   * Among how many workers a figure is divided.
   *
   * @param {string} id
   * @param {Given} given
   */
  #parts(id, given) {
    if (!this.figures.get(id)?.divisible) return 1;
    try {
      const parts = this.#pool.size;
      const steps = this.#gear.progress(id, given, { part: 0, parts });
      steps.return();
      return steps.divided ? parts : 1;
    } catch {
      // What cannot be is said by the worker.
      return 1;
    }
  }

  /**
   * Draws a computed figure; nothing is computed.
   *
   * @param {Figure} figure
   * @param {HTMLCanvasElement} canvas
   * @param {DrawOptions} options
   * @returns {{frames: FrameMap[], looks: SeriesLook[]}}
   */
  draw(figure, canvas, options) {
    const ready = this.#shownReady(figure, canvas, options);
    if (ready !== null) return ready;
    // One that moves has its words made anew for every moment.
    const said = this.words === null || figure.motion === null ? options : { ...options, words: this.words };
    return this.#gear.draw(figure, undefined, canvas, said);
  }

  /**
   * Shows a picture that came with its figure, if it is of the kind that is wanted now: once, for it is given away.
   *
   * @param {Figure} figure
   * @param {HTMLCanvasElement} canvas
   * @param {DrawOptions} options
   */
  #shownReady(figure, canvas, { theme, density, view }) {
    const ready = this.#pictures.get(figure);
    if (ready === undefined) return null;
    this.#pictures.delete(figure);
    const { bitmap, frames, looks } = ready.drawn;
    const { width, height } = canvas;
    const now = { width, height, theme, density, view };
    const context = JSON.stringify(ready.wanted) === JSON.stringify(now) ? canvas.getContext("2d") : null;
    if (context !== null) {
      context.globalCompositeOperation = "copy";
      context.drawImage(bitmap, 0, 0);
      context.globalCompositeOperation = "source-over";
    }
    bitmap.close();
    return context === null ? null : { frames, looks };
  }

  /**
   * A computed figure as the text of an SVG picture.
   *
   * @param {Figure} figure
   * @param {import("../../gear-bifurcations.js").SvgOptions} options
   */
  svg(figure, options) {
    return this.#gear.svg(figure, undefined, this.words === null ? options : { ...options, words: this.words });
  }

  /**
   * Whether a glance at a figure is worth a try: to be asked once for each, for it counts down where the last took too long.
   *
   * @param {string} id
   */
  glances(id) {
    const past = this.#glances.get(id);
    if (past === undefined || past.left === 0) return this.figures.has(id);
    past.left -= 1;
    return false;
  }

  /**
   * A figure computed here and now as far as it comes in a moment, as formulas and short motions come wholly and others coarsely:
   * it is then drawn in the very frame in which its parameters changed. Null where that would hold up the page; nothing is known
   * of errors then.
   *
   * @param {string} id
   * @param {Given} given
   * @returns {{figure: Figure, done: boolean} | null}
   */
  glance(id, given) {
    const past = this.#glances.get(id) ?? { late: 0, left: 0, rest: REST.least };
    this.#glances.set(id, past);
    const { last, took, failed } = this.#inTime(id, given, MOMENT / 2);
    if (failed) return null;
    // A busy machine makes one call slow, but not one after the other, and not so slow.
    if (last !== null && took < MOMENT) Object.assign(past, { late: 0, rest: REST.least });
    else past.late += 1;
    if (past.late >= PATIENCE || took > 2 * MOMENT) Object.assign(past, { left: past.rest, rest: Math.min(2 * past.rest, REST.most) });
    return last;
  }

  /**
   * A figure computed here and now as far as it comes within a time, for where nothing can be waited for, such as paper.
   *
   * @param {string} id
   * @param {Given} given
   * @param {number} time  Milliseconds.
   * @returns {{figure: Figure, done: boolean} | null} null where it comes to nothing
   */
  within(id, given, time) {
    return this.#inTime(id, given, time).last;
  }

  /**
   * The last step of a figure that is begun within a time, and how long all took, ms.
   *
   * @param {string} id
   * @param {Given} given
   * @param {number} time  Milliseconds.
   */
  #inTime(id, given, time) {
    const begin = performance.now();
    const since = () => performance.now() - begin;
    /** @type {{figure: Figure, done: boolean} | null} */
    let last = null;
    let failed = false;
    try {
      for (const step of this.#gear.progress(id, given)) {
        last = step;
        if (since() > time) break;
      }
    } catch {
      // What cannot be is said by the worker, as for every figure.
      failed = true;
    }
    return { last, failed, took: since() };
  }

  /**
   * What closed formulas say of equal supports; null where they say nothing.
   *
   * @param {Given} given
   */
  formulas(given) {
    try {
      return { modes: this.#gear.modes(given), tongues: this.#gear.tongues(given) };
    } catch (thrown) {
      if (thrown instanceof GearError) return null;
      throw thrown;
    }
  }

  /**
   * A real gear pair to parameters and scales: a few formulas.
   *
   * @param {import("../../gear-bifurcations.js").PhysicalPair} si
   */
  fromPhysical(si) {
    return this.#gear.fromPhysical(si);
  }

  /**
   * Parameters and scales back to a real gear pair.
   *
   * @param {import("../../gear-bifurcations.js").Parameters} p
   * @param {import("../../gear-bifurcations.js").Scales} scales
   */
  toPhysical(p, scales) {
    return this.#gear.toPhysical(p, scales);
  }

  /** Lets computations run to their ends: until this is called they stop at their first picture. */
  complete() {
    this.#pool.complete();
    this.#open();
  }

  /** Gives back the memory of what does not compute: for a page that nobody looks at. */
  rest() {
    giveBack(this.#gear);
    this.#pool.rest();
  }

  /** What tests need to look at and to break. */
  get pool() {
    return this.#pool;
  }
}

/**
 * A figure with its own parameters, asked for before the page can: what is said of it is kept until somebody listens.
 *
 * @typedef {{id: string, ticket: number, takenUp: (answers: import("./pool.js").Answers) => number}} Early
 */

/**
 * @param {Pool} pool
 * @param {string} id
 * @returns {Early}
 */
function askEarly(pool, id) {
  /** @type {((answers: import("./pool.js").Answers) => void)[]} */
  const said = [];
  /** @type {import("./pool.js").Answers | null} */
  let listening = null;
  const say = (/** @type {(answers: import("./pool.js").Answers) => void} */ what) => {
    // `figure/hold-back.js` looks for it.
    performance.mark("first-answer");
    if (listening === null) said.push(what);
    else what(listening);
  };
  const ticket = pool.run(
    { id, given: {}, heavy: false, priority: PRIORITY.shown, part: 0, parts: 1 },
    {
      partial: (figure, drawn) => say((answers) => answers.partial(figure, drawn)),
      done: (figure, drawn) => say((answers) => answers.done(figure, drawn)),
      failed: (error) => say((answers) => answers.failed(error)),
      restarted: () => say((answers) => answers.restarted()),
    },
  );
  const takenUp = (/** @type {import("./pool.js").Answers} */ answers) => {
    const listen = () => {
      listening = answers;
      for (const what of said.splice(0)) what(answers);
    };
    // What has been said already comes as what is said later does: in a task of its own, not while it is asked for.
    if (said.length === 0) listen();
    else setTimeout(listen);
    return ticket;
  };
  return { id, ticket, takenUp };
}

/**
 * Starts everything: fetches and compiles the module once, and brings up the workers meanwhile.
 *
 * @param {object} [options]
 * @param {string | null} [options.first]  A figure that will be asked for first, with its own parameters: computed as soon as can be.
 * @param {boolean} [options.draws]  Whether workers draw first pictures, which takes more time in all and less of the page's own.
 * @param {() => Promise<(import("./protocol.js").Fetched & {worker: Worker}) | null>} [options.fetchModule]  Fetches the module in a worker; null where
 *   that cannot be.
 * @returns {Promise<Engine>} rejected with a `GearError` of code `load`
 */
export async function startEngine({ first = null, draws = false, fetchModule } = {}) {
  const fetched = fetchModule && (await fetchModule());
  const loading = Promise.resolve(fetched?.module ?? wasm()).then((source) => load(source));
  const pool = new Pool(
    loading.then((gear) => gear.module),
    poolSize(navigator.hardwareConcurrency ?? 2),
    draws,
    fetched?.worker ?? null,
  );
  const early = first === null ? null : askEarly(pool, first);
  const engine = new Engine(await loading, pool, { early, draws, ...(fetched && { known: fetched }) });
  document.addEventListener("visibilitychange", () => {
    if (document.hidden) engine.rest();
  });
  return engine;
}
