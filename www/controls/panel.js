/**
 * The controls of one figure: the first few at once, the rest when they are asked for.
 *
 * @typedef {import("../figure/services.js").ParameterInfo} ParameterInfo
 * @typedef {import("../figure/services.js").GearErrorFields} GearErrorFields
 * @typedef {import("../figure/services.js").Given} Given
 * @typedef {import("./control.js").Control} Control
 */

import { say } from "../words/say.js";
import { createControl } from "./control.js";

/** How many stand open. */
const OPEN = 3;
/** What readers turn first; the others follow in the order that the figure gives. */
const FIRST = ["Omega", "alpha", "zeta", "k0", "F"];

/**
 * @typedef {object} Panel
 * @property {HTMLElement} element
 * @property {(given: Given) => void} show
 * @property {(parameter: string | null, message: string | null) => boolean} complain  Whether there is a control for it.
 */

/**
 * @param {readonly ParameterInfo[]} infos
 * @param {Given} given
 * @param {"full" | "compact"} extent
 * @param {{change: (name: string, value: number | string) => void, refuse: (problem: GearErrorFields) => void}} hooks
 * @returns {Panel}
 */
export function createPanel(infos, given, extent, hooks) {
  const ordered = [...infos].sort((one, other) => rank(one.name) - rank(other.name));
  /** @type {Map<string, Control>} */
  const controls = new Map();
  let values = given;

  /** @param {ParameterInfo} info */
  const build = (info) => {
    const control = createControl(info, values[info.name] ?? info.default, {
      change: (value) => hooks.change(info.name, value),
      refuse: hooks.refuse,
    });
    controls.set(info.name, control);
    return control.element;
  };

  const element = document.createElement("form");
  element.className = "panel";
  element.addEventListener("submit", (event) => event.preventDefault());
  const open = group(...ordered.slice(0, OPEN).map(build));
  element.append(open);

  const rest = ordered.slice(OPEN);
  const more = document.createElement("details");
  const buildRest = () => {
    if (more.querySelector(".controls") === null) more.append(group(...rest.map(build)));
  };
  if (rest.length > 0 && extent === "full") {
    more.className = "more";
    const summary = document.createElement("summary");
    summary.textContent = rest.length === 1 ? say("control.one-more") : say("control.more", { count: rest.length });
    more.append(summary);
    more.addEventListener("toggle", buildRest, { once: true });
    element.append(more);
  }

  return {
    element,
    show(now) {
      values = now;
      for (const info of infos) controls.get(info.name)?.show(now[info.name] ?? info.default);
    },
    complain(parameter, message) {
      if (parameter === null) {
        for (const control of controls.values()) control.complain(null);
        return false;
      }
      if (message !== null && rest.some((info) => info.name === parameter) && extent === "full") {
        buildRest();
        more.open = true;
      }
      const control = controls.get(parameter);
      control?.complain(message);
      return control !== undefined;
    },
  };
}

/** @param {string} name */
function rank(name) {
  const index = FIRST.indexOf(name);
  return index < 0 ? FIRST.length : index;
}

/** @param {...Node} controls */
function group(...controls) {
  const made = document.createElement("div");
  made.className = "controls";
  made.append(...controls);
  return made;
}
