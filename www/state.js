/**
 * The one state of the page: immutable, replaced as a whole, with those told who subscribed.
 *
 * @typedef {"auto" | "light" | "dark"} ThemeChoice
 * @typedef {Readonly<Record<string, number | string>>} Given  Parameters that differ from the figure's own, by name.
 * @typedef {object} State
 * @property {ThemeChoice} theme
 * @property {Readonly<Record<string, Given>>} figures  By the key of the figure's element.
 */

/** @type {Given} */
const NOTHING = Object.freeze({});

export class Store {
  /** @type {State} */
  #state;
  /** @type {Set<(state: State, before: State) => void>} */
  #subscribers = new Set();

  /** @param {Partial<State>} [initial] */
  constructor(initial = {}) {
    this.#state = Object.freeze({ theme: "auto", figures: Object.freeze({}), ...initial });
  }

  get state() {
    return this.#state;
  }

  /** @param {Partial<State>} change */
  update(change) {
    const before = this.#state;
    this.#state = Object.freeze({ ...before, ...change });
    for (const subscriber of [...this.#subscribers]) subscriber(this.#state, before);
  }

  /**
   * @param {(state: State, before: State) => void} subscriber
   * @returns {() => void} ends the subscription
   */
  subscribe(subscriber) {
    this.#subscribers.add(subscriber);
    return () => this.#subscribers.delete(subscriber);
  }

  /**
   * What was given for a figure.
   *
   * @param {string} key
   */
  given(key) {
    return givenOf(this.#state, key);
  }

  /**
   * @param {string} key
   * @param {Given} given
   */
  give(key, given) {
    this.update({ figures: Object.freeze({ ...this.#state.figures, [key]: Object.freeze({ ...given }) }) });
  }
}

/**
 * @param {State} state
 * @param {string} key
 */
export function givenOf(state, key) {
  return state.figures[key] ?? NOTHING;
}
