/**
 * How figures are to look at present: the theme, and how many pixels of the screen a CSS pixel has.
 *
 * @typedef {import("../engine/gear-bifurcations.js").ThemeName} ThemeName
 * @typedef {import("../state.js").State} State
 */

import { onLetters } from "./letters.js";
import { beginAll } from "./turn.js";

const prefersDark = matchMedia("(prefers-color-scheme: dark)");
const prefersContrast = matchMedia("(prefers-contrast: more)");
const forcesColors = matchMedia("(forced-colors: active)");
const prefersStill = matchMedia("(prefers-reduced-motion: reduce)");

/** @type {Set<() => void>} */
const listeners = new Set();
let printing = false;

/** More pixels than this a CSS pixel nobody tells apart. */
const MOST_DENSITY = 8;

/** Themes that an attribute can name. @type {ReadonlySet<string>} */
const NAMED = new Set(["light", "dark", "projector", "contrast", "contrast-dark", "print"]);

/**
 * The theme of a figure: what its own attribute says, else what the page's state says, else what the system prefers.
 *
 * @param {string | null} own
 * @param {Pick<State, "theme" | "projector">} state
 * @returns {ThemeName}
 */
export function resolveTheme(own, { theme, projector }) {
  if (printing) return "print";
  if (own !== null && NAMED.has(own)) return /** @type {ThemeName} */ (own);
  if (projector) return "projector";
  const contrast = prefersDark.matches ? "contrast-dark" : "contrast";
  if (theme === "contrast") return contrast;
  if (theme === "light" || theme === "dark") return theme;
  if (prefersContrast.matches || forcesColors.matches) return contrast;
  return prefersDark.matches ? "dark" : "light";
}

/**
 * How many pixels a CSS pixel has in a drawing: as many as the screen, on which curves are smooth, for the module draws to a
 * fraction of a pixel. Where the page is enlarged by a part, edges of canvases lie between the screen's pixels: a
 * picture with more than it has is sharper then.
 */
export function density() {
  return Math.min(MOST_DENSITY, Math.ceil(devicePixelRatio));
}

/** Whether the reader has asked for things to stand still. */
export function wantsStill() {
  return prefersStill.matches;
}

/**
 * Called when figures must be drawn anew although nothing about them has changed.
 *
 * @param {() => void} listener
 * @returns {() => void} ends it
 */
export function onAppearance(listener) {
  listeners.add(listener);
  return () => listeners.delete(listener);
}

function tell() {
  for (const listener of listeners) listener();
}

/** The density changes when a window is zoomed or moved to another screen; each query knows only one of them. */
function watchDensity() {
  matchMedia(`(resolution: ${devicePixelRatio}dppx)`).addEventListener(
    "change",
    () => {
      tell();
      watchDensity();
    },
    { once: true },
  );
}

watchDensity();
for (const preference of [prefersDark, prefersContrast, forcesColors]) preference.addEventListener("change", tell);
onLetters(tell);

/**
 * Paper is white: figures are drawn for it.
 *
 * @param {() => void} paintNow  Draws what waits, at once.
 */
export function watchPrinting(paintNow) {
  /** @param {boolean} now */
  const print = (now) => {
    printing = now;
    if (now) beginAll();
    tell();
    paintNow();
  };
  addEventListener("beforeprint", () => print(true));
  addEventListener("afterprint", () => print(false));
}
