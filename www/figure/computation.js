/**
 * The way of one figure's wishes: the newest wins, what it overtakes is abandoned or dropped.
 *
 * @typedef {import("./services.js").Figure} Figure
 * @typedef {import("./services.js").Given} Given
 */

/**
 * @typedef {object} Hooks
 * @property {(given: Given, run: {signal: AbortSignal, partial: (figure: Figure) => void}) => Promise<Figure>} compute
 * @property {(given: Given) => {figure: Figure, done: boolean} | null} now  What can be had at once.
 * @property {(figure: Figure, complete: boolean) => void} show
 * @property {(error: Error) => void} fail
 * @property {boolean} heavy  Worth being abandoned halfway; what is quick is awaited instead, so that a picture
 *   comes in every frame however fast the slider moves.
 */

export class Computation {
  #hooks;
  /** @type {AbortController | null} */
  #running = null;
  /** Whether what is running has shown something. */
  #pictured = false;
  /** @type {Given | null} */
  #waiting = null;
  /** @type {Deferred<Figure>} */
  #answer = new Deferred();

  /** @param {Hooks} hooks */
  constructor(hooks) {
    this.#hooks = hooks;
  }

  /** The figure of the newest wish, once it is complete. */
  get answer() {
    return this.#answer.promise;
  }

  get busy() {
    return this.#running !== null;
  }

  /** @param {Given} given */
  wish(given) {
    if (this.#answer.settled) this.#answer = new Deferred();
    const now = this.#hooks.now(given);
    if (now !== null) {
      this.stop();
      this.#hooks.show(now.figure, now.done);
      if (now.done) this.#answer.resolve(now.figure);
      else void this.#run(given, true);
      return;
    }
    // What is abandoned before its first picture, value after value, would never show one while a slider moves.
    if (this.#running !== null && !(this.#hooks.heavy && this.#pictured)) {
      this.#waiting = given;
      return;
    }
    this.#running?.abort();
    void this.#run(given);
  }

  /** Ends what is running without an answer. */
  stop() {
    this.#waiting = null;
    this.#running?.abort();
    this.#running = null;
  }

  /**
   * There will be no figure.
   *
   * @param {Error} error
   */
  refuse(error) {
    this.stop();
    if (this.#answer.settled) this.#answer = new Deferred();
    this.#answer.reject(error);
  }

  /**
   * @param {Given} given
   * @param {boolean} [pictured]  There is a picture already, and the first that comes will be no finer.
   */
  async #run(given, pictured = false) {
    const run = new AbortController();
    this.#running = run;
    this.#pictured = pictured;
    let stale = pictured;
    const isNewest = () => this.#running === run;
    try {
      const figure = await this.#hooks.compute(given, {
        signal: run.signal,
        partial: (partial) => {
          if (!isNewest()) return;
          if (stale) {
            stale = false;
            return;
          }
          this.#pictured = true;
          this.#hooks.show(partial, false);
          if (this.#waiting !== null) {
            run.abort();
            this.#running = null;
            this.#goOn();
          }
        },
      });
      if (!isNewest()) return;
      this.#running = null;
      const overtaken = this.#goOn();
      this.#hooks.show(figure, !overtaken);
      if (!overtaken) this.#answer.resolve(figure);
    } catch (thrown) {
      if (!isNewest()) return;
      this.#running = null;
      if (this.#goOn()) return;
      const error = thrown instanceof Error ? thrown : new Error(String(thrown));
      this.#answer.reject(error);
      this.#hooks.fail(error);
    }
  }

  /** Starts what waits; whether anything did. */
  #goOn() {
    const given = this.#waiting;
    if (given === null) return false;
    this.#waiting = null;
    void this.#run(given);
    return true;
  }
}

/** @template T */
class Deferred {
  settled = false;
  /** @type {(value: T) => void} */
  resolve = () => {};
  /** @type {(error: Error) => void} */
  reject = () => {};
  /** @type {Promise<T>} */
  promise = new Promise((resolve, reject) => {
    this.resolve = (value) => {
      this.settled = true;
      resolve(value);
    };
    this.reject = (error) => {
      this.settled = true;
      reject(error);
    };
  });

  constructor() {
    // Nobody need ask for the answer; the figure itself says what went wrong.
    this.promise.catch(() => {});
  }
}
