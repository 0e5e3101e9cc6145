/**
 * Draws figures: those in sight in animation frames, and no longer in one frame than the page can spare; the others
 * between frames, one at a time, for nobody sees when they change. So is one in sight that is drawn for the first time: that takes
 * as long again, and with the browser's own painting in one task it would hold the page up.
 *
 * @typedef {{readonly inSight: boolean, makeReady(): void, paint(): void}} Painter  To be made ready is to be given its size, which takes
 *   what has changed around it into account, and what it is drawn on.
 */

import { inNextTask } from "./next-task.js";

/** Time a frame may spend on drawing before the rest waits for the next one, ms. One figure is always drawn. */
const BUDGET = 12;

/** @type {Set<Painter>} */
const waiting = new Set();
/** Who has painted before. @type {WeakSet<Painter>} */
const warm = new WeakSet();
/** Who wants to know when a painter has painted. @type {{painter: Painter, tell: () => void}[]} */
let asking = [];
/** Who was made ready last, for its first drawing. @type {Painter | null} */
let ready = null;
let framed = false;
let posted = false;
/** Whether anything has been drawn yet. */
let begun = false;
/** What waits until then. @type {(() => void)[]} */
const waitingForFirst = [];
/** What waits for a first drawing waits no longer than this, ms. */
const FIRST_PATIENCE = 400;

/** @param {Painter} painter */
export function requestPaint(painter) {
  waiting.add(painter);
  // The very first picture waits for nothing: the frame after it shows it.
  if (!begun && painter.inSight) paint(painter);
  else schedule();
}

/**
 * Work that would take the processor from the page's very first drawing: done after it, or when that takes too long.
 *
 * @param {() => void} work
 */
export function afterFirst(work) {
  if (begun) {
    work();
    return;
  }
  if (waitingForFirst.length === 0) setTimeout(waitNoMore, FIRST_PATIENCE);
  waitingForFirst.push(work);
}

/** Does what waits for the first drawing. */
export function waitNoMore() {
  begun = true;
  for (const work of waitingForFirst.splice(0)) work();
}

/** @param {Painter} painter */
export function forgetPaint(painter) {
  waiting.delete(painter);
  if (ready === painter) ready = null;
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
  for (const painter of [...waiting]) paint(painter);
  tellWhoAsked();
}

/** Whether a painter is drawn in a frame. @param {Painter} painter */
function isForFrame(painter) {
  return painter.inSight && warm.has(painter);
}

function schedule() {
  const painters = [...waiting];
  const framing = painters.filter(isForFrame).length;
  if (!framed && framing > 0) {
    framed = true;
    requestAnimationFrame(paintFrame);
  }
  if (!posted && painters.length > framing) {
    posted = true;
    inNextTask(paintBetween);
  }
}

function paintFrame() {
  framed = false;
  const start = performance.now();
  for (const painter of [...waiting].filter(isForFrame)) {
    paint(painter);
    if (performance.now() - start > BUDGET) break;
  }
  tellWhoAsked();
  schedule();
}

function paintBetween() {
  posted = false;
  const painters = [...waiting];
  const next = painters.find((painter) => painter.inSight && !warm.has(painter)) ?? painters.find(({ inSight }) => !inSight);
  // What is seen comes first: the frame that is on its way asks again.
  if (framed && !next?.inSight) return;
  if (next !== undefined) {
    // To lay out what has changed around it and to give it a canvas takes half as long as to draw it for the first time: each has a task.
    if (warm.has(next) || ready === next) paint(next);
    else (ready = next).makeReady();
  }
  tellWhoAsked();
  schedule();
}

/** @param {Painter} painter */
function paint(painter) {
  waiting.delete(painter);
  warm.add(painter);
  ready = null;
  painter.paint();
  if (begun) return;
  begun = true;
  inNextTask(waitNoMore);
}
