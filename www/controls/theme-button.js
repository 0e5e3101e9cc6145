/**
 * The button that goes round the themes and back to as the system has it.
 *
 * @typedef {import("../state.js").ThemeChoice} ThemeChoice
 */

import { say } from "../words/say.js";

/** @type {readonly ThemeChoice[]} */
const ROUND = ["auto", "light", "dark"];

/**
 * @param {HTMLButtonElement} button
 * @param {() => ThemeChoice} current
 * @param {(choice: ThemeChoice) => void} change
 * @returns {() => void} shows the theme that is current
 */
export function wireThemeButton(button, current, change) {
  const show = () => {
    button.textContent = say("theme.button", { theme: say(`theme.${current()}`) });
  };
  button.addEventListener("click", () => change(ROUND[(ROUND.indexOf(current()) + 1) % ROUND.length]));
  show();
  button.hidden = false;
  return show;
}

/**
 * The word as a theme, `auto` where it is none.
 *
 * @param {string | null} word
 * @returns {ThemeChoice}
 */
export function themeNamed(word) {
  return ROUND.find((choice) => choice === word) ?? "auto";
}
