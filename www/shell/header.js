/**
 * The header: the three views, the presets, undo and redo, and the buttons of what is fetched when it is wanted.
 *
 * @typedef {import("../state.js").Store} Store
 * @typedef {import("./actions.js").Actions} Actions
 */

import { PRESETS } from "../presets.js";
import { VIEWS, withPreset } from "../state.js";
import { onLanguage, say } from "../words/say.js";

/** Keys that open the views. */
const VIEW_KEYS = { story: "1", lab: "2", class: "3" };

/**
 * Registers what the header does, and lets it follow the state.
 *
 * @param {HTMLElement} header
 * @param {Store} store
 * @param {Actions} actions
 * @param {(sentence: string) => void} announce
 */
export function furnishHeader(header, store, actions, announce) {
  /** @param {"undo" | "redo"} way */
  const go = (way) => {
    const { entries, at } = store.history;
    const { name } = way === "undo" ? entries[at] : entries[at + 1];
    store[way]();
    announce(say(`${way}.done`, { what: say(name) }));
  };
  actions.register(
    ...VIEWS.map((view) => ({
      id: `view.${view}`,
      word: `view.go.${view}`,
      key: VIEW_KEYS[view],
      possible: () => store.state.view !== view,
      run: () => store.act("act.view", (state) => ({ ...state, view })),
    })),
    { id: "undo", word: "undo", key: "Ctrl+Z", possible: () => store.undoable, run: () => go("undo") },
    { id: "redo", word: "redo", key: "Ctrl+Shift+Z Ctrl+Y", possible: () => store.redoable, run: () => go("redo") },
  );
  header.addEventListener("click", (event) => {
    const target = event.target instanceof Element ? event.target : null;
    const action = target?.closest("button")?.dataset.action;
    const link = target?.closest("a");
    if (action !== undefined) {
      actions.run(action);
    } else if (link && !event.ctrlKey && !event.metaKey && !event.shiftKey) {
      event.preventDefault();
      actions.run(`view.${link.hash.slice(1)}`);
    }
  });
  furnishPresets(header, store);
  const show = () => showState(header, store);
  store.subscribe(show);
  onLanguage(show);
  show();
}

/**
 * @param {HTMLElement} header
 * @param {Store} store
 */
function showState(header, store) {
  for (const link of header.querySelectorAll("nav a")) {
    if (link.getAttribute("href") === `#${store.state.view}`) link.setAttribute("aria-current", "page");
    else link.removeAttribute("aria-current");
  }
  const { entries, at } = store.history;
  for (const [name, entry] of /** @type {const} */ ([["undo", entries[at]], ["redo", entries[at + 1]]])) {
    const button = header.querySelector(`[data-action="${name}"]`);
    if (!(button instanceof HTMLButtonElement)) continue;
    const possible = name === "undo" ? store.undoable : store.redoable;
    // A button that goes dead under the finger would lose the focus: the next one has it then.
    if (!possible && button.matches(":focus")) header.querySelector("a")?.focus();
    button.disabled = !possible;
    button.title = possible ? say(`${name}.what`, { what: say(entry?.name ?? "") }) : say(name);
  }
}

/**
 * @param {HTMLElement} header
 * @param {Store} store
 */
function furnishPresets(header, store) {
  const select = header.querySelector("select");
  if (select === null) return;
  const show = () => {
    if (select.options.length === 0) select.append(...PRESETS.map((id) => new Option("", id)));
    for (const option of select.options) option.textContent = say("preset.figure", { figure: option.value });
    select.value = store.state.preset;
  };
  select.addEventListener("change", () => store.act("act.preset", (state) => withPreset(state, select.value)));
  store.subscribe((state, before) => {
    if (state.preset !== before.preset) select.value = state.preset;
  });
  onLanguage(show);
  show();
}
