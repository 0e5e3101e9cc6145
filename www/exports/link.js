/**
 * Addresses that show a figure as it is, and lines that bring it into another page.
 *
 * @typedef {import("../state.js").State} State
 * @typedef {import("../state.js").FigureState} FigureState
 * @typedef {import("../state.js").Given} Given
 */

import { presetGiven } from "../presets.js";
import { INITIAL, SHARED, withFigure, withPoint } from "../state.js";
import { write } from "../url.js";

/** What stands for the address of a site where there is none. */
const SOMEWHERE = "https://host.example/gear/";
/** The script that brings the element, in the site's folder. */
const ELEMENT = "gear-figure.js";

/**
 * The page's state with a figure of the story gone to; in the other views as it is.
 *
 * @param {State} state
 * @param {string} key  Of the figure's element.
 * @returns {State}
 */
export function stateAt(state, key) {
  return key.startsWith("fig-") ? { ...state, view: "story", at: key } : state;
}

/**
 * The state of a page that shows one figure of another document in the story.
 *
 * @param {string} id
 * @param {Given} given
 * @param {Readonly<FigureState>} shown
 * @returns {State}
 */
export function stateOf(id, given, shown) {
  const key = `fig-${id}`;
  const shared = SHARED[key] ?? [];
  const [point, own] = [true, false].map((ours) => Object.fromEntries(Object.entries(given).filter(([name]) => shared.includes(name) === ours)));
  return withPoint(withFigure({ ...INITIAL, at: key }, key, { ...shown, given: own }), point);
}

/**
 * @param {string} page
 * @param {State} state
 */
export function link(page, state) {
  return `${page}#${write(state)}`;
}

/**
 * @param {string | null} home  The folder of the site; null where there is none that others could reach.
 * @param {string} id
 * @param {Given} given
 * @returns {string}
 */
export function embedCode(home, id, given) {
  const own = presetGiven(id);
  const attributes = Object.entries(given)
    .filter(([name, value]) => own[name] !== value)
    .map(([name, value]) => ` ${name.toLowerCase()}="${escaped(String(value))}"`);
  const reachable = home !== null && /^https?:/.test(home);
  const where = reachable ? "" : `${COMMENT[0]} ${SOMEWHERE} stands for the address of your copy of the site. ${COMMENT[1]}\n`;
  return `${where}<script type="module" src="${escaped(new URL(ELEMENT, reachable ? home : SOMEWHERE).href)}"></${"script"}>
<gear-figure figure="${escaped(id)}"${attributes.join("")}></gear-figure>
`;
}

/** Parted, for they may not stand in the single file's scripts. */
const COMMENT = ["<!" + "--", "--" + ">"];

/** @param {string} text */
function escaped(text) {
  return text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll('"', "&quot;");
}
