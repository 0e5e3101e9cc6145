// How the browser tests run: in the Chromium that is on the machine, on a page served from a sub-path, as a host with
// folders would serve it. `cargo xtask test` passes the browser and the address; run by hand, the server starts here.

import { defineConfig } from "@playwright/test";

const executablePath = process.env.CHROMIUM ?? "/usr/bin/chromium";
const given = process.env.GEAR_ADDRESS;
const port = 8417;
const prefix = "/some/where/";

export default defineConfig({
  testDir: "tests/browser",
  outputDir: "test-results",
  // A test that passes at the second try has found something: no retries.
  retries: 0,
  workers: 2,
  fullyParallel: true,
  forbidOnly: Boolean(process.env.CI),
  timeout: 60_000,
  reporter: [["list"]],
  use: {
    // Ends with a slash: tests say page.goto("./") and stay under the prefix.
    baseURL: given ?? `http://127.0.0.1:${port}${prefix}`,
    trace: "retain-on-failure",
    launchOptions: {
      executablePath,
      args: [
        // Chromium's sandbox refuses to run as root, which is what build machines are.
        ...(process.getuid?.() === 0 ? ["--no-sandbox"] : []),
        "--disable-background-networking",
        "--disable-component-update",
        "--disable-sync",
        "--disable-quic",
        "--no-first-run",
      ],
    },
  },
  projects: [{ name: "chromium", use: { browserName: "chromium" } }],
  ...(given
    ? {}
    : {
        webServer: {
          command: `cargo xtask serve --port ${port} --prefix ${prefix}`,
          url: `http://127.0.0.1:${port}${prefix}`,
          timeout: 600_000,
        },
      }),
});
