/** Deutsch für die Sätze, die die Rechenmaschine macht. */

import { errata } from "./engine/errata.js";
import { errors } from "./engine/errors.js";
import { meanings } from "./engine/meanings.js";
import { methods } from "./engine/methods.js";
import { motions } from "./engine/motions.js";
import { summaries } from "./engine/summaries.js";
import { titles } from "./engine/titles.js";
import { compositions, words } from "./engine/words.js";

/** @type {import("../engine.js").Patterns} */
export const engine = [...words, ...titles, ...errata, ...meanings, ...errors, ...methods, ...motions, ...summaries, ...compositions];
