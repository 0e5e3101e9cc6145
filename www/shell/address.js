/**
 * The address follows the state, and the state the address. Each action is an entry of the browser's own history, so
 * that its back and forward buttons undo and redo.
 *
 * The browser's history is led to where the store's is, one step after the other, because it answers later: `written`
 * mirrors what stands in it, `where` is its place there.
 *
 * @typedef {import("../state.js").Store} Store
 * @typedef {import("../url.js").Known} Known
 * @typedef {import("../url.js").Problem} Problem
 */

import { INITIAL } from "../state.js";
import { parse, write } from "../url.js";

/** Browsers refuse to have their address changed many times a second, ms. */
const PAUSE = 250;
/** A step through the browser's history that has not come by now will not come: the oldest entries are dropped. */
const PATIENCE = 1000;

/**
 * @param {Store} store
 * @param {Known} known
 * @param {(problems: readonly Problem[]) => void} tell  What of an address could not be applied; called with none as well.
 */
export function followAddress(store, known, tell) {
  new AddressBar(store, known, tell).begin();
}

class AddressBar {
  #store;
  #known;
  #tell;
  /** Tells entries of this page's life from those of an earlier one. */
  #life = newLife();
  /** Ids of the store's entries, in the browser's order. @type {number[]} */
  #written = [];
  #where = 0;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #travelling;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #waiting;
  #last = -Infinity;
  /** Set while the state follows the address. */
  #following = false;

  /**
   * @param {Store} store
   * @param {Known} known
   * @param {(problems: readonly Problem[]) => void} tell
   */
  constructor(store, known, tell) {
    this.#store = store;
    this.#known = known;
    this.#tell = tell;
  }

  begin() {
    this.#beginAt(location.hash);
    this.#store.subscribe(() => {
      if (!this.#following) this.#soon();
    });
    addEventListener("popstate", (event) => this.#arrive(event.state));
    addEventListener("pagehide", () => this.#lead());
  }

  /**
   * The present entry is the first of a new life.
   *
   * @param {string} hash
   */
  #beginAt(hash) {
    this.#life = newLife();
    const { entries, at } = this.#store.history;
    this.#written = entries.slice(0, at + 1).map(({ id }) => id);
    this.#where = at;
    this.#put("replaceState", hash);
  }

  #soon() {
    this.#waiting ??= setTimeout(() => this.#lead(), Math.max(0, this.#last + PAUSE - performance.now()));
  }

  /** Brings the browser's history a step nearer to the store's, until they agree. */
  #lead() {
    clearTimeout(this.#waiting);
    this.#waiting = undefined;
    if (this.#travelling !== undefined) return;
    this.#last = performance.now();
    const { entries, at, first } = this.#store.history;
    const mismatch = entries.findIndex(({ id }, index) => index >= first && this.#written[index] !== id);
    const common = mismatch < 0 ? entries.length : mismatch;
    if (common > at) {
      if (this.#where === at) this.#put("replaceState", this.#hash());
      else this.#travel(at);
    } else if (this.#where === common - 1) {
      for (const { id, state } of entries.slice(common, at + 1)) {
        this.#where += 1;
        this.#written = [...this.#written.slice(0, this.#where), id];
        this.#put("pushState", hashOf(state));
      }
    } else {
      this.#travel(common - 1);
    }
  }

  /** @param {number} to */
  #travel(to) {
    const steps = to - this.#where;
    this.#travelling = setTimeout(() => {
      // The browser no longer has that entry: the one it shows takes its part.
      this.#travelling = undefined;
      this.#beginAt(this.#hash());
    }, PATIENCE);
    history.go(steps);
  }

  /**
   * The browser shows another of its entries.
   *
   * @param {unknown} state
   */
  #arrive(state) {
    const known = isOurs(state) && state.life === this.#life ? state : null;
    if (this.#travelling !== undefined) {
      clearTimeout(this.#travelling);
      this.#travelling = undefined;
      if (known !== null) {
        this.#where = known.at;
        this.#lead();
      } else {
        this.#beginAt(this.#hash());
      }
      return;
    }
    if (known !== null) {
      this.#where = known.at;
      this.#follow(() => this.#store.goTo(known.at));
    } else if (state === null) {
      this.#followLink();
    } else {
      this.#read((next) => this.#store.restart(next));
      this.#beginAt(location.hash);
    }
  }

  /** A link was followed, or an address written: that is an action, and the browser has an entry for it already. */
  #followLink() {
    this.#where += 1;
    const before = this.#store.history;
    this.#read((next) => this.#store.act("act.link", () => next));
    const { entries, at } = this.#store.history;
    if (this.#store.history === before) {
      // Nothing new was said: back to where it was said before.
      this.#written = [...this.#written.slice(0, this.#where), -1];
      this.#soon();
      return;
    }
    this.#written = [...this.#written.slice(0, this.#where), entries[at].id];
    if (at === this.#where) this.#put("replaceState", location.hash);
    else this.#beginAt(location.hash);
  }

  /** @param {(next: import("../state.js").State) => void} take */
  #read(take) {
    const { state, problems } = parse(location.hash.slice(1), this.#known);
    const { theme, projector, language } = this.#store.state;
    this.#follow(() => take({ ...INITIAL, theme, projector, language, ...state }));
    this.#tell(problems);
  }

  /** @param {() => void} change */
  #follow(change) {
    this.#following = true;
    try {
      change();
    } finally {
      this.#following = false;
    }
  }

  #hash() {
    return hashOf(this.#store.state);
  }

  /**
   * @param {"pushState" | "replaceState"} how
   * @param {string} hash
   */
  #put(how, hash) {
    try {
      history[how]({ life: this.#life, at: this.#where }, "", hash === "" ? location.pathname + location.search : hash);
    } catch {
      // A document without an address of its own, such as one in a sandbox, lives without.
    }
  }
}

/** @param {import("../state.js").State} state */
function hashOf(state) {
  const text = write(state);
  return text === "" ? "" : `#${text}`;
}

/**
 * @param {unknown} state
 * @returns {state is {life: string, at: number}}
 */
function isOurs(state) {
  return typeof state === "object" && state !== null && "life" in state && "at" in state;
}

function newLife() {
  return `${Date.now().toString(36)}${Math.random().toString(36).slice(2, 8)}`;
}
