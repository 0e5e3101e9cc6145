/**
 * The state as the part of the address after `#`, and back. What is written is readable, holds only what differs from the
 * preset, and names its version:
 *
 *     #lab&v=1&preset=11c&omega=1.7&k0=0.4&lab-T.window.chart=1.4..1.8,0..1
 *     #story&v=1&at=pulse&11a.omega=1.7&3.view=0.6,0.3&theme=dark
 *
 * Names are matched without regard to case. What cannot be applied is told, never guessed and never thrown; the rest
 * applies. docs/api.md has the whole vocabulary.
 *
 * @typedef {import("./state.js").State} State
 * @typedef {import("./state.js").FigureState} FigureState
 * @typedef {import("./engine/gear-bifurcations.js").ParameterInfo} ParameterInfo
 */

/**
 * What there is to be named in an address.
 *
 * @typedef {object} Known
 * @property {ReadonlyMap<string, ParameterInfo>} vocabulary
 * @property {(id: string) => boolean} isPlace  Whether the story has such a place.
 */

/**
 * Something that was not applied.
 *
 * @typedef {object} Problem
 * @property {"unknown" | "number" | "range" | "choice" | "form" | "newer" | "repeated"} kind
 * @property {string} name  As it was written.
 * @property {string} given
 * @property {string} allowed  In words and numbers; empty where nothing can be said.
 */

import { INITIAL, LANGUAGES, PINS, THEMES, UNTOUCHED, VIEWS, same } from "./state.js";
import { PRESETS, presetGiven } from "./presets.js";

export const VERSION = 1;

const NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i;
const FRAME = /^[a-z0-9_-]{1,40}$/i;
/** Longer names are not read to the end in a sentence. */
const SHOWN = 60;

/** Measures of a real gear pair, as in `fromPhysical`. */
export const PHYSICAL = Object.freeze(
  ("M_p M_g I_p I_g r_p r_g K K_amplitude K_p K_g K_p3 K_g3 C C_p C_g b E T_p T_g T_p_amplitude T_g_amplitude " +
    "omega_p omega_g teeth_p teeth_g rpm_p").split(" "),
);

/** Figures in the story are keyed `fig-11a`, those of the other rooms `lab-T` and `class-T`. */
const ROOMS = ["fig-", "lab-", "class-"];
/** @type {ReadonlyMap<string, string>} */
const KEYS = new Map(
  ROOMS.flatMap((room) => PRESETS.map((id) => [`${room === "fig-" ? "" : room}${id}`.toLowerCase(), `${room}${id}`])),
);

/**
 * @param {State} state
 * @returns {string} without the `#`; empty where there is nothing to say
 */
export function write(state) {
  /** @type {string[]} */
  const parts = [];
  const put = (/** @type {string} */ name, /** @type {string | number} */ value) => parts.push(`${name}=${escaped(value)}`);
  const putAll = (/** @type {string} */ before, /** @type {Record<string, string | number>} */ values) => {
    for (const [name, value] of Object.entries(values)) put(`${before}${name.toLowerCase()}`, value);
  };
  if (state.at !== null) put("at", state.at);
  if (state.preset !== INITIAL.preset) put("preset", state.preset);
  putAll("", state.point);
  for (const [name, value] of Object.entries(state.si ?? {})) put(`si.${name}`, value);
  for (const [element, figure] of Object.entries(state.figures)) {
    const key = element.replace(/^fig-/, "");
    if (!KEYS.has(key.toLowerCase())) continue;
    putAll(`${key}.`, figure.given);
    for (const [frame, { x, y }] of Object.entries(figure.windows)) put(`${key}.window.${frame}`, `${x.join("..")},${y.join("..")}`);
    if (figure.hidden.length > 0) parts.push(`${key}.hidden=${figure.hidden.map(escapedWhole).join(",")}`);
    if (figure.view !== null) put(`${key}.view`, `${figure.view.azimuth},${figure.view.elevation}`);
  }
  state.pinned.forEach((pin, index) => {
    put(`pin${index + 1}.preset`, pin.preset);
    putAll(`pin${index + 1}.`, pin.point);
  });
  if (state.lesson !== null) {
    put("lesson", state.lesson.id);
    if (state.lesson.step !== 0) put("step", state.lesson.step);
    if (state.lesson.locked.length > 0) put("lock", state.lesson.locked.join(",").toLowerCase());
  }
  if (state.theme !== INITIAL.theme) put("theme", state.theme);
  if (state.projector) put("projector", "on");
  if (state.language !== INITIAL.language) put("language", state.language);
  if (parts.length === 0) return state.view === INITIAL.view ? "" : state.view;
  return [state.view, `v=${VERSION}`, ...parts].join("&");
}

/**
 * What an address says. What it does not name is as at first, but for theme, projector and language, which are the
 * reader's own.
 *
 * @param {string} text  What stands after the `#`.
 * @param {Known | null} known  Null before the engine has told what there is: then only words that need no numbers are read.
 * @returns {{state: Partial<State>, problems: Problem[]}}
 */
export function parse(text, known) {
  const reading = new Reading(known);
  text.split("&").forEach((part, index) => {
    if (part === "") return;
    const cut = part.indexOf("=");
    if (cut < 0) reading.word(unescaped(part), index === 0);
    else reading.assign(unescaped(part.slice(0, cut)), part.slice(cut + 1));
  });
  return reading.result();
}

class Reading {
  #known;
  /** @type {Map<string, string>} */
  #names;
  /** @type {Set<string>} */
  #seen = new Set();
  /** @type {Problem[]} */
  #problems = [];
  /** @type {Partial<State>} */
  #state = {};
  /** @type {Record<string, number | string>} */
  #point = {};
  /** @type {Record<string, {given: Record<string, number | string>, windows: FigureState["windows"], hidden: readonly string[], view: FigureState["view"]}>} */
  #figures = {};
  /** @type {({preset: string, point: Record<string, number | string>} | undefined)[]} */
  #pins = [];
  /** @type {Record<string, number>} */
  #si = {};
  /** @type {{id: string | null, step: number, locked: string[]}} */
  #lesson = { id: null, step: 0, locked: [] };

  /** @param {Known | null} known */
  constructor(known) {
    this.#known = known;
    this.#names = new Map([...(known?.vocabulary.keys() ?? [])].map((name) => [name.toLowerCase(), name]));
  }

  /** @returns {{state: Partial<State>, problems: Problem[]}} */
  result() {
    const lesson = this.#lesson;
    const { preset = INITIAL.preset } = this.#state;
    return {
      state: {
        ...this.#state,
        point: differing(this.#point, preset),
        figures: Object.fromEntries(Object.entries(this.#figures).filter(([, figure]) => !same(figure, UNTOUCHED))),
        pinned: this.#pins.flatMap((pin) => (pin === undefined ? [] : [{ preset: pin.preset, point: differing(pin.point, pin.preset) }])),
        si: Object.keys(this.#si).length > 0 ? this.#si : null,
        lesson: lesson.id === null ? null : { id: lesson.id, step: lesson.step, locked: lesson.locked },
      },
      problems: this.#problems,
    };
  }

  /**
   * A word without a value: which way to read the page, or a place in the story.
   *
   * @param {string} word
   * @param {boolean} first
   */
  word(word, first) {
    const view = VIEWS.find((name) => name === word.toLowerCase());
    if (first && view !== undefined) this.#state.view = view;
    else if (first && (this.#known === null || this.#known.isPlace(word))) this.#state.at = word;
    else this.#refuse("unknown", word, "", "");
  }

  /**
   * @param {string} name
   * @param {string} raw  The value as it was written.
   */
  assign(name, raw) {
    const key = name.toLowerCase();
    const value = unescaped(raw).trim();
    if (this.#seen.has(key)) {
      this.#refuse("repeated", name, value, "");
      return;
    }
    this.#seen.add(key);
    const simple = SIMPLE[key];
    if (simple !== undefined) {
      simple(this, name, value);
      return;
    }
    if (this.#known === null) return;
    const [head, second, ...rest] = key.split(".");
    const written = name.split(".");
    const pin = /^pin(\d)$/.exec(head);
    const figure = KEYS.get(head);
    if (second === undefined) this.#parameter(this.#point, name, key, value);
    else if (head === "si") this.#physical(name, written.slice(1).join("."), value);
    else if (pin !== null && rest.length === 0) this.#pin(Number(pin[1]), name, second, value);
    else if (figure === undefined) this.#refuse("unknown", name, value, "");
    else if (second === "window" && rest.length === 1) this.#window(figure, name, written[2], value);
    else if (second === "hidden" && rest.length === 0) this.#figure(figure).hidden = raw.split(",").filter(Boolean).map(unescaped);
    else if (second === "view" && rest.length === 0) this.#view(figure, name, value);
    else this.#parameter(this.#figure(figure).given, name, key.slice(head.length + 1), value);
  }

  /**
   * One of a few words.
   *
   * @template {string} T
   * @param {readonly T[]} choices
   * @param {string} name
   * @param {string} value
   * @returns {T | undefined}
   */
  choice(choices, name, value) {
    const chosen = choices.find((choice) => choice.toLowerCase() === value.toLowerCase());
    if (chosen === undefined) this.#refuse("choice", name, value, choices.join(", "));
    return chosen;
  }

  /** @param {Partial<State>} change */
  set(change) {
    Object.assign(this.#state, change);
  }

  /**
   * @param {string} name
   * @param {string} value
   */
  version(name, value) {
    const version = this.number(name, value, 1, Infinity);
    if (version !== undefined && version > VERSION) this.#refuse("newer", name, value, String(VERSION));
  }

  /**
   * @param {string} name
   * @param {string} value
   */
  place(name, value) {
    if (this.#known === null || this.#known.isPlace(value)) this.#state.at = value;
    else this.#refuse("unknown", `${name}=${value}`, "", "");
  }

  /**
   * @param {string} name
   * @param {string} value
   */
  lesson(name, value) {
    if (/^[a-z0-9-]{1,40}$/i.test(value)) this.#lesson.id = value.toLowerCase();
    else this.#refuse("form", name, value, "");
  }

  /**
   * @param {string} name
   * @param {string} value
   */
  step(name, value) {
    const step = this.number(name, value, 0, 1000);
    if (step !== undefined) this.#lesson.step = Math.floor(step);
  }

  /**
   * @param {string} name
   * @param {string} value
   */
  lock(name, value) {
    if (this.#known === null) return;
    for (const given of value.split(",").map((word) => word.trim()).filter(Boolean)) {
      const parameter = this.#names.get(given.toLowerCase());
      if (parameter === undefined) this.#refuse("unknown", `${name}=${given}`, "", "");
      else this.#lesson.locked.push(parameter);
    }
  }

  /**
   * @param {string} name
   * @param {string} text
   * @param {number} low
   * @param {number} high
   * @returns {number | undefined}
   */
  number(name, text, low, high) {
    const value = numberOf(text);
    const allowed = high === Infinity ? "" : `${low} .. ${high}`;
    if (!Number.isFinite(value)) this.#refuse("number", name, text, allowed);
    else if (value < low || value > high) this.#refuse("range", name, text, allowed);
    else return value;
    return undefined;
  }

  /**
   * @param {Record<string, number | string>} into
   * @param {string} name  As it was written.
   * @param {string} key  The parameter, in lower case.
   * @param {string} value
   */
  #parameter(into, name, key, value) {
    const parameter = this.#names.get(key);
    const info = parameter === undefined ? undefined : this.#known?.vocabulary.get(parameter);
    if (info === undefined) {
      this.#refuse("unknown", name, value, "");
      return;
    }
    const judged = "choices" in info ? this.choice(info.choices, name, value) : this.number(name, value, info.low, info.high);
    if (judged !== undefined) into[info.name] = judged;
  }

  /**
   * @param {string} name
   * @param {string} measure
   * @param {string} value
   */
  #physical(name, measure, value) {
    const known = PHYSICAL.find((one) => one.toLowerCase() === measure.toLowerCase());
    if (known === undefined) {
      this.#refuse("unknown", name, value, "");
      return;
    }
    const number = this.number(name, value, -Number.MAX_VALUE, Number.MAX_VALUE);
    if (number !== undefined) this.#si[known] = number;
  }

  /**
   * @param {number} place
   * @param {string} name
   * @param {string} key
   * @param {string} value
   */
  #pin(place, name, key, value) {
    if (place < 1 || place > PINS) {
      this.#refuse("unknown", name, value, "");
      return;
    }
    const pin = (this.#pins[place - 1] ??= { preset: INITIAL.preset, point: {} });
    if (key === "preset") pin.preset = this.choice(PRESETS, name, value) ?? pin.preset;
    else this.#parameter(pin.point, name, key, value);
  }

  /** @param {string} key */
  #figure(key) {
    return (this.#figures[key] ??= { ...UNTOUCHED, given: {} });
  }

  /**
   * @param {string} key
   * @param {string} name
   * @param {string} frame
   * @param {string} value
   */
  #window(key, name, frame, value) {
    const ends = value.split(",").map((axis) => axis.split("..").map(numberOf));
    const [x, y] = ends;
    const fits = ends.length === 2 && ends.every(([low, high, more]) => more === undefined && Number.isFinite(low) && low < high && high < Infinity);
    if (fits && FRAME.test(frame)) {
      const figure = this.#figure(key);
      figure.windows = { ...figure.windows, [frame]: { x: [x[0], x[1]], y: [y[0], y[1]] } };
    } else {
      this.#refuse("form", name, value, "1.4..1.8,0..1");
    }
  }

  /**
   * @param {string} key
   * @param {string} name
   * @param {string} value
   */
  #view(key, name, value) {
    const [azimuth, elevation, more] = value.split(",").map(numberOf);
    const fits = more === undefined && Math.abs(azimuth) <= 1000 && Math.abs(elevation) <= Math.PI / 2;
    if (fits) this.#figure(key).view = { azimuth, elevation };
    else this.#refuse("form", name, value, "0.6,0.3");
  }

  /**
   * @param {Problem["kind"]} kind
   * @param {string} name
   * @param {string} given
   * @param {string} allowed
   */
  #refuse(kind, name, given, allowed) {
    this.#problems.push({ kind, name: shortened(name), given: shortened(given), allowed });
  }
}

/** What is not a parameter. @type {Record<string, ((reading: Reading, name: string, value: string) => void) | undefined>} */
const SIMPLE = Object.assign(Object.create(null), {
  v: (/** @type {Reading} */ reading, /** @type {string} */ name, /** @type {string} */ value) => reading.version(name, value),
  at: (/** @type {Reading} */ reading, /** @type {string} */ name, /** @type {string} */ value) => reading.place(name, value),
  preset(/** @type {Reading} */ reading, /** @type {string} */ name, /** @type {string} */ value) {
    const preset = reading.choice(PRESETS, name, value);
    if (preset !== undefined) reading.set({ preset });
  },
  theme(/** @type {Reading} */ reading, /** @type {string} */ name, /** @type {string} */ value) {
    const theme = reading.choice(THEMES, name, value);
    if (theme !== undefined) reading.set({ theme });
  },
  language(/** @type {Reading} */ reading, /** @type {string} */ name, /** @type {string} */ value) {
    const language = reading.choice(LANGUAGES, name, value);
    if (language !== undefined) reading.set({ language });
  },
  projector(/** @type {Reading} */ reading, /** @type {string} */ name, /** @type {string} */ value) {
    const on = reading.choice(/** @type {const} */ (["on", "off"]), name, value);
    if (on !== undefined) reading.set({ projector: on === "on" });
  },
  lesson: (/** @type {Reading} */ reading, /** @type {string} */ name, /** @type {string} */ value) => reading.lesson(name, value),
  step: (/** @type {Reading} */ reading, /** @type {string} */ name, /** @type {string} */ value) => reading.step(name, value),
  lock: (/** @type {Reading} */ reading, /** @type {string} */ name, /** @type {string} */ value) => reading.lock(name, value),
});

/** The number that a text says; NaN where it says none. A zero has no sign. @param {string} text */
function numberOf(text) {
  return NUMBER.test(text) ? Number(text) + 0 : NaN;
}

/**
 * What of a point is not as in its preset.
 *
 * @param {import("./state.js").Given} point
 * @param {string} preset
 * @returns {import("./state.js").Given}
 */
function differing(point, preset) {
  const own = presetGiven(preset);
  return Object.fromEntries(Object.entries(point).filter(([name, value]) => own[name] !== value));
}

/** Signs that are readable in an address stay; a space is a plus. @param {string | number} value */
function escaped(value) {
  return encodeURIComponent(String(value)).replaceAll("%20", "+").replaceAll("%2C", ",");
}

/** A text in a list: its own commas are none of the list's. @param {string} text */
function escapedWhole(text) {
  return encodeURIComponent(text).replaceAll("%20", "+");
}

/** @param {string} text */
function unescaped(text) {
  const spaced = text.replaceAll("+", " ");
  try {
    return decodeURIComponent(spaced);
  } catch {
    return spaced;
  }
}

/** @param {string} text */
function shortened(text) {
  return text.length > SHOWN ? `${text.slice(0, SHOWN)}…` : text;
}
