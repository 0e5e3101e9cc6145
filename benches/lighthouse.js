// Rates the page with Lighthouse, five times, and takes the median. Lighthouse is no part of the project: it is installed, by
// the lock file in lighthouse/, into target/lighthouse/ when it is first needed. `cargo xtask bench --page` calls this with the
// built folder in GEAR_DIST. A line for each category: what, how much, and what it should be, with tabs between.

import { execFile, execFileSync } from "node:child_process";
import { copyFile, mkdir, readFile, stat } from "node:fs/promises";
import { createServer } from "node:http";
import { extname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";

const RUNS = 5;
/** Each category, and what it should reach. */
const AIMS = { accessibility: 100, "best-practices": 100, performance: 95 };
/** @type {Readonly<Record<string, string>>} */
const TYPES = {
  ".html": "text/html; charset=utf-8",
  ".js": "text/javascript; charset=utf-8",
  ".css": "text/css; charset=utf-8",
  ".wasm": "application/wasm",
  ".svg": "image/svg+xml",
  ".woff2": "font/woff2",
  ".webmanifest": "application/manifest+json",
};
/** What is compressed already. */
const PACKED = new Set([".woff2", ".png"]);

const dist = process.env.GEAR_DIST ?? "";
const lock = fileURLToPath(new URL("lighthouse/", import.meta.url));
const home = fileURLToPath(new URL("../target/lighthouse/", import.meta.url));

await install();
const server = createServer((request, response) => void answer(request, response));
await new Promise((/** @type {(value?: void) => void} */ resolve) => server.listen(0, "127.0.0.1", resolve));
const { port } = /** @type {import("node:net").AddressInfo} */ (server.address());
/** @type {Record<string, number[]>} */
const scores = {};
for (let run = 0; run < RUNS; run += 1) {
  for (const [category, score] of Object.entries(await rate(`http://127.0.0.1:${port}/`))) (scores[category] ??= []).push(score);
}
server.close();
for (const [category, aim] of Object.entries(AIMS)) {
  const found = scores[category].sort((a, b) => a - b)[RUNS >> 1];
  console.log(`Lighthouse, ${category.replace("-", " ")}, median of ${RUNS}\t${Math.round(found * 100)}\t${aim}`);
}

/** Brings Lighthouse, once for each lock file. */
async function install() {
  await mkdir(home, { recursive: true });
  const [wanted, present] = await Promise.all([join(lock, "package-lock.json"), join(home, "package-lock.json")].map((file) => readFile(file, "utf8").catch(() => "")));
  const there = await stat(join(home, "node_modules/lighthouse")).catch(() => null);
  if (there !== null && wanted === present) return;
  for (const file of ["package.json", "package-lock.json"]) await copyFile(join(lock, file), join(home, file));
  execFileSync("npm", ["ci", "--ignore-scripts", "--no-audit", "--no-fund", "--silent"], { cwd: home, stdio: ["ignore", "ignore", "inherit"] });
}

/**
 * The scores of one run, from 0 to 1.
 *
 * @param {string} address
 * @returns {Promise<Record<string, number>>}
 */
async function rate(address) {
  const flags = ["--headless=new", ...(process.getuid?.() === 0 ? ["--no-sandbox"] : [])].join(" ");
  /** @type {string} */
  const report = await new Promise((resolve, reject) => {
    const options = { env: { ...process.env, CHROME_PATH: process.env.CHROMIUM ?? "/usr/bin/chromium" }, maxBuffer: 1 << 28 };
    const words = [join(home, "node_modules/lighthouse/cli/index.js"), address, "--preset=desktop", "--quiet", `--chrome-flags=${flags}`];
    execFile("node", [...words, `--only-categories=${Object.keys(AIMS).join(",")}`, "--output=json"], options, (error, out) => (error ? reject(error) : resolve(out)));
  });
  /** @type {{categories: Record<string, {score: number}>}} */
  const { categories } = JSON.parse(report);
  return Object.fromEntries(Object.entries(categories).map(([name, { score }]) => [name, score]));
}

/**
 * A file of the site, compressed, as hosts send it.
 *
 * @param {import("node:http").IncomingMessage} request
 * @param {import("node:http").ServerResponse} response
 */
async function answer(request, response) {
  const { pathname } = new URL(request.url ?? "/", "http://host");
  const name = pathname === "/" ? "index.html" : pathname.slice(1);
  try {
    const content = await readFile(join(dist, name));
    const kind = extname(name);
    const packed = PACKED.has(kind) ? content : gzipSync(content);
    const coding = PACKED.has(kind) ? {} : { "Content-Encoding": "gzip" };
    response.writeHead(200, { "Content-Type": TYPES[kind] ?? "application/octet-stream", "Content-Length": packed.length, "Cache-Control": "max-age=600", ...coding });
    response.end(packed);
  } catch {
    response.writeHead(404).end();
  }
}
