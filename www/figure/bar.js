/**
 * The buttons under a figure.
 *
 * @typedef {import("./services.js").FigureInfo} FigureInfo
 * @typedef {import("./motion.js").Clock} Clock
 * @typedef {import("./turning.js").Turning} Turning
 */

import { button } from "./shadow.js";

const ARROWS = /** @type {const} */ ([
  ["←", "Turn left", "ArrowLeft"],
  ["→", "Turn right", "ArrowRight"],
  ["↑", "Look from higher up", "ArrowUp"],
  ["↓", "Look from lower down", "ArrowDown"],
]);

/**
 * @param {{clock: Clock | null, turning: Turning | null, reset: () => void}} wiring
 * @returns {{buttons: HTMLButtonElement[], showPlaying: () => void}}
 */
export function createButtons({ clock, turning, reset }) {
  /** @type {HTMLButtonElement[]} */
  const buttons = [];
  let showPlaying = () => {};
  if (clock !== null) {
    const play = button("Pause", "Pause", () => {
      if (clock.playing) clock.pause();
      else clock.play();
      showPlaying();
    });
    showPlaying = () => {
      play.textContent = clock.playing ? "Pause" : "Play";
      play.removeAttribute("aria-label");
    };
    play.classList.add("play");
    buttons.push(play);
  }
  if (turning !== null) {
    for (const [sign, words, key] of ARROWS) {
      const arrow = button(sign, words, () => turning.press(key));
      arrow.classList.add("arrow");
      buttons.push(arrow);
    }
  }
  const back = button("Reset", "Reset", reset);
  back.classList.add("reset");
  buttons.push(back);
  return { buttons, showPlaying };
}
