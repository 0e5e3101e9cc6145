// All words of the page: German says everything that English says, in sentences with the same holes, and no key is used
// that nobody knows.

import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { test } from "node:test";
import { german } from "../../www/words/de/index.js";
import { ATTRIBUTES } from "../../www/words/page.js";
import { learn, number, say, speak } from "../../www/words/say.js";
import { marked } from "./document.mjs";

const root = new URL("../../", import.meta.url);

/** The English of every room. @type {Record<string, string>} */
const english = {};
for (const name of readdirSync(new URL("www/words/en/", root))) {
  const { words } = await import(new URL(`www/words/en/${name}`, root).href);
  for (const [key, sentence] of Object.entries(words)) {
    assert.ok(!(key in english), `${key} stands in two rooms`);
    english[key] = sentence;
  }
}
/** The English of the document itself. */
const documents = readdirSync(root).filter((name) => name.endsWith(".html"));
const inDocuments = documents.flatMap((name) => marked(readFileSync(new URL(name, root), "utf8"), ATTRIBUTES));

const holes = (/** @type {string} */ sentence) => [...sentence.matchAll(/\{(\w+)\}/g)].map(([, name]) => name).sort();

test("German has every key of English and no other", () => {
  const keys = [...Object.keys(english), ...inDocuments.map(({ key }) => key)];
  assert.deepEqual(Object.keys(german).sort(), [...new Set(keys)].sort());
});

test("a sentence has the same holes in both", () => {
  for (const [key, sentence] of Object.entries(english)) assert.deepEqual(holes(german[key]), holes(sentence), key);
});

test("a sentence of the document keeps its elements: each stands once in the German one", () => {
  for (const { key, children, attribute } of inDocuments) {
    const tags = [...german[key].matchAll(/<(\d+)\/?>/g)].map(([, index]) => Number(index));
    const top = children.length;
    if (attribute !== null) {
      assert.deepEqual(tags, [], `${key} is an attribute`);
      continue;
    }
    assert.deepEqual(outer(german[key]), Array.from({ length: top }, (_, index) => index), key);
    assert.doesNotMatch(german[key].replace(/<\/?\d+\/?>/g, ""), /<|&\w+;/, `${key}: plain text and numbered tags`);
  }
});

/** The numbers of the outermost tags, sorted. @param {string} sentence */
function outer(sentence) {
  /** @type {number[]} */
  const found = [];
  let depth = 0;
  for (const [tag, index] of sentence.matchAll(/<\/?(\d+)\/?>/g)) {
    if (tag.startsWith("</")) {
      depth -= 1;
      continue;
    }
    if (depth === 0) found.push(Number(index));
    if (!tag.endsWith("/>")) depth += 1;
  }
  return found.sort((one, other) => one - other);
}

test("one key says one thing in the document", () => {
  /** @type {Map<string, string>} */
  const said = new Map();
  for (const { key, text } of inDocuments) {
    assert.equal(said.get(key) ?? text, text, key);
    said.set(key, text);
  }
});

test("every key that the sources say is known", () => {
  const known = new Set([...Object.keys(english), ...inDocuments.map(({ key }) => key)]);
  let used = 0;
  for (const file of readdirSync(new URL("www/", root), { recursive: true, encoding: "utf8" })) {
    if (!file.endsWith(".js") || file.startsWith("words/")) continue;
    const source = readFileSync(new URL(`www/${file}`, root), "utf8");
    for (const [, key] of source.matchAll(/(?:(?<!#)\b(?:say|act)\(|\bword: )"([^"]+)"/g)) {
      assert.ok(known.has(key), `${file} says "${key}"`);
      used += 1;
    }
  }
  assert.ok(used > 20, "the sources were not found");
});

test("numbers are written as the language writes them", () => {
  assert.equal(number(-1.25), "−1.25");
  assert.equal(number(1 / 3, { digits: 3 }), "0.333");
  assert.equal(number(2, { decimals: 2 }), "2.00");
  assert.equal(number(-0.075, { digits: 1 }), "−0.08");
  assert.equal(number(145.45, { decimals: 1 }), "145.5");
  assert.equal(number(123456, { digits: 3 }), "123000");
  assert.equal(number(-0.001, { decimals: 2 }), "0.00");
  assert.equal(number(12_345_678), "1.2345678 × 10^7");
  assert.equal(number(1e-7, { digits: 2 }), "1.0 × 10^−7");
  learn({ ...english, "test.value": "{name} is {value}" });
  assert.equal(say("test.value", { name: "k0", value: 0.5 }), "k0 is 0.5");
  speak("de", { ...german, "test.value": "{name} ist {value}" });
  assert.equal(number(-1.25), "−1,25");
  assert.equal(number(1 / 3, { digits: 3 }), "0,333");
  assert.equal(number(12_345_678), "1,2345678 × 10^7");
  assert.equal(say("test.value", { name: "k0", value: 0.5 }), "k0 ist 0,5");
  assert.equal(say("view.failed"), german["view.failed"]);
  speak("en", null);
  assert.equal(say("view.failed"), english["view.failed"]);
});
