/**
 * What a room of the page (laboratory, classroom) is given when it is opened: `start(host, services)`.
 *
 * @typedef {object} RoomServices
 * @property {import("../state.js").Store} store  The state, `subscribe`, `undo`, `hold` and `release` around a drag.
 * @property {import("../state.js").Store["act"]} act  `act("act.parameter", (state) => withPoint(state, {k0: 0.4}), {merge: "k0"})`.
 * @property {import("../engine/client.js").Engine} engine
 * @property {typeof import("../words/say.js").say} say
 * @property {typeof import("../words/say.js").number} number
 * @property {readonly string[]} presets  Ids of the figures that can be started from.
 * @property {(sentence: string) => void} announce  Says it politely to whoever listens instead of looking.
 * @property {(work: () => void) => void} later  Does what can wait until figures are drawn.
 * @property {import("./actions.js").Actions} actions
 */

/**
 * A room's module.
 *
 * @typedef {object} Room
 * @property {(host: HTMLElement, services: RoomServices) => void} start  Called once, when the room is first opened.
 */

/**
 * Says sentences in a place that is heard and not seen.
 *
 * @param {HTMLElement} place  With `aria-live`.
 * @returns {(sentence: string) => void}
 */
export function announcer(place) {
  return (sentence) => {
    // The same sentence again would not be heard.
    place.textContent = place.textContent === sentence ? `${sentence}\u00a0` : sentence;
  };
}
