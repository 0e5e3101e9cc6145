/** The classroom. */

import { onLanguage } from "../words/say.js";

/**
 * @param {HTMLElement} host
 * @param {import("../shell/services.js").RoomServices} services
 */
export function start(host, { say }) {
  const sentence = document.createElement("p");
  const show = () => {
    sentence.textContent = say("class.soon");
  };
  show();
  onLanguage(show);
  host.append(sentence);
}
