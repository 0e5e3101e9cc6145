/**
 * One parameter: its symbol, a slider, and a number box that takes an exact value and says its range; or for the
 * regime, which is a word, a choice.
 *
 * @typedef {import("../figure/services.js").ParameterInfo} ParameterInfo
 * @typedef {import("../figure/services.js").GearErrorFields} GearErrorFields
 * @typedef {import("../engine/gear-bifurcations.js").NumberParameterInfo} NumberInfo
 * @typedef {import("../engine/gear-bifurcations.js").RegimeInfo} RegimeInfo
 */

/**
 * @typedef {object} Control
 * @property {HTMLElement} element
 * @property {(value: number | string) => void} show  Shows a value, unless the reader is writing one.
 * @property {(message: string | null) => void} complain  A sentence about what cannot be, or none.
 */

/**
 * @typedef {object} Hooks
 * @property {(value: number | string) => void} change
 * @property {(problem: GearErrorFields) => void} refuse  What was written will not do.
 */

import { elements, plain } from "../figure/markup.js";
import { spoken } from "../words/engine.js";
import { judge, rangeOf, writeNumber } from "./number.js";
import { place, stepped, track, valueAt } from "./scale.js";

/** While somebody writes, nothing is called wrong before this pause, ms. */
const THINKING = 700;

/**
 * @param {ParameterInfo} info
 * @param {number | string} value
 * @param {Hooks} hooks
 * @returns {Control}
 */
export function createControl(info, value, hooks) {
  return "choices" in info ? choiceControl(info, value, hooks) : numberControl(info, Number(value), hooks);
}

/**
 * @param {NumberInfo} info
 * @param {number} value
 * @param {Hooks} hooks
 * @returns {Control}
 */
function numberControl(info, value, hooks) {
  const { element, label, help, complaint } = frame(info.name, elements(info.symbol));
  const name = plain(info.symbol);
  help.append(`${spoken(info.meaning)}; `, span("range", rangeOf(info)));

  const slider = document.createElement("input");
  slider.type = "range";
  const { min, max, step } = track(info);
  Object.assign(slider, { min: String(min), max: String(max), step: String(step) });
  slider.setAttribute("aria-label", `${name}, ${spoken(info.meaning)}`);

  const box = document.createElement("input");
  Object.assign(box, { type: "text", inputMode: "decimal", autocomplete: "off", spellcheck: false, id: `${info.name}-box` });
  box.setAttribute("role", "spinbutton");
  box.setAttribute("aria-valuemin", String(info.low));
  box.setAttribute("aria-valuemax", String(info.high));
  box.setAttribute("aria-describedby", `${help.id} ${complaint.id}`);
  label.htmlFor = box.id;
  slider.setAttribute("aria-describedby", complaint.id);
  element.append(slider, box, help, complaint);

  let current = value;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let thinking;

  /** @param {number} to */
  const showOnSlider = (to) => {
    slider.value = String(place(info, to));
    slider.setAttribute("aria-valuetext", writeNumber(to));
    box.setAttribute("aria-valuenow", String(to));
  };
  /** @param {number} to */
  const take = (to) => {
    current = to;
    complain(box, complaint, null);
    showOnSlider(to);
    hooks.change(to);
  };
  const judgeBox = () => {
    clearTimeout(thinking);
    const judgement = judge(info, box.value);
    if ("value" in judgement) {
      if (judgement.value !== current || box.hasAttribute("aria-invalid")) take(Number(judgement.value));
      return;
    }
    complain(box, complaint, judgement.problem.message);
    hooks.refuse(judgement.problem);
  };

  slider.addEventListener("input", () => {
    const to = valueAt(info, Number(slider.value));
    box.value = writeNumber(to);
    take(to);
  });
  box.addEventListener("input", () => {
    clearTimeout(thinking);
    if ("value" in judge(info, box.value)) judgeBox();
    else thinking = setTimeout(judgeBox, THINKING);
  });
  box.addEventListener("change", judgeBox);
  box.addEventListener("keydown", (event) => {
    const steps = { ArrowUp: 1, ArrowDown: -1, PageUp: 10, PageDown: -10 }[event.key];
    if (event.key === "Enter") judgeBox();
    if (steps === undefined || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    const to = stepped(info, current, steps);
    box.value = writeNumber(to);
    take(to);
  });

  box.value = writeNumber(value);
  showOnSlider(value);
  return {
    element,
    show(to) {
      current = Number(to);
      // What will not do stays as written, beside its sentence, until it is mended or reset.
      const keep = box.hasAttribute("aria-invalid") || (box.matches(":focus") && says(info, box.value, current));
      if (!keep) box.value = writeNumber(current);
      showOnSlider(current);
    },
    complain: (message) => complain(box, complaint, message),
  };
}

/**
 * Whether what stands in the box already says the value, in whatever way the reader writes it.
 *
 * @param {NumberInfo} info
 * @param {string} text
 * @param {number} value
 */
function says(info, text, value) {
  const judgement = judge(info, text);
  return "value" in judgement && judgement.value === value;
}

/**
 * @param {RegimeInfo} info
 * @param {number | string} value
 * @param {Hooks} hooks
 * @returns {Control}
 */
function choiceControl(info, value, hooks) {
  const { element, label, help, complaint } = frame(info.name, document.createTextNode(info.name));
  element.classList.add("choice");
  help.append(spoken(info.meaning));
  const select = document.createElement("select");
  select.id = `${info.name}-box`;
  for (const choice of info.choices) select.append(new Option(choice, choice, false, choice === value));
  select.setAttribute("aria-describedby", `${help.id} ${complaint.id}`);
  label.htmlFor = select.id;
  element.append(select, help, complaint);
  select.addEventListener("change", () => {
    complain(select, complaint, null);
    hooks.change(select.value);
  });
  return {
    element,
    show: (to) => {
      select.value = String(to);
    },
    complain: (message) => complain(select, complaint, message),
  };
}

/**
 * What every control has: a label, a line that explains, and a place for complaints.
 *
 * @param {string} name
 * @param {Node} symbol
 */
function frame(name, symbol) {
  const element = document.createElement("div");
  element.className = "control";
  element.dataset.parameter = name;
  const label = document.createElement("label");
  label.append(symbol);
  const help = document.createElement("p");
  help.className = "help";
  help.id = `${name}-help`;
  const complaint = document.createElement("p");
  complaint.className = "complaint";
  complaint.id = `${name}-complaint`;
  complaint.setAttribute("role", "alert");
  element.append(label);
  return { element, label, help, complaint };
}

/**
 * @param {HTMLElement} field
 * @param {HTMLElement} place
 * @param {string | null} message
 */
function complain(field, place, message) {
  if (message === null) {
    field.removeAttribute("aria-invalid");
    if (place.textContent !== "") place.textContent = "";
  } else {
    field.setAttribute("aria-invalid", "true");
    if (place.textContent !== message) place.textContent = message;
  }
}

/**
 * @param {string} className
 * @param {string} text
 */
function span(className, text) {
  const made = document.createElement("span");
  made.className = className;
  made.textContent = text;
  return made;
}
