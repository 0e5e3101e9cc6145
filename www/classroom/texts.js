/**
 * Words of lessons: those that ship come from the catalogue, those of a teacher from the lesson itself.
 *
 * @typedef {import("./lesson.js").Text} Text
 * @typedef {import("../words/say.js").Values} Values
 */

import { elements } from "../figure/markup.js";
import { language, number, say } from "../words/say.js";

/**
 * @param {Text} text
 * @param {Values} [values]
 */
export function wordsOf(text, values = {}) {
  if (typeof text === "object" && "word" in text && Object.keys(text).length === 1) return say(text.word, values);
  /** @type {Readonly<Record<string, string>> | string} */
  const own = text;
  const words = typeof own === "string" ? own : (own[language()] ?? own.en ?? Object.values(own)[0] ?? "");
  return words.replace(/\{(\w+)\}/g, (hole, name) => {
    const value = values[name];
    return value === undefined ? hole : typeof value === "number" ? number(value) : value;
  });
}

/**
 * The same with symbols set as in formulas: `*u*_{p}`.
 *
 * @param {Text} text
 * @param {Values} [values]
 */
export function setOf(text, values = {}) {
  return elements(wordsOf(text, values));
}
