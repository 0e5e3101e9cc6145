/**
 * For a room: the keys that are pressed and the places that are touched are shown, so that others can follow.
 */

import { adopt } from "../style/adopt.js";
import { keyName, keyWords } from "./keys.js";

/** How long a key stays to be read after it was let go, ms. */
const READ = 1600;
/** Keys that say nothing by themselves. */
const HALF = new Set(["Control", "Shift", "Alt", "Meta", "AltGraph", "CapsLock", "Dead", "Unidentified"]);
/** Signs of keys whose names are long. @type {Readonly<Record<string, string>>} */
const SIGNS = { ArrowLeft: "←", ArrowRight: "→", ArrowUp: "↑", ArrowDown: "↓", " ": "Space" };

const STYLE = `
.shown-keys { position: fixed; inset-block-end: 1rem; inset-inline-start: 1rem; z-index: 10; display: flex; gap: 0.5rem; pointer-events: none; }
.shown-keys kbd { font: inherit; font-size: 1.75rem; line-height: 1.2; padding: 0.25rem 0.75rem; color: var(--ground); background: var(--ink); border-radius: 4px; }
.shown-touch { position: fixed; z-index: 10; inline-size: 3.5rem; block-size: 3.5rem; margin: -1.75rem; border: 4px solid var(--focus); border-radius: 50%; pointer-events: none; }
@media print { .shown-keys, .shown-touch { display: none; } }
`;

/** @returns {() => void} ends it */
export function showHands() {
  const undress = adopt(STYLE);
  const keys = document.createElement("div");
  keys.className = "shown-keys";
  // What is pressed is known to who presses it.
  keys.setAttribute("aria-hidden", "true");
  document.body.append(keys);
  /** @type {HTMLElement[]} */
  const held = [];
  /** @type {Map<number, HTMLElement>} */
  const touches = new Map();
  const life = new AbortController();
  const options = { capture: true, passive: true, signal: life.signal };

  addEventListener("keydown", (event) => {
    if (HALF.has(event.key)) return;
    // What is written into a box stands there.
    const target = event.composedPath()[0];
    if (target instanceof HTMLInputElement && target.type === "text" && event.key.length === 1 && !event.ctrlKey) return;
    if (event.repeat) return;
    const name = keyName(event);
    const key = document.createElement("kbd");
    key.textContent = SIGNS[name] === undefined ? keyWords(name) : SIGNS[name];
    keys.append(key);
    held.push(key);
  }, options);
  // Which key is let go is not always told: then it counts for all of them.
  const release = () => {
    for (const key of held.splice(0)) setTimeout(() => key.remove(), READ);
  };
  addEventListener("keyup", release, options);
  addEventListener("blur", release, options);
  addEventListener("pointerdown", (event) => {
    const ring = document.createElement("div");
    ring.className = "shown-touch";
    ring.setAttribute("aria-hidden", "true");
    place(ring, event);
    touches.get(event.pointerId)?.remove();
    touches.set(event.pointerId, ring);
    const sheetOver = document.querySelector("dialog[open]");
    (sheetOver ?? document.body).append(ring);
  }, options);
  addEventListener("pointermove", (event) => {
    const ring = touches.get(event.pointerId);
    if (ring !== undefined) place(ring, event);
  }, options);
  for (const end of ["pointerup", "pointercancel"]) {
    addEventListener(end, (event) => {
      const { pointerId } = /** @type {PointerEvent} */ (event);
      touches.get(pointerId)?.remove();
      touches.delete(pointerId);
    }, options);
  }
  return () => {
    life.abort();
    keys.remove();
    for (const ring of touches.values()) ring.remove();
    undress();
  };
}

/**
 * @param {HTMLElement} ring
 * @param {PointerEvent} event
 */
function place(ring, { clientX, clientY }) {
  ring.style.left = `${clientX}px`;
  ring.style.top = `${clientY}px`;
}
