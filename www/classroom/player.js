/**
 * A lesson being taken: a step at a time; where it asks, what comes is shown only after an answer.
 *
 * @typedef {import("../shell/services.js").RoomServices} RoomServices
 * @typedef {import("./lesson.js").Lesson} Lesson
 * @typedef {import("./lesson.js").Step} Step
 * @typedef {import("./lesson.js").Question} Question
 * @typedef {import("./answers.js").Answers} Answers
 * @typedef {import("./judge.js").Answer} Answer
 * @typedef {import("../controls/control.js").Control} Control
 */

import { createControl } from "../controls/control.js";
import { button, element, spoken } from "../controls/dom.js";
import { setting, valueOf } from "../values.js";
import { elements } from "../figure/markup.js";
import { pointOf, withPoint, withStep } from "../state.js";
import { spoken as inLanguage } from "../words/engine.js";
import { language, number, say, unlocalized } from "../words/say.js";
import { judgeAnswer } from "./judge.js";
import { parametersOf, worldAt } from "./point.js";
import { setOf, wordsOf } from "./texts.js";

/** Digits of a computed number in a sentence, where the lesson does not say. */
const DIGITS = 4;

export class Player {
  element = element("article", "lesson");
  #services;
  #lesson;
  #answers;
  #leave;
  #text = element("div", "words");
  #charts = element("div", "charts");
  #controls = element("div", "open");
  /** @type {Map<string, Control>} */
  #shown = new Map();
  /** Ends what the present step still computes. */
  #life = new AbortController();
  /** What is shown at present, so that nothing is built twice. */
  #at = "";
  /** The language of the headings. */
  #language = "";

  /**
   * @param {RoomServices} services
   * @param {Lesson} lesson
   * @param {Answers} answers
   * @param {() => void} leave
   */
  constructor(services, lesson, answers, leave) {
    this.#services = services;
    this.#lesson = lesson;
    this.#answers = answers;
    this.#leave = leave;
    this.element.append(this.#text, element("div", "side", this.#charts, this.#controls));
    this.show();
  }

  /** @returns {Step} */
  get #step() {
    return this.#lesson.steps[this.#number];
  }

  get #number() {
    const wanted = this.#services.store.state.lesson?.step ?? 0;
    return Math.min(Math.max(0, wanted), this.#lesson.steps.length - 1);
  }

  get #answered() {
    return this.#answers.of(this.#lesson.id, this.#number) !== null;
  }

  /** Shows the step as state and answers have it. */
  show() {
    const { store } = this.#services;
    const open = this.#answered || this.#step.question === undefined;
    const at = `${this.#number} ${open}`;
    if (at !== this.#at) {
      this.#at = at;
      this.#life.abort();
      this.#life = new AbortController();
      this.#showCharts(open);
      this.#showControls();
      void this.#showText();
    }
    const given = pointOf(store.state);
    for (const [name, control] of this.#shown) control.show(valueOf(given, this.#services.engine.vocabulary, name));
  }

  /** Another language: everything anew. */
  again() {
    this.#at = "";
    this.show();
  }

  close() {
    this.#life.abort();
  }

  /** @param {number} by */
  go(by) {
    const to = this.#number + by;
    if (to < 0 || to >= this.#lesson.steps.length) return;
    const { preset, point } = this.#lesson.steps[to];
    this.#services.act("class.act.step", (state) => withStep(state, to, preset, point));
    this.#text.querySelector("h2")?.focus();
    this.#services.announce(wordsOf(this.#lesson.steps[to].title));
  }

  /** @param {boolean} open  Whether what the question hides may be seen. */
  #showCharts(open) {
    const { engine, store } = this.#services;
    const ids = open ? (this.#step.reveal?.figures ?? this.#step.figures) : this.#step.figures;
    const present = new Map([...this.#charts.children].map((child) => [/** @type {HTMLElement} */ (child).dataset.figure, child]));
    const wanted = ids.map((id) => {
      const kept = present.get(id);
      if (kept !== undefined && language() === this.#language) {
        kept.querySelector("gear-figure")?.toggleAttribute("veiled", !open);
        return kept;
      }
      const figure = document.createElement("gear-figure");
      figure.id = `class-${id}`;
      figure.setAttribute("figure", id);
      figure.setAttribute("controls", "none");
      figure.setAttribute("files", "");
      figure.toggleAttribute("veiled", !open);
      store.share(figure.id, parametersOf(engine, id));
      const heading = element("h3", "", ...elements(inLanguage(engine.figures.get(id)?.title ?? "")).childNodes);
      heading.id = `class-${id}-name`;
      const place = element("section", "chart", heading, figure);
      place.dataset.figure = id;
      place.setAttribute("aria-labelledby", heading.id);
      return place;
    });
    this.#language = language();
    if (wanted.length !== this.#charts.children.length || wanted.some((place, index) => this.#charts.children[index] !== place)) {
      this.#charts.replaceChildren(...wanted);
    }
  }

  #showControls() {
    const { engine, store, act } = this.#services;
    const locked = store.state.lesson?.locked ?? [];
    this.#shown.clear();
    const made = (this.#step.open ?? []).flatMap((name) => {
      const info = engine.vocabulary.get(name);
      if (info === undefined || locked.includes(name)) return [];
      const control = createControl(info, valueOf(pointOf(store.state), engine.vocabulary, name), {
        change: (to) => act("act.parameter", (state) => withPoint(state, setting(name, to)), { merge: `class ${name}` }),
        refuse: () => {},
      });
      this.#shown.set(name, control);
      return [control.element];
    });
    this.#controls.replaceChildren(...made);
    if (locked.length > 0) this.#controls.append(element("p", "locked", say("class.locked", { names: locked.join(", ") })));
  }

  async #showText() {
    const step = this.#step;
    const heading = element("h2", "", ...setOf(step.title).childNodes);
    heading.tabIndex = -1;
    const progress = element("p", "progress", say("class.progress", { step: this.#number + 1, steps: this.#lesson.steps.length }));
    const texts = [step.text].flat().map((text) => element("p", "", ...setOf(/** @type {import("./lesson.js").Text} */ (text)).childNodes));
    /** @type {HTMLElement[]} */
    const parts = [progress, heading, ...texts];
    const given = this.#answers.of(this.#lesson.id, this.#number);
    if (step.question !== undefined && given === null) parts.push(this.#form(step.question));
    else if (step.question !== undefined && given !== null) parts.push(this.#verdict(step.question, given));
    const revealed = element("div", "reveal");
    parts.push(revealed, this.#steps());
    const focused = this.#text.contains(document.activeElement);
    this.#text.replaceChildren(...parts);
    if (focused) heading.focus();
    if (step.reveal !== undefined && (step.question === undefined || given !== null)) await this.#reveal(revealed, step);
  }

  /**
   * What was held back, with the numbers that the figures find now.
   *
   * @param {HTMLElement} place
   * @param {Step} step
   */
  async #reveal(place, { reveal }) {
    if (reveal === undefined) return;
    const { signal } = this.#life;
    const world = worldAt(this.#services, pointOf(this.#services.store.state), signal);
    /** @type {Record<string, string>} */
    const values = {};
    try {
      for (const [name, { figure, fact, digits = DIGITS }] of Object.entries(reveal.values ?? {})) {
        const value = await world.fact(figure, fact);
        values[name] = typeof value === "number" ? number(value, { digits }) : value === undefined ? "–" : String(value);
      }
    } catch (thrown) {
      if (signal.aborted) return;
      place.replaceChildren(element("p", "", thrown instanceof Error ? thrown.message : String(thrown)));
      return;
    }
    if (signal.aborted) return;
    place.replaceChildren(element("p", "", ...setOf(reveal.text, values).childNodes));
  }

  /** @param {Question} question */
  #form(question) {
    const form = element("form", "question");
    const ask = element("legend", "", ...setOf(question.ask).childNodes);
    const fields = element("fieldset", "", ask);
    const complaint = element("p", "complaint");
    complaint.setAttribute("role", "alert");
    /** @type {() => Answer | undefined} */
    let read = () => "here";
    if (question.kind === "choice") {
      question.options.forEach(({ text }, index) => {
        const input = element("input", "");
        Object.assign(input, { type: "radio", name: "answer", value: String(index) });
        fields.append(element("label", "", input, element("span", "", ...setOf(text).childNodes)));
      });
      read = () => {
        const chosen = form.querySelector("input:checked");
        return chosen instanceof HTMLInputElement ? Number(chosen.value) : undefined;
      };
    } else if (question.kind === "number") {
      const input = element("input", "");
      Object.assign(input, { type: "text", inputMode: "decimal", autocomplete: "off", spellcheck: false });
      input.setAttribute("aria-label", wordsOf(question.ask));
      fields.append(input);
      read = () => {
        const value = Number(unlocalized(input.value.trim().replace("−", "-")));
        return input.value.trim() !== "" && Number.isFinite(value) ? value : undefined;
      };
    } else {
      fields.append(spoken(element("p", "help"), "class.point"));
    }
    const submit = element("button", "primary", say(question.kind === "point" ? "class.here" : "class.answer"));
    const unknown = button("class.unknown", () => void this.#answer(question, null));
    form.append(fields, complaint, element("div", "buttons", submit, unknown));
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      const answer = read();
      complaint.textContent = answer === undefined ? say(question.kind === "choice" ? "class.choose" : "class.number") : "";
      if (answer !== undefined) void this.#answer(question, answer);
    });
    return form;
  }

  /**
   * @param {Question} question
   * @param {Answer} answer
   */
  async #answer(question, answer) {
    const { announce, act, store } = this.#services;
    const step = this.#number;
    const point = pointOf(store.state);
    const form = this.#text.querySelector("form");
    const complaint = form?.querySelector(".complaint");
    for (const one of form?.querySelectorAll("button") ?? []) one.disabled = true;
    const { signal } = this.#life;
    try {
      const verdict = await judgeAnswer(question, answer, worldAt(this.#services, point, signal));
      if (signal.aborted) return;
      // A point that is not there yet is no answer: the reader goes on looking.
      if (question.kind === "point" && answer !== null && !verdict.right) {
        if (complaint) complaint.textContent = say("class.not-there");
        for (const one of form?.querySelectorAll("button") ?? []) one.disabled = false;
        return;
      }
      this.#answers.put({ lesson: this.#lesson.id, step, answer, right: verdict.right, truth: verdict.truth, point });
    } catch (thrown) {
      if (signal.aborted) return;
      if (complaint) complaint.textContent = thrown instanceof Error ? thrown.message : String(thrown);
      for (const one of form?.querySelectorAll("button") ?? []) one.disabled = false;
      return;
    }
    const revealed = this.#lesson.steps[step].reveal?.point;
    if (revealed !== undefined) act("class.act.reveal", (state) => withStep(state, step, undefined, revealed));
    this.show();
    announce(this.#text.querySelector(".verdict")?.textContent ?? "");
  }

  /**
   * @param {Question} question
   * @param {NonNullable<ReturnType<Answers["of"]>>} given
   */
  #verdict(question, { answer, right, truth }) {
    const words = answer === null ? "class.was-unknown" : right ? "class.right" : "class.wrong";
    const parts = [element("b", "", `${answer === null ? "–" : right ? "✓" : "✕"} ${say(words)}`)];
    const verdict = element("p", "verdict", ...parts);
    verdict.dataset.right = String(right);
    if (question.kind === "choice" && typeof truth === "number" && !right) {
      verdict.append(" ", say("class.truth", { truth: wordsOf(question.options[truth].text) }));
    }
    if (question.kind === "number" && typeof truth === "number") {
      const yours = typeof answer === "number" ? number(answer) : "–";
      verdict.append(" ", say("class.compared", { yours, truth: number(truth, { digits: DIGITS }) }));
    }
    return verdict;
  }

  #steps() {
    const last = this.#number === this.#lesson.steps.length - 1;
    const waiting = this.#step.question !== undefined && !this.#answered;
    const back = button("class.back", () => this.go(-1));
    back.disabled = this.#number === 0;
    const next = last ? button("class.done", this.#leave) : button("class.next", () => this.go(1));
    next.className = waiting ? "" : "primary";
    next.disabled = waiting;
    const nav = element("nav", "buttons", back, next);
    nav.setAttribute("aria-label", say("class.steps"));
    return nav;
  }
}
