// Gestures of mouse and keyboard in the form that both WebDriver protocols share ("perform actions").

/** @typedef {{type: string, [more: string]: unknown}} Action */
/** @typedef {{type: "key" | "pointer", id: string, parameters?: object, actions: Action[]}} Source */

/** How long a movement between two places takes, ms: about a frame, so that the page sees each. */
const STEP = 16;

/** Keys that are no character, as the protocols write them (the table of code points in "Keyboard actions"). @type {Record<string, string>} */
const KEYS = {
  Backspace: "\uE003",
  Tab: "\uE004",
  Enter: "\uE007",
  Shift: "\uE008",
  Control: "\uE009",
  Alt: "\uE00A",
  Escape: "\uE00C",
  Space: " ",
  PageUp: "\uE00E",
  PageDown: "\uE00F",
  End: "\uE010",
  Home: "\uE011",
  ArrowLeft: "\uE012",
  ArrowUp: "\uE013",
  ArrowRight: "\uE014",
  ArrowDown: "\uE015",
  Delete: "\uE017",
};

/**
 * The mouse, pressed at the first place and let go at the last.
 *
 * @param {readonly import("./driver.mjs").Place[]} path
 * @returns {Source[]}
 */
export function dragging([from, ...rest]) {
  const move = (/** @type {import("./driver.mjs").Place} */ { x, y }, /** @type {number} */ duration) => ({
    type: "pointerMove",
    origin: "viewport",
    x: Math.round(x),
    y: Math.round(y),
    duration,
  });
  return [
    {
      type: "pointer",
      id: "mouse",
      parameters: { pointerType: "mouse" },
      actions: [move(from, 0), { type: "pointerDown", button: 0 }, ...rest.map((place) => move(place, STEP)), { type: "pointerUp", button: 0 }],
    },
  ];
}

/**
 * Keys pressed one after the other and let go in the other order, as `Control+z`.
 *
 * @param {string} keys
 * @returns {Source[]}
 */
export function pressing(keys) {
  const held = keys === "+" ? ["+"] : keys.split("+");
  const values = held.map((key) => {
    const value = KEYS[key] ?? key;
    if ([...value].length !== 1) throw new Error(`no key is called ${key}`);
    return value;
  });
  const down = values.map((value) => ({ type: "keyDown", value }));
  const up = [...values].reverse();
  return [{ type: "key", id: "keyboard", actions: [...down, ...up.map((value) => ({ type: "keyUp", value }))] }];
}

/**
 * Characters, one after the other.
 *
 * @param {string} text
 * @returns {Source[]}
 */
export function typing(text) {
  const actions = [...text].flatMap((value) => [
    { type: "keyDown", value },
    { type: "keyUp", value },
  ]);
  return [{ type: "key", id: "keyboard", actions }];
}
