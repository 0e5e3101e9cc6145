/**
 * Everything that can be done by name or key. Rooms register what they offer; the palette lists it, the help shows the
 * keys, and one listener runs it.
 *
 * @typedef {object} Action
 * @property {string} id  Unique, such as `lab.play`.
 * @property {string} word  The key of its name in the catalogue.
 * @property {Readonly<Record<string, string | number>>} [values]  What its name speaks of.
 * @property {string} [key]  Such as `Ctrl+Z`, `?` or `g`; letters alone are single-key shortcuts and can be switched off.
 * @property {() => void} run
 * @property {() => boolean} [possible]  Whether it can be done at present; always, when absent.
 */

export class Actions {
  /** @type {Map<string, Action>} */
  #actions = new Map();
  /** @type {Set<() => void>} */
  #listeners = new Set();

  /**
   * @param {...Action} actions
   * @returns {() => void} takes them back
   */
  register(...actions) {
    for (const action of actions) this.#actions.set(action.id, action);
    this.#tell();
    return () => {
      for (const action of actions) {
        if (this.#actions.get(action.id) === action) this.#actions.delete(action.id);
      }
      this.#tell();
    };
  }

  /** In the order in which they were registered. */
  get all() {
    return [...this.#actions.values()];
  }

  /** Those that can be done now. */
  get possible() {
    return this.all.filter((action) => action.possible?.() ?? true);
  }

  /** @param {string} id */
  run(id) {
    const action = this.#actions.get(id);
    if (action !== undefined && (action.possible?.() ?? true)) action.run();
  }

  /**
   * Called when there are other actions than before.
   *
   * @param {() => void} listener
   * @returns {() => void} ends it
   */
  watch(listener) {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }

  #tell() {
    for (const listener of [...this.#listeners]) listener();
  }
}
