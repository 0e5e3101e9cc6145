// The site below a path, as a host with folders would serve it, and pages of another origin that show its figures.

import { readFile } from "node:fs/promises";
import { createServer } from "node:http";
import { extname, join, normalize } from "node:path";
import { fileURLToPath } from "node:url";

export const DIST = fileURLToPath(new URL("../../dist/", import.meta.url));
const PREFIX = "/some/where/";

/** @type {Record<string, string>} */
const TYPES = {
  ".html": "text/html",
  ".js": "text/javascript",
  ".css": "text/css",
  ".wasm": "application/wasm",
  ".svg": "image/svg+xml",
  ".png": "image/png",
  ".woff2": "font/woff2",
  ".json": "application/json",
  ".webmanifest": "application/manifest+json",
};

/**
 * @typedef {object} Serving
 * @property {string} address  Ends with a slash.
 * @property {string[]} missed  What was asked for and is not there.
 * @property {() => Promise<void>} close  Gone, as a server is to whom the network does not lead.
 */

/**
 * @param {(path: string) => Promise<Uint8Array | string>} content
 * @param {string} prefix
 * @param {string} inserted  Into the head of every document that a reader opens.
 * @returns {Promise<Serving>}
 */
async function serve(content, prefix, inserted) {
  /** @type {string[]} */
  const missed = [];
  const server = createServer(async ({ url = "", headers }, response) => {
    const path = decodeURIComponent(new URL(url, "http://localhost").pathname);
    try {
      if (!path.startsWith(prefix)) throw new Error("elsewhere");
      const wanted = path.slice(prefix.length) || "index.html";
      const found = await content(wanted);
      const type = TYPES[extname(wanted)] ?? "application/octet-stream";
      const opened = type === "text/html" && (headers.accept ?? "").includes("text/html");
      // The page that is served to figures elsewhere lets itself be read, as the usual hosts of static files do.
      response.writeHead(200, { "Content-Type": type, "Access-Control-Allow-Origin": "*" });
      response.end(opened ? withHead(found.toString(), inserted) : found);
    } catch {
      missed.push(path);
      response.writeHead(404).end();
    }
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", () => resolve(undefined)));
  const { port } = /** @type {import("node:net").AddressInfo} */ (server.address());
  return {
    address: `http://127.0.0.1:${port}${prefix}`,
    missed,
    close: async () => {
      server.closeAllConnections();
      await new Promise((resolve) => server.close(resolve));
    },
  };
}

/** The site. @param {string} inserted */
export function serveSite(inserted) {
  return serve((path) => readFile(join(DIST, normalize(`/${path}`))), PREFIX, inserted);
}

/** One page of another origin. @param {string} body @param {string} inserted */
export function serveHost(body, inserted) {
  const page = `<!doctype html><html lang="en"><head><meta charset="utf-8"><title>A host</title><link rel="icon" href="data:,"></head><body>${body}</body></html>`;
  return serve(async (path) => (path === "index.html" ? page : Promise.reject(new Error("no such page"))), "/", inserted);
}

/**
 * A document with more in its head.
 *
 * @param {string} document
 * @param {string} inserted
 */
export function withHead(document, inserted) {
  return document.replace("<head>", () => `<head>${inserted}`);
}
