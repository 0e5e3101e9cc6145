/**
 * The classroom: lessons that ask for a prediction before they show what comes.
 *
 * @typedef {import("../shell/services.js").RoomServices} RoomServices
 * @typedef {import("./lesson.js").Lesson} Lesson
 * @typedef {import("./lesson.js").Fault} Fault
 */

import { button, element, named, spoken } from "../controls/dom.js";
import { INITIAL, withLesson, withStep } from "../state.js";
import { words } from "../words/en/classroom.js";
import { learn, onLanguage, say } from "../words/say.js";
import { Answers } from "./answers.js";
import { readLesson } from "./lesson.js";
import { LESSONS } from "./lessons/index.js";
import { Player } from "./player.js";
import { adopt } from "../style/adopt.js";
import { STYLE } from "./style.js";
import { setOf, wordsOf } from "./texts.js";

learn(words);

/** A lesson or a file of answers is small; what is larger is something else, bytes. */
const LARGEST = 1_000_000;

/**
 * @param {HTMLElement} host
 * @param {RoomServices} services
 */
export function start(host, services) {
  adopt(STYLE);
  new Classroom(host, services);
}

class Classroom {
  #services;
  #home = element("div", "classroom");
  #heading = element("h1", "");
  #answers = new Answers();
  /** Lessons that were opened from files. @type {Map<string, Lesson>} */
  #own = new Map();
  /** @type {{lesson: Lesson, player: Player} | null} */
  #playing = null;
  #message = element("p", "message");
  /** The point is being set to where a lesson's step begins, which shows nothing by itself. */
  #arriving = false;

  /**
   * @param {HTMLElement} host
   * @param {RoomServices} services
   */
  constructor(host, services) {
    this.#services = services;
    this.#message.setAttribute("role", "status");
    host.append(this.#home);
    services.store.subscribe((state, before) => {
      if (this.#arriving) return;
      if (state.lesson?.id !== before.lesson?.id || this.#playing === null) this.#show();
      else if (state !== before) this.#playing.player.show();
    });
    onLanguage(() => {
      if (this.#playing === null) this.#show();
      else {
        this.#entitle(this.#playing.lesson);
        this.#playing.player.again();
      }
    });
    this.#takeDrops();
    this.#register();
    this.#show();
  }

  /** @returns {Lesson[]} */
  get #lessons() {
    return [...LESSONS, ...this.#own.values()];
  }

  #show() {
    const { store } = this.#services;
    const wanted = store.state.lesson?.id ?? null;
    if (wanted !== null && this.#playing?.lesson.id === wanted) {
      this.#playing.player.show();
      return;
    }
    this.#playing?.player.close();
    this.#playing = null;
    const lesson = this.#lessons.find(({ id }) => id === wanted);
    if (lesson === undefined) {
      if (wanted !== null) this.#message.textContent = say("class.no-lesson", { name: wanted });
      this.#showList();
      return;
    }
    this.#message.textContent = "";
    this.#arrive(lesson);
    const player = new Player(this.#services, lesson, this.#answers, () => this.#leave());
    this.#playing = { lesson, player };
    this.#entitle(lesson);
    const leave = button("class.leave", () => this.#leave());
    this.#home.replaceChildren(element("div", "top", this.#heading, element("div", "buttons", leave, this.#screen(), this.#save())), this.#message, player.element);
  }

  /** @param {Lesson} lesson */
  #entitle(lesson) {
    this.#heading.replaceChildren(...setOf(lesson.title).childNodes);
  }

  /**
   * Whoever comes by a link is where the lesson's step begins, but for what the link itself gives.
   *
   * @param {Lesson} lesson
   */
  #arrive(lesson) {
    const { store } = this.#services;
    const { entries, at } = store.history;
    const { state } = store;
    if ((at > 0 && entries[at].name !== "act.link") || state.preset !== INITIAL.preset) return;
    const wanted = Math.min(state.lesson?.step ?? 0, lesson.steps.length - 1);
    const there = lesson.steps.slice(0, wanted + 1).reduce((before, { preset, point }, step) => withStep(before, step, preset, point), state);
    this.#arriving = true;
    store.update({ preset: there.preset, point: { ...there.point, ...state.point } });
    this.#arriving = false;
  }

  #showList() {
    const items = this.#lessons.map((lesson) => {
      const { given, right } = this.#answers.count(lesson.id);
      const begin = element("button", "begin", element("b", "", ...setOf(lesson.title).childNodes));
      begin.type = "button";
      begin.addEventListener("click", () => this.#begin(lesson));
      const item = element("li", "", begin, element("p", "", ...setOf(lesson.summary).childNodes));
      if (given > 0) item.append(element("p", "count", say("class.count", { given, right })));
      return item;
    });
    const open = element("input", "");
    Object.assign(open, { type: "file", accept: ".json,application/json" });
    open.addEventListener("change", () => {
      const [file] = open.files ?? [];
      if (file !== undefined) void this.#read(file);
      open.value = "";
    });
    const label = element("label", "file", spoken(element("span", ""), "class.open"), open);
    this.#home.replaceChildren(
      spoken(element("h1", ""), "class.title"),
      spoken(element("p", "lead"), "class.lead"),
      this.#message,
      named(element("ul", "lessons", ...items), "aria-label", "class.lessons"),
      element("div", "buttons", label, this.#save()),
      spoken(element("p", "help"), "class.teachers"),
    );
  }

  /** @param {Lesson} lesson */
  #begin(lesson) {
    const { preset, point } = lesson.steps[0];
    this.#services.act("class.act.begin", (state) => withLesson(state, lesson.id, preset, point));
    this.#home.querySelector("h2")?.focus();
  }

  #leave() {
    this.#services.act("class.act.leave", (state) => ({ ...state, lesson: null }));
    /** @type {HTMLElement | null} */ (this.#home.querySelector(".begin"))?.focus();
  }

  /** The whole screen for the classroom, where the browser allows it. */
  #screen() {
    const full = button("class.screen", () => {
      if (document.fullscreenElement === null) document.documentElement.requestFullscreen().catch(() => {});
      else document.exitFullscreen().catch(() => {});
    });
    full.hidden = !document.fullscreenEnabled;
    return full;
  }

  #save() {
    return button("class.save", () => this.#saveAnswers());
  }

  #saveAnswers() {
    if (this.#answers.empty) {
      this.#message.textContent = say("class.nothing");
      return;
    }
    const file = new Blob([this.#answers.write(location.href)], { type: "application/json" });
    const link = document.createElement("a");
    link.href = URL.createObjectURL(file);
    link.download = "gear-bifurcations-answers.json";
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
    this.#message.textContent = say("class.saved");
  }

  /** @param {File} file */
  async #read(file) {
    if (file.size > LARGEST) {
      this.#message.textContent = say("class.large", { name: file.name });
      return;
    }
    const text = await file.text();
    const count = this.#answers.read(text);
    if (count !== null) {
      this.#showList();
      this.#message.textContent = say("class.read-answers", { count });
      return;
    }
    const { engine } = this.#services;
    const { lesson, fault } = readLesson(text, { figures: [...engine.figures.keys()], parameters: new Set(engine.vocabulary.keys()) });
    if (lesson === null) {
      this.#message.textContent = sentenceOf(fault, file.name);
      return;
    }
    this.#own.set(lesson.id, lesson);
    this.#showList();
    this.#message.textContent = say("class.read-lesson", { name: wordsOf(lesson.title) });
  }

  /** A file dropped anywhere into the classroom is opened. */
  #takeDrops() {
    this.#home.addEventListener("dragover", (event) => event.preventDefault());
    this.#home.addEventListener("drop", (event) => {
      event.preventDefault();
      const [file] = event.dataTransfer?.files ?? [];
      if (file !== undefined) void this.#read(file);
    });
  }

  #register() {
    const { actions, store } = this.#services;
    const here = () => store.state.view === "class";
    const playing = () => here() && this.#playing !== null;
    actions.register(
      { id: "class.next", word: "class.next", possible: playing, run: () => /** @type {HTMLElement | null} */ (this.#home.querySelector("nav .buttons button:last-child, nav.buttons button:last-child"))?.click() },
      { id: "class.back", word: "class.back", possible: playing, run: () => this.#playing?.player.go(-1) },
      { id: "class.leave", word: "class.leave", possible: playing, run: () => this.#leave() },
      { id: "class.save", word: "class.save", possible: () => here() && !this.#answers.empty, run: () => this.#saveAnswers() },
      ...LESSONS.map((lesson) => ({
        id: `class.begin.${lesson.id}`,
        word: "class.begin",
        values: { name: wordsOf(lesson.title) },
        possible: here,
        run: () => this.#begin(lesson),
      })),
    );
  }
}

/**
 * @param {Fault} fault
 * @param {string} name  Of the file.
 */
function sentenceOf({ place, kind, given, allowed }, name) {
  const where = place === "" ? name : `${name}, ${place}`;
  return say(`class.fault.${kind}`, { where, given, allowed });
}
