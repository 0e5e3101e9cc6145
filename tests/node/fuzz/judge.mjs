// What is a good answer: finite numbers, nulls where the contract has them, or a whole GearError that is no fault of ours.

import { NULLABLE } from "./calls.mjs";

/** Codes whose `given` is a number that was computed, not one that was handed over. */
const COMPUTED = new Set(["no-convergence", "escaped", "numerics", "theory"]);
/** What a call may be refused with: never a fault of ours, and the module is loaded. */
const CODES = new Set(
  ("unknown-parameter not-a-number out-of-range not-a-choice not-allowed not-an-object asymmetric incommensurate missing " +
    "unbalanced-torque unknown-figure option no-convergence escaped not-found numerics theory drawing").split(" "),
);

/**
 * @param {any} thrown
 * @param {Function} GearError
 * @returns {string | null} what is wrong with it
 */
export function faultOfError(thrown, GearError) {
  if (!(thrown instanceof GearError)) return `something else was thrown: ${thrown instanceof Error ? thrown.stack : typeof thrown}`;
  const { name, code, parameter, given, allowed, message } = /** @type {any} */ (thrown);
  if (name !== "GearError") return "an error of another name";
  if (!CODES.has(code)) return `code ${code}: ${message}`;
  if (typeof message !== "string" || message.length < 10 || message.length > 7000) return `no sentence: ${String(message).slice(0, 100)}`;
  if (COMPUTED.has(code) && /NaN|\binf\b|Infinity/.test(message)) return `an odd sentence: ${message}`;
  if (parameter !== null && typeof parameter !== "string") return "parameter is neither text nor null";
  if (given !== null && typeof given !== "number" && typeof given !== "string") return "given is neither number nor text nor null";
  if (COMPUTED.has(code) && typeof given === "number" && !Number.isFinite(given)) return `${code}: given is ${given}: ${message}`;
  const isRange = Array.isArray(allowed) && allowed.length === 2 && allowed.every(Number.isFinite);
  if (allowed !== null && typeof allowed !== "string" && !isRange) return `allowed is ${allowed}`;
  if (code === "option" && (parameter === null || allowed === null)) return "an option is refused without its name, or without what it may be";
  return null;
}

/**
 * @param {unknown} value
 * @param {string} path
 * @param {string} name  The last of the path.
 * @returns {string | null} what is wrong with it
 */
export function faultOfAnswer(value, path, name) {
  switch (typeof value) {
    case "number":
      return Number.isFinite(value) ? null : `${path} is ${value}`;
    case "string":
    case "boolean":
      return null;
    case "object":
      break;
    default:
      return `${path} is ${typeof value}`;
  }
  if (value === null) return NULLABLE.has(name) ? null : `${path} is null`;
  if (ArrayBuffer.isView(value)) {
    const bad = /** @type {Float64Array} */ (value).findIndex((number) => !Number.isFinite(number));
    return bad < 0 ? null : `${path}[${bad}] is ${/** @type {Float64Array} */ (value)[bad]}`;
  }
  if (!Array.isArray(value) && Object.getPrototypeOf(value) !== Object.prototype) return `${path} is no plain object`;
  for (const [inner, content] of Object.entries(value)) {
    const fault = faultOfAnswer(content, `${path}.${inner}`, Array.isArray(value) ? name : inner);
    if (fault !== null) return fault;
  }
  return null;
}

/**
 * Columns of one length, states of six numbers, a name for everything: what can be said of an answer without computing it again.
 *
 * @param {string} call
 * @param {any} answer
 * @returns {string | null}
 */
export function faultOfShape(call, answer) {
  if (typeof answer !== "object" || answer === null) return null;
  if (!["defaults", "figures", "toPhysical", "progress"].includes(call) && call !== "svg" && (typeof answer.method !== "string" || answer.method === "" || typeof answer.error !== "object")) {
    return "it does not say how it was made";
  }
  const lengths = (/** @type {string[]} */ ...names) => new Set(names.map((name) => answer[name].length)).size === 1;
  switch (call) {
    case "timeResponse":
    case "poincare":
      return lengths("t", "u_p", "u_g", "u", "u_p_dot", "u_g_dot", "u_dot") ? null : "columns of different lengths";
    case "multipliers":
      return answer.re.length === 6 && answer.im.length === 6 && answer.spectralRadius >= 0 ? null : "no six multipliers";
    case "sweep":
      return lengths("Omega", "u_p", "u") ? null : "columns of different lengths";
    case "spectrum":
      return lengths("frequency", "amplitude") ? null : "columns of different lengths";
    case "stabilityChart":
      return answer.spectralRadius.length === answer.Omega.length * answer.k0.length ? null : "no value for each point";
    case "lyapunov":
      return answer.exponents.length === 6 && answer.exponents.every((/** @type {number} */ one, /** @type {number} */ index) => index === 0 || one <= answer.exponents[index - 1]) ? null : "exponents not in order";
    case "branch": {
      const rows = answer[answer.parameter].length;
      return answer.state.length === 6 * rows && answer.re.length === 6 * rows && answer.stable.length === rows && answer.ends.length === 2 ? null : "columns of different lengths";
    }
    case "torus":
      return answer.curve.length % 6 === 0 && answer.rotation >= 0 && answer.rotation <= 0.5 ? null : "no circle";
    case "tongueEdges":
      return (answer.left === null) === (answer.kind === null) && !(answer.left > answer.right) ? null : "edges that do not fit";
    case "figure":
      return answer.summary.length > 10 && answer.axes.length > 0 ? null : "no summary or no axes";
    default:
      return null;
  }
}
