/**
 * The help: what the page can do by keys and by pointer.
 *
 * @typedef {import("./tools.js").Tools} Tools
 */

import { say } from "../words/say.js";
import { openSheet } from "./dialog.js";
import { isSingle, keyWords } from "./keys.js";

/** What is done to figures is no action of the page: it belongs to the figure that has the focus, or is under the pointer. */
const MANNERS = ["slider", "box", "handle", "turn", "play", "zoom", "pan", "reset"];

/** @param {Tools} tools */
export function openHelp({ actions, singleKeys }) {
  openSheet("help", (body) => {
    const keys = document.createElement("dl");
    for (const { key, word, values } of actions.all) {
      if (key !== undefined) keys.append(...line(keyWords(key), say(word, values)));
    }
    const single = document.createElement("p");
    const some = actions.all.some(({ key }) => key?.split(" ").some(isSingle));
    single.textContent = some ? say(singleKeys.get() ? "help.single-on" : "help.single-off") : "";
    const manners = document.createElement("dl");
    manners.append(...MANNERS.flatMap((name) => line(say(`help.${name}.key`), say(`help.${name}`))));
    body.append(heading("help.keys"), keys, single, heading("help.figures"), manners);
  });
}

/** @param {string} word */
function heading(word) {
  const made = document.createElement("h3");
  made.textContent = say(word);
  return made;
}

/**
 * @param {string} term
 * @param {string} meaning
 */
function line(term, meaning) {
  const [key, words] = [document.createElement("dt"), document.createElement("dd")];
  const pressed = document.createElement("kbd");
  pressed.textContent = term;
  key.append(pressed);
  words.textContent = meaning;
  return [key, words];
}
