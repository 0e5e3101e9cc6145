/** Buttons that copy a citation. */

import { onLanguage, say } from "../words/say.js";

/** @param {HTMLElement} host */
export function offerCopies(host) {
  for (const place of host.querySelectorAll(".citation")) {
    const text = place.querySelector("pre");
    const name = place.querySelector("h3")?.textContent ?? "";
    if (text === null || !("clipboard" in navigator)) continue;
    const button = document.createElement("button");
    button.type = "button";
    const done = document.createElement("span");
    done.setAttribute("role", "status");
    const label = () => {
      button.textContent = say("cite.copy", { name });
      done.textContent = "";
    };
    label();
    onLanguage(label);
    button.addEventListener("click", async () => {
      try {
        await navigator.clipboard.writeText(text.textContent ?? "");
        done.textContent = say("cite.copied");
      } catch {
        // Copying may be forbidden: then the text is there to be marked, ready.
        getSelection()?.selectAllChildren(text);
        done.textContent = say("cite.marked");
      }
    });
    place.querySelector("p")?.prepend(button, " ", done, " ");
  }
}
