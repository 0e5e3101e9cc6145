// Firefox, driven over WebDriver BiDi (https://w3c.github.io/webdriver-bidi/), which it speaks itself: nothing else need be installed.

import { mkdtemp, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import WebSocket from "ws";
import { dragging, pressing, typing } from "./actions.mjs";
import { startProcess } from "./process.mjs";

const FIREFOX = process.env.FIREFOX ?? "/usr/bin/firefox-esr";
/** A machine with other work to do takes its time to start it, ms. */
const PATIENCE = 60_000;

/** A new profile: no first-run pages, no questions, no calls home, downloads without asking. */
const PREFERENCES = {
  "browser.shell.checkDefaultBrowser": false,
  "browser.startup.page": 0,
  "browser.aboutwelcome.enabled": false,
  "datareporting.policy.dataSubmissionEnabled": false,
  "toolkit.telemetry.enabled": false,
  "app.update.enabled": false,
  "app.normandy.enabled": false,
  "extensions.update.enabled": false,
  "network.captive-portal-service.enabled": false,
  "network.connectivity-service.enabled": false,
  "browser.safebrowsing.malware.enabled": false,
  "browser.safebrowsing.phishing.enabled": false,
  "services.settings.server": "data:,",
};

/** Said of an equation of which the rest has not been read yet; the journey looks at all of them when they have been. */
const UNREAD = /^Invalid markup: Incorrect number of children for <m\w+\/> tag\.$/;

/** Said, of no place, while a page is left that a frame of it is just answering: what came for it belongs to nobody any more. */
const LEFT = /^(Error: )?Permission denied to access property "\w+"$/;

/** @typedef {{id?: number, type?: string, method?: string, params?: any, result?: any, error?: string, message?: string}} Message */

/** @returns {Promise<import("./driver.mjs").Driver>} */
export async function startFirefox() {
  const profile = await mkdtemp(join(tmpdir(), "gear-firefox-"));
  const preferences = Object.entries(PREFERENCES).map(([name, value]) => `user_pref(${JSON.stringify(name)}, ${JSON.stringify(value)});`);
  await writeFile(join(profile, "user.js"), preferences.join("\n"));
  const firefox = startProcess(FIREFOX, ["--headless", "--no-remote", "--profile", profile, "--remote-debugging-port=0", "about:blank"]);
  const end = async () => {
    await firefox.end();
    await rm(profile, { recursive: true, force: true, maxRetries: 5 });
  };
  try {
    return await drive(await connect(await listening(firefox)), end);
  } catch (error) {
    await end();
    throw error;
  }
}

/** The address at which it waits for us. @param {import("./process.mjs").Started} firefox @returns {Promise<string>} */
function listening(firefox) {
  return new Promise((resolve, reject) => {
    const timer = setTimeout(() => reject(new Error(`${FIREFOX} says no address`)), PATIENCE);
    firefox.lines((line) => {
      const address = /WebDriver BiDi listening on (ws:\/\/\S+)/.exec(line)?.[1];
      if (line.includes("does not start")) reject(new Error(line));
      if (address === undefined) return;
      clearTimeout(timer);
      resolve(`${address}/session`);
    });
  });
}

/**
 * @typedef {object} Connection
 * @property {(method: string, params?: object) => Promise<any>} call
 * @property {(hear: (method: string, params: any) => void) => void} events
 * @property {() => void} close
 */

/** @param {string} address @returns {Promise<Connection>} */
async function connect(address) {
  const socket = new WebSocket(address);
  await new Promise((resolve, reject) => {
    socket.once("open", resolve);
    socket.once("error", reject);
  });
  let last = 0;
  /** @type {Map<number, {resolve: (result: any) => void, reject: (error: Error) => void}>} */
  const waiting = new Map();
  /** @type {((method: string, params: any) => void)[]} */
  const hearers = [];
  socket.on("message", (bytes) => {
    /** @type {Message} */
    const { id, type, method, params, result, error, message } = JSON.parse(bytes.toString());
    if (type === "event") for (const hear of hearers) hear(method ?? "", params);
    const asked = waiting.get(id ?? -1);
    waiting.delete(id ?? -1);
    if (type === "error") asked?.reject(new Error(`${error}: ${message}`));
    else asked?.resolve(result);
  });
  socket.on("close", () => {
    for (const { reject } of waiting.values()) reject(new Error("Firefox is gone"));
  });
  return {
    call: (method, params = {}) =>
      new Promise((resolve, reject) => {
        last += 1;
        waiting.set(last, { resolve, reject });
        socket.send(JSON.stringify({ id: last, method, params }));
      }),
    events: (hear) => void hearers.push(hear),
    close: () => socket.terminate(),
  };
}

/**
 * @param {Connection} connection
 * @param {() => Promise<void>} end
 * @returns {Promise<import("./driver.mjs").Driver>}
 */
async function drive({ call, events, close }, end) {
  const { capabilities } = await call("session.new", { capabilities: {} });
  await call("session.subscribe", { events: ["log.entryAdded", "network.responseCompleted", "network.fetchError"] });
  // What a policy forbids is no entry of its log.
  await call("script.addPreloadScript", {
    functionDeclaration: `() => addEventListener("securitypolicyviolation", ({ violatedDirective, blockedURI }) => console.error(violatedDirective, "forbids", blockedURI))`,
  });
  const { contexts } = await call("browsingContext.getTree");
  /** @type {string} */
  const context = contexts[0].context;
  /** @type {string[]} */
  let noise = [];
  let leaving = false;
  events((method, { level, text, response, request, errorText }) => {
    if (method === "log.entryAdded" && !UNREAD.test(text) && !(leaving && LEFT.test(text))) noise.push(`console ${level}: ${text}`);
    if (method === "network.responseCompleted" && response.status >= 400) noise.push(`status ${response.status}: ${response.url}`);
    // Whoever leaves a page gives up what it still waited for.
    if (method === "network.fetchError" && errorText !== "NS_BINDING_ABORTED") noise.push(`${errorText}: ${request.url}`);
  });
  const perform = (/** @type {import("./actions.mjs").Source[]} */ actions) => call("input.performActions", { context, actions });
  return {
    name: `Firefox ${capabilities.browserVersion}`,
    resize: (width, height) => call("browsingContext.setViewport", { context, viewport: { width, height } }),
    open: async (address) => {
      leaving = true;
      await call("browsingContext.navigate", { context, url: "about:blank", wait: "complete" });
      leaving = false;
      await call("browsingContext.navigate", { context, url: address, wait: "complete" });
    },
    reload: () => call("browsingContext.reload", { context, wait: "complete" }),
    evaluate: async (work, ...given) => {
      const { type, result, exceptionDetails } = await call("script.callFunction", {
        functionDeclaration: `async (given) => JSON.stringify(await (${work})(...JSON.parse(given)))`,
        arguments: [{ type: "string", value: JSON.stringify(given) }],
        awaitPromise: true,
        target: { context },
      });
      if (type !== "success") throw new Error(exceptionDetails.text);
      return result.type === "string" ? JSON.parse(result.value) : undefined;
    },
    drag: (path) => perform(dragging(path)),
    press: (keys) => perform(pressing(keys)),
    type: (text) => perform(typing(text)),
    picture: async () => Buffer.from((await call("browsingContext.captureScreenshot", { context })).data, "base64"),
    inserted: "",
    noise: async () => {
      const heard = noise;
      noise = [];
      return heard;
    },
    close: async () => {
      close();
      await end();
    },
  };
}
