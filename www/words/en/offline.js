/** What is said of a new release. */

/** @type {import("../say.js").Words} */
export const words = {
  "offline.new": "A new version of this page is ready. What you have set here is in the address and stays.",
  "offline.load": "Load it now",
  "offline.later": "Later",
};
