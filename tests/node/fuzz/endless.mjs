// The module with a call that never ends, for the test of the watch.

import { gear, GearError } from "../support.mjs";

export { GearError };

export const load = async () => ({
  ...gear,
  modes: (/** @type {any} */ ...args) => {
    // The reference is computed; only the fuzz goes on for ever.
    for (let endless = args.length !== 1; endless; );
    return gear.modes(...args);
  },
});
