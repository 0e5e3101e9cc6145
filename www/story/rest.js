/**
 * The story is long: to style and lay out all of it in one go would hold the page up. So its sections far from the screen rest
 * while another view is shown or all heights change, neither styled nor laid out nor painted, each as high as it was; then
 * they are woken in turn, a frame for each. What rests is still found by searching, read aloud and led to by links; on
 * paper nothing rests. A page that stands has nothing at rest, so that whatever pictures or reads all of it finds all of it.
 * How it is done is in style/story.css.
 */

/**
 * Whether the browser keeps in place what is read while heights above it change, as style/story.css asks too. One that does not
 * lays out everything, in one go.
 */
export const ANCHORS = CSS.supports("overflow-anchor", "auto");

/** Nearer than this, in heights of the window, nothing rests: it would be seen to come. */
const NEAR = "100% 0px";

/**
 * @param {HTMLElement} host  The story.
 * @returns {() => void} to be called when all of it is about to look otherwise: not for its width, which is seen
 */
export function letFarSectionsRest(host) {
  if (!ANCHORS) {
    layOutAll();
    return () => {};
  }
  const sections = /** @type {HTMLElement[]} */ ([...host.children].filter(({ localName }) => localName === "section"));
  const hidden = () => host.clientWidth === 0;
  /** @type {Set<Element>} */
  const near = new Set();
  const watch = new IntersectionObserver(
    (entries) => {
      // While another view is shown nothing has a place, and the reader comes back to where they were.
      if (!hidden()) for (const { target, isIntersecting } of entries) isIntersecting ? near.add(target) : near.delete(target);
    },
    { rootMargin: NEAR },
  );
  for (const section of sections) watch.observe(section);
  /** Those whose height has yet to come true. @type {Set<HTMLElement>} */
  const resting = new Set();
  const rest = () => {
    for (const section of sections) {
      resting.add(section);
      if (!near.has(section)) section.classList.add("far");
    }
  };
  let waking = false;
  const wake = async () => {
    if (waking) return;
    waking = true;
    // Not in the frame in which this is asked for.
    await nextTask();
    for (const section of resting) {
      if (hidden()) break;
      resting.delete(section);
      // What rests as a whole can be laid out as a whole.
      section.classList.replace("held", "far");
      layOut(section);
      section.classList.remove("far");
      await nextFrame();
    }
    waking = false;
    if (resting.size === 0) layOutAll();
  };
  const restAndWake = () => {
    rest();
    void wake();
  };
  let width = 0;
  const resized = () => {
    if (hidden()) rest();
    else if (host.clientWidth === width) void wake();
    else restAndWake();
    width = host.clientWidth || width;
  };
  // In a frame of its own: whoever changes sizes while sizes are told is told of a loop.
  new ResizeObserver(() => requestAnimationFrame(resized)).observe(host);
  return restAndWake;
}

/**
 * What is just below the screen comes up to where it belongs, one part of it after the other.
 *
 * @returns {Promise<void>}
 */
export async function bringNear() {
  const { dataset } = document.documentElement;
  for (const part of document.querySelectorAll(".below")) {
    if (dataset.opening !== "first") return;
    layOut(part);
    await nextTask();
  }
  if (dataset.opening === "first") dataset.opening = "near";
}

/** Lays out what rests, here and now: the frame that shows it then has only to paint it. @param {Element} resting */
function layOut(resting) {
  resting.querySelector("*")?.getBoundingClientRect();
}

/** From now on nothing is held back that `figure/hold-back.js` has held back: all has its right place. */
export function layOutAll() {
  delete document.documentElement.dataset.opening;
  for (const section of document.querySelectorAll("section.held")) section.classList.remove("held");
}

/** Holds back what is not shown at first: it is laid out piece by piece when it is. */
export function holdSections() {
  document.documentElement.dataset.opening = "";
  for (const section of document.querySelectorAll('main > [data-view="story"] > section')) section.classList.add("held");
}

/** Nothing rests: who goes far goes by heights that are true. */
export function wakeAll() {
  layOutAll();
  for (const section of document.querySelectorAll("section.far")) section.classList.remove("far");
}

/** @returns {Promise<void>} */
function nextFrame() {
  return new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
}

/** @returns {Promise<void>} */
function nextTask() {
  return new Promise((resolve) => setTimeout(resolve));
}
