/**
 * Has the browser keep the page for when there is no network, and offers a new release when there is one. Where service
 * workers are refused, or there is no such file, the page does without.
 */

import { words } from "../words/en/offline.js";
import { learn, onLanguage, say } from "../words/say.js";

const SCRIPT = "../../service-worker.js";

/** Whether the reader has agreed to a new release: only then does the page load itself anew. */
let agreed = false;

export async function keepForOffline() {
  // The single file needs nobody to keep it.
  if (!("serviceWorker" in navigator) || !isSecureContext || document.getElementById("gear-wasm") !== null) return;
  learn(words);
  try {
    const registration = await navigator.serviceWorker.register(new URL(SCRIPT, import.meta.url), { updateViaCache: "none" });
    watch(registration);
    // Asked for at once: when a browser looks by itself after a page has opened is its own affair, and a busy one forgets.
    if (navigator.serviceWorker.controller !== null) await registration.update();
  } catch {
    // It works without, and without a network there is nothing new.
  }
}

/** @param {ServiceWorkerRegistration} registration */
function watch(registration) {
  navigator.serviceWorker.addEventListener("controllerchange", () => {
    if (agreed) location.reload();
  });
  // A first visit has nobody in charge yet, and nothing to be offered.
  const look = () => {
    if (registration.waiting !== null && navigator.serviceWorker.controller !== null) offer(registration.waiting);
  };
  const follow = () => registration.installing?.addEventListener("statechange", look);
  look();
  // The browser may have begun by itself, before anybody here listened.
  follow();
  registration.addEventListener("updatefound", follow);
}

/** @param {ServiceWorker} waiting */
function offer(waiting) {
  if (document.querySelector(".release-notice") !== null) return;
  const notice = document.createElement("div");
  notice.className = "link-notice release-notice";
  notice.setAttribute("role", "status");
  const sentence = document.createElement("p");
  const [now, later] = [document.createElement("button"), document.createElement("button")];
  now.addEventListener("click", () => {
    agreed = true;
    waiting.postMessage("take over");
  });
  later.addEventListener("click", () => notice.remove());
  const speak = () => {
    sentence.textContent = say("offline.new");
    now.textContent = say("offline.load");
    later.textContent = say("offline.later");
  };
  speak();
  onLanguage(speak);
  for (const button of [now, later]) button.type = "button";
  notice.append(sentence, now, later);
  document.querySelector("main")?.before(notice);
}
