/**
 * What lies over the two charts on the left: one cursor through both, the motion's place among the branches and its
 * trail, and the pinned states. The charts are held so that a mesh frequency is at the same pixel in both.
 *
 * @typedef {import("./charts.js").Chart} Chart
 * @typedef {import("../figure/services.js").FrameMap} FrameMap
 * @typedef {{omega: number, size: number}} Place
 */

import { pixelOf } from "../figure/frames.js";
import { named, element } from "../controls/dom.js";

/** How many places of the trail are kept. */
const TRAIL = 800;
/** No chart is made narrower than by this part of its place. */
const MOST_INSET = 0.3;
/** Keys and how far they move the cursor, in parts of what is shown. */
const KEYS = new Map([
  ["ArrowRight", 0.0025],
  ["ArrowUp", 0.0025],
  ["ArrowLeft", -0.0025],
  ["ArrowDown", -0.0025],
  ["PageUp", 0.025],
  ["PageDown", -0.025],
]);

/**
 * @typedef {object} Hooks
 * @property {() => number} omega
 * @property {(omega: number) => void} move
 * @property {(omega: number) => string} words  The cursor's place, for the ear.
 */

export class Cursor {
  #chart;
  #branches;
  #home;
  #hooks;
  #line = element("div", "cursor");
  #knob = named(element("button", "knob"), "aria-label", "lab.cursor");
  #picture = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  #trail = document.createElementNS("http://www.w3.org/2000/svg", "polyline");
  #dot = document.createElementNS("http://www.w3.org/2000/svg", "circle");
  /** What was shown last: on a phone both charts may be hidden. @type {[number, number]} */
  #range;
  /** @type {Place | null} */
  #place = null;
  /** @type {Place[]} */
  #passed = [];
  /** @type {readonly {name: string, omega: number, k0: number, size: number | null}[]} */
  #pins = [];
  /** @type {HTMLElement[]} */
  #flags = [];
  #due = false;

  /**
   * @param {HTMLElement} home  The place of both charts, to which everything here is relative.
   * @param {Chart} chart  The stability chart, over mesh frequency and depth.
   * @param {Chart} branches
   * @param {[number, number]} range  Of mesh frequencies, before either is drawn.
   * @param {Hooks} hooks
   */
  constructor(home, chart, branches, range, hooks) {
    this.#range = range;
    this.#home = home;
    this.#chart = chart;
    this.#branches = branches;
    this.#hooks = hooks;
    this.#picture.classList.add("over");
    this.#picture.setAttribute("aria-hidden", "true");
    this.#trail.classList.add("trail");
    this.#dot.classList.add("here");
    this.#dot.setAttribute("r", "6");
    this.#picture.append(this.#trail, this.#dot);
    this.#knob.type = "button";
    this.#knob.setAttribute("role", "slider");
    this.#line.append(this.#knob);
    home.append(this.#picture, this.#line);
    this.#listen();
    for (const { figure } of [chart, branches]) figure.addEventListener("gear-paint", () => this.show());
    // What was held still while a hand was on it.
    for (const end of ["pointerup", "pointercancel"]) home.addEventListener(end, () => requestAnimationFrame(() => this.show()));
  }

  /** The motion's greatest `|u_p|` at its mesh frequency, or nothing known of it. @param {Place | null} place */
  place(place) {
    this.#place = place;
    this.show();
  }

  /** Leaves a trail where the motion is now. */
  leaveTrail() {
    if (this.#place === null) return;
    this.#passed.push(this.#place);
    if (this.#passed.length > TRAIL) this.#passed.shift();
  }

  forgetTrail() {
    this.#passed = [];
    this.show();
  }

  /** @param {readonly {name: string, omega: number, k0: number, size: number | null}[]} pins */
  pin(pins) {
    this.#pins = pins;
    this.show();
  }

  /** The range of mesh frequencies that is shown. @returns {[number, number]} */
  get range() {
    const map = mapOf(this.#chart) ?? mapOf(this.#branches);
    if (map !== null) this.#range = [map.x.low, map.x.high];
    return this.#range;
  }

  /** Puts everything in its place, once for all that asks for it in one go: to ask where the charts are has them laid out. */
  show() {
    if (this.#due) return;
    this.#due = true;
    queueMicrotask(() => {
      this.#due = false;
      this.#show();
    });
  }

  #show() {
    this.#align();
    const map = mapOf(this.#chart) ?? mapOf(this.#branches);
    const owner = mapOf(this.#chart) === null ? this.#branches : this.#chart;
    const omega = this.#hooks.omega();
    if (map === null) {
      this.#line.hidden = true;
      return;
    }
    const offset = offsetOf(owner, this.#home);
    const left = offset.left + pixelOf(map, omega, map.y.low).left;
    // Rounding may carry it a hair beyond the end.
    const hair = (map.x.high - map.x.low) / 1000;
    const inside = omega >= map.x.low - hair && omega <= map.x.high + hair;
    this.#line.hidden = !inside;
    this.#line.style.transform = `translateX(${left.toFixed(2)}px)`;
    const [low, high] = this.range;
    this.#knob.setAttribute("aria-valuemin", String(low));
    this.#knob.setAttribute("aria-valuemax", String(high));
    this.#knob.setAttribute("aria-valuenow", String(omega));
    this.#knob.setAttribute("aria-valuetext", this.#hooks.words(omega));
    this.#showPlaces();
  }

  #showPlaces() {
    const map = mapOf(this.#branches);
    const offset = offsetOf(this.#branches, this.#home);
    /** @param {Place} place */
    const at = ({ omega, size }) => {
      if (map === null) return null;
      const { left, top } = pixelOf(map, omega, size);
      const { plot } = map;
      const inside = left >= plot.left && left <= plot.right && top >= plot.top - 1 && top <= plot.bottom + 1;
      return inside ? { left: offset.left + left, top: offset.top + top } : null;
    };
    const here = this.#place === null ? null : at(this.#place);
    this.#dot.style.display = here === null ? "none" : "";
    if (here !== null) {
      this.#dot.setAttribute("cx", here.left.toFixed(1));
      this.#dot.setAttribute("cy", here.top.toFixed(1));
    }
    const trail = this.#passed.map(at).filter((place) => place !== null);
    this.#trail.setAttribute("points", trail.map(({ left, top }) => `${left.toFixed(1)},${top.toFixed(1)}`).join(" "));
    this.#showPins(at);
  }

  /** @param {(place: Place) => {left: number, top: number} | null} onBranches */
  #showPins(onBranches) {
    for (const flag of this.#flags) flag.remove();
    this.#flags = [];
    const map = mapOf(this.#chart);
    const offset = offsetOf(this.#chart, this.#home);
    for (const { name, omega, k0, size } of this.#pins) {
      const places = [size === null ? null : onBranches({ omega, size })];
      if (map !== null && omega >= map.x.low && omega <= map.x.high && k0 >= map.y.low && k0 <= map.y.high) {
        const { left, top } = pixelOf(map, omega, k0);
        places.push({ left: offset.left + left, top: offset.top + top });
      }
      for (const place of places) {
        if (place === null) continue;
        const flag = element("span", "pin-flag", name);
        flag.setAttribute("aria-hidden", "true");
        flag.style.transform = `translate(${place.left.toFixed(1)}px, ${place.top.toFixed(1)}px)`;
        this.#home.append(flag);
        this.#flags.push(flag);
      }
    }
  }

  /** Moves the charts' edges so that what they share of the axis lies at the same pixels. */
  #align() {
    const [above, below] = [mapOf(this.#chart), mapOf(this.#branches)];
    const [one, other] = [this.#chart.figure, this.#branches.figure];
    // A chart that moved under the hand would put the handle where nobody dragged it.
    if ([one, other, this.#knob].some((part) => part.matches(":active"))) return;
    if (above === null || below === null) {
      for (const figure of [one, other]) inset(figure, 0, 0);
      return;
    }
    const width = this.#home.clientWidth;
    if (one.offsetTop === other.offsetTop || Math.abs(one.getBoundingClientRect().width - other.getBoundingClientRect().width) > 1) return;
    const beside = { left: above.plot.left, right: storeWidth(one) - above.plot.right };
    const under = { left: below.plot.left, right: storeWidth(other) - below.plot.right };
    // The edges of the wider chart stand as far in as either needs.
    const left = Math.max(beside.left, under.left);
    const right = Math.max(beside.right, under.right);
    const scale = (width - left - right) / (Math.max(above.x.high, below.x.high) - Math.min(above.x.low, below.x.low));
    if (!(scale > 0)) return;
    const shifted = (/** @type {number} */ from) => Math.max(0, from * scale);
    const insets = [
      [left - beside.left + shifted(above.x.low - below.x.low), right - beside.right + shifted(below.x.high - above.x.high)],
      [left - under.left + shifted(below.x.low - above.x.low), right - under.right + shifted(above.x.high - below.x.high)],
    ];
    // Where they share too little of the axis, each has its own.
    const apart = insets.some(([start, end]) => start + end > MOST_INSET * width);
    [one, other].forEach((figure, index) => inset(figure, apart ? 0 : insets[index][0], apart ? 0 : insets[index][1]));
  }

  #listen() {
    const knob = this.#knob;
    /** @type {number | null} */
    let dragging = null;
    knob.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      dragging = event.pointerId;
      knob.setPointerCapture(event.pointerId);
    });
    knob.addEventListener("pointermove", (event) => {
      if (event.pointerId === dragging) this.#moveTo(event.clientX);
    });
    for (const end of /** @type {const} */ (["pointerup", "pointercancel"])) {
      knob.addEventListener(end, () => {
        dragging = null;
      });
    }
    knob.addEventListener("keydown", (event) => {
      const [low, high] = this.range;
      const step = KEYS.get(event.key);
      const end = { Home: low, End: high }[event.key];
      if ((step === undefined && end === undefined) || event.ctrlKey || event.altKey || event.metaKey) return;
      event.preventDefault();
      this.#hooks.move(rounded(end ?? this.#hooks.omega() + (step ?? 0) * (high - low), high - low));
    });
  }

  /** @param {number} clientX */
  #moveTo(clientX) {
    const map = mapOf(this.#chart) ?? mapOf(this.#branches);
    const owner = mapOf(this.#chart) === null ? this.#branches : this.#chart;
    if (map === null) return;
    const left = clientX - this.#home.getBoundingClientRect().left - offsetOf(owner, this.#home).left;
    const part = (left - map.plot.left) / (map.plot.right - map.plot.left);
    const omega = map.x.low + Math.min(1, Math.max(0, part)) * (map.x.high - map.x.low);
    this.#hooks.move(rounded(omega, map.x.high - map.x.low));
  }
}

/** As many digits as a pixel can tell apart. @param {number} omega @param {number} width */
function rounded(omega, width) {
  const digits = Math.max(0, Math.ceil(-Math.log10(width / 2000)));
  return Number(Math.max(0.01, omega).toFixed(digits));
}

/**
 * The map of a chart's only frame; null while there is none or it is not shown.
 *
 * @param {Chart} chart
 * @returns {FrameMap | null}
 */
export function mapOf({ figure }) {
  // Asked first, for to ask for its size has everything laid out that has changed, be it in another view.
  if (figure.closest("[hidden]") !== null || figure.clientWidth === 0) return null;
  return figure.map()?.frames[0] ?? null;
}

/**
 * Where a chart's canvas begins within the home.
 *
 * @param {Chart} chart
 * @param {HTMLElement} home
 */
export function offsetOf({ figure }, home) {
  const box = (figure.shadowRoot?.querySelector("canvas") ?? figure).getBoundingClientRect();
  const from = home.getBoundingClientRect();
  return { left: box.left - from.left, top: box.top - from.top };
}

/** The width of what is drawn. @param {HTMLElement} figure */
function storeWidth(figure) {
  return figure.shadowRoot?.querySelector("canvas")?.clientWidth ?? figure.clientWidth;
}

/** @param {HTMLElement} figure @param {number} left @param {number} right */
function inset(figure, left, right) {
  for (const [name, value] of /** @type {const} */ ([["--inset-start", left], ["--inset-end", right]])) {
    const text = `${Math.max(0, value).toFixed(2)}px`;
    const before = Number.parseFloat(figure.style.getPropertyValue(name));
    // Less than half a pixel nobody sees, and following it would never end.
    if (!(Math.abs(before - value) < 0.5)) figure.style.setProperty(name, text);
  }
}
