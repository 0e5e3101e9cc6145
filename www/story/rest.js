/**
 * Sections of the story that are far from the screen rest: the browser neither styles nor lays out nor paints what is in them,
 * and takes each to be as high as it was. So the page can be left and come back to at the cost of what is seen. What rests is
 * still found by searching, read aloud and led to by links; on paper nothing rests. How it is done is in style/story.css.
 *
 * Each section must have been laid out once, so that its height is known: that is done in turn, a frame for each, for
 * all of them in one go would hold the page up.
 */

/**
 * Whether the browser keeps in place what is read while heights above it change, as style/story.css asks too. One that does not
 * lays out everything, in one go.
 */
export const ANCHORS = CSS.supports("overflow-anchor", "auto");

/** Nearer than this, in heights of the window, nothing rests: what wakes has been drawn before it is seen. */
const NEAR = "100% 0px";

/**
 * @param {HTMLElement} host  The story.
 * @returns {() => void} to be called when its heights have changed: not for its width, which is seen
 */
export function letFarSectionsRest(host) {
  if (!ANCHORS) {
    layOutAll();
    return () => {};
  }
  const sections = /** @type {HTMLElement[]} */ ([...host.children].filter(({ localName }) => localName === "section"));
  const hidden = () => host.clientWidth === 0;
  const watch = new IntersectionObserver(
    (entries) => {
      // While another view is shown nothing has a place: each stays as it was, for the reader comes back to where they were.
      if (!hidden()) for (const { target, isIntersecting } of entries) target.classList.toggle("far", !isIntersecting);
    },
    { rootMargin: NEAR },
  );
  /** Those whose height is to be noted. @type {Set<HTMLElement>} */
  const waiting = new Set();
  let going = false;
  const goOn = async () => {
    if (going) return;
    going = true;
    for (const section of waiting) {
      if (hidden()) break;
      waiting.delete(section);
      section.classList.add("laid-out");
      section.classList.remove("far");
      // In the next frame its height is noted, and then whether it is far.
      watch.unobserve(section);
      watch.observe(section);
      await nextFrame();
    }
    going = false;
    if (waiting.size === 0) layOutAll();
  };
  const measureAll = () => {
    for (const section of sections) waiting.add(section);
    void goOn();
  };
  let width = 0;
  const resized = () => {
    if (hidden()) return;
    // Shown again, it is as it was, but for what was left undone.
    if (host.clientWidth !== width) measureAll();
    else void goOn();
    width = host.clientWidth;
  };
  // In a frame of its own: whoever changes sizes while sizes are told is told of a loop.
  new ResizeObserver(() => requestAnimationFrame(resized)).observe(host);
  // A figure may bring sentences and tables with its numbers.
  for (const name of ["gear-ready", "gear-change"]) {
    host.addEventListener(name, ({ target }) => {
      const section = target instanceof Element ? target.closest("section") : null;
      if (section === null || !section.classList.contains("far")) return;
      waiting.add(section);
      void goOn();
    });
  }
  return measureAll;
}

/** From now on nothing is held back that `figure/hold-back.js` has held back: all has its right place. */
export function layOutAll() {
  delete document.documentElement.dataset.opening;
}

/** Nothing rests: who goes far goes by heights that are true. What has been seen since then and left again rests anew. */
export function wakeAll() {
  layOutAll();
  for (const section of document.querySelectorAll("section.far")) section.classList.remove("far");
}

/** @returns {Promise<void>} */
function nextFrame() {
  return new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
}
