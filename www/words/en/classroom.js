/** What the classroom says. */

/** @type {import("../say.js").Words} */
export const words = {};
