// Keeps the page for when there is no network. The build puts it beside the page, with the files of this release in it.
//
// Each file is kept under its path and the hash of its content, so that what a new release has in common with the old one is not fetched
// again, and so that nothing of one release can be mistaken for the other's. A release is complete or it is not kept at all: a
// file whose content is another than its hash says (a host that is just being brought up to date) ends the installation,
// and the browser tries again at the next visit. A new release waits until the reader agrees or has left; then it takes over and
// whatever the old one alone had is deleted.

/** @type {Record<string, string>} The files of this release by their path, each with the hash of its content. */
const RELEASE = Object.freeze({});

const worker = /** @type {any} */ (self);
/** Several copies of the page may live on one host: each has a store of its own. */
const STORE = `gear-bifurcations ${worker.registration.scope}`;
const scope = new URL(worker.registration.scope);

/** @param {string} path */
function key(path) {
  return new URL(`${path}?sha256=${RELEASE[path]}`, scope).href;
}

/** @param {ArrayBuffer} content */
async function hash(content) {
  const bytes = new Uint8Array(await crypto.subtle.digest("SHA-256", content));
  return [...bytes].map((byte) => byte.toString(16).padStart(2, "0")).join("");
}

/**
 * A file of this release, from the browser's own store where that is up to date.
 *
 * @param {string} path
 */
async function fetched(path) {
  for (const cache of /** @type {RequestCache[]} */ (["default", "reload"])) {
    const answer = await fetch(new URL(path, scope), { cache });
    const content = await answer.arrayBuffer();
    if (answer.ok && (await hash(content)) === RELEASE[path]) {
      // Made anew: what a host redirected must not be answered to a navigation.
      return new Response(content, { headers: { "Content-Type": answer.headers.get("Content-Type") ?? "" } });
    }
  }
  throw new Error(`${path} is not of this release`);
}

async function keep() {
  const store = await caches.open(STORE);
  for (const path of Object.keys(RELEASE)) {
    if ((await store.match(key(path))) === undefined) await store.put(key(path), await fetched(path));
  }
}

/**
 * A file that the browser has cleared from its store since: kept anew, as far as it is still that of this release.
 *
 * @param {Cache} store
 * @param {string} path
 */
async function keptAgain(store, path) {
  try {
    const answer = await fetched(path);
    await store.put(key(path), answer.clone());
    return answer;
  } catch {
    return undefined;
  }
}

async function forgetOthers() {
  const store = await caches.open(STORE);
  const ours = new Set(Object.keys(RELEASE).map(key));
  for (const { url } of await store.keys()) if (!ours.has(url)) await store.delete(url);
}

/**
 * The file that an address of the page means; undefined for what is not kept.
 *
 * @param {string} address
 */
function pathOf(address) {
  const url = new URL(address);
  if (url.origin !== scope.origin || !url.pathname.startsWith(scope.pathname)) return undefined;
  const path = decodeURIComponent(url.pathname.slice(scope.pathname.length)) || "index.html";
  return Object.hasOwn(RELEASE, path) ? path : undefined;
}

worker.addEventListener("install", (/** @type {any} */ event) => event.waitUntil(keep()));
worker.addEventListener("activate", (/** @type {any} */ event) => event.waitUntil(forgetOthers()));
worker.addEventListener("message", (/** @type {MessageEvent} */ { data }) => {
  if (data === "take over") worker.skipWaiting();
});
worker.addEventListener("fetch", (/** @type {any} */ event) => {
  const path = event.request.method === "GET" ? pathOf(event.request.url) : undefined;
  if (path === undefined) return;
  const answer = async () => {
    const store = await caches.open(STORE);
    return (await store.match(key(path))) ?? (await keptAgain(store, path)) ?? fetch(event.request);
  };
  event.respondWith(answer());
});
