/**
 * What a pupil answered: kept while the page is open, saved as one file, read back from it.
 *
 * @typedef {import("./judge.js").Answer} Answer
 * @typedef {import("./lesson.js").Plain} Plain
 * @typedef {object} Given
 * @property {string} lesson
 * @property {number} step
 * @property {Answer} answer
 * @property {boolean} right
 * @property {Plain | null} truth
 * @property {Readonly<Record<string, number | string>>} point  The operating point at which it was given.
 */

const FORMAT = "gear-bifurcations answers";
const VERSION = 1;

export class Answers {
  /** @type {Map<string, Given>} */
  #given = new Map();

  /**
   * @param {string} lesson
   * @param {number} step
   */
  of(lesson, step) {
    return this.#given.get(`${lesson} ${step}`) ?? null;
  }

  /** @param {Given} given */
  put(given) {
    this.#given.set(`${given.lesson} ${given.step}`, Object.freeze({ ...given }));
  }

  /** @param {string} lesson */
  forget(lesson) {
    for (const [key, given] of this.#given) {
      if (given.lesson === lesson) this.#given.delete(key);
    }
  }

  /** @param {string} lesson */
  count(lesson) {
    const given = [...this.#given.values()].filter((one) => one.lesson === lesson);
    return { given: given.length, right: given.filter(({ right }) => right).length };
  }

  get empty() {
    return this.#given.size === 0;
  }

  /** @param {string} link  Of the page as it stands. */
  write(link) {
    return `${JSON.stringify({ format: FORMAT, version: VERSION, link, answers: [...this.#given.values()] }, null, 2)}\n`;
  }

  /**
   * Takes the answers of a file; what is none is left out.
   *
   * @param {string} text
   * @returns {number | null} how many there were; null where the file is none of ours
   */
  read(text) {
    /** @type {any} */
    let data;
    try {
      data = JSON.parse(text);
    } catch {
      return null;
    }
    if (data?.format !== FORMAT || data.version !== VERSION || !Array.isArray(data.answers)) return null;
    const sound = data.answers.filter(isGiven);
    for (const { lesson, step, answer, right, truth, point } of sound) this.put({ lesson, step, answer, right, truth: truth ?? null, point });
    return sound.length;
  }
}

/** @param {any} one */
function isGiven(one) {
  return (
    typeof one?.lesson === "string" &&
    Number.isInteger(one.step) &&
    one.step >= 0 &&
    typeof one.right === "boolean" &&
    (one.answer === null || one.answer === "here" || Number.isFinite(one.answer)) &&
    typeof one.point === "object" &&
    one.point !== null
  );
}
