// Browsers and drivers as processes: started, read, and ended with all that they have started themselves.

import { spawn } from "node:child_process";
import { createServer } from "node:net";

/**
 * @typedef {object} Started
 * @property {(line: (text: string) => void) => void} lines  Hears every line that it writes from now on, to either output.
 * @property {() => Promise<void>} end
 */

/**
 * Starts a program in a process group of its own.
 *
 * @param {string} program
 * @param {readonly string[]} given
 * @param {NodeJS.ProcessEnv} [environment]  Besides our own.
 * @returns {Started}
 */
export function startProcess(program, given, environment = {}) {
  const child = spawn(program, given, { detached: true, stdio: ["ignore", "pipe", "pipe"], env: { ...process.env, ...environment } });
  /** @type {((text: string) => void)[]} */
  const listeners = [];
  let failed = "";
  child.on("error", ({ message }) => {
    failed = `${program} does not start: ${message}`;
    for (const listener of listeners) listener(failed);
  });
  for (const output of [child.stdout, child.stderr]) {
    let rest = "";
    output.setEncoding("utf8");
    output.on("data", (/** @type {string} */ text) => {
      const lines = (rest + text).split("\n");
      rest = lines.pop() ?? "";
      for (const line of lines) for (const listener of listeners) listener(line);
    });
  }
  const gone = new Promise((resolve) => child.once("close", resolve));
  // What is interrupted in the middle leaves nothing behind.
  const kill = () => {
    try {
      if (child.pid !== undefined) process.kill(-child.pid, "SIGKILL");
    } catch {
      // It has ended by itself.
    }
  };
  process.once("exit", kill);
  return {
    lines: (listener) => {
      listeners.push(listener);
      if (failed !== "") listener(failed);
    },
    end: async () => {
      kill();
      process.off("exit", kill);
      if (child.pid !== undefined) await gone;
    },
  };
}

/** A port that is free at present. @returns {Promise<number>} */
export async function freePort() {
  const server = createServer();
  await new Promise((resolve) => server.listen(0, "127.0.0.1", () => resolve(undefined)));
  const { port } = /** @type {import("node:net").AddressInfo} */ (server.address());
  await new Promise((resolve) => server.close(resolve));
  return port;
}
