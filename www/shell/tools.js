/**
 * What is fetched when it is first wanted: palette, settings, help.
 *
 * @typedef {object} Tools
 * @property {import("../state.js").Store} store
 * @property {import("./actions.js").Actions} actions
 * @property {{get: () => boolean, set: (on: boolean) => void}} singleKeys
 */

import { words } from "../words/en/tools.js";
import { learn } from "../words/say.js";
import { openHelp } from "./help.js";
import { openPalette } from "./palette.js";
import { openSettings } from "./settings.js";

learn(words);

/**
 * @param {"palette" | "settings" | "help"} name
 * @param {Tools} tools
 * @param {import("./type-ahead.js").Typed} [typed]  While the palette was being fetched.
 */
export function open(name, tools, typed) {
  if (name === "palette") openPalette(tools.actions, typed);
  else if (name === "settings") openSettings(tools);
  else openHelp(tools);
}
