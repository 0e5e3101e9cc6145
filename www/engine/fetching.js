/**
 * Fetching the module in a worker: to receive it, to start it and to have it list its figures costs a page a quarter of what a figure
 * costs it in all, and where workers draw the page itself may never need it.
 *
 * @typedef {import("./protocol.js").Fetched} Fetched
 * @typedef {import("./protocol.js").FromWorker} FromWorker
 */

import { faces, newWorker } from "./delivery.js";

/** The smallest module there is. */
const EMPTY = Uint8Array.of(0, 97, 115, 109, 1, 0, 0, 0);

/**
 * The module, and the worker that has fetched it.
 *
 * @returns {Promise<(Fetched & {worker: Worker}) | null>} null where that cannot be: whoever then tries it by itself learns why
 */
export async function fetchedByWorker() {
  try {
    // A worker may be allowed what its page is not, which sooner or later draws by itself.
    await WebAssembly.compile(EMPTY);
    const worker = newWorker();
    const fetched = await answerOf(worker);
    if (fetched !== null) return { ...fetched, worker };
    worker.terminate();
  } catch {
    // As said above.
  }
  return null;
}

/**
 * @param {Worker} worker
 * @returns {Promise<Fetched | null>}
 */
function answerOf(worker) {
  return new Promise((resolve) => {
    worker.onmessage = (/** @type {MessageEvent<FromWorker>} */ { data }) => {
      if (data.type === "fetched") resolve(data.fetched);
    };
    worker.onerror = (event) => {
      event.preventDefault();
      resolve(null);
    };
    worker.onmessageerror = () => resolve(null);
    worker.postMessage({ type: "faces", faces: faces() });
    worker.postMessage({ type: "fetch" });
  });
}
