/**
 * The palette: every action by its name, found by writing a part of it.
 *
 * @typedef {import("./actions.js").Actions} Actions
 * @typedef {import("./actions.js").Action} Action
 */

import { say } from "../words/say.js";
import { openSheet } from "./dialog.js";
import { keyWords } from "./keys.js";

/**
 * Those whose names hold every word, in their order; first those that begin with what was written.
 *
 * @param {readonly {name: string, action: Action}[]} all
 * @param {string} written
 */
export function found(all, written) {
  const plain = (/** @type {string} */ text) => text.normalize("NFD").replace(/\p{M}/gu, "").toLowerCase();
  const words = plain(written).split(/\s+/).filter(Boolean);
  const fitting = all.filter(({ name }) => words.every((word) => plain(name).includes(word)));
  const begins = (/** @type {{name: string}} */ { name }) => plain(name).startsWith(plain(written.trim()));
  return [...fitting.filter(begins), ...fitting.filter((one) => !begins(one))];
}

/**
 * @param {Actions} actions
 * @param {import("./type-ahead.js").Typed} [typed]  What was typed for it before it was there.
 */
export function openPalette(actions, typed) {
  if (typed?.left) return;
  const sheet = openSheet("palette", (body, close) => {
    const all = actions.possible
      .filter(({ id }) => id !== "palette")
      .map((action) => ({ name: say(action.word, action.values), action }));
    /** @type {{name: string, action: Action}[]} */
    let shown = [];
    let at = 0;

    const box = document.createElement("input");
    Object.assign(box, { type: "text", autocomplete: "off", spellcheck: false, autofocus: true });
    for (const [name, value] of Object.entries({
      role: "combobox",
      "aria-label": say("palette.search"),
      "aria-expanded": "true",
      "aria-controls": "palette-list",
      "aria-autocomplete": "list",
    })) {
      box.setAttribute(name, value);
    }
    const list = document.createElement("ul");
    list.id = "palette-list";
    list.setAttribute("role", "listbox");
    list.setAttribute("aria-label", say("palette"));
    const none = document.createElement("p");
    none.className = "none";
    none.setAttribute("role", "status");
    body.append(box, list, none);

    const run = () => {
      const chosen = shown[at];
      if (chosen === undefined) return;
      close();
      chosen.action.run();
    };
    /** @param {number} to */
    const select = (to) => {
      at = Math.min(shown.length - 1, Math.max(0, to));
      [...list.children].forEach((option, index) => option.setAttribute("aria-selected", String(index === at)));
      const option = list.children[at];
      box.setAttribute("aria-activedescendant", option?.id ?? "");
      option?.scrollIntoView({ block: "nearest" });
    };
    const filter = () => {
      shown = found(all, box.value);
      list.replaceChildren(...shown.map(({ name, action }, index) => optionOf(name, action, index)));
      none.textContent = shown.length === 0 ? say("palette.none") : "";
      select(0);
    };
    box.addEventListener("input", filter);
    box.addEventListener("keydown", (event) => {
      const steps = { ArrowDown: 1, ArrowUp: -1, PageDown: 8, PageUp: -8 }[event.key];
      if (steps !== undefined) select(at + steps);
      else if (event.key === "Enter") run();
      else return;
      event.preventDefault();
    });
    list.addEventListener("click", (event) => {
      const option = event.target instanceof Element ? event.target.closest("li") : null;
      if (option === null) return;
      at = [...list.children].indexOf(option);
      run();
    });
    box.value = typed?.written ?? "";
    filter();
  });
  const input = sheet.querySelector("input");
  // What is written on goes behind what is there; where the focus puts the mark is every engine's own affair.
  input?.setSelectionRange(input.value.length, input.value.length);
  if (typed?.entered) input?.dispatchEvent(new KeyboardEvent("keydown", { key: "Enter", bubbles: true }));
}

/**
 * @param {string} name
 * @param {Action} action
 * @param {number} index
 */
function optionOf(name, action, index) {
  const option = document.createElement("li");
  option.id = `palette-${index}`;
  option.setAttribute("role", "option");
  const words = document.createElement("span");
  words.textContent = name;
  option.append(words);
  if (action.key !== undefined) {
    const key = document.createElement("kbd");
    key.textContent = keyWords(action.key);
    option.append(key);
  }
  return option;
}
