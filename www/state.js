/**
 * The one state of the page: immutable, replaced as a whole. Every change is an action, a pure function from state to
 * state with a name; so each can be undone, said in words and written into the address.
 *
 * @typedef {"story" | "lab" | "class"} View
 * @typedef {"auto" | "light" | "dark" | "contrast"} ThemeChoice
 * @typedef {"en" | "de"} Language
 * @typedef {Readonly<Record<string, number | string>>} Given  Parameters that differ from what they would be, by name.
 * @typedef {Readonly<{x: readonly [number, number], y: readonly [number, number]}>} Window  What is seen of a plane.
 * @typedef {Readonly<{azimuth: number, elevation: number}>} Direction  From where a view in space is seen, radians.
 * @typedef {Readonly<{preset: string, point: Given}>} Pin  An operating point kept for comparison.
 * @typedef {Readonly<{id: string, step: number, locked: readonly string[]}>} Lesson
 */

/**
 * What the reader has changed about one figure.
 *
 * @typedef {object} FigureState
 * @property {Given} given  Parameters that differ from the figure's own.
 * @property {Readonly<Record<string, Window>>} windows  By the name of the frame; what is not named is seen whole.
 * @property {readonly string[]} hidden  Names of series that are switched off.
 * @property {Direction | null} view  Null: from where the figure is seen at first.
 */

/**
 * @typedef {object} State
 * @property {View} view
 * @property {string | null} at  The place in the story that was gone to, an element's id.
 * @property {string} preset  The figure whose parameters the operating point starts from.
 * @property {Given} point  What differs from the preset at the one operating point, which all of the laboratory shares.
 * @property {Readonly<Record<string, Readonly<FigureState>>>} figures  By the key of the figure's element; a figure
 *   about which nothing was changed is not among them.
 * @property {ThemeChoice} theme
 * @property {boolean} projector  Large type and thick lines, for a room.
 * @property {Language} language
 * @property {readonly Pin[]} pinned  At most two.
 * @property {Lesson | null} lesson
 * @property {Readonly<Record<string, number>> | null} si  The real gear pair, in SI units, that the point stands for.
 */

import { begin, moved, record, redone, replaced, settled, undone } from "./history.js";
import { presetGiven } from "./presets.js";
import { PAIRS } from "./values.js";

/** @type {readonly View[]} */
export const VIEWS = Object.freeze(["story", "lab", "class"]);
/** @type {readonly ThemeChoice[]} */
export const THEMES = Object.freeze(["auto", "light", "dark", "contrast"]);
/** @type {readonly Language[]} */
export const LANGUAGES = Object.freeze(["en", "de"]);
/** How many operating points can be pinned. */
export const PINS = 2;

/**
 * Figures of the story that show the one operating point, and which of its parameters: the first screen's chart moves it,
 * and its gears follow.
 *
 * @type {Readonly<Record<string, readonly string[]>>}
 */
export const SHARED = Object.freeze({ "fig-1": ["k0", "Omega"], "fig-T": ["m", "k", "zeta", "k0", "Omega"] });

/** @type {Given} */
const NOTHING = Object.freeze({});

/** @type {Readonly<FigureState>} */
export const UNTOUCHED = Object.freeze({ given: NOTHING, windows: Object.freeze({}), hidden: Object.freeze([]), view: null });

/** @type {Readonly<State>} */
export const INITIAL = Object.freeze({
  view: "story",
  at: null,
  preset: "T",
  point: NOTHING,
  figures: Object.freeze({}),
  theme: "auto",
  projector: false,
  language: "en",
  pinned: Object.freeze([]),
  lesson: null,
  si: null,
});

/**
 * What was changed about a figure.
 *
 * @param {State} state
 * @param {string} key
 */
export function figureOf(state, key) {
  return state.figures[key] ?? UNTOUCHED;
}

/**
 * @param {State} state
 * @param {string} key
 */
export function givenOf(state, key) {
  return figureOf(state, key).given;
}

/**
 * The state with something changed about a figure; one about which nothing is left to say is forgotten. The figures stand
 * in one order, however they came there: engines give records of the same names in the same order one common shape, and
 * a long history holds a thousand of them.
 *
 * @param {State} state
 * @param {string} key
 * @param {Partial<FigureState>} change
 * @returns {State}
 */
export function withFigure(state, key, change) {
  const { [key]: before = UNTOUCHED, ...others } = state.figures;
  const figure = { ...before, ...change };
  if (same(figure, before)) return state;
  if (same(figure, UNTOUCHED)) return { ...state, figures: others };
  const figures = Object.entries({ ...others, [key]: figure }).sort(([one], [other]) => (one < other ? -1 : 1));
  return { ...state, figures: Object.fromEntries(figures) };
}

/**
 * Every parameter that is given at the operating point: those of the preset and what differs from them.
 *
 * @param {{preset: string, point: Given}} state
 * @returns {Given}
 */
export function pointOf({ preset, point }) {
  return { ...presetGiven(preset), ...point };
}

/**
 * The state with parameters of the operating point set; what is as in the preset is not kept, `undefined` takes back.
 * Nothing but the point changes: a pair in SI units is led along by whoever shows it.
 *
 * @param {State} state
 * @param {Readonly<Record<string, number | string | undefined>>} values
 * @returns {State}
 */
export function withPoint(state, values) {
  const own = presetGiven(state.preset);
  /** @type {Record<string, number | string>} */
  const point = { ...state.point };
  for (const [name, value] of Object.entries(values)) {
    if (isLocked(state, name)) continue;
    if (value === undefined || value === own[name]) delete point[name];
    else point[name] = value;
  }
  return same(point, state.point) ? state : { ...state, point };
}

/**
 * @param {State} state
 * @param {string} preset
 * @returns {State}
 */
export function withPreset(state, preset) {
  return keepingLocked(state, { ...state, preset, point: NOTHING, si: null });
}

/**
 * Whether a parameter, or one that is set with it, is held fast by the lesson that is taken.
 *
 * @param {State} state
 * @param {string} name
 */
export function isLocked({ lesson }, name) {
  return lesson !== null && lesson.locked.some((locked) => [locked, ...both(locked)].some((one) => one === name || both(name).includes(one)));
}

/** The two parameters that a short form sets. @param {string} name @returns {readonly string[]} */
function both(name) {
  return PAIRS[/** @type {keyof typeof PAIRS} */ (name)] ?? [];
}

/**
 * What the lesson locks stays as it was, wherever else the point goes.
 *
 * @param {State} before
 * @param {State} after
 * @returns {State}
 */
function keepingLocked(before, after) {
  if (before.lesson === null || before.lesson.locked.length === 0) return after;
  const kept = Object.entries(pointOf(before)).filter(([name]) => isLocked(before, name));
  const own = presetGiven(after.preset);
  const free = Object.entries(after.point).filter(([name]) => !isLocked(before, name));
  return { ...after, point: Object.fromEntries([...free, ...kept.filter(([name, value]) => own[name] !== value)]) };
}

/**
 * The state at a step of the lesson that is taken. Where the step names no figure to start from, the point goes on from
 * where it is.
 *
 * @param {State} state
 * @param {number} step
 * @param {string} [preset]
 * @param {Readonly<Record<string, number | string | boolean>>} [point]
 * @returns {State}
 */
export function withStep(state, step, preset, point = {}) {
  if (state.lesson === null) return state;
  const from = preset === undefined ? state : { ...state, preset, point: NOTHING, si: null };
  const own = presetGiven(from.preset);
  const set = { ...from.point, .../** @type {Given} */ (point) };
  const differing = Object.fromEntries(Object.entries(set).filter(([name, value]) => own[name] !== value));
  return keepingLocked(state, { ...from, point: differing, lesson: { ...state.lesson, step } });
}

/**
 * The state at the begin of a lesson; what a link has locked stays locked.
 *
 * @param {State} state
 * @param {string} id
 * @param {string} [preset]
 * @param {Readonly<Record<string, number | string | boolean>>} [point]
 * @returns {State}
 */
export function withLesson(state, id, preset, point) {
  const locked = state.lesson?.locked ?? [];
  return withStep({ ...state, lesson: { id, step: 0, locked } }, 0, preset, point);
}

/**
 * @typedef {object} ActOptions
 * @property {string} [merge]  Actions of the same kind that follow each other closely, such as a slider's on its way, are
 *   one for undoing.
 */

export class Store {
  /** @type {import("./history.js").History<State>} */
  #history;
  /** @type {Set<(state: State, before: State) => void>} */
  #subscribers = new Set();
  /** Parameters of the operating point that a figure shows as its own. @type {Map<string, readonly string[]>} */
  #shared = new Map();
  #holding = false;
  #now;

  /**
   * @param {Partial<State>} [initial]
   * @param {() => number} [now]  Time in ms.
   */
  constructor(initial = {}, now = () => performance.now()) {
    this.#history = begin(frozen({ ...INITIAL, ...initial }));
    this.#now = now;
  }

  get state() {
    return this.#history.entries[this.#history.at].state;
  }

  /** What was done, and where in it we are. */
  get history() {
    return this.#history;
  }

  /**
   * @param {string} name  A key of the catalogue that says what is done.
   * @param {(state: State) => State} change
   * @param {ActOptions} [options]
   */
  act(name, change, { merge } = {}) {
    const before = this.state;
    const state = change(before);
    if (state === before || same(state, before)) return;
    const held = this.#holding;
    this.#move(record(this.#history, { name, state: frozen(state), merge: merge ?? null, time: this.#now() }, held));
  }

  /** Whether there is something to undo. */
  get undoable() {
    return this.#history.at > this.#history.first;
  }

  get redoable() {
    return this.#history.at < this.#history.entries.length - 1;
  }

  undo() {
    this.#move(undone(this.#history));
  }

  redo() {
    this.#move(redone(this.#history));
  }

  /**
   * Goes to a moment of the history.
   *
   * @param {number} at
   */
  goTo(at) {
    this.#move(moved(this.#history, at));
  }

  /** While something is held, such as a slider, all it does is one action. */
  hold() {
    this.release();
    this.#holding = true;
  }

  release() {
    this.#holding = false;
    this.#history = settled(this.#history);
  }

  /**
   * Changes the state without a trace: what the page does by itself, not its reader.
   *
   * @param {Partial<State>} change
   */
  update(change) {
    const { entries, at } = this.#history;
    const entry = { ...entries[at], state: frozen({ ...this.state, ...change }) };
    this.#move({ ...this.#history, entries: replaced(entries, at, entry) });
  }

  /**
   * Begins anew with another state; nothing before it can be returned to.
   *
   * @param {State} state
   */
  restart(state) {
    this.#move(begin(frozen(state)));
  }

  /**
   * @param {(state: State, before: State) => void} subscriber
   * @returns {() => void} ends the subscription
   */
  subscribe(subscriber) {
    this.#subscribers.add(subscriber);
    return () => this.#subscribers.delete(subscriber);
  }

  /**
   * Lets a figure show these parameters of the operating point, and its handle and sliders move it.
   *
   * @param {string} key
   * @param {readonly string[]} names
   */
  share(key, names) {
    this.#shared.set(key, names);
  }

  /**
   * What is given for a figure.
   *
   * @param {string} key
   * @param {State} [state]
   * @returns {Given}
   */
  given(key, state = this.state) {
    const own = givenOf(state, key);
    const names = this.#shared.get(key);
    if (names === undefined) return own;
    const point = pointOf(state);
    return { ...own, ...Object.fromEntries(names.filter((name) => name in point).map((name) => [name, point[name]])) };
  }

  /**
   * @param {string} key
   * @param {Given} given
   */
  give(key, given) {
    const names = this.#shared.get(key) ?? [];
    const own = Object.fromEntries(Object.entries(given).filter(([name]) => !names.includes(name)));
    const shared = Object.fromEntries(names.map((name) => [name, given[name]]));
    const before = this.given(key);
    const changed = Object.keys({ ...before, ...given }).filter((name) => before[name] !== given[name]);
    this.act("act.parameter", (state) => withPoint(withFigure(state, key, { given: own }), shared), {
      merge: this.#holding ? key : `${key} ${changed}`,
    });
  }

  /**
   * All that was changed about a figure.
   *
   * @param {string} key
   * @param {State} [state]
   */
  shown(key, state = this.state) {
    return figureOf(state, key);
  }

  /**
   * Changes what is seen of a figure, and from where.
   *
   * @param {string} key
   * @param {Partial<FigureState>} change
   * @param {string} action  A key of the catalogue.
   * @param {string} [merge]
   */
  show(key, change, action, merge) {
    this.act(action, (state) => withFigure(state, key, change), { merge: merge === undefined ? undefined : `${key} ${merge}` });
  }

  /**
   * Takes back all that was changed about a figure.
   *
   * @param {string} key
   * @param {Given} start  What its own attributes give.
   */
  reset(key, start) {
    const names = this.#shared.get(key) ?? [];
    const own = Object.fromEntries(Object.entries(start).filter(([name]) => !names.includes(name)));
    const shared = Object.fromEntries(names.map((name) => [name, start[name]]));
    this.act("act.reset", (state) => withPoint(withFigure(state, key, { ...UNTOUCHED, given: own }), shared));
  }

  /**
   * What a figure's own attributes give: it counts where nothing else was given, and is nobody's action.
   *
   * @param {string} key
   * @param {Given} given
   */
  start(key, given) {
    if (this.state.figures[key] === undefined && Object.keys(given).length > 0) {
      this.update({ figures: withFigure(this.state, key, { given }).figures });
    }
  }

  /**
   * Another figure takes this one's place.
   *
   * @param {string} key
   */
  forget(key) {
    this.update({ figures: withFigure(this.state, key, UNTOUCHED).figures });
  }

  /** @param {import("./history.js").History<State>} history */
  #move(history) {
    const before = this.state;
    this.#history = history;
    if (this.state === before) return;
    for (const subscriber of [...this.#subscribers]) subscriber(this.state, before);
  }
}

/**
 * @template T
 * @param {T} value
 * @returns {T}
 */
function frozen(value) {
  if (typeof value !== "object" || value === null || Object.isFrozen(value)) return value;
  for (const inner of Object.values(value)) frozen(inner);
  return Object.freeze(value);
}

/**
 * Whether two values of plain data say the same.
 *
 * @param {unknown} one
 * @param {unknown} other
 * @returns {boolean}
 */
export function same(one, other) {
  if (one === other) return true;
  if (typeof one !== "object" || typeof other !== "object" || one === null || other === null) return false;
  const [names, others] = [Object.keys(one), Object.keys(other)];
  const [left, right] = [/** @type {any} */ (one), /** @type {any} */ (other)];
  return names.length === others.length && names.every((name) => Object.hasOwn(right, name) && same(left[name], right[name]));
}
