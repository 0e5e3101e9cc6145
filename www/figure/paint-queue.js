/**
 * Draws figures in animation frames, those in sight first, and no longer in one frame than the page can spare.
 *
 * @typedef {{readonly inSight: boolean, paint(): void}} Painter
 */

/** Time a frame may spend on drawing before the rest waits for the next one, ms. */
const BUDGET = 24;

/** @type {Set<Painter>} */
const waiting = new Set();
/** Who wants to know when a painter has painted. @type {{painter: Painter, tell: () => void}[]} */
let asking = [];
let requested = false;

/** @param {Painter} painter */
export function requestPaint(painter) {
  waiting.add(painter);
  if (!requested) {
    requested = true;
    requestAnimationFrame(paintFrame);
  }
}

/** @param {Painter} painter */
export function forgetPaint(painter) {
  waiting.delete(painter);
  tellWhoAsked();
}

/**
 * Resolves once nothing of this painter's waits to be drawn: however many frames that takes.
 *
 * @param {Painter} painter
 * @returns {Promise<void>}
 */
export function painted(painter) {
  if (!waiting.has(painter)) return Promise.resolve();
  return new Promise((resolve) => asking.push({ painter, tell: resolve }));
}

function tellWhoAsked() {
  const done = asking.filter(({ painter }) => !waiting.has(painter));
  asking = asking.filter(({ painter }) => waiting.has(painter));
  for (const { tell } of done) tell();
}

/** Draws everything that waits, at once: before the page is printed. */
export function paintAll() {
  for (const painter of [...waiting]) {
    waiting.delete(painter);
    painter.paint();
  }
  tellWhoAsked();
}

function paintFrame() {
  requested = false;
  const start = performance.now();
  const order = [...waiting].sort((one, other) => Number(other.inSight) - Number(one.inSight));
  for (const painter of order) {
    waiting.delete(painter);
    painter.paint();
    if (performance.now() - start > BUDGET) break;
  }
  tellWhoAsked();
  if (waiting.size > 0 && !requested) {
    requested = true;
    requestAnimationFrame(paintFrame);
  }
}
