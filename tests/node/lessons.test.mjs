// The lessons that ship: sound by the same check as a teacher's own, each question with one right answer by the module
// itself, and a file that is wrong told by place.

import assert from "node:assert/strict";
import { test } from "node:test";
import { FORMAT, readLesson } from "../../www/classroom/lesson.js";
import { LESSONS } from "../../www/classroom/lessons/index.js";
import { judgeAnswer } from "../../www/classroom/judge.js";
import { Answers } from "../../www/classroom/answers.js";
import { parametersOf } from "../../www/classroom/point.js";
import { INITIAL, isLocked, pointOf, withLesson, withPoint, withPreset, withStep } from "../../www/state.js";
import { valueOf } from "../../www/values.js";
import { words as english } from "../../www/words/en/classroom.js";
import { gear } from "./support.mjs";

/** @typedef {import("../../www/classroom/lesson.js").Lesson} Lesson */
/** @typedef {import("../../www/classroom/judge.js").World} World */

const figures = new Map(gear.figures().map((/** @type {any} */ info) => [info.id, info]));
const vocabulary = new Map(
  [...gear.defaults(), ...[...figures.values()].flatMap(({ parameters }) => parameters)].map((info) => [info.name, info]),
);
const known = { figures: [...figures.keys()], parameters: new Set(vocabulary.keys()) };
const file = (/** @type {object} */ lesson) => JSON.stringify({ format: FORMAT, version: 1, ...lesson });

/** The module itself, asked as the classroom asks it. @param {Record<string, any>} given @returns {World} */
function world(given) {
  const computed = new Map();
  return {
    given,
    parameter: (name) => valueOf(given, vocabulary, name),
    async fact(id, name) {
      if (!computed.has(id)) {
        const names = parametersOf(/** @type {any} */ ({ figures, vocabulary }), id);
        computed.set(id, gear.figure(id, Object.fromEntries(Object.entries(given).filter(([one]) => names.includes(one)))));
      }
      return computed.get(id).facts[name];
    },
  };
}

/** The operating point at each step, as somebody comes to it who changes nothing. @param {Lesson} lesson */
function points(lesson) {
  let state = withLesson({ ...INITIAL, view: "class" }, lesson.id, lesson.steps[0].preset, lesson.steps[0].point);
  return lesson.steps.map((step, index) => {
    if (index > 0) state = withStep(state, index, step.preset, step.point);
    return pointOf(state);
  });
}

/** Where the goals of the points that are asked for can be reached, from where the step begins. @type {Record<string, Record<string, number>>} */
const REACHED = {
  "tongue 3": { Omega: 5.4 },
  "tongue 4": { zeta: 0.2 },
  "pitchfork 3": { Omega: 1.63 },
  "hopf 2": { Omega: 3.78 },
  "hysteresis 3": { u_p0: -0.5, u_g0: 0.5 },
  "contact 3": { F: 1 },
};

for (const lesson of LESSONS) {
  test(`the lesson ${lesson.id} is sound as a file`, () => {
    assert.deepEqual(readLesson(file(lesson), known), { lesson: { format: FORMAT, version: 1, ...lesson }, fault: null });
  });

  test(`the lesson ${lesson.id}: what is asked has an answer, by the module`, async () => {
    for (const [index, given] of points(lesson).entries()) {
      const { question, reveal } = lesson.steps[index];
      const where = `${lesson.id} ${index}`;
      if (question?.kind === "choice") {
        const right = [];
        for (const at of question.options.keys()) if ((await judgeAnswer(question, at, world(given))).right) right.push(at);
        assert.equal(right.length, 1, `${where}: ${right}`);
      } else if (question?.kind === "number") {
        const { truth } = await judgeAnswer(question, 0, world(given));
        assert.ok(typeof truth === "number" && truth !== 0, where);
        assert.ok((await judgeAnswer(question, truth * (1 + 0.9 * question.within), world(given))).right, where);
        assert.ok(!(await judgeAnswer(question, truth * (1 + 1.1 * question.within), world(given))).right, where);
      } else if (question?.kind === "point") {
        assert.ok(!(await judgeAnswer(question, "here", world(given))).right, `${where} is there from the start`);
        const there = { ...given, ...REACHED[where] };
        assert.ok((await judgeAnswer(question, "here", world(there))).right, `${where} cannot be reached`);
        for (const name of Object.keys(REACHED[where] ?? {})) {
          const shown = lesson.steps[index].figures.includes("T") && ["Omega", "k0"].includes(name);
          assert.ok(shown || lesson.steps[index].open?.includes(name), `${where}: ${name} cannot be changed`);
        }
      }
      for (const [name, { figure, fact }] of Object.entries(reveal?.values ?? {})) {
        const value = await world({ ...given, ...reveal?.point }).fact(figure, fact);
        assert.equal(typeof value, "number", `${where}: {${name}}`);
      }
    }
  });

  test(`the lesson ${lesson.id}: the holes of a revealed sentence are filled`, () => {
    for (const { reveal } of lesson.steps) {
      if (reveal === undefined || typeof reveal.text !== "object" || !("word" in reveal.text)) continue;
      const holes = [...(english[reveal.text.word] ?? "").matchAll(/(?<![_^])\{(\w+)\}/g)].map(([, name]) => name);
      assert.deepEqual(holes.sort(), Object.keys(reveal.values ?? {}).sort(), reveal.text.word);
    }
  });
}

test("a lesson that is wrong is refused, by place, with what is allowed", () => {
  const sound = {
    format: FORMAT,
    version: 1,
    id: "mine",
    title: "Mine",
    summary: { en: "One", de: "Eine" },
    steps: [{ title: "One", text: ["First", "second"], figures: ["T"], question: { kind: "choice", ask: "?", options: [{ text: "a", right: true }, { text: "b" }] } }],
  };
  assert.equal(readLesson(JSON.stringify(sound), known).fault, null);
  /** @type {[(lesson: any) => void, string, string][]} */
  const spoilt = [
    [(lesson) => delete lesson.title, "title", "missing"],
    [(lesson) => (lesson.version = 2), "version", "wrong"],
    [(lesson) => (lesson.colour = "red"), "colour", "unknown"],
    [(lesson) => (lesson.id = "Mine and yours"), "id", "wrong"],
    [(lesson) => (lesson.steps = []), "steps", "wrong"],
    [(lesson) => (lesson.steps[0].figures = ["99"]), "steps[0].figures", "wrong"],
    [(lesson) => (lesson.steps[0].open = ["omgea"]), "steps[0].open", "unknown"],
    [(lesson) => (lesson.steps[0].point = { Omega: null }), "steps[0].point.Omega", "wrong"],
    [(lesson) => (lesson.steps[0].question.kind = "guess"), "steps[0].question.kind", "wrong"],
    [(lesson) => (lesson.steps[0].question.options = [{ text: "a" }]), "steps[0].question.options", "wrong"],
    [(lesson) => (lesson.steps[0].question = { kind: "number", ask: "?", answer: { figure: "M", fact: "stable" } }), "steps[0].question.within", "missing"],
    [(lesson) => (lesson.steps[0].question = { kind: "point", ask: "?", goal: [{ parameter: "speed", from: 1 }] }), "steps[0].question.goal[0].parameter", "unknown"],
  ];
  for (const [spoil, place, kind] of spoilt) {
    const lesson = structuredClone(sound);
    spoil(lesson);
    const { fault } = readLesson(JSON.stringify(lesson), known);
    assert.equal(fault?.place, place);
    assert.equal(fault?.kind, kind, place);
  }
  for (const text of ["", "{", "null", "[]", "1", '"lesson"', "\u0000"]) assert.notEqual(readLesson(text, known).fault, null, text);
});

test("answers are written and read back; what is no answer is left out", () => {
  const answers = new Answers();
  answers.put({ lesson: "tongue", step: 0, answer: 1, right: true, truth: 1, point: { k0: 0.5 } });
  answers.put({ lesson: "tongue", step: 1, answer: null, right: false, truth: 1, point: {} });
  answers.put({ lesson: "tongue", step: 0, answer: 0, right: false, truth: 1, point: {} });
  const other = new Answers();
  assert.equal(other.read(answers.write("https://example.org/#class")), 2);
  assert.deepEqual(other.of("tongue", 0), answers.of("tongue", 0));
  assert.deepEqual(other.count("tongue"), { given: 2, right: 0 });
  for (const text of ["", "[]", "{}", '{"format":"gear-bifurcations answers","version":2,"answers":[]}']) assert.equal(other.read(text), null);
  assert.equal(other.read('{"format":"gear-bifurcations answers","version":1,"answers":[{"lesson":1},{"lesson":"a","step":-1}]}'), 0);
});

test("what a lesson locks stays, whoever sets it and wherever the point goes", () => {
  const open = { ...INITIAL, point: { zeta: 0.05, m_p: 2 }, lesson: { id: "tongue", step: 0, locked: ["zeta", "m"] } };
  for (const name of ["zeta", "m", "m_p", "m_g"]) assert.ok(isLocked(open, name), name);
  for (const name of ["zeta_p", "k0", "k", "F"]) assert.ok(!isLocked(open, name), name);
  assert.equal(withPoint(open, { zeta: 0.2, m_g: 3 }), open);
  assert.deepEqual(withPoint(open, { k0: 0.4 }).point, { zeta: 0.05, m_p: 2, k0: 0.4 });
  assert.equal(pointOf(withPreset(open, "11a")).zeta, 0.05);
  assert.equal(pointOf(withStep(open, 1, "14a", { zeta: 0.5, k0: 0.3 })).zeta, 0.05);
  assert.equal(pointOf(withStep(open, 1, "14a", { zeta: 0.5, k0: 0.3 })).k0, 0.3);
  assert.deepEqual(withLesson(open, "hopf").lesson, { id: "hopf", step: 0, locked: ["zeta", "m"] });
});
