/**
 * The laboratory: one operating point, and charts that follow it together.
 *
 * @typedef {import("../shell/services.js").RoomServices} RoomServices
 * @typedef {import("../figure/services.js").Figure} Figure
 * @typedef {import("./charts.js").ChartId} ChartId
 * @typedef {import("./charts.js").Chart} Chart
 */

import { sentence as marked } from "../figure/markup.js";
import { pointOf, withPoint, withPreset } from "../state.js";
import { words } from "../words/en/lab.js";
import { language, learn, number, onLanguage, say } from "../words/say.js";
import { CHARTS, createCharts } from "./charts.js";
import { Compare } from "./compare.js";
import { Creep } from "./creep.js";
import { Cursor } from "./cursor.js";
import { button, choice, element, named, spoken } from "../controls/dom.js";
import { contact, sentence } from "./facts.js";
import { onceAFrame } from "./once-a-frame.js";
import { Pair } from "./pair.js";
import { createThumb, Parameters } from "./parameters.js";
import { pickOrbits, pickStarts } from "./pick.js";
import { shareWindows } from "./share.js";
import { Sound } from "./sound.js";
import { adopt } from "../style/adopt.js";
import { STYLE } from "./style.js";
import { numberOf } from "../values.js";

learn(words);

/** Mesh frequencies at hand before any chart says which it shows. @type {[number, number]} */
const RANGE = [0.4, 7];
/** Charts of which the sentence and the flag speak. */
const SPOKEN = new Set(["U", "P", "M"]);
/** The sentence is heard when nothing has changed for so long, ms. */
const QUIET = 900;

/**
 * @param {HTMLElement} host
 * @param {RoomServices} services
 */
export function start(host, services) {
  adopt(STYLE);
  new Laboratory(host, services);
}

class Laboratory {
  #services;
  #charts;
  /** The newest figure of each chart. @type {Map<string, Figure>} */
  #figures = new Map();
  /** What was drawn last in each, whether it still holds or not. @type {Map<string, Figure>} */
  #drawn = new Map();
  /** Charts that cannot be, and why. @type {Map<string, string>} */
  #refused = new Map();
  #sentence = element("p", "sentence");
  #flag = element("p", "flag");
  #pair;
  #compare;
  #cursor;
  #creep;
  #parameters;
  #thumb;
  #orbits;
  #sound = new Sound();
  #home = element("div", "lab");
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #quiet;
  #said = "";
  /** Says anew what is so, once for all that comes within a frame. */
  #later = onceAFrame(() => this.#tell());
  /** Once a frame, for to ask what is shown has everything laid out. */
  #askHiddenSoon = onceAFrame(() => this.#askHidden());

  /**
   * @param {HTMLElement} host
   * @param {RoomServices} services
   */
  constructor(host, services) {
    this.#services = services;
    const { act, engine, store } = services;
    const charts = createCharts(services);
    this.#charts = charts;
    const chart = (/** @type {ChartId} */ id) => /** @type {Chart} */ (charts.get(id));
    const omega = () => numberOf(pointOf(store.state), engine.vocabulary, "Omega");

    const left = element("div", "left", chart("T").place, chart("B").place);
    this.#cursor = new Cursor(left, chart("T"), chart("B"), RANGE, {
      omega,
      move: (to) => act("act.parameter", (state) => withPoint(state, { Omega: to }), { merge: "lab Omega" }),
      words: (at) => number(at, { digits: 6 }),
    });
    this.#creep = new Creep(services, {
      range: () => this.#cursor.range,
      changed: () => this.#showPlaying(),
      stepped: () => this.#cursor.leaveTrail(),
      escaped: (time) => services.announce(say("lab.creep.escaped", { time: number(time, { digits: 4 }), omega: number(omega(), { digits: 5 }) })),
    });
    this.#orbits = pickOrbits(chart("B"), services);
    pickStarts(chart("P"), services);
    this.#parameters = new Parameters(services);
    this.#thumb = createThumb(services, () => this.#cursor.range);
    this.#pair = new Pair(services);
    this.#compare = new Compare(services, () => this.#cursor.pin(this.#compare.places));

    const right = element("div", "right", ...(/** @type {const} */ (["1", "U", "P", "M", "W"])).map((id) => chart(id).place));
    const foot = element("div", "state", this.#flag, this.#sentence);
    const title = spoken(element("h1", "unseen"), "lab.title");
    this.#home.append(title, this.#toolbar(), this.#tabs(), left, right, this.#parameters.element, this.#thumb.element, foot, this.#pair.element, this.#compare.element);
    host.append(this.#home);

    for (const [id, { figure }] of charts) this.#watch(id, figure);
    store.subscribe(() => {
      this.#cursor.show();
      this.#cursor.pin(this.#compare.places);
      this.#hear();
      this.#askHiddenSoon();
    });
    store.subscribe((state, before) => shareWindows(store, before, charts));
    new ResizeObserver(() => this.#cursor.show()).observe(left);
    onLanguage(() => this.#tell());
    document.addEventListener("visibilitychange", () => this.#see());
    store.subscribe((state, before) => {
      if (state.view !== before.view) this.#see();
      if (state.preset !== before.preset) {
        this.#creep.stop();
        this.#cursor.forgetTrail();
      }
    });
    this.#cursor.pin(this.#compare.places);
    this.#begin();
    this.#register();
    this.#tell();
    this.#askHiddenSoon();
  }

  /** A link that gives a gear pair alone gives the point too. */
  #begin() {
    const { store } = this.#services;
    if (store.state.si !== null) this.#showPair(true);
  }

  /**
   * @param {string} id
   * @param {import("../figure/gear-figure.js").GearFigure} figure
   */
  #watch(id, figure) {
    figure.addEventListener("gear-paint", () => {
      const { shown } = figure;
      if (shown === null || shown === this.#drawn.get(id)) return;
      this.#drawn.set(id, shown);
      this.#figures.set(id, shown);
      this.#refused.delete(id);
      this.#later();
    });
    figure.addEventListener("gear-error", (event) => {
      const { code, message, parameter } = /** @type {CustomEvent<{code: string, message: string, parameter: string | null}>} */ (event).detail;
      // A place too small for a picture, on the way from one size to another, says nothing of the motion.
      if (code === "drawing") return;
      this.#refused.set(id, message);
      this.#figures.delete(id);
      this.#parameters.complain(parameter, message);
      this.#later();
    });
  }

  /** What the sentence needs is asked for although its chart may not be shown, as on a phone; but not from another view, where nobody reads it. */
  #askHidden() {
    if (this.#services.store.state.view !== "lab") return;
    for (const [id, { figure }] of this.#charts) {
      if (!SPOKEN.has(id) || figure.clientWidth > 0) continue;
      figure.data().then(
        (found) => {
          if (this.#figures.get(id) === found) return;
          this.#figures.set(id, found);
          this.#refused.delete(id);
          this.#later();
        },
        () => {},
      );
    }
  }

  #tell() {
    const { engine, store } = this.#services;
    if (this.#refused.size === 0) this.#parameters.complain(null, null);
    const refused = [...new Set(this.#refused.values())].join(" ");
    const found = this.#figures.size === 0 && refused !== "" ? "" : sentence(this.#figures);
    const said = [refused, found].filter((part) => part !== "").join(" ");
    this.#sentence.replaceChildren(marked(said));
    this.#sentence.classList.toggle("wrong", refused !== "");
    const facts = this.#figures.get("U")?.facts;
    const flag = contact(facts);
    this.#flag.dataset.contact = flag.kind;
    this.#flag.replaceChildren(element("span", "sign", flag.sign), ` ${flag.words}`);
    const size = facts?.maxU_p;
    const at = this.#figures.get("U")?.params.Omega;
    this.#cursor.place(size === undefined || at === undefined ? null : { omega: Number(at), size: Number(size) });
    this.#pair.know(this.#figures);
    this.#compare.know(this.#figures);
    this.#thumb.show();
    this.#hear();
    clearTimeout(this.#quiet);
    this.#quiet = setTimeout(() => {
      const all = `${said} ${flag.words.charAt(0).toLocaleUpperCase(language())}${flag.words.slice(1)}.`;
      if (all === this.#said || store.state.view !== "lab" || engine.figures.size === 0) return;
      this.#said = all;
      this.#services.announce(all);
    }, QUIET);
  }

  #hear() {
    const gears = this.#figures.get("1");
    this.#sound.play(gears?.motion ?? null, Number(gears?.params.Omega ?? 1), this.#pair.hertz);
  }

  #see() {
    const seen = !document.hidden && this.#services.store.state.view === "lab";
    this.#sound.seen = seen;
    if (!seen) this.#creep.stop();
  }

  #play = button("lab.play", () => this.#toggle());

  #toggle() {
    if (this.#creep.running) {
      this.#creep.stop();
    } else {
      this.#cursor.forgetTrail();
      this.#creep.start();
    }
  }

  #showPlaying() {
    this.#play.textContent = say(this.#creep.running ? "lab.stop" : "lab.play");
    this.#home.classList.toggle("creeping", this.#creep.running);
  }

  #pairButton = button("lab.pair.button", () => this.#showPair(!this.#pair.shown));

  /** @param {boolean} open */
  #showPair(open) {
    this.#pair.open(open);
    this.#pairButton.setAttribute("aria-expanded", String(open));
    if (open) this.#pair.element.scrollIntoView({ block: "nearest" });
  }

  #soundButton = button("lab.sound", () => this.#switchSound());
  #volume = named(element("input", ""), "aria-label", "lab.volume");

  #switchSound() {
    this.#sound.switch(!this.#sound.on);
    this.#soundButton.setAttribute("aria-pressed", String(this.#sound.on));
    this.#volume.hidden = !this.#sound.on;
    this.#hear();
  }

  #toolbar() {
    const direction = choice("lab.direction", [["-1", "lab.down"], ["1", "lab.up"]], (value) => {
      this.#creep.direction = value === "1" ? 1 : -1;
    });
    const pace = choice("lab.pace", [["slow", "lab.pace.slow"], ["normal", "lab.pace.normal"], ["fast", "lab.pace.fast"]], (value) => {
      this.#creep.pace = /** @type {keyof typeof import("./creep.js").PACES} */ (value);
    });
    pace.value = this.#creep.pace;
    this.#soundButton.setAttribute("aria-pressed", "false");
    Object.assign(this.#volume, { type: "range", min: "0", max: "1", step: "0.01", hidden: true });
    this.#volume.value = String(this.#sound.level);
    this.#volume.addEventListener("input", () => {
      this.#sound.level = Number(this.#volume.value);
    });
    this.#pairButton.setAttribute("aria-expanded", "false");
    onLanguage(() => this.#showPlaying());
    const bar = named(element("div", "toolbar"), "aria-label", "lab.tools");
    bar.setAttribute("role", "group");
    bar.append(
      element("span", "group", this.#play, direction, pace),
      element("span", "group", button("lab.pin", () => this.#compare.pin()), this.#pairButton),
      element("span", "group", this.#soundButton, this.#volume),
    );
    return bar;
  }

  /** Which one chart is shown where there is room for one only. */
  #tabs() {
    const tabs = named(element("div", "tabs"), "aria-label", "lab.charts");
    tabs.setAttribute("role", "group");
    /** @param {ChartId} chosen */
    const show = (chosen) => {
      this.#home.dataset.chart = chosen;
      for (const tab of tabs.querySelectorAll("button")) tab.setAttribute("aria-pressed", String(tab.dataset.chart === chosen));
      this.#cursor.show();
    };
    for (const id of CHARTS) {
      const tab = button(`lab.tab.${id}`, () => show(id));
      tab.dataset.chart = id;
      tabs.append(tab);
    }
    this.#home.dataset.chart = "T";
    for (const tab of tabs.querySelectorAll("button")) tab.setAttribute("aria-pressed", String(tab.dataset.chart === "T"));
    return tabs;
  }

  #register() {
    const { act, actions, store, presets } = this.#services;
    const possible = () => store.state.view === "lab";
    const byPreset = (/** @type {number} */ steps) => {
      const at = presets.indexOf(store.state.preset);
      act("act.preset", (state) => withPreset(state, presets[(at + steps + presets.length) % presets.length]));
    };
    actions.register(
      { id: "lab.play", word: "lab.do.play", key: "g", run: () => this.#toggle(), possible },
      { id: "lab.orbit", word: "lab.do.orbit", key: "o", run: () => this.#orbits.next(), possible },
      { id: "lab.pin", word: "lab.do.pin", key: "k", run: () => this.#compare.pin(), possible },
      { id: "lab.sound", word: "lab.do.sound", key: "w", run: () => this.#switchSound(), possible },
      { id: "lab.pair", word: "lab.do.pair", key: "i", run: () => this.#showPair(!this.#pair.shown), possible },
      { id: "lab.start", word: "lab.do.start", run: () => this.#parameters.open("start"), possible },
      { id: "lab.next", word: "lab.do.next", key: "n", run: () => byPreset(1), possible },
      { id: "lab.previous", word: "lab.do.previous", run: () => byPreset(-1), possible },
    );
  }
}
