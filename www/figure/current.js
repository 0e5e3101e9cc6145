/**
 * Which figure is meant when none is named: the one that was last focused, clicked or touched, as long as it is shown, else
 * the one that stands nearest to the middle of the window.
 *
 * @typedef {import("./gear-figure.js").GearFigure} GearFigure
 */

/** It may have left the page, and is not to be kept for this. @type {WeakRef<Element> | null} */
let last = null;

/** Watches which figure its reader is at. */
export function watchFigures() {
  for (const act of ["focusin", "pointerdown"]) {
    addEventListener(
      act,
      (event) => {
        const figure = event.composedPath().find((part) => part instanceof Element && part.localName === "gear-figure");
        if (figure instanceof Element) last = new WeakRef(figure);
      },
      { capture: true, passive: true },
    );
  }
}

/** @returns {GearFigure | null} null where none is shown */
export function currentFigure() {
  const all = /** @type {GearFigure[]} */ ([...document.querySelectorAll("gear-figure")]);
  const shown = all.filter((figure) => figure.getClientRects().length > 0);
  const far = (/** @type {Element} */ figure) => {
    const { top, bottom, left, right } = figure.getBoundingClientRect();
    return Math.max(top - innerHeight / 2, innerHeight / 2 - bottom, 0) + Math.max(left - innerWidth / 2, innerWidth / 2 - right, 0);
  };
  const near = (/** @type {Element} */ figure) => {
    const { top, bottom } = figure.getBoundingClientRect();
    return bottom > 0 && top < innerHeight;
  };
  const held = shown.find((figure) => figure === last?.deref());
  if (held !== undefined && near(held)) return held;
  return shown.reduce((/** @type {GearFigure | null} */ best, figure) => (best === null || far(figure) < far(best) ? figure : best), null);
}
