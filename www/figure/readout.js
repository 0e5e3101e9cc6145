/**
 * What is under the pointer: the coordinates, with as many digits as a pixel can tell apart, and what is drawn there.
 *
 * @typedef {import("./services.js").Figure} Figure
 * @typedef {import("./services.js").FrameMap} FrameMap
 * @typedef {import("./frames.js").Pixel} Pixel
 * @typedef {import("../engine/gear-bifurcations.js").FigureSeries} FigureSeries
 */

import { showTo } from "../controls/number.js";
import { dataAt, frameAt, frameOf, pixelOf, pixelSize } from "./frames.js";
import { elements, sentence } from "./markup.js";

/** As near as this to a curve or mark is on it, CSS pixels. */
const NEAR = 9;

/**
 * The words for a pixel, or null where there is no plane frame.
 *
 * @param {Figure} figure
 * @param {readonly FrameMap[]} maps
 * @param {Pixel} pixel
 * @returns {DocumentFragment | null}
 */
export function readout(figure, maps, pixel) {
  const map = frameAt(maps, pixel);
  if (map === undefined || map.projection !== null) return null;
  const frame = frameOf(figure, map);
  if (frame === undefined || frame.bare) return null;
  const { x, y } = dataAt(map, pixel);
  const size = pixelSize(map);
  const words = document.createDocumentFragment();
  words.append(elements(frame.x.label), ` = ${showTo(x, size.x)}`);
  // A scale along one line has no second coordinate.
  if (frame.y.label !== "") words.append(", ", elements(frame.y.label), ` = ${showTo(y, size.y)}`);
  const field = figure.series.find((series) => series.frame === map.name && series.mark === "field");
  const value = field === undefined ? null : valueAt(field, x, y);
  if (value !== null && frame.bar !== null) {
    words.append(", ", elements(frame.bar.label), ` = ${showTo(value, (frame.bar.high - frame.bar.low) / 500)}`);
  }
  const meaning = under(figure, map, pixel) ?? (value === null ? null : (field?.meaning ?? null));
  if (meaning !== null) words.append(": ", sentence(meaning));
  return words;
}

/**
 * @param {Figure} figure
 * @param {FrameMap} map
 * @param {Pixel} pixel
 */
function under(figure, map, pixel) {
  let nearest = NEAR * NEAR;
  /** @type {string | null} */
  let meaning = null;
  // What is drawn last lies on top and wins where two are equally near.
  for (const series of figure.series) {
    if (series.frame !== map.name || ["text", "band", "field"].includes(series.mark)) continue;
    const distance = squaredDistance(series, map, pixel);
    if (distance <= nearest) {
      nearest = distance;
      meaning = series.meaning;
    }
  }
  return meaning;
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
 * @param {FigureSeries} series
 * @param {FrameMap} map
 * @param {Pixel} pixel
 */
function squaredDistance({ mark, columns, pieces }, map, pixel) {
  const joined = mark === "curve";
  const starts = new Set(pieces);
  let least = Infinity;
  /** @type {Pixel | null} */
  let before = null;
  for (let index = 0; index < columns.x.length; index += 1) {
    const point = pixelOf(map, columns.x[index], columns.y[index]);
    const from = joined && before !== null && !starts.has(index) ? before : point;
    least = Math.min(least, squaredDistanceToSegment(pixel, from, point));
    before = point;
  }
  return least;
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
