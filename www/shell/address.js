/**
 * The address follows the state, and the state the address.
 *
 * @typedef {import("../state.js").Store} Store
 * @typedef {import("../state.js").State} State
 * @typedef {import("../url.js").Known} Known
 * @typedef {import("../url.js").Problem} Problem
 */

import { INITIAL } from "../state.js";
import { parse, write } from "../url.js";

/** Browsers refuse to have their address changed many times a second, ms. */
const PAUSE = 300;

/**
 * @param {Store} store
 * @param {Known} known
 * @param {(problems: readonly Problem[]) => void} tell  What of an address could not be applied; called with none as well.
 */
export function followAddress(store, known, tell) {
  let written = location.hash;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let waiting;
  const put = () => {
    waiting = undefined;
    const text = write(store.state);
    const hash = text === "" ? "" : `#${text}`;
    if (hash === location.hash) return;
    try {
      history.replaceState(null, "", hash === "" ? location.pathname + location.search : hash);
      written = hash;
    } catch {
      // A document without an address of its own, such as one in a sandbox, lives without.
    }
  };
  store.subscribe(() => {
    waiting ??= setTimeout(put, PAUSE);
  });
  addEventListener("hashchange", () => {
    if (location.hash === written) return;
    written = location.hash;
    const { state, problems } = parse(location.hash.slice(1), known);
    const { theme, projector, language } = store.state;
    store.act("act.link", () => ({ ...INITIAL, theme, projector, language, ...state }));
    tell(problems);
  });
}
