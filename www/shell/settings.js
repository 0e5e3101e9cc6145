/**
 * The settings: theme, language, projector mode, single keys.
 *
 * @typedef {import("./tools.js").Tools} Tools
 */

import { LANGUAGES, THEMES } from "../state.js";
import { say } from "../words/say.js";
import { openSheet } from "./dialog.js";

/** Languages are named in themselves. */
const NAMES = { en: "English", de: "Deutsch" };

/** @param {Tools} tools */
export function openSettings({ store, singleKeys }) {
  openSheet("settings", (body, close) => {
    const themes = choices("settings.theme", THEMES.map((name) => [name, say(`theme.${name}`)]), store.state.theme, (theme) =>
      store.act("act.theme", (state) => ({ ...state, theme })),
    );
    const languages = choices("settings.language", LANGUAGES.map((name) => [name, NAMES[name]]), store.state.language, (language) => {
      // The sheet speaks the old language still.
      close();
      store.act("act.language", (state) => ({ ...state, language }));
    });
    for (const label of languages.querySelectorAll("label")) label.lang = label.querySelector("input")?.value ?? "";
    const projector = toggle("settings.projector", store.state.projector, (on) =>
      store.act("act.projector", (state) => ({ ...state, projector: on })),
    );
    const keys = toggle("settings.single-keys", singleKeys.get(), (on) => singleKeys.set(on));
    body.append(themes, languages, projector, keys);
  });
}

/**
 * @template {string} T
 * @param {string} title
 * @param {readonly (readonly [T, string])[]} all
 * @param {T} chosen
 * @param {(choice: T) => void} choose
 */
function choices(title, all, chosen, choose) {
  const group = document.createElement("fieldset");
  const legend = document.createElement("legend");
  legend.textContent = say(title);
  group.append(legend);
  for (const [value, words] of all) {
    const { label, input } = labelled("radio", words);
    Object.assign(input, { name: title, value, checked: value === chosen });
    input.addEventListener("change", () => choose(value));
    group.append(label);
  }
  return group;
}

/**
 * @param {string} title
 * @param {boolean} on
 * @param {(on: boolean) => void} change
 */
function toggle(title, on, change) {
  const group = document.createElement("fieldset");
  const { label, input } = labelled("checkbox", say(title));
  input.checked = on;
  input.addEventListener("change", () => change(input.checked));
  group.append(label);
  return group;
}

/**
 * @param {"radio" | "checkbox"} type
 * @param {string} words
 */
function labelled(type, words) {
  const label = document.createElement("label");
  const input = document.createElement("input");
  input.type = type;
  label.append(input, words);
  return { label, input };
}
