// The page without a network, and when a new release comes.

import { createServer } from "node:http";
import { readFileSync } from "node:fs";
import { createHash } from "node:crypto";
import { extname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { test, expect } from "@playwright/test";
import { marked } from "./page.js";

const DIST = fileURLToPath(new URL("../../dist/", import.meta.url));
const TYPES = /** @type {Record<string, string>} */ ({ ".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".wasm": "application/wasm", ".svg": "image/svg+xml", ".woff2": "font/woff2", ".webmanifest": "application/manifest+json" });

// A browser looks for a new release with the least of its priorities. Where it draws without a graphics processor, gears that
// move 60 times a second leave it no time for that, for a minute and more; so they stand still here.
test.use({ serviceWorkers: "allow", reducedMotion: "reduce" });

/** The site on a server that can bring out a new release, and be taken away. */
async function serve() {
  let release = 1;
  const content = (/** @type {string} */ path) => {
    const bytes = readFileSync(join(DIST, path));
    if (release === 1 || !["index.html", "service-worker.js"].includes(path)) return bytes;
    // The second release differs in its document alone.
    const document = readFileSync(join(DIST, "index.html"), "utf8");
    const changed = document.replace("<title>", "<title>Second: ");
    if (path === "index.html") return changed;
    const sum = (/** @type {string} */ text) => createHash("sha256").update(text).digest("hex");
    return bytes.toString().replace(sum(document), sum(changed));
  };
  /** @type {string[]} */
  const asked = [];
  const server = createServer((request, response) => {
    const path = (request.url ?? "").slice(1).replace(/[?#].*/, "").replace(/^below\//, "") || "index.html";
    asked.push(path);
    try {
      response.writeHead(200, { "Content-Type": TYPES[extname(path)] ?? "text/plain" }).end(content(path));
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", () => resolve(undefined)));
  const { port } = /** @type {import("node:net").AddressInfo} */ (server.address());
  const close = () => {
    server.closeAllConnections();
    server.close();
  };
  const bringOut = () => {
    release = 2;
    asked.length = 0;
  };
  return { address: `http://127.0.0.1:${port}/below/`, asked, bringOut, close };
}

test("after the first visit the page opens without a network, and a new release is offered, not forced", async ({ page }) => {
  test.setTimeout(120_000);
  const { address, asked, bringOut, close } = await serve();
  const kept = () => page.evaluate(async () => (await navigator.serviceWorker.getRegistration())?.active?.state ?? null);
  const lives = () => expect.poll(() => marked(page, "first-figure"), { timeout: 30_000 }).not.toBeNull();
  await page.goto(address);
  await lives();
  await expect.poll(kept, { timeout: 30_000 }).toBe("activated");

  await page.context().setOffline(true);
  await page.goto(`${address}#lab`);
  await page.reload();
  await expect(page.locator('main > [data-view="lab"] > *').first()).toBeVisible();
  await page.context().setOffline(false);

  bringOut();
  await page.reload();
  await expect(page).toHaveTitle(/^(?!Second)/);
  const offer = page.getByRole("button", { name: "Load it now" });
  await expect(offer).toBeVisible({ timeout: 30_000 });
  // Only what is new was fetched anew.
  expect(asked.filter((path) => path.endsWith(".wasm"))).toEqual([]);
  await offer.click();
  await expect(page).toHaveTitle(/^Second/);
  const stored = await page.evaluate(async () => {
    const [store] = await caches.keys();
    return (await (await caches.open(store)).keys()).filter(({ url }) => url.includes("index.html")).length;
  });
  expect(stored).toBe(1);
  close();
});

test("where service workers are refused the page works without", async ({ browser, baseURL }) => {
  const context = await browser.newContext({ serviceWorkers: "block" });
  const page = await context.newPage();
  await page.goto(baseURL ?? "");
  await expect.poll(() => marked(page, "first-figure"), { timeout: 30_000 }).not.toBeNull();
  await context.close();
});

test("what makes it installable is there", async ({ request, baseURL }) => {
  const manifest = await (await request.get(`${baseURL}manifest.webmanifest`)).json();
  expect(manifest).toMatchObject({ start_url: "./", display: "standalone" });
  for (const { src, type, sizes } of manifest.icons) {
    const answer = await request.get(new URL(src, baseURL).href);
    expect(answer.headers()["content-type"]).toBe(type);
    if (type === "image/png") expect(`${(await answer.body()).readUInt32BE(16)}x${(await answer.body()).readUInt32BE(20)}`).toBe(sizes);
  }
});
