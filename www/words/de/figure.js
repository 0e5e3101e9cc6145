/** Was die Abbildungen und ihre Regler sagen. */

/** @type {import("../say.js").Words} */
export const words = {
  "control.range": "{low} bis {high}",
  "control.choice": "{name} ist eines von {allowed}; angegeben war „{given}“.",
  "control.nothing": "{symbol} muss eine Zahl von {range} sein; es steht nichts da.",
  "control.no-number": "{symbol} muss eine Zahl von {range} sein; „{given}“ ist keine.",
  "control.outside": "{symbol} muss von {range} liegen; angegeben war {given}.",
  "control.one-more": "Ein weiterer Parameter",
  "control.more": "{count} weitere Parameter",
};
