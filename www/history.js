/**
 * What was done, as a line of states with a place on it. Pure functions on plain data.
 *
 * @template S
 * @typedef {object} Entry
 * @property {number} id  No two entries of a history ever have the same; one that takes in a further action keeps its own.
 * @property {string} name  What was done, a key of the catalogue; empty for the first.
 * @property {S} state  How it was afterwards.
 * @property {string | null} merge  What kind of action can still be counted in with it.
 * @property {number} time  When, ms.
 */

/**
 * @template S
 * @typedef {object} History
 * @property {readonly Entry<S>[]} entries
 * @property {number} at  Where in it we are.
 * @property {number} first  The oldest that can be gone back to: those before it keep their places, so that a place means the same for
 *   ever, but not what they were.
 * @property {number} next  The id of the next entry.
 */

/** So many actions can be undone: more would only fill the memory of a page that is left open for days. */
export const MOST = 1000;

/** Actions of a kind that follow each other within this time are one, ms. */
const CLOSE = 1000;

/**
 * @template S
 * @param {S} state
 * @returns {History<S>}
 */
export function begin(state) {
  return { entries: [{ id: 0, name: "", state, merge: null, time: 0 }], at: 0, first: 0, next: 1 };
}

/**
 * Adds an action. What had been undone is forgotten, as the new one starts from before it.
 *
 * @template S
 * @param {History<S>} history
 * @param {Omit<Entry<S>, "id">} entry
 * @param {boolean} held  Whether whatever acts is still held: then closeness in time does not matter.
 * @returns {History<S>}
 */
export function record({ entries, at, first, next }, entry, held) {
  const last = entries[at];
  const newest = at === entries.length - 1;
  const joins = newest && entry.merge !== null && entry.merge === last.merge && (held || entry.time - last.time < CLOSE);
  const kept = entries.slice(0, joins ? at : at + 1);
  const id = joins ? last.id : next;
  return forgetful({ entries: [...kept, { ...entry, id }], at: kept.length, first, next: joins ? next : next + 1 });
}

/**
 * The same with no more to be undone than may be.
 *
 * @template S
 * @param {History<S>} history
 * @returns {History<S>}
 */
function forgetful(history) {
  const { entries, at, first } = history;
  if (at - first <= MOST) return history;
  // The very first stands in all the places that are given up.
  return { ...history, entries: replaced(entries, first, entries[0]), first: first + 1 };
}

/**
 * Nothing that follows is counted in with the last action.
 *
 * @template S
 * @param {History<S>} history
 * @returns {History<S>}
 */
export function settled(history) {
  const entry = history.entries[history.at];
  return entry.merge === null ? history : { ...history, entries: replaced(history.entries, history.at, { ...entry, merge: null }) };
}

/**
 * @template S
 * @param {History<S>} history
 * @returns {History<S>}
 */
export function undone(history) {
  return moved(history, history.at - 1);
}

/**
 * @template S
 * @param {History<S>} history
 * @returns {History<S>}
 */
export function redone(history) {
  return moved(history, history.at + 1);
}

/**
 * At another place, or at the nearest end. What is done next counts for itself.
 *
 * @template S
 * @param {History<S>} history
 * @param {number} at
 * @returns {History<S>}
 */
export function moved(history, at) {
  const place = Math.min(history.entries.length - 1, Math.max(history.first, at));
  return place === history.at ? history : settled({ ...history, at: place });
}

/**
 * @template T
 * @param {readonly T[]} list
 * @param {number} at
 * @param {T} value
 * @returns {readonly T[]}
 */
export function replaced(list, at, value) {
  return [...list.slice(0, at), value, ...list.slice(at + 1)];
}
