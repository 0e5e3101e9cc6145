/**
 * A handle goes ahead of the rest of its chart: it stands where the hand has put it in the very frame, while what depends on its
 * place is still computed.
 *
 * @typedef {import("./services.js").Figure} Figure
 */

/**
 * The figure with its handle at other values of the parameters along its axes, all else as it was; the same object
 * where that changes nothing. Only a handle that is one point in a plane of parameters can be told where to stand.
 *
 * @param {Figure} figure
 * @param {(name: string) => number | null} value  Of a parameter at present; null for what is none.
 * @param {boolean} [silent]  Without the word beside it, which speaks of where it stood.
 * @returns {Figure}
 */
export function withHandleAt(figure, value, silent = false) {
  let moved = false;
  const series = figure.series.map((one) => {
    const frame = figure.axes.find((axes) => axes.frame === one.frame);
    if (one.role !== "handle" || one.columns.x.length !== 1 || frame === undefined) return one;
    const [x, y] = [value(frame.x.name), value(frame.y.name)];
    if (x === null || y === null || (x === one.columns.x[0] && y === one.columns.y[0] && !silent)) return one;
    moved = true;
    const columns = { ...one.columns, x: Float64Array.of(x), y: Float64Array.of(y) };
    return silent ? { ...one, columns, label: null, meaning: "" } : { ...one, columns };
  });
  return moved ? { ...figure, series } : figure;
}
