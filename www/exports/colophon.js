/**
 * What every file that is taken away says of itself: whence it comes, how its numbers were made, and how far they can be
 * trusted. English and plain, whatever the page speaks: a decimal point, no signs that a program would stumble over.
 *
 * @typedef {import("../figure/services.js").Figure} Figure
 * @typedef {Readonly<{version: string, commit: string}>} Release
 *
 * @typedef {object} Colophon
 * @property {string} figure  Its id.
 * @property {string} title
 * @property {string} summary
 * @property {string} link  Shows the figure in the state in which it was saved.
 * @property {string} state  The whole state, as what stands after `#` in an address.
 * @property {string} version
 * @property {string} commit
 * @property {string} saved  When, as in ISO 8601.
 * @property {string} paper
 * @property {Figure["params"]} params  Every parameter by its full name.
 * @property {string} method
 * @property {Figure["error"]} error
 * @property {Figure["distances"]} distances
 * @property {Figure["facts"]} facts
 */

import { plain } from "../figure/markup.js";

const PAPER = "https://doi.org/10.1007/s11071-021-07110-x";

/**
 * @param {Figure} figure  As the module gave it.
 * @param {{link: string, state: string, release: Release, saved: string}} at
 * @returns {Colophon}
 */
export function colophon({ id, title, summary, params, method, error, distances, facts }, { link, state, release, saved }) {
  return {
    figure: id,
    title: plain(title),
    // Numbers in it are to be read by programs too.
    summary: plain(summary).replaceAll("\u2212", "-"),
    link,
    state,
    version: release.version,
    commit: release.commit,
    saved,
    paper: PAPER,
    params,
    method,
    error,
    distances,
    facts,
  };
}

/**
 * The same as lines of text, each `name: value`, for files that have room for comments only.
 *
 * @param {Colophon} of
 * @returns {string[]}
 */
export function colophonLines(of) {
  const errors = Object.entries(of.error).filter(([, value]) => value !== null && value !== undefined);
  const apart = of.distances.map(({ what, axis, at, theory, exact, difference }) => {
    const place = axis === null || at === null ? "" : `, at ${axis} = ${at}`;
    return `theory minus exact: ${what}${place}: ${theory} - ${exact} = ${difference}`;
  });
  return [
    `gear-bifurcations, figure ${of.figure}: ${of.title}`,
    `summary: ${of.summary}`,
    `link: ${of.link}`,
    `version: ${of.version} (commit ${of.commit})`,
    `saved: ${of.saved}`,
    `paper: ${of.paper}`,
    `parameters: ${pairs(of.params)}`,
    `method: ${of.method}`,
    `error: ${errors.length === 0 ? "none, closed formulas" : pairs(Object.fromEntries(errors))}`,
    ...apart,
    ...(Object.keys(of.facts).length === 0 ? [] : [`facts: ${pairs(of.facts)}`]),
  ].map(oneLine);
}

/** @param {object} values */
function pairs(values) {
  return Object.entries(values)
    .map(([name, value]) => `${name} = ${value}`)
    .join(", ");
}

/** What breaks a line would end the comment. @param {string} text */
export function oneLine(text) {
  return text.replace(/[\u0000-\u001f\u007f\u0085\u2028\u2029]+/g, " ");
}
