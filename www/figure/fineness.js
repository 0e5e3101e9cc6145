/**
 * How finely a figure is drawn: finely while it is seen and stands still, at the screen's own density otherwise. A browser
 * without a graphics processor copies all canvases that are not far whenever it paints another stretch of the page, and
 * fine ones take four times as long and as much memory.
 */

import { coarseDensity, density } from "./appearance.js";
import { isScrolling, whenStill } from "./scroll.js";

/** What has been out of sight for so long has been left, ms. */
const LEFT = 200;

/**
 * @typedef {object} Home
 * @property {() => boolean} inSight
 * @property {() => boolean} drawn  Whether there is anything to be drawn.
 * @property {() => Promise<void>} prepare  Makes its fine picture ready to be shown, as far as that can be done aside.
 * @property {() => void} repaint
 */

export class Fineness {
  #home;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #leaving;
  /** Whether what is drawn has yet to be drawn as finely as it should be: what was never drawn is worth no fine picture while it passes by. */
  coarse = true;
  /** Draws finely what was drawn coarsely while it was not seen, or not for long. */
  #refine = async () => {
    if (!this.coarse || !this.#home.inSight() || !this.#home.drawn()) return;
    await this.#home.prepare();
    this.#home.repaint();
  };
  #coarsen = () => {
    if (!this.coarse && !this.#home.inSight() && coarseDensity() < density()) this.#home.repaint();
  };

  /** @param {Home} home */
  constructor(home) {
    this.#home = home;
  }

  /**
   * How many pixels a CSS pixel has in the drawing that is made now.
   *
   * @param {boolean} anyhow  It is to be fine wherever it is.
   */
  next(anyhow) {
    const inSight = this.#home.inSight();
    const fine = anyhow || (inSight && (!this.coarse || !isScrolling()));
    const pixels = fine ? density() : coarseDensity();
    this.coarse = pixels < density();
    if (this.coarse && inSight) whenStill(this.#refine);
    return pixels;
  }

  /** @param {boolean} inSight */
  see(inSight) {
    clearTimeout(this.#leaving);
    if (inSight && this.coarse) whenStill(this.#refine);
    if (!inSight && !this.coarse) this.#leaving = setTimeout(() => whenStill(this.#coarsen), LEFT);
  }

  end() {
    clearTimeout(this.#leaving);
  }
}
