/** Elements, and words that stay right when another language is spoken. */

import { sentence as marked } from "../figure/markup.js";
import { onLanguage, say } from "../words/say.js";

/**
 * @template {keyof HTMLElementTagNameMap} Name
 * @param {Name} name
 * @param {string} className
 * @param {...(Node | string)} children
 * @returns {HTMLElementTagNameMap[Name]}
 */
export function element(name, className, ...children) {
  const made = document.createElement(name);
  if (className !== "") made.className = className;
  made.append(...children);
  return made;
}

/** Ends the listening of elements that are gone. @type {FinalizationRegistry<() => void>} */
const gone = new FinalizationRegistry((end) => end());

/**
 * Shows an element's words, and again in every other language, as long as there is such an element: lists and lessons are
 * built anew all the time, and what they were before must not be kept by the words on it.
 *
 * @template {HTMLElement} Element
 * @param {Element} made
 * @param {(made: Element) => void} show  Must not hold the element itself.
 * @returns {Element}
 */
function showing(made, show) {
  show(made);
  const held = new WeakRef(made);
  const end = onLanguage(() => {
    const still = held.deref();
    if (still !== undefined) show(still);
  });
  gone.register(made, end);
  return made;
}

/**
 * An element that says a sentence of the catalogue.
 *
 * @template {HTMLElement} Element
 * @param {Element} made
 * @param {string} key
 * @returns {Element}
 */
export function spoken(made, key) {
  return showing(made, (still) => {
    still.textContent = say(key);
  });
}

/**
 * The same with its quantities set as in formulas.
 *
 * @template {HTMLElement} Element
 * @param {Element} made
 * @param {string} key
 * @returns {Element}
 */
export function set(made, key) {
  return showing(made, (still) => still.replaceChildren(marked(say(key))));
}

/**
 * An element whose attribute is a sentence of the catalogue.
 *
 * @template {HTMLElement} Element
 * @param {Element} made
 * @param {"aria-label" | "title"} attribute
 * @param {string} key
 * @returns {Element}
 */
export function named(made, attribute, key) {
  return showing(made, (still) => still.setAttribute(attribute, say(key)));
}

/**
 * @param {string} key  Of its words.
 * @param {() => void} press
 */
export function button(key, press) {
  const made = spoken(element("button", ""), key);
  made.type = "button";
  made.addEventListener("click", press);
  return made;
}

/**
 * A choice among words of the catalogue.
 *
 * @param {string} label  Key of what is chosen.
 * @param {readonly (readonly [value: string, key: string])[]} choices
 * @param {(value: string) => void} choose
 */
export function choice(label, choices, choose) {
  const select = named(document.createElement("select"), "aria-label", label);
  for (const [value, key] of choices) {
    const option = spoken(document.createElement("option"), key);
    option.value = value;
    select.append(option);
  }
  select.addEventListener("change", () => choose(select.value));
  return select;
}
