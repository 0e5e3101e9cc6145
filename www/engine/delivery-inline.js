/**
 * Where the module and the workers' script come from in the single file: from the document itself, without any request.
 * The build puts this in the place of `delivery.js` there, and the elements named here into the document.
 */

const WASM = "gear-wasm";
const MODULE = "gear-module";
const WORKER = "gear-worker";

/**
 * What the module is loaded from: packed by gzip and written in base64 it takes less than half of its own size.
 *
 * @returns {Response}
 */
export function wasm() {
  const packed = new Blob([bytes(textOf(WASM))]).stream();
  const headers = { "Content-Type": "application/wasm" };
  return new Response(packed.pipeThrough(new DecompressionStream("gzip")), { headers });
}

/**
 * The faces that drawings are lettered with: those of the document's style.
 *
 * @returns {import("./protocol.js").Face[]}
 */
export function faces() {
  const rules = [...document.styleSheets].flatMap(({ cssRules }) => [...cssRules]).filter((rule) => rule instanceof CSSFontFaceRule);
  return rules.flatMap(({ style }) => {
    const [, source = ""] = /url\("(data:[^"]+)"\)/.exec(style.getPropertyValue("src")) ?? [];
    const family = style.getPropertyValue("font-family").replaceAll('"', "");
    if (source === "" || family === "STIX Two Equations") return [];
    return [{ family, source, style: style.getPropertyValue("font-style") || "normal", weight: style.getPropertyValue("font-weight") || "400" }];
  });
}

/** @type {string | null} */
let address = null;

/** A plain worker, not one of modules: all it needs stands in two scripts. */
export function newWorker() {
  address ??= URL.createObjectURL(new Blob([textOf(MODULE), textOf(WORKER)], { type: "text/javascript" }));
  return new Worker(address, { name: "gear" });
}

/** @param {string} id */
function textOf(id) {
  const text = document.getElementById(id)?.textContent;
  if (!text) throw new Error(`the file is not whole: it has no ${id}`);
  return text;
}

/** @param {string} base64 */
function bytes(base64) {
  // Where the browser reads it itself, ten times as fast.
  if ("fromBase64" in Uint8Array) return /** @type {any} */ (Uint8Array).fromBase64(base64);
  const letters = atob(base64);
  const found = new Uint8Array(letters.length);
  for (let index = 0; index < letters.length; index += 1) found[index] = letters.charCodeAt(index);
  return found;
}
