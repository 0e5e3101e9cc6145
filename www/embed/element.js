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
import { EmbeddedFigure } from "./embedded-figure.js";
import { equip } from "./equip.js";

const FAMILY = "STIX Two Text";
/** @type {[string, string, FontFaceDescriptors][]} */
const FACES = [
  [FAMILY, "regular", {}],
  [FAMILY, "italic", { style: "italic" }],
  [FAMILY, "bold", { weight: "700" }],
];

/** The drawings' own typeface; a page that forbids it, or is slow to get it, sees them in another. */
function loadFaces() {
  for (const [family, file, descriptors] of FACES) {
    const address = new URL(`../style/fonts/${file}.woff2`, import.meta.url);
    const face = new FontFace(family, `url(${JSON.stringify(address.href)})`, { display: "swap", ...descriptors });
    document.fonts.add(face);
    face.load().catch(() => document.fonts.delete(face));
  }
}

let awake = false;
EmbeddedFigure.wake = () => {
  if (awake) return;
  awake = true;
  loadFaces();
  equip(startEngine({ draws: true }), new URL("../../", import.meta.url).href, () => import("./element-exports.js"));
};

// A page may name the script twice, or have an element of this name: the first one stays.
if (customElements.get("gear-figure") === undefined) customElements.define("gear-figure", EmbeddedFigure);
