/**
 * A figure as JSON: everything that the module says of it, and the state of the page, which opens from it again as it was.
 *
 * @typedef {import("../figure/services.js").Figure} Figure
 * @typedef {import("../state.js").State} State
 * @typedef {import("../url.js").Known} Known
 * @typedef {import("../url.js").Problem} Problem
 * @typedef {import("./colophon.js").Colophon} Colophon
 * @typedef {{state: State, problems: Problem[], element: string | null}} Opened
 * @typedef {{word: string, values: Record<string, string | number>}} Refused  A sentence of the catalogue.
 */

import { INITIAL } from "../state.js";
import { parse, write } from "../url.js";

export const FORMAT = "gear-bifurcations figure";
export const FORMAT_VERSION = 1;
/** Larger files are none of ours, bytes. */
export const LARGEST = 64_000_000;
/** So much of a name is shown. */
const SHOWN = 60;

/**
 * What an address says, with what it leaves to the reader's own: theme, language, projector.
 *
 * @param {State} state
 */
export function wholeState(state) {
  const { theme, language, projector } = INITIAL;
  const text = write(state);
  const parts = [text === "" ? state.view : text];
  if (!text.includes("&")) parts.push("v=1");
  if (state.theme === theme) parts.push(`theme=${theme}`);
  if (state.projector === projector) parts.push("projector=off");
  if (state.language === language) parts.push(`language=${language}`);
  return parts.join("&");
}

/**
 * @param {Figure} figure  As the module gave it.
 * @param {Colophon} of
 * @param {string} element  The figure's element on the page.
 * @returns {string}
 */
export function saved(figure, of, element) {
  const plain = (/** @type {string} */ _, /** @type {unknown} */ value) =>
    ArrayBuffer.isView(value) ? Array.from(/** @type {Float64Array} */ (value)) : value;
  return `${JSON.stringify({ format: FORMAT, formatVersion: FORMAT_VERSION, ...of, element, data: figure }, plain)}\n`;
}

/**
 * What a file says, or what it is instead. Never throws, whatever it is given.
 *
 * @param {string} text
 * @param {string} file  Its name.
 * @param {Known} known
 * @returns {Opened | Refused}
 */
export function opened(text, file, known) {
  const name = file.length > SHOWN ? `${file.slice(0, SHOWN)}…` : file;
  const refuse = (/** @type {string} */ word, /** @type {Record<string, string | number>} */ values = {}) => ({ word, values: { name, ...values } });
  if (text.trim() === "") return refuse("export.open.empty");
  const kind = KINDS.find(([sign]) => sign.test(text));
  if (kind !== undefined) return refuse(kind[1]);
  /** @type {unknown} */
  let data;
  try {
    data = JSON.parse(text);
  } catch {
    return refuse(/^\s*\{/.test(text) ? "export.open.broken" : "export.open.other");
  }
  if (typeof data !== "object" || data === null || Array.isArray(data)) return refuse("export.open.foreign");
  const { format, formatVersion, state, element } = /** @type {Record<string, unknown>} */ (data);
  if (format === "gear-bifurcations answers") return refuse("export.open.answers");
  if (format !== FORMAT) return refuse("export.open.foreign");
  if (typeof formatVersion !== "number" || !(formatVersion >= 1)) return refuse("export.open.damaged");
  if (formatVersion > FORMAT_VERSION) return refuse("export.open.newer", { given: formatVersion, allowed: FORMAT_VERSION });
  if (typeof state !== "string" || state === "") return refuse("export.open.damaged");
  const { state: said, problems } = parse(state, known);
  return {
    state: { ...INITIAL, ...said },
    problems,
    element: typeof element === "string" && /^[\w-]{1,40}$/.test(element) ? element : null,
  };
}

/** What else may be brought: by what it begins with, and the sentence that says what it is. @type {readonly (readonly [RegExp, string])[]} */
const KINDS = [
  [/^\ufeff?(?:\ufffd|.)?PNG\r?\n/, "export.open.picture"],
  [/^(?:GIF8|\ufffd{3,4}\S{0,4}JFIF|RIFF)/, "export.open.picture"],
  [/^\ufeff?\s*(?:<\?xml[^>]*>\s*)?(?:<!-{2}[^]*?-->\s*)?<svg[\s>]/i, "export.open.picture"],
  [/^\ufeff?\s*<(?:!doctype\s+html|html)/i, "export.open.page"],
  [/^# gear-bifurcations, figure/, "export.open.table"],
  [/^\/\/ gear-bifurcations, figure/, "export.open.script"],
];
