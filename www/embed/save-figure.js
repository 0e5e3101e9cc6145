/**
 * A figure as a file of its own, made in the browser: from the shell and the parts that the single file holds, or on the
 * site from a file that has both put together. It opens by a double click and is as live as here.
 */

/** The site's file with everything in it but the figure itself. */
const TEMPLATE = "../../figure.html";
/** The ids of the parts in the single file, as `xtask/src/build/single.rs` writes them. */
const PARTS = ["gear-style", "gear-wasm", "gear-module", "gear-worker", "gear-code", "gear-shell"];

/**
 * @typedef {object} Saved
 * @property {string} figure  Its id.
 * @property {string} title
 * @property {string} description  What a still picture of it shows, in a sentence.
 * @property {string} svg  That picture.
 * @property {Readonly<Record<string, number | string>>} given  Parameters that differ from the figure's own, by name.
 * @property {string | null} [home]  The folder of the site that it comes from, as an address.
 * @property {import("../exports/colophon.js").Colophon} [colophon]  What it says of itself.
 */

/**
 * @param {Saved} saved
 * @returns {Promise<Blob>} an HTML document; rejected where the site cannot be reached
 */
export async function figureFile({ figure, title, description, svg, given, home = null, colophon }) {
  const [width, height] = ["width", "height"].map((name) => svg.match(new RegExp(`<svg[^>]* ${name}="([\\d.]+)"`))?.[1] ?? "");
  /** @type {Record<string, string>} */
  const values = {
    figure,
    title,
    description,
    width,
    height,
    picture: `data:image/svg+xml;base64,${base64(svg)}`,
  };
  const attributes = Object.entries(given).map(([name, value]) => ` ${name.toLowerCase()}="${escaped(String(value))}"`);
  const file = (await template()).replace(/\{\{(\w+)\}\}/g, (hole, name) => {
    if (name === "attributes") return attributes.join("");
    return values[name] === undefined ? hole : escaped(values[name]);
  });
  const told = { ...(home !== null && { "gear-home": home }), ...(colophon && { source: colophon.link, date: colophon.saved, "gear-colophon": JSON.stringify(colophon) }) };
  const metas = Object.entries(told).map(([name, content]) => `  <meta name="${name}" content="${escaped(content)}">\n`);
  return new Blob([file.replace("  <title>", () => `${metas.join("")}  <title>`)], { type: "text/html" });
}

/** The file before the figure is named. */
async function template() {
  const shell = document.getElementById("gear-shell")?.textContent;
  if (shell) return filled(new TextDecoder().decode(bytes(shell)));
  const answer = await fetch(new URL(TEMPLATE, import.meta.url));
  if (!answer.ok) throw new Error(`${answer.url}: status ${answer.status}`);
  return answer.text();
}

/** @param {string} shell */
function filled(shell) {
  return PARTS.reduce((text, id) => text.replace(`{{${id}}}`, () => document.getElementById(id)?.textContent ?? ""), shell);
}

/** @param {string} base64 */
function bytes(base64) {
  return Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
}

/** @param {string} text */
function base64(text) {
  let letters = "";
  for (const byte of new TextEncoder().encode(text)) letters += String.fromCharCode(byte);
  return btoa(letters);
}

/** @param {string} text */
function escaped(text) {
  return text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;").replaceAll('"', "&quot;");
}
