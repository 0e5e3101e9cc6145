/** The page: the only place that knows all its parts. */

import { themeNamed, wireThemeButton } from "./controls/theme-button.js";
import { engine, GearError, PRIORITY } from "./engine/running.js";
import { watchPrinting } from "./figure/appearance.js";
import { GearFigure } from "./figure/gear-figure.js";
import { paintAll } from "./figure/paint-queue.js";
import { provide } from "./figure/services.js";
import { Store } from "./state.js";

const THEME_KEY = "gear-bifurcations.theme";
/** After this time nothing waits for figures any more, ms. */
const LONGEST_OPENING = 4000;

const store = new Store({ theme: themeNamed(recall()) });
showTheme();

/** What the figures are given once the engine runs. */
const services = engine.then((running) => ({
  engine: running,
  store,
  priority: PRIORITY,
  error: (/** @type {import("./figure/services.js").GearErrorFields} */ fields) => new GearError(fields),
  later: whenCalm,
  painted: countDrawing,
}));
services.catch(() => {});

/** The paper's own figures: what the page opens with. Those with letters come after. */
const PAPER = /^\d/;
const all = [...document.querySelectorAll("gear-figure")].filter(isOfThePaper).length;
let drawn = 0;
/** @type {(() => void)[]} */
let waiting = [];

/** A figure that never comes must not hold up the others for longer than this, ms. */
const OPENING = 2000;
services.then(() => setTimeout(complete, OPENING), () => {});

function complete() {
  void engine.then((running) => running.complete());
}

/** @param {Element} figure */
function isOfThePaper(figure) {
  return PAPER.test(figure.getAttribute("figure") ?? "");
}

/**
 * Marks what readers wait for: the first live figure, and the last.
 *
 * @param {Element} figure
 */
function countDrawing(figure) {
  if (!isOfThePaper(figure)) return;
  drawn += 1;
  if (drawn === 1) performance.mark("first-figure");
  if (drawn === all) {
    performance.mark("all-figures");
    complete();
    calmDown();
  }
}

function calmDown() {
  const calm = waiting;
  waiting = [];
  for (const work of calm) idle(work);
}
// A figure that cannot be drawn must not keep the others from their controls.
setTimeout(calmDown, LONGEST_OPENING);

/**
 * Controls come when the drawings stand: they are not what a reader looks at first.
 *
 * @param {() => void} work
 */
function whenCalm(work) {
  if (drawn < all && performance.now() < LONGEST_OPENING) waiting.push(work);
  else idle(work);
}

/** @param {() => void} work */
function idle(work) {
  if ("requestIdleCallback" in window) requestIdleCallback(work, { timeout: 300 });
  else setTimeout(work);
}

function showTheme() {
  document.documentElement.dataset.theme = store.state.theme;
}

/** The theme that was chosen at the last visit. Storage may be forbidden: then it is as the system has it. */
function recall() {
  try {
    return localStorage.getItem(THEME_KEY);
  } catch {
    return null;
  }
}

/** @param {string} theme */
function remember(theme) {
  try {
    if (theme === "auto") localStorage.removeItem(THEME_KEY);
    else localStorage.setItem(THEME_KEY, theme);
  } catch {
    // It lasts as long as the page, then.
  }
}

const themeButton = document.querySelector("button.theme");
if (themeButton instanceof HTMLButtonElement) {
  wireThemeButton(themeButton, store.state.theme, (theme) => {
    store.update({ theme });
    remember(theme);
    showTheme();
  });
}

watchPrinting(paintAll);
provide(services);
customElements.define("gear-figure", GearFigure);

// With `?test` in the address, tests may break what only bad luck breaks.
if (new URLSearchParams(location.search).has("test")) {
  services.then(({ engine: running }) => Object.assign(window, { __gear: { engine: running, store } }));
}
