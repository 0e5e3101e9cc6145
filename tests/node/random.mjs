// Random choices from a seed: the same on every machine.

/** @param {number} seed */
export function random(seed) {
  let state = seed >>> 0;
  /** A number in [0, 1), by mulberry32. */
  const next = () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let mixed = Math.imul(state ^ (state >>> 15), state | 1);
    mixed ^= mixed + Math.imul(mixed ^ (mixed >>> 7), mixed | 61);
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32;
  };
  return {
    next,
    /** @param {number} low @param {number} high Both are possible. */
    integer: (low, high) => low + Math.floor(next() * (high - low + 1)),
    /** @param {number} low @param {number} high */
    number: (low, high) => low + next() * (high - low),
    /** @param {number} probability */
    chance: (probability) => next() < probability,
    /** @template T @param {readonly T[]} list @returns {T} */
    of: (list) => list[Math.floor(next() * list.length)],
  };
}

/** @typedef {ReturnType<typeof random>} Choose */
