/** Styles that come with a script: one sheet for each text, shared by all who adopt it. */

/** @type {Map<string, CSSStyleSheet>} */
const sheets = new Map();

/**
 * Adopts a style, once however often it is asked for.
 *
 * @param {string} text
 * @param {DocumentOrShadowRoot} [root]
 * @returns {() => void} takes it back
 */
export function adopt(text, root = document) {
  const sheet = sheets.get(text) ?? new CSSStyleSheet();
  if (!sheets.has(text)) sheet.replaceSync(text);
  sheets.set(text, sheet);
  if (!root.adoptedStyleSheets.includes(sheet)) root.adoptedStyleSheets = [...root.adoptedStyleSheets, sheet];
  return () => {
    root.adoptedStyleSheets = root.adoptedStyleSheets.filter((one) => one !== sheet);
  };
}
