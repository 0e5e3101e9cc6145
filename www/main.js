/** The page: the only place that knows all its parts. */

import { engine, GearError, PRIORITY } from "./engine/running.js";
import { watchPrinting } from "./figure/appearance.js";
import { currentFigure, watchFigures } from "./figure/current.js";
import { GearFigure } from "./figure/gear-figure.js";
import { fetchLetters } from "./figure/letters.js";
import { inNextTask } from "./figure/next-task.js";
import { paintAll, painted } from "./figure/paint-queue.js";
import { provide } from "./figure/services.js";
import { PRESETS } from "./presets.js";
import { Actions } from "./shell/actions.js";
import { followAddress } from "./shell/address.js";
import { furnishHeader } from "./shell/header.js";
import { watchKeys } from "./shell/keys.js";
import { atLeisure } from "./shell/leisure.js";
import { problemWords, showNotice } from "./shell/notice.js";
import { recall, remember } from "./shell/preferences.js";
import { announcer } from "./shell/services.js";
import { typeAhead } from "./shell/type-ahead.js";
import { LANGUAGES, SHARED, Store, THEMES, withPreset } from "./state.js";
import { ANCHORS, bringNear, holdSections, layOutAll, letFarSectionsRest } from "./story/rest.js";
import { startStory } from "./story/story.js";
import { parse } from "./url.js";
import { words as figureWords } from "./words/en/figure.js";
import { words as shellWords } from "./words/en/shell.js";
import { spoken, translateEngine } from "./words/engine.js";
import { translate } from "./words/page.js";
import { learn, number, say, speak } from "./words/say.js";

/** After this time nothing waits for figures any more, ms. */
const LONGEST_OPENING = 4000;

fetchLetters();
learn(shellWords);
learn(figureWords);

// What needs no numbers is shown at once; the rest of the address is read when the engine has said what there is.
const { state: opening } = parse(location.hash.slice(1), null);
const preferences = recall();
const { view = "story", at = null, projector = false } = opening;
const { theme, language } = { ...preferences, ...opening };
const store = new Store({ view, at, theme, projector, language });
const actions = new Actions();
/** @type {(() => void) | null} */
let hideHands = null;
showAppearance();

/** What the figures are given once the engine runs. */
const services = engine.then((running) => {
  readAddress(running);
  return {
    engine: running,
    store,
    priority: PRIORITY,
    error: (/** @type {import("./figure/services.js").GearErrorFields} */ fields) => new GearError(fields),
    leisure: atLeisure,
    later: whenCalm,
    painted: countDrawing,
    exports: (/** @type {GearFigure} */ figure, /** @type {HTMLElement} */ button) =>
      void exporting().then((room) => room.open(figure, button), () => figure.tell(say("figure.no-export"), true)),
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
services.then(() => (all === 0 ? complete() : setTimeout(complete, OPENING)), settle);
// A story that is not shown at first is laid out piece by piece when it is.
if (view !== "story" && ANCHORS) holdSections();

/** To be called when all of the story is about to look otherwise: it is styled and laid out piece by piece then. @type {(() => void) | null} */
let restStory = null;

/** Lays out what `figure/hold-back.js` has kept back and no figure has brought yet. */
async function settle() {
  await bringNear();
  restStory ??= letFarSectionsRest(element('main > [data-view="story"]'));
}

function complete() {
  void settle();
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

/** What can be named in an address. @param {import("./engine/client.js").Engine} running */
function knownTo({ vocabulary }) {
  return { vocabulary, isPlace: (/** @type {string} */ id) => document.querySelector(`main [id="${CSS.escape(id)}"]`) !== null };
}

/** @param {import("./engine/client.js").Engine} running */
function readAddress(running) {
  const known = knownTo(running);
  const { state, problems } = parse(location.hash.slice(1), known);
  // What the reader has done meanwhile counts for more than what the page was opened with.
  const { view, at, theme, projector, language } = store.state;
  const early = store.undoable;
  if (early) store.restart({ ...store.state, ...state, view, at, theme, projector, language });
  else store.update({ ...state, at: state.at ?? null });
  const tell = (/** @type {readonly import("./url.js").Problem[]} */ of) => notice(problemWords(of));
  if (problems.length > 0) tell(problems);
  followAddress(store, known, tell);
  // Then the address is to say so.
  if (early) store.update({});
}

/** Says something at the top of the page. @param {string} words */
function notice(words) {
  showNotice(element(".link-notice"), words);
}

/** @type {Promise<import("./exports/room.js").Room> | null} */
let exportRoom = null;

/** Takes figures away and opens what was saved: fetched when it is first wanted. */
function exporting() {
  exportRoom ??= Promise.all([import("./exports/room.js"), engine, services]).then(([{ startExports }, running]) => {
    const room = startExports({
      engine: running,
      home: location.href.split(/[?#]/)[0].replace(/[^/]*$/, ""),
      saving,
      page: {
        store,
        known: () => knownTo(running),
        tell: (sentence, problems) => notice([sentence, problemWords(problems)].filter(Boolean).join(" ")),
      },
    });
    actions.register(...room.actions(currentFigure));
    return room;
  });
  // It may come at the next try.
  exportRoom.catch(() => (exportRoom = null));
  return exportRoom;
}

/** @param {Iterable<File>} files */
function openFiles(files) {
  exporting().then((room) => room.receive(files), () => notice(say("view.failed")));
}

/** Whether something is dragged that is a file, and for the page: what takes files itself is left to do so. @param {DragEvent} event */
function bringsFile(event) {
  const [target] = event.composedPath();
  return event.dataTransfer?.types.includes("Files") === true && !(target instanceof HTMLInputElement);
}
addEventListener("dragover", (event) => {
  if (bringsFile(event)) event.preventDefault();
});
addEventListener("drop", (event) => {
  if (!bringsFile(event)) return;
  event.preventDefault();
  openFiles([...(event.dataTransfer?.files ?? [])]);
});

/** The rooms that are fetched when they are first entered. */
const ROOMS = {
  lab: () => import("./lab/lab.js"),
  class: () => import("./classroom/classroom.js"),
};
/** @type {Set<string>} */
const entered = new Set();

/** How far each view was read when it was left. @type {Map<string, number>} */
const places = new Map();

/** Shows the view of the state, and furnishes it where it is entered for the first time. */
function showView() {
  const { view: shown } = store.state;
  document.documentElement.dataset.view = shown;
  for (const part of document.querySelectorAll("main > [data-view]")) {
    if (part instanceof HTMLElement) part.hidden = part.dataset.view !== shown;
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
furnishHeader(element("header"), store, actions, announce);
registerActions();
watchKeys(actions, () => preferences.singleKeys);
showView();

// What is held, a slider or a handle, makes one action of all it does until it is let go.
addEventListener("pointerdown", () => store.hold(), { capture: true });
for (const end of ["pointerup", "pointercancel"]) addEventListener(end, () => store.release(), { capture: true });

for (const [key, names] of Object.entries(SHARED)) store.share(key, names);

// A link to a place of the story keeps what was changed, which following it would not.
document.addEventListener("click", (event) => {
  const link = event.target instanceof Element ? event.target.closest('a[href^="#"]') : null;
  const place = link === null ? null : document.getElementById(link.getAttribute("href")?.slice(1) ?? "");
  if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.shiftKey || place === null) return;
  event.preventDefault();
  goTo(place.id);
});

/** @param {string} id  Of a place in the story. */
function goTo(id) {
  store.act("act.jump", (state) => ({ ...state, view: "story", at: id }));
  const place = document.getElementById(id);
  if (place === null) return;
  place.scrollIntoView();
  // Whoever goes on by keys goes on from there.
  if (place.tabIndex < 0) place.tabIndex = -1;
  place.focus({ preventScroll: true });
}

/** What can be done from everywhere. What each room can do it registers itself. */
function registerActions() {
  const singleKeys = {
    get: () => preferences.singleKeys,
    set: (/** @type {boolean} */ on) => {
      preferences.singleKeys = on;
      remember({ singleKeys: on });
    },
  };
  const opening = async (/** @type {"palette" | "settings" | "help"} */ name) => {
    const over = name === "palette" ? typeAhead() : null;
    try {
      // What can be taken away is among the actions that the palette lists.
      const [{ open }] = await Promise.all([import("./shell/tools.js"), name === "palette" ? exporting().catch(() => null) : null]);
      open(name, { store, actions, singleKeys }, over?.());
    } finally {
      over?.();
    }
  };
  const tools = /** @type {const} */ ([["palette", "Ctrl+K"], ["settings", "s"], ["help", "?"]]);
  actions.register(
    ...tools.map(([name, key]) => ({
      id: name,
      word: name,
      key,
      run: () => void opening(name),
    })),
    { id: "open", word: "open", key: "Ctrl+O", run: () => void exporting().then((room) => room.choose(), () => notice(say("view.failed"))) },
    { id: "theme", word: "theme.next", key: "t", run: () => store.act("act.theme", (state) => ({ ...state, theme: THEMES[(THEMES.indexOf(state.theme) + 1) % THEMES.length] })) },
    { id: "projector", word: "projector.toggle", key: "p", run: () => store.act("act.projector", (state) => ({ ...state, projector: !state.projector })) },
    ...LANGUAGES.map((name) => ({
      id: `language.${name}`,
      word: `language.${name}`,
      possible: () => store.state.language !== name,
      run: () => store.act("act.language", (state) => ({ ...state, language: name })),
    })),
    ...PRESETS.map((id) => ({
      id: `preset.${id}`,
      word: "preset.use",
      values: { figure: id },
      possible: () => store.state.view !== "story",
      run: () => store.act("act.preset", (state) => withPreset(state, id)),
    })),
    ...PRESETS.map((id) => ({ id: `figure.${id}`, word: "figure.go", values: { figure: id }, run: () => goTo(`fig-${id}`) })),
  );
}

function showAppearance() {
  const { dataset } = document.documentElement;
  dataset.theme = store.state.theme;
  dataset.projector = String(store.state.projector);
  if (store.state.projector) void import("./shell/projector.js").then(({ showHands }) => {
    if (store.state.projector) hideHands ??= showHands();
  });
  else {
    hideHands?.();
    hideHands = null;
  }
}

/** @param {import("./state.js").Language} chosen */
async function chooseLanguage(chosen) {
  const { german: words, engine: patterns } = chosen === "de" ? await import("./words/de/index.js") : { german: null, engine: null };
  if (store.state.language !== chosen) return;
  translateEngine(patterns);
  void engine.then((running) => {
    running.words = patterns === null ? null : spoken;
  });
  document.documentElement.lang = chosen;
  // Charts are called by the headings over them.
  translate(document, words);
  speak(chosen, words);
  delete document.documentElement.dataset.wordless;
  // What was said in the other language is over.
  announce("");
  restStory?.();
}

store.subscribe((state, before) => {
  if (state.view !== before.view) {
    places.set(before.view, scrollY);
    showView();
    scrollTo(0, places.get(state.view) ?? 0);
  }
  if (state.theme !== before.theme || state.projector !== before.projector) {
    restStory?.();
    showAppearance();
  }
  if (state.theme !== before.theme) remember({ theme: state.theme });
  if (state.language !== before.language) {
    remember({ language: state.language });
    void chooseLanguage(state.language);
  }
});
if (language !== "en") void chooseLanguage(language);

/**
 * @param {string} selector
 * @returns {HTMLElement}
 */
function element(selector) {
  const found = document.querySelector(selector);
  if (found instanceof HTMLElement) return found;
  throw new Error(`the document has no ${selector}`);
}

startStory(element('main > [data-view="story"]'), store, engine);
addEventListener("beforeprint", layOutAll);
watchPrinting(paintAll);
watchFigures();
provide(services);
const define = () => customElements.define("gear-figure", GearFigure);
// Thirty of them at once are made in a task of their own, for nothing is asked of them before the engine runs. Whoever comes to a place
// of the story must find the heights above it.
if (document.documentElement.dataset.opening === "first") inNextTask(define);
else define();

whenCalm(() => {
  import("./offline/register.js").then(({ keepForOffline }) => keepForOffline()).catch(() => {});
});

/** Makes files of figures: fetched when one is to be saved. */
const saving = () => import("./embed/save-figure.js");

// With `?test` in the address, tests may break what only bad luck breaks.
if (new URLSearchParams(location.search).has("test")) {
  services.then(({ engine: running }) => Object.assign(window, { __gear: { engine: running, store, actions, painted, saving } }));
}
