// What the journey asks of a browser, whichever it is. The three drivers offer this and nothing else, so that the journey is written once.

/**
 * @typedef {{x: number, y: number}} Place  In the window, CSS pixels.
 *
 * @typedef {object} Driver
 * @property {string} name  With its version, for those who read what was tested.
 * @property {(width: number, height: number) => Promise<void>} resize  Of the window's inside, CSS pixels.
 * @property {(address: string) => Promise<void>} open  Loads a page anew, even one that differs behind `#` alone.
 * @property {() => Promise<void>} reload
 * @property {<Given extends readonly unknown[], Answer>(work: (...given: Given) => Answer, ...given: Given) => Promise<Awaited<Answer>>} evaluate
 *   Runs a function in the page, waits for what it promises; both what goes in and what comes out are plain data.
 * @property {(path: readonly Place[]) => Promise<void>} drag  Presses the mouse at the first place, lets go at the last; one place alone is a click.
 * @property {(keys: string) => Promise<void>} press  One key, or several held together, as `Control+z`; names are those of `KeyboardEvent.key`.
 * @property {(text: string) => Promise<void>} type  Character by character.
 * @property {() => Promise<Buffer>} picture  Of what the window shows, PNG.
 * @property {() => Promise<string[]>} noise  What the console said and what was asked for in vain since this was asked last.
 * @property {string} inserted  What documents must have in their heads to be heard, where the browser does not tell: else nothing.
 * @property {() => Promise<void>} close
 */

/** @typedef {"chromium" | "firefox" | "webkit"} EngineName */

/**
 * Starts a browser.
 *
 * @param {string} name
 * @returns {Promise<Driver>}
 */
export async function start(name) {
  switch (name) {
    case "chromium":
      return bounded(await (await import("./chromium.mjs")).startChromium());
    case "firefox":
      return bounded(await (await import("./firefox.mjs")).startFirefox());
    case "webkit":
      return bounded(await (await import("./webkit.mjs")).startWebKit());
    default:
      throw new Error(`ENGINE is one of chromium, firefox, webkit; ${name} was given`);
  }
}

/** No single thing that is asked of a browser takes so long, ms. */
const LONGEST = 90_000;

/**
 * The same browser, whose calls do not wait for ever: what never comes is told by its name, where a test that runs out of
 * its time could only say that it did.
 *
 * @param {Driver} driver
 * @returns {Driver}
 */
function bounded(driver) {
  return new Proxy(driver, {
    get: (browser, name) => {
      const asked = Reflect.get(browser, name);
      if (typeof asked !== "function") return asked;
      return async (/** @type {unknown[]} */ ...given) => {
        /** @type {NodeJS.Timeout | undefined} */
        let timer;
        const late = new Promise((_, reject) => {
          const what = `${String(name)}(${given.map(shown).join(", ")})`;
          timer = setTimeout(() => reject(new Error(`${browser.name} has not answered for ${LONGEST / 1000} s: ${what}`)), LONGEST);
        });
        try {
          return await Promise.race([asked(...given), late]);
        } finally {
          clearTimeout(timer);
        }
      };
    },
  });
}

/** What was given, short enough for a message. @param {unknown} given */
function shown(given) {
  const text = typeof given === "function" ? String(given) : (JSON.stringify(given) ?? "");
  return text.replace(/\s+/g, " ").slice(0, 200);
}

/**
 * Asks again and again until the answer is neither null, undefined nor false.
 *
 * @template Answer
 * @param {string} what  For the complaint that it never came.
 * @param {() => Promise<Answer>} ask
 * @param {number} [patience]  Milliseconds: a guard against what hangs, not a measure of speed.
 * @returns {Promise<Exclude<Answer, null | undefined | false>>}
 */
export async function until(what, ask, patience = 60_000) {
  const deadline = Date.now() + patience;
  /** @type {unknown} */
  let last;
  do {
    try {
      const answer = await ask();
      if (answer !== null && answer !== undefined && answer !== false) return /** @type {Exclude<Answer, null | undefined | false>} */ (answer);
      last = answer;
    } catch (error) {
      last = error;
    }
    await pause(50);
  } while (Date.now() < deadline);
  throw new Error(`never came: ${what}; the last answer was ${last}`);
}

/** @param {number} milliseconds */
export function pause(milliseconds) {
  return new Promise((resolve) => setTimeout(resolve, milliseconds));
}
