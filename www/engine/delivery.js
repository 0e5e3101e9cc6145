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

/**
 * The faces that drawings are lettered with.
 *
 * @returns {import("./protocol.js").Face[]}
 */
export function faces() {
  const family = "STIX Two Text";
  return [
    { family, source: new URL("../style/fonts/regular.woff2", import.meta.url).href },
    { family, source: new URL("../style/fonts/italic.woff2", import.meta.url).href, style: "italic" },
    { family, source: new URL("../style/fonts/bold.woff2", import.meta.url).href, weight: "700" },
    { family: "STIX Two Math", source: new URL("../style/fonts/signs.woff2", import.meta.url).href },
  ];
}

/** @type {string | null} */
let address = null;

/**
 * A page may start workers from its own origin only, but figures are also shown on pages of others, and in sandboxes, which
 * have none, wherever their document comes from. There a script of the page's own imports ours. It is a plain one: Chromium
 * starts no module from a blob in a sandbox, and would ask a page's policy for leave to start ours as a worker.
 */
export function newWorker() {
  const waiting = ahead?.workers.shift();
  if (waiting !== undefined) return waiting;
  const script = new URL("./worker.js", import.meta.url);
  if (script.origin === self.origin) return new Worker(script, { type: "module", name: "gear" });
  address ??= URL.createObjectURL(new Blob([importing(script.href)], { type: "text/javascript" }));
  return new Worker(address, { name: "gear" });
}

/**
 * A script that imports another, and keeps for it what is said meanwhile.
 *
 * @param {string} address
 */
function importing(address) {
  return `const early = [];
onmessage = ({ data }) => early.push(data);
import(${JSON.stringify(address)}).then(
  () => {
    onmessage = null;
    for (const data of early) dispatchEvent(new MessageEvent("message", { data }));
  },
  (reason) => setTimeout(() => { throw reason; }),
);`;
}
