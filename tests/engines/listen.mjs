// What a document says to its console, kept by the document itself: for the browser that has no other way to tell.

/** Runs in the page before anything else does. */
function listen() {
  const noise = /** @type {string[]} */ ([]);
  Object.assign(globalThis, { __noise: noise });
  for (const level of /** @type {const} */ (["log", "info", "debug", "warn", "error"])) {
    const say = console[level].bind(console);
    console[level] = (...given) => {
      noise.push(`console ${level}: ${given.join(" ")}`);
      say(...given);
    };
  }
  addEventListener("error", ({ message, target }) => {
    const element = target instanceof Element ? target.outerHTML.slice(0, 200) : "";
    noise.push(`uncaught: ${message ?? ""}${element}`);
  }, true);
  addEventListener("unhandledrejection", ({ reason }) => void noise.push(`uncaught: ${reason}`));
  addEventListener("securitypolicyviolation", ({ violatedDirective, blockedURI }) => void noise.push(`${violatedDirective} forbids ${blockedURI}`));
}

export const LISTENER = `<script>(${listen})()</script>`;

/** What was heard since this was asked last. Runs in the page. @returns {string[]} */
export function heard() {
  return /** @type {{__noise?: string[]}} */ (globalThis).__noise?.splice(0) ?? [];
}
