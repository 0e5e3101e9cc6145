/** How something leaves the page: onto the clipboard, or as a file. */

/** After this time a browser has taken a file, ms. */
const TAKEN = 60_000;

/** Whether another document holds this one, which may forbid it to save files. */
export function isHeld() {
  return window.parent !== window;
}

/**
 * @param {string} text
 * @returns {Promise<boolean>} false where copying is forbidden
 */
export async function copy(text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    // A page that may not ask for the clipboard may still copy what is marked.
    return copyMarked(text);
  }
}

/** @param {string} text */
function copyMarked(text) {
  let heard = false;
  const give = (/** @type {ClipboardEvent} */ event) => {
    event.clipboardData?.setData("text/plain", text);
    event.preventDefault();
    heard = true;
  };
  document.addEventListener("copy", give, { once: true, capture: true });
  try {
    return document.execCommand("copy") && heard;
  } catch {
    return false;
  } finally {
    document.removeEventListener("copy", give, { capture: true });
  }
}

/**
 * Offers a file to the browser, which saves it or asks where; whether it did is not told to pages.
 *
 * @param {string} name
 * @param {Blob} file
 */
export function save(name, file) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(file);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), TAKEN);
}
