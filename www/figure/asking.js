/**
 * Figures whose parameters have changed ask together, once a frame: first what workers answer, so that they are at work; handles go
 * ahead of those charts; then comes what is answered here, as long as the frame has time for it.
 *
 * @typedef {object} Asker
 * @property {() => boolean} here  Whether it may be answered here and now.
 * @property {(here: boolean) => void} ask
 * @property {() => void} lead  Shows what can be shown before the answer.
 */

/** What figures may take of a frame for answers, ms. */
const BUDGET = 28;

/** @type {Set<Asker>} */
const waiting = new Set();
let frame = 0;

/** @param {Asker} asker */
export function askInFrame(asker) {
  waiting.add(asker);
  if (frame === 0) frame = requestAnimationFrame(askAll);
}

/**
 * Whether it asks in the frame that comes.
 *
 * @param {Asker} asker
 */
export function asksInFrame(asker) {
  return waiting.has(asker);
}

/**
 * It asks no more, or has asked itself; whether it was about to.
 *
 * @param {Asker} asker
 */
export function askNoMore(asker) {
  return waiting.delete(asker);
}

function askAll() {
  frame = 0;
  const all = [...waiting].map((asker) => ({ asker, here: asker.here() }));
  waiting.clear();
  const elsewhere = all.filter(({ here }) => !here);
  for (const { asker } of elsewhere) asker.ask(false);
  for (const { asker } of elsewhere) asker.lead();
  const begin = performance.now();
  for (const { asker, here } of all) if (here) asker.ask(performance.now() - begin < BUDGET);
}
