// WebKit in its GTK port, driven by WebKitWebDriver (https://www.w3.org/TR/webdriver/) on a screen of its own (Xvfb).

import { existsSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { dragging, pressing, typing } from "./actions.mjs";
import { pause } from "./driver.mjs";
import { LISTENER, heard } from "./listen.mjs";
import { freePort, startProcess } from "./process.mjs";

const WEBDRIVER = process.env.WEBKIT_DRIVER ?? "/usr/bin/WebKitWebDriver";
/** A machine with other work to do takes its time to start it, ms. */
const PATIENCE = 60_000;
/** An answer that takes longer than this never comes, ms. */
const LONGEST_ANSWER = 120_000;

/** Its small browser lies in the library's own folder, whose name has the version of the interface in it. */
function miniBrowser() {
  if (process.env.MINI_BROWSER) return process.env.MINI_BROWSER;
  for (const libraries of ["/usr/lib/x86_64-linux-gnu", "/usr/lib/aarch64-linux-gnu", "/usr/lib"]) {
    const folders = existsSync(libraries) ? readdirSync(libraries).filter((name) => name.startsWith("webkit2gtk-")) : [];
    for (const folder of folders.sort().reverse()) {
      const browser = join(libraries, folder, "MiniBrowser");
      if (existsSync(browser)) return browser;
    }
  }
  throw new Error("there is no MiniBrowser; install webkit2gtk-driver, or name one in MINI_BROWSER");
}

/** @returns {Promise<import("./driver.mjs").Driver>} */
export async function startWebKit() {
  const port = await freePort();
  const screen = ["-a", "-s", "-screen 0 1600x1400x24"];
  const driver = startProcess("xvfb-run", [...screen, WEBDRIVER, `--port=${port}`], {
    // There is no graphics processor on the screens of Xvfb, and as root no sandbox.
    LIBGL_ALWAYS_SOFTWARE: "1",
    WEBKIT_DISABLE_COMPOSITING_MODE: "1",
    WEBKIT_DISABLE_SANDBOX_THIS_IS_DANGEROUS: "1",
  });
  try {
    return await drive(await connect(port, driver), driver);
  } catch (error) {
    await driver.end();
    throw error;
  }
}

/** @typedef {(method: "GET" | "POST" | "DELETE", path: string, body?: object) => Promise<any>} Call */

/**
 * A session: every path is below it.
 *
 * @param {number} port
 * @param {import("./process.mjs").Started} driver
 * @returns {Promise<{call: Call, version: string}>}
 */
async function connect(port, driver) {
  /** @type {Call} */
  const ask = async (method, path, body) => {
    const answer = await fetch(`http://127.0.0.1:${port}${path}`, {
      method,
      body: body === undefined ? undefined : JSON.stringify(body),
      signal: AbortSignal.timeout(LONGEST_ANSWER),
    });
    const { value } = /** @type {{value: any}} */ (await answer.json());
    if (!answer.ok) throw new Error(`${value.error}: ${value.message}`);
    return value;
  };
  let failed = "";
  driver.lines((line) => {
    if (line.includes("does not start")) failed = line;
  });
  const deadline = Date.now() + PATIENCE;
  while (!(await ask("GET", "/status").catch(() => null))) {
    if (failed !== "" || Date.now() > deadline) throw new Error(failed || `${WEBDRIVER} does not answer`);
    await pause(50);
  }
  const browser = { binary: miniBrowser(), args: ["--automation"] };
  const { sessionId, capabilities } = await ask("POST", "/session", { capabilities: { alwaysMatch: { "webkitgtk:browserOptions": browser } } });
  return { call: (method, path, body) => ask(method, `/session/${sessionId}${path}`, body), version: capabilities.browserVersion };
}

/**
 * @param {{call: Call, version: string}} session
 * @param {import("./process.mjs").Started} driver
 * @returns {Promise<import("./driver.mjs").Driver>}
 */
async function drive({ call, version }, driver) {
  await call("POST", "/timeouts", { script: LONGEST_ANSWER });
  const perform = (/** @type {import("./actions.mjs").Source[]} */ actions) => call("POST", "/actions", { actions });
  /** @type {import("./driver.mjs").Driver["evaluate"]} */
  const evaluate = async (work, ...given) => {
    // What a synchronous script answers may be a promise, but not everywhere: the asynchronous one has a word for "done".
    const script = `const [given, done] = arguments;
      (async () => JSON.stringify(await (${work})(...JSON.parse(given))))().then((text) => done({ text }), (error) => done({ error: String(error) }));`;
    const { text, error } = await call("POST", "/execute/async", { script, args: [JSON.stringify(given)] });
    if (error !== undefined) throw new Error(error);
    return typeof text === "string" ? JSON.parse(text) : undefined;
  };
  return {
    name: `WebKitGTK ${version}`,
    evaluate,
    resize: async (width, height) => {
      await call("POST", "/window/rect", { width, height });
      // The window has a frame, and what is set is the whole.
      const [wide, high] = await evaluate(() => [innerWidth, innerHeight]);
      await call("POST", "/window/rect", { width: 2 * width - wide, height: 2 * height - high });
    },
    open: async (address) => {
      await call("POST", "/url", { url: "about:blank" });
      await call("POST", "/url", { url: address });
    },
    reload: () => call("POST", "/refresh", {}),
    drag: (path) => perform(dragging(path)),
    press: (keys) => perform(pressing(keys)),
    type: (text) => perform(typing(text)),
    picture: async () => Buffer.from(await call("GET", "/screenshot"), "base64"),
    // The protocol knows no console.
    inserted: LISTENER,
    noise: () => evaluate(heard),
    close: async () => {
      await call("DELETE", "").catch(() => {});
      await driver.end();
    },
  };
}
