// The figures beyond the paper: they compute in the browser what the references say, and follow the reader's hand.

import { readFileSync } from "node:fs";
import { control, data, expect, figure, map, open, series, test } from "./page.js";

/** @param {string} name */
const reference = (name) => JSON.parse(readFileSync(new URL(`../reference/${name}.json`, import.meta.url), "utf8"));

test("figure E is a table that anyone can read, computed here", async ({ page }) => {
  await open(page);
  const home = figure(page, "E");
  await home.scrollIntoViewIfNeeded();
  const { table } = await data(page, "E");
  const rows = home.locator(".rows tbody tr");
  await expect(rows).toHaveCount(table?.length ?? 0);
  await expect(home.getByRole("columnheader", { name: "printed", exact: true })).toBeVisible();
  const line = rows.filter({ has: page.getByRole("rowheader", { name: "(105)", exact: true }) });
  await expect(line).toContainText("0.40131717");
  await expect(line).toContainText("0.35643978");
});

test("figure T: the boundary passes the exact edges, and the ring goes where it is dragged", async ({ page }) => {
  await open(page);
  const home = figure(page, "T");
  await home.scrollIntoViewIfNeeded();
  const before = await data(page, "T");
  const edges = reference("tongue_edges").edges["k0=0.5 zeta=0.02"]["2w2"];
  const { columns } = series(before, "second mode period-doubling");
  const middle = columns.y;
  const left = columns.x.filter((_, index) => Math.abs(middle[index] - 0.5) < 0.02);
  expect(Math.min(...left)).toBeLessThan(edges.left + 0.01);
  const [frame] = await map(page, "T");
  const canvas = home.locator("canvas");
  const at = (/** @type {number} */ omega, /** @type {number} */ k0) => ({
    x: frame.plot.left + ((omega - frame.x.low) / (frame.x.high - frame.x.low)) * (frame.plot.right - frame.plot.left),
    y: frame.plot.bottom - ((k0 - frame.y.low) / (frame.y.high - frame.y.low)) * (frame.plot.bottom - frame.plot.top),
  });
  await canvas.click({ position: at(2.4, 0.3) });
  await expect.poll(async () => (await data(page, "T")).params.Omega).toBeCloseTo(2.4, 1);
  const after = await data(page, "T");
  expect(after.params.k0).toBeCloseTo(0.3, 1);
  expect(after.summary).toContain("stable");
  const { box } = await control(page, "T", "k0");
  await expect(box).toHaveValue(/^0\.(29|3)/);
});

test("figure T follows its controls", async ({ page }) => {
  await open(page);
  const { box } = await control(page, "T", "zeta");
  await box.fill("0.05");
  await box.press("Enter");
  await expect.poll(async () => (await data(page, "T")).params.zeta).toBe(0.05);
  const names = (await data(page, "T")).series.map(({ name }) => name);
  expect(names).toContain("growth");
});

test("figure A grows finer and ends with every start decided", async ({ page }) => {
  await open(page);
  await figure(page, "A").scrollIntoViewIfNeeded();
  const { columns } = series(await data(page, "A"), "basins");
  const undecided = (columns.z ?? []).filter((value) => value === -2).length;
  expect(undecided / (columns.z?.length ?? 1)).toBeLessThan(0.01);
});
