/**
 * What the browser remembers for its reader between visits. Storage may be forbidden or full: then everything lasts as
 * long as the page.
 *
 * @typedef {object} Preferences
 * @property {import("../state.js").ThemeChoice} theme
 * @property {import("../state.js").Language} language
 * @property {boolean} singleKeys  Whether shortcuts of a single key are on.
 */

import { LANGUAGES, THEMES } from "../state.js";

const KEY = "gear-bifurcations.preferences";

/** @returns {Preferences} */
export function recall() {
  /** @type {any} */
  let stored = null;
  try {
    stored = JSON.parse(localStorage.getItem(KEY) ?? "null");
  } catch {
    // Forbidden, or written by something else.
  }
  return {
    theme: THEMES.find((name) => name === stored?.theme) ?? "auto",
    language: LANGUAGES.find((name) => name === stored?.language) ?? "en",
    singleKeys: stored?.singleKeys !== false,
  };
}

/** @param {Partial<Preferences>} change */
export function remember(change) {
  try {
    localStorage.setItem(KEY, JSON.stringify({ ...recall(), ...change }));
  } catch {
    // It lasts as long as the page, then.
  }
}
