/**
 * Words that stand in the document itself. `index.html` is the English catalogue of its own keys: `data-word="key"` marks
 * an element whose content is a sentence, `data-word-alt="key"` (`title`, `content`, `aria-label`, ...) one whose attribute is.
 *
 * In a translation `<0>words</0>` stands for the element's first child with other words in it, and `<1/>` for its second
 * one as it is, so that links, symbols and formulas are those of the document.
 *
 * @typedef {import("./say.js").Words} Words
 */

/** Attributes that hold words. */
export const ATTRIBUTES = Object.freeze(["alt", "title", "content", "aria-label"]);

/** What stood in the document at first. @type {WeakMap<Element, Node[]>} */
const contents = new WeakMap();
/** @type {WeakMap<Element, Map<string, string>>} */
const attributes = new WeakMap();

/**
 * Puts a language into the document, or English back.
 *
 * @param {ParentNode} root
 * @param {Words | null} words
 */
export function translate(root, words) {
  for (const element of root.querySelectorAll("[data-word]")) {
    const before = contents.get(element) ?? [...element.childNodes].map((node) => node.cloneNode(true));
    contents.set(element, before);
    const sentence = words?.[/** @type {HTMLElement} */ (element).dataset.word ?? ""];
    if (sentence === undefined) element.replaceChildren(...before.map((node) => node.cloneNode(true)));
    else element.replaceChildren(compose(sentence, before.filter((node) => node instanceof Element)));
  }
  for (const name of ATTRIBUTES) {
    for (const element of root.querySelectorAll(`[data-word-${name}]`)) {
      const known = attributes.get(element) ?? new Map();
      attributes.set(element, known);
      if (!known.has(name)) known.set(name, element.getAttribute(name) ?? "");
      element.setAttribute(name, words?.[element.getAttribute(`data-word-${name}`) ?? ""] ?? known.get(name));
    }
  }
}

const TAG = /<(\d+)\/>|<(\d+)>((?:(?!<\2>)[\s\S])*?)<\/\2>/g;

/**
 * @param {string} sentence
 * @param {readonly Element[]} children  What its tags stand for.
 * @returns {DocumentFragment}
 */
function compose(sentence, children) {
  const fragment = document.createDocumentFragment();
  let from = 0;
  for (const match of sentence.matchAll(TAG)) {
    fragment.append(sentence.slice(from, match.index));
    const [all, whole, opened, inner] = match;
    const child = children[Number(whole ?? opened)]?.cloneNode(true);
    if (child instanceof Element) {
      if (inner !== undefined) child.replaceChildren(compose(inner, [...child.children]));
      fragment.append(child);
    }
    from = match.index + all.length;
  }
  fragment.append(sentence.slice(from));
  return fragment;
}
