// Every sentence that the engine makes has its German: titles, labels, summaries, notes, lines of the table, errors.

import assert from "node:assert/strict";
import { test } from "node:test";
import { engine } from "../../www/words/de/engine.js";
import { spoken, spokenFigure, translateEngine, translation } from "../../www/words/engine.js";
import { speak } from "../../www/words/say.js";
import { gear, refused } from "./support.mjs";

/** @typedef {import("../../www/engine/gear-bifurcations.js").Figure} Figure */

speak("de", {});
translateEngine(engine);

/** Letters of formulas, names of functions, and names that are the same. */
const NEUTRAL = /\*[^*]*\*|[_^]\{[^}]*\}|\b(Det|Re|Im|max|min|ln|cos|sin|Omega|alpha|zeta|lambda|k0)\b/g;
/** English words that are no German ones: what is left of them was forgotten. */
const ENGLISH = /\b(the|with|without|of|and|is|are|for|from|to|by|at|edge|tongue|tongues|supports|damping|exact|unstable|stable|saddle|printed|paper|growing|decaying|hardening|softening|second|third|mode)\b/;

/** @param {string} text */
const saysNothing = (text) => !/[A-Za-z]{2,}/.test(text.replace(NEUTRAL, ""));

/** @type {Set<string>} */
const forgotten = new Set();

/** @param {string} text @param {string} where */
function check(text, where) {
  if (saysNothing(text)) return;
  const german = translation(text);
  if (german === null) forgotten.add(`${where}: ${text}`);
  else if (ENGLISH.test(german.replace(/Hopf|Floquet/g, ""))) forgotten.add(`${where}: ${german}`);
}

/** @param {Figure} figure */
function checkFigure(figure) {
  const { id } = figure;
  for (const text of [figure.title, figure.summary, figure.method, ...figure.notes]) check(text, id);
  for (const { title, x, y, z, bar } of figure.axes) {
    for (const text of [title, x.label, y.label, z?.label, bar?.label]) check(text ?? "", id);
  }
  for (const { what } of figure.distances) check(what, id);
  for (const { meaning, label } of figure.series) for (const text of [meaning, label ?? ""]) check(text, id);
  for (const row of figure.table ?? []) {
    for (const entry of [row.where, row.what, row.printed, row.ours, row.exact, row.remark]) if (typeof entry === "string") check(entry, id);
  }
}

const OWN = [{}, 12];
/** Parameters, and how many steps of the computation are looked at. @type {readonly (readonly [object, number])[]} */
const SETS = [
  /** @type {[object, number]} */ (OWN),
  [{ k0: 0.2, Omega: 2.5 }, 2],
  [{ zeta: 0.3 }, 2],
  [{ k0: 0, alpha: 0 }, 2],
  [{ Omega: 3.6, k0: 0.6 }, 3],
  [{ F: 1.5, regime: "backlash" }, 2],
  [{ regime: "backlash" }, 2],
  [{ F: 0.2, regime: "contact", alpha: -1 }, 2],
];

test("every sentence of every figure has its German, at several parameters and while it is computed", () => {
  for (const { id, title, caption, parameters } of gear.figures()) {
    for (const text of [title, caption]) check(text, id);
    for (const info of parameters) check(info.meaning, info.name);
    for (const [given, most] of SETS) {
      let count = 0;
      try {
        for (const { figure } of gear.progress(id, given)) {
          checkFigure(figure);
          count += 1;
          if (count >= most) break;
        }
      } catch (error) {
        check(/** @type {Error} */ (error).message, id);
      }
    }
  }
  for (const info of gear.defaults()) check(info.meaning, info.name);
  assert.deepEqual([...forgotten], []);
});

test("figure A names the motions inside the tooth gap, in German too", () => {
  forgotten.clear();
  /** @type {readonly (readonly [object, string, string, RegExp])[]} */
  const cases = [
    [{ regime: "backlash" }, "1: at rest in the gap", "1: in Ruhe im Zahnspalt", /kommen [\d,]+ Prozent irgendwo im Zahnspalt zur Ruhe, und [\d,]+ Prozent entkommen/],
    [
      { regime: "backlash", E: 0.05 },
      "1: in the gap, period *T*",
      "1: im Zahnspalt, Periode *T*",
      /kommen [\d,]+ Prozent zu einer aus einer stetigen Schar von Bewegungen der Periode 1T im Zahnspalt, und/,
    ],
  ];
  for (const [given, english, german, summary] of cases) {
    const found = new Set();
    // The attractors are known after the first slices, long before the picture is.
    for (const { figure } of gear.progress("A", given)) {
      checkFigure(figure);
      const labels = figure.series.map((/** @type {{label: string | null}} */ { label }) => label);
      if (!labels.includes(english)) continue;
      for (const { label } of spokenFigure(figure).series) found.add(label);
      assert.match(spoken(figure.summary), summary);
      break;
    }
    assert.ok(found.has(german), [...found].join());
  }
  // What two attractors' sentences become, whichever comes first.
  const rest = "20.5 per cent come to rest somewhere in the gap";
  const orbit = "30 per cent go to a motion of period 2T";
  const said = (/** @type {string[]} */ ...ends) => spoken(`Of the starts in this plane ${ends.join(", ")}, and 0 per cent escape.`);
  const [ruhe, bewegung] = ["20,5 Prozent irgendwo im Zahnspalt zur Ruhe", "30 Prozent zu einer Bewegung der Periode 2T"];
  for (const [ends, german] of [
    [[rest, orbit], [ruhe, bewegung]],
    [[orbit, rest], [bewegung, ruhe]],
    [[orbit, rest, orbit], [bewegung, ruhe, bewegung]],
  ]) {
    assert.equal(said(...ends), `Von den Anfängen in dieser Ebene kommen ${german.join(", ")}, und 0 Prozent entkommen.`);
  }
  assert.deepEqual([...forgotten], []);
});

test("errors have their German", () => {
  forgotten.clear();
  for (const call of [
    () => gear.multipliers({ k0: 2 }),
    () => gear.multipliers({ k0: "much" }),
    () => gear.multipliers({ depth: 2 }),
    () => gear.multipliers({ regime: "wet" }),
    () => gear.multipliers({ F: 1 }),
    () => gear.multipliers({ Omega_p: 1.23456 }),
    () => gear.tongues({ m_p: 2 }),
    () => gear.timeResponse({}, { periods: -1 }),
    () => gear.figure("99", {}),
    () => gear.periodicOrbit({ zeta: 0 }, { period: 1, guess: [9, 9, 9, 9, 9, 9] }),
  ]) {
    try {
      call();
      continue;
    } catch (error) {
      check(/** @type {Error} */ (error).message, "error");
    }
  }
  assert.deepEqual([...forgotten], []);
});

test("a figure in German is drawn like the other: names, numbers and columns are the same", () => {
  const figure = gear.figure("2", {});
  const german = spokenFigure(figure);
  assert.equal(german.title, "Determinanten in der Zunge der zweiten Mode");
  assert.equal(figure.title, "Determinants in the tongue of the second mode");
  for (const [index, series] of german.series.entries()) {
    assert.equal(series.name, figure.series[index].name);
    assert.equal(series.columns, figure.series[index].columns);
  }
  assert.ok(gear.svg(german).includes("Aufsatz"));
  translateEngine(null);
  assert.equal(spokenFigure(figure), figure);
  translateEngine(engine);
});

test("a figure that moves is drawn in German at every moment, by the option words", () => {
  const figure = spokenFigure(gear.figure("1", {}));
  // What is drawn; what a series means is said beside the drawing.
  const text = gear.svg(figure, {}, { view: { time: 3 }, words: spoken }).replace(/<title>[^<]*<\/title>/g, "");
  for (const word of ["Ritzel", "Eingriffslinie", "Zahnspalt"]) assert.ok(text.includes(word), word);
  for (const word of ["pinion", "line of action", "tooth gap", "teeth "]) assert.ok(!text.includes(`>${word}`), word);
  refused(() => gear.svg(figure, {}, { words: "German" }), { code: "option", parameter: "words" });
  refused(() => gear.svg(figure, {}, { words: () => 3 }), { code: "option", parameter: "words" });
  refused(() => gear.svg(figure, {}, { words: () => { throw new Error("no"); } }), { code: "option", parameter: "words" });
});

test("numbers in sentences are written as in German, and formulas' numbers are not", () => {
  assert.equal(translation("The motion escapes at t = 1.25; it is shown up to there."), "Die Bewegung entkommt bei t = 1,25; sie wird bis dorthin gezeigt.");
  assert.equal(translation("Edges of the third mode [T5]: exact 5.2 and 5.6, the formula is off by −9.0e-5 and 0.001."), "Ränder, dritte Mode [T5]: exakt 5,2 und 5,6, die Formel liegt um −9,0e-5 und 0,001 daneben.");
  assert.equal(translation("3.3; Figs. 7, 9"), "3.3; Abb. 7, 9");
});
