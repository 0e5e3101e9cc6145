/**
 * Waiting until the reader scrolls no more: what can wait then waits, for a frame that scrolls has enough to do.
 */

/** After this without a move it is still, ms. */
const STILL = 150;

/** @type {ReturnType<typeof setTimeout> | null} */
let timer = null;
/** @type {Set<() => void>} */
const waiting = new Set();

addEventListener(
  "scroll",
  () => {
    if (timer !== null) clearTimeout(timer);
    timer = setTimeout(beStill, STILL);
  },
  // Also what scrolls within the page.
  { capture: true, passive: true },
);

function beStill() {
  timer = null;
  const all = [...waiting];
  waiting.clear();
  for (const work of all) work();
}

/**
 * Does some work once nothing is scrolled: at once where nothing is. What waits already is not done twice.
 *
 * @param {() => void} work
 */
export function whenStill(work) {
  if (timer === null) work();
  else waiting.add(work);
}
