/** The memory of a figure's canvas: as many pixels as its place has. */

/** A canvas narrower than this is not on the page in earnest, CSS pixels. */
const NARROWEST = 60;

/** Whether a place is wide enough to be drawn in. @param {HTMLElement} stage */
export function isPlaced(stage) {
  return stage.clientWidth >= NARROWEST;
}

/**
 * As many pixels as the place has at a density.
 *
 * @param {HTMLElement} stage
 * @param {number} density  Pixels a CSS pixel.
 */
export function pixelsOf(stage, density) {
  return { width: Math.round(stage.clientWidth * density), height: Math.round(stage.clientHeight * density) };
}

/**
 * Whether a canvas has just as many.
 *
 * @param {HTMLCanvasElement} canvas
 * @param {{width: number, height: number}} pixels
 */
export function fits(canvas, { width, height }) {
  return canvas.width === width && canvas.height === height;
}

/**
 * Setting the size clears a canvas, so it is set only when it changes.
 *
 * @param {HTMLCanvasElement} canvas
 * @param {{width: number, height: number}} pixels
 */
export function fit(canvas, { width, height }) {
  if (canvas.width !== width) canvas.width = width;
  if (canvas.height !== height) canvas.height = height;
}

/** Has the browser find the memory, which it does with the first stroke. @param {HTMLCanvasElement} canvas */
export function claim(canvas) {
  const context = canvas.getContext("2d");
  context?.save();
  context?.restore();
}
