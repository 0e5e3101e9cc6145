/** What the laboratory says. */

/** @type {import("../say.js").Words} */
export const words = {};
