// The oldest browsers: what docs/engines.md says they must know is what the sources use, and nothing newer is.

import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { test } from "node:test";

const ROOT = fileURLToPath(new URL("../../", import.meta.url));
const DOCUMENT = readFileSync(`${ROOT}docs/engines.md`, "utf8");

/** All that is shipped to browsers. */
const SOURCES = readdirSync(`${ROOT}www`, { recursive: true, encoding: "utf8" })
  .filter((name) => /\.(js|css|html)$/.test(name))
  .map((name) => `www/${name}`)
  .concat("index.html")
  .map((name) => ({ name, text: readFileSync(ROOT + name, "utf8") }));

/** How each feature of the first table is seen in the sources. @type {Record<string, RegExp>} */
const NEEDED = {
  "workers that are modules": /new Worker\([^)]*type: "module"/,
  "`DecompressionStream`": /new DecompressionStream/,
  "container queries": /@container/,
  "MathML Core": /<math[ >]/,
  "`adoptedStyleSheets`": /adoptedStyleSheets/,
  "lookbehind": /\(\?<[=!]/,
  "`Object.hasOwn`": /Object\.hasOwn/,
  "private methods": /^ {2}(async )?#\w+\(/m,
  "`dialog`": /showModal\(/,
};

/** What is used only where it is, with how that is made sure; styles that are not known are passed over by themselves. @type {Record<string, {used: RegExp, guard?: RegExp}>} */
const OPTIONAL = {
  "`:has()`": { used: /:has\(/ },
  "`color-mix()`": { used: /color-mix\(/ },
  "popovers": { used: /showPopover/, guard: /showPopover\?\.\(/ },
  "`modulepreload`": { used: /rel="modulepreload"/ },
  "`text-wrap: balance`": { used: /text-wrap: balance/ },
  "`requestIdleCallback`": { used: /requestIdleCallback\(/, guard: /"requestIdleCallback" in (window|globalThis)/ },
};

/** What all engines know today, but not those named as the oldest. @type {Record<string, RegExp>} */
const TOO_NEW = {
  "Promise.withResolvers": /Promise\.withResolvers/,
  "Promise.try": /Promise\.try\(/,
  "Object.groupBy, Map.groupBy": /\b(Object|Map)\.groupBy/,
  "copies of arrays": /\.(toSorted|toReversed|toSpliced)\(/,
  "Array.fromAsync": /Array\.fromAsync/,
  "sets as sets": /\.(isSubsetOf|isSupersetOf|isDisjointFrom|symmetricDifference)\(/,
  "helpers of iterators": /Iterator\.from|\.(values|keys|entries)\(\)\.(map|filter|toArray|some|every|find|reduce)\(/,
  "AbortSignal.any": /AbortSignal\.any/,
  "URL.canParse": /URL\.canParse/,
  "the flag v of regular expressions": /\/[dgimsuy]*v[dgimsuy]*\.(test|exec)\(/,
  "light-dark()": /light-dark\(/,
  "@starting-style": /@starting-style/,
  "nested rules": /^\s*&[ .:[]/m,
  "view transitions": /startViewTransition/,
  "attributes of imports": /import .* with \{/,
  "reset() of a canvas context": /context\??\.reset\(/,
};

/** The rows of the table that begins with this head. @param {string} head @returns {{feature: string, versions: number[]}[]} */
function table(head) {
  const [, rest] = DOCUMENT.split(`| ${head} |`);
  assert.ok(rest, head);
  return rest
    .split("\n\n")[0]
    .split("\n")
    .slice(2)
    .map((row) => row.split("|").slice(1).map((cell) => cell.replaceAll("*", "").trim()))
    .map(([feature, ...cells]) => ({ feature, versions: cells.slice(0, 3).map((cell) => (cell === "none" ? Infinity : Number(cell))) }));
}

const uses = (/** @type {RegExp} */ pattern) => SOURCES.filter(({ text }) => pattern.test(text)).map(({ name }) => name);

test("what sets the oldest versions is used, and no row asks for more than the last one says", () => {
  const rows = table("needed");
  const all = rows.at(-1);
  assert.equal(all?.feature, "all of it");
  for (const [engine, oldest] of (all?.versions ?? []).entries()) assert.equal(Math.max(...rows.slice(0, -1).map(({ versions }) => versions[engine])), oldest);
  for (const [name, pattern] of Object.entries(NEEDED)) {
    assert.ok(rows.some(({ feature }) => feature.includes(name)), `${name} has a row`);
    assert.notDeepEqual(uses(pattern), [], `${name} is used somewhere`);
  }
  const readme = readFileSync(`${ROOT}README.md`, "utf8");
  const [chromium, firefox, safari] = all?.versions ?? [];
  assert.ok(readme.includes(`Chromium ${chromium}, Firefox ${firefox}, Safari ${safari}`), "README.md says the same");
});

test("what is newer is used only where it is", () => {
  const rows = table("used where it is");
  assert.deepEqual(rows.map(({ feature }) => feature), Object.keys(OPTIONAL));
  for (const [name, { used, guard }] of Object.entries(OPTIONAL)) {
    const found = SOURCES.filter(({ text }) => used.test(text) || guard?.test(text));
    assert.notEqual(found.length, 0, `${name} is used somewhere`);
    if (guard !== undefined) for (const source of found) assert.match(source.text, guard, source.name);
  }
});

test("nothing is used that the oldest do not know", () => {
  for (const [name, pattern] of Object.entries(TOO_NEW)) assert.deepEqual(uses(pattern), [], name);
});
