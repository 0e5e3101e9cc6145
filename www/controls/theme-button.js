/**
 * The button that goes round light, dark and as the system has it.
 *
 * @typedef {import("../state.js").ThemeChoice} ThemeChoice
 */

/** @type {readonly ThemeChoice[]} */
const ROUND = ["auto", "light", "dark"];
const WORDS = { auto: "auto", light: "light", dark: "dark" };

/**
 * @param {HTMLButtonElement} button
 * @param {ThemeChoice} start
 * @param {(choice: ThemeChoice) => void} change
 */
export function wireThemeButton(button, start, change) {
  let choice = start;
  const show = () => {
    button.textContent = `Theme: ${WORDS[choice]}`;
  };
  button.addEventListener("click", () => {
    choice = ROUND[(ROUND.indexOf(choice) + 1) % ROUND.length];
    show();
    change(choice);
  });
  show();
  button.hidden = false;
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
