/** Was Abbildungen auf fremden Seiten sagen. */

/** @type {import("../say.js").Words} */
export const words = {
  "embed.still": "Diese Abbildung kann hier nicht berechnet werden und steht deshalb still: {reason}.",
};
