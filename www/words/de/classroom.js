/** Was das Klassenzimmer sagt. */

/** @type {import("../say.js").Words} */
export const words = {};
