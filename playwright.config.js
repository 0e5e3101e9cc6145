// How the browser tests run: in the Chromium that is on the machine, on a page served from a sub-path, as a host with
// folders would serve it. `cargo xtask test` passes the browser and the address; run by hand, the server starts here.

import { defineConfig } from "@playwright/test";
import { launchOptions } from "./xtask/chromium.js";

const given = process.env.GEAR_ADDRESS;
const port = 8417;
const prefix = "/some/where/";
const address = given ?? `http://127.0.0.1:${port}${prefix}`;

export default defineConfig({
  testDir: "tests/browser",
  outputDir: "test-results",
  // A test that passes at the second try has found something: no retries.
  retries: 0,
  workers: 2,
  fullyParallel: true,
  forbidOnly: Boolean(process.env.CI),
  // A guard against what hangs, not a measure of speed: a busy machine takes its time over the heavier figures.
  timeout: 120_000,
  reporter: [["list"]],
  use: {
    // Ends with a slash: tests say page.goto("./") and stay under the prefix.
    baseURL: address,
    // Keeping the page for offline use would fetch it a second time in every test; offline.spec.js allows it.
    serviceWorkers: "block",
    // A recording doubles the time of every test, keeps the pages it has seen and sets their density. When a test fails it
    // is asked for by `--trace retain-on-failure`.
    trace: "off",
    screenshot: "only-on-failure",
    launchOptions,
  },
  projects: [{ name: "chromium", use: { browserName: "chromium" } }],
  webServer: given
    ? undefined
    : { command: `cargo xtask serve --port ${port} --prefix ${prefix}`, url: address, timeout: 600_000 },
});
