/** Was über eine neue Fassung gesagt wird. */

/** @type {import("../say.js").Words} */
export const words = {
  "offline.new": "Eine neue Fassung dieser Seite ist bereit. Was Sie hier eingestellt haben, steht in der Adresse und bleibt.",
  "offline.load": "Jetzt laden",
  "offline.later": "Später",
};
