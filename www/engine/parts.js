/**
 * One figure from several workers: each computes every so many columns of its fields, and shows in the others what it has
 * nearest to them.
 *
 * @typedef {import("../../gear-bifurcations.js").Figure} Figure
 * @typedef {import("../../gear-bifurcations.js").FigureSeries} Series
 */

/**
 * The picture of all parts so far.
 *
 * @param {readonly (Figure | null)[]} parts  In their order; null: nothing has come of it yet.
 * @param {readonly boolean[]} done  Which of them are complete.
 * @returns {Figure}
 */
export function merged(parts, done) {
  const there = parts.filter((part) => part !== null);
  // Words and numbers are those of the part that has farthest to go; of complete ones, of the least exact.
  const waiting = parts.find((part, index) => part !== null && !done[index]);
  const spoken = waiting ?? there.reduce((worst, part) => (errorOf(part) > errorOf(worst) ? part : worst));
  const names = [...new Set(there.flatMap(({ series }) => series.map(({ name }) => name)))];
  const series = names.flatMap((name) => {
    const own = parts.map((part) => part?.series.find((one) => one.name === name) ?? null);
    const first = own.find((one) => one !== null) ?? null;
    if (first === null) return [];
    if (first.mark === "field") return [interleaved(own, first)];
    return [first.mark === "cloud" ? joined(own.filter((one) => one !== null), first) : first];
  });
  return { ...spoken, series };
}

/** @param {Figure} figure */
function errorOf({ error }) {
  return error.step ?? 0;
}

/**
 * @param {readonly (Series | null)[]} own
 * @param {Series} first
 * @returns {Series}
 */
function interleaved(own, first) {
  const columns = first.columns.x.length;
  const z = Float64Array.from(first.columns.z ?? [], (value, index) => own[(index % columns) % own.length]?.columns.z?.[index] ?? value);
  return { ...first, columns: { ...first.columns, z } };
}

/**
 * @param {readonly Series[]} own
 * @param {Series} first
 * @returns {Series}
 */
function joined(own, first) {
  const all = (/** @type {"x" | "y"} */ axis) => Float64Array.from(own.flatMap(({ columns }) => [...columns[axis]]));
  return { ...first, columns: { ...first.columns, x: all("x"), y: all("y") } };
}
