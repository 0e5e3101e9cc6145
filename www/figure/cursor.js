/**
 * One cursor through all charts over the same quantity. Whoever reads a value off an axis says so with a `gear-cursor`
 * event on any element of the document, `detail: {quantity, value}`, the quantity by its name in docs/symbols.md and the
 * value null when nothing is read any more; every chart over this quantity then shows a line there.
 *
 * @typedef {{quantity: string, value: number | null}} Cursor
 */

/** Name of the event. */
export const CURSOR = "gear-cursor";

/**
 * @param {EventTarget} from
 * @param {Cursor} cursor
 */
export function tellCursor(from, { quantity, value }) {
  from.dispatchEvent(new CustomEvent(CURSOR, { detail: { quantity, value }, bubbles: true, composed: true }));
}

/**
 * @param {(cursor: Cursor, from: EventTarget | null) => void} hear
 * @returns {() => void} ends it
 */
export function hearCursors(hear) {
  /** @param {Event} event */
  const listen = (event) => {
    const detail = event instanceof CustomEvent ? event.detail : null;
    if (typeof detail?.quantity !== "string") return;
    const value = typeof detail.value === "number" && Number.isFinite(detail.value) ? detail.value : null;
    hear({ quantity: detail.quantity, value }, event.target);
  };
  document.addEventListener(CURSOR, listen);
  return () => document.removeEventListener(CURSOR, listen);
}
