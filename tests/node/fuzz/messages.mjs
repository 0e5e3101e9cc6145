// Messages that a frame must not hear: everything but what is exactly of the form, in Node and in a browser.

/** @typedef {import("../random.mjs").Choose} Choose */

const NUMBERS = [Number.NaN, Infinity, -Infinity, 0, -0, 1, 1.5, -1, 1e300];
const TEXTS = ["", "1", "gear", "set", "get", "ready", "constructor", "__proto__", "\0", "\ud800", "<img src=x onerror=alert(1)>", "javascript:alert(1)", "x".repeat(65), "../1", "Ω"];
/** Attributes that are no parameters: some would run a script, take the focus, or hide the figure. */
const RESERVED = (
  "onclick onfocus onerror onanimationstart ONLOAD style id class slot part is nonce autofocus tabindex hidden inert popover contenteditable draggable dir lang title role " +
    "figure controls theme innerHTML textContent outerHTML innertext accesskey translate"
).split(" ");
const NO_NAMES = ["", "1", "on click", "k 0", "x".repeat(40), "a-b", "<b>", "k0=1", "Ω", "a.b"];

/** Anything that can be posted. @param {Choose} choose @param {number} [depth] @returns {unknown} */
export function anything(choose, depth = 0) {
  switch (choose.integer(0, depth > 3 ? 5 : 14)) {
    case 0:
      return null;
    case 1:
      return undefined;
    case 2:
      return choose.of(NUMBERS);
    case 3:
      return choose.of(TEXTS);
    case 4:
      return choose.chance(0.5);
    case 5:
      return 10n ** 20n;
    case 6:
      return new Date(choose.of(NUMBERS));
    case 7:
      return new Map([[anything(choose, depth + 1), anything(choose, depth + 1)]]);
    case 8:
      return new Set([1, anything(choose, depth + 1)]);
    case 9:
      return new Error(choose.of(TEXTS));
    case 10:
      return new Float64Array(choose.integer(0, 8)).fill(choose.of(NUMBERS));
    case 11:
      return new ArrayBuffer(choose.integer(0, 64));
    case 12: {
      /** @type {any[]} */
      const round = [/set/g];
      round.push(round);
      return round;
    }
    case 13:
      return Array.from({ length: choose.integer(0, 4) }, () => anything(choose, depth + 1));
    default:
      return Object.fromEntries(Array.from({ length: choose.integer(0, 4) }, () => [choose.of([...TEXTS, "gear", "type", "params"]), anything(choose, depth + 1)]));
  }
}

/** What is no parameter's value. @param {Choose} choose */
function noValue(choose) {
  return choose.of([Number.NaN, Infinity, -Infinity, true, undefined, {}, [], [1], "x".repeat(65), 1n, new Date(0)]);
}

/** Parameters of which one is none. @param {Choose} choose */
function noParams(choose) {
  switch (choose.integer(0, 4)) {
    case 0:
      return choose.of([1, "k0", true, null, [["k0", 1]], new Float64Array(1).fill(1)[0]]);
    case 1:
      return { k0: 0.4, [choose.of(RESERVED)]: choose.of(["alert(1)", "import('//x')", 1, "true", null]) };
    case 2:
      return { Omega: 1.65, [choose.of(NO_NAMES)]: 1 };
    case 3:
      return { Omega: 1.6, k0: noValue(choose) };
    default:
      return Object.fromEntries(Array.from({ length: 65 }, (_, index) => [`k${index}`, 1]));
  }
}

/** @param {Choose} choose @returns {unknown} */
export function malformed(choose) {
  switch (choose.integer(0, 6)) {
    case 0:
      return { gear: choose.of([2, 0, "1", true, null, [1], { valueOf: 1 }]), type: choose.of(["set", "get", "reset", "play"]), params: { Omega: 1.5 } };
    case 1:
      return { gear: 1, type: choose.of(["SET", "Set", "", " set", 1, null, undefined, ["set"], "ready", "change", "resize", "error", "constructor", "__proto__", "toString"]), params: { Omega: 1.5 } };
    case 2:
      return { gear: 1, type: "set", params: noParams(choose) };
    case 3:
      return { gear: 1, type: "set", figure: choose.of(["../1", "11a&omega=2", "<b>", "", 11, null, ["11a"], {}, "11a\n", "toolong"]), params: { Omega: 1.5 } };
    case 4:
      return { gear: 1, type: "set", ...choose.of([{ controls: "all" }, { controls: null }, { controls: ["full"] }, { theme: "Dark" }, { theme: 1 }, { theme: "print" }]), params: { Omega: 1.5 } };
    case 5:
      return { gear: 1, type: "get", ...choose.of([{ id: {} }, { id: null }, { id: Number.NaN }, { id: "x".repeat(65) }, { data: 1 }, { data: "true" }, { data: null }, { id: [1] }]) };
    default:
      return anything(choose);
  }
}
