// How the page looks, as far as its address and what the browser remembers say so, before any of it is shown: a dark page would
// begin with a white one otherwise, and the laboratory with the story. This script stands in the document itself; `main.js`
// reads both again, with care, and where this may not run the page begins as it stands.
{
  const { dataset } = document.documentElement;
  const address = new URLSearchParams(location.hash.slice(1));
  const [view = ""] = address.keys();
  let remembered;
  try {
    remembered = JSON.parse(localStorage.getItem("gear-bifurcations.preferences") ?? "{}");
  } catch {
    // Forbidden, or written by something else.
  }
  // Not by an array's `find`: with that, here, Firefox shows the first figure of the page in one file half a second later.
  const own = (/** @type {unknown} */ name) => (typeof name === "string" && /^(auto|light|dark|contrast)$/.test(name) ? name : "");
  const theme = own(address.get("theme")) || own(remembered?.theme);
  if (theme) dataset.theme = theme;
  if (address.get("projector") === "on") dataset.projector = "true";
  if (view === "lab" || view === "class") dataset.view = view;
  // Another language takes other room: nothing is read in this one first, unless its words do not come.
  if ((address.get("language") ?? remembered?.language) === "de") {
    dataset.wordless = "";
    setTimeout(() => delete dataset.wordless, 1500);
  }
  // Without the page's own script there are no other views.
  addEventListener("error", ({ target }) => target instanceof HTMLScriptElement && delete dataset.view, { capture: true });
}
