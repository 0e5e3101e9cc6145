/**
 * Turning a view in space: by drag, by the arrow keys, by buttons. A vertical swipe still scrolls the page.
 *
 * @typedef {{azimuth: number, elevation: number}} Direction
 */

/**
 * @typedef {object} Turned
 * @property {(event: PointerEvent) => boolean} takes  Whether there is a view in space under the pointer.
 * @property {(direction: Direction) => void} turn
 */

/** From where views in space are seen at first, radians: as `chart::View` has it. @type {Direction} */
export const FIRST = Object.freeze({ azimuth: -Math.PI / 3, elevation: (24 * Math.PI) / 180 });
/** Radians a CSS pixel: a drag across a hand's width is half a turn. */
const DRAG = 0.011;
/** Radians a key. */
const KEY = Math.PI / 36;
const STEEPEST = Math.PI / 2;

/** @type {Readonly<Record<string, Direction>>} */
const KEYS = {
  ArrowLeft: { azimuth: -KEY, elevation: 0 },
  ArrowRight: { azimuth: KEY, elevation: 0 },
  ArrowUp: { azimuth: 0, elevation: KEY },
  ArrowDown: { azimuth: 0, elevation: -KEY },
};

export class Turning {
  /** @type {Direction} */
  direction = FIRST;
  #hooks;

  /**
   * @param {HTMLCanvasElement} canvas
   * @param {Turned} hooks
   */
  constructor(canvas, hooks) {
    this.#hooks = hooks;
    canvas.style.touchAction = "pan-y";
    canvas.addEventListener("pointerdown", (event) => this.#grasp(canvas, event));
    canvas.addEventListener("keydown", (event) => {
      if (event.ctrlKey || event.altKey || event.metaKey) return;
      if (this.press(event.key)) event.preventDefault();
    });
  }

  /**
   * What a key does, or a button named like one.
   *
   * @param {string} key
   */
  press(key) {
    if (key === "Home") this.#face(FIRST);
    else if (key in KEYS) this.#by(KEYS[key]);
    else return false;
    return true;
  }

  /**
   * @param {HTMLCanvasElement} canvas
   * @param {PointerEvent} down
   */
  #grasp(canvas, down) {
    if (down.button !== 0 || !this.#hooks.takes(down)) return;
    canvas.setPointerCapture(down.pointerId);
    canvas.classList.add("grasped");
    let { clientX, clientY } = down;
    const end = new AbortController();
    const { signal } = end;
    const drop = () => {
      canvas.classList.remove("grasped");
      end.abort();
    };
    canvas.addEventListener(
      "pointermove",
      (move) => {
        if (move.pointerId !== down.pointerId || canvas.classList.contains("pinched")) return;
        // The nearer side goes with the pointer.
        this.#by({ azimuth: -DRAG * (move.clientX - clientX), elevation: DRAG * (move.clientY - clientY) });
        ({ clientX, clientY } = move);
      },
      { signal },
    );
    canvas.addEventListener("pointerup", drop, { signal });
    canvas.addEventListener("pointercancel", drop, { signal });
  }

  /** @param {Direction} change */
  #by({ azimuth, elevation }) {
    const turned = this.direction.azimuth + azimuth;
    this.#face({
      azimuth: turned - 2 * Math.PI * Math.round(turned / (2 * Math.PI)),
      elevation: Math.min(STEEPEST, Math.max(-STEEPEST, this.direction.elevation + elevation)),
    });
  }

  /** @param {Direction} direction */
  #face(direction) {
    this.direction = direction;
    this.#hooks.turn(direction);
  }
}
