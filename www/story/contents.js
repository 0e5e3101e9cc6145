/** The table of contents: the section that is being read is marked. */

/** A section counts while it is across this band of the window. */
const BAND = "-25% 0px -70% 0px";

/** @param {HTMLElement} host */
export function markSections(host) {
  const links = new Map(
    [...host.querySelectorAll(".contents a")].map((link) => [decodeURIComponent(link.getAttribute("href")?.slice(1) ?? ""), link]),
  );
  const watch = new IntersectionObserver(
    (entries) => {
      for (const { target, isIntersecting } of entries) {
        if (isIntersecting) links.get(target.id)?.setAttribute("aria-current", "location");
        else links.get(target.id)?.removeAttribute("aria-current");
      }
    },
    { rootMargin: BAND },
  );
  for (const section of host.querySelectorAll("section[id]")) watch.observe(section);
}
