/**
 * Where the module and the workers' script come from: on a site, from the files beside. In the single file the build puts
 * `delivery-inline.js` in this one's place, which offers the same.
 */

/**
 * What the page's document has begun already: see `ahead.js`.
 *
 * @type {{module: Promise<WebAssembly.Module | undefined>, workers: Worker[]} | undefined}
 */
const ahead = /** @type {any} */ (self).gearAhead;

/**
 * What the module is loaded from.
 *
 * @returns {Promise<WebAssembly.Module | undefined> | undefined} undefined for the file beside the module
 */
export function wasm() {
  return ahead?.module;
}

/** @type {string | null} */
let address = null;

export function newWorker() {
  const waiting = ahead?.workers.shift();
  if (waiting !== undefined) return waiting;
  address ??= reachable(new URL("./worker.js", import.meta.url));
  return new Worker(address, { type: "module", name: "gear" });
}

/**
 * A page may start workers from its own origin only, but figures are also shown on pages of others. There a script of
 * the page's own origin imports ours.
 *
 * @param {URL} script
 */
function reachable(script) {
  if (script.origin === location.origin) return script.href;
  return URL.createObjectURL(new Blob([`import ${JSON.stringify(script.href)};`], { type: "text/javascript" }));
}
