/**
 * Figures whose parameters have changed ask together, once a frame: first what workers answer, so that they are at work; handles go
 * ahead of those charts; then comes what is answered here, the quickest first, as long as the frame has time for it.
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
/** How long each took when it was last answered here, ms. @type {WeakMap<Asker, number>} */
const took = new WeakMap();

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
  const all = [...waiting];
  waiting.clear();
  const here = all.filter((asker) => asker.here());
  const elsewhere = all.filter((asker) => !here.includes(asker));
  for (const asker of elsewhere) asker.ask(false);
  for (const asker of elsewhere) asker.lead();
  // What begins in time may take long: behind it a quick one would wait for the workers, and with it for all that they do.
  here.sort((a, b) => timeOf(a) - timeOf(b));
  const end = performance.now() + BUDGET;
  for (const asker of here) {
    const begin = performance.now();
    asker.ask(begin < end);
    if (begin < end) took.set(asker, performance.now() - begin);
  }
}

/** @param {Asker} asker */
function timeOf(asker) {
  return took.get(asker) ?? 0;
}
