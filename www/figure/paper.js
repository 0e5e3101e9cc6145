/**
 * What a figure needs on paper, where nobody can look at its controls or wait for it.
 *
 * @typedef {import("./services.js").Given} Given
 * @typedef {import("./services.js").FigureInfo} FigureInfo
 */

import { plain } from "./markup.js";
import { number, say } from "../words/say.js";

/** So long a figure may hold up the printing, ms. */
export const PATIENCE = 1500;

/**
 * What is said under a figure: parameters that are not the figure's own, and whether what is drawn is not all of it.
 *
 * @param {Given} given
 * @param {FigureInfo | null} info
 * @param {"still" | "part" | "whole"} drawn
 */
export function paperWords(given, info, drawn) {
  if (drawn === "still") return say("paper.still");
  const changed = (info?.parameters ?? []).filter(({ name, default: own }) => name in given && given[name] !== own);
  const said = changed.map((parameter) => {
    const value = given[parameter.name];
    const symbol = "symbol" in parameter ? plain(parameter.symbol) : parameter.name;
    return `${symbol} = ${typeof value === "number" ? number(value) : value}`;
  });
  const at = said.length === 0 ? "" : say("paper.at", { values: said.join(", ") });
  return drawn === "whole" ? at : `${at} ${say("paper.part")}`;
}
