/** Die Texte, die in index.html stehen; die englischen stehen dort. */

/** @type {import("../say.js").Words} */
export const words = {};
