/** The sheets that lie over the page: palette, settings, help. */

import { adopt } from "../style/adopt.js";
import { say } from "../words/say.js";

const STYLE = `
dialog.sheet { font: inherit; color: var(--ink); background: var(--ground); border: 1px solid var(--line); border-radius: 4px;
  padding: 1rem 1.25rem 1.25rem; inline-size: min(38rem, 100vw - 2rem); max-block-size: min(44rem, 100vh - 2rem); overflow: auto; }
dialog.sheet::backdrop { background: color-mix(in srgb, var(--ground) 60%, #000); opacity: 0.5; }
.sheet header { display: flex; justify-content: space-between; align-items: center; gap: 1rem; margin: 0 0 0.5rem; max-inline-size: none; }
.sheet h2 { margin: 0; font-size: 1.375rem; }
.sheet h3 { margin-block: 1rem 0.25rem; }
.sheet p, .sheet li, .sheet label, .sheet dt, .sheet dd, .sheet legend { font-size: 1.0625rem; }
.sheet button { font: inherit; color: inherit; background: none; border: 1px solid transparent; border-radius: 3px; min-block-size: 2.75rem;
  padding-inline: 0.75rem; cursor: pointer; text-decoration: underline; text-decoration-color: var(--line); text-underline-offset: 0.2em; }
.sheet button:hover { border-color: var(--rule); }
.sheet kbd { font: inherit; font-size: 0.9375rem; color: var(--quiet); white-space: nowrap; }
.sheet input[type="text"] { font: inherit; font-size: 1.1875rem; inline-size: 100%; min-block-size: 2.75rem; color: inherit; background: none; border: 0;
  border-block-end: 1px solid var(--line); }
.sheet [role="listbox"] { list-style: none; margin: 0.5rem 0 0; padding: 0; max-block-size: 24rem; overflow: auto; }
.sheet [role="option"] { display: flex; justify-content: space-between; align-items: center; gap: 1rem; min-block-size: 2.25rem; padding: 0.25rem 0.5rem; cursor: pointer; }
.sheet [aria-selected="true"] { background: var(--focus); color: var(--ground); }
.sheet [aria-selected="true"] kbd { color: inherit; }
.sheet .none { color: var(--quiet); }
.sheet fieldset { border: 0; margin: 0 0 0.75rem; padding: 0; display: flex; flex-wrap: wrap; gap: 0 1.25rem; }
.sheet legend { float: inline-start; min-inline-size: 9rem; padding: 0; line-height: 2.75rem; color: var(--quiet); }
.sheet fieldset label { display: inline-flex; align-items: center; gap: 0.5rem; min-block-size: 2.75rem; cursor: pointer; }
.sheet input[type="radio"], .sheet input[type="checkbox"] { inline-size: 1.25rem; block-size: 1.25rem; accent-color: var(--accent); margin: 0; }
.sheet dl { display: grid; grid-template-columns: max-content minmax(0, 1fr); gap: 0.15rem 1.25rem; margin: 0; }
.sheet dt { text-align: end; }
.sheet dd { margin: 0; }
@media (pointer: coarse) { .sheet [role="option"] { min-block-size: 2.75rem; } }
@media print { dialog.sheet { display: none; } }
`;

/**
 * Opens a sheet; it closes by Escape, by its button, and by a click beside it, and the focus goes back to where it was.
 *
 * @param {string} title  A key of the catalogue.
 * @param {(body: HTMLElement, close: () => void) => void} fill
 * @returns {HTMLDialogElement}
 */
export function openSheet(title, fill) {
  adopt(STYLE);
  for (const open of document.querySelectorAll("dialog.sheet")) if (open instanceof HTMLDialogElement) open.close();
  const dialog = document.createElement("dialog");
  dialog.className = "sheet";
  dialog.setAttribute("aria-labelledby", "sheet-title");
  const close = () => dialog.close();

  const header = document.createElement("header");
  const heading = document.createElement("h2");
  heading.id = "sheet-title";
  heading.textContent = say(title);
  const button = document.createElement("button");
  button.type = "button";
  button.textContent = say("sheet.close");
  button.addEventListener("click", close);
  header.append(heading, button);
  const body = document.createElement("div");
  dialog.append(header, body);
  fill(body, close);

  dialog.addEventListener("close", () => dialog.remove());
  dialog.addEventListener("pointerdown", (event) => {
    const box = dialog.getBoundingClientRect();
    const inside = event.clientX >= box.left && event.clientX <= box.right && event.clientY >= box.top && event.clientY <= box.bottom;
    if (event.target === dialog && !inside) close();
  });
  document.body.append(dialog);
  dialog.showModal();
  return dialog;
}
