/** The page: the only place that knows all its parts. */

import { themeNamed, wireThemeButton } from "./controls/theme-button.js";
import { engine, GearError, PRIORITY } from "./engine/running.js";
import { watchPrinting } from "./figure/appearance.js";
import { GearFigure } from "./figure/gear-figure.js";
import { paintAll } from "./figure/paint-queue.js";
import { provide } from "./figure/services.js";
import { PRESETS } from "./presets.js";
import { Actions } from "./shell/actions.js";
import { followAddress } from "./shell/address.js";
import { problemWords, showNotice } from "./shell/notice.js";
import { announcer } from "./shell/services.js";
import { Store } from "./state.js";
import { parse } from "./url.js";
import { words as figureWords } from "./words/en/figure.js";
import { words as shellWords } from "./words/en/shell.js";
import { translate } from "./words/page.js";
import { learn, number, onLanguage, say, speak } from "./words/say.js";

const THEME_KEY = "gear-bifurcations.theme";
/** After this time nothing waits for figures any more, ms. */
const LONGEST_OPENING = 4000;

learn(shellWords);
learn(figureWords);

// What needs no numbers is shown at once; the rest of the address is read when the engine has said what there is.
const { state: opening } = parse(location.hash.slice(1), null);
const { view = "story", at = null, theme = themeNamed(recall()), projector = false, language = "en" } = opening;
const store = new Store({ view, at, theme, projector, language });
const actions = new Actions();
showAppearance();

/** What the figures are given once the engine runs. */
const services = engine.then((running) => {
  readAddress(running);
  return {
    engine: running,
    store,
    priority: PRIORITY,
    error: (/** @type {import("./figure/services.js").GearErrorFields} */ fields) => new GearError(fields),
    later: whenCalm,
    painted: countDrawing,
  };
});
services.catch(() => {});

/** The paper's own figures: what the page opens with. Those with letters come after. */
const PAPER = /^\d/;
/** In another view nobody waits for them. */
const all = view === "story" ? [...document.querySelectorAll("gear-figure")].filter(isOfThePaper).length : 0;
let drawn = 0;
/** @type {(() => void)[]} */
let waiting = [];

/** A figure that never comes must not hold up the others for longer than this, ms. */
const OPENING = 2000;
services.then(() => (all === 0 ? complete() : setTimeout(complete, OPENING)), () => {});

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

/** @param {import("./engine/client.js").Engine} running */
function readAddress({ vocabulary }) {
  const known = { vocabulary, isPlace: (/** @type {string} */ id) => document.querySelector(`main [id="${CSS.escape(id)}"]`) !== null };
  const place = element(".link-notice");
  const { state, problems } = parse(location.hash.slice(1), known);
  store.update({ ...state, at: state.at ?? null });
  const tell = (/** @type {readonly import("./url.js").Problem[]} */ of) => showNotice(place, problemWords(of));
  if (problems.length > 0) tell(problems);
  followAddress(store, known, tell);
}

/** The rooms that are fetched when they are first entered. */
const ROOMS = {
  lab: () => import("./lab/lab.js"),
  class: () => import("./classroom/classroom.js"),
};
/** @type {Set<string>} */
const entered = new Set();

/** Shows the view of the state, and furnishes it where it is entered for the first time. */
function showView() {
  const { view: shown } = store.state;
  document.documentElement.dataset.view = shown;
  for (const part of document.querySelectorAll("main > [data-view]")) {
    if (part instanceof HTMLElement) part.hidden = part.dataset.view !== shown;
  }
  for (const link of document.querySelectorAll(".views a")) {
    if (link.getAttribute("href") === `#${shown}`) link.setAttribute("aria-current", "page");
    else link.removeAttribute("aria-current");
  }
  if (shown !== "story" && !entered.has(shown)) void enter(shown);
}

/** @param {"lab" | "class"} name */
async function enter(name) {
  entered.add(name);
  const host = element(`main > [data-view="${name}"]`);
  host.textContent = say("view.loading");
  try {
    const [room, running] = await Promise.all([ROOMS[name](), engine]);
    await services;
    host.replaceChildren();
    room.start(host, { store, act: store.act.bind(store), engine: running, say, number, presets: PRESETS, announce, later: whenCalm, actions });
  } catch (thrown) {
    entered.delete(name);
    host.textContent = say("view.failed");
    throw thrown;
  }
}

const announce = announcer(element(".announcer"));
for (const link of document.querySelectorAll(".views a")) {
  link.addEventListener("click", (event) => {
    if (event instanceof MouseEvent && (event.ctrlKey || event.metaKey || event.shiftKey)) return;
    event.preventDefault();
    const chosen = /** @type {import("./state.js").View} */ (link.getAttribute("href")?.slice(1));
    store.act("act.view", (state) => ({ ...state, view: chosen, at: null }));
    scrollTo(0, 0);
  });
}
showView();

function showAppearance() {
  const { dataset } = document.documentElement;
  dataset.theme = store.state.theme;
  dataset.projector = String(store.state.projector);
}

/** @param {import("./state.js").Language} chosen */
async function chooseLanguage(chosen) {
  const words = chosen === "de" ? (await import("./words/de/index.js")).german : null;
  if (store.state.language !== chosen) return;
  speak(chosen, words);
  document.documentElement.lang = chosen;
  translate(document, words);
}

store.subscribe((state, before) => {
  if (state.view !== before.view) showView();
  if (state.theme !== before.theme || state.projector !== before.projector) showAppearance();
  if (state.theme !== before.theme) remember(state.theme);
  if (state.language !== before.language) void chooseLanguage(state.language);
});
if (language !== "en") void chooseLanguage(language);

/** The theme that was chosen at the last visit. Storage may be forbidden: then it is as the system has it. */
function recall() {
  try {
    return localStorage.getItem(THEME_KEY);
  } catch {
    return null;
  }
}

/** @param {string} chosen */
function remember(chosen) {
  try {
    if (chosen === "auto") localStorage.removeItem(THEME_KEY);
    else localStorage.setItem(THEME_KEY, chosen);
  } catch {
    // It lasts as long as the page, then.
  }
}

/**
 * @param {string} selector
 * @returns {HTMLElement}
 */
function element(selector) {
  const found = document.querySelector(selector);
  if (found instanceof HTMLElement) return found;
  throw new Error(`the document has no ${selector}`);
}

const themeButton = document.querySelector("button.theme");
if (themeButton instanceof HTMLButtonElement) {
  const show = wireThemeButton(themeButton, () => store.state.theme, (chosen) => store.act("act.theme", (state) => ({ ...state, theme: chosen })));
  store.subscribe(show);
  onLanguage(show);
}

watchPrinting(paintAll);
provide(services);
customElements.define("gear-figure", GearFigure);

// With `?test` in the address, tests may break what only bad luck breaks.
if (new URLSearchParams(location.search).has("test")) {
  services.then(({ engine: running }) => Object.assign(window, { __gear: { engine: running, store, actions } }));
}
