/**
 * Where a value stands on its slider, and back.
 *
 * @typedef {import("../engine/gear-bifurcations.js").NumberParameterInfo} NumberInfo
 */

/** Steps of a logarithmic slider: at a factor of 100 one step is a little over a hundredth of the value. */
const LOGARITHMIC_STEPS = 400;
/** A linear slider has about so many steps or up to ten times as many. */
const LINEAR_STEPS = 500;
/** Digits of a value taken from a logarithmic slider. */
const DIGITS = 3;

/**
 * What the range input is told.
 *
 * @param {NumberInfo} info
 * @returns {{min: number, max: number, step: number}}
 */
export function track({ slider: [low, high], scale }) {
  if (scale === "logarithmic") return { min: 0, max: LOGARITHMIC_STEPS, step: 1 };
  return { min: low, max: high, step: 10 ** Math.floor(Math.log10((high - low) / LINEAR_STEPS)) };
}

/**
 * The place on the slider, at an end for what lies beyond.
 *
 * @param {NumberInfo} info
 * @param {number} value
 */
export function place(info, value) {
  const [low, high] = info.slider;
  const within = Math.min(high, Math.max(low, value));
  if (info.scale !== "logarithmic") return within;
  return (LOGARITHMIC_STEPS * Math.log(within / low)) / Math.log(high / low);
}

/**
 * The value at a place, with no more digits than the slider can tell apart.
 *
 * @param {NumberInfo} info
 * @param {number} at
 */
export function valueAt(info, at) {
  const [low, high] = info.slider;
  if (info.scale !== "logarithmic") return roundTo(at, track(info).step);
  if (at <= 0) return low;
  if (at >= LOGARITHMIC_STEPS) return high;
  return Number((low * (high / low) ** (at / LOGARITHMIC_STEPS)).toPrecision(DIGITS));
}

/**
 * The value a step further: what the arrow keys do in the number box.
 *
 * @param {NumberInfo} info
 * @param {number} value
 * @param {number} steps
 */
export function stepped(info, value, steps) {
  const [low, high] = info.slider;
  const next =
    info.scale === "logarithmic"
      ? Number((value * (high / low) ** (steps / LOGARITHMIC_STEPS)).toPrecision(DIGITS))
      : roundTo(value + steps * track(info).step, track(info).step);
  return Math.min(info.high, Math.max(info.low, next));
}

/**
 * The nearest multiple of a power of ten, free of binary dust.
 *
 * @param {number} value
 * @param {number} step
 */
export function roundTo(value, step) {
  return Number(value.toFixed(Math.max(0, Math.round(-Math.log10(step)))));
}
