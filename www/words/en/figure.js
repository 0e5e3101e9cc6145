/** What figures and their controls say. */

/** @type {import("../say.js").Words} */
export const words = {
  "control.range": "{low} to {high}",
  "control.choice": "The {name} is one of {allowed}; “{given}” was given.",
  "control.nothing": "{symbol} must be a number from {range}; nothing was given.",
  "control.no-number": "{symbol} must be a number from {range}; “{given}” is none.",
  "control.outside": "{symbol} must lie from {range}; {given} was given.",
  "control.one-more": "One more parameter",
  "control.more": "{count} more parameters",
};
