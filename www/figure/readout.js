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
  const meaning = under(figure, map, pixel);
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
    if (series.frame !== map.name || series.mark === "text" || series.mark === "band") continue;
    const distance = squaredDistance(series, map, pixel);
    if (distance <= nearest) {
      nearest = distance;
      meaning = series.meaning;
    }
  }
  return meaning;
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
