/** Was das Labor sagt. */

/** @type {import("../say.js").Words} */
export const words = {};
