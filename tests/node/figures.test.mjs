// Figures as plain data: there and back, drawn in a worker, computed in pieces; spoilt ones refused.

import assert from "node:assert/strict";
import { before, test } from "node:test";
import { Worker } from "node:worker_threads";
import { allFinite, gear, load, refused, script, secondsComputed } from "./support.mjs";

/** @typedef {import("../../www/engine/gear-bifurcations.js").Figure} Figure */
/** @typedef {import("../../www/engine/gear-bifurcations.js").FigureInfo} FigureInfo */

const IDS = "1 2 3 4 5 6 7 8 9 10 11a 11b 11c 12a 12b 12c 13a 13b 13c 14a 14b T B M S L A U P W E".split(" ");
/** @type {Map<string, Figure>} */
const figures = new Map();

before(() => {
  for (const id of IDS) figures.set(id, gear.figure(id));
});

/** @param {string} id @returns {any} */
function copy(id) {
  return structuredClone(figures.get(id));
}

test("figures() tells of every figure, with its own defaults", () => {
  /** @type {any[]} */
  const infos = gear.figures();
  assert.deepEqual(
    infos.map((info) => info.id),
    IDS,
  );
  allFinite(infos, "figures");
  for (const info of infos) {
    assert.deepEqual(Object.keys(info), "id title caption parameters turnable animated aspect heavy divisible".split(" "));
    assert.ok(info.title.length > 5 && info.caption.length > 40 && info.aspect > 0.3 && info.aspect < 4);
    assert.ok(info.parameters.length > 0);
    const own = Object.fromEntries(info.parameters.map((/** @type {any} */ control) => [control.name, control.default]));
    const { params } = /** @type {any} */ (figures.get(info.id));
    for (const control of info.parameters) {
      const names = control.sets ?? [control.name];
      for (const name of names) assert.equal(params[name], control.default, `${info.id}: ${name} by default`);
      if (control.name !== "regime") assert.ok(control.slider[0] < control.slider[1] && control.low <= control.default);
    }
    assert.deepEqual(gear.figure(info.id, own).series, figures.get(info.id)?.series, `${info.id}: its controls say what it shows`);
    assert.equal(info.animated, figures.get(info.id)?.motion !== null);
    assert.equal(info.turnable, figures.get(info.id)?.axes.some((frame) => frame.z !== null));
  }
  const presets = Object.fromEntries(infos.map((info) => [info.id, figures.get(info.id)?.params]));
  assert.deepEqual([presets["11a"]?.zeta, presets["11a"]?.Omega, presets["11a"]?.alpha_p], [0.052, 1.55, -0.2]);
  assert.deepEqual([presets["14b"]?.zeta, presets["14b"]?.alpha_g, presets["14b"]?.F], [0.07, -1.3, 1.5]);
});

test("figures with theory and exact answer give the distance between them, and every exact one its errors", () => {
  for (const id of "2 3 4 5 6 7 8 9 10 11a 11b 11c 12a 12b 12c 13a 13b 13c T B".split(" ")) {
    const { distances, error } = /** @type {Figure} */ (figures.get(id));
    assert.ok(distances.length > 0, `figure ${id}`);
    for (const { what, axis, at, theory, exact, difference } of distances) {
      assert.ok(what.length > 5 && (axis === null) === (at === null), `figure ${id}: ${what}`);
      assert.equal(difference, theory - exact);
      // They are of the same thing: a formula of first order is off by some part of what it says.
      assert.ok(Math.abs(difference) < 3 * Math.max(Math.abs(theory), Math.abs(exact)), `figure ${id}: ${what}`);
    }
    const errors = Object.values(error);
    assert.ok(errors.length > 0 && errors.every((value) => value >= 0), `figure ${id}: ${JSON.stringify(error)}`);
    // Among many branches there are orbits with multipliers up to 10,000, and of tori a line is drawn through some dozen.
    const most = ["7", "9", "10", "B"].includes(id) ? 5e-5 : 1e-5;
    assert.ok(errors.every((value) => value < most), `figure ${id}: ${JSON.stringify(error)}`);
  }
  for (const id of ["14a", "14b", "M", "S", "L", "A", "1"]) {
    assert.ok(Object.keys(/** @type {Figure} */ (figures.get(id)).error).length > 0, `figure ${id}`);
  }
  const { summary, distances } = /** @type {Figure} */ (figures.get("B"));
  assert.ok(summary.includes(`a distance of ${Number(distances[0].difference.toPrecision(3))}`), summary);
});

test("figure() has the shape of the contract and holds no number that is not finite", () => {
  for (const [id, figure] of figures) {
    assert.deepEqual(
      Object.keys(figure),
      "id title params grid axes series summary notes facts distances method error table end orbits motion".split(" "),
    );
    assert.equal(figure.id, id);
    allFinite(figure, id);
    assert.ok(figure.summary.length > 20 && figure.method.length > 5);
    const frames = figure.axes.map((frame) => frame.frame);
    assert.equal(new Set(frames).size, frames.length);
    for (const frame of figure.axes) {
      assert.deepEqual(Object.keys(frame), "frame title x y z bar cell span equalAspect bare".split(" "));
      assert.ok(frame.x.low < frame.x.high && frame.y.low < frame.y.high);
    }
    for (const series of figure.series) {
      assert.deepEqual(
        Object.keys(series),
        "frame name meaning stable role mark label labelAt columns pieces".split(" "),
      );
      assert.ok(frames.includes(series.frame) && series.role && series.mark, `${id}: ${series.name}`);
      assert.ok(series.columns.x instanceof Float64Array && series.pieces instanceof Uint32Array);
      const { x, y, z } = series.columns;
      if (series.mark === "field") assert.equal(z?.length, x.length * y.length);
      else assert.equal(x.length, y.length);
    }
  }
});

test("figure() takes parameters over its preset, and says with which it was computed", () => {
  const figure = gear.figure("11c", { Omega: 1.66, m_g: 1 });
  assert.deepEqual([figure.params.Omega, figure.params.zeta, figure.params.regime], [1.66, 0.02, "homogeneous"]);
  assert.notDeepEqual(figure.series, figures.get("11c")?.series);
});

test("a figure survives structuredClone and is drawn the same: svg(figure) equals svg(id)", () => {
  for (const id of IDS) {
    const text = gear.svg(id);
    assert.ok(text.startsWith("<svg") && text.trimEnd().endsWith("</svg>"), id);
    assert.doesNotMatch(text, /NaN|Infinity|undefined/, id);
    assert.equal(gear.svg(copy(id)), text, id);
  }
});

test("a figure survives JSON: lists of numbers serve as columns", () => {
  for (const id of ["1", "3", "11c"]) {
    const revived = JSON.parse(
      JSON.stringify(figures.get(id), (_, value) => (ArrayBuffer.isView(value) ? Array.from(/** @type {any} */ (value)) : value)),
    );
    assert.equal(gear.svg(revived), gear.svg(id), id);
  }
});

test("svg() shows a window of the axes and leaves out what is hidden", () => {
  const figure = gear.figure("2");
  const [{ frame, x }] = figure.axes;
  const middle = (x.low + x.high) / 2;
  const windows = { [frame]: { x: /** @type {[number, number]} */ ([middle, x.high]) } };
  const half = gear.svg(figure, {}, { view: { windows } });
  assert.notEqual(half, gear.svg(figure));
  const [first] = figure.series.filter((/** @type {any} */ { mark }) => mark === "curve");
  const less = gear.svg(figure, {}, { view: { hidden: [first.name] } });
  assert.ok(!less.includes(`data-series="${first.name}"`) && gear.svg(figure).includes(`data-series="${first.name}"`));
});

test("svg() on paper: millimetres, points, every theme", () => {
  for (const theme of /** @type {const} */ (["light", "dark", "projector", "contrast", "contrast-dark", "print"])) {
    const text = gear.svg("3", {}, { width: 84, height: 70, unit: "mm", theme });
    assert.match(text, /^<svg[^>]*width="84mm" height="70mm"/);
    assert.ok(!/(font-size|stroke-width)="[\d.]+"/.test(text), "every size and width has its unit");
  }
  const print = gear.svg("2", {}, { width: 84, height: 60, unit: "mm", theme: "print" });
  const widths = [...print.matchAll(/stroke-width="([\d.]+)pt"/g)].map(([, width]) => Number(width));
  assert.ok(Math.min(...widths) >= 0.4, `${Math.min(...widths)} pt would not be printed everywhere`);
  const sizes = [...print.matchAll(/font-size="([\d.]+)pt"/g)].map(([, size]) => Number(size));
  assert.ok(Math.max(...sizes) >= 8 && Math.max(...sizes) <= 12, `${Math.max(...sizes)} pt`);
});

test("svg() takes size, theme, view and time", () => {
  const wide = gear.svg("3", {}, { width: 1000, height: 400 });
  assert.match(wide, /^<svg[^>]*width="1000"[^>]*height="400"/);
  const all = [
    gear.svg("3"),
    gear.svg("3", {}, { theme: "dark" }),
    gear.svg("3", {}, { view: { azimuth: 1.2 } }),
    gear.svg("3", {}, { view: { elevation: 1 } }),
    gear.svg("3", { k0: 0.3 }),
  ];
  assert.equal(new Set(all).size, all.length);
  const moving = [0, 1, 2].map((time) => gear.svg("1", {}, { view: { time } }));
  assert.equal(new Set(moving).size, 3, "figure 1 moves");
  assert.equal(gear.svg(copy("1"), {}, { view: { time: 2 } }), moving[2], "from its data alone, too");
  const { motion } = /** @type {Figure} */ (figures.get("1"));
  const length = Number(motion?.t.at(-1));
  const later = gear.svg("1", {}, { view: { time: 1e9 } });
  assert.ok(length > 1 && later.length > 1000, "any time is within the loop");
});

test("progress() ends with the same figure as figure(), in steps that leave room", () => {
  for (const { id, heavy } of gear.figures()) {
    let steps = 0;
    let longest = 0;
    let last;
    let started = secondsComputed();
    for (const step of gear.progress(id)) {
      longest = Math.max(longest, secondsComputed() - started);
      steps += 1;
      assert.ok(!last?.done, "nothing after the last");
      last = step;
      allFinite(step, id);
      started = secondsComputed();
    }
    assert.equal(last?.done, true);
    assert.deepEqual(last?.figure, figures.get(id), id);
    if (heavy && id.startsWith("12")) assert.ok(steps > 2, `${id}: ${steps} steps`);
    assert.ok(longest < 0.5, `${id}: a step of ${longest} s`);
  }
});

test("progress(): what is there so far can be drawn, and leaving early ends it", () => {
  let steps = 0;
  for (const { figure, done } of gear.progress("12a")) {
    assert.match(gear.svg(figure), /^<svg/);
    assert.equal(done, false);
    steps += 1;
    if (steps === 2) break;
  }
  const job = gear.progress("12a");
  assert.equal(job[Symbol.iterator](), job);
  job.next();
  assert.deepEqual(job.return(), { value: undefined, done: true });
  assert.deepEqual(job.return(), { value: undefined, done: true }, "twice does no harm");
  assert.deepEqual(job.next(), { value: undefined, done: true });
});

test("a worker computes and draws the same, from the compiled module", async () => {
  const source = `
    const { parentPort, workerData } = require("node:worker_threads");
    import(workerData.script).then(async ({ load }) => {
      const gear = await load(workerData.module);
      const figure = gear.figure("9");
      let refusal;
      try { gear.figure("9", { k0: 2 }); } catch (error) { refusal = error.toJSON(); }
      parentPort.postMessage({ figure, svg: gear.svg("9"), refusal });
    });
  `;
  const worker = new Worker(source, { eval: true, workerData: { script, module: gear.module } });
  const answer = await new Promise((resolve, reject) => {
    worker.once("message", resolve);
    worker.once("error", reject);
  });
  await worker.terminate();
  assert.deepEqual(answer.figure, figures.get("9"));
  assert.equal(answer.svg, gear.svg("9"));
  assert.equal(gear.svg(answer.figure), answer.svg);
  assert.equal(answer.refusal.code, "out-of-range");
});

/** What spoils a figure, and the part that the refusal must name. @type {[string, (figure: any) => unknown, string][]} */
const SPOILT = [
  ["no id", (f) => delete f.id, "id"],
  ["a title that is none", (f) => (f.title = 7), "title"],
  ["no parameters", (f) => delete f.params, "params"],
  ["no grid", (f) => delete f.grid, "grid"],
  ["a grid of nothing", (f) => (f.grid = [0, 0]), "grid"],
  ["a huge grid", (f) => (f.grid = [1e9, 1e9]), "grid"],
  ["a fractional grid", (f) => (f.grid = [1.5, 1]), "grid"],
  ["no axes", (f) => (f.axes = []), "axes"],
  ["axes of null", (f) => (f.axes = null), "axes"],
  ["a thousand axes", (f) => (f.axes = Array(1000).fill(f.axes[0])), "axes"],
  ["an axis that is not there", (f) => delete f.axes[0].x, "axes[0].x"],
  ["an axis without a range", (f) => (f.axes[0].x.high = f.axes[0].x.low), "axes[0].x"],
  ["an axis turned round", (f) => (f.axes[0].y.low = 1e9), "axes[0].y"],
  ["an axis to infinity", (f) => (f.axes[0].y.high = Infinity), "axes[0].y.high"],
  ["an axis wider than numbers", (f) => Object.assign(f.axes[0].x, { low: -1.7e308, high: 1.7e308 }), "axes[0].x"],
  ["a label that is none", (f) => (f.axes[0].x.label = null), "axes[0].x.label"],
  ["an endless label", (f) => (f.axes[0].x.label = "x".repeat(1e6)), "axes[0].x.label"],
  ["a cell outside", (f) => (f.axes[0].cell = [9, 9]), "axes[0]"],
  ["a span of nothing", (f) => (f.axes[0].span = [0, 1]), "axes[0].span"],
  ["a flag that is none", (f) => (f.axes[0].bare = 1), "axes[0].bare"],
  ["two frames of one name", (f) => f.axes.push(f.axes[0]), "axes"],
  ["series of null", (f) => (f.series = null), "series"],
  ["endless series", (f) => (f.series = { length: 1e12 }), "series"],
  ["a series that is null", (f) => (f.series[0] = null), "series[0]"],
  ["a frame that is not there", (f) => (f.series[0].frame = "nowhere"), "series[0].frame"],
  ["a frame by number", (f) => (f.series[0].frame = 0), "series[0].frame"],
  ["a role that does not exist", (f) => (f.series[0].role = "hero"), "series[0].role"],
  ["a mark that does not exist", (f) => (f.series[0].mark = ""), "series[0].mark"],
  ["stability in words", (f) => (f.series[0].stable = "yes"), "series[0].stable"],
  ["a label's place that is none", (f) => (f.series[0].labelAt = NaN), "series[0].labelAt"],
  ["no columns", (f) => delete f.series[0].columns, "series[0].columns"],
  ["a column that is no list", (f) => (f.series[0].columns.x = 3), "series[0].columns.x"],
  ["a column of texts", (f) => (f.series[0].columns.x = ["1", "2"]), "series[0].columns.x"],
  ["a column with NaN", (f) => (f.series[0].columns.y[0] = NaN), "series[0].columns.y"],
  ["a column with infinity", (f) => (f.series[0].columns.x[0] = -Infinity), "series[0].columns.x"],
  ["columns of two lengths", (f) => (f.series[0].columns.x = new Float64Array(1)), "series[0]"],
  ["a third column in a plane", (f) => (f.series[0].columns.z = f.series[0].columns.x), "series[0]"],
  ["an endless column", (f) => (f.series[0].columns.x = { length: 1e12 }), "series[0].columns.x"],
  ["pieces that fall", (f) => (f.series[0].pieces = new Uint32Array([1, 0])), "series[0]"],
  ["pieces beyond the end", (f) => (f.series[0].pieces = new Uint32Array([4e9])), "series[0].pieces"],
  ["pieces in between", (f) => (f.series[0].pieces = [0.5]), "series[0].pieces"],
  ["a summary that is none", (f) => (f.summary = {}), "summary"],
  ["notes that are none", (f) => (f.notes = [1]), "notes[0]"],
  ["an error estimate in words", (f) => (f.error = { step: "small" }), "error.step"],
];

test("a spoilt figure object is refused, naming the part", () => {
  for (const [what, spoil, part] of SPOILT) {
    const figure = copy("2");
    spoil(figure);
    const error = refused(() => gear.svg(figure), { code: "drawing" }, what);
    assert.ok(error.parameter?.startsWith(part), `${what}: names ${part}, not ${error.parameter}`);
  }
  const moved = copy("1");
  moved.motion.t = new Float64Array(2);
  refused(() => gear.svg(moved), { code: "drawing" }, "columns of a motion of two lengths");
  refused(() => gear.svg({ ...copy("1"), motion: 3 }), { code: "drawing" }, "a motion that is none");
  refused(() => gear.svg({ ...copy("2"), id: "99" }), { code: "unknown-figure" });
  refused(() => gear.svg({ ...copy("2"), params: { k0: 7 } }), { code: "out-of-range", parameter: "k0" });
  refused(() => gear.svg({ ...copy("2"), params: 7 }), { code: "not-an-object" });
  for (const object of [null, {}, [], new Map(), Object.create(null), new Proxy({}, { get() { throw new Error("trap"); } })]) {
    refused(() => gear.svg(object));
  }
});

test("two million points are drawn, and one more is refused", () => {
  const figure = copy("11c");
  const series = figure.series.find((/** @type {any} */ one) => one.mark === "cloud") ?? figure.series[0];
  const most = 2_000_000;
  const column = new Float64Array(most).map((_, i) => Math.sin(i));
  figure.series = [{ ...series, columns: { x: column, y: column }, pieces: [], label: null }];
  assert.match(gear.svg(figure), /^<svg/);
  figure.series.push({ ...series, columns: { x: [0], y: [0] }, pieces: [], label: null });
  refused(() => gear.svg(figure), { code: "drawing" });
});

test("a figure can be altered and drawn: it is plain data", async () => {
  const own = await load();
  const figure = copy("2");
  figure.title = "Mine <&> \"yours\"";
  figure.series = figure.series.slice(0, 1);
  const text = own.svg(figure);
  assert.match(text, /Mine &lt;&amp;&gt;/);
});
