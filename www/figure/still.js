/**
 * The still drawing in a figure's light DOM, which stands in its place until the first live one does, and wherever none can.
 */

/** A live drawing that comes within this time needs no still one before it, ms. */
const STILL_AFTER = 600;

/** How much wider it is than high; null where that is not said. @param {HTMLImageElement | null} picture */
export function aspectOf(picture) {
  const [width, height] = [Number(picture?.getAttribute("width")), Number(picture?.getAttribute("height"))];
  return width > 0 && height > 0 ? width / height : null;
}

/**
 * One still on its way waits a little: reading and laying it out twice takes the time in which the live one is made.
 *
 * @param {HTMLImageElement} picture
 * @param {() => boolean} isLive  Whether it is not needed any more.
 */
export function holdBack(picture, isLive) {
  const address = picture.getAttribute("src");
  if (picture.complete && picture.naturalWidth > 0) return;
  if (address === null || isLive()) return;
  picture.removeAttribute("src");
  // Nor the sign of a picture that is missing: none is.
  picture.style.visibility = "hidden";
  const show = () => {
    picture.style.removeProperty("visibility");
    if (!isLive()) picture.setAttribute("src", address);
  };
  setTimeout(show, STILL_AFTER);
  addEventListener("beforeprint", show, { once: true });
}

/** One that waits to come near the screen would never come onto paper. @param {HTMLImageElement | null} picture */
export function hurry(picture) {
  if (picture !== null) picture.loading = "eager";
}
