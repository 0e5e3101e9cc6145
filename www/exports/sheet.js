/**
 * What the exports show over a figure: its menu, and a sheet with a file's content where files may not be saved. They are
 * dialogs, which lie over everything however narrow the figure's own place is, and live in the figure's shadow, where the
 * style of a strange page does not reach them.
 */

import { adopt } from "../style/adopt.js";
import { say } from "../words/say.js";

const STYLE = `
dialog.export { position: fixed; margin: 0; font: inherit; font-size: 1rem; line-height: 1.35; color: var(--ink, #1a1a1a); background: var(--ground, #fff); border: 1px solid var(--line, #767676);
  border-radius: 4px; padding: 0.25rem; overflow: auto; max-block-size: calc(100vh - 1rem); max-inline-size: calc(100vw - 1rem); }
dialog.export::backdrop { background: none; }
.export [role="menuitem"] { display: block; inline-size: 100%; min-block-size: 2.25rem; text-align: start; text-decoration: none; padding: 0.2rem 0.75rem; border-radius: 3px; white-space: nowrap; }
.export [role="menuitem"]:is(:hover, :focus) { background: var(--focus, #0072b2); color: var(--ground, #fff); outline: none; }
.export hr { border: 0; border-block-start: 1px solid var(--rule, #bbb); margin: 0.25rem 0; }
dialog.export.content { inset: 0; margin: auto; padding: 0.75rem 1rem 1rem; inline-size: min(40rem, 100vw - 1rem); block-size: fit-content; }
dialog.export.content::backdrop { background: #000; opacity: 0.4; }
.export p { margin: 0 0 0.5rem; text-wrap: pretty; }
.export textarea { box-sizing: border-box; display: block; inline-size: 100%; block-size: min(20rem, 45vh); font: 0.8125rem/1.4 ui-monospace, monospace; color: inherit; background: none; border: 1px solid var(--line, #767676); white-space: pre; }
.export img { display: block; max-inline-size: 100%; max-block-size: 45vh; border: 1px solid var(--rule, #bbb); }
.export .buttons { justify-content: start; margin: 0.5rem 0 0 -0.6rem; }
@media (pointer: coarse) { .export [role="menuitem"] { min-block-size: 2.75rem; } }
@media (forced-colors: active) { .export [role="menuitem"]:focus { outline: 2px solid Highlight; outline-offset: -2px; } }
@media print { dialog.export { display: none; } }
`;

/** The one that is open: there is never another. @type {HTMLDialogElement | null} */
let open = null;

/**
 * A dialog in a figure, closed by Escape and by a click beside it, and when the page goes elsewhere: in a view that is not shown nobody could close it.
 *
 * @param {ShadowRoot} root
 * @param {string} label
 * @returns {HTMLDialogElement}
 */
function dialogIn(root, label) {
  adopt(STYLE, root);
  open?.close();
  const dialog = document.createElement("dialog");
  open = dialog;
  dialog.className = "export";
  dialog.setAttribute("aria-label", label);
  const life = new AbortController();
  addEventListener("popstate", () => dialog.close(), { signal: life.signal });
  dialog.addEventListener("close", () => {
    life.abort();
    dialog.remove();
    if (open === dialog) open = null;
  });
  dialog.addEventListener("pointerdown", (event) => {
    const { left, right, top, bottom } = dialog.getBoundingClientRect();
    const inside = event.clientX >= left && event.clientX <= right && event.clientY >= top && event.clientY <= bottom;
    if (event.target === dialog && !inside) dialog.close();
  });
  // Keys pressed here are none of the page's.
  dialog.addEventListener("keydown", (event) => event.stopPropagation());
  root.append(dialog);
  return dialog;
}

/**
 * @typedef {object} Entry
 * @property {string} id
 * @property {string} words
 * @property {() => void} run
 * @property {boolean} [apart]  Something of another kind than those before it.
 */

/**
 * Opens a menu at a button: arrows, Home, End and first letters lead to an entry, Enter and Space choose it.
 *
 * @param {ShadowRoot} root
 * @param {HTMLElement} button
 * @param {string} label
 * @param {readonly Entry[]} entries
 */
export function openMenu(root, button, label, entries) {
  const dialog = dialogIn(root, label);
  const menu = document.createElement("div");
  menu.setAttribute("role", "menu");
  menu.setAttribute("aria-label", label);
  const items = entries.map(({ id, words, run, apart = false }) => {
    const item = document.createElement("button");
    item.type = "button";
    item.tabIndex = -1;
    item.setAttribute("role", "menuitem");
    item.dataset.export = id;
    item.textContent = words;
    item.addEventListener("click", () => {
      dialog.close();
      run();
    });
    if (apart) menu.append(document.createElement("hr"));
    menu.append(item);
    return item;
  });
  menu.addEventListener("keydown", (event) => {
    const at = items.indexOf(/** @type {HTMLButtonElement} */ (event.target));
    const steps = { ArrowDown: at + 1, ArrowUp: at - 1 + items.length, Home: 0, End: items.length - 1 }[event.key];
    if (steps !== undefined) items[steps % items.length].focus();
    else if (event.key === "Tab") dialog.close();
    else if (event.key.length === 1 && event.key !== " " && !event.ctrlKey && !event.metaKey && !event.altKey) {
      const begins = (/** @type {HTMLElement} */ item) => item.textContent?.toLowerCase().startsWith(event.key.toLowerCase()) ?? false;
      [...items.slice(at + 1), ...items].find(begins)?.focus();
    } else return;
    event.preventDefault();
  });
  dialog.append(menu);
  dialog.addEventListener("close", () => button.setAttribute("aria-expanded", "false"));
  button.setAttribute("aria-expanded", "true");
  dialog.showModal();
  place(dialog, button);
  items[0]?.focus();
}

/**
 * Under the button, or above it where there is more room; never beyond the window.
 *
 * @param {HTMLElement} dialog
 * @param {HTMLElement} button
 */
function place(dialog, button) {
  const at = button.getBoundingClientRect();
  const { offsetWidth: width, offsetHeight: height } = dialog;
  const within = (/** @type {number} */ wanted, /** @type {number} */ most) => Math.max(8, Math.min(wanted, most - 8));
  const under = at.bottom + 4 + height <= innerHeight || at.top < innerHeight - at.bottom;
  dialog.style.top = `${within(under ? at.bottom + 4 : at.top - 4 - height, innerHeight - height)}px`;
  dialog.style.left = `${within(at.right - width, innerWidth - width)}px`;
}

/**
 * Shows a file's content, to be copied or kept by hand.
 *
 * @param {ShadowRoot} root
 * @param {{title: string, words: string, text: string | null, picture: string | null, copy: ((text: string) => Promise<boolean>)}} content
 */
export function showContent(root, { title, words, text, picture, copy }) {
  const dialog = dialogIn(root, title);
  dialog.classList.add("content");
  const told = document.createElement("p");
  told.textContent = words;
  const buttons = document.createElement("div");
  buttons.className = "buttons";
  const button = (/** @type {string} */ key, /** @type {() => void} */ press) => {
    const made = document.createElement("button");
    made.type = "button";
    made.textContent = say(key);
    made.addEventListener("click", press);
    buttons.append(made);
    return made;
  };
  dialog.append(told);
  if (text !== null) {
    const area = document.createElement("textarea");
    area.readOnly = true;
    area.value = text;
    area.setAttribute("aria-label", title);
    dialog.append(area);
    const status = document.createElement("span");
    status.setAttribute("role", "status");
    button("export.copy", async () => {
      const done = await copy(text);
      if (!done) area.select();
      status.textContent = say(done ? "export.copied" : "export.marked");
    });
    button("export.close", () => dialog.close());
    buttons.append(status);
  } else {
    if (picture !== null) dialog.append(Object.assign(document.createElement("img"), { src: picture, alt: title }));
    button("export.close", () => dialog.close());
  }
  dialog.append(buttons);
  dialog.showModal();
  dialog.querySelector("button")?.focus();
}
