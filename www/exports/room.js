/**
 * Taking figures away: as links and lines, pictures, tables, data and scripts; and opening again what was saved. Fetched
 * when it is first asked for.
 *
 * @typedef {import("../figure/gear-figure.js").GearFigure} GearFigure
 * @typedef {import("../figure/services.js").Portrait} Portrait
 * @typedef {import("../figure/services.js").Store} Store
 * @typedef {import("../state.js").State} State
 * @typedef {import("../url.js").Problem} Problem
 * @typedef {import("./colophon.js").Colophon} Colophon
 */

/**
 * @typedef {object} Page  What only the page itself has: one state for all of it, and a place for messages.
 * @property {import("../state.js").Store} store
 * @property {() => import("../url.js").Known} known
 * @property {(sentence: string, problems: readonly Problem[]) => void} tell  What of a file could not be used.
 *
 * @typedef {object} Wiring
 * @property {Pick<import("../engine/client.js").Engine, "draw" | "svg">} engine
 * @property {string | null} home  The folder of the site, as an address; null where there is none.
 * @property {Page | null} page  Null where figures live in another document.
 * @property {() => Promise<typeof import("../embed/save-figure.js")>} saving
 *
 * @typedef {object} Room
 * @property {(figure: GearFigure, button: HTMLElement) => void} open  The menu of a figure.
 * @property {(current: () => GearFigure | null) => import("../shell/actions.js").Action[]} actions  The same by name.
 * @property {() => void} choose  Asks for a file to open.
 * @property {(files: Iterable<File>) => Promise<void>} receive  Opens a file that was brought.
 */

import { plain } from "../figure/markup.js";
import { INITIAL } from "../state.js";
import { words } from "../words/en/exports.js";
import { learn, say } from "../words/say.js";
import { colophon, colophonLines } from "./colophon.js";
import { csv } from "./csv.js";
import { facesFor } from "./faces.js";
import { copy, isHeld, save } from "./handing.js";
import { embedCode, link, stateAt, stateOf } from "./link.js";
import { described } from "./png.js";
import { RELEASE } from "./release.js";
import { LARGEST, opened, saved, wholeState } from "./saved.js";
import { MODULE, script } from "./script.js";
import { openMenu, showContent } from "./sheet.js";
import { dressed } from "./svg.js";

learn(words);

/** What a figure can become, in the order of the menu. */
const KINDS = /** @type {const} */ (["link", "embed", "png-2", "png-4", "svg", "csv", "json", "script", "html"]);
/** Where another sort begins. */
const APART = new Set(["png-2", "csv", "html"]);
/** Those that are copied; the others are files. */
const COPIED = new Set(["link", "embed"]);

/**
 * @param {Wiring} wiring
 * @returns {Room}
 */
export function startExports(wiring) {
  const made = new Exports(wiring);
  return {
    open: (figure, button) => made.open(figure, button),
    actions: (current) => made.actions(current),
    choose: () => made.choose(),
    receive: (files) => made.receive(files),
  };
}

class Exports {
  #wiring;

  /** @param {Wiring} wiring */
  constructor(wiring) {
    this.#wiring = wiring;
  }

  /**
   * @param {GearFigure} figure
   * @param {HTMLElement} button
   */
  open(figure, button) {
    /** @type {import("./sheet.js").Entry[]} */
    const entries = KINDS.map((id) => ({ id, words: say(`export.${id}`), apart: APART.has(id), run: () => void this.#take(figure, id) }));
    if (this.#wiring.page !== null) entries.push({ id: "open", words: say("export.open"), apart: true, run: () => this.choose() });
    if (figure.shadowRoot !== null) openMenu(figure.shadowRoot, button, say("export.menu", { figure: figure.getAttribute("figure") ?? "" }), entries);
  }

  /**
   * @param {() => GearFigure | null} current
   * @returns {import("../shell/actions.js").Action[]}
   */
  actions(current) {
    const id = () => current()?.getAttribute("figure") ?? "";
    return KINDS.map((kind) => ({
      id: `export.${kind}`,
      word: `export.do.${kind}`,
      // Which figure is meant is known when the list is shown.
      get values() {
        return { figure: id() };
      },
      possible: () => current() !== null,
      run: () => {
        const figure = current();
        if (figure !== null) void this.#take(figure, kind);
      },
    }));
  }

  /**
   * @param {GearFigure} figure
   * @param {typeof KINDS[number]} kind
   */
  async #take(figure, kind) {
    try {
      const portrait = await figure.portrait();
      if (COPIED.has(kind)) await this.#copy(figure, portrait, kind);
      else await this.#save(figure, portrait, kind);
    } catch (thrown) {
      const reason = thrown instanceof Error ? thrown.message : String(thrown);
      figure.tell(say("export.failed", { reason }), true);
    }
  }

  /**
   * @param {GearFigure} figure
   * @param {Portrait} portrait
   * @param {typeof KINDS[number]} kind
   */
  async #copy(figure, portrait, kind) {
    const text = kind === "link" ? this.#linkTo(portrait) : embedCode(this.#wiring.home, portrait.figure.id, portrait.given);
    if (await copy(text)) figure.tell(say(`export.copied.${kind}`));
    else this.#showContent(figure, say("export.not-copied"), text, null);
  }

  /**
   * @param {GearFigure} figure
   * @param {Portrait} portrait
   * @param {typeof KINDS[number]} kind
   */
  async #save(figure, portrait, kind) {
    const of = colophon(portrait.figure, {
      link: this.#linkTo(portrait),
      state: wholeState(this.#stateOf(portrait)),
      release: RELEASE,
      saved: new Date().toISOString(),
    });
    const { ending, type, content } = await this.#content(portrait, kind, of);
    const name = `gear-bifurcations-${of.figure}${ending}`;
    const file = content instanceof Blob ? content : new Blob([content], { type });
    save(name, file);
    if (!isHeld()) {
      figure.tell(say("export.saved", { name }));
      return;
    }
    // The page around this one may forbid files, and nobody tells: so it is here as well.
    const picture = type === "image/png" ? URL.createObjectURL(file) : null;
    this.#showContent(figure, say("export.held", { name }), picture === null ? await file.text() : null, picture);
  }

  /**
   * @param {Portrait} portrait
   * @param {typeof KINDS[number]} kind
   * @param {Colophon} of
   * @returns {Promise<{ending: string, type: string, content: string | Blob}>}
   */
  async #content(portrait, kind, of) {
    const { figure } = portrait;
    switch (kind) {
      case "png-2":
      case "png-4": {
        const density = kind === "png-2" ? 2 : 4;
        return { ending: `@${density}x.png`, type: "image/png", content: await this.#png(portrait, density, of) };
      }
      case "svg":
        return { ending: ".svg", type: "image/svg+xml", content: await this.#svg(portrait, of) };
      case "csv":
        return { ending: ".csv", type: "text/csv", content: csv(figure, colophonLines(of)) };
      case "json":
        return { ending: ".json", type: "application/json", content: saved(figure, of, portrait.key) };
      case "script": {
        const ending = ".mjs";
        const module = new URL(MODULE, this.#wiring.home ?? of.paper).href;
        return { ending, type: "text/javascript", content: script(of, module, `gear-bifurcations-${of.figure}${ending}`) };
      }
      default:
        return { ending: ".html", type: "text/html", content: await this.#html(portrait, of) };
    }
  }

  /**
   * As on the screen, drawn anew with this many pixels a CSS pixel.
   *
   * @param {Portrait} portrait
   * @param {number} density
   * @param {Colophon} of
   */
  async #png({ shown, view, theme, width, height }, density, of) {
    const canvas = document.createElement("canvas");
    canvas.width = Math.round(width * density);
    canvas.height = Math.round(height * density);
    this.#wiring.engine.draw(shown, canvas, { theme, density, view });
    const blob = await new Promise((resolve) => canvas.toBlob(resolve, "image/png"));
    if (!(blob instanceof Blob)) throw new Error(say("export.no-picture"));
    return new Blob([described(new Uint8Array(await blob.arrayBuffer()), of, density)], { type: "image/png" });
  }

  /**
   * @param {Portrait} portrait
   * @param {Colophon} of
   */
  async #svg({ shown, view }, of) {
    const drawn = this.#wiring.engine.svg(shown, { unit: "mm", theme: "print", view });
    return dressed(drawn, of, await facesFor(drawn, this.#wiring.home));
  }

  /**
   * @param {Portrait} portrait
   * @param {Colophon} of
   */
  async #html({ figure, shown, view, given }, of) {
    const { figureFile } = await this.#wiring.saving();
    const svg = dressed(this.#wiring.engine.svg(shown, { view }), of, []);
    return figureFile({ figure: figure.id, title: plain(shown.title), description: plain(shown.summary), svg, given, home: this.#wiring.home, colophon: of });
  }

  /** The state of the page; of a figure elsewhere the page's state that shows the same. @param {Portrait} portrait */
  #stateOf({ figure, given, state }) {
    return this.#wiring.page?.store.state ?? stateOf(figure.id, given, state);
  }

  /** @param {Portrait} portrait */
  #linkTo(portrait) {
    const { home, page } = this.#wiring;
    const state = this.#stateOf(portrait);
    if (page !== null) return link(location.href.split("#")[0], stateAt(state, portrait.key));
    return link(home ?? location.href.split("#")[0], state);
  }

  /**
   * @param {GearFigure} figure
   * @param {string} sentence
   * @param {string | null} text
   * @param {string | null} picture
   */
  #showContent(figure, sentence, text, picture) {
    if (figure.shadowRoot === null) return;
    showContent(figure.shadowRoot, { title: say("export.content"), words: sentence, text, picture, copy });
  }

  choose() {
    const input = document.createElement("input");
    input.type = "file";
    input.accept = ".json,application/json";
    input.addEventListener("change", () => void this.receive(input.files ?? []));
    input.click();
  }

  /** @param {Iterable<File>} files */
  async receive(files) {
    const { page } = this.#wiring;
    const [file, another] = files;
    if (page === null || file === undefined) return;
    const refuse = (/** @type {string} */ word, values = {}) => page.tell(say(word, { name: file.name, ...values }), []);
    if (another !== undefined) return refuse("export.open.several");
    if (file.size > LARGEST) return refuse("export.open.large");
    let text;
    try {
      text = await file.text();
    } catch {
      return refuse("export.open.unreadable");
    }
    const found = opened(text, file.name, page.known());
    if ("word" in found) return page.tell(say(found.word, found.values), []);
    const { state, problems, element } = found;
    page.store.act("export.act.open", () => ({ ...INITIAL, ...state }));
    page.tell(problems.length > 0 ? "" : say("export.opened", { name: file.name }), problems);
    const place = element === null ? null : document.getElementById(element);
    if (place !== null && place.getClientRects().length > 0) place.scrollIntoView({ block: "center" });
  }
}
