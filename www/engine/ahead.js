// Fetches and compiles the module and brings up two workers, the fewest there are, while the document itself is still being
// read. The build puts this script into the document, before all else. `delivery.js` takes what was begun here; where
// this may not run, or cannot, it begins anew.
{
  /** @type {Worker[]} */
  const workers = [];
  /** @type {Promise<WebAssembly.Module | undefined>} */
  let module = Promise.resolve(undefined);
  try {
    module = WebAssembly.compileStreaming(fetch("gear-bifurcations_bg.wasm")).catch(() => undefined);
    for (let count = 0; count < 2; count += 1) {
      const worker = new Worker("www/engine/worker.js", { type: "module", name: "gear" });
      workers.push(worker);
      // One that cannot come up is nobody's: the next attempt is heard.
      worker.onerror = (event) => {
        event.preventDefault();
        const place = workers.indexOf(worker);
        if (place >= 0) workers.splice(place, 1);
      };
    }
  } catch {
    // What is the matter is told by whoever tries again.
  }
  void module.then((compiled) => {
    if (compiled !== undefined) for (const worker of workers) worker.postMessage({ type: "start", module: compiled });
  });
  Object.assign(self, { gearAhead: { module, workers } });
}
