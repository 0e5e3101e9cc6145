// What a browser would read and lay out before the first figure lives, although nobody sees it yet, is held back: the still
// drawings that stand in for figures, and the sections of the story below the first screen. This script stands in the
// document itself, before all else; where it may not run, everything comes as it stands, and the figures a little later.
//
// Some engines compile a module slowly. Where the document says so, its first figure is shown still once its time is up
// and no answer has come; one that has will be drawn before a still one could be.
{
  /** After this time a figure without a live drawing shows its still one, ms: a site's wasm may come over a slow line. */
  const patience = Number(document.currentScript?.dataset.patience);
  /** The same for the first figure, since the document was opened. */
  const firstPatience = Number(document.currentScript?.dataset.firstPatience);
  /** Nothing that is just below the screen is held back longer, ms. */
  const LONGEST = 2000;
  /** @type {[HTMLImageElement, string][]} */
  const held = [];
  const { dataset } = document.documentElement;
  // Only for whoever begins at the top: a place further down can be found only among sections that are laid out.
  const visit = performance.getEntriesByType("navigation")[0];
  const begins = location.hash === "" && visit instanceof PerformanceNavigationTiming && visit.type === "navigate";
  if (begins) dataset.opening = "first";
  const watch = new MutationObserver((changes) => {
    for (const node of changes.flatMap(({ addedNodes }) => [...addedNodes])) {
      if (begins && node instanceof HTMLElement && node.localName === "section" && node.parentElement?.dataset.view === "story") node.classList.add("held");
      if (!(node instanceof HTMLImageElement) || node.parentElement?.localName !== "gear-figure") continue;
      held.push([node, node.getAttribute("src") ?? ""]);
      node.removeAttribute("src");
      // Nor the sign of a picture that is missing: none is.
      node.style.visibility = "hidden";
    }
  });
  watch.observe(document, { childList: true, subtree: true });
  const show = (pictures = held.splice(0)) => {
    for (const [picture, address] of pictures) {
      picture.style.removeProperty("visibility");
      if (address !== "" && !picture.parentElement?.shadowRoot?.querySelector(".live")) picture.setAttribute("src", address);
    }
  };
  const showFirst = () => {
    const { theme } = document.documentElement.dataset;
    // It is drawn on white, with its own parameters.
    const dark = theme === "dark" || (theme === "auto" && matchMedia("(prefers-color-scheme: dark)").matches);
    if (!dark && location.hash === "" && !performance.getEntriesByName("first-answer").length) show(held.splice(0, 1));
  };
  if (firstPatience) setTimeout(showFirst, firstPatience - performance.now());
  addEventListener("DOMContentLoaded", () => {
    watch.disconnect();
    setTimeout(() => show(), patience);
    setTimeout(showBelow, LONGEST);
  });
  // Whoever goes on must find what is there.
  const showBelow = () => {
    if (dataset.opening !== undefined) dataset.opening = "";
  };
  for (const type of ["scroll", "wheel", "pointerdown", "click", "keydown", "focusin", "hashchange"]) addEventListener(type, showBelow, { once: true, capture: true, passive: true });
  addEventListener("beforeprint", () => show());
}
