/**
 * Gives the figures of a document that is not our page what they need: one engine and one pool of workers for all of them,
 * and a state that knows nothing but their parameters.
 *
 * @typedef {import("../engine/client.js").Engine} Engine
 * @typedef {import("../state.js").ThemeChoice} ThemeChoice
 */

import { GearError, PRIORITY } from "../engine/client.js";
import { provide } from "../figure/services.js";
import { Store } from "../state.js";
import { words as embedded } from "../words/en/embed.js";
import { words as figure } from "../words/en/figure.js";
import { learn, say } from "../words/say.js";

// At once: a figure says something before the engine does.
learn(figure);
learn(embedded);

/**
 * @param {Promise<Engine>} starting
 * @param {string | null} home  The folder of the site, as an address; null where there is none.
 * @param {() => Promise<{startExports: typeof import("../exports/room.js").startExports, figureFile: typeof import("./save-figure.js").figureFile}>} exporting
 * @param {{theme?: ThemeChoice}} [options]
 */
export function equip(starting, home, exporting, { theme = "auto" } = {}) {
  const store = new Store({ theme });
  const services = starting.then((engine) => {
    engine.complete();
    /** @type {Promise<import("../exports/room.js").Room> | null} */
    let room = null;
    return {
      engine,
      exports: (/** @type {import("../figure/gear-figure.js").GearFigure} */ figure, /** @type {HTMLElement} */ button) => {
        room ??= exporting().then((parts) => parts.startExports({ engine, home, page: null, saving: () => Promise.resolve(parts) }));
        room.then(
          (opened) => opened.open(figure, button),
          () => {
            // It may come at the next try.
            room = null;
            figure.tell(say("figure.no-export"), true);
          },
        );
      },
      store,
      priority: PRIORITY,
      error: (/** @type {import("../figure/services.js").GearErrorFields} */ fields) => new GearError(fields),
      // At once: a frame of their own for the controls would cost the page more than they do.
      later: (/** @type {() => void} */ work) => work(),
      painted: mark,
    };
  }, refuse);
  // Each figure says itself what failed.
  services.catch(() => {});
  provide(services);
}

/**
 * Says in a sentence what is the matter where wasm, or what it is fetched from, is forbidden.
 *
 * @param {unknown} thrown
 * @returns {never}
 */
function refuse(thrown) {
  const reason = (thrown instanceof Error ? thrown.message : String(thrown)).replace(/\.$/, "");
  throw new GearError({ code: "load", parameter: null, given: null, allowed: null, message: say("embed.still", { reason }) });
}

let marked = false;

/** Says when the first live drawing stood, for measurements. */
function mark() {
  if (marked) return;
  marked = true;
  performance.mark("first-figure");
}
