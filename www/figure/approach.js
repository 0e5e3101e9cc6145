/**
 * Whether a figure is worth completing: its first picture is made at once, the rest when the reader comes near it and stops
 * there, when somebody asks for its numbers, or when nobody does anything (see shell/leisure.js). Thirty figures that are
 * all completed while a page opens hold two processors for five seconds, in which whoever begins to read and try would
 * feel it.
 */

import { whenStill } from "./scroll.js";

/** So near, in heights of the window above and below it. */
const NEAR = "200% 0px";

/** @type {WeakMap<Element, (near: boolean) => void>} */
const seers = new WeakMap();
/** One for all figures. */
const watch = new IntersectionObserver(
  (entries) => {
    for (const { target, isIntersecting } of entries) seers.get(target)?.(isIntersecting);
  },
  { rootMargin: NEAR },
);

export class Approach {
  /** By its place. */
  #near = false;
  /** The reader has been near it and has stopped there. */
  #reached = false;
  /** How many wait for what is computed. */
  #wanted = 0;
  /** @type {Set<() => void>} */
  #waiting = new Set();
  #stop = () => {
    if (this.#near) this.arrive();
  };

  /**
   * Watches until the signal is aborted.
   *
   * @param {Element} place
   * @param {AbortSignal} signal
   */
  watch(place, signal) {
    seers.set(place, (near) => this.#see(near));
    watch.observe(place);
    signal.addEventListener("abort", () => watch.unobserve(place));
  }

  /**
   * Over when it is worth while; null where it is already. To be called off by whoever needs it no more: a figure that the
   * reader never comes near would keep all that was ever wanted of it.
   *
   * @returns {{over: Promise<void>, callOff: () => void} | null}
   */
  coming() {
    if (this.#reached || this.#wanted > 0) return null;
    let tell = () => {};
    const over = new Promise((/** @type {(value: void) => void} */ resolve) => (tell = resolve));
    this.#waiting.add(tell);
    return { over, callOff: () => this.#waiting.delete(tell) };
  }

  /** Whether anything waits for the reader. */
  get awaited() {
    return this.#waiting.size > 0;
  }

  /** What waits need not wait any longer. */
  hurry() {
    for (const tell of this.#waiting) tell();
    this.#waiting.clear();
  }

  /**
   * Somebody waits for an answer: nothing that is computed until it is there waits for the reader, be it asked for later, as when the
   * parameters change meanwhile.
   *
   * @param {Promise<unknown>} answer
   */
  want(answer) {
    this.#wanted += 1;
    this.hurry();
    const end = () => void (this.#wanted -= 1);
    answer.then(end, end);
  }

  /** It is on the screen: nobody need see it come. */
  arrive() {
    this.#reached = true;
    this.hurry();
  }

  /** @param {boolean} near */
  #see(near) {
    this.#near = near;
    if (near) whenStill(this.#stop);
    else this.#reached = false;
  }
}
