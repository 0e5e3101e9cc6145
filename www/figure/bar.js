/**
 * The buttons under a figure.
 *
 * @typedef {import("./services.js").FigureInfo} FigureInfo
 * @typedef {import("./motion.js").Clock} Clock
 * @typedef {import("./turning.js").Turning} Turning
 */

import { say } from "../words/say.js";
import { button } from "./shadow.js";

const ARROWS = /** @type {const} */ ([
  ["←", "figure.turn-left", "ArrowLeft"],
  ["→", "figure.turn-right", "ArrowRight"],
  ["↑", "figure.higher", "ArrowUp"],
  ["↓", "figure.lower", "ArrowDown"],
]);

/**
 * The button that shows the whole again; it is there only while a part is seen.
 *
 * @param {() => void} press
 */
export function wholeButton(press) {
  const made = button(say("figure.whole"), say("figure.whole"), press);
  made.classList.add("whole");
  made.hidden = true;
  return made;
}

/**
 * @param {{clock: Clock | null, turning: Turning | null, reset: () => void, stop: () => void, take: ((button: HTMLElement) => void) | null}} wiring
 * @returns {{buttons: HTMLButtonElement[], showPlaying: () => void, showBusy: (busy: boolean) => void}}
 */
export function createButtons({ clock, turning, reset, stop, take }) {
  /** @type {HTMLButtonElement[]} */
  const buttons = [];
  let showPlaying = () => {};
  const end = button(say("figure.stop"), say("figure.stop"), stop);
  end.classList.add("stop");
  end.hidden = true;
  buttons.push(end);
  const showBusy = (/** @type {boolean} */ busy) => {
    end.hidden = !busy;
  };
  if (clock !== null) {
    const play = button(say("figure.pause"), say("figure.pause"), () => {
      if (clock.playing) clock.pause();
      else clock.play();
      showPlaying();
    });
    showPlaying = () => {
      play.textContent = say(clock.playing ? "figure.pause" : "figure.play");
      play.removeAttribute("aria-label");
    };
    play.classList.add("play");
    buttons.push(play);
  }
  if (turning !== null) {
    for (const [sign, word, key] of ARROWS) {
      const arrow = button(sign, say(word), () => turning.press(key));
      arrow.classList.add("arrow");
      buttons.push(arrow);
    }
  }
  const back = button(say("figure.reset"), say("figure.reset"), reset);
  back.classList.add("reset");
  buttons.push(back);
  if (take !== null) {
    const menu = button(say("figure.export"), say("figure.export"), () => take(menu));
    menu.classList.add("take");
    menu.setAttribute("aria-haspopup", "menu");
    menu.setAttribute("aria-expanded", "false");
    buttons.push(menu);
  }
  return { buttons, showPlaying, showBusy };
}
