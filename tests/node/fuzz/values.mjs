// What a caller may hand over: numbers from anywhere in a range, and whatever is no such number.

/** @typedef {import("../random.mjs").Choose} Choose */
/** @typedef {{name: string, low: number, high: number, slider: [number, number], scale: string, default: number}} Info */

/** Numbers that are no ordinary ones. */
const ODD = [Number.NaN, Infinity, -Infinity, 1e300, -1e300, Number.MAX_VALUE, 5e-324, -0, 0, 1, -1, 1e-300, 2 ** 32, 2 ** 53, -(2 ** 31), 1e16, 0.1 + 0.2];

/** Texts that look like something. */
const TEXTS = ["", " ", "0.5", "1e3", "NaN", "null", "homogeneous", "__proto__", "constructor", "\0", "\ud800", "Ω", "x".repeat(5000), "[object Object]", "primary2", "u_p", "2"];

/** @returns {never} */
function refuse() {
  throw new Error("thrown by what was given");
}

/** Makers of values that are no number; each is made anew, for some remember that they were read. @type {readonly ((choose: Choose) => unknown)[]} */
const STRANGE = [
  (choose) => choose.of(ODD),
  (choose) => choose.of(TEXTS),
  () => null,
  () => undefined,
  (choose) => choose.chance(0.5),
  () => 1n,
  () => Symbol("given"),
  () => () => 1,
  () => class {},
  () => [],
  (choose) => Array.from({ length: choose.integer(1, 8) }, () => choose.of(ODD)),
  () => [[[[]]]],
  () => Array(6),
  () => ({}),
  () => Object.create(null),
  () => Object.freeze({ k0: 0.5 }),
  () => Object.create({ k0: 0.1 }),
  () => new Date(Number.NaN),
  () => new Map([["k0", 1]]),
  () => new (class Parameters {})(),
  () => new Number(0.5),
  () => new String("contact"),
  () => /k0/,
  () => Promise.resolve(1),
  () => new Error("given"),
  () => globalThis,
  (choose) => new Float64Array(choose.of([0, 2, 3, 6, 7, 1000])).fill(choose.of(ODD)),
  () => new BigInt64Array(6),
  () => new Uint8Array(6),
  () => new DataView(new ArrayBuffer(8)),
  () => new Float64Array(new SharedArrayBuffer(48)),
  (choose) => ({ length: choose.of([6, 0, -1, 1.5, 1e300, Number.NaN, "6", 2 ** 32]) }),
  () => ({ valueOf: () => 0.5 }),
  () => ({ valueOf: refuse, toString: refuse, toJSON: refuse }),
  () => ({ [Symbol.toPrimitive]: refuse }),
  () => ({ [Symbol("k0")]: 1 }),
  () => Object.defineProperty({}, "k0", { enumerable: true, get: refuse }),
  () => Object.defineProperty([1, 2, 3, 4, 5, 6], 3, { get: refuse }),
  () => Object.defineProperty({}, "length", { get: refuse }),
  () => new Proxy({}, { ownKeys: refuse }),
  () => new Proxy({}, { getPrototypeOf: refuse }),
  () => new Proxy({ k0: 1 }, { get: refuse }),
  () => new Proxy(() => {}, {}),
  () => new Proxy([1, 2, 3, 4, 5, 6], { get: (list, name) => (name === "length" ? 6 : Reflect.get(list, name)) }),
  () => {
    const { proxy, revoke } = Proxy.revocable({}, {});
    revoke();
    return proxy;
  },
  // Says something else every time it is asked.
  () => {
    let asked = 0;
    return new Proxy({}, { ownKeys: () => ["k0"], getOwnPropertyDescriptor: () => ({ enumerable: true, configurable: true, value: 1 }), get: () => [0.5, "k0", Number.NaN, {}][(asked += 1) % 4] });
  },
  () => {
    /** @type {Record<string, unknown>} */
    const round = {};
    round.k0 = round;
    return round;
  },
  () => Object.fromEntries(Array.from({ length: 300 }, (_, index) => [`name${index}`, index])),
  () => detached(),
];

/** A view of memory that has been given away. */
function detached() {
  const view = new Float64Array(6);
  structuredClone(view, { transfer: [view.buffer] });
  return view;
}

/** @param {Choose} choose @returns {unknown} */
export function strange(choose) {
  return choose.of(STRANGE)(choose);
}

/** A text that may be a name. @param {Choose} choose */
export function strangeText(choose) {
  return choose.of(TEXTS);
}

/**
 * A number from a range: mostly what a slider covers, at times from anywhere, at the ends, or next to them.
 *
 * @param {Choose} choose
 * @param {Info} info
 * @param {number} [wild]  How often it lies beyond what a slider covers, 0 to 1.
 */
export function within(choose, { low, high, slider, scale, default: usual }, wild = 0.3) {
  if (!choose.chance(wild)) return choose.chance(0.15) ? usual : choose.number(slider[0], slider[1]);
  switch (choose.integer(0, 4)) {
    case 0:
      return low;
    case 1:
      return high;
    case 2:
      return choose.of([low + 1e-12 * (high - low), high - 1e-12 * (high - low), ...slider]);
    case 3:
      return low > 0 && scale === "logarithmic" ? Math.exp(choose.number(Math.log(low), Math.log(high))) : choose.number(low, high);
    default:
      // Small, of either sign where there is one.
      return Math.min(high, Math.max(low, 10 ** choose.number(-9, 0) * (choose.chance(0.5) ? 1 : -1)));
  }
}

/** A number beyond a range, or none. @param {Choose} choose @param {{low: number, high: number}} range */
export function beyond(choose, { low, high }) {
  return choose.of([low - 1, high + 1, low - 1e-9, high * 2 + 1, Number.NaN, Infinity, -Infinity, -1e300, 1e300]);
}
