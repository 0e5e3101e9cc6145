// What is marked for translation in an HTML document, read off its tags.

const VOID = new Set("area base br col embed hr img input link meta source track wbr".split(" "));
const TAG = /<!--[\s\S]*?-->|<(\/?)([a-z][\w-]*)((?:\s+[\w:-]+(?:\s*=\s*(?:"[^"]*"|'[^']*'|[^\s>]+))?)*)\s*(\/?)>/gi;

/**
 * @typedef {object} Marked
 * @property {string} key
 * @property {string} text  Of the attribute, or between the tags.
 * @property {string[]} children  Names of the child elements.
 * @property {string | null} attribute
 */

/**
 * @param {string} html
 * @param {readonly string[]} attributes
 * @returns {Marked[]}
 */
export function marked(html, attributes) {
  /** @type {Marked[]} */
  const found = [];
  /** @type {{name: string, key: string | null, from: number, children: string[]}[]} */
  const open = [];
  for (const match of html.matchAll(TAG)) {
    const [all, closing, name, written, selfClosing] = match;
    if (name === undefined) continue;
    if (closing === "/") {
      const element = open.pop();
      if (element?.name !== name) throw new Error(`</${name}> closes <${element?.name}> at ${html.slice(match.index, match.index + 60)}`);
      if (element.key !== null) {
        found.push({ key: element.key, text: html.slice(element.from, match.index), children: element.children, attribute: null });
      }
      continue;
    }
    open.at(-1)?.children.push(name);
    const values = new Map([...written.matchAll(/([\w:-]+)(?:\s*=\s*"([^"]*)")?/g)].map(([, key, value]) => [key, value ?? ""]));
    for (const attribute of attributes) {
      const key = values.get(`data-word-${attribute}`);
      if (key !== undefined) found.push({ key, text: values.get(attribute) ?? "", children: [], attribute });
    }
    if (selfClosing === "/" || VOID.has(name)) continue;
    open.push({ name, key: values.get("data-word") ?? null, from: match.index + all.length, children: [] });
  }
  return found;
}
