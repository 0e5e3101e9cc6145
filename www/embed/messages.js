/**
 * What a frame and the page around it say to each other: only what has this form is heard, whatever else arrives.
 *
 * @typedef {{gear: 1, type: "set", figure?: string, params?: Record<string, number | string | null>, controls?: string, theme?: string}} SetMessage
 * @typedef {{gear: 1, type: "get", id?: number | string, data?: boolean}} GetMessage
 * @typedef {{gear: 1, type: "play" | "pause" | "reset"}} PlainMessage
 * @typedef {SetMessage | GetMessage | PlainMessage} Message
 */

import { isReserved } from "../figure/attributes.js";

/** More parameters than there are names for is no message of ours. */
const MOST = 64;
const LONGEST = 64;
const NAME = /^[a-z][a-z0-9_]{0,31}$/i;
const CHOICES = { controls: ["full", "compact", "none"], theme: ["light", "dark", "auto"] };

/**
 * @param {unknown} data
 * @returns {Message | null} null for whatever is not of the form
 */
export function understood(data) {
  if (!isRecord(data) || data.gear !== 1) return null;
  switch (data.type) {
    case "play":
    case "pause":
    case "reset":
      return { gear: 1, type: data.type };
    case "get":
      return isIdentifier(data.id) && isFlag(data.data) ? { gear: 1, type: "get", id: data.id, data: data.data } : null;
    case "set":
      return understoodSet(data);
    default:
      return null;
  }
}

/**
 * @param {Record<string, unknown>} data
 * @returns {SetMessage | null}
 */
function understoodSet({ figure, params, controls, theme }) {
  if (figure !== undefined && !(typeof figure === "string" && /^\w{1,4}$/.test(figure))) return null;
  if (!isChoice("controls", controls) || !isChoice("theme", theme)) return null;
  if (params !== undefined && !isParams(params)) return null;
  return { gear: 1, type: "set", figure, params, controls, theme };
}

/**
 * @param {keyof typeof CHOICES} name
 * @param {unknown} value
 * @returns {value is string | undefined}
 */
function isChoice(name, value) {
  return value === undefined || (typeof value === "string" && CHOICES[name].includes(value));
}

/**
 * @param {unknown} value
 * @returns {value is Record<string, number | string | null>}
 */
function isParams(value) {
  if (!isRecord(value)) return false;
  const entries = Object.entries(value);
  return entries.length <= MOST && entries.every(([name, given]) => isName(name) && isValue(given));
}

/**
 * Whether this may be a parameter's name. It becomes an attribute, and must be none that runs a script or takes the focus.
 *
 * @param {string} name
 */
function isName(name) {
  return NAME.test(name) && !isReserved(name.toLowerCase());
}

/** @param {unknown} value */
function isValue(value) {
  if (value === null) return true;
  return typeof value === "number" ? Number.isFinite(value) : typeof value === "string" && value.length <= LONGEST;
}

/** @param {unknown} value @returns {value is number | string | undefined} */
function isIdentifier(value) {
  return value === undefined || Number.isFinite(value) || (typeof value === "string" && value.length <= LONGEST);
}

/** @param {unknown} value @returns {value is boolean | undefined} */
function isFlag(value) {
  return value === undefined || typeof value === "boolean";
}

/** @param {unknown} value @returns {value is Record<string, unknown>} */
function isRecord(value) {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}
