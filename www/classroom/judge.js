/**
 * Whether an answer is right: asked of the figures, at the operating point, when it is given. No lesson holds a number that
 * could be computed.
 *
 * @typedef {import("./lesson.js").Condition} Condition
 * @typedef {import("./lesson.js").Question} Question
 * @typedef {import("./lesson.js").Plain} Plain
 * @typedef {import("../state.js").Given} Given
 */

/**
 * What there is to ask.
 *
 * @typedef {object} World
 * @property {Given} given  The operating point.
 * @property {(name: string) => number | string} parameter  Its value there, given or following.
 * @property {(figure: string, fact: string) => Promise<Plain | undefined>} fact  What a figure finds there.
 */

/**
 * An answer: the index of an option, a number, or null where none was given; a point is answered by being there.
 *
 * @typedef {number | null | "here"} Answer
 * @typedef {{right: boolean, truth: Plain | null}} Verdict  `truth`: the right option's index, or the number itself.
 */

/**
 * @param {Condition} condition
 * @param {World} world
 */
async function holds({ figure, fact, parameter, is, from, to }, world) {
  const value = parameter === undefined ? await world.fact(figure ?? "", fact ?? "") : world.parameter(parameter);
  if (is !== undefined) return value === is;
  if (typeof value !== "number") return from === undefined && to === undefined && value !== undefined;
  return value >= (from ?? -Infinity) && value <= (to ?? Infinity);
}

/**
 * @param {readonly Condition[]} conditions
 * @param {World} world
 */
async function allHold(conditions, world) {
  for (const condition of conditions) {
    if (!(await holds(condition, world))) return false;
  }
  return true;
}

/**
 * @param {Question} question
 * @param {Answer} answer
 * @param {World} world
 * @returns {Promise<Verdict>}
 */
export async function judgeAnswer(question, answer, world) {
  switch (question.kind) {
    case "choice": {
      for (const [index, { right, when }] of question.options.entries()) {
        if (right === true || (when !== undefined && (await allHold(when, world)))) return { right: answer === index, truth: index };
      }
      return { right: false, truth: null };
    }
    case "number": {
      const truth = await world.fact(question.answer.figure, question.answer.fact);
      if (typeof truth !== "number") return { right: false, truth: null };
      const right = typeof answer === "number" && Math.abs(answer - truth) <= question.within * Math.abs(truth);
      return { right, truth };
    }
    case "point":
      return { right: answer !== null && (await allHold(question.goal, world)), truth: null };
  }
}
