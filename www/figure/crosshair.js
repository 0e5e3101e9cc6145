/**
 * Lines over a chart that are no part of its picture: the crosshair where something is read, and the cursors that other
 * charts have set. They are elements, so that moving them draws nothing anew.
 *
 * @typedef {import("./services.js").FrameMap} FrameMap
 * @typedef {import("./frames.js").Pixel} Pixel
 * @typedef {import("./cursor.js").Cursor} Cursor
 * @typedef {import("../engine/gear-bifurcations.js").FigureFrame} FigureFrame
 */

/** Of the ring about a point that is read, CSS pixels. */
const RADIUS = 5;

export class Crosshair {
  #layer;
  #upright = line("upright");
  #level = line("level");
  #dot = line("dot");
  /** @type {HTMLElement[]} */
  #linked = [];

  /** @param {HTMLElement} layer */
  constructor(layer) {
    this.#layer = layer;
    layer.append(this.#upright, this.#level, this.#dot);
    this.hide();
  }

  /**
   * @param {FrameMap} map
   * @param {Pixel} at
   * @param {boolean} onPoint  Whether a point is read and not just a place.
   */
  show({ plot }, { left, top }, onPoint) {
    setBox(this.#upright, left, plot.top, 0, plot.bottom - plot.top);
    setBox(this.#level, plot.left, top, plot.right - plot.left, 0);
    setBox(this.#dot, left - RADIUS, top - RADIUS, 2 * RADIUS, 2 * RADIUS);
    this.#dot.hidden = !onPoint;
  }

  hide() {
    for (const part of [this.#upright, this.#level, this.#dot]) part.hidden = true;
  }

  /**
   * Shows what another chart's cursor says.
   *
   * @param {Cursor} cursor
   * @param {readonly FrameMap[]} maps
   * @param {(map: FrameMap) => FigureFrame | undefined} frameOf
   */
  link({ quantity, value }, maps, frameOf) {
    let used = 0;
    for (const map of value === null ? [] : maps) {
      const frame = frameOf(map);
      if (value === null || frame === undefined || frame.bare || map.projection !== null) continue;
      for (const axis of /** @type {const} */ (["x", "y"])) {
        if (frame[axis].name !== quantity || value < map[axis].low || value > map[axis].high) continue;
        const part = (value - map[axis].low) / (map[axis].high - map[axis].low);
        const { plot } = map;
        const made = (this.#linked[used] ??= this.#layer.appendChild(line("linked")));
        used += 1;
        if (axis === "x") setBox(made, plot.left + part * (plot.right - plot.left), plot.top, 0, plot.bottom - plot.top);
        else setBox(made, plot.left, plot.bottom - part * (plot.bottom - plot.top), plot.right - plot.left, 0);
      }
    }
    for (const spare of this.#linked.slice(used)) spare.hidden = true;
  }
}

/** @param {string} name */
function line(name) {
  const made = document.createElement("span");
  made.className = name;
  made.hidden = true;
  return made;
}

/**
 * @param {HTMLElement} element
 * @param {number} left
 * @param {number} top
 * @param {number} width
 * @param {number} height
 */
function setBox(element, left, top, width, height) {
  element.hidden = false;
  element.style.transform = `translate(${left}px, ${top}px)`;
  element.style.inlineSize = `${width}px`;
  element.style.blockSize = `${height}px`;
}
