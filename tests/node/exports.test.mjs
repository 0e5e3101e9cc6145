// What is taken away: files say whence they come and how good their numbers are; the numbers are the figure's; what was saved
// opens as it was, and nothing else does.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { colophon, colophonLines } from "../../www/exports/colophon.js";
import { csv } from "../../www/exports/csv.js";
import { embedCode, link, stateAt, stateOf } from "../../www/exports/link.js";
import { described } from "../../www/exports/png.js";
import { opened, saved, wholeState } from "../../www/exports/saved.js";
import { script } from "../../www/exports/script.js";
import { dressed } from "../../www/exports/svg.js";
import { FURNITURE } from "../../www/figure/furniture.js";
import { PRESETS } from "../../www/presets.js";
import { INITIAL, UNTOUCHED, withPoint } from "../../www/state.js";
import { parse, write } from "../../www/url.js";
import { words } from "../../www/words/en/exports.js";
import { random } from "./random.mjs";
import { known, randomState } from "./states.mjs";
import { gear } from "./support.mjs";

/** @typedef {import("../../www/engine/gear-bifurcations.js").Figure} Figure */

const DIST = fileURLToPath(new URL("../../dist/", import.meta.url));
const RELEASE = { version: "1.2.3", commit: "abc" };
const SAVED = "2026-01-02T03:04:05.000Z";
/** What would end a comment, an element or a cell where it is not kept from it. */
const HOSTILE = 'a "b", </script> & ]]>\r\nimport x\u2028# y';

/** @param {Figure} figure @param {string} [state] */
function told(figure, state = "story&v=1&at=fig-2") {
  return colophon(figure, { link: `https://host.example/#${state}`, state, release: RELEASE, saved: SAVED });
}

const figures = new Map(["1", "2", "11a", "T", "E", "L"].map((id) => [id, /** @type {Figure} */ (gear.figure(id, { k0: 0.45 }))]));

/** @param {string} id */
const figureOf = (id) => /** @type {Figure} */ (figures.get(id));

/** @param {unknown} value */
const plain = (value) => JSON.parse(JSON.stringify(value, (_, inner) => (ArrayBuffer.isView(inner) ? Array.from(/** @type {Float64Array} */ (inner)) : inner)));

test("every file says link, version, method, errors and distances, a line each, with decimal points", () => {
  const figure = figureOf("2");
  const lines = colophonLines(told({ ...figure, method: `${figure.method} ${HOSTILE}` }));
  assert.ok(lines.every((line) => !/[\r\n\u2028\u2029]/.test(line)));
  const all = lines.join("\n");
  assert.match(all, /^link: https:\/\/host\.example\/#story&v=1&at=fig-2$/m);
  assert.match(all, /^version: 1\.2\.3 \(commit abc\)$/m);
  assert.match(all, /^parameters: m_p = 1, .*k0 = 0\.45/m);
  assert.match(all, /^error: .*residual = \d/m);
  assert.equal(lines.filter((line) => line.startsWith("theory minus exact: ")).length, figure.distances.length);
  assert.ok(figure.distances.length > 0);
  assert.doesNotMatch(all, /\u2212/);
});

for (const id of figures.keys()) {
  test(`the table of figure ${id} holds its numbers, to the last digit`, () => {
    const figure = figureOf(id);
    const lines = csv(figure, [...colophonLines(told(figure)), HOSTILE]).trimEnd().split("\n");
    const comments = lines.filter((line) => line.startsWith("# "));
    assert.ok(lines.slice(0, comments.length).every((line) => line.startsWith("# ")), "comments lead");
    const [names, ...rows] = lines.slice(comments.length).map(cells);
    assert.ok(rows.every((row) => row.length === names.length));
    const column = (/** @type {string} */ name) => rows.map((row) => row[names.indexOf(name)]);
    if (figure.table !== null) {
      assert.deepEqual(column("exact"), figure.table.map(({ exact }) => (typeof exact === "number" ? String(exact) : exact === null ? "" : exact.replace(/[*\\]/g, ""))));
    } else if (figure.motion !== null) {
      assert.deepEqual(column("u_p").map(Number), Array.from(figure.motion.u_p));
    } else {
      const told = figure.series.filter(({ role, mark, columns }) => !FURNITURE.has(role) && mark !== "text" && columns.x.length > 0);
      // A zero has no sign in a file.
      const values = told.flatMap(({ mark, columns: { x, y, z } }) => Array.from((mark === "field" ? z : y) ?? [], (value) => [mark, value + 0, x.length]));
      const read = rows.map((row) => {
        const [frame, name] = row;
        const { mark, columns } = told.find((series) => series.frame === frame && series.name === name) ?? assert.fail(`no series ${name}`);
        return [mark, Number(mark === "field" ? row[7] : row[6]), columns.x.length];
      });
      assert.deepEqual(read, values);
    }
  });
}

/** The cells of a line as RFC 4180 has them. @param {string} line */
function cells(line) {
  return [...line.matchAll(/(?:^|,)(?:"((?:[^"]|"")*)"|([^,]*))/g)].map(([, quoted, bare]) => quoted?.replaceAll('""', '"') ?? bare);
}

test("a figure's own parameters, given back, make the same figure", () => {
  for (const [id, figure] of figures) assert.deepEqual(plain(gear.figure(id, figure.params)), plain(figure), id);
});

test("the script runs in Node and yields the figure's data", () => {
  const folder = mkdtempSync(join(tmpdir(), "gear-exports-"));
  try {
    for (const id of ["2", "11a", "1"]) {
      const figure = figureOf(id);
      const name = `gear-bifurcations-${id}.mjs`;
      writeFileSync(join(folder, name), script({ ...told(figure), title: HOSTILE }, `https://host.example/${HOSTILE}`, name));
      const made = execFileSync(process.execPath, [join(folder, name), DIST], { encoding: "utf8", maxBuffer: 1e8 });
      assert.deepEqual(JSON.parse(made), plain(figure), id);
    }
  } finally {
    rmSync(folder, { recursive: true });
  }
});

test("what was saved opens as it was: state and numbers", () => {
  const choose = random(4711);
  const figure = figureOf("11a");
  for (let run = 0; run < 300; run += 1) {
    const state = randomState(choose);
    const text = saved(figure, told(figure, wholeState(state)), "fig-11a");
    const found = opened(text, "figure.json", known);
    assert.ok("state" in found, JSON.stringify(found));
    assert.deepEqual(found.problems, []);
    assert.deepEqual(found.state, state);
    assert.equal(found.element, "fig-11a");
  }
  const { data, format, formatVersion, link: address } = JSON.parse(saved(figure, told(figure), "fig-11a"));
  assert.deepEqual(data, plain(figure));
  assert.deepEqual([format, formatVersion], ["gear-bifurcations figure", 1]);
  assert.match(address, /^https:/);
});

test("the whole state says what an address leaves to the reader", () => {
  for (const state of [INITIAL, { ...INITIAL, view: /** @type {const} */ ("lab") }, { ...INITIAL, theme: /** @type {const} */ ("dark"), projector: true }]) {
    const { state: read, problems } = parse(wholeState(state), known);
    assert.deepEqual(problems, []);
    assert.deepEqual({ ...INITIAL, theme: null, projector: null, language: null, ...read }, state);
  }
});

/** What is brought instead, and what is said of it. @type {[string, string][]} */
const OTHERS = [
  ["", "empty"],
  [" \n", "empty"],
  ["\ufffdPNG\r\n\u001a\n\0\0", "picture"],
  ["GIF89a", "picture"],
  ['<?xml version="1.0"?>\n<svg xmlns="http://www.w3.org/2000/svg"/>', "picture"],
  [gear.svg("2"), "picture"],
  ["<!DOCTYPE html><title>x</title>", "page"],
  ["# gear-bifurcations, figure 2: x\nframe", "table"],
  ["// gear-bifurcations, figure 2: x", "script"],
  ["Omega;k0\n1,6;0,5", "other"],
  ["{", "broken"],
  ['{"format": "gear-bifurcations figure", "st', "broken"],
  ["[]", "foreign"],
  ["null", "foreign"],
  ["3", "foreign"],
  ['{"type": "FeatureCollection"}', "foreign"],
  ['{"format": "gear-bifurcations answers", "version": 1}', "answers"],
  ['{"format": "gear-bifurcations figure"}', "damaged"],
  ['{"format": "gear-bifurcations figure", "formatVersion": 1}', "damaged"],
  ['{"format": "gear-bifurcations figure", "formatVersion": 1, "state": 3}', "damaged"],
  ['{"format": "gear-bifurcations figure", "formatVersion": 2, "state": "story"}', "newer"],
  ["[".repeat(200_000), "other"],
];

test("a wrong, foreign or broken file is told for what it is", () => {
  for (const [text, kind] of OTHERS) {
    const found = opened(text, "x.json", known);
    assert.ok("word" in found, text.slice(0, 40));
    assert.equal(found.word, `export.open.${kind}`, text.slice(0, 40));
    assert.ok(found.word in words);
  }
  const long = opened("", "x".repeat(1000), known);
  assert.ok("values" in long && String(long.values.name).length < 80);
});

test("no mutation of a saved file is an exception; what opens can be written again", () => {
  const choose = random(20261126);
  const figure = figureOf("2");
  const start = saved({ ...figure, series: figure.series.slice(0, 1) }, told(figure, wholeState(randomState(choose))), "fig-2");
  let refusals = 0;
  for (let run = 0; run < 4000; run += 1) {
    let text = start;
    for (let count = choose.integer(1, 4); count > 0; count -= 1) text = mutated(text, choose);
    const found = opened(text, "figure.json", known);
    if ("word" in found) {
      refusals += 1;
      assert.ok(found.word in words, found.word);
      continue;
    }
    assert.deepEqual(parse(write(found.state), known).problems, [], write(found.state));
  }
  assert.ok(refusals > 1000 && refusals < 3900, `${refusals} of 4000`);
});

/** @param {string} text @param {import("./random.mjs").Choose} choose */
function mutated(text, choose) {
  // Most of a file is numbers, to which nothing happens: what is read stands in front.
  const at = choose.integer(0, choose.chance(0.7) ? Math.min(900, text.length) : text.length);
  const length = choose.integer(1, choose.chance(0.1) ? 2000 : 12);
  switch (choose.integer(0, 6)) {
    case 0:
      return text.slice(0, at);
    case 1:
      return text.slice(0, at) + text.slice(at + length);
    case 2:
      return text.slice(0, at) + choose.of(["null", "{}", "[", '"', "\\u0000", "-1e999", "%", "&omega=", "=", "\ud800", "__proto__", "}"]) + text.slice(at);
    case 3:
      return text.slice(0, at) + text.slice(at, at + length) + text.slice(at);
    case 4:
      return text.slice(0, at) + String.fromCharCode(choose.integer(1, 0xffff)) + text.slice(at + 1);
    case 5:
      return text.replace(/"state":"[^"]*"/, () => `"state":${choose.of(["null", "7", '""', '"lab&v=9"', '"=&=&="', '"lab&v=1&k0=0.3&k0=2"', '{"a":1}'])}`);
    default:
      return text.replace(/"formatVersion":\d+/, () => `"formatVersion":${choose.of(["0", "1", "1.5", "2", '"1"', "null", "1e400"])}`);
  }
}

test("a picture's chunks are sound, and stand after its head", () => {
  const png = new Uint8Array(readFileSync(new URL("../../docs/screens/class-wide-light.png", import.meta.url)));
  const of = told(figureOf("2"));
  const before = chunks(png);
  const after = chunks(described(png, of, 2));
  assert.deepEqual(after.filter(({ type }) => !["iTXt", "pHYs"].includes(type)).map(({ type }) => type), before.map(({ type }) => type));
  assert.equal(after[0].type, "IHDR");
  const texts = new Map(after.filter(({ type }) => type === "iTXt").map(({ content }) => {
    const [keyword, ...rest] = new TextDecoder().decode(content).split("\0");
    return [keyword, rest.slice(4).join("\0")];
  }));
  assert.equal(texts.get("Source"), of.link);
  assert.deepEqual(JSON.parse(texts.get("gear-bifurcations") ?? ""), plain(of));
  const dots = after.find(({ type }) => type === "pHYs") ?? assert.fail("no size");
  // 2 x 96 dots an inch.
  assert.equal(new DataView(dots.content.buffer, dots.content.byteOffset).getUint32(0), 7559);
});

/** The chunks of a PNG file, whose sums are checked by a table. @param {Uint8Array} png */
function chunks(png) {
  const bits = [1, 2, 3, 4, 5, 6, 7, 8];
  const table = Array.from({ length: 256 }, (_, byte) => bits.reduce((sum) => (sum & 1 ? 0xedb88320 ^ (sum >>> 1) : sum >>> 1), byte));
  const view = new DataView(png.buffer, png.byteOffset);
  const found = [];
  for (let at = 8; at < png.length; ) {
    const length = view.getUint32(at);
    const body = png.subarray(at + 4, at + 8 + length);
    let sum = -1;
    for (const byte of body) sum = table[(sum ^ byte) & 255] ^ (sum >>> 8);
    const type = new TextDecoder().decode(body.subarray(0, 4));
    assert.equal((sum ^ -1) >>> 0, view.getUint32(at + 8 + length), `the sum of ${type}`);
    found.push({ type, content: body.slice(4) });
    at += 12 + length;
  }
  return found;
}

test("a drawing keeps its size on paper and says what it is", () => {
  const figure = figureOf("2");
  const of = { ...told(figure), title: HOSTILE };
  const drawn = gear.svg(figure, {}, { unit: "mm", theme: "print" });
  const face = { family: "STIX Two Text", style: "normal", weight: "400", address: "data:font/woff2;base64,AA==" };
  const text = dressed(drawn, of, [face]);
  assert.match(text, /^<svg [^>]*width="174mm"[^>]*>\n<title>[^]*<\/desc>\n<metadata>/);
  const [metadata] = /<metadata>[^]*<\/metadata>\n/.exec(text) ?? [""];
  const inside = /<gear:figure [^>]*>([^<]*)<\/gear:figure>/.exec(metadata)?.[1] ?? "";
  const unescaped = inside.replaceAll("&lt;", "<").replaceAll("&gt;", ">").replaceAll("&amp;", "&");
  assert.deepEqual(JSON.parse(unescaped), plain(of));
  assert.equal(text.replace(metadata, "").replace(/<style>[^]*?<\/style>\n/, ""), drawn);
});

test("a link and the lines for embedding show the same", () => {
  const state = withPoint({ ...INITIAL, view: "lab" }, { k0: 0.3 });
  assert.equal(link("https://a.example/", stateAt(state, "lab-T")), "https://a.example/#lab&v=1&k0=0.3");
  assert.equal(stateAt(state, "fig-3").view, "story");
  for (const id of PRESETS) {
    const alone = stateOf(id, { Omega: 1.7, k0: 0.3 }, UNTOUCHED);
    const { state: read, problems } = parse(write(alone), { ...known, isPlace: () => true });
    assert.deepEqual(problems, []);
    assert.deepEqual({ ...INITIAL, ...read }, alone);
  }
  const code = embedCode("https://a.example/gear/", "11a", { Omega: 1.6, alpha: -0.2, k0: 0.5 });
  assert.equal(code, '<script type="module" src="https://a.example/gear/gear-figure.js"></script>\n<gear-figure figure="11a" omega="1.6"></gear-figure>\n');
  assert.match(embedCode(null, "2", {}), /^<!-- .* -->\n<script type="module" src="https:\/\/host\.example/);
  assert.match(embedCode("file:///home/reader/", "2", {}), /host\.example/);
});
