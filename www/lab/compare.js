/**
 * Two pinned states beside the present one: their numbers, and their motions drawn.
 *
 * @typedef {import("../shell/services.js").RoomServices} RoomServices
 * @typedef {import("../state.js").Pin} Pin
 * @typedef {import("../figure/services.js").Figure} Figure
 * @typedef {ReadonlyMap<string, Figure>} Figures
 */

import { density, onAppearance, resolveTheme } from "../figure/appearance.js";
import { PINS, pointOf, same } from "../state.js";
import { plain } from "../figure/markup.js";
import { spokenFigure } from "../words/engine.js";
import { decimalSign, language, number, onLanguage, say } from "../words/say.js";
import { START } from "./charts.js";
import { button, element, named } from "../controls/dom.js";
import { contact, sentence } from "./facts.js";
import { onceAFrame } from "./once-a-frame.js";
import { numberOf, PAIRS, valueOf } from "../values.js";

/** What is computed of a pinned state. */
const ASKED = ["M", "U", "P", "W"];
const NAMES = ["A", "B"];
/** What can differ between two states. */
const PARAMETERS = ["Omega", "k0", "m", "k", "alpha", "zeta", "zeta_s", "F", "F_p", "F_g", "E", "regime"];

export class Compare {
  element = named(element("section", "compare"), "aria-label", "lab.compare");
  #services;
  #changed;
  /** What is known of each pinned state. @type {Map<string, Map<string, Figure>>} */
  #known = new Map();
  /** @type {Figures} */
  #present = new Map();
  show = onceAFrame(() => this.#show());
  /** Figures that are drawn already, with their themes and languages. @type {WeakMap<Figure, {canvas: HTMLCanvasElement, look: string}>} */
  #pictures = new WeakMap();

  /**
   * @param {RoomServices} services
   * @param {() => void} changed  Something of the pinned states is known that was not.
   */
  constructor(services, changed) {
    this.#services = services;
    this.#changed = changed;
    this.element.hidden = true;
    services.store.subscribe((state, before) => {
      if (state.pinned !== before.pinned) this.#ask();
      if (state.pinned !== before.pinned || state.theme !== before.theme) this.show();
    });
    onLanguage(() => this.show());
    onAppearance(() => this.show());
    this.#ask();
    this.show();
  }

  /** Pins the present state, in the place of the older one where both places are taken. */
  pin() {
    const { act, announce } = this.#services;
    act("lab.act.pin", (state) => {
      const pin = { preset: state.preset, point: state.point };
      if (state.pinned.some((other) => same(other, pin))) return state;
      return { ...state, pinned: [...state.pinned, pin].slice(-PINS) };
    });
    announce(say("lab.pinned", { name: NAMES[this.#services.store.state.pinned.length - 1] }));
  }

  /** The pinned states as they are marked on the charts. */
  get places() {
    const { engine, store } = this.#services;
    return store.state.pinned.map((pin, index) => {
      const given = pointOf(pin);
      const size = this.#known.get(keyOf(pin))?.get("U")?.facts.maxU_p;
      return {
        name: NAMES[index],
        omega: numberOf(given, engine.vocabulary, "Omega"),
        k0: numberOf(given, engine.vocabulary, "k0"),
        size: size === undefined ? null : Number(size),
      };
    });
  }

  /** What the charts show now. @param {Figures} figures */
  know(figures) {
    this.#present = figures;
    this.show();
  }

  #ask() {
    const { engine, store } = this.#services;
    const keys = new Set(store.state.pinned.map(keyOf));
    for (const key of this.#known.keys()) if (!keys.has(key)) this.#known.delete(key);
    for (const pin of store.state.pinned) {
      const key = keyOf(pin);
      if (this.#known.has(key)) continue;
      /** @type {Map<string, Figure>} */
      const figures = new Map();
      this.#known.set(key, figures);
      for (const id of ASKED) {
        const given = Object.fromEntries(Object.entries(pointOf(pin)).filter(([name]) => id !== "M" || !START.includes(name)));
        engine.compute(id, given, { priority: 1 }).then(
          (figure) => {
            figures.set(id, figure);
            this.show();
            this.#changed();
          },
          () => {},
        );
      }
    }
  }

  #show() {
    const { store } = this.#services;
    const { pinned } = store.state;
    this.element.hidden = pinned.length === 0;
    if (pinned.length === 0) {
      this.element.replaceChildren();
      return;
    }
    const states = [...pinned.map((pin) => ({ pin, figures: this.#known.get(keyOf(pin)) ?? new Map() })), { pin: null, figures: this.#present }];
    const head = element("tr", "", element("td", ""), ...states.map(({ pin }, index) => this.#head(pin, index)));
    const table = element("table", "", element("thead", "", head));
    const body = element("tbody", "");
    for (const [label, cells] of this.#rows(states)) body.append(row(label, cells));
    for (const id of ["U", "P"]) body.append(row(say(`lab.chart.${id}`), states.map(({ figures }) => this.#picture(figures.get(id)))));
    table.append(body);
    // Focus stays where it was although the table is new.
    const focused = this.element.contains(document.activeElement) ? document.activeElement?.getAttribute("data-place") : null;
    this.element.replaceChildren(table);
    if (focused) /** @type {HTMLElement | null} */ (this.element.querySelector(`[data-place="${focused}"]`))?.focus();
  }

  /** @param {Pin | null} pin @param {number} index */
  #head(pin, index) {
    const made = element("th", "", pin === null ? say("lab.now") : NAMES[index]);
    made.scope = "col";
    if (pin === null) return made;
    const { act } = this.#services;
    const back = button("lab.compare.back", () => act("lab.act.back", (state) => ({ ...state, preset: pin.preset, point: pin.point })));
    const away = button("lab.compare.unpin", () => act("lab.act.unpin", (state) => ({ ...state, pinned: state.pinned.filter((other) => other !== pin) })));
    for (const [place, made_] of /** @type {const} */ ([["back", back], ["away", away]])) {
      made_.dataset.place = `${place}-${index}`;
      made_.setAttribute("aria-label", `${made_.textContent}: ${NAMES[index]}`);
      made.append(" ", made_);
    }
    return made;
  }

  /**
   * @param {readonly {pin: Pin | null, figures: Figures}[]} states
   * @returns {[string, string[]][]}
   */
  #rows(states) {
    const { engine, store } = this.#services;
    const { vocabulary } = engine;
    const givens = states.map(({ pin }) => pointOf(pin ?? store.state));
    /** @type {[string, string[]][]} */
    const rows = [];
    for (const name of PARAMETERS) {
      const values = givens.map((given) => {
        const [pinion, gear] = (PAIRS[/** @type {keyof typeof PAIRS} */ (name)] ?? [name, name]).map((one) => valueOf(given, vocabulary, one));
        const say_ = (/** @type {number | string} */ value) => (typeof value === "number" ? number(value) : say(`lab.regime.${value}`));
        return pinion === gear ? say_(pinion) : `${say_(pinion)} | ${say_(gear)}`;
      });
      if (name === "Omega" || name === "k0" || values.some((value) => value !== values[0])) rows.push([say(`lab.parameter.${name}`), values]);
    }
    const fact = (/** @type {string} */ id, /** @type {string} */ name) =>
      states.map(({ figures }) => {
        const value = figures.get(id)?.facts[name];
        return typeof value === "number" ? number(value, { digits: 5 }) : "–";
      });
    rows.push(
      [say("lab.row.multiplier"), fact("M", "spectralRadius")],
      // The orbit that is settled on is known better than the motion on its way to it.
      [say("lab.row.size"), fact("P", "maxU_p").map((size, index) => (size === "–" ? fact("U", "maxU_p")[index] : size))],
      [say("lab.row.lowest"), fact("U", "lowest")],
      [say("lab.row.highest"), fact("U", "highest")],
      [say("lab.row.contact"), states.map(({ figures }) => {
        const { sign, words } = contact(figures.get("U")?.facts);
        return `${sign} ${words}`;
      })],
      [say("lab.row.loudest"), fact("W", "loudest")],
      [say("lab.row.words"), states.map(({ figures }) => sentence(figures))],
    );
    return rows;
  }

  /** @param {Figure | undefined} figure */
  #picture(figure) {
    const { engine, store } = this.#services;
    const theme = resolveTheme(null, store.state);
    const look = `${theme} ${language()}`;
    const known = figure === undefined ? undefined : this.#pictures.get(figure);
    if (known !== undefined && known.look === look) return known.canvas;
    const told = figure && spokenFigure(figure);
    const canvas = element("canvas", "");
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", told === undefined ? say("lab.c.unknown") : plain(told.summary));
    if (figure === undefined || told === undefined) return canvas;
    this.#pictures.set(figure, { canvas, look });
    // Drawn when it has its place, of which the size follows.
    requestAnimationFrame(() => {
      if (!canvas.isConnected || canvas.clientWidth < 120) return;
      canvas.width = Math.round(canvas.clientWidth * density());
      canvas.height = Math.round(canvas.clientHeight * density());
      engine.draw(told, canvas, { theme, density: density(), view: { decimal: decimalSign() } });
    });
    return canvas;
  }
}

/** @param {Pin} pin */
function keyOf(pin) {
  return JSON.stringify([pin.preset, pin.point]);
}

/**
 * @param {string} label
 * @param {readonly (string | HTMLElement)[]} cells
 */
function row(label, cells) {
  const name = element("th", "", label);
  name.scope = "row";
  return element("tr", "", name, ...cells.map((cell) => element("td", "", cell)));
}
