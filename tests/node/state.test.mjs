// The page's one state: actions, undoing, and the operating points of the figures. Random sequences come from a seed.

import assert from "node:assert/strict";
import { test } from "node:test";
import { MOST } from "../../www/history.js";
import { PRESETS, presetGiven } from "../../www/presets.js";
import { INITIAL, Store, figureOf, givenOf, pointOf, withFigure, withPoint, withPreset } from "../../www/state.js";
import { random } from "./random.mjs";
import { randomState } from "./states.mjs";
import { gear } from "./support.mjs";

test("every preset is the figure's own operating point, and no figure is without", () => {
  const infos = /** @type {any[]} */ (gear.figures());
  const ofTheModel = new Set(gear.defaults().flatMap((/** @type {any} */ { name, short }) => [name, short]));
  assert.deepEqual([...PRESETS], infos.map((/** @type {any} */ { id }) => id));
  for (const { id, parameters } of infos) {
    const given = presetGiven(id);
    // From where a motion starts is no part of the operating point.
    for (const info of parameters.filter((/** @type {any} */ { name }) => ofTheModel.has(name))) assert.equal(given[info.name], info.default, `figure ${id}, ${info.name}`);
    const steps = gear.progress(id, {});
    assert.equal(given.regime, steps.next().value.figure.params.regime, `figure ${id}, regime`);
    steps.return();
    // And it can be computed from all of it, given in full.
    gear.multipliers({ ...given, regime: "homogeneous", F: 0, F_p: 0, F_g: 0, E: 0 });
  }
});

test("any sequence of actions, undone, gives the first state; redone, the last", () => {
  for (let seed = 1; seed <= 60; seed += 1) {
    const choose = random(seed);
    let time = 0;
    const store = new Store({}, () => time);
    const first = store.state;
    const states = [first];
    const length = choose.integer(1, 60);
    for (let step = 0; step < length; step += 1) {
      time += choose.integer(0, 1500);
      const doing = choose.integer(0, 9);
      if (doing === 0) store.undo();
      else if (doing === 1) store.redo();
      else if (doing === 2) store.hold();
      else if (doing === 3) store.release();
      else if (doing === 4) store.give(`fig-${choose.of(PRESETS)}`, { Omega: choose.number(0.1, 9) });
      else store.act("act.parameter", () => randomState(choose), choose.chance(0.5) ? { merge: choose.of(["a", "b"]) } : {});
      states.push(store.state);
    }
    store.release();
    const last = store.history.entries.at(-1)?.state;
    while (store.undoable) store.undo();
    assert.equal(store.state, first, `seed ${seed}`);
    while (store.redoable) store.redo();
    assert.equal(store.state, last, `seed ${seed}`);
    assert.equal(new Set(store.history.entries.map(({ id }) => id)).size, store.history.entries.length);
  }
});

test("a thousand actions can be undone, and of those before nothing is kept", () => {
  const store = new Store();
  const states = [store.state];
  for (let step = 1; step <= 3 * MOST; step += 1) {
    store.act("act.parameter", (state) => withPoint(state, { Omega: step / 1000 }));
    states.push(store.state);
  }
  assert.equal(new Set(store.history.entries.map(({ state }) => state)).size, MOST + 2);
  for (let step = 0; step < MOST; step += 1) store.undo();
  assert.equal(store.undoable, false);
  assert.equal(store.state, states[2 * MOST]);
  store.undo();
  store.goTo(5);
  assert.equal(store.state, states[2 * MOST], "there is nothing before");
  for (let step = 0; step < MOST; step += 1) store.redo();
  assert.equal(store.state, states[3 * MOST]);
});

test("what is held is one action, however long it takes; what follows quickly and is alike is one as well", () => {
  let time = 0;
  const store = new Store({}, () => time);
  const slide = (/** @type {number} */ Omega) => store.act("act.parameter", (state) => withPoint(state, { Omega }), { merge: "Omega" });
  store.hold();
  for (const Omega of [1.61, 1.62, 1.63]) {
    time += 5000;
    slide(Omega);
  }
  store.release();
  slide(1.64);
  assert.equal(store.history.at, 2);
  time += 10;
  slide(1.65);
  assert.equal(store.history.at, 2);
  time += 2000;
  slide(1.66);
  assert.equal(store.history.at, 3);
  store.undo();
  assert.equal(store.state.point.Omega, 1.65);
  store.undo();
  store.undo();
  assert.equal(store.state, store.history.entries[0].state);
});

test("after an undo nothing is counted in with what was undone", () => {
  const store = new Store({}, () => 0);
  const slide = (/** @type {number} */ Omega) => store.act("act.parameter", (state) => withPoint(state, { Omega }), { merge: "Omega" });
  slide(2);
  store.act("act.theme", (state) => ({ ...state, theme: "dark" }));
  store.undo();
  slide(3);
  store.undo();
  assert.equal(store.state.point.Omega, 2);
});

test("the state cannot be changed but by an action, and one that changes nothing leaves no trace", () => {
  const store = new Store();
  assert.throws(() => Object.assign(store.state, { theme: "dark" }), TypeError);
  assert.throws(() => Object.assign(store.state.figures, { x: 1 }), TypeError);
  store.act("act.theme", (state) => ({ ...state, theme: state.theme }));
  assert.equal(store.undoable, false);
});

test("a point keeps only what differs from its preset, and a figure only what was changed", () => {
  let state = withPoint(INITIAL, { Omega: 1.6, k0: 0.4 });
  assert.deepEqual(state.point, { k0: 0.4 });
  state = withPoint(state, { k0: undefined, zeta_p: 0.1 });
  assert.deepEqual(state.point, { zeta_p: 0.1 });
  assert.deepEqual(withPreset(state, "12a").point, {});
  assert.equal(pointOf(withPreset(state, "12a")).Omega, 3.65);
  const changed = withFigure(state, "fig-3", { hidden: ["a"] });
  assert.deepEqual(figureOf(changed, "fig-3").hidden, ["a"]);
  assert.deepEqual(withFigure(changed, "fig-3", { hidden: [] }).figures, {});
});

test("a figure that shares the point moves it, and leaves to itself what it does not share", () => {
  const store = new Store();
  store.share("fig-1", ["k0", "Omega"]);
  store.give("fig-1", { ...store.given("fig-1"), Omega: 3, F: 2 });
  assert.deepEqual(store.state.point, { Omega: 3 });
  assert.deepEqual(givenOf(store.state, "fig-1"), { F: 2 });
  assert.deepEqual(store.given("fig-1"), { F: 2, k0: 0.5, Omega: 3 });
  store.give("fig-1", {});
  assert.deepEqual([store.state.point, store.state.figures], [{}, {}]);
});

test("what a figure's attributes give counts where nothing was given, and is nobody's action", () => {
  const store = new Store({ figures: { "fig-3": figureOf(withFigure(INITIAL, "fig-3", { given: { k0: 0.3 } }), "fig-3") } });
  store.start("fig-3", { k0: 0.9 });
  store.start("fig-4", { k: 6 });
  assert.deepEqual([store.given("fig-3"), store.given("fig-4"), store.undoable], [{ k0: 0.3 }, { k: 6 }, false]);
});

test("subscribers are told of every change, with what was before, until they end it", () => {
  const store = new Store();
  /** @type {string[]} */
  const told = [];
  const end = store.subscribe((state, before) => told.push(`${before.theme} ${state.theme}`));
  store.act("act.theme", (state) => ({ ...state, theme: "dark" }));
  store.undo();
  end();
  store.redo();
  assert.deepEqual(told, ["auto dark", "dark auto"]);
});

test("the figures that were changed stand in one order, however they came there: a long history shares their shape", () => {
  const keys = ["fig-11a", "fig-T", "fig-3", "fig-14b", "fig-1"];
  for (let seed = 1; seed <= 20; seed += 1) {
    const choose = random(seed);
    let state = INITIAL;
    for (let step = 0; step < 30; step += 1) {
      const taken = choose.integer(0, 3) === 0;
      state = withFigure(state, choose.of(keys), { given: taken ? {} : { k0: choose.next() } });
      const names = Object.keys(state.figures);
      assert.deepEqual(names, [...names].sort(), `seed ${seed}, step ${step}`);
    }
  }
});
