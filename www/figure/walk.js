/**
 * Walking along the curves of a chart by keys, point by point: left and right along a curve, up and down to another one,
 * Page keys by a tenth of it, Home and End to its ends. Only what is seen is walked on.
 *
 * @typedef {import("./services.js").Figure} Figure
 * @typedef {import("./services.js").FrameMap} FrameMap
 * @typedef {import("../engine/gear-bifurcations.js").FigureSeries} FigureSeries
 * @typedef {{series: FigureSeries, index: number}} Step
 */

/**
 * @typedef {object} WalkHooks
 * @property {() => Figure | null} figure
 * @property {() => readonly FrameMap[]} maps
 * @property {(series: FigureSeries) => boolean} shown
 */

import { pixelOf } from "./frames.js";
import { FURNITURE } from "./furniture.js";

const WALKED = new Set(["curve", "cloud", "marks"]);

/** Which way the keys lead along a curve, and how far: in points, or as a part of the whole. @type {Readonly<Record<string, {points: number} | {part: number}>>} */
const ALONG = {
  ArrowRight: { points: 1 },
  ArrowLeft: { points: -1 },
  PageUp: { part: 0.1 },
  PageDown: { part: -0.1 },
  Home: { part: -1 },
  End: { part: 1 },
};

export class Walk {
  #hooks;
  /** The point that was reached, by the name of its series: a curve that is computed anew is walked on. @type {{name: string, index: number} | null} */
  #at = null;

  /** @param {WalkHooks} hooks */
  constructor(hooks) {
    this.#hooks = hooks;
  }

  /** Where it stands; null where nobody walks, or what was walked on is gone. @returns {Step | null} */
  get at() {
    const at = this.#at;
    const series = at === null ? undefined : this.#curves().find(({ name }) => name === at.name);
    if (at === null || series === undefined || series.columns.x.length === 0) return null;
    return { series, index: Math.min(at.index, series.columns.x.length - 1) };
  }

  /** Whether somebody walks. */
  get walking() {
    return this.#at !== null;
  }

  leave() {
    this.#at = null;
  }

  /**
   * Goes where a key leads. The first step only arrives: on the curve that is drawn last and so on top.
   *
   * @param {string} key
   * @returns {boolean} whether the key leads anywhere
   */
  press(key) {
    const along = ALONG[key];
    const across = key === "ArrowUp" ? 1 : key === "ArrowDown" ? -1 : 0;
    if (along === undefined && across === 0) return false;
    const now = this.at;
    if (now === null) return this.#arrive();
    if (across !== 0) this.#switch(now, across);
    else if ("points" in along) this.#go(now, along.points);
    else this.#leap(now, along.part);
    return true;
  }

  /** @returns {boolean} whether there is anything to walk on */
  #arrive() {
    const first = this.#curves()[0];
    if (first === undefined) return false;
    const seen = this.#seen(first);
    this.#at = { name: first.name, index: seen[Math.floor(seen.length / 2)] };
    return true;
  }

  /**
   * @param {Step} now
   * @param {number} by
   */
  #go({ series, index }, by) {
    const isSeen = this.#isSeen(series);
    const { length } = series.columns.x;
    for (let next = index + by; next >= 0 && next < length; next += by) {
      if (!isSeen(next)) continue;
      this.#at = { name: series.name, index: next };
      return;
    }
  }

  /**
   * @param {Step} now
   * @param {number} part  Of all points.
   */
  #leap({ series, index }, part) {
    const seen = this.#seen(series);
    if (seen.length === 0) return;
    const from = seen.findIndex((at) => at >= index);
    const by = Math.sign(part) * Math.max(1, Math.round(Math.abs(part) * seen.length));
    const to = Math.min(seen.length - 1, Math.max(0, (from < 0 ? seen.length - 1 : from) + by));
    this.#at = { name: series.name, index: seen[to] };
  }

  /**
   * To the next curve, at the point that is nearest across.
   *
   * @param {Step} now
   * @param {number} by
   */
  #switch({ series, index }, by) {
    const curves = this.#curves();
    const place = curves.findIndex(({ name }) => name === series.name);
    const next = curves[(place + by + curves.length) % curves.length];
    const from = this.#hooks.maps().find(({ name }) => name === series.frame);
    const to = this.#hooks.maps().find(({ name }) => name === next.frame);
    if (from === undefined || to === undefined) return;
    const left = pixelOf(from, series.columns.x[index], 0).left - from.plot.left + to.plot.left;
    const away = (/** @type {number} */ at) => Math.abs(pixelOf(to, next.columns.x[at], 0).left - left);
    const seen = this.#seen(next);
    const nearest = seen.reduce((best, at) => (away(at) < away(best) ? at : best), seen[0]);
    this.#at = { name: next.name, index: nearest };
  }

  /** The curves that can be walked on, those that mean most first. @returns {FigureSeries[]} */
  #curves() {
    const figure = this.#hooks.figure();
    if (figure === null) return [];
    const planes = new Map(this.#hooks.maps().filter(({ projection }) => projection === null).map((map) => [map.name, map]));
    const bare = new Set(figure.axes.filter((frame) => frame.bare).map(({ frame }) => frame));
    return figure.series.filter(
      (series) =>
        WALKED.has(series.mark) &&
        !FURNITURE.has(series.role) &&
        series.role !== "handle" &&
        planes.has(series.frame) &&
        !bare.has(series.frame) &&
        this.#hooks.shown(series) &&
        this.#seen(series).length > 0,
    );
  }

  /**
   * Indices of the points of a series that are seen.
   *
   * @param {FigureSeries} series
   * @returns {number[]}
   */
  #seen(series) {
    const isSeen = this.#isSeen(series);
    const indices = [];
    for (let index = 0; index < series.columns.x.length; index += 1) if (isSeen(index)) indices.push(index);
    return indices;
  }

  /**
   * @param {FigureSeries} series
   * @returns {(index: number) => boolean}
   */
  #isSeen({ frame, columns }) {
    const map = this.#hooks.maps().find(({ name }) => name === frame);
    if (map === undefined) return () => false;
    const { x, y } = map;
    return (index) =>
      columns.x[index] >= x.low && columns.x[index] <= x.high && columns.y[index] >= y.low && columns.y[index] <= y.high;
  }
}
