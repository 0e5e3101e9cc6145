/**
 * What is under the pointer: the coordinates and what is drawn there.
 *
 * @typedef {import("./services.js").Figure} Figure
 * @typedef {import("./services.js").FrameMap} FrameMap
 * @typedef {import("./frames.js").Pixel} Pixel
 * @typedef {import("../engine/gear-bifurcations.js").FigureSeries} FigureSeries
 * @typedef {import("../engine/gear-bifurcations.js").FigureFrame} FigureFrame
 */

import { showTo } from "../controls/number.js";
import { lastDigit } from "./digits.js";
import { dataAt, frameAt, frameOf, pixelOf, pixelSize } from "./frames.js";
import { FURNITURE } from "./furniture.js";
import { elements, sentence } from "./markup.js";
import { errorWords, trustWords } from "./trust.js";

/** As near as this to a curve or mark is on it, CSS pixels. */
const NEAR = 9;

/**
 * What is read at a place of a plane.
 *
 * @typedef {object} Reading
 * @property {FrameMap} map
 * @property {FigureFrame} frame
 * @property {Pixel} pixel  Where it is: the point's own place where a point is read.
 * @property {number} x
 * @property {number} y
 * @property {{series: FigureSeries, index: number} | null} point  The computed point that is read, or null for a mere place.
 * @property {string | null} meaning  Of what is drawn there.
 * @property {number | null} value  Of a field.
 * @property {string | null} [trust]  How far it can be trusted.
 */

/**
 * What is under a pixel, or null where there is no plane with axes. Near a computed point the point itself is read.
 *
 * @param {Figure} figure
 * @param {readonly FrameMap[]} maps
 * @param {Pixel} pixel
 * @param {(series: FigureSeries) => boolean} shown
 * @returns {Reading | null}
 */
export function read(figure, maps, pixel, shown) {
  const map = frameAt(maps, pixel);
  if (map === undefined || map.projection !== null) return null;
  const frame = frameOf(figure, map);
  if (frame === undefined || frame.bare) return null;
  const place = dataAt(map, pixel);
  const field = figure.series.find((series) => series.frame === map.name && series.mark === "field" && shown(series));
  const value = field === undefined ? null : valueAt(field, place.x, place.y);
  const found = under(figure, map, pixel, shown);
  const meaning = found?.series.meaning ?? (value === null ? null : (field?.meaning ?? null));
  const ofField = value === null ? null : errorWords(figure.error) || null;
  const trust = found === null ? ofField : trustWords(figure, found.series, place);
  const reading = { map, frame, pixel, ...place, point: null, meaning, value, trust };
  return found === null || found.index === null ? reading : { ...reading, ...pointAt(map, found.series, found.index) };
}

/**
 * A point of a series as it is read.
 *
 * @param {FrameMap} map
 * @param {FigureSeries} series
 * @param {number} index
 */
export function pointAt(map, series, index) {
  const [x, y] = [series.columns.x[index], series.columns.y[index]];
  return { x, y, pixel: pixelOf(map, x, y), point: { series, index } };
}

/**
 * A reading in words, with as many digits as a pixel can tell apart, or for a computed point as many as are true.
 *
 * @param {Figure} figure
 * @param {Reading} reading
 * @returns {DocumentFragment}
 */
export function readout(figure, { map, frame, x, y, point, meaning, value, trust = null }) {
  const size = pixelSize(map);
  const words = document.createDocumentFragment();
  const step = (/** @type {"x" | "y"} */ axis, /** @type {number} */ at) =>
    point === null ? size[axis] : lastDigit(figure, at, map[axis].high - map[axis].low);
  words.append(elements(frame.x.label), ` = ${showTo(x, step("x", x))}`);
  // A scale along one line has no second coordinate.
  if (frame.y.label !== "") words.append(", ", elements(frame.y.label), ` = ${showTo(y, step("y", y))}`);
  if (value !== null && frame.bar !== null) {
    words.append(", ", elements(frame.bar.label), ` = ${showTo(value, (frame.bar.high - frame.bar.low) / 500)}`);
  }
  if (meaning !== null) words.append(": ", sentence(meaning));
  if (trust !== null) words.append(" (", sentence(trust), ")");
  return words;
}

/**
 * What is drawn nearest under a pixel, and its computed point if that is near as well.
 *
 * @param {Figure} figure
 * @param {FrameMap} map
 * @param {Pixel} pixel
 * @param {(series: FigureSeries) => boolean} shown
 * @returns {{series: FigureSeries, index: number | null} | null}
 */
function under(figure, map, pixel, shown) {
  let nearest = NEAR * NEAR;
  /** @type {{series: FigureSeries, index: number | null} | null} */
  let best = null;
  // What is drawn last lies on top and wins where two are equally near.
  for (const series of figure.series) {
    if (series.frame !== map.name || ["text", "band", "field"].includes(series.mark) || !shown(series)) continue;
    const { distance, index, toPoint } = nearestOf(series, map, pixel);
    if (distance <= nearest) {
      nearest = distance;
      best = { series, index: toPoint <= NEAR * NEAR && !FURNITURE.has(series.role) ? index : null };
    }
  }
  return best;
}

/**
 * The number of a field nearest to a place, or null outside of it.
 *
 * @param {FigureSeries} series
 * @param {number} x
 * @param {number} y
 */
function valueAt({ columns }, x, y) {
  const column = nearest(columns.x, x);
  const row = nearest(columns.y, y);
  if (column === null || row === null) return null;
  return columns.z?.[row * columns.x.length + column] ?? null;
}

/**
 * @param {Float64Array} places  Evenly spaced and rising.
 * @param {number} wanted
 */
function nearest(places, wanted) {
  const last = places.length - 1;
  const along = last === 0 ? 0 : ((wanted - places[0]) / (places[last] - places[0])) * last;
  return along < -0.5 || along > last + 0.5 ? null : Math.min(last, Math.max(0, Math.round(along)));
}

/**
 * Squared distances to what is drawn of a series and to the nearest of its points.
 *
 * @param {FigureSeries} series
 * @param {FrameMap} map
 * @param {Pixel} pixel
 */
function nearestOf({ mark, columns, pieces }, map, pixel) {
  const joined = mark === "curve";
  const starts = new Set(pieces);
  let [distance, toPoint, index] = [Infinity, Infinity, 0];
  /** @type {Pixel | null} */
  let before = null;
  for (let at = 0; at < columns.x.length; at += 1) {
    const point = pixelOf(map, columns.x[at], columns.y[at]);
    const from = joined && before !== null && !starts.has(at) ? before : point;
    distance = Math.min(distance, squaredDistanceToSegment(pixel, from, point));
    const own = (pixel.left - point.left) ** 2 + (pixel.top - point.top) ** 2;
    if (own < toPoint) [toPoint, index] = [own, at];
    before = point;
  }
  return { distance, toPoint, index };
}

/**
 * @param {Pixel} pixel
 * @param {Pixel} from
 * @param {Pixel} to
 */
function squaredDistanceToSegment(pixel, from, to) {
  const along = { left: to.left - from.left, top: to.top - from.top };
  const length = along.left ** 2 + along.top ** 2;
  const part =
    length === 0
      ? 0
      : ((pixel.left - from.left) * along.left + (pixel.top - from.top) * along.top) / length;
  const held = Math.min(1, Math.max(0, part));
  return (
    (pixel.left - from.left - held * along.left) ** 2 + (pixel.top - from.top - held * along.top) ** 2
  );
}
