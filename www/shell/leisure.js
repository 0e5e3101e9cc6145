/**
 * Work for when nobody does anything: done one piece after the other, each begun only while the page is left alone. Thus what
 * is far from the screen is complete before somebody prints the page or goes through it, and nobody waits for it meanwhile.
 *
 * @typedef {() => Promise<unknown>} Piece
 */

/** Left alone for so long, ms, it is idle. */
const ALONE = 1500;
/** Pieces at a time: as many as a machine of two cores computes side by side. */
const LANES = 2;
/** What a reader does. */
const ACTS = ["pointerdown", "pointerup", "wheel", "keydown", "scroll", "touchstart", "input"];

/** @type {Set<Piece>} */
const pieces = new Set();
let touched = performance.now();
let busy = 0;
/** @type {ReturnType<typeof setTimeout> | null} */
let timer = null;

for (const act of ACTS) addEventListener(act, () => (touched = performance.now()), { capture: true, passive: true });

/**
 * @param {Piece} piece
 * @returns {() => void} to be called when it need not be done any more: a page in use may have no leisure for long
 */
export function atLeisure(piece) {
  pieces.add(piece);
  look();
  return () => void pieces.delete(piece);
}

function look() {
  if (timer !== null || pieces.size === 0) return;
  // A page that nobody sees has its timers held back, and rests.
  timer = setTimeout(goOn, Math.max(0, touched + ALONE - performance.now()));
}

function goOn() {
  timer = null;
  for (const piece of pieces) {
    if (busy === LANES || performance.now() - touched < ALONE) break;
    pieces.delete(piece);
    busy += 1;
    const over = () => {
      busy -= 1;
      look();
    };
    piece().then(over, over);
  }
  // Else whoever is busy looks again at its end.
  if (busy < LANES) look();
}
