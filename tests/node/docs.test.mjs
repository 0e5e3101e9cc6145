// Every example of docs/api.md runs as it stands, and what it says behind "// ->" is true; its tables are those of the code.

import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";
import { pathToFileURL } from "node:url";
import { gear, refused, script } from "./support.mjs";

const text = readFileSync(new URL("../../docs/api.md", import.meta.url), "utf8");
const folder = mkdtempSync(join(tmpdir(), "gear-docs-"));
after(() => rmSync(folder, { recursive: true }));

/** The examples with the heading each stands under. */
const examples = [...text.matchAll(/^## (.*)$|^```js\n([\s\S]*?)^```$/gm)].reduce(
  (found, [, heading, code]) => {
    if (heading !== undefined) found.heading = heading;
    else if (found.heading) found.list.push({ heading: found.heading, code });
    return found;
  },
  { heading: "", list: /** @type {{heading: string, code: string}[]} */ ([]) },
).list;

/** As many decimals as a number is written with. @param {string} written */
function decimals(written) {
  return written.split(".")[1]?.length ?? 0;
}

/** The example with each `expression; // -> value` made into a call of `check`. @param {string} code */
function runnable(code) {
  const checked = code.replace(
    /^(\s*)([^\n]*?);\s*\/\/ -> (.*)$/gm,
    (_, indent, expression, value) => `${indent}check(${JSON.stringify(value)}, ${expression});`,
  );
  const whole = `import { GearError, load } from "./gear-bifurcations.js";\nconst gear = await load();\n${checked}`;
  return whole
    .replaceAll('import.meta.resolve("./gear-bifurcations.js")', JSON.stringify(script))
    .replaceAll('"./gear-bifurcations.js"', JSON.stringify(script));
}

test("there is an example for every call", () => {
  for (const name of Object.keys(gear).filter((name) => name !== "module" && name !== "draw")) {
    assert.ok(
      examples.some(({ code }) => code.includes(`gear.${name}(`)),
      `an example of ${name}()`,
    );
  }
  assert.match(text, /gear\.draw\(/);
});

for (const [number, { heading, code }] of examples.entries()) {
  test(`the example under "${heading}"`, async () => {
    let checks = 0;
    const check = (/** @type {string} */ written, /** @type {unknown} */ value) => {
      checks += 1;
      const expected = JSON.parse(written);
      if (typeof expected === "number") {
        const rounding = 0.51 * 10 ** -decimals(written);
        assert.ok(Math.abs(Number(value) - expected) <= rounding, `${value} is shown as ${written}`);
      } else {
        assert.deepEqual(value, expected);
      }
    };
    const file = join(folder, `example-${number}.mjs`);
    const before = /** @type {any} */ (globalThis);
    before.check = check;
    writeFileSync(file, runnable(code));
    await import(pathToFileURL(file).href);
    delete before.check;
    assert.equal(checks, [...code.matchAll(/\/\/ -> /g)].length, "every promise was checked");
    assert.ok(checks > 0, "it promises something");
  });
}

test("the table of parameters is the one in the code", () => {
  for (const { name, short, default: value, low, high, meaning, follows } of gear.defaults().slice(0, -1)) {
    const row = text.match(new RegExp(`^\\| \`${name}\` \\|([^|]*)\\| (.*) \\| (.*) \\.\\. (.*) \\| (.*) \\|$`, "m"));
    assert.ok(row, name);
    assert.equal(row[1].trim(), short ? `\`${short}\`` : "", name);
    assert.equal(row[2], follows ? `= \`${follows}\`` : String(value), name);
    assert.deepEqual([Number(row[3]), Number(row[4]), row[5]], [low, high, meaning]);
  }
});

test("the table of errors names every code that the declarations have", () => {
  const declarations = readFileSync(new URL("../../www/engine/gear-bifurcations.d.ts", import.meta.url), "utf8");
  const union = declarations.match(/export type GearErrorCode =([\s\S]*?);/)?.[1] ?? "";
  const declared = [...union.matchAll(/"([a-z-]+)"/g)].map((match) => match[1]);
  const section = text.slice(text.indexOf("## Errors")).split(/\n## /)[0];
  const documented = [...section.matchAll(/^\| `([a-z-]+)` \|/gm)].map((match) => match[1]);
  assert.deepEqual(documented.filter((code) => code.includes("-") || declared.includes(code)), declared);
  const sources = readFileSync(new URL("../../src/web/errors.rs", import.meta.url), "utf8");
  for (const code of declared.filter((code) => code !== "load")) assert.ok(sources.includes(`"${code}"`), code);
});

test("the table of options says the ranges that hold", () => {
  /** The option's row within the rows of its call. @param {string} option @param {(value: number) => unknown} ask */
  const check = (option, ask) => {
    const row = text.match(new RegExp(`^\\|[^|]*\\| \`${option}\` \\| ([^|]*) \\| (\\S+) \\.\\. ([\\d.e-]+)`, "m"));
    assert.ok(row, option);
    const [low, high] = [Number(row[2]), Number(row[3])];
    const error = refused(() => ask(high * 2), { code: "option", parameter: option });
    assert.deepEqual(error.allowed, [low, high], option);
  };
  check("tolerance", (tolerance) => gear.multipliers({}, { tolerance }));
  check("periods", (periods) => gear.timeResponse({}, { periods }));
  check("samplesPerPeriod", (samplesPerPeriod) => gear.timeResponse({}, { samplesPerPeriod }));
  check("transient", (transient) => gear.poincare({}, { transient }));
  check("points", (points) => gear.poincare({}, { points }));
  check("period", (period) => gear.periodicOrbit({}, { period }));
  check("width", (width) => gear.svg("2", {}, { width }));
  check("height", (height) => gear.svg("2", {}, { height }));
  check("density", (density) => gear.draw("2", {}, null, { density }));
});
