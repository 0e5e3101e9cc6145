/**
 * The line of parameters: the only place where numbers are set. Each opens its slider, range and meaning in place.
 *
 * @typedef {import("../shell/services.js").RoomServices} RoomServices
 * @typedef {import("../state.js").State} State
 * @typedef {import("../controls/control.js").Control} Control
 */

import { createControl } from "../controls/control.js";
import { elements } from "../figure/markup.js";
import { pointOf, withPoint } from "../state.js";
import { number, onLanguage, say } from "../words/say.js";
import { START } from "./charts.js";
import { button, element, named, spoken } from "../controls/dom.js";
import { numberOf, PAIRS, setting, valueOf } from "../values.js";

/** What each entry of the line opens. @type {readonly {name: string, opens: readonly string[], further?: boolean}[]} */
const ENTRIES = [
  { name: "m", opens: ["m", "m_p", "m_g"] },
  { name: "k", opens: ["k", "k_p", "k_g"] },
  { name: "alpha", opens: ["alpha", "alpha_p", "alpha_g"] },
  { name: "zeta", opens: ["zeta"] },
  { name: "k0", opens: ["k0"] },
  { name: "Omega", opens: ["Omega"] },
  { name: "F", opens: ["F"] },
  { name: "regime", opens: ["regime"] },
  { name: "zeta_s", opens: ["zeta_s", "zeta_p", "zeta_g"], further: true },
  { name: "F_p", opens: ["F_p", "Omega_p"], further: true },
  { name: "F_g", opens: ["F_g", "Omega_g"], further: true },
  { name: "E", opens: ["E"], further: true },
  { name: "start", opens: START, further: true },
];

/** Digits of a value in the line; its number box has all of them. */
const DIGITS = 6;

export class Parameters {
  element = named(element("section", "numbers"), "aria-label", "lab.line");
  #services;
  #entries = element("div", "entries");
  #drawer = element("div", "drawer");
  /** @type {Map<string, HTMLButtonElement>} */
  #buttons = new Map();
  /** @type {Map<string, Control>} */
  #controls = new Map();
  /** The entry whose drawer is open. @type {string | null} */
  #open = null;
  /** The parameter of which something is complained, and what. @type {string | null} */
  #blamed = null;
  /** @type {string | null} */
  #message = null;

  /** @param {RoomServices} services */
  constructor(services) {
    this.#services = services;
    const further = element("div", "further");
    for (const entry of ENTRIES) (entry.further ? further : this.#entries).append(this.#entry(entry));
    further.hidden = true;
    further.id = "lab-further";
    const more = named(element("button", "more", "…"), "aria-label", "lab.more");
    more.type = "button";
    more.setAttribute("aria-expanded", "false");
    more.setAttribute("aria-controls", further.id);
    more.addEventListener("click", () => {
      further.hidden = !further.hidden;
      more.setAttribute("aria-expanded", String(!further.hidden));
    });
    this.#entries.append(more, further);
    this.#drawer.id = "lab-drawer";
    this.#drawer.hidden = true;
    this.element.append(this.#entries, this.#drawer);
    this.#listen();
    services.store.subscribe(() => this.show());
    onLanguage(() => {
      if (this.#open !== null) this.open(this.#open, false);
      this.show();
    });
    this.show();
  }

  /**
   * Opens the drawer of a parameter.
   *
   * @param {string} name
   * @param {boolean} [focus]
   */
  open(name, focus = true) {
    const entry = ENTRIES.find(({ name: own, opens }) => own === name || opens.includes(name));
    if (entry === undefined) return;
    this.#open = entry.name;
    this.#controls.clear();
    this.#drawer.replaceChildren(...entry.opens.map((one) => this.#control(one)), this.#foot(entry.name));
    this.#drawer.hidden = false;
    for (const [own, toggle] of this.#buttons) toggle.setAttribute("aria-expanded", String(own === entry.name));
    if (focus) /** @type {HTMLElement | null} */ (this.#drawer.querySelector("input, select"))?.focus();
  }

  close() {
    const opener = this.#open === null ? undefined : this.#buttons.get(this.#open);
    this.#open = null;
    this.#drawer.hidden = true;
    this.#drawer.replaceChildren();
    this.#controls.clear();
    for (const toggle of this.#buttons.values()) toggle.setAttribute("aria-expanded", "false");
    opener?.focus();
  }

  /**
   * Says beside a parameter what cannot be.
   *
   * @param {string | null} name
   * @param {string | null} message
   */
  complain(name, message) {
    if (this.#blamed !== null && this.#blamed !== name) this.#controls.get(this.#blamed)?.complain(null);
    this.#blamed = message === null ? null : name;
    this.#message = message;
    if (name !== null) this.#controls.get(name)?.complain(message);
  }

  show() {
    const { engine, store } = this.#services;
    const given = pointOf(store.state);
    for (const [name, toggle] of this.#buttons) {
      const value = toggle.querySelector(".value");
      if (value !== null) value.textContent = this.#words(name, given);
    }
    for (const [name, control] of this.#controls) control.show(this.#shown(valueOf(given, engine.vocabulary, name)));
  }

  /** Controls are given values that can be shown. @param {number | string} value */
  #shown(value) {
    return typeof value === "number" && !Number.isFinite(value) ? 0 : value;
  }

  /**
   * @param {string} name
   * @param {import("../state.js").Given} given
   */
  #words(name, given) {
    const { vocabulary } = this.#services.engine;
    if (name === "start") return say(START.some((one) => one in given) ? "lab.start.own" : "lab.start.usual");
    if (name === "regime") return say(`lab.regime.${valueOf(given, vocabulary, "regime")}`);
    const both = PAIRS[/** @type {keyof typeof PAIRS} */ (name)];
    if (both === undefined) return number(numberOf(given, vocabulary, name), { digits: DIGITS });
    const [pinion, gear] = both.map((one) => numberOf(given, vocabulary, one));
    return [...new Set([pinion, gear])].map((value) => number(value, { digits: DIGITS })).join(" | ");
  }

  /** @param {{name: string, opens: readonly string[]}} entry */
  #entry({ name }) {
    const info = this.#services.engine.vocabulary.get(name);
    const toggle = element("button", "entry");
    toggle.type = "button";
    toggle.dataset.parameter = name;
    toggle.setAttribute("aria-expanded", "false");
    toggle.setAttribute("aria-controls", "lab-drawer");
    const symbol = element("span", "symbol");
    if (info !== undefined && "symbol" in info) symbol.append(elements(info.symbol));
    else spoken(symbol, `lab.entry.${name}`);
    toggle.append(symbol, " ", element("span", "value"));
    toggle.addEventListener("click", () => {
      if (this.#open === name) this.close();
      else this.open(name);
    });
    this.#buttons.set(name, toggle);
    return toggle;
  }

  /** @param {string} name */
  #control(name) {
    const { engine, store, act } = this.#services;
    const info = engine.vocabulary.get(name);
    if (info === undefined) return "";
    const value = this.#shown(valueOf(pointOf(store.state), engine.vocabulary, name));
    const control = createControl(info, value, {
      change: (to) => {
        const before = store.state;
        act("act.parameter", (state) => withPoint(state, setting(name, to)), { merge: `lab ${name}` });
        // The same value said once more is as wrong as it was.
        if (store.state === before) this.complain(this.#blamed, this.#message);
        else this.complain(name, null);
      },
      refuse: () => {},
    });
    this.#controls.set(name, control);
    return control.element;
  }

  /** @param {string} name */
  #foot(name) {
    const { act } = this.#services;
    const foot = element("div", "foot");
    if (name === "start") {
      const clear = () => act("lab.act.start", (state) => withPoint(state, Object.fromEntries(START.map((one) => [one, undefined]))));
      foot.append(spoken(element("p", "help"), "lab.start.help"), button("lab.start.clear", clear));
    }
    foot.append(button("lab.close", () => this.close()));
    return foot;
  }

  #listen() {
    this.element.addEventListener("keydown", (event) => {
      if (event.key !== "Escape" || this.#open === null) return;
      event.stopPropagation();
      this.close();
    });
  }
}

/**
 * The two sliders under the thumb on a phone: mesh frequency and depth of the pulsation.
 *
 * @param {RoomServices} services
 * @param {() => [number, number]} range  Of the mesh frequencies shown.
 */
export function createThumb({ engine, store, act }, range) {
  const home = named(element("div", "thumb"), "aria-label", "lab.thumb");
  home.setAttribute("role", "group");
  const rows = ["Omega", "k0"].map((name) => {
    const info = engine.vocabulary.get(name);
    const slider = element("input", "");
    slider.type = "range";
    slider.step = "any";
    const symbol = element("span", "symbol");
    if (info !== undefined && "symbol" in info) symbol.append(elements(info.symbol));
    const label = element("label", "", symbol);
    const value = element("output", "");
    label.append(slider, value);
    home.append(label);
    slider.addEventListener("input", () => {
      const step = (Number(slider.max) - Number(slider.min)) / 1000;
      const digits = Math.max(0, Math.ceil(-Math.log10(step)));
      const to = Number(Number(slider.value).toFixed(digits));
      act("act.parameter", (state) => withPoint(state, { [name]: to }), { merge: `lab ${name}` });
    });
    return { name, slider, value };
  });
  const show = () => {
    const given = pointOf(store.state);
    for (const { name, slider, value } of rows) {
      const [low, high] = name === "Omega" ? range() : [0, 1];
      slider.min = String(low);
      slider.max = String(high);
      const now = numberOf(given, engine.vocabulary, name);
      slider.value = String(now);
      slider.setAttribute("aria-valuetext", number(now));
      value.textContent = number(now);
    }
  };
  store.subscribe(show);
  onLanguage(show);
  show();
  return { element: home, show };
}
