/**
 * What is typed for the palette while it is still being fetched: without this the letters would be taken for keys of the page.
 *
 * @typedef {object} Typed
 * @property {string} written
 * @property {boolean} entered  Whether Enter came after it.
 * @property {boolean} left  Whether Escape came, which takes the wish for a palette back.
 */

/**
 * Keeps all that is typed from now on from the page.
 *
 * @returns {() => Typed}  Ends that, and says what came.
 */
export function typeAhead() {
  const typed = { written: "", entered: false, left: false };
  const life = new AbortController();
  const keep = (/** @type {KeyboardEvent} */ event) => {
    const { key, ctrlKey, metaKey, altKey } = event;
    const sign = [...key].length === 1;
    if (ctrlKey || metaKey || altKey || !(sign || ["Enter", "Escape", "Backspace"].includes(key))) return;
    event.preventDefault();
    event.stopImmediatePropagation();
    if (typed.entered || typed.left) return;
    if (sign) typed.written += key;
    else if (key === "Backspace") typed.written = [...typed.written].slice(0, -1).join("");
    else if (key === "Enter") typed.entered = true;
    else typed.left = true;
  };
  addEventListener("keydown", keep, { capture: true, signal: life.signal });
  return () => {
    life.abort();
    return typed;
  };
}
