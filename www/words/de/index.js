/** German, whole: loaded only when it is chosen. */

import { engine as patterns } from "./engine.js";
import { words as classroom } from "./classroom.js";
import { words as embedded } from "./embed.js";
import { words as exported } from "./exports.js";
import { words as figure } from "./figure.js";
import { words as lab } from "./lab.js";
import { words as offline } from "./offline.js";
import { words as shell } from "./shell.js";
import { words as story } from "./story.js";
import { words as tools } from "./tools.js";

/** @type {import("../say.js").Words} */
export const german = { ...classroom, ...embedded, ...exported, ...figure, ...lab, ...offline, ...shell, ...story, ...tools };

export const engine = patterns;
