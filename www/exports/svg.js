/**
 * A drawing as a file for paper: with what it says of itself, and with its typeface inside.
 *
 * @typedef {import("./colophon.js").Colophon} Colophon
 * @typedef {{family: string, style: string, weight: string, address: string}} Face  A face as a data address.
 */

/** Names of what has no common name. */
const NAMESPACE = "https://doi.org/10.1007/s11071-021-07110-x#gear-bifurcations";

/**
 * The drawing with `<metadata>` after its title and description, and with its faces.
 *
 * @param {string} svg
 * @param {Colophon} of
 * @param {readonly Face[]} faces  Those that it needs and that could be had.
 * @returns {string}
 */
export function dressed(svg, of, faces) {
  const head = /^<svg[^>]*>\n?(?:<title>[^]*?<\/title>\n?)?(?:<desc>[^]*?<\/desc>\n?)?/.exec(svg)?.[0] ?? "";
  return `${head}${metadata(of)}${styled(faces)}${svg.slice(head.length)}`;
}

/** Dublin Core for programs that know it, everything as JSON for those that know us. @param {Colophon} of */
function metadata(of) {
  const element = (/** @type {string} */ name, /** @type {string} */ words) => `<dc:${name}>${escaped(words)}</dc:${name}>`;
  return `<metadata>
<rdf:RDF xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#" xmlns:dc="http://purl.org/dc/elements/1.1/">
<rdf:Description rdf:about="">
${element("title", of.title)}
${element("description", of.summary)}
${element("identifier", of.link)}
${element("source", of.paper)}
${element("date", of.saved)}
${element("publisher", `gear-bifurcations ${of.version} (commit ${of.commit})`)}
</rdf:Description>
</rdf:RDF>
<gear:figure xmlns:gear="${NAMESPACE}">${escaped(JSON.stringify(of))}</gear:figure>
</metadata>
`;
}

/** @param {readonly Face[]} faces */
function styled(faces) {
  if (faces.length === 0) return "";
  const rules = faces.map(
    ({ family, style, weight, address }) =>
      `@font-face { font-family: "${family}"; font-style: ${style}; font-weight: ${weight}; src: url("${address}") format("woff2"); }\n`,
  );
  return `<style>\n${rules.join("")}</style>\n`;
}

/** As text of XML, which has no room for signs that control. @param {string} text */
function escaped(text) {
  return text
    .replace(/[\u0000-\u0008\u000b\u000c\u000e-\u001f\ufffe\uffff]/g, " ")
    .replaceAll("&", "&amp;")
    .replaceAll("<", "&lt;")
    .replaceAll(">", "&gt;");
}
