/** What figures and their controls say. */

/** @type {import("../say.js").Words} */
export const words = {};
