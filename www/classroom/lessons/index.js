/**
 * The lessons that ship, in the order in which they are best taken.
 *
 * @typedef {import("../lesson.js").Lesson} Lesson
 */

import { contact } from "./contact.js";
import { hopf } from "./hopf.js";
import { hysteresis } from "./hysteresis.js";
import { pitchfork } from "./pitchfork.js";
import { tongue } from "./tongue.js";

/** @type {readonly Lesson[]} */
export const LESSONS = Object.freeze([tongue, pitchfork, hopf, hysteresis, contact]);
