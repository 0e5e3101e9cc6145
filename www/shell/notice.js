/**
 * A sentence at the top of the page that can be put away: what an address said that could not be applied.
 *
 * @typedef {import("../url.js").Problem} Problem
 */

import { say } from "../words/say.js";

/** More than so many are only counted. */
const SHOWN = 5;

/**
 * @param {readonly Problem[]} problems
 * @returns {string} empty for none
 */
export function problemWords(problems) {
  if (problems.length === 0) return "";
  const sentences = problems.slice(0, SHOWN).map(({ kind, name, given, allowed }) => {
    const key = kind !== "newer" && kind !== "unknown" && kind !== "repeated" && allowed === "" ? "form" : kind;
    return say(`link.${key}`, { name, given: given === "" ? say("link.nothing") : given, allowed });
  });
  if (problems.length > SHOWN) sentences.push(say("link.more", { count: problems.length - SHOWN }));
  return [say("link.some"), ...sentences].join(" ");
}

/**
 * @param {HTMLElement} place  Hidden while there is nothing to say; a paragraph and a button are in it.
 * @param {string} words
 */
export function showNotice(place, words) {
  const [sentence, button] = [place.querySelector("p"), place.querySelector("button")];
  if (sentence === null || button === null) return;
  place.hidden = words === "";
  sentence.textContent = words;
  button.onclick = () => {
    place.hidden = true;
  };
}
