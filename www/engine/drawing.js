/**
 * Drawing in a worker, on a canvas that is on no page: what a page then does with the picture costs it next to nothing.
 *
 * @typedef {import("../../gear-bifurcations.js").Gear} Gear
 * @typedef {import("./protocol.js").Drawn} Drawn
 * @typedef {import("./protocol.js").Face} Face
 * @typedef {import("./protocol.js").Figure} Figure
 * @typedef {import("./protocol.js").Wanted} Wanted
 */

/** Whether letters are as they should be: nothing is drawn before, nor where that cannot be. */
let lettered = false;

/**
 * Fetches the faces of the drawings.
 *
 * @param {readonly Face[]} faces
 */
export async function loadFaces(faces) {
  const fonts = /** @type {FontFaceSet | undefined} */ (/** @type {any} */ (self).fonts);
  if (fonts === undefined || typeof OffscreenCanvasRenderingContext2D === "undefined") return;
  // plotters' backend asks for a canvas of a page by name; ours has everything that it calls.
  Object.assign(self, { HTMLCanvasElement: OffscreenCanvas, CanvasRenderingContext2D: OffscreenCanvasRenderingContext2D });
  try {
    await Promise.all(
      faces.map(async ({ family, source, ...descriptors }) => {
        const face = new FontFace(family, await lettersOf(source), descriptors);
        fonts.add(await face.load());
      }),
    );
    lettered = faces.length > 0;
  } catch {
    // Where a policy forbids it, or they do not come, the page draws, whose letters may be others.
  }
}

/** The page has fetched them: nobody need be asked whether they have changed. @param {string} address */
async function lettersOf(address) {
  if (address.startsWith("data:")) return `url(${JSON.stringify(address)})`;
  const answer = await fetch(address, { cache: "force-cache" });
  if (!answer.ok) throw new Error(`${address}: status ${answer.status}`);
  return answer.arrayBuffer();
}

/**
 * The picture of a figure; null where it is for the page to draw.
 *
 * @param {Gear} gear
 * @param {Figure} figure
 * @param {Wanted} wanted
 * @returns {Drawn | null}
 */
export function drawn(gear, figure, { width, height, ...options }) {
  // What moves is drawn for its moment.
  if (!lettered || figure.motion !== null) return null;
  try {
    const canvas = new OffscreenCanvas(width, height);
    const onto = /** @type {HTMLCanvasElement} */ (/** @type {unknown} */ (canvas));
    const { frames, looks } = gear.draw(figure, undefined, onto, options);
    return { bitmap: canvas.transferToImageBitmap(), frames, looks };
  } catch {
    // The page will say what is the matter.
    return null;
  }
}
