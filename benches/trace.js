// How long a page's main thread has worked, read off a trace of the browser.

import { readFile, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";

/**
 * @typedef {{name: string, ph: string, pid: number, tid: number, ts: number, dur?: number, tdur?: number, args?: any}} TraceEvent
 * @typedef {{begin: number, time: number}} Task  When it began after the navigation, and how long it worked, ms.
 */

/**
 * What the main thread of a page does while something is done there: its tasks, with the time of the processor that each
 * took, not that of the clock, for the processor has others to serve.
 *
 * @param {import("@playwright/test").Browser} browser
 * @param {import("@playwright/test").Page} page
 * @param {() => Promise<unknown>} act  It navigates.
 * @returns {Promise<Task[]>}
 */
export async function tasksOf(browser, page, act) {
  const file = join(tmpdir(), `gear-trace-${process.pid}.json`);
  await browser.startTracing(page, { path: file, categories: ["toplevel", "loading", "blink.user_timing"] });
  await act();
  await browser.stopTracing();
  /** @type {{traceEvents: TraceEvent[]}} */
  const { traceEvents: events } = JSON.parse(await readFile(file, "utf8"));
  await rm(file);
  const started = events.filter(({ name, args }) => name === "navigationStart" && args?.data?.isOutermostMainFrame && /^(http|file)/.test(args.data.documentLoaderURL));
  const navigation = started.at(-1);
  if (navigation === undefined) throw new Error("the trace holds no navigation");
  const { pid, tid, ts } = navigation;
  const found = events.filter((event) => event.pid === pid && event.tid === tid && event.ph === "X" && event.tdur !== undefined && event.ts >= ts);
  found.sort((a, b) => a.ts - b.ts || (b.dur ?? 0) - (a.dur ?? 0));
  const tasks = [];
  let end = -Infinity;
  for (const { ts: begin, dur = 0, tdur = 0 } of found) {
    if (begin < end) continue;
    tasks.push({ begin: (begin - ts) / 1000, time: tdur / 1000 });
    end = begin + dur;
  }
  return tasks;
}
