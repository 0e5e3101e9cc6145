// Each figure's data as CSV, for a journal's supplement: `node xtask/data.js MODULE FOLDER`. `cargo xtask release` calls it.

import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

const [module, folder] = process.argv.slice(2);
/** @type {typeof import("../www/engine/gear-bifurcations.js")} */
const { load } = await import(pathToFileURL(module).href);
const gear = await load();

/** @param {string} text */
const quoted = (text) => (/[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);

for (const { id } of gear.figures()) {
  const { title, params, method, error, series, table } = gear.figure(id);
  const lines = [`# figure ${id}: ${title}`, `# parameters: ${JSON.stringify(params)}`, `# method: ${method}`, `# error: ${JSON.stringify(error)}`];
  lines.push("frame,series,stable,x,y,z");
  for (const { frame, name, stable, mark, columns, pieces } of series) {
    const starts = new Set(pieces);
    const { x, y, z } = columns;
    if (mark === "field") {
      // A number for each pair of a column and a row.
      y.forEach((row, line) => x.forEach((column, index) => lines.push([quoted(frame), quoted(name), "", column, row, z?.[line * x.length + index] ?? ""].join(","))));
      continue;
    }
    x.forEach((value, index) => {
      if (index > 0 && starts.has(index)) lines.push("");
      lines.push([quoted(frame), quoted(name), stable ?? "", value, y[index], z?.[index] ?? ""].join(","));
    });
  }
  if (table !== null) {
    lines.push("", "where,what,printed,ours,exact,deviation,ownDeviation,remark");
    for (const { where, what, printed, ours, exact, deviation, ownDeviation, remark } of table) {
      lines.push([where, what, printed, ours, exact, deviation, ownDeviation, remark].map((entry) => quoted(String(entry ?? ""))).join(","));
    }
  }
  writeFileSync(join(folder, `${id}.csv`), `${lines.join("\n")}\n`);
}
