/**
 * Figures begin in turn: the first that stands on the screen at once, the others there when it is drawn, the rest when those are, between
 * whatever else the page has to do, for thirty of them in one go would hold it up.
 *
 * @typedef {object} Beginner
 * @property {() => boolean} stands  Whether it is on the screen by its place.
 * @property {(stands: boolean) => void} begin
 * @property {Promise<unknown>} drawn  Its first drawing stands, or cannot come.
 * @property {AbortSignal} signal  Once it is aborted there is nobody to begin.
 */

import { inNextTask } from "./next-task.js";
import { afterFirst, waitNoMore } from "./paint-queue.js";

/** As style/story.css has it. */
const HELD_BACK = 'main > [data-view="story"]:not([hidden]) > section.held';

/** What is out of sight waits no longer than this for what is seen to be drawn, ms. */
const PATIENCE = 400;
/** Time one turn may take, ms. */
const BUDGET = 6;

/** @type {Beginner[]} */
let arriving = [];
/** Whether any has begun. */
let begun = false;
/** @type {Beginner[]} */
const waiting = [];

/**
 * Whether an element has its place among what `hold-back.js` keeps from being laid out while the page opens: out of sight,
 * and to ask where would have all of it laid out.
 *
 * @param {Element} element
 */
export function isHeldBack(element) {
  return element.closest(HELD_BACK) !== null;
}

/** @param {Beginner} beginner */
export function inTurn(beginner) {
  arriving.push(beginner);
  // Those that come together are looked at together: what each of them changes would have all places computed anew. Whoever put
  // a whole room of them there has done enough for one task; only the page's own first figures do not wait for the next.
  if (arriving.length === 1) (begun ? inNextTask : queueMicrotask)(beginShown);
}

function beginShown() {
  begun = true;
  const standing = arriving.map((beginner) => ({ beginner, stands: !beginner.signal.aborted && beginner.stands() }));
  arriving = [];
  const idle = waiting.length === 0;
  const [first, ...shown] = standing.filter(({ stands }) => stands);
  waiting.push(...standing.flatMap(({ beginner, stands }) => (stands ? [] : [beginner])));
  const others = () => {
    for (const { beginner } of shown) if (!beginner.signal.aborted) beginner.begin(true);
    if (!idle || waiting.length === 0) return;
    const rest = new Promise((resolve) => setTimeout(resolve, PATIENCE));
    void Promise.race([Promise.all(shown.map(({ beginner }) => beginner.drawn)), rest]).then(() => inNextTask(goOn));
  };
  first?.beginner.begin(true);
  // While a page opens, what the workers do for the others they do at the cost of what is about to be seen.
  if (first === undefined) others();
  else afterFirst(others);
}

/** Begins all at once, for where nothing can be waited for. */
export function beginAll() {
  waitNoMore();
  beginShown();
  for (const { begin, signal } of waiting.splice(0)) if (!signal.aborted) begin(false);
}

function goOn() {
  const start = performance.now();
  do {
    const next = waiting.shift();
    if (next !== undefined && !next.signal.aborted) next.begin(false);
  } while (waiting.length > 0 && performance.now() - start < BUDGET);
  if (waiting.length > 0) inNextTask(goOn);
}
