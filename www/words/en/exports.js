/** What exporting says. */

/** @type {import("../say.js").Words} */
export const words = {};
