/**
 * From pixels of a canvas to data and back, by the map that drawing returned.
 *
 * @typedef {import("./services.js").FrameMap} FrameMap
 * @typedef {import("./services.js").Figure} Figure
 * @typedef {import("../engine/gear-bifurcations.js").FigureFrame} FigureFrame
 * @typedef {{left: number, top: number}} Pixel  CSS pixels from the canvas's corner.
 */

/**
 * The frame under a pixel.
 *
 * @param {readonly FrameMap[]} maps
 * @param {Pixel} pixel
 */
export function frameAt(maps, { left, top }) {
  return maps.find(
    ({ plot }) => left >= plot.left && left <= plot.right && top >= plot.top && top <= plot.bottom,
  );
}

/**
 * @param {FrameMap} map  Of a plane frame.
 * @param {Pixel} pixel
 * @returns {{x: number, y: number}}
 */
export function dataAt({ plot, x, y }, { left, top }) {
  return {
    x: x.low + ((left - plot.left) / (plot.right - plot.left)) * (x.high - x.low),
    y: y.high - ((top - plot.top) / (plot.bottom - plot.top)) * (y.high - y.low),
  };
}

/**
 * @param {FrameMap} map  Of a plane frame.
 * @param {number} x
 * @param {number} y
 * @returns {Pixel}
 */
export function pixelOf(map, x, y) {
  const { plot } = map;
  return {
    left: plot.left + ((x - map.x.low) / (map.x.high - map.x.low)) * (plot.right - plot.left),
    top: plot.bottom - ((y - map.y.low) / (map.y.high - map.y.low)) * (plot.bottom - plot.top),
  };
}

/**
 * How much data one CSS pixel is worth, along each axis.
 *
 * @param {FrameMap} map
 */
export function pixelSize({ plot, x, y }) {
  return {
    x: (x.high - x.low) / (plot.right - plot.left),
    y: (y.high - y.low) / (plot.bottom - plot.top),
  };
}

/**
 * @param {Figure} figure
 * @param {FrameMap} map
 * @returns {FigureFrame | undefined}
 */
export function frameOf(figure, map) {
  return figure.axes.find(({ frame }) => frame === map.name);
}

/**
 * Where a pointer is on its canvas.
 *
 * @param {MouseEvent} event
 * @param {HTMLCanvasElement} canvas
 * @returns {Pixel}
 */
export function pixelUnder(event, canvas) {
  const box = canvas.getBoundingClientRect();
  return { left: event.clientX - box.left, top: event.clientY - box.top };
}
