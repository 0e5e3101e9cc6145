/** What figures in other people's pages say. */

/** @type {import("../say.js").Words} */
export const words = {
  "embed.still": "This figure cannot be computed here, so it stands still: {reason}.",
};
