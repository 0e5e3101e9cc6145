// What runs in the page for the journey: each function stands alone, for it travels as text.

/**
 * @typedef {import("../../www/figure/gear-figure.js").GearFigure} GearFigure
 * @typedef {{role: string, name: string, within?: string}} Wanted  By role and accessible name, as a reader finds it; within the first element of a selector.
 */

/** Opens a way to find things as readers do, also inside shadow roots, and to read a figure's pixels and data. */
export function installHands() {
  /** @type {Record<string, string>} */
  const ROLES = {
    button: "button, [role=button]",
    link: "a[href]",
    slider: "input[type=range], [role=slider]",
    spinbutton: "input[role=spinbutton], input[type=number]",
    textbox: "input[type=text], input:not([type]), textarea",
    radio: "input[type=radio]",
    combobox: "select, [role=combobox]",
    option: "[role=option]",
    heading: "h1, h2, h3",
    application: "[role=application]",
    dialog: "dialog",
    menuitem: "[role=menuitem]",
  };
  /** @param {ParentNode} root @param {string} selector @returns {Element[]} */
  const all = (root, selector) => {
    const found = [...root.querySelectorAll(selector)];
    for (const element of root.querySelectorAll("*")) if (element.shadowRoot) found.push(...all(element.shadowRoot, selector));
    if (root instanceof Element && root.shadowRoot) found.push(...all(root.shadowRoot, selector));
    return found;
  };
  /** @param {Element} element */
  const nameOf = (element) => {
    const home = /** @type {Document | ShadowRoot} */ (element.getRootNode());
    const by = (element.getAttribute("aria-labelledby") ?? "").split(" ").map((id) => home.getElementById(id)?.textContent ?? "");
    const labels = "labels" in element ? [.../** @type {HTMLInputElement} */ (element).labels ?? []].map(({ textContent }) => textContent ?? "") : [];
    const names = [by.join(" "), element.getAttribute("aria-label"), labels.join(" "), element.textContent, element.getAttribute("title")];
    return (names.find((name) => (name ?? "").trim() !== "") ?? "").replace(/\s+/g, " ").trim();
  };
  /** @param {Element} element */
  const visible = (element) => element.getClientRects().length > 0 && getComputedStyle(element).visibility === "visible";
  /** @param {Wanted} wanted */
  const find = ({ role, name, within }) => {
    const root = within === undefined ? document : all(document, within)[0];
    if (root === undefined) throw new Error(`there is no ${within}`);
    const candidates = all(root, ROLES[role] ?? "").filter(visible);
    const found = candidates.find((element) => nameOf(element) === name);
    if (found instanceof HTMLElement) return found;
    throw new Error(`no ${role} is called “${name}”; there are ${candidates.map((element) => `“${nameOf(element).slice(0, 60)}”`).join(", ")}`);
  };
  /** What lies uppermost at a place, through all shadow roots. @param {number} x @param {number} y */
  const uppermost = (x, y) => {
    let found = document.elementFromPoint(x, y);
    for (let deeper = found?.shadowRoot?.elementFromPoint(x, y); deeper && deeper !== found; deeper = found?.shadowRoot?.elementFromPoint(x, y)) found = deeper;
    return found;
  };
  /** The middle of an element that is brought into view, where it lies open. @param {HTMLElement} element */
  const middle = (element) => {
    // A radio button is hit by its label too, and often hidden behind it.
    const label = element instanceof HTMLInputElement && element.type === "radio" ? (element.labels?.[0] ?? element) : element;
    label.scrollIntoView({ block: "center", behavior: "instant" });
    const { left, top, width, height } = label.getBoundingClientRect();
    const place = { x: left + width / 2, y: top + height / 2 };
    const above = uppermost(place.x, place.y);
    const hit = above !== null && (label.contains(above) || above.contains(label) || above.shadowRoot?.contains(label));
    if (!hit) throw new Error(`“${nameOf(element)}” lies under ${above?.outerHTML.slice(0, 200)}`);
    return place;
  };
  /** @param {HTMLCanvasElement} canvas @param {[number, number, number, number]} box  Left, top, width, height in pixels of the store. */
  const readPixels = (canvas, [left, top, width, height]) => {
    const copy = Object.assign(document.createElement("canvas"), { width, height });
    const context = copy.getContext("2d", { willReadFrequently: true });
    context?.drawImage(canvas, -left, -top);
    return context?.getImageData(0, 0, width, height).data ?? new Uint8ClampedArray();
  };
  Object.assign(globalThis, { __hands: { all, find, middle, nameOf, readPixels, visible } });
  // A hand is always on the page: what is done while nobody does anything would take half of the machine from the journey beside this one.
  setInterval(() => dispatchEvent(new Event("input")), 500);
}

/** Whether all of the story has its place: sections that come into being above it would move what is aimed at. */
export function isLaidOut() {
  const story = document.querySelector('main > [data-view="story"]');
  return story === null || story.clientWidth === 0 || document.documentElement.dataset.opening === undefined;
}

/** Stops what moves, which would take a part of the machine as long as the journey goes on. */
export function standStill() {
  for (const figure of document.querySelectorAll("gear-figure")) /** @type {GearFigure} */ (figure).pause();
}

/** Where to click. @param {Wanted} wanted */
export function middleOf(wanted) {
  const { find, middle } = /** @type {any} */ (globalThis).__hands;
  return /** @type {import("./driver.mjs").Place} */ (middle(find(wanted)));
}

/** Gives it the focus, as the Tab key would. @param {Wanted} wanted */
export function focusOn(wanted) {
  /** @type {any} */ (globalThis).__hands.find(wanted).focus();
  return true;
}

/** When the page set a mark, ms after navigation; null before. @param {string} name */
export function markedAt(name) {
  return performance.getEntriesByName(name)[0]?.startTime ?? null;
}

/**
 * A figure's data once they are complete, as plain numbers: parameters, and the columns of every series.
 *
 * @param {string} selector
 */
export async function dataOf(selector) {
  const element = /** @type {GearFigure | null} */ (document.querySelector(selector));
  if (element === null) throw new Error(`there is no ${selector}`);
  element.scrollIntoView({ block: "nearest", behavior: "instant" });
  const { params, series, summary, facts } = await element.data();
  const plain = series.map(({ name, role, mark, frame, columns }) => ({
    name,
    role,
    mark,
    frame,
    columns: Object.fromEntries(Object.entries(columns).map(([column, numbers]) => [column, Array.from(/** @type {ArrayLike<number>} */ (numbers))])),
  }));
  return { params: /** @type {Record<string, number | string>} */ (/** @type {unknown} */ (params)), series: plain, summary, facts };
}

/**
 * In how many pixels of each frame's plot the canvas differs from its ground, once it is drawn.
 *
 * @param {string} selector
 */
export async function inkOf(selector) {
  const element = /** @type {GearFigure | null} */ (document.querySelector(selector));
  if (element === null) throw new Error(`there is no ${selector}`);
  element.scrollIntoView({ block: "nearest", behavior: "instant" });
  const { __hands, __gear } = /** @type {any} */ (globalThis);
  const shown = await element.data();
  await __gear.painted(element);
  const canvas = element.shadowRoot?.querySelector("canvas");
  const frames = element.map()?.frames ?? [];
  if (!canvas || frames.length === 0) throw new Error(`${selector} is not drawn`);
  const density = canvas.width / canvas.clientWidth;
  // The same figure without its series, to compare with.
  const empty = Object.assign(document.createElement("canvas"), { width: canvas.width, height: canvas.height });
  Object.assign(empty.style, { width: `${canvas.clientWidth}px`, height: `${canvas.clientHeight}px`, position: "fixed", left: "-9999px" });
  document.body.append(empty);
  __gear.engine.draw({ ...shown, series: [] }, empty, { theme: "light", density });
  /** @type {Record<string, number>} */
  const counts = {};
  for (const { name, plot } of frames) {
    const box = [plot.left, plot.top, plot.right - plot.left, plot.bottom - plot.top].map((length) => Math.round(length * density));
    const [full, bare] = [canvas, empty].map((one) => __hands.readPixels(one, box));
    counts[name] = 0;
    for (let index = 0; index < full.length; index += 4) {
      if ([0, 1, 2].some((part) => Math.abs(full[index + part] - bare[index + part]) > 24)) counts[name] += 1;
    }
  }
  empty.remove();
  return counts;
}

/**
 * Places in the window of data in a figure's first frame, once it is drawn.
 *
 * @param {string} selector
 * @param {[number, number][]} points
 */
export async function placesOf(selector, points) {
  const element = /** @type {GearFigure | null} */ (document.querySelector(selector));
  const canvas = element?.shadowRoot?.querySelector("canvas");
  if (!element || !canvas) throw new Error(`there is no ${selector}`);
  canvas.scrollIntoView({ block: "center", behavior: "instant" });
  await element.data();
  await /** @type {any} */ (globalThis).__gear.painted(element);
  const frame = element.map()?.frames[0];
  if (!frame) throw new Error(`${selector} is not drawn`);
  const { plot, x, y } = frame;
  const box = canvas.getBoundingClientRect();
  return points.map(([across, up]) => ({
    x: box.left + plot.left + ((across - x.low) / (x.high - x.low)) * (plot.right - plot.left),
    y: box.top + plot.bottom - ((up - y.low) / (y.high - y.low)) * (plot.bottom - plot.top),
  }));
}

/** From now on what the page hands to the browser as a file is kept in the page: drivers know no downloads. */
export function catchFiles() {
  const files = /** @type {{name: string, text: Promise<string>}[]} */ ([]);
  Object.assign(globalThis, { __files: files });
  const click = HTMLAnchorElement.prototype.click;
  HTMLAnchorElement.prototype.click = function handed() {
    // Read at once: its address may be taken back.
    if (this.download) files.push({ name: this.download, text: fetch(this.href).then((answer) => answer.text()) });
    else click.call(this);
  };
}

/** The file that was handed out last, if any. */
export async function lastFile() {
  const last = /** @type {any} */ (globalThis).__files.at(-1);
  return last ? { name: /** @type {string} */ (last.name), text: /** @type {string} */ (await last.text) } : null;
}
