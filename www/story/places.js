/**
 * Going to a place of the story: a section, a figure, a word of the glossary, a line of the errata. The rest of the state
 * stays as it is, which a plain link, being an address of its own, would not let it.
 *
 * @typedef {import("../state.js").Store} Store
 * @typedef {HTMLElement & {data?: () => Promise<unknown>}} Figure
 */

import { wakeAll } from "./rest.js";

/** What readers do who go on by themselves. */
const MOVES = ["wheel", "touchmove", "pointerdown", "keydown"];
/** So long a place is kept where it was brought, ms: all figures are complete by then. */
const LONGEST = 30_000;

/** Aborted when the reader goes on from the last place that was shown, by themselves or to another. */
let keeping = new AbortController();

const prefersStill = matchMedia("(prefers-reduced-motion: reduce)");

/**
 * @param {HTMLElement} host
 * @param {Store} store
 */
export function followPlaces(host, store) {
  host.addEventListener("click", (event) => {
    if (event.defaultPrevented || event.button !== 0 || event.ctrlKey || event.metaKey || event.shiftKey || event.altKey) return;
    const link = event.target instanceof Element ? event.target.closest('a[href^="#"]') : null;
    const id = decodeURIComponent(link?.getAttribute("href")?.slice(1) ?? "");
    if (id === "" || !isWithin(host, id)) return;
    event.preventDefault();
    if (store.state.at === id) goTo(id);
    else store.act("act.jump", (state) => ({ ...state, view: "story", at: id }));
  });
  store.subscribe((state, before) => {
    if (state.at !== null && state.at !== before.at && isWithin(host, state.at)) goTo(state.at);
  });
  const { at } = store.state;
  if (at !== null && isWithin(host, at)) goTo(at, "instant");
}

/**
 * @param {HTMLElement} host
 * @param {string} id
 */
function isWithin(host, id) {
  return host.querySelector(`[id="${CSS.escape(id)}"]`) !== null;
}

/**
 * @param {string} id
 * @param {ScrollBehavior} [behavior]
 */
function goTo(id, behavior = prefersStill.matches ? "instant" : "smooth") {
  const place = document.getElementById(id);
  if (place === null) return;
  if (place.classList.contains("line")) {
    void goToLine(place, behavior);
    return;
  }
  show(place, behavior);
}

/**
 * A line of a table is within its figure, and there only when it has been computed. Who has gone on meanwhile is not
 * called back.
 *
 * @param {HTMLElement} place
 * @param {ScrollBehavior} behavior
 */
async function goToLine(place, behavior) {
  const figure = /** @type {Figure | null} */ (place.closest("figure")?.querySelector("gear-figure") ?? null);
  const line = () => figure?.shadowRoot?.getElementById(place.id) ?? null;
  if (line() === null && figure !== null) {
    show(figure, behavior);
    const { signal } = keeping;
    await untilThere(figure, line);
    if (signal.aborted) return;
  }
  const found = line();
  if (found !== null) show(found, behavior);
}

/**
 * Fulfilled when the line is there, or when the figure is complete without it.
 *
 * @param {Figure} figure
 * @param {() => HTMLElement | null} line
 * @returns {Promise<void>}
 */
function untilThere(figure, line) {
  return new Promise((resolve) => {
    const watch = new MutationObserver(() => {
      if (line() !== null) done();
    });
    const done = () => {
      watch.disconnect();
      resolve();
    };
    if (figure.shadowRoot) watch.observe(figure.shadowRoot, { childList: true, subtree: true });
    void customElements.whenDefined(figure.localName).then(() => figure.data?.()).then(done, done);
  });
}

/**
 * Brings a place into view, and the focus with it, so that the keyboard goes on from there.
 *
 * @param {HTMLElement} place
 * @param {ScrollBehavior} behavior
 */
function show(place, behavior) {
  wakeAll();
  keeping.abort();
  keeping = new AbortController();
  const { signal } = keeping;
  for (const event of MOVES) addEventListener(event, () => keeping.abort(), { signal, passive: true, capture: true });
  const block = place.tagName === "TR" ? "center" : "start";
  place.scrollIntoView({ behavior, block });
  if (behavior === "instant") keep(place, block, signal);
  else addEventListener("scrollend", () => keep(place, block, signal), { once: true, signal });
  if (place.tabIndex < 0) place.tabIndex = -1;
  place.focus({ preventScroll: true });
}

/**
 * Figures above a place are drawn while it is looked at, with legends and sliders below them, and each would push it away.
 *
 * @param {HTMLElement} place
 * @param {ScrollLogicalPosition} block
 * @param {AbortSignal} signal
 */
function keep(place, block, signal) {
  const put = () => {
    if (!signal.aborted && place.getClientRects().length > 0) place.scrollIntoView({ behavior: "instant", block });
  };
  // Whoever scrolls while sizes are told is told of a loop.
  const size = new ResizeObserver(() => requestAnimationFrame(put));
  size.observe(document.body);
  const end = setTimeout(() => size.disconnect(), LONGEST);
  signal.addEventListener("abort", () => {
    clearTimeout(end);
    size.disconnect();
  });
}
