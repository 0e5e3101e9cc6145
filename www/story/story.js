/**
 * What makes the text of the page more than text: symbols that say their values, words that are explained where they come
 * up, contents that know where the reader is, and links that keep the rest of the state.
 *
 * @typedef {import("./symbols.js").Formulas} Formulas
 * @typedef {import("../engine/gear-bifurcations.js").ParameterInfo} ParameterInfo
 */

import { pointOf } from "../state.js";
import { learn, say } from "../words/say.js";
import { words } from "../words/en/story.js";
import { offerCopies } from "./citation.js";
import { markSections } from "./contents.js";
import { followPlaces } from "./places.js";
import { GearSymbol, describe, symbolOf } from "./symbols.js";
import { explainAll } from "./tip.js";

const EXPLAINED = "gear-symbol, [data-symbol], a.term";

/**
 * What the engine knows without computing anything.
 *
 * @typedef {object} Knowledge
 * @property {ReadonlyMap<string, ParameterInfo>} vocabulary
 * @property {(given: import("../state.js").Given) => Formulas | null} formulas
 */

/**
 * @param {HTMLElement} host
 * @param {import("../state.js").Store} store
 * @param {PromiseLike<Knowledge>} engine
 */
export function startStory(host, store, engine) {
  learn(words);
  if (customElements.get("gear-symbol") === undefined) customElements.define("gear-symbol", GearSymbol);
  /** @type {Knowledge} */
  let known = { vocabulary: new Map(), formulas: () => null };
  engine.then(
    (running) => {
      known = running;
    },
    () => {
      // Without the engine symbols say what they mean, and no values.
    },
  );
  explainAll(host, EXPLAINED, (element) => {
    if (element instanceof HTMLAnchorElement) return term(element);
    const given = pointOf(store.state);
    const { vocabulary } = known;
    return { title: "", words: describe(symbolOf(element), { given, vocabulary, formulas: () => known.formulas(given) }) };
  });
  markSections(host);
  followPlaces(host, store);
  offerCopies(host);
}

/**
 * A word of the glossary, from the glossary itself.
 *
 * @param {HTMLAnchorElement} link
 */
function term(link) {
  const word = document.getElementById(decodeURIComponent(link.getAttribute("href")?.slice(1) ?? ""));
  const meaning = word?.closest("div")?.querySelector("dd");
  if (!word || !meaning) return null;
  return { title: say("term.title", { term: word.textContent ?? "" }), words: meaning.textContent ?? "" };
}
