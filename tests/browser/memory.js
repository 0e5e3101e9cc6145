// How much memory a page and its workers hold once everything that can be collected has been.

/** @typedef {import("@playwright/test").Page} Page */
/** @typedef {(method: string, params?: object) => Promise<any>} Send */

/**
 * What is held: objects of JavaScript, what the browser holds for them, buffers, and the memories of wasm; and what the document has.
 *
 * @typedef {object} Held
 * @property {number} heap  Bytes of objects, of the page and its workers.
 * @property {number} buffers  Bytes of buffers.
 * @property {number} wasm  Bytes of the wasm memories.
 * @property {number} nodes  Nodes that are alive, in the document or not.
 * @property {number} listeners
 */

/** The heap of one thread counts as come to rest when two collections running change it by less than this, bytes. */
const STILL = 20_000;
const TRIES = 12;
/** A worker that has not answered after this time will not, ms. */
const PATIENCE = 30_000;

/** Ways to speak with the page and each of its workers. @param {Page} page @returns {Promise<Send[]>} */
export async function threads(page) {
  const session = await page.context().newCDPSession(page);
  /** @type {Send} */
  const toPage = (method, params) => session.send(/** @type {any} */ (method), params);
  let number = 0;
  /** @type {Map<string, (answer: any) => void>} */
  const waiting = new Map();
  session.on("Target.receivedMessageFromTarget", ({ sessionId, message }) => {
    const answer = JSON.parse(message);
    waiting.get(`${sessionId} ${answer.id}`)?.(answer);
  });
  /** @type {string[]} */
  const workers = [];
  session.on("Target.attachedToTarget", ({ sessionId, targetInfo }) => {
    if (targetInfo.type === "worker") workers.push(sessionId);
  });
  await toPage("Target.setAutoAttach", { autoAttach: true, waitForDebuggerOnStart: false, flatten: false });
  return [
    toPage,
    ...workers.map((sessionId) => async (/** @type {string} */ method, /** @type {object} */ params = {}) => {
      const id = (number += 1);
      const answered = new Promise((resolve, reject) => {
        waiting.set(`${sessionId} ${id}`, resolve);
        setTimeout(() => reject(new Error(`a worker does not answer to ${method}`)), PATIENCE);
      });
      await toPage("Target.sendMessageToTarget", { sessionId, message: JSON.stringify({ id, method, params }) });
      const { result, error } = /** @type {any} */ (await answered);
      if (error) throw new Error(`${method}: ${error.message}`);
      return result;
    }),
  ];
}

/** The least of several looks: what still moves makes objects between two of them. @param {Send} send */
async function heapOf(send) {
  await send("HeapProfiler.enable");
  let least = { heap: Infinity, buffers: Infinity };
  for (let tries = 0, still = 0; tries < TRIES && still < 2; tries += 1) {
    await send("HeapProfiler.collectGarbage");
    const { usedSize, embedderHeapUsedSize = 0, backingStorageSize = 0 } = await send("Runtime.getHeapUsage");
    const heap = usedSize + embedderHeapUsedSize;
    still = Math.abs(least.heap - heap) < STILL ? still + 1 : 0;
    if (heap < least.heap) least = { heap, buffers: backingStorageSize };
  }
  return least;
}

/** @param {Send} send */
async function wasmOf(send) {
  const { result: prototype } = await send("Runtime.evaluate", { expression: "WebAssembly.Memory.prototype" });
  const { objects } = await send("Runtime.queryObjects", { prototypeObjectId: prototype.objectId, objectGroup: "memory" });
  const { result } = await send("Runtime.callFunctionOn", {
    objectId: objects.objectId,
    functionDeclaration: "function () { return this.reduce((sum, memory) => sum + memory.buffer.byteLength, 0); }",
    returnByValue: true,
  });
  await send("Runtime.releaseObjectGroup", { objectGroup: "memory" });
  await send("Runtime.releaseObject", { objectId: prototype.objectId });
  return /** @type {number} */ (result.value);
}

/** @param {readonly Send[]} all @returns {Promise<Held>} */
export async function held(all) {
  /** @type {Held} */
  const sum = { heap: 0, buffers: 0, wasm: 0, nodes: 0, listeners: 0 };
  for (const send of all) {
    sum.wasm += await wasmOf(send);
    const { heap, buffers } = await heapOf(send);
    sum.heap += heap;
    sum.buffers += buffers;
  }
  const { nodes, jsEventListeners } = await all[0]("Memory.getDOMCounters");
  return { ...sum, nodes, listeners: jsEventListeners };
}
