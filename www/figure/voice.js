/** What a figure says to the ear: the name of its chart, the sentence that says what it shows, its keys, and what a change has led to. */

import { spoken } from "../words/engine.js";
import { say } from "../words/say.js";
import { plain } from "./markup.js";

/**
 * @typedef {import("./services.js").Figure} Figure
 * @typedef {import("./services.js").FigureInfo} FigureInfo
 */

export class Voice {
  #element;
  #parts;

  /**
   * @param {HTMLElement} element  The figure.
   * @param {{canvas: HTMLCanvasElement, described: HTMLElement, keys: HTMLElement, heard: HTMLElement}} parts
   */
  constructor(element, { canvas, described, keys, heard }) {
    this.#element = element;
    this.#parts = { canvas, described, keys, heard };
  }

  /** The heading that stands over the figure. */
  get #title() {
    return this.#element.closest("figure")?.querySelector("h2, h3, h4, h5")?.textContent?.trim() ?? null;
  }

  /** Before anything is known of the figure, its static drawing speaks for it. @param {string} words */
  standIn(words) {
    this.#parts.canvas.setAttribute("aria-label", this.#title ?? words);
    this.#parts.described.textContent = words;
  }

  /**
   * What the chart is called and how it is handled, in the language of the page.
   *
   * @param {FigureInfo | null} info
   * @param {Figure | null} figure
   */
  introduce(info, figure) {
    const { canvas, keys } = this.#parts;
    canvas.setAttribute("aria-roledescription", say("figure.chart"));
    canvas.setAttribute("aria-label", this.#title ?? plain(figure?.title ?? spoken(info?.title ?? "")));
    keys.textContent = say(info?.turnable ? "figure.keys.turn" : "figure.keys");
  }

  /** What it shows, for whoever comes to it. @param {Figure} figure */
  describe(figure) {
    this.#parts.described.textContent = plain(figure.summary);
  }

  /** Says something now, politely. @param {string} words */
  speak(words) {
    this.#parts.heard.textContent = words;
  }
}
