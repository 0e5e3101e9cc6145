/** Was beim Ausgeben gesagt wird. */

/** @type {import("../say.js").Words} */
export const words = {};
