/** A single figure in a file of its own: see figure.html. */

import { engine } from "../engine/running.js";
import { watchPrinting } from "../figure/appearance.js";
import { GearFigure } from "../figure/gear-figure.js";
import { fetchLetters } from "../figure/letters.js";
import { paintAll } from "../figure/paint-queue.js";
import { equip } from "./equip.js";

fetchLetters();
watchPrinting(paintAll);
equip(engine, document.querySelector('meta[name="gear-home"]')?.getAttribute("content") ?? null, () => import("./file-exports.js"));
customElements.define("gear-figure", GearFigure);
