/**
 * `<gear-figure>` for any page, by one script:
 *
 *     <script type="module" src="https://.../gear-figure.js"></script>
 *     <gear-figure figure="11a" omega="1.65"></gear-figure>
 *
 * All figures of the page share one instance of the module and one pool of workers, which start when the first of them comes
 * near the screen. See docs/embedding.md.
 */

import { startEngine } from "../engine/client.js";
import { faces } from "../engine/delivery.js";
import { fetchedByWorker } from "../engine/fetching.js";
import { EmbeddedFigure } from "./embedded-figure.js";
import { equip } from "./equip.js";

/** What a host shows of ours is set in this; signs that it lacks a host takes from elsewhere. */
const FAMILY = "STIX Two Text";

/** The drawings' own typeface; a page that forbids it, or is slow to get it, sees them in another. */
function loadFaces() {
  for (const { family, source, ...descriptors } of faces()) {
    if (family !== FAMILY) continue;
    const face = new FontFace(family, `url(${JSON.stringify(source)})`, { display: "swap", ...descriptors });
    document.fonts.add(face);
    face.load().catch(() => document.fonts.delete(face));
  }
}

EmbeddedFigure.wake = () => {
  loadFaces();
  equip(startEngine({ draws: true, fetchModule: fetchedByWorker }), new URL("../../", import.meta.url).href, () => import("./element-exports.js"));
};

// A page may name the script twice, or have an element of this name: the first one stays.
if (customElements.get("gear-figure") === undefined) customElements.define("gear-figure", EmbeddedFigure);
