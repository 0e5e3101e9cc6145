/** The line under a figure: what is the matter with it, what it is doing, and what is to be known of it. */

import { sentence } from "./markup.js";

export class Status {
  #place;
  /** Sentences about attributes that were left out: they stay as long as the attributes do. */
  leftOut = "";

  /** @param {HTMLElement} place */
  constructor(place) {
    this.#place = place;
  }

  /**
   * @param {string} text
   * @param {boolean} [wrong]
   */
  say(text, wrong = false) {
    this.#place.replaceChildren(sentence(text));
    if (this.leftOut !== "") this.#place.prepend(`${this.leftOut} `);
    this.#place.classList.toggle("wrong", wrong || this.leftOut !== "");
  }

  /**
   * Says something as it stands, for a name of a file is no formula, until the reader goes on.
   *
   * @param {string} words
   * @param {boolean} wrong
   * @param {() => string} afterwards  What is said then.
   */
  sayForNow(words, wrong, afterwards) {
    this.say("", wrong);
    this.#place.append(words);
    this.#place.classList.add("told");
    const life = new AbortController();
    const over = () => {
      life.abort();
      this.#place.classList.remove("told");
      this.say(afterwards());
    };
    for (const act of ["pointerdown", "keydown"]) addEventListener(act, over, { capture: true, signal: life.signal });
  }
}
