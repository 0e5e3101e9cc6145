/**
 * Whether a figure is worth completing: its first picture is made at once, the rest when the reader comes near it and stays a
 * moment, when somebody asks for its numbers, or when the page has been open for so long that nobody is kept waiting by it.
 * Thirty figures that are all completed while a page opens hold two processors for five seconds, in which whoever
 * begins to read and try would feel it.
 */

/** So near, in heights of the window above and below it. */
const NEAR = "200% 0px";
/** Whoever scrolls past is gone again within this, ms. */
const PASSING = 150;

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
  #near = false;
  /** Nothing waits any more. */
  #leisure = false;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #arrival;
  /** @type {(() => void)[]} */
  #waiting = [];

  /**
   * Watches until the signal is aborted.
   *
   * @param {Element} place
   * @param {AbortSignal} signal
   */
  watch(place, signal) {
    seers.set(place, (near) => this.#see(near));
    watch.observe(place);
    signal.addEventListener("abort", () => {
      watch.unobserve(place);
      clearTimeout(this.#arrival);
    });
  }

  /** Over when it is worth while; null where it is already. @returns {Promise<void> | null} */
  get coming() {
    return this.#near || this.#leisure ? null : new Promise((resolve) => this.#waiting.push(resolve));
  }

  /** Whether anything waits for the reader. */
  get awaited() {
    return this.#waiting.length > 0;
  }

  /** What waits need not wait any longer. */
  hurry() {
    for (const resolve of this.#waiting.splice(0)) resolve();
  }

  /** From now on everything is worth while. */
  atLeisure() {
    this.#leisure = true;
    this.hurry();
  }

  /** It is on the screen: nobody need see it come. */
  arrive() {
    this.#near = true;
    this.hurry();
  }

  /** @param {boolean} near */
  #see(near) {
    clearTimeout(this.#arrival);
    if (near && !this.#near) this.#arrival = setTimeout(() => this.arrive(), PASSING);
    else if (!near) this.#near = false;
  }
}
