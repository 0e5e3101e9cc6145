/**
 * Runs actions by their keys.
 *
 * @typedef {import("./actions.js").Actions} Actions
 * @typedef {import("./actions.js").Action} Action
 */

/**
 * The name of the keys that are pressed, as actions name them: `Ctrl+Shift+Z`, `?`, `g`. Command counts as Ctrl.
 *
 * @param {KeyboardEvent} event
 */
export function keyName({ key, ctrlKey, metaKey, altKey, shiftKey }) {
  const command = ctrlKey || metaKey;
  const letter = key.length === 1 && /[a-z]/i.test(key);
  const parts = [command && "Ctrl", altKey && "Alt", shiftKey && (command || key.length > 1) && "Shift"].filter(Boolean);
  return [...parts, letter && command ? key.toUpperCase() : key].join("+");
}

import { say } from "../words/say.js";

/** Whether a key is one sign alone, which a reader who dictates may press without meaning to. @param {string} key */
export function isSingle(key) {
  return [...key].length === 1;
}

/**
 * Where keys are text.
 *
 * @param {EventTarget | undefined} target
 */
function isText(target) {
  if (!(target instanceof HTMLElement)) return false;
  if (target instanceof HTMLInputElement) return !["range", "checkbox", "radio", "button"].includes(target.type);
  return target.isContentEditable || target instanceof HTMLTextAreaElement;
}

/**
 * @param {Actions} actions
 * @param {() => boolean} singles  Whether single keys are wanted.
 */
export function watchKeys(actions, singles) {
  addEventListener("keydown", (event) => {
    // A sheet that lies over the page has keys of its own.
    if (event.defaultPrevented || event.isComposing || document.querySelector("dialog[open]") !== null) return;
    const name = keyName(event);
    const action = actions.possible.find(({ key }) => key?.split(" ").includes(name));
    if (action === undefined) return;
    // In a box the browser's own undo takes back what was typed; signs are text in it, and choose in a list.
    const target = event.composedPath()[0];
    if (isText(target) && (isSingle(name) || /\+[ZY]$/.test(name))) return;
    if (isSingle(name) && (!singles() || target instanceof HTMLSelectElement)) return;
    event.preventDefault();
    action.run();
  });
}

/** Keys for reading: the first of several, in the reader's language. @param {string} key */
export function keyWords(key) {
  return key
    .split(" ")[0]
    .split("+")
    .map((part) => (part.length > 1 ? say(`key.${part}`) : part))
    .join(" + ");
}
