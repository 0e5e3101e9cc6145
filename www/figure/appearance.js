/**
 * How figures are to look at present: light or dark, and how many pixels of the screen a CSS pixel has.
 *
 * @typedef {"light" | "dark"} Theme
 * @typedef {import("../state.js").ThemeChoice} ThemeChoice
 */

const prefersDark = matchMedia("(prefers-color-scheme: dark)");
const prefersStill = matchMedia("(prefers-reduced-motion: reduce)");

/** @type {Set<() => void>} */
const listeners = new Set();
let printing = false;

/** Curves stay smooth at two pixels a CSS pixel even where the screen has one. */
const LEAST_DENSITY = 2;
/** More pixels than this a CSS pixel nobody tells apart. */
const MOST_DENSITY = 8;

/**
 * @param {ThemeChoice | string | null} choice
 * @returns {Theme}
 */
export function resolveTheme(choice) {
  if (printing) return "light";
  if (choice === "light" || choice === "dark") return choice;
  return prefersDark.matches ? "dark" : "light";
}

export function density() {
  return Math.min(MOST_DENSITY, Math.max(LEAST_DENSITY, devicePixelRatio));
}

/** The screen's own density: enough for what is not seen yet, and drawn in half the time. */
export function coarseDensity() {
  return Math.min(MOST_DENSITY, Math.max(1, devicePixelRatio));
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
prefersDark.addEventListener("change", tell);
// Text that was drawn before its typeface had come.
document.fonts.addEventListener("loadingdone", tell);

/**
 * Paper is white: figures are drawn light for it.
 *
 * @param {() => void} paintNow  Draws what waits, at once.
 */
export function watchPrinting(paintNow) {
  /** @param {boolean} now */
  const print = (now) => {
    printing = now;
    tell();
    paintNow();
  };
  addEventListener("beforeprint", () => print(true));
  addEventListener("afterprint", () => print(false));
}
