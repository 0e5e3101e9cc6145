/**
 * The moving figure's clock. It stands while the figure is out of sight, and from the start where the reader has
 * asked for stillness.
 *
 * @typedef {import("../engine/gear-bifurcations.js").Motion} Motion
 */

/** Units of the dimensionless time a second: a mesh period of the preset takes a second and a half. */
const PACE = 2.6;
/** A longer pause between two frames (a sleeping page) is not made up for, s. */
const LONGEST_FRAME = 0.1;

export class Clock {
  /** Time of the motion. */
  time = 0;
  #playing = false;
  #seen = false;
  #frame = 0;
  #last = 0;
  #tick;
  /** @type {Motion | null} */
  #motion = null;

  /** @param {() => void} tick  Called when there is a new time to draw. */
  constructor(tick) {
    this.#tick = tick;
  }

  get playing() {
    return this.#playing;
  }

  /** @param {Motion | null} motion */
  set motion(motion) {
    this.#motion = motion;
    this.#update();
  }

  /** @param {boolean} seen */
  set seen(seen) {
    this.#seen = seen;
    this.#update();
  }

  play() {
    this.#playing = true;
    this.#update();
  }

  pause() {
    this.#playing = false;
    this.#update();
  }

  #update() {
    const runs = this.#playing && this.#seen && this.#motion !== null && this.#motion.t.length > 1;
    if (runs && this.#frame === 0) {
      this.#last = performance.now();
      this.#frame = requestAnimationFrame((now) => this.#advance(now));
    } else if (!runs && this.#frame !== 0) {
      cancelAnimationFrame(this.#frame);
      this.#frame = 0;
    }
  }

  /** @param {number} now */
  #advance(now) {
    const passed = Math.min(LONGEST_FRAME, Math.max(0, (now - this.#last) / 1000));
    this.#last = now;
    this.#frame = requestAnimationFrame((next) => this.#advance(next));
    const times = this.#motion?.t;
    if (times === undefined) return;
    const length = times[times.length - 1] - times[0];
    this.time = (this.time + PACE * passed) % length;
    this.#tick();
  }
}
