/** Was die Abbildungen und ihre Regler sagen. */

/** @type {import("../say.js").Words} */
export const words = {};
