/**
 * What was done, as a line of states with a place on it. Pure functions on plain data.
 *
 * @template S
 * @typedef {object} Entry
 * @property {string} name  What was done, a key of the catalogue; empty for the first.
 * @property {S} state  How it was afterwards.
 * @property {string | null} merge  What kind of action can still be counted in with it.
 * @property {number} time  When, ms.
 */

/**
 * @template S
 * @typedef {{entries: readonly Entry<S>[], at: number}} History
 */

/** Actions of a kind that follow each other within this time are one, ms. */
const CLOSE = 1000;

/**
 * @template S
 * @param {S} state
 * @returns {History<S>}
 */
export function begin(state) {
  return { entries: [{ name: "", state, merge: null, time: 0 }], at: 0 };
}

/**
 * Adds an action. What had been undone is forgotten, as the new one starts from before it.
 *
 * @template S
 * @param {History<S>} history
 * @param {Entry<S>} entry
 * @param {boolean} held  Whether whatever acts is still held: then closeness in time does not matter.
 * @returns {History<S>}
 */
export function record({ entries, at }, entry, held) {
  const last = entries[at];
  const newest = at === entries.length - 1;
  const joins = newest && entry.merge !== null && entry.merge === last.merge && (held || entry.time - last.time < CLOSE);
  const kept = entries.slice(0, joins ? at : at + 1);
  return { entries: [...kept, entry], at: kept.length };
}

/**
 * Nothing that follows is counted in with the last action.
 *
 * @template S
 * @param {History<S>} history
 * @returns {History<S>}
 */
export function settled({ entries, at }) {
  return { entries: entries.map((entry, index) => (index === at ? { ...entry, merge: null } : entry)), at };
}

/**
 * @template S
 * @param {History<S>} history
 * @returns {History<S>}
 */
export function undone({ entries, at }) {
  return { entries, at: Math.max(0, at - 1) };
}

/**
 * @template S
 * @param {History<S>} history
 * @returns {History<S>}
 */
export function redone({ entries, at }) {
  return { entries, at: Math.min(entries.length - 1, at + 1) };
}
