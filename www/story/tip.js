/**
 * A few words beside what they explain: shown while the pointer rests on it or the focus is there, until Escape. The
 * pointer may move onto the words without their going away.
 */

/** The pointer may cross the gap between a word and its explanation, ms. */
const GRACE = 200;
/** Distance from the edges of the window and from what is explained, CSS pixels. */
const MARGIN = 8;

/**
 * @typedef {object} Explained
 * @property {string} title  Empty for none.
 * @property {string} words
 */

/**
 * @param {HTMLElement} host  Where the explained elements are.
 * @param {string} selector  Which they are.
 * @param {(element: Element) => Explained | null} explain  Null where there is nothing to say.
 */
export function explainAll(host, selector, explain) {
  const tip = document.createElement("div");
  tip.id = "explanation";
  tip.className = "tip";
  tip.setAttribute("role", "tooltip");
  tip.popover = "manual";
  // Before there were popovers it was shown and hidden like anything else.
  tip.hidden = true;
  const title = document.createElement("b");
  const words = document.createElement("span");
  tip.append(title, " ", words);
  host.append(tip);

  /** @type {Element | null} */
  let shown = null;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let leaving;

  /** @param {Element} element */
  const show = (element) => {
    clearTimeout(leaving);
    if (shown === element) return;
    const said = explain(element);
    if (said === null) return;
    hide();
    title.textContent = said.title;
    words.textContent = said.words;
    shown = element;
    element.setAttribute("aria-describedby", tip.id);
    tip.hidden = false;
    tip.showPopover?.();
    place(tip, element);
  };
  const hide = () => {
    clearTimeout(leaving);
    if (shown === null) return;
    shown.removeAttribute("aria-describedby");
    shown = null;
    tip.hidePopover?.();
    tip.hidden = true;
  };
  /** @param {EventTarget | null} target */
  const explained = (target) => (target instanceof Element ? target.closest(selector) : null);
  const leave = () => {
    clearTimeout(leaving);
    leaving = setTimeout(() => {
      if (!(shown?.matches(":focus-visible") ?? false)) hide();
    }, GRACE);
  };

  host.addEventListener("pointerover", (event) => {
    const element = explained(event.target);
    if (element !== null && event.pointerType !== "touch") show(element);
  });
  host.addEventListener("pointerout", (event) => {
    if (explained(event.target) !== null && event.pointerType !== "touch") leave();
  });
  tip.addEventListener("pointerenter", () => clearTimeout(leaving));
  tip.addEventListener("pointerleave", leave);
  host.addEventListener("focusin", (event) => {
    const element = explained(event.target);
    if (element?.matches(":focus-visible")) show(element);
  });
  host.addEventListener("focusout", hide);
  // A finger has no way to rest on a word: its first touch explains, and only a second one follows a link.
  host.addEventListener("click", (event) => {
    const element = explained(event.target);
    const touched = event instanceof PointerEvent && event.pointerType === "touch";
    if (element === null) hide();
    else if (shown === element && element instanceof HTMLAnchorElement) hide();
    else if (touched || !(element instanceof HTMLAnchorElement)) {
      event.preventDefault();
      show(element);
    }
  });
  document.addEventListener("pointerdown", (event) => {
    if (event.pointerType === "touch" && explained(event.target) === null) hide();
  });
  document.addEventListener("keydown", (event) => {
    if (event.key === "Escape") hide();
  });
  addEventListener("scroll", () => shown !== null && place(tip, shown), { passive: true });
  addEventListener("resize", hide);
}

/**
 * Under the element, or over it where there is no room.
 *
 * @param {HTMLElement} tip
 * @param {Element} element
 */
function place(tip, element) {
  const [first] = element.getClientRects();
  const target = first ?? element.getBoundingClientRect();
  const { width, height } = tip.getBoundingClientRect();
  const room = document.documentElement.clientWidth - width - MARGIN;
  const left = Math.max(MARGIN, Math.min(target.left, room));
  const below = target.bottom + MARGIN;
  const top = below + height > innerHeight && target.top - height > MARGIN ? target.top - height - MARGIN : below;
  tip.style.left = `${left}px`;
  tip.style.top = `${top}px`;
}
