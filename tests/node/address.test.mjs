// The address after `#`: what is written reads back as the same state, and whatever is read, nothing is thrown.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { INITIAL, Store, same, withPoint } from "../../www/state.js";
import { parse, write } from "../../www/url.js";
import { random } from "./random.mjs";
import { known, randomState, randomText } from "./states.mjs";

/** @param {string} text */
const read = (text) => {
  const { state, problems } = parse(text, known);
  return { state: { ...INITIAL, ...state }, problems };
};

test("what is written reads back as the same state, exactly, without a complaint", () => {
  for (let seed = 1; seed <= 2000; seed += 1) {
    const state = randomState(random(seed));
    const text = write(state);
    const back = read(text);
    assert.deepEqual(back, { state, problems: [] }, `seed ${seed}: ${text}`);
    assert.equal(write(back.state), text);
    assert.match(text, /^[A-Za-z0-9_.,=&%+*'()!~-]*$/, "signs that an address may hold");
  }
});

test("it is readable, names its version, and holds only what differs", () => {
  assert.equal(write(INITIAL), "");
  assert.equal(write({ ...INITIAL, view: "lab" }), "lab");
  assert.equal(write(withPoint({ ...INITIAL, view: "lab", preset: "11c" }, { Omega: 1.7, k0: 0.5 })), "lab&v=1&preset=11c&omega=1.7");
  const store = new Store();
  store.give("fig-11a", { Omega: 1.7 });
  assert.equal(write(store.state), "story&v=1&11a.omega=1.7");
});

test("names are matched without regard to case, full names and short forms", () => {
  const { state, problems } = read("LAB&PRESET=11C&OMEGA=1.7&zeta_S=0.1&M_P=2&REGIME=Contact&si.M_P=3&t.Window.tongues=1..2,0..1&THEME=Dark");
  assert.deepEqual(problems, []);
  assert.deepEqual(state.point, { Omega: 1.7, zeta_s: 0.1, m_p: 2, regime: "contact" });
  assert.deepEqual([state.view, state.preset, state.si, state.theme], ["lab", "11c", { M_p: 3 }, "dark"]);
  assert.deepEqual(state.figures["fig-T"].windows, { tongues: { x: [1, 2], y: [0, 1] } });
});

for (const [text, kind, name, given, allowed] of /** @type {const} */ ([
  ["lab&omgea=1", "unknown", "omgea", "1", ""],
  ["lab&k0=abc", "number", "k0", "abc", "0 .. 1"],
  ["lab&k0=", "number", "k0", "", "0 .. 1"],
  ["lab&k0=1e999", "number", "k0", "1e999", "0 .. 1"],
  ["lab&k0=0x1", "number", "k0", "0x1", "0 .. 1"],
  ["lab&k0=2", "range", "k0", "2", "0 .. 1"],
  ["lab&regime=wet", "choice", "regime", "wet", "homogeneous, contact, backlash"],
  ["lab&theme=pink", "choice", "theme", "pink", "auto, light, dark, contrast"],
  ["lab&v=7", "newer", "v", "7", "1"],
  ["lab&T.window.tongues=2..1,0..1", "form", "T.window.tongues", "2..1,0..1", "1.4..1.8,0..1"],
  ["lab&3.view=1,9", "form", "3.view", "1,9", "0.6,0.3"],
  ["lab&99z.omega=1", "unknown", "99z.omega", "1", ""],
  ["lab&pin3.omega=1", "unknown", "pin3.omega", "1", ""],
  ["lab&si.mass=1", "unknown", "si.mass", "1", ""],
  ["lab&k0=0.4&K0=0.6", "repeated", "K0", "0.6", ""],
  ["nowhere", "unknown", "nowhere", "", ""],
  ["lab&at=nowhere", "unknown", "at=nowhere", "", ""],
  ["lab&lock=k0,magic&lesson=hopf", "unknown", "lock=magic", "", ""],
  ["lab&__proto__=1", "unknown", "__proto__", "1", ""],
  ["lab&constructor.omega=1", "unknown", "constructor.omega", "1", ""],
])) {
  test(`${text}: one complaint, by name, and the rest applies`, () => {
    const { state, problems } = read(`${text}&zeta=0.5`);
    assert.deepEqual(problems, [{ kind, name, given, allowed }]);
    assert.equal(state.point.zeta, 0.5);
    if (kind === "repeated") assert.equal(state.point.k0, 0.4);
  });
}

test("every example of docs/address.md is applied whole, and every name there is one", () => {
  const text = readFileSync(new URL("../../docs/address.md", import.meta.url), "utf8");
  const examples = [...text.matchAll(/^#([a-z]+\S*)$/gm)].map(([, example]) => example);
  assert.ok(examples.length >= 6);
  for (const example of examples) assert.deepEqual(read(example).problems, [], example);
});

test("before the engine has told what there is, words that need no numbers are read already", () => {
  const { state, problems } = parse("lab&omega=1.7&theme=dark&language=de&bogus=1", null);
  assert.deepEqual([state.view, state.theme, state.language, state.point, problems], ["lab", "dark", "de", {}, []]);
});

test("100,000 random and mutated addresses: never an exception, always a state that can be written", () => {
  const choose = random(4);
  const whole = Array.from({ length: 1000 }, () => write(randomState(choose)));
  for (let count = 0; count < 100_000; count += 1) {
    const text = choose.chance(0.3) ? noise(choose) : mutated(choose, choose.of(whole));
    const { state, problems } = read(text);
    for (const problem of problems) assert.ok(problem.name.length <= 61 && problem.given.length <= 61, text);
    if (count % 10 !== 0) continue;
    const again = read(write(state));
    // The quick comparison first: the other one is for telling what differs.
    if (!same(again, { state, problems: [] })) assert.deepEqual(again, { state, problems: [] }, text);
  }
});

/** @param {import("./random.mjs").Choose} choose */
function noise(choose) {
  return Array.from({ length: choose.integer(0, 12) }, () => choose.of(["&", "=", ".", "..", "%", "lab", "T.window.", "pin1.", "v=", randomText(choose)])).join("");
}

/** @param {import("./random.mjs").Choose} choose @param {string} text */
function mutated(choose, text) {
  let changed = text;
  for (let count = choose.integer(1, 4); count > 0; count -= 1) {
    const at = choose.integer(0, changed.length);
    const drop = choose.integer(0, 3);
    changed = changed.slice(0, at) + choose.of(["", "&", "=", "%", "%E0%A4%A", "..", "9", "-", "e", "NaN", changed.slice(0, 20)]) + changed.slice(at + drop);
  }
  return changed;
}
