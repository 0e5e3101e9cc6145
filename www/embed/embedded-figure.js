/**
 * The figure's element in a page that is not ours: it looks the same whatever the page does to its own text, takes its
 * colours from a handful of custom properties, begins only when it comes near the screen, and where it cannot live
 * shows its still drawing and says why.
 */

import { GearFigure } from "../figure/gear-figure.js";
import { adopt } from "../style/adopt.js";

/** How near the screen a figure must come before anything of it is loaded. */
const NEAR = "600px";

const COLORS = {
  light: { ink: "#1b1f24", ground: "#ffffff", quiet: "#4e555d", rule: "#c6cad0", line: "#72777e", accent: "#0072b2", focus: "#0072b2", wrong: "#b04a00" },
  dark: { ink: "#e9ebee", ground: "#14171b", quiet: "#b0b7bf", rule: "#45484e", line: "#8a8d92", accent: "#42aaec", focus: "#7cc4f0", wrong: "#ff9e5e" },
};

/** @param {Record<string, string>} colors */
const properties = (colors) =>
  Object.entries(colors)
    .map(([name, color]) => `--${name}: var(--gear-${name}, ${color});`)
    .join(" ");

/**
 * What text inherits is set anew on each part, for rules of the page may reach the element itself. What the parts measure
 * themselves by is ours even against `* { all: initial !important }`: of two such rules the inner one wins.
 */
const STYLE = `
:host { ${properties(COLORS.light)} color-scheme: light; container-type: inline-size !important; }
@media (prefers-color-scheme: dark) { :host(:not([theme="light"])) { ${properties(COLORS.dark)} color-scheme: dark; } }
:host([theme="dark"]) { ${properties(COLORS.dark)} color-scheme: dark; }
:host > * {
  color: var(--ink); cursor: auto; direction: ltr; font: 400 1rem/1.5 var(--gear-font, "STIX Two Text", "STIX Two Math", "Times New Roman", Times, serif);
  font-size-adjust: none; hyphens: manual; letter-spacing: normal; text-align: start; text-indent: 0; text-shadow: none; text-transform: none;
  visibility: visible; white-space: normal; word-break: normal; word-spacing: normal;
}
`;

let awake = false;

export class EmbeddedFigure extends GearFigure {
  /** Starts what all figures share; called once, when the first of them comes near. */
  static wake = () => {};

  #near = false;
  /** @type {IntersectionObserver | null} */
  #watch = null;

  constructor() {
    super();
    if (this.shadowRoot !== null) adopt(STYLE, this.shadowRoot);
    this.addEventListener("gear-error", () => this.#showStill());
  }

  connectedCallback() {
    if (this.#near) {
      super.connectedCallback();
      return;
    }
    const watch = new IntersectionObserver(
      (entries) => {
        if (!entries.some(({ isIntersecting }) => isIntersecting)) return;
        watch.disconnect();
        this.#near = true;
        if (!awake) EmbeddedFigure.wake();
        awake = true;
        super.connectedCallback();
      },
      { rootMargin: NEAR },
    );
    this.#watch = watch;
    watch.observe(this);
  }

  disconnectedCallback() {
    this.#watch?.disconnect();
    super.disconnectedCallback();
  }

  /** Where there is no live drawing and the page brought no still one, ours takes the place. */
  #showStill() {
    const live = this.shadowRoot?.querySelector(".live") ?? null;
    const figure = this.getAttribute("figure") ?? "";
    if (live !== null || this.querySelector("img") !== null || !/^\w{1,4}$/.test(figure)) return;
    const picture = document.createElement("img");
    picture.src = new URL(`../../figures/${figure}.svg`, import.meta.url).href;
    picture.alt = `Figure ${figure}, as a still drawing`;
    picture.addEventListener("error", () => picture.remove());
    this.append(picture);
  }
}
