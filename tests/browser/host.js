// Pages that are not ours: a server of another origin than the site's, with one document at a time, and another that serves
// the site itself as some host might.

import { createServer } from "node:http";
import { readFileSync } from "node:fs";
import { extname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { test as base, expect } from "@playwright/test";

export { expect };

/** @typedef {import("@playwright/test").Page} Page */
/** @typedef {{body: string, headers?: Record<string, string>, name?: string}} Document  `name`: of the host, 127.0.0.1 if left out. */
/** @typedef {(wanted: Document) => string} Host  Takes a document to serve and says its address. */
/** @typedef {(headers?: Record<string, string>) => string} Elsewhere  Serves the site with these headers and says its address. */

const TESTS = fileURLToPath(new URL("../", import.meta.url));
const DIST = fileURLToPath(new URL("../../dist/", import.meta.url));
const TYPES = /** @type {Record<string, string>} */ ({
  ".html": "text/html",
  ".js": "text/javascript",
  ".mjs": "text/javascript",
  ".css": "text/css",
  ".wasm": "application/wasm",
  ".svg": "image/svg+xml",
  ".woff2": "font/woff2",
  ".webmanifest": "application/manifest+json",
});

/**
 * @param {(path: string) => {content: string | Buffer, type: string, headers?: Record<string, string>}} answer  Throws where there is nothing.
 * @param {(port: number) => Promise<void>} use
 */
async function serving(answer, use) {
  const server = createServer((request, response) => {
    try {
      const { content, type, headers } = answer(decodeURIComponent((request.url ?? "/").replace(/[?#].*/, "")));
      response.writeHead(200, { "Content-Type": type, ...headers }).end(content);
    } catch {
      response.writeHead(404).end();
    }
  });
  // Every name of this machine: localhost is another site than 127.0.0.1.
  await new Promise((resolve) => server.listen(0, () => resolve(undefined)));
  await use(/** @type {import("node:net").AddressInfo} */ (server.address()).port);
  server.closeAllConnections();
  server.close();
}

/** @type {import("@playwright/test").Fixtures<{host: Host, elsewhere: Elsewhere}, {}, import("@playwright/test").PlaywrightTestArgs>} */
const fixtures = {
  host: async ({}, /** @type {(host: Host) => Promise<void>} */ use) => {
    /** @type {Document} */
    let document = { body: "" };
    await serving(
      (path) => {
        // What makes things up from a seed is shared with the tests in Node.
        if (path.startsWith("/node/")) return { content: readFileSync(join(TESTS, path)), type: "text/javascript" };
        if (path !== "/") throw new Error("nothing there");
        const content = `<!doctype html><meta charset="utf-8"><title>A host</title><link rel="icon" href="data:,">${document.body}`;
        return { content, type: "text/html", headers: document.headers };
      },
      (port) =>
        use((wanted) => {
          document = wanted;
          return `http://${wanted.name ?? "127.0.0.1"}:${port}/`;
        }),
    );
  },
  elsewhere: async ({}, /** @type {(elsewhere: Elsewhere) => Promise<void>} */ use) => {
    /** @type {Record<string, string>} */
    let sent = {};
    await serving(
      (path) => {
        const name = path === "/" ? "index.html" : path.slice(1);
        return { content: readFileSync(join(DIST, name)), type: TYPES[extname(name)] ?? "text/plain", headers: sent };
      },
      (port) =>
        use((headers = {}) => {
          sent = headers;
          return `http://127.0.0.1:${port}/`;
        }),
    );
  },
};

export const test = base.extend(fixtures);

/** Notes what figures and frames say. */
export const LISTEN = `<script>
  window.heard = [];
  for (const type of ["gear-ready", "gear-change", "gear-error"]) addEventListener(type, (event) => heard.push([type, event.detail]));
  addEventListener("message", ({ data }) => heard.push([data?.type, data]));
</script>`;

/** @param {string | undefined} site */
export const ELEMENT = (site) => `<script type="module" src="${site}gear-figure.js"></script>`;

/** @param {Page} page @param {string} type */
export function heard(page, type) {
  return page.evaluate(
    (wanted) =>
      /** @type {any} */ (window).heard
        .filter((/** @type {any[]} */ [name]) => name === wanted)
        .map((/** @type {any[]} */ [, detail]) => JSON.parse(JSON.stringify(detail))),
    type,
  );
}

/** @param {Page} page @param {string} type @param {number} [count] */
export async function hears(page, type, count = 1) {
  await expect.poll(async () => (await heard(page, type)).length, { timeout: 30_000 }).toBeGreaterThanOrEqual(count);
  return heard(page, type);
}
