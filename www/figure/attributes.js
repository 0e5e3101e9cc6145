/**
 * Parameters from an element's attributes, in any letter case: `omega="1.65"` is `Omega`.
 *
 * @typedef {import("./services.js").ParameterInfo} ParameterInfo
 * @typedef {import("./services.js").GearErrorFields} GearErrorFields
 */

import { judge } from "../controls/number.js";

/** Attributes that are ours but no parameters, and those that every element of HTML has. */
const OTHERS = new Set(
  ("figure controls theme fit files veiled accesskey autocapitalize autofocus class contenteditable dir draggable enterkeyhint exportparts " +
    "hidden id inert inputmode is itemid itemprop itemref itemscope itemtype lang nonce part popover role slot spellcheck " +
    "style tabindex title translate").split(" "),
);

/** What else an attribute of HTML does, it does through a property of this name. @type {Set<string> | null} */
let properties = null;

/**
 * Whether an attribute of this name, in small letters, means something to the browser or to the figure that is no parameter.
 * Who may set parameters from outside must not set these: some run scripts, others take the focus.
 *
 * @param {string} name
 */
export function isReserved(name) {
  if (properties === null) {
    properties = new Set();
    // Named one by one by the browser itself: what it will learn to understand is among them.
    for (const property in globalThis.HTMLElement?.prototype) properties.add(property.toLowerCase());
  }
  return OTHERS.has(name) || name.includes("-") || name.startsWith("on") || properties.has(name);
}

/**
 * What the attributes give; what is wrong with them is told and left out, the rest applies.
 *
 * @param {Iterable<{name: string, value: string}>} attributes
 * @param {ReadonlyMap<string, ParameterInfo>} vocabulary
 * @returns {{given: Record<string, number | string>, problems: GearErrorFields[]}}
 */
export function givenByAttributes(attributes, vocabulary) {
  const names = new Map([...vocabulary.keys()].map((name) => [name.toLowerCase(), name]));
  /** @type {Record<string, number | string>} */
  const given = {};
  /** @type {GearErrorFields[]} */
  const problems = [];
  for (const { name: attribute, value } of attributes) {
    if (OTHERS.has(attribute) || attribute.includes("-") || attribute.startsWith("on")) continue;
    const info = vocabulary.get(names.get(attribute.toLowerCase()) ?? "");
    if (info === undefined) {
      problems.push(unknown(attribute, value));
      continue;
    }
    const judgement = judge(info, value);
    if ("value" in judgement) given[info.name] = judgement.value;
    else problems.push(judgement.problem);
  }
  return { given, problems };
}

/**
 * @param {string} name
 * @param {string} value
 * @returns {GearErrorFields}
 */
function unknown(name, value) {
  const message = `There is no parameter “${name}”; it was left out.`;
  return { code: "unknown-parameter", parameter: name, given: value, allowed: null, message };
}
