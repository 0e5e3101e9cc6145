/** The typeface that drawings are lettered with; see style/fonts/faces.css. Equations have one of their own, which no drawing shows. */

/** @type {ReadonlySet<string>} */
const FAMILIES = new Set(["STIX Two Text", "STIX Two Math"]);

/** @param {FontFace} face */
function isOfDrawings({ family }) {
  return FAMILIES.has(family.replaceAll(/["']/g, ""));
}

/**
 * A browser fetches a face when the first of its letters is to be shown, and what was drawn meanwhile is drawn anew when it
 * has come: a document of ours has them before.
 */
export function fetchLetters() {
  for (const face of document.fonts) if (isOfDrawings(face)) face.load().catch(() => {});
}

/**
 * Called when letters have come that a drawing may have been without; not for those of the page around it.
 *
 * @param {() => void} listener
 */
export function onLetters(listener) {
  document.fonts.addEventListener("loadingdone", ({ fontfaces }) => {
    if (fontfaces.some(isOfDrawings)) listener();
  });
}
