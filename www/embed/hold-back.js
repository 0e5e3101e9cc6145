// In the single file the still drawings stand in the document itself, and a browser would read and lay out all of them before the
// first figure lives, which takes longer than the figure. Where scripts run they are held back, and shown only if no
// live drawing comes.
{
  /** After this time a figure without a live drawing shows its still one, ms. */
  const PATIENCE = 4000;
  /** @type {[HTMLImageElement, string][]} */
  const held = [];
  const watch = new MutationObserver((changes) => {
    for (const node of changes.flatMap(({ addedNodes }) => [...addedNodes])) {
      if (!(node instanceof HTMLImageElement) || node.parentElement?.localName !== "gear-figure") continue;
      held.push([node, node.getAttribute("src") ?? ""]);
      node.removeAttribute("src");
    }
  });
  watch.observe(document, { childList: true, subtree: true });
  addEventListener("DOMContentLoaded", () => {
    watch.disconnect();
    setTimeout(() => {
      for (const [picture, address] of held) {
        if (!picture.parentElement?.shadowRoot?.querySelector(".live")) picture.setAttribute("src", address);
      }
    }, PATIENCE);
  });
}
