// The npm package, as `npm pack` makes it: what is in it, and that it works where it is installed.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";
import { fileURLToPath, pathToFileURL } from "node:url";

const source = fileURLToPath(new URL("../../dist/package/", import.meta.url));
const folder = mkdtempSync(join(tmpdir(), "gear-package-"));
after(() => rmSync(folder, { recursive: true }));

const FILES = [
  "LICENSE-APACHE",
  "LICENSE-MIT",
  "README.md",
  "gear-bifurcations.d.ts",
  "gear-bifurcations.js",
  "gear-bifurcations_bg.wasm",
  "package.json",
];

/** Runs a program with what is installed in the folder. @param {string} code */
function run(code) {
  const file = join(folder, `run-${Math.random()}.mjs`);
  writeFileSync(file, code);
  return execFileSync("node", [file], { cwd: folder, encoding: "utf8" }).trim();
}

test("npm pack packs these files and nothing that runs at installation", () => {
  const said = execFileSync("npm", ["pack", source, "--json", "--ignore-scripts", "--pack-destination", folder], { cwd: folder, encoding: "utf8" });
  const [packed] = JSON.parse(said);
  assert.deepEqual(packed.files.map((/** @type {{path: string}} */ { path }) => path).sort(), FILES);
  const home = join(folder, "node_modules/gear-bifurcations");
  mkdirSync(home, { recursive: true });
  execFileSync("tar", ["-xzf", join(folder, packed.filename), "--strip-components", "1", "-C", home]);
});

test("installed, it is imported by its name, by a path to it and by an address", () => {
  const use = (/** @type {string} */ from) =>
    run(`import { load } from ${JSON.stringify(from)};\nconst gear = await load();\nconsole.log(gear.multipliers({ k0: 0.5, Omega: 1.65 }).stable);`);
  const module = join(folder, "node_modules/gear-bifurcations/gear-bifurcations.js");
  for (const from of ["gear-bifurcations", "gear-bifurcations/gear-bifurcations.js", "./node_modules/gear-bifurcations/gear-bifurcations.js", pathToFileURL(module).href]) {
    assert.equal(use(from), "false", from);
  }
});

test("its manifest names no dependency and no script", () => {
  const keys = run('import manifest from "gear-bifurcations/package.json" with { type: "json" };\nconsole.log(Object.keys(manifest).join(" "));');
  assert.doesNotMatch(keys, /[dD]ependencies|scripts|bin/);
  assert.match(keys, /types/);
});
