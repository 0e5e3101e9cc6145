/** Work in a task of its own, as soon as can be: a timer would wait longer each time it sets the next one. */

/** @type {(() => void)[]} */
const waiting = [];
const channel = new MessageChannel();
channel.port1.onmessage = () => waiting.shift()?.();

/** @param {() => void} work */
export function inNextTask(work) {
  waiting.push(work);
  channel.port2.postMessage(null);
}
