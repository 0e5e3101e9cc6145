/**
 * A real gear pair in SI units: into the parameters, and back out of them as speeds and torques.
 *
 * @typedef {import("../shell/services.js").RoomServices} RoomServices
 * @typedef {import("../state.js").State} State
 * @typedef {import("../state.js").Given} Given
 * @typedef {import("../figure/services.js").Figure} Figure
 * @typedef {Readonly<Record<string, number>>} Si
 */

import { parseNumber, writeNumber } from "../controls/number.js";
import { pointOf, same, withPoint } from "../state.js";
import { number, onLanguage, say } from "../words/say.js";
import { START } from "./charts.js";
import { button, element, named, spoken } from "../controls/dom.js";
import { over } from "./facts.js";
import { numberOf, PAIRS, valueOf } from "../values.js";

/** What is asked for, in groups, each with its unit. @type {readonly (readonly [group: string, quantities: readonly (readonly [name: string, unit: string])[]])[]} */
const ASKED = [
  ["gears", [["teeth_p", ""], ["teeth_g", ""], ["r_p", "m"], ["r_g", "m"], ["M_p", "kg"], ["M_g", "kg"], ["I_p", "kg m²"], ["I_g", "kg m²"]]],
  ["mesh", [["K", "N/m"], ["K_amplitude", "N/m"], ["C", "N s/m"], ["b", "m"], ["E", "m"]]],
  ["supports", [["K_p", "N/m"], ["K_g", "N/m"], ["K_p3", "N/m³"], ["K_g3", "N/m³"], ["C_p", "N s/m"], ["C_g", "N s/m"]]],
  ["drive", [["rpm_p", "1/min"], ["T_p", "N m"]]],
];
/** Whole numbers of a pair, which no parameter changes. */
const FIXED = new Set(["teeth_p", "teeth_g", "r_p", "r_g", "I_p", "I_g"]);
/** A pair to begin with: it has the paper's parameters, near its tongue of the second mode, under a load. @type {Si} */
const EXAMPLE = Object.freeze({
  teeth_p: 25, teeth_g: 40, r_p: 0.05, r_g: 0.08, M_p: 2, M_g: 2, I_p: 0.01, I_g: 0.0256,
  K: 2e8, K_amplitude: 1e8, C: 800, b: 5e-5, E: 0,
  K_p: 1e9, K_g: 1e9, K_p3: -1.6e16, K_g3: -1.6e16, C_p: 800, C_g: 800,
  rpm_p: 6300, T_p: 750,
});
/** Digits that survive the way through the parameters and back. */
const DIGITS = 12;
/** After this pause the least torque is looked for, ms. */
const PAUSE = 350;
/** The tongues as figure T names them. */
const TONGUES = /** @type {const} */ ([["primary2", "second mode"], ["combination", "combination"], ["primary3", "third mode"]]);

export class Pair {
  element = named(element("section", "pair"), "aria-label", "lab.pair");
  #services;
  #form = element("form", "");
  #answers = element("div", "answers");
  #complaint = element("p", "complaint");
  /** @type {Map<string, HTMLInputElement>} */
  #boxes = new Map();
  /** @type {ReadonlyMap<string, Figure>} */
  #figures = new Map();
  /** @type {AbortController | null} */
  #asking = null;
  /** @type {Figure | null} */
  #loads = null;
  #asked = "";

  /** @param {RoomServices} services */
  constructor(services) {
    this.#services = services;
    this.element.hidden = true;
    this.#complaint.setAttribute("role", "alert");
    for (const [group, quantities] of ASKED) this.#form.append(this.#group(group, quantities));
    const use = button("lab.pair.use", () => {});
    use.type = "submit";
    const leave = button("lab.pair.leave", () => services.act("lab.act.unpair", (state) => ({ ...state, si: null })));
    this.#form.append(this.#complaint, element("p", "buttons", use, leave));
    this.#form.addEventListener("submit", (event) => {
      event.preventDefault();
      this.#use();
    });
    this.element.append(spoken(element("p", "help"), "lab.pair.help"), this.#form, this.#answers);
    services.store.subscribe((state, before) => {
      if (state.si !== before.si || state.point !== before.point || state.preset !== before.preset) this.show();
    });
    onLanguage(() => this.show());
    this.#fill(services.store.state.si ?? EXAMPLE);
    this.show();
  }

  /** Opens or closes the panel. @param {boolean} open */
  open(open) {
    this.element.hidden = !open;
    if (open) this.show();
    else this.#asking?.abort();
  }

  get shown() {
    return !this.element.hidden;
  }

  /** What the charts show now. @param {ReadonlyMap<string, Figure>} figures */
  know(figures) {
    this.#figures = figures;
    if (!this.element.hidden) this.#showAnswers();
  }

  /** The mesh frequency of the real pair, Hz; null where there is none. */
  get hertz() {
    return this.#physical()?.mesh_frequency ?? null;
  }

  show() {
    const { store } = this.#services;
    const { si } = store.state;
    if (si !== null) {
      const led = this.#led(si);
      if (!same(led, si)) store.update({ si: led });
      this.#fill(led);
    }
    if (this.element.hidden) return;
    this.#showAnswers();
    this.#askLoads();
  }

  /** The pair as it is after parameters were changed. @param {Si} si @returns {Si} */
  #led(si) {
    const back = this.#physical();
    if (back === null) return si;
    const led = Object.entries(si).map(([name, value]) => {
      const now = /** @type {Record<string, number>} */ (/** @type {unknown} */ (back))[name];
      if (FIXED.has(name) || now === undefined) return [name, value];
      const rounded = Number(now.toPrecision(DIGITS));
      return [name, Math.abs(rounded - value) <= 1e-9 * Math.abs(value) ? value : rounded];
    });
    return Object.fromEntries(led);
  }

  /** The point in SI units; null where no pair gives the scales. */
  #physical(more = {}) {
    const { engine, store } = this.#services;
    const { si } = store.state;
    if (si === null) return null;
    try {
      const { scales } = engine.fromPhysical(asked(si));
      return engine.toPhysical({ ...modelOf(pointOf(store.state)), ...more }, scales);
    } catch {
      return null;
    }
  }

  #use() {
    const { act, engine } = this.#services;
    this.#complain(null, null);
    /** @type {Record<string, number>} */
    const si = {};
    for (const [name, box] of this.#boxes) {
      const value = parseNumber(box.value);
      if (value === null) {
        this.#complain(name, say("lab.pair.number", { name: say(`lab.si.${name}`) }));
        return;
      }
      si[name] = value;
    }
    try {
      const { params } = engine.fromPhysical(asked(si));
      act("lab.act.pair", (state) => ({ ...withPoint(state, taken({ ...params }, state, engine.vocabulary)), si }));
    } catch (thrown) {
      const error = /** @type {Error & {parameter?: string | null}} */ (thrown);
      this.#complain(error.parameter ?? null, error.message);
    }
  }

  /** @param {string | null} name @param {string | null} message */
  #complain(name, message) {
    for (const [own, box] of this.#boxes) {
      if (own === name && message !== null) box.setAttribute("aria-invalid", "true");
      else box.removeAttribute("aria-invalid");
    }
    this.#complaint.textContent = message ?? "";
    if (name !== null) this.#boxes.get(name)?.focus();
  }

  /** @param {Si} si */
  #fill(si) {
    for (const [name, box] of this.#boxes) {
      if (document.activeElement !== box && !box.hasAttribute("aria-invalid")) box.value = written(si[name] ?? 0);
    }
  }

  /**
   * @param {string} group
   * @param {readonly (readonly [string, string])[]} quantities
   */
  #group(group, quantities) {
    const made = element("fieldset", "", spoken(element("legend", ""), `lab.pair.${group}`));
    for (const [name, unit] of quantities) {
      const box = element("input", "");
      Object.assign(box, { type: "text", inputMode: "decimal", autocomplete: "off", spellcheck: false, id: `si-${name}` });
      const label = spoken(element("label", ""), `lab.si.${name}`);
      label.htmlFor = box.id;
      made.append(element("div", "quantity", label, box, element("span", "unit", unit)));
      this.#boxes.set(name, box);
    }
    return made;
  }

  #showAnswers() {
    const now = this.#physical();
    if (now === null) {
      this.#answers.replaceChildren(element("p", "", say("lab.pair.none")));
      return;
    }
    const { engine, store } = this.#services;
    const given = pointOf(store.state);
    const lines = [
      say("lab.pair.now", { hertz: digits(now.mesh_frequency), pinion: digits(now.rpm_p), gear: digits(now.rpm_g), torque: digits(now.T_p) }),
      this.#leastTorque(given),
    ];
    const rows = TONGUES.map(([key, name]) => {
      const edges = this.#edges(name, numberOf(given, engine.vocabulary, "k0"));
      const words = edges === null ? say("lab.pair.closed") : say("lab.pair.range", { low: digits(this.#rpm(edges[0])), high: digits(this.#rpm(edges[1])) });
      return element("tr", "", heading(say(`lab.tongue.${key}`)), element("td", "", words));
    });
    const table = element("table", "", element("caption", "", say("lab.pair.tongues", { k0: digits(numberOf(given, engine.vocabulary, "k0")) })), element("tbody", "", ...rows));
    this.#answers.replaceChildren(...lines.filter((line) => line !== "").map((line) => element("p", "", line)), table);
  }

  /** The pinion's speed at a mesh frequency. @param {number} omega */
  #rpm(omega) {
    return this.#physical({ Omega: omega })?.rpm_p ?? Number.NaN;
  }

  /**
   * The exact edges of a tongue at a depth, from the boundaries that figure T has drawn.
   *
   * @param {string} name
   * @param {number} k0
   * @returns {[number, number] | null}
   */
  #edges(name, k0) {
    /** @type {number[]} */
    const found = [];
    for (const { meaning, columns } of this.#figures.get("T")?.series ?? []) {
      if (!meaning.startsWith(`exact boundary, ${name}:`)) continue;
      const { x, y } = columns;
      for (let index = 1; index < x.length; index += 1) {
        if ((y[index - 1] - k0) * (y[index] - k0) > 0 || y[index] === y[index - 1]) continue;
        found.push(x[index - 1] + ((k0 - y[index - 1]) / (y[index] - y[index - 1])) * (x[index] - x[index - 1]));
      }
    }
    return found.length < 2 ? null : [Math.min(...found), Math.max(...found)];
  }

  /** The least torque that keeps the teeth together here, in words. @param {Given} given */
  #leastTorque(given) {
    if (this.#loads === null) return say("lab.pair.looking");
    const omega = numberOf(given, this.#services.engine.vocabulary, "Omega");
    const curve = this.#loads.series.find(({ name }) => name === "load");
    const least = curve === undefined ? -Infinity : pieces(curve).reduce((most, [x, y]) => Math.max(most, over(x, y, omega)), -Infinity);
    if (!Number.isFinite(least)) return say("lab.pair.no-torque");
    const torque = this.#physical({ F: least, regime: "contact" })?.T_p;
    return torque === undefined ? "" : say("lab.pair.torque", { torque: digits(torque) });
  }

  /** Looks for the least load over all mesh frequencies, unless it is known or being looked for. */
  #askLoads() {
    const { engine, store } = this.#services;
    const { F: _, Omega: __, ...others } = modelOf(pointOf(store.state));
    const given = { ...others, regime: "contact" };
    const asked = JSON.stringify(given);
    if (asked === this.#asked || store.state.si === null) return;
    this.#asked = asked;
    this.#asking?.abort();
    const run = new AbortController();
    this.#asking = run;
    this.#loads = null;
    setTimeout(() => {
      if (run.signal.aborted) return;
      engine.compute("L", given, { signal: run.signal, priority: 1 }).then(
        (figure) => {
          if (run.signal.aborted) return;
          this.#loads = figure;
          this.#showAnswers();
        },
        () => {
          if (!run.signal.aborted) this.#asked = "";
        },
      );
    }, PAUSE);
  }
}

/** @param {string} words */
function heading(words) {
  const made = element("th", "", words);
  made.scope = "row";
  return made;
}

/**
 * A pair as the module takes it: what is missing it names itself.
 *
 * @param {Si} si
 */
function asked(si) {
  return /** @type {import("../engine/gear-bifurcations.js").PhysicalPair} */ (/** @type {unknown} */ (si));
}

/** A quantity as it is written in a box, large and small ones with a power of ten. @param {number} value */
function written(value) {
  const rounded = Number(value.toPrecision(6));
  const size = Math.abs(rounded);
  return size !== 0 && (size >= 1e6 || size < 1e-3) ? rounded.toExponential() : writeNumber(rounded);
}

/** @param {number | undefined} value */
function digits(value = Number.NaN) {
  return number(value, { digits: 4 });
}

/** The parameters of a point without its start. @param {Given} given @returns {Record<string, number | string>} */
function modelOf(given) {
  return Object.fromEntries(Object.entries(given).filter(([name]) => !START.includes(name)));
}

/**
 * A curve's separate pieces, each as its columns.
 *
 * @param {Figure["series"][number]} curve
 * @returns {[Float64Array, Float64Array][]}
 */
function pieces({ columns: { x, y }, pieces: starts }) {
  const from = starts.length === 0 ? [0] : Array.from(starts);
  return from.map((start, index) => [x.subarray(start, from[index + 1]), y.subarray(start, from[index + 1])]);
}

/**
 * What has to be set at the point for a pair's parameters: equal ones by their short form, and a regime in which a load can be.
 *
 * @param {Readonly<Record<string, number | string>>} params
 * @param {State} state
 * @param {import("../values.js").Vocabulary} vocabulary
 */
function taken(params, state, vocabulary) {
  /** @type {Record<string, number | string | undefined>} */
  const values = {};
  for (const [name, value] of Object.entries(params)) {
    if (name !== "regime") values[name] = Number(Number(value).toPrecision(DIGITS));
  }
  for (const [short, [pinion, gear]] of Object.entries(PAIRS)) {
    const equal = values[pinion] === values[gear];
    values[short] = equal ? values[pinion] : undefined;
    if (equal) values[pinion] = values[gear] = undefined;
  }
  if (values.F_p === 0) values.Omega_p = undefined;
  if (values.F_g === 0) values.Omega_g = undefined;
  const loaded = ["F", "F_p", "F_g", "E"].some((name) => values[name] !== 0);
  if (loaded && valueOf(pointOf(state), vocabulary, "regime") === "homogeneous") values.regime = "backlash";
  for (const name of START) values[name] = undefined;
  return values;
}
