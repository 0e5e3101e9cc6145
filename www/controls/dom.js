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

/**
 * An element that says a sentence of the catalogue.
 *
 * @template {HTMLElement} Element
 * @param {Element} made
 * @param {string} key
 * @returns {Element}
 */
export function spoken(made, key) {
  const show = () => {
    made.textContent = say(key);
  };
  show();
  onLanguage(show);
  return made;
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
  const show = () => made.replaceChildren(marked(say(key)));
  show();
  onLanguage(show);
  return made;
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
  const show = () => made.setAttribute(attribute, say(key));
  show();
  onLanguage(show);
  return made;
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
