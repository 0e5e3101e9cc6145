/**
 * The faces of a drawing as data addresses: those that the document itself has, or those of the site.
 *
 * @typedef {import("./svg.js").Face} Face
 */

const TEXT = "STIX Two Text";

/** Faces, the signs in a drawing that ask for them, and their files on the site. */
const FACES = [
  { family: TEXT, style: "normal", weight: "400", file: "regular", asked: /<text/ },
  { family: TEXT, style: "italic", weight: "400", file: "italic", asked: /font-style="italic"/ },
  { family: TEXT, style: "normal", weight: "700", file: "bold", asked: /font-weight="(?:bold|700)"/ },
  { family: "STIX Two Math", style: "normal", weight: "400", file: "signs", asked: /[\u2190-\u2194\u21d2\u2202-\u22ff\u27e8\u27e9]/ },
];

/**
 * @param {string} svg
 * @param {string | null} home  The folder of the site, where there is one.
 * @returns {Promise<Face[]>} those that cannot be had are left out: the drawing names them all the same
 */
export async function facesFor(svg, home) {
  const wanted = FACES.filter(({ asked }) => asked.test(svg));
  const found = await Promise.all(
    wanted.map(async ({ family, style, weight, file }) => {
      const address = inDocument(family, style, weight) ?? (home === null ? null : new URL(`www/style/fonts/${file}.woff2`, home).href);
      const data = address === null ? null : await asData(address);
      return data === null ? [] : [{ family, style, weight, address: data }];
    }),
  );
  return found.flat();
}

/**
 * The address of a face in the document's own style sheets.
 *
 * @param {string} family
 * @param {string} style
 * @param {string} weight
 * @returns {string | null}
 */
function inDocument(family, style, weight) {
  for (const sheet of document.styleSheets) {
    let rules;
    try {
      rules = sheet.cssRules;
    } catch {
      // A sheet of another origin keeps its rules to itself.
      continue;
    }
    for (const rule of rules) {
      if (!(rule instanceof CSSFontFaceRule)) continue;
      const value = (/** @type {string} */ name) => rule.style.getPropertyValue(name).replace(/["']/g, "").trim();
      if (value("font-family") !== family || value("font-style") !== style || value("font-weight") !== weight) continue;
      const address = /url\(["']?([^"')]+)["']?\)/.exec(rule.style.getPropertyValue("src"))?.[1];
      if (address !== undefined) return new URL(address, sheet.href ?? document.baseURI).href;
    }
  }
  return null;
}

/** @param {string} address */
async function asData(address) {
  if (address.startsWith("data:")) return address;
  try {
    const answer = await fetch(address);
    if (!answer.ok) return null;
    let letters = "";
    for (const byte of new Uint8Array(await answer.arrayBuffer())) letters += String.fromCharCode(byte);
    return `data:font/woff2;base64,${btoa(letters)}`;
  } catch {
    return null;
  }
}
