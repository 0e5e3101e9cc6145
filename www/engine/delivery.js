/**
 * Where the module and the workers' script come from: on a site, from the files beside. In the single file the build puts
 * `delivery-inline.js` in this one's place, which offers the same.
 */

/**
 * What the module is loaded from.
 *
 * @returns {import("../../gear-bifurcations.js").LoadSource | Promise<import("../../gear-bifurcations.js").LoadSource> | undefined}
 *   undefined for the file beside the module
 */
export function wasm() {
  return undefined;
}

/** @type {string | null} */
let address = null;

export function newWorker() {
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
