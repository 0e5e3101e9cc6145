/**
 * The whine: the computed transmission error as a sound, at the pitch of the gear pair. Silent until asked for.
 *
 * @typedef {import("../engine/gear-bifurcations.js").Motion} Motion
 */

/** Mesh frequency that is heard for `Omega = 1` where no real gear pair says otherwise, Hz. */
const PITCH = 200;
/** A new waveform takes the old one's place in this time, s. */
const FADE = 0.06;
/** `u` that swings by this much on either side is as loud as it gets, half-backlashes. */
const LOUDEST = 4;
/** Frequencies that can be heard, Hz. */
const AUDIBLE = /** @type {const} */ ([20, 8000]);

export class Sound {
  /** @type {AudioContext | null} */
  #context = null;
  /** @type {GainNode | null} */
  #volume = null;
  /** @type {{source: AudioBufferSourceNode, gain: GainNode} | null} */
  #voice = null;
  #level = 0.3;
  /** @type {{motion: Motion, omega: number, hertz: number | null} | null} */
  #wanted = null;
  #on = false;

  get on() {
    return this.#on;
  }

  /** @param {boolean} on  Turned on only from within an event of the reader's, as browsers demand. */
  switch(on) {
    this.#on = on;
    if (on && this.#context === null) {
      this.#context = new AudioContext();
      this.#volume = new GainNode(this.#context, { gain: this.#level });
      this.#volume.connect(this.#context.destination);
    }
    this.#renew();
  }

  /** @param {number} level  0 to 1. */
  set level(level) {
    this.#level = level;
    if (this.#context !== null) this.#volume?.gain.setTargetAtTime(level, this.#context.currentTime, FADE);
  }

  get level() {
    return this.#level;
  }

  /**
   * What is to be heard.
   *
   * @param {Motion | null} motion  One loop of it.
   * @param {number} omega
   * @param {number | null} hertz  The mesh frequency of the real pair; null where there is none.
   */
  play(motion, omega, hertz) {
    this.#wanted = motion === null ? null : { motion, omega, hertz };
    if (this.#on) this.#renew();
  }

  /** Out of sight it is out of hearing. @param {boolean} seen */
  set seen(seen) {
    if (seen) void this.#context?.resume();
    else void this.#context?.suspend();
  }

  #renew() {
    const context = this.#context;
    if (context === null || this.#volume === null) return;
    this.#fade();
    const wave = this.#on && this.#wanted !== null ? waveform(this.#wanted, context.sampleRate) : null;
    if (wave === null) {
      if (!this.#on) void context.suspend();
      return;
    }
    void context.resume();
    const buffer = new AudioBuffer({ length: wave.length, sampleRate: context.sampleRate });
    buffer.copyToChannel(wave, 0);
    const gain = new GainNode(context, { gain: 0 });
    const source = new AudioBufferSourceNode(context, { buffer, loop: true });
    source.connect(gain).connect(this.#volume);
    gain.gain.linearRampToValueAtTime(1, context.currentTime + FADE);
    source.start();
    this.#voice = { source, gain };
  }

  #fade() {
    if (this.#voice === null || this.#context === null) return;
    const { source, gain } = this.#voice;
    this.#voice = null;
    const { currentTime } = this.#context;
    gain.gain.cancelScheduledValues(currentTime);
    gain.gain.setValueAtTime(gain.gain.value, currentTime);
    gain.gain.linearRampToValueAtTime(0, currentTime + FADE);
    source.stop(currentTime + FADE);
  }
}

/**
 * One loop of a motion as samples from -1 to 1, its mean taken away; null where there is nothing to hear.
 *
 * @param {{motion: Motion, omega: number, hertz: number | null}} wanted
 * @param {number} rate  Samples a second.
 * @returns {Float32Array<ArrayBuffer> | null}
 */
export function waveform({ motion, omega, hertz }, rate) {
  const { t, u } = motion;
  const duration = t.length < 2 ? 0 : t[t.length - 1] - t[0];
  if (!(duration > 0)) return null;
  const pitch = Math.min(AUDIBLE[1], Math.max(AUDIBLE[0], hertz ?? PITCH * omega));
  const periods = (duration * omega) / (2 * Math.PI);
  const count = Math.max(2, Math.round((periods / pitch) * rate));
  let mean = 0;
  for (let index = 1; index < u.length; index += 1) mean += u[index] / (u.length - 1);
  const samples = new Float32Array(count);
  // A motion that does not close in the loop would click once in each: its mismatch is spread over the whole of it.
  const mismatch = u[u.length - 1] - u[0];
  let after = 1;
  for (let index = 0; index < count; index += 1) {
    const time = t[0] + (index / count) * duration;
    while (after < t.length - 1 && t[after] < time) after += 1;
    const part = (time - t[after - 1]) / (t[after] - t[after - 1]);
    const value = u[after - 1] + part * (u[after] - u[after - 1]) - mean - mismatch * (index / count - 0.5);
    samples[index] = Math.tanh(value / LOUDEST);
  }
  return samples;
}
