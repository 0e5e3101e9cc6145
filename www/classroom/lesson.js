/**
 * What a lesson is: plain data, so that a teacher writes one without programming. docs/lessons.md tells it in full.
 *
 * @typedef {string | Readonly<{word: string}> | Readonly<Record<string, string>>} Text  The words themselves, the key of a sentence
 *   in the catalogue, or the words by language (`{"en": ..., "de": ...}`).
 * @typedef {string | number | boolean} Plain
 * @typedef {Readonly<{figure: string, fact: string}>} Fact  Something that a figure finds at the operating point.
 * @typedef {Readonly<{figure: string, fact: string, digits?: number}>} Shown  A fact as a number in a sentence.
 * @typedef {Readonly<{figure?: string, fact?: string, parameter?: string, is?: Plain, from?: number, to?: number}>} Condition
 *   A fact or a parameter that is something, or lies from a number to another.
 * @typedef {Readonly<{text: Text, right?: boolean, when?: readonly Condition[]}>} Option  Right by itself, or when all conditions hold.
 * @typedef {Readonly<{kind: "choice", ask: Text, options: readonly Option[]}>} ChoiceQuestion
 * @typedef {Readonly<{kind: "number", ask: Text, answer: Fact, within: number}>} NumberQuestion  `within`: how far off still counts as
 *   right, as a part of the answer.
 * @typedef {Readonly<{kind: "point", ask: Text, goal: readonly Condition[]}>} PointQuestion  The operating point is to be moved to where all
 *   conditions hold.
 * @typedef {ChoiceQuestion | NumberQuestion | PointQuestion} Question
 * @typedef {Readonly<{text: Text, figures?: readonly string[], point?: Readonly<Record<string, Plain>>, values?: Readonly<Record<string, Shown>>}>} Reveal
 * @typedef {object} Step
 * @property {Text} title
 * @property {Text | readonly Text[]} text
 * @property {string} [preset]  The figure whose parameters the operating point has when the step begins; as before it, when absent.
 * @property {Readonly<Record<string, number | string>>} [point]  What differs from them.
 * @property {readonly string[]} figures  Which are shown, one or two.
 * @property {readonly string[]} [open]  Parameters that may be changed.
 * @property {Question} [question]
 * @property {Reveal} [reveal]  What is shown once the question is answered.
 *
 * @typedef {object} Lesson
 * @property {string} id
 * @property {Text} title
 * @property {Text} summary
 * @property {readonly Step[]} steps
 */

/** What a lesson's file begins with. */
export const FORMAT = "gear-bifurcations lesson";
const VERSION = 1;
/** Longer lessons and words are a mistake. */
const MOST_STEPS = 100;
const MOST_WORDS = 4000;

/**
 * Where a lesson's file is wrong.
 *
 * @typedef {object} Fault
 * @property {string} place  Such as `steps[2].question.kind`.
 * @property {"missing" | "wrong" | "unknown"} kind
 * @property {string} given  As far as it can be said in a few words.
 * @property {string} allowed
 */

/**
 * Reads a lesson's file.
 *
 * @param {string} text
 * @param {{figures: readonly string[], parameters: ReadonlySet<string>}} known
 * @returns {{lesson: Lesson, fault: null} | {lesson: null, fault: Fault}}
 */
export function readLesson(text, known) {
  /** @type {unknown} */
  let data;
  try {
    data = JSON.parse(text);
  } catch (thrown) {
    const given = thrown instanceof Error ? thrown.message : "";
    return { lesson: null, fault: { place: "", kind: "wrong", given, allowed: "JSON" } };
  }
  try {
    return { lesson: new Check(known).lesson(data), fault: null };
  } catch (thrown) {
    if (thrown instanceof Refusal) return { lesson: null, fault: thrown.fault };
    throw thrown;
  }
}

/** @param {Fault} fault */
class Refusal extends Error {
  /** @param {Fault} fault */
  constructor(fault) {
    super(fault.place);
    this.fault = fault;
  }
}

/** Goes through the data once and stops at the first thing that is wrong. */
class Check {
  #known;

  /** @param {{figures: readonly string[], parameters: ReadonlySet<string>}} known */
  constructor(known) {
    this.#known = known;
  }

  /**
   * @param {unknown} data
   * @returns {Lesson}
   */
  lesson(data) {
    const lesson = this.#object(data, "", ["format", "version", "id", "title", "summary", "steps"]);
    this.#one(lesson.format, "format", [FORMAT]);
    this.#one(lesson.version, "version", [VERSION]);
    if (typeof lesson.id !== "string" || !/^[a-z0-9-]{1,40}$/.test(lesson.id)) refuse("id", lesson.id, "a-z 0-9 -");
    this.#text(lesson.title, "title");
    this.#text(lesson.summary, "summary");
    const steps = this.#list(lesson.steps, "steps", 1, MOST_STEPS);
    steps.forEach((step, index) => this.#step(step, `steps[${index}]`));
    return /** @type {Lesson} */ (/** @type {unknown} */ (lesson));
  }

  /**
   * @param {unknown} data
   * @param {string} place
   */
  #step(data, place) {
    const step = this.#object(data, place, ["title", "text", "preset", "point", "figures", "open", "question", "reveal"]);
    this.#text(step.title, `${place}.title`);
    for (const text of Array.isArray(step.text) ? step.text : [step.text]) this.#text(text, `${place}.text`);
    if (step.preset !== undefined) this.#one(step.preset, `${place}.preset`, this.#known.figures);
    this.#point(step.point, `${place}.point`);
    this.#figures(step.figures, `${place}.figures`);
    this.#list(step.open ?? [], `${place}.open`, 0, 50).forEach((name) => this.#parameter(name, `${place}.open`));
    if (step.question !== undefined) this.#question(step.question, `${place}.question`);
    if (step.reveal === undefined) return;
    const reveal = this.#object(step.reveal, `${place}.reveal`, ["text", "figures", "point", "values"]);
    this.#text(reveal.text, `${place}.reveal.text`);
    if (reveal.figures !== undefined) this.#figures(reveal.figures, `${place}.reveal.figures`);
    this.#point(reveal.point, `${place}.reveal.point`);
    if (reveal.values === undefined) return;
    for (const [name, shown] of Object.entries(this.#object(reveal.values, `${place}.reveal.values`, null))) {
      this.#fact(shown, `${place}.reveal.values.${name}`);
    }
  }

  /**
   * @param {unknown} data
   * @param {string} place
   */
  #question(data, place) {
    const question = this.#object(data, place, ["kind", "ask", "options", "answer", "within", "goal"]);
    this.#one(question.kind, `${place}.kind`, ["choice", "number", "point"]);
    this.#text(question.ask, `${place}.ask`);
    if (question.kind === "choice") {
      this.#list(question.options, `${place}.options`, 2, 9).forEach((one, index) => {
        const here = `${place}.options[${index}]`;
        const option = this.#object(one, here, ["text", "right", "when"]);
        this.#text(option.text, `${here}.text`);
        if (option.right !== undefined) this.#one(option.right, `${here}.right`, [true, false]);
        if (option.when !== undefined) this.#conditions(option.when, `${here}.when`);
      });
    } else if (question.kind === "number") {
      this.#fact(question.answer, `${place}.answer`);
      const { within } = question;
      if (typeof within !== "number" || !(within > 0 && within <= 1)) refuse(`${place}.within`, within, "0 .. 1");
    } else {
      this.#conditions(question.goal, `${place}.goal`);
    }
  }

  /**
   * @param {unknown} data
   * @param {string} place
   */
  #conditions(data, place) {
    this.#list(data, place, 1, 9).forEach((one, index) => {
      const here = `${place}[${index}]`;
      const condition = this.#object(one, here, ["figure", "fact", "parameter", "is", "from", "to"]);
      if (condition.parameter === undefined) this.#fact(condition, here);
      else this.#parameter(condition.parameter, `${here}.parameter`);
      for (const end of ["from", "to"]) {
        if (condition[end] !== undefined && typeof condition[end] !== "number") refuse(`${here}.${end}`, condition[end], "0.5");
      }
    });
  }

  /**
   * @param {unknown} data
   * @param {string} place
   */
  #fact(data, place) {
    const fact = this.#object(data, place, null);
    this.#one(fact.figure, `${place}.figure`, this.#known.figures);
    if (typeof fact.fact !== "string") refuse(`${place}.fact`, fact.fact, "maxU_p");
  }

  /**
   * @param {unknown} data
   * @param {string} place
   */
  #figures(data, place) {
    this.#list(data, place, 1, 2).forEach((id) => this.#one(id, place, this.#known.figures));
  }

  /**
   * @param {unknown} data
   * @param {string} place
   */
  #point(data, place) {
    if (data === undefined) return;
    for (const [name, value] of Object.entries(this.#object(data, place, null))) {
      this.#parameter(name, place);
      if (typeof value !== "string" && !(typeof value === "number" && Number.isFinite(value))) refuse(`${place}.${name}`, value, "0.5");
    }
  }

  /**
   * @param {unknown} name
   * @param {string} place
   */
  #parameter(name, place) {
    if (typeof name !== "string" || !this.#known.parameters.has(name)) refuse(place, name, [...this.#known.parameters].join(", "), "unknown");
  }

  /**
   * @param {unknown} text
   * @param {string} place
   */
  #text(text, place) {
    const texts = typeof text === "object" && text !== null && !Array.isArray(text) ? Object.values(text) : [text];
    if (texts.length === 0) refuse(place, text, "“…”");
    for (const one of texts) {
      if (typeof one !== "string" || one.length > MOST_WORDS) refuse(place, one, "“…”");
    }
  }

  /**
   * @param {unknown} value
   * @param {string} place
   * @param {readonly unknown[]} allowed
   */
  #one(value, place, allowed) {
    if (!allowed.includes(value)) refuse(place, value, allowed.join(", "));
  }

  /**
   * @param {unknown} value
   * @param {string} place
   * @param {number} least
   * @param {number} most
   * @returns {unknown[]}
   */
  #list(value, place, least, most) {
    if (Array.isArray(value) && value.length >= least && value.length <= most) return value;
    return refuse(place, value, `[…], ${least} .. ${most}`);
  }

  /**
   * @param {unknown} value
   * @param {string} place
   * @param {readonly string[] | null} names  Those that it may have; any, when null.
   * @returns {Record<string, unknown>}
   */
  #object(value, place, names) {
    if (typeof value !== "object" || value === null || Array.isArray(value)) return refuse(place, value, "{…}");
    const stray = names === null ? undefined : Object.keys(value).find((name) => !names.includes(name));
    if (stray !== undefined) refuse(place === "" ? stray : `${place}.${stray}`, stray, (names ?? []).join(", "), "unknown");
    return /** @type {Record<string, unknown>} */ (value);
  }
}

/**
 * @param {string} place
 * @param {unknown} given
 * @param {string} allowed
 * @param {Fault["kind"]} [kind]
 * @returns {never}
 */
function refuse(place, given, allowed, kind = given === undefined ? "missing" : "wrong") {
  const words = given === undefined ? "" : (JSON.stringify(given) ?? String(given)).slice(0, 60);
  throw new Refusal({ place, kind, given: words, allowed });
}
