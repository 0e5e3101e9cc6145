/**
 * `<gear-figure figure="11a" omega="1.65">`: one live figure. Until its first live drawing stands in the canvas, the
 * static drawing in its light DOM is shown in the very same place.
 *
 * Attributes: `figure`, parameters by name in any letter case, `controls="full|compact|none"`, `theme`, one of the module's
 * or `auto`; on the page itself `fit`, as large as its place, `files`, with a menu to take it away whatever its controls, and `veiled`, without what answers a question. Methods: `data()`, `map()`, `portrait()`, `tell()`, `reset()`, `play()`, `pause()`. Events, bubbling and composed: `gear-ready` when the
 * first complete figure is there, `gear-change` when one with other parameters is, `gear-error` with the error's fields,
 * `gear-pick` when a place of a plane is clicked or Enter pressed on a point, `gear-cursor` when a value is read off an axis;
 * and `gear-paint`, which does not bubble, after every drawing.
 *
 * @typedef {import("./services.js").Services} Services
 * @typedef {import("./services.js").Figure} Figure
 * @typedef {import("./services.js").FigureInfo} FigureInfo
 * @typedef {import("./services.js").FrameMap} FrameMap
 * @typedef {import("./services.js").Given} Given
 * @typedef {import("./services.js").GearErrorFields} GearErrorFields
 * @typedef {import("../controls/panel.js").Panel} Panel
 * @typedef {import("./services.js").Portrait} Portrait
 */

import { createPanel } from "../controls/panel.js";
import { spoken, spokenFigure } from "../words/engine.js";
import { decimalSign, onLanguage, say } from "../words/say.js";
import { withHandleAt } from "./ahead.js";
import { density, onAppearance, resolveTheme, wantsStill } from "./appearance.js";
import { Approach } from "./approach.js";
import { askInFrame, askNoMore, asksInFrame } from "./asking.js";
import { givenByAttributes } from "./attributes.js";
import { createButtons, wholeButton } from "./bar.js";
import { Computation } from "./computation.js";
import { fieldsOf, unknownFigure } from "./errors.js";
import { frameAt, pixelUnder } from "./frames.js";
import { Legend, hiddenSeries } from "./legend.js";
import { plain } from "./markup.js";
import { Clock } from "./motion.js";
import { PATIENCE, paperWords } from "./paper.js";
import { forgetPaint, requestPaint } from "./paint-queue.js";
import { claim, fit, fits, isPlaced, pixelsOf } from "./pixels.js";
import { Reach } from "./reach.js";
import { showRows } from "./rows.js";
import { services } from "./services.js";
import { furnish } from "./shadow.js";
import { Status } from "./status.js";
import { aspectOf, holdBack, hurry } from "./still.js";
import { hideTables, showTables } from "./table.js";
import { inTurn, isHeldBack } from "./turn.js";
import { FIRST, Turning } from "./turning.js";
import { veiled } from "./veil.js";
import { Voice } from "./voice.js";
import { sound } from "./windows.js";

/** What takes longer than this says that it is being computed, ms. */
const NOTICEABLE = 400;
/** How wide a picture is of a figure that has no place on the page at present, CSS pixels. */
const USUAL_WIDTH = 720;
/** How far out of sight a figure still counts as seen. */
const MARGIN = "300px";

const NOWHERE = "the figure is not in a document";

let anonymous = 0;

/** @type {Readonly<import("../state.js").FigureState>} */
const UNCHANGED = Object.freeze({ given: {}, windows: {}, hidden: [], view: null });

export class GearFigure extends HTMLElement {
  #parts = furnish(this.attachShadow({ mode: "open" }));
  #status = new Status(this.#parts.status);
  #voice = new Voice(this, this.#parts);
  /** Where the page's state keeps the parameters. */
  #key = "";
  /** @type {Services | null} */
  #services = null;
  /** @type {FigureInfo | null} */
  #info = null;
  /** As it is shown, in the language of the page. @type {Figure | null} */
  #figure = null;
  /** As it was computed. @type {Figure | null} */
  #computed = null;
  /** The same with its handle at a place that has no answer yet. @type {Figure | null} */
  #ahead = null;
  /** @type {FrameMap[]} */
  #maps = [];
  /** Names of the series that are switched off. @type {Set<string>} */
  #hidden = new Set();
  #reach;
  #legend;
  #whole = wholeButton(() => this.#reach.showWhole());
  /** @type {Panel | null} */
  #panel = null;
  /** @type {Turning | null} */
  #turning = null;
  /** @type {Clock | null} */
  #clock = null;
  #showPlaying = () => {};
  /** @type {(busy: boolean) => void} */
  #showBusy = () => {};
  /** @type {Computation | null} */
  #computation = null;
  #approach = new Approach();
  /** What the attributes gave: to this a reset returns. @type {Given} */
  #start = {};
  /** The parameter beside which an answer of the engine complains. @type {string | null} */
  #blamed = null;
  #questions = 0;
  /** Its question waits until it is shown. */
  #postponed = false;
  /** Whether the answer comes while it is asked for. */
  #asking = false;
  /** Whether it may be computed in the page's own thread. */
  #here = false;
  #announced = false;
  /** It had no place when it was to be drawn. */
  #missed = false;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #notice;
  /** @type {import("./asking.js").Asker} */
  #asker = {
    // A handle that goes ahead is answer enough for this frame, which then has time for others.
    here: () => this.#led() === null && this.#services?.engine.glances(this.#info?.id ?? "") === true,
    ask: (here) => this.#ask(false, here),
    lead: () => {
      if (this.#clock?.playing) this.#paintNow();
      else if (this.#computation?.busy && this.inSight) this.#leadHandle();
    },
  };
  #life = new AbortController();
  /** When its turn has come. @type {Promise<void>} */
  #begun = Promise.resolve();
  /** Whether it is on the screen or nearly so: by its place when it began, for the observer says so only after the next frame. */
  inSight = false;

  constructor() {
    super();
    this.#reach = new Reach(this.#parts.canvas, this.#parts, {
      figure: () => this.#figure,
      maps: () => this.#maps,
      shown: ({ name }) => !this.#hidden.has(name),
      windows: () => this.#shown.windows,
      look: (windows, gesture) => this.#services?.store.show(this.#key, { windows }, "act.window", gesture),
      read: (words) => this.#parts.readout.replaceChildren(words ?? ""),
      speak: (words) => this.#voice.speak(words),
      hasParameter: (name) => this.#info?.parameters.some((info) => info.name === name) ?? false,
      set: (name, value) => this.#set(name, value),
      hold: (held) => (held ? this.#services?.store.hold() : this.#services?.store.release()),
      pick: (detail) => this.#tell("gear-pick", { figure: this.#info?.id ?? "", ...detail }),
      inSight: () => this.inSight,
    });
    this.#legend = new Legend(this.#parts.legend, (hidden) => this.#services?.store.show(this.#key, { hidden }, "act.hidden"));
    // A context that was lost has forgotten everything.
    this.#parts.canvas.addEventListener("contextrestored", () => this.#repaint());
    this.#parts.data.addEventListener("toggle", () => this.#tabulate());
  }

  connectedCallback() {
    this.#life = new AbortController();
    const { signal } = this.#life;
    this.#key = this.id || `figure-${(anonymous += 1)}`;
    this.#reservePlace();
    const drawn = new Promise((resolve) => {
      for (const end of ["gear-paint", "gear-error"]) this.addEventListener(end, resolve, { once: true, signal });
    });
    let tellBegun = () => {};
    this.#begun = new Promise((resolve) => {
      tellBegun = resolve;
    });
    signal.addEventListener("abort", tellBegun);
    const sight = new IntersectionObserver((entries) => this.#see(entries[entries.length - 1].isIntersecting), {
      rootMargin: MARGIN,
    });
    sight.observe(this.#parts.stage);
    this.#approach.watch(this.#parts.stage, signal);
    const size = new ResizeObserver(() => this.#fit());
    size.observe(this.#parts.stage);
    const attributes = new MutationObserver((changes) => {
      if (changes.some(({ attributeName }) => attributeName === "figure")) this.#beginAnew();
      else if (changes.every(({ attributeName }) => attributeName === "veiled")) this.#translate();
      else this.#readAttributes();
    });
    attributes.observe(this, { attributes: true });
    addEventListener("beforeprint", () => this.#prepareForPaper(), { signal });
    signal.addEventListener("abort", this.#reach.link(this));
    signal.addEventListener("abort", () => {
      sight.disconnect();
      size.disconnect();
      attributes.disconnect();
    });
    services.then(
      (provided) =>
        inTurn({
          stands: () => this.#stands(),
          begin: (stands) => {
            this.inSight ||= stands;
            if (stands) this.#approach.arrive();
            this.#begin(provided, signal);
            tellBegun();
          },
          drawn,
          signal,
        }),
      (thrown) => {
        if (!signal.aborted) this.#complain(thrown);
      },
    );
  }

  disconnectedCallback() {
    this.#life.abort();
    this.#computation?.refuse(new Error(NOWHERE));
    this.#computation = null;
    // Whoever starts it later, for it was to start when the page is calm, finds none.
    this.#clock?.pause();
    this.#clock = null;
    clearTimeout(this.#notice);
    askNoMore(this.#asker);
    forgetPaint(this);
  }

  /**
   * What is shown, once it is complete: the object that `gear.figure()` returns. Rejects with a `GearError` where the
   * parameters allow no figure, and when the figure leaves the document.
   *
   * @returns {Promise<Figure>}
   */
  async data() {
    await services;
    while (this.isConnected && this.#computation === null) await this.#begun;
    if (askNoMore(this.#asker) || this.#postponed) this.#ask(true);
    const computation = this.#computation;
    if (computation === null) throw new Error(NOWHERE);
    const { answer } = computation;
    this.#approach.want(answer);
    try {
      return await answer;
    } catch (thrown) {
      // Where it has begun anew meanwhile, in another place or as another figure, that one is wanted.
      if (this.isConnected && computation !== this.#computation) return this.data();
      throw thrown;
    }
  }

  /**
   * The complete figure, and how it is seen: all that a picture of it or a file needs.
   *
   * @returns {Promise<Portrait>} rejected as `data()` is
   */
  async portrait() {
    const figure = await this.data();
    const { clientWidth, clientHeight } = this.#parts.stage;
    const placed = isPlaced(this.#parts.stage);
    const width = placed ? clientWidth : USUAL_WIDTH;
    const height = placed ? clientHeight : Math.round(USUAL_WIDTH / (this.#info?.aspect ?? 1));
    const shown = spokenFigure(figure);
    return { key: this.#key, figure, shown, given: this.#given, state: this.#shown, view: this.#viewOf(shown), theme: this.#theme, width, height };
  }

  /**
   * Says something about the figure beside it, until the reader goes on.
   *
   * @param {string} sentence
   * @param {boolean} [wrong]
   */
  tell(sentence, wrong = false) {
    if (this.hasAttribute("fit")) this.#voice.speak(sentence);
    this.#status.sayForNow(sentence, wrong, () => this.#figure?.notes.join(" ") ?? "");
  }

  /** What is drawn at present, complete or not; null before the first. */
  get shown() {
    return this.#figure;
  }

  /** The map between pixels and data of each frame of the last drawing; null before the first. */
  map() {
    return this.#maps.length === 0 ? null : { frames: this.#maps };
  }

  /** Takes the page's own parameters back, and looks at all of it from where it looked at first: one action. */
  reset() {
    this.#panel?.complain(null, null);
    this.#services?.store.reset(this.#key, this.#start);
    this.#panel?.show(this.#given);
  }

  play() {
    this.#clock?.play();
    this.#showPlaying();
  }

  pause() {
    this.#clock?.pause();
    this.#showPlaying();
  }

  /**
   * How it will be drawn when its first answer comes, as far as that can be known before: then the worker draws it too. Null for what is
   * asked later, while somebody turns, drags or reads.
   */
  #pictureAhead() {
    const { windows, hidden } = this.#shown;
    if (this.#services?.engine.draws !== true || this.#questions > 1 || this.#info?.animated !== false || this.hasAttribute("veiled") || hidden.length > 0 || Object.keys(windows).length > 0) return null;
    const { stage } = this.#parts;
    if (!isPlaced(stage)) return null;
    const view = { ...this.#turning?.direction, windows: {}, hidden: [] };
    return this.#wanted(view);
  }

  /**
   * How a picture is to be drawn at present.
   *
   * @param {import("../engine/gear-bifurcations.js").ViewOptions} view
   */
  #wanted(view) {
    const pixels = density();
    return { ...pixelsOf(this.#parts.stage, pixels), theme: this.#theme, density: pixels, view: { ...view, decimal: decimalSign() } };
  }

  /** Draws now what is known now. */
  paint() {
    const { stage, canvas } = this.#parts;
    if (this.#figure === null || this.#services === null) return;
    this.#missed = !isPlaced(stage);
    if (this.#missed) return;
    const { hidden } = this.#shown;
    const view = this.#viewOf(this.#figure);
    this.#hidden = new Set(view.hidden);
    const { width, height, ...options } = this.#wanted(view);
    fit(canvas, { width, height });
    try {
      const { frames, looks } = this.#services.engine.draw(this.#ahead ?? this.#figure, canvas, options);
      this.#maps = frames;
      this.#legend.show(this.#figure, looks, hidden);
    } catch (thrown) {
      this.#complain(thrown);
      return;
    }
    this.#whole.hidden = !this.#reach.zoomed;
    this.#reach.painted();
    this.dispatchEvent(new Event("gear-paint"));
    if (this.#isLive) return;
    stage.classList.add("live");
    this.#services.painted(this);
    this.#services.later(() => this.#buildPanel());
  }

  /** What the first drawing would wait for: its place, and the memory of its canvas, which a browser finds with the first stroke. */
  makeReady() {
    const { stage, canvas } = this.#parts;
    if (!isPlaced(stage)) return;
    fit(canvas, pixelsOf(stage, density()));
    claim(canvas);
  }

  /** Before anything is known of the figure, its static drawing says how much room it takes. */
  #reservePlace() {
    const picture = this.querySelector("img");
    const aspect = aspectOf(picture);
    if (aspect !== null) this.#parts.stage.style.setProperty("--aspect", String(aspect));
    this.#voice.standIn(picture?.alt ?? "");
    if (picture !== null) holdBack(picture, () => this.#isLive);
  }

  /** Whether a live drawing stands in its place. */
  get #isLive() {
    return this.#parts.stage.classList.contains("live");
  }

  /** What is not computed yet is computed now as far as it comes; what is not all of it says so. */
  #prepareForPaper() {
    if (this.clientWidth === 0) return;
    let whole = this.#figure !== null && this.#computation?.busy === false;
    if (!whole && this.#info !== null) {
      const found = this.#services?.engine.within(this.#info.id, this.#given, PATIENCE) ?? null;
      if (found !== null) {
        whole = found.done;
        this.#show(found.figure, false);
        forgetPaint(this);
        this.paint();
      }
    }
    const live = this.#isLive;
    if (!live) hurry(this.querySelector("img"));
    this.#parts.printed.textContent = paperWords(this.#given, this.#info, !live ? "still" : whole ? "whole" : "part");
  }

  #beginAnew() {
    this.disconnectedCallback();
    this.#services?.store.forget(this.#key);
    this.#panel = null;
    this.#parts.controls.replaceChildren();
    this.#parts.rows.replaceChildren();
    this.#parts.stage.classList.remove("live");
    this.#figure = null;
    this.#ahead = null;
    this.#maps = [];
    this.#announced = false;
    this.connectedCallback();
  }

  /**
   * @param {Services} provided
   * @param {AbortSignal} signal
   */
  #begin(provided, signal) {
    this.#services = provided;
    const { engine, store, priority } = provided;
    const id = this.getAttribute("figure") ?? "";
    this.#info = engine.figures.get(id) ?? null;
    this.#questions = 0;
    this.#computation = new Computation({
      heavy: this.#info?.heavy ?? false,
      compute: (given, { signal: ended, partial }) => {
        const coming = this.#approach.coming();
        const answer = engine.compute(id, given, {
          signal: ended,
          partial,
          priority: this.inSight ? priority.shown : priority.hidden,
          restarted: () => this.#status.say(say("figure.replaced")),
          picture: this.#pictureAhead(),
          held: coming?.over ?? null,
        });
        if (coming === null) this.#noticeLater();
        else this.#await(answer, coming, ended);
        return answer;
      },
      // The first picture of all figures is the workers': here they would come one after another.
      now: (given) => (this.#here && this.inSight ? engine.glance(id, given) : null),
      show: (figure, complete) => this.#show(figure, complete),
      fail: (error) => this.#complain(error),
    });
    if (this.#info === null) {
      const error = provided.error(unknownFigure(id, engine.figures.keys()));
      this.#computation.refuse(error);
      this.#complain(error);
      return;
    }
    this.#parts.stage.style.setProperty("--aspect", String(this.#info.aspect));
    this.#furnish(this.#info, provided);
    this.#readAttributes();
    signal.addEventListener("abort", onAppearance(() => this.#repaint()));
    signal.addEventListener("abort", onLanguage(() => this.#translate()));
    const unsubscribe = store.subscribe((state, before) => {
      const given = store.given(this.#key, state);
      if (!sameGiven(given, store.given(this.#key, before))) {
        this.#panel?.show(given);
        askInFrame(this.#asker);
      }
      const [now, then] = [store.shown(this.#key, state), store.shown(this.#key, before)];
      if (now !== then) this.#face(now.view);
      if (now !== then || state.theme !== before.theme || state.projector !== before.projector) this.#repaint();
    });
    signal.addEventListener("abort", unsubscribe);
  }

  /**
   * @param {FigureInfo} info
   * @param {Services} provided
   */
  #furnish(info, provided) {
    const { canvas, buttons } = this.#parts;
    if (info.animated) {
      // It ticks in a frame: to wait for the next one would show every second moment only. What is about to be answered in
      // this very frame is drawn then.
      this.#clock = new Clock(() => {
        if (!asksInFrame(this.#asker)) this.#paintNow();
      });
      this.#clock.seen = this.inSight;
      canvas.onkeydown = (event) => {
        if (event.key !== " ") return;
        event.preventDefault();
        if (this.#clock?.playing) this.pause();
        else this.play();
      };
    }
    if (info.turnable) {
      this.#turning ??= new Turning(canvas, {
        takes: (event) => (frameAt(this.#maps, pixelUnder(event, canvas))?.projection ?? null) !== null,
        turn: (view) => this.#services?.store.show(this.#key, { view: view === FIRST ? null : view }, "act.turn", "turn"),
      });
      this.#face(this.#shown.view);
    }
    this.#buildButtons(buttons);
    canvas.tabIndex = 0;
    canvas.setAttribute("role", "application");
    canvas.setAttribute("aria-describedby", `${this.#parts.described.id} ${this.#parts.keys.id}`);
    this.#speakAnew();
    if (info.animated && !wantsStill()) provided.later(() => this.play());
    this.#showPlaying();
  }

  /** @param {HTMLElement} place */
  #buildButtons(place) {
    const made = createButtons({
      clock: this.#clock,
      turning: this.#turning,
      reset: () => this.reset(),
      stop: () => this.#stop(),
      take: this.#offersFiles ? (button) => this.#services?.exports?.(this, button) : null,
    });
    this.#showPlaying = made.showPlaying;
    this.#showBusy = made.showBusy;
    place.replaceChildren(this.#whole, ...made.buttons);
    this.#showPlaying();
  }

  /** Says in the language of the page what does not come from the module. */
  #speakAnew() {
    this.#voice.introduce(this.#info, this.#figure);
    this.#whole.textContent = say("figure.whole");
    this.#repaint();
  }

  #buildPanel() {
    const extent = this.getAttribute("controls") ?? "full";
    if (this.#panel !== null || this.#info === null || extent === "none" || !this.isConnected) return;
    this.#panel = createPanel(this.#info.parameters, this.#given, extent === "compact" ? extent : "full", {
      change: (name, value) => this.#set(name, value),
      refuse: (problem) => this.#tell("gear-error", problem),
    });
    this.#parts.controls.replaceChildren(this.#panel.element);
  }

  /** Whether there is a menu to take the figure away: beside full controls, and on the page itself; but not of what has yet to be guessed. */
  get #offersFiles() {
    const offered = (this.getAttribute("controls") ?? "full") === "full" || this.hasAttribute("fit") || this.hasAttribute("files");
    return offered && !this.hasAttribute("veiled") && this.#services?.exports !== undefined;
  }

  /** A figure in the language of the page; while it is veiled, without what answers a question. @param {Figure} figure */
  #told(figure) {
    const told = spokenFigure(figure);
    return this.hasAttribute("veiled") ? veiled(told) : told;
  }

  /** What of the figure is seen. */
  get #shown() {
    return this.#services?.store.shown(this.#key) ?? UNCHANGED;
  }

  /** The same, and from where and when, as the module draws it. @param {Figure} figure */
  #viewOf(figure) {
    const { windows, hidden } = this.#shown;
    return {
      ...this.#turning?.direction,
      ...(this.#clock && { time: this.#clock.time }),
      windows: sound(windows, figure.axes),
      hidden: [...hiddenSeries(figure, hidden)],
    };
  }

  get #theme() {
    return resolveTheme(this.getAttribute("theme"), this.#services?.store.state ?? { theme: "auto", projector: false });
  }

  /** @param {import("./turning.js").Direction | null} view */
  #face(view) {
    if (this.#turning !== null) this.#turning.direction = view ?? FIRST;
  }

  /** The parameters that were given, by name; what is not among them is the figure's own. */
  get #given() {
    return this.#services?.store.given(this.#key) ?? {};
  }

  /**
   * @param {string} name
   * @param {number | string} value
   */
  #set(name, value) {
    this.#services?.store.give(this.#key, { ...this.#given, [name]: value });
  }

  #readAttributes() {
    if (this.#services === null || this.#info === null) return;
    const { engine, store } = this.#services;
    const { given, problems } = givenByAttributes(this.attributes, engine.vocabulary);
    this.#status.leftOut = problems.map(({ message }) => message).join(" ");
    if (this.#questions === 0 || !sameGiven(given, this.#start)) {
      this.#start = given;
      // What was given before the figure came, by the page's address, counts more than its attributes.
      if (this.#questions === 0) store.start(this.#key, given);
      else store.give(this.#key, given);
      this.#panel?.show(this.#given);
      if (this.#questions === 0) this.#ask();
    }
    this.#repaint(); // the theme may have changed
    for (const problem of problems) this.#complain(this.#services.error(problem));
  }

  /**
   * @param {boolean} [wanted]  Somebody waits for the answer, seen or not.
   * @param {boolean} [here]  It may be answered here.
   */
  #ask(wanted = false, here = false) {
    askNoMore(this.#asker);
    this.#questions += 1;
    // What has no place on the page, in a view that is not shown, must not take time from what has.
    this.#postponed = !wanted && !isHeldBack(this) && this.clientWidth === 0;
    if (this.#postponed) return;
    clearTimeout(this.#notice);
    this.#asking = true;
    this.#here = here && this.#questions > 1;
    this.#computation?.wish(this.#given);
    this.#asking = false;
  }

  /**
   * What is held at its first picture goes on when the reader comes or nobody does anything.
   *
   * @param {Promise<Figure>} answer
   * @param {{over: Promise<void>, callOff: () => void}} coming
   * @param {AbortSignal} ended
   */
  #await(answer, coming, ended) {
    let settled = false;
    const callOff = this.#services?.leisure?.(() => {
      this.#approach.hurry();
      return answer;
    });
    const end = () => {
      settled = true;
      coming.callOff();
      callOff?.();
    };
    answer.then(end, end);
    void coming.over.then(() => settled || ended.aborted || this.#noticeLater());
  }

  /** What takes long enough from now on says so. */
  #noticeLater() {
    clearTimeout(this.#notice);
    this.#notice = setTimeout(() => {
      this.#status.say(say("figure.computing"));
      this.#showBusy(true);
      if (this.#ahead !== null) this.#leadHandle(true);
    }, NOTICEABLE);
  }

  /** @param {boolean} [silent]  See `withHandleAt`. */
  #leadHandle(silent) {
    const led = this.#led(silent);
    if (led === null) return;
    this.#ahead = led;
    this.#paintNow();
  }

  /**
   * What is drawn with its handle where it stands by now; null where that changes nothing.
   *
   * @param {boolean} [silent]
   */
  #led(silent) {
    if (this.#figure === null) return null;
    const led = withHandleAt(this.#figure, (name) => this.#valueOf(name), silent);
    return led === this.#figure ? null : led;
  }

  /** What a parameter is at present; null for what is none of the figure's. @param {string} name */
  #valueOf(name) {
    const info = this.#info?.parameters.find((one) => one.name === name);
    const value = this.#given[name] ?? info?.default;
    return info !== undefined && typeof value === "number" ? value : null;
  }

  /**
   * @param {Figure} figure
   * @param {boolean} complete
   */
  #show(figure, complete) {
    const first = this.#figure === null;
    this.#computed = figure;
    this.#ahead = null;
    figure = this.#told(figure);
    this.#figure = figure;
    if (this.#clock) this.#clock.motion = figure.motion;
    if (figure.table !== null) showRows(this.#parts.rows, figure);
    // Nobody watches a figure out of sight fill in.
    if (complete || first || this.inSight) this.#repaint();
    if (this.#asking) {
      // This is the frame in which the parameters changed: the picture is in it.
      this.#paintNow();
    }
    if (!complete) return;
    clearTimeout(this.#notice);
    this.#showBusy(false);
    if (this.#blamed !== null) this.#panel?.complain(this.#blamed, null);
    this.#blamed = null;
    this.#voice.describe(figure);
    this.#status.say(figure.notes.join(" "));
    this.#tabulate();
    // Twenty figures that all speak when the page opens are noise; one that answers its reader is not.
    // Where it is one of several that answer together, whoever put them there speaks for all.
    const together = this.hasAttribute("fit");
    if (this.#questions > 1 && !together) this.#voice.speak(plain(figure.summary));
    if (!together) this.#parts.status.setAttribute("role", "status");
    this.#tell(this.#announced ? "gear-change" : "gear-ready", { figure: figure.id, params: figure.params });
    this.#announced = true;
  }

  /** @param {unknown} thrown */
  #complain(thrown) {
    clearTimeout(this.#notice);
    this.#showBusy(false);
    const fields = fieldsOf(thrown);
    if (fields.parameter !== null && this.#panel?.complain(fields.parameter, spoken(fields.message))) {
      this.#blamed = fields.parameter;
    }
    this.#status.say(this.#status.leftOut.includes(fields.message) ? "" : spoken(fields.message), true);
    // What is wrong must be mendable, drawing or not.
    this.#services?.later(() => this.#buildPanel());
    this.#tell("gear-error", fields);
  }

  /** The reader has seen enough: what there is stays, until something else is asked for. */
  #stop() {
    clearTimeout(this.#notice);
    this.#showBusy(false);
    this.#computation?.refuse(new Error(say("figure.stopped")));
    this.#status.say(say("figure.stopped"));
  }

  /** Says everything anew in another language. */
  #translate() {
    const summary = this.#parts.data.querySelector("summary");
    if (summary !== null) summary.textContent = say("figure.in-words");
    this.#buildButtons(this.#parts.buttons);
    if (this.#panel !== null) {
      this.#panel = null;
      this.#buildPanel();
    }
    if (this.#computed === null) return;
    this.#ahead = null;
    this.#figure = this.#told(this.#computed);
    if (this.#figure.table !== null) {
      this.#parts.rows.replaceChildren();
      showRows(this.#parts.rows, this.#figure);
    }
    this.#voice.describe(this.#figure);
    this.#voice.speak("");
    this.#speakAnew();
    const busy = this.#computation?.busy === true && !this.#approach.awaited;
    this.#showBusy(busy);
    this.#status.say(busy ? say("figure.computing") : this.#figure.notes.join(" "));
    this.#tabulate();
  }

  #tabulate() {
    const { data } = this.#parts;
    if (!data.open) hideTables(data);
    else if (this.#figure !== null) showTables(data, this.#figure);
  }

  /** @param {boolean} inSight */
  #see(inSight) {
    this.inSight = inSight;
    if (inSight && this.#postponed) this.#ask();
    if (inSight && this.#computation?.busy) this.#repaint();
    if (this.#clock) this.#clock.seen = inSight;
  }

  /** Whether it is on the screen by its place. */
  #stands() {
    if (isHeldBack(this)) return false;
    const { width, top, bottom } = this.getBoundingClientRect();
    return width > 0 && bottom > 0 && top < innerHeight;
  }

  /** An observer also speaks of a place that is as large as before, or by less than a pixel another. */
  #fit() {
    const { stage, canvas } = this.#parts;
    if (this.#missed || !fits(canvas, pixelsOf(stage, density()))) this.#repaint();
  }

  #paintNow() {
    this.paint();
    forgetPaint(this);
  }

  #repaint() {
    if (this.#figure !== null) requestPaint(this);
  }

  /**
   * @param {string} name
   * @param {object} detail
   */
  #tell(name, detail) {
    this.dispatchEvent(new CustomEvent(name, { detail, bubbles: true, composed: true }));
  }
}

/**
 * @param {Given} one
 * @param {Given} other
 */
function sameGiven(one, other) {
  const names = Object.keys(one);
  return names.length === Object.keys(other).length && names.every((name) => one[name] === other[name]);
}
