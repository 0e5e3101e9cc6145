/**
 * A script that makes the figure's numbers anew, in Node, through the module.
 *
 * @typedef {import("./colophon.js").Colophon} Colophon
 */

import { colophonLines, oneLine } from "./colophon.js";

/** In the folder of a site. */
export const MODULE = "gear-bifurcations.js";
/** Parted, so that whoever reads this module for its own imports finds those alone. */
const IMPORT = "im" + "port";

/**
 * @param {Colophon} of
 * @param {string} module  Where the module can be had.
 * @param {string} name  Of the script's own file.
 * @returns {string}
 */
export function script(of, module, name) {
  const comments = colophonLines(of).map((line) => `// ${line}\n`);
  const parameters = Object.entries(of.params).map(([parameter, value]) => `  ${JSON.stringify(parameter)}: ${JSON.stringify(value)},\n`);
  return `${comments.join("")}//
// Needs Node 20 or newer, and gear-bifurcations.js with gear-bifurcations_bg.wasm beside it: next to this file, or in the
// folder that is named after it. They are at
// ${oneLine(module)}
//
//     node ${name} [folder] > figure-${of.figure}.json

${IMPORT} { resolve } from "node:path";
${IMPORT} { pathToFileURL } from "node:url";

const folder = process.argv[2] === undefined ? new URL("./", ${IMPORT}.meta.url) : pathToFileURL(\`\${resolve(process.argv[2])}/\`);
const { load } = await ${IMPORT}(new URL("${MODULE}", folder).href);
const gear = await load();

const parameters = {
${parameters.join("")}};
const figure = gear.figure(${JSON.stringify(of.figure)}, parameters);

// Columns are typed arrays, which JSON does not know.
const plain = (key, value) => (ArrayBuffer.isView(value) ? Array.from(value) : value);
process.stdout.write(\`\${JSON.stringify(figure, plain, 1)}\\n\`);
`;
}
