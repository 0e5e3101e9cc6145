/**
 * `embed.html#figure=11a&omega=1.65`: one figure in a frame, and what it says to the page around it.
 *
 * What stands after `#` goes to no server. Nothing here takes the focus or scrolls. It hears the window that embeds it, of
 * the origin that it was embedded by, and nobody else; whatever is not of the form in `messages.js` is not heard at all.
 *
 * @typedef {import("./messages.js").Message} Message
 */

import { startEngine } from "../engine/client.js";
import { fetchedByWorker } from "../engine/fetching.js";
import { isReserved } from "../figure/attributes.js";
import { fetchLetters } from "../figure/letters.js";
import { EmbeddedFigure } from "./embedded-figure.js";
import { equip } from "./equip.js";
import { understood } from "./messages.js";

/** What an address names beside parameters. */
const OWN = ["figure", "controls", "theme"];
const NAME = /^[a-z][a-z0-9_.]{0,31}$/;

/** Without a parent there is nobody to talk to: the document was opened by itself. */
const host = window.parent === window ? null : window.parent;
const hostOrigin = originOfHost();

EmbeddedFigure.wake = () => {
  fetchLetters();
  equip(startEngine({ draws: true, fetchModule: fetchedByWorker }), new URL("../../", import.meta.url).href, () => import("./frame-exports.js"));
};
customElements.define("gear-figure", EmbeddedFigure);
const figure = /** @type {EmbeddedFigure} */ (document.createElement("gear-figure"));
follow();
document.body.prepend(figure);
addEventListener("hashchange", follow);

for (const type of /** @type {const} */ (["ready", "change", "error"])) {
  figure.addEventListener(`gear-${type}`, (event) => say({ type, .../** @type {CustomEvent} */ (event).detail }));
}
new ResizeObserver(() => {
  const { width, height } = figure.getBoundingClientRect();
  say({ type: "resize", width: Math.ceil(width), height: Math.ceil(height) });
}).observe(figure);

addEventListener("message", (event) => {
  if (event.source !== host || host === null) return;
  if (hostOrigin !== null && event.origin !== hostOrigin) return;
  const message = understood(event.data);
  if (message !== null) obey(message);
});

/** The origin that embeds this frame; null where the browser does not say, as for pages from a disk and sandboxed ones. */
function originOfHost() {
  const named = location.ancestorOrigins?.[0] ?? (document.referrer === "" ? "null" : new URL(document.referrer).origin);
  return named === "null" ? null : named;
}

/** @param {{type: "ready" | "resize" | "change" | "error"} & Record<string, unknown>} message */
function say(message) {
  // Only the embedding window itself can hear it, even where its origin has no name.
  host?.postMessage({ gear: 1, ...message }, hostOrigin ?? "*");
}

/** Makes the element's attributes what the address says. */
function follow() {
  const wanted = new Map([["figure", "1"]]);
  for (const [name, value] of new URLSearchParams(location.hash.slice(1))) {
    const attribute = name.toLowerCase();
    if (OWN.includes(attribute) || (NAME.test(attribute) && !isReserved(attribute) && attribute !== "v")) wanted.set(attribute, value);
  }
  for (const { name } of [...figure.attributes]) if (!wanted.has(name)) figure.removeAttribute(name);
  for (const [name, value] of wanted) if (figure.getAttribute(name) !== value) figure.setAttribute(name, value);
}

/** @param {Message} message */
function obey(message) {
  switch (message.type) {
    case "play":
      figure.play();
      break;
    case "pause":
      figure.pause();
      break;
    case "reset":
      follow();
      figure.reset();
      break;
    case "get":
      void answer(message);
      break;
    case "set": {
      const { figure: id, params = {}, controls, theme } = message;
      const given = Object.entries(params).map(([name, value]) => [name.toLowerCase(), value]);
      for (const [name, value] of [...given, ["figure", id], ["controls", controls], ["theme", theme]]) {
        if (value === null) figure.removeAttribute(String(name));
        else if (value !== undefined) figure.setAttribute(String(name), String(value));
      }
    }
  }
}

/** @param {import("./messages.js").GetMessage} message */
async function answer({ id, data: whole }) {
  try {
    const data = await figure.data();
    say({ type: "change", id, figure: data.id, params: data.params, ...(whole ? { data } : {}) });
  } catch (thrown) {
    const { code = "internal", message = String(thrown) } = /** @type {{code?: string, message?: string}} */ (thrown);
    say({ type: "error", id, code, message });
  }
}
